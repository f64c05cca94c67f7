#pragma once
/// The command-line options that every program which replays logs understands.
#include <algorithm>
#include <optional>
#include <rme/estimator_json.hpp>
#include <string>

#include "io/arguments.hpp"
#include "replay_log/replay.hpp"
#include "run_network/json_file.hpp"
#include "run_network/network_file.hpp"

namespace rme::examples {

constexpr const char* kReplayUsage =
    "  --at T              estimate from the samples [T, T + window), whatever the detector says [s]\n"
    "  --window S          how long samples are collected [s] (0.2)\n"
    "  --baseline B        auto (default), none, or T0:T1, when the hand is known to be empty [s]\n"
    "  --config C.json     settings of the estimator (rme/estimator_json.hpp); other options go before them\n"
    "  --weights W.json    a network's guess as the prior, in place of the fixed one\n"
    "  --preset NAME       sensing of the arm: unknown (default), link_side, joint_friction\n"
    "  --detector NAME     robust (default), or published: Algorithm 1 to the letter\n";

/// All that the options below say.
struct ReplayRequest {
  ReplayOptions options;
  std::optional<NetworkFile> weights;

  /// The prior that the command line asks for: a network's guess, or the fixed one.
  AnyPrior prior(const Log<7>& log) const { return weights ? AnyPrior(*weights, nominal_period(log.t)) : AnyPrior(); }
};

/// What `make` returns; its errors name the file.
template <typename Make>
auto named(const std::string& file, Make&& make) {
  try {
    return make();
  } catch (const std::invalid_argument& error) {
    throw ArgumentError(file + ": " + error.what());
  }
}

/// The settings that a file holds.
inline EstimatorConfig<double, 7> read_estimator(const std::string& file) {
  return named(file, [&] { return estimator_config_from_json<double, 7>(read_json_file(file)); });
}

/// Takes --config and --preset out of `arguments`.
/// @throws ArgumentError naming what is wrong
inline EstimatorConfig<double, 7> parse_estimator(Arguments& arguments) {
  EstimatorConfig<double, 7> estimator;
  if (const auto file = arguments.text("--config")) estimator = read_estimator(*file);
  const std::string preset = arguments.text("--preset").value_or("");
  if (preset == "link_side")
    estimator.sensors = {SensorModel<double, 7>::link_side()};
  else if (preset == "joint_friction")
    estimator.sensors = {SensorModel<double, 7>::joint_friction()};
  else if (preset == "unknown")
    estimator.sensors = EstimatorConfig<double, 7>().sensors;
  else if (!preset.empty())
    throw ArgumentError("--preset: \"" + preset + "\" is none of unknown, link_side, joint_friction");
  return estimator;
}

/// Takes the options above out of `arguments`.
/// @throws ArgumentError naming what is wrong
inline ReplayRequest parse_replay_options(Arguments& arguments) {
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
  estimator.validate(1e-3);
  return request;
}

}  // namespace rme::examples
