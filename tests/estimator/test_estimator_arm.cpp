// What the estimator learns of its arm, and has to live with.
#include <algorithm>
#include <cmath>
#include <random>
#include <rme/estimator.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

#include "support/catch.hpp"
#include "support/held_arm.hpp"

namespace {

using namespace rme::examples;
using rme::Status;
using rme::testing::HeldArm;

constexpr double kPeriod = HeldArm::kPeriod;

/// A Panda under an impedance law, with the estimator's compensation, that swings about its ready pose when asked to.
class Host {
 public:
  Host(std::uint64_t seed, bool friction) : arm(panda(), faults(seed, friction), panda().ready) {}

  /// The torque sensors are zeroed in this pose.
  void zero() { zero_ = last_; }
  void run(double seconds, double swing = 0) {
    const double begin = arm.time();
    while (arm.time() < begin + seconds) {
      const double t = arm.time() - begin, share = std::sin(M_PI * t / seconds);
      PoseImpedance<7>::Vector q = panda().ready;
      for (int j = 0; j < 7; ++j) q[j] += swing * share * share * std::sin((1.3 + 0.2 * j) * t);
      controller_ = PoseImpedance<7>(panda(), q);
      const auto& [position, rotation, jacobian] = arm.kinematics();
      last_ = arm.tau_ext();
      const PoseImpedance<7>::Vector tau_ext = last_ - zero_;
      REQUIRE(estimator.update({tau_ext, jacobian, rotation, arm.dq()}) == Status::Ok);
      arm.step(controller_.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()) +
               estimator.compensation(jacobian, rotation));
    }
  }

  SyntheticArm<7> arm;
  rme::Estimator<double, 7> estimator{kPeriod};

 private:
  static SyntheticArmConfig<7> faults(std::uint64_t seed, bool friction) {
    auto config = with_typical_faults(panda(), seed);
    if (!friction) config.friction = {};
    return config;
  }
  PoseImpedance<7> controller_{panda(), panda().ready};
  PoseImpedance<7>::Vector last_ = PoseImpedance<7>::Vector::Zero(), zero_ = PoseImpedance<7>::Vector::Zero();
};

TEST_CASE("Estimator: what kind of arm it is on shows in motion, and is remembered from one payload to the next",
          "[estimator]") {
  for (const bool friction : {false, true}) {
    for (const std::uint64_t seed : {1u, 2u}) {
      CAPTURE(friction, seed);
      Host host(seed, friction);
      host.run(1);
      host.run(6, 0.3);
      const auto& state = host.estimator.state();
      const auto known = [&] { return friction ? state.friction_shows() > 0.99 : state.friction_shows() < 0.01; };
      CHECK(known());
      for (const double mass : {0.3, 0.8, 1.6}) {
        CAPTURE(mass);
        const int handle = host.arm.attach(box(mass, {0.02, 0.01, 0.1}, {0.06, 0.06, 0.1}));
        host.run(0.5);
        CHECK_FALSE(state.empty());
        CHECK(std::abs(state.payload.mean[0] - mass) < (friction ? 0.06 : 0.01));
        host.arm.detach(handle);
        host.run(0.5);
        CHECK(state.empty());
        CHECK(known());
      }
    }
  }
}

TEST_CASE("Estimator: a model that is off by half a newton metre, elsewhere in each pose, delays no event",
          "[estimator]") {
  for (const unsigned seed : {1u, 2u, 3u}) {
    CAPTURE(seed);
    HeldArm arm(seed);
    rme::Estimator<double, 7> estimator(kPeriod);
    const auto& state = estimator.state();
    const HeldArm::Vector ready = arm.pose();
    const auto run = [&](double seconds) {
      for (int k = 0; k < static_cast<int>(seconds / kPeriod); ++k) {
        if (!arm.moving()) arm.move(ready.array() + (arm.pose()[0] < ready[0] ? 0.3 : -0.3), 3);
        auto sample = arm.tick();
        for (int j = 0; j < 7; ++j) sample.tau_ext[j] += (j < 4 ? 0.5 : 0.2) * std::sin(4 * arm.pose()[j] + j);
        REQUIRE(estimator.update(sample) == Status::Ok);
      }
    };
    run(6);
    CHECK(state.payload.mean[0] < 0.1);  // 0.5 N m are 0.09 kg there
    for (const double mass : {1.2, 0.0, 0.8, 0.0}) {
      CAPTURE(mass);
      const int before = state.event.number;
      arm.hold({mass, {0.02, 0.01, 0.1}});
      run(0.6);
      CHECK(state.event.number > before);
      CHECK(std::abs(state.payload.mean[0] - mass) < 0.2);
      run(2);
      CHECK(std::abs(state.payload.mean[0] - mass) < 0.15);
    }
  }
}

