#include <cmath>
#include <random>
#include <rme/tracking/bank/joint_torque_model.hpp>

#include "support/catch.hpp"

namespace {

constexpr int kDofs = 2;
using Model = rme::bank::JointTorqueModel<double, kDofs>;
using Block = rme::TorqueBlock<double, kDofs>;
using Regime = rme::FrictionRegime<double, kDofs>;
using Joints = rme::JointVector<double, kDofs>;
using rme::Sensing;

/// What such an arm may show: another one in each joint.
const rme::ArmPrior<double, kDofs> kArm = {Joints(0.1, 0.2), Joints(0.3, 0.4), Joints(1, 2), Joints(0.5, 0.6),
                                           Joints(0.2, 0.1)};

/// Nothing moves, nothing is held, no torque shows.
Block at_rest() {
  Block block;
  block.duration = 0.02;
  block.samples = 20;
  block.tau.setZero();
  block.regressor.setZero();
  block.jacobian.setZero();
  block.rotation.setIdentity();
  block.velocity.setZero();
  block.velocities.setZero();
  block.torque_step.setZero();
  block.torque_rate.setZero();
  block.velocity_noise.setZero();
  return block;
}

/// A model that is shown one block after another.
struct Scene {
  explicit Scene(Sensing sensing) : model(sensing, kArm, 0.01), star(model.prior()) {}
  void block(const Joints& velocity, double tau = 0) { block(velocity, Joints(Joints::Constant(tau))); }
  void block(const Joints& velocity, const Joints& tau, const Joints& torque_step = Joints::Zero()) {
    Block block = at_rest();
    block.tau = tau;
    block.regressor(1, 3) = 0.7;
    block.velocity = velocity;
    block.velocities = velocity.replicate<1, rme::kBlockParts>();
    block.torque_step = torque_step;
    regime.update(block);
    model.begin(block, regime, context);
    model.predict(star);
  }
  double deviation(int j, rme::bank::Nuisance n) const { return std::sqrt(star.joint(j).covariance(n, n)); }

