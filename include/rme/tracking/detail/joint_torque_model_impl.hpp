#pragma once
/// What JointTorqueModel does with a block.
#include <algorithm>
#include <cmath>
#include <rme/tracking/joint_torque_model.hpp>

namespace rme {

template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::begin(const TorqueBlock<Scalar, Dofs>& block,
                                           const FrictionRegime<Scalar, Dofs>& regime,
                                           const BlockContext<Scalar>& context) noexcept {
  constexpr double kTiming = 0.0006;   // [s]
  constexpr double kSteps = 8.0 / 12;  // a step's variance, times the blocks that it may stay the same
  // tau and the motion that goes with it may be a millisecond apart; and the lag of an observer that is not quite what
  // it is said to be is left in as a share of every change.
  const Scalar share = Scalar(kTiming) / block.duration;
  for (int j = 0; j < Dofs; ++j) {
    const Scalar change = started_ ? share * (block.tau[j] - block_.tau[j]) : Scalar(0), step = block.torque_step[j];
    // Torque that comes in steps stands still between them: what it is off by stays for many blocks.
    timing_noise_[j] = change * change + Scalar(kSteps) * step * step;
  }
  noise_.watch(block, timing_noise_);
  follow_changes(block);
  follow_torque(block);
  follow_compensation(block, context);
  turn(block);
  if (started_) rate_before_ = block_.torque_rate;
  started_ = true;
  // Noise of dq at both ends of the block is noise of the flange's acceleration: of the force on the payload, and of
  // the moment that turns it, whose arm is the prior's.
  Scalar linear_noise = Scalar(0), angular_noise = Scalar(0);  // mean over the axes
  JointVector<Scalar, Dofs> lever, turn;                       // squares of the columns of J
  for (int j = 0; j < Dofs; ++j) {
    lever[j] = turn[j] = Scalar(0);
    for (int axis = 0; axis < 3; ++axis) {
      lever[j] += block.jacobian(axis, j) * block.jacobian(axis, j);
      turn[j] += block.jacobian(3 + axis, j) * block.jacobian(3 + axis, j);
    }
    linear_noise += lever[j] * block.velocity_noise[j] / 3;
    angular_noise += turn[j] * block.velocity_noise[j] / 3;
  }
  // The slope of n samples has 12 / n, that of a few samples what two ends make; and 2.5 times that, since the joints
  // all see the same noise, which is left out otherwise.
  const auto samples = static_cast<Scalar>(std::max(1, block.samples));
  const Scalar difference = Scalar(2.5) * std::min(Scalar(2), Scalar(12) / samples) / (block.duration * block.duration);
  const Scalar linear = difference * linear_noise, angular = difference * angular_noise;
  for (int j = 0; j < Dofs; ++j)
    inertia_noise_[j] = linear * lever[j] + (linear * inertia_arm_ + angular * inertia_arm_ * inertia_arm_) * turn[j];
  block_ = block;
  regime_ = regime;
  friction_shows_ = context.friction_shows;
}

/// Once the torque is known to be late, each large change shows by how much. Without one, noise that is in the torque
/// and in its rate alike would be taken for a lag.
template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::follow_changes(const TorqueBlock<Scalar, Dofs>& block) noexcept {
  constexpr double kLarge = 20;  // standard deviations of a block's noise
  watch_ = std::max(Scalar(0), watch_ - block.duration);
  for (int j = 0; j < Dofs && late_; ++j) {
    const Scalar change = block.torque_rate[j] * block.duration;
    if (change * change > Scalar(kLarge * kLarge) * noise_.variance(j)) watch_ = Scalar(kWatchLag);
  }
}

/// A joint that rests balances whatever comes: its torque changes as that of its motor does, and its friction with it.
/// The change is that of a ramp which is as far ahead of its average over a tenth of a second, without what noise may
/// be: slow changes show as well as sudden ones.
template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::follow_torque(const TorqueBlock<Scalar, Dofs>& block) noexcept {
  using std::abs;
  using std::sqrt;
  constexpr double kMemory = 0.08;  // [s]
  constexpr double kNoise = 1.5;    // standard deviations of a block's, nearly two of the distance's
  if (!started_) recent_torque_ = block.tau;
  const Scalar keep = Scalar(kMemory) / (Scalar(kMemory) + block.duration);
  for (int j = 0; j < Dofs; ++j) {
    recent_torque_[j] = keep * recent_torque_[j] + (Scalar(1) - keep) * block.tau[j];
    const Scalar ahead = abs(block.tau[j] - recent_torque_[j]) - Scalar(kNoise) * sqrt(noise_.variance(j));
    torque_change_[j] = std::max(Scalar(0), ahead * (Scalar(1) - keep) / keep);
  }
}

/// So a resting joint confirms any compensation: by as much as that grows, the joint's torque does, whatever is held.
/// Slow changes are lost in the noise of the torque, but they are known beforehand.
template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::follow_compensation(const TorqueBlock<Scalar, Dofs>& block,
                                                         const BlockContext<Scalar>& context) noexcept {
  using std::abs;
  using std::exp;
  constexpr double kDelay = 0.04;  // until a new compensation shows in tau_ext: drive, arm and observer [s]
  const Scalar keep = exp(-block.duration / Scalar(kDelay));
  for (int j = 0; j < Dofs; ++j) {
    Scalar torque = Scalar(0);
    for (int i = 0; i < kInertial; ++i) torque += block.regressor(j, i) * context.compensation_change[i];
    pending_[j] += abs(torque);
    if (context.friction_shows) torque_change_[j] += (Scalar(1) - keep) * pending_[j];
    pending_[j] *= keep;
  }
}

/// How far each joint's friction has turned over: a change of v / (|v| + kSlow), 1 from rest to motion, 2 for a
/// reversal.
template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::turn(const TorqueBlock<Scalar, Dofs>& block) noexcept {
  using std::abs;
  using std::exp;
  constexpr double kSlow = 0.05;     // [rad/s]
  constexpr double kTurnTime = 0.2;  // that it takes friction to settle [s]
  if (!started_) return;
  const Scalar keep = exp(-block.duration / Scalar(kTurnTime));
  for (int j = 0; j < Dofs; ++j) {
    const auto direction = [](Scalar velocity) { return velocity / (abs(velocity) + Scalar(kSlow)); };
    turned_[j] = abs(direction(block.velocity[j]) - direction(block_.velocity[j]));
    turning_[j] = std::max(std::min(Scalar(1), turned_[j]), keep * turning_[j]);
  }
}

/// How the nuisances change over a block, before its torque is taken in.
template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::predict(Star& star) const noexcept {
  using std::exp;
  // The residual is a function of the pose: an Ornstein-Uhlenbeck process over the way that the joints have gone.
  constexpr double kCorrelationWay = 0.7;  // [rad]
  constexpr double kRoughWay = 1.2;
  constexpr double kCreepTime = 2;         // in which friction of a rough arm at rest creeps [s]
  constexpr double kOffsetDrift = 2e-4;    // of the arm's scale, per block [N m]
  constexpr double kFrictionDrift = 1e-4;  // of friction itself, per block: it changes as the gears warm up
  constexpr double kStictionTime = 20;     // [s]
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
    if (rough) {  // what holds a joint that stops is another torque each time, and creeps
      renew(star, j, kStiction, hold * exp(Scalar(-0.5) * turned_[j]), stiction_variance(star, j));
      continue;
    }
    const JointFriction<Scalar>& friction = regime_.joint(j);
    if (friction.stops) {  // what held it until it stopped holds it still, or nearly so
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
  constexpr double kSlow = 0.003;  // where a rough arm's friction goes from stiction to that of motion [rad/s]
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
  if (!friction.steady()) o.noise += Scalar(0.25) * arm_.coulomb[j] * arm_.coulomb[j];  // when within the block?
  return o;
}

}  // namespace rme
