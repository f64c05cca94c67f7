#pragma once
/// Whether each joint rests, moves, or does both within a block.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <rme/core/types.hpp>
#include <rme/tracking/star_gaussian.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

/// State of motion of one joint in one block, which determines its dry friction.
template <typename Scalar>
struct JointFriction {
  Scalar direction = Scalar(0);       ///< mean of sign(dq) over the block, where rest counts 0; -1 to 1
  Scalar resting = Scalar(1);         ///< share of the block in which the joint rests, 0 to 1
  bool stops = false;                 ///< the joint rests at the end of the block, but not at the end of the last one
  Scalar last_direction = Scalar(0);  ///< direction of its last motion, -1 or 1; 0 if it has never moved
  /// Whether the joint rests, or moves in one direction, throughout the block.
  bool steady() const noexcept { return resting == 1 || (resting == 0 && (direction == 1 || direction == -1)); }
};

/// Distinguishes resting joints from moving ones (docs/theory.md, "Friction"). A joint moves in a quarter of a block if
/// its mean dq there exceeds 1e-4 rad/s and six standard deviations of its noise. A joint whose motion cannot be
/// distinguished from noise counts as resting. The opposite mistake would be worse: if noise is taken for motion, the
/// friction does not change with the supposed direction, and is learned to be zero. No call allocates.
template <typename Scalar, int Dofs>
class FrictionRegime {
 public:
  /// Advances by one block.
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
    // Noise of dq alone must not count as motion: three standard deviations of the norm of the block's mean dq.
    const Scalar noise = block.velocity_noise.sum() / samples;
    arm_moves_ = block.velocity.norm() > std::max(Scalar(kArmMoves), 3 * sqrt(noise));
  }
  /// State of joint j in the last block, j from 0 to Dofs - 1.
  const JointFriction<Scalar>& joint(int j) const noexcept { return joints_[static_cast<std::size_t>(j)]; }
  /// Whether joint j rested at the end of the last block.
  bool rests(int j) const noexcept { return joint_rests_[static_cast<std::size_t>(j)]; }
  /// Whether any joint moved in the last block: the stiction of a resting joint may then change.
  bool arm_moves() const noexcept { return arm_moves_; }

  /// At first, all joints rest.
  FrictionRegime() noexcept { joint_rests_.fill(true); }

 private:
  static constexpr double kMoves = 1e-4;     // smallest velocity of a moving joint [rad/s]
  static constexpr double kArmMoves = 1e-3;  // smallest norm of dq of a moving arm [rad/s]
  static constexpr double kDeviations = 6;   // by noise alone, seven joints at rest exceed them once in a hundred hours
  std::array<JointFriction<Scalar>, static_cast<std::size_t>(Dofs)> joints_{};
  std::array<bool, static_cast<std::size_t>(Dofs)> joint_rests_{};
  bool arm_moves_ = false;
};

}  // namespace rme
