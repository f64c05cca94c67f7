// check_arm: analyses an arm's torque with an empty hand, and promises how well payloads will be estimated.
//
// Reads logs in replay_log's format in which the hand is empty. Says what is wrong with them, and which command mends
// it. Prints noise, offset, friction and what is left, joint by joint; what the estimator finds in the logs with the
// settings that check_arm makes; and the promise: the estimator's errors after 0.2, 1 and 5 s for payloads that are
// simulated onto parts of the logs, with settings from the rest, which shows other poses. If its intervals hold the mass
// too seldom, the settings are widened. With --output it writes the settings (settings.json, for replay_log --config and
// for Estimator) and the data that plot.py draws. If other masses, centres of mass and inertias of the links explain
// measured torque much better than those of the URDF, the settings are for the corrected arm, which is written to
// corrected.urdf. The logs should show the motions that the arm makes at work: each joint in both directions, slowly and
// fast, with stops, and on different paths. Exit codes: 0; 1 something is wrong with a log; 2 unusable arguments;
// 3 unusable log or URDF.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <fstream>
#include <nlohmann/json.hpp>
#include <optional>
#include <rme/estimator_json.hpp>
#include <string>
#include <vector>

#include "check_arm/held_out.hpp"
#include "check_arm/joint_findings.hpp"
#include "check_arm/link_correction.hpp"
#include "check_arm/observer_step.hpp"
#include "check_arm/promise.hpp"
#include "io/program.hpp"
#include "log_diagnosis/recorded_log.hpp"
#include "replay_log/options.hpp"
#include "replay_log/settings_model.hpp"

