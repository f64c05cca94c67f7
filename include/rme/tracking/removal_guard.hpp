#pragma once
/// Reduces the compensation when the payload's weight is suddenly missing in tau_ext.
#include <algorithm>
#include <cmath>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Compares, tick by tick, the torque that is carried with what the arm feels. When an object is dropped, compensation
/// pushes the empty hand upwards until the filters have noticed. The guard notices within milliseconds. It also acts
/// when somebody lifts the object: the arm then sags a little, which is the safer error.
///
///     s = (tau - nu) . t / t . t     (docs/theory.md (T35))
///
/// with t the payload's torque, nu what tau held besides in the last block in which nothing happened, and tau averaged
/// over 4 ms. The share of the compensation is 2 s, between 0 and 1.
template <typename Scalar, int Dofs>
class RemovalGuard {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< joint torque [N m]

  /// @param tau      external torque of this tick, the observer's lag taken out [N m]
  /// @param carried  torque of what is believed to be held [N m]
  /// @param dt       since the tick before [s]
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
  /// What a block's mean torque held besides the payload's, of a block in which nothing happened [N m].
  void learn(const Vector& besides) noexcept { besides_ = besides; }
  /// Of the compensation, that is safe to command: 0 to 1.
  Scalar share() const noexcept { return share_; }

 private:
  static constexpr double kAverage = 0.004;  // time constant [s]
  static constexpr double kLeast = 0.3;      // a torque below it is no danger [N m]
  Vector average_ = Vector::Zero(), besides_ = Vector::Zero();
  Scalar share_ = Scalar(1);
};

}  // namespace rme
