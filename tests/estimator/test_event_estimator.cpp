#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <functional>
#include <limits>
#include <random>
#include <rme/event_estimator.hpp>
#include <stdexcept>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/six_joint_arm.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "support/allocation_count.hpp"
#include "support/catch.hpp"

namespace {

using rme::Phase;
using rme::Status;
using rme::examples::box;
using rme::examples::panda;
using rme::examples::PoseImpedance;
using rme::examples::RigidBody;
using rme::examples::SyntheticArm;
using rme::examples::SyntheticArmConfig;
template <int Dofs>
using Sample = rme::Proprioception<double, Dofs>;

constexpr double kPeriod = 1e-3;
const Eigen::Vector3d kSize(0.06, 0.06, 0.1);
const RigidBody kFirst = box(1.1, {0.05, 0.02, 0.13}, kSize);
const RigidBody kSecond = box(0.6, {-0.04, 0.03, 0.1}, kSize);

/// An arm as it comes, sensing behind the gears: white noise and offsets, no friction in the torque.
template <int Dofs>
SyntheticArmConfig<Dofs> link_side(const rme::examples::ArmModel<Dofs>& model, std::uint64_t seed) {
  SyntheticArmConfig<Dofs> config = rme::examples::with_typical_faults(model, seed);
  config.friction = {};
  return config;
}

/// A host: an arm that holds a pose under the impedance law, and the estimator whose compensation it adds.
template <int Dofs>
class Host {
 public:
  using Estimator = rme::EventEstimator<double, Dofs>;
  using Config = rme::EventEstimatorConfig<double, Dofs>;

  Host(const rme::examples::ArmModel<Dofs>& model, const SyntheticArmConfig<Dofs>& faults, const Config& config = {})
      : arm(model, faults, model.ready), estimator(kPeriod, config), law_(model, model.ready), ramp_(kPeriod) {}

  Sample<Dofs> sample() const {
    return {arm.tau_ext(), arm.kinematics().jacobian, arm.kinematics().rotation, arm.dq()};
  }

  /// One tick after the other; a change of phase, an estimate and a rejection leave a letter in `story`.
  void run(double seconds) {
    for (const double end = arm.time() + seconds - 1e-9; arm.time() < end;) {
      samples.push_back(sample());
      const Phase before = estimator.phase();
      REQUIRE(estimator.update(samples.back()) == Status::Ok);
      if (estimator.phase() != before) story += rme::to_string(estimator.phase())[0];
      if (estimator.estimated()) estimates.push_back(estimator.estimate());
      if (estimator.rejected()) ++rejections;
      const auto& at = arm.kinematics();
      REQUIRE(ramp_.update(estimator.compensation(at.jacobian, at.rotation)) == Status::Ok);
      arm.step(law_.torque(arm.q(), arm.dq(), at, arm.dynamics()) + ramp_.torque());
    }
  }

  SyntheticArm<Dofs> arm;
  Estimator estimator;
  std::string story = "W";  ///< Watching, Collecting, Estimating: first letters
  std::vector<rme::Estimate<double>> estimates;
  int rejections = 0;
  std::vector<Sample<Dofs>> samples;  ///< all that the estimator has seen

