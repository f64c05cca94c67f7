#pragma once
/// The dynamical system that circles in a plane.
#include <cmath>
#include <rme/control/flow.hpp>
#include <rme/core/require.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Settings of LimitCycle; the default plane is the paper's y-z plane.
template <typename Scalar>
struct LimitCycleConfig {
  Vector3<Scalar> center = Vector3<Scalar>::Zero();  ///< c [m], world axes
  Vector3<Scalar> normal =
      Vector3<Scalar>::UnitX();      ///< n, any length > 0, world axes; the motion is right-handed about n
  Scalar radius = Scalar(0.1);       ///< r > 0 [m]
  Scalar angular_speed = Scalar(1);  ///< w [rad/s]; negative: left-handed about n
  Scalar gain = Scalar(2);           ///< k > 0 [1/s], how fast f leads to the plane and the circle
};

/// Circles a point in a plane:
///
///     f(x) = w n x p - k (|p|^2 - r^2) / (|p|^2 + r^2) p - k (n.e) n,   e = x - c, p = e - (n.e) n
///
/// [m/s] (docs/theory_control.md (C23)), with n of length 1. The circle |p| = r in the plane is the stable limit cycle;
/// f is smooth everywhere, also at the centre. The second and third terms are -grad V, with
///
///     V = k (|p|^2 / 2 - r^2 / 2 - r^2 log((|p|^2 + r^2) / (2 r^2))) + k (n.e)^2 / 2      [m^2/s]
///
/// which is zero on the cycle. The first term circles, and has no potential.
template <typename Scalar>
class LimitCycle {
 public:
  /// @throws std::invalid_argument naming the field out of range
  explicit LimitCycle(const LimitCycleConfig<Scalar>& config) : config_(config) {
    detail::require_positive(config.radius, "LimitCycleConfig::radius", "> 0 m");
    detail::require_positive(config.gain, "LimitCycleConfig::gain", "> 0 1/s");
    detail::require_positive(config.normal.norm(), "LimitCycleConfig::normal", "a length > 0");
    detail::require(std::isfinite(config.angular_speed), "LimitCycleConfig::angular_speed", "a finite number",
                    config.angular_speed);
    detail::require(config.center.allFinite(), "LimitCycleConfig::center", "finite numbers", config.center.norm());
    config_.normal.normalize();
  }

  /// f and V at x [m], world axes.
  Flow<Scalar> operator()(const Vector3<Scalar>& x) const noexcept {
    const Vector3<Scalar> e = x - config_.center;
    const Vector3<Scalar>& n = config_.normal;
    const Scalar height = n.dot(e);
    const Vector3<Scalar> p = e - height * n;
    const Scalar k = config_.gain, p2 = p.squaredNorm(), r2 = config_.radius * config_.radius;
    const Scalar ratio = (p2 - r2) / (p2 + r2);
    Flow<Scalar> flow;
    flow.conservative = -k * ratio * p - k * height * n;
    flow.velocity = flow.conservative + config_.angular_speed * n.cross(p);
    // With u = (p2 - r2) / (2 r2): p2 / 2 - r2 / 2 = r2 u and (p2 + r2) / (2 r2) = 1 + u.
    const Scalar u = (p2 - r2) / (2 * r2);
    flow.potential = k * r2 * (u - std::log1p(u)) + k * height * height / 2;
    return flow;
  }

 private:
  LimitCycleConfig<Scalar> config_;
};

}  // namespace rme
