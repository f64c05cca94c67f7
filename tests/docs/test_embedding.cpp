// The snippets of docs/embedding.md as a host would have them: after the platform's headers, here stand-ins.
#include "stand_ins/libfranka.hpp"
#include "stand_ins/pinocchio.hpp"
#include "stand_ins/ros2_control.hpp"
// In the order in which they build on each other.
#include "embedding_compensation.hpp"
#include "embedding_events.hpp"
#include "embedding_hand_over.hpp"
#include "embedding_libfranka.hpp"
#include "embedding_pinocchio.hpp"
#include "embedding_ros2_control.hpp"
#include "embedding_settings.hpp"

#include <cmath>
#include <cstdio>
#include <limits>
#include <synthetic_arm/synthetic_arm.hpp>

#include "support/allocation_count.hpp"
#include "support/catch.hpp"

namespace {

using rme::examples::box;
using rme::examples::panda;
using rme::examples::RigidBody;
using Vector = rme::JointVector<double, 7>;
using Arm = rme::examples::SyntheticArm<7>;
using ArmConfig = rme::examples::SyntheticArmConfig<7>;

constexpr double kPeriod = 1e-3;  // [s]
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

RigidBody unknown_kilogram() {
  return box(1, {0.03, -0.02, 0.16}, {0.08, 0.06, 0.1});
}

/// What it takes to hold `body` where the arm is: J^T [ -m g ; -(R r) x (m g) ], written out.
Vector torque_that_holds(const RigidBody& body, const rme::examples::Kinematics<7>& at) {
  const Eigen::Vector3d weight(0, 0, -9.81 * body.mass);
  rme::Vector6<double> wrench;
  wrench << -weight, -(at.rotation * body.com).cross(weight);
  return at.jacobian.transpose() * wrench;
}

/// A host's own controller: follows a joint trajectory, gravity left to others.
Vector impedance(const Vector& q, const Vector& dq, const Vector& q_d, const Vector& dq_d) {
  const Vector stiffness = (Vector() << 600, 600, 600, 600, 100, 100, 50).finished();
  const Vector damping = (Vector() << 40, 40, 40, 40, 4, 4, 1).finished();
  return stiffness.cwiseProduct(q_d - q) + damping.cwiseProduct(dq_d - dq);
}

/// A Franka arm at rest: carries its own weight and the load that it was told of, and reports what torque it exerts
/// beyond that.
struct FrankaArm {
  FrankaArm() {
    // The end effector is a hand, turned and ahead of the flange.
    F_T_EE.translate(Eigen::Vector3d(0.01, 0, 0.1034)).rotate(Eigen::AngleAxisd(-0.7854, Eigen::Vector3d::UnitZ()));
  }

  franka::RobotState read() const {
    franka::RobotState state;
    Eigen::Isometry3d O_T_F = Eigen::Isometry3d::Identity();
    O_T_F.linear() = arm.kinematics().rotation;
    O_T_F.translation() = arm.kinematics().position;
    Eigen::Map<rme::Matrix4<double>>(state.O_T_EE.data()) = (O_T_F * F_T_EE).matrix();
    Eigen::Map<rme::Matrix4<double>>(state.F_T_EE.data()) = F_T_EE.matrix();
    Eigen::Map<Vector>(state.q.data()) = arm.q();
    Eigen::Map<Vector>(state.dq.data()) = arm.dq();
    const Vector reported = -arm.tau_ext() - torque_that_holds(load, arm.kinematics());
    Eigen::Map<Vector>(state.tau_ext_hat_filtered.data()) =
        ticks == spoilt_tick ? Vector(Vector::Constant(kNaN)) : reported;
    return state;
  }
  void command(const franka::Torques& torques) {
    commanded = Eigen::Map<const Vector>(torques.tau_J.data());
    step();
    ++ticks;
  }
  void step() { arm.step(commanded + arm.dynamics().gravity + torque_that_holds(load, arm.kinematics())); }
  /// Some packets never arrive: the robot goes on with the last command.
  std::uint64_t lose() {
    if (loses_every == 0 || ticks == 0 || ticks % loses_every != 0) return 0;
    for (int i = 0; i < 3; ++i) step();
    return 3;
  }
  franka::Robot robot() {
    return franka::Robot({[this] { return read(); }, [this](const franka::Torques& torques) { command(torques); },
                          [this](double mass, const Eigen::Vector3d& com, const Eigen::Matrix3d& inertia) {
                            load = {mass, com, inertia};
                            ++loads_set;
                          },
                          [this] { return lose(); }});
  }
  /// Runs the snippet's control loop for a while, around a controller that holds the pose, or swings about it.
  void control(franka::Robot& robot, PayloadCompensation<7>& payload, int duration) {
    const int end = ticks + duration;
    ::control(robot, franka::Model(), payload, [&](const franka::RobotState& state) {
      franka::Torques torques = state.q;         // any: it is overwritten
      const double phase = 4 * kPeriod * ticks;  // 4 rad/s
      Eigen::Map<Vector>(torques.tau_J.data()) =
          impedance(Eigen::Map<const Vector>(state.q.data()), Eigen::Map<const Vector>(state.dq.data()),
                    pose + Vector::Constant(swing * std::sin(phase)), Vector::Constant(4 * swing * std::cos(phase)));
      return ticks + 1 < end ? torques : franka::MotionFinished(torques);
    });
  }

