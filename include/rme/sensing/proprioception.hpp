#pragma once
/// What a host hands in each tick, and the check that it makes sense.
#include <cmath>
#include <optional>
#include <rme/core/flange_motion.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// One tick of what a torque-controlled arm reports anyway.
template <typename Scalar, int Dofs>
struct Proprioception {
  JointVector<Scalar, Dofs> tau_ext = JointVector<Scalar, Dofs>::Zero();  ///< external joint torque [N m]
  Jacobian<Scalar, Dofs> jacobian = Jacobian<Scalar, Dofs>::Zero();       ///< J, 6 x Dofs
  Matrix3<Scalar> rotation = Matrix3<Scalar>::Identity();                 ///< R, end-effector axes to world axes
  /// Joint velocity [rad/s]. Left at zero, the arm is taken to be at rest: no inertia force, no friction.
  JointVector<Scalar, Dofs> dq = JointVector<Scalar, Dofs>::Zero();
  /// How the flange has moved over the period that ends now, from a host that knows better than the differences of
  /// J dq, which are taken otherwise.
  std::optional<FlangeMotion<Scalar>> motion = std::nullopt;
  /// Time since the sample before [s], where the host measures it: samples that got lost are time that passed. 0 is the
  /// nominal period.
  double period = 0;
};

/// @return Ok; NonFiniteInput, also for numbers beyond kLargestPlausible; NotARotation if R^T R is further than 1e-3
/// from the identity or R is a mirror
template <typename Scalar, int Dofs>
Status check(const Proprioception<Scalar, Dofs>& sample) noexcept {
  if (!plausible(sample.tau_ext) || !plausible(sample.jacobian) || !sample.rotation.allFinite() ||
      !plausible(sample.dq))
    return Status::NonFiniteInput;
  if (sample.motion && !(plausible(sample.motion->angular_velocity) && plausible(sample.motion->linear_acceleration) &&
                         plausible(sample.motion->angular_acceleration)))
    return Status::NonFiniteInput;
  if (!(sample.period >= 0 && sample.period <= kLargestPlausible)) return Status::NonFiniteInput;
  const Matrix3<Scalar>& R = sample.rotation;
  const Scalar error = (R.transpose() * R - Matrix3<Scalar>::Identity()).cwiseAbs().maxCoeff();
  if (!(error < Scalar(1e-3)) || !(R.col(0).cross(R.col(1)).dot(R.col(2)) > 0)) return Status::NotARotation;
  return Status::Ok;
}

}  // namespace rme
