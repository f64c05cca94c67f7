#include <cmath>
#include <limits>
#include <random>
#include <rme/estimator.hpp>
#include <vector>

#include "realtime/life.hpp"
#include "support/catch.hpp"
#include "support/held_arm.hpp"

namespace {

using Eigen::Vector3d;
using rme::ContactCause;
using rme::Status;
using rme::testing::HeldArm;
using Contact = rme::ContactState<double, 7>;
using Sample = rme::Proprioception<double, 7>;

constexpr double kPeriod = HeldArm::kPeriod;

template <typename Scalar>
bool finite(const rme::ContactState<Scalar, 7>& c) {
  return c.residual.allFinite() && c.variance.allFinite() && c.threshold.allFinite() && c.link.allFinite() &&
         c.wrench.vector().allFinite() && c.wrench_covariance.allFinite() && std::isfinite(c.statistic) &&
         std::isfinite(c.last.peak_torque) && std::isfinite(c.last.peak_force);
}

bool same(const Contact& a, const Contact& b) {
  return a.ready == b.ready && a.contact == b.contact && a.statistic == b.statistic && a.residual == b.residual &&
         a.variance == b.variance && a.threshold == b.threshold && a.wrench.vector() == b.wrench.vector() &&
         a.wrench_covariance == b.wrench_covariance && a.link == b.link && a.last.number == b.last.number &&
         a.last.cause == b.last.cause && a.last.onset == b.last.onset && a.last.noticed == b.last.noticed &&
         a.last.over == b.last.over && a.last.peak_torque == b.last.peak_torque &&
         a.last.peak_force == b.last.peak_force;
}

/// As the arm is that is held: its torque contains no friction. Until an arm has moved, this is not known by itself.
rme::EstimatorConfig<double, 7> link_side(double false_alarms = 0.1) {
  rme::EstimatorConfig<double, 7> config;
  config.sensing = rme::Sensing::LinkSide;
  config.contact_false_alarms = false_alarms;
  return config;
}

/// An arm that is held, and an estimator that listens to it.
struct Bench {
  explicit Bench(unsigned seed, const rme::EstimatorConfig<double, 7>& config = link_side())
      : arm(seed), estimator(kPeriod, config) {}
  void run(double seconds) {
    for (int k = static_cast<int>(std::lround(seconds / kPeriod)); k > 0; --k) {
      REQUIRE(estimator.update(arm.tick()) == Status::Ok);
      REQUIRE(finite(contact()));
    }
  }
  const Contact& contact() const { return estimator.contact(); }
  double time() const { return estimator.state().time; }