 private:
  PoseImpedance<Dofs> law_;
  rme::CompensationRamp<double, Dofs> ramp_;
};

Eigen::Vector4d truth_of(const RigidBody& body) {
  return (Eigen::Vector4d() << body.mass, body.com).finished();
}

/// Within 20 g and 6 mm across gravity of the truth, which is what the torque of one pose tells with offsets of 0.1 and
/// 0.05 N m less the baseline, and within four of its own standard deviations in all four.
void check_close(const rme::Estimate<double>& estimate, const RigidBody& body, const Eigen::Matrix3d& rotation,
                 const Eigen::Vector3d& gravity = rme::standard_gravity<double>()) {
  const Eigen::Vector4d error = estimate.posterior.mean - truth_of(body);
  const Eigen::Vector3d down = (rotation.transpose() * gravity).normalized();
  const Eigen::Vector3d lever = error.tail<3>(), across = lever - down * down.dot(lever);
  const Eigen::Vector4d deviations = error.cwiseQuotient(estimate.posterior.standard_deviation());
  CAPTURE(error.transpose(), deviations.transpose());
  CHECK_FALSE(estimate.empty);
  CHECK(std::abs(error[0]) < 0.02);
  CHECK(across.norm() < 6e-3);
  CHECK(deviations.cwiseAbs().maxCoeff() < 4);
}

bool same(const rme::Estimate<double>& a, const rme::Estimate<double>& b) {
  return a.posterior.mean == b.posterior.mean && a.posterior.covariance == b.posterior.covariance &&
         a.empty == b.empty && a.detected_at == b.detected_at && a.window_begin == b.window_begin &&
         a.window_end == b.window_end;
}

TEST_CASE("Estimator: watches, collects, estimates and compensates; a second object adds up, and all go again",
          "[estimator]") {
  for (const std::uint64_t seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    Host<7> host(panda(), link_side(panda(), seed));
    host.run(1);
    CHECK(host.story == "W");
    CHECK(host.estimator.estimate().empty);
    const auto& at = host.arm.kinematics();
    CHECK(host.estimator.compensation(at.jacobian, at.rotation) == rme::JointVector<double, 7>::Zero());

    const int first = host.arm.attach(kFirst);
    host.run(3);
    REQUIRE(host.story == "WCEC");  // Watching, Collecting, Estimating, Compensating
    CHECK(host.estimator.phase() == Phase::Compensating);
    REQUIRE(host.estimates.size() == 1);
    check_close(host.estimates[0], kFirst, at.rotation);
    // Attached before the tick at 1.000 s, whose sample is still the old one: it shows 1 ms later, and the first 20 ms
    // are left out.
    CHECK(host.estimates[0].window_begin == Approx(1.021).margin(2.1e-3));
    CHECK(host.estimates[0].window_end - host.estimates[0].detected_at == Approx(0.2));
    CHECK(host.estimates[0].detected_at == host.estimator.detected_at());

    const int second = host.arm.attach(kSecond);
    host.run(3);
    REQUIRE(host.story == "WCECCEC");
    check_close(host.estimator.estimate(), kFirst + kSecond, at.rotation);

    host.arm.detach(first);
    host.run(3);
    REQUIRE(host.story == "WCECCECCEC");
    check_close(host.estimator.estimate(), kSecond, at.rotation);

    host.arm.detach(second);
    host.run(3);
    CHECK(host.story == "WCECCECCECCEW");
    CHECK(host.estimator.phase() == Phase::Watching);
    CHECK(host.estimator.estimate().empty);
    CHECK(host.estimator.estimate().posterior.mean == Eigen::Vector4d::Zero());
    CHECK(host.estimator.compensation(at.jacobian, at.rotation) == rme::JointVector<double, 7>::Zero());
    CHECK(host.estimates.size() == 4);
    CHECK(host.rejections == 0);
  }
}

TEST_CASE("Estimator: a push is rejected and leaves the estimate as it was", "[estimator]") {
  Host<7> host(panda(), link_side(panda(), 4));
  host.run(1);
  const auto push = [&](double seconds) {
    host.arm.push({{10, -8, 0}, Eigen::Vector3d::Zero()});
    host.run(seconds);
    host.arm.push({});
    host.run(2);
  };
  push(2);
  CHECK(host.estimates.empty());
  CHECK(host.rejections >= 1);
  CHECK(host.estimator.phase() == Phase::Watching);

  host.arm.attach(kFirst);
  host.run(2);
  REQUIRE(host.estimates.size() == 1);
  check_close(host.estimates[0], kFirst, host.arm.kinematics().rotation);
  const int before = host.rejections;
  push(2);
  CHECK(host.estimates.size() == 1);
  CHECK(host.rejections > before);
  CHECK(same(host.estimator.estimate(), host.estimates[0]));
  CHECK(host.estimator.phase() == Phase::Compensating);
}

TEST_CASE("Estimator: compensation is -J^T times the wrench of the estimate, wherever the arm is", "[estimator]") {
  // J^T [m g ; (R r) x (m g)], written out.
  Host<7> host(panda(), link_side(panda(), 5));
  host.run(1);
  host.arm.attach(kFirst);
  host.run(1.5);
  REQUIRE(host.estimates.size() == 1);
  const Eigen::Vector4d mean = host.estimates[0].posterior.mean;
  const Eigen::Vector3d weight(0, 0, -9.81 * mean[0]), com = mean.tail<3>();
  for (const double turn : {0.0, 0.4, -0.7}) {
    const auto at = panda().kinematics(panda().ready.array() + turn);
    rme::Vector6<double> wrench;
    wrench << weight, (at.rotation * com).cross(weight);
    const rme::JointVector<double, 7> expected = -at.jacobian.transpose() * wrench;
    CHECK((host.estimator.compensation(at.jacobian, at.rotation) - expected).norm() < 1e-12);
    CHECK(expected.norm() > 1);
  }
}

TEST_CASE("Estimator: a push that has been there from the start does not spoil all that follows", "[estimator]") {
  // What was quiet before its end is taken for the empty hand, and the empty hand that follows for another push.
  Host<7> host(panda(), link_side(panda(), 20));
  host.arm.push({{10, -8, 3}, Eigen::Vector3d::Zero()});
  host.run(1.5);
  host.arm.push({});
  host.run(2);
  int handle = host.arm.attach(kFirst);
  host.run(2);
  host.arm.detach(handle);
  host.run(2);
  handle = host.arm.attach(kSecond);
  host.run(2);
  check_close(host.estimator.estimate(), kSecond, host.arm.kinematics().rotation);
  host.arm.detach(handle);
  host.run(2);
  CHECK(host.estimator.phase() == Phase::Watching);
}

/// The samples of a run in which an object comes, another joins it, both go, and somebody pushes.
std::vector<Sample<7>> recording(std::uint64_t seed) {
  Host<7> host(panda(), link_side(panda(), seed));
  host.run(0.8);
  const int first = host.arm.attach(kFirst);
  host.run(1.5);
  host.arm.push({{10, -8, 0}, Eigen::Vector3d::Zero()});
  host.run(1.5);
  host.arm.push({});
  host.run(1.5);
  host.arm.detach(first);
  host.run(1.5);
  REQUIRE(host.estimates.size() == 2);
  REQUIRE(host.rejections > 0);
  return host.samples;
}

TEST_CASE("Estimator: bad samples are named and leave no trace", "[estimator]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const unsigned seed = 120;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  struct Spoilt {
    const char* what;
    std::function<void(Sample<7>&)> spoil;
    Status expected;
  };
  const std::vector<Spoilt> bad = {
      {"NaN torque", [&](Sample<7>& s) { s.tau_ext[2] = nan; }, Status::NonFiniteInput},
      {"infinite torque", [&](Sample<7>& s) { s.tau_ext[0] = -infinity; }, Status::NonFiniteInput},
      {"enormous torque", [&](Sample<7>& s) { s.tau_ext[1] = 1e308; }, Status::NonFiniteInput},
      {"NaN Jacobian", [&](Sample<7>& s) { s.jacobian(3, 4) = nan; }, Status::NonFiniteInput},
      {"infinite velocity", [&](Sample<7>& s) { s.dq[6] = infinity; }, Status::NonFiniteInput},
      {"NaN rotation", [&](Sample<7>& s) { s.rotation(1, 1) = nan; }, Status::NonFiniteInput},
      {"scaled rotation", [&](Sample<7>& s) { s.rotation *= 1.1; }, Status::NotARotation},
      {"mirror", [&](Sample<7>& s) { s.rotation.col(2) *= -1; }, Status::NotARotation},
  };
  rme::EventEstimator<double, 7> estimator(kPeriod), twin(kPeriod);
  std::vector<int> ticks_in(4);  // by phase: the bad samples must have met each
  for (const Sample<7>& good : recording(6)) {
    const bool spoilt = random() % 3 == 0;
    if (spoilt) {
      const Spoilt& which = bad[random() % bad.size()];
      CAPTURE(which.what);
      Sample<7> sample = good;
      which.spoil(sample);
      const double time = estimator.time();
      REQUIRE(estimator.update(sample) == which.expected);
      REQUIRE(estimator.time() == time);
      ++ticks_in[static_cast<std::size_t>(estimator.phase())];
    }
    REQUIRE(estimator.phase() == twin.phase());
    REQUIRE(estimator.update(good) == Status::Ok);
    REQUIRE(twin.update(good) == Status::Ok);
    REQUIRE(estimator.phase() == twin.phase());
    REQUIRE(estimator.rejected() == twin.rejected());
    REQUIRE(same(estimator.estimate(), twin.estimate()));
  }
  for (const Phase phase : {Phase::Watching, Phase::Collecting, Phase::Compensating})
    CHECK(ticks_in[static_cast<std::size_t>(phase)] > 0);
}

