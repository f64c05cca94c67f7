#pragma once
/// The pipelines that the tests of this folder run, beside that of examples/precompiled, and their inference: compiled
/// once for all of them.
#include <rme/published/fixed_guess.hpp>
#include <rme/published/published_pipeline.hpp>

namespace rme {

extern template Status infer_payload(const PayloadLikelihood<float>&, const PayloadGaussian<float>&,
                                     InferenceResult<float>&, const StochasticViConfig&, std::mt19937_64&) noexcept;
extern template class PublishedPipeline<float, 7>;
extern template class PublishedPipeline<double, 7, FixedGuess<double>>;
extern template class PublishedPipeline<float, 7, FixedGuess<float>>;

}  // namespace rme
