// examples/hosts/kinova, against stand-ins.
#include "hosts/kinova/kortex_payload.hpp"

#include <cmath>
#include <limits>
#include <pinocchio/parsers/urdf.hpp>
#include <string>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "host/franka_arm.hpp"
#include "support/catch.hpp"

namespace {

using rme::testing::torque_that_holds;
using rme::testing::unknown_kilogram;
using Vector = rme::JointVector<double, 7>;
namespace api = Kinova::Api::BaseCyclic;

constexpr double kPeriod = 1e-3, kDegree = 3.141592653589793 / 180;

/// An arm with continuous joints: in degrees from 0 to 360, with torque sensors that show the opposite of the command.
struct Gen3 {
  Gen3() {
    for (int j = 0; j < 7; ++j) {
      feedback.add_actuators();
      command.add_actuators();
    }
  }
  void report() {
    for (int j = 0; j < 7; ++j) {
      const double degrees = std::fmod(arm.q()[j] / kDegree, 360);
      feedback.mutable_actuators(j)->set_position(static_cast<float>(degrees < 0 ? degrees + 360 : degrees));
      feedback.mutable_actuators(j)->set_velocity(static_cast<float>(arm.dq()[j] / kDegree));
      feedback.mutable_actuators(j)->set_torque(static_cast<float>(-arm.tau_measured()[j]));
    }
  }
  void step() {
    Vector torque;
    for (int j = 0; j < 7; ++j) torque[j] = static_cast<double>(command.actuators(j).torque_joint());
    arm.step(torque);
  }
  api::Feedback feedback;
  api::Command command;
  rme::examples::SyntheticArm<7> arm{rme::examples::panda(), {}, rme::examples::panda().ready};
};

hosts::KortexPayload<7> kortex_payload(const rme::EstimatorConfig<double, 7>& estimator) {
  std::string urdf = "<robot/> with ";
  std::vector<std::string> joints;
  for (int j = 1; j <= 7; ++j) {
    joints.push_back("joint_" + std::to_string(j));
    urdf += "\"" + joints.back() + "\" type=\"" + (j % 2 == 1 ? "continuous" : "revolute") + "\" ";
  }
  pinocchio::Model robot;
  pinocchio::urdf::buildModelFromXML(urdf, robot);
  REQUIRE(robot.nq == 11);
  rme::PayloadCompensationConfig<double, 7> config;
  config.estimator = estimator;
  return {robot, joints, "end_effector_link", kPeriod, config};
}

/// Holds a pose, and a kilogram from the first second on.
/// @return by how much the compensation differs from the torque that holds it, as a share
double hold(hosts::KortexPayload<7>& payload, Gen3& gen3) {
  const Vector pose = gen3.arm.q();
  const Vector stiffness = (Vector() << 600, 600, 600, 600, 100, 100, 50).finished();
  for (int k = 0; k < 4000; ++k) {
    if (k == 1000) gen3.arm.attach(unknown_kilogram());
    gen3.report();
    REQUIRE(payload.update(gen3.feedback, kPeriod) == rme::Status::Ok);
    const Vector nominal =
        stiffness.cwiseProduct(pose - gen3.arm.q()) - 0.07 * stiffness.cwiseProduct(gen3.arm.dq()) + payload.gravity();
    payload.command(nominal, gen3.feedback, gen3.command);
    gen3.step();
  }
  const Vector wanted = torque_that_holds(unknown_kilogram(), gen3.arm.kinematics());
  return (payload.compensation().torque() - wanted).norm() / wanted.norm();
}

TEST_CASE("hosts: Kinova's feedback holds an unknown kilogram within 2 percent, with continuous joints", "[docs]") {
  auto payload = kortex_payload(hosts::kortex_config<7>());
  Gen3 gen3;
  CHECK(hold(payload, gen3) < 0.02);
  // What the robot needs besides the torque: its own position, and a number that says how new the command is.
  CHECK(gen3.command.actuators(3).position() == gen3.feedback.actuators(3).position());
  CHECK(gen3.command.frame_id() == 4000);
  CHECK(gen3.command.actuators(6).command_id() == 4000);
}

TEST_CASE("hosts: Kinova's torque taken with the wrong sign carries nothing", "[docs]") {
  auto config = hosts::kortex_config<7>();
  config.torque_sign = rme::TorqueSign::External;
  auto payload = kortex_payload(config);
  Gen3 gen3;
  CHECK(hold(payload, gen3) > 0.9);
}

TEST_CASE("hosts: Kinova's command identifier starts again after 65535", "[docs]") {
  auto payload = kortex_payload(hosts::kortex_config<7>());
  Gen3 gen3;
  gen3.command.set_frame_id(65535);
  payload.command(Vector::Zero(), gen3.feedback, gen3.command);
  CHECK(gen3.command.frame_id() == 0);
}

TEST_CASE("hosts: Kinova's feedback with NaN, or of too few joints, changes nothing", "[docs]") {
  auto payload = kortex_payload(hosts::kortex_config<7>());
  Gen3 gen3;
  (void)hold(payload, gen3);
  const Vector before = payload.compensation().torque();
  gen3.feedback.mutable_actuators(2)->set_torque(std::numeric_limits<float>::quiet_NaN());
  CHECK(payload.update(gen3.feedback, kPeriod) == rme::Status::NonFiniteInput);
  CHECK(payload.update(api::Feedback(), kPeriod) == rme::Status::NotReady);
  CHECK((payload.compensation().torque() == before));
}

}  // namespace
