// make_logs: writes recordings of a simulated Panda, with the truth in every row.
//
// Pose, payload, pushes, path and sensor faults of every recording are drawn at random from its seed. A draw that
// brings the arm near a joint limit or a singular pose, or demands too much speed or torque of a joint, is replaced by
// another one. The files have the format of all logs (docs/conventions.md). A new seed gives data that nothing was
// tuned on.
#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <mujoco_arm/physics_option.hpp>
#include <stdexcept>

#include "io/program.hpp"
#include "make_logs/recording.hpp"
#include "paper/experiment/report.hpp"

namespace {

using namespace rme::examples;

constexpr int kTries = 200;  // draws for one recording

constexpr const char* kUsage = R"(usage: rme_make_logs --output DIR [options]

Writes recordings of a simulated Panda: NAME.csv.gz with the truth in every row, and manifest.json, which describes the
events of each recording.

  --output DIR      the folder; it is created if it does not exist
  --kind NAME       link_side: torque is sensed behind the gears (default); joint_friction: at the motors, so that it
                    contains joint friction; model_error: link_side, and the model's link masses are off by 1 % and
                    their centres of mass by 1 mm (standard deviations)
  --scenario A,B    list of scenarios (default all)
                      A  a payload is attached at 1 s, near the ready pose, without compensation
                      B  the same in any pose
                      D  payload A is attached, B is added, B is removed, A is removed; pushes of 5 to 15 N in between
                      E  attached at 1 s at rest, carried and turned from 3 s on, with the true payload compensated
                      F  a cup is attached at 1 s and filled from 3 s on for 4 to 15 s
                      H  as E, but it is taken over gradually, within 0.3 to 3 s
                      M  always moving; attached at 5 s, removed at 12 s, with the true payload compensated
  --runs N          recordings of each scenario (default 4)
  --seed N          of everything random (default 1)
  --physics NAME    synthetic (default), or mujoco if this was built with it
  --dq-noise W      white noise on the reported joint velocity, standard deviation [rad/s]; real arms: 0.002 to 0.004
  --noisy-observer  the observer of tau_ext gets that noisy velocity too
  --torque-step T   tau_ext is quantised in steps of T [N m]
  --late N          tau_ext is delayed by N ticks, at most 1000
  --lost P          share of the rows that are missing, below 1
  --mass-error S    error of the model's link masses, relative, standard deviation
  --com-error D     error of each coordinate of the model's link centres of mass, standard deviation [m]
  --plain           write NAME.csv, not compressed
  --help            this text

Exit codes: 0 done; 2 unusable arguments; 3 a file cannot be written.
)";

struct Options {
  std::string output, kind, scenarios;
  Engine engine = Engine::Synthetic;
  std::size_t runs = 4;
  std::uint64_t seed = 1;
  bool plain = false;
  SyntheticArmConfig<7> faults;  // those that are chosen, not drawn
};

std::string parse_scenarios(const std::string& list) {
  std::string out;
  bool good = list.size() % 2 == 1;
  for (std::size_t i = 0; i < list.size(); ++i) {
    good = good && (i % 2 == 1 ? list[i] == ',' : kScenarios.find(list[i]) != std::string::npos);
    if (i % 2 == 0 && out.find(list[i]) == std::string::npos) out += list[i];
  }
  if (!good) throw ArgumentError("--scenario: \"" + list + "\" is not a list such as A,B; there are " + kScenarios);
  return out;
}

// The option's value, which must be at least 0 and below `bound`.
double parse_size(Arguments& arguments, const std::string& option, double bound, double otherwise) {
  const double size = arguments.number(option).value_or(otherwise);
  if (!(size >= 0 && size < bound)) throw ArgumentError(text("%s: must be from 0 to below %g", option.c_str(), bound));
  return size;
}

