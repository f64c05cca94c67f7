#include "event_replay/options.hpp"

#include <algorithm>
#include <fstream>
#include <rme/event_estimator_json.hpp>
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

EventEstimatorConfig<double, 7> read_estimator(const std::string& file) {
  return named(file, [&] { return event_estimator_config_from_json<double, 7>(read_json_file(file)); });
}

void write_estimator(const std::string& file, const EventEstimatorConfig<double, 7>& settings) {
  std::ofstream stream(file);
  stream << event_estimator_config_to_json(settings).dump(2) << "\n";
  if (!stream.flush()) throw LogError(file + ": cannot be written");
}

EventEstimatorConfig<double, 7> parse_estimator(Arguments& arguments) {
  EventEstimatorConfig<double, 7> estimator;
  if (const auto file = arguments.text("--config")) estimator = read_estimator(*file);
  const std::string preset = arguments.text("--preset").value_or("");
  if (preset == "link_side")
    estimator.sensors = {SensorModel<double, 7>::link_side()};
  else if (preset == "joint_friction")
    estimator.sensors = {SensorModel<double, 7>::joint_friction()};
  else if (preset == "unknown")
    estimator.sensors = EventEstimatorConfig<double, 7>().sensors;
  else if (!preset.empty())
    throw ArgumentError("--preset: \"" + preset + "\" is none of unknown, link_side, joint_friction");
  return estimator;
}

ReplayRequest parse_replay_options(Arguments& arguments) {
  ReplayRequest request;
  ReplayOptions& options = request.options;
  auto& estimator = options.estimator;
  estimator = parse_estimator(arguments);
  if (const auto file = arguments.text("--weights"))
    request.weights = named(*file, [&] { return read_network_file(*file); });
  options.at = arguments.number("--at");
  estimator.collection = arguments.number("--window").value_or(estimator.collection);
  const std::string detector = arguments.text("--detector").value_or("");
  if (detector == "published") {
    estimator.detector = MismatchDetectorConfig::published();
    estimator.watch_norm = true;
  }
  if (detector == "robust") {
    estimator.detector = MismatchDetectorConfig();
    estimator.watch_norm = false;
  }
  if (detector != "published" && detector != "robust" && !detector.empty())
    throw ArgumentError("--detector: \"" + detector + "\" is none of robust, published");
  const std::string baseline = arguments.text("--baseline").value_or("auto");
  if (baseline == "none") {
    estimator.baseline = 0;
  } else if (baseline != "auto") {
    const std::size_t colon = baseline.find(':');
    const auto t0 = parse_number(baseline.substr(0, colon));
    const auto t1 = colon == std::string::npos ? std::nullopt : parse_number(baseline.substr(colon + 1));
    if (!t0 || !t1 || !(*t0 < *t1))
      throw ArgumentError("--baseline: \"" + baseline + "\" is none of auto, none, T0:T1 with T0 < T1");
    if (options.at && *t1 > *options.at) throw ArgumentError("--baseline: \"" + baseline + "\" ends after --at");
    options.baseline = {*t0, *t1};
  }
  // The window must hold whatever was asked for.
  const double tare = options.baseline ? options.baseline->second - options.baseline->first : 0;
  estimator.window.duration =
      std::max(estimator.window.duration, estimator.detector.window + std::max(estimator.collection, tare) + 0.5);
  if (estimator.window.duration > 60) throw ArgumentError("--window and --baseline must be shorter than a minute");
  named("options", [&] { estimator.validate(1e-3); });
  return request;
}

}  // namespace rme::examples
