#pragma once
/// The joint torques that make no wrench, and how near the arm is to a pose where a wrench is lost.
#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Settings of NullSpace.
template <typename Scalar>
struct NullSpaceConfig {
  /// sigma_0 > 0: damping sets in where clearance() falls below. The Jacobian's rows carry metres and radians; a Panda
  /// has a clearance of 0.15 in its ready pose.
  Scalar clearance = Scalar(0.02);
  Scalar damping = Scalar(0.02);  ///< lambda_0 > 0 at a singular pose, in the unit of J's singular values
};

/// The projector N = I - J^T (J J^T + lambda^2 I)^-1 J onto joint torques without a wrench (docs/theory_control.md, the
/// metric of CPIC). Away from singular poses lambda = 0: N is exactly the orthogonal projector onto the null space of
/// J, zero for six joints. Where the clearance sigma falls below sigma_0, lambda = lambda_0 (1 - (sigma / sigma_0)^2):
/// the directions in which J is about to lose a wrench then count partly as null space, J N != 0, and N stays bounded
/// and a continuous function of J, with eigenvalues in [0, 1].
///
/// @tparam Dofs  number of joints, >= 6
template <typename Scalar, int Dofs>
class NullSpace {
  static_assert(Dofs >= 6, "an arm with fewer than six joints cannot make every wrench: J^+ has no right inverse");

 public:
  /// @throws std::invalid_argument naming the field out of range
  explicit NullSpace(const NullSpaceConfig<Scalar>& config = NullSpaceConfig<Scalar>()) : config_(config) {
    detail::require_positive(config.clearance, "NullSpaceConfig::clearance", "> 0");
    detail::require_positive(config.damping, "NullSpaceConfig::damping", "> 0");
  }

  /// Computes N.
  /// @return Ok, or NonFiniteInput, also for numbers beyond kLargestPlausible: N is then as it was
  Status update(const Jacobian<Scalar, Dofs>& jacobian) noexcept;

  const JointMatrix<Scalar, Dofs>& projector() const noexcept { return projector_; }  ///< N, DofsxDofs
  /// sigma = |J^+|_F^-1, between sigma_min / sqrt(6) and sigma_min, J's smallest singular value; 0 at a singular pose.
  Scalar clearance() const noexcept { return clearance_; }
  Scalar damping() const noexcept { return damping_; }  ///< lambda

 private:
  NullSpaceConfig<Scalar> config_;
  JointMatrix<Scalar, Dofs> projector_ = JointMatrix<Scalar, Dofs>::Zero();
  Scalar clearance_ = Scalar(0);
  Scalar damping_ = Scalar(0);
};

template <typename Scalar, int Dofs>
Status NullSpace<Scalar, Dofs>::update(const Jacobian<Scalar, Dofs>& jacobian) noexcept {
  if (!plausible(jacobian)) return Status::NonFiniteInput;
  // J^T = Q [R; 0] by Householder reflections I - v v^T (|v|^2 = 2). Not through J J^T, which would square the
  // condition number: N is divided by a small weight afterwards.
  Eigen::Matrix<Scalar, Dofs, 6> a = jacobian.transpose();
  Vector6<Scalar> diagonal;
  for (int k = 0; k < 6; ++k) {
    Scalar squared = 0;
    for (int i = k; i < Dofs; ++i) squared += a(i, k) * a(i, k);
    const Scalar norm = std::sqrt(squared);
    diagonal[k] = a(k, k) > 0 ? -norm : norm;
    if (!(norm > 0)) continue;
    const Scalar scale = Scalar(1) / std::sqrt(squared + norm * std::abs(a(k, k)));
    a(k, k) -= diagonal[k];
    for (int i = k; i < Dofs; ++i) a(i, k) *= scale;
    for (int j = k + 1; j < 6; ++j) {
      Scalar dot = 0;
      for (int i = k; i < Dofs; ++i) dot += a(i, k) * a(i, j);
      for (int i = k; i < Dofs; ++i) a(i, j) -= dot * a(i, k);
    }
  }

  // |J^+|_F = |R^-1|_F, column by column; a pivot of zero makes it infinite and the clearance zero.
  Scalar inverse_squared = 0;
  for (int j = 0; j < 6; ++j) {
    Vector6<Scalar> column;
    for (int i = j; i >= 0; --i) {
      Scalar sum = i == j ? Scalar(1) : Scalar(0);
      for (int l = i + 1; l <= j; ++l) sum -= a(i, l) * column[l];
      column[i] = sum / diagonal[i];
      inverse_squared += column[i] * column[i];
    }
  }
  // Beyond what the scalar resolves (or for NaN from 0 / 0) the pose is singular.
  clearance_ = inverse_squared < Scalar(1) / std::numeric_limits<Scalar>::min() ? Scalar(1) / std::sqrt(inverse_squared)
                                                                                : Scalar(0);

  const Scalar ratio = clearance_ / config_.clearance;
  damping_ = config_.damping * std::max(Scalar(0), Scalar(1) - ratio * ratio);
  if (damping_ > 0) {
    Matrix6<Scalar> damped = jacobian * jacobian.transpose();
    damped.diagonal().array() += damping_ * damping_;
    const Eigen::Matrix<Scalar, 6, Dofs> y = damped.llt().matrixL().solve(jacobian);
    projector_.noalias() = -y.transpose() * y;
    projector_.diagonal().array() += Scalar(1);
    return Status::Ok;
  }
  projector_.setZero();
  for (int m = 6; m < Dofs; ++m) {  // the last columns of Q span the null space
    JointVector<Scalar, Dofs> z = JointVector<Scalar, Dofs>::Unit(m);
    for (int k = 5; k >= 0; --k) {
      Scalar dot = 0;
      for (int i = k; i < Dofs; ++i) dot += a(i, k) * z[i];
      for (int i = k; i < Dofs; ++i) z[i] -= dot * a(i, k);
    }
    projector_.noalias() += z * z.transpose();
  }
  return Status::Ok;
}

}  // namespace rme
