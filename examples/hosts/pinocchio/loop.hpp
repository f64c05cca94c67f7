#pragma once
/// The lines that a controller with Pinocchio gains: those that docs/embedding.md shows.
// <snippet pinocchio_loop>
#include <rme/host/payload_compensation.hpp>
#include <rme/host/pinocchio.hpp>
// </snippet>

#include <string>
#include <vector>

namespace hosts {

// <snippet pinocchio_loop>
template <int Dofs>
class CarryingArm {
 public:
  using Vector = rme::JointVector<double, Dofs>;

  CarryingArm(const pinocchio::Model& robot, const std::vector<std::string>& joints, const std::string& end_effector,
              double period, const rme::EstimatorConfig<double, Dofs>& config)
      : sensing_(rme::pinocchio_arm(robot, joints), end_effector, period, config), payload_(period, config) {}

  /// Each tick: what to command instead of `nominal`, which is your controller's torque, gravity included.
  /// @param tau     torque that the motors exert, as measured, or all of your last command [N m]
  /// @param period  measured [s]
  Vector command(const Vector& nominal, const Vector& q, const Vector& dq, const Vector& tau, double period) {
    rme::Status status = sensing_.update(q, dq, tau, period, sample_);
    if (status == rme::Status::Ok) status = payload_.update(sample_);
    return nominal + payload_.torque();  // after a bad sample: with the last compensation
  }

 private:
  rme::PinocchioSensing<Dofs> sensing_;
  rme::PayloadCompensation<double, Dofs> payload_;
  rme::Proprioception<double, Dofs> sample_;
};
// </snippet>

}  // namespace hosts
