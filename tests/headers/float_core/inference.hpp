#pragma once
#include <rme/inference/inference_result.hpp>

namespace float_core {

using Solver = rme::Status (*)(const rme::PayloadLikelihood<float>&, const rme::PayloadGaussian<float>&,
                               rme::InferenceResult<float>&);

/// In 30 random events: the truth within five of the exact posterior's deviations, and a solver's mean within half a
/// one of the exact mean.
bool finds_the_payload(Solver solve);

}  // namespace float_core
