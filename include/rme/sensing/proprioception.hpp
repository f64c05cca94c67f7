#pragma once
/// The input of each tick, and the check that it is plausible.
#include <cmath>
#include <optional>
#include <rme/core/flange_motion.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// What a torque-controlled arm reports in one tick.
template <typename Scalar, int Dofs>
struct Proprioception {
  /// External joint torque [N m]: what the environment exerts on the arm, or its reaction (TorqueSign).
  JointVector<Scalar, Dofs> tau_ext = JointVector<Scalar, Dofs>::Zero();
  /// J, 6 x Dofs: world axes, linear rows first, at the end-effector origin.
  Jacobian<Scalar, Dofs> jacobian = Jacobian<Scalar, Dofs>::Zero();
  Matrix3<Scalar> rotation = Matrix3<Scalar>::Identity();  ///< R, end-effector axes to world axes
  /// Joint velocity [rad/s]. Zero means an arm at rest: no inertia force, no friction of motion.
  JointVector<Scalar, Dofs> dq = JointVector<Scalar, Dofs>::Zero();
  /// Motion of the flange over the period that ends now. Set it if the host knows it better than from differences of
  /// J dq, which are used otherwise.
  std::optional<FlangeMotion<Scalar>> motion = std::nullopt;
  /// Time since the last sample [s], >= 0, if the host measures it: lost samples then count as time that passed. 0
  /// means the nominal period.
  double period = 0;
  /// Torque that the host really adds to its command for the payload [N m], Dofs x 1, mean over the period that ends
  /// now. Absent means: what compensation() returned, as it is.
  std::optional<JointVector<Scalar, Dofs>> compensation = std::nullopt;
  /// G, the arm's own gravity torque per unit of gravity along each world axis [N m / (m/s^2)], Dofs x 3, payload not
  /// included: in M ddq + C dq + g(q) = tau + tau_ext, g(q) is G g for gravity g (0, 0, -9.81 on a floor). Column i is
  /// what a function of the model that computes g(q) returns for gravity along axis i of size 1. If the base is tilted,
  /// so that the true gravity is g + d, tau_ext contains -G d.
  std::optional<Eigen::Matrix<Scalar, Dofs, 3>> gravity_torque = std::nullopt;
};

namespace detail {

/// Whether R^T R is within 1e-3 of the identity and det R > 0.
template <typename Scalar>
bool is_rotation(const Matrix3<Scalar>& R) noexcept {
  using std::abs;
  const Matrix3<Scalar> square = detail::transposed_product(R, R);
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j <= i; ++j)
      if (!(abs(square(i, j) - Scalar(i == j ? 1 : 0)) < Scalar(1e-3))) return false;
  Scalar determinant = Scalar(0);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    determinant += R(i, 0) * (R(j, 1) * R(k, 2) - R(k, 1) * R(j, 2));
  }
  return determinant > 0;
}

}  // namespace detail

/// Whether a sample can be used.
/// @return Ok; NonFiniteInput, also for numbers beyond kLargestPlausible and for a period below 0; NotARotation, if an
///         entry of R^T R is 1e-3 or more away from the identity, or det R is not above 0
template <typename Scalar, int Dofs>
Status check_sample(const Proprioception<Scalar, Dofs>& sample) noexcept {
  if (!plausible(sample.tau_ext) || !plausible(sample.jacobian) || !detail::finite(sample.rotation) ||
      !plausible(sample.dq))
    return Status::NonFiniteInput;
  if (sample.motion && !(plausible(sample.motion->angular_velocity) && plausible(sample.motion->linear_acceleration) &&
                         plausible(sample.motion->angular_acceleration)))
    return Status::NonFiniteInput;
  if (sample.compensation && !plausible(*sample.compensation)) return Status::NonFiniteInput;
  if (sample.gravity_torque && !plausible(*sample.gravity_torque)) return Status::NonFiniteInput;
  if (!(sample.period >= 0 && sample.period <= kLargestPlausible)) return Status::NonFiniteInput;
  return detail::is_rotation(sample.rotation) ? Status::Ok : Status::NotARotation;
}

}  // namespace rme
