#pragma once
/// The value of a dynamical system at one point: the desired velocity, and the potential.
#include <rme/core/types.hpp>
#include <type_traits>

namespace rme {

/// The value of a dynamical system at one point (f and V in docs/theory_control.md (C15, C16)): of xdot = f(x) for
/// positions x [m], with f in m/s, or of omega = f(R) for orientations R, with f in rad/s.
template <typename Scalar>
struct Flow {
  Vector3<Scalar> velocity = Vector3<Scalar>::Zero();      ///< f(x), world axes
  Vector3<Scalar> conservative = Vector3<Scalar>::Zero();  ///< -grad V(x), world axes: the part of f with a potential
  Scalar potential = Scalar(0);                            ///< V(x) >= 0 [m^2/s] or [rad^2/s]
};

/// The flow of any system at x [m], world axes. A system is a callable x -> Flow, or x -> Vector3 if it has no known
/// potential. In the second case no part of f counts as conservative, and the power of f counts as supplied
/// (passivity_monitor.hpp).
template <typename System, typename Scalar>
Flow<Scalar> flow_at(const System& system, const Vector3<Scalar>& x) noexcept {
  using Answer = std::decay_t<decltype(system(x))>;
  if constexpr (std::is_same_v<Answer, Flow<Scalar>>) {
    return system(x);
  } else {
    Flow<Scalar> flow;
    flow.velocity = system(x);
    return flow;
  }
}

}  // namespace rme
