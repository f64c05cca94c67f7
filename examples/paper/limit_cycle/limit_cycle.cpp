// limit_cycle: the flange moves on a circle in the y-z plane under CPIC, and a payload is attached while it moves.
//
// The weight acts in the plane of the circle. If it exceeds the force that drives the flange along the circle,
// lambda_1 w r = 6 N, the sum of both forces has a stable equilibrium: without compensation the arm stops there, in a
// spurious attractor. With a lighter payload the flange moves on, beside the circle. With the tracker's compensation it
// returns to the circle. Gains and speed are the defaults of LimitCycle and PassiveController: 60 and 90 N s/m, 2 1/s,
// 1 rad/s.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <random>

#include "paper/experiment/report.hpp"
#include "paper/experiment/trial.hpp"

namespace {

using namespace rme::examples;
using Eigen::Vector3d, Eigen::Vector4d;

constexpr double kRadius = 0.1;      // [m]
constexpr double kTarget = 0.005;    // distance to the cycle that counts as being on it [m]
constexpr double kAllowance = 1e-3;  // on that of the empty hand, with friction [m]
constexpr double kAtRest = 0.005;    // slower than this over the last second, the arm has stopped [m/s]
const double kTurn = 2 * kPi / rme::LimitCycleConfig<double>().angular_speed;  // [s]

constexpr double kShown = 1.1;  // payload of the CSV files that follow a path [kg]
constexpr const char* kPathColumns = "t,y,z,distance,m,mass";

constexpr const char* kUsage = R"(usage: rme_limit_cycle [options]

The flange moves on a circle, and a payload of Table 2 is attached while it moves. Compares no compensation with that of
the published pipeline and that of the tracker.

  --trials N        of each payload (default 4; 1 of two payloads with --quick)
)";

constexpr const char* kExitCodes = R"(
Exit codes: 0 the tracker finds every payload and, with its compensation, the mean distance to the cycle in the second
turn after the attachment is at most 5 mm (with --friction, which moves the empty hand off the cycle as well: at most 1 mm
more than before the attachment); 1 otherwise; 2 unusable arguments.
)";

/// Where the flange is, relative to the cycle.
struct CyclePoint {
  Vector3d offset;  // from the centre, world axes [m]
  double distance() const { return std::hypot(offset.x(), offset.tail<2>().norm() - kRadius); }
  double angle() const { return std::atan2(offset.z(), offset.y()); }
};

/// What the flange did in one turn's time.
struct Turn {
  double mean = 0, worst = 0;  // distance to the cycle [m]
  double progress = 0;         // angle covered, in turns: 1 if the phase keeps up
};

struct Outcome {
  std::array<Turn, 3> turns;             // the turn before the attachment, and the two turns after it
  double outside = 0;                    // last time after the attachment that the distance exceeded kTarget [s]
  double last_speed = 0;                 // mean over the last second [m/s]
  std::optional<double> noticed, found;  // when a change was noticed and the payload found, after the attachment [s]
  Vector4d error = Vector4d::Zero();     // of the last estimate

  // A path that only crosses the cycle is not within kTarget for the whole of the last half turn.
  bool returned() const { return outside < 1.5 * kTurn; }
  bool at_rest() const { return last_speed < kAtRest; }
};

