#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <rme/tracking/pour.hpp>
#include <rme/tracking/swing.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"
#include "tracking/random_star.hpp"

namespace {

using oracle::Matrix;
using oracle::Vector;
using rme::kInertial;
using rme::kPayload;
using rme::kShared;
using rme::kSwing;
constexpr int kDofs = 3;
constexpr double kBlock = 0.02, kGravity = 9.81;
using Star = rme::StarGaussian<double, kDofs>;
using Swing = rme::Swing<double, kDofs>;

/// Holds `mass`, known to `deviation`; nothing else of the payload is in doubt.
Star holding(double mass, double deviation) {
  Star star;
  rme::InertialVector<double> mean = rme::InertialVector<double>::Zero();
  rme::InertialMatrix<double> factor = rme::InertialMatrix<double>::Zero();
  mean[0] = mass;
  factor(0, 0) = deviation;
  star.draw_payload(mean, factor);
  return star;
}

/// What the three joints measure: the force along x, y and z, with the payload's weight in the latter.
rme::JointObservation<double> force(int axis, double torque, double noise) {
  rme::JointObservation<double> o{torque, rme::SharedVector<double>::Zero(), rme::JointNuisanceVector<double>::Zero(),
                                  noise * noise};
  o.h[kSwing + axis] = 1;
  if (axis == 2) o.h[kPayload] = o.h[rme::kTool] = -kGravity;
  return o;
}

/// Lives through blocks in which the payload's mass is `mass`, and pulls with `pull(t)` beside its weight.
template <typename Pull>
void live(Star& star, Swing& swing, double mass, int blocks, std::mt19937& random, const Pull& pull) {
  std::normal_distribution<double> noise(0, 0.05);
  for (int k = 1; k <= blocks; ++k) {
    swing.predict(star, kBlock);
    const Eigen::Vector3d now = pull(k * kBlock) - Eigen::Vector3d(0, 0, kGravity * mass);
    for (int j = 0; j < kDofs; ++j) {
      const auto p = star.predict(j, force(j, now[j] + noise(random), 0.05));
      swing.observe(star, p);
      star.observe(j, p);
    }
    swing.learn(star, kBlock, kGravity * star.mass());
  }
}

TEST_CASE("Swing: it begins and ends with the moments of every pair, and is no part of the payload", "[swing]") {
  using namespace rme::testing;
  const unsigned seed = 514;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    Star star = random_star(random);
    rme::Pour<double, kDofs>().end(star);
    // It begins to swing, whatever else is known: just now, or before.
    const bool goes = k % 4 < 2;
    const double weight = 1 + random_vector(random, 1).cwiseAbs2()[0];
    Dense expected = dense(star);
    const rme::Vector4<double> tool = expected.covariance.diagonal().segment<4>(kTool);
    Matrix T = Matrix::Identity(kAll, kAll);  // the tool is known, so what depended on it does so no more
    for (int i = 0; i < 4; ++i) {
      T(kTool + i, kTool + i) = 0;
      for (int j = 0; j < kJoints; ++j)
        for (int n = 0; n < kJointNuisances; ++n) T(first(j) + n, kTool + i) = -star.joint(j).slope(kTool + i, n);
    }
    expected.covariance = T * expected.covariance * T.transpose();
    for (int i = 0; i < 3; ++i) expected.covariance(kSwing + i, kSwing + i) = goes ? 0.01 * weight * weight : 0;
    // What a hand carries takes the tool's place, and the joints' nuisances depend on it as they did on the tool.
    const rme::Vector4<double> led = k % 2 * random_vector(random, 4).cwiseAbs2(), told = star.mean().segment<4>(kTool);
    expected.covariance.diagonal().segment<4>(kTool) = led;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < kJoints; ++j)
        for (int n = 0; n < kJointNuisances; ++n) T(first(j) + n, kTool + i) = star.joint(j).slope(kTool + i, n);
    for (int i = 0; i < 4; ++i) T(kTool + i, kTool + i) = 1;
    expected.covariance = T * expected.covariance * T.transpose();
    Swing swing;
    swing.begin(star, weight, goes, led);
    CHECK(star.swings());
    CHECK(difference(dense(star), expected) < 1e-9);
    for (int i = 0; i < 9; ++i) star.observe(i % kJoints, star.predict(i % kJoints, random_observation(random)));
    CHECK(star.mass() == star.mean()[kPayload]);
    CHECK(star.mass_variance() == Approx(star.covariance()(kPayload, kPayload)));
    CHECK(star.payload_mean() == rme::InertialVector<double>(star.mean().segment<kInertial>(kPayload)));
    CHECK((star.payload_covariance() - star.covariance().block<kInertial, kInertial>(kPayload, kPayload)).norm() <
          1e-9 * star.covariance().norm());
    const Dense before = dense(star);
    // It ends: the tool is what it was, and as uncertain; the nuisances are those of an arm that nobody leads, and the rest
    // is as it was.
    CHECK(swing.tool_mean() == told);
    T = Matrix::Identity(kAll, kAll);
    for (int i = 0; i < 3; ++i) T(kSwing + i, kSwing + i) = 0;
    for (int i = 0; i < 4; ++i) {
      T(kTool + i, kTool + i) = 0;
      for (int j = 0; j < kJoints; ++j)
        for (int n = 0; n < kJointNuisances; ++n) T(first(j) + n, kTool + i) = -star.joint(j).slope(kTool + i, n);
    }
    expected = mapped(T, before);
    expected.mean.segment<4>(kTool) = told;
    for (int j = 0; j < kJoints; ++j)
      expected.mean.segment<kJointNuisances>(first(j)) += star.joint(j).slope.middleRows<4>(kTool).transpose() * told;
    expected.covariance.diagonal().segment<4>(kTool) += tool;
    Star changed = star;
    swing.end(changed);
    CHECK_FALSE(changed.swings());
    CHECK(difference(dense(changed), expected) < 1e-9);
    for (int i = 0; i < 4; ++i) CHECK(changed.variance(kTool + i) >= (1 - 1e-9) * tool[i]);
    const Dense ended = dense(changed);
    swing.end(changed);
    CHECK(difference(dense(changed), ended) == 0);
  }
}