  Model model;
  Regime regime;
  rme::bank::BlockContext<double> context;
  rme::bank::StarGaussian<double, kDofs> star;
};

TEST_CASE("JointTorqueModel: behind the gears there is no friction, moving or not", "[joint_torque]") {
  Scene scene(Sensing::LinkSide);
  for (const double velocity : {0.0, 0.3, -0.3}) {
    scene.block(Joints::Constant(velocity));
    for (int j = 0; j < kDofs; ++j)
      CHECK(scene.model.observation(j, 0).c == rme::bank::JointNuisanceVector<double>(1, 0, 0, 1, 0));
  }
  CHECK(scene.deviation(0, rme::bank::kCoulomb) == 0);
}

TEST_CASE("JointTorqueModel: a lag counts for 0.6 s after it has shown, and after each large change from then on",
          "[joint_torque]") {
  for (const Sensing sensing : {Sensing::LinkSide, Sensing::JointFriction, Sensing::RoughModel}) {
    Model model(sensing, kArm, 0.01);
    Regime regime;
    // How long it counts in a block of this rate, in blocks of the same rate.
    const auto lag_after = [&](double rate) {
      Block block = at_rest();
      block.torque_rate = Joints(rate, 0.5 * rate);
      regime.update(block);
      model.begin(block, regime);
      return Joints(model.observation(0, 0).c[rme::bank::kLag], model.observation(1, 0).c[rme::bank::kLag]);
    };
    const bool link_side = sensing == Sensing::LinkSide;
    const double large = 21 * std::sqrt(model.noise().variance(0)) / 0.02, small = 0.9 * large;
    CHECK(lag_after(large).isZero(0));  // nothing is late yet
    if (link_side) CHECK(model.prior().joint(0).covariance(rme::bank::kLag, rme::bank::kLag) == Approx(0.015 * 0.015));
    CHECK(model.unexplained(Joints(0.02 * large, 0), Joints::Ones()) == link_side);
    int blocks = 0;
    while (blocks < 100 && !lag_after(small).isZero(0)) ++blocks;
    CHECK(blocks == (link_side ? 29 : 0));
    CHECK(lag_after(small).isZero(0));
    const Joints lag = lag_after(-large);
    CHECK(lag == (link_side ? Joints(-large, -0.5 * large) : Joints(0, 0)));
    blocks = 0;
    while (blocks < 100 && !lag_after(small).isZero(0)) ++blocks;
    CHECK(blocks == (link_side ? 29 : 0));
  }
}

TEST_CASE(
    "JointTorqueModel: torque is late if a lag of 21 ms leaves as much as is unexplained, at the rate of this block or "
    "the last",
    "[joint_torque]") {
  const Joints variance(1, 0.2);
  for (const auto& [last, now] : {std::pair{Joints(0, 0), Joints(-3, 1)},
                                  {Joints(-3, 1), Joints(0, 0)},
                                  {Joints(1, -1), Joints(-3, 0.5)},
                                  {Joints(-3, 0.5), Joints(2, 1)}}) {
    const Joints rate = now.cwiseAbs().cwiseMax(last.cwiseAbs());
    for (const double lag : {0.0209, 0.0211}) {
      CAPTURE(last.transpose(), now.transpose(), lag);
      Model model(Sensing::LinkSide, kArm, 0.01);
      Regime regime;
      Block block = at_rest();
      regime.update(block);
      for (const Joints& r : {last, now}) {
        block.torque_rate = r;
        model.begin(block, regime);
      }
      // Any innovation counts in its standard deviations.
      const double length = lag * std::sqrt((rate.array().square() / variance.array()).sum());
      const Joints innovation(0.6 * length, -0.8 * length * std::sqrt(variance[1]));
      CHECK(model.unexplained(innovation, variance) == (lag < 0.021));
      model.begin(block, regime);
      CHECK((model.observation(0, 0).c[rme::bank::kLag] == now[0]) == (lag < 0.021 || now[0] == 0));
      CHECK_FALSE(model.unexplained(Joints::Constant(std::nan("")), variance));
    }
  }
}

TEST_CASE("JointTorqueModel: friction acts against the motion, and what a joint held when it stopped, it holds",
          "[joint_torque]") {
  Scene scene(Sensing::JointFriction);
  scene.block(Joints(0.3, -0.3));
  CHECK(scene.model.observation(0, 0).c == rme::bank::JointNuisanceVector<double>(1, -1, -0.3, 1, 0));
  CHECK(scene.model.observation(1, 0).c == rme::bank::JointNuisanceVector<double>(1, 1, 0.3, 1, 0));
  scene.block(Joints::Zero());
  for (int j = 0; j < kDofs; ++j) {
    CHECK(scene.model.observation(j, 0).c == rme::bank::JointNuisanceVector<double>(1, 0, 0, 1, 1));
    const double sign = j == 0 ? -1 : 1;
    CHECK(scene.star.joint(j).mean[rme::bank::kStiction] == Approx(0.95 * sign * kArm.coulomb[j]));
  }
}

TEST_CASE("JointTorqueModel: a rough arm's friction fades into what holds it at rest", "[joint_torque]") {
  Scene scene(Sensing::RoughModel);
  double last = 1;
  for (const double velocity : {0.0, 0.003, 0.03, 1.0}) {
    scene.block(Joints(velocity, -velocity));
    const auto c = scene.model.observation(0, 0).c, opposite = scene.model.observation(1, 0).c;
    CHECK(c[rme::bank::kStiction] == Approx(0.003 / (velocity + 0.003)));
    CHECK(c[rme::bank::kCoulomb] == Approx(c[rme::bank::kStiction] - 1));
    CHECK(opposite[rme::bank::kCoulomb] == Approx(-c[rme::bank::kCoulomb]));
    CHECK(c[rme::bank::kStiction] <= last);
    last = c[rme::bank::kStiction];
  }
}

TEST_CASE("JointTorqueModel: a rough arm's joint that turns back is noisy for a while, and its residual is another one",
          "[joint_torque]") {
  Scene scene(Sensing::RoughModel);
  for (int k = 0; k < 50; ++k) scene.block(Joints(0.3, 0.3));
  const double residual = std::sqrt(scene.model.noise().residual_variance(0));
  const double quiet = scene.model.observation(0, 0).noise;
  scene.star.joint(0).mean[rme::bank::kResidual] = scene.star.joint(1).mean[rme::bank::kResidual] = 1;
  scene.block(Joints(-0.3, 0.3));
  // From 0.3 / 0.35 to its opposite is a change of 1.71; the other joint has gone its way, as far as both together.
  const double way = std::sqrt(0.18) * 0.02, kept = std::exp(-way / 1.2);
  CHECK(scene.star.joint(0).mean[rme::bank::kResidual] == Approx(kept * std::exp(-0.6 / 0.35)));
  CHECK(scene.star.joint(1).mean[rme::bank::kResidual] == Approx(kept));
  CHECK(scene.deviation(0, rme::bank::kResidual) == Approx(residual).epsilon(0.05));
  CHECK(scene.model.observation(0, 0).noise > quiet + 5.9 * residual * residual);
  CHECK(scene.model.observation(1, 0).noise == Approx(scene.model.noise().variance(1)));
  for (int k = 0; k < 50; ++k) scene.block(Joints(-0.3, 0.3));
  CHECK(scene.model.observation(0, 0).noise < quiet + 0.1 * residual * residual);
}

TEST_CASE("JointTorqueModel: noise of dq is noise of the inertia force, in proportion to the mass", "[joint_torque]") {
  Model model(Sensing::LinkSide, kArm, 0.01);
  Block block = at_rest();
  block.jacobian(2, 0) = 0.5;
  block.acceleration_variance = 0.003;
  model.begin(block, Regime());
  const double floor = model.observation(0, 0).noise, held = model.observation(0, 2).noise - floor;
  // (m J)^2 of the acceleration's variance, 2.5 times that.
  CHECK(held == Approx(2 * 2 * 0.25 * 2.5 * 0.003));
  CHECK(model.observation(1, 2).noise == Approx(model.observation(1, 0).noise));
}

using Beta = rme::bank::JointNuisanceVector<double>;
using BetaMatrix = rme::bank::JointNuisanceMatrix<double>;

/// Every number of every joint is another one.
rme::bank::StarGaussian<double, kDofs> any_star(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  rme::bank::StarGaussian<double, kDofs> star;
  for (int j = 0; j < kDofs; ++j) {
    const BetaMatrix L = BetaMatrix::NullaryExpr(draw);
    star.joint(j).mean = Beta::NullaryExpr(draw);
    star.joint(j).slope = star.joint(j).slope.NullaryExpr(draw);
    star.joint(j).covariance = L * L.transpose();
  }
  return star;
}

/// Nuisances live on by beta <- F beta + N(0, Q); the definition of a star says what becomes of its three parts.
struct Life {
  BetaMatrix F = BetaMatrix::Identity(), Q = BetaMatrix::Zero();
};
void check_life(const rme::bank::StarGaussian<double, kDofs>& before,
                const rme::bank::StarGaussian<double, kDofs>& after, int j, const Life& life) {
  CAPTURE(j);
  const auto& [mean, slope, covariance] = before.joint(j);
  CHECK((after.joint(j).mean - life.F * mean).norm() < 1e-12);
  CHECK((after.joint(j).slope - slope * life.F.transpose()).norm() < 1e-12);
  CHECK((after.joint(j).covariance - life.F * covariance * life.F.transpose() - life.Q).norm() < 1e-12);
}

constexpr double kPeriod = 0.02;  // [s]

/// What (T27) says of the residual, and what drifts by 2e-4 N m of the arm's scale, or by 1e-4 of itself.
Life life_of(const Scene& scene, int j, Sensing sensing, double speed, double turned = 0) {
  Life life;
  const double keep = std::exp(-speed * kPeriod / (sensing == Sensing::RoughModel ? 1.2 : 0.7)) * std::exp(-turned);
  life.F(rme::bank::kResidual, rme::bank::kResidual) = keep;
  life.Q(rme::bank::kResidual, rme::bank::kResidual) = (1 - keep * keep) * scene.model.noise().residual_variance(j);
  life.Q(rme::bank::kOffset, rme::bank::kOffset) = std::pow(2e-4 * kArm.residual[j], 2);
  if (sensing == Sensing::LinkSide) return life;
  life.Q(rme::bank::kCoulomb, rme::bank::kCoulomb) = std::pow(1e-4 * kArm.coulomb[j], 2);
  life.Q(rme::bank::kViscous, rme::bank::kViscous) = std::pow(1e-4 * kArm.viscous[j], 2);
  return life;
}
void hold(Life& life, double share, double variance) {
  life.F(rme::bank::kStiction, rme::bank::kStiction) = share;
  life.Q(rme::bank::kStiction, rme::bank::kStiction) = (1 - share * share) * variance;
}

TEST_CASE("JointTorqueModel: a moving arm's nuisances live on as theory says, in any star", "[joint_torque]") {
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

TEST_CASE("JointTorqueModel: what holds a resting joint wanders while others move, and stays while none does",
          "[joint_torque]") {
  const unsigned seed = 701;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Scene scene(Sensing::JointFriction);
  auto before = scene.star = any_star(random);
  scene.block(Joints(0, 0.5));
  Life life = life_of(scene, 0, Sensing::JointFriction, 0.5);
  hold(life, std::exp(-kPeriod / 20), std::pow(0.6 * kArm.coulomb[0], 2));
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

TEST_CASE("JointTorqueModel: friction holds a resting joint with no more than motion has shown", "[joint_torque]") {
  for (const double shown : {0.02, 10.0}) {
    CAPTURE(shown);
    Scene scene(Sensing::JointFriction);
    auto& joint = scene.star.joint(0);
    // Half of it is known to belong to the payload's mass.
    scene.star.replace_payload(2 * rme::InertialVector<double>::Unit(0), rme::InertialMatrix<double>::Zero());
    joint.slope(0, rme::bank::kCoulomb) = 0.25 * shown;
    joint.mean[rme::bank::kCoulomb] = 0.5 * shown;
    joint.covariance(rme::bank::kCoulomb, rme::bank::kCoulomb) = 0.01 * 0.01;
    joint.covariance(rme::bank::kStiction, rme::bank::kStiction) = 0.3 * 0.3;
    const double square = shown * shown + 0.01 * 0.01 + std::pow(1e-4 * kArm.coulomb[0], 2);
    const double variance = std::min(std::pow(0.6 * kArm.coulomb[0], 2), square), keep = std::exp(-2 * kPeriod / 20);
    scene.block(Joints(0, 0.5));
    CHECK(joint.covariance(rme::bank::kStiction, rme::bank::kStiction) ==
          Approx(keep * 0.3 * 0.3 + (1 - keep) * variance));
    CHECK(scene.model.stiction_jump(scene.star, 0) == Approx(6.25 * variance));
  }
}

TEST_CASE("JointTorqueModel: what holds a resting joint turns over as its torque changes, if friction is sure to show",
          "[joint_torque]") {
  // Of a ramp what it goes in a block, of a step a fifth of it in the first; a quarter of 1.5 deviations, 0.1 and
  // 0.2 N m, may be noise.
  const unsigned seed = 703;
  CAPTURE(seed);
  std::mt19937 random(seed);
  // In a block in which joint 0 rests at `tau`, and joint 1 turns at `speed`.
  const auto turned = [&](Scene& scene, double speed, const Joints& tau, double change) {
    CAPTURE(speed, change);
    const auto before = scene.star = any_star(random);
    scene.block(Joints(0, speed), tau);
    Life life = life_of(scene, 0, Sensing::JointFriction, speed);
    const double hold_still = speed > 0 ? std::exp(-kPeriod / 20) : 1;
    hold(life, hold_still * std::exp(-change / kArm.coulomb[0]), std::pow(0.6 * kArm.coulomb[0], 2));
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
      turned(step, speed, {1, 0.2}, counts * 0.25 * (0.8 * (1 - 0.2 * 0.18) - 0.15));
      Scene ramp(Sensing::JointFriction);
      ramp.context.friction_shows = shows;
      for (int k = 0; k < 200; ++k) ramp.block(Joints::Zero(), Joints(-0.2 * k, 3));
      turned(ramp, speed, {-0.2 * 200, 3}, counts * (0.2 - 0.25 * 0.15));
    }
  }
}

TEST_CASE("JointTorqueModel: what holds a resting joint turns over as its own compensation changes, however slowly",
          "[joint_torque]") {
  const unsigned seed = 704;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const double keep = std::exp(-kPeriod / 0.04);  // of what is yet to show in tau_ext, over a block
  for (const bool shows : {true, false}) {
    CAPTURE(shows);
    Scene scene(Sensing::JointFriction);
    scene.context.friction_shows = shows;
    scene.block(Joints::Zero());
    // Joint 1 sees a hundredth of 0.7 of what phi changes by, either way; joint 0 nothing.
    double pending = 0;
    for (const double change : {0.01, 0.0, -0.02, 0.0}) {
      CAPTURE(change);
      scene.context.compensation_change[3] = change;
      const auto before = scene.star = any_star(random);
      scene.block(Joints::Zero());
      pending += 0.7 * std::abs(change);
      Life life = life_of(scene, 1, Sensing::JointFriction, 0);
      hold(life, shows ? std::exp(-(1 - keep) * pending / kArm.coulomb[1]) : 1, std::pow(0.6 * kArm.coulomb[1], 2));
      pending *= keep;
      check_life(before, scene.star, 1, life);
      life = life_of(scene, 0, Sensing::JointFriction, 0);
      hold(life, 1, std::pow(0.6 * kArm.coulomb[0], 2));
      check_life(before, scene.star, 0, life);
    }
  }
}

TEST_CASE("JointTorqueModel: a joint that stops is held by 0.95 of its friction, and shares what is known of that",
          "[joint_torque]") {
  const unsigned seed = 702;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Scene scene(Sensing::JointFriction);
  scene.block(Joints(-0.5, 0.5));
  const auto before = scene.star = any_star(random);
  scene.block(Joints(0, 0.5));
  Life life = life_of(scene, 0, Sensing::JointFriction, 0.5);
  life.F(rme::bank::kStiction, rme::bank::kStiction) = 0;
  life.F(rme::bank::kStiction, rme::bank::kCoulomb) = 0.95;  // it moved backwards, so that friction pointed forwards
  // What drifted this block has drifted in both.
  life.Q.row(rme::bank::kStiction) = 0.95 * life.Q.row(rme::bank::kCoulomb);
  life.Q.col(rme::bank::kStiction) = 0.95 * life.Q.col(rme::bank::kCoulomb);
  life.Q(rme::bank::kStiction, rme::bank::kStiction) = 0.95 * 0.95 * life.Q(rme::bank::kCoulomb, rme::bank::kCoulomb) +
                                                       std::pow(0.15 * before.joint(0).mean[rme::bank::kCoulomb], 2);
  check_life(before, scene.star, 0, life);
  check_life(before, scene.star, 1, life_of(scene, 1, Sensing::JointFriction, 0.5));
}

TEST_CASE("JointTorqueModel: a rough arm's joint that turns forgets its residual and half as fast what held it",
          "[joint_torque]") {
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
      hold(life, std::exp(-kPeriod / 2 - 0.5 * turned[j]),
           std::pow(0.6 * kArm.coulomb[j], 2) + 16 * scene.model.noise().residual_variance(j));
      check_life(before, scene.star, j, life);
    }
  }
}

