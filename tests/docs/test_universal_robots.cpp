// examples/hosts/universal_robots, against stand-ins.
#include "hosts/universal_robots/ur_payload.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <memory>
#include <pinocchio/parsers/urdf.hpp>
#include <precompiled/any_joints.hpp>
#include <string>
#include <synthetic_arm/six_joint_arm.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "hosts/universal_robots/ur_hand_over.hpp"
#include "support/catch.hpp"

namespace {

using rme::examples::box;
using rme::examples::RigidBody;
using rme::examples::six_joint_arm;
using Vector = rme::JointVector<double, 6>;

constexpr double kPeriod = 0.002;  // [s]

RigidBody unknown_object() {
  return box(1.5, {0.03, -0.02, 0.12}, {0.12, 0.06, 0.08});
}

/// What it takes to hold `body` where the arm is.
Vector torque_that_holds(const RigidBody& body, const rme::examples::Kinematics<6>& at) {
  const Eigen::Vector3d weight(0, 0, -9.81 * body.mass);
  rme::Vector6<double> wrench;
  wrench << -weight, -(at.rotation * body.com).cross(weight);
  return at.jacobian.transpose() * wrench;
}

/// A UR: carries its own weight, and the payload that it was told of, which it takes over in a transition time. Reports
/// torque less the gravity of both.
struct UrArm {
  static rme::examples::SyntheticArmConfig<6> at_its_rate() {
    rme::examples::SyntheticArmConfig<6> config;
    config.dt = kPeriod;
    config.substeps = 2;
    return config;
  }
  RigidBody payload() const {  // that it carries now: linear in mass and first moment
    const double s = since < 0 ? 0 : transition > 0 ? std::min(1.0, since / transition) : 1;
    return (1 - s) * from + s * to;
  }
  Vector own_gravity() const { return arm.dynamics().gravity + torque_that_holds(payload(), arm.kinematics()); }
  urcl::UrDriver driver() {
    return urcl::UrDriver(
        {[this](urcl::rtde_interface::DataPackage& data) { read(data); },
         [this](const urcl::vector6d_t& torque) { step(Eigen::Map<const Vector>(torque.data())); },
         [this](double mass, const urcl::vector3d_t& cog, const urcl::vector6d_t& inertia, double transition_time) {
           if (!listens) return false;
           ++told;
           if (!obeys) return true;
           from = payload();
           asked = {mass, cog, inertia};
           const rme::InertialParameters<double> body = asked.body();
           to = {mass, body.payload().com, body.inertia_about_com()};
           transition = transition_time;
           since = -latency;
           return true;
         }});
  }
  void read(urcl::rtde_interface::DataPackage& data) const {
    urcl::vector6d_t q{}, dq{}, torque{};
    Eigen::Map<Vector>(q.data()) = arm.q();
    Eigen::Map<Vector>(dq.data()) = arm.dq();
    Eigen::Map<Vector>(torque.data()) = reported;
    REQUIRE(data.setData("actual_q", q));
    REQUIRE(data.setData("actual_qd", dq));
    REQUIRE(data.setData("actual_current_as_torque", torque));
    const RigidBody now = payload();
    const hosts::UrLoad load =
        hosts::UrLoad::of(rme::InertialParameters<double>::of_body({now.mass, now.com}, now.inertia));
    REQUIRE(data.setData("payload", load.mass));
    REQUIRE(data.setData("payload_cog", load.cog));
    REQUIRE(data.setData("payload_inertia", load.inertia));
  }
  void step(const Vector& command) {
    const Vector gravity = own_gravity();
    largest_step = std::max(largest_step, (command + gravity - last).cwiseAbs().maxCoeff());
    last = command + gravity;
    arm.step(last);
    since += kPeriod;
    reported = arm.tau_measured() - own_gravity();
  }