TEST_CASE("Estimator: numbers that no arm has never become a NaN in the compensation", "[estimator]") {
  rme::EventEstimator<double, 7> estimator(kPeriod);
  const auto samples = recording(6);
  const unsigned seed = 121;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> exponent(-300, 300);
  int estimates = 0;
  for (int round = 0; round < 20; ++round) {
    for (const Sample<7>& good : samples) {
      Sample<7> sample = good;
      if (random() % 300 == 0) sample.tau_ext[static_cast<int>(random() % 7)] *= std::pow(10.0, exponent(random));
      if (random() % 300 == 0) sample.jacobian *= std::pow(10.0, exponent(random));
      if (random() % 300 == 0) sample.dq *= std::pow(10.0, exponent(random));
      if (random() % 300 == 0) estimator.trigger();
      (void)estimator.update(sample);  // some are refused, some are not
      estimates += estimator.estimated();
      REQUIRE(estimator.compensation(good.jacobian, good.rotation).allFinite());
      REQUIRE(estimator.estimate().posterior.mean.allFinite());
      REQUIRE(estimator.estimate().posterior.covariance.allFinite());
    }
  }
  CHECK(estimates > 20);
}

TEST_CASE("Estimator: an arm that reports the reaction torque gets the same estimates", "[estimator]") {
  rme::EventEstimatorConfig<double, 7> config;
  config.torque_sign = rme::TorqueSign::Reaction;
  rme::EventEstimator<double, 7> external(kPeriod), reaction(kPeriod, config);
  int estimates = 0;
  for (Sample<7> sample : recording(7)) {
    REQUIRE(external.update(sample) == Status::Ok);
    sample.tau_ext *= -1;
    REQUIRE(reaction.update(sample) == Status::Ok);
    REQUIRE(reaction.phase() == external.phase());
    REQUIRE(same(reaction.estimate(), external.estimate()));
    if (reaction.estimated()) ++estimates;
  }
  CHECK(estimates == 2);
}

