#pragma once
/// How JointTorqueModel processes a block.
#include <algorithm>
#include <cmath>
#include <rme/tracking/bank/joint_torque_model.hpp>

namespace rme::bank {

template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::begin(const TorqueBlock<Scalar, Dofs>& block,
                                           const FrictionRegime<Scalar, Dofs>& regime,
                                           const BlockContext<Scalar>& context) noexcept {
  constexpr double kTiming = 0.0006;   // standard deviation of the torque's timing error [s]
  constexpr double kSteps = 8.0 / 12;  // variance of a rounding error, 1 / 12, times the blocks that it may last
  // Torque and motion may be a millisecond apart. And if the observer's bandwidth is not quite the stated one, its
  // inversion leaves a share of every change of the torque.
  const Scalar share = Scalar(kTiming) / block.duration;
  for (int j = 0; j < Dofs; ++j) {
    const Scalar change = started_ ? share * (block.tau[j] - block_.tau[j]) : Scalar(0), step = block.torque_step[j];
    // A quantised torque is constant between two steps, so its rounding error stays the same for many blocks.
    timing_noise_[j] = change * change + Scalar(kSteps) * step * step;
  }
  noise_.watch(block, timing_noise_);
  follow_changes(block);
  follow_torque(block);
  follow_compensation(block, context);
  turn(block);
  if (started_) rate_before_ = block_.torque_rate;
  started_ = true;
  // The error of the flange's acceleration makes an error of the payload's inertia force and moment (T29). The payload's
  // distance from the flange is the prior's, inertia_arm_. The joints' errors have one cause, which the filter neglects:
  // kCorrelated makes up for that.
  constexpr double kCorrelated = 2.5;
  const Scalar linear = Scalar(kCorrelated) * block.acceleration_variance;
  const Scalar angular = Scalar(kCorrelated) * block.angular_acceleration_variance;
  for (int j = 0; j < Dofs; ++j) {
    Scalar lever = Scalar(0), turn = Scalar(0);  // squared norms of the columns of J_v and J_w
    for (int axis = 0; axis < 3; ++axis) {
      lever += block.jacobian(axis, j) * block.jacobian(axis, j);
      turn += block.jacobian(3 + axis, j) * block.jacobian(3 + axis, j);
    }
    inertia_noise_[j] = linear * lever + (linear * inertia_arm_ + angular * inertia_arm_ * inertia_arm_) * turn;
  }
  block_ = block;
  regime_ = regime;
  friction_shows_ = context.friction_shows;
}

/// Once the torque is known to be late, each large change of it shows by how much. The lag is learned only for a while
/// after such a change: noise is in the torque and in its rate alike, and would be taken for a lag.
template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::follow_changes(const TorqueBlock<Scalar, Dofs>& block) noexcept {
  constexpr double kLarge = 20;  // in standard deviations of a block's noise
  watch_ = std::max(Scalar(0), watch_ - block.duration);
  for (int j = 0; j < Dofs && late_; ++j) {
    const Scalar change = block.torque_rate[j] * block.duration;
    if (change * change > Scalar(kLarge * kLarge) * noise_.variance(j)) watch_ = Scalar(kWatchLag);
  }
}

/// The friction of a resting joint balances all other torques: it changes when the motor's torque changes, and tau_ext
/// shows this change. The change per block is computed as for a ramp, from the difference between the torque and its
/// average over 0.08 s, less what noise may cause. So slow changes are noticed as well as sudden ones.
template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::follow_torque(const TorqueBlock<Scalar, Dofs>& block) noexcept {
  using std::abs;
  using std::sqrt;
  constexpr double kMemory = 0.08;  // time constant of the average [s]
  constexpr double kNoise = 1.5;    // standard deviations of a block's noise: nearly two of the difference's noise
  if (!started_) recent_torque_ = block.tau;
  const Scalar keep = Scalar(kMemory) / (Scalar(kMemory) + block.duration);
  for (int j = 0; j < Dofs; ++j) {
    recent_torque_[j] = keep * recent_torque_[j] + (Scalar(1) - keep) * block.tau[j];
    const Scalar ahead = abs(block.tau[j] - recent_torque_[j]) - Scalar(kNoise) * sqrt(noise_.variance(j));
    torque_change_[j] = std::max(Scalar(0), ahead * (Scalar(1) - keep) / keep);
  }
}

/// If friction holds a joint, its torque changes by as much as the compensation does, whatever the hand holds. So the
/// joint seems to confirm any compensation. Slow changes of the compensation are lost in the noise of the torque, but
/// the tracker knows them: they follow from the change of its estimate.
template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::follow_compensation(const TorqueBlock<Scalar, Dofs>& block,
                                                         const BlockContext<Scalar>& context) noexcept {
  using std::abs;
  using std::exp;
  constexpr double kDelay = 0.04;  // time constant until tau_ext shows a new compensation: drive, arm, observer [s]
  const Scalar keep = exp(-block.duration / Scalar(kDelay));
  for (int j = 0; j < Dofs; ++j) {
    Scalar torque = Scalar(0);
    for (int i = 0; i < kInertial; ++i) torque += block.regressor(j, i) * context.compensation_change[i];
    pending_[j] += abs(torque);
    if (context.friction_shows) torque_change_[j] += (Scalar(1) - keep) * pending_[j];
    pending_[j] *= keep;
  }
}

/// Computes how far each joint's friction has turned over since the last block: the change of v / (|v| + kSlow), which
/// is 1 from rest to fast motion and 2 for a reversal.
template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::turn(const TorqueBlock<Scalar, Dofs>& block) noexcept {
  using std::abs;
  using std::exp;
  constexpr double kSlow = 0.05;     // [rad/s]
  constexpr double kTurnTime = 0.2;  // time constant with which friction settles again [s]
  if (!started_) return;
  const Scalar keep = exp(-block.duration / Scalar(kTurnTime));
  for (int j = 0; j < Dofs; ++j) {
    const auto direction = [](Scalar velocity) { return velocity / (abs(velocity) + Scalar(kSlow)); };
    turned_[j] = abs(direction(block.velocity[j]) - direction(block_.velocity[j]));
    turning_[j] = std::max(std::min(Scalar(1), turned_[j]), keep * turning_[j]);
  }
}

/// Time update of the nuisances.
template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::predict(Star& star) const noexcept {
  using std::exp;
  // The residual is a function of the pose: an Ornstein-Uhlenbeck process over the distance that the joints move (T27).
  constexpr double kCorrelationWay = 0.7;  // correlation length of the residual [rad]
  constexpr double kRoughWay = 1.2;        // the same for a rough model [rad]
  constexpr double kCreepTime = 2;         // time constant of a rough model's stiction [s]
  constexpr double kOffsetDrift = 2e-4;    // random walk of an offset per block, times the joint's scale [N m]
  constexpr double kFrictionDrift = 1e-4;  // random walk of friction per block, as a share of the prior's friction
  constexpr double kStictionTime = 20;     // time constant of the stiction while the arm moves [s]
  const bool rough = sensing_ == Sensing::RoughModel;
  const Scalar way = block_.velocity.norm() * block_.duration;
  const Scalar keep = exp(-way / Scalar(rough ? kRoughWay : kCorrelationWay));
  const Scalar hold = rough                 ? exp(-block_.duration / Scalar(kCreepTime))
                      : regime_.arm_moves() ? exp(-block_.duration / Scalar(kStictionTime))
                                            : Scalar(1);
  for (int j = 0; j < Dofs; ++j) {
    auto& joint = star.joint(j);
    auto& V = joint.covariance;
    renew(star, j, kResidual, rough ? keep * exp(-turned_[j]) : keep, noise_.residual_variance(j));
    const Scalar drift = Scalar(kOffsetDrift) * arm_.residual[j];
    V(kOffset, kOffset) += drift * drift;
    if (sensing_ == Sensing::LinkSide) continue;
    const Scalar coulomb_drift = Scalar(kFrictionDrift) * arm_.coulomb[j];
    const Scalar viscous_drift = Scalar(kFrictionDrift) * arm_.viscous[j];
    V(kCoulomb, kCoulomb) += coulomb_drift * coulomb_drift;
    V(kViscous, kViscous) += viscous_drift * viscous_drift;
    if (rough) {  // after each stop, friction holds the joint with another torque, which creeps
      renew(star, j, kStiction, hold * exp(Scalar(-0.5) * turned_[j]), stiction_variance(star, j));
      continue;
    }
    const JointFriction<Scalar>& friction = regime_.joint(j);
    if (friction.stops) {  // friction keeps about the torque that it had when the joint stopped
      const Scalar d = Scalar(-0.95) * friction.last_direction;
      joint.mean[kStiction] = d * joint.mean[kCoulomb];
      for (int i = 0; i < kInertial; ++i) joint.slope(i, kStiction) = d * joint.slope(i, kCoulomb);
      for (int i = 0; i < kJointNuisances; ++i)
        if (i != kStiction) V(kStiction, i) = V(i, kStiction) = d * V(kCoulomb, i);
      const Scalar off = Scalar(0.15) * joint.mean[kCoulomb];
      V(kStiction, kStiction) = d * d * V(kCoulomb, kCoulomb) + off * off;
    } else if (regime_.rests(j)) {
      const Scalar change = regime_.arm_moves() || friction_shows_ ? torque_change_[j] : Scalar(0);
      renew(star, j, kStiction, hold * exp(-change / arm_.coulomb[j]), stiction_variance(star, j));
    }
  }
}

template <typename Scalar, int Dofs>
JointObservation<Scalar> JointTorqueModel<Scalar, Dofs>::observation(int j, Scalar mass) const noexcept {
  using std::abs;
  constexpr double kSlow = 0.003;  // where a rough model's friction is half stiction, half friction of motion [rad/s]
  JointObservation<Scalar> o;
  o.torque = block_.tau[j];
  for (int i = 0; i < kInertial; ++i) o.h[i] = block_.regressor(j, i);
  o.noise = noise_.variance(j) + timing_noise_[j] + mass * mass * inertia_noise_[j];
  if (sensing_ == Sensing::LinkSide) {
    o.c << 1, 0, watch_ > 0 ? block_.torque_rate[j] : Scalar(0), 1, 0;
    return o;
  }
  if (sensing_ == Sensing::RoughModel) {
    const Scalar v = block_.velocity[j], d = v / (abs(v) + Scalar(kSlow));
    o.c << 1, -d, -v, 1, Scalar(1) - abs(d);
    o.noise += (Scalar(kTurnNoise) + Scalar(kStopNoise) * o.c[kStiction]) * turning_[j] * noise_.residual_variance(j);
    return o;
  }
  const JointFriction<Scalar>& friction = regime_.joint(j);
  o.c << 1, -friction.direction, -block_.velocity[j], 1, friction.resting;
  // It is not known when in the block the joint started, stopped or turned back.
  if (!friction.steady()) o.noise += Scalar(0.25) * arm_.coulomb[j] * arm_.coulomb[j];
  return o;
}

}  // namespace rme::bank