Outcome run_trial(const Setup& setup, const PublishedTrial& payload, std::uint64_t number, Method method,
                  CsvFile* csv) {
  std::mt19937_64 random(setup.seed * 7919 + number);
  std::normal_distribution<double> spread(0, 0.1);
  Trial::Vector q = panda().ready;
  for (double& angle : q) angle += spread(random);
  const double attach = kTurn * (1.5 + std::uniform_real_distribution<double>()(random));
  HostConfig host = HostConfig::hold(panda(), q);
  host.cycle_radius = kRadius;
  host.target.y() -= kRadius;  // it starts on the cycle
  Trial trial(setup.arm(number), host, q, method);

  Outcome outcome;
  bool attached = false;
  std::uint64_t before = 0, detected = 0;  // answers and detections before the attachment
  double last_angle = 0;
  while (trial.arm.time() - attach < 2 * kTurn) {
    const double t = trial.arm.time() - attach;
    if (!attached && t > -kPeriod / 2) attached = trial.arm.attach(experiment_payload(payload.mass, payload.com)) > 0;
    const CyclePoint at{trial.position_error()};
    const double distance = at.distance();
    if (t >= -kTurn) {
      Turn& turn = outcome.turns[static_cast<std::size_t>(std::floor(t / kTurn) + 1)];
      turn.mean += distance * kPeriod / kTurn;
      turn.worst = std::max(turn.worst, distance);
      turn.progress += std::remainder(at.angle() - last_angle, 2 * kPi) / (2 * kPi);
    }
    last_angle = at.angle();
    if (attached && distance > kTarget) outcome.outside = t;
    if (t > 2 * kTurn - 1)
      outcome.last_speed += kPeriod * (trial.arm.kinematics().jacobian.topRows<3>() * trial.arm.dq()).norm();
    if (csv && std::lround(trial.arm.time() / kPeriod) % 10 == 0)
      csv->row(t, at.offset.y(), at.offset.z(), distance, trial.arm.payload().mass, trial.belief(method).mean[0]);
    trial.tick();
    if (!attached) {
      before = trial.answers(method);
      detected = trial.published.state().detections;
      continue;
    }
    const bool noticed =
        method == Method::Published ? trial.published.state().detections > detected : trial.estimator.state().changing;
    if (noticed && !outcome.noticed) outcome.noticed = t;
    if (trial.answers(method) > before && !outcome.found) outcome.found = t;
  }
  outcome.error = trial.belief(method).mean - trial.truth();
  return outcome;
}

/// All trials of a payload with one method.
struct Summary {
  double trials = 0;
  std::array<Turn, 3> turns;          // means over the trials, and the worst of all
  double outside = 0;                 // the longest, of the trials that returned [s]
  double noticed = 0, found = 0;      // the latest of all trials [s]
  Vector4d error = Vector4d::Zero();  // mean absolute, in the end
  int returned = 0, at_rest = 0, missed = 0;

  explicit Summary(const std::vector<Outcome>& outcomes) : trials(static_cast<double>(outcomes.size())) {
    for (const Outcome& outcome : outcomes) {
      for (std::size_t i = 0; i < turns.size(); ++i) {
        turns[i].mean += outcome.turns[i].mean / trials;
        turns[i].worst = std::max(turns[i].worst, outcome.turns[i].worst);
        turns[i].progress += outcome.turns[i].progress / trials;
      }
      returned += outcome.returned();
      at_rest += outcome.at_rest();
      missed += !outcome.found;
      if (outcome.returned()) outside = std::max(outside, outcome.outside);
      noticed = std::max(noticed, outcome.noticed.value_or(0));
      found = std::max(found, outcome.found.value_or(0));
      error += outcome.error.cwiseAbs();
    }
    error /= trials;
  }
  std::string back() const {
    if (returned == 0) return "never";
    return text("%.2f", outside) + (returned < trials ? text("; %.0f never", trials - returned) : "");
  }
};

