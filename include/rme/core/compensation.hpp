#pragma once
/// Torque that carries the estimated payload, and the ramp that limits its rate (Appendix B of the paper).
#include <rme/core/payload.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// tau_comp = -J^T w(theta_hat) [N m]: holds the payload against gravity. The host adds it to the nominal controller's
/// torque last, after CPIC; the nominal model is never corrected (docs/theory_control.md (C19)).
/// @param payload   theta_hat, the estimate
/// @param jacobian  J, 6xDofs: a matrix, a map or a block
/// @param rotation  R, 3x3, end-effector axes to world axes: a matrix, a map or a block
/// @param gravity   g [m/s^2], world axes
/// @return one torque per column of J, Dofs x 1
template <typename Scalar, typename Columns, typename Rotation>
JointVector<Scalar, Columns::ColsAtCompileTime> compensation_torque(
    const Payload<Scalar>& payload, const Eigen::MatrixBase<Columns>& jacobian,
    const Eigen::MatrixBase<Rotation>& rotation, const Vector3<Scalar>& gravity = standard_gravity<Scalar>()) noexcept {
  constexpr int kDofs = Columns::ColsAtCompileTime;
  static_assert(Columns::RowsAtCompileTime == 6 && kDofs != Eigen::Dynamic,
                "compensation_torque: a Jacobian of 6 rows and as many columns as the arm has joints, known when "
                "compiled (else: RuntimeEstimator)");
  const Vector6<Scalar> wrench = payload_wrench(payload, rotation, gravity).vector();
  JointVector<Scalar, kDofs> torque;
  for (int j = 0; j < kDofs; ++j) torque[j] = -jacobian.col(j).dot(wrench);
  return torque;
}

/// U = m g.(p + R r) [J] (docs/theory_control.md (C20)): compensation_torque is -dU/dq. U is minus the payload's own
/// potential energy.
/// @param payload   what is held
/// @param position  p [m], of the end-effector origin, world axes, counted from a point in the middle of the workspace:
///                  the bound of EnergyTank contains the largest |U|
/// @param rotation  R, end-effector axes to world axes
/// @param gravity   g [m/s^2], world axes
template <typename Scalar, typename Position, typename Rotation>
Scalar compensation_potential(const Payload<Scalar>& payload, const Eigen::MatrixBase<Position>& position,
                              const Eigen::MatrixBase<Rotation>& rotation,
                              const Vector3<Scalar>& gravity = standard_gravity<Scalar>()) noexcept {
  EIGEN_STATIC_ASSERT_VECTOR_SPECIFIC_SIZE(Position, 3);
  EIGEN_STATIC_ASSERT_MATRIX_SPECIFIC_SIZE(Rotation, 3, 3);
  return payload.mass * gravity.dot(position + rotation.lazyProduct(payload.com));
}

/// Settings of CompensationRamp.
template <typename Scalar, int Dofs>
struct CompensationRampConfig {
  /// How fast the compensation may change [N m/s], per joint, > 0. It shares the arm's torque-rate limit (1000 N m/s on
  /// a Panda) with the nominal controller: the default leaves the nominal controller one half.
  JointVector<Scalar, Dofs> torque_rate = JointVector<Scalar, Dofs>::Constant(Scalar(500));
};

/// Limits the rate of the compensation torque: in a tick no joint's torque changes by more than torque_rate * period,
/// even if the estimate jumps. All joints move by the same fraction of the way to the target. So at one pose, the
/// torque between two estimates is that of a payload between the two. A target that moves slower than the limit is met
/// exactly (docs/theory_control.md, "Compensation").
template <typename Scalar, int Dofs>
class CompensationRamp {
 public:
  /// @param period  control period [s], > 0. The nominal one, not the measured one: a late tick must not make a step.
  /// @param config  how fast the torque may change
  /// @throws std::invalid_argument naming the field out of range
  explicit CompensationRamp(
      Scalar period, const CompensationRampConfig<Scalar, Dofs>& config = CompensationRampConfig<Scalar, Dofs>());

  /// Moves the torque towards `target` [N m] by at most one tick's step.
  /// @return Ok, or NonFiniteInput: the torque stays what it was
  Status update(const JointVector<Scalar, Dofs>& target) noexcept;

  /// The compensation torque to command now [N m]; zero before the first update().
  const JointVector<Scalar, Dofs>& torque() const noexcept { return torque_; }
  /// Sets the torque to zero at once. This is a torque step: only for use while the arm is not commanded.
  void reset() noexcept { torque_.setZero(); }

 private:
  JointVector<Scalar, Dofs> max_step_;  // [N m] per tick
  JointVector<Scalar, Dofs> torque_ = JointVector<Scalar, Dofs>::Zero();
};

template <typename Scalar, int Dofs>
CompensationRamp<Scalar, Dofs>::CompensationRamp(Scalar period, const CompensationRampConfig<Scalar, Dofs>& config)
    : max_step_(config.torque_rate * period) {
  detail::require_positive(period, "CompensationRamp::period", "> 0 s");
  for (int joint = 0; joint < Dofs; ++joint) {  // the step: it could underflow to zero
    detail::require(max_step_[joint] > 0, "CompensationRampConfig::torque_rate", "> 0 N m/s",
                    config.torque_rate[joint]);
  }
}

template <typename Scalar, int Dofs>
Status CompensationRamp<Scalar, Dofs>::update(const JointVector<Scalar, Dofs>& target) noexcept {
  const JointVector<Scalar, Dofs> way = target - torque_;
  if (!way.allFinite()) return Status::NonFiniteInput;  // also a finite target whose distance overflows
  const Scalar ticks = way.cwiseQuotient(max_step_).cwiseAbs().maxCoeff();
  // Assigned, where it can be reached: adding the whole way would be subject to rounding.
  torque_ = ticks > Scalar(1) ? JointVector<Scalar, Dofs>(torque_ + way / ticks) : target;
  return Status::Ok;
}

}  // namespace rme
