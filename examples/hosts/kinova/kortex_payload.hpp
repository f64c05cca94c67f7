#pragma once
/// For a torque controller on Kinova's Kortex API (Gen3, low-level servoing): the compensation, from the cyclic feedback.
#include <BaseCyclic.pb.h>

#include <cmath>
#include <rme/host/payload_compensation.hpp>
#include <rme/host/pinocchio.hpp>
#include <string>
#include <vector>

namespace hosts {

/// Settings for what a Gen3 reports: its torque sensors show the opposite of the torque that is commanded.
template <int Dofs>
rme::EstimatorConfig<double, Dofs> kortex_config() {
  rme::EstimatorConfig<double, Dofs> config;
  config.torque_sign = rme::TorqueSign::Reaction;
  config.rated_payload = 4;  // [kg]
  return config;
}

/// @tparam Dofs  6 or 7
template <int Dofs>
class KortexPayload {
 public:
  using Vector = rme::JointVector<double, Dofs>;

  /// @param robot         from kortex_description; continuous joints are taken
  /// @param joints        names of the joints, from the base
  /// @param end_effector  name of a frame
  /// @param period        of the loop [s]
  /// @param config        settings; its estimator's are kortex_config()
  KortexPayload(const pinocchio::Model& robot, const std::vector<std::string>& joints, const std::string& end_effector,
                double period, const rme::PayloadCompensationConfig<double, Dofs>& config)
      : sensing_(rme::pinocchio_arm(robot, joints), end_effector, period, config.estimator), payload_(period, config) {}

  /// Once for each feedback.
  /// @param period  measured [s]
  rme::Status update(const Kinova::Api::BaseCyclic::Feedback& feedback, double period) {
    if (feedback.actuators_size() < Dofs) return rme::Status::NotReady;
    Vector q, dq, torque;
    for (int j = 0; j < Dofs; ++j) {
      const auto& actuator = feedback.actuators(j);
      q[j] = std::remainder(kRadian * static_cast<double>(actuator.position()), kTurn);  // reported from 0 to 360
      dq[j] = kRadian * static_cast<double>(actuator.velocity());
      torque[j] = static_cast<double>(actuator.torque());
    }
    const rme::Status status = sensing_.update(q, dq, torque, period, sample_);
    return status == rme::Status::Ok ? payload_.update(sample_) : status;
  }
  /// Puts nominal plus the compensation into the next command. A Gen3 in torque mode adds no gravity torque by itself.
  /// @param nominal   your torque, gravity included: gravity() has it [N m]
  /// @param feedback  of this tick: its positions are commanded as well, or the robot stops at a following error
  void command(const Vector& nominal, const Kinova::Api::BaseCyclic::Feedback& feedback,
               Kinova::Api::BaseCyclic::Command& out) const {
    const Vector torque = nominal + payload_.torque();
    out.set_frame_id((out.frame_id() + 1) & 0xffff);
    for (int j = 0; j < Dofs; ++j) {
      out.mutable_actuators(j)->set_command_id(out.frame_id());
      out.mutable_actuators(j)->set_position(feedback.actuators(j).position());
      out.mutable_actuators(j)->set_torque_joint(static_cast<float>(torque[j]));
    }
  }
  Vector gravity() const { return sensing_.gravity(); }  ///< of the arm, at the last update() [N m]
  rme::PayloadCompensation<double, Dofs>& compensation() { return payload_; }

 private:
  static constexpr double kTurn = 6.283185307179586, kRadian = kTurn / 360;  // [rad], [rad/deg]
  rme::PinocchioSensing<Dofs> sensing_;
  rme::PayloadCompensation<double, Dofs> payload_;
  rme::Proprioception<double, Dofs> sample_;
};

}  // namespace hosts
