#include <cmath>
#include <random>
#include <rme/tracking/joint_torque_model.hpp>

#include "support/catch.hpp"

namespace {

constexpr int kDofs = 2;
using Model = rme::JointTorqueModel<double, kDofs>;
using Block = rme::TorqueBlock<double, kDofs>;
using Regime = rme::FrictionRegime<double, kDofs>;
using Joints = rme::JointVector<double, kDofs>;
using rme::Sensing;

/// What such an arm may show: another one in each joint.
const rme::ArmPrior<double, kDofs> kArm = {Joints(0.1, 0.2), Joints(0.3, 0.4), Joints(1, 2),
                                           Joints(0.5, 0.6), Joints(0.2, 0.1), 0.4};

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

Model make_model(Sensing sensing) {
  return {rme::kind_of(sensing), kArm, 3, 0.01, {0, 0, -9.81}};
}

const rme::SensingKind& kRough = rme::kind_of(Sensing::RoughModel);

/// A model that is shown one block after another.
struct Scene {
  explicit Scene(Sensing sensing) : model(make_model(sensing)), star(model.prior()) {}
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
  double deviation(int j, rme::Nuisance n) const { return std::sqrt(star.joint(j).covariance(n, n)); }

  Model model;
  Regime regime;
  rme::BlockContext<double, kDofs> context;
  rme::StarGaussian<double, kDofs> star;
};

TEST_CASE("JointTorqueModel: friction acts against the motion, and a joint that stops keeps its friction torque",
          "[joint_torque]") {
  Scene scene(Sensing::JointFriction);
  scene.block(Joints(0.3, -0.3));
  CHECK(scene.model.observation(0, {}).c == rme::JointNuisanceVector<double>{1, -1, -0.3, 1, 0, 0});
  CHECK(scene.model.observation(1, {}).c == rme::JointNuisanceVector<double>{1, 1, 0.3, 1, 0, 0});
  scene.block(Joints::Zero());
  for (int j = 0; j < kDofs; ++j) {
    CHECK(scene.model.observation(j, {}).c == rme::JointNuisanceVector<double>{1, 0, 0, 1, 1, 0});
    const double sign = j == 0 ? -1 : 1;
    CHECK(scene.star.joint(j).mean[rme::kStiction] == Approx(0.95 * sign * kArm.coulomb[j]));
  }
}

TEST_CASE("JointTorqueModel: a rough arm's friction fades into what holds it at rest", "[joint_torque]") {
  Scene scene(Sensing::RoughModel);
  double last = 1;
  for (const double velocity : {0.0, 0.003, 0.03, 1.0}) {
    scene.block(Joints(velocity, -velocity));
    const auto c = scene.model.observation(0, {}).c, opposite = scene.model.observation(1, {}).c;
    CHECK(c[rme::kStiction] == Approx(kRough.slow / (velocity + kRough.slow)));
    CHECK(c[rme::kCoulomb] == Approx(c[rme::kStiction] - 1));
    CHECK(opposite[rme::kCoulomb] == Approx(-c[rme::kCoulomb]));
    CHECK(c[rme::kStiction] <= last);
    last = c[rme::kStiction];
  }
}

TEST_CASE("JointTorqueModel: a rough arm's joint that turns back is noisy for a while, and its residual is another one",
          "[joint_torque]") {
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
  CHECK(scene.model.observation(0, {}).noise > quiet + 0.98 * kRough.turn_noise * residual * residual);
  CHECK(scene.model.observation(1, {}).noise == Approx(scene.model.noise().variance(1)));
  for (int k = 0; k < 50; ++k) scene.block(Joints(-0.3, 0.3));
  CHECK(scene.model.observation(0, {}).noise < quiet + 0.1 * residual * residual);
}

using Beta = rme::JointNuisanceVector<double>;
using BetaMatrix = rme::JointNuisanceMatrix<double>;

/// Every number of every joint is another one.
rme::StarGaussian<double, kDofs> any_star(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  rme::StarGaussian<double, kDofs> star;
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
void check_life(const rme::StarGaussian<double, kDofs>& before, const rme::StarGaussian<double, kDofs>& after, int j,
                const Life& life) {
  CAPTURE(j);
  const auto& [mean, slope, covariance] = before.joint(j);
  CHECK((after.joint(j).mean - life.F * mean).norm() < 1e-12);
  CHECK((after.joint(j).slope - slope * life.F.transpose()).norm() < 1e-12);
  CHECK((after.joint(j).covariance - life.F * covariance * life.F.transpose() - life.Q).norm() < 1e-12);
}

constexpr double kPeriod = 0.02;  // [s]
constexpr double kTurns = 1;      // change of the torque that draws the stiction anew, in Coulomb frictions
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

TEST_CASE("JointTorqueModel: friction holds a resting joint with no more than motion has shown", "[joint_torque]") {
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

TEST_CASE("JointTorqueModel: what holds a resting joint turns over as its torque changes, if friction is sure to show",
          "[joint_torque]") {
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
      hold(life, std::exp(-kPeriod * kRough.creep - 0.5 * kRough.turn * turned[j]),
           std::pow(0.6 * kArm.coulomb[j], 2) + kRough.stiction * scene.model.noise().residual_variance(j));
      check_life(before, scene.star, j, life);
    }
  }
}

TEST_CASE("JointTorqueModel: a timing error of 0.6 ms and the torque's resolution count as noise", "[joint_torque]") {
  Scene scene(Sensing::LinkSide);
  scene.block(Joints::Zero(), Joints(5, 5));  // the first block has no predecessor
  for (int j = 0; j < kDofs; ++j) {
    CHECK(scene.model.observation(j, {}).noise == scene.model.noise().variance(j));
    CHECK(scene.model.observation(j, {}).torque == 5);
  }
  scene.block(Joints::Zero(), Joints(7, -5), Joints(0.1, 0.2));
  for (int j = 0; j < kDofs; ++j) {
    const double change = j == 0 ? 2 : -10, step = j == 0 ? 0.1 : 0.2;
    CHECK(scene.model.observation(j, {}).noise - scene.model.noise().variance(j) ==
          Approx(std::pow(0.03 * change, 2) + 8.0 / 12 * step * step));
  }
}

TEST_CASE("JointTorqueModel: a block half as long as usual has twice the noise", "[joint_torque]") {
  Model model = make_model(Sensing::LinkSide);
  Regime regime;
  Block block = at_rest();
  for (const bool begins : {false, true}) {
    block.begins = begins;
    block.duration = begins ? 0.01 : 0.02;
    regime.update(block);
    model.begin(block, regime);
    for (int j = 0; j < kDofs; ++j) {
      CAPTURE(begins, j);
      CHECK(model.observation(j, {}).noise == Approx((begins ? 2 : 1) * model.noise().variance(j)).epsilon(1e-12));
    }
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
  CHECK(scene.model.observation(0, {}).noise - scene.model.noise().variance(0) ==
        Approx(std::pow(kArm.coulomb[0] / 2, 2)));
  CHECK(scene.model.observation(1, {}).noise == scene.model.noise().variance(1));
}

TEST_CASE("JointTorqueModel: the torque depends on lag, tool, tilt and payload as they are defined", "[joint_torque]") {
  const unsigned seed = 705;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  for (const Eigen::Vector3d& gravity : {Eigen::Vector3d(0, 0, -9.81), Eigen::Vector3d(9.81, 0, 0)}) {
    Model model(rme::kind_of(Sensing::LinkSide), kArm, 3, 0.01, gravity);
    Block block = at_rest();
    block.torque_rate = block.torque_rate.NullaryExpr(draw);
    block.regressor = block.regressor.NullaryExpr(draw);
    block.jacobian = block.jacobian.NullaryExpr(draw);
    for (const bool known : {false, true}) {
      Eigen::Matrix<double, kDofs, 3> arm = arm.NullaryExpr(draw);
      if (known) block.gravity_torque = arm;
      model.begin(block, Regime(), {}, true);
      Eigen::Matrix<double, kDofs, 2> tilt;
      for (int j = 0; j < kDofs; ++j) {
        const auto o = model.observation(j, {});
        CHECK(o.h[rme::kLag] == 0.02 * block.torque_rate[j]);
        CHECK(o.h.segment<4>(rme::kTool).transpose() == block.regressor.row(j).head<4>());
        CHECK(o.h.segment<rme::kInertial>(rme::kPayload).transpose() == block.regressor.row(j));
        tilt.row(j) = o.h.segment<2>(rme::kTilt).transpose();
      }
      // The robot's model takes gravity to be g; it is g turned about two axes across it. The arm's own torque that it
      // subtracts is -arm g, and what it leaves is the difference.
      if (!known) arm = rme::usual_gravity_torque<double, kDofs>(block.jacobian, 5 * 3);
      const Eigen::Matrix2d across = tilt.transpose() * tilt;
      const Eigen::Matrix<double, kDofs, 3> turned = arm * rme::skew(gravity);
      // The same whichever two orthogonal axes are chosen.
      CHECK(across.trace() == Approx((turned.transpose() * turned).trace()));
      CHECK((tilt * tilt.transpose() - turned * turned.transpose()).norm() < 1e-9 * turned.squaredNorm());
    }
  }
}

TEST_CASE(
    "JointTorqueModel: a tilt shows a residual of a third of its torque, unless the arm's gravity torque is known",
    "[joint_torque]") {
  const unsigned seed = 707;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  for (const bool known : {false, true}) {
    CAPTURE(known);
    Model model(rme::kind_of(Sensing::LinkSide), kArm, 3, 0.01, {0, 0, -9.81});
    Block block = at_rest();
    block.jacobian = block.jacobian.NullaryExpr(draw);
    block.regressor = block.regressor.NullaryExpr(draw);
    if (known) block.gravity_torque = Eigen::Matrix<double, kDofs, 3>::NullaryExpr(draw);
    model.begin(block, Regime(), {}, true);
    auto star = model.prior();
    model.tilt(star, 0.04);
    block.velocity.setConstant(1e3);  // so far that nothing is kept of the residual
    model.begin(block, Regime(), {}, true);
    for (int j = 0; j < kDofs; ++j) {
      const double torque = 0.04 * model.observation(j, {}).h.segment<2>(rme::kTilt).norm();
      CHECK(torque > 0);
      const double expected = known ? 0 : 0.34 * 0.34 * torque * torque;
      CHECK(star.joint(j).covariance(rme::kResidual, rme::kResidual) == Approx(expected));
      auto moved = star;
      model.predict(moved);
      CHECK(moved.joint(j).covariance(rme::kResidual, rme::kResidual) ==
            Approx(model.noise().residual_variance(j) + expected));
    }
  }
}

TEST_CASE("JointTorqueModel: the weight of what is held acts along the tilted gravity, linearised about what is known",
          "[joint_torque]") {
  const unsigned seed = 706;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  const Eigen::Vector3d gravity(0.8, -1.1, -9.7);
  const Eigen::Vector2d angles(0.05, -0.03);
  Model model(rme::kind_of(Sensing::LinkSide), kArm, 3, 0.01, gravity);
  Block block = at_rest();
  block.jacobian = block.jacobian.NullaryExpr(draw);
  block.rotation = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, -2, 0.5).normalized()).toRotationMatrix();
  block.regressor = block.regressor.NullaryExpr(draw);
  const rme::InertialVector<double> phi = rme::InertialVector<double>::NullaryExpr(draw);
  // An arm whose joints show the coordinates of gravity tells by how much the angles change it.
  Eigen::Vector3d changed = Eigen::Vector3d::Zero();
  for (int axis = 0; axis < 3; ++axis) {
    block.gravity_torque = Eigen::Matrix<double, kDofs, 3>::Zero();
    (*block.gravity_torque)(0, axis) = 1;
    model.begin(block, Regime(), {}, true);
    changed[axis] = -model.observation(0, {}).h.segment<2>(rme::kTilt).dot(angles);
  }
  CHECK(changed.norm() == Approx(angles.norm() * gravity.norm()));
  CHECK(std::abs(changed.dot(gravity)) < 1e-9);
  const Eigen::Matrix<double, 6, rme::kInertial> difference =
      rme::inertial_wrench_regressor<double>(block.rotation, gravity + changed, {}) -
      rme::inertial_wrench_regressor<double>(block.rotation, gravity, {});
  rme::Load<double, kDofs> load;
  load.held = phi.head<4>();
  load.tilt = angles;
  for (const bool known : {true, false}) {
    if (!known) block.gravity_torque.reset();
    for (int j = 0; j < kDofs; ++j) {
      const Eigen::Matrix<double, 1, rme::kInertial> turned = block.jacobian.col(j).transpose() * difference;
      model.begin(block, Regime(), {}, true);
      const auto level = model.observation(j, {}), tilted = model.observation(j, load);
      CHECK((tilted.h - level.h).segment<2>(rme::kTilt).dot(angles) == Approx(turned.dot(phi)));
      // Usual links tell too little of the tilt to turn the weight by what they say.
      const double share = known ? 1 : 0;
      CHECK((tilted.h.segment<rme::kInertial>(rme::kPayload) - block.regressor.row(j).transpose() -
             share * turned.transpose())
                .norm() < 1e-9);
      CHECK((tilted.h.segment<4>(rme::kPoured) - tilted.h.segment<4>(rme::kPayload)).norm() < 1e-12);
      CHECK(tilted.torque - level.torque == Approx(share * turned.dot(phi)));  // so that the product counts once
      CHECK(level.torque == block.tau[j]);
      model.begin(block, Regime());  // no story has a tilt
      CHECK(model.observation(j, load).h == model.observation(j, {}).h);
      CHECK(model.observation(j, load).torque == block.tau[j]);
    }
  }
}