  Vector pose = six_joint_arm().ready + Vector::Constant(0.15);
  rme::examples::SyntheticArm<6> arm{six_joint_arm(), at_its_rate(), pose};
  RigidBody from, to;
  hosts::UrLoad asked;
  double transition = 0, since = 0;  // [s]
  double latency = 0.012;            // between the call and what the robot makes of it [s]
  bool listens = true, obeys = true;
  int told = 0;
  Vector reported = Vector::Zero(), last = Vector::Zero();
  double largest_step = 0;  // of the motors' torque, in a period [N m]
};

/// The loop: an impedance controller that holds a pose or swings about it, and the compensation.
struct Host {
  explicit Host(UrArm& robot) : ur(robot), driver(robot.driver()) {
    config.estimator.rated_payload = 5;
    config.estimator.sensing = rme::Sensing::LinkSide;
    config.fade_time = 0.5;
    pinocchio::Model model;
    pinocchio::urdf::buildModelFromXML("<robot/> with shoulder_pan_joint", model);
    const RigidBody& tool = robot.to;  // a gripper that the robot was told of is in the URDF, too
    if (tool.mass > 0)
      model.appendBodyToJoint(6, pinocchio::Inertia(tool.mass, tool.com, tool.inertia), model.frames[0].placement);
    payload = std::make_unique<hosts::UrPayload>(
        model,
        std::vector<std::string>{"shoulder_pan_joint", "shoulder_lift_joint", "elbow_joint", "wrist_1_joint",
                                 "wrist_2_joint", "wrist_3_joint"},
        "tool0", kPeriod, config);
    hand_over = std::make_unique<hosts::UrHandOver>(driver, payload->compensation());
  }
  void run(double seconds, double swing = 0) {
    const Vector way = (Vector() << 0.3, 0.5, 0.5, 1, 1.5, 1).finished();
    const Vector damping = (Vector() << 64, 64, 64, 4, 4, 1).finished();
    const Vector stiffness = (Vector() << 800, 800, 800, 150, 150, 100).finished();
    for (int k = 0; k < static_cast<int>(seconds / kPeriod); ++k) {
      REQUIRE(driver.getDataPackage(data));
      REQUIRE(payload->update(data, kPeriod, hand_over->carried(payload->sample())) == rme::Status::Ok);
      hand_over->update(data, kPeriod);
      const Vector wanted = ur.pose + swing * (1 - std::cos(3.141592654 * k * kPeriod)) * way;
      const Vector torque = stiffness.cwiseProduct(wanted - ur.arm.q()) - damping.cwiseProduct(ur.arm.dq()) +
                            payload->compensation().torque();
      urcl::vector6d_t command{};
      Eigen::Map<Vector>(command.data()) = torque;
      REQUIRE(driver.writeJointCommand(command, urcl::comm::ControlMode::MODE_TORQUE));
      furthest = std::max(furthest, (ur.arm.q() - ur.pose).norm());
    }
  }
  /// Is handed the object, and carries it about until it is known well.
  int pick_up() {
    run(1);
    const int handle = ur.arm.attach(unknown_object());
    run(1);
    run(4, 0.3);
    run(1.5);
    return handle;
  }

  UrArm& ur;
  urcl::UrDriver driver;
  urcl::rtde_interface::DataPackage data{hosts::ur_recipe()};
  rme::PayloadCompensationConfig<double, 6> config;
  std::unique_ptr<hosts::UrPayload> payload;
  std::unique_ptr<hosts::UrHandOver> hand_over;
  double furthest = 0;  // from the pose [rad]
};

TEST_CASE("hosts: a UR's torque plus its model's gravity holds an unknown object within 2 percent", "[docs]") {
  UrArm ur;
  Host host(ur);
  host.run(1);
  ur.arm.attach(unknown_object());
  host.run(3);
  const Vector wanted = torque_that_holds(unknown_object(), ur.arm.kinematics());
  CHECK((host.payload->compensation().torque() - wanted).norm() < 0.02 * wanted.norm());
  ur.reported[2] = std::numeric_limits<double>::quiet_NaN();
  REQUIRE(host.driver.getDataPackage(host.data));
  CHECK(host.payload->update(host.data, kPeriod) == rme::Status::NonFiniteInput);
  CHECK(host.payload->update(urcl::rtde_interface::DataPackage({"actual_q"}), kPeriod) == rme::Status::NotReady);
}

TEST_CASE("hosts: a UR is told the payload in its own order, and takes it over without a step of the torque",
          "[docs]") {
  UrArm ur;
  ur.from = ur.to = box(0.6, {0.01, 0, 0.04}, {0.06, 0.1, 0.08});  // a gripper, which it knows
  ur.arm.attach(ur.to);
  Host host(ur);
  (void)host.pick_up();
  const auto judged = host.hand_over->begin(host.data);
  CAPTURE(rme::to_string(judged.verdict), judged.torque_error);
  REQUIRE(host.hand_over->running());
  CHECK(ur.told == 1);
  // Gripper and object together.
  const RigidBody sum = ur.from + unknown_object();
  CHECK(std::abs(ur.asked.mass - sum.mass) < 0.02);
  for (std::size_t i = 0; i < 3; ++i) CHECK(std::abs(ur.asked.cog[i] - sum.com[static_cast<int>(i)]) < 0.005);
  const Eigen::Matrix3d I =
      rme::InertialParameters<double>::from_vector(
          rme::InertialParameters<double>::of_body({ur.from.mass, ur.from.com}, ur.from.inertia).vector() +
          judged.body.vector())
          .inertia_about_com();
  const urcl::vector6d_t wanted = {I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)};
  for (std::size_t i = 0; i < 6; ++i) CHECK(std::abs(ur.asked.inertia[i] - wanted[i]) < 1e-9);

