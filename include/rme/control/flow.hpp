#pragma once
/// What a dynamical system says at one point: the velocity it wants, and the part of it that a potential explains.
#include <rme/core/types.hpp>
#include <type_traits>

namespace rme {

/// A dynamical system xdot = f(x) at one x, for position [m/s] or, with x an orientation, for angular velocity [rad/s].
template <typename Scalar>
struct Flow {
  Vector3<Scalar> velocity = Vector3<Scalar>::Zero();      ///< f(x), world axes
  Vector3<Scalar> conservative = Vector3<Scalar>::Zero();  ///< -grad V(x), the part of f that cannot make energy
  Scalar potential = Scalar(0);                            ///< V(x) >= 0 [m^2/s] or [rad^2/s]
};

/// Asks any system for its flow at x. A system is a callable x -> Flow, or x -> Vector3 for one without a known
/// potential: then all of f counts as driven, and its power as supplied (passivity_monitor.hpp).
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