TEST_CASE(
    "JointTorqueModel: a payload that was hidden by the nuisances changes no prediction, and all the more the mass",
    "[joint_torque]") {
  Scene scene(Sensing::JointFriction);
  scene.block(Joints(0.3, -0.3));
  auto star = scene.star;
  scene.model.suppose_hidden(star, Eigen::Vector3d(0, 0, 0.1));
  double precision = 0;
  for (int j = 0; j < kDofs; ++j) {
    const auto o = scene.model.observation(j, {});
    const auto before = scene.star.predict(j, o), after = star.predict(j, o);
    const double torque = o.h[rme::kPayload] + 0.1 * o.h[rme::kPayload + 3];
    const auto V = scene.star.nuisance_covariance(j);
    double able = 0;
    for (int n = 0; n < rme::kJointNuisances; ++n) able += V(n, n) * o.c[n] * o.c[n];
    precision += torque * torque / (able + o.noise);
    CHECK(after.innovation == Approx(before.innovation));
    // What the noise would have let through of a payload of this size.
    const double through = torque * o.noise / (able + o.noise);
    CHECK(after.variance == Approx(before.variance + through * through * star.mass_variance()));
  }
  REQUIRE(precision > 0);
  CHECK(star.mass_variance() == Approx(9 / precision));
}

