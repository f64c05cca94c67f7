#pragma once
/// The likelihood of the paper: white noise whose standard deviation is a quarter of the torque's range.
#include <algorithm>
#include <limits>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/payload_likelihood.hpp>
#include <rme/inference/payload_statistics.hpp>

namespace rme {

/// Settings of published_likelihood(); the defaults are the published ones.
struct PublishedLikelihoodConfig {
  int samples = 50;           ///< taken from the window, uniformly spaced, first and last included, >= 2
  double range_share = 0.25;  ///< sigma_j as a share of the range of joint j's torque, >= 0
  double least_sigma = 0.1;   ///< lower bound of sigma_j [N m], > 0
};

/// tau_t ~ N(m (a_t + B_t r), diag(sigma_j^2)) over uniformly spaced samples, with
///
///     sigma_j = max(0.25 (max_t tau_j - min_t tau_j), 0.1 N m)     (docs/theory.md (T41))
///
/// It has no offset, no friction and no correlation of the noise. The paper takes the raw tau_ext and the regressor at
/// rest.
/// @param count            samples in the window, >= 1; if there are fewer than config.samples, some are taken twice
/// @param at               callable (int i) -> PayloadObservation, i from 0 to count - 1; tau and regressor are used
/// @param[out] likelihood  as it was unless the status is Ok
/// @param config           the defaults are the published ones
/// @return Ok; NotReady (an empty window); NonFiniteInput
template <typename Scalar, int Dofs, typename At>
Status published_likelihood(int count, const At& at, PayloadLikelihood<Scalar>& likelihood,
                            const PublishedLikelihoodConfig& config = PublishedLikelihoodConfig()) noexcept {
  if (count < 1) return Status::NotReady;
  PayloadStatistics<Scalar, Dofs> sums;
  constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  JointVector<Scalar, Dofs> least = JointVector<Scalar, Dofs>::Constant(kInfinity), most = -least;
  const int gaps = std::max(config.samples - 1, 1);
  for (int k = 0; k <= gaps; ++k) {
    const PayloadObservation<Scalar, Dofs>& o = at((k * (count - 1) + gaps / 2) / gaps);
    if (!o.tau.allFinite() || !o.regressor.a.allFinite() || !o.regressor.B.allFinite()) return Status::NonFiniteInput;
    sums.add(o);
    least = least.cwiseMin(o.tau);
    most = most.cwiseMax(o.tau);
  }
  const JointVector<Scalar, Dofs> sigma =
      (Scalar(config.range_share) * (most - least)).cwiseMax(Scalar(config.least_sigma));
  likelihood = sums.likelihood(sigma.cwiseAbs2().cwiseInverse());
  return Status::Ok;
}

}  // namespace rme
