#include <cmath>
#include <random>
#include <rme/tracking/tracker.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <utility>

#include "support/catch.hpp"

namespace {

using rme::Hypothesis;
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
                 Scalar(kRated), known) {}

  int attach(const rme::examples::RigidBody& body) { return arm_.attach(body); }
  void detach(int handle) { arm_.detach(handle); }
  void push(const rme::Wrench<double>& wrench) { arm_.push(wrench); }
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
  double probability(Hypothesis h) const { return double(belief().probability[h]); }
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
    // One step a tick: a block's work is done before the next one comes.
    tracker_.advance();
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
  CHECK(scene.probability(Hypothesis::Empty) > 0.95);
  // At rest.
  const int handle = scene.attach(kTool);
  scene.live(2, 0);
  CAPTURE(scene.mass(), scene.com().transpose());
  CHECK(scene.probability(Hypothesis::Empty) < 0.01);
  CHECK(std::abs(scene.mass() - 0.9) < bounds.at_rest);
  // Carried and turned: what gravity had hidden shows.
  scene.live(5, 0.5);
  CAPTURE(scene.mass(), scene.com().transpose());
  CHECK(scene.probability(Hypothesis::Steady) > 0.9);
  CHECK(std::abs(scene.mass() - 0.9) < bounds.in_motion);
  CHECK((scene.com() - kTool.com).norm() < bounds.com);
  CHECK(scene.mass_score(0.9) < 4);
  CHECK(double(scene.belief().health) < 3);
  // Taken off and attached again while the arm moves.
  scene.detach(handle);
  scene.live(1, 0.5);
  CHECK(scene.probability(Hypothesis::Empty) > 0.9);
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
  for (const std::uint64_t seed : {663u, 664u, 665u}) check_life<double>(seed, true, {0.03, 0.002, 0.0015});
}

TEST_CASE("Tracker: the same in float", "[tracker]") {
  check_life<float>(660, false, {0.005, 0.002, 0.0015});
  check_life<float>(663, true, {0.03, 0.002, 0.0015});
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

TEST_CASE("Tracker: a push is no payload, and what was held is held still", "[tracker]") {
  for (const bool friction : {false, true}) {
    const std::uint64_t seed = 667;
    CAPTURE(seed, friction);
    Scene<double> scene(seed, friction, friction ? rme::Sensing::JointFriction : rme::Sensing::LinkSide);
    scene.live(1, 0);
    scene.push({{12, -9, 0}, {0.5, 0.2, 0}});
    scene.live(0.5, 0);
    CHECK(scene.probability(Hypothesis::Pushed) > 0.9);
    scene.push({});
    scene.live(1, 0);
    CHECK(scene.probability(Hypothesis::Empty) > 0.9);
    scene.attach(kTool);
    scene.live(2, 0);
    const double before = scene.mass();
    scene.push({{12, -9, 0}, {0.5, 0.2, 0}});
    scene.live(0.5, 0);
    CHECK(scene.probability(Hypothesis::Pushed) > 0.9);
    CHECK(std::abs(scene.mass() - before) < 0.02);
    scene.push({});
    scene.live(1, 0);
    CHECK(scene.probability(Hypothesis::Pushed) < 0.1);
    CHECK(std::abs(scene.mass() - before) < 0.02);
  }
}

TEST_CASE("Tracker: what the host says is believed at once, and overturned by data", "[tracker]") {
  const std::uint64_t seed = 668;
  CAPTURE(seed);
  Scene<double> scene(seed, false, rme::Sensing::LinkSide);
  scene.live(1, 0);
  scene.tracker().set_payload(
      rme::PayloadGaussian<double>::independent({0.9, 0.03, -0.02, 0.1}, {0.01, 0.005, 0.005, 0.005}));
  CHECK(scene.probability(Hypothesis::Steady) > 0.99);
  CHECK(scene.mass() == Approx(0.9).epsilon(0.01));
  scene.live(0.5, 0);  // there is none
  CHECK(scene.probability(Hypothesis::Steady) < 0.1);
  scene.attach(kTool);
  scene.live(1, 0);
  CHECK(scene.probability(Hypothesis::Steady) > 0.9);
  scene.tracker().declare_empty();
  CHECK(scene.probability(Hypothesis::Empty) > 0.99);
  CHECK(std::abs(scene.mass() - 0.9) < 0.05);  // if the hand is not empty after all
  scene.live(0.5, 0);
  CHECK(scene.probability(Hypothesis::Empty) < 0.01);
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
                                  std::nullopt);
  tracker.set_payload(said);
  const auto& star = tracker.bank().star(Hypothesis::Steady);
  constexpr int kSamples = 400'000;
  rme::Vector4<double> mean = rme::Vector4<double>::Zero();
  rme::Matrix4<double> square = rme::Matrix4<double>::Zero();
  for (int k = 0; k < kSamples; ++k) {
    rme::Vector4<double> x = rme::Vector4<double>::NullaryExpr([&] { return n(random); });
    x = said.mean + L * x;
    x.tail<3>() *= x[0];
    const rme::Vector4<double> d = x - star.mean().head<4>();
    mean += d / kSamples;
    square += d * d.transpose() / kSamples;
  }
  const auto covariance = star.covariance();
  for (int i = 0; i < 4; ++i) {
    CAPTURE(i);
    const double deviation = std::sqrt(covariance(i, i));
    CHECK(std::abs(mean[i]) < 0.02 * deviation);
    // Of fourth moments, those that a product of correlated m and r has beyond the documented ones are small.
    for (int k = 0; k < 4; ++k)
      CHECK(std::abs(square(i, k) - covariance(i, k)) < 0.05 * deviation * std::sqrt(covariance(k, k)));
  }
}