TEST_CASE("Estimator: watching the norm alone, it notices an object's weight as well", "[estimator]") {
  rme::EventEstimatorConfig<double, 7> config;
  config.watch_norm = true;
  Host<7> host(panda(), link_side(panda(), 8), config);
  host.run(1);
  host.arm.attach(kFirst);
  host.run(2);
  REQUIRE(host.estimates.size() == 1);
  check_close(host.estimates[0], kFirst, host.arm.kinematics().rotation);
}

TEST_CASE("Estimator: a host that knows when the gripper closes needs no detector", "[estimator]") {
  const RigidBody light = box(0.1, {0, 0, 0.1}, kSize);  // about 0.56 N m: below the detector's threshold
  for (const RigidBody& body : {light, kFirst}) {
    CAPTURE(body.mass);
    Host<7> host(panda(), link_side(panda(), 8)), without(panda(), link_side(panda(), 8));
    host.run(1);
    host.estimator.trigger();
    CHECK(host.estimator.phase() == Phase::Collecting);
    host.run(0.05);  // the gripper takes its time
    host.arm.attach(body);
    host.run(0.5);
    REQUIRE(host.estimates.size() == 1);
    const auto& estimate = host.estimates[0];
    check_close(estimate, body, host.arm.kinematics().rotation);
    // Triggered after the sample of 0.999 s, the 1000th. What came before the weight is left out, and so are the 20 ms
    // (onset_guard) after it.
    CHECK(estimate.detected_at == Approx(1));
    CHECK(estimate.window_end == Approx(1.2));
    CHECK(estimate.window_begin == Approx(1.071).margin(1.1e-3));

    without.run(1.05);
    without.arm.attach(body);
    without.run(0.7);
    CHECK(without.estimates.size() == (body.mass > 1 ? 1u : 0u));
  }
}

