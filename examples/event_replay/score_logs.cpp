// score_logs: how far off are the estimates, and do their intervals hold? Logs with truth, played through the
// estimator.
//
// Takes any number of logs with the truth columns m, rx, ry, rz, and the options of replay_log. Each change of the
// truth is an event; the first final estimate after it and before the next one is its estimate. With --at-attach D the
// estimate is made from the samples that begin D seconds after the log's first change, without the detector. Prints,
// over all events that left something in the hand: mean absolute and rms error, how often the 90 % interval holds the
// truth and its mean half width, for the mass, each coordinate of the centre of mass and its part across gravity (the
// part along it cannot be seen at rest). With the early estimates it says when the mass came within a twentieth, or a
// tenth, of the truth and stayed there. With --every S the same is asked of windows all along the log.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <optional>

#include "event_replay/options.hpp"
#include "io/program.hpp"

namespace {

using namespace rme::examples;

constexpr const char* kUsage = "usage: score_logs LOG.csv[.gz]... [options]\n";
constexpr const char* kOwnUsage =
    "  --at-attach D       estimate from D seconds after the first change of the truth [s]\n"
    "  --every S           with --at-attach: and again every S seconds, up to the next change [s]\n"
    "  --verbose           a line for each event\n";

constexpr double kNinety = 1.6448536269514722;  // half width of a Gaussian's 90 % interval [standard deviations]

constexpr std::array<double, 2> kTolerances = {0.05, 0.1};  // of the mass

struct Scored {
  Eigen::Vector4d truth, error, deviation;
  double across;                  // error of the centre of mass across gravity [m]
  double delay;                   // from the change to the estimate [s]
  std::array<double, 2> settled;  // from the change until the mass was good and stayed so, per kTolerances [s]
};

struct Scores {
  std::vector<Scored> found;
  int missed = 0;
  int surplus = 0;
  int rejected = 0;
};

void score(const Log<7>& log, const ReplayRequest& request, Scores& scores) {
  std::vector<std::size_t> changes;  // rows at which the truth changes; what a log starts with is no event
  for (std::size_t i = 1; i < log.size(); ++i)
    if (log.truth[i] != log.truth[i - 1]) changes.push_back(i);
  std::vector<bool> answered(changes.size(), false);
  std::array<std::optional<double>, kTolerances.size()> good_since;  // of the event that is going on [s]
  const auto on_estimate = [&](const ReplayedEstimate& e) {
    for (std::size_t i = 0; i < kTolerances.size(); ++i) {
      const bool good = std::abs(e.posterior.mean[0] - (*e.truth)[0]) <= kTolerances[i] * (*e.truth)[0];
      if (!good) good_since[i].reset();
      if (good && !good_since[i]) good_since[i] = e.t;
    }
    if (!e.final) return;
    const auto since = good_since;
    good_since = {};
    std::size_t event = changes.size();
    for (std::size_t k = 0; k < changes.size(); ++k)
      if (log.t[changes[k]] <= e.t) event = k;
    if (event == changes.size() || answered[event]) {
      ++scores.surplus;
      return;
    }
    answered[event] = true;
    Scored s;
    s.truth = *e.truth;
    s.error = e.posterior.mean - s.truth;
    s.deviation = e.posterior.standard_deviation();
    s.delay = e.t - log.t[changes[event]];
    for (std::size_t i = 0; i < kTolerances.size(); ++i)
      s.settled[i] = since[i] ? *since[i] - log.t[changes[event]] : std::numeric_limits<double>::infinity();
    const auto row = static_cast<std::size_t>(std::lower_bound(log.t.begin(), log.t.end(), e.t) - log.t.begin());
    const Eigen::Vector3d down =
        panda().kinematics(log.q[row]).rotation.transpose() * panda().gravity_vector.normalized();
    s.across = (s.error.tail<3>() - down * down.dot(s.error.tail<3>())).norm();
    scores.found.push_back(s);
  };
  const auto on_rejection = [&](const ReplayedRejection&) { ++scores.rejected; };
  replay(log, request.options, request.prior(log), on_estimate, on_rejection);
  scores.missed += static_cast<int>(std::count(answered.begin(), answered.end(), false));
}

void print(const Scores& scores) {
  std::printf("%-8s %8s %8s %14s %14s\n", "", "mae", "rmse", "90 % holds", "half width");
  int n = 0;
  for (const Scored& s : scores.found) n += s.truth[0] > 0 ? 1 : 0;
  const char* names[] = {"mass [g]", "x [mm]", "y [mm]", "z [mm]"};
  for (int i = 0; i < 4; ++i) {
    double absolute = 0, square = 0, holds = 0, width = 0;
    for (const Scored& s : scores.found) {
      if (!(s.truth[0] > 0)) continue;
      absolute += std::abs(s.error[i]);
      square += s.error[i] * s.error[i];
      holds += std::abs(s.error[i]) <= kNinety * s.deviation[i] ? 1 : 0;
      width += kNinety * s.deviation[i];
    }
    std::printf("%-8s %8.2f %8.2f %12.0f %% %14.2f\n", names[i], 1e3 * absolute / n, 1e3 * std::sqrt(square / n),
                100 * holds / n, 1e3 * width / n);
  }
  double across = 0, delay = 0, left = 0;
  for (const Scored& s : scores.found) {
    delay += s.delay;
    if (s.truth[0] > 0)
      across += s.across;
    else
      left = std::max(left, std::abs(s.error[0]));
  }
  std::printf("com across gravity, mean: %.2f mm\n", 1e3 * across / n);
  std::printf(
      "%zu events answered (%d with a payload), %d missed, %d surplus estimates, %d changes rejected; %.0f ms after "
      "the change on average\n",
      scores.found.size(), n, scores.missed, scores.surplus, scores.rejected,
      1e3 * delay / static_cast<double>(scores.found.size()));
  for (std::size_t i = 0; n > 0 && i < kTolerances.size(); ++i) {
    std::vector<double> settled;
    for (const Scored& s : scores.found)
      if (s.truth[0] > 0) settled.push_back(s.settled[i]);
    const auto middle = settled.begin() + static_cast<std::ptrdiff_t>(settled.size() / 2);
    std::nth_element(settled.begin(), middle, settled.end());
    std::printf("mass within %.0f %% for good: %.0f ms after the change (median), %.0f ms (worst)\n",
                100 * kTolerances[i], 1e3 * *middle, 1e3 * *std::max_element(settled.begin(), settled.end()));
  }
  if (n < static_cast<int>(scores.found.size()))
    std::printf("empty hand: at most %.1f g were still seen\n", 1e3 * left);
}

int run(Arguments& arguments) {
  const bool verbose = arguments.flag("--verbose");
  const std::optional<double> at_attach = arguments.number("--at-attach"), every = arguments.number("--every");
  if (every && !(*every > 0 && at_attach)) throw ArgumentError("--every: must be above 0 s, and needs --at-attach");
  ReplayRequest request = parse_replay_options(arguments);
  std::vector<std::string> names;
  do names.push_back(arguments.positional("LOG.csv"));
  while (!arguments.empty());

  Scores scores;
  for (const std::string& name : names) {
    const Log<7> log = read_log<7>(name);
    require_external_torque(log);
    if (log.truth.empty()) throw LogError(name + ": has no truth columns m, rx, ry, rz");
    std::size_t end = 0;  // of the first change's payload
    if (at_attach) {
      std::size_t row = 1;
      while (row < log.size() && log.truth[row] == log.truth[row - 1]) ++row;
      if (row == log.size()) throw LogError(name + ": the truth never changes");
      request.options.at = log.t[row] + *at_attach;
      end = row;
      while (end + 1 < log.size() && log.truth[end + 1] == log.truth[row]) ++end;
    }
    const std::size_t before = scores.found.size();
    score(log, request, scores);
    // Every window is estimated for itself.
    while (every && (*request.options.at += *every) + request.options.estimator.collection < log.t[end])
      score(log, request, scores);
    if (!verbose) continue;
    std::printf("%s\n", name.c_str());
    for (std::size_t i = before; i < scores.found.size(); ++i) {
      const Scored& s = scores.found[i];
      std::printf("  after %5.0f ms: %6.3f kg, error %7.1f +- %5.1f g, com %6.1f %6.1f %6.1f +- %4.1f %4.1f %4.1f mm\n",
                  1e3 * s.delay, s.truth[0], 1e3 * s.error[0], 1e3 * s.deviation[0], 1e3 * s.error[1], 1e3 * s.error[2],
                  1e3 * s.error[3], 1e3 * s.deviation[1], 1e3 * s.deviation[2], 1e3 * s.deviation[3]);
    }
  }
  if (scores.found.empty()) {
    std::printf("no event was answered; %d missed\n", scores.missed);
    return 1;
  }
  print(scores);
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("score_logs", std::string(kUsage) + kReplayUsage + kOwnUsage, argc, argv, run);
}
