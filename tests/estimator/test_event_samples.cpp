#include <cstdint>
#include <random>
#include <rme/event_samples.hpp>

#include "support/catch.hpp"
#include "support/random_events.hpp"

namespace {

using rme::Status;
using rme::testing::kDofs;
using Config = rme::EventEstimatorConfig<double, kDofs>;
using Event = rme::EventSamples<double, kDofs>;
using Sample = rme::Proprioception<double, kDofs>;
using Statistics = rme::PayloadStatistics<double, kDofs>;
using Torque = rme::JointVector<double, kDofs>;

constexpr double kPeriod = 1e-3;
const Eigen::Vector3d kCom(0.02, -0.03, 0.08);

/// An arm that stands still in one pose, whose torque steps, or climbs, at will.
class Arm {
 public:
  explicit Arm(unsigned seed) : random_(seed) {
    const auto [jacobian, rotation] = rme::testing::random_pose(random_);
    sample_.jacobian = jacobian;
    sample_.rotation = rotation;
    sample_.tau_ext.setZero();
    rme::SampleWindowConfig config;
    config.observer_bandwidth = 0;
    window_ = Window(kPeriod, config);
  }
  /// One tick, the torque changed by `jump`, spread over the joints.
  void tick(double jump = 0) {
    std::normal_distribution<double> n(0, 0.01);
    sample_.tau_ext += jump * Torque::Ones().normalized();
    Sample noisy = sample_;
    for (double& tau : noisy.tau_ext) tau += n(random_);
    REQUIRE(window_.push(noisy) == Status::Ok);
    ++now_;
  }
  void ticks(int count, double jump = 0) {
    for (int k = 0; k < count; ++k) tick(jump);
  }
  using Window = rme::SampleWindow<double, kDofs>;
  const Window& window() const { return window_; }
  std::uint64_t now() const { return now_; }