TEST_CASE("JointTorqueModel: the prior is the arm's, friction give or take half of it", "[joint_torque]") {
  for (const Sensing sensing : {Sensing::LinkSide, Sensing::JointFriction, Sensing::RoughModel}) {
    const Model model(sensing, kArm, 0.01);
    const auto star = model.prior();
    const bool friction = sensing != Sensing::LinkSide;
    for (int j = 0; j < kDofs; ++j) {
      Beta mean = Beta::Zero(), variance = Beta::Zero();
      variance[rme::bank::kOffset] = std::pow(kArm.offset[j], 2);
      if (!friction) variance[rme::bank::kLag] = std::pow(0.015, 2);
      if (friction) {
        mean[rme::bank::kCoulomb] = kArm.coulomb[j];
        mean[rme::bank::kViscous] = kArm.viscous[j];
        variance[rme::bank::kCoulomb] = std::pow(kArm.coulomb[j] / 2, 2);
        variance[rme::bank::kViscous] = std::pow(kArm.viscous[j] / 2, 2);
        variance[rme::bank::kStiction] = std::pow(0.6 * kArm.coulomb[j], 2);
      }
      if (sensing == Sensing::RoughModel) variance[rme::bank::kStiction] += 16 * model.noise().residual_variance(j);
      CHECK(star.joint(j).mean == mean);
      CHECK((star.joint(j).covariance - BetaMatrix(variance.asDiagonal())).norm() < 1e-14);
    }
    CHECK(model.rough() == (sensing == Sensing::RoughModel));
    CHECK(model.learns_lag() == (sensing == Sensing::LinkSide));
  }
}

