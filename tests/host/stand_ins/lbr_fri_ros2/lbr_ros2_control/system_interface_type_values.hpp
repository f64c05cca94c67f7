#pragma once
// As much of lbr_fri_ros2_stack as its host uses: the names of its own state interfaces.
namespace lbr_ros2_control {

constexpr char HW_IF_EXTERNAL_TORQUE[] = "external_torque";

}  // namespace lbr_ros2_control
