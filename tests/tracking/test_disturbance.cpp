#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <rme/tracking/disturbance.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using oracle::Matrix;
using oracle::Vector;
using rme::Disturbing;
using rme::kInertial;
using rme::kJointNuisances;
using rme::kShared;
using rme::Sensing;
constexpr int kDofs = 3;
constexpr double kRated = 3;
constexpr double kNone = -std::numeric_limits<double>::infinity();  // log probability
using Star = rme::StarGaussian<double, kDofs>;
using Model = rme::JointTorqueModel<double, kDofs>;
using Disturbance = rme::Disturbance<double, kDofs>;
using Matrix6 = Eigen::Matrix<double, 6, 6>;

/// A model in a random block.
/// @param shaken  posterior variance of the flange's acceleration [(m/s^2)^2]
/// @param loud    size of the torque, in twice a newton metre
Model random_model(std::mt19937& random, double shaken = 0, double loud = 1, Sensing sensing = Sensing::JointFriction) {
  Model model(rme::kind_of(sensing), rme::ArmPrior<double, kDofs>::of(kRated), kRated, 0.02, {0, 0, -9.81});
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
  model.begin(block, regime);
  return model;
}

Star random_star(std::mt19937& random) {
  Star star;
  star.set_arm(Eigen::Matrix<double, rme::kArmShared, 1>::Constant(0.04));
  star.set_tilt(0.01);                                                        // of an arm of 15 kg
  const Matrix factor = oracle::random_matrix(random, kInertial, kInertial);  // before the mean, whatever the compiler
  star.draw_payload(oracle::random_matrix(random, kInertial, 1), factor);
  for (int j = 0; j < kDofs; ++j) {
    star.joint(j).mean = oracle::random_matrix(random, kJointNuisances, 1);
    star.joint(j).slope = oracle::random_matrix(random, kShared, kJointNuisances);
    Matrix spread = oracle::random_matrix(random, kJointNuisances, kJointNuisances);
    spread.row(rme::kGain) *= 0.002;  // of a torque of tens of newton metres
    star.joint(j).covariance = oracle::square(spread);
    star.joint(j).slope.col(rme::kGain) *= 0.002;
  }
  return star;
}

