// score_run: compares estimates on a run with a known payload with those of least squares.
//
// Plays a log in which the hand holds a known mass from beginning to end. If --empty names a log of an empty hand, that
// log is played directly before. Prints a row of a Markdown table for
//
//   rme                    the estimator's estimates over time
//   batch least squares    one estimate of (m, m r), offsets and friction from the whole run, made afterwards
//   recursive, forgetting  with --empty: (m, m r) from the last seconds, after the offset and friction of the empty log
//                          are subtracted: the usual method for online use
//   KDL's wrench           if the log has measured torque: the force along gravity at the tip as found by Orocos KDL's
//                          ChainExternalWrenchEstimator, divided by gravity, averaged over the last seconds; once from
//                          the torque as it is and, with --empty, once after offset and friction are subtracted
//
// With --mass 0 the hand is empty during the run. With --add, a simulated payload is added to what the hand holds, and
// KDL's wrench is left out. If it was built without Orocos KDL, the program says so and leaves KDL's rows out. Exit
// codes: 0; 2 unusable arguments; 3 unusable log.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <optional>
#include <string>
#include <vector>

#include "check_arm/joint_findings.hpp"
#include "io/program.hpp"
#include "paper/injection/payload_injection.hpp"
#include "replay_log/options.hpp"
#ifdef RME_HAS_KDL
#include "real_arms/kdl_wrench.hpp"
#endif

