#pragma once
// As much of ros2_control as the hosts use, by its names and signatures. What is pure virtual there is so here, and
// what cannot be copied, overridden or ignored there cannot be here. With RME_STAND_IN_HUMBLE, as in ROS 2 Humble.
#include <cstdint>
#include <map>
#include <memory>
#include <optional>
#include <rclcpp/rclcpp.hpp>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace hardware_interface {

/// A number under a name; while another thread has it locked, it can neither be read nor written.
struct Handle {
  using SharedPtr = std::shared_ptr<Handle>;
  std::string name;
  double value = 0;
  bool locked = false;
};

class LoanedStateInterface {
 public:
  explicit LoanedStateInterface(std::shared_ptr<const Handle> handle) : handle_(std::move(handle)) {}
  LoanedStateInterface(const LoanedStateInterface&) = delete;
  LoanedStateInterface(LoanedStateInterface&&) = default;
  virtual ~LoanedStateInterface() = default;
  const std::string& get_name() const { return handle_->name; }
#ifdef RME_STAND_IN_HUMBLE
  double get_value() const {
    return handle_->value;
  }
#else
  template <typename T = double>
  [[nodiscard]] std::optional<T> get_optional(unsigned int /*max_tries*/ = 10) const {
    return handle_->locked ? std::nullopt : std::optional<T>(handle_->value);
  }
#endif

 private:
  std::shared_ptr<const Handle> handle_;
};

class LoanedCommandInterface {
 public:
  explicit LoanedCommandInterface(Handle::SharedPtr handle) : handle_(std::move(handle)) {}
  LoanedCommandInterface(const LoanedCommandInterface&) = delete;
  LoanedCommandInterface(LoanedCommandInterface&&) = default;
  virtual ~LoanedCommandInterface() = default;
  const std::string& get_name() const { return handle_->name; }
#ifdef RME_STAND_IN_HUMBLE
  void set_value(double value) {
    handle_->value = value;
  }
#else
  template <typename T>
  [[nodiscard]] bool set_value(const T& value, unsigned int /*max_tries*/ = 10) {
    if (handle_->locked) return false;
    handle_->value = value;
    return true;
  }
#endif

 private:
  Handle::SharedPtr handle_;
};

struct CommandInterface {
  using SharedPtr = std::shared_ptr<CommandInterface>;
};
struct StateInterface {
  using ConstSharedPtr = std::shared_ptr<const StateInterface>;
};

}  // namespace hardware_interface

namespace controller_interface {

using CallbackReturn = rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface::CallbackReturn;
enum class return_type : std::uint8_t { OK = 0, ERROR = 1 };
enum class interface_configuration_type : std::uint8_t { ALL = 0, INDIVIDUAL = 1, NONE = 2 };
struct InterfaceConfiguration {
  interface_configuration_type type = interface_configuration_type::NONE;
  std::vector<std::string> names = {};
};

struct ControllerInterfaceParams {
  std::string controller_name = "";
  std::string robot_description = "";
  unsigned int update_rate = 0;
};

class ControllerInterfaceBase : public rclcpp_lifecycle::node_interfaces::LifecycleNodeInterface {
 public:
  virtual InterfaceConfiguration command_interface_configuration() const = 0;
  virtual InterfaceConfiguration state_interface_configuration() const = 0;
  virtual void assign_interfaces(std::vector<hardware_interface::LoanedCommandInterface>&& command_interfaces,
                                 std::vector<hardware_interface::LoanedStateInterface>&& state_interfaces) {
    command_interfaces_ = std::move(command_interfaces);
    state_interfaces_ = std::move(state_interfaces);
  }
  virtual void release_interfaces() {
    command_interfaces_.clear();
    state_interfaces_.clear();
  }
  return_type init(const ControllerInterfaceParams& params) {
    params_ = params;
    return on_init() == CallbackReturn::SUCCESS ? return_type::OK : return_type::ERROR;
  }
  virtual CallbackReturn on_init() = 0;
  virtual return_type update(const rclcpp::Time& time, const rclcpp::Duration& period) = 0;

  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> get_node() { return node_; }
  std::shared_ptr<const rclcpp_lifecycle::LifecycleNode> get_node() const { return node_; }
  unsigned int get_update_rate() const { return params_.update_rate; }
#ifndef RME_STAND_IN_HUMBLE
  const std::string& get_robot_description() const {
    return params_.robot_description;
  }
#endif
  template <typename ParameterT>
  auto auto_declare(const std::string& name, const ParameterT& default_value) {
    if (!get_node()->has_parameter(name)) return get_node()->declare_parameter<ParameterT>(name, default_value);
    return get_node()->get_parameter(name).get_value<ParameterT>();
  }

  virtual bool is_chainable() const = 0;
  virtual std::vector<hardware_interface::CommandInterface::SharedPtr> export_reference_interfaces() = 0;
  virtual std::vector<hardware_interface::StateInterface::ConstSharedPtr> export_state_interfaces() = 0;
  virtual bool set_chained_mode(bool chained_mode) = 0;
  virtual bool is_in_chained_mode() const = 0;

 protected:
  std::vector<hardware_interface::LoanedCommandInterface> command_interfaces_;
  std::vector<hardware_interface::LoanedStateInterface> state_interfaces_;

 private:
  ControllerInterfaceParams params_;
  std::shared_ptr<rclcpp_lifecycle::LifecycleNode> node_ = std::make_shared<rclcpp_lifecycle::LifecycleNode>();
};

class ControllerInterface : public ControllerInterfaceBase {
 public:
  bool is_chainable() const final { return false; }
  std::vector<hardware_interface::StateInterface::ConstSharedPtr> export_state_interfaces() final { return {}; }
  std::vector<hardware_interface::CommandInterface::SharedPtr> export_reference_interfaces() final { return {}; }
  bool set_chained_mode(bool) final { return false; }
  bool is_in_chained_mode() const final { return false; }
};

}  // namespace controller_interface
