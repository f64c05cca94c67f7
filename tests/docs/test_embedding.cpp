// The snippets of docs/embedding.md as a host would have them: after the platform's headers, here stand-ins.
#include "stand_ins/libfranka.hpp"
#include "stand_ins/pinocchio.hpp"
#include "stand_ins/ros2_control.hpp"
// In the order in which they build on each other.
#include "embedding_compensation.hpp"
#include "embedding_hand_over.hpp"
#include "embedding_libfranka.hpp"
#include "embedding_pinocchio.hpp"
#include "embedding_ros2_control.hpp"

#include <cmath>
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
    arm.step(commanded + arm.dynamics().gravity + torque_that_holds(load, arm.kinematics()));
    ++ticks;
  }
  franka::Robot robot() {
    return franka::Robot({[this] { return read(); }, [this](const franka::Torques& torques) { command(torques); },
                          [this](double mass, const Eigen::Vector3d& com, const Eigen::Matrix3d& inertia) {
                            load = {mass, com, inertia};
                            ++loads_set;
                          }});
  }
  /// Runs the snippet's control loop for a while, around a controller that holds the pose.
  void control(franka::Robot& robot, PayloadCompensation<7>& payload, int duration) {
    const int end = ticks + duration;
    ::control(robot, franka::Model(), payload, [&](const franka::RobotState& state) {
      franka::Torques torques = state.q;  // any: it is overwritten
      Eigen::Map<Vector>(torques.tau_J.data()) = impedance(
          Eigen::Map<const Vector>(state.q.data()), Eigen::Map<const Vector>(state.dq.data()), pose, Vector::Zero());
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
  const rme::Payload<double> estimate = payload.estimator().estimate().payload();
  const Eigen::Vector3d error = estimate.com - franka.F_T_EE.inverse() * unknown_kilogram().com;
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

TEST_CASE("embedding.md: the load handed over is the payload in flange axes, and rme then adds nothing", "[docs]") {
  FrankaArm franka;
  franka::Robot robot = franka.robot();
  PayloadCompensation<7> payload(kPeriod, franka_config());
  hand_over(robot, franka.read(), payload);
  CHECK(franka.loads_set == 0);  // there is nothing yet
  franka.control(robot, payload, 1000);
  franka.arm.attach(unknown_kilogram());
  franka.control(robot, payload, 200);
  REQUIRE_FALSE(payload.estimator().estimate().empty);
  hand_over(robot, franka.read(), payload);
  CHECK(franka.loads_set == 0);  // there is an early estimate

  franka.control(robot, payload, 1800);
  hand_over(robot, franka.read(), payload);
  CHECK(franka.loads_set == 1);
  const Vector wanted = torque_that_holds(unknown_kilogram(), franka.arm.kinematics());
  CHECK((torque_that_holds(franka.load, franka.arm.kinematics()) - wanted).norm() < 0.02 * wanted.norm());
  CHECK(franka.load.inertia.isApprox(franka.load.mass * 9e-4 * Eigen::Matrix3d::Identity()));

  franka.control(robot, payload, 10);
  CHECK(payload.torque().isZero(0));
  franka.control(robot, payload, 2000);
  CHECK(payload.estimator().phase() == rme::Phase::Watching);
  CHECK(payload.torque().isZero(0));
  CHECK((franka.arm.q() - franka.pose).norm() < 2e-3);
}

TEST_CASE("embedding.md: a load that is lost after it was handed over is a negative mass to rme, which holds the arm",
          "[docs]") {
  FrankaArm franka;
  franka::Robot robot = franka.robot();
  PayloadCompensation<7> payload(kPeriod, franka_config());
  franka.control(robot, payload, 1000);
  const int handle = franka.arm.attach(unknown_kilogram());
  franka.control(robot, payload, 2000);
  hand_over(robot, franka.read(), payload);
  franka.control(robot, payload, 1000);
  franka.arm.detach(handle);
  franka.control(robot, payload, 2000);
  CHECK(std::abs(payload.estimator().estimate().payload().mass + 1) < 0.02);
  CHECK((franka.arm.q() - franka.pose).norm() < 2e-3);
}

/// Hardware that reports position, velocity and torque of each joint, and nothing else.
struct Hardware {
  explicit Hardware(controller_interface::ControllerInterface& owner) : controller(owner) {
    std::vector<hardware_interface::LoanedStateInterface> states;
    std::vector<hardware_interface::LoanedCommandInterface> commands;
    for (const double& value : state) states.emplace_back(value);
    for (double& value : command) commands.emplace_back(value);
    controller.assign_interfaces(std::move(commands), std::move(states));
    REQUIRE(controller.on_configure({}) == controller_interface::CallbackReturn::SUCCESS);
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
  PinocchioSensing sensing(pinocchio::Model(), 0, kPeriod);
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

/// The mass that is estimated of a kilogram on a resting arm whose observer has 50 rad/s.
double estimated_mass(double period, double told_bandwidth) {
  rme::EstimatorConfig<double, 7> config;
  config.window.observer_bandwidth = told_bandwidth;
  PayloadCompensation<7> payload(period, config);
  const auto at = panda().kinematics(panda().ready);
  Vector tau_ext = Vector::Zero();
  for (double t = 0; t < 3; t += period) {
    if (t > 1) tau_ext += 50 * period * (-torque_that_holds(unknown_kilogram(), at) - tau_ext);
    REQUIRE(payload.update({tau_ext, at.jacobian, at.rotation, Vector::Zero()}) == rme::Status::Ok);
  }
  return payload.estimator().estimate().payload().mass;
}

TEST_CASE("embedding.md: the default settings hold down to 100 Hz", "[docs]") {
  for (const double period : {0.001, 0.004, 0.01}) {
    CAPTURE(period);
    CHECK(std::abs(estimated_mass(period, 50) - 1) < 1e-3);
  }
  CHECK_THROWS_WITH(PayloadCompensation<7>(0.011), contains("onset_span"));
}

TEST_CASE("embedding.md: half or twice the true bandwidth makes 2 percent of the mass", "[docs]") {
  for (const double told : {25.0, 100.0}) {
    CAPTURE(told);
    const double error = std::abs(estimated_mass(kPeriod, told) - 1);
    CHECK(error > 1e-3);
    CHECK(error < 0.02);
  }
}

}  // namespace
