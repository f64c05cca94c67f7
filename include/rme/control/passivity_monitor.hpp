#pragma once
/// The energy balance of a controlled arm in each tick: stored against supplied energy.
#include <cmath>
#include <rme/control/detail/compensated_sum.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// 1/2 dq^T M dq [J], a part of S in docs/theory_control.md (C16). For six joints it is the 1/2 xdot^T M_x xdot of
/// [RME, Eq. 34]; a redundant arm also has kinetic energy in motions that do not move the hand.
/// @param mass_matrix  M, DofsxDofs [kg m^2]
/// @param dq           joint velocity [rad/s]
template <typename Scalar, int Dofs>
Scalar kinetic_energy(const JointMatrix<Scalar, Dofs>& mass_matrix, const JointVector<Scalar, Dofs>& dq) noexcept {
  return dq.dot(mass_matrix * dq) / 2;
}

/// Balances the storage function S = kinetic energy + lambda_1 V [RME, Eq. 34] against the energy supplied to the
/// system from outside. Passive means that S grows by no more than the supplied energy [RME, Eq. 35;
/// docs/theory_control.md (C16)]: residual() never rises, except by what the controller puts in by holding its torque
/// for a tick (C17). This part goes to zero with the period.
///
/// The host gives the supply as work or as power. A torque that was held since the last tick has done exactly the work
/// tau^T (q - q_last): update_with_work(). update() integrates power by the trapezoidal rule. Its error is in
/// proportion to the square of the period if the power is smooth, and to the period if the torque is held (C18). Sums
/// are compensated, so that float loses no small terms.
///
/// The host chooses what counts as supplied: the power xdot^T (F_ext + dF_mm) of the external wrench and of the payload
/// that is not compensated; with PassiveController also its injected_power(), and dq^T tau of every torque beside
/// J^T F_c, such as those for null space and constraints.
template <typename Scalar>
class PassivityMonitor {
 public:
  /// @param period  between two updates [s], > 0
  /// @throws std::invalid_argument naming the field out of range
  explicit PassivityMonitor(Scalar period) : period_(period) {
    detail::require_positive(period, "PassivityMonitor::period", "> 0 s");
  }

  /// Adds one tick to the balance; the first call starts the balance.
  /// @param storage  S [J]
  /// @param power    supplied power [W] at the same instant
  /// @return Ok, or NonFiniteInput, also for numbers beyond kLargestPlausible: nothing has changed
  Status update(Scalar storage, Scalar power) noexcept;
  /// The same with the work done since the last tick (C17).
  /// @param storage  S [J]
  /// @param work     supplied since the last update [J], e.g. tau^T (q - q_last) of a torque that was held; ignored in
  ///                 the update that starts the balance
  /// @return Ok, or NonFiniteInput, also for numbers beyond kLargestPlausible: nothing has changed
  Status update_with_work(Scalar storage, Scalar work) noexcept;
  /// The next update starts a new balance. Needed after a change of the potential (a new target).
  void reset() noexcept { open_ = false; }

  Scalar storage() const noexcept { return storage_; }            ///< S [J]
  Scalar supplied() const noexcept { return supplied_.value(); }  ///< energy supplied since the balance started [J]
  /// S - S(0) - supplied() [J]: the dissipated energy with a minus sign; never above zero for a passive system.
  Scalar residual() const noexcept { return open_ ? -supplied_.minus(storage_ - initial_) : Scalar(0); }
  /// dS/dt minus the supplied power, averaged over the last tick [W]. By [RME, Eq. 35] it is -xdot^T D xdot.
  Scalar power_residual() const noexcept { return power_residual_; }

 private:
  Scalar period_;
  bool open_ = false;
  Scalar initial_ = Scalar(0), storage_ = Scalar(0), power_ = Scalar(0);
  detail::CompensatedSum<Scalar> supplied_;
  Scalar power_residual_ = Scalar(0);
};

template <typename Scalar>
Status PassivityMonitor<Scalar>::update(Scalar storage, Scalar power) noexcept {
  if (!plausible(power)) return Status::NonFiniteInput;
  const Status status = update_with_work(storage, period_ * ((power_ + power) / 2));
  if (status == Status::Ok) power_ = power;
  return status;
}

template <typename Scalar>
Status PassivityMonitor<Scalar>::update_with_work(Scalar storage, Scalar work) noexcept {
  if (!plausible(storage) || !plausible(work)) return Status::NonFiniteInput;
  if (!open_) {
    open_ = true;
    initial_ = storage;
    supplied_ = detail::CompensatedSum<Scalar>();
    power_residual_ = Scalar(0);
  } else {
    supplied_.add(work);
    power_residual_ = (storage - storage_ - work) / period_;
  }
  storage_ = storage;
  power_ = work / period_;
  return Status::Ok;
}

}  // namespace rme
