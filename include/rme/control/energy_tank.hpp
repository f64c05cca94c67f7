#pragma once
/// A bound on the energy that a torque that need not be passive may put into the arm.
#include <algorithm>
#include <cmath>
#include <rme/control/detail/compensated_sum.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Settings of EnergyTank.
struct EnergyTankConfig {
  /// Largest level [J], > 0. The default pays for a change of 1.2 kg one metre away from the zero of the potential.
  double capacity = 12;
  double initial = 12;  ///< level at the start [J], 0 to capacity
  double reserve = 2;   ///< below this level the torque fades [J], > 0, at most capacity
  /// Power that flows in at all times [W], >= 0. An object that is put down higher than it was picked up costs m g
  /// times the difference in height; holding the torque costs a little in each tick. Without a refill the tank runs
  /// empty.
  double refill = 0;
};

/// Optional, for the compensation torque. While the estimate is constant, right or wrong, this torque is -dU/dq of the
/// potential U(theta, q) = m g.(p + R r) (compensation_potential), and puts no energy into a closed motion. If the
/// estimate changes while the arm moves, the torque can put in energy. So can a torque that is held for a tick. The
/// tank scales the torque. It keeps the balance B of the work that the scaled torque does: a torque that was held since
/// the last update has done exactly tau^T (q - q_last). The level E is B minus the scaled U
/// (docs/theory_control.md (C21)):
///
///     B <- B + refill period - tau^T (q - q_last),    E = B - share U <= capacity,
///     share = (B - min(U, 0)) / (reserve + max(U, 0)), within 0 and 1
///
/// The share is one as long as the reserve is then left in the tank. For any sequence of estimates, the energy that the
/// torque has put in since the hand was empty is at most
///
///     initial + refill t + max |U|
///
/// where max |U| is the largest potential of all estimates: 12 J for 1.2 kg within one metre of the point from which p
/// is counted. The bound holds if the unscaled torque does no more work in one period than the reserve: 2 kW at 1 kHz.
/// E can fall to -max |U|, if an estimated object vanishes higher up than it appeared. The share is continuous in B and
/// U. An empty tank does not carry the payload, and the arm sinks. Energy tanks: Ferraguti et al., ICRA 2013.
template <typename Scalar, int Dofs>
class EnergyTank {
 public:
  /// @param period  control period [s], > 0
  /// @param config  capacity, initial level, reserve and refill
  /// @throws std::invalid_argument naming the field out of range
  explicit EnergyTank(Scalar period, const EnergyTankConfig& config = EnergyTankConfig());

  /// Pays for the work of torque() since the last update, and scales the torque to command next.
  /// @param q          joint positions [rad, m], Dofs; without jumps: a jump by 2 pi would count as motion
  /// @param torque     to be scaled [N m, N], Dofs
  /// @param potential  U of the present estimate at q [J]. Zero for torques that are no gradient: all of their work is
  ///                   paid for.
  /// @return Ok; or NonFiniteInput, also for numbers beyond kLargestPlausible: nothing is paid, and torque() stays what
  ///         it was. If the host goes on commanding it, the next update pays for all of its work.
  Status update(const JointVector<Scalar, Dofs>& q, const JointVector<Scalar, Dofs>& torque,
                Scalar potential = Scalar(0)) noexcept;
  /// To be called when the host stops commanding torque(): it is zero until the next update, which then pays nothing.
  void reset() noexcept { torque_.setZero(); }

  /// The scaled torque [N m, N], to command until the next update; zero before the first one.
  const JointVector<Scalar, Dofs>& torque() const noexcept { return torque_; }
  Scalar share() const noexcept { return share_; }                  ///< factor of the last update's torque, 0 to 1
  Scalar energy() const noexcept { return balance_.minus(held_); }  ///< E, the level [J]; can be negative

 private:
  Scalar capacity_, reserve_, refill_;      // [J], [J], [J] a period
  detail::CompensatedSum<Scalar> balance_;  // B [J]: what came in, minus what the torque has put into the arm
  JointVector<Scalar, Dofs> q_ = JointVector<Scalar, Dofs>::Zero();
  JointVector<Scalar, Dofs> torque_ = JointVector<Scalar, Dofs>::Zero();
  Scalar share_ = Scalar(0);
  Scalar held_ = Scalar(0);  // share U [J]
};

template <typename Scalar, int Dofs>
EnergyTank<Scalar, Dofs>::EnergyTank(Scalar period, const EnergyTankConfig& config)
    : capacity_(static_cast<Scalar>(config.capacity)),
      reserve_(static_cast<Scalar>(config.reserve)),
      refill_(static_cast<Scalar>(config.refill) * period),
      balance_(static_cast<Scalar>(config.initial)) {
  detail::require_positive(period, "EnergyTank::period", "> 0 s");
  detail::require_positive(config.capacity, "EnergyTankConfig::capacity", "> 0 J");
  detail::require(config.initial >= 0 && config.initial <= config.capacity, "EnergyTankConfig::initial",
                  "0 to capacity [J]", config.initial);
  detail::require(config.refill >= 0 && std::isfinite(config.refill), "EnergyTankConfig::refill", ">= 0 W",
                  config.refill);
  // A reserve that underflows to zero in Scalar is refused too.
  detail::require(reserve_ > 0 && config.reserve <= config.capacity, "EnergyTankConfig::reserve",
                  "above 0, at most capacity [J]", config.reserve);
}

template <typename Scalar, int Dofs>
Status EnergyTank<Scalar, Dofs>::update(const JointVector<Scalar, Dofs>& q, const JointVector<Scalar, Dofs>& torque,
                                        Scalar potential) noexcept {
  if (!plausible(q) || !plausible(torque) || !plausible(potential)) return Status::NonFiniteInput;
  balance_.add(refill_);
  balance_.add(-torque_.dot(q - q_));  // before the first update there was no torque
  q_ = q;
  const Scalar above = std::max(Scalar(0), potential), below = potential - above;
  share_ = std::max(Scalar(0), std::min(Scalar(1), balance_.minus(below) / (reserve_ + above)));
  held_ = share_ * potential;
  if (energy() > capacity_) balance_ = detail::CompensatedSum<Scalar>(capacity_ + held_);
  torque_ = share_ * torque;
  return Status::Ok;
}

}  // namespace rme
