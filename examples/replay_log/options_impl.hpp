#pragma once
/// Implementation of options.hpp, for replay_dofs.cpp.in, which compiles it for each number of joints.
#include <cstdio>
#include <rme/estimator_json.hpp>
#include <stdexcept>

#include "io/json_file.hpp"
#include "io/number.hpp"
#include "replay_log/options.hpp"
#include "replay_log/settings_model.hpp"

namespace rme::examples {

namespace detail {

/// What `make` returns; its errors name the file or options that caused them.
template <typename Make>
auto named(const std::string& given, Make&& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    throw ArgumentError(given + ": " + error.what());
  }
}

}  // namespace detail

template <int Dofs>
ArmSettings<Dofs> parse_settings(Arguments& arguments, const ArmRequest& given) {
  ArmRequest request = given;
  ArmSettings<Dofs> settings;
  EstimatorConfig<double, Dofs>& config = settings.config;
  bool rated = false;
  if (const auto file = arguments.text("--config")) {
    const nlohmann::json json = read_json_file(*file);
    config = detail::named(*file, [&] { return estimator_config_from_json<double, Dofs>(json); });
    rated = json.contains("rated_payload");
    if (json.contains("model")) {
      settings.notes.push_back(use_model(json.at("model"), *file, request));
      settings.corrected = true;
    }
  }
  if (const auto sensing =
          arguments.choice<std::optional<Sensing>>("--preset", {{"unknown", std::nullopt},
                                                                {"link_side", Sensing::LinkSide},
                                                                {"joint_friction", Sensing::JointFriction},
                                                                {"rough_model", Sensing::RoughModel}}))
    config.sensing = *sensing;
  config.observer_bandwidth = arguments.number("--bandwidth").value_or(config.observer_bandwidth);
  settings.arm = recorded_arm<Dofs>(request, rated, config);
  settings.chain = request.chain;
  if (request.chain && !request.rated_payload && !rated) {
    char text[120];
    std::snprintf(text, sizeof text, "rated payload %.2g kg, from the effort limits; --rated-payload sets it",
                  config.rated_payload);
    settings.notes.emplace_back(text);
  }
  detail::named("options", [&] { config.validate(1e-3); });
  return settings;
}

template <int Dofs>
ReplayRequest<Dofs> parse_replay(Arguments& arguments, const ArmRequest& arm) {
  ReplayRequest<Dofs> request;
  ReplayOptions<Dofs>& options = request.options;
  const ArmSettings<Dofs> settings = parse_settings<Dofs>(arguments, arm);
  options.arm = settings.arm;
  options.estimator = settings.config;
  request.notes = settings.notes;
  if (const auto file = arguments.text("--weights"))
    request.weights = detail::named(*file, [&] { return read_network_file(*file); });
  options.at = arguments.number("--at");
  options.window = arguments.number("--window").value_or(options.window);
  if (!(options.window >= 0.002 && options.window <= 60)) throw ArgumentError("--window: must be 0.002 to 60 s");
  const std::string baseline = arguments.text("--baseline").value_or("auto");
  if (baseline != "none" && baseline != "auto") {
    const std::size_t colon = baseline.find(':');
    const auto t0 = parse_number(baseline.substr(0, colon));
    const auto t1 = colon == std::string::npos ? std::nullopt : parse_number(baseline.substr(colon + 1));
    if (!t0 || !t1 || !(*t0 < *t1))
      throw ArgumentError("--baseline: \"" + baseline + "\" is none of auto, none, T0:T1 with T0 < T1");
    if (options.at && *t1 > *options.at) throw ArgumentError("--baseline: \"" + baseline + "\" ends after --at");
    options.empty_at = *t1;
  }
  return request;
}

}  // namespace rme::examples