TEST_CASE("Swing: payload, force and its rate are what one dense filter over all of them makes of random torques",
          "[swing]") {
  // df/dt = r, dr/dt = -L^2 f - 2 L r + noise, exactly over a block, with a stationary variance of f of s, and of r of
  // L^2 s. s begins with (0.1 of the weight)^2; it follows, within 0.3 s, r^2 / L^2 between 0.01 and 0.1 of the weight.
  const unsigned seed = 590;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Star star = holding(1.2, 0.3);
  Swing swing;
  swing.begin(star, kGravity * 1.2, true, rme::Vector4<double>::Zero());
  constexpr double L = 20;
  constexpr int kAll = kShared + 3;
  Vector mean = Vector::Zero(kAll);
  mean.head(kShared) = star.mean();
  Matrix P = Matrix::Zero(kAll, kAll);
  P.topLeftCorner(kShared, kShared) = star.covariance();
  Eigen::Vector3d size = Eigen::Vector3d::Constant(std::pow(0.1 * kGravity * 1.2, 2));
  for (int i = 0; i < 3; ++i) {
    CHECK(P(kSwing + i, kSwing + i) == Approx(size[i]));
    P(kShared + i, kShared + i) = L * L * size[i];
  }
  for (int k = 0; k < 100; ++k) {
    CAPTURE(k);
    // exp of the system's matrix, as (1 + M / 2^20)^(2^20).
    Eigen::Matrix2d step;
    step << 0, 1, -L * L, -2 * L;
    step = Eigen::Matrix2d::Identity() + kBlock / (1 << 20) * step;
    for (int n = 0; n < 20; ++n) step = Eigen::Matrix2d(step * step);
    Matrix T = Matrix::Identity(kAll, kAll);
    Matrix noise = Matrix::Zero(kAll, kAll);
    for (int i = 0; i < 3; ++i) {
      const int at[2] = {kSwing + i, kShared + i};
      const Eigen::Matrix2d still = Eigen::Vector2d(size[i], L * L * size[i]).asDiagonal();
      const Eigen::Matrix2d added = still - step * still * step.transpose();
      for (int a = 0; a < 2; ++a)
        for (int b = 0; b < 2; ++b) {
          T(at[a], at[b]) = step(a, b);
          noise(at[a], at[b]) = added(a, b);
        }
    }
    mean = oracle::product(T, mean);
    P = oracle::congruence(T, P) + noise;
    swing.predict(star, kBlock);
    for (int j = 0; j < kDofs; ++j) {
      rme::JointObservation<double> o{oracle::random_matrix(random, 1, 1)(0, 0),
                                      oracle::random_matrix(random, kShared, 1),
                                      rme::JointNuisanceVector<double>::Zero(), 0.04};
      o.h.head<rme::kArmShared>().setZero();
      Vector h = Vector::Zero(kAll);
      h.head(kShared) = o.h;
      h[kSwing + 3] = 0;  // a pour's
      o.h[kSwing + 3] = 0;
      const Vector cross = P * h;
      const double variance = h.dot(cross) + o.noise;
      mean += cross * (o.torque - h.dot(mean)) / variance;
      P -= cross * cross.transpose() / variance;
      const auto p = star.predict(j, o);
      swing.observe(star, p);
      star.observe(j, p);
    }
    const double share = 1 - std::exp(-kBlock / 0.3), weight = kGravity * std::max(0.1, star.mass());
    for (int i = 0; i < 3; ++i) {
      const double r = mean[kShared + i];
      size[i] += share * ((r * r + P(kShared + i, kShared + i)) / (L * L) - size[i]);
      size[i] = std::clamp(size[i], std::pow(0.01 * weight, 2), std::pow(0.1 * weight, 2));
    }
    swing.learn(star, kBlock, weight);
    CHECK((star.mean() - mean.head(kShared)).norm() < 1e-5);
    CHECK((star.covariance() - P.topLeftCorner(kShared, kShared)).norm() < 1e-5 * P.norm());
  }
}

