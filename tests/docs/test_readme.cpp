// Compiled without rme's headers: the snippet has to name what it needs.
#include "readme_host_loop.hpp"

#include <cmath>

#include "support/catch.hpp"

namespace {

/// An arm at rest with J = (I6 | 0): its joint torques are the wrench on its flange. Handed 1 kg after one second,
/// which it reports through a momentum observer of the default bandwidth, 50 rad/s.
struct RestingArm {
  using Torque = rme::JointVector<double, 7>;

  bool wait_for_tick() {
    if (++tick > 1000) observed += 50 * 0.001 * (payload_torque() - observed);
    return tick <= 3000;
  }
  // By hand: w = (0, 0, -9.81, r x mg) with r = (0, 0.05, 0.1), so the moment is (-0.05 * 9.81, 0, 0).
  static Torque payload_torque() { return (Torque() << 0, 0, -9.81, -0.4905, 0, 0, 0).finished(); }
  Torque tau_ext() const { return observed; }
  rme::Jacobian<double, 7> jacobian() const { return rme::Jacobian<double, 7>::Identity(); }
  rme::Matrix3<double> rotation() const { return rme::Matrix3<double>::Identity(); }
  Torque dq() const { return Torque::Zero(); }
  Torque nominal_torque() const { return Torque::Constant(0.5); }
  void command(const Torque& tau, rme::Status status) {
    commanded = tau;
    all_ok = all_ok && status == rme::Status::Ok;
  }

  void show(const rme::EstimatorState<double>& state) { shown = state; }

  rme::EstimatorState<double> shown;
  int tick = 0;
  Torque observed = Torque::Zero();
  Torque commanded = Torque::Zero();
  bool all_ok = true;
};

TEST_CASE("README: its host loop holds an unknown kilogram within 2 percent of its weight", "[docs]") {
  RestingArm arm;
  control(arm);
  CHECK(arm.all_ok);
  const RestingArm::Torque held = arm.nominal_torque() - RestingArm::payload_torque();
  CAPTURE(arm.commanded.transpose());
  CHECK((arm.commanded - held).norm() < 0.02 * 9.81);
  CHECK(std::abs(arm.shown.payload.mean[0] - 1) < 0.02);
  CHECK(arm.shown.event.kind == rme::EventKind::Attached);
  CHECK_FALSE(arm.shown.changing);
}

}  // namespace
