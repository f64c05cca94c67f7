#pragma once
/// A Gaussian over a payload's mass and centre of mass: a prior or a posterior.
#include <Eigen/Cholesky>
#include <rme/core/payload.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// N(mean, covariance) over theta = (m, r_x, r_y, r_z), in [kg, m, m, m], end-effector axes.
template <typename Scalar>
struct PayloadGaussian {
  Vector4<Scalar> mean = Vector4<Scalar>::Zero();            ///< [kg, m, m, m]
  Matrix4<Scalar> covariance = Matrix4<Scalar>::Identity();  ///< 4x4, positive semidefinite, units of the mean

  /// The mean as mass and centre of mass.
  Payload<Scalar> payload() const noexcept { return Payload<Scalar>::from_vector(mean); }
  /// Marginal standard deviations, 4x1.
  Vector4<Scalar> standard_deviation() const noexcept { return covariance.diagonal().cwiseSqrt(); }

  /// The Gaussian with independent entries.
  /// @param mean                4x1 [kg, m, m, m]
  /// @param standard_deviation  4x1 [kg, m, m, m], each > 0
  static PayloadGaussian independent(const Vector4<Scalar>& mean, const Vector4<Scalar>& standard_deviation) noexcept {
    return {mean, standard_deviation.cwiseAbs2().asDiagonal()};
  }
};

}  // namespace rme
