#pragma once
/// The estimators that are compiled in rme_precompiled_any_joints, so that what links it need not compile them.
#include <rme/estimator.hpp>

namespace rme {

extern template class Estimator<double, 4>;
extern template class Estimator<double, 5>;
extern template class Estimator<double, 6>;
extern template class Estimator<double, 7>;
extern template class Estimator<double, 8>;

}  // namespace rme
