#pragma once
/// How the nuisances of the joints change from block to block.
#include <algorithm>
#include <cmath>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/sensing_kind.hpp>
#include <rme/tracking/sensor_noise.hpp>
#include <rme/tracking/star_gaussian.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

/// Offset and friction of a joint walk at random. Its residual, and the stiction that holds it while it rests, forget
/// and are drawn anew (docs/theory.md (T27)): the residual with the distance that the arm moves, the stiction with
/// time, and as the torque changes that it balances. Of a rough model, both change where a joint turns over, and so
/// does its noise.
///
/// A block comes in with begin(), and the time update of a filter's state goes out with predict(). Real time: nothing
/// allocates.
template <typename Scalar, int Dofs>
class NuisanceProcess {
 public:
  using Star = StarGaussian<Scalar, Dofs>;   ///< state of a filter
  using Torque = JointVector<Scalar, Dofs>;  ///< one number per joint
  using Noise = SensorNoise<Scalar, Dofs>;   ///< learned sizes of noise and residual

  /// @param kind  row of the kind of torque sensing
  /// @param arm   offset, residual and friction before the first sample, of an arm whose torque shows its friction
  NuisanceProcess(const SensingKind& kind, const ArmPrior<Scalar, Dofs>& arm) noexcept : kind_(kind), arm_(arm) {
    const auto share = static_cast<Scalar>(kind_.friction);
    arm_.coulomb *= share;
    arm_.viscous *= share;
  }

  /// Starts a block.
  /// @param block    the next block
  /// @param regime   which joints rest in it
  /// @param context  unless friction_shows is set, a change of the torque while the arm rests is not taken for a change of
  ///                 friction
  /// @param noise    of the torque
  void begin(const TorqueBlock<Scalar, Dofs>& block, const FrictionRegime<Scalar, Dofs>& regime,
             const BlockContext<Scalar, Dofs>& context, const Noise& noise) noexcept {
    follow_torque(block, noise);
    follow_compensation(block, context);
    turn(block);
    velocity_ = block.velocity;
    elapsed_ = block.elapsed();
    regime_ = regime;
    friction_shows_ = context.friction_shows;
    started_ = true;
  }
  /// Time update, from the last block to this one. To be called before the update with the block's torque.
  /// @param star   state
  /// @param noise  has the residual's variance
  /// @param more   what else the residual's variance contains [(N m)^2]
  void predict(Star& star, const Noise& noise, const Torque& more) const noexcept;

  /// Stationary variance of the stiction [(N m)^2]. The standard deviation is 0.6 of the prior's Coulomb friction, and
  /// at most the Coulomb friction that motion has shown; what the kind adds to it is in proportion to the residual.
  Scalar stiction_variance(const Star& star, int j, const Noise& noise) const noexcept {
    const Scalar off = Scalar(kStictionShare) * arm_.coulomb[j];
    const Scalar mean = star.nuisance_mean(j, kCoulomb);
    const Scalar shown = mean * mean + star.joint(j).covariance(kCoulomb, kCoulomb);  // E[Coulomb^2]
    return std::min(off * off, shown) + static_cast<Scalar>(kind_.stiction) * noise.residual_variance(j);
  }
  /// Variance that a jump of joint j's stiction would add in this block [(N m)^2]: a joint that rests while others move
  /// may come loose and stick again. 0 if the joint moves, if the whole arm rests, and if the torque shows no friction.
  Scalar stiction_jump(const Star& star, int j, const Noise& noise) const noexcept {
    if (regime_.joint(j).resting < 1 || !regime_.arm_moves()) return Scalar(0);
    return Scalar(kJump) * stiction_variance(star, j, noise);
  }
  /// How much of joint j's velocity v is motion, with its sign: -1 to 1.
  Scalar moves(int j) const noexcept {
    const Scalar v = velocity_[j], slow = static_cast<Scalar>(kind_.slow);
    return slow > 0 ? v / (std::abs(v) + slow) : regime_.joint(j).direction;
  }
  /// How much joint j rests, 0 to 1.
  Scalar rests(int j) const noexcept {
    return kind_.slow > 0 ? Scalar(1) - std::abs(moves(j)) : regime_.joint(j).resting;
  }
  /// Variance of the noise of a joint that starts, stops or turns back [(N m)^2].
  Scalar turn_variance(int j, const Noise& noise) const noexcept {
    return (static_cast<Scalar>(kind_.turn_noise) + static_cast<Scalar>(kind_.stop_noise) * rests(j)) * turning_[j] *
           noise.residual_variance(j) * noise.turn_scale();
  }
  const FrictionRegime<Scalar, Dofs>& regime() const noexcept { return regime_; }  ///< of the block
  const SensingKind& kind() const noexcept { return kind_; }           ///< row of the kind of torque sensing
  const ArmPrior<Scalar, Dofs>& arm() const noexcept { return arm_; }  ///< with the friction that it sees

