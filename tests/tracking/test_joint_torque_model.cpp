#include <cmath>
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
const rme::ArmPrior<double, kDofs> kArm = {Joints(0.1, 0.2), Joints(0.3, 0.4), Joints(1, 2), Joints(0.5, 0.6),
                                           Joints(0.2, 0.1)};

/// A model that is shown one block after another.
struct Scene {
  explicit Scene(Sensing sensing) : model(sensing, kArm, 0.01), star(model.prior()) {}
  void block(const Joints& velocity, double tau = 0) {
    Block block;
    block.duration = 0.02;
    block.samples = 20;
    block.tau.setConstant(tau);
    block.regressor.setZero();
    block.jacobian.setZero();
    block.rotation.setIdentity();
    block.velocity = velocity;
    block.velocities = velocity.replicate<1, rme::kBlockParts>();
    block.torque_step.setZero();
    block.velocity_noise.setZero();
    regime.update(block);
    model.begin(block, regime);
    model.predict(star);
  }
  double deviation(int j, rme::Nuisance n) const { return std::sqrt(star.joint(j).covariance(n, n)); }

  Model model;
  Regime regime;
  rme::StarGaussian<double, kDofs> star;
};

TEST_CASE("JointTorqueModel: behind the gears there is no friction, moving or not", "[joint_torque]") {
  Scene scene(Sensing::LinkSide);
  for (const double velocity : {0.0, 0.3, -0.3}) {
    scene.block(Joints::Constant(velocity));
    for (int j = 0; j < kDofs; ++j)
      CHECK(scene.model.observation(j, 0).c == rme::JointNuisanceVector<double>(1, 0, 0, 1, 0));
  }
  CHECK(scene.deviation(0, rme::kCoulomb) == 0);
}

TEST_CASE("JointTorqueModel: friction acts against the motion; what a joint held when it stopped, it holds",
          "[joint_torque]") {
  Scene scene(Sensing::JointFriction);
  scene.block(Joints(0.3, -0.3));
  CHECK(scene.model.observation(0, 0).c == rme::JointNuisanceVector<double>(1, -1, -0.3, 1, 0));
  CHECK(scene.model.observation(1, 0).c == rme::JointNuisanceVector<double>(1, 1, 0.3, 1, 0));
  scene.block(Joints::Zero());
  for (int j = 0; j < kDofs; ++j) {
    CHECK(scene.model.observation(j, 0).c == rme::JointNuisanceVector<double>(1, 0, 0, 1, 1));
    const double sign = j == 0 ? -1 : 1;
    CHECK(scene.star.joint(j).mean[rme::kStiction] == Approx(0.95 * sign * kArm.coulomb[j]));
  }
}

TEST_CASE("JointTorqueModel: a rough arm's friction fades into what holds it at rest", "[joint_torque]") {
  Scene scene(Sensing::RoughModel);
  double last = 1;
  for (const double velocity : {0.0, 0.003, 0.03, 1.0}) {
    scene.block(Joints(velocity, -velocity));
    const auto c = scene.model.observation(0, 0).c, opposite = scene.model.observation(1, 0).c;
    CHECK(c[rme::kStiction] == Approx(0.003 / (velocity + 0.003)));
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
  const double quiet = scene.model.observation(0, 0).noise;
  scene.star.joint(0).mean[rme::kResidual] = scene.star.joint(1).mean[rme::kResidual] = 1;
  scene.block(Joints(-0.3, 0.3));
  // From 0.3 / 0.35 to its opposite is a change of 1.71; the other joint has gone its way, as far as both together.
  const double way = std::sqrt(0.18) * 0.02, kept = std::exp(-way / 1.2);
  CHECK(scene.star.joint(0).mean[rme::kResidual] == Approx(kept * std::exp(-0.6 / 0.35)));
  CHECK(scene.star.joint(1).mean[rme::kResidual] == Approx(kept));
  CHECK(scene.deviation(0, rme::kResidual) == Approx(residual).epsilon(0.05));
  CHECK(scene.model.observation(0, 0).noise > quiet + 2.9 * residual * residual);
  CHECK(scene.model.observation(1, 0).noise == Approx(scene.model.noise().variance(1)));
  for (int k = 0; k < 50; ++k) scene.block(Joints(-0.3, 0.3));
  CHECK(scene.model.observation(0, 0).noise < quiet + 0.1 * residual * residual);
}

TEST_CASE("JointTorqueModel: noise of dq is noise of the inertia force, in proportion to the mass", "[joint_torque]") {
  Model model(Sensing::LinkSide, kArm, 0.01);
  Block block;
  block.duration = 0.02;
  block.samples = 20;
  block.tau.setZero();
  block.regressor.setZero();
  block.jacobian.setZero();
  block.jacobian(2, 0) = 0.5;
  block.rotation.setIdentity();
  block.velocity.setZero();
  block.velocities.setZero();
  block.torque_step.setZero();
  block.velocity_noise = Joints(1e-6, 0);
  model.begin(block, Regime());
  const double floor = model.observation(0, 0).noise, held = model.observation(0, 2).noise - floor;
  // (m J)^2 of the slope's variance, 12 / (n T^2) J^2 sigma^2; shared by three axes, 2.5 times that.
  CHECK(held == Approx(2 * 2 * 0.25 * (2.5 * 12 / 20 / 4e-4 * 0.25 * 1e-6 / 3)));
  CHECK(model.observation(1, 2).noise == Approx(model.observation(1, 0).noise));
}

}  // namespace
