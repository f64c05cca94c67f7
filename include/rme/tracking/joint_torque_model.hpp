#pragma once
/// Model of a joint's torque: its nuisances, how they change from block to block, and its noise.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/base_tilt.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/sensing_kind.hpp>
#include <rme/tracking/sensor_noise.hpp>
#include <rme/tracking/star_gaussian.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

/// What the joints bear beside the arm itself.
template <typename Scalar, int Dofs>
struct Load {
  Scalar mass = Scalar(0);                                                 ///< of the payload [kg]
  JointVector<Scalar, Dofs> torque = JointVector<Scalar, Dofs>::Zero();    ///< [N m]
  Vector4<Scalar> held = Vector4<Scalar>::Zero();                          ///< (m, m r) of the payload [kg, kg m]
  Eigen::Matrix<Scalar, 2, 1> tilt = Eigen::Matrix<Scalar, 2, 1>::Zero();  ///< of the base [rad]
};

/// Model of the joints' torque for one kind of torque sensing: the prior of what all joints share and of each joint's
/// nuisances, their change from block to block, and their regressor in a block (docs/theory.md (T24)):
///
///     tau_j = h_j^T x + offset - d coulomb - dq viscous + residual + s stiction + gain load_j + noise
///
/// with d the mean direction of motion, s the share of the block in which the joint rests, and the load that it bears. What
/// a kind of sensing does not see has no variance. Real time: nothing allocates.
template <typename Scalar, int Dofs>
class JointTorqueModel {
 public:
  using Star = StarGaussian<Scalar, Dofs>;   ///< state of a filter
  using Torque = JointVector<Scalar, Dofs>;  ///< one number per joint

  /// @param kind           row of the kind of torque sensing
  /// @param arm            sizes of noise, offset, residual and friction before the first sample
  /// @param rated_payload  [kg], > 0
  /// @param inertia_arm    mean square distance of a payload's centre of mass from the end-effector origin [m^2]
  /// @param gravity        g [m/s^2], world axes
  JointTorqueModel(const SensingKind& kind, const ArmPrior<Scalar, Dofs>& arm, Scalar rated_payload, Scalar inertia_arm,
                   const Vector3<Scalar>& gravity) noexcept
      : kind_(kind),
        arm_(arm),
        rated_(rated_payload),
        inertia_arm_(inertia_arm),
        noise_(kind_, arm),
        base_(gravity, rated_payload),
        gravity_(gravity) {
    const auto share = static_cast<Scalar>(kind_.friction);
    arm_.coulomb *= share;
    arm_.viscous *= share;
  }

