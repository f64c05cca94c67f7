// The plugins that payload_controllers.xml describes.
#include "hosts/ros2_control/joint_hold.hpp"

#include <pluginlib/class_list_macros.hpp>

PLUGINLIB_EXPORT_CLASS(hosts::JointHold6, controller_interface::ControllerInterface)
PLUGINLIB_EXPORT_CLASS(hosts::JointHold7, controller_interface::ControllerInterface)