SyntheticArmConfig<7> parse_faults(Arguments& arguments, bool model_error) {
  SyntheticArmConfig<7> faults;
  faults.dq_noise.setConstant(parse_size(arguments, "--dq-noise", 1, 0));
  faults.noisy_observer = arguments.flag("--noisy-observer");
  faults.torque_step = parse_size(arguments, "--torque-step", 10, 0);
  faults.torque_delay = static_cast<int>(arguments.whole("--late", 0, 1000).value_or(0));
  faults.loss = parse_size(arguments, "--lost", 1, 0);
  faults.mass_error = parse_size(arguments, "--mass-error", 1, model_error ? 0.01 : 0);
  faults.com_error = parse_size(arguments, "--com-error", 0.1, model_error ? 0.001 : 0);
  return faults;
}

Options parse(Arguments& arguments) {
  Options options;
  using Names = std::vector<std::pair<std::string, std::string>>;
  const auto named = [](const char* name) { return std::pair<std::string, std::string>(name, name); };
  const Names kinds = {named("link_side"), named("joint_friction"), named("model_error")};
  options.kind = arguments.choice("--kind", kinds).value_or("link_side");
  options.engine = parse_engine(arguments);
  options.scenarios = kScenarios;
  if (const auto list = arguments.text("--scenario")) options.scenarios = parse_scenarios(*list);
  options.runs = arguments.whole("--runs", 1, 1000).value_or(4);
  options.seed = arguments.whole("--seed", 0).value_or(1);
  options.plain = arguments.flag("--plain");
  options.faults = parse_faults(arguments, options.kind == "model_error");
  const auto output = arguments.text("--output");
  arguments.finish();
  if (!output) throw ArgumentError("--output: missing");
  options.output = *output;
  make_folder("--output", options.output);
  return options;
}

SyntheticArmConfig<7> draw_arm(const Options& options, std::uint64_t seed) {
  const SyntheticArmConfig<7> drawn = with_typical_faults(panda(), seed);
  SyntheticArmConfig<7> config = options.faults;
  config.seed = drawn.seed;
  config.torque_noise = drawn.torque_noise;
  config.torque_offset = drawn.torque_offset;
  if (options.kind == "joint_friction") config.friction = drawn.friction;
  use_engine(options.engine, config);
  return config;
}

/// Draws until the arm can carry out the plan, and writes the recording.
ManifestEntry make(const Options& options, char scenario, std::size_t run) {
  std::seed_seq seeds{static_cast<std::uint32_t>(options.seed), static_cast<std::uint32_t>(scenario),
                      static_cast<std::uint32_t>(run)};
  std::mt19937_64 random(seeds);
  const std::string name = text("%c_%02zu", scenario, run);
  ManifestEntry entry{name, name + (options.plain ? ".csv" : ".csv.gz"), 0, {}, {}};
  std::string refusal;
  for (int attempt = 0; attempt < kTries; ++attempt) {
    entry.seed = random() >> 32;
    entry.plan = draw_plan(scenario, random);
    entry.config = draw_arm(options, entry.seed);
    const Recording recording = record(entry.plan, entry.config);
    refusal = recording.refusal;
    if (!refusal.empty()) continue;
    write_log((std::filesystem::path(options.output) / entry.file).string(), recording);
    return entry;
  }
  throw std::runtime_error(name + ": no draw that the arm can carry out, at last for a " + refusal);
}

int run(Arguments& arguments) {
  const Options options = parse(arguments);
  const std::size_t all = options.runs * options.scenarios.size();
  std::vector<ManifestEntry> entries;
  for (const char scenario : options.scenarios) {
    for (std::size_t i = 0; i < options.runs; ++i) {
      entries.push_back(make(options, scenario, i));
      progress("recordings", entries.size(), all);
    }
  }
  const std::string path = (std::filesystem::path(options.output) / "manifest.json").string();
  std::ofstream file(path);
  file << manifest(options.kind, options.engine == Engine::Mujoco ? "mujoco" : "synthetic", entries);
  if (!file.flush()) throw std::runtime_error("cannot write " + path);
  std::printf("%zu recordings in %s\n", entries.size(), options.output.c_str());
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_make_logs", kUsage, argc, argv, run);
}
