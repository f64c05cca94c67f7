#pragma once
/// Notices that a load which the robot was told of is gone.
#include <algorithm>
#include <cmath>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// A robot that was told of a load adds a torque t that carries it. If the object is dropped, t pushes the empty hand
/// upwards, and tau_ext becomes t. The watch compares the two, tick by tick:
///
///     missing = clamp(4 (tau . t / t . t) - 2, 0, 1)
///
/// where tau is tau_ext with the observer's filter inverted, averaged over 4 ms (docs/theory_control.md (C28)). All of
/// the load counts as missing as soon as three quarters of t are seen: an object is there or not, and the friction of
/// joints that start to move hides a part of t. A torque that is not along t is ignored. Somebody who lifts the object
/// has the same effect as a loss, until the hand is let go. Real time: O(Dofs); no call allocates.
template <typename Scalar, int Dofs>
class LoadWatch {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< [N m]

  /// @param bandwidth  of the first-order filter, at 1 kHz, through which tau_ext comes [rad/s]; 0: none
  explicit LoadWatch(double bandwidth) noexcept : bandwidth_(bandwidth) {}

  /// Advances by one tick.
  /// @param tau_ext  external torque as filtered [N m]
  /// @param load     t, the torque with which the robot carries its load [N m]
  /// @param period   time since the last tick [s], > 0
  void update(const Vector& tau_ext, const Vector& load, double period) noexcept {
    // The filter has moved by this share of the way in the period (docs/theory.md (T7)).
    const double share = bandwidth_ > 0 ? 1 - std::pow(std::max(0.0, 1 - 0.001 * bandwidth_), period / 0.001) : 1;
    Vector now = tau_ext;
    if (started_ && share > 0)
      now = filtered_ + detail::scaled(static_cast<Scalar>(1 / share), detail::difference(tau_ext, filtered_));
    filtered_ = tau_ext;
    started_ = true;
    detail::add_scaled(average_, static_cast<Scalar>(1 - std::exp(-period / kAverage)),
                       detail::difference(now, average_));
    const Scalar square = detail::dot(load, load), along = detail::dot(average_, load);
    const Scalar across = detail::dot(average_, average_) * square - along * along;
    missing_ = Scalar(0);
    if (square > Scalar(kLeast * kLeast) && across < along * along)
      missing_ = std::max(Scalar(0), std::min(Scalar(1), 4 * along / square - 2));
    missed_ = missing_ > 0 ? missed_ + period : 0;
    lost_ = lost_ || missed_ > kLost;
  }
  /// The share of the load that is certainly missing, 0 to 1: as much of t has to be taken off the command.
  Scalar missing() const noexcept { return missing_; }
  /// Whether the load has been missing for a quarter of a second without a break. Stays until reset().
  bool lost() const noexcept { return lost_; }
  /// Begins anew, for another load.
  void reset() noexcept { *this = LoadWatch(bandwidth_); }

 private:
  static constexpr double kAverage = 0.004;  // time constant of tau's average [s]
  static constexpr double kLeast = 1;        // nothing is missing if the norm of t is at most this: no danger [N m]
  static constexpr double kLost = 0.25;      // [s]
  double bandwidth_, missed_ = 0;            // for how long something has been missing [s]
  Vector filtered_ = Vector::Zero(), average_ = Vector::Zero();
  Scalar missing_ = Scalar(0);
  bool started_ = false, lost_ = false;
};

}  // namespace rme
