#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <rme/tracking/disturbance.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"
#include "tracking/dense_star.hpp"

namespace {

using oracle::Matrix;
using oracle::Vector;
using rme::Disturbing;
using rme::kInertial;
using rme::kJointNuisances;
using rme::kShared;
constexpr int kDofs = 3;
constexpr double kRated = 3;
constexpr double kNone = -std::numeric_limits<double>::infinity();  // log probability
using Star = rme::StarGaussian<double, kDofs>;
using Model = rme::JointTorqueModel<double, kDofs>;
using Disturbance = rme::Disturbance<double, kDofs>;
using Dense = oracle::DenseStar<kDofs>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A model in a random block.
/// @param shaken  posterior variance of the flange's acceleration [(m/s^2)^2]
/// @param loud    size of the torque, in twice a newton metre
/// @param answer  of a hand that cannot move
Model random_model(std::mt19937& random, double shaken = 0, double loud = 1, const rme::Answer<double>& answer = {}) {
  Model model(rme::kind_of(rme::Sensing::JointFriction), rme::ArmPrior<double, kDofs>::of(kRated), kRated, 0.02,
              {0, 0, -9.81});
  rme::TorqueBlock<double, kDofs> block;
  block.duration = 0.02;
  block.samples = 20;
  block.acceleration_variance = shaken;
  block.tau = 2 * loud * oracle::random_matrix(random, kDofs, 1);
  block.torque_rate = oracle::random_matrix(random, kDofs, 1);
  block.regressor = oracle::random_matrix(random, kDofs, kInertial);
  block.jacobian = oracle::random_matrix(random, 6, kDofs);
  block.rotation.setIdentity();
  block.velocity = oracle::random_matrix(random, kDofs, 1);
  block.velocities = block.velocity.replicate<1, rme::kBlockParts>();
  block.torque_step.setZero();
  block.velocity_noise.setZero();
  rme::FrictionRegime<double, kDofs> regime;
  regime.update(block);
  rme::BlockContext<double, kDofs> context;
  context.answer = answer;
  model.begin(block, regime, context);
  return model;
}

/// A star with a payload, or an empty hand, and nuisances that depend on both.
Star random_star(std::mt19937& random, bool held = true) {
  Star star;
  star.set_arm(Eigen::Matrix<double, rme::kArmShared, 1>::Constant(0.04));
  if (held)
    star.draw_payload(oracle::random_matrix(random, kInertial, 1).cwiseAbs(),
                      0.1 * oracle::random_matrix(random, kInertial, kInertial));
  const int known = held ? rme::kHeldShared : rme::kArmShared;
  for (int j = 0; j < kDofs; ++j) {
    star.joint(j).mean = oracle::random_matrix(random, kJointNuisances, 1);
    star.joint(j).slope.topRows(known) = oracle::random_matrix(random, known, kJointNuisances);
    star.joint(j).covariance = oracle::square(oracle::random_matrix(random, kJointNuisances, kJointNuisances));
  }
  return star;
}

/// Covariance of a wrench that nothing is known of: 4 N and 0.5 N m per kilogram of what the arm is rated for.
Matrix6 any_wrench() {
  rme::Vector6<double> deviation;
  deviation << 12, 12, 12, 1.5, 1.5, 1.5;
  return deviation.cwiseAbs2().asDiagonal();
}

/// log(exp(a) + exp(b)).
double log_sum(double a, double b) {
  return std::max(a, b) + std::log1p(std::exp(-std::abs(a - b)));
}

/// All joints' torques of a block, y = H (x, beta) + noise of covariance R.
struct Measured {
  Matrix H = Matrix::Zero(kDofs, Dense::kAll), R = Matrix::Zero(kDofs, kDofs);
  Vector y = Vector::Zero(kDofs);
};
/// The wrench's columns of the regressor are J^T.
Measured measured(const Model& model, double mass, bool acts) {
  Measured out;
  for (int j = 0; j < kDofs; ++j) {
    auto o = model.observation(j, mass);
    o.h.segment<rme::kActing>(rme::kWrench).setZero();
    if (acts) o.h.segment<6>(rme::kWrench) = model.block().jacobian.col(j);
    out.H.row(j) = Dense::row(j, o).transpose();
    out.R(j, j) = o.noise;
    out.y[j] = o.torque;
  }
  return out;
}

TEST_CASE("Disturbance: wrench, payload, arm and likelihood are those of one dense Gaussian", "[disturbance]") {
  const unsigned seed = 560;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const double log_jolt = std::log(0.001), log_anew = std::log(0.001);  // per block
  int went_on = 0, began_anew = 0, hidden = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const Disturbing how = trial % 2 == 0 ? Disturbing::Hand : Disturbing::Still;
    const double loud = trial % 4 < 2 ? 1 : 30;
    CAPTURE(trial, loud);
    Star star = random_star(random);
    Disturbance::begin(star, kRated, false);
    for (int k = 0; k < 3; ++k) {  // from the second block on, something is known of the wrench
      CAPTURE(k);
      const Model model = random_model(random, 0, k == 2 ? loud : 1);
      if (k > 0) Disturbance::predict(model, star, how, kRated);
      const double mass = std::max(0.0, star.mass() - star.wrench_mean()[2] / 9.81);
      const Dense before = Dense::of(star);
      // The wrench goes on.
      const Measured now = measured(model, mass, true);
      const Vector e = now.y - oracle::product(now.H, before.mean);
      const double goes_on = oracle::log_normal(e, oracle::congruence(now.H, before.covariance) + now.R);
      // A hand pushes anew, or a jolt of one of three sizes hides it. What is not known of the payload does not count.
      const Measured none = measured(model, mass, false);
      const Vector rest = none.y - oracle::product(none.H, before.mean);
      Matrix known = none.R, shaken = Matrix::Zero(kDofs, kDofs), U(kDofs, kShared);
      double square = 0;
      for (int j = 0; j < kDofs; ++j) {
        const auto& joint = star.joint(j);
        const Vector c = none.H.row(j).segment(Dense::first(j), kJointNuisances);
        U.row(j) = none.H.row(j).head(kShared) + (joint.slope * c).transpose();
        known(j, j) += c.dot(joint.covariance * c);
        shaken(j, j) = std::pow(3 * model.arm().residual[j], 2);
        const Vector row = none.H.row(j);
        square += rest[j] * rest[j] / (row.dot(before.covariance * row) + none.R(j, j));
      }
      Matrix arm = star.covariance();
      arm.rightCols(kShared - rme::kPayload).setZero();
      arm.bottomRows(kShared - rme::kPayload).setZero();
      known += oracle::congruence(U, arm);
      const Matrix any = known + oracle::congruence(oracle::transposed(model.block().jacobian), any_wrench());
      const double anew = how == Disturbing::Hand ? log_anew + oracle::log_normal(rest, any) : -1e30;
      double jolt = -1e30;
      for (const double size : {1.0, 10.0, 100.0})
        jolt = log_sum(jolt, oracle::log_normal(rest, size * size * (any + shaken)) + log_jolt - std::log(3.0));
      Dense expected = before;
      if (jolt > std::max(goes_on, anew)) {
        ++hidden;
      } else if (anew > goes_on) {
        ++began_anew;
        Star other = star;
        Disturbance::begin(other, kRated, false);
        expected = Dense::of(other).given(now.H, now.y, now.R);
      } else {
        ++went_on;
        expected = before.given(now.H, now.y, now.R);
      }
      double squared = 0;
      const double log_likelihood = Disturbance::observe(model, star, how, log_jolt, kRated, squared);
      CHECK(log_likelihood == Approx(log_sum(log_sum(goes_on, anew), jolt)).epsilon(1e-9));
      CHECK(difference(Dense::of(star), expected) < 1e-6);
      CHECK(squared == Approx(square).epsilon(1e-9));
    }
  }
  CHECK(went_on > 0);
  CHECK(began_anew > 0);
  CHECK(hidden > 0);
}

