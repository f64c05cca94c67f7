#include "log_diagnosis/torque_fit.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace rme::examples {

namespace {

constexpr double kCorrelated = 0.5;  // errors last for so long [s]
constexpr double kSlow = 0.02;       // [rad/s]: at lower speeds it is uncertain whether a joint moves
constexpr double kOutlier = 4;       // robust standard deviations: an emergency stop says little about a fault
constexpr double kFloor = 0.01;      // least error, as a share of the torque's rms
constexpr double kRest = 0.2;        // weight of an instant at which a joint rests, so that its friction is unknown

/// Columns that explain a joint's torque, and which of their coefficients cannot be negative.
struct Columns {
  std::vector<Eigen::VectorXd> of;
  std::vector<bool> positive;
  void add(const Eigen::VectorXd& column, bool is_positive) {
    of.push_back(column);
    positive.push_back(is_positive);
  }
};

Columns own(const Explained& data, Eigen::Index j) {
  const Eigen::VectorXd dq = data.motion.dq.col(j), direction = (dq / kSlow).array().tanh();
  Columns out;
  out.add(Eigen::VectorXd::Ones(dq.size()), false);
  out.add(direction, data.measured);
  out.add(dq, data.measured);
  out.add(direction.cwiseProduct(data.loads.col(j).cwiseAbs()), data.measured);
  if (data.measured) out.add(data.motion.ddq.col(j), true);
  return out;
}

Eigen::VectorXd weights(const Explained& data, Eigen::Index j) {
  return (data.motion.dq.col(j).array().abs() < kSlow).select(kRest, Eigen::ArrayXd::Ones(data.tau.rows()));
}

struct Solution {
  Eigen::VectorXd x, left;     // coefficients; what is not explained
  Eigen::MatrixXd covariance;  // for errors of variance 1 that are independent
};

/// Weighted least squares; a coefficient that must be positive and is not is left out.
Solution least_squares(const Columns& columns, const Eigen::VectorXd& y, const Eigen::VectorXd& w) {
  const auto n = static_cast<Eigen::Index>(columns.of.size());
  std::vector<bool> used(columns.of.size(), true);
  Solution out;
  for (;;) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    for (Eigen::Index i = 0; i < n; ++i) {
      const Eigen::VectorXd weighted = w.cwiseProduct(columns.of[static_cast<std::size_t>(i)]);
      if (!used[static_cast<std::size_t>(i)]) continue;
      for (Eigen::Index k = 0; k <= i; ++k)
        if (used[static_cast<std::size_t>(k)])
          A(i, k) = A(k, i) = weighted.dot(columns.of[static_cast<std::size_t>(k)]);
      b[i] = weighted.dot(y);
    }
    for (Eigen::Index i = 0; i < n; ++i) A(i, i) = A(i, i) > 0 ? A(i, i) * (1 + 1e-9) : 1;
    const Eigen::LDLT<Eigen::MatrixXd> factor(A);
    out.x = factor.solve(b);
    out.covariance = factor.solve(Eigen::MatrixXd::Identity(n, n));
    Eigen::Index worst = -1;
    for (Eigen::Index i = 0; i < n; ++i)
      if (columns.positive[static_cast<std::size_t>(i)] && out.x[i] < 0 && (worst < 0 || out.x[i] < out.x[worst]))
        worst = i;
    if (worst < 0) break;
    used[static_cast<std::size_t>(worst)] = false;
  }
  out.left = y;
  for (Eigen::Index i = 0; i < n; ++i) out.left -= out.x[i] * columns.of[static_cast<std::size_t>(i)];
  return out;
}

/// Weighted mean square in which outliers count for no more than kOutlier deviations.
double mean_square(const Eigen::VectorXd& left, const Eigen::VectorXd& w) {
  Eigen::VectorXd sizes = left.cwiseAbs();
  double* const middle = sizes.data() + sizes.size() / 2;
  std::nth_element(sizes.data(), middle, sizes.data() + sizes.size());
  const double bound = kOutlier * std::max(*middle / 0.6745, 1e-9);
  return w.dot(left.cwiseMax(-bound).cwiseMin(bound).cwiseAbs2()) / w.sum();
}

double mean_square(const Eigen::VectorXd& v) {
  return v.squaredNorm() / static_cast<double>(v.size());
}

Eigen::VectorXd friction_of(const Columns& columns, const Eigen::VectorXd& x) {
  return x[1] * columns.of[1] + x[2] * columns.of[2] + x[3] * columns.of[3];
}

