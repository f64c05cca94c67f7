#pragma once
/// How noisy an arm's torque is, and how far its rigid-body model is off: learned while the arm runs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

/// Learned from innovations of blocks in which nothing happens (docs/theory.md, "Noise and residual"; the noise is
/// (T25)).
///
/// Noise, per joint: half the mean square of the difference of two innovations in a row. Whatever lasts longer than a
/// block, be it an offset, friction, or a residual, cancels in it. If a joint
/// became much noisier, each block would look like an event, and nothing would be learned. So watch() looks for white
/// noise, which changes sign from block to block as no event does (T26).
///
/// Residual, one scale per joint: if it is right, innovations are white. If they are correlated with those before, the
/// residual is larger than assumed, and smaller if they are anticorrelated (Mehra, IEEE Trans. Automatic Control 1970).
/// Only blocks in which the arm moves count. The longer an arm has moved, the more slowly its residual is learned:
/// otherwise a pour would be learned as residual.
///
/// A rough model's residual has one scale for all joints, and is another one in each motion. It is smoother than the
/// tracker's, so that innovations would never be white, however large it is: there, innovations that are smaller than
/// their variance says count as well.
template <typename Scalar, int Dofs>
class SensorNoise {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint

  /// Learning begins at what the prior says.
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

  /// Variance of a block's mean torque [(N m)^2].
  Scalar variance(int j) const noexcept { return variance_[j]; }
  /// Variance of the model's residual [(N m)^2].
  Scalar residual_variance(int j) const noexcept {
    const Scalar s = residual_[j] * share_[j];
    return s * s;
  }

  /// Variance of the first moment [(kg m)^2] that the link which carries the payload may be off by, if it is as wrong as
  /// all joints' residuals say that links are (docs/theory.md (T28)). However long the arm moves, this cannot be told
  /// from the payload's. 0 for a rough model, whose payload is less certain for another reason (Tracker).
  Scalar first_moment_variance() const noexcept {
    if (rough_) return Scalar(0);
    Scalar sum = Scalar(0), scale = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      sum += residual_[j] * residual_[j] - static_cast<Scalar>(range_.least * range_.least);
      scale = std::max(scale, share_[j] / Scalar(kGravity));
    }
    return scale * scale * sum / Scalar(Dofs);
  }

  /// Notices that a joint has become noisier, whatever else happens: white torque turns back block after block, which
  /// neither a hand nor a pour does (docs/theory.md (T26)).
  /// @param block  the next one, each of them
  /// @param other  variance of other noise in it [(N m)^2]
  void watch(const TorqueBlock<Scalar, Dofs>& block, const Vector& other) noexcept {
    for (int j = 0; j < Dofs; ++j) {
      const Scalar slope = block.tau[j] - torque_[j], bend = slope - slope_[j];
      const Scalar turn = std::min(Scalar(kMost) * variance_[j], Scalar(-0.25) * bend * bend_[j]);
      torque_[j] = block.tau[j];
      slope_[j] = slope;
      bend_[j] = bend;
      zigzag_[j] += (std::max(-variance_[j], turn) - zigzag_[j]) / Scalar(kWatch);
      if (zigzag_[j] > Scalar(kNoisier) * (variance_[j] + other[j])) {
        variance_[j] = 2 * zigzag_[j];  // rather too much than too little: from here it is learned quickly
        blocks_[j] = std::min(blocks_[j], Scalar(kWatch));
      }
    }
  }

  /// Takes in a block of which it is sure that nothing happened in it.
  /// @param empty       which of the two hypotheses the innovations are of: those of two are not compared
  /// @param innovation  e [N m]
  /// @param variance    S of e [(N m)^2]
  /// @param block       that they are of
  /// @param regime      which joints rest in it
  void learn(bool empty, const Vector& innovation, const Vector& variance, const TorqueBlock<Scalar, Dofs>& block,
             const FrictionRegime<Scalar, Dofs>& regime) noexcept {
    using std::sqrt;
    if (empty != was_empty_) interrupt();
    was_empty_ = empty;
    const Scalar way = block.velocity.norm() * block.duration;
    const Scalar weight = std::min(Scalar(1), way / Scalar(kFullWay));
    const Scalar keep = static_cast<Scalar>(rough_ ? kRoughKeep : kKeep);
    const Scalar add = sqrt(Scalar(1) - keep * keep);  // white innovations have an average of variance 1
    Vector evidence;
    for (int j = 0; j < Dofs; ++j) {
      const bool steady = regime.joint(j).steady();
      const auto k = static_cast<std::size_t>(j);
      if (steady && usable_[k]) {
        const Scalar difference = innovation[j] - last_[j];
        // Single large differences are events, not noise.
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
  /// Something happens: the next block has no predecessor.
  void interrupt() noexcept { usable_.fill(false); }

 private:
  /// @param evidence  for a larger residual, of each joint
  /// @param weight    that the block has, 0 to 1
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

  // [N m] of the arm's scale; a sensor that shows less is not switched on, and will be noisier.
  static constexpr double kLeastNoise = 0.008;
  /// Of the arm's scale [N m]: where learning begins, and its bounds.
  struct Range {
    double first, least, largest;
  };
  // No rigid-body model is better than the least, whatever a few seconds of motion show. Link side and joint friction
  // begin and end alike: of two kinds, the one with the smaller residual would be believed of an arm that has none,
  // whether friction shows or not. A residual on a link-side arm that could absorb as much as friction would be one
  // more friction model, and a bad one.
  static constexpr Range kResidual[kSensings] = {{0.015, 0.005, 0.1}, {0.015, 0.005, 0.1}, {0.3, 0.1, 4}};
  static constexpr double kPriorBlocks = 5;  // that the prior counts for
  static constexpr double kWatch = 25;       // blocks that watch() looks back on
  static constexpr double kNoisier = 4;      // times the variance, which no hour of events and white noise shows
  static constexpr double kMost = 9;         // times the variance that one block may show: one event is not enough
  static constexpr double kMemory = 500;     // blocks: 10 s
  static constexpr double kFullWay = 0.002;  // [rad] in a block: 0.1 rad/s
  static constexpr double kOwn = 4;          // joints, as so many a joint's own evidence counts for its residual
  static constexpr double kStep = 0.05;      // of log variance per unit of correlation, at first
  static constexpr double kNew = 100;        // blocks of motion for which that is so
  static constexpr double kMotion = 1000;    // blocks of motion that are remembered: 20 s
  static constexpr double kKeep = 0.96;      // of a block: the average looks half a second back
  static constexpr double kRoughKeep = 0.9;  // 0.2 s
  static constexpr double kShare = 0.5;      // of the size of innovations, in the evidence
  static constexpr double kGravity = 9.81;   // [m/s^2]

  bool rough_;
  Vector share_, variance_, floor_, blocks_;
  Vector last_ = Vector::Zero(), average_ = Vector::Zero();
  Vector torque_ = Vector::Zero(), slope_ = Vector::Zero(), bend_ = Vector::Zero(), zigzag_ = Vector::Zero();
  std::array<bool, static_cast<std::size_t>(Dofs)> usable_{};
  Range range_;
  Vector residual_;            // [N m] of the arm's scale
  Scalar motion_ = Scalar(1);  // blocks
  bool was_empty_ = true;
};

}  // namespace rme