  /// State before the first sample, with an empty hand.
  Star prior() const noexcept {
    Star star;
    const auto square = [](double x) { return static_cast<Scalar>(x * x); };
    Eigen::Matrix<Scalar, kArmShared, 1> shared;
    shared[kLag] = square(kind_.lag);
    shared[kTool] = square(kind_.tool) * rated_ * rated_;
    for (int i = 1; i < 4; ++i) shared[kTool + i] = square(kind_.tool * kToolArm) * rated_ * rated_;
    shared[kTilt] = shared[kTilt + 1] = square(BaseTilt<Scalar, Dofs>::kLevelled);
    star.set_arm(shared);
    for (int j = 0; j < Dofs; ++j) {
      auto& joint = star.joint(j);
      joint.covariance(kOffset, kOffset) = arm_.offset[j] * arm_.offset[j];
      joint.mean[kCoulomb] = arm_.coulomb[j];
      joint.mean[kViscous] = arm_.viscous[j];
      const Scalar spread = arm_.friction_std * arm_.friction_std;
      joint.covariance(kCoulomb, kCoulomb) = spread * arm_.coulomb[j] * arm_.coulomb[j];
      joint.covariance(kViscous, kViscous) = spread * arm_.viscous[j] * arm_.viscous[j];
      joint.covariance(kStiction, kStiction) = stiction_variance(star, j);
    }
    return star;
  }
  /// Starts a block. The calls below then refer to it.
  /// @param block    the next block
  /// @param regime   which joints rest in it
  /// @param context  what else is known of it. Unless friction_shows is set, a change of the torque while the arm rests
  ///                 is not taken for a change of friction
  /// @param tilted   whether any story has a tilted base
  void begin(const TorqueBlock<Scalar, Dofs>& block, const FrictionRegime<Scalar, Dofs>& regime,
             const BlockContext<Scalar, Dofs>& context = {}, bool tilted = false) noexcept;
  /// Time update: changes the nuisances from the last block to this one. To be called before the update with the
  /// block's torque.
  void predict(Star& star) const noexcept;
  /// The base is tilted, so much that links that weigh other than usual ones show.
  /// @param star       before the first block
  /// @param deviation  standard deviation of each angle [rad]
  void tilt(Star& star, Scalar deviation) const noexcept {
    star.set_tilt(deviation);
    const Torque unlike = unlike_variance(star);
    for (int j = 0; j < Dofs; ++j) star.joint(j).covariance(kResidual, kResidual) += unlike[j];
  }
  /// A payload that is taken up slowly is taken for friction and offset at first. Supposes that the empty hand of `star`
  /// already holds as much as they can have hidden so far.
  /// @param star  state, with an empty hand
  /// @param com    where its centre of mass is expected [m], end-effector axes
  void suppose_hidden(Star& star, const Vector3<Scalar>& com) const noexcept {
    InertialVector<Scalar> along = InertialVector<Scalar>::Zero();
    along[0] = 1;
    for (int i = 0; i < 3; ++i) along[1 + i] = com[i];
    std::array<typename Star::Beta, static_cast<std::size_t>(Dofs)> shift;
    Scalar precision = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      const JointObservation<Scalar> o = observation(j, Load<Scalar, Dofs>());
      Scalar torque = Scalar(0), able = Scalar(0);
      for (int i = 0; i < 4; ++i) torque += block_.regressor(j, i) * along[i];
      auto& absorbed = shift[static_cast<std::size_t>(j)];
      const auto V = star.nuisance_covariance(j);
      for (int n = 0; n < kJointNuisances; ++n) {
        absorbed[n] = V(n, n) * o.c[n];
        able += absorbed[n] * o.c[n];
      }
      absorbed *= -torque / (able + o.noise);
      precision += torque * torque / (able + o.noise);
    }
    const Scalar mass = Scalar(kHidden) / std::sqrt(std::max(precision, Scalar(1e-6)));
    for (auto& s : shift) s *= mass;
    star.suppose_payload(detail::scaled(mass, along), shift);
  }
  /// A payload has been removed. While it was held, a drift of the torque's gain was taken for one of the offset.
  /// @param star      state
  /// @param held      its phi
  /// @param held_for  for how long [s]
  void unload(Star& star, const InertialVector<Scalar>& held, Scalar held_for) const noexcept {
    const Scalar drift = Scalar(kGainDrift) * std::sqrt(held_for);
    for (int j = 0; j < Dofs; ++j) {
      Scalar torque = Scalar(0);
      for (int i = 0; i < 4; ++i) torque += block_.regressor(j, i) * held[i];
      const Scalar off = std::min(drift * std::abs(torque), arm_.offset[j]);
      star.joint(j).covariance(kOffset, kOffset) += off * off;
    }
  }
  /// The torque sensors have been zeroed in this pose, whatever the hand holds.
  void zero(Star& star) const noexcept {
    const Load<Scalar, Dofs> borne = load(star);
    for (int j = 0; j < Dofs; ++j) {
      const JointObservation<Scalar> o = observation(j, borne, star.swings());
      star.zero_torque(j, o, o.noise + star.nuisance_covariance(j)(kOffset, kOffset));
    }
  }
  /// What the joints bear in this block if they hold what `star` says.
  Load<Scalar, Dofs> load(const Star& star) const noexcept {
    Load<Scalar, Dofs> out;
    out.mass = std::min(std::max(star.mass(), Scalar(0)), rated_);
    if (star.empty()) return out;
    const InertialVector<Scalar> held = star.payload_mean();
    out.torque = detail::product(block_.regressor, held);
    out.held = held.template head<4>();
    out.tilt = star.mean().template segment<2>(kTilt);
    return out;
  }
  /// The measurement of joint j in this block.
  /// @param j       0 .. Dofs - 1
  /// @param load    about which the products of load and gain, and of weight and tilt, are linearised
  /// @param swings  whether the payload swings
  JointObservation<Scalar> observation(int j, const Load<Scalar, Dofs>& load, bool swings = false) const noexcept;
  /// Variance that a jump of joint j's stiction would add in this block [(N m)^2]: a joint that rests while others move
  /// may come loose and stick again. 0 if the joint moves, if the whole arm rests, and if the torque shows no friction.
  /// @param star  has the joint's Coulomb friction
  /// @param j     0 .. Dofs - 1
  Scalar stiction_jump(const Star& star, int j) const noexcept {
    if (regime_.joint(j).resting < 1 || !regime_.arm_moves()) return Scalar(0);
    return Scalar(kJump) * stiction_variance(star, j);
  }
  /// Adds the offsets' prior variances to their variances.
  void reopen_offset(Star& star) const noexcept {
    for (int j = 0; j < Dofs; ++j) star.joint(j).covariance(kOffset, kOffset) += arm_.offset[j] * arm_.offset[j];
  }

  /// Learns noise and residual from a block in which nothing happened; parameters as in SensorNoise::learn().
  void learn(int payload, const Torque& innovation, const Torque& variance) noexcept {
    Torque turns;
    for (int j = 0; j < Dofs; ++j) {
      const Scalar v = std::abs(block_.velocity[j]), slow = static_cast<Scalar>(kind_.slow);
      turns[j] = turn_variance(j, slow > 0 ? slow / (v + slow) : Scalar(0));
    }
    noise_.learn(payload, innovation, variance, block_, regime_, turns);
  }
  void interrupt() noexcept { noise_.interrupt(); }                           ///< something happened in this block
  const SensorNoise<Scalar, Dofs>& noise() const noexcept { return noise_; }  ///< learned noise and residual
  const TorqueBlock<Scalar, Dofs>& block() const noexcept { return block_; }  ///< the block of the last begin()
  /// Whether the host says that the payload changes now.
  bool exchange_likely() const noexcept { return exchange_likely_; }
  /// How far the end effector has gone up in the block of the last begin() [m].
  Scalar risen() const noexcept {
    Scalar along = Scalar(0);  // of the velocity, along gravity
    for (int j = 0; j < Dofs; ++j)
      for (int i = 0; i < 3; ++i) along += gravity_[i] * block_.jacobian(i, j) * block_.velocity[j];
    return -along * block_.elapsed() / std::sqrt(detail::dot(gravity_, gravity_));
  }
  const Vector3<Scalar>& gravity() const noexcept { return gravity_; }  ///< g [m/s^2], world axes
  const SensingKind& kind() const noexcept { return kind_; }            ///< row of the kind of torque sensing
  const ArmPrior<Scalar, Dofs>& arm() const noexcept { return arm_; }   ///< with the friction that the kind sees

 private:
  static constexpr double kGainDrift = 0.004;  // random walk of a torque sensor's gain [1/s^(1/2)]
  static constexpr double kStictionShare = 0.6;
  static constexpr double kHidden = 3;     // standard deviations of all joints together that may hide a payload
  static constexpr double kToolArm = 0.1;  // spread of the tool error's first moment, per kg of its mass [m]
  static constexpr double kJump = 6.25;    // variance of a jump of the stiction, in stiction variances

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
  void follow_torque(const TorqueBlock<Scalar, Dofs>& block) noexcept;
  void follow_compensation(const TorqueBlock<Scalar, Dofs>& block, const BlockContext<Scalar, Dofs>& context) noexcept;
  void turn(const TorqueBlock<Scalar, Dofs>& block) noexcept;
  /// Variance of what a tilt's torque has wrong if the links are usual ones [(N m)^2].
  Torque unlike_variance(const Star& star) const noexcept {
    if (block_.gravity_torque) return Torque::Zero();
    return BaseTilt<Scalar, Dofs>::unlike_variance(tilt_, star);
  }
  /// Stationary variance of the stiction [(N m)^2]. The standard deviation is 0.6 of the prior's Coulomb friction, and
  /// at most the Coulomb friction that motion has shown; what the kind adds to it is in proportion to the residual.
  Scalar stiction_variance(const Star& star, int j) const noexcept {
    const Scalar off = Scalar(kStictionShare) * arm_.coulomb[j];
    const Scalar mean = star.nuisance_mean(j)[kCoulomb];
    const Scalar shown = mean * mean + star.joint(j).covariance(kCoulomb, kCoulomb);  // E[Coulomb^2]
    return std::min(off * off, shown) + static_cast<Scalar>(kind_.stiction) * noise_.residual_variance(j);
  }
  /// Variance of the noise of a joint that starts, stops or turns back [(N m)^2].
  Scalar turn_variance(int j, Scalar rests) const noexcept {
    return (static_cast<Scalar>(kind_.turn_noise) + static_cast<Scalar>(kind_.stop_noise) * rests) * turning_[j] *
           noise_.residual_variance(j) * noise_.turn_scale();
  }
  SensingKind kind_;
  ArmPrior<Scalar, Dofs> arm_;
  Scalar rated_, inertia_arm_;
  SensorNoise<Scalar, Dofs> noise_;
  bool started_ = false, tilted_ = false, friction_shows_ = false, exchange_likely_ = false;
  TorqueBlock<Scalar, Dofs> block_;
  FrictionRegime<Scalar, Dofs> regime_;
  // How far friction has turned over in this block, and the decaying maximum of that (turn()).
  Torque turned_ = Torque::Zero(), turning_ = Torque::Zero();
  // Per joint [N m]: average of the torque over the last 0.08 s; change of the motor's torque in this block
  // (follow_torque(), follow_compensation()); changes of the compensation that tau_ext does not show yet.
  Torque recent_torque_ = Torque::Zero(), torque_change_ = Torque::Zero(), pending_ = Torque::Zero();
  BaseTilt<Scalar, Dofs> base_;
  Vector3<Scalar> gravity_;
  Eigen::Matrix<Scalar, Dofs, 2> tilt_ = Eigen::Matrix<Scalar, Dofs, 2>::Zero();  // d tau / d tilt [N m/rad]
  typename BaseTilt<Scalar, Dofs>::Weight turns_;                          // the same of what is held, if tilted_
  Torque timing_noise_ = Torque::Zero(), inertia_noise_ = Torque::Zero();  // variances [(N m)^2], [(N m / kg)^2]
};

