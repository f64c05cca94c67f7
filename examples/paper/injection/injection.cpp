// injection: are the intervals honest on a real arm? Payloads added to a recording in which the hand was empty.
//
// No log of a real arm comes with a hundred payloads whose truth is known, but one without any is easily had. A payload
// of known mass and centre of mass exerts a known joint torque, inertia force included: added to what was recorded from
// an instant on, it is what the arm would have reported had it moved the same. Noise, friction and the errors of the
// arm's model stay those of the real arm.
//
// Printed are, over windows at random instants: what is estimated where nothing was injected; payloads of 0 to 1.5 kg
// with the instant known to the estimator, and with the instant left to the detector; and how often the detector finds
// something in the log as it is. Windows overlap where the log is short, so that their errors are not independent.
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "event_replay/options.hpp"
#include "io/program.hpp"
#include "paper/calibration/scores.hpp"
#include "paper/injection/payload_injection.hpp"

namespace {

using namespace rme::examples;
using Config = rme::EventEstimatorConfig<double, 7>;

constexpr const char* kUsage =
    R"(usage: rme_injection LOG.csv[.gz] [options]

Adds payloads to a log in which the hand is empty, and says how good and how honest the estimates are.

  --windows N         instants at which a payload is added, in turn (default 100)
  --config C.json     settings of the estimator (rme/event_estimator_json.hpp), as identify_noise measures them
  --preset NAME       sensing of the arm: unknown (default), link_side, joint_friction
  --span T0:T1        only what the log holds of [T0, T1) [s]
  --seed N            of everything random (default 1)
  --output DIR        write injection.csv there; the folder is made if need be. plot.py draws it
  --help              this text

Exit codes: 0 done; 2 unusable arguments; 3 unusable log.
)";

constexpr double kBefore = 1.5, kAfter = 2;  // the log is played from and to around an instant, if it is that long [s]

struct Options {
  std::string log;
  Config config;
  std::size_t windows = 100;
  std::uint64_t seed = 1;
  std::optional<std::vector<double>> span;
  std::optional<std::string> output;
};

Options parse(Arguments& arguments) {
  Options options;
  options.windows = arguments.whole("--windows", 1, 1000000).value_or(options.windows);
  options.seed = arguments.whole("--seed", 0).value_or(options.seed);
  options.span = arguments.numbers("--span", 2, ':');
  if (options.span && !((*options.span)[0] < (*options.span)[1])) throw ArgumentError("--span: T0 must be below T1");
  options.output = arguments.text("--output");
  options.config = parse_estimator(arguments);
  options.config.validate(1e-3);
  options.log = arguments.positional("LOG.csv");
  arguments.finish();
  return options;
}

