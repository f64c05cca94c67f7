#include <cmath>
#include <functional>
#include <limits>
#include <rme/core/compensation.hpp>
#include <rme/estimator.hpp>
#include <string>
#include <vector>

#include "robustness/bad_numbers.hpp"
#include "support/held_arm.hpp"

namespace {

using rme::Status;
using rme::testing::below;
using rme::testing::entries_of;
using rme::testing::HeldArm;
using rme::testing::Random;
using Tick = rme::Proprioception<double, 7>;
using Torque = rme::JointVector<double, 7>;

const rme::Payload<double> kObject = {1.1, {0.05, 0.02, 0.13}};

/// All that an estimator says: numbers that have to be finite.
template <typename Scalar>
Eigen::VectorXd answers(const rme::Estimator<Scalar, 7>& estimator, const rme::Proprioception<Scalar, 7>& at) {
  const rme::EstimatorState<Scalar>& state = estimator.state();
  const rme::ContactState<Scalar, 7>& contact = estimator.contact();
  Eigen::Matrix<double, 234, 1> all;
  all << state.payload.mean.template cast<double>(),
      Eigen::Map<const Eigen::Matrix<Scalar, 16, 1>>(state.payload.covariance.data()).template cast<double>(),
      state.inertial.mean.template cast<double>(),
      Eigen::Map<const Eigen::Matrix<Scalar, 100, 1>>(state.inertial.covariance.data()).template cast<double>(),
      estimator.compensation(at.jacobian, at.rotation).template cast<double>(),
      Eigen::Map<const Eigen::Matrix<Scalar, 5, 1>>(state.probability.values.data()).template cast<double>(),
      double(state.held), double(state.confidence), double(state.health), double(state.friction_shows()), state.time,
      state.updated, double(state.changing), state.change_onset, state.change_noticed, double(state.event.number),
      double(state.event.kind), state.event.onset, state.event.noticed, state.event.over, double(contact.ready),
      double(contact.contact), double(contact.statistic), contact.residual.template cast<double>(),
      contact.variance.template cast<double>(), contact.threshold.template cast<double>(),
      contact.wrench.vector().template cast<double>(),
      Eigen::Map<const Eigen::Matrix<Scalar, 36, 1>>(contact.wrench_covariance.data()).template cast<double>(),
      contact.link.template cast<double>(), double(contact.last.number), double(contact.last.cause), contact.last.onset,
      contact.last.over, double(contact.last.peak_force);
  return all;
}

TEST_CASE("Estimator: a refused tick might as well not have been, whatever is going on", "[robustness]") {
  const unsigned seed = 20;
  CAPTURE(seed);
  Random random(seed);
  HeldArm arm(seed);
  rme::Estimator<double, 7> estimator(HeldArm::kPeriod), twin(HeldArm::kPeriod);
  int refused = 0, accepted = 0;
  for (int k = 0; k < 12000; ++k) {
    CAPTURE(k);
    if (k % 3000 == 1000) arm.hold(kObject);
    if (k % 3000 == 2200) arm.hold({});
    const Tick& good = arm.tick();
    if (below(random, 10) == 0) {
      Tick bad = good;
      if (below(random, 4) == 0) bad.motion.emplace();
      auto entries = entries_of(bad.tau_ext, bad.jacobian, bad.rotation, bad.dq);
      if (below(random, 8) == 0) {
        bad.compensation.emplace().setOnes();
        entries = entries_of(*bad.compensation);
      } else if (below(random, 8) == 0) {
        bad.gravity_torque.emplace().setOnes();
        entries = entries_of(*bad.gravity_torque);
      } else if (bad.motion) {
        entries =
            entries_of(bad.motion->angular_velocity, bad.motion->linear_acceleration, bad.motion->angular_acceleration);
      }
      rme::testing::spoil(entries, random);
      REQUIRE(estimator.compensation(bad.jacobian, bad.rotation).allFinite());
      const Status status = estimator.update(bad);
      CAPTURE(to_string(status));
      if (status == Status::Ok || status == Status::NotAMeasurement) {  // of the latter, the time counts
        ++accepted;
        REQUIRE(twin.update(bad) == status);
      } else {
        ++refused;
      }
      REQUIRE(answers(estimator, good).allFinite());
      REQUIRE(answers(estimator, good) == answers(twin, good));
    }
    REQUIRE(estimator.update(good) == Status::Ok);
    REQUIRE(twin.update(good) == Status::Ok);
    REQUIRE(answers(estimator, good).allFinite());
    REQUIRE(answers(estimator, good) == answers(twin, good));
  }
  CHECK(refused > 500);
  CHECK(accepted > 100);
  CHECK(estimator.state().event.number > 2);
}

TEST_CASE("Estimator: before the first sample, and for an invalid pose, the compensation is finite", "[robustness]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  HeldArm arm(21);
  const Tick first = arm.tick();
  rme::Estimator<double, 7> estimator(HeldArm::kPeriod);
  const rme::Jacobian<double, 7> bad = rme::Jacobian<double, 7>::Constant(nan);
  CHECK(estimator.compensation(bad, first.rotation) == Torque::Zero());
  // The first sample has no predecessor: nothing of it may last that a later one cannot undo.
  Tick enormous = first;
  enormous.jacobian *= 1e200;
  enormous.dq.setConstant(1e200);
  CHECK(estimator.update(enormous) == Status::NonFiniteInput);
  for (int k = 0; k < 1000; ++k) REQUIRE(estimator.update(arm.tick()) == Status::Ok);
  arm.hold(kObject);
  for (int k = 0; k < 1000; ++k) REQUIRE(estimator.update(arm.tick()) == Status::Ok);
  const Torque carried = estimator.compensation(first.jacobian, first.rotation);
  CHECK(carried.norm() > 1);
  CHECK(estimator.compensation(bad, first.rotation) == carried);
  CHECK(estimator.compensation(first.jacobian, nan * first.rotation) == carried);
  CHECK(estimator.compensation(1e300 * first.jacobian, first.rotation) == carried);
}

/// What becomes of a good tick while a fault lasts; nothing if the tick is lost.
struct Fault {
  std::string what;
  int ticks;
  std::function<bool(Tick& tick, const Tick& before)> spoil;
};

const std::vector<Fault>& faults() {
  static const std::vector<Fault> all = {
      {"lost samples", 100, [](Tick&, const Tick&) { return false; }},
      {"repeated samples", 300, [](Tick& tick, const Tick& before) { return tick = before, true; }},
      {"torque freezes", 1000, [](Tick& tick, const Tick& before) { return tick.tau_ext = before.tau_ext, true; }},
      {"torque of joint 2 saturates", 800, [](Tick& tick, const Tick&) { return tick.tau_ext[1] = 87, true; }},
      {"all torques read zero", 800, [](Tick& tick, const Tick&) { return tick.tau_ext.setZero(), true; }},
      {"one sample of 100 times the range", 1, [](Tick& tick, const Tick&) { return tick.tau_ext *= 1e4, true; }},
      {"a step to 100 times the range", 200,
       [](Tick& tick, const Tick&) { return tick.tau_ext.setConstant(8700), true; }},
      {"velocities of 100 times the range", 200,
       [](Tick& tick, const Tick&) { return tick.dq.setConstant(200), true; }},
      {"Jacobian of zeros", 300, [](Tick& tick, const Tick&) { return tick.jacobian.setZero(), true; }},
      {"Jacobian of rank one", 300,
       [](Tick& tick, const Tick&) {
         tick.jacobian = (tick.jacobian.col(1) * Torque::Ones().transpose()).eval();
         return true;
       }},
      {"denormals", 300,
       [](Tick& tick, const Tick&) {
         tick.tau_ext *= 1e-310;
         tick.dq.setConstant(std::numeric_limits<double>::denorm_min());
         return true;
       }},
      {"rotation off by one percent", 300, [](Tick& tick, const Tick&) { return tick.rotation *= 1.01, true; }},
      {"NaN for a second", 1000, [](Tick& tick, const Tick&) { return tick.tau_ext[3] = std::nan(""), true; }},
  };
  return all;
}

/// The fault sets in at a random instant of an event's life; then, with the hand empty and the arm left alone for three
/// seconds, an object comes.
/// @return the error of the mass [kg]
template <typename Scalar>
double mass_error_after(const Fault& fault, unsigned seed) {
  Random random(seed);
  HeldArm arm(seed);
  rme::Estimator<Scalar, 7> estimator(HeldArm::kPeriod);
  rme::CompensationRamp<Scalar, 7> ramp{Scalar(HeldArm::kPeriod)};
  const int begin = 900 + static_cast<int>(below(random, 2000));
  const rme::Vector3<Scalar> widest = Scalar(2.001) * rme::PayloadPrior<Scalar>::of(Scalar(3)).com_std;
  rme::JointVector<Scalar, 7> commanded = ramp.torque();
  Tick before = arm.tick();
  for (int k = 0; k < 9000; ++k) {
    CAPTURE(k);
    if (k == 1000 || k == 7500) arm.hold(kObject);
    if (k == 2500) arm.hold({});
    const Tick& good = arm.tick();
    Tick tick = good;
    if (k < begin) before = good;
    if (k >= begin && k < begin + fault.ticks && !fault.spoil(tick, before)) continue;
    rme::Proprioception<Scalar, 7> in;
    in.tau_ext = tick.tau_ext.template cast<Scalar>();
    in.jacobian = tick.jacobian.template cast<Scalar>();
    in.rotation = tick.rotation.template cast<Scalar>();
    in.dq = tick.dq.template cast<Scalar>();
    (void)estimator.update(in);
    REQUIRE(answers(estimator, in).allFinite());
    REQUIRE((estimator.state().payload.standard_deviation().template tail<3>().array() <= widest.array()).all());
    REQUIRE(ramp.update(estimator.compensation(in.jacobian, in.rotation)) == Status::Ok);
    REQUIRE((ramp.torque() - commanded).cwiseAbs().maxCoeff() <= Scalar(0.5001));
    commanded = ramp.torque();
  }
  return std::abs(static_cast<double>(estimator.state().payload.mean[0]) - kObject.mass);
}

TEMPLATE_TEST_CASE("Estimator: whatever the fault, three quiet seconds later an object weighs what it weighs",
                   "[robustness]", float, double) {
  for (const Fault& fault : faults()) {
    for (unsigned seed = 30; seed < 33; ++seed) {
      CAPTURE(fault.what, seed);
      CHECK(mass_error_after<TestType>(fault, seed) < 0.05);
    }
  }
}

}  // namespace
