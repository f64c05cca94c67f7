#pragma once
/// The noise of an arm's torque and the size of its rigid-body model's residual, both learned while the arm runs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme::bank {

/// Learns the variances of noise and residual from the innovations of blocks in which nothing happens (docs/theory.md,
/// "Noise and residual").
///
/// Noise, per joint: half the mean square of the difference of two successive innovations (T25). Errors that last
/// longer than a block cancel in this difference: offset, friction, residual. If a joint becomes much noisier, each
/// block looks like an event, and nothing would be learned. So watch() looks for white noise in all blocks: it changes
/// its sign from block to block, and the torque of an event does not (T26).
///
/// Residual, one standard deviation per joint: if it is right, innovations are white. If an innovation is correlated
/// with those before it, the residual is larger than assumed; if it is anticorrelated, the residual is smaller (Mehra,
/// IEEE Trans. Automatic Control 1970). Only blocks in which the arm moves count. The longer the arm has moved, the
/// more slowly the residual is learned: otherwise a pour would be learned as residual.
///
/// A rough model has one standard deviation for all joints, in proportion to their scales, and its residual is
/// different in each motion. The residual may be smoother than the filter assumes, so that no standard deviation makes
/// the innovations white. So the size of the innovations, compared with their variance, counts as well. Real time: no
/// call allocates.
template <typename Scalar, int Dofs>
class SensorNoise {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint

  /// @param sensing  kind of torque sensing; determines the first value and the bounds of the residual
  /// @param arm      first value of the noise, and scale of each joint
  SensorNoise(Sensing sensing, const ArmPrior<Scalar, Dofs>& arm) noexcept
      : rough_(sensing == Sensing::RoughModel),
        share_(arm.residual),
        range_(kResidual[static_cast<std::size_t>(sensing)]),
        residual_(Vector::Constant(static_cast<Scalar>(range_.first))) {
    for (int j = 0; j < Dofs; ++j) {
      const Scalar least = Scalar(kLeastNoise) * arm.residual[j];
      variance_[j] = arm.noise[j] * arm.noise[j];
      floor_[j] = least * least;
      blocks_[j] = Scalar(kPriorBlocks);
    }
  }

  /// Variance of the noise of joint j's mean torque over a block [(N m)^2].
  Scalar variance(int j) const noexcept { return variance_[j]; }
  /// Variance of joint j's residual [(N m)^2].
  Scalar residual_variance(int j) const noexcept {
    const Scalar s = residual_[j] * share_[j];
    return s * s;
  }

