#pragma once
/// A payload's mass and centre of mass, and the wrench that it exerts.
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/core/wrench.hpp>

namespace rme {

/// A payload fixed to the end effector; all zero means an empty hand.
template <typename Scalar>
struct Payload {
  Scalar mass = Scalar(0);                        ///< m [kg]
  Vector3<Scalar> com = Vector3<Scalar>::Zero();  ///< r [m], end-effector axes, from the end-effector origin

  /// theta = (m, r_x, r_y, r_z), 4x1: the order of every mean, covariance and network output.
  Vector4<Scalar> vector() const noexcept { return {mass, com[0], com[1], com[2]}; }
  /// The payload of theta, as vector() has it.
  static Payload from_vector(const Vector4<Scalar>& theta) noexcept {
    return {theta[0], {theta[1], theta[2], theta[3]}};
  }
};

/// Wrench of a payload at rest on the end effector, w = [ m g ; (R r) x (m g) ] (docs/theory.md (T1)).
/// @param payload   mass [kg] and centre of mass [m]
/// @param rotation  R, 3x3, end-effector axes to world axes: a matrix, a map, a block
/// @param gravity   g [m/s^2], world axes
template <typename Scalar, typename Rotation>
Wrench<Scalar> payload_wrench(const Payload<Scalar>& payload, const Eigen::MatrixBase<Rotation>& rotation,
                              const Vector3<Scalar>& gravity = standard_gravity<Scalar>()) noexcept {
  EIGEN_STATIC_ASSERT_MATRIX_SPECIFIC_SIZE(Rotation, 3, 3);
  const Vector3<Scalar> weight = detail::scaled(payload.mass, gravity);
  const Vector3<Scalar> lever = rotation.lazyProduct(payload.com);
  return {weight, lever.cross(weight)};
}

}  // namespace rme