  ur.largest_step = host.furthest = 0;
  host.run(1);
  CHECK(host.hand_over->done());
  CHECK_FALSE(host.hand_over->running());
  CHECK(ur.largest_step < 0.1);
  CHECK(host.furthest < 1e-3);
  host.run(2);
  CHECK(host.payload->compensation().state().empty());
  CHECK(host.payload->compensation().torque().norm() < 0.05);
  CHECK(host.furthest < 1e-3);
}

TEST_CASE("hosts: a UR is told nothing of a payload that is not known well enough", "[docs]") {
  UrArm ur;
  Host host(ur);
  host.run(1);
  CHECK(host.hand_over->begin(host.data).verdict == rme::HandOverVerdict::Empty);
  ur.arm.attach(unknown_object());
  host.run(0.1);
  CHECK_FALSE(host.hand_over->begin(host.data).ready());
  CHECK(ur.told == 0);
  CHECK_FALSE(host.hand_over->running());
}

TEST_CASE("hosts: if a UR does not take the payload, rme carries on", "[docs]") {
  for (const bool listens : {false, true}) {
    CAPTURE(listens);
    UrArm ur;
    ur.listens = listens;
    ur.obeys = false;
    Host host(ur);
    (void)host.pick_up();
    CHECK(host.hand_over->begin(host.data).ready());
    CHECK(host.hand_over->running() == listens);
    host.run(3);
    CHECK_FALSE(host.hand_over->running());
    CHECK_FALSE(host.hand_over->done());
    const Vector wanted = torque_that_holds(unknown_object(), ur.arm.kinematics());
    CHECK((host.payload->compensation().torque() - wanted).norm() < 0.03 * wanted.norm());
  }
}

TEST_CASE("hosts: an object that a UR carries and that is dropped moves it little, and its payload is set back",
          "[docs]") {
  UrArm ur;
  Host host(ur);
  const int handle = host.pick_up();
  REQUIRE(host.hand_over->begin(host.data).ready());
  host.run(2);
  REQUIRE(host.hand_over->done());
  const Vector upwards = torque_that_holds(unknown_object(), ur.arm.kinematics());
  ur.arm.detach(handle);
  host.run(0.2);
  CHECK((host.payload->compensation().torque() + upwards).norm() < 0.1 * upwards.norm());
  host.run(0.3);
  REQUIRE(host.payload->compensation().load_lost());
  REQUIRE(host.hand_over->clear());
  CHECK(ur.asked.mass == 0);
  host.run(2);
  CHECK(host.payload->compensation().state().empty());
  CHECK((ur.arm.q() - ur.pose).norm() < 2e-3);
  CHECK_FALSE(host.hand_over->clear());
}

TEST_CASE("hosts: a UR that took a payload over at once, without transition, would change the torque by a step",
          "[docs]") {
  // The same object, with the robot's torque there from one tick to the next and rme's still there: what UrHandOver avoids.
  UrArm ur;
  Host host(ur);
  (void)host.pick_up();
  ur.largest_step = 0;
  const rme::HandOver<double> judged = host.payload->compensation().hand_over();
  REQUIRE(judged.ready());
  const hosts::UrLoad load = hosts::UrLoad::of(judged.body);
  REQUIRE(host.driver.setTargetPayload(static_cast<float>(load.mass), load.cog, load.inertia, 0));
  host.run(0.05);
  CHECK(ur.largest_step > 5);
}

}  // namespace
