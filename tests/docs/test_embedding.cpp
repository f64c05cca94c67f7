// The hosts of examples/hosts, from which docs/embedding.md has its code, here with stand-ins for their platforms.
#include "host/franka_arm.hpp"
#include "hosts/libfranka/patch.hpp"
#include "hosts/pinocchio/loop.hpp"
#include "hosts/ros2_control/joint_hold.hpp"
#include "hosts/settings.hpp"

#include <array>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <iterator>
#include <limits>
#include <map>
#include <memory>
#include <pluginlib/class_list_macros.hpp>
#include <string>
#include <vector>

#include "docs/ros2_hardware.hpp"
#include "support/allocation_count.hpp"
#include "support/catch.hpp"

namespace {

using rme::examples::box;
using rme::examples::panda;
using rme::examples::RigidBody;
using rme::testing::torque_that_holds;
using rme::testing::unknown_kilogram;
using namespace hosts;
using Vector = rme::JointVector<double, 7>;
using rme::testing::Hardware;
using rme::testing::joint_names;
using Arm = rme::examples::SyntheticArm<7>;
using ArmConfig = rme::examples::SyntheticArmConfig<7>;

constexpr double kPeriod = 1e-3;  // [s]
constexpr double kNaN = std::numeric_limits<double>::quiet_NaN();

/// A host's own controller: follows a joint trajectory, gravity left to others.
Vector impedance(const Vector& q, const Vector& dq, const Vector& q_d, const Vector& dq_d) {
  const Vector stiffness = (Vector() << 600, 600, 600, 600, 100, 100, 50).finished();
  const Vector damping = (Vector() << 40, 40, 40, 40, 4, 4, 1).finished();
  return stiffness.cwiseProduct(q_d - q) + damping.cwiseProduct(dq_d - dq);
}

/// Runs the patched loop for a while; a kilogram comes after a second.
/// @return the largest of what was added on a joint
double run_patched(rme::testing::FrankaArm& franka, const CarryOptions& options) {
  franka::Robot robot(franka.simulation());
  double added = 0;
  Vector last = Vector::Zero();
  const auto nominal = [&](const franka::RobotState& state, franka::Duration) {
    if (franka.ticks > 0) added = std::max(added, (franka.commanded - last).cwiseAbs().maxCoeff());
    if (franka.ticks == 1000) franka.arm.attach(unknown_kilogram());
    const Vector wanted = impedance(Eigen::Map<const Vector>(state.q.data()), Eigen::Map<const Vector>(state.dq.data()),
                                    franka.pose, Vector::Zero());
    last += (wanted - last).cwiseMax(-0.5).cwiseMin(0.5);
    franka::Torques torques(std::array<double, 7>{});
    Eigen::Map<Vector>(torques.tau_J.data()) = last;
    return franka.ticks < 4000 ? torques : franka::MotionFinished(torques);
  };
  run(robot, robot.loadModel(), nominal, options);
  return added;
}

TEST_CASE("embedding.md: a patched libfranka controller commands what it did before, until it is switched on",
          "[docs]") {
  rme::testing::FrankaArm without, with, bounded;
  CHECK(run_patched(without, {}) == 0);
  CHECK((without.arm.q() - without.pose).norm() > 0.01);  // it sags
  CHECK(run_patched(with, {true}) > 5);
  CHECK((with.arm.q() - with.pose).norm() < 2e-3);
  const double added = run_patched(bounded, {true, 3});
  CHECK(added <= 3 + 1e-9);
  CHECK(added > 2.9);
}

TEST_CASE("embedding.md: a patched libfranka controller ends on a bad sample with its last command", "[docs]") {
  rme::testing::FrankaArm franka;
  franka.spoilt_tick = 2000;
  (void)run_patched(franka, {true});
  CHECK(franka.ticks == 2001);
  CHECK(franka.commanded.allFinite());
}

TEST_CASE("embedding.md: Pinocchio's lines hold an unknown kilogram within 2 percent", "[docs]") {
  pinocchio::Model robot;
  pinocchio::urdf::buildModelFromXML("<robot/> with panda_finger_joint1", robot);
  std::vector<std::string> joints;
  for (int j = 1; j <= 7; ++j) joints.push_back("panda_joint" + std::to_string(j));
  CarryingArm<7> carrying(robot, joints, "panda_link8", kPeriod, {});
  Arm arm(panda(), ArmConfig(), panda().ready);
  Vector nominal = Vector::Zero(), command = Vector::Zero();
  for (int k = 0; k < 4000; ++k) {
    if (k == 1000) arm.attach(unknown_kilogram());
    nominal = impedance(arm.q(), arm.dq(), panda().ready, Vector::Zero()) + arm.dynamics().gravity;
    command = carrying.command(nominal, arm.q(), arm.dq(), arm.tau_measured(), kPeriod);
    arm.step(command);
  }
  const Vector wanted = torque_that_holds(unknown_kilogram(), arm.kinematics());
  CHECK((command - nominal - wanted).norm() < 0.02 * wanted.norm());
}

TEST_CASE("embedding.md: settings are read from a file, and what is wrong with them is named", "[docs]") {
  const std::string file = "embedding_settings.json";
  const auto read = [&](const std::string& text) {
    std::ofstream(file) << text;
    return read_settings<7>(file);
  };
  const auto settings = read(R"({"rated_payload": 12.5, "observer_bandwidth": 0, "torque_sign": "reaction"})");
  CHECK(settings.rated_payload == 12.5);
  CHECK(settings.observer_bandwidth == 0);
  CHECK(settings.torque_sign == rme::TorqueSign::Reaction);
  CHECK(settings.sensing == std::nullopt);
  CHECK_THROWS_WITH(read(R"({"rated_load": 12.5})"), contains("rated_load"));
  (void)std::remove(file.c_str());
  CHECK_THROWS_WITH(read_settings<7>(file), contains(file));
}

/// The user's side of the ros2_control snippet: swings the joints.
class SwingingController : public PayloadController<7> {
 public:
  Vector nominal = Vector::Zero();
  double spoilt = 0;  // a controller's own mistake

