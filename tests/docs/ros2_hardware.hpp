#pragma once
// Hardware behind the stand-in for ros2_control.
#include <cmath>
#include <controller_interface/controller_interface.hpp>
#include <map>
#include <memory>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <utility>
#include <vector>

#include "support/catch.hpp"

namespace rme::testing {

inline std::vector<std::string> joint_names() {
  std::vector<std::string> names;
  for (int j = 1; j <= 7; ++j) names.push_back("panda_joint" + std::to_string(j));
  return names;
}

/// Hardware that reports position, velocity and torque of each joint, and nothing else; and the controller manager.
struct Hardware {
  using Vector = JointVector<double, 7>;
  explicit Hardware(controller_interface::ControllerInterface& owner) : controller(owner) {
    controller.get_node()->override_parameter("joints", joint_names());
    controller.get_node()->override_parameter("end_effector", std::string("panda_link8"));
    controller.get_node()->override_parameter("rated_payload", 3.0);
  }
  void activate() {
    REQUIRE(controller.init({"payload", "<robot name='panda'/> with panda_finger_joint1, panda_finger_joint2", 1000}) ==
            controller_interface::return_type::OK);
    REQUIRE(controller.on_configure({}) == controller_interface::CallbackReturn::SUCCESS);
    // Interfaces are lent by name, in the order in which the controller asks for them.
    std::vector<hardware_interface::LoanedStateInterface> states;
    std::vector<hardware_interface::LoanedCommandInterface> commands;
    for (const std::string& name : controller.state_interface_configuration().names) states.emplace_back(handle(name));
    for (const std::string& name : controller.command_interface_configuration().names)
      commands.emplace_back(handle("command of " + name));
    controller.assign_interfaces(std::move(commands), std::move(states));
    REQUIRE(controller.on_activate({}) == controller_interface::CallbackReturn::SUCCESS);
  }
  hardware_interface::Handle::SharedPtr handle(const std::string& name) {
    auto& found = handles[name];
    if (!found) found = std::make_shared<hardware_interface::Handle>(hardware_interface::Handle{name});
    return found;
  }

  controller_interface::return_type tick() {
    const Vector gravity = examples::panda().dynamics(arm.q(), Vector::Zero()).gravity;
    for (int j = 0; j < 7; ++j) {
      const std::string& name = names[static_cast<std::size_t>(j)];
      handles.at(name + "/position")->value = arm.q()[j];
      handles.at(name + "/velocity")->value = arm.dq()[j];
      const double friction = load_friction * std::abs(gravity[j]) * std::tanh(arm.dq()[j] / 0.02);
      handles.at(name + "/effort")->value =
          (arm.tau_measured()[j] - (lacks_gravity ? gravity[j] : 0) + friction) / gains[j];
    }
    if (torque_is_lost) handles.at("panda_joint7/effort")->value = std::nan("");
    const auto result = controller.update(rclcpp::Time(), period);
    arm.step(commanded());
    return result;
  }
  /// @return how many went well
  int run(int ticks) {
    int good = 0;
    for (int k = 0; k < ticks; ++k) good += tick() == controller_interface::return_type::OK ? 1 : 0;
    return good;
  }
  Vector commanded() const {
    Vector tau;
    for (int j = 0; j < 7; ++j)
      tau[j] = handles.at("command of " + names[static_cast<std::size_t>(j)] + "/effort")->value;
    return tau;
  }

  controller_interface::ControllerInterface& controller;
  examples::SyntheticArm<7> arm{examples::panda(), examples::SyntheticArmConfig<7>(), examples::panda().ready};
  std::map<std::string, hardware_interface::Handle::SharedPtr> handles;
  const std::vector<std::string> names = joint_names();
  const rclcpp::Duration period = rclcpp::Duration::from_seconds(1e-3);
  Vector gains = Vector::Ones();  // [N m] for what `effort` is in
  double load_friction = 0;       // that the motors give besides, for each N m of gravity torque on a joint that moves
  bool torque_is_lost = false;
  bool lacks_gravity = false;  // effort is the torque less gravity
};

}  // namespace rme::testing
