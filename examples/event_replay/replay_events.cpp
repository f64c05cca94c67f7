// replay_events: would rme have noticed, and what would it have said? A recording of an arm, played through the
// estimator.
//
// Reads a CSV log (plain or gzip) of a Franka Panda; columns by their names: t, q1..q7 and tau_ext1..7, or tau1..7
// (measured torque, gravity included) with dq1..7; dq1..7 and the truth m, rx, ry, rz if there. Prints each estimate,
// as a table (of the early ones the first) or with --json as one JSON object per line. Exit codes: 0; 2 unusable
// arguments; 3 unreadable log.
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <string>
#include <utility>

#include "event_replay/options.hpp"
#include "io/program.hpp"

namespace {

using namespace rme::examples;
using nlohmann::ordered_json;

constexpr const char* kUsage = "usage: replay_events LOG.csv[.gz] [options]\n";
constexpr const char* kOwnUsage = "  --json              one JSON object per line\n";

/// What the command line asks for.
struct Request {
  std::string log;
  ReplayRequest replay;
  bool json = false;
};

Request parse(Arguments& arguments) {
  Request request;
  request.json = arguments.flag("--json");
  request.replay = parse_replay_options(arguments);
  request.log = arguments.positional("LOG.csv");
  arguments.finish();
  return request;
}

ordered_json to_json(const ReplayedEstimate& e) {
  const auto vector = [](const auto& v) { return std::vector<double>(v.data(), v.data() + v.size()); };
  const auto& p = e.posterior;
  ordered_json covariance;
  for (int row = 0; row < 4; ++row) covariance.push_back(vector(rme::Vector4<double>(p.covariance.row(row))));
  ordered_json out;
  out["type"] = "estimate";
  out["event"] = e.event;
  out["final"] = e.final;
  out["t"] = e.t;
  out["detected_at"] = e.detected_at ? ordered_json(*e.detected_at) : ordered_json(nullptr);
  out["window"] = {e.window_begin, e.window_end};
  out["mass"] = p.mean[0];
  out["com"] = vector(p.payload().com);
  out["std"] = vector(p.standard_deviation());
  out["covariance"] = covariance;
  out["log_odds"] = e.verdict.log_odds();
  out["elapsed_us"] = e.elapsed_us;
  out["excess"] = e.verdict.excess;
  out["truth"] = e.truth ? ordered_json(vector(*e.truth)) : ordered_json(nullptr);
  return out;
}

ordered_json to_json(const ReplayedRejection& r) {
  ordered_json out;
  out["type"] = "rejected";
  out["t"] = r.t;
  out["detected_at"] = r.detected_at;
  out["log_odds"] = r.verdict.log_odds();
  out["log_evidence"] = {{"payload", r.verdict.payload},
                         {"empty", r.verdict.empty},
                         {"unchanged", r.verdict.unchanged},
                         {"push", r.verdict.push}};
  return out;
}

void print_row(const ReplayedRejection& r) {
  const bool push = r.verdict.push > r.verdict.unchanged;
  std::printf("    - %8.3f %8.3f  no payload: %s (log odds %.1f)\n", r.detected_at, r.t,
              push ? "something pushes" : "nothing has changed", r.verdict.log_odds());
}

void print_row(const ReplayedEstimate& e) {
  static int early_of = -1;  // the event of which an early estimate has been printed; one is enough to read
  if (!e.final && std::exchange(early_of, e.event) == e.event) return;
  const auto& p = e.posterior;
  const rme::Vector4<double> sd = p.standard_deviation();
  std::printf("%5d %8.3f %8.3f  %7.3f +- %5.3f", e.event, e.detected_at.value_or(e.window_begin), e.t, p.mean[0],
              sd[0]);
  for (int i = 1; i < 4; ++i) std::printf("  %7.1f +- %5.1f", 1e3 * p.mean[i], 1e3 * sd[i]);
  std::printf("  %8.1f  (%slog odds %.1f)\n", e.elapsed_us, e.final ? "" : "early, ", e.verdict.log_odds());
  if (!e.truth) return;
  std::printf("%5s %8s %8s  %7.3f %8s", "", "", "truth", (*e.truth)[0], "");
  for (int i = 1; i < 4; ++i) std::printf("  %7.1f %8s", 1e3 * (*e.truth)[i], "");
  std::printf("\n");
}

int run(Arguments& arguments) {
  const Request request = parse(arguments);
  const Log<7> log = read_log<7>(request.log);
  require_external_torque(log);
  if (log.size() < 2) throw LogError(log.name + ": has a single row, which gives no sample rate");
  if (!request.json) {
    std::printf("%5s %8s %8s  %16s  %16s  %16s  %16s  %8s\n", "event", "from [s]", "at [s]", "mass [kg]", "x [mm]",
                "y [mm]", "z [mm]", "took[us]");
  }
  const auto report = [&request](const auto& happened) {
    if (request.json)
      std::cout << to_json(happened).dump() << "\n";
    else
      print_row(happened);
  };
  const ReplaySummary summary = replay(log, request.replay.options, request.replay.prior(log), report, report);
  if (request.json) {
    ordered_json out;
    out["type"] = "summary";
    out["samples"] = summary.samples;
    out["estimates"] = summary.estimates;
    out["rejected"] = summary.rejected;
    std::cout << out.dump() << "\n";
  } else {
    std::printf("%zu samples, %d estimates, %d rejected\n", summary.samples, summary.estimates, summary.rejected);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("replay_events", std::string(kUsage) + kReplayUsage + kOwnUsage, argc, argv, run);
}
