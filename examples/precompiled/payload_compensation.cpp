#include <precompiled/rme.hpp>

namespace rme {

template class CompensationRamp<double, 7>;
template class PayloadCompensation<double, 7>;

}  // namespace rme
