#include "replay_log/options.hpp"

#include <rme/estimator_json.hpp>
#include <stdexcept>

#include "run_network/json_file.hpp"

namespace rme::examples {

namespace {

/// What `make` returns; its errors name what the command line gave.
template <typename Make>
auto named(const std::string& given, Make&& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    throw ArgumentError(given + ": " + error.what());
  }
}

}  // namespace

EstimatorConfig<double, 7> parse_estimator_config(Arguments& arguments) {
  EstimatorConfig<double, 7> config;
  if (const auto file = arguments.text("--config"))
    config = named(*file, [&] { return estimator_config_from_json<double, 7>(read_json_file(*file)); });
  const std::string preset = arguments.text("--preset").value_or("");
  if (preset == "link_side")
    config.sensing = Sensing::LinkSide;
  else if (preset == "joint_friction")
    config.sensing = Sensing::JointFriction;
  else if (preset == "unknown")
    config.sensing = std::nullopt;
  else if (!preset.empty())
    throw ArgumentError("--preset: \"" + preset + "\" is none of unknown, link_side, joint_friction");
  config.rated_payload = arguments.number("--rated-payload").value_or(config.rated_payload);
  named("options", [&] { config.validate(1e-3); });
  return config;
}

ReplayRequest parse_replay(Arguments& arguments) {
  ReplayRequest request;
  ReplayOptions& options = request.options;
  options.estimator = parse_estimator_config(arguments);
  if (const auto file = arguments.text("--weights"))
    request.weights = named(*file, [&] { return read_network_file(*file); });
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
