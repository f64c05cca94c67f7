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
constexpr double kMostRotor = 5;     // greatest inertia of a rotor, gear included [kg m^2]
constexpr double kRest = 0.2;        // weight of an instant at which a joint rests, so that its friction is unknown

/// Columns that explain a joint's torque, and which of their coefficients cannot be negative.
struct Columns {
  std::vector<Eigen::VectorXd> of;
  std::vector<bool> positive;
  std::vector<double> most;  // greatest value of each coefficient
  void add(const Eigen::VectorXd& column, bool is_positive, double greatest = 1e300) {
    of.push_back(column);
    positive.push_back(is_positive);
    most.push_back(greatest);
  }
};

Columns own(const Explained& data, Eigen::Index j) {
  const Eigen::VectorXd dq = data.motion.dq.col(j), direction = (dq / kSlow).array().tanh();
  Columns out;
  out.add(Eigen::VectorXd::Ones(dq.size()), false);
  out.add(direction, data.measured);
  out.add(dq, data.measured);
  out.add(direction.cwiseProduct(data.loads.col(j).cwiseAbs()), data.measured);
  if (data.measured) out.add(data.motion.ddq.col(j), true, kMostRotor);
  return out;
}

Eigen::VectorXd weights(const Explained& data, Eigen::Index j) {
  return (data.motion.dq.col(j).array().abs() < kSlow).select(kRest, Eigen::ArrayXd::Ones(data.tau.rows()));
}

struct Solution {
  Eigen::VectorXd x, left;     // coefficients; what is not explained
  Eigen::MatrixXd covariance;  // for errors of variance 1 that are independent
};

/// Weighted least squares; a coefficient that must be positive and is not is left out, one that is too large is fixed.
Solution least_squares(const Columns& columns, Eigen::VectorXd y, const Eigen::VectorXd& w) {
  const std::size_t n = columns.of.size();
  const auto size = static_cast<Eigen::Index>(n);
  std::vector<bool> used(n, true);
  Eigen::VectorXd fixed = Eigen::VectorXd::Zero(size);
  Solution out;
  for (bool settled = false; !settled;) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Identity(size, size);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(size);
    for (std::size_t i = 0; i < n; ++i) {
      if (!used[i]) continue;
      const auto row = static_cast<Eigen::Index>(i);
      const Eigen::VectorXd weighted = w.cwiseProduct(columns.of[i]);
      for (std::size_t k = 0; k <= i; ++k) {
        const auto column = static_cast<Eigen::Index>(k);
        if (used[k]) A(row, column) = A(column, row) = weighted.dot(columns.of[k]);
      }
      A(row, row) = A(row, row) > 0 ? A(row, row) * (1 + 1e-9) : 1;
      b[row] = weighted.dot(y);
    }
    const Eigen::LDLT<Eigen::MatrixXd> factor(A);
    out.x = factor.solve(b);
    out.covariance = factor.solve(Eigen::MatrixXd::Identity(size, size));
    settled = true;
    for (std::size_t i = 0; i < n && settled; ++i) {
      const auto row = static_cast<Eigen::Index>(i);
      if (!used[i]) continue;
      settled = !(columns.positive[i] && out.x[row] < 0) && out.x[row] <= columns.most[i];
      if (settled) continue;
      used[i] = false;
      fixed[row] = out.x[row] < 0 ? 0 : columns.most[i];
      y -= fixed[row] * columns.of[i];
    }
  }
  out.x += fixed;
  out.left = y;
  for (std::size_t i = 0; i < n; ++i)
    if (used[i]) out.left -= out.x[static_cast<Eigen::Index>(i)] * columns.of[i];
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
      std::fill(nuisance.most.begin(), nuisance.most.end(), 1e300);
      std::vector<Eigen::VectorXd> projected;
      projected.reserve(shared.size());
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
    double least = 0, opposite = 0;
    const double floor = kFloor * kFloor * mean_square(data.tau.col(j));
    for (const double sign : {1.0, -1.0}) {  // friction has the torque's sign
      const Solution found = least_squares(columns, sign * data.tau.col(j), w);
      const double square = mean_square(found.left, w);
      if (sign < 0) opposite = 0.5 * samples_ * std::log((least + floor) / (square + floor));
      if (sign < 0 && !(square < least)) continue;
      least = square;
      const Eigen::Index last = found.x.size() - 1;
      const double gain = found.x[last], spread = (data.base.col(j).array() - data.base.col(j).mean()).matrix().norm();
      const Eigen::VectorXd friction = friction_of(columns, found.x);
      const double variance = (square + floor) * w.sum() / samples_;
      best = {sign * gain, std::sqrt(variance * found.covariance(last, last)),
              gain > 0 && spread > 0 ? friction.norm() / (gain * spread) : 1e9, 0};
    }
    best.opposite = opposite;
    out.push_back(best);
  }
  return out;
}

}  // namespace rme::examples
