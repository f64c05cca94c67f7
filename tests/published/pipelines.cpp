#include "published/pipelines.hpp"

namespace rme {

template Status infer_payload(const PayloadLikelihood<float>&, const PayloadGaussian<float>&, InferenceResult<float>&,
                              const StochasticViConfig&, std::mt19937_64&) noexcept;
template class PublishedPipeline<float, 7>;
template class PublishedPipeline<double, 7, FixedGuess<double>>;
template class PublishedPipeline<float, 7, FixedGuess<float>>;

}  // namespace rme
