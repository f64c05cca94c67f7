#pragma once
/// What a joint's torque is made of besides the payload's, and how that changes from block to block.
#include <algorithm>
#include <cmath>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/sensor_noise.hpp>
#include <rme/tracking/star_gaussian.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

/// The nuisances' prior, how they change over a block, and how they enter a block's torque, for one kind of torque
/// sensing (docs/theory.md, "Friction" and "What counts as unexplained"; observation() is (T24), the residual in
/// predict() (T27), the noise of dq (T29)):
///
///     tau_j = h_j^T phi + offset - d coulomb - dq viscous + residual + s stiction + noise
///
/// with d the mean direction of motion and s the share of the block in which the joint rests. A link-side sensor sees no
/// friction; there it is
///
///     tau_j = h_j^T phi + offset + lag dtau_ext,j/dt + residual + noise
///
/// where the lag is zero until it has shown (unexplained()). Real time: nothing allocates.
template <typename Scalar, int Dofs>
class JointTorqueModel {
 public:
  using Star = StarGaussian<Scalar, Dofs>;  ///< what a filter is over

  /// @param sensing      kind of torque sensing
  /// @param arm          sizes before the first sample
  /// @param inertia_arm  mean square distance of a payload's mass from the flange [m^2]
  JointTorqueModel(Sensing sensing, const ArmPrior<Scalar, Dofs>& arm, Scalar inertia_arm) noexcept
      : sensing_(sensing), arm_(arm), inertia_arm_(inertia_arm), noise_(sensing, arm) {
    timing_noise_.setZero();
    inertia_noise_.setZero();
  }

  /// What is believed of the joints before the first sample; nothing is held.
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
  /// Starts a block: what follows is about it.
  /// @param block    the next one
  /// @param regime   which joints rest in it
  /// @param context  what else is known of it; unless friction is certain to show, what changes the torque of an arm
  ///                 that rests is not taken for its friction
  void begin(const TorqueBlock<Scalar, Dofs>& block, const FrictionRegime<Scalar, Dofs>& regime,
             const BlockContext<Scalar>& context = {}) noexcept;
  /// How the nuisances change over the block, before its torque is taken in.
  void predict(Star& star) const noexcept;
  /// @param j     0 .. Dofs - 1
  /// @param mass  that is held [kg]: noise of dq becomes noise of its inertia force
  JointObservation<Scalar> observation(int j, Scalar mass) const noexcept;
  /// Variance that a jump of a resting joint's stiction within the block would add: while other joints move, it may be
  /// anywhere within the friction that `star` expects [(N m)^2]. 0 if the joint moves or the arm rests.
  Scalar stiction_jump(const Star& star, int j) const noexcept {
    if (sensing_ == Sensing::LinkSide || regime_.joint(j).resting < 1 || !regime_.arm_moves()) return Scalar(0);
    return Scalar(6.25) * stiction_variance(star, j);
  }
  /// Whether the lag is a nuisance.
  bool learns_lag() const noexcept { return sensing_ == Sensing::LinkSide; }
  /// Whether the arm's model is taken to be rough.
  bool rough() const noexcept { return sensing_ == Sensing::RoughModel; }
  /// Resets to their priors what can hide a payload while it is not noticed: the residual, and what holds a joint at rest.
  void reopen_hiding(Star& star) const noexcept {
    for (int j = 0; j < Dofs; ++j) {
      renew(star, j, kResidual, Scalar(0), noise_.residual_variance(j));
      renew(star, j, kStiction, Scalar(0), stiction_variance(star, j));
    }
  }
  /// After a removal: if the payload's torque is missing in every joint, to within a tenth and five standard
  /// deviations, the offsets become less certain. An error of a torque sensor's gain, 2 % of that torque, seemed to be
  /// an offset while the payload was held. No offset becomes less certain than before the first sample.
  /// @param star   of the empty hand in this block, predicted
  /// @param held   phi that is gone
  /// @param share  weight of the part of the star that held something in the block before, 0 to 1
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
  /// A change of the torque is badly explained. If a lag would leave as much at the torque's rate, or made as much at the
  /// rate of the block before, which the payload has taken on, then what has been taken out of the torque is not its lag,
  /// or it comes late: from the next block on, the lag is learned from what follows a large change. Otherwise somebody
  /// pushes.
  /// @param innovation, variance  of each joint [N m, (N m)^2]
  /// @return whether the torque is late
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
  /// Adds the prior's variance to the offsets'.
  void reopen_offset(Star& star) const noexcept {
    for (int j = 0; j < Dofs; ++j) star.joint(j).covariance(kOffset, kOffset) += arm_.offset[j] * arm_.offset[j];
  }

  /// Learns from a block in which nothing happened (SensorNoise).
  void learn(bool empty, const JointVector<Scalar, Dofs>& innovation,
             const JointVector<Scalar, Dofs>& variance) noexcept {
    noise_.learn(empty, innovation, variance, block_, regime_);
  }
  void interrupt() noexcept { noise_.interrupt(); }                           ///< something happens: nothing is learned
  const SensorNoise<Scalar, Dofs>& noise() const noexcept { return noise_; }  ///< what has been learned
  const TorqueBlock<Scalar, Dofs>& block() const noexcept { return block_; }  ///< that begin() was given

 private:
  static constexpr double kLagSpread = 0.015;   // of an observer of 50 rad/s that is half or twice as fast as said [s]
  static constexpr double kLargestLag = 0.021;  // of an observer half as fast, and less than a push leaves [s]
  static constexpr double kWatchLag = 0.6;      // after a large change [s]
  static constexpr double kGain = 0.02;         // error of a torque sensor's gain
  static constexpr double kGone = 0.1;          // of a load, that may seem to be left where all of it has gone
  // Of the residual's variance, where the arm's model is rough: what gears hold at rest; the noise of a joint that
  // starts, stops or turns back; and what comes to it the slower the joint is.
  static constexpr double kRoughStiction = 16;
  static constexpr double kTurnNoise = 6;
  static constexpr double kStopNoise = 20;

  /// A step of a joint's nuisance n, which keeps this share of what it was and has this variance in the long run.
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
  /// Of what may hold a resting joint [(N m)^2]: 0.6 of the Coulomb friction to expect, and no more friction than
  /// motion has shown.
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
  bool late_ = false;         // torque and motion are not in time
  Scalar watch_ = Scalar(0);  // for which their lag is to be learned yet [s]
  TorqueBlock<Scalar, Dofs> block_;
  FrictionRegime<Scalar, Dofs> regime_;
  JointVector<Scalar, Dofs> rate_before_ =
      JointVector<Scalar, Dofs>::Zero();  // torque_rate of the block before [N m/s]
  // How far friction has turned over in this block, and lately (turn()).
  JointVector<Scalar, Dofs> turned_ = JointVector<Scalar, Dofs>::Zero(), turning_ = JointVector<Scalar, Dofs>::Zero();
  // Of each joint: its torque of late, and by how much that changes within this block beyond noise, or because the
  // compensation does; and changes of the compensation that are yet to reach it [N m].
  JointVector<Scalar, Dofs> recent_torque_ = JointVector<Scalar, Dofs>::Zero();
  JointVector<Scalar, Dofs> torque_change_ = JointVector<Scalar, Dofs>::Zero();
  JointVector<Scalar, Dofs> pending_ = JointVector<Scalar, Dofs>::Zero();
  JointVector<Scalar, Dofs> timing_noise_, inertia_noise_;  // [(N m)^2], [(N m / kg)^2]
};

}  // namespace rme

#include <rme/tracking/detail/joint_torque_model_impl.hpp>