TEST_CASE("Estimator: once tared, an estimate does not depend on the sensor's offset", "[estimator]") {
  // An offset of the shape of a weight: with J_v^T g of 5.6 N m per kilogram, 0.5 N m pass for 89 g at rest; tau_ext
  // shows it with a minus sign. Without a baseline part of that is in the estimate (the sensor model and the arm's
  // motion speak against the rest), after tare() nothing but what 500 samples leave of the noise.
  const auto at = panda().kinematics(panda().ready);
  const rme::JointVector<double, 7> pull = at.jacobian.topRows<3>().transpose() * rme::standard_gravity<double>();
  REQUIRE(pull.norm() == Approx(5.6).margin(0.05));
  const auto mass = [&](double offset, bool tared) {
    SyntheticArmConfig<7> faults = link_side(panda(), 9);
    faults.torque_offset = offset * pull.normalized();
    rme::EventEstimatorConfig<double, 7> config;
    config.baseline = 0;  // none is learned unless by tare()
    Host<7> host(panda(), faults, config);
    host.run(1);
    if (tared) host.estimator.tare(0.5);
    host.arm.attach(kFirst);
    host.run(1.2);
    REQUIRE(host.estimates.size() == 1);
    if (tared) check_close(host.estimates[0], kFirst, host.arm.kinematics().rotation);
    return host.estimates[0].posterior.mean[0];
  };
  const double untared_shift = mass(0.5, false) - mass(0, false), tared_shift = mass(0.5, true) - mass(0, true);
  CHECK(untared_shift < -0.015);
  CHECK(untared_shift > -0.089);
  CHECK(std::abs(tared_shift) < 0.001);
}

TEST_CASE("Estimator: works on an arm that hangs on a wall", "[estimator]") {
  // The base's z axis is horizontal: gravity, in the arm's own world axes, points along -x.
  rme::examples::ArmModel<7> wall = panda();
  wall.gravity_vector << -9.81, 0, 0;
  rme::EventEstimatorConfig<double, 7> config;
  config.gravity = wall.gravity_vector;
  Host<7> host(wall, link_side(wall, 10), config);
  host.run(1);
  const int handle = host.arm.attach(kFirst);
  host.run(2);
  REQUIRE(host.estimates.size() == 1);
  const auto& at = host.arm.kinematics();
  check_close(host.estimates[0], kFirst, at.rotation, wall.gravity_vector);
  const Eigen::Vector4d mean = host.estimates[0].posterior.mean;
  const Eigen::Vector3d weight(-9.81 * mean[0], 0, 0);
  rme::Vector6<double> wrench;
  wrench << weight, (at.rotation * mean.tail<3>()).cross(weight);
  CHECK((host.estimator.compensation(at.jacobian, at.rotation) + at.jacobian.transpose() * wrench).norm() < 1e-12);
  host.arm.detach(handle);
  host.run(2);
  CHECK(host.estimator.estimate().empty);
}

TEST_CASE("Estimator: works on a six-joint arm", "[estimator]") {
  const auto& model = rme::examples::six_joint_arm();
  Host<6> host(model, link_side(model, 11));
  host.run(1);
  const int handle = host.arm.attach(kFirst);
  host.run(2);
  REQUIRE(host.story == "WCEC");
  check_close(host.estimates[0], kFirst, host.arm.kinematics().rotation);
  host.arm.detach(handle);
  host.run(2);
  CHECK(host.story == "WCECCEW");
}

TEST_CASE("Estimator: after reset it is as new", "[estimator]") {
  const auto samples = recording(12);
  rme::EventEstimator<double, 7> used(kPeriod), fresh(kPeriod);
  used.tare(0.1);
  // Interrupted wherever it was: in the middle of a collection, compensating, after a push.
  for (const std::size_t stop : {std::size_t(1200), std::size_t(2000), std::size_t(4000), samples.size()}) {
    CAPTURE(stop);
    for (std::size_t k = 0; k < stop; ++k) REQUIRE(used.update(samples[k]) == Status::Ok);
    used.reset();
    fresh = rme::EventEstimator<double, 7>(kPeriod);
    CHECK(used.time() == 0);
    CHECK(used.detected_at() == 0);
    CHECK(used.verdict().payload == 0);
    for (const Sample<7>& sample : samples) {
      REQUIRE(used.update(sample) == Status::Ok);
      REQUIRE(fresh.update(sample) == Status::Ok);
      REQUIRE(used.phase() == fresh.phase());
      REQUIRE(same(used.estimate(), fresh.estimate()));
    }
    used.reset();
  }
}

