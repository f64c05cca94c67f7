#include "support/instances.hpp"

namespace rme {

template class StarGaussian<double, 2>;
template class StarGaussian<double, 3>;
template class StarGaussian<double, 7>;
template class Disturbance<double, 7>;
template class JointTorqueModel<double, 7>;
template class BlockAverager<double, 7>;
template class Histories<double, 7>;
template class Tracker<double, 7>;
template class Histories<float, 7>;
template class Tracker<float, 7>;
template class Estimator<float, 7>;

}  // namespace rme