/// The observation of a joint whose gain is what is believed of it.
rme::JointObservation<double> with_known_gain(const Star& star, int j, rme::JointObservation<double> o) {
  const auto& joint = star.joint(j);
  o.torque -= o.c[rme::kGain] * (joint.mean[rme::kGain] + joint.slope.col(rme::kGain).dot(star.mean()));
  o.c[rme::kGain] = 0;
  return o;
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

using Load = rme::Load<double, kDofs>;
/// What the joints bear: the payload, and the wrench, which may be a weight.
Load load(const Model& model, const Star& star, const Disturbance& disturbance) {
  Load out;
  out.mass = std::max(0.0, star.mass() - disturbance.mean()[2] / 9.81);
  out.torque = model.block().regressor * star.payload_mean() + model.block().jacobian.transpose() * disturbance.mean();
  return out;
}

TEST_CASE("Disturbance: wrench, likelihood and nuisances are those of dense Gaussians, and the payload is kept",
          "[disturbance]") {
  const unsigned seed = 563;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const double log_jolt = std::log(0.001);  // per block
  int went_on = 0, pushed = 0, touched = 0, hidden = 0;
  for (int trial = 0; trial < 40; ++trial) {
    const Disturbing how = trial % 2 == 0 ? Disturbing::Hand : Disturbing::Still;
    const double loud = trial % 4 < 2 ? 1 : 30;
    const Sensing sensing = trial % 8 < 4 ? Sensing::LinkSide : Sensing::JointFriction;
    const double touches = sensing == Sensing::LinkSide ? 0.05 : 0;
    CAPTURE(trial, loud, touches);
    Star star = random_star(random);
    Disturbance disturbance;
    disturbance.begin(kRated);
    bool begins = true;
    for (int k = 0; k < 3; ++k) {  // from the second block on, something is known of the wrench
      CAPTURE(k);
      if (k > 0) disturbance.predict(how, 0.02, kRated);
      const Model model = random_model(random, 0, k == 2 ? loud : 1, sensing);
      // tau = h^T x + c^T beta + J^T w + noise. Jointly with x the wrench is not: x keeps its distribution.
      // What is not known of the payload and of the gains does not count.
      Matrix P = star.covariance();
      P.rightCols(kShared - rme::kPayload).setZero();
      P.bottomRows(kShared - rme::kPayload).setZero();
      const Matrix JT = oracle::transposed(model.block().jacobian);
      Matrix U(kDofs, kShared), own = Matrix::Zero(kDofs, kDofs), shaken = Matrix::Zero(kDofs, kDofs);
      Vector e(kDofs);
      const Load bears = load(model, star, disturbance);
      for (int j = 0; j < kDofs; ++j) {
        const auto o = with_known_gain(star, j, model.observation(j, bears));
        const auto& joint = star.joint(j);
        U.row(j) = (o.h + joint.slope * o.c).transpose();
        own(j, j) = o.c.dot(joint.covariance * o.c) + o.noise;
        shaken(j, j) = std::pow(3 * model.arm().residual[j], 2);
        e[j] = o.torque - o.c.dot(joint.mean) - U.row(j).dot(star.mean());
      }
      const Matrix known = oracle::congruence(U, P) + own;
      const auto with = [&](const Matrix& W) { return Matrix(known + oracle::congruence(JT, W)); };
      const auto surprise = [&](const Vector& w) { return Vector(e - oracle::product(JT, w)); };
      // The wrench goes on; or a hand pushes anew; or a jolt of one of three sizes hides it.
      Vector w = disturbance.mean();
      Matrix W = disturbance.covariance();
      const double goes_on = how == Disturbing::Hand && begins ? -1e30 : oracle::log_normal(surprise(w), with(W));
      double anew = -1e30, all_anew = -1e30;  // as a push, or as a touch
      Matrix other = W;
      for (const double size : {1.0, 0.1}) {
        if (how != Disturbing::Hand) break;
        const Matrix prior = size * size * any_wrench();
        const double probability = !begins ? (size < 1 ? 0 : 0.001) : size < 1 ? touches : 1 - touches;
        if (!(probability > 0)) break;
        const double log_one = std::log(probability) + oracle::log_normal(e, with(prior));
        all_anew = log_sum(all_anew, log_one);
        if (log_one > anew) other = prior;
        anew = std::max(anew, log_one);
      }
      double jolt = -1e30;
      for (const double size : {1.0, 10.0, 100.0})
        jolt = log_sum(jolt,
                       oracle::log_normal(e, size * size * (with(any_wrench()) + shaken)) + log_jolt - std::log(3.0));
      const bool learns = jolt <= std::max(goes_on, anew);
      if (learns && anew > goes_on) {
        w.setZero();
        W = other;
      }
      begins = begins && !learns;
      (!learns ? hidden : anew <= goes_on ? went_on : other == any_wrench() ? pushed : touched) += 1;
      const Matrix gain = oracle::transposed(oracle::solve(with(W), oracle::product(JT, W)));
      const Vector mean = learns ? Vector(w + oracle::product(gain, surprise(w))) : w;
      const Matrix covariance = learns ? Matrix(W - oracle::product(gain, oracle::product(JT, W))) : W;
      const Star before = star;
      double squared = 0, expected_square = 0;
      const double log_likelihood = disturbance.observe(model, star, how, log_jolt, kRated, squared);
      CHECK(log_likelihood == Approx(log_sum(log_sum(goes_on, all_anew), jolt)).epsilon(1e-9));
      CHECK((disturbance.mean() - mean).norm() <= 1e-9 * mean.norm());
      CHECK((disturbance.covariance() - covariance).norm() < 1e-9 * W.norm());
      // Given x, and the wrench as it was known, each joint's nuisances learn from what is left. The wrench's error is
      // the same in 200 blocks.
      for (int j = 0; j < kDofs; ++j) {
        CAPTURE(j);
        const auto o = with_known_gain(before, j, model.observation(j, bears));
        const auto& joint = before.joint(j);
        expected_square += std::pow(e[j], 2) / (own(j, j) + U.row(j).dot(before.covariance() * U.row(j).transpose()));
        auto expected = joint;
        if (learns) {
          const double noise = 200 * JT.row(j).dot(W * JT.row(j).transpose());
          const Vector K = joint.covariance * o.c / (own(j, j) + noise);
          const double left = o.torque - JT.row(j).dot(w) - o.c.dot(joint.mean);
          expected.slope -= U.row(j).transpose() * K.transpose();
          expected.mean += K * left;
          expected.covariance -= K * o.c.transpose() * joint.covariance;
        }
        CHECK((star.joint(j).mean - expected.mean).norm() < 1e-9 * expected.mean.norm());
        CHECK((star.joint(j).slope - expected.slope).topRows<rme::kHeldShared>().norm() < 1e-9 * expected.slope.norm());
        CHECK((star.joint(j).covariance - expected.covariance).norm() < 1e-9 * expected.covariance.norm());
      }
      CHECK(squared == Approx(expected_square));
      CHECK(star.mean() == before.mean());
      CHECK(star.covariance() == before.covariance());
    }
  }
  CHECK(went_on > 0);
  CHECK(pushed > 0);
  CHECK(touched > 0);
  CHECK(hidden > 0);
}

TEST_CASE("Disturbance: nothing is learned of a jolt", "[disturbance]") {
  const unsigned seed = 565;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const Model model = random_model(random, 0, 100);
  Star star = random_star(random);
  const Star before = star;
  Disturbance disturbance;
  disturbance.begin(kRated);
  double squared;
  CHECK(std::isfinite(disturbance.observe(model, star, Disturbing::Jolt, 0, kRated, squared)));
  CHECK(disturbance.mean().isZero(0));
  for (int j = 0; j < kDofs; ++j) CHECK(star.joint(j).mean == before.joint(j).mean);
}

TEST_CASE("Disturbance: a hand trembles, a growing wrench grows along itself, a still one stays", "[disturbance]") {
  const unsigned seed = 561;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto after = [&](Disturbing how, double duration) {
    std::mt19937 same = random;
    Disturbance disturbance;
    disturbance.begin(kRated);
    Star star = random_star(same);
    double squared;
    disturbance.observe(random_model(same), star, how, kNone, kRated, squared);
    const Disturbance before = disturbance;
    disturbance.predict(how, duration, kRated);
    CHECK(disturbance.mean() == before.mean());
    const Matrix6 added = disturbance.covariance() - before.covariance();
    return std::pair(added, before.mean());
  };
  for (const double duration : {0.02, 0.06}) {
    CHECK(after(Disturbing::Still, duration).first.isZero(0));
    const Matrix6 hand = after(Disturbing::Hand, duration).first, tremble = 0.01 * duration / 0.02 * any_wrench();
    CHECK((hand - tremble).norm() < 1e-9 * tremble.norm());
    const auto [growing, wrench] = after(Disturbing::Growing, duration);
    REQUIRE(wrench.head<3>().cwiseAbs().maxCoeff() > 1);
    // Of rank one but for a tremble that is a five hundredth of a hand's.
    const Matrix6 own = 4e-8 * duration / 0.02 * any_wrench();
    const double along = (growing - own).trace() / wrench.squaredNorm();
    CHECK((growing - own - along * wrench * wrench.transpose()).norm() < 1e-9 * growing.norm());
    CHECK(along > 0);
    CHECK(growing.trace() < tremble.trace());
  }
  Disturbance disturbance;
  disturbance.begin(kRated);
  CHECK((disturbance.covariance() - any_wrench()).norm() < 1e-9);
  CHECK(disturbance.mean().isZero(0));
}

TEST_CASE("Disturbance: a wrench that acts like a weight has the noise of that weight's inertia", "[disturbance]") {
  // Known to be the weight of 2 kg: the block is then as likely as with a payload of 2 kg more.
  const unsigned seed = 563;
  CAPTURE(seed);
  for (const double shaken : {0.0, 1.0}) {
    std::mt19937 random(seed);
    Disturbance disturbance;
    disturbance.begin(kRated);
    for (int k = 0; k < 4000; ++k) {
      Model model = random_model(random);
      auto block = model.block();
      rme::Vector6<double> weight;
      weight << 0, 0, -2 * 9.81, 0, 0, 0;
      block.tau = block.jacobian.transpose() * weight;
      rme::FrictionRegime<double, kDofs> regime;
      regime.update(block);
      model.begin(block, regime);
      Star empty;
      double squared;
      disturbance.observe(model, empty, Disturbing::Still, kNone, kRated, squared);
    }
    REQUIRE(disturbance.mean()[2] == Approx(-2 * 9.81).epsilon(1e-2));
    const Model model = random_model(random, shaken);
    Star star, copy;
    double squared = 0, expected = 0;
    disturbance.observe(model, star, Disturbing::Still, kNone, kRated, squared);
    for (int j = 0; j < kDofs; ++j) {
      const auto p = copy.predict(j, model.observation(j, load(model, copy, disturbance)));
      expected += p.innovation * p.innovation / p.variance;
    }
    CHECK(squared == Approx(expected).epsilon(0.05));
    if (shaken > 0) CHECK(model.observation(0, {2, Load().torque}).noise > 1.5 * model.observation(0, {}).noise);
  }
}

TEST_CASE("Disturbance: a wrench turns out a payload by the ratio of two dense Gaussians", "[disturbance]") {
  const unsigned seed = 564;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto prior = rme::PayloadPrior<double>::of(kRated);
  for (int trial = 0; trial < 10; ++trial) {
    CAPTURE(trial);
    Star star;
    star.set_arm(Eigen::Matrix<double, rme::kArmShared, 1>::Constant(0.04));
    if (trial % 2 == 0)
      star.draw_payload(oracle::random_matrix(random, kInertial, 1).cwiseAbs(),
                        0.1 * oracle::random_matrix(random, kInertial, kInertial));
    for (int j = 0; j < kDofs; ++j)
      star.joint(j).covariance = oracle::square(oracle::random_matrix(random, kJointNuisances, kJointNuisances));
    Disturbance disturbance;
    disturbance.begin(kRated);
    Model model = random_model(random);
    for (int k = 0; k < 6; ++k) {  // in poses that show all of the wrench
      model = random_model(random);
      Star copy = star;
      double squared;
      disturbance.observe(model, copy, Disturbing::Still, kNone, kRated, squared);
      disturbance.predict(Disturbing::Hand, 0.02 * (trial % 3), kRated);
    }
    // All blocks together are one measurement z of the wrench, with an error that is added up from theirs and the arm's.
    // What is known of a wrench that nothing is known of has changed with it, by a tenth of a hand's each time.
    const Matrix C = disturbance.covariance(), W = (1 + 0.01 * 6 * (trial % 3)) * any_wrench();
    const Matrix one = Matrix::Identity(6, 6);
    const Matrix shown = oracle::solve(oracle::solve(C, one) - oracle::solve(W, one), one);
    Matrix U(kDofs, kShared), arm = Matrix::Zero(kDofs, kDofs);
    Load bears = load(model, star, disturbance);
    bears.mass = star.mass();
    for (int j = 0; j < kDofs; ++j) {
      const auto o = model.observation(j, bears);
      U.row(j) = (o.h + star.joint(j).slope * o.c).transpose();
      arm(j, j) = o.c.dot(star.joint(j).covariance * o.c) + o.noise;
    }
    const Matrix S = oracle::congruence(U, star.covariance()) + arm;
    const Matrix J = model.block().jacobian;
    // Three joints show three directions of the wrench; the others are hardly known.
    const Matrix once = oracle::product(J, oracle::solve(S, oracle::transposed(J))) + 1e-6 * oracle::solve(W, one);
    const Matrix error = shown + oracle::solve(once, one);
    const Vector z = oracle::product(shown, oracle::solve(C, Matrix(disturbance.mean())));
    Matrix Y = Matrix::Zero(6, 4);
    Y(2, 0) = -9.81;
    Y(3, 2) = -9.81;  // r x (0, 0, -g) = (-g r_y, g r_x, 0)
    Y(4, 1) = 9.81;
    const double mass = std::clamp(star.mass() - disturbance.mean()[2] / 9.81, 0.02 * kRated, kRated);
    const Matrix L = prior.factor(mass * mass).topLeftCorner<4, 4>();
    const Vector change = prior.mean().head<4>() - star.payload_mean().head<4>();
    const Matrix with_payload = oracle::congruence(Y, oracle::square(L)) + error, with_any = W + error;
    const double expected =
        oracle::log_normal(z - oracle::product(Y, change), with_payload) - oracle::log_normal(z, with_any);
    CHECK(disturbance.weigh(model, star, prior, kRated) == Approx(expected).epsilon(1e-3).margin(1e-3));
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
    Disturbance disturbance;
    disturbance.begin(kRated);
    double squared;
    const double log_likelihood = disturbance.observe(model, star, Disturbing::Still, kNone, kRated, squared);
    CHECK(std::isfinite(log_likelihood) == std::isfinite(offset));
    if (std::isfinite(offset)) CHECK(star.finite());
  }
}

}  // namespace
