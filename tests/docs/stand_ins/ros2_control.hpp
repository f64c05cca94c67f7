#pragma once
// As much of ros2_control as the snippets of docs/embedding.md use, by its names and signatures.
#include <optional>
#include <string>
#include <vector>

namespace rclcpp {
class Time {};
class Duration {};
}  // namespace rclcpp

namespace rclcpp_lifecycle {
class State {};
}  // namespace rclcpp_lifecycle

namespace hardware_interface {

class LoanedStateInterface {
 public:
  explicit LoanedStateInterface(const double& value) : value_(&value) {}
  template <typename T = double>
  [[nodiscard]] std::optional<T> get_optional() const {
    return *value_;
  }

 private:
  const double* value_;
};

class LoanedCommandInterface {
 public:
  explicit LoanedCommandInterface(double& value) : value_(&value) {}
  template <typename T>
  [[nodiscard]] bool set_value(const T& value) {
    *value_ = value;
    return true;
  }

 private:
  double* value_;
};

}  // namespace hardware_interface

namespace controller_interface {

enum class return_type { OK, ERROR };
enum class CallbackReturn { SUCCESS, ERROR };

class ControllerInterface {
 public:
  virtual ~ControllerInterface() = default;
  virtual CallbackReturn on_configure(const rclcpp_lifecycle::State&) = 0;
  virtual CallbackReturn on_activate(const rclcpp_lifecycle::State&) = 0;
  virtual return_type update(const rclcpp::Time& time, const rclcpp::Duration& period) = 0;

  void assign_interfaces(std::vector<hardware_interface::LoanedCommandInterface>&& command_interfaces,
                         std::vector<hardware_interface::LoanedStateInterface>&& state_interfaces) {
    command_interfaces_ = std::move(command_interfaces);
    state_interfaces_ = std::move(state_interfaces);
  }
  unsigned int get_update_rate() const { return 1000; }
  const std::string& get_robot_description() const { return description_; }

 protected:
  std::vector<hardware_interface::LoanedCommandInterface> command_interfaces_;
  std::vector<hardware_interface::LoanedStateInterface> state_interfaces_;

 private:
  std::string description_ = "<robot/>";
};

}  // namespace controller_interface
