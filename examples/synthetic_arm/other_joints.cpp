// Arms of any other joint count, compiled once for all programs and tests.
#include <synthetic_arm/synthetic_arm.hpp>

namespace rme::examples {

template struct ArmModel<4>;
template struct ArmModel<5>;
template struct ArmModel<6>;
template struct ArmModel<8>;
template class RungeKutta<6>;
template class SyntheticArm<6>;

}  // namespace rme::examples
