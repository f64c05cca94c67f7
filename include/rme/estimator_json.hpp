#pragma once
/// The JSON form of an EstimatorConfig: an object with the fields of the struct under their own names. Link rme::json.
#include <cmath>
#include <cstddef>
#include <initializer_list>
#include <limits>
#include <nlohmann/json.hpp>
#include <rme/core/describe_json.hpp>
#include <rme/core/require.hpp>
#include <rme/estimator_config.hpp>
#include <string>
#include <vector>

namespace rme {

/// The settings that a JSON object describes. A missing field has its value in `defaults`; "arm" and "payload" need all
/// of their fields, but for "friction_std", which is 0.5 if it is missing.
///
///     {"rated_payload": 12.5, "observer_bandwidth": 0, "torque_sign": "reaction", "sensing": "joint_friction",
///      "contact_false_alarms": 0.1, "gravity": [0, 0, -9.81],
///      "arm": {"noise": [..], "offset": [..], "residual": [..], "coulomb": [..], "viscous": [..], "friction_std":
///      0.3}, "payload": {"mass_mean": 1, "mass_std": 1, "com_mean": [0, 0, 0.1], "com_std": [0.06, 0.06, 0.07]}}
///
/// "torque_sign" is "external" or "reaction"; "sensing" is "unknown", "link_side", "joint_friction" or "rough_model".
/// "model", which check_arm may write, is not read. It names the rigid-body model that belongs to the settings: the
/// host has to compute tau_ext with this model.
///
/// For a RuntimeEstimator, Dofs is Eigen::Dynamic, and the RuntimeEstimator checks the vectors' sizes.
/// @param object    the JSON object
/// @param defaults  of fields that are missing, such as franka_config()
/// @throws std::invalid_argument naming a field that is unknown, missing or of the wrong type or size, with what was
///         expected and what was found. The Estimator's constructor checks ranges.
template <typename Scalar, int Dofs>
EstimatorConfig<Scalar, Dofs> estimator_config_from_json(const nlohmann::json& object,
                                                         const EstimatorConfig<Scalar, Dofs>& defaults = {});

/// The JSON object of the settings, with "arm" and "payload" only if they are set. estimator_config_from_json() gives
/// the same settings back.
template <typename Scalar, int Dofs>
nlohmann::json estimator_config_to_json(const EstimatorConfig<Scalar, Dofs>& config);

namespace detail {

/// Reads the fields of one object, and refuses unknown ones.
class SettingsReader {
 public:
  SettingsReader(const nlohmann::json& object, const std::string& path, std::initializer_list<const char*> known)
      : object_(object), path_(path) {
    if (!object.is_object())
      refuse((path.empty() ? "the settings" : path) + ": expected an object, got " + describe(object));
    for (const auto& [key, value] : object.items()) {
      bool found = false;
      for (const char* name : known) found = found || key == name;
      if (!found) refuse(name_of(key) + ": unknown field");
    }
  }
  const nlohmann::json* find(const char* key) const { return object_.contains(key) ? &object_.at(key) : nullptr; }
  const nlohmann::json& at(const char* key) const {
    if (!object_.contains(key)) refuse(name_of(key) + ": missing");
    return object_.at(key);
  }
  std::string name_of(const std::string& key) const { return path_.empty() ? key : path_ + "." + key; }

