#pragma once
/// Noise, offset, friction and residual of an arm's torque with an empty hand, joint by joint.
#include <Eigen/Core>
#include <vector>

#include "replay_log/log_blocks.hpp"

namespace rme::examples {

/// The parameters of one joint. The model of a moving joint's torque in a block is
///
///     offset - direction coulomb - velocity viscous + residual + noise
///
/// with an offset for each log; at rest, stiction takes the place of friction.
struct JointFindings {
  double noise = 0;             ///< standard deviation of a block's error that does not last into the next block [N m]
  std::vector<double> offset;   ///< for each log [N m]
  double coulomb = 0;           ///< [N m]
  double viscous = 0;           ///< [N m s/rad]
  double stiction = 0;          ///< rms about the offset while the joint rests [N m]
  double residual = 0;          ///< standard deviation of the error that lasts longer than a block [N m]
  double correlation_time = 0;  ///< after which the residual's autocorrelation is 1/e [s]
  bool friction_known = false;  ///< the joint moves both ways for a second each
  bool rests = false;           ///< the joint rests for a second or more, so that stiction is known
  /// Increase of Coulomb friction per N m of the model's gravity torque on the joint; 0 if the logs show none.
  /// unexplained() does not subtract it, since the tracker's friction model does not depend on the load.
  double coulomb_per_load = 0;
  /// Slope of the torque over the model's gravity torque: about 0 for an external torque, and about 1 or -1 if gravity
  /// has not been subtracted from it.
  double gravity_slope = 0;
  bool gravity_seen = false;  ///< the model's gravity torque changes enough in the logs to find the slope
};

/// Finds the parameters of all joints.
/// @param logs  of the same arm, with at least one block in all
std::vector<JointFindings> find_joints(const std::vector<LogBlocks>& logs);

/// The torque minus offset and friction, in the shape of log.tau [N m].
/// @param number  index of the log in find_joints()
Eigen::MatrixXd unexplained(const LogBlocks& log, std::size_t number, const std::vector<JointFindings>& joints);

/// A^-1 b of a symmetric positive definite A, of which only the lower triangle is read. Compiled once: Eigen's LDL^T takes
/// long.
Eigen::VectorXd solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b);

}  // namespace rme::examples
