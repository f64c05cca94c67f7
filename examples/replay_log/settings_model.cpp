#include "replay_log/settings_model.hpp"

#include <filesystem>
#include <rme/core/describe_json.hpp>

namespace rme::examples {

nlohmann::json model_to_json(const UrdfChain& chain, const std::string& urdf, const std::vector<double>& rotor_inertia,
                             const std::vector<double>& load_friction) {
  return {{"urdf", urdf},
          {"base", chain.base},
          {"tip", chain.tip_link},
          {"rotor_inertia", rotor_inertia},
          {"load_friction", load_friction}};
}

std::string use_model(const nlohmann::json& model, const std::string& file, ArmRequest& request) {
  const auto refuse = [&](const std::string& what) { throw ArgumentError(file + ": model" + what); };
  if (!model.is_object()) refuse(": expected an object, got " + rme::detail::describe(model));
  for (const auto& [key, value] : model.items())
    if (key != "urdf" && key != "base" && key != "tip" && key != "rotor_inertia" && key != "load_friction")
      refuse("." + key + ": unknown field");
  const auto text = [&](const char* key) {
    if (!model.contains(key)) refuse("." + std::string(key) + ": missing");
    const nlohmann::json& value = model.at(key);
    if (!value.is_string()) refuse("." + std::string(key) + ": expected a string, got " + rme::detail::describe(value));
    return value.get<std::string>();
  };
  const std::string base = text("base"), tip = text("tip");
  const std::string urdf = (std::filesystem::path(file).parent_path() / text("urdf")).string();
  if (request.chain && (request.chain->base != base || request.chain->tip_link != tip))
    refuse(": is from " + base + " to " + tip + ", the command line's arm from " + request.chain->base + " to " +
           request.chain->tip_link);
  UrdfChain chain = read_urdf(urdf, base, tip);
  if (chain.dofs() != request.dofs())
    refuse(": has " + std::to_string(chain.dofs()) + " joints, the arm has " + std::to_string(request.dofs()) +
           "; --urdf, --base and --tip say which arm it is");
  const auto numbers = [&](const char* key, std::vector<double>& values) {
    if (!values.empty() || !model.contains(key)) return;  // the command line overrides settings
    const nlohmann::json& found = model.at(key);
    const auto joints = static_cast<std::size_t>(chain.dofs());
    bool good = found.is_array() && found.size() == joints;
    for (std::size_t j = 0; good && j < joints; ++j) good = found[j].is_number() && found[j].get<double>() >= 0;
    if (!good)
      refuse("." + std::string(key) + ": expected an array of " + std::to_string(joints) + " numbers >= 0, got " +
             rme::detail::describe(found));
    values = found.get<std::vector<double>>();
  };
  numbers("rotor_inertia", request.rotor_inertia);
  numbers("load_friction", request.load_friction);
  request.chain = std::move(chain);
  return "the arm is that of " + urdf + ", to which the settings belong, with their rotors and friction";
}

}  // namespace rme::examples
