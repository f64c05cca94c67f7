// score_run: compares rme with other methods on a run with a known payload.
//
// Plays a log in which the hand holds a known mass from beginning to end. If --empty names a log of an empty hand, that
// log is played directly before. Prints a row of a Markdown table for rme and for each of its rivals
// (examples/rivals/rivals.hpp), with the same settings for all. With --tare, the rivals' offset and friction come from
// that log of an empty hand; without it, from --empty. With --mass 0 the hand is empty during the run. With --add, a
// simulated payload is added to what the hand holds, and KDL's wrench is left out. With --output, the estimates over
// time are written for plot.py, and the scores are appended to a table that page.py reads. Exit codes: 0; 2 unusable
// arguments; 3 unusable log.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <limits>
#include <optional>
#include <string>
#include <vector>

#include "io/program.hpp"
#include "paper/injection/payload_injection.hpp"
#include "replay_log/options.hpp"
#include "rivals/run_score.hpp"

namespace {

using namespace rme::examples;

constexpr const char* kUsage = "usage: score_run LOG.csv[.gz] --mass KG [options]\n";
constexpr const char* kOwnUsage =
    "  --mass KG           mass that the hand holds [kg]\n"
    "  --add KG            mass of a simulated payload in addition, 6 cm from the tip [kg]\n"
    "  --empty LOG.csv     log of an empty hand, which is played first\n"
    "  --tare LOG.csv      log of an empty hand, from which the rivals have offset and friction (that of --empty)\n"
    "  --weights W.json    the network of the published pipeline, which is left out without it\n"
    "  --name TEXT         name of the run, for the table\n"
    "  --header            print the table's header as well\n"
    "  --output DIR        append the scores to DIR/scores.csv, and write the estimates to DIR/NAME.csv, for plot.py\n";

/// A cell of the table: the number, or nothing if there is none.
std::string cell(double value, const char* format = "%.3f") {
  if (!std::isfinite(value)) return "";
  char text[32];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

void print(const std::string& run, const Rival& method, double truth, const RunScore& score) {
  const bool online = method.masses.size() > 1, empty = truth == 0;
  const double none = std::numeric_limits<double>::quiet_NaN();
  std::printf("| %s | %s | %s | %s | %s | %s | %s | %s |\n", run.c_str(), method.name.c_str(),
              cell(online ? score.mean_error : none).c_str(), cell(online ? score.largest_error : none).c_str(),
              cell(score.end_error).c_str(), cell(empty || !online ? none : score.close, "%.1f").c_str(),
              cell(empty ? score.largest_mass : none).c_str(), cell(100 * score.held, "%.0f").c_str());
}

/// The run's name as a file's.
std::string file_name(std::string name) {
  std::replace_if(
      name.begin(), name.end(), [](char c) { return !std::isalnum(static_cast<unsigned char>(c)) && c != '.'; }, '_');
  return name;
}

/// Appends the scores, and writes the estimates.
void write(const std::string& folder, const std::string& run, double truth, double begin,
           const std::vector<Rival>& methods, const std::vector<RunScore>& scores) {
  std::ofstream table(folder + "/scores.csv", std::ios::app);
  if (table.tellp() == 0) table << "run,by,truth,mean,largest,end,close,false,held\n";
  std::ofstream file(folder + "/" + file_name(run) + ".csv");
  file << "by,t,mass,deviation,truth\n";
  for (std::size_t i = 0; i < methods.size(); ++i) {
    const RunScore& s = scores[i];
    table << '"' << run << "\",\"" << methods[i].name << "\"," << truth << ',' << s.mean_error << ',' << s.largest_error
          << ',' << s.end_error << ',' << s.close << ',' << s.largest_mass << ',' << s.held << '\n';
    for (const MassAt& m : methods[i].masses)
      file << '"' << methods[i].name << "\"," << m.t - begin << ',' << m.mass << ',' << m.deviation << ',' << truth
           << '\n';
  }
  if (!table.flush() || !file.flush()) throw LogError("--output: cannot write to " + folder);
}

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
  const auto empty = arguments.text("--empty"), tare = arguments.text("--tare"), name = arguments.text("--name"),
             weights = arguments.text("--weights"), folder = arguments.text("--output");
  const bool header = arguments.flag("--header");
  const std::string file = arguments.positional("LOG.csv");
  arguments.finish();
  if (folder) make_folder("--output", *folder);
  const auto read = [&](const std::string& path) {
    Log<Dofs> log = read_log<Dofs>(path);
    require_external_torque(log);
    log.truth.clear();
    return log;
  };
  const Log<Dofs> log = read(file);
  std::optional<Log<Dofs>> before, known;
  if (empty) before = read(*empty);
  if (tare || empty) known = read(tare ? *tare : *empty);
  if (before && (before->tau_ext.empty() != log.tau_ext.empty() || before->dq.empty() != log.dq.empty()))
    throw LogError(before->name + ": has other columns than " + log.name);
  std::optional<NetworkFile> network;
  if (weights) network = read_network_file(*weights);
  if (log.t.back() - log.t.front() < 6) throw LogError(log.name + ": is shorter than 6 s");

  const Log<Dofs> life = before ? joined(*before, log) : log;
  const double begin = life.t.back() - (log.t.back() - log.t.front());
  Rival ours{"rme", {}};
  ReplayOptions<Dofs> options;
  options.arm = settings.arm;
  options.estimator = settings.config;
  replay<Dofs>(
      life, loaded(life, samples_of(life, settings.arm, settings.config), settings.arm, added, begin), options,
      [&](const ReplayedEstimate& e) {
        if (e.t >= begin)
          ours.masses.push_back(
              {e.t - begin + log.t.front(), e.state.payload.mean[0], e.state.payload.standard_deviation()[0]});
      },
      [](const ReplayedPush&) {});
  if (ours.masses.empty()) throw LogError(log.name + ": no sample of it can be used");

  const Samples<Dofs> samples =
      loaded(log, samples_of(log, settings.arm, settings.config), settings.arm, added, log.t.front());
  std::vector<Rival> methods =
      run_rivals<Dofs>({log, samples, settings, known ? &*known : nullptr, network ? &*network : nullptr, added > 0});
  methods.insert(methods.begin(), ours);
  const double moved = moved_for(log, samples, 2);
  std::vector<RunScore> scores;
  for (const Rival& method : methods) scores.push_back(score_run(method.masses, held, log.t.front(), moved));
  if (header)
    std::printf(
        "| run | by | mean error from 5 s on [kg] | largest error after 2 s of motion [kg] | error at the end [kg] | "
        "within 10 %% after [s] | false mass [kg] | 90 %% interval holds [%%] |\n"
        "|---|---|---:|---:|---:|---:|---:|---:|\n");
  const std::string title = name.value_or(file.substr(file.rfind('/') + 1));
  for (std::size_t i = 0; i < methods.size(); ++i) print(i == 0 ? title : "", methods[i], held, scores[i]);
  if (folder) write(*folder, title, held, log.t.front(), methods, scores);
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