TEST_CASE("JointTorqueModel: after a removal the offsets are uncertain by what the gain has drifted since the pick-up",
          "[joint_torque]") {
  Scene scene(Sensing::LinkSide);
  scene.block(Joints::Zero());
  rme::InertialVector<double> held = rme::InertialVector<double>::Zero();
  held[3] = 0.2;
  auto star = scene.star;
  scene.model.unload(star, held, 25);
  const auto grown = [&](int j) {
    return star.joint(j).covariance(rme::kOffset, rme::kOffset) -
           scene.star.joint(j).covariance(rme::kOffset, rme::kOffset);
  };
  CHECK(grown(0) == Approx(0).margin(1e-15));
  CHECK(grown(1) == Approx(std::pow(0.02 * 0.7 * 0.2, 2)));  // 0.004 per square root of a second
  held[3] = 1e6;                                             // no more than the prior
  star = scene.star;
  scene.model.unload(star, held, 25);
  CHECK(grown(1) == Approx(kArm.offset[1] * kArm.offset[1]));
}

TEST_CASE("JointTorqueModel: an error of a joint's gain is a share of what the payload makes the joint bear",
          "[joint_torque]") {
  Scene scene(Sensing::LinkSide);
  scene.block(Joints::Zero());
  rme::InertialVector<double> held = rme::InertialVector<double>::Zero();
  CHECK(scene.model.load(scene.star).torque == Joints::Zero());
  held << 1.3, 0.1, -0.2, 0.3, 0, 0, 0, 0, 0, 0;
  scene.star.draw_payload(held, rme::InertialMatrix<double>::Identity());
  const auto bears = scene.model.load(scene.star);
  CHECK(bears.mass == Approx(1.3));
  for (int j = 0; j < kDofs; ++j) {
    const double torque = scene.model.block().regressor.row(j).dot(held);
    CHECK(bears.torque[j] == Approx(torque));
    CHECK(scene.model.observation(j, bears).c[rme::kGain] == Approx(torque));
    CHECK(scene.model.observation(j, bears).h == scene.model.observation(j, {}).h);
  }
  CHECK(bears.torque.norm() > 0.1);
}

