#pragma once
/// Settings of the published pipeline.
#include <cmath>
#include <cstdint>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/published_likelihood.hpp>
#include <rme/inference/stochastic_vi.hpp>
#include <rme/sensing/mismatch_detector.hpp>

namespace rme {

/// Which solver infers the payload from the samples of a collection. All of them have the same likelihood and prior.
enum class PublishedSolver : std::uint8_t {
  Stochastic,  ///< stochastic variational inference, as published: a diagonal Gaussian, about half a millisecond
  ClosedForm,  ///< the Gaussian of full covariance that maximises the ELBO: a few microseconds
  MeanField,   ///< the diagonal Gaussian that maximises the ELBO: the published family, without the published noise
  Exact,       ///< mean and covariance of the exact posterior, by quadrature over the mass: about ten microseconds
};

/// The enumerator's name, for logs.
constexpr const char* to_string(PublishedSolver solver) noexcept {
  switch (solver) {
    case PublishedSolver::Stochastic:
      return "Stochastic";
    case PublishedSolver::ClosedForm:
      return "ClosedForm";
    case PublishedSolver::MeanField:
      return "MeanField";
    case PublishedSolver::Exact:
      return "Exact";
  }
  return "unknown";
}

/// Settings of PublishedPipeline; the defaults are the published ones.
template <typename Scalar>
struct PublishedPipelineConfig {
  MismatchDetectorConfig detector = MismatchDetectorConfig::published();  ///< of ||tau_ext||_2
  double collection = 0.2;        ///< how long samples are collected after the detection [s]: M to 1e6 samples
  Scalar damping = Scalar(0.01);  ///< lambda of the network's pseudo-wrenches [m^2], > 0: must be the training's
  /// Standard deviations of the prior around the network's output (m [kg], r_x, r_y, r_z [m]), each > 0.
  Vector4<Scalar> standard_deviation = {Scalar(0.5), Scalar(0.02), Scalar(0.02), Scalar(0.05)};
  PublishedLikelihoodConfig likelihood;                  ///< of the samples
  PublishedSolver solver = PublishedSolver::Stochastic;  ///< of the inference
  StochasticViConfig inference;                          ///< of PublishedSolver::Stochastic, with its early stop
  Vector3<Scalar> gravity = standard_gravity<Scalar>();  ///< g [m/s^2], world axes

  /// Checks all settings but the detector's, which the detector checks.
  /// @param dt  control period [s]
  /// @throws std::invalid_argument naming the field out of range
  void validate(double dt) const;
};

template <typename Scalar>
void PublishedPipelineConfig<Scalar>::validate(double dt) const {
  using detail::require;
  using detail::require_positive;
  require_positive(dt, "PublishedPipeline::dt", "> 0 s");
  require(collection / dt >= 1 && collection / dt < 1e6, "PublishedPipelineConfig::collection", "1 to 1e6 samples",
          collection / dt);
  require_positive(damping, "PublishedPipelineConfig::damping", "> 0");
  for (int i = 0; i < 4; ++i)
    require_positive(standard_deviation[i], "PublishedPipelineConfig::standard_deviation", "> 0");
  require(plausible(gravity) && gravity.norm() > 0, "PublishedPipelineConfig::gravity", "finite and not zero",
          gravity.norm());

  require(solver <= PublishedSolver::Exact, "PublishedPipelineConfig::solver", "one of the enumerators",
          static_cast<int>(solver));

  const PublishedLikelihoodConfig& l = likelihood;
  require(l.samples >= 2 && l.samples <= 1000, "PublishedLikelihoodConfig::samples", "2 to 1000", l.samples);
  require(l.range_share >= 0 && std::isfinite(l.range_share), "PublishedLikelihoodConfig::range_share", ">= 0",
          l.range_share);
  require_positive(l.least_sigma, "PublishedLikelihoodConfig::least_sigma", "> 0 N m");

  const StochasticViConfig& vi = inference;
  constexpr int kMost = 1000000000;  // two of them add up without overflow
  require_positive(vi.learning_rate, "StochasticViConfig::learning_rate", "> 0");
  require(vi.gradient_norm > 0, "StochasticViConfig::gradient_norm", "> 0, or infinity", vi.gradient_norm);
  require(vi.max_steps >= 1 && vi.max_steps <= kMost, "StochasticViConfig::max_steps", "1 to 1e9", vi.max_steps);
  require(vi.first_check >= 0, "StochasticViConfig::first_check", ">= 0", vi.first_check);
  require(vi.check_interval >= 1 && vi.check_interval <= kMost, "StochasticViConfig::check_interval", "1 to 1e9",
          vi.check_interval);
  require(vi.small_change >= 0, "StochasticViConfig::small_change", ">= 0", vi.small_change);
  require(vi.small_changes >= 1, "StochasticViConfig::small_changes", ">= 1", vi.small_changes);
  for (const double deviation : vi.initial_deviation)
    require_positive(deviation, "StochasticViConfig::initial_deviation", "> 0");
  require(vi.evidence_draws >= 1, "StochasticViConfig::evidence_draws", ">= 1", vi.evidence_draws);
}

}  // namespace rme
