// replay_log: plays a recording of an arm through the estimator, and prints what rme would have estimated, and when.
//
// Reads a CSV log (plain or gzip) of a Franka Panda, or of the arm that --urdf describes. Columns are found by their
// names: t, q1.. and either tau_ext1.., or tau1.. (measured torque, gravity included, or motor current), those of other
// recorders, or those of --columns; optional are dq1.. and the truth m, rx, ry, rz. If something is wrong with the log,
// it says what, and which command mends it. Otherwise it prints a table with a line for each event, also for one that is
// not over when the log ends, or with --json each estimate as one JSON object per line. With --compare, other methods
// (examples/rivals/rivals.hpp) estimate the mass in the same log, too. Assumptions and irregular time stamps are
// reported on stderr, or with --json in objects of type "note". Exit codes: 0; 1 something is wrong with a log;
// 2 unusable arguments; 3 unreadable log or URDF.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <limits>
#include <nlohmann/json.hpp>
#include <optional>
#include <string>
#include <vector>

#include "io/program.hpp"
#include "log_diagnosis/recorded_log.hpp"
#include "replay_log/options.hpp"
#include "rivals/rivals.hpp"

namespace {

using namespace rme::examples;
using nlohmann::ordered_json;
using rme::Mode;

constexpr const char* kUsage = "usage: replay_log LOG.csv[.gz] [options]\n";
constexpr const char* kOwnUsage =
    "  --json              print each estimate as one JSON object per line\n"
    "  --compare           other methods estimate the mass as well; the published pipeline needs --weights\n"
    "  --tare LOG.csv      with --compare: log of an empty hand, from which the others have offset and friction\n";

/// Log odds of a payload, or an empty hand, against a push [nats].
double log_odds(const rme::EstimatorState<double>& state) {
  const double pushed = std::clamp(state.probability[Mode::Disturbed], 1e-12, 1 - 1e-12);
  return std::log((1 - pushed) / pushed);
}

const char* kind_of(const ReplayedEstimate& e) {
  return e.state.changing ? "changing" : to_string(e.state.event.kind);
}

template <typename Vector>
std::vector<double> list(const Vector& v) {
  return std::vector<double>(v.data(), v.data() + v.size());
}

ordered_json to_json(const ReplayedEstimate& e, const ordered_json& network) {
  const auto& p = e.state.payload;
  ordered_json covariance, probability;
  for (int row = 0; row < 4; ++row) covariance.push_back(list(rme::Vector4<double>(p.covariance.row(row))));
  for (std::size_t i = 0; i < rme::kModes; ++i)
    probability[to_string(static_cast<Mode>(i))] = e.state.probability.values[i];
  ordered_json out;
  out["type"] = "estimate";
  out["event"] = e.event;
  out["final"] = e.final;
  out["kind"] = kind_of(e);
  out["t"] = e.t;
  out["detected_at"] = e.detected_at ? ordered_json(*e.detected_at) : ordered_json(nullptr);
  out["window"] = {e.window_begin, e.window_end};
  out["mass"] = p.mean[0];
  out["com"] = list(p.payload().com);
  out["std"] = list(p.standard_deviation());
  out["covariance"] = covariance;
  out["log_odds"] = log_odds(e.state);
  out["elapsed_us"] = e.elapsed_us;
  out["excess"] = e.state.health;
  out["probability"] = probability;
  out["held"] = e.state.held;
  out["health"] = e.state.health;
  out["confidence"] = e.state.confidence;
  out["inertial"] = list(e.state.inertial.mean);
  out["truth"] = e.truth ? ordered_json(list(*e.truth)) : ordered_json(nullptr);
  if (!network.is_null()) out["network"] = network;
  return out;
}

ordered_json to_json(const ReplayedPush& r) {
  const auto evidence = [&](Mode h) { return std::log(std::max(r.state.probability[h], 1e-12)); };
  ordered_json out;
  out["type"] = "rejected";
  out["kind"] = "pushed";
  out["t"] = r.t;
  out["detected_at"] = r.detected_at;
  out["log_odds"] = log_odds(r.state);
  out["log_evidence"] = {{"payload", evidence(Mode::Changing)},
                         {"empty", evidence(Mode::Empty)},
                         {"unchanged", evidence(Mode::Held)},
                         {"push", evidence(Mode::Disturbed)}};
  return out;
}

/// What the likeliest mode of an event that goes on is called.
const char* ongoing_kind(const rme::EstimatorState<double>& state) {
  const auto& p = state.probability;
  if (p[Mode::Disturbed] >= std::max(p[Mode::Changing], p[Mode::Pouring])) return "pushed";
  return p[Mode::Changing] >= p[Mode::Pouring] ? "changing" : "filling";
}

/// An event that is not over at the end of the log.
ordered_json ongoing_json(const ReplayedEstimate& last) {
  return {{"type", "ongoing"},
          {"kind", ongoing_kind(last.state)},
          {"t", last.t},
          {"detected_at", *last.detected_at},
          {"mass", last.state.payload.mean[0]}};
}

void print_ongoing(const ReplayedEstimate& last) {
  std::printf("    - %8.3f %8s  %7.3f +- %5.3f  %s, not over at the end of the log, %.1f s later: health %.1f\n",
              *last.detected_at, "-", last.state.payload.mean[0], last.state.payload.standard_deviation()[0],
              ongoing_kind(last.state), last.t - *last.detected_at, last.state.health);
}

/// Mean over time of the mass error [kg]; NaN if the log has no truth.
template <int Dofs>
double mean_error(const Rival& method, const Log<Dofs>& log) {
  if (log.truth.empty()) return std::numeric_limits<double>::quiet_NaN();
  double sum = 0;
  std::size_t row = 0, estimate = 0;
  for (; row < log.size(); ++row) {
    while (estimate + 1 < method.masses.size() && method.masses[estimate + 1].t <= log.t[row]) ++estimate;
    const bool any = method.masses[estimate].t <= log.t[row];
    sum += std::abs((any ? method.masses[estimate].mass : 0) - log.truth[row][0]);
  }
  return sum / static_cast<double>(log.size());
}

template <int Dofs>
void print(const std::vector<Rival>& methods, const Log<Dofs>& log) {
  std::printf("\n%-24s %20s  %s\n", "by", "mass at the end [kg]", log.truth.empty() ? "" : "mean error [kg]");
  for (const Rival& method : methods) {
    std::printf("%-24s %20.3f", method.name.c_str(), method.masses.back().mass);
    if (!log.truth.empty() && method.masses.size() > 1) std::printf("  %15.3f", mean_error(method, log));
    std::printf("\n");
  }
}

void print_row(const ReplayedPush& r) {
  std::printf("    - %8.3f %8.3f  pushed\n", r.detected_at, r.t);
}

void print_row(const ReplayedEstimate& e) {
  if (!e.final) return;
  const auto& p = e.state.payload;
  const rme::Vector4<double> sd = p.standard_deviation();
  std::printf("%5d %8.3f %8.3f  %7.3f +- %5.3f", e.event, e.detected_at.value_or(e.window_begin), e.t, p.mean[0],
              sd[0]);
  for (int i = 1; i < 4; ++i) std::printf("  %7.1f +- %5.1f", 1e3 * p.mean[i], 1e3 * sd[i]);
  std::printf("  %8.1f  %s\n", e.elapsed_us, to_string(e.state.event.kind));
  if (!e.truth) return;
  std::printf("%5s %8s %8s  %7.3f %8s", "", "", "truth", (*e.truth)[0], "");
  for (int i = 1; i < 4; ++i) std::printf("  %7.1f %8s", 1e3 * (*e.truth)[i], "");
  std::printf("\n");
}

/// The network's output (m, r) for the 200 ms that end at `t`, or null if there are too few samples.
template <int Dofs>
ordered_json guess_of(const NetworkFile& file, const Log<Dofs>& log, const Samples<Dofs>& samples, double t) {
  const double dt = samples.timing.period;
  const auto later = [&](double limit, std::size_t row) { return limit < log.t[row]; };
  const auto end = std::upper_bound(samples.row.begin(), samples.row.end(), t + 0.5 * dt, later);
  const auto count = std::lround(0.2 / dt), first = end - samples.row.begin() - count;
  if (first < 0) return nullptr;
  const auto guess = file.guess<Dofs>(static_cast<int>(count), [&](int i) -> const rme::Proprioception<double, Dofs>& {
    return samples.sample[static_cast<std::size_t>(first + i)];
  });
  return guess ? ordered_json(list(*guess)) : ordered_json(nullptr);
}

/// Whether the log can be right. If not, says what is wrong, and which command mends it.
/// @param may_hold  the hand may hold something
template <int Dofs>
bool judge(const FormattedLog<Dofs>& log, const ReplayOptions<Dofs>& options, const LogFormat& format, bool may_hold,
           const Arguments& arguments) {
  const Diagnosis diagnosis = diagnose(log, options.arm, options.estimator, format, may_hold);
  if (diagnosis.usable()) return true;
  std::fprintf(stderr, "replay_log: %s: %s\n", log.log.name.c_str(), diagnosis.sentence().c_str());
  if (!diagnosis.options().empty())
    std::fprintf(stderr, "try: replay_log %s\n", arguments.with(diagnosis.options()).c_str());
  return false;
}

template <int Dofs>
int run(Arguments& arguments, const ArmRequest& arm) {
  const bool json = arguments.flag("--json"), compare = arguments.flag("--compare");
  const auto tare = arguments.text("--tare");
  if (tare && !compare) throw ArgumentError("--tare: means nothing without --compare");
  const ReplayRequest<Dofs> request = parse_replay<Dofs>(arguments, arm);
  const LogFormat format = parse_format(arguments);
  const std::string file = arguments.positional("LOG.csv");
  arguments.finish();
  const std::vector<std::string> joints = joint_names(arm);
  const FormattedLog<Dofs> read = read_formatted_log<Dofs>(file, format, joints);
  if (!judge(read, request.options, format, true, arguments)) return 1;
  const Log<Dofs>& log = read.log;
  std::vector<std::string> notes = request.notes;
  for (const std::string& note : read.notes) notes.push_back(log.name + ": " + note);
  std::optional<FormattedLog<Dofs>> empty;
  if (tare) {
    empty = read_formatted_log<Dofs>(*tare, format, joints);
    require_empty_hand(empty->log);
    if (!judge(*empty, request.options, format, false, arguments)) return 1;
    for (const std::string& note : empty->notes) notes.push_back(empty->log.name + ": " + note);
  }
  const Samples<Dofs> samples = samples_of(log, request.options.arm, request.options.estimator);
  for (const std::string& note : samples.timing.notes()) notes.push_back(log.name + ": " + note);
  for (const std::string& note : notes) {
    if (json)
      std::cout << ordered_json({{"type", "note"}, {"text", note}}).dump() << "\n";
    else
      std::fprintf(stderr, "replay_log: %s\n", note.c_str());
  }
  if (!json) {
    std::printf("%5s %8s %8s  %16s  %16s  %16s  %16s  %8s\n", "event", "from [s]", "at [s]", "mass [kg]", "x [mm]",
                "y [mm]", "z [mm]", "took[us]");
  }
  Rival ours{"rme", {}};
  std::optional<ReplayedEstimate> last;
  const auto on_estimate = [&](const ReplayedEstimate& e) {
    last = e;
    ours.masses.push_back({e.t, e.state.payload.mean[0], e.state.payload.standard_deviation()[0]});
    if (!json) {
      print_row(e);
      return;
    }
    const ordered_json network =
        request.weights && e.final ? guess_of(*request.weights, log, samples, e.t) : ordered_json();
    std::cout << to_json(e, network).dump() << "\n";
  };
  const auto on_push = [&](const ReplayedPush& r) {
    if (json)
      std::cout << to_json(r).dump() << "\n";
    else
      print_row(r);
  };
  const ReplaySummary summary = replay<Dofs>(log, samples, request.options, on_estimate, on_push);
  const bool ongoing = last && last->state.changing && !request.options.at;
  std::vector<Rival> methods;
  if (compare) {
    const ArmSettings<Dofs> settings{request.options.arm, request.options.estimator, std::nullopt, false, {}};
    methods = run_rivals<Dofs>(
        {log, samples, settings, empty ? &empty->log : nullptr, request.weights ? &*request.weights : nullptr, false});
    if (!ours.masses.empty()) methods.insert(methods.begin(), ours);
  }
  if (json) {
    if (ongoing) std::cout << ongoing_json(*last).dump() << "\n";
    for (const Rival& method : methods)
      if (method.name != ours.name)
        for (const MassAt& at : method.masses)
          std::cout << ordered_json({{"type", "rival"}, {"by", method.name}, {"t", at.t}, {"mass", at.mass}}).dump()
                    << "\n";
    ordered_json out;
    out["type"] = "summary";
    out["samples"] = summary.samples;
    out["estimates"] = summary.estimates;
    out["rejected"] = summary.rejected;
    std::cout << out.dump() << "\n";
  } else {
    if (ongoing) print_ongoing(*last);
    std::printf("%zu samples, %d estimates, %d rejected\n", summary.samples, summary.estimates, summary.rejected);
    if (compare) print(methods, log);
  }
  return 0;
}

int run(Arguments& arguments) {
  const ArmRequest arm = parse_arm(arguments);
  return with_joint_count(arm.dofs(), [&](auto dofs) { return run<dofs()>(arguments, arm); });
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("replay_log",
                     std::string(kUsage) + kArmUsage + kFormatUsage + kSettingsUsage + kReplayUsage + kOwnUsage, argc,
                     argv, run);
}
