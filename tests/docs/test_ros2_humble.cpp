// The ros2_control host with what ROS 2 Humble has: no get_optional(), no get_robot_description(), a set_value() that
// returns nothing.
#include <vector>

#include "docs/ros2_hardware.hpp"
#include "host/franka_arm.hpp"
#include "hosts/ros2_control/joint_hold.hpp"

namespace {

using rme::testing::Hardware;

TEST_CASE("hosts: in Humble, the joint hold takes the robot's description as a parameter, and holds a kilogram",
          "[docs]") {
  hosts::JointHold7 controller;
  Hardware hardware(controller);
  const auto node = controller.get_node();
  node->override_parameter("robot_description", std::string("<robot/> with panda_finger_joint1, panda_finger_joint2"));
  node->override_parameter("stiffness", std::vector<double>{600, 600, 600, 600, 100, 100, 50});
  node->override_parameter("damping", std::vector<double>{40, 40, 40, 40, 4, 4, 1});
  hardware.activate();
  const auto pose = hardware.arm.q();
  REQUIRE(hardware.run(1000) == 1000);
  hardware.arm.attach(rme::testing::unknown_kilogram());
  REQUIRE(hardware.run(3000) == 3000);
  CHECK((hardware.arm.q() - pose).norm() < 2e-3);
  hardware.torque_is_lost = true;
  CHECK(hardware.run(5) == 4);
}

TEST_CASE("hosts: in Humble, a missing description and a missing update rate are said", "[docs]") {
  hosts::JointHold7 controller;
  const Hardware hardware(controller);
  REQUIRE(controller.init({"payload", "", 1000}) == controller_interface::return_type::OK);
  CHECK(controller.on_configure({}) == controller_interface::CallbackReturn::ERROR);
  CHECK_THAT(*controller.get_node()->get_logger().last, contains("URDF"));

  hosts::JointHold7 idle;
  const Hardware other(idle);
  REQUIRE(idle.init({"payload", "", 0}) == controller_interface::return_type::OK);
  CHECK(idle.on_configure({}) == controller_interface::CallbackReturn::ERROR);
  CHECK_THAT(*idle.get_node()->get_logger().last, contains("update_rate: 0; in Humble, set"));
}

}  // namespace