  Eigen::Isometry3d F_T_EE = Eigen::Isometry3d::Identity();
  Vector pose = panda().ready + Vector::Constant(0.1);
  Arm arm{panda(), ArmConfig(), pose};
  RigidBody load;
  int loads_set = 0;
  Vector commanded = Vector::Zero();
  int ticks = 0;
  int spoilt_tick = -1;
  int loses_every = 0;
  double swing = 0;  // [rad]
};

TEST_CASE("embedding.md: libfranka's snippet holds an unknown kilogram within 2 percent", "[docs]") {
  FrankaArm franka;
  franka::Robot robot = franka.robot();
  PayloadCompensation<7> payload(kPeriod, franka_config());
  franka.control(robot, payload, 1000);
  CHECK(payload.torque().isZero(0));
  franka.arm.attach(unknown_kilogram());
  franka.control(robot, payload, 3000);

  const Vector wanted = torque_that_holds(unknown_kilogram(), franka.arm.kinematics());
  CAPTURE(payload.torque().transpose(), wanted.transpose());
  CHECK((payload.torque() - wanted).norm() < 0.02 * wanted.norm());
  CHECK((franka.arm.q() - franka.pose).norm() < 2e-3);
  // The centre of mass in the end effector's axes, but for the part along gravity.
  const rme::Payload<double> believed = payload.estimator().state().payload.payload();
  const Eigen::Vector3d error = believed.com - franka.F_T_EE.inverse() * unknown_kilogram().com;
  const Eigen::Matrix3d R = franka.arm.kinematics().rotation * franka.F_T_EE.linear();
  CHECK((R * error).head<2>().norm() < 2e-3);
}

TEST_CASE("embedding.md: libfranka's snippet ends its loop on a bad sample, and keeps the compensation", "[docs]") {
  FrankaArm franka;
  franka::Robot robot = franka.robot();
  PayloadCompensation<7> payload(kPeriod, franka_config());
  franka.control(robot, payload, 1000);
  franka.arm.attach(unknown_kilogram());
  franka.control(robot, payload, 2000);
  const Vector before = payload.torque();
  REQUIRE(before.norm() > 1);
  franka.spoilt_tick = franka.ticks + 10;
  franka.control(robot, payload, 1000);
  CHECK(franka.ticks == franka.spoilt_tick + 1);
  CHECK((payload.torque() - before).norm() < 0.01);
  CHECK(franka.commanded.allFinite());
}

TEST_CASE("embedding.md: libfranka's snippet holds an unknown kilogram although packets get lost", "[docs]") {
  FrankaArm franka;
  franka.loses_every = 7;
  franka::Robot robot = franka.robot();
  PayloadCompensation<7> payload(kPeriod, franka_config());
  franka.control(robot, payload, 1000);
  franka.arm.attach(unknown_kilogram());
  franka.control(robot, payload, 3000);
  const Vector wanted = torque_that_holds(unknown_kilogram(), franka.arm.kinematics());
  CAPTURE(payload.torque().transpose(), wanted.transpose());
  CHECK((payload.torque() - wanted).norm() < 0.02 * wanted.norm());
}

TEST_CASE("embedding.md: the load handed over is the payload in flange axes, and rme then adds nothing", "[docs]") {
  FrankaArm franka;
  franka::Robot robot = franka.robot();
  PayloadCompensation<7> payload(kPeriod, franka_config());
  CHECK_FALSE(hand_over(robot, franka.read(), payload));  // there is nothing yet
  franka.control(robot, payload, 1000);
  CHECK_FALSE(hand_over(robot, franka.read(), payload));
  franka.arm.attach(unknown_kilogram());
  franka.control(robot, payload, 60);
  CHECK_FALSE(hand_over(robot, franka.read(), payload));  // it is still coming
  CHECK(franka.loads_set == 0);

  franka.control(robot, payload, 1940);
  CHECK(hand_over(robot, franka.read(), payload));
  CHECK(franka.loads_set == 1);
  const Vector wanted = torque_that_holds(unknown_kilogram(), franka.arm.kinematics());
  CHECK((torque_that_holds(franka.load, franka.arm.kinematics()) - wanted).norm() < 0.02 * wanted.norm());
  // By hand: the arm has rested, so that no inertia has shown; made_consistent() makes it 2 m radius^2 about any axis.
  CHECK(franka.load.inertia.diagonal().minCoeff() >= 2 * 0.02 * 0.02 * franka.load.mass * (1 - 1e-9));

  franka.control(robot, payload, 10);
  CHECK(payload.torque().isZero(0));
  franka.control(robot, payload, 2000);
  CHECK(payload.estimator().state().empty());
  CHECK(payload.torque().norm() < 0.05);
  CHECK((franka.arm.q() - franka.pose).norm() < 2e-3);
}

TEST_CASE("embedding.md: the inertia handed over is the payload's, in flange axes, once the arm has moved", "[docs]") {
  FrankaArm franka;
  franka.swing = 0.2;
  franka::Robot robot = franka.robot();
  PayloadCompensation<7> payload(kPeriod, franka_config());
  const RigidBody body = box(2, {0.03, -0.02, 0.16}, {0.4, 0.2, 0.1});
  franka.control(robot, payload, 1000);
  franka.arm.attach(body);
  franka.control(robot, payload, 8000);
  REQUIRE(hand_over(robot, franka.read(), payload));
  CAPTURE(franka.load.inertia, body.inertia);
  CHECK((franka.load.inertia - body.inertia).norm() < 0.2 * body.inertia.norm());
}

TEST_CASE("embedding.md: a handed-over load that is lost is a push to rme, which carries nothing", "[docs]") {
  FrankaArm franka;
  franka::Robot robot = franka.robot();
  PayloadCompensation<7> payload(kPeriod, franka_config());
  franka.control(robot, payload, 1000);
  const int handle = franka.arm.attach(unknown_kilogram());
  franka.control(robot, payload, 2000);
  REQUIRE(hand_over(robot, franka.read(), payload));
  franka.control(robot, payload, 1000);
  franka.arm.detach(handle);
  franka.control(robot, payload, 3000);
  const auto& state = payload.estimator().state();
  CHECK(state.probability[rme::Hypothesis::Pushed] > 0.9);
  CHECK(state.health > 10);
  CHECK(state.payload.mean[0] < 0.02);
  CHECK(payload.torque().norm() < 0.1);
}

TEST_CASE("embedding.md: after a wrong sign nothing is carried, and health says that something is wrong", "[docs]") {
  FrankaArm franka;
  franka::Robot robot = franka.robot();
  rme::EstimatorConfig<double, 7> config = franka_config();
  config.torque_sign = rme::TorqueSign::External;
  PayloadCompensation<7> payload(kPeriod, config);
  franka.control(robot, payload, 1000);
  franka.arm.attach(unknown_kilogram());
  franka.control(robot, payload, 3000);
  CHECK(payload.estimator().state().probability[rme::Hypothesis::Pushed] > 0.9);
  CHECK(payload.estimator().state().health > 10);
  CHECK(payload.estimator().state().confidence < 0.05);
  CHECK(payload.torque().norm() < 0.1);
}

TEST_CASE("embedding.md: events tell a payload that came and one that went, once, and no push", "[docs]") {
  FrankaArm franka;
  franka::Robot robot = franka.robot();
  PayloadCompensation<7> payload(kPeriod, franka_config());
  PayloadChanges changes;
  const rme::EstimatorState<double>& state = payload.estimator().state();
  franka.control(robot, payload, 1000);
  CHECK_FALSE(changes.since_last(state));
  const int handle = franka.arm.attach(unknown_kilogram());
  franka.control(robot, payload, 1000);
  CHECK(changes.since_last(state));
  CHECK_FALSE(changes.since_last(state));
  CHECK(state.event.kind == rme::EventKind::Attached);
  CHECK(std::abs(state.event.onset - 1) < 0.03);

  franka.arm.push({{0, 10, 0}, Eigen::Vector3d::Zero()});
  franka.control(robot, payload, 500);
  franka.arm.push({});
  franka.control(robot, payload, 1000);
  CHECK(state.event.kind == rme::EventKind::Pushed);
  CHECK_FALSE(changes.since_last(state));

  franka.arm.detach(handle);
  franka.control(robot, payload, 1000);
  CHECK(state.event.kind == rme::EventKind::Removed);
  CHECK(changes.since_last(state));
  CHECK_FALSE(changes.since_last(state));
  payload.reset();
  CHECK(changes.since_last(state));
}

TEST_CASE("embedding.md: settings are read from a file, and what is wrong with them is named", "[docs]") {
  const std::string file = "embedding_settings.json";
  const auto read = [&](const std::string& text) {
    std::ofstream(file) << text;
    return read_settings(file);
  };
  const auto settings = read(R"({"rated_payload": 12.5, "observer_bandwidth": 0, "torque_sign": "reaction"})");
  CHECK(settings.rated_payload == 12.5);
  CHECK(settings.observer_bandwidth == 0);
  CHECK(settings.torque_sign == rme::TorqueSign::Reaction);
  CHECK(settings.sensing == std::nullopt);
  CHECK_THROWS_WITH(read(R"({"rated_load": 12.5})"), contains("rated_load"));
  (void)std::remove(file.c_str());
  CHECK_THROWS_WITH(read_settings(file), contains(file));
}

std::vector<std::string> joint_names() {
  std::vector<std::string> names;
  for (int j = 1; j <= 7; ++j) names.push_back("panda_joint" + std::to_string(j));
  return names;
}

pinocchio::Model panda_with_hand() {
  pinocchio::Model model;
  return pinocchio::urdf::buildModelFromXML("", model);
}

/// Hardware that reports position, velocity and torque of each joint, and nothing else.
struct Hardware {
  explicit Hardware(controller_interface::ControllerInterface& owner) : controller(owner) {
    std::vector<hardware_interface::LoanedStateInterface> states;
    std::vector<hardware_interface::LoanedCommandInterface> commands;
    for (const double& value : state) states.emplace_back(value);
    for (double& value : command) commands.emplace_back(value);
    controller.get_node()->parameters.emplace("joints", rclcpp::Parameter(joint_names()));
    controller.get_node()->parameters.emplace("end_effector", rclcpp::Parameter(std::string("panda_link8")));
    REQUIRE(controller.on_init() == controller_interface::CallbackReturn::SUCCESS);
    REQUIRE(controller.on_configure({}) == controller_interface::CallbackReturn::SUCCESS);
    controller.assign_interfaces(std::move(commands), std::move(states));
    REQUIRE(controller.on_activate({}) == controller_interface::CallbackReturn::SUCCESS);
  }

