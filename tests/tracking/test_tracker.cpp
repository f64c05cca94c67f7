#include <cmath>
#include <random>
#include <rme/tracking/tracker.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <utility>

#include "enumerated_stories.hpp"
#include "support/catch.hpp"

namespace {

using rme::Mode;
using rme::examples::TorqueSensing;
using Arm = rme::examples::SyntheticArm<7>;
using Joints = rme::JointVector<double, 7>;
constexpr double kRated = 3;

/// A simulated Panda that follows a path in its joints, and a tracker that listens.
template <typename Scalar>
class Scene {
 public:
  /// @param friction  of the joints, behind motor-side sensors; without it the sensors are link-side
  Scene(std::uint64_t seed, bool friction, std::optional<rme::Sensing> known = std::nullopt)
      : arm_(model_, config(seed, friction), model_.ready),
        averager_(50, rme::standard_gravity<Scalar>()),
        tracker_(rme::ArmPrior<Scalar, 7>::of(Scalar(kRated)), rme::PayloadPrior<Scalar>::of(Scalar(kRated)),
                 Scalar(kRated), known, rme::standard_gravity<Scalar>()) {}

  int attach(const rme::examples::RigidBody& body) { return arm_.attach(body); }
  void detach(int handle) { arm_.detach(handle); }
  /// @param swing  amplitude of the joints' motion [rad]; a change fades in
  void live(double seconds, double swing) {
    for (int k = 0; k < static_cast<int>(1000 * seconds); ++k) {
      swing_ += 2e-3 * (swing - swing_);
      tick();
    }
  }

  const rme::TrackerBelief<Scalar>& belief() const { return tracker_.belief(); }
  rme::Tracker<Scalar, 7>& tracker() { return tracker_; }
  Scalar sensing(rme::Sensing kind) const { return belief().sensing[static_cast<std::size_t>(kind)]; }
  double mass() const { return double(belief().payload.mean[0]); }
  Eigen::Vector3d com() const { return belief().payload.mean.template segment<3>(1).template cast<double>() / mass(); }
  double probability(Mode m) const { return double(belief().probability[m]); }
  /// How many deviations the mass is off.
  double mass_score(double truth) const {
    return std::abs(mass() - truth) / std::sqrt(double(belief().payload.covariance(0, 0)));
  }
  int blocks = 0;

 private:
  static rme::examples::SyntheticArmConfig<7> config(std::uint64_t seed, bool friction) {
    auto out = rme::examples::with_typical_faults(rme::examples::panda(), seed);
    if (!friction) out.friction = {};
    return out;
  }

  void tick() {
    // Joint j swings at its own rate about the ready pose; held by a stiff computed torque that knows no payload.
    const double t = arm_.time();
    Joints q = model_.ready, dq = Joints::Zero(), ddq = Joints::Zero();
    for (int j = 0; j < 7; ++j) {
      const double rate = 1.3 + 0.37 * j;
      q[j] += swing_ * std::sin(rate * t + j);
      dq[j] = swing_ * rate * std::cos(rate * t + j);
      ddq[j] = -swing_ * rate * rate * std::sin(rate * t + j);
    }
    const auto& d = arm_.dynamics();
    ddq += 400 * (q - arm_.q()) + 40 * (dq - arm_.dq());
    arm_.step(d.mass_matrix * ddq + d.coriolis + d.gravity);
    rme::Proprioception<Scalar, 7> sample;
    sample.tau_ext = arm_.tau_ext().cast<Scalar>();
    sample.jacobian = arm_.kinematics().jacobian.cast<Scalar>();
    sample.rotation = arm_.kinematics().rotation.cast<Scalar>();
    sample.dq = arm_.dq().cast<Scalar>();
    if (averager_.add(sample, 1e-3, arm_.time())) {
      tracker_.begin(averager_.block(), false);
      ++blocks;
    }
    while (tracker_.busy()) tracker_.advance();
  }

