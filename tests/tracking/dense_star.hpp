#pragma once
// The Gaussian of a star without its form: mean and covariance of all of (x, beta_1 .. beta_n).
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/tracking/star_gaussian.hpp>

#include "support/linear_algebra.hpp"

namespace oracle {

template <int Joints>
struct DenseStar {
  static constexpr int kAll = rme::kShared + Joints * rme::kJointNuisances;
  /// Index of the first nuisance of joint j.
  static constexpr int first(int j) { return rme::kShared + j * rme::kJointNuisances; }

  Vector mean;
  Matrix covariance;

  /// By the definition of a star: (x, beta) = T (x, beta - E[beta | x]) + constant, and the latter two are independent.
  static DenseStar of(const rme::StarGaussian<double, Joints>& star) {
    Matrix T = Matrix::Identity(kAll, kAll), blocks = Matrix::Zero(kAll, kAll);
    Vector constant = Vector::Zero(kAll), x = Vector::Zero(kAll);
    blocks.topLeftCorner(rme::kShared, rme::kShared) = star.covariance();
    for (int j = 0; j < Joints; ++j) {
      T.block(first(j), 0, rme::kJointNuisances, rme::kShared) = star.joint(j).slope.transpose();
      blocks.block(first(j), first(j), rme::kJointNuisances, rme::kJointNuisances) = star.joint(j).covariance;
      constant.segment(first(j), rme::kJointNuisances) = star.joint(j).mean;
    }
    x.head(rme::kShared) = star.mean();
    return {product(T, x) + constant, congruence(T, blocks)};
  }
  /// A linear map of everything.
  DenseStar mapped(const Matrix& T) const { return {product(T, mean), congruence(T, covariance)}; }
  /// Regressor of an observation of joint j.
  static Vector row(int j, const rme::JointObservation<double>& o) {
    Vector out = Vector::Zero(kAll);
    out.head(rme::kShared) = o.h;
    out.segment(first(j), rme::kJointNuisances) = o.c;
    return out;
  }
  /// Given the measurements y = H z + noise of covariance R.
  DenseStar given(const Matrix& H, const Vector& y, const Matrix& R) const {
    const Matrix cross = product(covariance, transposed(H));
    const Matrix gain = transposed(solve(congruence(H, covariance) + R, transposed(cross)));
    return {mean + product(gain, y - product(H, mean)), covariance - product(gain, transposed(cross))};
  }

  /// Largest difference of two Gaussians in what a star holds: x and each pair (x, beta_j), but not two joints'
  /// nuisances. Relative to the deviations; infinite if one of them is not finite.
  friend double difference(const DenseStar& a, const DenseStar& b) {
    for (const DenseStar* d : {&a, &b})
      if (!d->mean.allFinite() || !d->covariance.allFinite()) return std::numeric_limits<double>::infinity();
    const Vector scale = b.covariance.diagonal().cwiseMax(1e-300).cwiseSqrt();
    double worst = 0;
    for (int i = 0; i < kAll; ++i) {
      worst = std::max(worst, std::abs(a.mean[i] - b.mean[i]) / scale[i]);
      for (int k = 0; k < kAll; ++k) {
        const bool own = i < rme::kShared || k < rme::kShared ||
                         (i - first(0)) / rme::kJointNuisances == (k - first(0)) / rme::kJointNuisances;
        if (own) worst = std::max(worst, std::abs(a.covariance(i, k) - b.covariance(i, k)) / (scale[i] * scale[k]));
      }
    }
    return worst;
  }
};

}  // namespace oracle