TEST_CASE("Disturbance: nothing is learned of a jolt, nor of a block in which anything acts", "[disturbance]") {
  const unsigned seed = 565;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const Model model = random_model(random, 0, 100);
  Star star = random_star(random);
  const Star before = star;
  double squared;
  CHECK(std::isfinite(Disturbance::observe(model, star, Disturbing::Jolt, 0, kRated, squared)));
  CHECK(difference(Dense::of(star), Dense::of(before)) == 0);
  CHECK(std::isfinite(Disturbance::anything(model, star, kRated, squared)));
}

TEST_CASE("Disturbance: how a hand trembles, a wrench grows along itself, what touches pushes back, and one is still",
          "[disturbance]") {
  const unsigned seed = 561;
  CAPTURE(seed);
  for (const double speed : {0.0, 1.0}) {
    for (const Disturbing how : {Disturbing::Hand, Disturbing::Growing, Disturbing::Still}) {
      std::mt19937 random(seed);
      CAPTURE(speed, static_cast<int>(how));
      Star star = random_star(random);
      Disturbance::begin(star, kRated, false);
      double squared;
      Model model = random_model(random);
      Disturbance::observe(model, star, how, kNone, kRated, squared);
      auto block = model.block();
      block.velocity *= speed;
      rme::FrictionRegime<double, kDofs> regime;
      regime.update(block);
      rme::BlockContext<double, kDofs> context;
      context.answer.change << 1, -2, 3, 0.1, 0.2, -0.3;
      context.answer.pending << 0.5, 0, 1, 0, 0.1, 0;
      model.begin(block, regime, context);
      const auto mean = star.wrench_mean();
      const Eigen::Matrix<double, 7, 7> covariance = star.wrench_covariance();
      Disturbance::predict(model, star, how, kRated);
      // The answer, with what is not known of it: half of what is pending may come sooner or later, and the point where
      // the hand is held is within a centimetre or so.
      Eigen::Matrix<double, 7, 7> T = Eigen::Matrix<double, 7, 7>::Identity();
      T.topRightCorner<6, 1>() = context.answer.change;
      rme::Vector6<double> back = rme::Vector6<double>::Zero();
      if (how != Disturbing::Hand) back.head<3>() = -500 * 0.02 * (block.jacobian * block.velocity).head<3>();
      Eigen::Matrix<double, 7, 1> expected = T * mean;
      expected.head<6>() += back;
      Matrix6 noise = 0.25 * context.answer.pending * context.answer.pending.transpose() + back * back.transpose();
      noise.diagonal().tail<3>().array() += 1e-4 * context.answer.change.head<3>().squaredNorm();
      if (how == Disturbing::Hand) noise += 0.01 * any_wrench();
      if (how == Disturbing::Growing) {
        const rme::Vector6<double> w = mean.head<6>();
        REQUIRE(w.head<3>().cwiseAbs().maxCoeff() > 1);
        noise +=
            4e-6 * any_wrench() + std::pow(0.06 * kRated / w.head<3>().cwiseAbs().maxCoeff(), 2) * w * w.transpose();
      }
      Eigen::Matrix<double, 7, 7> spread = T * covariance * T.transpose();
      spread.topLeftCorner<6, 6>() += noise;
      CHECK((star.wrench_mean() - expected).norm() < 1e-9 * expected.norm());
      CHECK((star.wrench_covariance() - spread).norm() < 1e-9 * spread.norm());
    }
  }
}

