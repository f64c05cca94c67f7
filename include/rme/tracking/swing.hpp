#pragma once
/// A payload that swings: it hangs, or what holds it gives.
#include <algorithm>
#include <cmath>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/star_gaussian.hpp>

namespace rme {

/// The force of a swing: that with which a payload pulls at the hand beside its weight and its inertia (docs/theory.md
/// (T55)). It has no mean, so what the hand holds is learned all the same. In each direction it is an Ornstein-Uhlenbeck
/// process, part of the star's x, and its size is learned. Real time: nothing allocates.
template <typename Scalar, int Dofs>
class Swing {
 public:
  using Star = StarGaussian<Scalar, Dofs>;  ///< state of the filter

  /// A swing that nothing is known of.
  /// @param star    state; from here on it has the force as an unknown of its own
  /// @param weight  of the payload [N], > 0
  void begin(Star& star, Scalar weight) noexcept {
    const Scalar force = Scalar(kForce) * weight;
    *this = Swing();
    variance_.setConstant(force * force);
    star.begin_swing(variance_);
  }
  /// Time update of the force.
  /// @param star      state
  /// @param duration  of the block [s]
  void predict(Star& star, Scalar duration) const noexcept {
    star.renew_swing(std::exp(-duration / Scalar(kTime)), variance_);
  }
  /// Learns the size of the swing, and its frequency, from what the last block has shown of the force.
  /// @param star      state, after the block
  /// @param duration  of the block [s]
  /// @param weight    of the payload [N], > 0
  void learn(const Star& star, Scalar duration, Scalar weight) noexcept {
    const Scalar share = Scalar(1) - std::exp(-duration / Scalar(kMemory));
    const Scalar least = Scalar(kLeast) * weight, most = Scalar(kMost) * weight;
    int axis = 0;
    Vector3<Scalar> off;
    for (int i = 0; i < 3; ++i) {
      // A force that stays belongs to the payload: the size is that of the changes.
      off[i] = star.mean()[kSwing + i] - mean_[i];
      mean_[i] += share * off[i];
      moves_[i] += share * (off[i] * off[i] - moves_[i]);
      const Scalar square = (Scalar(1) - share) * off[i] * off[i] + star.variance(kSwing + i);
      variance_[i] += share * (square - variance_[i]);
      variance_[i] = std::max(least * least, std::min(most * most, variance_[i]));
      if (moves_[i] > moves_[axis]) axis = i;
    }
    since_ += duration;
    if (off[axis] * off[axis] < Scalar(kEdge * kEdge) * moves_[axis]) return;
    const int side = off[axis] > 0 ? 1 + axis : -1 - axis;
    if (side == side_) return;
    if (side == -side_ && turns_ > 0) half_ = half_ > 0 ? half_ + Scalar(kNewest) * (since_ - half_) : since_;
    turns_ = side == -side_ ? 1 : 0;
    side_ = side;
    since_ = Scalar(0);
  }
  /// Frequency of the swing, from the times between its turns; 0 before there were two [Hz].
  Scalar frequency() const noexcept { return half_ > 0 ? Scalar(0.5) / half_ : Scalar(0); }

  /// Mean square of the relative error that a swing has caused in a payload before it was noticed. One that has been there
  /// for longer than its correlation time would have been noticed.
  /// @param held_for  since the payload was drawn [s]
  static Scalar hidden(Scalar held_for) noexcept {
    return Scalar(kForce * kForce) * std::exp(-held_for / Scalar(kTime));
  }

 private:
  static constexpr double kForce = 0.15;  // standard deviation of the force in each direction at first, per weight
  static constexpr double kLeast = 0.01, kMost = 0.3;  // the same, bounds of what is learned
  static constexpr double kTime = 0.15;                // correlation time of the force [s]
  static constexpr double kMemory = 1;                 // time constant with which its size is learned [s]
  static constexpr double kEdge = 0.3;    // how far out of the middle a side begins, in standard deviations
  static constexpr double kNewest = 0.3;  // share of the newest half period in the frequency
  Vector3<Scalar> variance_ = Vector3<Scalar>::Zero();  // of the force in each direction [N^2], world axes
  Vector3<Scalar> mean_ = Vector3<Scalar>::Zero();      // of its estimate in the last second [N]
  Vector3<Scalar> moves_ = Vector3<Scalar>::Zero();     // variance of its estimate in the last second [N^2]
  Scalar since_ = Scalar(0), half_ = Scalar(0);         // time since the last turn, and half the period; 0: unknown [s]
  int side_ = 0, turns_ = 0;  // on which side it is: 1 + axis, or minus that; whether the last side was the other one
};

}  // namespace rme