  controller_interface::return_type tick() {
    for (std::size_t i = 0; i < 21; ++i) {
      const int j = static_cast<int>(i / 3);
      state[i] = i % 3 == 0 ? arm.q()[j] : i % 3 == 1 ? arm.dq()[j] : arm.tau_measured()[j];
    }
    if (torque_is_lost) state[20] = kNaN;
    const auto result = controller.update({}, {});
    arm.step(commanded());
    return result;
  }
  /// @return how many went well
  int run(int ticks) {
    int good = 0;
    for (int k = 0; k < ticks; ++k) good += tick() == controller_interface::return_type::OK ? 1 : 0;
    return good;
  }
  Vector commanded() const { return Eigen::Map<const Vector>(command.data()); }

  controller_interface::ControllerInterface& controller;
  Arm arm{panda(), ArmConfig(), panda().ready};
  std::array<double, 21> state{};
  std::array<double, 7> command{};
  bool torque_is_lost = false;
};

/// The user's side of the ros2_control snippet: swings the joints.
class SwingingController : public PayloadController {
 public:
  Vector nominal = Vector::Zero();

 protected:
  Vector nominal_torque(const Vector& q, const Vector& dq) override {
    const double phase = 3 * kPeriod * ticks_++;  // 3 rad/s
    const Vector amplitude = Vector::Constant(0.15);
    nominal = impedance(q, dq, panda().ready + amplitude * std::sin(phase), 3 * amplitude * std::cos(phase)) +
              panda().dynamics(q, dq).gravity;
    return nominal;
  }

