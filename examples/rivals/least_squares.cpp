#include "rivals/least_squares.hpp"

#include <Eigen/Cholesky>
#include <cmath>

namespace rme::examples {

RecursiveLeastSquares::RecursiveLeastSquares(const Eigen::VectorXd& ridge, double memory)
    : ridge_(ridge),
      memory_(memory),
      A_(Eigen::MatrixXd::Zero(ridge.size(), ridge.size())),
      b_(Eigen::VectorXd::Zero(ridge.size())) {}

void RecursiveLeastSquares::age(double duration) {
  if (!(memory_ > 0)) return;
  const double keep = std::exp(-duration / memory_);
  A_ *= keep;
  b_ *= keep;
}

void RecursiveLeastSquares::add(const Eigen::MatrixXd& H, const Eigen::VectorXd& y, const Eigen::VectorXd& weight) {
  for (Eigen::Index i = 0; i < H.rows(); ++i) {
    const Eigen::VectorXd h = H.row(i);
    A_.selfadjointView<Eigen::Lower>().rankUpdate(h, weight[i]);
    b_ += weight[i] * y[i] * h;
  }
}

Eigen::VectorXd RecursiveLeastSquares::solution() const {
  Eigen::MatrixXd A = A_;
  A.diagonal() += ridge_;
  return A.ldlt().solve(b_);
}

Tare Tare::none(Eigen::Index joints) {
  const Eigen::VectorXd zero = Eigen::VectorXd::Zero(joints);
  return {zero, zero, zero, Eigen::VectorXd::Ones(joints)};
}

Tare Tare::of(const LogBlocks& empty) {
  constexpr double kRests = 1e-3;                 // weight of a block in which the joint rests
  constexpr double kLeast = 1e-4;                 // least deviation of what is left [N m]
  const Eigen::Vector3d ridge(1e-6, 1e-2, 1e-2);  // of offset and friction; the latter's is for a joint that rests
  Tare out = none(empty.joints());
  for (Eigen::Index j = 0; j < empty.joints(); ++j) {
    RecursiveLeastSquares fit(ridge, 0);
    Eigen::MatrixXd H(empty.blocks(), 3);
    H << Eigen::VectorXd::Ones(empty.blocks()), -empty.direction.col(j), -empty.velocity.col(j);
    fit.add(H, empty.tau.col(j), (1 - empty.resting.col(j).array()).max(kRests).matrix());
    const Eigen::VectorXd x = fit.solution();
    out.offset[j] = x[0];
    out.coulomb[j] = x[1];
    out.viscous[j] = x[2];
    const double variance = (empty.tau.col(j) - H * x).squaredNorm() / static_cast<double>(empty.blocks());
    out.weight[j] = 1 / (variance + kLeast * kLeast);
  }
  return out;
}

Eigen::MatrixXd Tare::torque(const LogBlocks& log) const {
  Eigen::MatrixXd out(log.blocks(), log.joints());
  for (Eigen::Index j = 0; j < log.joints(); ++j)
    out.col(j) = Eigen::VectorXd::Constant(log.blocks(), offset[j]) - coulomb[j] * log.direction.col(j) -
                 viscous[j] * log.velocity.col(j);
  return out;
}

Eigen::Vector4d batch_least_squares(const LogBlocks& log, const Eigen::VectorXd& weight) {
  const Eigen::Index joints = log.joints(), n = 4 + 3 * joints;
  RecursiveLeastSquares fit(Eigen::VectorXd::Constant(n, 1e-6), 0);
  for (Eigen::Index j = 0; j < joints; ++j) {
    Eigen::MatrixXd H = Eigen::MatrixXd::Zero(log.blocks(), n);
    H.leftCols<4>() = log.payload[static_cast<std::size_t>(j)];
    H.middleCols<3>(4 + 3 * j) << Eigen::VectorXd::Ones(log.blocks()), -log.direction.col(j), -log.velocity.col(j);
    fit.add(H, log.tau.col(j), Eigen::VectorXd::Constant(log.blocks(), weight[j]));
  }
  return fit.solution().head<4>();
}

}  // namespace rme::examples
