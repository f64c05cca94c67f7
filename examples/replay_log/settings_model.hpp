#pragma once
/// The arm that settings belong to, where it is not the URDF as its maker wrote it: "model" in a settings file.
#include <nlohmann/json.hpp>
#include <string>
#include <vector>

#include "urdf_arm/recorded_arm.hpp"

namespace rme::examples {

/// What settings say of the arm that they were made with:
///
///     "model": {"urdf": "corrected.urdf", "base": "base_link", "tip": "tool0", "rotor_inertia": [3.9, 2.5, ..],
///               "load_friction": [0, 0.09, ..]}
///
/// @param chain          that the URDF has
/// @param urdf           its file, as seen from the settings' folder
/// @param rotor_inertia  of each joint, gear included [kg m^2]
/// @param load_friction  as RecordedArm has it
nlohmann::json model_to_json(const UrdfChain& chain, const std::string& urdf, const std::vector<double>& rotor_inertia,
                             const std::vector<double>& load_friction);

/// Puts the arm of `model` in the place of what the command line said of links and rotors.
/// @param file  of the settings: where the URDF is looked for, and what to call it in messages
/// @return a sentence that says so
/// @throws ArgumentError if it is no such model, or of another arm than the command line's; UrdfError
std::string use_model(const nlohmann::json& model, const std::string& file, ArmRequest& request);

}  // namespace rme::examples
