// rme/host/franka.hpp, against a stand-in for libfranka.
#include <rme/host/franka.hpp>

#include <array>
#include <cmath>
#include <rme/host/payload_changes.hpp>
#include <string>

#include "host/franka_arm.hpp"
#include "support/catch.hpp"

namespace {

using namespace rme;
using rme::examples::box;
using rme::examples::panda;
using rme::examples::RigidBody;
using rme::testing::torque_that_holds;
using rme::testing::unknown_kilogram;
using Vector = JointVector<double, 7>;
using Compensation = PayloadCompensation<double, 7>;

constexpr double kPeriod = 1e-3;  // [s]

/// A host's own controller: follows a joint trajectory, gravity left to others.
Vector impedance(const Vector& q, const Vector& dq, const Vector& q_d, const Vector& dq_d) {
  const Vector stiffness = (Vector() << 600, 600, 600, 600, 100, 100, 50).finished();
  const Vector damping = (Vector() << 40, 40, 40, 40, 4, 4, 1).finished();
  return stiffness.cwiseProduct(q_d - q) + damping.cwiseProduct(dq_d - dq);
}

/// Runs the host's control loop for a while, around a controller that holds the pose, or swings about it once a second.
struct FrankaHost : rme::testing::FrankaArm {
  Status control(franka::Robot& robot, Compensation& payload, int duration) {
    const int begin = ticks;
    Vector last = Vector::Zero();
    return franka_control(robot, robot.loadModel(), payload, [&](const franka::RobotState& state, franka::Duration) {
      franka::Torques torques = state.q;  // any: it is overwritten
      const double w = 6.283185307, phase = w * kPeriod * (ticks - begin);
      const Vector wanted = impedance(
          Eigen::Map<const Vector>(state.q.data()), Eigen::Map<const Vector>(state.dq.data()),
          pose + Vector::Constant(swing * (1 - std::cos(phase))), Vector::Constant(w * swing * std::sin(phase)));
      last += (wanted - last).cwiseMax(-0.5).cwiseMin(0.5);  // half of the robot's torque rate
      Eigen::Map<Vector>(torques.tau_J.data()) = last;
      return ticks + 1 < begin + duration ? torques : franka::MotionFinished(torques);
    });
  }
  double swing = 0;  // [rad]
};

TEST_CASE("franka_sample: the gravity torque along each axis is by how much g(q) changes with gravity along it",
          "[host]") {
  // Finite differences of gravity's direction and size, of the arm with the load that it was told of.
  FrankaHost franka;
  franka::Robot robot(franka.simulation());
  const franka::Model model = robot.loadModel();
  franka.load = unknown_kilogram();
  const Proprioception<double, 7> sample = franka_sample(model, franka.read(), franka::Duration(1));
  REQUIRE(sample.gravity_torque.has_value());
  constexpr double kStep = 3;  // [m/s^2]; g is linear in gravity
  for (int axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    Vector difference = Vector::Zero();
    for (const int side : {1, -1}) {
      examples::ArmModel<7> arm = panda();
      arm.gravity_vector[axis] += side * kStep;
      difference += side * arm.dynamics(franka.arm.q(), Vector::Zero(), franka.load).gravity / (2 * kStep);
    }
    CHECK(difference.norm() > 0.1);
    CHECK((sample.gravity_torque->col(axis) - difference).norm() < 1e-12);
  }
  // What franka_ros2 gives has no gravity torque along an axis.
  const auto jacobian = model.zeroJacobian(franka::Frame::kEndEffector, franka.read());
  CHECK_FALSE(franka_sample(jacobian, franka.read(), 0.001).gravity_torque.has_value());
}

TEST_CASE("franka_control: holds an unknown kilogram within 2 percent", "[host]") {
  FrankaHost franka;
  franka::Robot robot(franka.simulation());
  Compensation payload(kPeriod, franka_config());
  (void)franka.control(robot, payload, 1000);
  CHECK(payload.torque().norm() < 1e-3);
  franka.arm.attach(unknown_kilogram());
  (void)franka.control(robot, payload, 3000);

  const Vector wanted = torque_that_holds(unknown_kilogram(), franka.arm.kinematics());
  CAPTURE(payload.torque().transpose(), wanted.transpose());
  CHECK((payload.torque() - wanted).norm() < 0.02 * wanted.norm());
  CHECK((franka.arm.q() - franka.pose).norm() < 2e-3);
  // The centre of mass in the end effector's axes, but for the part along gravity.
  const Payload<double> believed = payload.state().payload.payload();
  const Eigen::Vector3d error = believed.com - franka.F_T_EE.inverse() * unknown_kilogram().com;
  const Eigen::Matrix3d R = franka.arm.kinematics().rotation * franka.F_T_EE.linear();
  CHECK((R * error).head<2>().norm() < 2e-3);
}

TEST_CASE("franka_control: ends its loop on a bad sample with the last command, and says which it was", "[host]") {
  FrankaHost franka;
  franka::Robot robot(franka.simulation());
  Compensation payload(kPeriod, franka_config());
  (void)franka.control(robot, payload, 1000);
  franka.arm.attach(unknown_kilogram());
  (void)franka.control(robot, payload, 2000);
  const Vector held = payload.torque();
  REQUIRE(held.norm() > 1);
  franka.spoilt_tick = franka.ticks + 200;
  CHECK(franka.control(robot, payload, 1000) == Status::NonFiniteInput);
  CHECK(franka.ticks == franka.spoilt_tick + 1);
  CHECK((payload.torque() - held).norm() < 0.01);
  CHECK((franka.commanded - held).norm() < 1);  // the last command, which was all right
  CHECK(franka.control(robot, payload, 1000) == Status::Ok);
}

TEST_CASE("franka_control: holds an unknown kilogram although packets get lost", "[host]") {
  FrankaHost franka;
  franka.loses_every = 7;
  franka::Robot robot(franka.simulation());
  Compensation payload(kPeriod, franka_config());
  (void)franka.control(robot, payload, 1000);
  franka.arm.attach(unknown_kilogram());
  (void)franka.control(robot, payload, 3000);
  const Vector wanted = torque_that_holds(unknown_kilogram(), franka.arm.kinematics());
  CAPTURE(payload.torque().transpose(), wanted.transpose());
  CHECK((payload.torque() - wanted).norm() < 0.02 * wanted.norm());
  // Packets that were lost are time that passed.
  CHECK(std::abs(payload.state().time - franka.arm.time()) < 0.01);
}

/// Carries the payload about, so that its centre of mass shows, and comes to rest.
void carry_about(FrankaHost& franka, franka::Robot& robot, Compensation& payload) {
  franka.swing = 0.2;
  REQUIRE(franka.control(robot, payload, 4000) == Status::Ok);
  franka.swing = 0;
  REQUIRE(franka.control(robot, payload, 1000) == Status::Ok);
}

/// Is handed the kilogram after a second, and carries it about.
int pick_up(FrankaHost& franka, franka::Robot& robot, Compensation& payload) {
  REQUIRE(franka.control(robot, payload, 1000) == Status::Ok);
  const int handle = franka.arm.attach(unknown_kilogram());
  REQUIRE(franka.control(robot, payload, 1000) == Status::Ok);
  carry_about(franka, robot, payload);
  return handle;
}

TEST_CASE("franka_hand_over: refuses, with the reason, until mass and centre of mass are certain", "[host]") {
  FrankaHost franka;
  franka::Robot robot(franka.simulation());
  PayloadCompensationConfig<double, 7> config;
  config.estimator = franka_config();
  config.hand_over_error = 0.05;  // [N m]; what this arm, which has no noise, shows of a payload at rest is worse
  Compensation payload(kPeriod, config);
  CHECK(franka_hand_over(robot, payload).judged.verdict == HandOverVerdict::NotMeasured);
  REQUIRE(franka.control(robot, payload, 1000) == Status::Ok);
  CHECK(franka_hand_over(robot, payload).judged.verdict == HandOverVerdict::Empty);
  franka.arm.attach(unknown_kilogram());
  REQUIRE(franka.control(robot, payload, 60) == Status::Ok);
  CHECK_FALSE(franka_hand_over(robot, payload).judged.ready());  // it is still coming
  REQUIRE(franka.control(robot, payload, 1940) == Status::Ok);
  const FrankaHandOver at_rest = franka_hand_over(robot, payload);
  CHECK(at_rest.judged.verdict == HandOverVerdict::Uncertain);
  CHECK(at_rest.judged.torque_error > 0.05);
  CHECK_FALSE(at_rest.done);
  CHECK(franka.loads_set == 0);
  CHECK(payload.torque().norm() > 1);  // rme goes on
}

TEST_CASE("franka_hand_over: the load is the payload in flange axes, and rme then adds nothing", "[host]") {
  FrankaHost franka;
  franka::Robot robot(franka.simulation());
  Compensation payload(kPeriod, franka_config());
  (void)pick_up(franka, robot, payload);
  const FrankaHandOver result = franka_hand_over(robot, payload);
  CAPTURE(to_string(result.judged.verdict), result.judged.torque_error);
  REQUIRE(result.done);
  CHECK(franka.loads_set == 1);
  CHECK(std::abs(result.taken.mass - 1) < 0.01);
  CHECK(result.taken.mass == result.asked.mass);
  // In every pose, the robot holds it as well as was promised.
  for (double angle = 0; angle < 6; angle += 0.37) {
    const auto at = panda().kinematics(franka.pose + Vector::Constant(angle));
    const Vector error = torque_that_holds(franka.load, at) - torque_that_holds(unknown_kilogram(), at);
    CHECK(error.cwiseAbs().maxCoeff() < result.judged.torque_error);
  }
  REQUIRE(franka.control(robot, payload, 1) == Status::Ok);
  CHECK(payload.torque().isZero(0.05));
  REQUIRE(franka.control(robot, payload, 2000) == Status::Ok);
  CHECK(payload.state().empty());
  CHECK(payload.torque().norm() < 0.05);
  CHECK_FALSE(payload.load_lost());
  CHECK((franka.arm.q() - franka.pose).norm() < 2e-3);
}

TEST_CASE("franka_hand_over: a load that the robot has already is handed over together with the payload", "[host]") {
  FrankaHost franka;
  franka::Robot robot(franka.simulation());
  Compensation payload(kPeriod, franka_config());
  const RigidBody tool = box(0.7, {-0.02, 0.05, 0.03}, {0.05, 0.1, 0.05});
  franka.arm.attach(tool);
  FrankaLoad before;
  before.mass = tool.mass;
  Eigen::Map<Eigen::Vector3d>(before.com.data()) = tool.com;
  Eigen::Map<Eigen::Matrix3d>(before.inertia.data()) = tool.inertia;
  franka_clear_load(robot, payload, before);
  REQUIRE(franka.control(robot, payload, 1000) == Status::Ok);
  CHECK(payload.state().empty());
  franka.arm.attach(unknown_kilogram());
  REQUIRE(franka.control(robot, payload, 1000) == Status::Ok);
  carry_about(franka, robot, payload);
  REQUIRE(franka_hand_over(robot, payload).done);
  const Vector wanted = torque_that_holds(unknown_kilogram() + tool, franka.arm.kinematics());
  CHECK((torque_that_holds(franka.load, franka.arm.kinematics()) - wanted).norm() < 0.02 * wanted.norm());
  CHECK(std::abs(franka.load.mass - 1.7) < 0.02);
  REQUIRE(franka.control(robot, payload, 1000) == Status::Ok);
  CHECK(payload.torque().norm() < 0.05);
}

TEST_CASE("franka_hand_over: what counts is what the robot took", "[host]") {
  FrankaHost franka;
  franka::Robot robot(franka.simulation());
  Compensation payload(kPeriod, franka_config());
  const int handle = pick_up(franka, robot, payload);
  franka.takes = 0;  // says yes, and takes nothing
  const FrankaHandOver nothing = franka_hand_over(robot, payload);
  CHECK(nothing.judged.ready());
  CHECK_FALSE(nothing.done);
  CHECK(nothing.taken.mass == 0);
  REQUIRE(franka.control(robot, payload, 500) == Status::Ok);
  const Vector wanted = torque_that_holds(unknown_kilogram(), franka.arm.kinematics());
  CHECK((payload.torque() - wanted).norm() < 0.02 * wanted.norm());

  franka.takes = 0.8;
  const FrankaHandOver most = franka_hand_over(robot, payload);
  CHECK(most.done);
  CHECK(most.taken.mass == Approx(0.8 * most.asked.mass));
  REQUIRE(franka.control(robot, payload, 2000) == Status::Ok);  // rme carries the rest
  const Vector rest = torque_that_holds(unknown_kilogram(), franka.arm.kinematics()) -
                      torque_that_holds(franka.load, franka.arm.kinematics());
  CHECK((payload.torque() - rest).norm() < 0.2 * rest.norm());
  const Vector upwards = torque_that_holds(franka.load, franka.arm.kinematics());
  franka.arm.detach(handle);
  REQUIRE(franka.control(robot, payload, 200) == Status::Ok);
  CHECK((payload.torque() + upwards).norm() < 0.1 * upwards.norm());
}

TEST_CASE("franka_hand_over: the inertia is the payload's, in flange axes, once the arm has moved", "[host]") {
  FrankaHost franka;
  franka.swing = 0.12;
  franka::Robot robot(franka.simulation());
  Compensation payload(kPeriod, franka_config());
  const RigidBody body = box(2, {0.03, -0.02, 0.16}, {0.4, 0.2, 0.1});
  REQUIRE(franka.control(robot, payload, 1000) == Status::Ok);
  franka.arm.attach(body);
  REQUIRE(franka.control(robot, payload, 8000) == Status::Ok);
  REQUIRE(franka_hand_over(robot, payload).done);
  CAPTURE(franka.load.inertia, body.inertia);
  CHECK((franka.load.inertia - body.inertia).norm() < 0.2 * body.inertia.norm());
}

TEST_CASE("A load that was handed over and is dropped moves the arm little, and is then cleared", "[host]") {
  FrankaHost franka;
  franka::Robot robot(franka.simulation());
  Compensation payload(kPeriod, franka_config());
  const int handle = pick_up(franka, robot, payload);
  REQUIRE(franka_hand_over(robot, payload).done);
  REQUIRE(franka.control(robot, payload, 1000) == Status::Ok);
  const Vector upwards = torque_that_holds(franka.load, franka.arm.kinematics());
  franka.arm.detach(handle);
  REQUIRE(franka.control(robot, payload, 200) == Status::Ok);
  CHECK((payload.torque() + upwards).norm() < 0.1 * upwards.norm());
  CHECK_FALSE(payload.load_lost());
  REQUIRE(franka.control(robot, payload, 500) == Status::Ok);
  CHECK(payload.load_lost());
  franka_clear_load(robot, payload);
  CHECK(franka.load.mass == 0);
  REQUIRE(franka.control(robot, payload, 1000) == Status::Ok);
  CHECK_FALSE(payload.load_lost());
  CHECK(payload.torque().norm() < 0.05);
  CHECK(payload.state().empty());
  CHECK((franka.arm.q() - franka.pose).norm() < 2e-3);
}

TEST_CASE("With a wrong sign nothing is carried, and health says that something is wrong", "[host]") {
  FrankaHost franka;
  franka::Robot robot(franka.simulation());
  EstimatorConfig<double, 7> config = franka_config();
  config.torque_sign = TorqueSign::External;
  Compensation payload(kPeriod, config);
  (void)franka.control(robot, payload, 1000);
  franka.arm.attach(unknown_kilogram());
  (void)franka.control(robot, payload, 3000);
  CHECK(payload.state().probability[Mode::Disturbed] > 0.9);
  CHECK(payload.state().health > 10);
  CHECK(payload.state().confidence < 0.05);
  CHECK(payload.torque().norm() < 0.1);
}

TEST_CASE("Events tell a payload that came and one that went, once, and no push", "[host]") {
  FrankaHost franka;
  franka::Robot robot(franka.simulation());
  Compensation payload(kPeriod, franka_config());
  PayloadChanges changes;
  const EstimatorState<double>& state = payload.state();
  (void)franka.control(robot, payload, 1000);
  CHECK_FALSE(changes.since_last(state));
  const int handle = franka.arm.attach(unknown_kilogram());
  (void)franka.control(robot, payload, 1000);
  CHECK(changes.since_last(state));
  CHECK_FALSE(changes.since_last(state));
  CHECK(state.event.kind == EventKind::Attached);
  CHECK(std::abs(state.event.onset - 1) < 0.03);

  franka.arm.push({{0, 10, 0}, Eigen::Vector3d::Zero()});
  (void)franka.control(robot, payload, 500);
  franka.arm.push({});
  (void)franka.control(robot, payload, 1000);
  CHECK(state.event.kind == EventKind::Pushed);
  CHECK_FALSE(changes.since_last(state));

  franka.arm.detach(handle);
  (void)franka.control(robot, payload, 1000);
  CHECK(state.event.kind == EventKind::Removed);
  CHECK(changes.since_last(state));
  CHECK_FALSE(changes.since_last(state));
  payload.reset();
  CHECK(changes.since_last(state));
}

}  // namespace
