#pragma once
/// For an effort controller of franka_ros2: the compensation, from the state interfaces of the robot.
#include <cstring>
#include <franka_semantic_components/franka_robot_model.hpp>
#include <rme/host/franka.hpp>

#include <string>
#include <vector>

namespace hosts {

/// A member of your controller. Construct it in on_configure(): that may throw.
class FrankaPayload {
 public:
  /// @param robot  name of the robot, such as fr3
  FrankaPayload(const std::string& robot, double period, const rme::PayloadCompensationConfig<double, 7>& config)
      : state_name_(robot + "/robot_state"), model_(robot + "/robot_model", state_name_), payload_(period, config) {}

  /// To add to those of state_interface_configuration().
  std::vector<std::string> state_interfaces() const { return model_.get_state_interface_names(); }
  /// In on_activate() and on_deactivate(), with the controller's state_interfaces_.
  void activate(std::vector<hardware_interface::LoanedStateInterface>& interfaces) {
    model_.assign_loaned_state_interfaces(interfaces);
    payload_.reset();
  }
  void deactivate() { model_.release_interfaces(); }

  /// In update(). Afterwards, add compensation().torque() to your torque, which contains no gravity: the robot adds that.
  /// @param value   of the state interface robot_state: its bits are a pointer
  /// @param period  measured [s]
  rme::Status update(double value, double period) {
    const franka::RobotState* state = nullptr;
    static_assert(sizeof state == sizeof value, "franka_ros2 keeps a pointer in a double");
    std::memcpy(&state, &value, sizeof state);
    if (state == nullptr) return rme::Status::NotReady;
    const auto jacobian = model_.getZeroJacobian(franka::Frame::kEndEffector);
    return payload_.update(rme::franka_sample(jacobian, *state, period));
  }
  rme::PayloadCompensation<double, 7>& compensation() { return payload_; }

 private:
  std::string state_name_;
  franka_semantic_components::FrankaRobotModel model_;
  rme::PayloadCompensation<double, 7> payload_;
};

}  // namespace hosts
