#include <precompiled/rme.hpp>

namespace rme {

template Status infer_payload(const PayloadLikelihood<double>&, const PayloadGaussian<double>&,
                              InferenceResult<double>&, const StochasticViConfig&, std::mt19937_64&) noexcept;
template class MismatchNetwork<double>;
template class MismatchNetwork<float>;
template class PublishedPipeline<double, 7>;

}  // namespace rme
