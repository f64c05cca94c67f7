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
  if (axis == 2) o.h[kPayload] = -kGravity;
  return o;
}

/// Lives through blocks in which the payload's mass is `mass`, and pulls with `pull(t)` beside its weight.
template <typename Pull>
void live(Star& star, Swing& swing, double mass, int blocks, std::mt19937& random, const Pull& pull) {
  std::normal_distribution<double> noise(0, 0.05);
  for (int k = 1; k <= blocks; ++k) {
    swing.predict(star, kBlock);
    const Eigen::Vector3d now = pull(k * kBlock) - Eigen::Vector3d(0, 0, kGravity * mass);
    for (int j = 0; j < kDofs; ++j) star.observe(j, star.predict(j, force(j, now[j] + noise(random), 0.05)));
    swing.learn(star, kBlock, kGravity * star.mass());
  }
}

TEST_CASE("Swing: payload and force are what one dense filter over both makes of random torques", "[swing]") {
  // The force of each axis decays in 0.15 s, with a noise that keeps its size. The size begins with 0.15 of the weight;
  // it follows, within a second, the square of the force about its own mean, and stays within 0.01 and 0.3 of the weight.
  const unsigned seed = 590;
  CAPTURE(seed);
  std::mt19937 random(seed);
  Star star = holding(1.2, 0.3);
  Swing swing;
  swing.begin(star, kGravity * 1.2);
  Vector mean = star.mean();
  Matrix P = star.covariance();
  Eigen::Vector3d size = Eigen::Vector3d::Constant(std::pow(0.15 * kGravity * 1.2, 2)),
                  middle = Eigen::Vector3d::Zero();
  for (int i = 0; i < 3; ++i) CHECK(P(kSwing + i, kSwing + i) == Approx(size[i]));
  for (int k = 0; k < 100; ++k) {
    CAPTURE(k);
    const double keep = std::exp(-kBlock / 0.15);
    Matrix T = Matrix::Identity(kShared, kShared);
    for (int i = 0; i < 3; ++i) T(kSwing + i, kSwing + i) = keep;
    mean = oracle::product(T, mean);
    P = oracle::congruence(T, P);
    for (int i = 0; i < 3; ++i) P(kSwing + i, kSwing + i) += (1 - keep * keep) * size[i];
    swing.predict(star, kBlock);
    for (int j = 0; j < kDofs; ++j) {
      rme::JointObservation<double> o{oracle::random_matrix(random, 1, 1)(0, 0),
                                      oracle::random_matrix(random, kShared, 1),
                                      rme::JointNuisanceVector<double>::Zero(), 0.04};
      o.h.head<rme::kArmShared>().setZero();
      const Vector cross = P * Vector(o.h);
      const double variance = o.h.dot(cross) + o.noise;
      mean += cross * (o.torque - o.h.dot(mean)) / variance;
      P -= cross * cross.transpose() / variance;
      star.observe(j, star.predict(j, o));
    }
    const double share = 1 - std::exp(-kBlock), weight = kGravity * std::max(0.1, star.mass());
    for (int i = 0; i < 3; ++i) {
      const double before = mean[kSwing + i] - middle[i], after = before - share * before;
      middle[i] += share * before;
      size[i] = (1 - share) * size[i] + share * (before * after + P(kSwing + i, kSwing + i));
      size[i] = std::clamp(size[i], std::pow(0.01 * weight, 2), std::pow(0.3 * weight, 2));
    }
    swing.learn(star, kBlock, weight);
    CHECK((star.mean() - mean).norm() < 1e-9);
    CHECK((star.covariance() - P).norm() < 1e-9 * P.norm());
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
      swing.begin(star, kGravity * 1.3);
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
  swing.begin(star, kGravity * 0.8);
  live(star, swing, 1, 400, random, [](double) { return Eigen::Vector3d(0, 0, 0); });
  CHECK(star.mass() == Approx(1).epsilon(0.03));
  CHECK(std::abs(star.mean()[kSwing + 2]) < 0.3);
}

TEST_CASE("Swing: what swung unnoticed is off by at most the first size of a swing, and by less the longer it was held",
          "[swing]") {
  CHECK(Swing::hidden(0) == Approx(0.15 * 0.15));
  CHECK(Swing::hidden(0.15) == Approx(0.15 * 0.15 / std::exp(1.0)));
  CHECK(Swing::hidden(std::numeric_limits<double>::max()) == 0);
}

}  // namespace
