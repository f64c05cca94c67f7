#pragma once
// As much of franka_ros2 as its host uses, by its names and signatures.
#include <franka/model.h>
#include <franka/robot.h>

#include <array>
#include <controller_interface/controller_interface.hpp>
#include <cstring>
#include <functional>
#include <memory>
#include <stdexcept>
#include <string>
#include <vector>

namespace franka_semantic_components {

class FrankaRobotModel {
 public:
  FrankaRobotModel(const std::string& franka_model_interface_name, const std::string& franka_state_interface_name)
      : names_{franka_model_interface_name, franka_state_interface_name} {}
  FrankaRobotModel() = delete;
  virtual ~FrankaRobotModel() = default;

  virtual std::vector<std::string> get_state_interface_names() const { return names_; }
  /// Keeps those of its names.
  bool assign_loaned_state_interfaces(std::vector<hardware_interface::LoanedStateInterface>& state_interfaces) {
    for (const std::string& name : names_)
      for (auto& interface : state_interfaces)
        if (interface.get_name() == name) state_interfaces_.emplace_back(interface);
    return state_interfaces_.size() == names_.size();
  }
  void release_interfaces() { state_interfaces_.clear(); }

  /// @throws std::runtime_error without its interfaces
  std::array<double, 42> getZeroJacobian(const franka::Frame& frame) {
    if (state_interfaces_.size() != 2) throw std::runtime_error("Franka state interfaces does not exist");
    const double value = state_interfaces_[1].get().get_optional().value_or(0);
    const franka::RobotState* state = nullptr;
    std::memcpy(&state, &value, sizeof state);
    return model_.zeroJacobian(frame, *state);
  }

 private:
  std::vector<std::string> names_;
  std::vector<std::reference_wrapper<hardware_interface::LoanedStateInterface>> state_interfaces_;
  franka::Model model_ = franka::Robot(franka::Robot::Simulation()).loadModel();
};

}  // namespace franka_semantic_components