TEST_CASE("JointTorqueModel: the prior is the arm's, friction as well known as that says", "[joint_torque]") {
  for (const Sensing sensing : {Sensing::LinkSide, Sensing::JointFriction, Sensing::RoughModel}) {
    const rme::SensingKind& kind = rme::kind_of(sensing);
    const Model model = make_model(sensing);
    const auto star = model.prior();
    CHECK(star.empty());
    CHECK(star.mean().isZero(0));
    CHECK(star.variance(rme::kLag) == Approx(kind.lag * kind.lag));
    CHECK(std::sqrt(star.variance(rme::kTool)) == Approx(3 * kind.tool));
    for (int i = 1; i < 4; ++i) CHECK(std::sqrt(star.variance(rme::kTool + i)) == Approx(3 * kind.tool * 0.1));
    CHECK(std::sqrt(star.variance(rme::kTilt)) == Approx(0.02));
    for (int j = 0; j < kDofs; ++j) {
      Beta mean = Beta::Zero(), variance = Beta::Zero();
      variance[rme::kOffset] = std::pow(kArm.offset[j], 2);
      mean[rme::kCoulomb] = kind.friction * kArm.coulomb[j];
      mean[rme::kViscous] = kind.friction * kArm.viscous[j];
      variance[rme::kCoulomb] = std::pow(kArm.friction_std * mean[rme::kCoulomb], 2);
      variance[rme::kViscous] = std::pow(kArm.friction_std * mean[rme::kViscous], 2);
      variance[rme::kStiction] =
          std::pow(0.6 * mean[rme::kCoulomb], 2) + kind.stiction * model.noise().residual_variance(j);
      CHECK(star.joint(j).mean == mean);
      CHECK((star.joint(j).covariance - BetaMatrix(variance.asDiagonal())).norm() < 1e-14);
    }
  }
}