TEST_CASE("JointTorqueModel: reopening forgets what can hide a payload altogether, and of the offset how sure it was",
          "[joint_torque]") {
  const unsigned seed = 704;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const Model model(Sensing::RoughModel, kArm, 0.01);
  const auto before = any_star(random);
  auto star = before;
  model.reopen_hiding(star);
  for (int j = 0; j < kDofs; ++j) {
    Life life;
    life.F(rme::bank::kResidual, rme::bank::kResidual) = life.F(rme::bank::kStiction, rme::bank::kStiction) = 0;
    life.Q(rme::bank::kResidual, rme::bank::kResidual) = model.noise().residual_variance(j);
    life.Q(rme::bank::kStiction, rme::bank::kStiction) =
        std::pow(0.6 * kArm.coulomb[j], 2) + 16 * model.noise().residual_variance(j);
    check_life(before, star, j, life);
  }
  star = before;
  model.reopen_offset(star);
  for (int j = 0; j < kDofs; ++j) {
    Life life;
    life.Q(rme::bank::kOffset, rme::bank::kOffset) = std::pow(kArm.offset[j], 2);
    check_life(before, star, j, life);
  }
}

TEST_CASE("JointTorqueModel: once a load is gone, its offsets are uncertain by 2 % of what it made each joint bear",
          "[joint_torque]") {
  const unsigned seed = 553;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  Block block = at_rest();
  rme::InertialVector<double> held;
  for (int i = 0; i < rme::kInertial; ++i) {
    held[i] = normal(random);
    for (int j = 0; j < kDofs; ++j) block.regressor(j, i) = (j == 0 ? 1 : 10) * normal(random);
  }
  const Joints load = block.regressor * held;
  // The second joint's offset was better known before any sample.
  REQUIRE(0.02 * std::abs(load[0]) < kArm.offset[0]);
  REQUIRE(0.02 * std::abs(load[1]) > kArm.offset[1]);
  // What is left of the load, in the first joint or the second.
  for (const double left : {0.0, 0.08, -0.08, 0.12, -0.12, 1.0}) {
    for (int at = 0; at < kDofs; ++at) {
      CAPTURE(left, at);
      Model model(Sensing::LinkSide, kArm, 0.01);
      const auto before = model.prior();
      const double deviation = std::sqrt(std::pow(kArm.offset[at], 2) + model.noise().variance(at));
      block.tau.setZero();
      block.tau[at] = left * load[at];
      if (left != 0) block.tau[at] += std::copysign(4.9 * deviation, block.tau[at]);
      REQUIRE((std::abs(left) > 0.1) == (std::abs(block.tau[at]) > 0.1 * std::abs(load[at]) + 5 * deviation));
      Regime regime;
      regime.update(block);
      model.begin(block, regime);
      for (const double share : {1.0, 0.3}) {
        CAPTURE(share);
        auto star = before;
        model.unload(star, held, share);
        for (int j = 0; j < kDofs; ++j) {
          Life life;
          if (std::abs(left) < 0.1)
            life.Q(rme::bank::kOffset, rme::bank::kOffset) =
                share * std::pow(std::min(0.02 * std::abs(load[j]), kArm.offset[j]), 2);
          check_life(before, star, j, life);
        }
      }
    }
  }
}