  HeldArm arm;
  rme::Estimator<double, 7> estimator;
};

TEST_CASE("Contact: a push on what is carried is noticed within 20 ms, in size and place, and was no payload",
          "[contact]") {
  const unsigned seed = 400;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Bench bench(seed);
  bench.run(0.99);
  CHECK_FALSE(bench.contact().ready);
  bench.run(0.02);
  CHECK(bench.contact().ready);
  bench.run(1);
  bench.arm.hold({1.1, {0.05, 0.02, 0.13}});
  bench.run(3);
  REQUIRE_FALSE(bench.contact().contact);
  for (int i = 0; i < 6; ++i) {
    CAPTURE(i);
    const int number = bench.contact().last.number;
    Vector3d force{normal(random), normal(random), normal(random)};
    force *= 8 / force.norm();
    const double onset = bench.time();
    bench.arm.push({force, Vector3d::Zero()});
    bench.run(0.15);
    const Contact at = bench.contact();
    CHECK(at.contact);
    REQUIRE(at.last.number == number + 1);
    CHECK(at.last.noticed > onset);
    CHECK(at.last.noticed < onset + 0.0205);
    CHECK(at.last.onset <= at.last.noticed);
    CHECK(at.last.onset > onset - 0.02);
    CHECK(at.last.over == 0);
    // All but exp(-150 / 20) has come through the observer. The force is within what its own covariance says, to five
    // deviations: its prior of 100 N and the mean that has not followed take a little.
    const Vector3d error = at.wrench.force - force;
    CAPTURE(error.transpose());
    CHECK(error.norm() < 2);
    CHECK(at.likeliest_link() == 7);
    bench.arm.push({});
    bench.run(1.5);
    CHECK_FALSE(bench.contact().contact);
    CHECK(bench.contact().likeliest_link() == 0);
    CHECK(bench.contact().last.number == number + 1);
    CHECK(bench.contact().last.over > onset + 0.15);
    CHECK(bench.contact().last.over < onset + 0.5);
    CHECK(bench.contact().last.cause == ContactCause::Contact);
    CHECK(bench.contact().last.peak_force == Approx(8).margin(2));
    CHECK(std::abs(bench.estimator.state().payload.mean[0] - 1.1) < 0.02);
  }
}

TEST_CASE("Contact: an object that comes, and one that goes, is a contact at first, and a payload in the end",
          "[contact]") {
  for (const unsigned seed : {410u, 411u, 412u}) {
    CAPTURE(seed);
    Bench bench(seed);
    bench.run(3);
    CHECK(bench.contact().last.number == 0);
    int number = 0;
    for (const double mass : {1.1, 0.0}) {
      CAPTURE(mass);
      const double onset = bench.time();
      bench.arm.hold({mass, {0.05, 0.02, 0.13}});
      bench.run(0.03);
      CHECK(bench.contact().contact);
      CHECK(bench.contact().last.noticed < onset + 0.0205);
      CHECK(bench.contact().last.cause == ContactCause::Undecided);
      bench.run(1.5);
      CHECK_FALSE(bench.contact().contact);
      CHECK(bench.contact().last.cause == ContactCause::Payload);
      CHECK(bench.contact().last.number > number);
      number = bench.contact().last.number;
    }
    // And nothing of it is left.
    bench.run(20);
    CHECK(bench.contact().last.number == number);
  }
}

TEST_CASE("Contact: a move with a payload is no contact", "[contact]") {
  const unsigned seed = 420;
  CAPTURE(seed);
  Bench bench(seed);
  bench.run(2);
  bench.arm.hold({1.1, {0.05, 0.02, 0.13}});
  bench.run(3);
  const int number = bench.contact().last.number;
  for (const double way : {0.3, -0.5, 0.4, -0.2}) {
    bench.arm.move(bench.arm.pose() + way * HeldArm::Vector::Ones(), 1.2);
    bench.run(2);
  }
  CHECK(bench.contact().last.number == number);
}

TEST_CASE("Contact: a payload that swings is no contact, and a push on it meanwhile is one", "[contact]") {
  const unsigned seed = 425;
  for (const double degrees : {5.0, 10.0, 20.0}) {
    CAPTURE(seed, degrees);
    Bench bench(seed);
    bench.run(2);
    bench.arm.hold({1, {0, 0, 0.1}});
    double t = 0;
    const auto swing = [&](double seconds, double push) {  // 20 cm below the hand
      for (const double end = t + seconds; t < end; t += kPeriod) {
        const double pi = std::acos(-1.0), angle = degrees * pi / 180 * std::cos(2 * pi * 1.1 * t);
        const double sideways = 9.81 * std::sin(angle) * std::cos(angle), down = -9.81 * std::pow(std::sin(angle), 2);
        bench.arm.push({{sideways, push, -down}, Vector3d::Zero()});
        bench.run(kPeriod);
      }
    };
    swing(5, 0);
    CHECK(bench.estimator.state().swinging > 0.9);
    const int number = bench.contact().last.number;
    swing(30, 0);
    CHECK(bench.contact().last.number == number);
    swing(0.1, 20);
    CHECK(bench.contact().last.number == number + 1);
    CHECK(bench.contact().contact);
  }
}

TEST_CASE("Contact: a refused sample leaves contact() bit for bit as it was", "[contact]") {
  const unsigned seed = 430;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  rme::Estimator<double, 7> estimator(kPeriod), twin(kPeriod);
  int refused = 0;
  for (const Sample& good : rme::testing::life(seed)) {
    if (random() % 5 == 0) {
      Sample bad = good;
      const int joint = static_cast<int>(random() % 7);
      if (random() % 2 == 0)
        bad.tau_ext[joint] = std::numeric_limits<double>::quiet_NaN();
      else
        bad.dq[joint] = std::numeric_limits<double>::infinity();
      REQUIRE(estimator.update(bad) == Status::NonFiniteInput);
      ++refused;
    }
    REQUIRE(estimator.update(good) == Status::Ok);
    REQUIRE(twin.update(good) == Status::Ok);
    REQUIRE(same(estimator.contact(), twin.contact()));
    REQUIRE(finite(estimator.contact()));
  }
  CHECK(refused > 1000);
  CHECK(estimator.contact().last.number >= 3);  // an attachment, a push, a removal
}

TEST_CASE("Contact: while the torque is no measurement, contact() is not ready, and says nothing new", "[contact]") {
  const unsigned seed = 440;
  CAPTURE(seed);
  Bench bench(seed);
  bench.run(2);
  bench.arm.hold({1.1, {0.05, 0.02, 0.13}});
  bench.run(3);
  const Contact before = bench.contact();
  REQUIRE(before.ready);
  const HeldArm::Vector frozen = bench.arm.tick().tau_ext;
  int lost = 0;
  for (int k = 0; k < 5000; ++k) {
    Sample sample = bench.arm.tick();
    sample.tau_ext = frozen;
    const Status status = bench.estimator.update(sample);
    lost += status == Status::NotAMeasurement ? 1 : 0;
    REQUIRE((status == Status::Ok || status == Status::NotAMeasurement));
    REQUIRE(bench.contact().ready == (status == Status::Ok));
    REQUIRE(finite(bench.contact()));
  }
  CHECK(lost > 4900);
  CHECK(bench.contact().last.number == before.last.number);
  // It is back, and sees what touches the arm.
  bench.run(0.5);
  CHECK(bench.contact().ready);
  CHECK(bench.contact().last.number == before.last.number);
  bench.arm.push({{6, -6, 0}, Vector3d::Zero()});
  bench.run(0.03);
  CHECK(bench.contact().contact);
}

TEST_CASE("Contact: the stated rate of false alarms sets the threshold", "[contact]") {
  const unsigned seed = 450;
  CAPTURE(seed);
  Bench a(seed, link_side(60)), b(seed, link_side(1e-3));
  a.run(5);
  b.run(5);
  // The residuals are the same, and so is all that was learned from them.
  CHECK(a.contact().variance == b.contact().variance);
  CHECK(a.contact().threshold.minCoeff() > 0);
  CHECK((b.contact().threshold.array() > 1.2 * a.contact().threshold.array()).all());
}

TEST_CASE("Contact: an arm that may have friction is not trusted at rest before it has moved", "[contact]") {
  const unsigned seed = 455;
  CAPTURE(seed);
  rme::EstimatorConfig<double, 7> friction;
  friction.sensing = rme::Sensing::JointFriction;
  Bench a(seed), b(seed, friction), unknown(seed, rme::EstimatorConfig<double, 7>());
  a.run(5);
  b.run(5);
  unknown.run(5);
  // E[c^2] / 3 with 0.2 N m; the noise is far below that.
  CHECK(a.contact().variance[0] < 1e-3);
  CHECK(b.contact().variance[0] > 0.04 / 3);
  CHECK(unknown.contact().variance[0] == Approx(b.contact().variance[0]).epsilon(0.05));
  // Once it has moved, it is known that there is none.
  for (const double way : {0.4, -0.6, 0.5, -0.3}) {
    unknown.arm.move(unknown.arm.pose() + way * HeldArm::Vector::Ones(), 1.5);
    unknown.run(2.5);
  }
  unknown.run(5);
  CHECK(unknown.contact().variance[0] < 2e-3);
}

TEST_CASE("Contact: after reset() it is as new, and what a host says of the hand ends a contact", "[contact]") {
  const auto samples = rme::testing::life(460);
  rme::Estimator<double, 7> used(kPeriod), fresh(kPeriod);
  for (const Sample& s : samples) REQUIRE(used.update(s) == Status::Ok);
  used.reset();
  CHECK(same(used.contact(), fresh.contact()));
  for (std::size_t k = 0; k < 1010; ++k) {  // 10 ms after an object has come
    REQUIRE(used.update(samples[k]) == Status::Ok);
    REQUIRE(fresh.update(samples[k]) == Status::Ok);
    REQUIRE(same(used.contact(), fresh.contact()));
  }
  REQUIRE(used.contact().contact);
  used.declare_empty();
  CHECK_FALSE(used.contact().contact);
}

TEST_CASE("Contact: float notices what double does", "[contact]") {
  const unsigned seed = 470;
  CAPTURE(seed);
  rme::Estimator<double, 7> in_double(kPeriod);
  rme::Estimator<float, 7> in_float(kPeriod);
  int differ = 0, contacts = 0;
  for (const Sample& sample : rme::testing::life(seed)) {
    rme::Proprioception<float, 7> rounded;
    rounded.tau_ext = sample.tau_ext.cast<float>();
    rounded.jacobian = sample.jacobian.cast<float>();
    rounded.rotation = sample.rotation.cast<float>();
    rounded.dq = sample.dq.cast<float>();
    REQUIRE(in_double.update(sample) == Status::Ok);
    REQUIRE(in_float.update(rounded) == Status::Ok);
    REQUIRE(finite(in_float.contact()));
    contacts += in_double.contact().contact ? 1 : 0;
    differ += in_double.contact().contact != in_float.contact().contact ? 1 : 0;
  }
  CAPTURE(contacts, differ);
  CHECK(contacts > 500);
  CHECK(differ < contacts / 10);
}

}  // namespace
