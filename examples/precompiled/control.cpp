#include <precompiled/rme.hpp>

namespace rme {

template class PassiveController<double>;
template class JointLimits<double, 7>;
template class Cpic<double, 7, 8>;
template class Cpic<double, 7>;

}  // namespace rme