template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::begin(const TorqueBlock<Scalar, Dofs>& block,
                                           const FrictionRegime<Scalar, Dofs>& regime,
                                           const BlockContext<Scalar, Dofs>& context, bool tilted) noexcept {
  constexpr double kCorrelated = 2.5;
  constexpr double kTiming = 0.0006;   // standard deviation of the torque's timing error [s]
  constexpr double kSteps = 8.0 / 12;  // variance of a rounding error, 1 / 12, times the blocks that it may last
  // Torque and motion may be a millisecond apart. And if the observer's bandwidth is not quite the stated one, its
  // inversion leaves a share of every change of the torque.
  const Scalar share = Scalar(kTiming) / block.duration;
  // In a block half as long as those from which noise is learned, white noise has twice the variance.
  const Scalar again = Scalar(block.begins ? 1 : 0);
  for (int j = 0; j < Dofs; ++j) {
    const Scalar change = started_ ? share * (block.tau[j] - block_.tau[j]) : Scalar(0), step = block.torque_step[j];
    // A quantised torque is constant between two steps, so its rounding error stays the same for many blocks.
    timing_noise_[j] = change * change + Scalar(kSteps) * step * step + again * noise_.variance(j);
  }
  noise_.watch(block, timing_noise_);
  follow_torque(block);
  follow_compensation(block, context);
  turn(block);
  started_ = true;
  // The error of the flange's acceleration makes an error of the payload's inertia force and moment (T29). The payload's
  // distance from the flange is the prior's, inertia_arm_. The joints' errors have one cause, which the filter neglects:
  // kCorrelated makes up for that.
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
  tilted_ = tilted;
  tilt_.setZero();
  if (tilted) {
    tilt_ = base_.regressor(block);
    turns_ = base_.weight(block);
  }
  block_ = block;
  regime_ = regime;
  friction_shows_ = context.friction_shows;
  exchange_likely_ = context.exchange_likely;
}

