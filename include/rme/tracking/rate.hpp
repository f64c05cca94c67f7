#pragma once
/// How quickly a part of a filter's shared unknowns changes.
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/star_gaussian.hpp>

namespace rme {

/// A Gaussian over the rate r of the last four entries of a star's x, correlated with x. Each beta_j depends on r only
/// through x. Real time: nothing allocates.
template <typename Scalar, int Dofs>
struct Rate {
  using Star = StarGaussian<Scalar, Dofs>;  ///< state of the filter

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
  /// The last four entries of x move by dt r; then process noise Q is added to them. Each beta_j keeps its moments with
  /// the old x (docs/theory.md, "The star").
  /// @param star  state; if Q is not finite, nothing changes
  /// @param dt    [s]
  /// @param Q     covariance of the noise, positive semidefinite
  void drift(Star& star, Scalar dt, const Matrix4<Scalar>& Q) noexcept {
    // x changes by d = dt r + noise.
    const Vector4<Scalar> moves_mean = detail::scaled(dt, mean);
    Matrix4<Scalar> moves = Q;
    detail::add_scaled(moves, dt * dt, covariance);
    if (!star.template add<kHeldShared>(moves_mean, moves, typename Star::Cross(detail::scaled(dt, cross)))) return;
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 4; ++i) cross(kHeldShared + i, k) += dt * covariance(i, k);
  }
};

}  // namespace rme