TEST_CASE("Disturbance: a wrench begins with anything or with nearly nothing, and answers or not", "[disturbance]") {
  for (const bool soft : {false, true}) {
    Star star;
    Disturbance::begin(star, kRated, soft);
    Eigen::Matrix<double, 7, 7> expected = Eigen::Matrix<double, 7, 7>::Zero();
    expected.topLeftCorner<6, 6>() = any_wrench() * (soft ? 0.005 * 0.005 : 1);
    expected(6, 6) = 0.25;
    CHECK((star.wrench_covariance() - expected).norm() < 1e-9);
    CHECK((star.wrench_mean() - 0.5 * Eigen::Matrix<double, 7, 1>::Unit(6)).norm() < 1e-12);
  }
}

TEST_CASE("Disturbance: that a wrench answers to the compensation is learned from its changes", "[disturbance]") {
  // The truth answers with s; the compensation changes up and down.
  const unsigned seed = 566;
  CAPTURE(seed);
  for (const double truth : {0.0, 1.0}) {
    CAPTURE(truth);
    std::mt19937 random(seed);
    Star star;
    Disturbance::begin(star, kRated, false);
    rme::Vector6<double> w;
    w << 1, 2, -9, 0.1, 0.2, 0;
    for (int k = 0; k < 60; ++k) {
      rme::Answer<double> answer;
      answer.change[2] = k % 10 < 5 ? 0.5 : -0.5;
      w += truth * answer.change;
      Model model = random_model(random, 0, 1, answer);
      auto block = model.block();
      block.velocity.setZero();
      block.tau = block.jacobian.transpose() * w;
      rme::FrictionRegime<double, kDofs> regime;
      regime.update(block);
      rme::BlockContext<double, kDofs> context;
      context.answer = answer;
      model.begin(block, regime, context);
      if (k > 0) Disturbance::predict(model, star, Disturbing::Still, kRated);
      double squared;
      Disturbance::observe(model, star, Disturbing::Still, kNone, kRated, squared);
    }
    CHECK(star.wrench_mean()[6] == Approx(truth).margin(0.05));
    CHECK(star.wrench_covariance()(6, 6) < 0.05 * 0.05);
  }
}

