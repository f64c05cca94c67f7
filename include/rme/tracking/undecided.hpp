#pragma once
/// Which part of a payload may be no weight but something rigid that holds the hand.
#include <algorithm>
#include <cmath>

namespace rme {

/// If something rigid holds the hand, the robot's compensation appears as further weight, so that a robot which carries
/// all of it drives both up. Weight and support differ in one thing: something rigid resists each millimetre of motion
/// with some newtons. So what appears little by little is undecided until the hand has moved up or down with it
/// (docs/theory.md (T67)), also just before it was noticed. What appears at once is a payload; what comes later, before
/// the hand has moved with that, comes little by little. Real time: nothing allocates.
template <typename Scalar>
class Undecided {
 public:
  /// In this block the payload changes, or another one takes its place.
  void change() noexcept {
    begin();
    slow_ = !weight_ && (slow_ || age_ > Scalar(kAtOnce));
  }
  /// From this block on, something flows into what is held.
  void pour() noexcept {
    begin();
    slow_ = !weight_;
  }
  /// Nothing is held any more.
  void let_go() noexcept {
    weight_ = true;
    slow_ = false;
    settled_ = Scalar(0);
  }
  /// A block has passed.
  /// @param mass      that is held; while it changes, the one before [kg]
  /// @param shown     mass that the block shows [kg]
  /// @param duration  of the block [s]
  /// @param risen     how far the hand has gone up in it [m]
  /// @param gravity   |g| [m/s^2]
  /// @param certain   the host has said that the payload changes now, so what comes is a weight
  void update(Scalar mass, Scalar shown, Scalar duration, Scalar risen, Scalar gravity, bool certain) noexcept {
    age_ += duration;
    risen_ += risen;
    if (!slow_) risen_ *= std::exp(-duration / Scalar(kRecent));  // a load makes the hand sink before it is noticed
    const Scalar force = (slow_ ? of(shown) : std::max(Scalar(0), shown)) * gravity;
    if (certain || !(risen_ > -Scalar(kSlack) && risen_ < Scalar(kSlack) + force / Scalar(kRigid))) {
      weight_ = true;
      slow_ = false;
    }
    settled_ = std::max(Scalar(0), slow_ ? std::min(settled_, mass) : mass);
  }
  /// How much of the payload's mass is undecided [kg].
  /// @param mass  of the payload [kg]
  Scalar of(Scalar mass) const noexcept { return slow_ ? std::max(Scalar(0), mass - settled_) : Scalar(0); }

  /// Share of a payload that is carried.
  /// @param undecided  share of it that is undecided
  static Scalar carried(Scalar undecided) noexcept { return Scalar(1) - Scalar(1 - kShare) * undecided; }

 private:
  static constexpr double kShare = 0.2;    // share that is carried of what is undecided
  static constexpr double kRigid = 5000;   // least stiffness of what is rigid [N/m]
  static constexpr double kSlack = 0.001;  // its play, and the drift of the integral of dq [m]
  static constexpr double kRecent = 0.2;   // memory of a hand that sinks [s]
  static constexpr double kAtOnce = 0.1;   // longest change that is felt at once [s]

  /// Something comes. What has come since the hand last moved with all of it is one with it.
  void begin() noexcept {
    if (weight_) {
      age_ = Scalar(0);
      risen_ = std::min(Scalar(0), risen_);
    }
    weight_ = false;
  }

  Scalar settled_ = Scalar(0);  // mass that is no support [kg]
  Scalar age_ = Scalar(0);      // since the first of what has come began to [s]
  Scalar risen_ = Scalar(0);    // how far the hand has gone up since then [m]
  bool weight_ = true;          // the hand has moved with all that has come, or the host has said that it is a weight
  bool slow_ = false;           // it comes little by little
};

}  // namespace rme
