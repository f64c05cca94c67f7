#pragma once
/// A light seven-joint arm with quasi-direct drives: motors with a gear of one or two stages, whose current is the only
/// torque that they know.
#include <synthetic_arm/arm_model.hpp>

namespace rme::examples {

/// An arm of the size of today's open arms for robot learning (0.65 m reach, 4.5 kg). The numbers are realistic and
/// invented: it is nobody's product. Coulomb and viscous friction are what such gears have when they are identified:
/// 5 to 10 times a Panda's, for a third of its payload.
const ArmModel<7>& light_arm();

/// What the light arm is rated for [kg].
inline constexpr double kLightArmPayload = 1.5;

}  // namespace rme::examples
