#pragma once
/// Whether each joint rests, moves, or does both within a block, and what friction may do there.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <rme/core/types.hpp>
#include <rme/tracking/star_gaussian.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

/// Dry friction of one joint in one block.
template <typename Scalar>
struct JointFriction {
  Scalar direction = Scalar(0);       ///< mean of sign(dq), 0 while it rests
  Scalar resting = Scalar(1);         ///< share of the block that it rests
  bool stops = false;                 ///< it has come to rest, having moved before
  Scalar last_direction = Scalar(0);  ///< in which it moved last; 0 if it never has
  /// Whether it rests, or moves in one direction, all through the block.
  bool steady() const noexcept { return resting == 1 || (resting == 0 && (direction == 1 || direction == -1)); }
};

/// Tells resting joints from moving ones. A joint moves if the mean of dq over a quarter of a block exceeds 1e-4 rad/s
/// and 4.5 standard deviations of its noise. One that moves more slowly than its noise shows counts as resting: what
/// held it when it stopped still holds it, and the direction of a joint that has never moved is 0. Taking noise for
/// motion would be worse: the friction would then seem to be the same in both directions, and be learned to be zero.
template <typename Scalar, int Dofs>
class FrictionRegime {
 public:
  /// Looks at the next block.
  void update(const TorqueBlock<Scalar, Dofs>& block) noexcept {
    using std::abs;
    using std::sqrt;
    const auto samples = static_cast<Scalar>(std::max(1, block.samples));
    for (int j = 0; j < Dofs; ++j) {
      const Scalar noise = block.velocity_noise[j];
      const Scalar threshold = std::max(Scalar(kMoves), Scalar(kDeviations) * sqrt(kBlockParts * noise / samples));
      JointFriction<Scalar>& joint = joints_[static_cast<std::size_t>(j)];
      const bool rested = joint_rests_[static_cast<std::size_t>(j)];
      int moving = 0;
      Scalar signs = Scalar(0);
      for (int i = 0; i < kBlockParts; ++i) {
        const Scalar v = block.velocities(j, i);
        if (!(abs(v) > threshold)) continue;
        ++moving;
        signs += v > 0 ? Scalar(1) : Scalar(-1);
        joint.last_direction = v > 0 ? Scalar(1) : Scalar(-1);
      }
      joint.direction = signs / kBlockParts;
      joint.resting = Scalar(1) - Scalar(moving) / kBlockParts;
      const bool rests = !(abs(block.velocities(j, kBlockParts - 1)) > threshold);
      joint.stops = rests && !rested;
      joint_rests_[static_cast<std::size_t>(j)] = rests;
    }
    // Noise of dq alone is no motion: three deviations of what it leaves of the norm of a block's mean.
    const Scalar noise = block.velocity_noise.sum() / samples;
    arm_moves_ = block.velocity.norm() > std::max(Scalar(kArmMoves), 3 * sqrt(noise));
  }
  /// Joint j in the last block.
  const JointFriction<Scalar>& joint(int j) const noexcept { return joints_[static_cast<std::size_t>(j)]; }
  /// Whether joint j rested at the end of the last block.
  bool rests(int j) const noexcept { return joint_rests_[static_cast<std::size_t>(j)]; }
  /// Whether any joint moves, so that what holds a resting one may change.
  bool arm_moves() const noexcept { return arm_moves_; }

  FrictionRegime() noexcept { joint_rests_.fill(true); }

 private:
  static constexpr double kMoves = 1e-4;      // [rad/s]
  static constexpr double kArmMoves = 1e-3;   // norm of dq [rad/s]
  static constexpr double kDeviations = 4.5;  // which the quarters of seven joints exceed once in two minutes
  std::array<JointFriction<Scalar>, static_cast<std::size_t>(Dofs)> joints_{};
  std::array<bool, static_cast<std::size_t>(Dofs)> joint_rests_{};
  bool arm_moves_ = false;
};

}  // namespace rme
