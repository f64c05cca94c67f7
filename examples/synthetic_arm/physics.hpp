#pragma once
/// What moves a simulated arm. Sensors, payloads' comings and goings and the control period are SyntheticArm's
/// business; a Physics takes the arm from one state to the next, so that another engine can stand in for our own.
#include <memory>
#include <rme/core/wrench.hpp>
#include <synthetic_arm/arm_model.hpp>

namespace rme::examples {

/// Where the joints are and how fast they move.
template <int Dofs>
struct JointState {
  JointVector<double, Dofs> q;   ///< [rad]
  JointVector<double, Dofs> dq;  ///< [rad/s]
};

/// Dry and viscous friction of the joints; as it stands there is none.
template <int Dofs>
struct JointFriction {
  using Vector = JointVector<double, Dofs>;
  Vector coulomb = Vector::Zero();  ///< Coulomb friction; also the torque at which a joint breaks away [N m]
  Vector viscous = Vector::Zero();  ///< [N m s/rad]
};

/// What acts on the arm during an integration step.
template <int Dofs>
struct Load {
  JointVector<double, Dofs> torque;  ///< at the joints, gravity included [N m]
  RigidBody payload;                 ///< welded to the flange, flange axes
  Wrench<double> push;               ///< at the flange origin, world axes
};

/// An integrator of M(q) ddq + C(q, dq) dq + g(q) = torque + friction + J^T push, payload included.
template <int Dofs>
class Physics {
 public:
  virtual ~Physics() = default;
  /// Advances the state by `h` [s] under a load that lasts.
  /// @return the joints' friction torque, averaged over the step [N m]
  virtual JointVector<double, Dofs> step(double h, const Load<Dofs>& load, JointState<Dofs>& state) = 0;
};

/// Makes the physics of an arm. Plain functions, so that a configuration that names one can be copied.
template <int Dofs>
using MakePhysics = std::unique_ptr<Physics<Dofs>> (*)(const ArmModel<Dofs>&, const JointFriction<Dofs>&);

}  // namespace rme::examples
