#pragma once
/// What most tests of this folder begin with: the likelihoods of random events, and solvers that two of them call.
/// Compiled once.
#include <rme/inference/variational_inference.hpp>

#include "support/random_events.hpp"

namespace rme::testing {

/// What an event's samples say.
PayloadLikelihood<double> likelihood_of(const Event& event);
/// The same if their noise had this precision.
PayloadLikelihood<double> likelihood_of(const Event& event, const JointVector<double, kDofs>& precision);

PayloadLikelihood<float> in_float(const PayloadLikelihood<double>& l);
PayloadGaussian<float> in_float(const PayloadGaussian<double>& prior);

}  // namespace rme::testing

namespace rme {

extern template Status infer_payload(const PayloadLikelihood<float>&, const PayloadGaussian<float>&,
                                     InferenceResult<float>&, const VariationalInferenceConfig&,
                                     const Vector4<float>*) noexcept;

}  // namespace rme
