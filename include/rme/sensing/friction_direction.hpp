#pragma once
/// The direction of dry friction in each joint.
#include <algorithm>
#include <cmath>
#include <rme/core/types.hpp>

namespace rme {

/// The direction of Coulomb friction in each joint, d in [-1, 1]: the friction torque is -coulomb d.
///
/// A moving joint has d = sign(dq). A joint that stops keeps d at first. At rest, its torques balance. As long as the
/// payload's torque is steady, a change of tau_ext is therefore a change of friction:
///
///     d = d_stop - (tau_ext - tau_ext at the stop) / coulomb     (docs/theory.md (T38))
///
/// This matters when a payload has just been compensated: the controller pulls the arm back, and friction then acts in
/// the other direction. With the last direction of motion as d, the error would be up to twice the friction. While the
/// flange accelerates, the payload's torque is not steady, and d stays as it is. When the payload is known to change,
/// or the torque changes by more than friction can, d returns to its value before the change and keeps it for 0.1 s.
template <typename Scalar, int Dofs>
class FrictionDirection {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint

  /// @param dt             control period [s], > 0; the owner checks it
  /// @param rest_velocity  joints slower than this count as resting [rad/s]
  /// @param coulomb        Coulomb friction to expect in tau_ext [N m], >= 0; with 0, a joint keeps its last direction
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
  /// @param payload_steady  false while the payload is known to change
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
        if (std::abs(d) > static_cast<Scalar>(kBeyond)) {  // not friction: another torque on a resting joint
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

  /// Returns to the state after construction: no joint has moved.
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
  // The change was not friction: returns to the direction before it.
  void restore(int j) noexcept {
    direction_[j] = stop_direction_[j] = slow_[j];
    stop_level_[j] = level_[j];
  }

  static constexpr double kSmoothing = 0.01;  // time constant, since a sample's noise is not small beside friction [s]
  static constexpr double kSettling = 0.1;    // after it, the filtered torque shows the whole change [s]
  static constexpr double kMemory = 0.2;      // time constant of the average that gives d before a change [s]
  static constexpr double kBeyond = 2;        // up to twice the expected Coulomb friction is taken for friction
  static constexpr double kSteady = 0.5;      // acceleration below which the payload's torque counts as steady [m/s^2]

  Scalar rest_velocity_;
  Vector coulomb_;
  Scalar blend_, slow_blend_;
  int settling_;
  bool started_ = false;
  Vector direction_, stop_direction_, slow_;
  Vector level_, stop_level_;                 // smoothed tau: now, and when the joint stopped [N m]
  Eigen::Matrix<int, Dofs, 1> moved_, hold_;  // 1 if the joint moved in the last tick; ticks for which d stays
  Vector3<Scalar> acceleration_;              // smoothed, of the flange [m/s^2]
};

}  // namespace rme
