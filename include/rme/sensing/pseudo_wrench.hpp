#pragma once
/// The wrench at the end effector that fits the external joint torque best.
#include <rme/core/cholesky.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/core/wrench.hpp>

namespace rme {

/// Damped pseudo-wrench W = (J J^T + lambda I)^-1 J tau_ext, in world axes (docs/theory.md (T36); paper, Section 4.1).
/// The damping keeps it bounded near a singularity; a Jacobian of zeros gives zero.
/// @param jacobian     J, 6 x Dofs, world axes, linear rows first: a matrix, a map, a block
/// @param tau_ext      external joint torque [N m], Dofs x 1, likewise
/// @param damping      lambda [m^2], > 0, the same for the angular rows; the paper's value is 1e-2
/// @param[out] wrench  world axes; as it was unless the status is Ok
/// @return Ok; NonFiniteInput; NotPositiveDefinite (the damping is not > 0, or is lost to rounding beside J J^T)
template <typename Scalar, typename Columns, typename Torque>
Status pseudo_wrench(const Eigen::MatrixBase<Columns>& jacobian, const Eigen::MatrixBase<Torque>& tau_ext,
                     Scalar damping, Wrench<Scalar>& wrench) noexcept {
  constexpr int kDofs = Columns::ColsAtCompileTime;
  static_assert(Columns::RowsAtCompileTime == 6 && kDofs != Eigen::Dynamic && Torque::SizeAtCompileTime == kDofs,
                "pseudo_wrench: a Jacobian of 6 rows and as many columns as there are torques, known when compiled");
  Matrix6<Scalar> A;
  A.noalias() = jacobian * jacobian.transpose();
  A.diagonal().array() += damping;
  const Vector6<Scalar> b = jacobian * tau_ext;
  if (!A.allFinite() || !b.allFinite()) return Status::NonFiniteInput;
  const Cholesky<Scalar, 6> factor(A);
  if (!(damping > 0) || !factor.positive_definite()) return Status::NotPositiveDefinite;
  const Vector6<Scalar> w = factor.solve(b);
  if (!w.allFinite()) return Status::NonFiniteInput;
  wrench = Wrench<Scalar>::from_vector(w);
  return Status::Ok;
}

/// The same wrench in end-effector axes, diag(R^T, R^T) W. The force of a payload at rest shows the direction of
/// gravity in these axes.
/// @param wrench    world axes
/// @param rotation  R, 3x3, end-effector axes to world axes
template <typename Scalar, typename Rotation>
Wrench<Scalar> in_end_effector_axes(const Wrench<Scalar>& wrench,
                                    const Eigen::MatrixBase<Rotation>& rotation) noexcept {
  EIGEN_STATIC_ASSERT_MATRIX_SPECIFIC_SIZE(Rotation, 3, 3);
  return {rotation.transpose() * wrench.force, rotation.transpose() * wrench.moment};
}

}  // namespace rme