TEST_CASE("Estimator: the prior source is told how many samples have settled, and what it says in vain is not used",
          "[estimator]") {
  // A prior of 1 mg and 1 um of doubt says what the estimate is, whatever the torque. One tick early it says 2 kg.
  struct Certain {
    std::vector<std::size_t>* counts;
    rme::PayloadGaussian<double> operator()(const rme::SampleWindow<double, 7>&, std::size_t n) const noexcept {
      counts->push_back(n);
      const bool in_vain = std::count(counts->begin(), counts->end(), 200u) == 1;
      return rme::PayloadGaussian<double>::independent({in_vain ? 2 : 1.12, 0.04, 0.03, 0.12},
                                                       {1e-6, 1e-6, 1e-6, 1e-6});
    }
  };
  const auto samples = recording(13);
  for (const double refresh : {0.0, 0.01}) {
    std::vector<std::size_t> counts;
    rme::EventEstimatorConfig<double, 7> config;
    config.refresh = refresh;
    rme::EventEstimator<double, 7, Certain> estimator(kPeriod, config, Certain{&counts});
    for (std::size_t k = 0; k < samples.size() && !estimator.estimated(); ++k) {
      REQUIRE(estimator.update(samples[k]) == Status::Ok);
      CHECK((!estimator.refreshed() || refresh > 0));
    }
    REQUIRE(estimator.estimated());
    CHECK((estimator.estimate().posterior.mean - Eigen::Vector4d(1.12, 0.04, 0.03, 0.12)).norm() < 1e-5);
    REQUIRE_FALSE(counts.empty());
    CHECK(counts.back() == 200);
    if (refresh > 0) {
      CHECK(counts.front() == 0);  // before the change has settled
      CHECK(std::is_sorted(counts.begin(), counts.end()));
    } else {
      CHECK(counts.size() == 2);
    }
  }
}

TEST_CASE("Estimator: 60 ms after a sharp change most of the payload is carried, and what is said of it is early",
          "[estimator]") {
  for (const std::uint64_t seed : {15u, 16u, 17u}) {
    CAPTURE(seed);
    Host<7> host(panda(), link_side(panda(), seed));
    host.run(1);
    const int handle = host.arm.attach(kFirst);
    host.run(0.06);
    REQUIRE(host.estimates.empty());
    const auto early = host.estimator.estimate();
    CHECK_FALSE(early.final);
    CHECK_FALSE(early.empty);
    CHECK(early.confidence > 0.95);
    CHECK(early.confidence < 1);
    CHECK(std::abs(early.posterior.mean[0] - kFirst.mass) < 0.05 * kFirst.mass);
    CHECK(early.detected_at == Approx(1.006).margin(5e-3));
    CHECK(early.window_begin == Approx(1.021).margin(2.1e-3));
    const auto& at = host.arm.kinematics();
    const auto needed = rme::compensation_torque<double, 7>({kFirst.mass, kFirst.com}, at.jacobian, at.rotation);
    CHECK((host.estimator.compensation(at.jacobian, at.rotation) - needed).norm() < 0.1 * needed.norm());

    host.run(2);
    REQUIRE(host.estimates.size() == 1);
    CHECK(host.estimator.estimate().final);
    CHECK(host.estimator.estimate().confidence == 1);

    host.arm.detach(handle);  // and 60 ms after it has gone nothing is carried any more
    host.run(0.06);
    CHECK_FALSE(host.estimator.estimate().final);
    CHECK(host.estimator.estimate().empty);
    CHECK(host.estimator.compensation(at.jacobian, at.rotation).norm() < 0.01 * needed.norm());
  }
}

TEST_CASE("Estimator: a slow change after a triggered one is followed as any", "[estimator]") {
  Host<7> host(panda(), link_side(panda(), 21));
  host.run(1);
  host.estimator.trigger();
  host.arm.attach(kFirst);
  host.run(1.5);
  REQUIRE(host.estimates.size() == 1);
  host.arm.attach(kSecond, 1.0);
  host.run(0.8);
  CHECK_FALSE(host.estimator.estimate().final);
  CHECK(std::abs(host.estimator.estimate().posterior.mean[0] - host.arm.payload().mass) < 0.15);
}

