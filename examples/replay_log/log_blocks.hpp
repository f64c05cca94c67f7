#pragma once
/// A recording in blocks of 20 ms, as the tracker uses it, for any number of joints.
#include <Eigen/Core>
#include <string>
#include <vector>

#include "replay_log/replay.hpp"

namespace rme::examples {

/// A row for each block, a column for each joint.
struct LogBlocks {
  std::string name;
  Eigen::VectorXd end, duration;         ///< [s]
  Eigen::MatrixXd tau;                   ///< external torque, the observer's lag removed [N m]
  Eigen::MatrixXd velocity;              ///< [rad/s]
  Eigen::MatrixXd direction;             ///< direction of dry friction, -1 to 1
  Eigen::MatrixXd resting;               ///< share of the block for which the joint rests
  Eigen::MatrixXd gravity;               ///< the model's gravity torque [N m]
  std::vector<Eigen::MatrixXd> payload;  ///< for each joint: torque per (m, m r) [N m / kg, N m / (kg m)], 4 columns

  Eigen::Index blocks() const noexcept { return tau.rows(); }
  Eigen::Index joints() const noexcept { return tau.cols(); }
};

/// Averages a log's samples over blocks.
template <int Dofs>
LogBlocks blocks_of(const Log<Dofs>& log, const Samples<Dofs>& samples, const RecordedArm<Dofs>& arm);

}  // namespace rme::examples
