#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <rme/tracking/swing.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

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
    CHECK(star.tool_mean().isZero(0));
    star.end_swing();
    CHECK(star.tool_mean().isZero(0));
    CHECK(star.mean()[rme::kTool] == 0);
  }
}

}  // namespace
