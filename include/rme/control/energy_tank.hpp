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
  double capacity = 12;  ///< the most it holds [J], > 0: changes of 1.2 kg a metre away from the zero of the potential
  double initial = 12;   ///< what it starts with [J], 0 to capacity
  double reserve = 2;    ///< below this level the torque fades [J], > 0, at most capacity
  /// What flows in at all times [W], >= 0. An object that is put down higher than it was picked up costs m g times the
  /// difference; holding the torque for a tick costs a little in each. Without a refill the tank runs out.
  double refill = 0;
};

/// Optional, for the compensation torque. While the estimate is constant, right or wrong, that torque is -dU/dq of the
/// potential U(theta, q) = m g.(p + R r) (compensation_potential), and puts nothing into a closed motion. An estimate
/// that changes while the arm moves can, and so can a torque that is held for a tick. The tank scales the torque. It
/// keeps the balance B of the work that the scaled torque does, exactly tau^T (q - q_last) for one that was held since
/// the last update. Its level E is B less the scaled U (docs/theory_control.md (C22)):
///
///     B <- B + refill period - tau^T (q - q_last),    E = B - share U <= capacity,
///     share = (B - min(U, 0)) / (reserve + max(U, 0)), within 0 and 1
///
/// The share is one for as long as that leaves the reserve in the tank. Whatever the estimates do, the torque has put
/// in at most
///
///     initial + refill t + max |U|
///
/// since an empty hand, where max |U| is the largest potential that the estimates had: 12 J for 1.2 kg within a metre
/// of the point from which p is counted. The bound needs that the unscaled torque does no more work than the reserve in
/// one period: 2 kW at 1 kHz. E can fall to -max |U|, where the estimate of an object vanishes above the place where it
/// appeared. The share is continuous in B and U. With an empty tank the payload is not carried, and the arm sinks.
/// Energy tanks: Ferraguti et al., ICRA 2013.
template <typename Scalar, int Dofs>
class EnergyTank {
 public:
  /// @param period  control period [s], > 0
  /// @param config  how much it holds, and when the torque fades
  /// @throws std::invalid_argument naming the field out of range
  explicit EnergyTank(Scalar period, const EnergyTankConfig& config = EnergyTankConfig());

  /// Pays for what torque() has done since the update before, and scales the torque to command next.
  /// @param q          joint positions [rad, m], Dofs: turns are counted, a jump by 2 pi would pass for motion
  /// @param torque     to be scaled [N m, N], Dofs
  /// @param potential  U of the present estimate at q [J]. Left at zero, all of the work is paid for: for torques that
  ///                   are no gradient.
  /// @return Ok; or NonFiniteInput, also for numbers beyond kLargestPlausible: nothing is paid, and torque() stays what
  ///         it was. While it is held on, the next update pays for all that it has done.
  Status update(const JointVector<Scalar, Dofs>& q, const JointVector<Scalar, Dofs>& torque,
                Scalar potential = Scalar(0)) noexcept;
  /// To be called when torque() is no longer commanded: until the next update it is zero, and nothing is paid.
  void reset() noexcept { torque_.setZero(); }

  /// The scaled torque [N m, N], to command from now on until the next update; zero before the first one.
  const JointVector<Scalar, Dofs>& torque() const noexcept { return torque_; }
  Scalar share() const noexcept { return share_; }                  ///< by which it is scaled, 0 to 1
  Scalar energy() const noexcept { return balance_.minus(held_); }  ///< E, what is left [J]

 private:
  Scalar capacity_, reserve_, refill_;      // [J], [J], [J] a period
  detail::CompensatedSum<Scalar> balance_;  // B [J]: what came in, less what the torque has put into the arm
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
  // One that underflows is none.
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
