#pragma once
/// A simulated arm as a MuJoCo model.
#include <memory>
#include <string>
#include <synthetic_arm/physics.hpp>

struct mjModel_;
struct mjData_;

namespace rme::examples {

/// The arm as an MJCF text, for MuJoCo or for a reader: links and joints of the table, a welded body for the payload,
/// and shapes to look at that take no part in the physics. Those of the payload, "payload" and the
/// "rod" that it hangs on, are invisible at first.
/// @param shapes  whether MuJoCo is to keep those shapes, whose places it computes in every step: a fifth of the time
template <int Dofs>
std::string to_mjcf(const ArmModel<Dofs>& model, const JointFriction<Dofs>& friction, bool shapes);

struct MujocoDelete {
  void operator()(mjModel_* model) const;
  void operator()(mjData_* data) const;
};
using MujocoModel = std::unique_ptr<mjModel_, MujocoDelete>;
using MujocoData = std::unique_ptr<mjData_, MujocoDelete>;

/// @throws std::runtime_error with MuJoCo's own words if it refuses the text
MujocoModel compile_mjcf(const std::string& mjcf);

extern template std::string to_mjcf<6>(const ArmModel<6>&, const JointFriction<6>&, bool);
extern template std::string to_mjcf<7>(const ArmModel<7>&, const JointFriction<7>&, bool);

}  // namespace rme::examples
