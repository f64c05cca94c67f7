#pragma once
/// Model of a joint's torque: its nuisances, how they change from block to block, and its noise.
#include <algorithm>
#include <cmath>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/bank/sensor_noise.hpp>
#include <rme/tracking/bank/star_gaussian.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme::bank {

/// What is known of a block in addition to its samples.
template <typename Scalar>
struct BlockContext {
  bool exchange_likely = false;  ///< the host says that the payload changes now
  bool kind_likely = true;       ///< the arm is not unlikely to have this bank's kind of torque sensing
  bool friction_shows = false;   ///< it is certain that tau_ext contains joint friction
  /// Change of the phi that is compensated, since the last block [kg, kg m, kg m^2].
  InertialVector<Scalar> compensation_change = InertialVector<Scalar>::Zero();
};

/// Model of the joints' torque for one kind of torque sensing: the nuisances' prior, their change from block to block,
/// and their regressor in a block (docs/theory.md, "Friction" and "What counts as unexplained"). observation() has the
/// regressor (T24) and the noise of dq (T29), predict() the residual (T27). With joint friction, the torque is
///
///     tau_j = h_j^T phi + offset - d coulomb - dq viscous + residual + s stiction + noise
///
/// with d the mean direction of motion and s the share of the block in which the joint rests. A rough model has the
/// same form, with larger errors. A link-side sensor sees no friction; there the torque is
///
///     tau_j = h_j^T phi + offset + lag dtau_ext,j/dt + residual + noise
///
/// The lag's regressor is zero until a block has shown that the torque is late (unexplained()). Real time: nothing
/// allocates.
template <typename Scalar, int Dofs>
class JointTorqueModel {
 public:
  using Star = StarGaussian<Scalar, Dofs>;  ///< state of a filter

  /// @param sensing      kind of torque sensing
  /// @param arm          sizes of noise, offset, residual and friction before the first sample
  /// @param inertia_arm  mean square distance of a payload's centre of mass from the end-effector origin [m^2]
  JointTorqueModel(Sensing sensing, const ArmPrior<Scalar, Dofs>& arm, Scalar inertia_arm) noexcept
      : sensing_(sensing), arm_(arm), inertia_arm_(inertia_arm), noise_(sensing, arm) {
    timing_noise_.setZero();
    inertia_noise_.setZero();
  }

