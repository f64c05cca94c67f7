#pragma once
/// The passive interaction controller: a task force that follows a dynamical system and yields to pushes.
#include <cmath>
#include <rme/control/flow.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/core/wrench.hpp>

namespace rme {

/// Damping along and across the motion that the dynamical system asks for.
template <typename Scalar>
struct DirectionalDamping {
  Scalar along;   ///< lambda_1 > 0, also the gain of the driving force lambda_1 f
  Scalar across;  ///< lambda_2 = lambda_3 > 0
  Scalar blend;   ///< f_0 > 0: far below this speed D is about lambda_2 I, since f = 0 has no direction
};

/// D = lambda_2 I + (lambda_1 - lambda_2) f f^T / (|f|^2 + f_0^2) (docs/theory_control.md (C14)).
///
/// For |f| >> f_0 it is V diag(lambda_1, lambda_2, lambda_2) V^T with the first axis of V along f [RME, Eq. 32]. The
/// other two eigenvalues are equal, so the other two axes make no difference. At f = 0 it is lambda_2 I. D is a smooth
/// function of f, symmetric, with eigenvalues between lambda_1 and lambda_2.
/// @param f        [m/s] or [rad/s], world axes
/// @param damping  lambda_1, lambda_2 [N s/m] or [N m s/rad], f_0 [m/s] or [rad/s]
/// @return D, 3x3, world axes [N s/m] or [N m s/rad]
template <typename Scalar>
Matrix3<Scalar> damping_matrix(const Vector3<Scalar>& f, const DirectionalDamping<Scalar>& damping) noexcept {
  Matrix3<Scalar> D =
      (damping.along - damping.across) / (f.squaredNorm() + damping.blend * damping.blend) * f * f.transpose();
  D.diagonal().array() += damping.across;
  return D;
}

/// Settings of PassiveController.
template <typename Scalar>
struct PassiveControllerConfig {
  DirectionalDamping<Scalar> linear = {Scalar(60), Scalar(90), Scalar(0.01)};  ///< [N s/m], [N s/m], [m/s]
  DirectionalDamping<Scalar> angular = {Scalar(6), Scalar(6), Scalar(0.01)};   ///< [N m s/rad], same, [rad/s]
};

/// F_c = lambda_1 f(x) - D(x) xdot (docs/theory_control.md (C15)), for position and orientation alike.
///
/// The paper has -D (xdot - f) [RME, Eq. 31]; its proof needs D f = lambda_1 f (Eq. 33), which with this D holds only
/// for |f| >> f_0. With the F_c above, the proof holds for all f: if S = 1/2 dq^T M dq + potential_energy(), and the
/// only torques are J^T F_c and gravity compensation, then (docs/theory_control.md (C16))
///
///     dS/dt = xdot^T F_ext - dissipated_power() + injected_power()
template <typename Scalar>
class PassiveController {
 public:
  /// @throws std::invalid_argument naming the field out of range
  explicit PassiveController(const PassiveControllerConfig<Scalar>& config = PassiveControllerConfig<Scalar>());

  /// @param position     the flow of the translational system at the present position [m/s], world axes
  /// @param orientation  the flow of the rotational system at the present orientation [rad/s], world axes
  /// @param twist        present velocity of the end effector [m/s, rad/s], world axes
  /// @return Ok, or NonFiniteInput (also if a result overflows): nothing has changed
  Status update(const Flow<Scalar>& position, const Flow<Scalar>& orientation, const Twist<Scalar>& twist) noexcept;

  const Wrench<Scalar>& wrench() const noexcept { return wrench_; }  ///< F_c [N, N m], world axes
  /// lambda_1 V, summed over both systems [J]: the potential part of the storage function [RME, Eq. 34].
  Scalar potential_energy() const noexcept { return potential_energy_; }
  /// lambda_1 xdot^T (f + grad V) [W]: power of the parts of f without a potential, such as a limit cycle's circling.
  Scalar injected_power() const noexcept { return injected_power_; }
  /// xdot^T D xdot >= 0 [W], summed over both systems.
  Scalar dissipated_power() const noexcept { return dissipated_power_; }

 private:
  PassiveControllerConfig<Scalar> config_;
  Wrench<Scalar> wrench_;
  Scalar potential_energy_ = Scalar(0);
  Scalar injected_power_ = Scalar(0);
  Scalar dissipated_power_ = Scalar(0);
};

template <typename Scalar>
PassiveController<Scalar>::PassiveController(const PassiveControllerConfig<Scalar>& config) : config_(config) {
  for (const auto* damping : {&config.linear, &config.angular}) {
    detail::require_positive(damping->along, "DirectionalDamping::along", "> 0");
    detail::require_positive(damping->across, "DirectionalDamping::across", "> 0");
    detail::require_positive(damping->blend, "DirectionalDamping::blend", "> 0");
  }
}

template <typename Scalar>
Status PassiveController<Scalar>::update(const Flow<Scalar>& position, const Flow<Scalar>& orientation,
                                         const Twist<Scalar>& twist) noexcept {
  const auto& [linear, angular] = config_;
  const Vector3<Scalar> drag = damping_matrix(position.velocity, linear) * twist.linear;
  const Vector3<Scalar> turning_drag = damping_matrix(orientation.velocity, angular) * twist.angular;
  const Wrench<Scalar> wrench = {linear.along * position.velocity - drag,
                                 angular.along * orientation.velocity - turning_drag};
  const Scalar potential = linear.along * position.potential + angular.along * orientation.potential;
  const Scalar injected = linear.along * twist.linear.dot(position.velocity - position.conservative) +
                          angular.along * twist.angular.dot(orientation.velocity - orientation.conservative);
  const Scalar dissipated = twist.linear.dot(drag) + twist.angular.dot(turning_drag);
  if (!wrench.vector().allFinite() || !std::isfinite(potential) || !std::isfinite(injected) ||
      !std::isfinite(dissipated)) {
    return Status::NonFiniteInput;
  }
  wrench_ = wrench;
  potential_energy_ = potential;
  injected_power_ = injected;
  dissipated_power_ = dissipated;
  return Status::Ok;
}

}  // namespace rme
