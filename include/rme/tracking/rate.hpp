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
  /// @tparam Before  number of entries before them that get noise of their own
  /// @param star  state; if Q is not finite, nothing changes
  /// @param dt    [s]
  /// @param Q     covariance of the noise, positive semidefinite
  /// @param own   variance of the noise of each of the entries before, >= 0
  template <int Before = 0>
  void drift(Star& star, Scalar dt, const Matrix4<Scalar>& Q, Scalar own = Scalar(0)) noexcept {
    // x changes by d = (noise, dt r + noise).
    Eigen::Matrix<Scalar, Before + 4, 1> mean_move = Eigen::Matrix<Scalar, Before + 4, 1>::Zero();
    Eigen::Matrix<Scalar, Before + 4, Before + 4> moves = Eigen::Matrix<Scalar, Before + 4, Before + 4>::Zero();
    Eigen::Matrix<Scalar, kShared, Before + 4> with_x = Eigen::Matrix<Scalar, kShared, Before + 4>::Zero();
    for (int i = 0; i < Before; ++i) moves(i, i) = own;
    for (int k = 0; k < 4; ++k) {
      mean_move[Before + k] = dt * mean[k];
      for (int i = 0; i < 4; ++i) moves(Before + i, Before + k) = Q(i, k) + dt * dt * covariance(i, k);
      for (int i = 0; i < kShared; ++i) with_x(i, Before + k) = dt * cross(i, k);
    }
    if (!star.template add<kHeldShared - Before>(mean_move, moves, with_x)) return;
    for (int k = 0; k < 4; ++k)
      for (int i = 0; i < 4; ++i) cross(kHeldShared + i, k) += dt * covariance(i, k);
  }
};

}  // namespace rme