TEST_CASE("Disturbance: a wrench that acts like a weight has the noise of that weight's inertia", "[disturbance]") {
  // Known to be the weight of 2 kg: the block is then as likely as with a payload of 2 kg more.
  const unsigned seed = 563;
  CAPTURE(seed);
  for (const double shaken : {0.0, 1.0}) {
    std::mt19937 random(seed);
    Star star;
    Disturbance::begin(star, kRated, false);
    for (int k = 0; k < 4000; ++k) {
      Model model = random_model(random);
      auto block = model.block();
      rme::Vector6<double> weight;
      weight << 0, 0, -2 * 9.81, 0, 0, 0;
      block.tau = block.jacobian.transpose() * weight;
      rme::FrictionRegime<double, kDofs> regime;
      regime.update(block);
      model.begin(block, regime);
      double squared;
      Disturbance::observe(model, star, Disturbing::Still, kNone, kRated, squared);
    }
    const double weight = star.wrench_mean()[2];
    REQUIRE(weight == Approx(-2 * 9.81).epsilon(1e-2));
    const Model model = random_model(random, shaken);
    Star copy = star;
    double squared = 0, expected = 0;
    Disturbance::observe(model, star, Disturbing::Still, kNone, kRated, squared);
    for (int j = 0; j < kDofs; ++j) {
      auto o = model.observation(j, -weight / 9.81);
      o.h.segment<rme::kActing>(rme::kWrench).setZero();
      const auto p = copy.predict(j, o);
      expected += p.innovation * p.innovation / p.variance;
    }
    CHECK(squared == Approx(expected).epsilon(0.05));
    if (shaken > 0) CHECK(model.observation(0, 2).noise > 1.5 * model.observation(0, 0).noise);
  }
}

