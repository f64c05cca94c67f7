#pragma once
// As much of ros2_control as the snippets of docs/embedding.md use, by its names and signatures. What is pure virtual
// there is so here.
#include <cstdio>
#include <map>
#include <memory>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

#define RCLCPP_ERROR(logger, ...) ((void)(logger), (void)std::snprintf(nullptr, 0, __VA_ARGS__))

namespace rclcpp {
class Time {};
class Duration {};
struct Logger {};

/// A parameter that is a string, or an array of them.
class Parameter {
 public:
  Parameter() = default;
  explicit Parameter(std::string value) : value_(std::move(value)), is_string_(true) {}
  explicit Parameter(std::vector<std::string> value) : values_(std::move(value)) {}
  const std::string& as_string() const {
    if (!is_string_) throw std::runtime_error("parameter is not a string");
    return value_;
  }
  const std::vector<std::string>& as_string_array() const {
    if (is_string_) throw std::runtime_error("parameter is not an array of strings");
    return values_;
  }

 private:
  std::string value_;
  std::vector<std::string> values_;
  bool is_string_ = false;
};
}  // namespace rclcpp

namespace rclcpp_lifecycle {
class State {};
class LifecycleNode {
 public:
  rclcpp::Logger get_logger() const { return {}; }
  rclcpp::Parameter get_parameter(const std::string& name) const { return parameters.at(name); }
  std::map<std::string, rclcpp::Parameter> parameters;
};
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
enum class CallbackReturn { SUCCESS, FAILURE, ERROR };
enum class interface_configuration_type { ALL, INDIVIDUAL, NONE };
struct InterfaceConfiguration {
  interface_configuration_type type;
  std::vector<std::string> names;
};

class ControllerInterface {
 public:
  virtual ~ControllerInterface() = default;
  virtual InterfaceConfiguration command_interface_configuration() const = 0;
  virtual InterfaceConfiguration state_interface_configuration() const = 0;
  virtual CallbackReturn on_init() = 0;
  virtual return_type update(const rclcpp::Time& time, const rclcpp::Duration& period) = 0;
  virtual CallbackReturn on_configure(const rclcpp_lifecycle::State&) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_activate(const rclcpp_lifecycle::State&) { return CallbackReturn::SUCCESS; }

  void assign_interfaces(std::vector<hardware_interface::LoanedCommandInterface>&& command_interfaces,
                         std::vector<hardware_interface::LoanedStateInterface>&& state_interfaces) {
    command_interfaces_ = std::move(command_interfaces);
    state_interfaces_ = std::move(state_interfaces);
  }
  unsigned int get_update_rate() const { return 1000; }
  const std::string& get_robot_description() const { return description_; }
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> get_node() const { return node_; }
  template <typename T>
  void auto_declare(const std::string& name, const T& default_value) {
    node_->parameters.emplace(name, rclcpp::Parameter(default_value));  // a value from the launch file stays
  }

 protected:
  std::vector<hardware_interface::LoanedCommandInterface> command_interfaces_;
  std::vector<hardware_interface::LoanedStateInterface> state_interfaces_;

 private:
  std::string description_ = "<robot/>";
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> node_ = std::make_shared<rclcpp_lifecycle::LifecycleNode>();
};

}  // namespace controller_interface
