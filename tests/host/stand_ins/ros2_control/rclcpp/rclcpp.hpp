#pragma once
// As much of rclcpp and rclcpp_lifecycle as the hosts use, by its names and signatures.
#include <chrono>
#include <cstdarg>
#include <cstdint>
#include <cstdio>
#include <functional>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <utility>
#include <variant>
#include <vector>

// The format is checked, and nothing is printed; the last line is kept for tests.
#define RME_STAND_IN_LOG(logger, ...) (logger).keep(__VA_ARGS__)
#define RCLCPP_INFO(logger, ...) RME_STAND_IN_LOG(logger, __VA_ARGS__)
#define RCLCPP_WARN(logger, ...) RME_STAND_IN_LOG(logger, __VA_ARGS__)
#define RCLCPP_ERROR(logger, ...) RME_STAND_IN_LOG(logger, __VA_ARGS__)

namespace rclcpp {

class Time {
 public:
  explicit Time(std::int64_t nanoseconds = 0) : nanoseconds_(nanoseconds) {}
  std::int64_t nanoseconds() const { return nanoseconds_; }

 private:
  std::int64_t nanoseconds_;
};

class Duration {  // no default constructor, there as here
 public:
  explicit Duration(std::chrono::nanoseconds duration) : duration_(duration) {}
  static Duration from_seconds(double seconds) {
    return Duration(std::chrono::nanoseconds(static_cast<std::int64_t>(seconds * 1e9)));
  }
  double seconds() const { return std::chrono::duration<double>(duration_).count(); }

 private:
  std::chrono::nanoseconds duration_;
};

class Logger {
 public:
  [[gnu::format(printf, 2, 3)]] void keep(const char* format, ...) const {
    char text[400];
    va_list arguments;
    va_start(arguments, format);
    (void)std::vsnprintf(text, sizeof text, format, arguments);
    va_end(arguments);
    *last = text;
  }
  std::shared_ptr<std::string> last = std::make_shared<std::string>();
};

struct ParameterTypeException : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct InvalidParameterTypeException : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct ParameterAlreadyDeclaredException : std::runtime_error {
  using std::runtime_error::runtime_error;
};
struct ParameterNotDeclaredException : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// What it is not cannot be had of it.
class Parameter {
 public:
  using Value = std::variant<std::monostate, bool, std::int64_t, double, std::string, std::vector<double>,
                             std::vector<std::string>>;
  Parameter() = default;
  Parameter(std::string name, Value value) : name_(std::move(name)), value_(std::move(value)) {}
  bool as_bool() const { return as<bool>(); }
  std::int64_t as_int() const { return as<std::int64_t>(); }
  double as_double() const { return as<double>(); }
  const std::string& as_string() const { return as<std::string>(); }
  const std::vector<double>& as_double_array() const { return as<std::vector<double>>(); }
  const std::vector<std::string>& as_string_array() const { return as<std::vector<std::string>>(); }
  const Value& value() const { return value_; }  // not rclcpp's
  template <typename T>
  T get_value() const {
    return as<T>();
  }

 private:
  template <typename T>
  const T& as() const {
    if (!std::holds_alternative<T>(value_)) throw InvalidParameterTypeException(name_);
    return std::get<T>(value_);
  }

  std::string name_;
  Value value_;
};

/// A callback that somebody else calls.
class TimerBase {
 public:
  using SharedPtr = std::shared_ptr<TimerBase>;
  explicit TimerBase(std::function<void()> callback) : callback_(std::move(callback)) {}
  virtual ~TimerBase() = default;
  void execute_callback() { callback_(); }

 private:
  std::function<void()> callback_;
};

}  // namespace rclcpp

namespace rclcpp_lifecycle {

class State {
 public:
  State() = default;
};

class LifecycleNode {
 public:
  rclcpp::Logger get_logger() const { return logger_; }
  bool has_parameter(const std::string& name) const { return declared_.count(name) > 0; }
  rclcpp::Parameter get_parameter(const std::string& name) const {
    const auto found = declared_.find(name);
    if (found == declared_.end()) throw rclcpp::ParameterNotDeclaredException(name);
    return found->second;
  }
  /// A value from the launch file comes before the default, and must be of its type.
  template <typename T>
  T declare_parameter(const std::string& name, const T& default_value) {
    if (has_parameter(name)) throw rclcpp::ParameterAlreadyDeclaredException(name);
    const rclcpp::Parameter by_default(name, rclcpp::Parameter::Value(default_value));
    const auto given = overrides.find(name);
    if (given != overrides.end() && given->second.value().index() != by_default.value().index())
      throw rclcpp::InvalidParameterTypeException(name);
    declared_[name] = given == overrides.end() ? by_default : given->second;
    return declared_[name].get_value<T>();
  }
  template <typename Period, typename Callback>
  rclcpp::TimerBase::SharedPtr create_wall_timer(std::chrono::duration<std::int64_t, Period>, Callback callback) {
    timers.push_back(std::make_shared<rclcpp::TimerBase>(std::move(callback)));
    return timers.back();
  }

  // Not rclcpp's: the launch file, and the executor.
  template <typename T>
  void override_parameter(const std::string& name, const T& value) {
    overrides[name] = rclcpp::Parameter(name, rclcpp::Parameter::Value(value));
  }
  std::map<std::string, rclcpp::Parameter> overrides;
  std::vector<rclcpp::TimerBase::SharedPtr> timers;

 private:
  rclcpp::Logger logger_;
  std::map<std::string, rclcpp::Parameter> declared_;
};

namespace node_interfaces {

class LifecycleNodeInterface {
 public:
  enum class CallbackReturn : std::uint8_t { SUCCESS = 97, FAILURE = 98, ERROR = 99 };
  virtual ~LifecycleNodeInterface() = default;
  virtual CallbackReturn on_configure(const State&) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_cleanup(const State&) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_shutdown(const State&) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_activate(const State&) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_deactivate(const State&) { return CallbackReturn::SUCCESS; }
  virtual CallbackReturn on_error(const State&) { return CallbackReturn::FAILURE; }
};

}  // namespace node_interfaces
}  // namespace rclcpp_lifecycle
