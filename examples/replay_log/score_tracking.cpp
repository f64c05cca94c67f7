// score_tracking: compares the estimate at each instant of a recording with the truth at that instant.
//
// Takes folders of recordings with a manifest.json (as make_logs writes them) and the options of replay_log, and prints
// a row for each scenario and folder:
//
//   mass, centre of mass   mean absolute error over the scenario's window and all runs, and how often the 90 % interval
//                          holds the truth. Windows: A, B at 0.5 s (--after) after the attachment; D the whole run;
//                          E, H the last 4 s; F the end; M 8 to 11.9 s
//   end                    mean absolute error of the mass at the end
//   lag                    F: largest error of the mass from the beginning of the pour on, mean over the runs
//   before                 largest mass that is estimated before the attachment
//   attach                 median time after which the mass stays within 5 % of the truth for 0.3 s
//   pushed                 D: runs in which the mass is off by more than 50 g for more than 0.2 s, the 0.3 s after each
//                          change left out
//
// Options make the samples worse first, in ways that occur on real arms.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <map>
#include <nlohmann/json.hpp>
#include <random>
#include <string>
#include <vector>

#include "io/json_file.hpp"
#include "io/program.hpp"
#include "replay_log/options.hpp"

namespace {

using namespace rme::examples;

constexpr const char* kUsage = "usage: score_tracking FOLDER... [options]\n";
constexpr const char* kOwnUsage =
    "  --scenario LETTERS  which scenarios (ABDEFHM)\n"
    "  --after S           when A and B are compared, after the attachment [s] (0.5)\n"
    "  --dq-noise W        white noise on dq, standard deviation [rad/s]\n"
    "  --torque-step T     tau_ext is quantised in steps of T [N m]\n"
    "  --late N            tau_ext is delayed by N rows\n"
    "  --observer W        tau_ext as an observer of W rad/s would report it; --bandwidth is then the recordings' own\n"
    "  --lost P            share of rows that are lost\n"
    "  --every N           only every Nth row\n"
    "  --seed N            of noise and losses (1)\n";

constexpr double kNinety = 1.6448536269514722;  // half width of a Gaussian's 90 % interval [standard deviations]

/// How the recordings are made worse.
struct Faults {
  double dq_noise = 0, torque_step = 0, lost = 0, observer = 0;
  std::size_t late = 0, every = 1, seed = 1;
};

/// tau_ext as another observer than that of the recording would report it; both run once per row.
/// @param recorded  bandwidth of the recording's [rad/s], > 0
std::vector<rme::JointVector<double, 7>> observed_by(double bandwidth, double recorded, const Log<7>& log) {
  std::vector<rme::JointVector<double, 7>> out{log.tau_ext.front()};
  for (std::size_t i = 1; i < log.size(); ++i) {
    const double dt = log.t[i] - log.t[i - 1];
    const rme::JointVector<double, 7> change = log.tau_ext[i] - log.tau_ext[i - 1];
    const rme::JointVector<double, 7> tau = log.tau_ext[i - 1] + change / std::min(1.0, recorded * dt);
    out.push_back(out.back() + std::min(1.0, bandwidth * dt) * (tau - out.back()));
  }
  return out;
}

/// The log with the faults.
/// @param recorded  bandwidth of the recording's observer [rad/s]
Log<7> spoilt(const Log<7>& log, const Faults& faults, double recorded, std::size_t run) {
  std::mt19937_64 random(faults.seed * 1000 + run);
  std::normal_distribution<double> normal(0, 1);
  std::uniform_real_distribution<double> uniform;
  const auto tau_ext = faults.observer > 0 ? observed_by(faults.observer, recorded, log) : log.tau_ext;
  Log<7> out;
  out.name = log.name;
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (i % faults.every != 0 || (faults.lost > 0 && uniform(random) < faults.lost)) continue;
    out.t.push_back(log.t[i]);
    out.q.push_back(log.q[i]);
    out.truth.push_back(log.truth[i]);
    rme::JointVector<double, 7> dq = log.dq[i], tau = tau_ext[i - std::min(i, faults.late)];
    for (int j = 0; j < 7; ++j) {
      if (faults.dq_noise > 0) dq[j] += faults.dq_noise * normal(random);
      if (faults.torque_step > 0) tau[j] = std::round(tau[j] / faults.torque_step) * faults.torque_step;
    }
    out.dq.push_back(dq);
    out.tau_ext.push_back(tau);
  }
  return out;
}

