#pragma once
/// The direction and share of dry friction in each joint.
#include <algorithm>
#include <cmath>
#include <rme/core/types.hpp>

namespace rme {

/// The share of Coulomb friction that acts against each joint's motion, d in [-1, 1]: friction torque = -coulomb d.
///
/// A moving joint has d = sign(dq). A joint that stops keeps d at first. From then on friction balances every change of
/// the other torques. The joint does not move, so that its torques cancel, and as long as the payload's torque is
/// steady a change of tau_ext is a change of friction:
///
///     d = d_stop - (tau_ext - tau_ext at the stop) / coulomb     (docs/theory.md (T38))
///
/// This matters when a payload has just been compensated: the controller pulls the arm back, and friction then acts in
/// the other direction. With the last direction of motion as d, the error would be up to twice the friction. While the
/// flange accelerates, the payload's torque is not steady, and d stays as it is. When a payload is known to come, or the
/// torque changes by more than friction can, d returns to its value before the change and keeps it for 0.1 s.
template <typename Scalar, int Dofs>
class FrictionDirection {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint

  /// @param dt             control period [s], > 0; the owner checks it
  /// @param rest_velocity  joints slower than this count as resting [rad/s]
  /// @param coulomb        friction to expect in tau_ext [N m]; a joint with 0 keeps its last direction
  FrictionDirection(double dt, Scalar rest_velocity, const Vector& coulomb) noexcept
      : rest_velocity_(rest_velocity),
        coulomb_(coulomb),
        blend_(static_cast<Scalar>(-std::expm1(-dt / kSmoothing))),
        slow_blend_(static_cast<Scalar>(-std::expm1(-dt / kMemory))),
        settling_(static_cast<int>(std::min(1e6, kSettling / dt))) {
    reset();
  }

  /// Advances by one period. Finite arguments only.
  /// @param tau             external torque, with the observer's lag removed [N m]
  /// @param dq              joint velocity [rad/s]
  /// @param acceleration    of the flange, linear [m/s^2]
  /// @param payload_steady  false while the payload is known to come or go
  /// @return d; 0 for a joint that has not moved yet
  const Vector& update(const Vector& tau, const Vector& dq, const Vector3<Scalar>& acceleration,
                       bool payload_steady = true) noexcept {
    if (!started_) level_ = stop_level_ = tau;
    started_ = true;
    acceleration_ += blend_ * (acceleration - acceleration_);
    const Vector change = blend_ * (tau - level_);
    level_ += change;
    const bool accelerates = acceleration_.norm() > static_cast<Scalar>(kSteady);
    for (int j = 0; j < Dofs; ++j) {
      const bool moves = std::abs(dq[j]) > rest_velocity_;
      if (!moves && !payload_steady && coulomb_[j] > 0) {
        if (hold_[j] == 0) restore(j);
        hold_[j] = settling_;
      }
      if (moves) {
        direction_[j] = dq[j] > 0 ? Scalar(1) : Scalar(-1);
      } else if (moved_[j] != 0) {
        stop_level_[j] = level_[j];
        stop_direction_[j] = direction_[j];
      } else if (accelerates || hold_[j] > 0) {
        stop_level_[j] += change[j];
      } else if (coulomb_[j] > 0) {
        const Scalar d = stop_direction_[j] - (level_[j] - stop_level_[j]) / coulomb_[j];
        if (std::abs(d) > static_cast<Scalar>(kBeyond)) {  // something else that does not move the joint
          restore(j);
          hold_[j] = settling_;
        } else {
          direction_[j] = std::max(Scalar(-1), std::min(Scalar(1), d));
        }
      }
      hold_[j] = std::max(0, hold_[j] - 1);
      moved_[j] = moves ? 1 : 0;
      slow_[j] += slow_blend_ * (direction_[j] - slow_[j]);
    }
    return direction_;
  }

  /// As constructed: no joint has moved.
  void reset() noexcept {
    started_ = false;
    hold_.setConstant(settling_);
    direction_.setZero();
    stop_direction_.setZero();
    level_.setZero();
    stop_level_.setZero();
    moved_.setZero();
    acceleration_.setZero();
    slow_.setZero();
  }

 private:
  // What has just changed was not friction: back to what was before.
  void restore(int j) noexcept {
    direction_[j] = stop_direction_[j] = slow_[j];
    stop_level_[j] = level_[j];
  }

  static constexpr double kSmoothing = 0.01;  // time constant: a single sample's noise is a share of the friction [s]
  static constexpr double kSettling = 0.1;    // by then a filter shows what has come, be it payload or offset [s]
  static constexpr double kMemory = 0.2;      // time constant: what d was before a change that has just begun [s]
  static constexpr double kBeyond = 2;        // Coulomb friction twice the expected is still friction
  static constexpr double kSteady = 0.5;      // below it 1 kg on an arm's length counts as steady [m/s^2]

  Scalar rest_velocity_;
  Vector coulomb_;
  Scalar blend_, slow_blend_;
  int settling_;
  bool started_ = false;
  Vector direction_, stop_direction_, slow_;
  Vector level_, stop_level_;                 // of tau, smoothed: now, and when the joint stopped [N m]
  Eigen::Matrix<int, Dofs, 1> moved_, hold_;  // in the last tick: 0 or 1; ticks for which d stays as it is
  Vector3<Scalar> acceleration_;              // smoothed
};

}  // namespace rme
