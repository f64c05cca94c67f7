#pragma once
/// Least squares estimates of a payload's parameters, which are linear in an arm's external torque.
#include <Eigen/Core>

#include "replay_log/log_blocks.hpp"

namespace rme::examples {

/// Recursive least squares with exponential forgetting (Ljung, System Identification, 11.2), in information form:
///
///     A <- keep A + H^T W H,   b <- keep b + H^T W y,   x = (A + R)^-1 b
///
/// The ridge R is not forgotten: without it, what the last poses did not show would grow without bound.
class RecursiveLeastSquares {
 public:
  /// @param ridge   diagonal of R, n x 1: one over the squares of the parameters' usual sizes, > 0
  /// @param memory  time constant of the forgetting [s]; 0: nothing is forgotten
  RecursiveLeastSquares(const Eigen::VectorXd& ridge, double memory);

  /// Forgets.
  /// @param duration  time since the last call [s]
  void age(double duration);
  /// Takes in some rows.
  /// @param H       rows x n
  /// @param y       rows x 1
  /// @param weight  diagonal of W, rows x 1, >= 0
  void add(const Eigen::MatrixXd& H, const Eigen::VectorXd& y, const Eigen::VectorXd& weight);
  /// x, n x 1.
  Eigen::VectorXd solution() const;

 private:
  Eigen::VectorXd ridge_;
  double memory_;
  Eigen::MatrixXd A_;  // only the lower triangle
  Eigen::VectorXd b_;
};

/// What a log of the empty hand shows of each joint, to be subtracted from later torque: the user's tare.
struct Tare {
  Eigen::VectorXd offset;   ///< [N m]
  Eigen::VectorXd coulomb;  ///< [N m]
  Eigen::VectorXd viscous;  ///< [N m s/rad]
  Eigen::VectorXd weight;   ///< one over the variance of what is left [1/(N m)^2]

  /// No offset, no friction, equal weights.
  static Tare none(Eigen::Index joints);
  /// By least squares over the blocks, those in which the joint moves.
  static Tare of(const LogBlocks& empty);
  /// offset - direction coulomb - velocity viscous, in the shape of log.tau [N m].
  Eigen::MatrixXd torque(const LogBlocks& log) const;
};

/// The payload (m, m r) of all blocks [kg, kg m], by least squares together with each joint's own offset and friction.
/// @param weight  of each joint
Eigen::Vector4d batch_least_squares(const LogBlocks& log, const Eigen::VectorXd& weight);

}  // namespace rme::examples
