// examples/hosts/mit_mode, against a stand-in for Pinocchio.
#include "hosts/mit_mode/mit_arm.hpp"

#include <algorithm>
#include <cmath>
#include <cstdint>
#include <limits>
#include <pinocchio/parsers/urdf.hpp>
#include <string>
#include <synthetic_arm/light_arm.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "support/catch.hpp"

namespace {

using rme::examples::light_arm;
using rme::examples::RigidBody;
using Vector = rme::JointVector<double, 7>;

constexpr double kPeriod = 2e-3;  // of the bus; the motors compute their torque twice as often [s]

/// As a motor's answer has it: a whole number of `bits` bits for what lies between -limit and limit.
double through_bus(double value, double limit, int bits) {
  const double most = std::pow(2, bits) - 1;
  return std::floor((std::min(std::max(value, -limit), limit) + limit) / (2 * limit) * most) / most * 2 * limit - limit;
}

/// The light arm: motors that compute their torque from the last command, and report it as their current shows it.
struct Motors {
  explicit Motors(std::uint64_t seed)
      : faults(rme::examples::with_typical_faults(light_arm(), seed)), arm(light_arm(), faults, light_arm().ready) {
    command.kp = (Vector() << 80, 80, 80, 60, 20, 20, 20).finished();
    command.kd = (Vector() << 3, 3, 2, 2, 0.7, 0.7, 0.2).finished();  // with more, the bare wrist oscillates
    command.q = arm.q();
  }
  /// One period of the bus.
  void step() {
    measured.setZero();
    for (int i = 0; i < 2; ++i) {
      arm.step(command.torque(arm.q(), arm.dq()));
      measured += 0.5 * arm.tau_measured();
    }
  }
  Vector q() const {
    return arm.q().unaryExpr([](double x) { return through_bus(x, 12.5, 16); });
  }
  Vector dq() const {
    return arm.dq().unaryExpr([](double x) { return through_bus(x, 20, 12); });
  }
  Vector torque() const {
    Vector out;
    for (int j = 0; j < 7; ++j) out[j] = through_bus(measured[j], light_arm().tau_max[j], 12);
    return out;
  }

