// injection: are payloads found on a real arm, and do the intervals hold the truth? Adds simulated payloads to a
// recording in which the hand was empty.
//
// A log of a real arm with a hundred known payloads is hard to obtain, a log without payload is not. A payload of known
// mass and centre of mass exerts a known joint torque, inertial forces included. If this torque is added to the recorded
// one from an instant on, the sum is what the arm would have reported if it had made the same motion with the payload.
// Noise, friction and model errors remain those of the real arm.
//
// Prints the estimates 1 s (--after) after random instants at which nothing is injected; the same for payloads of a
// tenth to half of the rated payload, unannounced and announced with expect_change(); and the estimates in the log as it is.
// In a short log the windows overlap, so their errors are not independent.
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "io/program.hpp"
#include "paper/injection/payload_injection.hpp"
#include "replay_log/options.hpp"

namespace {

using namespace rme::examples;

constexpr const char* kUsage =
    "usage: rme_injection LOG.csv[.gz] [options]\n"
    "\n"
    "Adds payloads to a log in which the hand is empty, and prints the errors and how often the intervals hold the "
    "truth.\n"
    "\n";
constexpr const char* kOwnUsage =
    "  --windows N         number of instants at which a payload is added, one at a time (100)\n"
    "  --before S          how long the log is played before each instant [s] (5)\n"
    "  --after S           how long after it the estimate is compared with the truth [s] (1)\n"
    "  --span T0:T1        use only the log's rows of [T0, T1) [s]\n"
    "  --seed N            of everything random (1)\n"
    "  --output DIR        write injection.csv there; the folder is created if it does not exist. plot.py draws it\n"
    "\n"
    "Exit codes: 0 done; 2 unusable arguments; 3 unusable log.\n";

constexpr double kNinety = 1.6448536269514722;  // half width of a Gaussian's 90 % interval [standard deviations]

struct Options {
  std::size_t windows = 100, seed = 1;
  double before = 5, after = 1;  // [s]
  std::optional<std::vector<double>> span;
  std::optional<std::string> output;
};

Options parse(Arguments& arguments) {
  Options options;
  options.windows = arguments.whole("--windows", 1, 1000000).value_or(options.windows);
  options.seed = arguments.whole("--seed", 0).value_or(options.seed);
  options.before = arguments.number("--before").value_or(options.before);
  options.after = arguments.number("--after").value_or(options.after);
  if (!(options.before >= 0.1)) throw ArgumentError("--before: must be 0.1 s or more");
  if (!(options.after >= 0.05)) throw ArgumentError("--after: must be 0.05 s or more");
  options.span = arguments.numbers("--span", 2, ':');
  if (options.span && !((*options.span)[0] < (*options.span)[1])) throw ArgumentError("--span: T0 must be below T1");
  options.output = arguments.text("--output");
  return options;
}

/// The estimate at one instant and the truth.
struct Scored {
  double t;  // of the injection [s]
  Eigen::Vector4d truth, error, deviation;
  bool found;  // the hand is not empty
};

struct Table {
  const char* name;
  std::vector<Scored> scored;
  int pushes = 0;
};

/// Draws instants and payloads, which are the same in all tables.
std::vector<Injected> draw(const Options& options, const std::vector<double>& t, double rated) {
  std::mt19937_64 random(options.seed);
  const auto uniform = [&random](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const double first = t.front() + std::min(options.before, 0.5 * (t.back() - t.front()));
  const double last = t.back() - options.after - 0.05;
  if (!(last > first)) throw LogError("the log is shorter than what is played before and after an instant");
  std::vector<Injected> out;
  for (std::size_t i = 0; i < options.windows; ++i) {
    Injected injection;
    injection.t = uniform(first, last);
    rme::Payload<double> payload;
    payload.mass = uniform(0.1, 0.5) * rated;
    for (int k = 0; k < 2; ++k) payload.com[k] = uniform(-0.08, 0.08);
    payload.com[2] = uniform(0, 0.2);
    const double radius = uniform(0.015, 0.04);  // of gyration: boxes of 4 to 10 cm
    injection.payload =
        rme::InertialParameters<double>::of_body(payload, payload.mass * radius * radius * Eigen::Matrix3d::Identity());
    out.push_back(injection);
  }
  return out;
}

template <int Dofs>
Table estimate(const char* name, const Options& options, const Log<Dofs>& log, const Samples<Dofs>& samples,
               const ArmSettings<Dofs>& settings, const std::vector<Injected>& injections, bool empty, bool announced) {
  Table table{name, {}, 0};
  const auto motion = motion_of(log, samples);
  for (Injected injection : injections) {
    if (empty) injection.payload = {};
    const Samples<Dofs> played = injected(log, samples, motion, settings.arm.model.gravity_vector, injection,
                                          injection.t - options.before, injection.t + options.after);
    ReplayOptions<Dofs> replayed;
    replayed.arm = settings.arm;
    replayed.estimator = settings.config;
    if (announced) replayed.at = injection.t;
    replayed.window = 2 * options.after;  // longer than what is played, so that the last estimate counts
    Scored scored{injection.t, Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero(), false};
    const rme::Payload<double> truth = injection.payload.payload();
    scored.truth << truth.mass, truth.com;
    replay<Dofs>(
        log, played, replayed,
        [&](const ReplayedEstimate& e) {
          scored.error = e.state.payload.mean - scored.truth;
          scored.deviation = e.state.payload.standard_deviation();
          scored.found = !e.state.empty();
        },
        [&](const ReplayedPush& push) { table.pushes += push.t > injection.t ? 1 : 0; });
    table.scored.push_back(scored);
  }
  return table;
}

void print(const Table& table, bool with_com) {
  std::size_t found = 0;
  for (const Scored& s : table.scored) found += s.found ? 1 : 0;
  std::printf("\n%s: something is held in %zu of %zu; %d events taken for a push\n", table.name, found,
              table.scored.size(), table.pushes);
  std::printf("%-9s %7s %7s %7s | %9s | %11s\n", "", "mae", "rms", "bias", "90 % hold", "half width");
  const char* names[] = {"mass [g]", "x [mm]", "y [mm]", "z [mm]"};
  const auto n = static_cast<double>(table.scored.size());
  for (int i = 0; i < (with_com ? 4 : 1); ++i) {
    double absolute = 0, square = 0, bias = 0, held = 0, width = 0;
    for (const Scored& s : table.scored) {
      absolute += std::abs(s.error[i]) / n;
      square += s.error[i] * s.error[i] / n;
      bias += s.error[i] / n;
      held += std::abs(s.error[i]) <= kNinety * s.deviation[i] ? 1 / n : 0;
      width += kNinety * s.deviation[i] / n;
    }
    std::printf("%-9s %7.2f %7.2f %7.2f | %9.1f | %11.2f\n", names[i], 1e3 * absolute, 1e3 * std::sqrt(square),
                1e3 * bias, 100 * held, 1e3 * width);
  }
}

void write_csv(const std::filesystem::path& folder, const std::vector<Table>& tables) {
  std::ofstream file(folder / "injection.csv");
  file << "table,t,mass,x,y,z,mass_error,x_error,y_error,z_error,mass_std,x_std,y_std,z_std\n";
  const Eigen::IOFormat cells(Eigen::StreamPrecision, Eigen::DontAlignCols, ",", ",");
  for (const Table& table : tables)
    for (const Scored& s : table.scored)
      file << table.name << ',' << s.t << ',' << s.truth.format(cells) << ',' << s.error.format(cells) << ','
           << s.deviation.format(cells) << '\n';
  if (!file.flush()) throw LogError("--output: cannot write to " + folder.string());
}

/// What is estimated in the log as it is: false payloads, as the hand is empty.
template <int Dofs>
void print_false_payloads(const Log<Dofs>& log, const Samples<Dofs>& samples, const ArmSettings<Dofs>& settings) {
  ReplayOptions<Dofs> options;
  options.arm = settings.arm;
  options.estimator = settings.config;
  int attached = 0;
  double largest = 0;
  const ReplaySummary summary = replay<Dofs>(
      log, samples, options,
      [&](const ReplayedEstimate& e) {
        attached += e.final && !e.state.empty() ? 1 : 0;
        if (e.state.held > 0.9) largest = std::max(largest, e.state.payload.mean[0]);
      },
      [](const ReplayedPush&) {});
  std::printf(
      "\nthe log as it is, %.1f s: %d false payloads, the heaviest with 90 %% probability %.3f kg; %d changes taken "
      "for a "
      "push\n",
      log.t.back() - log.t.front(), attached, largest, summary.rejected);
}

template <int Dofs>
int run(Arguments& arguments, const ArmRequest& arm) {
  const ArmSettings<Dofs> settings = parse_settings<Dofs>(arguments, arm);
  const Options options = parse(arguments);
  const std::string file = arguments.positional("LOG.csv");
  arguments.finish();
  if (options.output) make_folder("--output", *options.output);
  for (const std::string& note : settings.notes) std::fprintf(stderr, "rme_injection: %s\n", note.c_str());
  Log<Dofs> log = read_log<Dofs>(file);
  require_external_torque(log);
  if (options.span) log = cropped(log, (*options.span)[0], (*options.span)[1]);
  if (log.size() < 2) throw LogError(log.name + ": has fewer than two rows, which gives no sample rate");
  require_empty_hand(log);
  const Samples<Dofs> samples = samples_of(log, settings.arm, settings.config);
  const auto injections = draw(options, log.t, settings.config.rated_payload);
  std::vector<Table> tables;
  tables.push_back(estimate("nothing injected", options, log, samples, settings, injections, true, false));
  tables.push_back(estimate("payload", options, log, samples, settings, injections, false, false));
  tables.push_back(estimate("payload announced", options, log, samples, settings, injections, false, true));
  for (const Table& table : tables) print(table, &table != &tables.front());
  print_false_payloads(log, samples, settings);
  if (options.output) write_csv(*options.output, tables);
  return 0;
}

int run(Arguments& arguments) {
  const ArmRequest arm = parse_arm(arguments);
  return with_joint_count(arm.dofs(), [&](auto dofs) { return run<dofs()>(arguments, arm); });
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_injection", std::string(kUsage) + kArmUsage + kSettingsUsage + kOwnUsage, argc, argv, run);
}