namespace {

using namespace rme::examples;

constexpr const char* kUsage = "usage: check_arm LOG.csv[.gz]... [options]\n";
constexpr const char* kOwnUsage =
    "  --span T0:T1        use only the logs' rows of [T0, T1) [s]\n"
    "  --keep-links        do not correct the URDF's links\n"
    "  --output FOLDER     write settings.json and the data that plot.py draws there\n";

/// The logs, and how they are read.
struct Inputs {
  std::vector<std::string> files;
  std::optional<std::vector<double>> span;  ///< [s]
  LogFormat format;
  std::vector<std::string> joints;  ///< of the arm
};

template <int Dofs>
std::vector<FormattedLog<Dofs>> read(const Inputs& inputs) {
  std::vector<FormattedLog<Dofs>> out;
  double seconds = 0;
  for (const std::string& file : inputs.files) {
    out.push_back(read_formatted_log<Dofs>(file, inputs.format, inputs.joints));
    Log<Dofs>& log = out.back().log;
    require_external_torque(log);
    if (inputs.span) log = cropped(log, (*inputs.span)[0], (*inputs.span)[1]);
    if (log.size() < 2) throw LogError(log.name + ": has fewer than two rows, which gives no sample rate");
    require_empty_hand(log);
    seconds += log.t.back() - log.t.front();
  }
  if (seconds < 5)
    throw LogError(inputs.files.front() + ": 5 s of an empty hand are needed, the logs hold " +
                   std::to_string(std::lround(1e3 * seconds)) + " ms");
  return out;
}

/// Prints how the logs were read, and what is wrong with them.
/// @param mending  the options that mend the first log with which something is wrong
/// @return whether they can be used
template <int Dofs>
bool judge_logs(const std::vector<FormattedLog<Dofs>>& logs, const LogFormat& format, const ArmSettings<Dofs>& settings,
                std::string& mending) {
  bool usable = true;
  for (const FormattedLog<Dofs>& log : logs) {
    const char* name = log.log.name.c_str();
    for (const std::string& note : log.notes) std::fprintf(stderr, "check_arm: %s: %s\n", name, note.c_str());
    const Diagnosis diagnosis = diagnose(log, settings.arm, settings.config, format, false);
    std::printf("%s: %s\n", name, diagnosis.sentence().c_str());
    for (const std::string& remark : diagnosis.remarks) std::printf("%s: %s\n", name, remark.c_str());
    if (!log.log.tau_ext.empty() && diagnosis.usable())
      std::printf("the sign of tau_ext does not show here: hang a known weight on the arm\n");
    if (usable) mending = diagnosis.options();
    usable = usable && diagnosis.usable();
  }
  std::printf("\n");
  return usable;
}

template <int Dofs>
struct Checked {
  std::vector<Log<Dofs>> logs;
  std::vector<Samples<Dofs>> samples;
  std::vector<LogBlocks> blocks;
};

/// The logs in blocks, as this arm's.
template <int Dofs>
Checked<Dofs> checked(const std::vector<Log<Dofs>>& logs, const ArmSettings<Dofs>& settings) {
  Checked<Dofs> out;
  out.logs = logs;
  for (const Log<Dofs>& log : logs) {
    out.samples.push_back(samples_of(log, settings.arm, settings.config));
    out.blocks.push_back(blocks_of(log, out.samples.back(), settings.arm));
  }
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
  // Friction of a gear that was measured once changes from day to day, as it wears and warms up.
  constexpr double kFrictionStd = 0.3;
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
      arm.friction_std = kFrictionStd;
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
template <int Dofs>
void print_beliefs(const Checked<Dofs>& data, const ArmSettings<Dofs>& settings) {
  std::printf("\nestimates in these logs, these settings     mean mass [kg]  largest, 90%% sure [kg]  empty  health\n");
  for (std::size_t k = 0; k < data.logs.size(); ++k) {
    ReplayOptions<Dofs> options;
    options.arm = settings.arm;
    options.estimator = settings.config;
    double mass = 0, largest = 0, empty = 0, health = 0, time = 0, last = data.logs[k].t.front();
    replay<Dofs>(
        data.logs[k], data.samples[k], options,
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
                data.logs[k].name.substr(data.logs[k].name.rfind('/') + 1).c_str(), mass / time, largest,
                100 * empty / time, health / time);
  }
}

/// The results from the logs with one model of the arm.
template <int Dofs>
struct Findings {
  Checked<Dofs> data;
  std::vector<JointFindings> joints;
  ArmSettings<Dofs> settings;  ///< the settings that result
};

template <int Dofs>
Findings<Dofs> find(const std::vector<Log<Dofs>>& logs, const ArmSettings<Dofs>& settings) {
  Findings<Dofs> out{checked(logs, settings), {}, settings};
  out.joints = find_joints(out.data.blocks);
  out.settings.config = settings_of<Dofs>(out.joints, settings);
  out.settings.config.validate(0.001);
  return out;
}

/// Analyses the logs and prints the results.
template <int Dofs>
Findings<Dofs> check(const std::vector<Log<Dofs>>& logs, const ArmSettings<Dofs>& settings) {
  Findings<Dofs> out = find(logs, settings);
  print(out.joints);
  if (!logs.front().tau_ext.empty()) {
    double fastest = 0;
    for (const Log<Dofs>& log : logs) fastest = std::max(fastest, fastest_step(log.t, log.tau_ext, log.dq));
    if (fastest > 0)
      std::printf("a step in tau_ext takes 1/%.0f s: the observer's bandwidth is at least %.0f rad/s; set: %g rad/s\n",
                  fastest, fastest, settings.config.observer_bandwidth);
    else
      std::printf("no step in tau_ext while the arm rests, so the observer's bandwidth does not show; set: %g rad/s\n",
                  settings.config.observer_bandwidth);
  }
  return out;
}

/// Fits links and rotors to the logs.
template <int Dofs>
LinkCorrection fit_links(const Findings<Dofs>& found) {
  std::vector<LinkRegressors> regressors;
  for (std::size_t k = 0; k < found.data.logs.size(); ++k)
    regressors.push_back(link_regressors(found.data.logs[k], found.data.samples[k], found.settings.arm));
  std::vector<RigidBody> bodies;
  for (const Link& link : found.settings.chain->links) bodies.push_back(link.body);
  return correct_links(found.data.blocks, regressors, found.joints, bodies);
}

/// The arm with other links and rotors.
template <int Dofs>
ArmSettings<Dofs> with_links(ArmSettings<Dofs> settings, const LinkCorrection& correction) {
  const Eigen::Vector3d gravity = settings.arm.model.gravity_vector;
  for (std::size_t l = 0; l < settings.chain->links.size(); ++l)
    settings.chain->links[l].body = corrected(settings.chain->links[l].body, correction.addition[l]);
  for (int j = 0; j < Dofs; ++j) settings.arm.rotor_inertia[j] += correction.rotor[static_cast<std::size_t>(j)];
  settings.arm.model = arm_model<Dofs>(*settings.chain);
  settings.arm.model.gravity_vector = gravity;
  settings.corrected = true;
  return settings;
}

/// The arm with friction that grows with its own weight, as the joints show it.
template <int Dofs>
ArmSettings<Dofs> with_load_friction(ArmSettings<Dofs> settings, const std::vector<JointFindings>& joints) {
  for (int j = 0; j < Dofs; ++j) {
    const double more = joints[static_cast<std::size_t>(j)].coulomb_per_load;
    settings.arm.load_friction[j] += more;
    settings.corrected = settings.corrected || more > 0;
  }
  return settings;
}

/// Tests whether other links and rotors explain the logs much better, and prints the result.
/// @return whether they do
template <int Dofs>
bool judge_links(const Findings<Dofs>& found, const LinkCorrection& correction) {
  constexpr double kWorthwhile = 2.0 / 3;  // of what is left
  std::printf(
      "\nother masses, centres and inertias of the links and rotors would leave %.0f %% of what is left, out of sample",
      100 * correction.left);
  if (correction.left > kWorthwhile) {
    std::printf(": no correction\n");
    return false;
  }
  std::printf(":\nlink                      mass [kg]: URDF, corrected    centre [m]: URDF, corrected\n");
  const UrdfChain& chain = *found.settings.chain;
  for (std::size_t l = 0; l < chain.links.size(); ++l) {
    const RigidBody &was = chain.links[l].body, body = corrected(was, correction.addition[l]);
    std::printf("%-30.30s %9.3f %9.3f   %7.3f %7.3f %7.3f %7.3f %7.3f %7.3f\n", chain.joints[l].name.c_str(), was.mass,
                body.mass, was.com[0], was.com[1], was.com[2], body.com[0], body.com[1], body.com[2]);
  }
  return true;
}

/// What was decided from all logs: what is corrected in the arm, and its kind of torque sensing.
struct Decisions {
  bool links = false, friction = false;
  std::optional<rme::Sensing> sensing;
};

/// The settings that the logs give, with these decisions.
template <int Dofs>
ArmSettings<Dofs> settings_from(const std::vector<Log<Dofs>>& logs, const ArmSettings<Dofs>& given,
                                const Decisions& decisions) {
  Findings<Dofs> found = find(logs, given);
  ArmSettings<Dofs> arm = given;
  if (decisions.links) {
    arm = with_links(arm, fit_links(found));
    found = find(logs, arm);
  }
  if (decisions.friction) found = find(logs, with_load_friction(arm, found.joints));
  found.settings.config.sensing = decisions.sensing;
  return found.settings;
}

constexpr double kLeastCoverage = 0.8;  // of the 90 % intervals; below that, settings are widened

/// The promise and what it is made from.
struct Promised {
  HeldOutTest test;
  Promise promise;
  double widening = 1;  ///< factor on the settings' noise, offset and residual
};

/// Tests settings from each rest of the logs on the part that was left out, and widens them until the intervals hold the
/// mass often enough.
/// @param parts  at least one
template <int Dofs>
Promised rehearse(const std::vector<Log<Dofs>>& logs, const std::vector<HeldOut>& parts, const ArmSettings<Dofs>& given,
                  const Decisions& decisions) {
  constexpr double kStep = 1.5, kWidest = 8;
  constexpr int kInstants = 16;  // over all parts' spans
  std::vector<ArmSettings<Dofs>> settings;
  std::size_t spans = 0;
  for (const HeldOut& part : parts) {
    std::vector<Log<Dofs>> rest;
    for (const LogSpan& span : part.rest) rest.push_back(cropped(logs[span.log], span.begin, span.end));
    settings.push_back(settings_from(rest, given, decisions));
    spans += part.part.size();
  }
  Promised best;
  for (double factor = 1; factor < kWidest; factor *= kStep) {
    Promised out;
    out.widening = factor;
    std::mt19937_64 random(1);
    for (std::size_t k = 0; k < parts.size(); ++k) {
      ArmSettings<Dofs> wider = settings[k];
      wider.config = widened(wider.config, factor);
      for (const LogSpan& span : parts[k].part) {
        const Log<Dofs>& log = logs[span.log];
        rehearse(log, samples_of(log, wider.arm, wider.config), wider, span.begin, span.end,
                 std::max(3, kInstants / static_cast<int>(spans)), random, out.test);
      }
    }
    out.promise = promise_of(out.test, given.config.rated_payload);
    if (factor == 1 || out.promise.coverage > best.promise.coverage) best = out;
    if (best.promise.coverage >= kLeastCoverage) break;
  }
  return best;
}

/// @param recordings  number of logs
void print(const Promised& promised, std::size_t recordings) {
  const Promise& promise = promised.promise;
  std::printf(
      "\nthe promise: what the estimator finds of payloads that are simulated onto %.0f s of these logs, with "
      "settings\n"
      "from the rest, in which the arm is on another path\n"
      "after [s]   arm         answers   error of mass [kg]   19 of 20 below   90 %% intervals hold   centre of mass "
      "[mm]\n",
      promised.test.seconds);
  for (const PromiseRow& row : promise.rows)
    std::printf("%9.1f   %-9s %9d %20.3f %16.3f %19.0f %% %21.0f\n", kAfter[row.after], row.moving ? "moves" : "rests",
                row.answers, row.error, row.worst, 100 * row.coverage, 1e3 * row.centre);
  const auto tried = [&promise](std::size_t after) {  // so long after an attachment a short log may be over
    return std::any_of(promise.rows.begin(), promise.rows.end(),
                       [after](const auto& row) { return row.after == after; });
  };
  std::printf("lightest payload that is found in 95 %%:");
  for (std::size_t after = 0; after < kAfter.size(); ++after) {
    const double mass = promise.lightest[after];
    if (std::isfinite(mass))
      std::printf("%s %.3g kg within %g s", after > 0 ? "," : "", mass, kAfter[after]);
    else
      std::printf(tried(after) ? "%s none within %g s" : "%s not tried for %g s", after > 0 ? "," : "", kAfter[after]);
  }
  const double hours = promised.test.seconds / 3600;
  std::printf("\nfalse payloads: %d in %.0f s, %.0f an hour", promised.test.false_payloads, promised.test.seconds,
              promised.test.false_payloads / hours);
  if (promised.test.false_payloads == 0) std::printf(" (so short a log shows no fewer than %.0f)", 3 / hours);
  if (promised.test.largest_mass > 0)
    std::printf("; an empty hand was taken to hold up to %.3f kg: trust no lighter payload",
                promised.test.largest_mass);
  std::printf("\n");
  if (recordings == 1)
    std::printf("one recording shows nothing of what differs on another day: the promise of several is safer\n");
  if (promised.widening > 1)
    std::printf(
        "noise, offset and residual in the settings are %.2g times what the logs show, since intervals held too "
        "seldom\n",
        promised.widening);
  if (promise.coverage < kLeastCoverage)
    std::printf("no such widening makes the intervals hold in %.0f %%: do not trust them on this arm\n",
                100 * kLeastCoverage);
}

template <int Dofs>
void write(const std::string& folder, const Findings<Dofs>& found, const Promised* promised) {
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
  std::ofstream blocks(folder + "/blocks.csv"), trials(folder + "/trials.csv");
  blocks << "log,t";
  for (const char* name : {"tau", "dq", "left"})
    for (int j = 1; j <= Dofs; ++j) blocks << ',' << name << j;
  for (std::size_t k = 0; k < found.data.blocks.size(); ++k) {
    const LogBlocks& log = found.data.blocks[k];
    const Eigen::MatrixXd left = unexplained(log, k, found.joints);
    for (Eigen::Index i = 0; i < log.blocks(); ++i) {
      blocks << '\n' << k << ',' << log.end[i];
      for (const Eigen::MatrixXd* m : {&log.tau, &log.velocity, &left})
        for (int j = 0; j < Dofs; ++j) blocks << ',' << (*m)(i, j);
    }
  }
  trials << "t,mass,weighed,after,moving,found,error,deviation,centre";
  if (promised)
    for (const Trial& trial : promised->test.trials)
      for (const TrialAnswer& answer : trial.answers)
        trials << '\n'
               << trial.t << ',' << trial.mass << ',' << (trial.share >= kWeighed) << ',' << kAfter[answer.after] << ','
               << answer.moving << ',' << answer.found << ',' << answer.error << ',' << answer.deviation << ','
               << answer.centre;
  blocks << '\n';
  trials << '\n';
  if (!blocks.flush() || !trials.flush()) throw LogError(folder + ": cannot be written");
}

template <int Dofs>
int run(Arguments& arguments, const ArmRequest& request) {
  const ArmSettings<Dofs> settings = parse_settings<Dofs>(arguments, request);
  const auto span = arguments.numbers("--span", 2, ':');
  if (span && !((*span)[0] < (*span)[1])) throw ArgumentError("--span: T0 must be below T1");
  const bool keep_links = arguments.flag("--keep-links");
  const auto folder = arguments.text("--output");
  Inputs inputs{{}, span, parse_format(arguments), joint_names(request)};
  do inputs.files.push_back(arguments.positional("LOG.csv"));
  while (!arguments.empty());
  for (const std::string& note : settings.notes) std::fprintf(stderr, "check_arm: %s\n", note.c_str());
  std::printf("%s, %d joints, rated for %.3g kg\n\n", settings.arm.model.name.c_str(), Dofs,
              settings.config.rated_payload);
  const std::vector<FormattedLog<Dofs>> formatted = read<Dofs>(inputs);
  std::string mending;
  if (!judge_logs(formatted, inputs.format, settings, mending)) {
    if (mending.empty())
      std::printf("no option mends this\n");
    else
      std::printf("try: check_arm %s\n", arguments.with(mending + (folder ? "" : " --output checked")).c_str());
    return 1;
  }
  std::vector<Log<Dofs>> logs;
  logs.reserve(formatted.size());
  for (const FormattedLog<Dofs>& log : formatted) logs.push_back(log.log);
  Findings<Dofs> found = check<Dofs>(logs, settings);
  for (std::size_t k = 0; k < logs.size(); ++k)
    for (const std::string& note : found.data.samples[k].timing.notes())
      std::fprintf(stderr, "check_arm: %s: %s\n", logs[k].name.c_str(), note.c_str());
  Decisions decisions;
  if (logs.front().tau_ext.empty() && settings.chain && !keep_links) {
    ArmSettings<Dofs> better = settings;
    const LinkCorrection correction = fit_links(found);
    decisions.links = judge_links(found, correction);
    // With wrong links the load is wrong, and friction may only seem to grow with it: fit it again.
    if (decisions.links) {
      better = with_links(better, correction);
      found.joints = find(logs, better).joints;
    }
    better = with_load_friction(better, found.joints);
    decisions.friction = std::any_of(found.joints.begin(), found.joints.end(),
                                     [](const JointFindings& joint) { return joint.coulomb_per_load > 0; });
    if (decisions.links || decisions.friction) {
      std::printf("\nthe same logs, with");
      if (decisions.links) {
        std::printf(" these links, rotors of");
        for (int j = 0; j < Dofs; ++j) std::printf("%s %.3g", j > 0 ? "," : "", better.arm.rotor_inertia[j]);
        std::printf(" kg m^2, gear included,\nand");
      }
      std::printf(" friction that takes");
      for (int j = 0; j < Dofs; ++j) std::printf("%s %.3g", j > 0 ? "," : "", better.arm.load_friction[j]);
      std::printf(" of the gravity torque that the arm itself puts on a joint:\n\n");
      found = check<Dofs>(logs, better);
    }
  }
  std::vector<LogPath> paths;
  paths.reserve(logs.size());
  for (const Log<Dofs>& log : logs) paths.push_back(path_of(log));
  const std::vector<HeldOut> parts = held_out_parts(paths);
  std::optional<Promised> promised;
  if (parts.empty()) {
    std::printf("\nno promise: these logs show one path only. Record another one, or a longer log with other poses\n");
  } else {
    decisions.sensing = found.settings.config.sensing;
    promised = rehearse(logs, parts, settings, decisions);
    print(*promised, logs.size());
    found.settings.config = widened(found.settings.config, promised->widening);
  }
  print_beliefs<Dofs>(found.data, found.settings);
  if (!folder) {
    std::printf("--output FOLDER writes the settings, and what examples/check_arm/plot.py FOLDER draws\n");
    return 0;
  }
  write<Dofs>(*folder, found, promised ? &*promised : nullptr);
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
