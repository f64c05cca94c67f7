#pragma once
/// For an arm of motors in "MIT mode" (quasi-direct drives on a CAN bus: OpenArm, YAM and the like), of which there is a
/// URDF and the motors' currents: the torque to send as feedforward.
#include <rme/host/payload_compensation.hpp>
#include <rme/host/pinocchio.hpp>
#include <string>
#include <vector>

namespace hosts {

/// What each motor is sent; the motor computes its torque from it at its own, higher rate.
template <int Dofs>
struct MitCommand {
  using Vector = rme::JointVector<double, Dofs>;
  Vector q = Vector::Zero(), dq = Vector::Zero();   ///< [rad], [rad/s]
  Vector kp = Vector::Zero(), kd = Vector::Zero();  ///< [N m/rad], [N m s/rad]
  Vector feedforward = Vector::Zero();              ///< [N m]

  /// Torque of the motors where the joints are at q_now and move at dq_now [N m]. For motors that report no torque: the
  /// feedforward alone is not what they exert.
  Vector torque(const Vector& q_now, const Vector& dq_now) const {
    return kp.cwiseProduct(q - q_now) + kd.cwiseProduct(dq - dq_now) + feedforward;
  }
};

template <int Dofs>
class MitArm {
 public:
  using Vector = rme::JointVector<double, Dofs>;

  /// @param robot         from the URDF; a gripper's joints are locked
  /// @param joints        names of the joints, from the base
  /// @param end_effector  name of a frame
  /// @param period        of the loop over the bus [s], such as 0.002
  /// @param config        settings; its estimator's are mit_config()
  /// @param rotors        inertia of each rotor, gear included: rotor times ratio squared [kg m^2]
  MitArm(const pinocchio::Model& robot, const std::vector<std::string>& joints, const std::string& end_effector,
         double period, const rme::PayloadCompensationConfig<double, Dofs>& config,
         const Vector& rotors = Vector::Zero())
      : sensing_(rme::pinocchio_arm(robot, joints), end_effector, period, config.estimator, Vector::Ones(), rotors),
        payload_(period, config) {}

  /// Each tick.
  /// @param torque  of the motors: what they report (current times torque constant, gear included), or
  ///                MitCommand::torque() of the last command [N m]
  /// @param period  measured [s]
  /// @return feedforward of the next command: gravity torque of the arm and of the payload [N m]
  Vector feedforward(const Vector& q, const Vector& dq, const Vector& torque, double period) {
    status_ = sensing_.update(q, dq, torque, period, sample_);
    if (status_ == rme::Status::Ok) {
      status_ = payload_.update(sample_);
      gravity_ = sensing_.gravity();
    }
    return gravity_ + payload_.torque();  // after a bad sample, such as a motor's that did not answer: as before
  }
  rme::Status status() const { return status_; }  ///< of the last feedforward()
  rme::PayloadCompensation<double, Dofs>& compensation() { return payload_; }

 private:
  rme::PinocchioSensing<Dofs> sensing_;
  rme::PayloadCompensation<double, Dofs> payload_;
  rme::Proprioception<double, Dofs> sample_;
  rme::Status status_ = rme::Status::NotReady;
  Vector gravity_ = Vector::Zero();
};

/// Settings for motors whose current is the only torque that they know: all of the gears' friction is in it.
/// @param rated_payload  of the arm [kg]
/// @param coulomb        Coulomb friction to expect of each joint; within a factor of two will do [N m]
/// @param viscous        viscous friction to expect of each joint [N m s/rad]
template <int Dofs>
rme::EstimatorConfig<double, Dofs> mit_config(double rated_payload, const rme::JointVector<double, Dofs>& coulomb,
                                              const rme::JointVector<double, Dofs>& viscous) {
  rme::EstimatorConfig<double, Dofs> config;
  config.rated_payload = rated_payload;
  config.arm = rme::ArmPrior<double, Dofs>::of(rated_payload);
  config.arm->coulomb = coulomb;
  config.arm->viscous = viscous;
  return config;
}

}  // namespace hosts
