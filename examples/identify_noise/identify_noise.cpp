// identify_noise: what is this arm's torque sensing like? Measured from recordings in which the hand is empty.
//
// Reads the logs that replay_log reads, and prints for each joint the numbers of rme::SensorModel beside those of the
// presets. With --output it writes the settings of an estimator for this arm: that sensor model, and thresholds that
// nothing in the logs would have crossed. replay_log --config reads them. The logs should show what the arm does at
// work: each joint in both directions, slowly and fast, with stops. Exit codes: 0; 2 unusable arguments; 3 unusable
// log.
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "event_replay/options.hpp"
#include "identify_noise/sensor_identification.hpp"
#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Sensor = rme::SensorModel<double, 7>;

constexpr const char* kUsage =
    "usage: identify_noise LOG.csv[.gz]... [options]\n"
    "  --config C.json     settings of the estimator, of which the observer, gravity and the sign of the torque count\n"
    "  --preset NAME       kept where the logs say nothing: joint_friction (default), link_side\n"
    "  --span T0:T1        only what the logs hold of [T0, T1) [s]\n"
    "  --output C.json     write the settings there, with what was measured in them\n";

// Noise counts as uncorrelated over the shortest of these over which it is, nearly [s].
constexpr double kCorrelationTimes[] = {0.02, 0.05, 0.1};
constexpr double kUncorrelated = 0.1;

struct Request {
  std::vector<std::string> logs;
  rme::EventEstimatorConfig<double, 7> settings;
  Sensor preset = Sensor::joint_friction();
  std::optional<std::vector<double>> span;
  std::optional<std::string> output;
};

Request parse(Arguments& arguments) {
  Request request;
  if (const auto file = arguments.text("--config")) request.settings = read_estimator(*file);
  const std::string preset = arguments.text("--preset").value_or("joint_friction");
  if (preset == "link_side")
    request.preset = Sensor::link_side();
  else if (preset != "joint_friction")
    throw ArgumentError("--preset: \"" + preset + "\" is none of joint_friction, link_side");
  request.span = arguments.numbers("--span", 2, ':');
  if (request.span && !((*request.span)[0] < (*request.span)[1])) throw ArgumentError("--span: T0 must be below T1");
  request.output = arguments.text("--output");
  do request.logs.push_back(arguments.positional("LOG.csv"));
  while (!arguments.empty());
  return request;
}

std::vector<Log<7>> read(const Request& request) {
  std::vector<Log<7>> logs;
  for (const std::string& file : request.logs) {
    Log<7> log = read_log<7>(file);
    require_external_torque(log);
    if (request.span) log = cropped(log, (*request.span)[0], (*request.span)[1]);
    if (log.size() < 2) throw LogError(log.name + ": has fewer than two rows, which gives no sample rate");
    require_empty_hand(log);
    request.settings.validate(nominal_period(log.t));
    logs.push_back(log);
  }
  return logs;
}

/// The model with the shortest correlation time over which the noise is uncorrelated.
IdentifiedSensor identify(const std::vector<Log<7>>& logs, const Request& request) {
  IdentifiedSensor found;
  for (const double time : kCorrelationTimes) {
    Sensor preset = request.preset;
    preset.noise_correlation_time = time;
    SensorIdentification identification(preset, request.settings.collection);
    for (const Log<7>& log : logs) identification.add(blocks_of(log, request.settings, identification.block()));
    if (identification.windows() < SensorIdentification::kLeastWindows)
      throw LogError(logs.front().name + ": " + std::to_string(SensorIdentification::kLeastWindows) + " windows of " +
                     std::to_string(SensorIdentification::kWindow).substr(0, 3) + " s are needed, " +
                     (logs.size() > 1 ? "the logs hold " : "the log holds ") +
                     std::to_string(identification.windows()));
    found = identification.identify();
    if (found.correlation < kUncorrelated) break;
  }
  found.model.validate();
  return found;
}

void print(const IdentifiedSensor& found) {
  std::printf("%-29s", "joint");
  for (int j = 1; j <= 7; ++j) std::printf("%9d", j);
  std::printf("\n");
  const auto link_side = Sensor::link_side(), joint_friction = Sensor::joint_friction();
  std::array<bool, 7> always{};
  always.fill(true);
  const auto row = [&](const char* name, rme::JointVector<double, 7> Sensor::*field, const std::array<bool, 7>& known) {
    std::printf("%-29s", name);
    for (int j = 0; j < 7; ++j)
      std::printf("%8.4f%c", (found.model.*field)[j], known[static_cast<std::size_t>(j)] ? ' ' : '*');
    for (const auto& [preset, model] : {std::pair("link_side", link_side), {"joint_friction", joint_friction}}) {
      std::printf("\n  %-27s", preset);
      for (int j = 0; j < 7; ++j) std::printf("%8.4f ", (model.*field)[j]);
    }
    std::printf("\n");
  };
  row("noise [N m]", &Sensor::noise, always);
  row("offset [N m]", &Sensor::offset, always);
  row("stiction [N m]", &Sensor::stiction, found.stiction_known);
  row("coulomb_mean [N m]", &Sensor::coulomb_mean, found.coulomb_known);
  row("coulomb_std [N m]", &Sensor::coulomb_std, found.coulomb_known);
  row("viscous_mean [N m s/rad]", &Sensor::viscous_mean, found.viscous_known);
  row("viscous_std [N m s/rad]", &Sensor::viscous_std, found.viscous_known);
  std::printf("* the logs do not tell: from the preset\n");
  std::printf("noise_correlation_time %g s; neighbouring blocks correlate by %.2f at most\n",
              found.model.noise_correlation_time, found.correlation);
  std::printf("the empty hand looks like a payload by %.2f standard deviations (rms)%s\n", found.surprise,
              found.surprise > 1 ? ": all of them were widened by that" : "");
}

int run(Arguments& arguments) {
  const Request request = parse(arguments);
  const std::vector<Log<7>> logs = read(request);
  const IdentifiedSensor found = identify(logs, request);
  rme::EventEstimatorConfig<double, 7> settings = request.settings;
  const double span = std::min(2 * found.model.noise_correlation_time, settings.detector.window / 4);
  Restlessness restlessness;
  for (const Log<7>& log : logs) measure(log, settings, span, restlessness);
  settings.sensors = {found.model};
  raise_thresholds(restlessness, span, settings);
  print(found);
  std::printf("onset_jump %.2f N m, unrest %.2f N m, detector %s (activation_threshold %.2f N m)\n",
              settings.onset_jump, settings.unrest, restlessness.noticed ? "with longer means" : "as it was",
              settings.detector.activation_threshold);
  if (request.output) write_estimator(*request.output, settings);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("identify_noise", kUsage, argc, argv, run);
}
