#pragma once
/// Reduces the compensation when the payload's weight is suddenly missing in tau_ext.
#include <algorithm>
#include <cmath>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Compares, tick by tick, the payload's torque with the external torque. When an object is dropped, the compensation
/// pushes the empty hand upwards until the stories have noticed. The guard notices within milliseconds. It also acts
/// when somebody lifts the object: the arm then sags a little, which is the safer error.
///
///     share = clamp(2 (tau - nu) . t / t . t, 0, 1)     (docs/theory.md (T35))
///
/// Here t is the payload's torque, tau the external torque averaged over 4 ms, and nu the part of tau that the payload
/// did not explain in the last block in which nothing happened; in a push that bears clearly more than its weight, nu
/// follows within a second. Who takes the object away bears its weight, and no more; so a hand that presses on
/// something soon presses no harder because it holds an object. No call allocates.
template <typename Scalar, int Dofs>
class RemovalGuard {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< joint torque [N m]

  /// Advances by one tick.
  /// @param tau      external torque of this tick, with the observer's lag removed [N m]
  /// @param carried  t, the torque of the estimated payload [N m]
  /// @param dt       time since the last tick [s], > 0
  void update(const Vector& tau, const Vector& carried, Scalar dt) noexcept {
    using std::exp;
    detail::add_scaled(average_, Scalar(1) - exp(-dt / Scalar(kAverage)), detail::difference(tau, average_));
    const Scalar square = detail::dot(carried, carried);
    if (!(square > Scalar(kLeast * kLeast))) {
      share_ = Scalar(1);
      return;
    }
    const Scalar support = detail::dot(detail::difference(average_, besides_), carried) / square;
    share_ = std::max(Scalar(0), std::min(Scalar(1), 2 * support));
  }
  /// Learns nu from a block in which the payload was certainly held: at once if nothing happened, within a second if a
  /// push bore clearly more than the payload's weight, and not at all if it bore less.
  /// @param tau      the block's mean torque [N m]
  /// @param weight   that of the payload [N m]
  /// @param pushed   whether something else acted on the arm
  /// @param elapsed  time since the last block [s]
  void learn(const Vector& tau, const Vector& weight, bool pushed, Scalar elapsed) noexcept {
    using std::exp;
    if (pushed && !(detail::dot(tau, weight) < -Scalar(kMore) * detail::dot(weight, weight))) return;
    const Scalar blend = pushed ? Scalar(1) - exp(-elapsed / Scalar(kPatience)) : Scalar(1);
    detail::add_scaled(besides_, blend, detail::difference(detail::difference(tau, weight), besides_));
  }
  /// The share of the compensation that is safe to command, 0 to 1.
  Scalar share() const noexcept { return share_; }

 private:
  static constexpr double kAverage = 0.004;  // time constant of tau's average [s]
  static constexpr double kMore = 0.2;       // what a push bears beyond the weight, as a share of it
  static constexpr double kPatience = 1;     // how long it takes to trust such a push [s]
  static constexpr double kLeast = 0.3;      // the share is 1 if the norm of t is at most this: no danger [N m]
  Vector average_ = Vector::Zero(), besides_ = Vector::Zero();  // of tau; nu
  Scalar share_ = Scalar(1);
};

}  // namespace rme
