#pragma once
/// The dynamical system that turns the end effector to a target orientation.
#include <Eigen/Geometry>
#include <cmath>
#include <rme/control/flow.hpp>
#include <rme/core/require.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Settings of OrientationAttractor.
template <typename Scalar>
struct OrientationAttractorConfig {
  Eigen::Quaternion<Scalar> target = Eigen::Quaternion<Scalar>::Identity();  ///< end-effector axes to world axes
  Scalar gain = Scalar(2);                                                   ///< k > 0 [1/s]
};

/// omega = -k sin(theta) u [rad/s] (docs/theory_control.md (C24)) for the rotation by the angle theta about the unit
/// axis u, world axes, that leads from the target to the present orientation. It is -grad V of V = k (1 - cos theta),
/// and smooth for all orientations. With the quaternion (w, v) of that rotation it is -2 k w v, the same for both signs
/// of the quaternion. Beyond 90 degrees it becomes weaker, and 180 degrees is an unstable equilibrium.
template <typename Scalar>
class OrientationAttractor {
 public:
  /// @throws std::invalid_argument naming the field out of range
  explicit OrientationAttractor(const OrientationAttractorConfig<Scalar>& config) : config_(config) {
    detail::require_positive(config.gain, "OrientationAttractorConfig::gain", "> 0 1/s");
    const Scalar norm = config.target.norm();
    detail::require(std::abs(norm - Scalar(1)) < Scalar(1e-3), "OrientationAttractorConfig::target",
                    "a unit quaternion", norm);
    config_.target.normalize();
  }

  /// @param rotation  R, end-effector axes to world axes
  /// @return velocity: the desired angular velocity [rad/s], world axes; potential [rad^2/s]
  Flow<Scalar> operator()(const Matrix3<Scalar>& rotation) const noexcept {
    // R R*^T has sin(theta) u as its skew part and 1 + 2 cos(theta) as its trace.
    const Matrix3<Scalar> error = rotation * config_.target.toRotationMatrix().transpose();
    const Vector3<Scalar> sine(error(2, 1) - error(1, 2), error(0, 2) - error(2, 0), error(1, 0) - error(0, 1));
    Flow<Scalar> flow;
    flow.velocity = -config_.gain / 2 * sine;
    flow.conservative = flow.velocity;
    flow.potential = config_.gain * (Scalar(3) - error.trace()) / 2;
    return flow;
  }

 private:
  OrientationAttractorConfig<Scalar> config_;
};

}  // namespace rme
