#pragma once
/// An EventEstimatorConfig's JSON form: an object with the fields of the structs under their own names. Link rme::json.
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <nlohmann/json.hpp>
#include <rme/core/describe_json.hpp>
#include <rme/core/require.hpp>
#include <rme/event_estimator.hpp>
#include <set>
#include <string>
#include <vector>

namespace rme {

/// The settings that a JSON object describes. A field that is not there keeps its default; per-joint fields are arrays
/// of Dofs numbers; each of "sensors" is "link_side", "joint_friction" or an object of which every field is needed.
///
///     {"collection": 0.2, "window": {"observer_bandwidth": 30}, "sensors": ["link_side"]}
///
/// @throws std::invalid_argument naming a field that is unknown or of the wrong type or size, with what was expected
/// and
///         what came. Ranges are checked by the Estimator, which knows the period.
template <typename Scalar, int Dofs>
EventEstimatorConfig<Scalar, Dofs> event_estimator_config_from_json(const nlohmann::json& object);

/// The JSON object with every field of the settings; event_estimator_config_from_json() gives the same settings back.
template <typename Scalar, int Dofs>
nlohmann::json event_estimator_config_to_json(const EventEstimatorConfig<Scalar, Dofs>& config);

namespace detail {

// The fields of each struct, once for reading and writing alike.
template <typename Config, typename Visit>
void visit_fields(Config& c, Visit&& visit, const MismatchDetectorConfig*) {
  visit("window", c.window);
  visit("activation_threshold", c.activation_threshold);
  visit("stabilisation_threshold", c.stabilisation_threshold);
  visit("stabilisation_ratio", c.stabilisation_ratio);
  visit("newest_average", c.newest_average);
  visit("check_average", c.check_average);
  visit("check_age", c.check_age);
  visit("edge_average", c.edge_average);
}
template <typename Config, typename Visit>
void visit_fields(Config& c, Visit&& visit, const SampleWindowConfig*) {
  visit("duration", c.duration);
  visit("observer_bandwidth", c.observer_bandwidth);
  visit("rest_velocity", c.rest_velocity);
}
template <typename Config, typename Visit, typename Scalar, int Dofs>
void visit_fields(Config& c, Visit&& visit, const SensorModel<Scalar, Dofs>*) {
  visit("noise", c.noise);
  visit("noise_correlation_time", c.noise_correlation_time);
  visit("offset", c.offset);
  visit("stiction", c.stiction);
  visit("coulomb_mean", c.coulomb_mean);
  visit("coulomb_std", c.coulomb_std);
  visit("viscous_mean", c.viscous_mean);
  visit("viscous_std", c.viscous_std);
}
template <typename Config, typename Visit>
void visit_fields(Config& c, Visit&& visit, const PushPrior*) {
  visit("force", c.force);
  visit("moment", c.moment);
}
template <typename Config, typename Visit>
void visit_fields(Config& c, Visit&& visit, const VariationalInferenceConfig*) {
  visit("max_iterations", c.max_iterations);
  visit("tolerance", c.tolerance);
}
template <typename Config, typename Visit, typename Scalar, int Dofs>
void visit_fields(Config& c, Visit&& visit, const EventEstimatorConfig<Scalar, Dofs>*) {
  visit("gravity", c.gravity);
  visit("torque_sign", c.torque_sign);
  visit("detector", c.detector);
  visit("watch_norm", c.watch_norm);
  visit("window", c.window);
  visit("sensors", c.sensors);
  visit("collection", c.collection);
  visit("baseline", c.baseline);
  visit("baseline_guard", c.baseline_guard);
  visit("onset_span", c.onset_span);
  visit("onset_jump", c.onset_jump);
  visit("onset_guard", c.onset_guard);
  visit("unrest", c.unrest);
  visit("odds", c.odds);
  visit("refresh", c.refresh);
  visit("early_window", c.early_window);
  visit("gentle_window", c.gentle_window);
  visit("early_odds", c.early_odds);
  visit("early_excess", c.early_excess);
  visit("gyration_radius", c.gyration_radius);
  visit("learn_noise", c.learn_noise);
  visit("push", c.push);
  visit("inference", c.inference);
}

[[noreturn]] inline void refuse_field(const std::string& path, const char* expected, const nlohmann::json& got) {
  refuse(path + ": expected " + expected + ", got " + describe(got));
}

inline void read_field(const nlohmann::json& json, const std::string& path, double& out) {
  if (!json.is_number()) refuse_field(path, "a number", json);
  out = json.get<double>();
}
inline void read_field(const nlohmann::json& json, const std::string& path, float& out) {
  // A float cannot hold every number, and what becomes of the others is undefined.
  if (!json.is_number() || !(std::abs(json.get<double>()) <= double(std::numeric_limits<float>::max())))
    refuse_field(path, "a number that a float can hold", json);
  out = json.get<float>();
}
inline void read_field(const nlohmann::json& json, const std::string& path, int& out) {
  if (!json.is_number_integer() || json > std::numeric_limits<int>::max() || json < std::numeric_limits<int>::min())
    refuse_field(path, "an integer", json);
  out = json.get<int>();
}
inline void read_field(const nlohmann::json& json, const std::string& path, bool& out) {
  if (!json.is_boolean()) refuse_field(path, "true or false", json);
  out = json.get<bool>();
}
inline void read_field(const nlohmann::json& json, const std::string& path, TorqueSign& out) {
  if (json == "external")
    out = TorqueSign::External;
  else if (json == "reaction")
    out = TorqueSign::Reaction;
  else
    refuse_field(path, "\"external\" or \"reaction\"", json);
}
template <typename Vector>
void read_numbers(const nlohmann::json& json, const std::string& path, std::size_t size, Vector& out) {
  if (!json.is_array() || json.size() != size)
    refuse_field(path, ("an array of " + std::to_string(size) + " numbers").c_str(), json);
  for (std::size_t i = 0; i < size; ++i)
    read_field(json[i], path + "[" + std::to_string(i) + "]", out[static_cast<typename Eigen::Index>(i)]);
}
template <std::size_t Size>
void read_field(const nlohmann::json& json, const std::string& path, std::array<double, Size>& out) {
  Eigen::Map<Eigen::Matrix<double, int(Size), 1>> map(out.data());
  read_numbers(json, path, Size, map);
}
template <typename Scalar, int Size>
void read_field(const nlohmann::json& json, const std::string& path, Eigen::Matrix<Scalar, Size, 1>& out) {
  read_numbers(json, path, std::size_t(Size), out);
}
template <typename Config>
void read_fields(const nlohmann::json& json, const std::string& path, bool all, Config& out);
template <typename Scalar, int Dofs>
void read_field(const nlohmann::json& json, const std::string& path, std::vector<SensorModel<Scalar, Dofs>>& out) {
  if (!json.is_array() || json.empty()) refuse_field(path, "an array of one to four sensor models", json);
  out.clear();
  for (std::size_t i = 0; i < json.size(); ++i) {
    const std::string at = path + "[" + std::to_string(i) + "]";
    if (json[i] == "link_side") {
      out.push_back(SensorModel<Scalar, Dofs>::link_side());
    } else if (json[i] == "joint_friction") {
      out.push_back(SensorModel<Scalar, Dofs>::joint_friction());
    } else if (json[i].is_object()) {
      out.push_back(SensorModel<Scalar, Dofs>::link_side());
      read_fields(json[i], at, true, out.back());
    } else {
      refuse_field(at, "\"link_side\", \"joint_friction\" or an object", json[i]);
    }
  }
}
template <typename Config>  // a struct: whatever no overload above takes
void read_field(const nlohmann::json& json, const std::string& path, Config& out) {
  read_fields(json, path, false, out);
}

template <typename Config>
void read_fields(const nlohmann::json& json, const std::string& path, bool all, Config& out) {
  if (!json.is_object()) refuse_field(path.empty() ? "the configuration" : path, "an object", json);
  const auto at = [&path](const std::string& key) { return path.empty() ? key : path + "." + key; };
  std::set<std::string> known;
  visit_fields(
      out,
      [&](const char* key, auto& field) {
        known.insert(key);
        if (json.contains(key))
          read_field(json.at(key), at(key), field);
        else if (all)
          refuse(at(key) + ": missing");
      },
      static_cast<Config*>(nullptr));
  for (const auto& [key, value] : json.items())
    if (known.count(key) == 0) refuse(at(key) + ": unknown field");
}

template <typename Scalar, int Dofs>
nlohmann::json write_field(const std::vector<SensorModel<Scalar, Dofs>>& sensors);
template <typename Field>
nlohmann::json write_field(const Field& field) {
  if constexpr (std::is_arithmetic_v<Field> || std::is_convertible_v<Field, std::array<double, 3>>) {
    return field;
  } else if constexpr (std::is_same_v<Field, TorqueSign>) {
    return field == TorqueSign::External ? "external" : "reaction";
  } else if constexpr (std::is_base_of_v<Eigen::MatrixBase<Field>, Field>) {
    return std::vector<typename Field::Scalar>(field.data(), field.data() + field.size());
  } else {
    nlohmann::json out = nlohmann::json::object();
    visit_fields(
        field, [&out](const char* key, const auto& value) { out[key] = write_field(value); },
        static_cast<Field*>(nullptr));
    return out;
  }
}
template <typename Scalar, int Dofs>
nlohmann::json write_field(const std::vector<SensorModel<Scalar, Dofs>>& sensors) {
  nlohmann::json out = nlohmann::json::array();
  for (const auto& sensor : sensors) out.push_back(write_field(sensor));
  return out;
}

}  // namespace detail

template <typename Scalar, int Dofs>
EventEstimatorConfig<Scalar, Dofs> event_estimator_config_from_json(const nlohmann::json& object) {
  EventEstimatorConfig<Scalar, Dofs> config;
  detail::read_fields(object, "", false, config);
  return config;
}

template <typename Scalar, int Dofs>
nlohmann::json event_estimator_config_to_json(const EventEstimatorConfig<Scalar, Dofs>& config) {
  return detail::write_field(config);
}

}  // namespace rme
