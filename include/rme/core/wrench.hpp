#pragma once
/// Forces and velocities of the end effector. Two types, so that a twist cannot be passed for a wrench.
#include <rme/core/types.hpp>

namespace rme {

namespace detail {

/// (a, b), 6x1.
template <typename Scalar>
Vector6<Scalar> stacked(const Vector3<Scalar>& a, const Vector3<Scalar>& b) noexcept {
  Vector6<Scalar> out;
  for (int i = 0; i < 3; ++i) {
    out[i] = a[i];
    out[3 + i] = b[i];
  }
  return out;
}

}  // namespace detail

/// Force and moment on the end effector: world axes, moment about the end-effector origin.
template <typename Scalar>
struct Wrench {
  Vector3<Scalar> force = Vector3<Scalar>::Zero();   ///< [N]
  Vector3<Scalar> moment = Vector3<Scalar>::Zero();  ///< [N m]

  /// (force, moment), 6x1: the order of the Jacobian's rows, so that tau = J^T w.vector().
  Vector6<Scalar> vector() const noexcept { return detail::stacked(force, moment); }
  /// The wrench of (force, moment), as vector() has it.
  static Wrench from_vector(const Vector6<Scalar>& w) noexcept { return {{w[0], w[1], w[2]}, {w[3], w[4], w[5]}}; }
};

/// Velocity of the end effector: world axes, at the end-effector origin.
template <typename Scalar>
struct Twist {
  Vector3<Scalar> linear = Vector3<Scalar>::Zero();   ///< [m/s]
  Vector3<Scalar> angular = Vector3<Scalar>::Zero();  ///< [rad/s]

  /// (linear, angular), 6x1: the order of the Jacobian's rows, so that J dq = twist.vector().
  Vector6<Scalar> vector() const noexcept { return detail::stacked(linear, angular); }
  /// The twist of (linear, angular), as vector() has it.
  static Twist from_vector(const Vector6<Scalar>& v) noexcept { return {{v[0], v[1], v[2]}, {v[3], v[4], v[5]}}; }
};

}  // namespace rme