/// Instants and payloads of one table: the same in all that have payloads.
std::vector<Injected> draw(const Options& options, const Recording& recording, bool empty) {
  std::mt19937_64 random(options.seed);
  const auto uniform = [&random](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const double duration = static_cast<double>(recording.ticks.size()) * recording.dt;
  const double first = std::min(kBefore, duration / 2), last = duration - std::min(kAfter, duration / 2);
  if (last + options.config.collection > duration || last < first)
    throw LogError("the log is shorter than two collections");
  std::vector<Injected> out;
  for (std::size_t i = 0; i < options.windows; ++i) {
    Injected injected;
    injected.row = static_cast<std::size_t>(uniform(first, last) / recording.dt);
    injected.payload.mass = uniform(0, 1.5);
    for (int k = 0; k < 2; ++k) injected.payload.com[k] = uniform(-0.08, 0.08);
    injected.payload.com[2] = uniform(0, 0.2);
    injected.gyration_radius = uniform(0.015, 0.04);  // boxes of 4 to 10 cm
    if (empty) injected.payload = rme::Payload<double>();
    out.push_back(injected);
  }
  return out;
}

/// One table: the estimates of all windows.
struct Table {
  const char* name;
  std::vector<double> t;       // of the instants of those estimated [s]
  std::vector<Scored> scored;  // an empty hand as a mass of 0
  std::vector<Scored> held;    // without those: an empty hand has no centre of mass
  int refused = 0, unnoticed = 0;
};

Table estimate(const char* name, const Options& options, const Recording& recording,
               const std::vector<Injected>& injections, bool known) {
  Table table{name, {}, {}, {}, 0, 0};
  for (const Injected& injected : injections) {
    const Outcome outcome = estimate_injected(recording, options.config, injected, kBefore, kAfter, known);
    if (!outcome.scored) {
      ++(outcome.refused > 0 ? table.refused : table.unnoticed);
      continue;
    }
    table.t.push_back(recording.t[injected.row]);
    table.scored.push_back(*outcome.scored);
    if (!outcome.empty) table.held.push_back(*outcome.scored);
  }
  return table;
}

void print(const Table& table, bool with_com) {
  std::printf("\n%s: %zu estimates, %zu of them of an empty hand; %d refused, %d not noticed\n", table.name,
              table.scored.size(), table.scored.size() - table.held.size(), table.refused, table.unnoticed);
  if (table.scored.empty()) return;
  std::printf("%-9s %7s %7s %7s |%7s%7s%7s%7s  %% hold |%11s\n", "", "mae", "rms", "bias", "50", "80", "90", "95",
              "half width");
  for (int i = 0; i < (with_com ? 4 : 1); ++i) {
    const std::vector<Scored>& scored = i == 0 ? table.scored : table.held;
    if (scored.empty()) return;
    const Summary s = summarise(scored, i);
    std::printf("%-9s %7.2f %7.2f %7.2f |", kParameters[static_cast<std::size_t>(i)], s.mean_absolute, s.rms, s.bias);
    for (const double coverage : s.coverage) std::printf("%7.1f", coverage);
    std::printf("         |%11.2f\n", s.half_width);
  }
}

void write_csv(const std::filesystem::path& folder, const std::vector<Table>& tables) {
  std::ofstream file(folder / "injection.csv");
  file << "table,t,mass,x,y,z,mass_error,x_error,y_error,z_error,mass_std,x_std,y_std,z_std\n";
  const Eigen::IOFormat cells(Eigen::StreamPrecision, Eigen::DontAlignCols, ",", ",");
  for (const Table& table : tables)
    for (std::size_t i = 0; i < table.scored.size(); ++i) {
      const Scored& s = table.scored[i];
      file << table.name << ',' << table.t[i] << ',' << s.truth.format(cells) << ',' << s.error.format(cells) << ','
           << s.deviation.format(cells) << '\n';
    }
  if (!file.flush()) throw LogError("--output: cannot write to " + folder.string());
}

/// What the detector finds in the log as it is.
void print_false_estimates(const Options& options, const Recording& recording) {
  rme::EventEstimator<double, 7> estimator(recording.dt, options.config);
  int estimates = 0, rejected = 0;
  for (const auto& tick : recording.ticks) {
    if (estimator.update(tick) != rme::Status::Ok) continue;
    if (estimator.estimated() && !estimator.estimate().empty) ++estimates;
    if (estimator.rejected()) ++rejected;
  }
  const double minutes = static_cast<double>(recording.ticks.size()) * recording.dt / 60;
  std::printf("\nthe log as it is, %.1f s: %d false estimates (%.1f per minute), %d changes refused\n", 60 * minutes,
              estimates, estimates / minutes, rejected);
}

int run(Arguments& arguments) {
  const Options options = parse(arguments);
  if (options.output) make_folder("--output", *options.output);
  const Log<7> log = read_log<7>(options.log);
  require_external_torque(log);
  const Log<7> part = options.span ? cropped(log, (*options.span)[0], (*options.span)[1]) : log;
  if (part.size() < 2) throw LogError(log.name + ": has fewer than two rows, which gives no sample rate");
  require_empty_hand(part);
  const Recording recording = recording_of(part, options.config.window.observer_bandwidth);
  const auto nothing = draw(options, recording, true), payloads = draw(options, recording, false);
  std::vector<Table> tables;
  tables.push_back(estimate("nothing injected", options, recording, nothing, true));
  tables.push_back(estimate("instant known", options, recording, payloads, true));
  tables.push_back(estimate("instant detected", options, recording, payloads, false));
  for (const Table& table : tables) print(table, &table != &tables.front());
  print_false_estimates(options, recording);
  if (options.output) write_csv(*options.output, tables);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_injection", kUsage, argc, argv, run);
}
