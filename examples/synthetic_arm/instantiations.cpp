// Arms, compiled once for all programs and tests.
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

namespace rme::examples {

template struct ArmModel<4>;
template struct ArmModel<5>;
template struct ArmModel<6>;
template struct ArmModel<7>;
template struct ArmModel<8>;
template class RungeKutta<6>;
template class RungeKutta<7>;
template class SyntheticArm<6>;
template class SyntheticArm<7>;
template class PoseImpedance<7>;

}  // namespace rme::examples