TEST_CASE("Estimator: a payload that comes slowly is followed while it comes", "[estimator]") {
  for (const double ramp : {0.5, 1.0, 2.0}) {
    CAPTURE(ramp);
    Host<7> host(panda(), link_side(panda(), 18));
    host.run(1);
    host.arm.attach(kFirst, ramp);
    double worst = 0;
    for (int k = 0; k < 100; ++k) {
      host.run(ramp / 100);
      // Known are the last 100 ms, half of which is old; noticed is a tenth of the payload, and believed 100 ms later.
      const double late = 0.15 / ramp, share = host.arm.payload().mass / kFirst.mass;
      if (share > 0.15 + 2 * late && share < 1)
        worst = std::max(worst, host.arm.payload().mass - host.estimator.estimate().posterior.mean[0]);
    }
    CHECK(worst < 0.15 / ramp * kFirst.mass + 0.03);
    host.run(1.5);
    REQUIRE(host.estimates.size() == 1);
    check_close(host.estimator.estimate(), kFirst, host.arm.kinematics().rotation);
  }
}

TEST_CASE("Estimator: a verdict with less than the odds asked for is a rejection", "[estimator]") {
  for (const bool sceptical : {false, true}) {
    rme::EventEstimatorConfig<double, 7> config;
    config.odds = sceptical ? 1e6 : 0;
    Host<7> host(panda(), link_side(panda(), 20), config);
    host.run(1);
    host.arm.attach(kFirst);
    host.run(0.7);
    CHECK(host.estimates.size() == (sceptical ? 0u : 1u));
    CHECK(host.rejections == (sceptical ? 1 : 0));
    CHECK(host.estimator.estimate().empty == sceptical);  // the early estimates are taken back
  }
}

TEST_CASE("Estimator: a push that grows and fades is not carried for a moment", "[estimator]") {
  const std::uint64_t seed = 19;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  for (int k = 0; k < 10; ++k) {
    CAPTURE(k);
    Host<7> host(panda(), link_side(panda(), seed + static_cast<unsigned>(k)));
    const Eigen::Vector3d force =
        15 * Eigen::Vector3d(normal(random), normal(random), 0.3 * normal(random)).normalized();
    host.run(1);
    double carried = 0;
    for (int step = 0; step < 100; ++step) {
      host.arm.push({std::pow(std::sin(M_PI * step / 100), 2) * force, Eigen::Vector3d::Zero()});
      host.run(0.01);
      const auto& at = host.arm.kinematics();
      carried = std::max(carried, host.estimator.compensation(at.jacobian, at.rotation).norm());
    }
    host.arm.push({});
    host.run(1);
    CHECK(carried == 0);
    CHECK(host.estimates.empty());
  }
}

#ifdef RME_COUNTS_ALLOCATIONS
TEST_CASE("Estimator: allocates nothing once it is made", "[estimator]") {
  const auto samples = recording(14);
  const int before_any = rme::testing::allocations();
  rme::EventEstimator<double, 7> estimator(kPeriod);
  REQUIRE(rme::testing::allocations() > before_any);  // the counter counts
  rme::JointVector<double, 7> sum = rme::JointVector<double, 7>::Zero();
  int estimates = 0, failures = 0;
  const int before = rme::testing::allocations();
  for (int round = 0; round < 2; ++round) {
    for (std::size_t k = 0; k < samples.size(); ++k) {
      if (k == 700) estimator.tare(0.5);
      if (k == 5000) estimator.trigger();
      failures += estimator.update(samples[k]) != Status::Ok;
      estimates += estimator.estimated();
      sum += estimator.compensation(samples[k].jacobian, samples[k].rotation);
    }
    estimator.reset();
  }
  const int during = rme::testing::allocations() - before;
  CHECK(during == 0);
  CHECK(failures == 0);
  CHECK(estimates >= 4);
  CHECK(sum.allFinite());
}
#endif