int run(Arguments& arguments) {
  const Setup setup = Setup::parse(arguments);
  const std::size_t trials = arguments.whole("--trials", 1, 1000).value_or(setup.quick ? 1 : 4);
  arguments.finish();
  std::vector<PublishedTrial> payloads(published_trials().begin(), published_trials().end());
  if (setup.quick) payloads = {published_trials()[1], published_trials()[4]};

  CsvFile csv(setup.output, "trials.csv",
              "m,trial,method,mean_before,mean_attach,mean_after,worst_before,worst_attach,worst_after,progress,"
              "outside,last_speed,noticed,found,m_error,x_error,y_error,z_error");
  std::array<CsvFile, 3> paths = {CsvFile(setup.output, "alone.csv", kPathColumns),
                                  CsvFile(setup.output, "published.csv", kPathColumns),
                                  CsvFile(setup.output, "tracker.csv", kPathColumns)};
  MarkdownTable cycle({"payload [kg]", "compensation", "turn before [mm]", "turn of the attachment [mm]",
                       "turn after [mm]", "progress [turns]", "stopped", "back after [s]"});
  MarkdownTable estimates(
      {"payload [kg]", "by", "noticed after [s]", "found after [s]", "mass [g]", "x [mm]", "y [mm]", "z [mm]"});
  std::uint64_t number = 0;
  int missed = 0;
  bool kept = true;
  for (const PublishedTrial& payload : payloads) {
    const std::string name = text("%.3f", payload.mass);
    std::array<std::vector<Outcome>, kMethods.size()> outcomes;
    for (std::size_t k = 0; k < trials; ++k) {
      ++number;
      const bool shown = k == 0 && payload.mass == kShown;
      for (std::size_t i = 0; i < kMethods.size(); ++i) {
        const Outcome o = run_trial(setup, payload, number, kMethods[i], shown ? &paths[i] : nullptr);
        outcomes[i].push_back(o);
        const auto& [before, attach, after] = o.turns;
        csv.row(payload.mass, k, name_of(kMethods[i]), before.mean, attach.mean, after.mean, before.worst, attach.worst,
                after.worst, after.progress, o.outside, o.last_speed, o.noticed.value_or(-1), o.found.value_or(-1),
                o.error[0], o.error[1], o.error[2], o.error[3]);
      }
      progress("limit_cycle", number, trials * payloads.size());
    }
    for (std::size_t i = 0; i < kMethods.size(); ++i) {
      const Summary all(outcomes[i]);
      const std::string by = name_of(kMethods[i]);
      std::vector<std::string> cells = {name, by};
      for (const Turn& turn : all.turns) cells.push_back(text("%.1f; %.1f", 1e3 * turn.mean, 1e3 * turn.worst));
      cells.push_back(text("%.2f", all.turns[2].progress));
      cells.push_back(text("%d of %.0f", all.at_rest, all.trials));
      cells.push_back(all.back());
      cycle.row(cells);
      if (kMethods[i] == Method::None) continue;
      if (kMethods[i] == Method::Tracker) {
        missed += all.missed;
        const double allowed = setup.friction ? all.turns[0].mean + kAllowance : kTarget;
        kept = kept && all.turns[2].mean <= allowed;
      }
      estimates.row({name, by, text("%.3f", all.noticed), text("%.2f", all.found), text("%.1f", 1e3 * all.error[0]),
                     text("%.1f", 1e3 * all.error[1]), text("%.1f", 1e3 * all.error[2]),
                     text("%.1f", 1e3 * all.error[3])});
    }
  }

  std::printf("%s, %zu trial(s) of each payload, seed %llu. A cycle of %.0f mm radius in %.1f s.\n\n",
              setup.name().c_str(), trials, static_cast<unsigned long long>(setup.seed), 1e3 * kRadius, kTurn);
  std::printf(
      "Columns of turns: distance to the cycle, mean over the turn; worst. Progress: share of the last turn that the\n"
      "arm completes. Stopped: trials in which the arm is slower than %.0f mm/s at the end. Back: time since the\n"
      "attach after which the distance stays below %.0f mm for the rest of the trial, at least half a turn; the\n"
      "longest of the trials that return, 0 if the distance is never larger.\n\n",
      1e3 * kAtRest, 1e3 * kTarget);
  cycle.print();
  std::printf(
      "Estimates on the moving arm: longest time of all trials; mean absolute error two turns after the "
      "attachment.\n\n");
  estimates.print();
  std::printf("Payloads that the tracker did not find: %d of %llu.\n\n", missed,
              static_cast<unsigned long long>(number));
  return kept && missed == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_limit_cycle", std::string(kUsage) + Setup::kUsage + kExitCodes, argc, argv, run);
}
