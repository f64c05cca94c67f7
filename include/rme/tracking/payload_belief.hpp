#pragma once
/// From a Gaussian over the inertial parameters to one over mass and centre of mass, within what an arm can hold.
#include <algorithm>
#include <cmath>
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/inertial_parameters.hpp>

namespace rme {

/// N(mean, covariance) over phi.
template <typename Scalar>
struct InertialGaussian {
  InertialVector<Scalar> mean = InertialVector<Scalar>::Zero();
  InertialMatrix<Scalar> covariance = InertialMatrix<Scalar>::Zero();
};

/// Cuts a Gaussian where the mass would be negative or above `largest`: the moments of the truncated mass, and of all
/// else what follows from its regression on the mass. Unchanged where nothing is to be cut.
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
      cut_mean = mass + deviation * shift;
      cut_variance = variance * (1 + (a * density(a) - b * density(b)) / inside - shift * shift);
      cut_variance = std::max(cut_variance, Scalar(1e-4) * variance);
    } else {  // far out: at the bound, and off by as much as there is contradiction
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
  const InertialVector<Scalar> slope = free.covariance.col(0) / variance;
  cut.mean += slope * (cut_mean - mass);
  cut.covariance += slope * slope.transpose() * (cut_variance - variance);
  return cut;
}

/// (m, r) of (m, m r): r = (m r) / m to first order. Of a payload so light that its centre does not show, the prior's
/// centre of mass is as good as any.
template <typename Scalar>
PayloadGaussian<Scalar> payload_of(const InertialGaussian<Scalar>& phi, const PayloadPrior<Scalar>& prior) noexcept {
  PayloadGaussian<Scalar> out;
  const Scalar mass = phi.mean[0];
  out.mean << mass, prior.com_mean;
  out.covariance.setZero();
  out.covariance(0, 0) = phi.covariance(0, 0);
  out.covariance.diagonal().template tail<3>() = prior.com_std.cwiseAbs2();
  if (!(mass * mass > phi.covariance(0, 0)) || !(mass > 0)) return out;
  const Vector3<Scalar> com = phi.mean.template segment<3>(1) / mass;
  Matrix4<Scalar> derivative = Matrix4<Scalar>::Zero();
  derivative(0, 0) = 1;
  derivative.template bottomLeftCorner<3, 1>() = -com / mass;
  derivative.template bottomRightCorner<3, 3>().diagonal().setConstant(1 / mass);
  out.mean.template tail<3>() = com;
  out.covariance = derivative * phi.covariance.template topLeftCorner<4, 4>() * derivative.transpose();
  // What cancels in it must not leave a variance below zero.
  out.covariance.diagonal() = out.covariance.diagonal().cwiseMax(Scalar(1e-12));
  return out;
}

}  // namespace rme
