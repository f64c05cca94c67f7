#pragma once
/// The payload model as a regression: a payload (m, r) exerts the joint torque m (a + B r + Q p(r)), where p(r) are the
/// six products of two entries of r.
#include <rme/core/flange_motion.hpp>
#include <rme/core/payload.hpp>
#include <rme/core/types.hpp>

namespace rme {
namespace detail {

/// p(r) [m^2]: the products (x x, x y, x z, y y, y z, z z) of the entries of a centre of mass r = (x, y, z) [m].
template <typename Scalar>
Vector6<Scalar> com_products(const Vector3<Scalar>& r) noexcept {
  Vector6<Scalar> out;
  out << r[0] * r[0], r[0] * r[1], r[0] * r[2], r[1] * r[1], r[1] * r[2], r[2] * r[2];
  return out;
}

}  // namespace detail

/// a, B and Q of one sample: a payload (m, r) exerts the joint torque tau = m (a + B r + Q p(r)). At rest Q = 0, and the
/// model is bilinear.
template <typename Scalar, int Dofs>
struct PayloadRegressor {
  JointVector<Scalar, Dofs> a = JointVector<Scalar, Dofs>::Zero();            ///< Dofs x 1 [N m / kg]
  Eigen::Matrix<Scalar, Dofs, 3> B = Eigen::Matrix<Scalar, Dofs, 3>::Zero();  ///< Dofs x 3 [N / kg]
  Eigen::Matrix<Scalar, Dofs, 6> Q = Eigen::Matrix<Scalar, Dofs, 6>::Zero();  ///< Dofs x 6 [N / (kg m)]

  /// tau = m (a + B r + Q p(r)) [N m] (docs/theory.md (T5)).
  JointVector<Scalar, Dofs> torque(const Payload<Scalar>& payload) const noexcept {
    return payload.mass * (a + B * payload.com + Q * detail::com_products(payload.com));
  }
};

/// Regressor of a payload at rest: a = J_v^T g, B = -J_w^T [g]x R (docs/theory.md (T2)).
/// @param jacobian  6 x Dofs, world axes, linear rows first
/// @param rotation  R, end-effector axes to world axes
/// @param gravity   g [m/s^2], world axes
template <typename Scalar, int Dofs>
PayloadRegressor<Scalar, Dofs> payload_regressor(const Jacobian<Scalar, Dofs>& jacobian,
                                                 const Matrix3<Scalar>& rotation,
                                                 const Vector3<Scalar>& gravity) noexcept {
  const Matrix3<Scalar> moment = -skew(gravity) * rotation;
  return {jacobian.template topRows<3>().transpose() * gravity, jacobian.template bottomRows<3>().transpose() * moment,
          Eigen::Matrix<Scalar, Dofs, 6>::Zero()};
}

/// Regressor of a payload that is carried along, inertia force included:
///
///     f = m (g - a_o - W R r),   n = (R r) x f - m k^2 alpha,   W = [alpha]x + [omega]x^2
///
/// with the origin's acceleration a_o and the payload's radius of gyration k (docs/theory.md (T4, T5)). n contains the
/// inertia of the point mass, -m (R r) x (W R r), which is quadratic in r: it gives the six columns of Q.
/// @param jacobian         6 x Dofs, world axes, linear rows first
/// @param rotation         R, end-effector axes to world axes
/// @param gravity          g [m/s^2], world axes
/// @param motion           omega, alpha and a_o of the flange, world axes
/// @param gyration_radius  k [m], of the payload about its centre of mass, taken as the same about every axis
template <typename Scalar, int Dofs>
PayloadRegressor<Scalar, Dofs> payload_regressor(const Jacobian<Scalar, Dofs>& jacobian,
                                                 const Matrix3<Scalar>& rotation, const Vector3<Scalar>& gravity,
                                                 const FlangeMotion<Scalar>& motion, Scalar gyration_radius) noexcept {
  const Vector3<Scalar> specific_force = gravity - motion.linear_acceleration;
  const Matrix3<Scalar> omega_cross = skew(motion.angular_velocity);
  const Matrix3<Scalar> W_R = (skew(motion.angular_acceleration) + omega_cross * omega_cross) * rotation;
  const Matrix3<Scalar> S = rotation.transpose() * W_R;
  Eigen::Matrix<Scalar, 3, 6> own;  // r x S r by the products of r, end-effector axes
  // clang-format off
  own << Scalar(0),  S(2, 0),            -S(1, 0),            S(2, 1),   S(2, 2) - S(1, 1), -S(1, 2),
         -S(2, 0),   -S(2, 1),           S(0, 0) - S(2, 2),   Scalar(0), S(0, 1),           S(0, 2),
         S(1, 0),    S(1, 1) - S(0, 0),  S(1, 2),             -S(0, 1),  -S(0, 2),          Scalar(0);
  // clang-format on
  const auto J_v = jacobian.template topRows<3>();
  const auto J_w = jacobian.template bottomRows<3>();
  PayloadRegressor<Scalar, Dofs> regressor;
  regressor.a.noalias() = J_v.transpose() * specific_force;
  regressor.a.noalias() -= J_w.transpose() * (gyration_radius * gyration_radius * motion.angular_acceleration);
  regressor.B.noalias() = J_w.transpose() * Matrix3<Scalar>(-skew(specific_force) * rotation);
  regressor.B.noalias() -= J_v.transpose() * W_R;
  regressor.Q.noalias() = J_w.transpose() * Eigen::Matrix<Scalar, 3, 6>(-rotation * own);
  return regressor;
}

}  // namespace rme
