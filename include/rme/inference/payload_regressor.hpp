#pragma once
/// The payload model as a regression: the joint torque of a payload is m (a + B r).
#include <rme/core/flange_motion.hpp>
#include <rme/core/payload.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// a and B of one sample: a payload (m, r) exerts the joint torque tau = m (a + B r).
template <typename Scalar, int Dofs>
struct PayloadRegressor {
  JointVector<Scalar, Dofs> a = JointVector<Scalar, Dofs>::Zero();            ///< Dofs x 1 [N m / kg]
  Eigen::Matrix<Scalar, Dofs, 3> B = Eigen::Matrix<Scalar, Dofs, 3>::Zero();  ///< Dofs x 3 [N / kg]

  JointVector<Scalar, Dofs> torque(const Payload<Scalar>& payload) const noexcept {
    return payload.mass * (a + B * payload.com);
  }
};

/// Regressor of a payload at rest: a = J_v^T g, B = -J_w^T [g]x R (docs/theory.md, "The model is bilinear").
/// @param jacobian  6 x Dofs, world axes, linear rows first
/// @param rotation  R, end-effector axes to world axes
/// @param gravity   g [m/s^2], world axes
template <typename Scalar, int Dofs>
PayloadRegressor<Scalar, Dofs> payload_regressor(const Jacobian<Scalar, Dofs>& jacobian,
                                                 const Matrix3<Scalar>& rotation,
                                                 const Vector3<Scalar>& gravity) noexcept {
  const Matrix3<Scalar> moment = -skew(gravity) * rotation;
  return {jacobian.template topRows<3>().transpose() * gravity, jacobian.template bottomRows<3>().transpose() * moment};
}

/// Regressor of a payload that is carried along, inertia force included:
///
///     f = m (g - a_o - W R r),   n = (R r) x f,   W = [alpha]x + [omega]x^2
///
/// with a_o the origin's acceleration. n is quadratic in r through the point mass's own inertia, (R r) x (W R r).
/// Written as (R r0) x (W R r) with a fixed r0 near r it is linear again, and exact at r = r0: take r0 from the prior
/// or from the last estimate. A body's inertia about its own centre adds k^2 alpha per kilogram for a radius of
/// gyration k. docs/theory.md, "Motion".
/// @param com_guess        r0 [m], end-effector axes
/// @param gyration_radius  k [m], of the payload about its centre of mass, taken as the same about every axis
template <typename Scalar, int Dofs>
PayloadRegressor<Scalar, Dofs> payload_regressor(const Jacobian<Scalar, Dofs>& jacobian,
                                                 const Matrix3<Scalar>& rotation, const Vector3<Scalar>& gravity,
                                                 const FlangeMotion<Scalar>& motion, const Vector3<Scalar>& com_guess,
                                                 Scalar gyration_radius) noexcept {
  const Vector3<Scalar> specific_force = gravity - motion.linear_acceleration;
  const Matrix3<Scalar> omega_cross = skew(motion.angular_velocity);
  const Matrix3<Scalar> W_R = (skew(motion.angular_acceleration) + omega_cross * omega_cross) * rotation;
  const Vector3<Scalar> lever = rotation * com_guess;
  const Matrix3<Scalar> moment = -skew(specific_force) * rotation - skew(lever) * W_R;
  const auto J_v = jacobian.template topRows<3>();
  const auto J_w = jacobian.template bottomRows<3>();
  PayloadRegressor<Scalar, Dofs> regressor;
  regressor.a.noalias() = J_v.transpose() * specific_force;
  regressor.a.noalias() -= J_w.transpose() * (gyration_radius * gyration_radius * motion.angular_acceleration);
  regressor.B.noalias() = J_w.transpose() * moment;
  regressor.B.noalias() -= J_v.transpose() * W_R;
  return regressor;
}

}  // namespace rme
