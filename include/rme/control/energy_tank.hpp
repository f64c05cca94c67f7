#pragma once
/// A bound on the energy that a torque without a proof of passivity may put into the arm.
#include <algorithm>
#include <cmath>
#include <rme/control/detail/compensated_sum.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>

namespace rme {

/// Settings of EnergyTank.
struct EnergyTankConfig {
  double capacity = 12;  ///< the most it holds [J], > 0: changes of 1.2 kg a metre away from the zero of the potential
  double initial = 12;   ///< what it starts with [J], 0 to capacity
  double reserve = 2;    ///< below this level the torque fades [J], > 0, at most capacity
  double refill = 0;     ///< what flows in by itself [W], >= 0: objects that are put down elsewhere than picked up cost
};

/// Optional, for the compensation torque. While the estimate is constant, right or wrong, that torque is the gradient
/// of a potential U(theta, q) = m g.(p + R r) (compensation_potential) and gives back on the way down what it gave on
/// the way up; what can feed a motion is an estimate that changes while the arm moves. The tank pays for that part
/// only, the energy that the scaled torque puts in less what U has lost (docs/theory_control.md (C22)):
///
///     share = min(1, E / reserve),    E <- E + refill dt - (share power dt + change of (share U)),    E <= capacity
///
/// Summed up, whatever the estimates do, the torque has put in at most
///
///     initial + refill t + max |U|
///
/// since an empty hand (docs/theory_control.md, "Compensation"), where max |U| is the largest potential that the
/// estimates had: 12 J for 1.2 kg within a metre of the point from which p is counted. Energy tanks: Ferraguti et al.,
/// ICRA 2013. E falls below zero, to -max |U| at worst, where the estimate of an object vanishes above the place where
/// it appeared. The share is continuous where U and power are; with an empty tank the payload is not carried, and the
/// arm rests lower.
template <typename Scalar>
class EnergyTank {
 public:
  /// @param period  control period [s], > 0
  /// @param config  how much it holds, and when the torque fades
  /// @throws std::invalid_argument naming the field out of range
  explicit EnergyTank(Scalar period, const EnergyTankConfig& config = EnergyTankConfig())
      : period_(period),
        capacity_(static_cast<Scalar>(config.capacity)),
        reserve_(static_cast<Scalar>(config.reserve)),
        refill_(static_cast<Scalar>(config.refill) * period),
        energy_(static_cast<Scalar>(config.initial)) {
    detail::require_positive(period, "EnergyTank::period", "> 0 s");
    detail::require_positive(config.capacity, "EnergyTankConfig::capacity", "> 0 J");
    detail::require(config.initial >= 0 && config.initial <= config.capacity, "EnergyTankConfig::initial",
                    "0 to capacity [J]", config.initial);
    detail::require(config.refill >= 0 && std::isfinite(config.refill), "EnergyTankConfig::refill", ">= 0 W",
                    config.refill);
    detail::require(config.reserve > 0 && config.reserve <= config.capacity, "EnergyTankConfig::reserve",
                    "above 0, at most capacity [J]", config.reserve);
  }

  /// Pays for one period.
  /// @param power      that the unscaled torque puts into the arm, dq^T tau [W]
  /// @param potential  U of the present estimate at the present pose [J]. Left at zero, all of the power is paid for:
  ///                   for torques that are no gradient.
  /// @return Ok; or NonFiniteInput: nothing is paid, and the share is that of the tick before
  Status update(Scalar power, Scalar potential = Scalar(0)) noexcept {
    using std::isfinite;
    const Scalar drawn = power * period_, asked = drawn + potential;  // for a share of one
    if (!isfinite(asked)) return Status::NonFiniteInput;
    energy_.add(refill_);
    share_ = std::max(Scalar(0), std::min(Scalar(1), energy_.value() / reserve_));
    energy_.add(held_);  // what U took last time comes back, and what it takes now is paid
    const Scalar level = energy_.value();
    const bool emptied = asked > 0 && share_ * asked > level;
    if (emptied) share_ = std::max(Scalar(0), level / asked);
    held_ = share_ * potential;
    energy_.add(-held_);  // apart from the next term, so that in float no U rounds it away
    energy_.add(-share_ * drawn);
    if (emptied && level >= 0) energy_ = detail::CompensatedSum<Scalar>();
    if (energy_.value() > capacity_) energy_ = detail::CompensatedSum<Scalar>(capacity_);
    return Status::Ok;
  }

  Scalar share() const noexcept { return share_; }            ///< by which to scale the torque this tick, 0 to 1
  Scalar energy() const noexcept { return energy_.value(); }  ///< what is left [J]

 private:
  Scalar period_, capacity_, reserve_, refill_;
  detail::CompensatedSum<Scalar> energy_;
  Scalar held_ = Scalar(0);  // share U of the last tick [J]
  Scalar share_ = Scalar(0);
};

}  // namespace rme