namespace {

using namespace rme::examples;

constexpr const char* kUsage = "usage: score_run LOG.csv[.gz] --mass KG [options]\n";
constexpr const char* kOwnUsage =
    "  --mass KG           mass that the hand holds [kg]\n"
    "  --add KG            mass of a simulated payload in addition, 6 cm from the tip [kg]\n"
    "  --empty LOG.csv     log of an empty hand, which is played first; friction and offsets for recursive least\n"
    "                      squares and KDL come from it\n"
    "  --name TEXT         name of the run, for the table\n"
    "  --header            print the table's header as well\n";

constexpr double kNinety = 1.6448536269514722;
constexpr double kSettles = 5, kEarly = 10, kMemory = 5;  // [s]

struct Belief {
  double t, mass, deviation;  // since the beginning of the run [s]; estimate and its standard deviation [kg]
};

/// Prints a row of the table. Means are over time, from kSettles on.
/// @param honest  whether the method states a standard deviation
void print(const std::string& run, const char* what, const std::vector<Belief>& beliefs, double truth, bool honest) {
  double error = 0, held = 0, time = 0, early = 0, largest = 0;
  for (std::size_t i = 0; i < beliefs.size(); ++i) {
    const Belief& b = beliefs[i];
    const double step = i > 0 ? b.t - beliefs[i - 1].t : 0, off = std::abs(b.mass - truth);
    if (b.t <= kEarly) early = off;
    if (b.t < kSettles) continue;
    error += step * off;
    held += off <= kNinety * b.deviation ? step : 0;
    time += step;
    if (b.mass > 1.2816 * b.deviation) largest = std::max(largest, b.mass);
  }
  char share[16] = "";
  if (honest) std::snprintf(share, sizeof share, "%.0f", 100 * held / time);
  std::printf("| %s | %s | %.3f | %.3f | %.3f | %.3f | %s | %.2f |\n", run.c_str(), what, error / time, early,
              std::abs(beliefs.back().mass - truth), beliefs.back().mass, share, largest);
}

/// Mass by least squares over all blocks, with each joint's offset and friction.
double batch(const LogBlocks& log, const Eigen::VectorXd& weight) {
  const Eigen::Index joints = log.joints(), n = 4 + 3 * joints;
  Eigen::MatrixXd A = 1e-6 * Eigen::MatrixXd::Identity(n, n);
  Eigen::VectorXd b = Eigen::VectorXd::Zero(n);
  for (Eigen::Index j = 0; j < joints; ++j) {
    for (Eigen::Index i = 0; i < log.blocks(); ++i) {
      Eigen::VectorXd row = Eigen::VectorXd::Zero(n);
      row.head<4>() = log.payload[static_cast<std::size_t>(j)].row(i);
      row.segment<3>(4 + 3 * j) << 1, -log.direction(i, j), -log.velocity(i, j);
      A += weight[j] * row * row.transpose();
      b += weight[j] * row * log.tau(i, j);
    }
  }
  return solve(A, b)[0];
}

std::vector<Belief> recursive(const LogBlocks& log, const Eigen::MatrixXd& torque, const Eigen::VectorXd& weight,
                              double begin) {
  Eigen::Matrix4d A = 1e-3 * Eigen::Matrix4d::Identity();
  Eigen::Vector4d b = Eigen::Vector4d::Zero();
  std::vector<Belief> out;
  for (Eigen::Index i = 0; i < log.blocks(); ++i) {
    const double keep = std::exp(-log.duration[i] / kMemory);
    A *= keep;
    b *= keep;
    for (Eigen::Index j = 0; j < log.joints(); ++j) {
      const Eigen::Vector4d h = log.payload[static_cast<std::size_t>(j)].row(i);
      A += weight[j] * h * h.transpose();
      b += weight[j] * h * torque(i, j);
    }
    out.push_back({log.end[i] - begin, solve(A, b)[0], 0});
  }
  return out;
}

#ifdef RME_HAS_KDL
/// KDL's mass, averaged with the same memory as recursive least squares.
/// @param known  offset and friction to subtract, in the shape of blocks.tau [N m]; or empty
template <int Dofs>
std::vector<Belief> kdl_wrench(const Log<Dofs>& log, const Samples<Dofs>& samples, const LogBlocks& blocks,
                               const RecordedArm<Dofs>& arm, double sign, const Eigen::MatrixXd& known) {
  constexpr double kGain = 50;  // as that of the other observers [1/s]
  // Of 1e-5, 0.03, 0.1, 0.2, 0.3 and 0.5, the best value for KDL on these recordings. With 1e-5, its default, the error
  // is tens of kilograms: near singular poses it divides friction by almost zero.
  constexpr double kSingular = 0.1;
  KdlTipMass<Dofs> tip(arm.model, arm.rotor_inertia, samples.timing.period, kGain, kSingular);
  std::vector<Belief> out;
  Eigen::Index block = 0;
  double sum = 0, weight = 0;
  for (std::size_t k = 0; k < samples.sample.size(); ++k) {
    const std::size_t row = samples.row[k];
    const double t = log.t[row], step = k > 0 ? t - log.t[samples.row[k - 1]] : samples.timing.period;
    rme::JointVector<double, Dofs> tau = sign * arm.gains.cwiseProduct(log.tau[row]);
    while (block + 1 < blocks.blocks() && blocks.end[block] < t) ++block;
    if (known.size() > 0)  // tau_ext is the model's torque minus tau
      tau += known.row(block).transpose() - load_friction(arm, log.q[row], samples.sample[k].dq);
    const double keep = std::exp(-step / kMemory);
    sum = keep * sum + step * tip.update(log.q[row], samples.sample[k].dq, tau);
    weight = keep * weight + step;
    out.push_back({t - log.t.front(), sum / weight, 0});
  }
  return out;
}
#endif

/// One log after the other, a period apart.
template <int Dofs>
Log<Dofs> joined(Log<Dofs> first, const Log<Dofs>& second) {
  const double shift = first.t.back() + nominal_period(second.t) - second.t.front();
  for (const double t : second.t) first.t.push_back(t + shift);
  const auto append = [](auto& to, const auto& from) { to.insert(to.end(), from.begin(), from.end()); };
  append(first.q, second.q);
  append(first.dq, second.dq);
  append(first.tau, second.tau);
  append(first.tau_ext, second.tau_ext);
  return first;
}

/// The samples, with a payload of this mass in the hand from `begin` on [s].
template <int Dofs>
Samples<Dofs> loaded(const Log<Dofs>& log, const Samples<Dofs>& samples, const RecordedArm<Dofs>& arm, double mass,
                     double begin) {
  if (!(mass > 0)) return samples;
  constexpr double kCentre = 0.06, kWidth = 0.08;  // of a cube [m]
  Injected injected_payload;
  injected_payload.t = begin;
  injected_payload.payload = rme::InertialParameters<double>::of_body(
      {mass, {0, 0, kCentre}}, Eigen::Matrix3d(mass * kWidth * kWidth / 6 * Eigen::Matrix3d::Identity()));
  return injected(log, samples, motion_of(log, samples), arm.model.gravity_vector, injected_payload, log.t.front(),
                  log.t.back());
}

template <int Dofs>
int run(Arguments& arguments, const ArmRequest& request) {
  const ArmSettings<Dofs> settings = parse_settings<Dofs>(arguments, request);
  const auto mass = arguments.number("--mass");
  if (!mass || !(*mass >= 0)) throw ArgumentError("--mass: must say what the hand holds, 0 or more kg");
  const double added = arguments.number("--add").value_or(0);
  if (!(added >= 0)) throw ArgumentError("--add: must be the mass of a simulated payload, 0 or more kg");
  const double held = *mass + added;
  const auto empty = arguments.text("--empty");
  const bool header = arguments.flag("--header");
  const auto name = arguments.text("--name");
  const std::string file = arguments.positional("LOG.csv");
  arguments.finish();
  const auto read = [&](const std::string& path) {
    Log<Dofs> log = read_log<Dofs>(path);
    require_external_torque(log);
    log.truth.clear();
    return log;
  };
  const Log<Dofs> log = read(file);
  if (header)
    std::printf(
        "| run | by | mean error from 5 s on [kg] | error at 10 s [kg] | error at the end [kg] | mass at the end [kg] "
        "| 90 %% interval holds [%%] | largest mass, 90 %% sure [kg] |\n|---|---|---:|---:|---:|---:|---:|---:|\n");
  const std::string title = name.value_or(file.substr(file.rfind('/') + 1));
  const Samples<Dofs> samples = samples_of(log, settings.arm, settings.config);
  const LogBlocks blocks = blocks_of(log, loaded(log, samples, settings.arm, added, log.t.front()), settings.arm);
  Eigen::VectorXd weight = Eigen::VectorXd::Ones(Dofs);
  Eigen::MatrixXd without_friction = blocks.tau;
  Log<Dofs> life = log;
  if (empty) {
    const Log<Dofs> before = read(*empty);
    if (before.tau_ext.empty() != log.tau_ext.empty() || before.dq.empty() != log.dq.empty())
      throw LogError(before.name + ": has other columns than " + log.name);
    const std::vector<LogBlocks> logs = {
        blocks_of(before, samples_of(before, settings.arm, settings.config), settings.arm)};
    const std::vector<JointFindings> joints = find_joints(logs);
    without_friction = unexplained(blocks, 0, joints);
    const Eigen::MatrixXd left = unexplained(logs.front(), 0, joints);
    for (int j = 0; j < Dofs; ++j)
      weight[j] = 1 / std::max(1e-8, left.col(j).squaredNorm() / static_cast<double>(left.rows()));
    life = joined(before, log);
  }
  const double begin = life.t.back() - (log.t.back() - log.t.front());
  std::vector<Belief> beliefs;
  ReplayOptions<Dofs> options;
  options.arm = settings.arm;
  options.estimator = settings.config;
  replay<Dofs>(
      life, loaded(life, samples_of(life, settings.arm, settings.config), settings.arm, added, begin), options,
      [&](const ReplayedEstimate& e) {
        if (e.t >= begin)
          beliefs.push_back({e.t - begin, e.state.payload.mean[0], e.state.payload.standard_deviation()[0]});
      },
      [](const ReplayedPush&) {});
  if (beliefs.empty() || beliefs.back().t < kSettles + 1) throw LogError(log.name + ": is shorter than 6 s");
  print(title, "rme", beliefs, held, true);
  const double hindsight = batch(blocks, weight);
  std::printf("| | batch least squares | | | %.3f | %.3f | | |\n", std::abs(hindsight - held), hindsight);
  if (empty)
    print("", "recursive, forgetting", recursive(blocks, without_friction, weight, log.t.front()), held, false);
  if (!log.tau_ext.empty() || added > 0) return 0;  // KDL takes the torque that the motors give
#ifdef RME_HAS_KDL
  const double sign = static_cast<double>(settings.config.torque_sign);
  print("", "KDL's wrench", kdl_wrench(log, samples, blocks, settings.arm, sign, {}), held, false);
  if (empty)
    print("", "KDL's wrench, friction known",
          kdl_wrench(log, samples, blocks, settings.arm, sign, blocks.tau - without_friction), held, false);
#else
  std::fprintf(stderr, "score_run: built without Orocos KDL (liborocos-kdl-dev): no rows of its wrench estimator\n");
#endif
  return 0;
}

int run(Arguments& arguments) {
  const ArmRequest request = parse_arm(arguments);
  return with_joint_count(request.dofs(), [&](auto dofs) { return run<dofs()>(arguments, request); });
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("score_run", std::string(kUsage) + kArmUsage + kSettingsUsage + kOwnUsage, argc, argv, run);
}