/// Least mean square of the error: no model is better.
double floor_of(const Eigen::VectorXd& tau, const Eigen::VectorXd& friction) {
  return kFloor * kFloor * mean_square(tau) + mean_square(friction) + 1e-12;
}

}  // namespace

TorqueFit::TorqueFit(double duration) : samples_(std::clamp(duration / kCorrelated, 10.0, 60.0)) {}

FitQuality TorqueFit::fit(const Explained& data, int parameters) const {
  FitQuality out;
  out.left.resize(data.tau.cols());
  out.friction.resize(data.tau.cols());
  out.cost = 0.5 * parameters * std::log(samples_);
  for (Eigen::Index j = 0; j < data.tau.cols(); ++j) {
    const Eigen::VectorXd w = weights(data, j);
    const Columns columns = own(data, j);
    const Solution found = least_squares(columns, data.tau.col(j) - data.base.col(j), w);
    const Eigen::VectorXd friction = friction_of(columns, found.x);
    out.friction[j] = std::sqrt(mean_square(friction));
    const double square = mean_square(found.left, w);
    out.left[j] = std::sqrt(square);
    out.cost += 0.5 * samples_ * std::log(square + floor_of(data.tau.col(j), data.friction_error * friction));
  }
  return out;
}

FitQuality TorqueFit::fit_shared(const Explained& data, const std::vector<Eigen::MatrixXd>& shared, Eigen::VectorXd& x,
                                 Eigen::VectorXd& deviation) const {
  constexpr int kRounds = 4;  // of fitting with the errors of the round before
  const auto n = static_cast<Eigen::Index>(shared.size());
  Explained with = data;
  FitQuality out = fit(data);
  for (int round = 0; round < kRounds; ++round) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n, n);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
    for (Eigen::Index j = 0; j < data.tau.cols(); ++j) {
      const Eigen::VectorXd w = weights(data, j);
      Columns nuisance = own(data, j);
      std::fill(nuisance.positive.begin(), nuisance.positive.end(), false);
      std::vector<Eigen::VectorXd> projected;
      for (const Eigen::MatrixXd& column : shared) projected.push_back(least_squares(nuisance, column.col(j), w).left);
      const Eigen::VectorXd y = data.tau.col(j) - data.base.col(j);
      const double precision =
          1 / (out.left[j] * out.left[j] + std::pow(data.friction_error * out.friction[j], 2) + 1e-12) / w.sum();
      for (Eigen::Index i = 0; i < n; ++i) {
        const Eigen::VectorXd weighted = w.cwiseProduct(projected[static_cast<std::size_t>(i)]);
        for (Eigen::Index k = 0; k < n; ++k)
          A(i, k) += precision * weighted.dot(projected[static_cast<std::size_t>(k)]);
        b[i] += precision * weighted.dot(y);
      }
    }
    A.diagonal().array() += 1e-9 * std::max(A.trace(), 1e-9);
    const Eigen::LDLT<Eigen::MatrixXd> factor(A);
    x = factor.solve(b);
    deviation = factor.solve(Eigen::MatrixXd::Identity(n, n)).diagonal().cwiseSqrt() / std::sqrt(samples_);
    with.base = data.base;
    for (Eigen::Index i = 0; i < n; ++i) with.base += x[i] * shared[static_cast<std::size_t>(i)];
    out = fit(with, static_cast<int>(n));
  }
  return out;
}

std::vector<GainFit> TorqueFit::fit_gains(const Explained& data) const {
  std::vector<GainFit> out;
  for (Eigen::Index j = 0; j < data.tau.cols(); ++j) {
    const Eigen::VectorXd w = weights(data, j);
    Columns columns = own(data, j);
    columns.add(data.base.col(j), true);
    GainFit best;
    double least = 0;
    for (const double sign : {1.0, -1.0}) {  // friction has the torque's sign
      const Solution found = least_squares(columns, sign * data.tau.col(j), w);
      const double square = mean_square(found.left, w);
      if (sign < 0 && !(square < least)) continue;
      least = square;
      const Eigen::Index last = found.x.size() - 1;
      const double gain = found.x[last], spread = (data.base.col(j).array() - data.base.col(j).mean()).matrix().norm();
      const Eigen::VectorXd friction = friction_of(columns, found.x);
      const double variance = (square + kFloor * kFloor * mean_square(data.tau.col(j))) * w.sum() / samples_;
      best = {sign * gain, std::sqrt(variance * found.covariance(last, last)),
              gain > 0 && spread > 0 ? friction.norm() / (gain * spread) : 1e9};
    }
    out.push_back(best);
  }
  return out;
}

}  // namespace rme::examples
