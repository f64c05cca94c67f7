#pragma once
/// The estimators that rme_precompiled_any_joints has, so that what links it need not compile them: those within
/// RME_JOINT_COUNTS. That for seven joints is in rme_precompiled.
#include <precompiled/joint_counts.hpp>
#include <rme/estimator.hpp>

namespace rme {

extern template class Estimator<double, 4>;
extern template class Estimator<double, 5>;
extern template class Estimator<double, 6>;
extern template class Estimator<double, 8>;

}  // namespace rme
