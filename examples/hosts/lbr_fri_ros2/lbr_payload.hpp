#pragma once
/// For a torque controller of lbr_fri_ros2_stack (KUKA LBR iiwa and Med): the compensation, from the state interfaces of
/// the robot.
#include <cmath>
#include <controller_interface/controller_interface.hpp>
#include <cstddef>
#include <functional>
#include <lbr_ros2_control/system_interface_type_values.hpp>
#include <rme/host/payload_compensation.hpp>
#include <rme/host/pinocchio.hpp>
#include <string>
#include <vector>

#include "hosts/ros2_control/versions.hpp"

namespace hosts {

/// Settings for what the stack reports. Its low-pass filter of the external torque moves by this share a of the way in
/// each period h; rme wants the bandwidth K of the same filter at 1 kHz:
///
///     a = c - 1 + sqrt(c^2 - 4 c + 3),   c = cos(2 pi f h),   (1 - K 1 ms)^(h / 1 ms) = 1 - a
///
/// @param cutoff       f, the stack's external_torque_cutoff_frequency [Hz]
/// @param sample_time  h, of FRI as set on the robot [s]
inline rme::EstimatorConfig<double, 7> lbr_config(double cutoff = 10, double sample_time = 0.005) {
  const double c = std::cos(2 * 3.141592653589793 * cutoff * sample_time);
  const double share = c - 1 + std::sqrt(c * c - 4 * c + 3);
  rme::EstimatorConfig<double, 7> config;
  config.rated_payload = 7;  // [kg]; an LBR iiwa 14's is 14
  config.observer_bandwidth = (1 - std::pow(1 - share, 0.001 / sample_time)) / 0.001;
  config.sensing = rme::Sensing::LinkSide;
  return config;
}

/// A member of your controller. Construct it in on_configure(): that may throw.
class LbrPayload {
 public:
  using Vector = rme::JointVector<double, 7>;

  /// @param robot         from the robot's description, without tool if the robot knows none
  /// @param joints        names of the seven joints, from the base, such as lbr_A1
  /// @param end_effector  name of a frame, such as lbr_link_ee
  /// @param period        of the controller [s]
  /// @param config        settings; its estimator's are lbr_config()
  LbrPayload(const pinocchio::Model& robot, const std::vector<std::string>& joints, const std::string& end_effector,
             double period, const rme::PayloadCompensationConfig<double, 7>& config)
      : joints_(joints),
        sensing_(rme::pinocchio_arm(robot, joints), end_effector, period, config.estimator),
        payload_(period, config) {}

  /// To add to those of state_interface_configuration().
  std::vector<std::string> state_interfaces() const {
    std::vector<std::string> names;
    for (const std::string& joint : joints_)
      for (const char* quantity : {"position", "velocity", lbr_ros2_control::HW_IF_EXTERNAL_TORQUE})
        names.push_back(joint + "/" + quantity);
    return names;
  }
  /// In on_activate() and on_deactivate(), with the controller's state_interfaces_.
  /// @return whether all of them are there
  bool activate(std::vector<hardware_interface::LoanedStateInterface>& interfaces) {
    state_.clear();
    for (const std::string& name : state_interfaces())
      for (const hardware_interface::LoanedStateInterface& interface : interfaces)
        if (interface.get_name() == name) state_.emplace_back(interface);
    sensing_.reset();
    payload_.reset();
    return state_.size() == 21;
  }
  void deactivate() { state_.clear(); }

  /// In update(). Afterwards, add compensation().torque() to your torque overlay, which contains no gravity: the robot
  /// adds that.
  /// @param period  measured [s]
  rme::Status update(double period) {
    if (state_.size() != 21) return rme::Status::NotReady;
    Vector q, dq, tau_ext;
    std::size_t i = 0;
    for (int j = 0; j < 7; ++j)
      for (Vector* v : {&q, &dq, &tau_ext}) (*v)[j] = read(state_[i++].get());  // NaN until the robot is connected
    const rme::Status status = sensing_.update_external(q, dq, tau_ext, period, sample_);
    return status == rme::Status::Ok ? payload_.update(sample_) : status;
  }
  rme::PayloadCompensation<double, 7>& compensation() { return payload_; }

 private:
  std::vector<std::string> joints_;
  rme::PinocchioSensing<7> sensing_;
  rme::PayloadCompensation<double, 7> payload_;
  rme::Proprioception<double, 7> sample_;
  std::vector<std::reference_wrapper<const hardware_interface::LoanedStateInterface>> state_;
};

}  // namespace hosts
