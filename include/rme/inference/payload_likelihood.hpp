#pragma once
/// The likelihood of a payload, for a window of any length: 15 numbers.
#include <cmath>
#include <rme/core/types.hpp>

namespace rme {

/// Log-likelihood of theta = (m, r), up to a constant (docs/theory.md (T3)):
///
///     L(theta) = -1/2 [ yy - 2 m (ya + yB . r) + m^2 (aa + 2 aB . r + r^T BB r) ]
///
/// Each number is a precision-weighted sum over samples and joints, e.g. aB = sum_t B_t^T W a_t, where W is the inverse
/// covariance of the torque's noise. PayloadStatistics computes the sums.
template <typename Scalar>
struct PayloadLikelihood {
  Scalar yy = Scalar(0);                         ///< sum of y^T W y, without unit
  Scalar ya = Scalar(0);                         ///< sum of y^T W a [1/kg]
  Scalar aa = Scalar(0);                         ///< sum of a^T W a [1/kg^2]
  Vector3<Scalar> yB = Vector3<Scalar>::Zero();  ///< sum of B^T W y [1/(kg m)]
  Vector3<Scalar> aB = Vector3<Scalar>::Zero();  ///< sum of B^T W a [1/(kg^2 m)]
  Matrix3<Scalar> BB = Matrix3<Scalar>::Zero();  ///< sum of B^T W B [1/(kg m)^2]

  /// The likelihood with these sums.
  /// @param products  precision-weighted products of (y, a, B_x, B_y, B_z), 5x5, symmetric
  static PayloadLikelihood from_products(const Eigen::Matrix<Scalar, 5, 5>& products) noexcept {
    PayloadLikelihood l;
    l.yy = products(0, 0);
    l.ya = products(0, 1);
    l.aa = products(1, 1);
    l.yB = products.template block<3, 1>(2, 0);
    l.aB = products.template block<3, 1>(2, 1);
    l.BB = products.template block<3, 3>(2, 2);
    return l;
  }

  /// L(theta) [nats].
  Scalar log_likelihood(const Vector4<Scalar>& theta) const noexcept {
    const Scalar m = theta[0];
    const Vector3<Scalar> r = theta.template tail<3>();
    return Scalar(-0.5) * (yy - 2 * m * (ya + yB.dot(r)) + m * m * (aa + 2 * aB.dot(r) + r.dot(BB * r)));
  }

  /// L(theta) - L(m = 0) [nats]: how much better a payload explains the window than an empty hand does. The term yy
  /// cancels. It is so large that the others would be lost to rounding.
  /// @param theta          (m [kg], r [m]), 4x1
  /// @param[out] gradient  with respect to theta, 4x1
  Scalar log_likelihood_ratio(const Vector4<Scalar>& theta, Vector4<Scalar>& gradient) const noexcept {
    const Scalar m = theta[0];
    const Vector3<Scalar> r = theta.template tail<3>(), aB_BBr = aB + BB * r;
    const Scalar yt = ya + yB.dot(r), tt = aa + (aB + aB_BBr).dot(r);  // with t = a + B r
    gradient << yt - m * tt, m * yB - m * m * aB_BBr;
    return m * yt - Scalar(0.5) * m * m * tt;
  }

  /// Whether no sum is NaN or infinite.
  bool all_finite() const noexcept {
    return std::isfinite(yy) && std::isfinite(ya) && std::isfinite(aa) && yB.allFinite() && aB.allFinite() &&
           BB.allFinite();
  }
};

}  // namespace rme
