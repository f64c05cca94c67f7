#pragma once
// Precompiled for the examples, the tests and the benchmarks: what most of them include, and the classes that most of
// them instantiate, which rme.cpp does once for all. A program that does not see this file compiles just the same.
#include <Eigen/Dense>
#include <rme/control/barriers.hpp>
#include <rme/control/cpic.hpp>
#include <rme/control/passive_controller.hpp>
#include <rme/estimator.hpp>

namespace rme {

extern template class EventInference<double, 7>;
extern template class PayloadStatistics<double, 7>;
extern template class SampleWindow<double, 7>;
extern template class WindowStatistics<double, 7>;
extern template class Estimator<double, 7>;
extern template class MismatchDetector<7>;
extern template class PassiveController<double>;
extern template class JointLimits<double, 7>;
extern template class Cpic<double, 7, 8>;
extern template class Cpic<double, 7>;

}  // namespace rme
