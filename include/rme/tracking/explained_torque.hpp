#pragma once
/// The joint torque that a known body on the end effector explains while it moves. In: Jacobian, rotation and velocity
/// of each tick, and the body's ten parameters. Out: its torque as the arm's own observer shows it, (T60).
#include <algorithm>
#include <cmath>
#include <optional>
#include <rme/core/flange_motion.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/core/wrench.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/tracking/inertial_parameters.hpp>

namespace rme {

/// The torque of a body phi, passed through the first-order filter of the observer that computes tau_ext:
///
///     e_k = e_(k-1) + b (J^T Y(motion) phi - e_(k-1)),   b = 1 - (1 - K p)^(dt / p)      (docs/theory.md (T60))
///
/// The flange's acceleration is the difference of J dq over one period. Its noise is large, but the filter sums it up to
/// K times that of J dq, in step with tau_ext, whose observer differentiates the arm's momentum with the same filter. So no
/// further filter is needed, and none delays the answer. Real time: update() is O(6 Dofs); nothing allocates.
template <typename Scalar, int Dofs>
class ExplainedTorque {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< joint torque [N m]

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
    motion_ = FlangeMotion<Scalar>();
    for (int i = 0; i < 3; ++i) motion_.angular_velocity[i] = twist[3 + i];
    if (sample.motion) {
      motion_ = *sample.motion;
    } else if (started_) {
      const Scalar rate = Scalar(1) / static_cast<Scalar>(dt);
      for (int i = 0; i < 3; ++i) {
        motion_.linear_acceleration[i] = rate * (twist[i] - last_twist_[i]);
        motion_.angular_acceleration[i] = rate * (twist[3 + i] - last_twist_[3 + i]);
      }
    }
    last_twist_ = twist;
    jacobian_ = sample.jacobian;
    rotation_ = sample.rotation;
    const Vector now = torque_of(phi_, gravity_, motion_);
    if (!started_) torque_ = now;
    started_ = true;
    detail::add_scaled(torque_, blend_, detail::difference(now, torque_));
  }
  /// The body is another one, or is known better. It counts as having been there for longer than the observer's lag.
  /// @param phi  its ten parameters, 10 x 1
  /// @return change of torque() [N m]
  Vector become(const InertialVector<Scalar>& phi) noexcept {
    const Vector change = torque_of(detail::difference(phi, phi_), gravity_, FlangeMotion<Scalar>());
    phi_ = phi;
    torque_ += change;
    return change;
  }
  /// The next sample has no predecessor.
  void interrupt() noexcept { started_ = false; }

  const Vector& torque() const noexcept { return torque_; }  ///< e [N m]; zero before the first sample

 private:
  /// J^T Y phi, by Newton's and Euler's equations in end-effector axes (T10).
  Vector torque_of(const InertialVector<Scalar>& phi, const Vector3<Scalar>& gravity,
                   const FlangeMotion<Scalar>& motion) const noexcept {
    const Vector3<Scalar> s =
        detail::transposed_product(rotation_, detail::difference(gravity, motion.linear_acceleration));
    const Vector3<Scalar> w = detail::transposed_product(rotation_, motion.angular_velocity);
    const Vector3<Scalar> a = detail::transposed_product(rotation_, motion.angular_acceleration);
    const Vector3<Scalar> h(phi[1], phi[2], phi[3]);
    const auto inertia_times = [&phi](const Vector3<Scalar>& v) {
      return Vector3<Scalar>(phi[4] * v[0] + phi[5] * v[1] + phi[6] * v[2],
                             phi[5] * v[0] + phi[7] * v[1] + phi[8] * v[2],
                             phi[6] * v[0] + phi[8] * v[1] + phi[9] * v[2]);
    };
    const Vector3<Scalar> force = phi[0] * s - a.cross(h) - w.cross(w.cross(h));
    const Vector3<Scalar> moment = h.cross(s) - inertia_times(a) - w.cross(inertia_times(w));
    const Vector6<Scalar> wrench =
        detail::stacked<Scalar>(detail::product(rotation_, force), detail::product(rotation_, moment));
    return detail::transposed_product(jacobian_, wrench);
  }

  double bandwidth_, period_;
  Vector3<Scalar> gravity_;
  bool started_ = false;
  double last_dt_ = 0;
  Scalar blend_ = Scalar(1);  // b
  InertialVector<Scalar> phi_ = InertialVector<Scalar>::Zero();
  Vector6<Scalar> last_twist_ = Vector6<Scalar>::Zero();
  FlangeMotion<Scalar> motion_;
  Jacobian<Scalar, Dofs> jacobian_ = Jacobian<Scalar, Dofs>::Zero();
  Matrix3<Scalar> rotation_ = Matrix3<Scalar>::Identity();
  Vector torque_ = Vector::Zero();
};

}  // namespace rme
