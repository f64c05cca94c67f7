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
  using Cross = typename Star::Cross;       ///< covariance of x and the rate

  Vector4<Scalar> mean = Vector4<Scalar>::Zero();        ///< [of x / s]
  Matrix4<Scalar> covariance = Matrix4<Scalar>::Zero();  ///< of the rate
  Cross cross = Cross::Zero();                           ///< cov(x, rate)

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
    move(star, dt, Q, Matrix4<Scalar>::Zero(), Cross::Zero());
  }
  /// The same if they also move by A^T (x - E[x]), as what is not known of x does.
  void drift(Star& star, Scalar dt, const Matrix4<Scalar>& Q, const Cross& A) noexcept {
    const Cross spread = detail::transposed_product(star.factor(), A);
    Matrix4<Scalar> noise = Q;
    noise += detail::transposed_product(spread, spread);
    move(star, dt, noise, detail::transposed_product(A, cross), detail::product(star.factor(), spread));
  }

 private:
  /// @param noise    covariance of what x moves by beside dt r
  /// @param follows  cov(that, r)
  /// @param with     cov(x, that)
  void move(Star& star, Scalar dt, const Matrix4<Scalar>& noise, const Matrix4<Scalar>& follows,
            const Cross& with) noexcept {
    Matrix4<Scalar> moves = noise;
    detail::add_scaled(moves, dt * dt, covariance);
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 4; ++i) moves(i, k) += dt * (follows(i, k) + follows(k, i));
    Cross shown = with;
    detail::add_scaled(shown, dt, cross);
    if (!star.template add<kHeldShared>(Vector4<Scalar>(detail::scaled(dt, mean)), moves, shown)) return;
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 4; ++i) cross(kHeldShared + i, k) += dt * covariance(i, k) + follows(i, k);
  }
};

}  // namespace rme
