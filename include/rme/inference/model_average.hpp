#pragma once
/// Several models of the same data, averaged by how well each explains it.
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>

namespace rme {

/// log sum_k exp(x_k), one term at a time, without overflow.
template <typename Scalar>
class LogSum {
 public:
  void add(Scalar x) noexcept {
    using std::exp;
    if (sum_ > 0 && x <= largest_) {
      sum_ += exp(x - largest_);
    } else {
      sum_ = sum_ > 0 ? sum_ * exp(largest_ - x) + 1 : Scalar(1);
      largest_ = x;
    }
  }
  Scalar value() const noexcept {  ///< -infinity of nothing
    using std::log;
    return sum_ > 0 ? largest_ + log(sum_) : -std::numeric_limits<Scalar>::infinity();
  }

 private:
  Scalar largest_ = Scalar(0), sum_ = Scalar(0);
};

/// Bayesian model averaging of Gaussian posteriors with equal prior odds: sum_k p(k | y) N_k, as its own mean and
/// covariance. Feed it one model at a time; the best so far sets the scale, so that no exponential overflows.
template <typename Scalar>
class ModelAverage {
 public:
  /// @param log_evidence  log p(y | k), up to a constant that all k share; finite
  void add(const PayloadGaussian<Scalar>& posterior, Scalar log_evidence) noexcept {
    using std::exp;
    if (weight_ > 0 && log_evidence > best_) {  // re-scale what is there
      const Scalar factor = exp(best_ - log_evidence);
      weight_ *= factor;
      first_ *= factor;
      second_ *= factor;
    }
    if (weight_ == 0) reference_ = posterior.mean;
    if (weight_ == 0 || log_evidence > best_) best_ = log_evidence;
    const Scalar w = exp(log_evidence - best_);
    // Moments about the first mean, so that nearby means do not cancel.
    const Vector4<Scalar> d = posterior.mean - reference_;
    weight_ += w;
    first_ += w * d;
    second_ += w * (posterior.covariance + d * d.transpose());
  }

  bool empty() const noexcept { return !(weight_ > 0); }
  /// log sum_k p(y | k): the evidence of all models together, up to their number. Requires one add().
  Scalar log_evidence() const noexcept {
    using std::log;
    return best_ + log(weight_);
  }
  /// Mean and covariance of the mixture. Requires one add().
  PayloadGaussian<Scalar> moments() const noexcept {
    const Vector4<Scalar> d = first_ / weight_;
    return {reference_ + d, second_ / weight_ - d * d.transpose()};
  }

 private:
  Scalar weight_ = Scalar(0);  // relative to exp(best_)
  Scalar best_ = Scalar(0);
  Vector4<Scalar> reference_ = Vector4<Scalar>::Zero();
  Vector4<Scalar> first_ = Vector4<Scalar>::Zero();
  Matrix4<Scalar> second_ = Matrix4<Scalar>::Zero();
};

}  // namespace rme