TEST_CASE("Estimator: an object is no push, though each torque sensor's gain is off by 2 %", "[estimator]") {
  int wrong = 0;
  for (std::uint64_t seed = 1; seed <= 60; ++seed) {
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    HeldArm arm(seed);
    HeldArm::Vector gain;
    for (int j = 0; j < 7; ++j) gain[j] = 1 + 0.02 * normal(random);
    arm.set_gain(gain);
    rme::Estimator<double, 7> estimator(kPeriod);
    const auto run = [&](double seconds) {
      for (int k = 0; k < std::lround(seconds / kPeriod); ++k) REQUIRE(estimator.update(arm.tick()) == Status::Ok);
    };
    const HeldArm::Vector ready = arm.pose();
    for (const double way : {0.3, 0.0}) {
      arm.move(ready.array() + way, 2);
      run(3);
    }
    const double mass = std::uniform_real_distribution<double>(0.8, 1.8)(random);
    arm.hold({mass, {0.04, -0.02, 0.12}});
    run(0.7);
    const auto& payload = estimator.state().payload;
    CAPTURE(seed, mass, payload.mean[0], payload.standard_deviation()[0]);
    const double off = std::abs(payload.mean[0] - mass);
    CHECK(off < 0.08 * mass);  // four deviations of one joint's gain, which cannot be told from the mass
    wrong += off > 0.05 * mass ? 1 : 0;
  }
  CHECK(wrong <= 5);
}

TEST_CASE("Estimator: a kilogram is mostly still held after the torque sensors were zeroed with it, or the state warns",
          "[estimator]") {
  // At rest, that could be a removal; the arm's offsets tell, and then its motion. Friction hides both.
  for (const bool friction : {false, true}) {
    int right = 0, silent = 0, stays = 0;  // without a warning; wrong without one; still held after it was removed
    for (std::uint64_t seed = 40; seed < 76; ++seed) {
      CAPTURE(friction, seed);
      Host host(seed, friction);
      host.run(1);
      const int handle = host.arm.attach(box(1, {0.02, 0, 0.1}, {0.08, 0.08, 0.1}));
      host.run(2);
      REQUIRE(host.estimator.state().held > 0.9);
      host.zero();
      host.run(1);
      host.run(3, 0.4);
      const bool wrong = std::abs(host.estimator.state().payload.mean[0] - 1) > 0.03;
      const bool warns = host.estimator.state().health >= 10;
      if (wrong && !warns) ++silent;
      if (wrong || warns) continue;
      ++right;
      host.arm.detach(handle);
      host.run(1);
      if (host.estimator.state().held > 0.1) ++stays;
    }
    CAPTURE(friction, right, silent, stays);
    CHECK(right >= (friction ? 8 : 29));  // of 36; of 144 it is 117 and, with friction, 33, and 8 silent
    CHECK(silent <= (friction ? 3 : 0));
    CHECK(stays == 0);
  }
}

TEST_CASE("Estimator: the inertia of what is taken up little by little, and added to, is within its stated deviation",
          "[estimator]") {
  int entries = 0, within = 0, known = 0;
  for (std::uint64_t seed = 900; seed < 936; ++seed) {
    CAPTURE(seed);
    Host host(seed, false);
    host.run(1);
    const double slow = 0.3 + 0.1 * static_cast<double>(seed % 18);  // [s]
    host.arm.attach(box(0.8, {0.03, 0.02, 0.1}, {0.06, 0.06, 0.1}), slow);
    host.run(slow + 1);
    host.run(6, 0.3);
    host.arm.attach(box(0.5, {-0.05, 0.03, 0.06}, {0.06, 0.06, 0.1}), 3);
    host.run(4);
    host.run(8, 0.3);
    const rme::examples::RigidBody held = host.arm.payload();
    const auto truth = rme::InertialParameters<double>::of_body({held.mass, held.com}, held.inertia).vector();
    const auto& found = host.estimator.state().inertial;
    for (int i = 4; i < rme::kInertial; ++i) {
      const double deviation = std::sqrt(found.covariance(i, i));
      ++entries;
      within += std::abs(found.mean[i] - truth[i]) < 4 * deviation ? 1 : 0;
      known += deviation < 0.005 ? 1 : 0;  // [kg m^2]; the prior's is 0.03
    }
  }
  CAPTURE(entries, within, known);
  CHECK(within >= 0.97 * entries);
  CHECK(known >= 0.8 * entries);
}

}  // namespace