TEST_CASE("JointTorqueModel: what 0.6 ms of the torque's change make, and what its steps hide, is noise",
          "[joint_torque]") {
  Scene scene(Sensing::LinkSide);
  scene.block(Joints::Zero(), Joints(5, 5));  // the first block has no predecessor
  for (int j = 0; j < kDofs; ++j) {
    CHECK(scene.model.observation(j, 0).noise == scene.model.noise().variance(j));
    CHECK(scene.model.observation(j, 0).torque == 5);
  }
  CHECK(scene.model.observation(1, 0).h == rme::InertialVector<double>::Unit(3) * 0.7);
  scene.block(Joints::Zero(), Joints(7, -5), Joints(0.1, 0.2));
  for (int j = 0; j < kDofs; ++j) {
    const double change = j == 0 ? 2 : -10, step = j == 0 ? 0.1 : 0.2;
    CHECK(scene.model.observation(j, 0).noise - scene.model.noise().variance(j) ==
          Approx(std::pow(0.03 * change, 2) + 8.0 / 12 * step * step));
  }
}

TEST_CASE("JointTorqueModel: a joint that starts or turns back within a block has half its friction more noise",
          "[joint_torque]") {
  Scene scene(Sensing::JointFriction);
  Block block;
  block.duration = kPeriod;
  block.samples = 20;
  block.tau.setZero();
  block.regressor.setZero();
  block.jacobian.setZero();
  block.velocity << 0, 0.3;
  block.velocities << 0.3, 0.3, -0.3, -0.3, 0.3, 0.3, 0.3, 0.3;
  block.torque_step.setZero();
  block.velocity_noise.setZero();
  scene.regime.update(block);
  scene.model.begin(block, scene.regime);
  CHECK(scene.model.observation(0, 0).noise - scene.model.noise().variance(0) ==
        Approx(std::pow(kArm.coulomb[0] / 2, 2)));
  CHECK(scene.model.observation(1, 0).noise == scene.model.noise().variance(1));
}

