#pragma once
/// The Franka Emika Panda: the numbers that its public models carry.
#include <synthetic_arm/arm_model.hpp>

namespace rme::examples {

/// The Panda without a hand. Inertias and friction: Gaz, Cognetti, Oliva, Robuffo Giordano, De Luca, "Dynamic
/// Identification of the Franka Emika Panda Robot With Retrieval of Feasible Parameters Using Penalty-Based
/// Optimization", RA-L 2019. Friction and sensor faults are typical, not identified (see panda_friction for those).
const ArmModel<7>& panda();

/// Friction of one real Panda as identified by Gaz et al. (above): the torque by which the measured joint torque
/// exceeds the rigid-body model, same sign as dq [N m]. Zero at rest.
JointVector<double, 7> panda_friction(const JointVector<double, 7>& dq);

}  // namespace rme::examples
