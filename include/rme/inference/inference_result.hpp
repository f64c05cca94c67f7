#pragma once
/// What an inference has found, whichever of the solvers made it.
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>

namespace rme {

/// Every solver is called as
///
///     Status infer(likelihood, prior, result, config)
///
/// and the type of `config` chooses it: VariationalInferenceConfig (the default), MeanFieldConfig, ExactQuadrature, or
/// StochasticViConfig, which wants a random generator after it (docs/theory.md, "Four solvers").
template <typename Scalar>
struct InferenceResult {
  PayloadGaussian<Scalar> posterior;  ///< mean and covariance
  /// log p(y) - log p(y | m = 0), what the data say for a payload and against an empty hand [nats]: exact, or the ELBO,
  /// which bounds it from below.
  Scalar log_evidence = Scalar(0);
  int iterations = 0;  ///< steps of the solver; of a quadrature its nodes
};

}  // namespace rme
