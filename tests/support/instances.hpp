#pragma once
// What several tests instantiate and the examples do not: compiled once, in instances.cpp. A test that does not see
// this file compiles just the same.
#include <precompiled/rme.hpp>

namespace rme {

extern template class StarGaussian<double, 2>;
extern template class StarGaussian<double, 3>;
extern template class StarGaussian<double, 7>;
extern template class Disturbance<double, 7>;
extern template class JointTorqueModel<double, 7>;
extern template class BlockAverager<double, 7>;
extern template class Histories<double, 7>;
extern template class Tracker<double, 7>;
extern template class Histories<float, 7>;
extern template class Tracker<float, 7>;
extern template class Estimator<float, 7>;

}  // namespace rme