  rme::examples::SyntheticArmConfig<7> faults;  // offset, noise and friction of motors and gears
  rme::examples::SyntheticArm<7> arm;
  hosts::MitCommand<7> command;
  Vector measured = Vector::Zero();
};

/// Where the arm is told to be after t seconds: it swings, and pauses in between.
Vector wanted(double t) {
  const double swing =
      0.5 - 0.5 * std::cos(3.141592653589793 * std::min(std::fmod(t, 3.0), 2.0));  // 2 s, then 1 s rest
  return light_arm().ready + swing * (Vector() << 0.4, 0.3, 0.4, 0.4, 0.3, -0.3, 0.3).finished();
}

/// @param friction  the settings' Coulomb and viscous friction, as a share of what is typical of the arm
hosts::MitArm<7> mit_arm(double friction = 1) {
  pinocchio::Model robot;
  pinocchio::urdf::buildModelFromXML("<robot/> with light_joint1", robot);
  std::vector<std::string> joints;
  for (int j = 1; j <= 7; ++j) joints.push_back("light_joint" + std::to_string(j));
  rme::PayloadCompensationConfig<double, 7> config;
  config.estimator = hosts::mit_config<7>(rme::examples::kLightArmPayload, friction * light_arm().typical_coulomb,
                                          friction * light_arm().typical_viscous);
  return {robot, joints, "light_tool", kPeriod, config};
}

/// Half a kilogram in the gripper.
RigidBody half_kilogram() {
  return rme::examples::box(0.5, {0.01, -0.02, 0.08}, {0.05, 0.05, 0.12});
}

/// How wrong the mass is some time after half a kilogram was taken up [kg].
struct Errors {
  double mean_1s = 0, worst_1s = 0, mean_5s = 0, worst_5s = 0;
};

/// 36 arms with other offsets, friction and noise each swing for 6 s, and then with the payload.
Errors errors_with(double friction) {
  constexpr int kArms = 36, kTakesUp = 3000;  // ticks
  Errors out;
  for (std::uint64_t seed = 1; seed <= kArms; ++seed) {
    Motors motors(seed);
    auto mit = mit_arm(friction);
    const auto note = [&](double& mean, double& worst) {
      const double error = std::abs(mit.compensation().state().payload.mean[0] - half_kilogram().mass);
      mean += error / kArms;
      worst = std::max(worst, error);
    };
    for (int k = 0; k <= kTakesUp + 2500; ++k) {
      if (k == kTakesUp) motors.arm.attach(half_kilogram());
      if (k == kTakesUp + 500) note(out.mean_1s, out.worst_1s);
      motors.command.q = wanted(k * kPeriod);
      motors.command.feedforward = mit.feedforward(motors.q(), motors.dq(), motors.torque(), kPeriod);
      REQUIRE(mit.status() == rme::Status::Ok);
      motors.step();
    }
    note(out.mean_5s, out.worst_5s);
  }
  return out;
}

TEST_CASE("hosts: arms of MIT-mode motors with their friction find half a kilogram", "[docs]") {
  const Errors errors = errors_with(1);
  CAPTURE(errors.mean_1s, errors.worst_1s, errors.mean_5s, errors.worst_5s);
  CHECK(errors.mean_1s < 0.005);
  CHECK(errors.mean_5s < 0.004);
  CHECK(errors.worst_5s < 0.02);
}

TEST_CASE(
    "hosts: with MIT-mode motors, friction that is stated twice too large costs less after a second than half of it "
    "does",
    "[docs]") {
  const Errors large = errors_with(2), small = errors_with(0.5);
  CAPTURE(large.mean_1s, large.worst_1s, large.mean_5s, large.worst_5s);
  CAPTURE(small.mean_1s, small.worst_1s, small.mean_5s, small.worst_5s);
  CHECK(large.mean_5s < 0.004);
  CHECK(small.mean_1s > 1.5 * large.mean_1s);
}

TEST_CASE("hosts: MIT-mode motors' feedforward carries the payload, and stays after an answer that is missing",
          "[docs]") {
  Motors motors(3);
  auto mit = mit_arm();
  for (int k = 0; k < 3500; ++k) {
    if (k == 1500) motors.arm.attach(half_kilogram());
    motors.command.q = wanted(k < 3000 ? k * kPeriod : 6);  // comes to rest
    motors.command.feedforward = mit.feedforward(motors.q(), motors.dq(), motors.torque(), kPeriod);
    motors.step();
  }
  const Vector without = light_arm().dynamics(motors.arm.q(), Vector::Zero()).gravity;
  const Vector with = light_arm().dynamics(motors.arm.q(), Vector::Zero(), half_kilogram()).gravity;
  CAPTURE(motors.command.feedforward.transpose(), with.transpose());
  CHECK((motors.command.feedforward - with).norm() < 0.15 * (with - without).norm());
  Vector missing = motors.torque();
  missing[4] = std::numeric_limits<double>::quiet_NaN();
  const Vector before = motors.command.feedforward;
  CHECK((mit.feedforward(motors.q(), motors.dq(), missing, kPeriod) == before));
  CHECK(mit.status() == rme::Status::NonFiniteInput);
}

TEST_CASE("hosts: an MIT-mode motor's torque is more than its feedforward", "[docs]") {
  hosts::MitCommand<7> command;
  command.kp.setConstant(20);
  command.kd.setConstant(0.5);
  command.q.setConstant(0.3);
  command.feedforward.setConstant(1);
  // 20 (0.3 - 0.1) - 0.5 * 2 + 1 = 4
  CHECK((command.torque(Vector::Constant(0.1), Vector::Constant(2)) - Vector::Constant(4)).norm() < 1e-12);
}

}  // namespace
