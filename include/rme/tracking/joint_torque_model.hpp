#pragma once
/// Model of a joint's torque: what it contains, and how well that is known before the first block.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/base_tilt.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/nuisance_process.hpp>
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
/// nuisances, and their regressor in a block (docs/theory.md (T24)):
///
///     tau_j = h_j^T x + offset - d coulomb - dq viscous + residual + s stiction + gain load_j + noise
///
/// with d the mean direction of motion, s the share of the block in which the joint rests, and the load that it bears.
/// What a kind of sensing does not see has no variance. Real time: nothing allocates.
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
      : process_(kind, arm),
        rated_(rated_payload),
        inertia_arm_(inertia_arm),
        noise_(kind, arm),
        base_(gravity, rated_payload),
        gravity_(gravity) {}

  /// State before the first sample, with an empty hand.
  Star prior() const noexcept {
    Star star;
    const auto square = [](double x) { return static_cast<Scalar>(x * x); };
    Eigen::Matrix<Scalar, kArmShared, 1> shared;
    shared[kLag] = square(kind().lag);
    shared[kTool] = square(kind().tool) * rated_ * rated_;
    for (int i = 1; i < 4; ++i) shared[kTool + i] = square(kind().tool * kToolArm) * rated_ * rated_;
    shared[kTilt] = shared[kTilt + 1] = square(BaseTilt<Scalar, Dofs>::kLevelled);
    star.set_arm(shared);
    for (int j = 0; j < Dofs; ++j) {
      auto& joint = star.joint(j);
      joint.covariance(kOffset, kOffset) = arm().offset[j] * arm().offset[j];
      joint.mean[kCoulomb] = arm().coulomb[j];
      joint.mean[kViscous] = arm().viscous[j];
      const Scalar spread = arm().friction_std * arm().friction_std;
      joint.covariance(kCoulomb, kCoulomb) = spread * arm().coulomb[j] * arm().coulomb[j];
      joint.covariance(kViscous, kViscous) = spread * arm().viscous[j] * arm().viscous[j];
      joint.covariance(kStiction, kStiction) = process_.stiction_variance(star, j, noise_);
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
  /// Time update of the nuisances, from the last block to this one. To be called before the update with the block's
  /// torque.
  void predict(Star& star) const noexcept { process_.predict(star, noise_, unlike_variance(star)); }
  /// The base is tilted, so much that links that weigh other than usual ones show.
  /// @param star       before the first block
  /// @param deviation  standard deviation of each angle [rad]
  void tilt(Star& star, Scalar deviation) const noexcept {
    star.set_tilt(deviation);
    const Torque unlike = unlike_variance(star);
    for (int j = 0; j < Dofs; ++j) star.joint(j).covariance(kResidual, kResidual) += unlike[j];
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
      const Scalar off = std::min(drift * std::abs(torque), arm().offset[j]);
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
  /// NuisanceProcess::stiction_jump() in this block.
  Scalar stiction_jump(const Star& star, int j) const noexcept { return process_.stiction_jump(star, j, noise_); }
  /// Adds the offsets' prior variances to their variances.
  void reopen_offset(Star& star) const noexcept {
    for (int j = 0; j < Dofs; ++j) star.joint(j).covariance(kOffset, kOffset) += arm().offset[j] * arm().offset[j];
  }

  /// Learns noise and residual from a block in which nothing happened; parameters as in SensorNoise::learn().
  void learn(int payload, const Torque& innovation, const Torque& variance) noexcept {
    Torque turns;
    for (int j = 0; j < Dofs; ++j) turns[j] = process_.turn_variance(j, noise_);
    noise_.learn(payload, innovation, variance, block_, process_.regime(), turns);
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
  const SensingKind& kind() const noexcept { return process_.kind(); }  ///< row of the kind of torque sensing
  const ArmPrior<Scalar, Dofs>& arm() const noexcept {
    return process_.arm();
  }  ///< with the friction that the kind sees

 private:
  static constexpr double kGainDrift = 0.004;  // random walk of a torque sensor's gain [1/s^(1/2)]
  static constexpr double kToolArm = 0.1;      // spread of the tool error's first moment, per kg of its mass [m]

  /// Variance of what a tilt's torque has wrong if the links are usual ones [(N m)^2].
  Torque unlike_variance(const Star& star) const noexcept {
    if (block_.gravity_torque) return Torque::Zero();
    return BaseTilt<Scalar, Dofs>::unlike_variance(tilt_, star);
  }
  NuisanceProcess<Scalar, Dofs> process_;
  Scalar rated_, inertia_arm_;
  SensorNoise<Scalar, Dofs> noise_;
  bool started_ = false, tilted_ = false, exchange_likely_ = false;
  TorqueBlock<Scalar, Dofs> block_;
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
  const Scalar again = block.usual > 0 ? block.usual / block.duration - 1 : Scalar(0);
  for (int j = 0; j < Dofs; ++j) {
    const Scalar change = started_ ? share * (block.tau[j] - block_.tau[j]) : Scalar(0), step = block.torque_step[j];
    // A quantised torque is constant between two steps, so its rounding error stays the same for many blocks.
    timing_noise_[j] = change * change + Scalar(kSteps) * step * step + again * noise_.variance(j);
  }
  noise_.watch(block, timing_noise_);
  process_.begin(block, regime, context, noise_);
  started_ = true;
  // The error of the flange's acceleration makes an error of the payload's inertia force and moment (T29). The
  // payload's distance from the flange is the prior's, inertia_arm_. The joints' errors have one cause, which the
  // filter neglects: kCorrelated makes up for that.
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
  exchange_likely_ = context.exchange_likely;
}

template <typename Scalar, int Dofs>
JointObservation<Scalar> JointTorqueModel<Scalar, Dofs>::observation(int j, const Load<Scalar, Dofs>& load,
                                                                     bool swings) const noexcept {
  JointObservation<Scalar> o;
  o.torque = block_.tau[j];
  o.h[kLag] = block_.observer_time * block_.torque_rate[j];
  for (int i = 0; i < 4; ++i) o.h[kTool + i] = block_.regressor(j, i);
  for (int i = 0; i < 2; ++i) o.h[kTilt + i] = tilt_(j, i);
  for (int i = 0; i < kInertial; ++i) o.h[kPayload + i] = block_.regressor(j, i);
  for (int i = 0; i < 4; ++i) o.h[kPoured + i] = swings ? Scalar(0) : block_.regressor(j, i);
  for (int i = 0; swings && i < 3; ++i) o.h[kSwing + i] = block_.jacobian(i, j);
  // The product of tilt and weight is linearised about the load's. What usual links say of the tilt is too rough to
  // turn the weight by: there it only shows that the weight may be turned.
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
  o.c << 1, -process_.moves(j), -block_.velocity[j], 1, process_.rests(j), load.torque[j];
  o.noise += process_.turn_variance(j, noise_);
  // It is not known when in the block the joint started, stopped or turned back.
  const bool fades = kind().slow > 0;
  if (!fades && !process_.regime().joint(j).steady()) o.noise += Scalar(0.25) * arm().coulomb[j] * arm().coulomb[j];
  return o;
}

}  // namespace rme