struct Belief {
  double t;
  Eigen::Vector4d mean, deviation;
};

/// The result of one run.
struct Score {
  Eigen::Vector4d error = Eigen::Vector4d::Zero(), held = Eigen::Vector4d::Zero();  // means over the window
  double end = 0, lag = 0, before = 0, attach = 1e9;
  bool pushed = false;
};

Score score(const Log<7>& log, const std::string& scenario, double attach, const std::vector<double>& changes,
            double after, const ReplayOptions<7>& options) {
  std::vector<Belief> beliefs{{-1e9, Eigen::Vector4d::Zero(), Eigen::Vector4d::Zero()}};
  replay<7>(
      log, samples_of(log, options.arm, options.estimator), options,
      [&](const ReplayedEstimate& e) {
        beliefs.push_back({e.t, e.state.payload.mean, e.state.payload.standard_deviation()});
      },
      [](const ReplayedPush&) {});
  const double last = log.t.back();
  const auto truth = [&](double t) -> const Eigen::Vector4d& {
    const auto row = std::upper_bound(log.t.begin(), log.t.end(), t + 1e-9) - log.t.begin();
    return log.truth[static_cast<std::size_t>(std::max<std::ptrdiff_t>(row - 1, 0))];
  };
  const auto belief = [&](double t) -> const Belief& {
    const auto later = std::upper_bound(beliefs.begin(), beliefs.end(), t + 1e-9,
                                        [](double time, const Belief& b) { return time < b.t; });
    return *(later - 1);
  };
  const std::map<char, std::pair<double, double>> windows = {{'A', {attach + after, attach + after}},
                                                             {'B', {attach + after, attach + after}},
                                                             {'D', {0, last}},
                                                             {'E', {last - 4, last}},
                                                             {'H', {last - 4, last}},
                                                             {'F', {last - 0.05, last}},
                                                             {'M', {8, 11.9}}};
  const auto [begin, end] = windows.at(scenario[0]);
  Score s;
  int n = 0;
  for (double t = begin; t <= end + 1e-9; t += 0.05, ++n) {
    const Eigen::Vector4d e = (belief(t).mean - truth(t)).cwiseAbs();
    s.error += e;
    s.held += (e.array() <= kNinety * belief(t).deviation.array()).cast<double>().matrix();
  }
  s.error /= n;
  s.held /= n;
  s.end = std::abs(belief(last).mean[0] - truth(last)[0]);
  int off = 0;
  for (double t = 0.3; t <= last; t += 0.02) {
    const double wrong = std::abs(belief(t).mean[0] - truth(t)[0]);
    if (t < attach - 0.01) s.before = std::max(s.before, std::abs(belief(t).mean[0]));
    if (scenario == "F" && t >= 3) s.lag = std::max(s.lag, wrong);
    const bool after_change =
        std::any_of(changes.begin(), changes.end(), [t](double c) { return t >= c && t < c + 0.3; });
    off = wrong > 0.05 && !after_change ? off + 1 : 0;
    s.pushed = s.pushed || (scenario == "D" && off > 10);
  }
  for (double t = attach; t < std::min(last, attach + 3) && s.attach > 1e8; t += 0.001) {
    bool good = true;
    for (double later = t; good && later < t + 0.3; later += 0.01)
      good = std::abs(belief(later).mean[0] - truth(later)[0]) < 0.05 * truth(later)[0];
    if (good) s.attach = t - attach;
  }
  return s;
}

