#pragma once
/// A bound on the energy that a torque without a proof of passivity may put into the arm.
#include <algorithm>
#include <cmath>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>

namespace rme {

/// Settings of EnergyTank.
struct EnergyTankConfig {
  double capacity = 12;  ///< the most it holds [J], > 0: lifting 1.2 kg by a metre
  double initial = 12;   ///< what it starts with [J], 0 to capacity
  double reserve = 2;    ///< below this level the torque fades [J], > 0, at most capacity
};

/// Optional, for the compensation torque: carrying a payload that is estimated right stores no energy in the arm, but a
/// wrong estimate, or one that changes while the arm moves, can feed a motion. The tank pays for what the torque puts
/// in, is refilled by what it takes out, and scales it down as it runs empty:
///
///     share = min(1, E / reserve),    E <- E - share power dt,    0 <= E <= capacity
///
/// so that over any time the torque puts in no more than E at its beginning, whatever the estimates (energy tanks:
/// Ferraguti et al., ICRA 2013). The share is continuous; with an empty tank the payload is not carried, and the arm
/// rests lower.
template <typename Scalar>
class EnergyTank {
 public:
  /// @param period  control period [s], > 0
  /// @throws std::invalid_argument naming the field out of range
  explicit EnergyTank(Scalar period, const EnergyTankConfig& config = EnergyTankConfig())
      : period_(period),
        capacity_(static_cast<Scalar>(config.capacity)),
        reserve_(static_cast<Scalar>(config.reserve)),
        energy_(static_cast<Scalar>(config.initial)) {
    detail::require_positive(period, "EnergyTank::period", "> 0 s");
    detail::require_positive(config.capacity, "EnergyTankConfig::capacity", "> 0 J");
    detail::require(config.initial >= 0 && config.initial <= config.capacity, "EnergyTankConfig::initial",
                    "0 to capacity [J]", config.initial);
    detail::require(config.reserve > 0 && config.reserve <= config.capacity, "EnergyTankConfig::reserve",
                    "above 0, at most capacity [J]", config.reserve);
  }

  /// Pays for one period.
  /// @param power  that the torque would put into the arm, dq^T tau [W]
  /// @return Ok; or NonFiniteInput: nothing is paid, and the share is that of the tick before
  Status update(Scalar power) noexcept {
    using std::isfinite;
    const Scalar asked = power * period_;
    if (!isfinite(asked)) return Status::NonFiniteInput;
    share_ = std::min(Scalar(1), energy_ / reserve_);
    if (share_ * asked > energy_) share_ = energy_ / asked;
    energy_ = std::min(capacity_, std::max(Scalar(0), energy_ - share_ * asked));
    return Status::Ok;
  }

  Scalar share() const noexcept { return share_; }    ///< by which to scale the torque this tick, 0 to 1
  Scalar energy() const noexcept { return energy_; }  ///< what is left [J]

 private:
  Scalar period_, capacity_, reserve_;
  Scalar energy_;
  Scalar share_ = Scalar(0);
};

}  // namespace rme
