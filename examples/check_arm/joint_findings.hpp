#pragma once
/// What an arm's torque looks like with an empty hand, joint by joint.
#include <Eigen/Core>
#include <vector>

#include "replay_log/log_blocks.hpp"

namespace rme::examples {

/// What was found of one joint. The torque of a block is taken to be
///
///     offset - direction coulomb - velocity viscous + residual + noise
///
/// of a joint that moves, with an offset for each log; at rest, stiction takes the place of friction.
struct JointFindings {
  double noise = 0;             ///< of a block: what does not last from one to the next [N m]
  std::vector<double> offset;   ///< for each log [N m]
  double coulomb = 0;           ///< [N m]
  double viscous = 0;           ///< [N m s/rad]
  double stiction = 0;          ///< rms about the offset while the joint rests [N m]
  double residual = 0;          ///< standard deviation of what lasts longer than a block [N m]
  double correlation_time = 0;  ///< over which the residual keeps 1/e of itself [s]
  bool friction_known = false;  ///< the joint moves both ways for a second each
  bool rests = false;           ///< the joint rests for a second or more, so that stiction is known
  /// By how much Coulomb friction grows with what the joint carries, where the data show it: what the model's gravity
  /// torque leaves over of friction. 0 where they do not. No part of what unexplained() takes off: the tracker's
  /// friction does not know of loads.
  double coulomb_per_load = 0;
  /// By how much the torque follows the model's gravity torque, and how closely. An external torque does not: 0; where
  /// gravity was left in it is 1, -1 with the sign changed.
  double gravity_slope = 0, gravity_correlation = 0;
  bool gravity_seen = false;  ///< it changes enough in the logs to tell
};

/// @param logs  the same arm, at least one block in all
std::vector<JointFindings> find_joints(const std::vector<LogBlocks>& logs);

/// The torque less offset and friction, in the shape of log.tau [N m].
Eigen::MatrixXd unexplained(const LogBlocks& log, std::size_t number, const std::vector<JointFindings>& joints);

/// What an empty hand looks like to somebody who watches for `window` seconds, knowing what the tracker knows: offset,
/// friction, noise, the residual's size and correlation, and what it was just before.
struct Visibility {
  double window = 0;         ///< [s]
  int windows = 0;           ///< that the logs hold
  double mass = 0;           ///< rms of the mass that is seen in an empty hand [kg]
  double expected_mass = 0;  ///< the same as noise and residual let expect [kg]
  double moment = 0;         ///< rms of m r, of the three axes [kg m]
  /// Lightest payload that stands out: four times `mass`, so that one in a hundred windows would show it wrongly and
  /// one in twenty would miss it [kg].
  double lightest() const { return 4 * mass; }
};

/// @param rated  heaviest payload of the arm [kg]
Visibility visibility(const std::vector<LogBlocks>& logs, const std::vector<JointFindings>& joints, double window,
                      double rated);

}  // namespace rme::examples
