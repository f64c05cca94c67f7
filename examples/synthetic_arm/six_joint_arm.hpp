#pragma once
/// A six-joint arm, to show that another robot is a table of numbers away.
#include <synthetic_arm/arm_model.hpp>

namespace rme::examples {

/// An arm of the size and layout of a 5 kg collaborative robot with an offset wrist (0.85 m reach, 18 kg). The numbers
/// are realistic and invented: it is nobody's product. Inertias are those of solid cylinders of the links' size; the
/// wrist's are larger by what geared drives add, which identified models lump into the links.
const ArmModel<6>& six_joint_arm();

}  // namespace rme::examples
