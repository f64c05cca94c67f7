#pragma once
/// An arm's model from its URDF, and the choice of the compiled templates by the number of joints at run time.
#include <algorithm>
#include <cstddef>
#include <precompiled/joint_counts.hpp>
#include <stdexcept>
#include <string>
#include <synthetic_arm/arm_model.hpp>
#include <type_traits>
#include <utility>
#include <vector>

namespace rme::examples {

/// Says what is wrong with a URDF, or with the links that were asked for: "FILE: ...".
class UrdfError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// A joint of the chain, with its limits.
struct ChainJoint {
  std::string name;
  double q_min, q_max;  ///< [rad]; infinite if it is continuous
  double dq_max;        ///< [rad/s]; infinite if the URDF gives none
  double tau_max;       ///< [N m]; infinite if the URDF gives none
};

/// The moving links and joints between two links of a URDF, from the base on. World axes are those of the base link.
struct UrdfChain {
  std::string name;            ///< of the robot
  std::string base, tip_link;  ///< first and last link
  std::vector<Link> links;     ///< those that move, each with all that is fixed to it
  std::vector<ChainJoint> joints;
  Eigen::Vector3d tip;           ///< tip link's origin in the last moving link's axes [m]
  Eigen::Matrix3d tip_rotation;  ///< tip link's axes to the last moving link's axes

  int dofs() const noexcept { return static_cast<int>(links.size()); }
};

/// Reads the chain from link `base` to link `tip`. A moving link of the chain includes all that is attached to it:
/// links behind fixed joints, also beyond the tip, and side branches. Movable parts of these, such as fingers, are in
/// their zero position.
/// @throws UrdfError naming what is wrong: no such link, and which there are; a joint in the chain that is neither
///         revolute nor continuous; a moving link without inertia; a loop; fewer than kFewestJoints joints or more
///         than kMostJoints; or that the programs were built without urdfdom
UrdfChain read_urdf(const std::string& file, const std::string& base, const std::string& tip);
/// The same from the text of a URDF.
/// @param file  what to call it in messages
UrdfChain parse_urdf(const std::string& text, const std::string& file, const std::string& base, const std::string& tip);

/// The chain as an arm. Requires chain.dofs() == Dofs. Speeds and torques that the URDF does not bound are infinite.
/// The ready pose is half way between the limits; 0 for a continuous joint.
template <int Dofs>
ArmModel<Dofs> arm_model(const UrdfChain& chain) {
  ArmModel<Dofs> m{};
  m.name = chain.name;
  std::copy(chain.links.begin(), chain.links.end(), m.links.begin());
  m.flange = chain.tip;
  m.flange_rotation = chain.tip_rotation;
  for (int j = 0; j < Dofs; ++j) {
    const ChainJoint& joint = chain.joints[static_cast<std::size_t>(j)];
    m.q_min[j] = joint.q_min;
    m.q_max[j] = joint.q_max;
    m.dq_max[j] = joint.dq_max;
    m.tau_max[j] = joint.tau_max;
    m.ready[j] = std::isfinite(joint.q_min + joint.q_max) ? 0.5 * (joint.q_min + joint.q_max) : 0;
  }
  return m;
}

/// Calls `function(std::integral_constant<int, Dofs>)` for the Dofs that is `dofs`, and returns what it returns:
///
///     with_joint_count(chain.dofs(), [&](auto n) { return replay<n()>(arm_model<n()>(chain)); });
///
/// @throws std::invalid_argument if the programs are not compiled for that many joints
template <int Dofs = kFewestJoints, typename Function>
auto with_joint_count(int dofs, Function&& function) {
  if (dofs == Dofs) return function(std::integral_constant<int, Dofs>());
  if constexpr (Dofs < kMostJoints) {
    return with_joint_count<Dofs + 1>(dofs, std::forward<Function>(function));
  } else {
    throw std::invalid_argument("an arm of " + std::to_string(dofs) + " joints; the programs are compiled for " +
                                std::to_string(kFewestJoints) + " to " + std::to_string(kMostJoints));
  }
}

}  // namespace rme::examples
