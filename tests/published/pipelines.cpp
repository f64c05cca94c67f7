#include "published/pipelines.hpp"

namespace rme {

template class PublishedPipeline<float, 7>;
template class PublishedPipeline<double, 7, FixedGuess<double>>;
template class PublishedPipeline<float, 7, FixedGuess<float>>;

}  // namespace rme
