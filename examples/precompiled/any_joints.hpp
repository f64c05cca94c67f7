#pragma once
/// The estimators that rme_precompiled_any_joints has, so that what links it need not compile them. That for seven joints is
/// in rme_precompiled.
#include <rme/estimator.hpp>

namespace rme {

extern template class Estimator<double, 4>;
extern template class Estimator<double, 5>;
extern template class Estimator<double, 6>;
extern template class Estimator<double, 8>;

}  // namespace rme