 private:
  static constexpr double kStictionShare = 0.6;
  static constexpr double kJump = 6.25;  // variance of a jump of the stiction, in stiction variances

  /// One step of a first-order autoregressive process: nuisance n of joint j is multiplied by `keep`, and noise is
  /// added such that its stationary variance is `variance`.
  static void renew(Star& star, int j, Nuisance n, Scalar keep, Scalar variance) noexcept {
    auto& joint = star.joint(j);
    auto& V = joint.covariance;
    joint.mean[n] *= keep;
    for (int i = 0; i < kShared; ++i) joint.slope(i, n) *= keep;
    for (int i = 0; i < kJointNuisances; ++i) V(i, n) *= keep;
    for (int i = 0; i < kJointNuisances; ++i) V(n, i) *= keep;
    V(n, n) += (Scalar(1) - keep * keep) * variance;
  }
  /// Friction keeps about the torque that it had when joint j stopped.
  static void stop(Star& star, int j, Scalar last_direction) noexcept {
    auto& joint = star.joint(j);
    auto& V = joint.covariance;
    const Scalar d = Scalar(-0.95) * last_direction;
    joint.mean[kStiction] = d * joint.mean[kCoulomb];
    for (int i = 0; i < kShared; ++i) joint.slope(i, kStiction) = d * joint.slope(i, kCoulomb);
    for (int i = 0; i < kJointNuisances; ++i)
      if (i != kStiction) V(kStiction, i) = V(i, kStiction) = d * V(kCoulomb, i);
    const Scalar off = Scalar(0.15) * joint.mean[kCoulomb];
    V(kStiction, kStiction) = d * d * V(kCoulomb, kCoulomb) + off * off;
  }
  void follow_torque(const TorqueBlock<Scalar, Dofs>& block, const Noise& noise) noexcept;
  void follow_compensation(const TorqueBlock<Scalar, Dofs>& block, const BlockContext<Scalar, Dofs>& context) noexcept;
  void turn(const TorqueBlock<Scalar, Dofs>& block) noexcept;

  SensingKind kind_;
  ArmPrior<Scalar, Dofs> arm_;
  FrictionRegime<Scalar, Dofs> regime_;
  bool started_ = false, friction_shows_ = false;
  Scalar elapsed_ = Scalar(0);        // since the last block [s]
  Torque velocity_ = Torque::Zero();  // [rad/s]
  // How far friction has turned over in this block, and the decaying maximum of that (turn()).
  Torque turned_ = Torque::Zero(), turning_ = Torque::Zero();
  // Per joint [N m]: average of the torque over the last 0.08 s; change of the motor's torque in this block
  // (follow_torque(), follow_compensation()); changes of the compensation that tau_ext does not show yet.
  Torque recent_torque_ = Torque::Zero(), torque_change_ = Torque::Zero(), pending_ = Torque::Zero();
};

/// The friction of a resting joint balances all other torques: it changes when the motor's torque changes, and tau_ext
/// shows this change. The change per block is computed as for a ramp, from the difference between the torque and its
/// average over 0.08 s, less what noise may cause. So slow changes are noticed as well as sudden ones.
template <typename Scalar, int Dofs>
void NuisanceProcess<Scalar, Dofs>::follow_torque(const TorqueBlock<Scalar, Dofs>& block, const Noise& noise) noexcept {
  using std::abs;
  using std::sqrt;
  constexpr double kMemory = 0.08;  // time constant of the average [s]
  constexpr double kNoise = 3;      // standard deviations of a block's noise
  if (!started_) recent_torque_ = block.tau;
  const Scalar keep = Scalar(kMemory) / (Scalar(kMemory) + block.elapsed());
  for (int j = 0; j < Dofs; ++j) {
    recent_torque_[j] = keep * recent_torque_[j] + (Scalar(1) - keep) * block.tau[j];
    const Scalar ahead = abs(block.tau[j] - recent_torque_[j]) - Scalar(kNoise) * sqrt(noise.variance(j));
    torque_change_[j] = std::max(Scalar(0), ahead * (Scalar(1) - keep) / keep);
  }
}

