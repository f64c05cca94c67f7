#pragma once
/// What most tests of this folder use: likelihoods and priors in float, and a solver that two of them call. Compiled once.
#include <rme/inference/variational_inference.hpp>

#include "support/random_events.hpp"

namespace rme::testing {

PayloadLikelihood<float> in_float(const PayloadLikelihood<double>& l);
PayloadGaussian<float> in_float(const PayloadGaussian<double>& prior);

}  // namespace rme::testing

namespace rme {

extern template Status infer_payload(const PayloadLikelihood<float>&, const PayloadGaussian<float>&,
                                     InferenceResult<float>&, const VariationalInferenceConfig&,
                                     const Vector4<float>*) noexcept;

}  // namespace rme