  /// s^2 of docs/theory.md (T28): variance of the error of a link's first moment in the arm's model [(kg m)^2],
  /// inferred from the residuals of all joints. However long the arm moves, this error of the link that carries the
  /// payload cannot be distinguished from the payload's first moment. 0 for a rough model, whose covariance Tracker
  /// increases in another way.
  Scalar first_moment_variance() const noexcept {
    if (rough_) return Scalar(0);
    Scalar sum = Scalar(0), scale = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      sum += residual_[j] * residual_[j] - static_cast<Scalar>(range_.least * range_.least);
      scale = std::max(scale, share_[j] / Scalar(kGravity));
    }
    return scale * scale * sum / Scalar(Dofs);
  }

  /// Notices that a joint has become much noisier, also during events: the torque's slope changes its sign from block
  /// to block, which neither a hand nor a pour causes (docs/theory.md (T26)). To be called for every block.
  /// @param block  the next block
  /// @param other  variance of further noise in each joint's torque [(N m)^2]
  void watch(const TorqueBlock<Scalar, Dofs>& block, const Vector& other) noexcept {
    for (int j = 0; j < Dofs; ++j) {
      const Scalar slope = block.tau[j] - torque_[j], bend = slope - slope_[j];
      const Scalar turn = std::min(Scalar(kMost) * variance_[j], Scalar(-0.25) * bend * bend_[j]);
      torque_[j] = block.tau[j];
      slope_[j] = slope;
      bend_[j] = bend;
      zigzag_[j] += (std::max(-variance_[j], turn) - zigzag_[j]) / Scalar(kWatch);
      if (zigzag_[j] > Scalar(kNoisier) * (variance_[j] + other[j])) {
        variance_[j] = 2 * zigzag_[j];  // rather too large than too small: it is learned quickly from here
        blocks_[j] = std::min(blocks_[j], Scalar(kWatch));
      }
    }
  }

  /// Learns from a block in which almost certainly nothing happened.
  /// @param empty       true if the innovations are of Hypothesis::Empty, false if they are of Steady. Innovations of
  ///                    different hypotheses are not subtracted from each other
  /// @param innovation  e of each joint [N m]
  /// @param variance    S of each joint [(N m)^2], > 0
  /// @param block       the block
  /// @param regime      which joints rest in it
  void learn(bool empty, const Vector& innovation, const Vector& variance, const TorqueBlock<Scalar, Dofs>& block,
             const FrictionRegime<Scalar, Dofs>& regime) noexcept {
    using std::sqrt;
    if (empty != was_empty_) interrupt();
    was_empty_ = empty;
    const Scalar way = block.velocity.norm() * block.duration;
    const Scalar weight = std::min(Scalar(1), way / Scalar(kFullWay));
    const Scalar keep = static_cast<Scalar>(rough_ ? kRoughKeep : kKeep);
    const Scalar add = sqrt(Scalar(1) - keep * keep);  // the average of white innovations has variance 1
    Vector evidence;
    for (int j = 0; j < Dofs; ++j) {
      const bool steady = regime.joint(j).steady();
      const auto k = static_cast<std::size_t>(j);
      if (steady && usable_[k]) {
        const Scalar difference = innovation[j] - last_[j];
        // A single large difference is an event, not noise.
        const Scalar square = std::min(Scalar(0.5) * difference * difference, 9 * variance_[j]);
        blocks_[j] = std::min(blocks_[j] + 1, Scalar(kMemory));
        variance_[j] = std::max(floor_[j], variance_[j] + (square - variance_[j]) / blocks_[j]);
      }
      last_[j] = innovation[j];
      usable_[k] = steady;
      const Scalar white = std::max(Scalar(-3), std::min(Scalar(3), innovation[j] / sqrt(variance[j])));
      evidence[j] = white * average_[j];
      if (rough_)
        evidence[j] += Scalar(kShare) * std::max(Scalar(0), 1 - variance_[j] / variance[j]) * (white * white - 1);
      average_[j] = keep * average_[j] + add * white;
    }
    learn_residual(evidence, weight);
  }
  /// To be called after a block that is not learned from: the next innovation has no predecessor.
  void interrupt() noexcept { usable_.fill(false); }

 private:
  /// @param evidence  of each joint, > 0 for a larger residual
  /// @param weight    of the block, 0 to 1
  void learn_residual(const Vector& evidence, Scalar weight) noexcept {
    using std::exp;
    if (!rough_) motion_ = std::min(motion_ + weight, Scalar(kMotion));
    const Scalar pace = rough_ ? Scalar(1) : std::min(Scalar(1), Scalar(kNew) / motion_);
    const Scalar all = evidence.sum();
    for (int j = 0; j < Dofs; ++j) {
      Scalar e = (rough_ ? all : Scalar(kOwn) * evidence[j]) * weight;
      e = std::max(Scalar(-6), std::min(Scalar(6), e)) * pace;
      residual_[j] *= exp(Scalar(0.5 * kStep) * e);
      residual_[j] =
          std::max(static_cast<Scalar>(range_.least), std::min(static_cast<Scalar>(range_.largest), residual_[j]));
    }
  }

  // Smallest standard deviation of the noise, times the joint's scale [N m]. A sensor that shows less is not switched
  // on yet, and will be noisier.
  static constexpr double kLeastNoise = 0.008;
  /// First value and bounds of the residual's standard deviation, times the joint's scale [N m].
  struct Range {
    double first, least, largest;
  };
  // No rigid-body model is better than `least`, whatever a few seconds of motion show. Link side and joint friction
  // have the same range. Otherwise, on an arm without a residual, the kind with the smaller one would win, whether
  // there is friction or not. With a larger bound, a link-side arm's residual could absorb friction, as a bad friction
  // model.
  static constexpr Range kResidual[kSensings] = {{0.015, 0.005, 0.1}, {0.015, 0.005, 0.1}, {0.3, 0.1, 4}};
  static constexpr double kPriorBlocks = 5;  // number of blocks for which the noise's prior counts
  static constexpr double kWatch = 25;       // memory of watch() in blocks: 0.5 s
  static constexpr double kNoisier = 4;      // times the noise variance: an hour of events and white noise stays below
  static constexpr double kMost = 9;         // times the noise variance, bound of one product: one event is not enough
  static constexpr double kMemory = 500;     // memory of the noise in blocks: 10 s
  static constexpr double kFullWay = 0.002;  // motion in a block from which it has full weight [rad]: 0.1 rad/s
  static constexpr double kOwn = 4;          // factor of a joint's evidence; a rough model has the sum over all joints
  static constexpr double kStep = 0.05;      // change of the log variance per unit of evidence, at first
  static constexpr double kNew = 100;        // blocks of motion after which the residual is learned more slowly: 2 s
  static constexpr double kMotion = 1000;    // blocks of motion from which the rate stays: 20 s, a tenth of the rate
  static constexpr double kKeep = 0.96;      // factor per block of the average of innovations: half a second
  static constexpr double kRoughKeep = 0.9;  // the same for a rough model: 0.2 s
  static constexpr double kShare = 0.5;      // weight of the innovations' size in the evidence of a rough model
  static constexpr double kGravity = 9.81;   // [m/s^2]

  bool rough_;
  Vector share_, variance_, floor_, blocks_;
  Vector last_ = Vector::Zero(), average_ = Vector::Zero();
  Vector torque_ = Vector::Zero(), slope_ = Vector::Zero(), bend_ = Vector::Zero(), zigzag_ = Vector::Zero();
  std::array<bool, static_cast<std::size_t>(Dofs)> usable_{};
  Range range_;
  Vector residual_;            // standard deviation, times the joint's scale [N m]
  Scalar motion_ = Scalar(1);  // blocks of motion, at most kMotion
  bool was_empty_ = true;
};

}  // namespace rme::bank
