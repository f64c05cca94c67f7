#pragma once
/// The inertial parameters of a payload from the output of a momentum observer, by recursive least squares on a
/// regressor that has passed the observer's filter (Kurdas et al., ICRA 2022).
#include <rme/core/flange_motion.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/tracking/inertial_parameters.hpp>

#include "replay_log/replay.hpp"
#include "rivals/least_squares.hpp"

namespace rme::examples {

/// The observer's output to a payload phi is linear in it. With the filter F of the observer,
///
///     F(tau_ext) = F(J^T Y) phi
///
/// where Y is inertial_wrench_regressor(), and its accelerations are the change of the twist over a period, as the
/// observer takes the change of momentum.
template <int Dofs>
class ObserverMatchedLeastSquares {
 public:
  /// @param gravity    [m/s^2], world axes
  /// @param rated      rated payload of the arm [kg]; scales the ridge
  /// @param bandwidth  of the filter that the torque has passed [rad/s]; 0: none, then both are filtered here with 50
  /// @param memory     time constant of the forgetting [s]; 0: nothing is forgotten
  ObserverMatchedLeastSquares(const Eigen::Vector3d& gravity, double rated, double bandwidth, double memory)
      : gravity_(gravity), bandwidth_(bandwidth), fit_(ridge(rated), memory) {}

  /// Advances by one sample.
  /// @param sample  external torque of TorqueSign::External
  /// @param known   part of tau_ext that is no payload: offset and friction, not filtered [N m]
  /// @param period  time since the last sample [s], > 0
  /// @param weight  of each joint, Dofs x 1
  void update(const Proprioception<double, Dofs>& sample, const JointVector<double, Dofs>& known, double period,
              const Eigen::VectorXd& weight) {
    const Vector6<double> twist = sample.jacobian * sample.dq;
    if (!started_) twist_ = twist;
    const FlangeMotion<double> motion{twist.tail<3>(), (twist - twist_).head<3>() / period,
                                      (twist - twist_).tail<3>() / period};
    twist_ = twist;
    const Regressor now =
        sample.jacobian.transpose() * inertial_wrench_regressor<double>(sample.rotation, gravity_, motion);
    const bool filtered = bandwidth_ > 0;
    const double blend = started_ ? observer_blend(filtered ? bandwidth_ : kBandwidth, period) : 1;
    regressor_ += blend * (now - regressor_);
    known_ += blend * (known - known_);
    torque_ += (filtered ? 1 : blend) * (sample.tau_ext - torque_);
    started_ = true;
    running_ += period;
    fit_.age(period);
    // Before that, the torque shows what the filter started with, which is not known.
    if (running_ > kSettles / (filtered ? bandwidth_ : kBandwidth))
      fit_.add(regressor_, torque_ - known_, period * weight);
  }
  /// phi.
  InertialVector<double> solution() const { return fit_.solution(); }

 private:
  using Regressor = Eigen::Matrix<double, Dofs, kInertial>;
  static constexpr double kBandwidth = 50;  // [rad/s]
  static constexpr double kSettles = 7;     // time constants until a filter has forgotten all but a thousandth

  static Eigen::VectorXd ridge(double rated) {
    constexpr double kLever = 0.2;  // [m]
    const double mass = rated, moment = rated * kLever, inertia = rated * kLever * kLever;
    Eigen::VectorXd usual(kInertial);
    usual << mass, moment, moment, moment, Eigen::VectorXd::Constant(6, inertia);
    return usual.cwiseAbs2().cwiseInverse();
  }

  Eigen::Vector3d gravity_;
  double bandwidth_;
  RecursiveLeastSquares fit_;
  bool started_ = false;
  double running_ = 0;  // [s]
  Vector6<double> twist_ = Vector6<double>::Zero();
  Regressor regressor_ = Regressor::Zero();
  JointVector<double, Dofs> known_ = JointVector<double, Dofs>::Zero(), torque_ = JointVector<double, Dofs>::Zero();
};

}  // namespace rme::examples
