#pragma once
/// "model" in a settings file: the arm that the settings belong to, if it is not the URDF as its maker wrote it.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "urdf_arm/recorded_arm.hpp"

namespace rme::examples {

/// The "model" of settings:
///
///     "model": {"urdf": "corrected.urdf", "base": "base_link", "tip": "tool0", "rotor_inertia": [3.9, 2.5, ..],
///               "load_friction": [0, 0.09, ..]}
///
/// @param chain          the chain in the URDF
/// @param urdf           the URDF's file, relative to the settings' folder
/// @param rotor_inertia  of each joint, gear included [kg m^2]
/// @param load_friction  of each joint, as RecordedArm::load_friction
nlohmann::json model_to_json(const UrdfChain& chain, const std::string& urdf, const std::vector<double>& rotor_inertia,
                             const std::vector<double>& load_friction);

/// Replaces the request's arm by that of `model`. Rotor inertias of the command line are kept.
/// @param file  the settings' file: the URDF is relative to its folder, and messages name it
/// @return a note about this for the user
/// @throws ArgumentError if `model` is malformed or of another arm than the command line's; UrdfError
std::string use_model(const nlohmann::json& model, const std::string& file, ArmRequest& request);

}  // namespace rme::examples
