#pragma once
/// Stars in which everything that may be correlated is, and the dense Gaussians that they stand for.
#include <algorithm>
#include <cmath>
#include <limits>
#include <random>
#include <rme/tracking/rate.hpp>
#include <rme/tracking/star_gaussian.hpp>

#include "support/linear_algebra.hpp"

namespace rme::testing {

using oracle::Matrix;
using oracle::Vector;
using rme::kArmShared;
using rme::kInertial;
using rme::kJointNuisances;
using rme::kPayload;
using rme::kPoured;
using rme::kShared;
using rme::kSwing;
using rme::kTool;
inline constexpr int kJoints = 3;
inline constexpr int kAll = kShared + kJoints * kJointNuisances;
using Star = rme::StarGaussian<double, kJoints>;
using Arm = Eigen::Matrix<double, kArmShared, 1>;

inline int first(int j) {
  return kShared + j * kJointNuisances;
}

inline Vector random_vector(std::mt19937& random, int n) {
  return oracle::random_matrix(random, n, 1).col(0);
}

inline rme::JointObservation<double> random_observation(std::mt19937& random) {
  const double noise = 0.01 + std::uniform_real_distribution<double>(0, 1)(random);
  return {3 * random_vector(random, 1)[0], random_vector(random, kShared), random_vector(random, kJointNuisances),
          noise};
}

/// Any star with a payload, of which some has been poured: everything that may be correlated is.
inline Star random_star(std::mt19937& random) {
  Star star;
  star.set_arm(Arm::Constant(0.5) + Arm(random_vector(random, kArmShared).cwiseAbs2()));
  star.draw_payload(random_vector(random, kInertial), oracle::random_matrix(random, kInertial, kInertial));
  star.extend(Star::Last::Poured);
  rme::Rate<double, kJoints> rate;
  rate.mean = random_vector(random, 4);
  rate.covariance = oracle::square(oracle::random_matrix(random, 4, 4));
  rate.drift(star, 1, oracle::square(oracle::random_matrix(random, 4, 4)));
  for (int j = 0; j < kJoints; ++j) {
    star.joint(j).mean = random_vector(random, kJointNuisances);
    star.joint(j).slope = oracle::random_matrix(random, kShared, kJointNuisances);
    star.joint(j).covariance = oracle::square(oracle::random_matrix(random, kJointNuisances, kJointNuisances));
  }
  for (int k = 0; k < 9; ++k) star.observe(k % kJoints, star.predict(k % kJoints, random_observation(random)));
  return star;
}

/// The same Gaussian over all of (x, beta_1 .. beta_n), by the definition of a star.
struct Dense {
  Vector mean;
  Matrix covariance;
};
inline Dense dense(const Star& star) {
  // (x, beta) = T (x, beta - E[beta | x]) + constant, and the latter two are independent.
  Matrix T = Matrix::Identity(kAll, kAll), blocks = Matrix::Zero(kAll, kAll);
  Vector constant = Vector::Zero(kAll), x = Vector::Zero(kAll);
  blocks.topLeftCorner(kShared, kShared) = star.covariance();
  for (int j = 0; j < kJoints; ++j) {
    T.block(first(j), 0, kJointNuisances, kShared) = star.joint(j).slope.transpose();
    blocks.block(first(j), first(j), kJointNuisances, kJointNuisances) = star.joint(j).covariance;
    constant.segment(first(j), kJointNuisances) = star.joint(j).mean;
  }
  x.head(kShared) = star.mean();
  return {oracle::product(T, x) + constant, oracle::congruence(T, blocks)};
}

/// A linear map of everything.
inline Dense mapped(const Matrix& T, const Dense& d) {
  return {oracle::product(T, d.mean), oracle::congruence(T, d.covariance)};
}
/// T that leaves the hand empty.
inline Matrix emptying() {
  Matrix T = Matrix::Identity(kAll, kAll);
  for (int i = kArmShared; i < kShared; ++i) T(i, i) = 0;
  return T;
}

/// Largest difference of two Gaussians in what a star holds: x and each pair (x, beta_j), but not two joints'
/// nuisances. Relative to the deviations; infinite if one of them is not finite.
inline double difference(const Dense& a, const Dense& b) {
  for (const Dense* d : {&a, &b})
    if (!d->mean.allFinite() || !d->covariance.allFinite()) return std::numeric_limits<double>::infinity();
  const Vector scale = b.covariance.diagonal().cwiseMax(1e-300).cwiseSqrt();
  double worst = 0;
  for (int i = 0; i < kAll; ++i) {
    worst = std::max(worst, std::abs(a.mean[i] - b.mean[i]) / scale[i]);
    for (int k = 0; k < kAll; ++k) {
      const bool own =
          i < kShared || k < kShared || (i - first(0)) / kJointNuisances == (k - first(0)) / kJointNuisances;
      if (own) worst = std::max(worst, std::abs(a.covariance(i, k) - b.covariance(i, k)) / (scale[i] * scale[k]));
    }
  }
  return worst;
}

}  // namespace rme::testing