  const rme::examples::ArmModel<7>& model_ = rme::examples::panda();
  Arm arm_;
  rme::BlockAverager<Scalar, 7> averager_;
  rme::Tracker<Scalar, 7> tracker_;
  double swing_ = 0;
};

const rme::examples::RigidBody kTool = rme::examples::box(0.9, {0.03, -0.02, 0.1}, {0.08, 0.06, 0.12});

/// Largest errors to be had: of the mass at rest and in motion [kg], of the centre in motion [m].
struct Bounds {
  double at_rest, in_motion, com;
};

template <typename Scalar>
void check_life(std::uint64_t seed, bool friction, const Bounds& bounds) {
  CAPTURE(seed, friction);
  Scene<Scalar> scene(seed, friction);
  scene.live(1, 0);
  CHECK(scene.probability(Mode::Empty) > 0.95);
  // At rest.
  const int handle = scene.attach(kTool);
  scene.live(2, 0);
  CAPTURE(scene.mass(), scene.com().transpose());
  CHECK(scene.probability(Mode::Empty) < 0.01);
  CHECK(std::abs(scene.mass() - 0.9) < bounds.at_rest);
  // Carried and turned: what gravity had hidden shows.
  scene.live(5, 0.5);
  CAPTURE(scene.mass(), scene.com().transpose());
  CHECK(scene.probability(Mode::Held) > 0.9);
  CHECK(std::abs(scene.mass() - 0.9) < bounds.in_motion);
  CHECK((scene.com() - kTool.com).norm() < bounds.com);
  CHECK(scene.mass_score(0.9) < 4);
  CHECK(double(scene.belief().health) < 3);
  // Taken off and attached again while the arm moves.
  scene.detach(handle);
  scene.live(1, 0.5);
  CHECK(scene.probability(Mode::Empty) > 0.9);
  scene.attach(kTool);
  scene.live(3, 0.5);
  CAPTURE(scene.mass(), scene.com().transpose());
  CHECK(std::abs(scene.mass() - 0.9) < bounds.in_motion);
  CHECK((scene.com() - kTool.com).norm() < bounds.com);
  // Which kind of sensing it is has shown by now, and is remembered.
  CHECK(double(scene.sensing(friction ? rme::Sensing::JointFriction : rme::Sensing::LinkSide)) > 0.99);
}

TEST_CASE("Tracker: 0.9 kg attached at rest and in motion, link-side sensing", "[tracker]") {
  for (const std::uint64_t seed : {660u, 661u, 662u}) check_life<double>(seed, false, {0.005, 0.002, 0.0015});
}

TEST_CASE("Tracker: 0.9 kg attached at rest and in motion, with joint friction", "[tracker]") {
  for (const std::uint64_t seed : {663u, 664u, 665u}) check_life<double>(seed, true, {0.03, 0.0025, 0.0015});
}

TEST_CASE("Tracker: the same in float", "[tracker]") {
  check_life<float>(660, false, {0.005, 0.002, 0.0015});
  check_life<float>(663, true, {0.03, 0.0025, 0.0015});
}

TEST_CASE("Tracker: the host may say which sensing it is, and is believed from the first block", "[tracker]") {
  for (const bool friction : {false, true}) {
    CAPTURE(friction);
    const rme::Sensing known = friction ? rme::Sensing::JointFriction : rme::Sensing::LinkSide;
    Scene<double> scene(666, friction, known);
    CHECK(scene.blocks == 0);
    scene.live(0.5, 0);
    CHECK(scene.sensing(known) == Approx(1).margin(1e-12));
  }
}

TEST_CASE("Tracker: what the host says is believed at once, and overturned by data", "[tracker]") {
  const std::uint64_t seed = 668;
  CAPTURE(seed);
  Scene<double> scene(seed, false, rme::Sensing::LinkSide);
  scene.live(1, 0);
  scene.tracker().set_payload(
      rme::PayloadGaussian<double>::independent({0.9, 0.03, -0.02, 0.1}, {0.01, 0.005, 0.005, 0.005}));
  CHECK(scene.probability(Mode::Held) > 0.99);
  CHECK(scene.mass() == Approx(0.9).epsilon(0.01));
  scene.live(0.5, 0);  // there is none
  CHECK(scene.probability(Mode::Held) < 0.1);
  scene.attach(kTool);
  scene.live(1, 0);
  CHECK(scene.probability(Mode::Held) > 0.9);
  scene.tracker().declare_empty();
  CHECK(scene.probability(Mode::Empty) > 0.99);
  CHECK(std::abs(scene.mass() - 0.9) < 0.05);  // if the hand is not empty after all
  scene.live(0.5, 0);
  CHECK(scene.probability(Mode::Empty) < 0.01);
  CHECK(std::abs(scene.mass() - 0.9) < 0.05);
}

TEST_CASE("Tracker: set_payload turns a Gaussian over (m, r) into the moments of (m, m r)", "[tracker]") {
  // Against samples; m and r are correlated, and the mass is far enough from its bounds to be cut nowhere.
  const unsigned seed = 669;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  rme::Matrix4<double> L;
  L << 0.15, 0, 0, 0, 0.01, 0.02, 0, 0, -0.01, 0.01, 0.015, 0, 0.02, 0, 0.01, 0.02;
  const rme::PayloadGaussian<double> said{{1.2, 0.03, -0.02, 0.1}, L * L.transpose()};
  rme::Tracker<double, 7> tracker(rme::ArmPrior<double, 7>::of(kRated), rme::PayloadPrior<double>::of(kRated), kRated,
                                  std::nullopt, rme::standard_gravity<double>());
  tracker.set_payload(said);
  const auto& star = tracker.histories().story(0).star;
  constexpr int kSamples = 400'000;
  rme::Vector4<double> mean = rme::Vector4<double>::Zero();
  rme::Matrix4<double> square = rme::Matrix4<double>::Zero();
  for (int k = 0; k < kSamples; ++k) {
    rme::Vector4<double> x = rme::Vector4<double>::NullaryExpr([&] { return n(random); });
    x = said.mean + L * x;
    x.tail<3>() *= x[0];
    const rme::Vector4<double> d = x - star.mean().segment<4>(rme::kPayload);
    mean += d / kSamples;
    square += d * d.transpose() / kSamples;
  }
  const Eigen::Matrix4d covariance = star.covariance().block<4, 4>(rme::kPayload, rme::kPayload);
  for (int i = 0; i < 4; ++i) {
    CAPTURE(i);
    const double deviation = std::sqrt(covariance(i, i));
    CHECK(std::abs(mean[i]) < 0.02 * deviation);
    // Of fourth moments, those that a product of correlated m and r has beyond the documented ones are small.
    for (int k = 0; k < 4; ++k)
      CHECK(std::abs(square(i, k) - covariance(i, k)) < 0.05 * deviation * std::sqrt(covariance(k, k)));
  }
}

TEST_CASE("Tracker: no mass is believed that is negative or beyond the rated one, whatever the host says",
          "[tracker]") {
  // Half of N(3, 0.3^2) is left: the mean lies sqrt(2 / pi) deviations below the bound, and 1 - 2 / pi of the variance.
  const double pi = 3.141592653589793;
  for (const double mass : {0.0, 3.0}) {
    rme::Tracker<double, 7> tracker(rme::ArmPrior<double, 7>::of(kRated), rme::PayloadPrior<double>::of(kRated), kRated,
                                    std::nullopt, rme::standard_gravity<double>());
    tracker.set_payload(rme::PayloadGaussian<double>::independent({mass, 0, 0, 0.1}, {0.3, 0.01, 0.01, 0.01}));
    CHECK(std::abs(tracker.belief().payload.mean[0] - mass) == Approx(0.3 * std::sqrt(2 / pi)).margin(0.01));
    CHECK(tracker.belief().payload.covariance(0, 0) == Approx(0.09 * (1 - 2 / pi)).margin(0.003));
  }
}

/// A block of a Panda at rest in its ready pose that holds this, with a ripple in place of noise.
rme::TorqueBlock<double, 7> ready_block(double mass, int k) {
  const auto& model = rme::examples::panda();
  const auto at = model.kinematics(model.ready);
  const rme::Payload<double> held{mass, {0, 0, 0.1}};
  Joints tau = at.jacobian.transpose() * rme::payload_wrench<double>(held, at.rotation).vector();
  for (int j = 0; j < 7; ++j) tau[j] += 0.01 * std::sin(7.0 * k + j * j);
  return rme::testing::block_at_rest<double, 7>(at.jacobian, at.rotation, tau);
}

TEST_CASE("Tracker: the belief has the moments of the mixture over all stories in which something is held",
          "[tracker]") {
  rme::Tracker<double, 7> tracker(rme::ArmPrior<double, 7>::of(kRated), rme::PayloadPrior<double>::of(kRated), kRated,
                                  rme::Sensing::LinkSide, rme::standard_gravity<double>());
  for (int k = 0; k < 40; ++k) {
    CAPTURE(k);
    tracker.begin(ready_block(k < 20 ? 0 : 0.8, k), false);
    while (!tracker.advance()) {
    }
    const auto& histories = tracker.histories();
    double held = 0, all = 0;
    rme::InertialGaussian<double> mixture;
    rme::PerMode<double> probability;
    for (int i = 0; i < histories.count(); ++i) {
      const double w = histories.weight(i);
      probability[histories.story(i).mode] += w;
      all += w;
      if (!histories.holds(i)) continue;
      held += w;
      const auto payload = histories.payload(i);
      mixture.mean += w * payload.mean;
      mixture.covariance += w * (payload.covariance + payload.mean * payload.mean.transpose());
    }
    CHECK(all == Approx(1).epsilon(1e-12));
    const auto& belief = tracker.belief();
    for (std::size_t m = 0; m < rme::kModes; ++m)
      CHECK(std::abs(belief.probability.values[m] - probability.values[m]) < 1e-4);
    CHECK(std::abs(belief.empty - (1 - held)) < 1e-4);
    if (held < 0.01) continue;  // stories below a millionth do not count
    mixture.mean /= held;
    mixture.covariance = mixture.covariance / held - mixture.mean * mixture.mean.transpose();
    // The first moment is no more certain than that of the last link, most of all along the last joint's axis.
    const double link = histories.model().noise().first_moment_variance();
    for (int i = 1; i < 4; ++i) mixture.covariance(i, i) += (i == 3 ? 1 + 0.15 * 0.15 : 0.15 * 0.15) * link;
    mixture = rme::within_rated(mixture, kRated);
    CHECK((belief.payload.mean - mixture.mean).norm() < 1e-3 * mixture.mean.norm());
    CHECK((belief.payload.covariance - mixture.covariance).norm() < 1e-3 * mixture.covariance.norm() + 1e-9);
  }
  CHECK(tracker.belief().payload.mean[0] == Approx(0.8).margin(0.02));
}

TEST_CASE("Tracker: a block is taken in step by step, or all at once when the next one comes", "[tracker]") {
  rme::Tracker<double, 7> stepwise(rme::ArmPrior<double, 7>::of(kRated), rme::PayloadPrior<double>::of(kRated), kRated,
                                   std::nullopt, rme::standard_gravity<double>());
  auto hasty = stepwise;
  CHECK_FALSE(stepwise.busy());
  CHECK_FALSE(stepwise.advance());
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    const double before = stepwise.belief().probability[Mode::Empty];
    stepwise.begin(ready_block(k < 10 ? 0 : 0.8, k), false);
    hasty.begin(ready_block(k < 10 ? 0 : 0.8, k), false);
    int steps = 1;
    while (!stepwise.advance()) {
      REQUIRE(stepwise.busy());
      CHECK(stepwise.belief().probability[Mode::Empty] == before);
      REQUIRE(++steps < 1000);
    }
    CHECK_FALSE(stepwise.busy());
  }
  while (hasty.busy()) hasty.advance();
  CHECK(hasty.belief().payload.mean == stepwise.belief().payload.mean);
  CHECK(hasty.belief().payload.covariance == stepwise.belief().payload.covariance);
  CHECK(stepwise.belief().payload.mean[0] == Approx(0.8).margin(0.05));
}

}  // namespace
