#pragma once
/// From a Gaussian over the inertial parameters to one over a plausible mass and a centre of mass.
#include <algorithm>
#include <cmath>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/inertial_parameters.hpp>

namespace rme {

/// Gaussian over phi (inertial_parameters.hpp).
template <typename Scalar>
struct InertialGaussian {
  /// Mean of phi [kg, kg m, kg m^2].
  InertialVector<Scalar> mean = InertialVector<Scalar>::Zero();
  /// 10x10, positive semidefinite.
  InertialMatrix<Scalar> covariance = InertialMatrix<Scalar>::Zero();
};

/// Truncates the mass to the interval from 0 to `largest`. The result has the mean and variance of the truncated mass;
/// the moments of all other entries follow from their regression on the mass (docs/theory.md (T31)).
/// @param free     before the truncation; returned as it is if the interval holds the mass +- 4 standard deviations
/// @param largest  [kg], > 0
template <typename Scalar>
InertialGaussian<Scalar> within_rated(const InertialGaussian<Scalar>& free, Scalar largest) noexcept {
  using std::erfc;
  using std::exp;
  using std::sqrt;
  const Scalar variance = free.covariance(0, 0), mass = free.mean[0];
  const Scalar deviation = sqrt(std::max(variance, Scalar(0)));
  if (mass - 4 * deviation >= 0 && mass + 4 * deviation <= largest) return free;
  Scalar cut_mean, cut_variance;
  if (!(deviation > Scalar(1e-6) * largest)) {
    cut_mean = std::max(Scalar(0), std::min(largest, mass));
    cut_variance = std::max(variance, Scalar(0.25) * (mass - cut_mean) * (mass - cut_mean));
  } else {
    const Scalar a = -mass / deviation, b = (largest - mass) / deviation;
    const auto density = [](Scalar x) { return Scalar(0.3989422804014327) * exp(Scalar(-0.5) * x * x); };
    const auto above = [](Scalar x) { return Scalar(0.5) * erfc(x / sqrt(Scalar(2))); };
    const Scalar inside = above(a) - above(b);
    if (inside > Scalar(1e-6)) {
      const Scalar shift = (density(a) - density(b)) / inside;
      cut_mean = std::max(Scalar(0), std::min(largest, mass + deviation * shift));  // rounding, if both are large
      cut_variance = variance * (1 + (a * density(a) - b * density(b)) / inside - shift * shift);
      cut_variance = std::max(cut_variance, Scalar(1e-4) * variance);
    } else {  // far outside: at the bound, with at least half of the distance as deviation
      const Scalar far = mass < 0 ? -mass : mass - largest;
      cut_mean = mass < 0 ? Scalar(0) : largest;
      cut_variance = std::max(variance, Scalar(0.25) * far * far);
    }
  }
  InertialGaussian<Scalar> cut = free;
  if (!(variance > 0)) {
    cut.mean[0] = cut_mean;
    return cut;
  }
  InertialVector<Scalar> slope;
  for (int i = 0; i < kInertial; ++i) slope[i] = free.covariance(i, 0) / variance;
  detail::add_scaled(cut.mean, cut_mean - mass, slope);
  detail::add_outer(cut.covariance, detail::scaled(cut_variance - variance, slope), slope);
  cut.mean[0] = cut_mean;  // the sums above round, if the mass was far outside
  cut.covariance(0, 0) = cut_variance;
  return cut;
}

/// Gaussian over (m, r) from one over (m, m r), by r = (m r) / m to first order (docs/theory.md (T32)). If the standard
/// deviation of m exceeds m, r is the prior's: phi then says nothing of the centre of mass.
template <typename Scalar>
PayloadGaussian<Scalar> payload_of(const InertialGaussian<Scalar>& phi, const PayloadPrior<Scalar>& prior) noexcept {
  PayloadGaussian<Scalar> out;
  const Scalar mass = phi.mean[0];
  out.mean = Vector4<Scalar>(mass, prior.com_mean[0], prior.com_mean[1], prior.com_mean[2]);
  out.covariance.setZero();
  out.covariance(0, 0) = phi.covariance(0, 0);
  for (int i = 0; i < 3; ++i) out.covariance(1 + i, 1 + i) = prior.com_std[i] * prior.com_std[i];
  if (!(mass * mass > phi.covariance(0, 0)) || !(mass > 0)) return out;
  Matrix4<Scalar> derivative = Matrix4<Scalar>::Zero(), P;
  derivative(0, 0) = 1;
  for (int i = 1; i < 4; ++i) {
    out.mean[i] = phi.mean[i] / mass;
    derivative(i, 0) = -out.mean[i] / mass;
    derivative(i, i) = 1 / mass;
  }
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) P(i, j) = phi.covariance(i, j);
  out.covariance = detail::product(detail::product(derivative, P), Matrix4<Scalar>(derivative.transpose()));
  // Cancellation must not leave a variance below zero.
  for (int i = 0; i < 4; ++i) out.covariance(i, i) = std::max(out.covariance(i, i), Scalar(1e-12));
  return out;
}

/// Bounds a covariance of theta = (m, r): no entry of r is less certain than one that is drawn from a prior twice as
/// wide, since a body has its centre within reach of the hand.
/// @param covariance  of theta, positive semidefinite; returned as it is if r is known better
/// @param prior       of the payload
template <typename Scalar>
Matrix4<Scalar> no_wider_than_prior(const Matrix4<Scalar>& covariance, const PayloadPrior<Scalar>& prior) noexcept {
  constexpr double kWidest = 2;  // of the prior's standard deviations
  Matrix4<Scalar> out = covariance;
  for (int i = 1; i < 4; ++i) {  // the rest of the widest variance is left open (docs/theory.md (T54))
    const Scalar widest = static_cast<Scalar>(kWidest * kWidest) * prior.com_std[i - 1] * prior.com_std[i - 1];
    if (!(covariance(i, i) > widest)) continue;
    const Scalar share = widest / covariance(i, i);
    for (int j = 0; j < 4; ++j) out(i, j) *= share;
    for (int j = 0; j < 4; ++j) out(j, i) *= share;
    out(i, i) = widest;
  }
  return out;
}

/// What is known of theta if r is known no better than no_wider_than_prior() says: what exceeds it counts as an error
/// of r's measurement. A small mass that is hardly known leaves any r possible to first order (T32).
/// @param free   before
/// @param prior  of the payload
template <typename Scalar>
PayloadGaussian<Scalar> within_prior(const PayloadGaussian<Scalar>& free, const PayloadPrior<Scalar>& prior) noexcept {
  PayloadGaussian<Scalar> out{free.mean, no_wider_than_prior(free.covariance, prior)};
  for (int i = 1; i < 4; ++i) {
    const Scalar centre = prior.com_mean[i - 1];
    if (out.covariance(i, i) < free.covariance(i, i))
      out.mean[i] = centre + out.covariance(i, i) / free.covariance(i, i) * (free.mean[i] - centre);
  }
  return out;
}

}  // namespace rme
