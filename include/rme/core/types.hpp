#pragma once
/// Fixed-size Eigen types by scalar and number of joints.
#include <Eigen/Core>
#include <Eigen/Geometry>  // cross(): without it, code that uses it compiles and does not link

namespace rme {

template <typename Scalar>
using Vector3 = Eigen::Matrix<Scalar, 3, 1>;  ///< 3x1
template <typename Scalar>
using Vector4 = Eigen::Matrix<Scalar, 4, 1>;  ///< 4x1
template <typename Scalar>
using Vector6 = Eigen::Matrix<Scalar, 6, 1>;  ///< 6x1: of a wrench or a twist, linear part first
template <typename Scalar>
using Matrix3 = Eigen::Matrix<Scalar, 3, 3>;  ///< 3x3
template <typename Scalar>
using Matrix4 = Eigen::Matrix<Scalar, 4, 4>;  ///< 4x4
template <typename Scalar>
using Matrix6 = Eigen::Matrix<Scalar, 6, 6>;  ///< 6x6

/// Joint-space vector: q [rad], dq [rad/s], tau [N m].
template <typename Scalar, int Dofs>
using JointVector = Eigen::Matrix<Scalar, Dofs, 1>;
/// Joint-space matrix: mass matrix M [kg m^2].
template <typename Scalar, int Dofs>
using JointMatrix = Eigen::Matrix<Scalar, Dofs, Dofs>;
/// Geometric Jacobian at the end-effector origin, world axes: rows linear, then angular; twist = J dq, tau = J^T w.
template <typename Scalar, int Dofs>
using Jacobian = Eigen::Matrix<Scalar, 6, Dofs>;

/// Gravity in world axes [m/s^2] for an arm that stands on the floor, with z up.
template <typename Scalar>
Vector3<Scalar> standard_gravity() noexcept {
  return Vector3<Scalar>(Scalar(0), Scalar(0), Scalar(-9.81));
}

/// The matrix [v]x with [v]x u = v x u.
template <typename Derived>
Matrix3<typename Derived::Scalar> skew(const Eigen::MatrixBase<Derived>& v) noexcept {
  EIGEN_STATIC_ASSERT_VECTOR_SPECIFIC_SIZE(Derived, 3);
  using Scalar = typename Derived::Scalar;
  Matrix3<Scalar> m;
  m << Scalar(0), -v[2], v[1], v[2], Scalar(0), -v[0], -v[1], v[0], Scalar(0);
  return m;
}

}  // namespace rme