TEST_CASE("Tracker: of a rough arm the filters take what the host says as 1.7 times as certain as the belief does",
          "[tracker]") {
  rme::Matrix4<double> L;
  L << 0.15, 0, 0, 0, 0.01, 0.02, 0, 0, -0.01, 0.01, 0.015, 0, 0.02, 0, 0.01, 0.02;
  const rme::PayloadGaussian<double> said{{1.2, 0.03, -0.02, 0.1}, L * L.transpose()};
  const auto covariance = [&](rme::Sensing sensing) {
    rme::Tracker<double, 7> tracker(rme::ArmPrior<double, 7>::of(kRated), rme::PayloadPrior<double>::of(kRated), kRated,
                                    sensing);
    tracker.set_payload(said);
    return tracker.bank().star(Hypothesis::Steady).covariance();
  };
  const auto sure = covariance(rme::Sensing::RoughModel), plain = covariance(rme::Sensing::LinkSide);
  CHECK((1.7 * 1.7 * sure - plain).norm() < 1e-12);
}

/// Moments of the mixture over all that is not empty, of the likeliest kind of sensing.
/// @param spread  by which the payload is less certain than the filters say
rme::InertialGaussian<double> mixture(const rme::Tracker<double, 7>& tracker, double spread) {
  const auto& bank = tracker.bank();
  const Hypothesis held[] = {Hypothesis::Steady, Hypothesis::Filling, Hypothesis::Exchanged, Hypothesis::Pushed};
  double total = 0;
  rme::InertialGaussian<double> out;
  for (const Hypothesis h : held) total += bank.probability(h);
  for (const Hypothesis h : held) out.mean += bank.probability(h) / total * bank.star(h).mean();
  for (const Hypothesis h : held) {
    const rme::InertialVector<double> d = bank.star(h).mean() - out.mean;
    out.covariance += bank.probability(h) / total * (spread * spread * bank.star(h).covariance() + d * d.transpose());
  }
  return out;
}

TEST_CASE("Tracker: the belief has the moments of the mixture over all that is not empty", "[tracker]") {
  using rme::Sensing;
  for (const auto& [sensing, spread] :
       {std::pair(std::optional<Sensing>(), 1.0), std::pair(std::optional<Sensing>(Sensing::RoughModel), 1.7)}) {
    CAPTURE(spread);  // of a rough arm, the belief is less certain than the filters
    rme::Tracker<double, 7> tracker(rme::ArmPrior<double, 7>::of(kRated), rme::PayloadPrior<double>::of(kRated), kRated,
                                    sensing);
    tracker.declare_empty();
    // Before the first block all banks hold the same of the payload: the prior, and beside a push nothing.
    REQUIRE(tracker.bank().star(Hypothesis::Pushed).mean().isZero(0));
    auto expected = mixture(tracker, spread);
    const double link = 0.15 * 0.15 * tracker.bank().noise().first_moment_variance();
    for (int i = 1; i < 4; ++i) expected.covariance(i, i) += link;
    expected = rme::within_rated(expected, kRated);
    const auto& payload = tracker.belief().payload;
    CHECK((payload.mean - expected.mean).norm() < 1e-12);
    CHECK((payload.covariance - expected.covariance).norm() < 1e-12);
  }
}

