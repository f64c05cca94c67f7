#pragma once
/// The noise of an arm's torque and the size of its rigid-body model's residual, both learned while the arm runs.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/sensing_kind.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

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

  /// @param kind  row of the kind of torque sensing: first value and bounds of the residual, and how it is learned
  /// @param arm   first value of the noise, and scale of each joint
  SensorNoise(const SensingKind& kind, const ArmPrior<Scalar, Dofs>& arm) noexcept
      : kind_(kind), share_(arm.residual), residual_(Vector::Constant(static_cast<Scalar>(kind.residual))) {
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

  /// Size of the noise of joints that turn over, relative to the kind's.
  Scalar turn_scale() const noexcept { return turn_scale_; }

  /// s^2 of docs/theory.md (T28): variance of the error of a link's first moment in the arm's model [(kg m)^2],
  /// inferred from the residuals of all joints. However long the arm moves, this error of the link that carries the
  /// payload cannot be distinguished from the payload's first moment. 0 for a rough model, whose joints do not learn
  /// their own residuals: it says nothing of single links, and SensingKind::spread takes its place.
  Scalar first_moment_variance() const noexcept {
    if (!(kind_.own > 0)) return Scalar(0);
    Scalar sum = Scalar(0), scale = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      sum += residual_[j] * residual_[j] - static_cast<Scalar>(kind_.least_residual * kind_.least_residual);
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
  /// @param payload     which payload the innovations are for; those for different ones are not subtracted from each
  ///                    other
  /// @param innovation  e of each joint [N m]
  /// @param variance    S of each joint [(N m)^2], > 0
  /// @param block       the block
  /// @param regime      which joints rest in it
  /// @param turns       part of the variance that is due to joints turning over [(N m)^2]
  void learn(int payload, const Vector& innovation, const Vector& variance, const TorqueBlock<Scalar, Dofs>& block,
             const FrictionRegime<Scalar, Dofs>& regime, const Vector& turns) noexcept {
    using std::exp;
    using std::sqrt;
    Scalar turn_evidence = Scalar(0);
    if (payload != last_payload_) interrupt();
    last_payload_ = payload;
    const Scalar way = block.velocity.norm() * block.duration;
    const Scalar weight = std::min(Scalar(1), way / Scalar(kFullWay));
    const Scalar keep = static_cast<Scalar>(kind_.memory);
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
      turn_evidence += turns[j] / variance[j] * (white * white - 1);
      evidence[j] +=
          static_cast<Scalar>(kind_.size) * std::max(Scalar(0), 1 - variance_[j] / variance[j]) * (white * white - 1);
      average_[j] = keep * average_[j] + add * white;
    }
    learn_residual(evidence, weight);
    turn_scale_ *= exp(Scalar(0.5 * kStep) * std::max(Scalar(-6), std::min(Scalar(6), turn_evidence)));
    turn_scale_ = std::max(Scalar(0.01), std::min(Scalar(10), turn_scale_));
  }
  /// To be called after a block that is not learned from: the next innovation has no predecessor.
  void interrupt() noexcept { usable_.fill(false); }

 private:
  /// @param evidence  of each joint, > 0 for a larger residual
  /// @param weight    of the block, 0 to 1
  void learn_residual(const Vector& evidence, Scalar weight) noexcept {
    using std::exp;
    const auto settles = static_cast<Scalar>(kind_.settles);
    motion_ = std::min(motion_ + weight, 10 * settles);
    const Scalar pace = std::min(Scalar(1), settles / motion_);
    const Scalar all = static_cast<Scalar>(kind_.common) * evidence.sum();
    for (int j = 0; j < Dofs; ++j) {
      Scalar e = (all + static_cast<Scalar>(kind_.own) * evidence[j]) * weight;
      e = std::max(Scalar(-6), std::min(Scalar(6), e)) * pace;
      residual_[j] *= exp(Scalar(0.5 * kStep) * e);
      residual_[j] = std::max(static_cast<Scalar>(kind_.least_residual),
                              std::min(static_cast<Scalar>(kind_.largest_residual), residual_[j]));
    }
  }

  // Smallest standard deviation of the noise, times the joint's scale [N m]. A sensor that shows less is not switched
  // on yet, and will be noisier.
  static constexpr double kLeastNoise = 0.008;
  static constexpr double kPriorBlocks = 5;  // number of blocks for which the noise's prior counts
  static constexpr double kWatch = 25;       // memory of watch() in blocks: 0.5 s
  static constexpr double kNoisier = 4;      // times the noise variance: an hour of events and white noise stays below
  static constexpr double kMost = 9;         // times the noise variance, bound of one product: one event is not enough
  static constexpr double kMemory = 500;     // memory of the noise in blocks: 10 s
  static constexpr double kFullWay = 0.002;  // motion in a block from which it has full weight [rad]: 0.1 rad/s
  static constexpr double kStep = 0.05;      // change of the log variance per unit of evidence, at first
  static constexpr double kGravity = 9.81;   // [m/s^2]

  SensingKind kind_;
  Vector share_, variance_, floor_, blocks_;
  Vector last_ = Vector::Zero(), average_ = Vector::Zero();
  Vector torque_ = Vector::Zero(), slope_ = Vector::Zero(), bend_ = Vector::Zero(), zigzag_ = Vector::Zero();
  std::array<bool, static_cast<std::size_t>(Dofs)> usable_{};
  Vector residual_;  // standard deviation, times the joint's scale [N m]
  Scalar turn_scale_ = Scalar(1);
  Scalar motion_ = Scalar(1);  // blocks of motion, at most 10 kind_.settles
  int last_payload_ = 0;
};

}  // namespace rme
