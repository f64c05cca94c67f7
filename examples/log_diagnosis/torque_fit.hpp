#pragma once
/// Explains an arm's torque, joint by joint, by its model and by what every joint may have: offset, friction, a rotor.
#include <Eigen/Core>
#include <vector>

#include "log_diagnosis/log_diagnosis.hpp"

namespace rme::examples {

/// Torque that is to be explained, and what explains it.
struct Explained {
  Eigen::MatrixXd tau;           ///< [N m], a row for each instant
  Motion motion;                 ///< of the same instants
  Eigen::MatrixXd base;          ///< the model's share, known [N m]
  Eigen::MatrixXd loads;         ///< the model's gravity torque, with which friction may grow [N m]
  bool measured = true;          ///< friction adds to the torque; in external torque it may have either sign
  double friction_error = 0.25;  ///< least error, as a share of the friction's rms
};

/// How well something explains the torque.
struct FitQuality {
  double cost = 0;           ///< negative log likelihood, and what its parameters cost [nats]
  Eigen::VectorXd left;      ///< rms of each joint's torque that is not explained [N m]
  Eigen::VectorXd friction;  ///< rms of each joint's friction [N m]
};

/// The factor on the model's share of a joint's torque.
struct GainFit {
  double gain = 1, deviation = 1e9;  ///< least squares, and its standard deviation
  double friction = 0;               ///< rms of friction over that of the model's share times the gain
  double opposite =
      0;  ///< by how much the opposite sign is likelier, friction included: it never drives a joint [nats]
};

/// Fits with errors that last for half a second; and with friction that is known to a quarter, so that a joint whose
/// torque is mostly friction counts for little.
class TorqueFit {
 public:
  /// @param duration  of the log [s]
  explicit TorqueFit(double duration);

  /// Offset, friction and rotor of each joint beside the known share.
  FitQuality fit(const Explained& data, int parameters = 0) const;
  /// The same with parameters that all joints share: tau = base + sum_i shared[i] x_i.
  /// @param x          the parameters
  /// @param deviation  their standard deviations if what is left does not average out
  FitQuality fit_shared(const Explained& data, const std::vector<Eigen::MatrixXd>& shared, Eigen::VectorXd& x,
                        Eigen::VectorXd& deviation) const;
  /// A factor on each joint's share.
  std::vector<GainFit> fit_gains(const Explained& data) const;
  double samples() const noexcept { return samples_; }  ///< independent ones in the log

 private:
  double samples_;
};

}  // namespace rme::examples