TEST_CASE("Swing: mass and frequency of what hangs on a string, or on a spring, are found", "[swing]") {
  const unsigned seed = 591;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (const double frequency : {0.8, 1.1, 2.8, 5.0})
    for (const bool bounces : {false, true}) {
      CAPTURE(frequency, bounces);
      Star star = holding(1.3, 0.3);
      Swing swing;
      swing.begin(star, kGravity * 1.3, true, rme::Vector4<double>::Zero());
      CHECK(swing.frequency() == 0);
      live(star, swing, 1, 200, random, [&](double t) {  // 10 degrees, or a quarter of the weight
        const double phase = 2 * std::acos(-1.0) * frequency * t;
        return bounces ? Eigen::Vector3d(0, 0, 2.5 * std::sin(phase)) : Eigen::Vector3d(1.6 * std::sin(phase), 0.5, 0);
      });
      CHECK(star.mass() == Approx(1).epsilon(0.05));
      CHECK(std::abs(star.mass() - 1) < 4 * std::sqrt(star.mass_variance()));
      CHECK(swing.frequency() == Approx(frequency).epsilon(0.08));
    }
}

TEST_CASE("Swing: a force that stays is no swing, but weight", "[swing]") {
  const unsigned seed = 592;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Star star = holding(0.8, 0.1);
  Swing swing;
  swing.begin(star, kGravity * 0.8, true, rme::Vector4<double>::Zero());
  live(star, swing, 1, 400, random, [](double) { return Eigen::Vector3d(0, 0, 0); });
  CHECK(star.mass() == Approx(1).epsilon(0.03));
  CHECK(std::abs(star.mean()[kSwing + 2]) < 0.3);
}

TEST_CASE("Swing: a payload that swung unnoticed is off by 3 % at most, and by less the longer it was held",
          "[swing]") {
  CHECK(Swing::hidden(0) == Approx(0.03 * 0.03));
  CHECK(Swing::hidden(0.3) == Approx(0.03 * 0.03 / std::exp(1.0)));
  CHECK(Swing::hidden(std::numeric_limits<double>::max()) == 0);
}

TEST_CASE("Swing: what begins to swing more than a second after it was drawn may be led by a hand that carries of it",
          "[swing]") {
  CHECK_FALSE(Swing::may_be_led(0.99));
  CHECK(Swing::led(0.99, 2).isZero(0));
  CHECK(Swing::may_be_led(1.01));
  CHECK(Swing::led(1.01, 2).isApprox(rme::Vector4<double>(0.36, 0.04, 0.04, 0.04)));
  const unsigned seed = 593;
  CAPTURE(seed);
  for (const bool led : {false, true}) {
    CAPTURE(led);
    std::mt19937 random(seed);
    Star star = holding(1, 0.01);
    Swing swing;
    swing.begin(star, kGravity, false, Swing::led(led ? 2 : 0, 1));
    live(star, swing, 0.8, 1000, random, [](double) { return Eigen::Vector3d(0, 0, 0); });
    CHECK(std::abs(star.mass() - (led ? 1 : 0.8)) < 0.02);  // somebody carries 0.2 kg of it, or it is lighter
    CHECK(swing.tool_mean().isZero(0));
    swing.end(star);
    CHECK(star.mean()[rme::kTool] == 0);
  }
}

}  // namespace