/// The friction of a resting joint balances all other torques: it changes when the motor's torque changes, and tau_ext
/// shows this change. The change per block is computed as for a ramp, from the difference between the torque and its
/// average over 0.08 s, less what noise may cause. So slow changes are noticed as well as sudden ones.
template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::follow_torque(const TorqueBlock<Scalar, Dofs>& block) noexcept {
  using std::abs;
  using std::sqrt;
  constexpr double kMemory = 0.08;  // time constant of the average [s]
  constexpr double kNoise = 3;      // standard deviations of a block's noise
  if (!started_) recent_torque_ = block.tau;
  const Scalar keep = Scalar(kMemory) / (Scalar(kMemory) + block.elapsed());
  for (int j = 0; j < Dofs; ++j) {
    recent_torque_[j] = keep * recent_torque_[j] + (Scalar(1) - keep) * block.tau[j];
    const Scalar ahead = abs(block.tau[j] - recent_torque_[j]) - Scalar(kNoise) * sqrt(noise_.variance(j));
    torque_change_[j] = std::max(Scalar(0), ahead * (Scalar(1) - keep) / keep);
  }
}

/// If friction holds a joint, its torque changes by as much as the compensation does, whatever the hand holds. So the
/// joint seems to confirm any compensation. Slow changes of the compensation are lost in the noise of the torque, but
/// they are known.
template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::follow_compensation(const TorqueBlock<Scalar, Dofs>& block,
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
void JointTorqueModel<Scalar, Dofs>::turn(const TorqueBlock<Scalar, Dofs>& block) noexcept {
  using std::abs;
  using std::exp;
  constexpr double kTurns = 0.05;    // [rad/s]
  constexpr double kTurnTime = 0.2;  // time constant with which friction settles again [s]
  if (!started_) return;
  const Scalar keep = exp(-block.elapsed() / Scalar(kTurnTime));
  for (int j = 0; j < Dofs; ++j) {
    const auto direction = [](Scalar velocity) { return velocity / (abs(velocity) + Scalar(kTurns)); };
    turned_[j] = abs(direction(block.velocity[j]) - direction(block_.velocity[j]));
    turning_[j] = std::max(std::min(Scalar(1), turned_[j]), keep * turning_[j]);
  }
}

template <typename Scalar, int Dofs>
void JointTorqueModel<Scalar, Dofs>::predict(Star& star) const noexcept {
  using std::exp;
  constexpr double kOffsetDrift = 2e-4;    // random walk of an offset per block, times the joint's scale [N m]
  constexpr double kFrictionDrift = 1e-4;  // random walk of friction per block, as a share of the prior's friction
  // The residual is a function of the pose: an Ornstein-Uhlenbeck process over the distance that the joints move (T27).
  const Scalar way = block_.velocity.norm() * block_.elapsed();
  const Scalar keep = exp(-way / static_cast<Scalar>(kind_.way));
  const Torque unlike = unlike_variance(star);
  const Scalar hold =
      exp(-block_.elapsed() * static_cast<Scalar>(regime_.arm_moves() ? kind_.creep : kind_.creep_at_rest));
  for (int j = 0; j < Dofs; ++j) {
    auto& joint = star.joint(j);
    auto& V = joint.covariance;
    const Scalar turned = static_cast<Scalar>(kind_.turn) * turned_[j];
    renew(star, j, kResidual, keep * exp(-turned), noise_.residual_variance(j) + unlike[j]);
    const Scalar drift = Scalar(kOffsetDrift) * arm_.residual[j];
    V(kOffset, kOffset) += drift * drift;
    if (!(kind_.friction > 0)) continue;
    const Scalar coulomb_drift = Scalar(kFrictionDrift) * arm_.coulomb[j];
    const Scalar viscous_drift = Scalar(kFrictionDrift) * arm_.viscous[j];
    V(kCoulomb, kCoulomb) += coulomb_drift * coulomb_drift;
    V(kViscous, kViscous) += viscous_drift * viscous_drift;
    if (kind_.slow > 0) {  // after each stop, friction holds the joint with another torque, which creeps
      renew(star, j, kStiction, hold * exp(Scalar(-0.5) * turned), stiction_variance(star, j));
      continue;
    }
    const JointFriction<Scalar>& friction = regime_.joint(j);
    if (friction.stops) {  // friction keeps about the torque that it had when the joint stopped
      const Scalar d = Scalar(-0.95) * friction.last_direction;
      joint.mean[kStiction] = d * joint.mean[kCoulomb];
      for (int i = 0; i < kShared; ++i) joint.slope(i, kStiction) = d * joint.slope(i, kCoulomb);
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
JointObservation<Scalar> JointTorqueModel<Scalar, Dofs>::observation(int j, const Load<Scalar, Dofs>& load,
                                                                     bool swings) const noexcept {
  using std::abs;
  JointObservation<Scalar> o;
  o.torque = block_.tau[j];
  o.h[kLag] = block_.observer_time * block_.torque_rate[j];
  for (int i = 0; i < 4; ++i) o.h[kTool + i] = block_.regressor(j, i);
  for (int i = 0; i < 2; ++i) o.h[kTilt + i] = tilt_(j, i);
  for (int i = 0; i < kInertial; ++i) o.h[kPayload + i] = block_.regressor(j, i);
  for (int i = 0; i < 4; ++i) o.h[kPoured + i] = swings ? Scalar(0) : block_.regressor(j, i);
  for (int i = 0; swings && i < 3; ++i) o.h[kSwing + i] = block_.jacobian(i, j);
  // The product of tilt and weight is linearised about the load's. What usual links say of the tilt is too rough to turn the
  // weight by: there it only shows that the weight may be turned.
  for (int k = 0; tilted_ && k < 2; ++k) {
    const auto& turns = turns_[static_cast<std::size_t>(k)];
    const Scalar turned = block_.gravity_torque ? load.tilt[k] : Scalar(0);
    Scalar shown = Scalar(0);
    for (int i = 0; i < 4; ++i) {
      shown += turns(j, i) * load.held[i];
      o.h[kPayload + i] += turns(j, i) * turned;
      if (!swings) o.h[kPoured + i] += turns(j, i) * turned;
    }
    o.h[kTilt + k] += shown;
    o.torque += shown * turned;
  }
  o.noise = noise_.variance(j) + timing_noise_[j] + load.mass * load.mass * inertia_noise_[j];
  const JointFriction<Scalar>& friction = regime_.joint(j);
  const Scalar v = block_.velocity[j], slow = static_cast<Scalar>(kind_.slow);
  const Scalar d = slow > 0 ? v / (abs(v) + slow) : friction.direction;
  const Scalar rests = slow > 0 ? Scalar(1) - abs(d) : friction.resting;
  o.c << 1, -d, -v, 1, rests, load.torque[j];
  o.noise += turn_variance(j, rests);
  // It is not known when in the block the joint started, stopped or turned back.
  if (!(slow > 0) && !friction.steady()) o.noise += Scalar(0.25) * arm_.coulomb[j] * arm_.coulomb[j];
  return o;
}

}  // namespace rme
