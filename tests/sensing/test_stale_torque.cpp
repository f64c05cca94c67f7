#include <cmath>
#include <random>
#include <rme/sensing/stale_torque.hpp>

#include "support/catch.hpp"

namespace {

constexpr int kDofs = 7;
using Stale = rme::StaleTorque<double, kDofs>;
using Joints = rme::JointVector<double, kDofs>;

/// An arm with a torque sensor in each joint, sampled each millisecond.
struct Arm {
  explicit Arm(unsigned seed) : random(seed) {}
  double noise = 0.05;    ///< [N m], white, before the observer
  double bandwidth = 50;  ///< of the observer [rad/s]; 0 if there is none
  double resolution = 0;  ///< [N m]; 0 for none
  double speed = 0;       ///< amplitude of dq [rad/s]
  double load = 4;        ///< amplitude of the payload's torque [N m]
  std::mt19937_64 random;
  std::normal_distribution<double> normal;
  Joints filtered = Joints::Zero();
  int k = 0;

  Joints dq() const {
    return Joints(Joints::NullaryExpr([this](Eigen::Index j) { return speed * std::cos(2e-3 * k + double(j)); }));
  }
  Joints torque() {
    ++k;
    for (int j = 0; j < kDofs; ++j) {
      // Moves as the arm does, whose angle is the integral of dq.
      const double tau = load * std::sin(0.5 * speed * std::sin(2e-3 * k + j) + j) + noise * normal(random);
      filtered[j] += (bandwidth > 0 ? 1e-3 * bandwidth : 1) * (tau - filtered[j]);
    }
    Joints seen = filtered;
    for (int j = 0; resolution > 0 && j < kDofs; ++j) seen[j] = resolution * std::round(seen[j] / resolution);
    return seen;
  }
};

/// How many of an arm's readings are refused. The host runs at 1 kHz, the arm measures each `every` ms.
int refused_of(Stale& stale, Arm& arm, int milliseconds, int every = 1) {
  int refused = 0;
  Joints seen = Joints::Zero();
  for (int i = 0; i < milliseconds; ++i) {
    const Joints fresh = arm.torque();
    if (i % every == 0) seen = fresh;
    refused += stale.update(seen, arm.dq(), 1e-3) ? 0 : 1;
  }
  return refused;
}
/// After how many milliseconds of one and the same reading it is refused for good; `most` if it is not.
int refused_after(Stale& stale, const Joints& tau, const Joints& dq, int most) {
  int last_good = 0;
  for (int i = 1; i <= most; ++i)
    if (stale.update(tau, dq, 1e-3)) last_good = i;
  return last_good;
}

TEST_CASE("StaleTorque: a torque with noise that freezes is refused after 50 ms, at rest and in motion", "[stale]") {
  const unsigned seed = 701;
  CAPTURE(seed);
  for (const double speed : {0.0, 0.02, 1.5}) {
    for (const double bandwidth : {0.0, 50.0}) {
      CAPTURE(speed, bandwidth);
      Stale stale;
      Arm arm(seed);
      arm.speed = speed;
      arm.bandwidth = bandwidth;
      CHECK(refused_of(stale, arm, 3000) == 0);
      const Joints frozen = arm.torque();
      CHECK(stale.update(frozen, arm.dq(), 1e-3));
      CHECK(refused_after(stale, frozen, arm.dq(), 2000) == 49);
      CHECK(refused_of(stale, arm, 2000) == 0);  // the first reading that differs counts again
    }
  }
}

TEST_CASE("StaleTorque: an exact zero in all joints is refused at once where noise makes it impossible", "[stale]") {
  const unsigned seed = 702;
  CAPTURE(seed);
  Stale stale;
  Arm arm(seed);
  CHECK(stale.update(Joints::Zero(), arm.dq(), 1e-3));  // an observer that has just started
  CHECK(refused_of(stale, arm, 500) == 0);
  CHECK_FALSE(stale.update(Joints::Zero(), arm.dq(), 1e-3));
  CHECK(refused_of(stale, arm, 10) == 0);
  CHECK(refused_after(stale, Joints::Zero(), arm.dq(), 1000) == 0);
  CHECK(refused_of(stale, arm, 500) == 0);
  Joints one_alive = Joints::Zero();
  one_alive[3] = 0.01;
  CHECK(stale.update(one_alive, arm.dq(), 1e-3));
  stale.reset();
  CHECK(refused_after(stale, Joints::Zero(), arm.dq(), 1000) == 1000);
}

TEST_CASE("StaleTorque: a simulated arm without noise is never refused, be its torque constant or zero", "[stale]") {
  for (const double resolution : {0.0, 1e-5}) {  // as numbers, or as a log with five digits
    CAPTURE(resolution);
    Stale stale;
    Arm arm(1);
    arm.noise = 0;
    arm.speed = 1;
    arm.resolution = resolution;
    CHECK(refused_after(stale, Joints::Zero(), arm.dq(), 3000) == 3000);  // empty, in motion
    CHECK(refused_of(stale, arm, 5000) == 0);                             // a payload, in motion
    const Joints constant = arm.torque();
    CHECK(refused_after(stale, constant, Joints::Zero(), 3000) == 3000);  // at rest
    CHECK(refused_of(stale, arm, 5000) == 0);
    CHECK(refused_after(stale, Joints::Zero(), arm.dq(), 3000) == 3000);  // dropped in motion
  }
}

TEST_CASE("StaleTorque: torque with a coarse resolution may be constant at rest, whatever it did in motion",
          "[stale]") {
  const unsigned seed = 703;
  CAPTURE(seed);
  for (const double noise : {0.0, 0.003, 0.01, 0.05, 0.2}) {
    for (const double bandwidth : {0.0, 50.0}) {
      CAPTURE(noise, bandwidth);
      Stale stale;
      Arm arm(seed);
      arm.resolution = 0.05;
      arm.noise = noise;
      arm.bandwidth = bandwidth;
      for (const double speed : {0.0, 1.0, 0.0, 0.06, 0.0}) {
        arm.speed = speed;
        CHECK(refused_of(stale, arm, 4000) == 0);
      }
      arm.load = 0;
      CHECK(refused_of(stale, arm, 4000) == 0);
    }
  }
}

TEST_CASE("StaleTorque: a coarse torque that freezes is refused once the arm has moved for 50 ms", "[stale]") {
  const unsigned seed = 704;
  CAPTURE(seed);
  Stale stale;
  Arm arm(seed);
  arm.resolution = 0.05;
  arm.noise = 0.04;
  arm.bandwidth = 0;
  arm.speed = 0.3;
  CHECK(refused_of(stale, arm, 4000) == 0);
  const Joints frozen = arm.torque();
  CHECK(stale.update(frozen, arm.dq(), 1e-3));
  CHECK(refused_after(stale, frozen, Joints::Zero(), 1000) == 1000);
  CHECK(refused_after(stale, frozen, Joints::Constant(0.3), 1000) <= 60);
  CHECK_FALSE(stale.update(frozen, Joints::Zero(), 1e-3));  // nor does it become a measurement when the arm stops
  CHECK(refused_of(stale, arm, 1000) == 0);
}

TEST_CASE("StaleTorque: an arm that measures less often than the host asks is not refused, and noticed when it freezes",
          "[stale]") {
  const unsigned seed = 705;
  CAPTURE(seed);
  for (const int every : {1, 4, 10, 100}) {
    CAPTURE(every);
    Stale stale;
    Arm arm(seed);
    CHECK(refused_of(stale, arm, 200 * every, every) == 0);
    const Joints frozen = arm.torque();
    CHECK(stale.update(frozen, arm.dq(), 1e-3));
    CHECK(refused_after(stale, frozen, arm.dq(), 1000) == std::max(50, 3 * every) - 1);
  }
}

TEST_CASE("StaleTorque: a host at 10 Hz notices after three periods, and no reading before the hundredth is refused",
          "[stale]") {
  const unsigned seed = 706;
  CAPTURE(seed);
  Arm arm(seed);
  const auto ten_hertz = [&] {
    for (int i = 0; i < 99; ++i) arm.torque();
    return arm.torque();
  };
  Stale stale;
  for (int i = 0; i < 50; ++i) CHECK(stale.update(ten_hertz(), arm.dq(), 0.1));
  const Joints early = ten_hertz();
  for (int i = 0; i < 50; ++i) CHECK(stale.update(early, arm.dq(), 0.1));
  stale.reset();
  for (int i = 0; i < 150; ++i) CHECK(stale.update(ten_hertz(), arm.dq(), 0.1));
  const Joints frozen = ten_hertz();
  for (int i = 0; i < 10; ++i) CHECK(stale.update(frozen, arm.dq(), 0.1) == (i < 3));
}

TEST_CASE("StaleTorque: a long pause makes pauses usual only for a while", "[stale]") {
  const unsigned seed = 707;
  CAPTURE(seed);
  Stale stale;
  Arm arm(seed);
  CHECK(refused_of(stale, arm, 1000) == 0);
  const Joints frozen = arm.torque();
  CHECK(stale.update(frozen, arm.dq(), 1e-3));
  CHECK(refused_after(stale, frozen, arm.dq(), 5000) == 49);
  CHECK(refused_of(stale, arm, 1) == 0);
  const Joints again = arm.torque();
  CHECK(stale.update(again, arm.dq(), 1e-3));
  CHECK(refused_after(stale, again, arm.dq(), 1000) <= 300);
  CHECK(refused_of(stale, arm, 2000) == 0);
  const Joints later = arm.torque();
  CHECK(stale.update(later, arm.dq(), 1e-3));
  CHECK(refused_after(stale, later, arm.dq(), 1000) == 49);
}

static_assert(noexcept(std::declval<Stale&>().update(std::declval<const Joints&>(), std::declval<const Joints&>(),
                                                     1e-3)));

}  // namespace