 private:
  int ticks_ = 0;
};

TEST_CASE("embedding.md: ros2_control's snippet holds an unknown kilogram within 2 percent on a moving arm", "[docs]") {
  SwingingController controller;
  Hardware hardware(controller);
  REQUIRE(hardware.run(1000) == 1000);
  CHECK((hardware.commanded() == controller.nominal));
  hardware.arm.attach(unknown_kilogram());
  REQUIRE(hardware.run(3000) == 3000);
  const Vector wanted = torque_that_holds(unknown_kilogram(), hardware.arm.kinematics());
  REQUIRE(hardware.run(1) == 1);
  const Vector compensation = hardware.commanded() - controller.nominal;
  CAPTURE(compensation.transpose(), wanted.transpose());
  CHECK((compensation - wanted).norm() < 0.02 * wanted.norm());
}

TEST_CASE("embedding.md: ros2_control's snippet claims its interfaces in the order in which it reads them", "[docs]") {
  SwingingController controller;
  const Hardware hardware(controller);
  const auto states = controller.state_interface_configuration();
  REQUIRE(states.names.size() == 21);
  CHECK(states.type == controller_interface::interface_configuration_type::INDIVIDUAL);
  CHECK(states.names[3] == "panda_joint2/position");
  CHECK(states.names[4] == "panda_joint2/velocity");
  CHECK(states.names[5] == "panda_joint2/effort");
  CHECK(controller.command_interface_configuration().names[6] == "panda_joint7/effort");
}

TEST_CASE("embedding.md: ros2_control's snippet refuses a frame or a joint that the model lacks", "[docs]") {
  std::vector<std::string> six = joint_names();
  six.pop_back();
  for (const bool wrong_frame : {true, false}) {
    CAPTURE(wrong_frame);
    SwingingController controller;
    controller.get_node()->parameters.emplace("joints", rclcpp::Parameter(wrong_frame ? joint_names() : six));
    controller.get_node()->parameters.emplace("end_effector",
                                              rclcpp::Parameter(std::string(wrong_frame ? "flange" : "panda_link8")));
    REQUIRE(controller.on_init() == controller_interface::CallbackReturn::SUCCESS);
    CHECK(controller.on_configure({}) == controller_interface::CallbackReturn::ERROR);
  }
}

TEST_CASE("embedding.md: ros2_control's snippet survives four bad samples with its last command, and then stops",
          "[docs]") {
  SwingingController controller;
  Hardware hardware(controller);
  REQUIRE(hardware.run(100) == 100);
  const Vector last = hardware.commanded();
  hardware.torque_is_lost = true;
  CHECK(hardware.run(4) == 4);
  CHECK((hardware.commanded() == last));
  hardware.torque_is_lost = false;
  CHECK(hardware.run(1) == 1);
  CHECK((hardware.commanded() != last));
  hardware.torque_is_lost = true;
  CHECK(hardware.run(5) == 4);
}

TEST_CASE("embedding.md: ros2_control's snippet allocates nothing in its loop", "[docs]") {
#ifdef RME_COUNTS_ALLOCATIONS
  SwingingController controller;
  Hardware hardware(controller);
  int good = hardware.run(1000);
  const int before = rme::testing::allocations();
  hardware.arm.attach(unknown_kilogram());  // allocates once
  good += hardware.run(2000);
  CHECK(rme::testing::allocations() - before <= 1);
  CHECK(good == 3000);
#else
  WARN("allocations are not counted here");
#endif
}

TEST_CASE("embedding.md: Pinocchio's snippet sees what a moving arm's own observer, Jacobian and pose say", "[docs]") {
  Arm arm(panda(), ArmConfig(), panda().ready, Vector::Constant(1));
  PinocchioSensing sensing(arm_of(panda_with_hand(), joint_names()), "panda_link8", kPeriod);
  arm.attach(unknown_kilogram());
  for (int k = 0; k < 200; ++k) {
    rme::Proprioception<double, 7> sample;
    REQUIRE(sensing.update(arm.q(), arm.dq(), arm.tau_measured(), sample) == rme::Status::Ok);
    CAPTURE(k, arm.dq().transpose());
    // C^T dq takes another way through the stand-in's matrix, which costs some digits.
    REQUIRE((sample.tau_ext - arm.tau_ext()).norm() < 1e-9);
    REQUIRE((sample.jacobian == arm.kinematics().jacobian));
    REQUIRE((sample.rotation == arm.kinematics().rotation));
    REQUIRE((sample.dq == arm.dq()));
    arm.step(arm.dynamics().gravity);
  }
}

TEST_CASE("embedding.md: Pinocchio's snippet refuses a model with fingers, and a frame that there is not", "[docs]") {
  CHECK_THROWS_WITH(PinocchioSensing(panda_with_hand(), "panda_link8", kPeriod), contains("other joints"));
  const pinocchio::Model arm = arm_of(panda_with_hand(), joint_names());
  CHECK_THROWS_WITH(PinocchioSensing(arm, "flange", kPeriod), contains("flange"));
  std::vector<std::string> other_order = joint_names();
  std::swap(other_order[0], other_order[1]);
  CHECK_THROWS_WITH(arm_of(panda_with_hand(), other_order), contains("order"));
}

TEST_CASE("embedding.md: a payload that Pinocchio's model carries no longer shows in tau_ext, at rest and in motion",
          "[docs]") {
  Arm arm(panda(), ArmConfig(), panda().ready, Vector::Constant(1));
  PinocchioSensing sensing(arm_of(panda_with_hand(), joint_names()), "panda_link8", kPeriod);
  arm.attach(unknown_kilogram());
  const RigidBody body = unknown_kilogram();
  sensing.carry(rme::InertialParameters<double>::of_body({body.mass, body.com}, body.inertia));
  rme::Proprioception<double, 7> sample;
  for (int k = 0; k < 200; ++k) {
    REQUIRE(sensing.update(arm.q(), arm.dq(), arm.tau_measured(), sample) == rme::Status::Ok);
    if (k == 100) CHECK(arm.dq().norm() > 1);
    arm.step(arm.dynamics().gravity);
  }
  CHECK(arm.tau_ext().norm() > 1);
  CHECK(sample.tau_ext.norm() < 1e-3);
}

TEST_CASE("embedding.md: an observer without the compensation in its torque sees half of the mass", "[docs]") {
  Arm arm(panda(), ArmConfig(), panda().ready);
  PinocchioSensing sensing(arm_of(panda_with_hand(), joint_names()), "panda_link8", kPeriod);
  PayloadCompensation<7> payload(kPeriod);
  Vector without = Vector::Zero();
  for (int k = 0; k < 4000; ++k) {
    if (k == 1000) arm.attach(unknown_kilogram());
    rme::Proprioception<double, 7> sample;
    REQUIRE(sensing.update(arm.q(), arm.dq(), without, sample) == rme::Status::Ok);
    REQUIRE(payload.update(sample) == rme::Status::Ok);
    without = impedance(arm.q(), arm.dq(), panda().ready, Vector::Zero()) + arm.dynamics().gravity;
    arm.step(without + payload.torque());
  }
  CHECK(std::abs(payload.estimator().state().payload.mean[0] - 0.5) < 0.05);
  CHECK(payload.estimator().state().health < 10);
}

/// What is believed of a kilogram on a resting arm whose observer has 50 rad/s.
rme::PayloadGaussian<double> believed(double period, double told_bandwidth) {
  rme::EstimatorConfig<double, 7> config;
  config.observer_bandwidth = told_bandwidth;
  PayloadCompensation<7> payload(period, config);
  const auto at = panda().kinematics(panda().ready);
  Vector tau_ext = Vector::Zero();
  for (int k = 0; k < 3000; ++k) {  // the observer has its own millisecond
    if (k >= 1000) tau_ext += 50 * kPeriod * (-torque_that_holds(unknown_kilogram(), at) - tau_ext);
    if (k % static_cast<int>(std::lround(period / kPeriod)) != 0) continue;
    REQUIRE(payload.update({tau_ext, at.jacobian, at.rotation, Vector::Zero()}) == rme::Status::Ok);
  }
  return payload.estimator().state().payload;
}

TEST_CASE("embedding.md: the default settings hold down to 50 Hz", "[docs]") {
  for (const double period : {0.001, 0.004, 0.01, 0.02}) {
    CAPTURE(period);
    CHECK(std::abs(believed(period, 50).mean[0] - 1) < 2e-3);
  }
  CHECK_THROWS_WITH(PayloadCompensation<7>(0.021), contains("Estimator::dt"));
}

TEST_CASE("embedding.md: half or twice the true bandwidth, or none, makes up to 3 percent of the mass", "[docs]") {
  for (const double told : {0.0, 25.0, 100.0}) {
    CAPTURE(told);
    CHECK(std::abs(believed(kPeriod, told).mean[0] - 1) < 0.03);
  }
}

}  // namespace
