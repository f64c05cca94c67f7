// The arm that nearly all programs and tests run on, compiled once.
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

namespace rme::examples {

template struct ArmModel<7>;
template class RungeKutta<7>;
template class SyntheticArm<7>;
template class PoseImpedance<7>;

}  // namespace rme::examples
