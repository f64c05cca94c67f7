#pragma once
/// What differs between the versions of ros2_control: Humble (2.x), Jazzy (4.x) and newer. Found out from the types.
#include <cmath>
#include <string>
#include <type_traits>
#include <utility>

namespace hosts {

namespace detail {

template <typename T, typename = void>
struct HasGetOptional : std::false_type {};
template <typename T>
struct HasGetOptional<T, std::void_t<decltype(std::declval<const T&>().get_optional())>> : std::true_type {};
template <typename T, typename = void>
struct HasRobotDescription : std::false_type {};
template <typename T>
struct HasRobotDescription<T, std::void_t<decltype(std::declval<const T&>().get_robot_description())>>
    : std::true_type {};

}  // namespace detail

/// The value of a state interface; NaN if it cannot be read now.
template <typename StateInterface>
double read(const StateInterface& interface) {
  if constexpr (detail::HasGetOptional<StateInterface>::value)  // from 4.27 on
    return interface.get_optional().value_or(std::nan(""));
  else
    return interface.get_value();
}

/// Sets a command interface.
/// @return whether it was set
template <typename CommandInterface>
bool write(CommandInterface& interface, double value) {
  if constexpr (std::is_void_v<decltype(interface.set_value(value))>) {  // Humble
    interface.set_value(value);
    return true;
  } else {
    return interface.set_value(value);
  }
}

/// To call in on_init(): Humble does not give controllers the robot's description, so that it is a parameter there.
template <typename Controller>
void declare_robot_description(Controller& controller) {
  if constexpr (!detail::HasRobotDescription<Controller>::value)
    controller.template auto_declare<std::string>("robot_description", "");
}
/// The robot's URDF, from on_configure() on.
template <typename Controller>
std::string robot_description(Controller& controller) {
  if constexpr (detail::HasRobotDescription<Controller>::value)
    return controller.get_robot_description();
  else
    return controller.get_node()->get_parameter("robot_description").as_string();
}

}  // namespace hosts
