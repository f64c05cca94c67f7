#pragma once
/// The dynamical system that goes straight to a point.
#include <cmath>
#include <limits>
#include <rme/control/flow.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Settings of LinearAttractor.
template <typename Scalar>
struct LinearAttractorConfig {
  Vector3<Scalar> target = Vector3<Scalar>::Zero();  ///< x* [m], world axes
  Scalar gain = Scalar(1);                           ///< k > 0 [1/s]
  Scalar max_speed = Scalar(0.5);                    ///< v > 0 [m/s]; infinite for a purely linear system
};

/// f(x) = -k e / sqrt(1 + (k |e| / v)^2), e = x - x* (docs/theory_control.md (C22)): linear near the target, never
/// faster than v, smooth everywhere. It is -grad V of V = (v^2 / k) (sqrt(1 + (k |e| / v)^2) - 1), which near the
/// target is k |e|^2 / 2.
template <typename Scalar>
class LinearAttractor {
 public:
  /// @throws std::invalid_argument naming the field out of range
  explicit LinearAttractor(const LinearAttractorConfig<Scalar>& config) : config_(config) {
    detail::require(config.target.allFinite(), "LinearAttractorConfig::target", "finite numbers", config.target.norm());
    detail::require_positive(config.gain, "LinearAttractorConfig::gain", "> 0 1/s");
    detail::require(config.max_speed > 0, "LinearAttractorConfig::max_speed", "> 0 m/s", config.max_speed);
  }

  /// f and V at x [m], world axes.
  Flow<Scalar> operator()(const Vector3<Scalar>& x) const noexcept {
    const Vector3<Scalar> e = x - config_.target;
    const Scalar k = config_.gain;
    const Scalar root = std::sqrt(Scalar(1) + k * k * e.squaredNorm() / (config_.max_speed * config_.max_speed));
    Flow<Scalar> flow;
    flow.velocity = -k / root * e;
    flow.conservative = flow.velocity;
    // (v^2 / k) (root - 1), written without the difference, which would lose all digits near the target.
    flow.potential = k * e.squaredNorm() / (root + Scalar(1));
    return flow;
  }

  /// Moves the target [m], world axes. The potential jumps: call PassivityMonitor::reset() as well.
  /// @return Ok, or NonFiniteInput: the target stays
  Status set_target(const Vector3<Scalar>& target) noexcept {
    if (!target.allFinite()) return Status::NonFiniteInput;
    config_.target = target;
    return Status::Ok;
  }

 private:
  LinearAttractorConfig<Scalar> config_;
};

}  // namespace rme