/// If friction holds a joint, its torque changes by as much as the compensation does, whatever the hand holds. So the
/// joint seems to confirm any compensation. Slow changes of the compensation are lost in the noise of the torque, but
/// they are known.
template <typename Scalar, int Dofs>
void NuisanceProcess<Scalar, Dofs>::follow_compensation(const TorqueBlock<Scalar, Dofs>& block,
                                                        const BlockContext<Scalar, Dofs>& context) noexcept {
  using std::abs;
  using std::exp;
  constexpr double kDelay = 0.04;  // time constant until tau_ext shows a new compensation: drive, arm, observer [s]
  const Scalar keep = exp(-block.elapsed() / Scalar(kDelay));
  for (int j = 0; j < Dofs; ++j) {
    pending_[j] += abs(context.compensation_change[j]);
    if (context.friction_shows) torque_change_[j] += (Scalar(1) - keep) * pending_[j];
    pending_[j] *= keep;
  }
}

/// Computes how far each joint's friction has turned over since the last block: the change of v / (|v| + kTurns), which
/// is 1 from rest to fast motion and 2 for a reversal.
template <typename Scalar, int Dofs>
void NuisanceProcess<Scalar, Dofs>::turn(const TorqueBlock<Scalar, Dofs>& block) noexcept {
  using std::abs;
  using std::exp;
  constexpr double kTurns = 0.05;    // [rad/s]
  constexpr double kTurnTime = 0.2;  // time constant with which friction settles again [s]
  if (!started_) return;
  const Scalar keep = exp(-block.elapsed() / Scalar(kTurnTime));
  for (int j = 0; j < Dofs; ++j) {
    const auto direction = [](Scalar velocity) { return velocity / (abs(velocity) + Scalar(kTurns)); };
    turned_[j] = abs(direction(block.velocity[j]) - direction(velocity_[j]));
    turning_[j] = std::max(std::min(Scalar(1), turned_[j]), keep * turning_[j]);
  }
}

template <typename Scalar, int Dofs>
void NuisanceProcess<Scalar, Dofs>::predict(Star& star, const Noise& noise, const Torque& more) const noexcept {
  using std::exp;
  constexpr double kOffsetDrift = 2e-4;    // random walk of an offset per block, times the joint's scale [N m]
  constexpr double kFrictionDrift = 1e-4;  // random walk of friction per block, as a share of the prior's friction
  // The residual is a function of the pose: an Ornstein-Uhlenbeck process over the distance that the joints move (T27).
  const Scalar way = velocity_.norm() * elapsed_;
  const Scalar keep = exp(-way / static_cast<Scalar>(kind_.way));
  const Scalar hold = exp(-elapsed_ * static_cast<Scalar>(regime_.arm_moves() ? kind_.creep : kind_.creep_at_rest));
  for (int j = 0; j < Dofs; ++j) {
    auto& V = star.joint(j).covariance;
    const Scalar turned = static_cast<Scalar>(kind_.turn) * turned_[j];
    renew(star, j, kResidual, keep * exp(-turned), noise.residual_variance(j) + more[j]);
    const Scalar drift = Scalar(kOffsetDrift) * arm_.residual[j];
    V(kOffset, kOffset) += drift * drift;
    if (!(kind_.friction > 0)) continue;
    const Scalar coulomb_drift = Scalar(kFrictionDrift) * arm_.coulomb[j];
    const Scalar viscous_drift = Scalar(kFrictionDrift) * arm_.viscous[j];
    V(kCoulomb, kCoulomb) += coulomb_drift * coulomb_drift;
    V(kViscous, kViscous) += viscous_drift * viscous_drift;
    const JointFriction<Scalar>& friction = regime_.joint(j);
    if (kind_.slow > 0) {  // after each stop, friction holds the joint with another torque, which creeps
      renew(star, j, kStiction, hold * exp(Scalar(-0.5) * turned), stiction_variance(star, j, noise));
    } else if (friction.stops) {
      stop(star, j, friction.last_direction);
    } else if (regime_.rests(j)) {
      const Scalar change = regime_.arm_moves() || friction_shows_ ? torque_change_[j] : Scalar(0);
      renew(star, j, kStiction, hold * exp(-change / arm_.coulomb[j]), stiction_variance(star, j, noise));
    }
  }
}

}  // namespace rme
