#pragma once
/// Forces and velocities of the end effector. Two types, so that a twist cannot be passed for a wrench.
#include <rme/core/types.hpp>

namespace rme {

/// Force and moment on the end effector: world axes, moment about the end-effector origin.
template <typename Scalar>
struct Wrench {
  Vector3<Scalar> force = Vector3<Scalar>::Zero();   ///< [N]
  Vector3<Scalar> moment = Vector3<Scalar>::Zero();  ///< [N m]

  /// (force, moment), 6x1: the order of the Jacobian's rows, so that tau = J^T w.vector().
  Vector6<Scalar> vector() const noexcept { return (Vector6<Scalar>() << force, moment).finished(); }
  static Wrench from_vector(const Vector6<Scalar>& w) noexcept { return {w.template head<3>(), w.template tail<3>()}; }
};

/// Velocity of the end effector: world axes, at the end-effector origin.
template <typename Scalar>
struct Twist {
  Vector3<Scalar> linear = Vector3<Scalar>::Zero();   ///< [m/s]
  Vector3<Scalar> angular = Vector3<Scalar>::Zero();  ///< [rad/s]

  /// (linear, angular), 6x1: the order of the Jacobian's rows, so that J dq = twist.vector().
  Vector6<Scalar> vector() const noexcept { return (Vector6<Scalar>() << linear, angular).finished(); }
  static Twist from_vector(const Vector6<Scalar>& v) noexcept { return {v.template head<3>(), v.template tail<3>()}; }
};

}  // namespace rme