TEST_CASE("Tracker: the payload's first moment is no more certain than the last link's, most of all along its axis",
          "[tracker]") {
  const std::uint64_t seed = 676;
  CAPTURE(seed);
  Scene<double> scene(seed, false, rme::Sensing::LinkSide);
  scene.live(1, 0);
  scene.attach(kTool);
  scene.live(2, 0.5);
  const double link = scene.tracker().bank().noise().first_moment_variance();
  REQUIRE(link > 1e-8);
  const rme::InertialMatrix<double> added = scene.belief().payload.covariance - mixture(scene.tracker(), 1).covariance;
  rme::InertialMatrix<double> expected = rme::InertialMatrix<double>::Zero();
  for (int i = 1; i < 4; ++i) expected(i, i) = 0.15 * 0.15 * link;
  expected(3, 3) += link;  // a Panda's last joint turns about z of the flange
  CHECK((added - expected).norm() < 1e-6 * link);
}

TEST_CASE("Tracker: no mass is believed that is negative or beyond the rated one, whatever the host says",
          "[tracker]") {
  rme::Tracker<double, 7> tracker(rme::ArmPrior<double, 7>::of(kRated), rme::PayloadPrior<double>::of(kRated), kRated,
                                  std::nullopt);
  // Half of N(3, 0.3^2) is left: the mean lies sqrt(2 / pi) deviations below the bound, and 1 - 2 / pi of the variance.
  const double pi = 3.141592653589793;
  tracker.set_payload(rme::PayloadGaussian<double>::independent({3, 0, 0, 0.1}, {0.3, 0.01, 0.01, 0.01}));
  CHECK(tracker.belief().payload.mean[0] == Approx(3 - 0.3 * std::sqrt(2 / pi)).margin(0.01));
  CHECK(tracker.belief().payload.covariance(0, 0) == Approx(0.09 * (1 - 2 / pi)).margin(0.003));
  tracker.set_payload(rme::PayloadGaussian<double>::independent({0, 0, 0, 0.1}, {0.3, 0.01, 0.01, 0.01}));
  CHECK(tracker.belief().payload.mean[0] == Approx(0.3 * std::sqrt(2 / pi)).margin(0.01));
}

TEST_CASE("Tracker: a block is taken in by as many steps as are said, or all at once when the next one comes",
          "[tracker]") {
  rme::Tracker<double, 7> stepwise(rme::ArmPrior<double, 7>::of(kRated), rme::PayloadPrior<double>::of(kRated), kRated,
                                   std::nullopt);
  auto hasty = stepwise;
  CHECK_FALSE(stepwise.busy());
  CHECK_FALSE(stepwise.advance());
  const auto& model = rme::examples::panda();
  const auto at = model.kinematics(model.ready);
  rme::BlockAverager<double, 7> averager(0, model.gravity_vector);
  rme::Proprioception<double, 7> sample;
  sample.jacobian = at.jacobian;
  sample.rotation = at.rotation;
  int blocks = 0;
  for (int k = 0; k <= 200; ++k) {
    const rme::Payload<double> held{k < 100 ? 0 : 0.8, {0, 0, 0.1}};
    sample.tau_ext = at.jacobian.transpose() * rme::payload_wrench<double>(held, at.rotation).vector();
    sample.tau_ext += 0.02 * Joints::NullaryExpr([k](Eigen::Index j) { return std::sin(double(7 * k + j * j)); });
    if (!averager.add(sample, 1e-3, 1e-3 * k)) continue;
    ++blocks;
    const double before = stepwise.belief().probability[Hypothesis::Empty];
    stepwise.begin(averager.block(), false);
    hasty.begin(averager.block(), false);
    for (int i = 1; i < rme::Tracker<double, 7>::kSteps; ++i) {
      CHECK_FALSE(stepwise.advance());
      CHECK(stepwise.busy());
      CHECK(stepwise.belief().probability[Hypothesis::Empty] == before);
    }
    CHECK(stepwise.advance());
    CHECK_FALSE(stepwise.busy());
    double sum = 0;
    for (const double p : stepwise.belief().probability.values) sum += p;
    CHECK(sum == Approx(1));
  }
  REQUIRE(blocks == 10);
  while (hasty.busy()) hasty.advance();
  CHECK(hasty.belief().payload.mean == stepwise.belief().payload.mean);
  CHECK(hasty.belief().payload.covariance == stepwise.belief().payload.covariance);
  CHECK(stepwise.belief().payload.mean[0] == Approx(0.8).margin(0.05));
}

}  // namespace
