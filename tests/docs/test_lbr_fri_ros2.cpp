// examples/hosts/lbr_fri_ros2, against stand-ins.
#include "hosts/lbr_fri_ros2/lbr_payload.hpp"

#include <cmath>
#include <controller_interface/controller_interface.hpp>
#include <limits>
#include <map>
#include <memory>
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

/// The stack's low-pass filter, which it runs at the robot's sample time.
struct StackFilter {
  double share;
  Vector value = Vector::Zero();
  StackFilter(double cutoff, double sample_time) : share(0) {
    const double c = std::cos(2 * 3.141592653589793 * cutoff * sample_time);
    share = c - 1 + std::sqrt(c * c - 4 * c + 3);
  }
  const Vector& update(const Vector& now) { return value += share * (now - value); }
};

/// An iiwa-like arm: adds its own gravity torque, and reports the external torque every 5 ms, filtered.
struct LbrArm {
  explicit LbrArm(double cutoff) : filter(cutoff, kSampleTime) {}
  /// An estimate of the external torque that is much faster than the stack's filter.
  static rme::examples::SyntheticArmConfig<7> fast() {
    rme::examples::SyntheticArmConfig<7> config;
    config.observer_gain.setConstant(900);
    return config;
  }
  static constexpr double kSampleTime = 0.005;  // [s]

  std::vector<hardware_interface::LoanedStateInterface> lend(const std::vector<std::string>& names) {
    std::vector<hardware_interface::LoanedStateInterface> out;
    for (auto name = names.rbegin(); name != names.rend(); ++name) {  // in another order than they were asked for
      auto& handle = handles[*name];
      handle = std::make_shared<hardware_interface::Handle>(hardware_interface::Handle{*name});
      handle->value = std::nan("");  // as long as the robot is not connected
      out.emplace_back(handle);
    }
    return out;
  }
  void report() {
    const Vector tau_ext = filter.update(arm.tau_ext());
    for (int j = 0; j < 7; ++j) {
      const std::string name = "lbr_A" + std::to_string(j + 1);
      handles.at(name + "/position")->value = arm.q()[j];
      handles.at(name + "/velocity")->value = arm.dq()[j];
      handles.at(name + "/external_torque")->value = tau_ext[j];
    }
  }
  void step(const Vector& overlay) {
    for (int i = 0; i < 5; ++i) arm.step(arm.dynamics().gravity + overlay);
  }

  rme::examples::SyntheticArm<7> arm{rme::examples::panda(), fast(), rme::examples::panda().ready};
  StackFilter filter;
  std::map<std::string, hardware_interface::Handle::SharedPtr> handles;
};

hosts::LbrPayload lbr_payload(const rme::EstimatorConfig<double, 7>& estimator) {
  pinocchio::Model robot;
  pinocchio::urdf::buildModelFromXML("<robot/> with lbr_A1", robot);
  std::vector<std::string> joints;
  for (int j = 1; j <= 7; ++j) joints.push_back("lbr_A" + std::to_string(j));
  rme::PayloadCompensationConfig<double, 7> config;
  config.estimator = estimator;
  return {robot, joints, "lbr_link_ee", LbrArm::kSampleTime, config};
}

TEST_CASE("hosts: lbr_fri_ros2's interfaces hold an unknown kilogram within 2 percent", "[docs]") {
  hosts::LbrPayload payload = lbr_payload(hosts::lbr_config(10, LbrArm::kSampleTime));
  LbrArm lbr(10);
  CHECK(payload.update(LbrArm::kSampleTime) == rme::Status::NotReady);  // not activated yet
  std::vector<hardware_interface::LoanedStateInterface> interfaces = lbr.lend(payload.state_interfaces());
  REQUIRE(payload.activate(interfaces));
  CHECK(payload.update(LbrArm::kSampleTime) == rme::Status::NonFiniteInput);  // not connected yet
  const Vector pose = lbr.arm.q();
  const Vector stiffness = (Vector() << 600, 600, 600, 600, 100, 100, 50).finished();
  for (int k = 0; k < 1000; ++k) {
    if (k == 200) lbr.arm.attach(unknown_kilogram());
    lbr.report();
    REQUIRE(payload.update(LbrArm::kSampleTime) == rme::Status::Ok);
    const Vector nominal = stiffness.cwiseProduct(pose - lbr.arm.q()) - 0.07 * stiffness.cwiseProduct(lbr.arm.dq());
    lbr.step(nominal + payload.compensation().torque());
  }
  const Vector wanted = torque_that_holds(unknown_kilogram(), lbr.arm.kinematics());
  CHECK((payload.compensation().torque() - wanted).norm() < 0.02 * wanted.norm());
  payload.deactivate();
  CHECK(payload.update(LbrArm::kSampleTime) == rme::Status::NotReady);
}

TEST_CASE("hosts: lbr_fri_ros2's filter is the one that the settings say", "[docs]") {
  for (const double cutoff : {5.0, 10.0, 40.0})
    for (const double sample_time : {0.001, 0.005, 0.01}) {
      CAPTURE(cutoff, sample_time);
      StackFilter stack(cutoff, sample_time);
      const double K = hosts::lbr_config(cutoff, sample_time).observer_bandwidth;
      double ours = 0;  // K's filter at 1 kHz, of a unit step
      for (int period = 0; period < 20; ++period) {
        stack.update(Vector::Ones());
        for (int ms = 0; ms < std::lround(1000 * sample_time); ++ms) ours += 0.001 * K * (1 - ours);
        CHECK(std::abs(stack.value[0] - ours) < 1e-9);
      }
    }
}

TEST_CASE("hosts: lbr_fri_ros2's host reports a missing interface, and does not run without it", "[docs]") {
  hosts::LbrPayload payload = lbr_payload(hosts::lbr_config());
  LbrArm lbr(10);
  std::vector<std::string> names = payload.state_interfaces();
  REQUIRE(names.size() == 21);
  CHECK(names[5] == "lbr_A2/external_torque");
  names.pop_back();
  std::vector<hardware_interface::LoanedStateInterface> interfaces = lbr.lend(names);
  CHECK_FALSE(payload.activate(interfaces));
  CHECK(payload.update(LbrArm::kSampleTime) == rme::Status::NotReady);
}

}  // namespace