 private:
  std::mt19937_64 random_;
  Sample sample_;
  Window window_{kPeriod};
  std::uint64_t now_ = 0;
};

/// Largest difference between two windows' sums, of a joint, relative.
double difference(const Statistics& a, const Statistics& b) {
  rme::NuisanceGaussian<double, kDofs> nuisance;
  nuisance.mean.fill(Eigen::Vector3d(0.1, 0.2, 0.05));
  nuisance.covariance.fill(Eigen::Vector3d(0.01, 0.04, 0.09).asDiagonal());
  const Torque precision = Torque::Constant(100);
  Statistics::Marginals of_a, of_b;
  REQUIRE(a.marginals(precision, nuisance, of_a) == Status::Ok);
  REQUIRE(b.marginals(precision, nuisance, of_b) == Status::Ok);
  double largest = 0;
  for (std::size_t j = 0; j < kDofs; ++j)
    largest = std::max(largest, (of_a[j].products - of_b[j].products).norm() / of_b[j].products.norm());
  return largest;
}

TEST_CASE("EventSamples: what was there before the onset was found is in its sums as if it had always been known",
          "[event_samples]") {
  const unsigned seed = 410;
  CAPTURE(seed);
  const Config config;
  const auto guard = static_cast<std::uint64_t>(std::lround(config.onset_guard / kPeriod));
  Arm arm(seed);
  arm.ticks(200);
  arm.tick(3);
  const std::uint64_t onset = arm.now();
  Event found_late(kPeriod, config), found_early(kPeriod, config);
  for (int k = 0; k < 150; ++k) {
    arm.tick();
    found_early.add(arm.window().newest(), arm.now());
    found_late.add(arm.window().newest(), arm.now());
    if (k == 15) REQUIRE(found_early.locate(arm.window(), arm.now(), 100));
    if (k == 120) REQUIRE(found_late.locate(arm.window(), arm.now(), 200));
  }
  for (const Event* event : {&found_early, &found_late}) {
    CHECK(event->onset_known());
    CHECK(event->first_tick() == onset + guard);
    CHECK(static_cast<std::uint64_t>(event->about(kCom).all.count()) == arm.now() - event->first_tick() + 1);
  }
  CHECK(difference(found_late.about(kCom).all, found_early.about(kCom).all) < 1e-12);
}

TEST_CASE("EventSamples: the settled samples are kept apart, and count in the whole", "[event_samples]") {
  const unsigned seed = 411;
  CAPTURE(seed);
  const Config config;
  Arm arm(seed);
  arm.ticks(100);
  arm.tick(3);
  arm.ticks(60);
  Event event(kPeriod, config);
  REQUIRE(event.locate(arm.window(), arm.now(), 120));
  const int before = event.about(kCom).all.count();
  CHECK(before == 60 + 1 - std::lround(config.onset_guard / kPeriod));
  CHECK(event.settled_count() == 0);
  for (int k = 0; k < 50; ++k) {
    arm.tick();
    event.add_settled(arm.window().newest(), arm.now());
  }
  CHECK(event.settled_count() == 50);
  CHECK(event.about(kCom).settled.count() == 50);
  CHECK(event.about(kCom).all.count() == before + 50);
  CHECK(difference(event.about(kCom).settled, event.sums(arm.window(), 0, 50).about(kCom)) < 1e-12);
}

TEST_CASE("EventSamples: a step that is not wholly in view is none yet, and what was known stays", "[event_samples]") {
  const unsigned seed = 412;
  CAPTURE(seed);
  Arm arm(seed);
  arm.ticks(100);
  arm.tick(3);
  arm.ticks(10);  // span + 2 are needed
  Event event(kPeriod, Config());
  CHECK(event.locate(arm.window(), arm.now(), 100));
  CHECK_FALSE(event.onset_known());
  CHECK(event.about(kCom).all.count() == 0);
  arm.ticks(2);
  CHECK(event.locate(arm.window(), arm.now(), 100));
  CHECK(event.onset_known());
}

TEST_CASE("EventSamples: a hand-over without a step gathers nothing", "[event_samples]") {
  const unsigned seed = 413;
  CAPTURE(seed);
  Arm arm(seed);
  arm.ticks(100);
  arm.ticks(300, 0.01);
  Event event(kPeriod, Config());
  CHECK_FALSE(event.locate(arm.window(), arm.now(), 380));
  CHECK_FALSE(event.onset_known());
  event.add(arm.window().newest(), arm.now());
  CHECK(event.about(kCom).all.count() == 0);
}

TEST_CASE("EventSamples: the same step found again changes nothing, another one starts anew", "[event_samples]") {
  const unsigned seed = 414;
  CAPTURE(seed);
  Arm arm(seed);
  arm.ticks(100);
  arm.tick(2);
  arm.ticks(40);
  Event event(kPeriod, Config());
  REQUIRE(event.locate(arm.window(), arm.now(), 120));
  const std::uint64_t first = event.first_tick();
  arm.tick();
  event.add_settled(arm.window().newest(), arm.now());
  CHECK(event.locate(arm.window(), arm.now(), 120));
  CHECK(event.first_tick() == first);
  CHECK(event.settled_count() == 1);

  arm.tick(6);
  const std::uint64_t onset = arm.now();
  arm.ticks(40);
  CHECK(event.locate(arm.window(), arm.now(), 120));
  CHECK(event.first_tick() > onset);
  CHECK(event.settled_count() == 0);
  CHECK(static_cast<std::uint64_t>(event.about(kCom).all.count()) == arm.now() - event.first_tick() + 1);
}

TEST_CASE("EventSamples: without an onset the first settled sample is the first of all", "[event_samples]") {
  const unsigned seed = 415;
  CAPTURE(seed);
  Arm arm(seed);
  arm.ticks(50);
  Event event(kPeriod, Config());
  for (int k = 0; k < 3; ++k) {
    arm.tick();
    event.add_settled(arm.window().newest(), arm.now());
  }
  CHECK(event.first_tick() == arm.now() - 2);
  event.clear();
  CHECK(event.settled_count() == 0);
  arm.tick();
  event.add_settled(arm.window().newest(), arm.now());
  CHECK(event.first_tick() == arm.now());
}

}  // namespace