TEST_CASE("JointTorqueModel: reopening forgets how sure the offset was", "[joint_torque]") {
  const unsigned seed = 704;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto before = any_star(random);
  auto star = before;
  make_model(Sensing::RoughModel).reopen_offset(star);
  for (int j = 0; j < kDofs; ++j) {
    Life life;
    life.Q(rme::kOffset, rme::kOffset) = std::pow(kArm.offset[j], 2);
    check_life(before, star, j, life);
  }
}

TEST_CASE("JointTorqueModel: what is not known of the flange's acceleration is noise of the payload's inertia force",
          "[joint_torque]") {
  // A kilogram turns it into J^T a and, at the root of 0.01 m^2 from the flange, into moments: of its inertia force on
  // that arm, and of the angular acceleration. 2.5 times, since the joints' errors are one and the same.
  Block block = at_rest();
  block.jacobian << 0.1, 0.4, 0.2, 0.5, -0.1, 0.1, 0.3, 0.2, -0.3, 0.7, 0.6, 0.8;
  block.acceleration_variance = 0.3;
  block.angular_acceleration_variance = 0.7;
  Model model = make_model(Sensing::LinkSide);
  model.begin(block, Regime());
  const double arm = 0.01;
  for (int j = 0; j < kDofs; ++j)
    CHECK(model.observation(j, {3, Joints::Zero()}).noise - model.noise().variance(j) ==
          Approx(9 * 2.5 *
                 (0.3 * block.jacobian.col(j).head<3>().squaredNorm() +
                  (0.3 * arm + 0.7 * arm * arm) * block.jacobian.col(j).tail<3>().squaredNorm())));
}

}  // namespace
