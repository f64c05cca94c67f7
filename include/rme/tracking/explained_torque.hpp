#pragma once
/// What a body on the end effector adds to the external torque while it moves. In: Jacobian, rotation and velocity of
/// each tick. Out: the regressor of its ten parameters as the arm's own observer shows it, (T60).
#include <algorithm>
#include <cmath>
#include <rme/core/flange_motion.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/tracking/inertial_parameters.hpp>

namespace rme {

/// The regressor J^T Y, passed through the first-order filter of the observer that computes tau_ext:
///
///     E_k = E_(k-1) + b (J^T Y(motion) - E_(k-1)),   b = 1 - (1 - K p)^(dt / p)      (docs/theory.md (T60))
///
/// E phi is then the torque of a body phi that has been there for longer than the observer's lag. The flange's
/// acceleration is the difference of J dq over one period. Its noise is large, but the filter sums it up to K times
/// that of J dq, in step with tau_ext, whose observer differentiates the arm's momentum with the same filter. So no
/// further filter is needed, and none delays the answer. Real time: update() is O(60 Dofs); nothing allocates.
template <typename Scalar, int Dofs>
class ExplainedTorque {
 public:
  using Regressor = Eigen::Matrix<Scalar, Dofs, kInertial>;  ///< maps phi to joint torque [N m]

  /// @param bandwidth  K of the observer that computed tau_ext [rad/s]; 0 if tau_ext is unfiltered
  /// @param period     p, the observer's own period [s], > 0
  /// @param gravity    g [m/s^2], world axes
  ExplainedTorque(double bandwidth, double period, const Vector3<Scalar>& gravity) noexcept
      : bandwidth_(bandwidth), period_(period), gravity_(gravity) {}

  /// Advances by one tick.
  /// @param sample  one tick, for which check_sample() has returned Ok
  /// @param dt      time since the last sample [s], > 0
  void update(const Proprioception<Scalar, Dofs>& sample, double dt) noexcept {
    if (dt != last_dt_) {
      last_dt_ = dt;
      const double gain = std::min(1.0, bandwidth_ * period_);
      blend_ = bandwidth_ > 0 ? static_cast<Scalar>(1 - std::pow(1 - gain, dt / period_)) : Scalar(1);
    }
    const Vector6<Scalar> twist = detail::product(sample.jacobian, sample.dq);
    FlangeMotion<Scalar> motion;
    for (int i = 0; i < 3; ++i) motion.angular_velocity[i] = twist[3 + i];
    if (sample.motion) {
      motion = *sample.motion;
    } else if (started_) {
      const Scalar rate = Scalar(1) / static_cast<Scalar>(dt);
      for (int i = 0; i < 3; ++i) {
        motion.linear_acceleration[i] = rate * (twist[i] - last_twist_[i]);
        motion.angular_acceleration[i] = rate * (twist[3 + i] - last_twist_[3 + i]);
      }
    }
    last_twist_ = twist;
    const Eigen::Matrix<Scalar, 6, kInertial> wrench =
        inertial_wrench_regressor<Scalar>(sample.rotation, gravity_, motion);
    const Eigen::Matrix<Scalar, Dofs, 6> transposed = sample.jacobian.transpose();
    Regressor now = Regressor::Zero();
    for (int i = 0; i < kInertial; ++i)  // an inertia makes no force
      for (int k = i < 4 ? 0 : 3; k < 6; ++k)
        detail::column(now, i) += detail::column(transposed, k) * wrench.coeff(k, i);
    if (started_)
      detail::add_scaled(regressor_, blend_, detail::difference(now, regressor_));
    else
      regressor_ = now;
    started_ = true;
  }
  /// The next sample has no predecessor.
  void interrupt() noexcept { started_ = false; }

  const Regressor& regressor() const noexcept { return regressor_; }  ///< E; zero before the first sample

 private:
  double bandwidth_, period_;
  Vector3<Scalar> gravity_;
  bool started_ = false;
  double last_dt_ = 0;
  Scalar blend_ = Scalar(1);  // b
  Vector6<Scalar> last_twist_ = Vector6<Scalar>::Zero();
  Regressor regressor_ = Regressor::Zero();
};

}  // namespace rme
