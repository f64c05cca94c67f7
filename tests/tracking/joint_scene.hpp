#pragma once
/// A small arm whose torque model is shown one block after another.
#include <cmath>
#include <random>
#include <rme/tracking/joint_torque_model.hpp>

#include "support/catch.hpp"

namespace rme::testing::joints {

constexpr int kDofs = 2;
constexpr double kPeriod = 0.02;  // of blocks [s]
using Model = JointTorqueModel<double, kDofs>;
using Block = TorqueBlock<double, kDofs>;
using Regime = FrictionRegime<double, kDofs>;
using Joints = JointVector<double, kDofs>;

/// What such an arm may show: another one in each joint.
inline const ArmPrior<double, kDofs> kArm = {Joints(0.1, 0.2), Joints(0.3, 0.4), Joints(1, 2),
                                             Joints(0.5, 0.6), Joints(0.2, 0.1), 0.4};

/// Nothing moves, nothing is held, no torque shows.
inline Block at_rest() {
  Block block;
  block.duration = kPeriod;
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

inline Model make_model(Sensing sensing) {
  return {kind_of(sensing), kArm, 3, 0.01, {0, 0, -9.81}};
}

inline const SensingKind& kRough = kind_of(Sensing::RoughModel);

/// A model that is shown one block after another.
struct Scene {
  explicit Scene(Sensing sensing) : model(make_model(sensing)), star(model.prior()) {}
  void block(const Joints& velocity, double tau = 0) { block(velocity, Joints(Joints::Constant(tau))); }
  void block(const Joints& velocity, const Joints& tau, const Joints& torque_step = Joints::Zero()) {
    Block block = at_rest();
    block.tau = tau;
    block.regressor(1, 3) = 0.7;
    block.velocity = velocity;
    block.velocities = velocity.replicate<1, kBlockParts>();
    block.torque_step = torque_step;
    regime.update(block);
    model.begin(block, regime, context);
    model.predict(star);
  }
  double deviation(int j, Nuisance n) const { return std::sqrt(star.joint(j).covariance(n, n)); }

  Model model;
  Regime regime;
  BlockContext<double, kDofs> context;
  StarGaussian<double, kDofs> star;
};

using Beta = JointNuisanceVector<double>;
using BetaMatrix = JointNuisanceMatrix<double>;

/// Every number of every joint is another one.
inline StarGaussian<double, kDofs> any_star(std::mt19937& random) {
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  StarGaussian<double, kDofs> star;
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
inline void check_life(const StarGaussian<double, kDofs>& before, const StarGaussian<double, kDofs>& after, int j,
                       const Life& life) {
  CAPTURE(j);
  const auto& [mean, slope, covariance] = before.joint(j);
  CHECK((after.joint(j).mean - life.F * mean).norm() < 1e-12);
  CHECK((after.joint(j).slope - slope * life.F.transpose()).norm() < 1e-12);
  CHECK((after.joint(j).covariance - life.F * covariance * life.F.transpose() - life.Q).norm() < 1e-12);
}

}  // namespace rme::testing::joints
