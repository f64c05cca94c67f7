// replay_log: what would rme have believed, and when? A recording of an arm, played through the estimator.
//
// Reads a CSV log (plain or gzip) of a Franka Panda; columns by their names: t, q1..q7 and tau_ext1..7, or tau1..7
// (measured torque, gravity included) with dq1..7; dq1..7 and the truth m, rx, ry, rz if there. Prints a line for each
// event, as a table, or with --json each belief as one JSON object per line. Exit codes: 0; 2 unusable arguments;
// 3 unreadable log.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <iostream>
#include <nlohmann/json.hpp>
#include <rme/sensing/sample_window.hpp>
#include <string>

#include "io/program.hpp"
#include "replay_log/options.hpp"

namespace {

using namespace rme::examples;
using nlohmann::ordered_json;
using rme::Hypothesis;

constexpr const char* kUsage = "usage: replay_log LOG.csv[.gz] [options]\n";
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
  request.replay = parse_replay(arguments);
  request.log = arguments.positional("LOG.csv");
  arguments.finish();
  return request;
}

/// Odds of a payload, an empty one included, against a push [nats].
double log_odds(const rme::EstimatorState<double>& state) {
  const double pushed = std::clamp(state.probability[Hypothesis::Pushed], 1e-12, 1 - 1e-12);
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
  for (std::size_t i = 0; i < rme::kHypotheses; ++i)
    probability[to_string(static_cast<Hypothesis>(i))] = e.state.probability.values[i];
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
  out["health"] = e.state.health;
  out["confidence"] = e.state.confidence;
  out["inertial"] = list(e.state.inertial.mean);
  out["truth"] = e.truth ? ordered_json(list(*e.truth)) : ordered_json(nullptr);
  if (!network.is_null()) out["network"] = network;
  return out;
}

ordered_json to_json(const ReplayedPush& r) {
  const auto evidence = [&](Hypothesis h) { return std::log(std::max(r.state.probability[h], 1e-12)); };
  ordered_json out;
  out["type"] = "rejected";
  out["kind"] = "pushed";
  out["t"] = r.t;
  out["detected_at"] = r.detected_at;
  out["log_odds"] = log_odds(r.state);
  out["log_evidence"] = {{"payload", evidence(Hypothesis::Exchanged)},
                         {"empty", evidence(Hypothesis::Empty)},
                         {"unchanged", evidence(Hypothesis::Steady)},
                         {"push", evidence(Hypothesis::Pushed)}};
  return out;
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

/// What the network says to the 200 ms that end at `t`: (m, r), or null if it has learned from none like them.
ordered_json guess_of(const NetworkFile& file, const Log<7>& log, double bandwidth, double t) {
  const double dt = nominal_period(log.t);
  rme::SampleWindowConfig config;
  config.observer_bandwidth = std::min(bandwidth, 1 / dt);
  rme::SampleWindow<double, 7> window(dt, config);
  const Log<7> last = cropped(log, t - 0.3, t + 0.5 * dt);
  if (last.size() < 2) return nullptr;
  for (const auto& sample : samples_of(last, bandwidth)) (void)window.push(sample);
  const rme::NetworkPrior<double> prior(*file.network, dt, file.config);
  rme::Vector4<double> said;
  return prior.guess(window, window.size(), said) ? ordered_json(list(said)) : ordered_json(nullptr);
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
  const auto& options = request.replay.options;
  const auto on_estimate = [&](const ReplayedEstimate& e) {
    if (!request.json) {
      print_row(e);
      return;
    }
    const auto& weights = request.replay.weights;
    const ordered_json network =
        weights && e.final ? guess_of(*weights, log, options.estimator.observer_bandwidth, e.t) : ordered_json();
    std::cout << to_json(e, network).dump() << "\n";
  };
  const auto on_push = [&](const ReplayedPush& r) {
    if (request.json)
      std::cout << to_json(r).dump() << "\n";
    else
      print_row(r);
  };
  const ReplaySummary summary = replay(log, options, on_estimate, on_push);
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
  return run_program("replay_log", std::string(kUsage) + kReplayUsage + kOwnUsage, argc, argv, run);
}
