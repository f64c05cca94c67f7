#pragma once
/// The energy balance of a controlled arm: what is stored against what was supplied, each tick.
#include <cmath>
#include <rme/control/detail/compensated_sum.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// 1/2 dq^T M dq [J], part of S in docs/theory_control.md (C17). For six joints it is the 1/2 xdot^T M_x xdot of
/// [RME, Eq. 34]; a redundant arm also stores energy in motions that leave the hand where it is.
/// @param mass_matrix  M, DofsxDofs [kg m^2]
/// @param dq           joint velocity [rad/s]
template <typename Scalar, int Dofs>
Scalar kinetic_energy(const JointMatrix<Scalar, Dofs>& mass_matrix, const JointVector<Scalar, Dofs>& dq) noexcept {
  return dq.dot(mass_matrix * dq) / 2;
}

/// Keeps the books of the storage function S = kinetic + lambda_1 V [RME, Eq. 34] and of the energy supplied to the
/// system from outside. Passive means that S grows by no more than what was supplied [RME, Eq. 35;
/// docs/theory_control.md (C17)]: residual() never rises, but for what the controller puts in by holding its torque for
/// a tick (C18), which vanishes with the period.
///
/// Supply enters as work or as power. A torque that was held since the last tick has done the work tau^T (q - q_last),
/// exactly: update_with_work(). Power is integrated by the trapezoidal rule. Its error goes with the period's square
/// where the power is smooth, and with the period where the torque is held (C19). Sums are compensated, so that float
/// loses no small terms.
///
/// The host chooses what counts as supplied: the power of the external wrench, xdot^T (F_ext + dF_mm); with
/// PassiveController also its injected_power(), and dq^T tau of every torque beside J^T F_c: null space, constraints.
template <typename Scalar>
class PassivityMonitor {
 public:
  /// @param period  between two updates [s], > 0
  /// @throws std::invalid_argument naming the field out of range
  explicit PassivityMonitor(Scalar period) : period_(period) {
    detail::require_positive(period, "PassivityMonitor::period", "> 0 s");
  }

  /// Enters one tick into the books; the first one opens them.
  /// @param storage  S [J]
  /// @param power    supplied power [W] at the same instant
  /// @return Ok, or NonFiniteInput, also for numbers beyond kLargestPlausible: the books stay as they were
  Status update(Scalar storage, Scalar power) noexcept;
  /// The same by the work done since the last tick.
  /// @param storage  S [J]
  /// @param work     supplied since the last update, e.g. tau^T (q - q_last) of a torque held meanwhile [J]; the update
  ///                 that opens the books takes no notice of it
  /// @return Ok, or NonFiniteInput, also for numbers beyond kLargestPlausible: the books stay as they were
  Status update_with_work(Scalar storage, Scalar work) noexcept;
  /// Closes the books: the next update opens new ones. Needed after a change of potential (a new target).
  void reset() noexcept { open_ = false; }

  Scalar storage() const noexcept { return storage_; }            ///< S [J]
  Scalar supplied() const noexcept { return supplied_.value(); }  ///< energy supplied since the books were opened [J]
  /// S - S(0) - supplied() [J]: minus what was dissipated; never above zero for a passive system.
  Scalar residual() const noexcept { return open_ ? -supplied_.minus(storage_ - initial_) : Scalar(0); }
  /// dS/dt less the supplied power, over the last tick [W]: the residual of [RME, Eq. 35], minus xdot^T D xdot.
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