TEST_CASE("Estimator: a setting out of range is refused by name", "[estimator]") {
  using Config = rme::EventEstimatorConfig<double, 7>;
  const double nan = std::numeric_limits<double>::quiet_NaN();
  const auto with = [](const std::function<void(Config&)>& change) {
    Config config;
    change(config);
    rme::EventEstimator<double, 7> estimator(kPeriod, config);
  };
  CHECK_NOTHROW(with([](Config&) {}));
  for (const double bad : {0.0, -1.0, nan}) {
    CAPTURE(bad);
    CHECK_THROWS_WITH((rme::EventEstimator<double, 7>(bad)), contains("Estimator::dt"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.collection = bad; }), contains("EventEstimatorConfig::collection"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.onset_span = bad; }), contains("EventEstimatorConfig::onset_span"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.onset_jump = bad; }), contains("EventEstimatorConfig::onset_jump"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.early_window = bad; }), contains("EventEstimatorConfig::early_window"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.gentle_window = bad; }), contains("EventEstimatorConfig::gentle_window"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.early_excess = bad; }), contains("EventEstimatorConfig::early_excess"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.unrest = bad; }), contains("EventEstimatorConfig::unrest"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.detector.window = bad; }), contains("MismatchDetectorConfig::window"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.push.force = bad; }), contains("PushPrior::force"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.sensors[1].noise[2] = bad; }), contains("SensorModel::noise"));
  }
  for (const double bad : {-1.0, nan}) {
    CAPTURE(bad);
    CHECK_THROWS_WITH(with([=](Config& c) { c.baseline = bad; }), contains("EventEstimatorConfig::baseline:"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.baseline_guard = bad; }),
                      contains("EventEstimatorConfig::baseline_guard"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.onset_guard = bad; }), contains("EventEstimatorConfig::onset_guard"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.refresh = bad; }), contains("EventEstimatorConfig::refresh"));
    CHECK_THROWS_WITH(with([=](Config& c) { c.gyration_radius = bad; }),
                      contains("EventEstimatorConfig::gyration_radius"));
  }
  CHECK_THROWS_WITH(with([=](Config& c) { c.odds = nan; }), contains("EventEstimatorConfig::odds"));
  CHECK_THROWS_WITH(with([=](Config& c) { c.early_odds = nan; }), contains("EventEstimatorConfig::early_odds"));
  CHECK_THROWS_WITH(with([](Config& c) { c.gravity.setZero(); }), contains("EventEstimatorConfig::gravity"));
  CHECK_THROWS_WITH(with([=](Config& c) { c.gravity[1] = nan; }), contains("EventEstimatorConfig::gravity"));
  CHECK_THROWS_WITH(with([](Config& c) { c.sensors.clear(); }), contains("EventEstimatorConfig::sensors"));
  // What the collection, the baseline and the detector look back to must be kept.
  CHECK_THROWS_WITH(with([](Config& c) { c.window.duration = 0.7; }), contains("SampleWindowConfig::duration"));
  CHECK_THROWS_WITH(with([](Config& c) { c.collection = 1.2; }), contains("SampleWindowConfig::duration"));
  CHECK_THROWS_WITH(with([](Config& c) { c.baseline = 1.2; }), contains("SampleWindowConfig::duration"));
}

using Estimator7 = rme::EventEstimator<double, 7>;
static_assert(noexcept(std::declval<Estimator7&>().update(std::declval<const Sample<7>&>())));
static_assert(noexcept(std::declval<Estimator7&>().trigger()));
static_assert(noexcept(std::declval<Estimator7&>().tare(1.0)));
static_assert(noexcept(std::declval<Estimator7&>().reset()));
static_assert(noexcept(std::declval<const Estimator7&>().compensation(std::declval<const rme::Jacobian<double, 7>&>(),
                                                                      std::declval<const rme::Matrix3<double>&>())));
static_assert(noexcept(std::declval<const Estimator7&>().phase()));
static_assert(noexcept(std::declval<const Estimator7&>().estimate()));
static_assert(noexcept(std::declval<const Estimator7&>().estimated()));
static_assert(noexcept(std::declval<const Estimator7&>().rejected()));
static_assert(noexcept(std::declval<const Estimator7&>().verdict()));
static_assert(noexcept(std::declval<const Estimator7&>().time()));

}  // namespace