 private:
  const nlohmann::json& object_;
  std::string path_;
};

template <typename Scalar>
Scalar read_number(const nlohmann::json& json, const std::string& path) {
  // Converting a number that is too large for Scalar is undefined behaviour.
  if (!json.is_number() || !(std::abs(json.get<double>()) <= double(std::numeric_limits<Scalar>::max())))
    refuse(path + ": expected a number, got " + describe(json));
  return json.get<Scalar>();
}
template <typename Vector>
Vector read_vector(const nlohmann::json& json, const std::string& path) {
  Vector out;
  constexpr bool any = Vector::SizeAtCompileTime == Eigen::Dynamic;
  const std::size_t size = any && json.is_array() ? json.size() : static_cast<std::size_t>(out.size());
  if (!json.is_array() || json.size() != size)
    refuse(path + ": expected an array of " + (any ? "" : std::to_string(size) + " ") + "numbers, got " +
           describe(json));
  out.resize(static_cast<Eigen::Index>(size));
  for (std::size_t i = 0; i < size; ++i)
    out[static_cast<Eigen::Index>(i)] =
        read_number<typename Vector::Scalar>(json[i], path + "[" + std::to_string(i) + "]");
  return out;
}
/// The value whose name the string is: names[i] belongs to values[i].
template <typename Enum, std::size_t Count>
Enum read_name(const nlohmann::json& json, const std::string& path, const Enum (&values)[Count],
               const char* const (&names)[Count]) {
  std::string expected;
  for (std::size_t i = 0; i < Count; ++i) {
    if (json == names[i]) return values[i];
    expected += (i == 0 ? "\"" : ", \"") + std::string(names[i]) + "\"";
  }
  refuse(path + ": expected one of " + expected + ", got " + describe(json));
}
template <typename Vector>
std::vector<typename Vector::Scalar> write_vector(const Vector& v) {
  return std::vector<typename Vector::Scalar>(v.data(), v.data() + v.size());
}

inline constexpr TorqueSign kSigns[] = {TorqueSign::External, TorqueSign::Reaction};
inline constexpr const char* kSignNames[] = {"external", "reaction"};
inline constexpr std::optional<Sensing> kSensingValues[] = {std::nullopt, Sensing::LinkSide, Sensing::JointFriction,
                                                            Sensing::RoughModel};
inline constexpr const char* kSensingNames[] = {"unknown", "link_side", "joint_friction", "rough_model"};

}  // namespace detail

template <typename Scalar, int Dofs>
EstimatorConfig<Scalar, Dofs> estimator_config_from_json(const nlohmann::json& object,
                                                         const EstimatorConfig<Scalar, Dofs>& defaults) {
  using Vector = JointVector<Scalar, Dofs>;
  EstimatorConfig<Scalar, Dofs> config = defaults;
  const detail::SettingsReader reader(object, "",
                                      {"gravity", "torque_sign", "rated_payload", "observer_bandwidth",
                                       "contact_false_alarms", "sensing", "arm", "payload", "model"});
  if (const auto* v = reader.find("gravity")) config.gravity = detail::read_vector<Vector3<Scalar>>(*v, "gravity");
  if (const auto* v = reader.find("torque_sign"))
    config.torque_sign = detail::read_name(*v, "torque_sign", detail::kSigns, detail::kSignNames);
  if (const auto* v = reader.find("rated_payload"))
    config.rated_payload = detail::read_number<Scalar>(*v, "rated_payload");
  if (const auto* v = reader.find("observer_bandwidth"))
    config.observer_bandwidth = detail::read_number<double>(*v, "observer_bandwidth");
  if (const auto* v = reader.find("contact_false_alarms"))
    config.contact_false_alarms = detail::read_number<double>(*v, "contact_false_alarms");
  if (const auto* v = reader.find("sensing"))
    config.sensing = detail::read_name(*v, "sensing", detail::kSensingValues, detail::kSensingNames);
  if (const auto* v = reader.find("arm")) {
    const detail::SettingsReader arm(*v, "arm", {"noise", "offset", "residual", "coulomb", "viscous", "friction_std"});
    const auto vector = [&](const char* key) { return detail::read_vector<Vector>(arm.at(key), arm.name_of(key)); };
    config.arm = ArmPrior<Scalar, Dofs>{vector("noise"), vector("offset"), vector("residual"), vector("coulomb"),
                                        vector("viscous")};
    if (const auto* s = arm.find("friction_std"))
      config.arm->friction_std = detail::read_number<Scalar>(*s, arm.name_of("friction_std"));
  }
  if (const auto* v = reader.find("payload")) {
    const detail::SettingsReader payload(*v, "payload", {"mass_mean", "mass_std", "com_mean", "com_std"});
    const auto number = [&](const char* key) {
      return detail::read_number<Scalar>(payload.at(key), payload.name_of(key));
    };
    const auto vector = [&](const char* key) {
      return detail::read_vector<Vector3<Scalar>>(payload.at(key), payload.name_of(key));
    };
    config.payload =
        PayloadPrior<Scalar>{number("mass_mean"), number("mass_std"), vector("com_mean"), vector("com_std")};
  }
  return config;
}

template <typename Scalar, int Dofs>
nlohmann::json estimator_config_to_json(const EstimatorConfig<Scalar, Dofs>& config) {
  nlohmann::json out;
  out["gravity"] = detail::write_vector(config.gravity);
  out["torque_sign"] = detail::kSignNames[config.torque_sign == TorqueSign::External ? 0 : 1];
  out["rated_payload"] = config.rated_payload;
  out["observer_bandwidth"] = config.observer_bandwidth;
  out["contact_false_alarms"] = config.contact_false_alarms;
  out["sensing"] = detail::kSensingNames[config.sensing ? static_cast<std::size_t>(*config.sensing) + 1 : 0];
  if (config.arm) {
    out["arm"] = {{"noise", detail::write_vector(config.arm->noise)},
                  {"offset", detail::write_vector(config.arm->offset)},
                  {"residual", detail::write_vector(config.arm->residual)},
                  {"coulomb", detail::write_vector(config.arm->coulomb)},
                  {"viscous", detail::write_vector(config.arm->viscous)},
                  {"friction_std", config.arm->friction_std}};
  }
  if (config.payload) {
    out["payload"] = {{"mass_mean", config.payload->mass_mean},
                      {"mass_std", config.payload->mass_std},
                      {"com_mean", detail::write_vector(config.payload->com_mean)},
                      {"com_std", detail::write_vector(config.payload->com_std)}};
  }
  return out;
}

}  // namespace rme
