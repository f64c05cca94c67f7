#pragma once
/// The estimators that rme_replay has compiled, so that a program which links it need not.
#include <rme/estimator.hpp>

namespace rme {

extern template class Estimator<double, 4>;
extern template class Estimator<double, 5>;
extern template class Estimator<double, 6>;
extern template class Estimator<double, 7>;
extern template class Estimator<double, 8>;

}  // namespace rme
