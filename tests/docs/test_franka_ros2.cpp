// examples/hosts/franka_ros2, against a stand-in.
#include "hosts/franka_ros2/franka_payload.hpp"

#include <cstring>
#include <memory>
#include <vector>

#include "host/franka_arm.hpp"
#include "support/catch.hpp"

namespace {

using rme::testing::FrankaArm;
using rme::testing::torque_that_holds;
using rme::testing::unknown_kilogram;
using Vector = rme::testing::Vector7;

TEST_CASE("hosts: franka_ros2's state and model interfaces hold an unknown kilogram within 2 percent", "[docs]") {
  rme::PayloadCompensationConfig<double, 7> config;
  config.estimator = rme::franka_config();
  hosts::FrankaPayload payload("fr3", 0.001, config);
  CHECK(payload.state_interfaces() == std::vector<std::string>{"fr3/robot_model", "fr3/robot_state"});
  std::vector<hardware_interface::LoanedStateInterface> interfaces;
  auto handle = std::make_shared<hardware_interface::Handle>(hardware_interface::Handle{"fr3/robot_state"});
  interfaces.emplace_back(std::make_shared<hardware_interface::Handle>(hardware_interface::Handle{"fr3/robot_model"}));
  interfaces.emplace_back(handle);
  CHECK(payload.update(0, 0.001) == rme::Status::NotReady);  // no state yet
  payload.activate(interfaces);
  FrankaArm franka;
  const Vector stiffness = (Vector() << 600, 600, 600, 600, 100, 100, 50).finished();
  for (int k = 0; k < 4000; ++k) {
    if (k == 1000) franka.arm.attach(unknown_kilogram());
    const franka::RobotState state = franka.read();
    const franka::RobotState* pointer = &state;
    std::memcpy(&handle->value, &pointer, sizeof pointer);
    REQUIRE(payload.update(handle->value, 0.001) == rme::Status::Ok);
    franka::Torques torques(std::array<double, 7>{});
    Eigen::Map<Vector>(torques.tau_J.data()) = stiffness.cwiseProduct(franka.pose - franka.arm.q()) -
                                               0.07 * stiffness.cwiseProduct(franka.arm.dq()) +
                                               payload.compensation().torque();
    franka.command(torques);
  }
  const Vector wanted = torque_that_holds(unknown_kilogram(), franka.arm.kinematics());
  CHECK((payload.compensation().torque() - wanted).norm() < 0.02 * wanted.norm());
  payload.deactivate();
  CHECK_THROWS_WITH(payload.update(handle->value, 0.001), contains("does not exist"));
}

}  // namespace
