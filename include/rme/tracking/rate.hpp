#pragma once
/// How quickly a part of a filter's shared unknowns changes.
#include <rme/core/singular_cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/star_gaussian.hpp>

namespace rme {

/// A Gaussian over the rate r of the last four entries of a star's x, correlated with x. Each beta_j depends on r only
/// through x. Real time: nothing allocates.
template <typename Scalar, int Dofs>
struct Rate {
  using Star = StarGaussian<Scalar, Dofs>;  ///< state of the filter
  using Beta = typename Star::Beta;         ///< 6x1
  using Slope = typename Star::Slope;       ///< 21x6

  Vector4<Scalar> mean = Vector4<Scalar>::Zero();        ///< [of x / s]
  Matrix4<Scalar> covariance = Matrix4<Scalar>::Zero();  ///< of the rate
  typename Star::Cross cross = Star::Cross::Zero();      ///< cov(x, rate)

  /// Updates the rate with an observation; to be called before star.observe(j, p).
  void observe(const Star& star, const typename Star::Prediction& p) noexcept {
    const Vector4<Scalar> shown = detail::transposed_product(cross, p.gain_row);  // cov(rate, y)
    const SharedVector<Scalar> row = star.covariance_row(p);
    const Vector4<Scalar> gain = detail::scaled(Scalar(1) / p.variance, shown);
    detail::add_scaled(mean, p.innovation, gain);
    detail::add_outer(cross, detail::scaled(Scalar(-1), row), gain);
    detail::add_outer(covariance, detail::scaled(Scalar(-1), shown), gain);
  }
  /// The last four entries of x move by dt r; then process noise Q is added to them. Each beta_j keeps its moments with the
  /// old x (docs/theory.md, "The star").
  /// @param star  state; if Q is not finite, nothing changes
  /// @param dt    [s]
  /// @param Q     covariance of the noise, positive semidefinite
  void drift(Star& star, Scalar dt, const Matrix4<Scalar>& Q) noexcept {
    // r = E[r] + G^T (x - E[x]) + what x does not tell. So x' = A x + E n, with A = 1 + dt E G^T, and n, the noise, in the
    // last four entries alone: beta_j changes by matrices of rank four.
    using Factor = SingularCholesky<Scalar, kShared>;
    SharedMatrix<Scalar> total = star.covariance();
    const Factor before(total);
    if (!before.finite()) return;
    const typename Star::Cross G = before.solve(cross);
    Matrix4<Scalar> noise = covariance;
    detail::add_scaled(noise, Scalar(-1), Matrix4<Scalar>(detail::transposed_product(cross, G)));
    noise *= dt * dt;
    noise += Q;
    typename Star::Cross after = cross;
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 4; ++i) after(kHeldShared + i, k) += dt * covariance(i, k);
    for (int i = 0; i < kShared; ++i) {
      for (int k = 0; k < 4; ++k) {
        total(i, kHeldShared + k) += dt * cross(i, k);
        total(kHeldShared + k, i) += dt * after(i, k);
      }
    }
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) total(kHeldShared + i, kHeldShared + k) += Q(i, k);
    const Factor factor(total);
    if (!factor.finite()) return;
    typename Star::Cross place = Star::Cross::Zero();
    for (int i = 0; i < 4; ++i)
      for (int k = 0; k < 4; ++k) place(kHeldShared + i, k) = noise(i, k);
    const typename Star::Cross shown = factor.solve(place);  // E[n | x'] = shown^T (x' - E[x'])
    Matrix4<Scalar> left = noise, turned = Matrix4<Scalar>::Identity();
    for (int i = 0; i < 4; ++i) {
      for (int k = 0; k < 4; ++k) {
        for (int l = 0; l < 4; ++l) left(i, k) -= noise(i, l) * shown(kHeldShared + l, k);
        turned(i, k) += dt * G(kHeldShared + i, k);
      }
    }
    const Matrix4<Scalar> back = turned.inverse();
    SharedVector<Scalar> moved = star.mean();
    for (int i = 0; i < 4; ++i) moved[kHeldShared + i] += dt * mean[i];
    for (int j = 0; j < Dofs; ++j) {
      auto& joint = star.joint(j);
      const Beta marginal = star.nuisance_mean(j);
      Eigen::Matrix<Scalar, 4, kJointNuisances> part;
      for (int i = 0; i < 4; ++i)
        for (int n = 0; n < kJointNuisances; ++n) part(i, n) = joint.slope(kHeldShared + i, n);
      part = detail::product(back, part);
      detail::add_scaled(joint.slope, -dt, Slope(detail::product(G, part)));
      for (int i = 0; i < 4; ++i)
        for (int n = 0; n < kJointNuisances; ++n) part(i, n) = joint.slope(kHeldShared + i, n);
      detail::add_scaled(joint.slope, Scalar(-1), Slope(detail::product(shown, part)));
      const Eigen::Matrix<Scalar, 4, kJointNuisances> spread = detail::product(left, part);
      joint.covariance += detail::transposed_product(part, spread);
      joint.mean = marginal;
      detail::add_scaled(joint.mean, Scalar(-1), Beta(detail::transposed_product(joint.slope, moved)));
    }
    star.set_shared(moved, factor.lower());
    cross = after;
  }
};

}  // namespace rme
