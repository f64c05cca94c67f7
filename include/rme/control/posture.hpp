#pragma once
/// A spring and a damper at each joint, for the null space of a redundant arm.
#include <cmath>
#include <rme/core/require.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Settings of Posture, the same for all joints but for the rest pose; with zero stiffness there is only damping.
template <typename Scalar, int Dofs>
struct PostureConfig {
  JointVector<Scalar, Dofs> rest = JointVector<Scalar, Dofs>::Zero();  ///< q_0 [rad]
  Scalar stiffness = Scalar(5);                                        ///< k >= 0 [N m/rad]
  Scalar damping = Scalar(2);                                          ///< d >= 0 [N m s/rad]
};

/// tau_0 = k (q_0 - q) - d dq. CPIC uses the part of it that makes no wrench, N tau_0 (docs/theory_control.md (C5)).
template <typename Scalar, int Dofs>
class Posture {
 public:
  /// @throws std::invalid_argument naming the field out of range
  explicit Posture(const PostureConfig<Scalar, Dofs>& config) : config_(config) {
    detail::require(config.rest.allFinite(), "PostureConfig::rest", "finite numbers", config.rest.norm());
    detail::require(config.stiffness >= 0 && std::isfinite(config.stiffness), "PostureConfig::stiffness",
                    ">= 0 N m/rad", config.stiffness);
    detail::require(config.damping >= 0 && std::isfinite(config.damping), "PostureConfig::damping", ">= 0 N m s/rad",
                    config.damping);
  }

  /// tau_0 [N m] at q [rad] and dq [rad/s], for the null space.
  JointVector<Scalar, Dofs> torque(const JointVector<Scalar, Dofs>& q,
                                   const JointVector<Scalar, Dofs>& dq) const noexcept {
    return config_.stiffness * (config_.rest - q) - config_.damping * dq;
  }

 private:
  PostureConfig<Scalar, Dofs> config_;
};

}  // namespace rme
