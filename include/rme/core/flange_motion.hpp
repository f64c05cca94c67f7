#pragma once
/// Motion of the end effector, for the inertia force of a payload.
#include <rme/core/types.hpp>

namespace rme {

/// How the end effector moves; all zero for an arm at rest. World axes, at the end-effector origin.
template <typename Scalar>
struct FlangeMotion {
  Vector3<Scalar> angular_velocity = Vector3<Scalar>::Zero();      ///< omega [rad/s]
  Vector3<Scalar> linear_acceleration = Vector3<Scalar>::Zero();   ///< [m/s^2], of the origin, gravity not included
  Vector3<Scalar> angular_acceleration = Vector3<Scalar>::Zero();  ///< alpha [rad/s^2]
};

}  // namespace rme
