#include <precompiled/rme.hpp>

namespace rme {

template class EventInference<double, 7>;
template class PayloadStatistics<double, 7>;
template class SampleWindow<double, 7>;
template class WindowStatistics<double, 7>;
template class Estimator<double, 7>;
template class MismatchDetector<7>;
template class PassiveController<double>;
template class JointLimits<double, 7>;
template class Cpic<double, 7, 8>;
template class Cpic<double, 7>;

}  // namespace rme
