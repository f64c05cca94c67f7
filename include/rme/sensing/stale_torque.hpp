#pragma once
/// Detects a sensor of the external torque, or a connection, that has stopped measuring but still reports values.
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/core/types.hpp>

namespace rme {

/// Detects that tau_ext is no measurement: it no longer changes, bit for bit in all joints, or it is exactly zero in
/// all joints, where its own noise makes both impossible.
///
/// What is impossible is learned from the readings, since many arms repeat theirs for good reasons: torque with a
/// coarse resolution is constant at rest, a simulated arm without noise is constant or zero at rest and in motion, and
/// a host may ask more often than the arm measures. So a reading is refused only after at least kFew different ones, if
///
/// - **fine noise** is known to be in every joint: each joint changes with nearly every new reading, its second
///   differences often change their sign, and they are far larger than its resolution, so that they do not come from
///   rounding. Then tau_ext is refused once it has not changed for 50 ms and for three times the longest time that it
///   usually takes; and an exact zero in all joints is refused at once;
/// - there is **coarse noise** in most joints, which often change in the direction opposite to their last change, and
///   the arm moves: tau_ext is refused once it has not changed for 50 ms and for five times the longest way that the
///   joints usually move until it does, 0.01 rad or more.
///
/// A coarse torque that freezes while the arm rests is not noticed: it looks as it would without a fault. The same is
/// true of a torque that never showed noise. A repeated reading counts as a measurement until it is refused, and the
/// next reading that differs counts again. Real time: update() is O(Dofs); nothing allocates or throws.
template <typename Scalar, int Dofs>
class StaleTorque {
 public:
  static constexpr double kTolerated = 0.05;  ///< how long tau_ext may stay the same in any case [s]

  /// Takes in a sample.
  /// @param tau_ext  as the arm reports it [N m], finite
  /// @param dq       joint velocity [rad/s], finite
  /// @param dt       time since the last sample [s], > 0
  /// @return whether tau_ext is a measurement
  bool update(const JointVector<Scalar, Dofs>& tau_ext, const JointVector<Scalar, Dofs>& dq, double dt) noexcept {
    bool same = true, zero = true;
    Scalar speed = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      same &= tau_ext[j] == last_[j];
      zero &= std::abs(tau_ext[j]) < std::numeric_limits<Scalar>::min();  // what is smaller, some CPUs take for zero
      speed = std::max(speed, std::abs(dq[j]));
    }
    held_ += dt;
    const bool moves = speed > Scalar(kMoves);
    if (moves) way_ += dt * static_cast<double>(speed);
    if (zero && fine()) return false;
    if (!same || !started_) {
      learn(tau_ext);
      return true;
    }
    if (fine())
      refused_ = held_ > std::max(kTolerated, 3 * longest_) - kRounding;
    else if (noisy() && moves && held_ > kTolerated - kRounding && way_ > std::max(kLeastWay, 5 * longest_way_))
      refused_ = true;  // and stays so when the arm stops
    return !refused_;
  }
  /// Returns to the state after construction.
  void reset() noexcept { *this = StaleTorque(); }

 private:
  static constexpr int kFew = 100;           // different readings, before which none is refused
  static constexpr int kMemory = 500;        // of shares and of the longest times, in different readings
  static constexpr double kMoves = 0.05;     // speed of the fastest joint above which the arm moves [rad/s]
  static constexpr double kUnchanged = 0.1;  // a joint with fine noise keeps its value in a smaller share of readings
  static constexpr double kLeastWay = 0.01;  // [rad]
  // Share of sign changes above which there is noise. Noise changes the sign of its changes in half of all readings,
  // and that of its second differences in two thirds; a smooth torque a few times a second.
  static constexpr double kBack = 0.3, kBent = 0.4;
  static constexpr double kFine = 4;         // second differences of fine noise, in steps of the resolution
  static constexpr double kRounding = 1e-9;  // of sums of periods [s]

  // Learns from a reading that differs from the last one.
  void learn(const JointVector<Scalar, Dofs>& tau_ext) noexcept {
    if (started_) {
      const auto blend = Scalar(1) / static_cast<Scalar>(std::min(++readings_, kMemory));
      for (int j = 0; j < Dofs; ++j) {
        const Scalar change = tau_ext[j] - last_[j];
        const Scalar bend = change - difference_[j];
        unchanged_[j] += blend * (Scalar(change == Scalar(0) ? 1 : 0) - unchanged_[j]);
        bent_[j] += blend * (Scalar(bend * bend_[j] < 0 ? 1 : 0) - bent_[j]);
        size_[j] += blend * (std::abs(bend) - size_[j]);
        bend_[j] = bend;
        difference_[j] = change;
        if (change == Scalar(0)) continue;
        back_[j] += blend * (Scalar(change * change_[j] < 0 ? 1 : 0) - back_[j]);
        change_[j] = change;
        step_[j] = step_[j] > 0 ? std::min(step_[j], std::abs(change)) : std::abs(change);
      }
      // At most doubled: one long pause does not mean that pauses are usual.
      if (readings_ > kMemory) readings_ = kMemory;
      remember(held_, kTolerated, longest_);
      if (way_ > 0) remember(way_, kLeastWay, longest_way_);
    }
    started_ = true;
    refused_ = false;
    last_ = tau_ext;
    held_ = way_ = 0;
  }
  void remember(double held, double least, double& longest) const noexcept {
    const double most = readings_ < kFew ? held : 2 * std::max(longest, least);
    longest = std::max(longest * (1 - 1.0 / kMemory), std::min(held, most));
  }
  // Whether there is noise, coarse or fine, in more than half of the joints.
  bool noisy() const noexcept {
    int count = 0;
    for (int j = 0; j < Dofs; ++j) count += back_[j] > Scalar(kBack) ? 1 : 0;
    return readings_ >= kFew && 2 * count > Dofs;
  }
  // Whether there is fine noise in every joint.
  bool fine() const noexcept {
    bool all = readings_ >= kFew;
    for (int j = 0; j < Dofs; ++j)
      all &= unchanged_[j] < Scalar(kUnchanged) && bent_[j] > Scalar(kBent) && size_[j] > Scalar(kFine) * step_[j];
    return all;
  }

  bool started_ = false, refused_ = false;
  int readings_ = 0;                      // different ones so far, at most kMemory
  double held_ = 0, way_ = 0;             // since the last change: time [s], and way of the fastest joint [rad]
  double longest_ = 0, longest_way_ = 0;  // decaying maxima of these
  JointVector<Scalar, Dofs> last_ = JointVector<Scalar, Dofs>::Zero();        // last reading [N m]
  JointVector<Scalar, Dofs> difference_ = JointVector<Scalar, Dofs>::Zero();  // its difference from the one before
  JointVector<Scalar, Dofs> bend_ = JointVector<Scalar, Dofs>::Zero();        // last second difference
  JointVector<Scalar, Dofs> change_ = JointVector<Scalar, Dofs>::Zero();      // last difference that was not zero
  JointVector<Scalar, Dofs> step_ = JointVector<Scalar, Dofs>::Zero();        // smallest difference so far
  JointVector<Scalar, Dofs> unchanged_ = JointVector<Scalar, Dofs>::Zero();   // share of readings without a change
  JointVector<Scalar, Dofs> bent_ = JointVector<Scalar, Dofs>::Zero();  // share of sign changes of second differences
  JointVector<Scalar, Dofs> size_ = JointVector<Scalar, Dofs>::Zero();  // mean size of second differences [N m]
  JointVector<Scalar, Dofs> back_ = JointVector<Scalar, Dofs>::Zero();  // share of changes opposite to the last one
};

}  // namespace rme