 protected:
  Vector nominal_torque(const Vector& q, const Vector& dq, const Vector& gravity) override {
    const double phase = 3 * kPeriod * ticks_++;  // 3 rad/s
    const Vector amplitude = Vector::Constant(0.15);
    nominal = impedance(q, dq, panda().ready + amplitude * std::sin(phase), 3 * amplitude * std::cos(phase)) + gravity;
    return nominal + Vector::Constant(spoilt);
  }

 private:
  int ticks_ = 0;
};

TEST_CASE("embedding.md: ros2_control's snippet holds an unknown kilogram within 2 percent on a moving arm", "[docs]") {
  SwingingController controller;
  Hardware hardware(controller);
  hardware.activate();
  REQUIRE(hardware.run(1000) == 1000);
  CHECK((hardware.commanded() - controller.nominal).norm() < 1e-3);
  hardware.arm.attach(unknown_kilogram());
  REQUIRE(hardware.run(3000) == 3000);
  const Vector wanted = torque_that_holds(unknown_kilogram(), hardware.arm.kinematics());
  REQUIRE(hardware.run(1) == 1);
  const Vector compensation = hardware.commanded() - controller.nominal;
  CAPTURE(compensation.transpose(), wanted.transpose());
  CHECK((compensation - wanted).norm() < 0.02 * wanted.norm());
}

TEST_CASE("embedding.md: ros2_control's snippet takes motor currents, with the gains and settings of check_arm",
          "[docs]") {
  SwingingController controller;
  Hardware hardware(controller);
  hardware.gains = (Vector() << -11, -12, -9, -10, -8, -7, -6).finished();  // the sign is in the settings
  const std::string file = "embedding_currents.json";
  std::ofstream(file) << R"({"rated_payload": 3, "torque_sign": "reaction"})";
  controller.get_node()->override_parameter("settings", file);
  controller.get_node()->override_parameter("gains", std::vector<double>{11, 12, 9, 10, 8, 7, 6});
  hardware.load_friction = 0.1;
  controller.get_node()->override_parameter("load_friction", std::vector<double>(7, 0.1));
  hardware.activate();
  (void)std::remove(file.c_str());
  REQUIRE(hardware.run(1000) == 1000);
  hardware.arm.attach(unknown_kilogram());
  REQUIRE(hardware.run(3001) == 3001);
  const Vector wanted = torque_that_holds(unknown_kilogram(), hardware.arm.kinematics());
  CHECK((hardware.commanded() - controller.nominal - wanted).norm() < 0.02 * wanted.norm());
}

TEST_CASE("embedding.md: ros2_control's host takes an effort that lacks gravity, as a UR's, when it is told so",
          "[docs]") {
  for (const bool told : {true, false}) {
    SwingingController controller;
    Hardware hardware(controller);
    hardware.lacks_gravity = true;
    controller.get_node()->override_parameter("effort_lacks_gravity", told);
    hardware.activate();
    REQUIRE(hardware.run(1000) == 1000);
    hardware.arm.attach(unknown_kilogram());
    REQUIRE(hardware.run(3001) == 3001);
    const Vector wanted = torque_that_holds(unknown_kilogram(), hardware.arm.kinematics());
    CHECK(((hardware.commanded() - controller.nominal - wanted).norm() < 0.02 * wanted.norm()) == told);
  }
}

TEST_CASE("embedding.md: ros2_control's snippet asks for its interfaces in the order in which it reads them",
          "[docs]") {
  SwingingController controller;
  Hardware hardware(controller);
  hardware.activate();
  const auto states = controller.state_interface_configuration();
  REQUIRE(states.names.size() == 21);
  CHECK(states.type == controller_interface::interface_configuration_type::INDIVIDUAL);
  CHECK(states.names[3] == "panda_joint2/position");
  CHECK(states.names[4] == "panda_joint2/velocity");
  CHECK(states.names[5] == "panda_joint2/effort");
  CHECK(controller.command_interface_configuration().names[6] == "panda_joint7/effort");
}

TEST_CASE("embedding.md: ros2_control's snippet refuses what it cannot work with, and says why", "[docs]") {
  std::vector<std::string> six = joint_names(), wrong = joint_names();
  six.pop_back();
  wrong[3] = "elbow";
  struct Case {
    const char* parameter;
    rclcpp::Parameter::Value value;
    const char* said;
  };
  for (const Case& c :
       {Case{"end_effector", std::string("flange"), "no frame flange"}, Case{"joints", six, "expected 7 names"},
        Case{"joints", wrong, "no joint elbow"}, Case{"gains", std::vector<double>(6, 1), "expected 7 numbers"},
        Case{"rotor_inertia", std::vector<double>(8, 1), "expected 7 numbers"},
        Case{"load_friction", std::vector<double>(8, 0), "expected 7 numbers"},
        Case{"rated_payload", 0.0, "rated_payload"}, Case{"rated_payload", -3.0, "rated_payload"},
        Case{"settings", std::string("nowhere.json"), "nowhere.json"}}) {
    CAPTURE(c.parameter, c.said);
    SwingingController controller;
    const Hardware hardware(controller);
    controller.get_node()->overrides[c.parameter] = rclcpp::Parameter(c.parameter, c.value);
    REQUIRE(controller.init({"payload", "<robot/>", 1000}) == controller_interface::return_type::OK);
    CHECK(controller.on_configure({}) == controller_interface::CallbackReturn::ERROR);
    CHECK_THAT(*controller.get_node()->get_logger().last, contains(c.said));
  }
  for (const unsigned int rate : {0u, 9u, 1000u}) {  // 9 Hz is too slow; in the last, the description is no URDF
    CAPTURE(rate);
    SwingingController controller;
    const Hardware hardware(controller);
    REQUIRE(controller.init({"payload", rate == 1000 ? "" : "<robot/>", rate}) ==
            controller_interface::return_type::OK);
    CHECK(controller.on_configure({}) == controller_interface::CallbackReturn::ERROR);
    CHECK_THAT(*controller.get_node()->get_logger().last, contains(rate == 0   ? "update_rate"
                                                                   : rate == 9 ? "Estimator::dt"
                                                                               : "URDF"));
  }
}

TEST_CASE("embedding.md: ros2_control's snippet survives four bad samples with its last command, and then stops",
          "[docs]") {
  SwingingController controller;
  Hardware hardware(controller);
  hardware.activate();
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

TEST_CASE("embedding.md: ros2_control's snippet commands no NaN of the controller's own", "[docs]") {
  SwingingController controller;
  Hardware hardware(controller);
  hardware.activate();
  REQUIRE(hardware.run(100) == 100);
  const Vector last = hardware.commanded();
  controller.spoilt = kNaN;
  CHECK(hardware.run(5) == 4);
  CHECK((hardware.commanded() == last));
}

TEST_CASE("embedding.md: ros2_control's snippet counts a command that was not taken as one bad sample", "[docs]") {
  SwingingController controller;
  Hardware hardware(controller);
  hardware.activate();
  REQUIRE(hardware.run(100) == 100);
  for (auto& [name, handle] : hardware.handles) handle->locked = name == "command of panda_joint1/effort";
  CHECK(hardware.run(4) == 4);
  for (auto& [name, handle] : hardware.handles) handle->locked = name == "panda_joint3/velocity";
  CHECK(hardware.run(1) == 0);
  for (auto& [name, handle] : hardware.handles) handle->locked = false;
  CHECK(hardware.run(1) == 1);
}

TEST_CASE("embedding.md: ros2_control's snippet allocates nothing in its loop", "[docs]") {
#ifdef RME_COUNTS_ALLOCATIONS
  SwingingController controller;
  Hardware hardware(controller);
  hardware.activate();
  hardware.run(100);
  int good = 0, allocated = 0;
  hardware.arm.attach(unknown_kilogram());
  for (int k = 0; k < 2000; ++k) {
    hardware.run(1);
    const int before = rme::testing::allocations();
    good += controller.update(rclcpp::Time(), hardware.period) == controller_interface::return_type::OK ? 1 : 0;
    allocated += rme::testing::allocations() - before;
  }
  CHECK(allocated == 0);
  CHECK(good == 2000);
#else
  WARN("allocations are not counted here");
#endif
}

TEST_CASE("hosts: the joint hold that is a plugin holds an unknown kilogram, and reports it outside its loop",
          "[docs]") {
  // As pluginlib makes it, by the type that payload_controllers.xml names.
  auto& classes = pluginlib::stand_in::classes<controller_interface::ControllerInterface>();
  std::ifstream file(RME_TEST_DATA "/../../examples/hosts/ros2_control/payload_controllers.xml");
  const std::string xml{std::istreambuf_iterator<char>(file), {}};
  std::size_t described = 0;
  for (std::size_t at = xml.find(" type=\""); at != std::string::npos; at = xml.find(" type=\"", at + 1), ++described) {
    const std::string type = xml.substr(at + 7, xml.find('"', at + 7) - at - 7);
    CAPTURE(type);
    CHECK(classes.count(type) == 1);
  }
  CHECK(described == classes.size());
  const auto controller = classes.at("hosts::JointHold7")();
  Hardware hardware(*controller);
  const std::vector<double> stiffness = {600, 600, 600, 600, 100, 100, 50}, damping = {40, 40, 40, 40, 4, 4, 1};
  controller->get_node()->override_parameter("stiffness", stiffness);
  controller->get_node()->override_parameter("damping", damping);
  hardware.activate();
  const Vector pose = hardware.arm.q();
  REQUIRE(hardware.run(1000) == 1000);
  const std::string& said = *controller->get_node()->get_logger().last;
  REQUIRE(controller->get_node()->timers.size() == 1);
  controller->get_node()->timers[0]->execute_callback();
  CHECK(said.empty());
  hardware.arm.attach(unknown_kilogram());
  REQUIRE(hardware.run(3000) == 3000);
  CHECK((hardware.arm.q() - pose).norm() < 2e-3);
  controller->get_node()->timers[0]->execute_callback();
  CHECK_THAT(said, contains("payload: 1.00"));
}

TEST_CASE("hosts: the joint hold refuses a stiffness of another length", "[docs]") {
  hosts::JointHold7 controller;
  Hardware hardware(controller);
  controller.get_node()->override_parameter("stiffness", std::vector<double>(6, 100));
  REQUIRE(controller.init({"payload", "<robot/>", 1000}) == controller_interface::return_type::OK);
  CHECK(controller.on_configure({}) == controller_interface::CallbackReturn::ERROR);
  CHECK_THAT(*controller.get_node()->get_logger().last, contains("expected 7 numbers each"));
}

/// What is believed of a kilogram on a resting arm whose observer has 50 rad/s.
rme::PayloadGaussian<double> believed(double period, double told_bandwidth) {
  rme::EstimatorConfig<double, 7> config;
  config.observer_bandwidth = told_bandwidth;
  rme::PayloadCompensation<double, 7> payload(period, config);
  const auto at = panda().kinematics(panda().ready);
  Vector tau_ext = Vector::Zero();
  for (int k = 0; k < 3000; ++k) {  // the observer has its own millisecond
    if (k >= 1000) tau_ext += 50 * kPeriod * (-torque_that_holds(unknown_kilogram(), at) - tau_ext);
    if (k % static_cast<int>(std::lround(period / kPeriod)) != 0) continue;
    REQUIRE(payload.update({tau_ext, at.jacobian, at.rotation, Vector::Zero()}) == rme::Status::Ok);
  }
  return payload.state().payload;
}

TEST_CASE("embedding.md: the default settings hold down to 10 Hz", "[docs]") {
  for (const double period : {0.001, 0.004, 0.01, 0.02, 0.1}) {
    CAPTURE(period);
    CHECK(std::abs(believed(period, 50).mean[0] - 1) < 2e-3);
  }
  CHECK_THROWS_WITH((rme::PayloadCompensation<double, 7>(0.101)), contains("Estimator::dt"));
}

TEST_CASE("embedding.md: half or twice the true bandwidth, or none, makes up to 3 percent of the mass", "[docs]") {
  for (const double told : {0.0, 25.0, 100.0}) {
    CAPTURE(told);
    CHECK(std::abs(believed(kPeriod, told).mean[0] - 1) < 0.03);
  }
}

}  // namespace