TEST_CASE("Disturbance: a wrench turns out a payload by the ratio of two dense Gaussians", "[disturbance]") {
  // Six blocks in poses that show all of the wrench. Either any wrench acts, which may answer to the compensation, or the
  // weight of a payload from the prior, which does not. What is known of the arm is the same.
  const unsigned seed = 564;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto prior = rme::PayloadPrior<double>::of(kRated);
  for (int trial = 0; trial < 10; ++trial) {
    CAPTURE(trial);
    const Star arm = random_star(random, false);
    Star star = arm;
    Disturbance::begin(star, kRated, false);
    constexpr int kBlocks = 6;
    const int rows = kBlocks * kDofs;
    // In the wrench's place, column kAnswer holds how the answers have added up: y = .. + J^T (w + s total).
    Matrix H = Matrix::Zero(rows, Dense::kAll), R = Matrix::Zero(rows, rows);
    Vector y(rows);
    rme::Vector6<double> total = rme::Vector6<double>::Zero();
    Model model = random_model(random);
    Eigen::Matrix<double, 6, kBlocks> totals;
    for (int k = 0; k < kBlocks; ++k) {
      rme::Answer<double> answer;
      if (k > 0) answer.change = 0.3 * oracle::random_matrix(random, 6, 1);
      answer.change.head<3>().setZero();  // the noise of an answer's moment is in proportion to its force
      total += answer.change;
      model = random_model(random, 0, 1, answer);
      auto block = model.block();
      block.velocity.setZero();
      rme::FrictionRegime<double, kDofs> regime;
      regime.update(block);
      rme::BlockContext<double, kDofs> context;
      context.answer = answer;
      model.begin(block, regime, context);
      if (k > 0) Disturbance::predict(model, star, Disturbing::Still, kRated);
      const double mass = std::max(0.0, -star.wrench_mean()[2] / 9.81);
      const Measured now = measured(model, mass, true);
      H.middleRows(k * kDofs, kDofs) = now.H;
      H.middleRows(k * kDofs, kDofs).col(rme::kAnswer) = model.block().jacobian.transpose() * total;
      R.block(k * kDofs, k * kDofs, kDofs, kDofs) = now.R;
      y.segment(k * kDofs, kDofs) = now.y;
      double squared;
      Disturbance::observe(model, star, Disturbing::Still, kNone, kRated, squared);
    }
    Dense any = Dense::of(arm), weight = any;
    any.mean[rme::kAnswer] = 0.5;
    any.covariance.block<6, 6>(rme::kWrench, rme::kWrench) = any_wrench();
    any.covariance(rme::kAnswer, rme::kAnswer) = 0.25;
    Matrix Y = Matrix::Zero(6, 4);
    Y(2, 0) = -9.81;
    Y(3, 2) = -9.81;  // r x (0, 0, -g) = (-g r_y, g r_x, 0)
    Y(4, 1) = 9.81;
    const double mass = std::clamp(-star.wrench_mean()[2] / 9.81, 0.02 * kRated, kRated);
    const Matrix L = prior.factor(mass * mass).topLeftCorner<4, 4>();
    weight.mean.segment<6>(rme::kWrench) = Y * prior.mean().head<4>();
    weight.covariance.block<6, 6>(rme::kWrench, rme::kWrench) = oracle::congruence(Y, oracle::square(L));
    const auto log_likelihood = [&](const Dense& d) {
      return oracle::log_normal(y - oracle::product(H, d.mean), oracle::congruence(H, d.covariance) + R);
    };
    const double expected = log_likelihood(weight) - log_likelihood(any);
    CHECK(Disturbance::weigh(model, star, prior, kRated) == Approx(expected).epsilon(1e-3).margin(1e-2));
  }
}

TEST_CASE("Disturbance: a torque that is no number has no likelihood, and one that is huge has a finite one",
          "[disturbance]") {
  const unsigned seed = 562;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const Model model = random_model(random);
  for (const double offset : {1e100, std::nan("")}) {
    Star star = random_star(random);
    star.joint(1).mean[rme::kOffset] = offset;
    Disturbance::begin(star, kRated, false);
    double squared;
    const double log_likelihood = Disturbance::observe(model, star, Disturbing::Still, kNone, kRated, squared);
    CHECK(std::isfinite(log_likelihood) == std::isfinite(offset));
    if (std::isfinite(offset)) CHECK(star.finite());
  }
}

}  // namespace
