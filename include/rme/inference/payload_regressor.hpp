#pragma once
/// The payload model as a regression: a payload (m, r) at rest exerts the joint torque m (a + B r).
#include <rme/core/payload.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// a and B of one sample.
template <typename Scalar, int Dofs>
struct PayloadRegressor {
  JointVector<Scalar, Dofs> a = JointVector<Scalar, Dofs>::Zero();            ///< Dofs x 1 [N m / kg]
  Eigen::Matrix<Scalar, Dofs, 3> B = Eigen::Matrix<Scalar, Dofs, 3>::Zero();  ///< Dofs x 3 [N / kg]

  /// tau = m (a + B r) [N m] (docs/theory.md (T2)).
  JointVector<Scalar, Dofs> torque(const Payload<Scalar>& payload) const noexcept {
    return payload.mass * (a + B * payload.com);
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
  return {jacobian.template topRows<3>().transpose() * gravity, jacobian.template bottomRows<3>().transpose() * moment};
}

}  // namespace rme
