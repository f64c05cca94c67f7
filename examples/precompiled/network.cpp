#include <precompiled/rme.hpp>

namespace rme {

template class MismatchNetwork<double>;
template class MismatchNetwork<float>;
template class NetworkPrior<double>;
template PayloadGaussian<double> NetworkPrior<double>::operator()(const SampleWindow<double, 7>&,
                                                                  std::size_t) const noexcept;
template class PublishedPipeline<double, 7>;

}  // namespace rme