  /// The nuisances' prior before the first sample, with an empty hand.
  Star prior() const noexcept {
    Star star;
    for (int j = 0; j < Dofs; ++j) {
      auto& joint = star.joint(j);
      joint.covariance(kOffset, kOffset) = arm_.offset[j] * arm_.offset[j];
      if (sensing_ == Sensing::LinkSide) {
        joint.covariance(kLag, kLag) = Scalar(kLagSpread * kLagSpread);
        continue;
      }
      joint.mean[kCoulomb] = arm_.coulomb[j];
      joint.mean[kViscous] = arm_.viscous[j];
      joint.covariance(kCoulomb, kCoulomb) = Scalar(0.25) * arm_.coulomb[j] * arm_.coulomb[j];
      joint.covariance(kViscous, kViscous) = Scalar(0.25) * arm_.viscous[j] * arm_.viscous[j];
      joint.covariance(kStiction, kStiction) = stiction_variance(star, j);
    }
    return star;
  }
  /// Starts a block. The calls below then refer to it.
  /// @param block    the next block
  /// @param regime   which joints rest in it
  /// @param context  what else is known of it. Unless friction_shows is set, a change of the torque while the arm rests
  ///                 is not taken for a change of friction
  void begin(const TorqueBlock<Scalar, Dofs>& block, const FrictionRegime<Scalar, Dofs>& regime,
             const BlockContext<Scalar>& context = {}) noexcept;
  /// Time update: changes the nuisances from the last block to this one. To be called before the update with the
  /// block's torque.
  void predict(Star& star) const noexcept;
  /// The measurement of joint j in this block.
  /// @param j     0 .. Dofs - 1
  /// @param mass  mass of the payload [kg]; the noise of dq makes a noise of its inertia force
  JointObservation<Scalar> observation(int j, Scalar mass) const noexcept;
  /// Variance that a jump of joint j's stiction would add in this block [(N m)^2]: a joint that rests while others move
  /// may come loose and stick again. 0 if the joint moves, if the whole arm rests, and with link-side sensing.
  /// @param star  has the joint's Coulomb friction
  /// @param j     0 .. Dofs - 1
  Scalar stiction_jump(const Star& star, int j) const noexcept {
    if (sensing_ == Sensing::LinkSide || regime_.joint(j).resting < 1 || !regime_.arm_moves()) return Scalar(0);
    return Scalar(6.25) * stiction_variance(star, j);
  }
  /// Whether the lag is one of the nuisances, as it is with link-side sensing.
  bool learns_lag() const noexcept { return sensing_ == Sensing::LinkSide; }
  /// Whether this is the model for Sensing::RoughModel.
  bool rough() const noexcept { return sensing_ == Sensing::RoughModel; }
  /// Resets the residuals and the stictions to their priors. Until a payload is noticed, these two may absorb its
  /// torque.
  void reopen_hiding(Star& star) const noexcept {
    for (int j = 0; j < Dofs; ++j) {
      renew(star, j, kResidual, Scalar(0), noise_.residual_variance(j));
      renew(star, j, kStiction, Scalar(0), stiction_variance(star, j));
    }
  }
  /// After a removal: makes the offsets less certain, if in each joint no more than a tenth of the payload's torque,
  /// plus five standard deviations, is left. While the payload was held, an error of the torque sensor's gain, 2 % of
  /// the payload's torque, was taken for offset. At most the offset's prior variance is added.
  /// @param star   state of Hypothesis::Empty, after predict() for this block
  /// @param held   phi of the removed payload
  /// @param share  probability that something was held in the block before, given that the hand is empty in this one
  void unload(Star& star, const InertialVector<Scalar>& held, Scalar share) const noexcept {
    using std::abs;
    using std::sqrt;
    JointVector<Scalar, Dofs> load = JointVector<Scalar, Dofs>::Zero();
    for (int j = 0; j < Dofs; ++j) {
      for (int i = 0; i < kInertial; ++i) load[j] += block_.regressor(j, i) * held[i];
      const auto p = star.predict(j, observation(j, Scalar(0)));
      if (!(abs(p.innovation) < Scalar(kGone) * abs(load[j]) + 5 * sqrt(p.variance))) return;
    }
    for (int j = 0; j < Dofs; ++j) {
      const Scalar off = std::min(Scalar(kGain) * abs(load[j]), arm_.offset[j]);
      star.joint(j).covariance(kOffset, kOffset) += share * off * off;
    }
  }
  /// Decides why a block soon after an exchange is badly explained: because the torque is late, or because something
  /// pushes. It is late if a lag of 21 ms could make innovations as large as these, at the torque's rate in this block
  /// or in the block before, whose error the filter has taken for payload. The observer's bandwidth is then not the
  /// stated one, or the torque is delayed: from the next block on, the lag is learned after each large change.
  /// @param innovation  e of each joint [N m]
  /// @param variance    S of each joint [(N m)^2], > 0
  /// @return whether the torque is late; always false unless learns_lag()
  bool unexplained(const JointVector<Scalar, Dofs>& innovation, const JointVector<Scalar, Dofs>& variance) noexcept {
    Scalar left = Scalar(0), lag = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      const Scalar most = Scalar(kLargestLag) * std::max(std::abs(block_.torque_rate[j]), std::abs(rate_before_[j]));
      left += innovation[j] * innovation[j] / variance[j];
      lag += most * most / variance[j];
    }
    if (!(learns_lag() && left < lag)) return false;
    late_ = true;
    watch_ = Scalar(kWatchLag);
    return true;
  }
  /// Adds the offsets' prior variances to their variances.
  void reopen_offset(Star& star) const noexcept {
    for (int j = 0; j < Dofs; ++j) star.joint(j).covariance(kOffset, kOffset) += arm_.offset[j] * arm_.offset[j];
  }

  /// Learns noise and residual from a block in which nothing happened; parameters as in SensorNoise::learn().
  void learn(bool empty, const JointVector<Scalar, Dofs>& innovation,
             const JointVector<Scalar, Dofs>& variance) noexcept {
    noise_.learn(empty, innovation, variance, block_, regime_);
  }
  void interrupt() noexcept { noise_.interrupt(); }                           ///< something happened in this block
  const SensorNoise<Scalar, Dofs>& noise() const noexcept { return noise_; }  ///< learned noise and residual
  const TorqueBlock<Scalar, Dofs>& block() const noexcept { return block_; }  ///< the block of the last begin()

 private:
  // An observer of 50 rad/s that is in truth half or twice as fast has a lag of 20 or -10 ms.
  static constexpr double kLagSpread = 0.015;   // prior standard deviation of the lag [s]
  static constexpr double kLargestLag = 0.021;  // largest lag; a push makes errors as a larger one would [s]
  static constexpr double kWatchLag = 0.6;      // how long the lag is learned after a large change [s]
  static constexpr double kGain = 0.02;         // relative error of a torque sensor's gain
  static constexpr double kGone = 0.1;          // share of the payload's torque that may be left after a removal
  // For a rough model, as multiples of the residual's variance: stiction; noise of a joint that starts, stops or turns
  // back; and further noise of such a joint at rest.
  static constexpr double kRoughStiction = 16;
  static constexpr double kTurnNoise = 6;
  static constexpr double kStopNoise = 20;

  /// One step of a first-order autoregressive process: nuisance n of joint j is multiplied by `keep`, and noise is
  /// added such that its stationary variance is `variance`.
  static void renew(Star& star, int j, Nuisance n, Scalar keep, Scalar variance) noexcept {
    auto& joint = star.joint(j);
    auto& V = joint.covariance;
    joint.mean[n] *= keep;
    for (int i = 0; i < kInertial; ++i) joint.slope(i, n) *= keep;
    for (int i = 0; i < kJointNuisances; ++i) V(i, n) *= keep;
    for (int i = 0; i < kJointNuisances; ++i) V(n, i) *= keep;
    V(n, n) += (Scalar(1) - keep * keep) * variance;
  }
  void follow_changes(const TorqueBlock<Scalar, Dofs>& block) noexcept;
  void follow_torque(const TorqueBlock<Scalar, Dofs>& block) noexcept;
  void follow_compensation(const TorqueBlock<Scalar, Dofs>& block, const BlockContext<Scalar>& context) noexcept;
  void turn(const TorqueBlock<Scalar, Dofs>& block) noexcept;
  /// Stationary variance of the stiction [(N m)^2]. The standard deviation is 0.6 of the prior's Coulomb friction, and
  /// at most the Coulomb friction that motion has shown; a rough model's has kRoughStiction instead of this bound.
  Scalar stiction_variance(const Star& star, int j) const noexcept {
    const Scalar off = Scalar(0.6) * arm_.coulomb[j];
    if (sensing_ == Sensing::RoughModel) return off * off + Scalar(kRoughStiction) * noise_.residual_variance(j);
    const Scalar mean = star.nuisance_mean(j)[kCoulomb];
    return std::min(off * off, mean * mean + star.joint(j).covariance(kCoulomb, kCoulomb));  // E[Coulomb^2]
  }
  Sensing sensing_;
  ArmPrior<Scalar, Dofs> arm_;
  Scalar inertia_arm_;
  SensorNoise<Scalar, Dofs> noise_;
  bool started_ = false, friction_shows_ = false;
  bool late_ = false;         // a block has shown that the torque is late
  Scalar watch_ = Scalar(0);  // how long the lag will still be learned [s]
  TorqueBlock<Scalar, Dofs> block_;
  FrictionRegime<Scalar, Dofs> regime_;
  JointVector<Scalar, Dofs> rate_before_ = JointVector<Scalar, Dofs>::Zero();  // last block's torque_rate [N m/s]
  // How far friction has turned over in this block, and the decaying maximum of that (turn()).
  JointVector<Scalar, Dofs> turned_ = JointVector<Scalar, Dofs>::Zero(), turning_ = JointVector<Scalar, Dofs>::Zero();
  // Per joint [N m]: average of the torque over the last 0.08 s; change of the motor's torque in this block
  // (follow_torque(), follow_compensation()); changes of the compensation that tau_ext does not show yet.
  JointVector<Scalar, Dofs> recent_torque_ = JointVector<Scalar, Dofs>::Zero();
  JointVector<Scalar, Dofs> torque_change_ = JointVector<Scalar, Dofs>::Zero();
  JointVector<Scalar, Dofs> pending_ = JointVector<Scalar, Dofs>::Zero();
  JointVector<Scalar, Dofs> timing_noise_, inertia_noise_;  // variances [(N m)^2], [(N m / kg)^2]
};

}  // namespace rme::bank

#include <rme/tracking/bank/joint_torque_model_impl.hpp>