void print(const std::string& folder, const std::string& scenario, std::vector<Score> scores) {
  Score mean;
  mean.attach = 0;
  int pushed = 0;
  for (const Score& s : scores) {
    mean.error += s.error;
    mean.held += s.held;
    mean.end += s.end;
    mean.lag += s.lag;
    mean.before = std::max(mean.before, s.before);
    pushed += s.pushed ? 1 : 0;
  }
  const auto n = static_cast<double>(scores.size());
  std::nth_element(scores.begin(), scores.begin() + static_cast<std::ptrdiff_t>(scores.size() / 2), scores.end(),
                   [](const Score& a, const Score& b) { return a.attach < b.attach; });
  const double attach = scores[scores.size() / 2].attach;
  std::printf(
      "| %-16s | %-2s | %4zu | %6.1f | %4.1f %4.1f %5.1f | %3.0f %3.0f %3.0f %3.0f | %6.1f | %6.1f | %6.1f | %6.0f "
      "| %6d |\n",
      folder.c_str(), scenario.c_str(), scores.size(), 1e3 * mean.error[0] / n, 1e3 * mean.error[1] / n,
      1e3 * mean.error[2] / n, 1e3 * mean.error[3] / n, 100 * mean.held[0] / n, 100 * mean.held[1] / n,
      100 * mean.held[2] / n, 100 * mean.held[3] / n, 1e3 * mean.end / n, 1e3 * mean.lag / n, 1e3 * mean.before,
      1e3 * attach, pushed);
}

int run(Arguments& arguments) {
  Faults faults;
  const std::string scenarios = arguments.text("--scenario").value_or("ABDEFHM");
  const double after = arguments.number("--after").value_or(0.5);
  faults.dq_noise = arguments.number("--dq-noise").value_or(0);
  faults.torque_step = arguments.number("--torque-step").value_or(0);
  faults.lost = arguments.number("--lost").value_or(0);
  faults.late = arguments.whole("--late", 0).value_or(0);
  faults.observer = arguments.number("--observer").value_or(0);
  faults.every = arguments.whole("--every", 1).value_or(1);
  faults.seed = arguments.whole("--seed", 0).value_or(1);
  if (!(faults.dq_noise >= 0 && faults.torque_step >= 0 && faults.lost >= 0 && faults.lost < 1))
    throw ArgumentError("--dq-noise, --torque-step: must be 0 or more, --lost below 1");
  if (!(after > 0)) throw ArgumentError("--after: must be above 0 s");
  const ReplayRequest<7> request = parse_replay<7>(arguments, parse_arm(arguments));
  const double recorded = request.options.estimator.observer_bandwidth;
  if (!(faults.observer >= 0) || (faults.observer > 0 && !(recorded > 0)))
    throw ArgumentError("--observer: must be above 0, and so must --bandwidth, that of the recordings");
  std::vector<std::string> folders;
  do folders.push_back(arguments.positional("FOLDER"));
  while (!arguments.empty());

  std::printf(
      "| folder           |    | runs | mass g | com x, y, z mm  | held, of 90 %%   |  end g |  lag g | before | "
      "attach | pushed |\n|------------------|----|-----:|-------:|----------------:|----------------:|-------:|"
      "-------:|-------:|-------:|-------:|\n");
  for (const std::string& folder : folders) {
    const auto manifest = read_json_file(folder + "/manifest.json");
    std::map<std::string, std::vector<Score>> scores;
    std::size_t number = 0;
    for (const auto& entry : manifest.at("runs")) {
      const std::string scenario = entry.at("scenario");
      const std::string name = entry.at("name");
      // Some folders also have runs without faults, with "clean" in their names: they are left out.
      if (scenario.size() != 1 || scenarios.find(scenario) == std::string::npos ||
          name.find("clean") != std::string::npos || std::string("ABDEFHM").find(scenario) == std::string::npos)
        continue;
      const std::string file = entry.at("file");
      std::fprintf(stderr, "\r%-70s", file.c_str());
      const Log<7> log = read_log<7>(folder + "/" + file);
      require_external_torque(log);
      if (log.truth.empty() || log.dq.empty() || log.tau_ext.empty())
        throw LogError(log.name + ": tau_ext, dq and the truth m, rx, ry, rz are all needed");
      std::vector<double> changes;
      for (const auto& event : entry.at("events")) changes.push_back(event.at("t"));
      scores[scenario].push_back(score(spoilt(log, faults, recorded, number++), scenario, entry.at("attach_time"),
                                       changes, after, request.options));
    }
    std::fprintf(stderr, "\r%-70s\r", "");
    std::string name = folder;
    while (!name.empty() && name.back() == '/') name.pop_back();
    name = name.substr(name.rfind('/') + 1);
    for (const auto& [scenario, list] : scores) print(name, scenario, list);
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("score_tracking", std::string(kUsage) + kSettingsUsage + kReplayUsage + kOwnUsage, argc, argv,
                     run);
}
