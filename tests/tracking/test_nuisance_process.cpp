#include <algorithm>
#include <cmath>
#include <random>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/nuisance_process.hpp>

#include "support/catch.hpp"
#include "tracking/joint_scene.hpp"

namespace {

using namespace rme::testing::joints;
using rme::Sensing;

constexpr double kTurns = 1;  // change of the torque that draws the stiction anew, in Coulomb frictions
/// What is left of the stiction after a block in which other joints move.
const double kHold = std::exp(-kPeriod * rme::kind_of(Sensing::JointFriction).creep);

/// What (T27) says of the residual, and what drifts by 2e-4 N m of the arm's scale, or by 1e-4 of itself.
Life life_of(const Scene& scene, int j, Sensing sensing, double speed, double turned = 0) {
  Life life;
  const double keep = std::exp(-speed * kPeriod / rme::kind_of(sensing).way - rme::kind_of(sensing).turn * turned);
  life.F(rme::kResidual, rme::kResidual) = keep;
  life.Q(rme::kResidual, rme::kResidual) = (1 - keep * keep) * scene.model.noise().residual_variance(j);
  life.Q(rme::kOffset, rme::kOffset) = std::pow(2e-4 * kArm.residual[j], 2);
  if (sensing == Sensing::LinkSide) return life;
  life.Q(rme::kCoulomb, rme::kCoulomb) = std::pow(1e-4 * kArm.coulomb[j], 2);
  life.Q(rme::kViscous, rme::kViscous) = std::pow(1e-4 * kArm.viscous[j], 2);
  return life;
}
void hold(Life& life, double share, double variance) {
  life.F(rme::kStiction, rme::kStiction) = share;
  life.Q(rme::kStiction, rme::kStiction) = (1 - share * share) * variance;
}

TEST_CASE("NuisanceProcess: a rough arm's joint that turns back is noisy for a while, and its residual is another one",
          "[nuisance_process]") {
  Scene scene(Sensing::RoughModel);
  for (int k = 0; k < 50; ++k) scene.block(Joints(0.3, 0.3));
  const double residual = std::sqrt(scene.model.noise().residual_variance(0));
  const double quiet = scene.model.observation(0, {}).noise;
  scene.star.joint(0).mean[rme::kResidual] = scene.star.joint(1).mean[rme::kResidual] = 1;
  scene.block(Joints(-0.3, 0.3));
  // From 0.3 / 0.35 to its opposite is a change of 1.71; the other joint has gone its way, as far as both together.
  const double way = std::sqrt(0.18) * 0.02, kept = std::exp(-way / rme::kind_of(Sensing::RoughModel).way);
  CHECK(scene.star.joint(0).mean[rme::kResidual] == Approx(kept * std::exp(-0.6 / 0.35)));
  CHECK(scene.star.joint(1).mean[rme::kResidual] == Approx(kept));
  CHECK(scene.deviation(0, rme::kResidual) == Approx(residual).epsilon(0.05));
  // It turned over completely, and rests for 1 %, since it moves a hundred times as fast as what counts as half at rest.
  const double most = kRough.turn_noise + kRough.stop_noise * 0.003 / 0.303;
  CHECK(scene.model.observation(0, {}).noise == Approx(quiet + most * residual * residual).epsilon(0.02));
  CHECK(scene.model.observation(1, {}).noise == Approx(scene.model.noise().variance(1)));
  for (int k = 0; k < 50; ++k) scene.block(Joints(-0.3, 0.3));
  CHECK(scene.model.observation(0, {}).noise < quiet + 0.1 * residual * residual);
}

TEST_CASE("NuisanceProcess: a moving arm's nuisances live on as theory says, in any star", "[nuisance_process]") {
  const unsigned seed = 700;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (const Sensing sensing : {Sensing::LinkSide, Sensing::JointFriction}) {
    Scene scene(sensing);
    const auto before = scene.star = any_star(random);
    scene.block(Joints(3, -4));
    for (int j = 0; j < kDofs; ++j) check_life(before, scene.star, j, life_of(scene, j, sensing, 5));
  }
}

TEST_CASE("NuisanceProcess: what holds a resting joint wanders while others move, and stays while none does",
          "[nuisance_process]") {
  const unsigned seed = 701;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Scene scene(Sensing::JointFriction);
  auto before = scene.star = any_star(random);
  scene.block(Joints(0, 0.5));
  Life life = life_of(scene, 0, Sensing::JointFriction, 0.5);
  hold(life, kHold, std::pow(0.6 * kArm.coulomb[0], 2));
  check_life(before, scene.star, 0, life);
  CHECK(scene.model.stiction_jump(scene.star, 0) == Approx(std::pow(1.5 * kArm.coulomb[0], 2)));
  CHECK(scene.model.stiction_jump(scene.star, 1) == 0);  // it moves

  Scene still(Sensing::JointFriction);
  before = still.star = any_star(random);
  still.block(Joints::Zero());
  for (int j = 0; j < kDofs; ++j) {
    check_life(before, still.star, j, life_of(still, j, Sensing::JointFriction, 0));
    CHECK(still.model.stiction_jump(still.star, j) == 0);
  }
  Scene behind(Sensing::LinkSide);
  behind.block(Joints(0, 0.5));
  CHECK(behind.model.stiction_jump(behind.star, 0) == 0);
}

TEST_CASE("NuisanceProcess: friction holds a resting joint with no more than motion has shown", "[nuisance_process]") {
  for (const double shown : {0.02, 10.0}) {
    CAPTURE(shown);
    Scene scene(Sensing::JointFriction);
    auto& joint = scene.star.joint(0);
    // Half of it is known to belong to the payload's mass.
    scene.star.draw_payload(2 * rme::InertialVector<double>::Unit(0), rme::InertialMatrix<double>::Zero());
    joint.slope(rme::kPayload, rme::kCoulomb) = 0.25 * shown;
    joint.mean[rme::kCoulomb] = 0.5 * shown;
    joint.covariance(rme::kCoulomb, rme::kCoulomb) = 0.01 * 0.01;
    joint.covariance(rme::kStiction, rme::kStiction) = 0.3 * 0.3;
    const double square = shown * shown + 0.01 * 0.01 + std::pow(1e-4 * kArm.coulomb[0], 2);
    const double variance = std::min(std::pow(0.6 * kArm.coulomb[0], 2), square), keep = kHold * kHold;
    scene.block(Joints(0, 0.5));
    CHECK(joint.covariance(rme::kStiction, rme::kStiction) == Approx(keep * 0.3 * 0.3 + (1 - keep) * variance));
    CHECK(scene.model.stiction_jump(scene.star, 0) == Approx(6.25 * variance));
  }
}

TEST_CASE("NuisanceProcess: what holds a resting joint turns over as its torque changes, if friction is sure to show",
          "[nuisance_process]") {
  // Of a ramp what it goes in a block, of a step a fifth of it in the first; a quarter of three deviations, 0.1
  // and 0.2 N m, may be noise.
  const unsigned seed = 703;
  CAPTURE(seed);
  std::mt19937 random(seed);
  // In a block in which joint 0 rests at `tau`, and joint 1 turns at `speed`.
  const auto turned = [&](Scene& scene, double speed, const Joints& tau, double change) {
    CAPTURE(speed, change);
    const auto before = scene.star = any_star(random);
    scene.block(Joints(0, speed), tau);
    Life life = life_of(scene, 0, Sensing::JointFriction, speed);
    const double hold_still = speed > 0 ? kHold : 1;
    hold(life, hold_still * std::exp(-change / (kTurns * kArm.coulomb[0])), std::pow(0.6 * kArm.coulomb[0], 2));
    check_life(before, scene.star, 0, life);
  };
  for (const bool shows : {true, false}) {
    for (const double speed : {0.0, 0.5}) {
      CAPTURE(shows, speed);
      const double counts = shows || speed > 0 ? 1 : 0;
      Scene step(Sensing::JointFriction);
      step.context.friction_shows = shows;
      step.block(Joints::Zero());
      turned(step, speed, {0.18, 0.37}, 0);
      turned(step, speed, {1, 0.2}, counts * 0.25 * (0.8 * (1 - 0.2 * 0.18) - 0.3));
      Scene ramp(Sensing::JointFriction);
      ramp.context.friction_shows = shows;
      for (int k = 0; k < 200; ++k) ramp.block(Joints::Zero(), Joints(-0.2 * k, 3));
      turned(ramp, speed, {-0.2 * 200, 3}, counts * (0.2 - 0.25 * 0.3));
    }
  }
}

TEST_CASE("NuisanceProcess: what holds a resting joint turns over as its own compensation changes, however slowly",
          "[nuisance_process]") {
  const unsigned seed = 704;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const double keep = std::exp(-kPeriod / 0.04);  // of what is yet to show in tau_ext, over a block
  for (const bool shows : {true, false}) {
    CAPTURE(shows);
    Scene scene(Sensing::JointFriction);
    scene.context.friction_shows = shows;
    scene.block(Joints::Zero());
    // Either way; that of joint 0 does not change.
    double pending = 0;
    for (const double change : {0.01, 0.0, -0.02, 0.0}) {
      CAPTURE(change);
      scene.context.compensation_change = Joints(0, 0.7 * change);
      const auto before = scene.star = any_star(random);
      scene.block(Joints::Zero());
      pending += 0.7 * std::abs(change);
      Life life = life_of(scene, 1, Sensing::JointFriction, 0);
      hold(life, shows ? std::exp(-(1 - keep) * pending / (kTurns * kArm.coulomb[1])) : 1,
           std::pow(0.6 * kArm.coulomb[1], 2));
      pending *= keep;
      check_life(before, scene.star, 1, life);
      life = life_of(scene, 0, Sensing::JointFriction, 0);
      hold(life, 1, std::pow(0.6 * kArm.coulomb[0], 2));
      check_life(before, scene.star, 0, life);
    }
  }
}

TEST_CASE("NuisanceProcess: a joint that stops is held by 0.95 of its friction, and shares what is known of that",
          "[nuisance_process]") {
  const unsigned seed = 702;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Scene scene(Sensing::JointFriction);
  scene.block(Joints(-0.5, 0.5));
  const auto before = scene.star = any_star(random);
  scene.block(Joints(0, 0.5));
  Life life = life_of(scene, 0, Sensing::JointFriction, 0.5);
  life.F(rme::kStiction, rme::kStiction) = 0;
  life.F(rme::kStiction, rme::kCoulomb) = 0.95;  // it moved backwards, so that friction pointed forwards
  // What drifted this block has drifted in both.
  life.Q.row(rme::kStiction) = 0.95 * life.Q.row(rme::kCoulomb);
  life.Q.col(rme::kStiction) = 0.95 * life.Q.col(rme::kCoulomb);
  life.Q(rme::kStiction, rme::kStiction) =
      0.95 * 0.95 * life.Q(rme::kCoulomb, rme::kCoulomb) + std::pow(0.15 * before.joint(0).mean[rme::kCoulomb], 2);
  check_life(before, scene.star, 0, life);
  check_life(before, scene.star, 1, life_of(scene, 1, Sensing::JointFriction, 0.5));
}

TEST_CASE("NuisanceProcess: a rough arm's joint that turns forgets its residual and half as fast what held it",
          "[nuisance_process]") {
  const unsigned seed = 703;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (const double last : {0.2, 0.0}) {  // slower, or at rest
    Scene scene(Sensing::RoughModel);
    scene.block(Joints(0.5, 0));
    const auto before = scene.star = any_star(random);
    scene.block(Joints(last, -0.15));
    const double turned[] = {0.5 / 0.55 - last / (last + 0.05), 0.15 / 0.2};  // changes of v / (|v| + 0.05)
    for (int j = 0; j < kDofs; ++j) {
      Life life = life_of(scene, j, Sensing::RoughModel, std::hypot(last, 0.15), turned[j]);
      hold(life, std::exp(-kPeriod * kRough.creep - 0.5 * kRough.turn * turned[j]),
           std::pow(0.6 * kArm.coulomb[j], 2) + kRough.stiction * scene.model.noise().residual_variance(j));
      check_life(before, scene.star, j, life);
    }
  }
}

TEST_CASE("NuisanceProcess: without friction in its torque, a resting joint keeps what it knows of it",
          "[nuisance_process]") {
  const unsigned seed = 705;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Scene scene(Sensing::LinkSide);
  scene.block(Joints::Zero());
  const auto before = scene.star = any_star(random);
  scene.block(Joints::Zero());
  for (int j = 0; j < kDofs; ++j) check_life(before, scene.star, j, life_of(scene, j, Sensing::LinkSide, 0));
}

TEST_CASE("NuisanceProcess: how much a joint moves, rests or goes both ways is a share of the block",
          "[nuisance_process]") {
  const auto shares = [](const Eigen::Matrix<double, 1, rme::kBlockParts>& velocities) {
    Scene scene(Sensing::JointFriction);
    Block block = at_rest();
    block.velocities.row(0) = velocities;
    block.velocity[0] = velocities.mean();
    scene.regime.update(block);
    scene.model.begin(block, scene.regime, scene.context);
    const auto c = scene.model.observation(0, {}).c;
    return std::pair(-c[rme::kCoulomb], c[rme::kStiction]);
  };
  CHECK(shares({0, 0, 0, 0}) == std::pair(0.0, 1.0));
  CHECK(shares({-0.1, -0.1, -0.1, -0.1}) == std::pair(-1.0, 0.0));
  CHECK(shares({0, 0, 0, 0.1}) == std::pair(0.25, 0.75));
  CHECK(shares({0.1, 0.1, -0.1, -0.1}) == std::pair(0.0, 0.0));
}

TEST_CASE("NuisanceProcess: what its caller adds to the residual's variance, the residual is drawn from",
          "[nuisance_process]") {
  const unsigned seed = 706;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const rme::SensingKind& kind = rme::kind_of(Sensing::LinkSide);
  rme::NuisanceProcess<double, kDofs> process(kind, kArm);
  CHECK((process.arm().coulomb.isZero() && process.arm().viscous.isZero()));  // no friction shows
  const rme::SensorNoise<double, kDofs> noise(kind, kArm);
  Block block = at_rest();
  block.velocity = Joints(3, -4);
  block.velocities = block.velocity.replicate<1, rme::kBlockParts>();
  Regime regime;
  regime.update(block);
  process.begin(block, regime, {}, noise);
  const auto before = any_star(random);
  auto after = before;
  const Joints more(0.3, 0.02);
  process.predict(after, noise, more);
  const double keep = std::exp(-5 * kPeriod / kind.way);
  for (int j = 0; j < kDofs; ++j) {
    Life life;
    life.F(rme::kResidual, rme::kResidual) = keep;
    life.Q(rme::kResidual, rme::kResidual) = (1 - keep * keep) * (noise.residual_variance(j) + more[j]);
    life.Q(rme::kOffset, rme::kOffset) = std::pow(2e-4 * kArm.residual[j], 2);
    check_life(before, after, j, life);
  }
}

TEST_CASE("NuisanceProcess: the noise of joints that turn over is scaled by what has been learned of it",
          "[nuisance_process]") {
  Scene scene(Sensing::RoughModel);
  scene.block(Joints(0.3, 0.3));
  scene.block(Joints(-0.3, 0.3));
  for (int k = 0; k < 5; ++k) {  // innovations of thrice the size that is expected
    scene.model.learn(1, Joints::Constant(3), Joints::Ones());
    scene.block(Joints(k % 2 == 0 ? 0.3 : -0.3, 0.3));
  }
  const auto& noise = scene.model.noise();
  REQUIRE(noise.turn_scale() > 1.05);
  const double turned = kRough.turn_noise + kRough.stop_noise * 0.003 / 0.303;
  const double expected = turned * noise.residual_variance(0) * noise.turn_scale();
  CHECK(scene.model.observation(0, {}).noise - scene.model.observation(1, {}).noise ==
        Approx(expected + noise.variance(0) - noise.variance(1)));
}

}  // namespace