TEST_CASE(
    "JointTorqueModel: noise of a rough arm's joint that has turned fades within 0.2 s, and is larger the slower it is",
    "[joint_torque]") {
  Scene scene(Sensing::RoughModel);
  const auto turning = [&](int j) {
    const auto o = scene.model.observation(j, 0);
    const double residual = scene.model.noise().residual_variance(j);
    return (o.noise - scene.model.noise().variance(j)) / (residual * (6 + 20 * o.c[rme::bank::kStiction]));
  };
  scene.block(Joints(0.3, 0));
  CHECK(turning(0) == 0);  // the first block has no predecessor
  scene.block(Joints(-0.3, 0.002));
  CHECK(turning(0) == Approx(1));  // a reversal is a change of 1.71; more than 1 does not count
  CHECK(turning(1) == Approx(0.002 / 0.052));
  scene.block(Joints(-0.3, 0.002));
  CHECK(turning(0) == Approx(std::exp(-0.1)));
  scene.block(Joints(-0.3, 0.002));
  CHECK(turning(0) == Approx(std::exp(-0.2)));
  CHECK(turning(1) == Approx(0.002 / 0.052 * std::exp(-0.2)));
}

TEST_CASE("JointTorqueModel: an error of the acceleration turns the payload as well", "[joint_torque]") {
  // A kilogram turns the error of the flange's acceleration into J^T a and, at the root of 0.01 m^2 from it, into moments: of its
  // weight on that arm, and of the angular acceleration.
  Block block;
  block.duration = 0.04;
  block.tau.setZero();
  block.regressor.setZero();
  block.jacobian << 0.1, 0.4, 0.2, 0.5, -0.1, 0.1, 0.3, 0.2, -0.3, 0.7, 0.6, 0.8;
  block.velocity.setZero();
  block.velocities.setZero();
  block.torque_step.setZero();
  block.velocity_noise.setZero();
  block.samples = 20;
  block.acceleration_variance = 0.004;
  block.angular_acceleration_variance = 0.03;
  const auto linear = block.jacobian.topRows<3>(), angular = block.jacobian.bottomRows<3>();
  const double arm = 0.01;
  Model model(Sensing::LinkSide, kArm, arm);
  model.begin(block, Regime());
  const double a = 2.5 * 0.004, turn = 2.5 * 0.03;
  for (int j = 0; j < kDofs; ++j)
    CHECK(model.observation(j, 3).noise - model.noise().variance(j) ==
          Approx(9 * (a * linear.col(j).squaredNorm() + (a * arm + turn * arm * arm) * angular.col(j).squaredNorm())));
}

}  // namespace
