// check_arm: analyses an arm's torque with an empty hand, and finds the lightest payload that it can show.
//
// Reads logs in replay_log's format in which the hand is empty. Prints noise, offset, friction and what is left, joint
// by joint; what is wrong with the logs, and the option that mends it; the lightest payload that shows within 0.2, 1 and 5 s; and
// what the estimator finds in the same logs with the settings that check_arm makes. With --output it writes these
// settings (settings.json, for replay_log --config and for Estimator) and the data that plot.py draws. If other masses,
// centres of mass and inertias of the links explain measured torque much better than those of the URDF, the settings
// are for the corrected arm, which is written to corrected.urdf. The logs should show the motions that the arm makes at
// work: each joint in both directions, slowly and fast, with stops. Exit codes: 0; 1 something is wrong with a
// log; 2 unusable arguments; 3 unusable log or URDF.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <rme/estimator_json.hpp>
#include <string>
#include <vector>

#include "check_arm/joint_findings.hpp"
#include "check_arm/link_correction.hpp"
#include "check_arm/observer_step.hpp"
#include "io/program.hpp"
#include "log_diagnosis/recorded_log.hpp"
#include "replay_log/options.hpp"
#include "replay_log/settings_model.hpp"

namespace {

using namespace rme::examples;

constexpr const char* kUsage = "usage: check_arm LOG.csv[.gz]... [options]\n";
constexpr const char* kOwnUsage =
    "  --span T0:T1        use only the logs' rows of [T0, T1) [s]\n"
    "  --mass M            mass of the payload for which the error of the centre of mass is printed [kg] (1)\n"
    "  --keep-links        do not correct the URDF's links\n"
    "  --output FOLDER     write settings.json and the data that plot.py draws there\n";

constexpr double kWindows[] = {0.2, 1, 5};  // [s]

/// The logs, and how they are read.
struct Inputs {
  std::vector<std::string> files;
  std::optional<std::vector<double>> span;
  LogFormat format;
  std::vector<std::string> joints;
};

template <int Dofs>
FormattedLog<Dofs> read(const std::string& file, const Inputs& inputs) {
  FormattedLog<Dofs> out = read_formatted_log<Dofs>(file, inputs.format, inputs.joints);
  require_external_torque(out.log);
  if (inputs.span) out.log = cropped(out.log, (*inputs.span)[0], (*inputs.span)[1]);
  if (out.log.size() < 2) throw LogError(out.log.name + ": has fewer than two rows, which gives no sample rate");
  require_empty_hand(out.log);
  return out;
}

template <int Dofs>
struct Checked {
  std::vector<Log<Dofs>> logs;
  std::vector<Samples<Dofs>> samples;
  std::vector<LogBlocks> blocks;
};

template <int Dofs>
Checked<Dofs> read(const Inputs& inputs, const ArmSettings<Dofs>& settings) {
  Checked<Dofs> out;
  double seconds = 0;
  for (const std::string& file : inputs.files) {
    const Log<Dofs> log = read<Dofs>(file, inputs).log;
    out.samples.push_back(samples_of(log, settings.arm, settings.config));
    out.blocks.push_back(blocks_of(log, out.samples.back(), settings.arm));
    seconds += out.blocks.back().duration.sum();
    out.logs.push_back(log);
  }
  if (seconds < 5)
    throw LogError(inputs.files.front() + ": 5 s of an empty hand are needed, the logs hold " +
                   std::to_string(seconds));
  return out;
}

void print(const char* name, const std::vector<JointFindings>& joints, const char* format,
           double (*value)(const JointFindings&), bool (*known)(const JointFindings&)) {
  std::printf("%-26s", name);
  for (const JointFindings& joint : joints) {
    char text[32];
    std::snprintf(text, sizeof text, format, value(joint));
    std::printf("%9s", known(joint) ? text : "?");
  }
  std::printf("\n");
}

double rms(const std::vector<double>& values) {
  double sum = 0;
  for (const double v : values) sum += v * v;
  return std::sqrt(sum / static_cast<double>(values.size()));
}

void print(const std::vector<JointFindings>& joints) {
  const auto always = [](const JointFindings&) { return true; };
  const auto friction = [](const JointFindings& j) { return j.friction_known; };
  const auto gravity = [](const JointFindings& j) { return j.gravity_seen; };
  const auto rests = [](const JointFindings& j) { return j.rests; };
  std::printf("%-26s", "joint");
  for (std::size_t j = 1; j <= joints.size(); ++j) std::printf("%9zu", j);
  std::printf("\n");
  print(
      "noise of 20 ms [N m]", joints, "%.4f", [](const JointFindings& j) { return j.noise; }, always);
  print(
      "offset, rms of logs [N m]", joints, "%.3f", [](const JointFindings& j) { return rms(j.offset); }, always);
  print(
      "Coulomb friction [N m]", joints, "%.3f", [](const JointFindings& j) { return j.coulomb; }, friction);
  print(
      "viscous [N m s/rad]", joints, "%.3f", [](const JointFindings& j) { return j.viscous; }, friction);
  print(
      "  more for each N m of load", joints, "%.3f", [](const JointFindings& j) { return j.coulomb_per_load; },
      friction);
  print(
      "stiction at rest [N m]", joints, "%.3f", [](const JointFindings& j) { return j.stiction; }, rests);
  print(
      "what is left [N m]", joints, "%.3f", [](const JointFindings& j) { return j.residual; }, always);
  print(
      "  correlated over [s]", joints, "%.2f", [](const JointFindings& j) { return j.correlation_time; }, always);
  print(
      "follows gravity by", joints, "%.2f", [](const JointFindings& j) { return j.gravity_slope; }, gravity);
  std::printf("? the logs do not tell: the joint has to move both ways, or to rest, for a second each\n");
  std::string growing;
  for (std::size_t j = 0; j < joints.size(); ++j)
    if (joints[j].coulomb_per_load > 0) growing += (growing.empty() ? "" : ", ") + std::to_string(j + 1);
  if (!growing.empty())
    std::printf(
        "friction grows with what joint %s carries, by the model's gravity: a payload adds friction, which the "
        "estimator does not model\n",
        growing.c_str());
  std::printf("\n");
}

template <int Dofs>
rme::EstimatorConfig<double, Dofs> settings_of(const std::vector<JointFindings>& joints,
                                               const ArmSettings<Dofs>& given) {
  rme::EstimatorConfig<double, Dofs> out = given.config;
  const auto usual = out.arm.value_or(rme::ArmPrior<double, Dofs>::of(out.rated_payload));
  rme::ArmPrior<double, Dofs> arm = usual;
  // A residual above this share of the default scale is too large for a link-side sensor or a friction model.
  constexpr double kRough = 0.1;
  // The residual's scale is learned as the arm runs. The ratios between joints in a log hold for its poses only. So
  // they are raised to this power, which was chosen on the recordings of docs/real_arms.md.
  constexpr double kTrust = 0.4;
  double friction = 0, noise = 0, residual = 0, limit = 0, scale = 0;
  const auto ratio = [&](int j) {
    return std::max(joints[static_cast<std::size_t>(j)].residual / usual.residual[j], 1e-3);
  };
  for (int j = 0; j < Dofs; ++j) scale += std::log(ratio(j)) / Dofs;
  for (int j = 0; j < Dofs; ++j) {
    const JointFindings& joint = joints[static_cast<std::size_t>(j)];
    const auto logs = static_cast<double>(joint.offset.size());
    arm.noise[j] = std::max(joint.noise, 1e-4);
    // A few logs say little about the spread of the offsets: the default counts as one more log.
    const double square = rms(joint.offset) * rms(joint.offset) * logs + usual.offset[j] * usual.offset[j];
    arm.offset[j] = std::sqrt(square / (logs + 1));
    residual += joint.residual;
    limit += kRough * usual.residual[j];
    arm.residual[j] = usual.residual[j] * std::exp(kTrust * (std::log(ratio(j)) - scale));
    if (joint.friction_known) {
      arm.coulomb[j] = std::max(joint.coulomb, 1e-3);
      arm.viscous[j] = std::max(joint.viscous, 1e-3);
      friction += joint.coulomb;
      noise += joint.noise + joint.residual;
    }
  }
  // With a link-side sensor, what looks like friction is an error of the model.
  if (!out.sensing && residual > limit)
    out.sensing = rme::Sensing::RoughModel;
  else if (!out.sensing && friction > noise)
    out.sensing = rme::Sensing::JointFriction;
  out.arm = arm;
  return out;
}

/// Prints what the estimator finds in the logs; the hand is empty in all of them.
/// @return the largest mass that it estimates while an empty hand has a probability below 10 % [kg]
template <int Dofs>
double print_beliefs(const Checked<Dofs>& checked, const ArmSettings<Dofs>& settings) {
  double heaviest = 0;
  std::printf("\nestimates in these logs, these settings     mean mass [kg]  largest, 90%% sure [kg]  empty  health\n");
  for (std::size_t k = 0; k < checked.logs.size(); ++k) {
    ReplayOptions<Dofs> options;
    options.arm = settings.arm;
    options.estimator = settings.config;
    double mass = 0, largest = 0, empty = 0, health = 0, time = 0, last = checked.logs[k].t.front();
    replay<Dofs>(
        checked.logs[k], checked.samples[k], options,
        [&](const ReplayedEstimate& e) {
          const double step = e.t - last;
          last = e.t;
          const auto& payload = e.state.payload;
          mass += step * payload.mean[0];
          empty += e.state.empty() ? step : 0;
          health += step * e.state.health;
          time += step;
          if (e.state.held > 0.9) largest = std::max(largest, payload.mean[0]);
        },
        [](const ReplayedPush&) {});
    std::printf("  %-40.40s %15.3f %23.3f %5.0f%% %7.1f\n",
                checked.logs[k].name.substr(checked.logs[k].name.rfind('/') + 1).c_str(), mass / time, largest,
                100 * empty / time, health / time);
    heaviest = std::max(heaviest, largest);
  }
  return heaviest;
}

/// The results from the logs with one model of the arm.
template <int Dofs>
struct Findings {
  Checked<Dofs> checked;
  std::vector<JointFindings> joints;
  std::vector<Visibility> seen;
  ArmSettings<Dofs> settings;  ///< the settings that result
};

/// Analyses the logs and prints the results.
/// @param mass  of the payload for which the error of the centre of mass is printed [kg]
template <int Dofs>
Findings<Dofs> check(const Inputs& inputs, const ArmSettings<Dofs>& settings, double mass) {
  Findings<Dofs> out{read<Dofs>(inputs, settings), {}, {}, settings};
  const Checked<Dofs>& checked = out.checked;
  out.joints = find_joints(checked.blocks);
  print(out.joints);
  const bool measured = checked.logs.front().tau_ext.empty();
  if (!measured) {
    double fastest = 0;
    for (std::size_t k = 0; k < checked.logs.size(); ++k)
      fastest = std::max(fastest, fastest_step(checked.logs[k].t, checked.logs[k].tau_ext, checked.logs[k].dq));
    if (fastest > 0)
      std::printf("a step in tau_ext takes 1/%.0f s: the observer's bandwidth is at least %.0f rad/s; set: %g rad/s\n",
                  fastest, fastest, settings.config.observer_bandwidth);
    else
      std::printf("no step in tau_ext while the arm rests, so the observer's bandwidth does not show; set: %g rad/s\n",
                  settings.config.observer_bandwidth);
  }
  for (const double window : kWindows)
    out.seen.push_back(visibility(checked.blocks, out.joints, window, settings.config.rated_payload));
  std::printf(
      "\nwithin [s]   lightest payload that shows [kg]   mass +- [kg]  (expected)   centre of mass of %g kg +- [mm]\n",
      mass);
  for (const Visibility& v : out.seen) {
    if (v.windows == 0)
      std::printf("%10.1f   the logs are shorter\n", v.window);
    else
      std::printf("%10.1f   %32.3f   %12.3f  %10.3f   %30.0f\n", v.window, v.lightest(), v.mass, v.expected_mass,
                  1e3 * v.moment / mass);
  }
  // The tracker assumes that the joints' errors are independent. An error that all joints have in common, such as that
  // of a link's mass, looks more like a payload.
  double surprise = 1;
  for (const Visibility& v : out.seen)
    if (v.windows > 0 && v.expected_mass > 0) surprise = std::max(surprise, v.mass / v.expected_mass);
  if (surprise > 1.2)
    std::printf("the empty hand's mass is uncertain by up to %.1f times as much as independent errors explain\n",
                surprise);
  out.settings.config = settings_of<Dofs>(out.joints, settings);
  out.settings.config.validate(0.001);
  const double false_mass = print_beliefs<Dofs>(checked, out.settings);
  if (false_mass > 0)
    std::printf("an empty hand was taken to hold up to %.3f kg: trust no lighter payload\n", false_mass);
  return out;
}

/// Prints how the logs were read, and what is wrong with them.
/// @param mending  the options that mend the first log with which something is wrong
/// @return whether they can be used
template <int Dofs>
bool judge_logs(const Inputs& inputs, const ArmSettings<Dofs>& settings, std::string& mending) {
  bool usable = true;
  for (const std::string& file : inputs.files) {
    const FormattedLog<Dofs> log = read<Dofs>(file, inputs);
    for (const std::string& note : log.notes) std::fprintf(stderr, "check_arm: %s: %s\n", file.c_str(), note.c_str());
    const Diagnosis diagnosis = diagnose(log, settings.arm, settings.config, inputs.format, false);
    std::printf("%s: %s\n", file.c_str(), diagnosis.sentence().c_str());
    for (const std::string& remark : diagnosis.remarks) std::printf("%s: %s\n", file.c_str(), remark.c_str());
    if (!log.log.tau_ext.empty() && diagnosis.usable())
      std::printf("the sign of tau_ext does not show here: hang a known weight on the arm\n");
    if (usable) mending = diagnosis.options();
    usable = usable && diagnosis.usable();
  }
  std::printf("\n");
  return usable;
}

/// Tests whether other links and rotors explain the logs much better, and prints the result. If so, writes them to
/// `better`.
/// @return whether they do
template <int Dofs>
bool judge_links(const Findings<Dofs>& found, const ArmSettings<Dofs>& settings, ArmSettings<Dofs>& better) {
  constexpr double kWorthwhile = 2.0 / 3;  // of what is left
  const Checked<Dofs>& checked = found.checked;
  std::vector<LinkRegressors> regressors;
  for (std::size_t k = 0; k < checked.logs.size(); ++k)
    regressors.push_back(link_regressors(checked.logs[k], checked.samples[k], settings.arm));
  std::vector<RigidBody> bodies;
  for (const Link& link : settings.chain->links) bodies.push_back(link.body);
  const LinkCorrection correction = correct_links(checked.blocks, regressors, found.joints, bodies);
  std::printf(
      "\nother masses, centres and inertias of the links and rotors would leave %.0f %% of what is left, out of sample",
      100 * correction.left);
  if (correction.left > kWorthwhile) {
    std::printf(": no correction\n");
    return false;
  }
  std::printf(":\nlink                      mass [kg]: URDF, corrected    centre [m]: URDF, corrected\n");
  for (std::size_t l = 0; l < bodies.size(); ++l) {
    const RigidBody& was = bodies[l];
    RigidBody& body = better.chain->links[l].body;
    body = corrected(was, correction.addition[l]);
    std::printf("%-30.30s %9.3f %9.3f   %7.3f %7.3f %7.3f %7.3f %7.3f %7.3f\n", settings.chain->joints[l].name.c_str(),
                was.mass, body.mass, was.com[0], was.com[1], was.com[2], body.com[0], body.com[1], body.com[2]);
  }
  for (int j = 0; j < Dofs; ++j) better.arm.rotor_inertia[j] += correction.rotor[static_cast<std::size_t>(j)];
  better.arm.model = arm_model<Dofs>(*better.chain);
  better.arm.model.gravity_vector = settings.arm.model.gravity_vector;
  return true;
}

template <int Dofs>
void write(const std::string& folder, const Findings<Dofs>& found) {
  make_folder("--output", folder);
  const ArmSettings<Dofs>& settings = found.settings;
  nlohmann::json json = rme::estimator_config_to_json(settings.config);
  if (settings.corrected) {
    const auto &rotor = settings.arm.rotor_inertia, &load = settings.arm.load_friction;
    json["model"] = model_to_json(*settings.chain, "corrected.urdf", {rotor.data(), rotor.data() + Dofs},
                                  {load.data(), load.data() + Dofs});
    std::ofstream(folder + "/corrected.urdf") << to_urdf(*settings.chain);
  }
  std::ofstream(folder + "/settings.json") << json.dump(2) << "\n";
  std::ofstream blocks(folder + "/blocks.csv"), windows(folder + "/windows.csv");
  blocks << "log,t";
  for (const char* name : {"tau", "dq", "left"})
    for (int j = 1; j <= Dofs; ++j) blocks << ',' << name << j;
  for (std::size_t k = 0; k < found.checked.blocks.size(); ++k) {
    const LogBlocks& log = found.checked.blocks[k];
    const Eigen::MatrixXd left = unexplained(log, k, found.joints);
    for (Eigen::Index i = 0; i < log.blocks(); ++i) {
      blocks << '\n' << k << ',' << log.end[i];
      for (const Eigen::MatrixXd* m : {&log.tau, &log.velocity, &left})
        for (int j = 0; j < Dofs; ++j) blocks << ',' << (*m)(i, j);
    }
  }
  windows << "window,mass,expected,moment";
  for (const Visibility& v : found.seen)
    windows << '\n' << v.window << ',' << v.mass << ',' << v.expected_mass << ',' << v.moment;
  blocks << '\n';
  windows << '\n';
  if (!blocks.flush() || !windows.flush()) throw LogError(folder + ": cannot be written");
}

template <int Dofs>
int run(Arguments& arguments, const ArmRequest& request) {
  const ArmSettings<Dofs> settings = parse_settings<Dofs>(arguments, request);
  const auto span = arguments.numbers("--span", 2, ':');
  if (span && !((*span)[0] < (*span)[1])) throw ArgumentError("--span: T0 must be below T1");
  const double mass = arguments.number("--mass").value_or(1);
  if (!(mass > 0)) throw ArgumentError("--mass: must be above 0 kg");
  const bool keep_links = arguments.flag("--keep-links");
  const auto folder = arguments.text("--output");
  Inputs inputs{{}, span, parse_format(arguments), joint_names(request)};
  do inputs.files.push_back(arguments.positional("LOG.csv"));
  while (!arguments.empty());
  for (const std::string& note : settings.notes) std::fprintf(stderr, "check_arm: %s\n", note.c_str());
  std::printf("%s, %d joints, rated for %.3g kg\n\n", settings.arm.model.name.c_str(), Dofs,
              settings.config.rated_payload);
  std::string mending;
  if (!judge_logs<Dofs>(inputs, settings, mending)) {
    if (mending.empty())
      std::printf("no option mends this\n");
    else
      std::printf("try: check_arm %s\n", arguments.with(mending + (folder ? "" : " --output checked")).c_str());
    return 1;
  }
  Findings<Dofs> found = check<Dofs>(inputs, settings, mass);
  for (std::size_t k = 0; k < found.checked.logs.size(); ++k)
    for (const std::string& note : found.checked.samples[k].timing.notes())
      std::fprintf(stderr, "check_arm: %s: %s\n", found.checked.logs[k].name.c_str(), note.c_str());
  const bool measured = found.checked.logs.front().tau_ext.empty();
  if (measured && settings.chain && !keep_links) {
    ArmSettings<Dofs> better = settings;
    const bool links = judge_links<Dofs>(found, settings, better);
    // With wrong links the load is wrong, and friction may only seem to grow with it: fit it again.
    if (links) found.joints = find_joints(read<Dofs>(inputs, better).blocks);
    bool friction = false;
    for (int j = 0; j < Dofs; ++j) {
      const double more = found.joints[static_cast<std::size_t>(j)].coulomb_per_load;
      friction = friction || more > 0;
      better.arm.load_friction[j] += more;
    }
    if (links || friction) {
      better.corrected = true;
      std::printf("\nthe same logs, with");
      if (links) {
        std::printf(" these links, rotors of");
        for (int j = 0; j < Dofs; ++j) std::printf("%s %.3g", j > 0 ? "," : "", better.arm.rotor_inertia[j]);
        std::printf(" kg m^2, gear included,\nand");
      }
      std::printf(" friction that takes");
      for (int j = 0; j < Dofs; ++j) std::printf("%s %.3g", j > 0 ? "," : "", better.arm.load_friction[j]);
      std::printf(" of the gravity torque that the arm itself puts on a joint:\n\n");
      found = check<Dofs>(inputs, better, mass);
    }
  }
  if (!folder) {
    std::printf("--output FOLDER writes the settings, and what examples/check_arm/plot.py FOLDER draws\n");
    return 0;
  }
  write<Dofs>(*folder, found);
  std::printf("the settings are in %s/settings.json; python3 examples/check_arm/plot.py %s draws what is beside them\n",
              folder->c_str(), folder->c_str());
  if (found.settings.corrected)
    std::printf(
        "they belong to the links of %s/corrected.urdf, those rotors and that friction, which --config takes with "
        "them; a controller has to use the same\n",
        folder->c_str());
  return 0;
}

int run(Arguments& arguments) {
  const ArmRequest request = parse_arm(arguments);
  return with_joint_count(request.dofs(), [&](auto dofs) { return run<dofs()>(arguments, request); });
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("check_arm", std::string(kUsage) + kArmUsage + kFormatUsage + kSettingsUsage + kOwnUsage, argc,
                     argv, run);
}
