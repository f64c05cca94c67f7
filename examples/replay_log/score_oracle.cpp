// score_oracle: how near the estimate comes to what an oracle makes of the same samples.
//
// The oracle knows when the payload was attached, the offset and the noise of each torque sensor, the acceleration from
// the next sample as well, and that nothing else is wrong: no friction, no error of the model, no push. What is left is
// linear least squares over the ten inertial parameters with white noise and the prior from which payloads are drawn.
// No estimator can be better on average; what rme has more is the price of not knowing these things.
//
// Takes folders of link-side recordings (make_logs --kind link_side) and the options of replay_log, and prints for 50 ms,
// 0.5 s and 2 s after the attachment the root mean square error of the mass, over all runs of a scenario that last so
// long, and the median size of rme's.
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <limits>
#include <map>
#include <nlohmann/json.hpp>
#include <rme/tracking/inertial_parameters.hpp>
#include <string>
#include <vector>

#include "io/json_file.hpp"
#include "io/program.hpp"
#include "replay_log/options.hpp"

namespace {

using namespace rme::examples;
using Torque = rme::JointVector<double, 7>;

constexpr const char* kUsage = "usage: score_oracle FOLDER... [options]\n";
constexpr const char* kOwnUsage = "  --scenario LETTERS  which scenarios: ABE (AE)\n";
constexpr std::array<double, 3> kAfter = {0.05, 0.5, 2};  // [s]

using Errors = std::array<double, kAfter.size()>;  // of the mass, at each of these instants [kg]

/// Twist of the end effector, world axes: linear velocity, then angular velocity.
rme::Vector6<double> twist(const rme::Proprioception<double, 7>& sample) {
  return sample.jacobian * sample.dq;
}

/// The oracle's errors.
/// @param attach   when the payload was attached [s]
/// @param offset   of each torque sensor [N m]
/// @param noise    standard deviation of the torque of one sample [N m]
/// @return NaN where the log ends before
Errors oracle(const Log<7>& log, const Samples<7>& samples, const rme::EstimatorConfig<double, 7>& config,
              double attach, const Torque& offset, const Torque& noise) {
  using Information = Eigen::Matrix<double, rme::kInertial, rme::kInertial>;
  const auto prior = config.payload.value_or(rme::PayloadPrior<double>::of(config.rated_payload));
  const Eigen::Matrix<double, rme::kInertial, 1> mean = prior.mean();
  Information information = Information::Zero();
  Eigen::Matrix<double, rme::kInertial, 1> shown = Eigen::Matrix<double, rme::kInertial, 1>::Zero();
  Errors out;
  out.fill(std::numeric_limits<double>::quiet_NaN());
  std::size_t next = 0;
  for (std::size_t i = 1; i + 1 < samples.sample.size() && next < kAfter.size(); ++i) {
    const double t = log.t[samples.row[i]];
    const auto &now = samples.sample[i], &before = samples.sample[i - 1];
    if (t > attach + kAfter[next]) {
      const double truth = log.truth[samples.row[i]][0];
      const Information L = prior.factor(truth * truth);
      Information total = information + (L * L.transpose()).inverse();
      out[next++] = (mean + total.ldlt().solve(shown - information * mean))[0] - truth;
    }
    if (before.period <= 0 || log.t[samples.row[i - 1]] < attach) continue;
    const double blend = observer_blend(samples.bandwidth, now.period);
    const Torque torque = before.tau_ext + (now.tau_ext - before.tau_ext) / blend - offset;
    const rme::Vector6<double> acceleration = (twist(now) - twist(before)) / now.period;
    rme::FlangeMotion<double> motion;
    motion.angular_velocity = twist(before).tail<3>();
    motion.linear_acceleration = acceleration.head<3>();
    motion.angular_acceleration = acceleration.tail<3>();
    const Eigen::Matrix<double, 7, rme::kInertial> Y =
        before.jacobian.transpose() * rme::inertial_wrench_regressor<double>(before.rotation, config.gravity, motion);
    for (int j = 0; j < 7; ++j) {
      const double weight = 1 / (noise[j] * noise[j]);
      information += weight * Y.row(j).transpose() * Y.row(j);
      shown += weight * torque[j] * Y.row(j).transpose();
    }
  }
  return out;
}

/// The errors of rme.
Errors tracked(const Log<7>& log, const Samples<7>& samples, double attach, const ReplayOptions<7>& options) {
  Errors out{};
  std::vector<std::pair<double, double>> masses{{-1e9, 0}};
  replay<7>(
      log, samples, options, [&](const ReplayedEstimate& e) { masses.emplace_back(e.t, e.state.payload.mean[0]); },
      [](const ReplayedPush&) {});
  for (std::size_t k = 0; k < kAfter.size(); ++k) {
    const auto row = std::upper_bound(log.t.begin(), log.t.end(), attach + kAfter[k]) - log.t.begin();
    for (const auto& [t, mass] : masses)
      if (t <= attach + kAfter[k]) out[k] = mass - log.truth[static_cast<std::size_t>(row - 1)][0];
  }
  return out;
}

Torque numbers(const nlohmann::json& list) {
  Torque out;
  for (int j = 0; j < 7; ++j) out[j] = list.at(static_cast<std::size_t>(j));
  return out;
}

int run(Arguments& arguments) {
  const std::string scenarios = arguments.text("--scenario").value_or("AE");
  if (scenarios.empty() || scenarios.find_first_not_of("ABE") != std::string::npos)
    throw ArgumentError("--scenario: must be letters out of ABE, got '" + scenarios + "'");
  const ReplayRequest<7> request = parse_replay<7>(arguments, parse_arm(arguments));
  std::vector<std::string> folders;
  do folders.push_back(arguments.positional("FOLDER"));
  while (!arguments.empty());
  std::printf("| folder           |    | runs | after s | oracle g |  rme g | ratio | rme median |\n");
  std::printf("|------------------|----|-----:|--------:|---------:|-------:|------:|-----------:|\n");
  for (const std::string& folder : folders) {
    const auto manifest = read_json_file(folder + "/manifest.json");
    std::map<std::string, std::vector<std::pair<Errors, Errors>>> errors;
    for (const auto& entry : manifest.at("runs")) {
      const std::string scenario = entry.at("scenario"), file = entry.at("file");
      if (scenario.size() != 1 || scenarios.find(scenario) == std::string::npos) continue;
      std::fprintf(stderr, "\r%-70s", file.c_str());
      const std::string path = folder + "/";
      const Log<7> log = read_log<7>(path + file);
      require_external_torque(log);
      if (log.truth.empty() || log.dq.empty() || log.tau_ext.empty())
        throw LogError(log.name + ": tau_ext, dq and the truth m, rx, ry, rz are all needed");
      const auto samples = samples_of(log, request.options.arm, request.options.estimator);
      const auto& noise = entry.at("noise");
      if (numbers(noise.at("coulomb")).cwiseAbs().maxCoeff() > 0)
        throw LogError(log.name + ": the oracle knows of no friction; make the recordings with --kind link_side");
      const double attach = entry.at("attach_time");
      errors[scenario].emplace_back(oracle(log, samples, request.options.estimator, attach,
                                           -numbers(noise.at("tau_bias")), numbers(noise.at("tau_sigma"))),
                                    tracked(log, samples, attach, request.options));
    }
    std::fprintf(stderr, "\r%-70s\r", "");
    for (const auto& [scenario, list] : errors)
      for (std::size_t k = 0; k < kAfter.size(); ++k) {
        double best = 0, own = 0;
        std::vector<double> sizes;  // of rme's errors
        for (const auto& [of_oracle, of_rme] : list) {
          if (std::isnan(of_oracle[k])) continue;
          best += of_oracle[k] * of_oracle[k];
          own += of_rme[k] * of_rme[k];
          sizes.push_back(std::abs(of_rme[k]));
        }
        if (sizes.empty()) continue;
        const auto n = static_cast<double>(sizes.size());
        const auto middle = sizes.begin() + static_cast<std::ptrdiff_t>(sizes.size() / 2);
        std::nth_element(sizes.begin(), middle, sizes.end());
        std::printf("| %-16s | %-2s | %4zu | %7.2f | %8.2f | %6.2f | %5.2f | %10.2f |\n",
                    folder.substr(folder.rfind('/') + 1).c_str(), scenario.c_str(), sizes.size(), kAfter[k],
                    1e3 * std::sqrt(best / n), 1e3 * std::sqrt(own / n), std::sqrt(own / best), 1e3 * *middle);
      }
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("score_oracle", std::string(kUsage) + kSettingsUsage + kReplayUsage + kOwnUsage, argc, argv, run);
}
