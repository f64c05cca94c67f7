#pragma once
/// The result of an inference, the same for all solvers.
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>

namespace rme {

/// Every solver is called as
///
///     Status infer_payload(likelihood, prior, result, config)
///
/// and the type of `config` selects the solver: VariationalInferenceConfig (the default), MeanFieldConfig,
/// ExactQuadrature, or StochasticViConfig, after which a random generator is passed (docs/theory.md, "Four solvers").
template <typename Scalar>
struct InferenceResult {
  PayloadGaussian<Scalar> posterior;  ///< mean and covariance [kg, m, m, m]
  /// log p(y) - log p(y | m = 0), the log evidence of a payload relative to an empty hand [nats]: exact, or the ELBO,
  /// which bounds it from below.
  Scalar log_evidence = Scalar(0);
  int iterations = 0;  ///< steps of the solver; for the quadrature, evaluations of the density
};

}  // namespace rme
