#include <cmath>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <rme/event_estimator_json.hpp>
#include <sstream>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "support/catch.hpp"
#include "support/program.hpp"

// The program itself, as its users run it.

namespace {

using nlohmann::json;
using rme::examples::panda;
using rme::examples::SyntheticArm;
using rme::examples::SyntheticArmConfig;
using rme::examples::TorqueSensing;
using rme::testing::Result;
using rme::testing::run;
using rme::testing::Stream;
using rme::testing::TemporaryFile;
using Torque = rme::JointVector<double, 7>;
using Sensor = rme::SensorModel<double, 7>;

constexpr double kPeriod = 1e-3;

Result errors_of(const std::string& arguments) {
  return run(RME_IDENTIFY_NOISE, arguments, Stream::Errors);
}

/// The settings that the program writes.
json identified(const std::string& arguments) {
  const TemporaryFile settings("identified.json", "");
  const Result result = run(RME_IDENTIFY_NOISE, arguments + " --output " + settings.name, Stream::Output);
  REQUIRE(result.exit_code == 0);
  INFO(result.text);
  json out;
  std::ifstream(settings.name) >> out;
  return out;
}
Sensor sensor_of(const json& settings) {
  return rme::event_estimator_config_from_json<double, 7>(settings).sensors.front();
}

/// CSV text with the columns t, q, dq and tau_ext.
class LogText {
 public:
  LogText() {
    text_.precision(10);
    text_ << "t";
    for (const char* name : {"q", "dq", "tau_ext"})
      for (int j = 1; j <= 7; ++j) text_ << ',' << name << j;
  }
  void add(double t, const Torque& q, const Torque& dq, const Torque& tau_ext) {
    text_ << '\n' << t;
    for (const auto& v : {q, dq, tau_ext})
      for (int j = 0; j < 7; ++j) text_ << ',' << v[j];
  }
  std::string str() const { return text_.str() + '\n'; }

 private:
  std::ostringstream text_;
};

/// 20 s of an arm whose joints swing about the ready pose, each at a frequency of its own, up to 0.8 to 1.5 rad/s.
std::string swinging(const SyntheticArmConfig<7>& faults) {
  SyntheticArm<7> arm(panda(), faults, panda().ready);
  LogText log;
  for (double t = 0; t < 20; t += kPeriod) {
    Torque target = panda().ready, velocity;
    for (int j = 0; j < 7; ++j) {
      const double omega = 2 + 0.3 * j;
      target[j] += 0.4 * std::sin(omega * t);
      velocity[j] = 0.4 * omega * std::cos(omega * t);
    }
    const auto& dynamics = arm.dynamics();
    arm.step(dynamics.gravity + dynamics.coriolis +
             dynamics.mass_matrix * (400 * (target - arm.q()) + 40 * (velocity - arm.dq())));
    log.add(arm.time(), arm.q(), arm.dq(), arm.tau_ext());
  }
  return log.str();
}

/// A resting arm whose torque is an unfiltered autoregressive noise.
std::string resting(double deviation, double correlation_time, double duration) {
  std::mt19937_64 random(1);
  std::normal_distribution<double> normal(0, deviation);
  const double kept = correlation_time > 0 ? std::exp(-kPeriod / correlation_time) : 0;
  LogText log;
  Torque tau = Torque::Zero();
  for (double t = 0; t < duration; t += kPeriod) {
    for (int j = 0; j < 7; ++j) tau[j] = kept * tau[j] + std::sqrt(1 - kept * kept) * normal(random);
    log.add(t, panda().ready, Torque::Zero(), tau);
  }
  return log.str();
}

TEST_CASE("identify_noise: the faults of a synthetic arm come back from its logs", "[identify_noise]") {
  for (const auto sensing : {TorqueSensing::MotorSide, TorqueSensing::LinkSide}) {
    const bool friction_shows = sensing == TorqueSensing::MotorSide;
    CAPTURE(friction_shows);
    SyntheticArmConfig<7> first = rme::examples::with_typical_faults(panda(), 1), second = first;
    first.sensing = second.sensing = sensing;
    second.torque_offset = -2 * first.torque_offset;
    second.seed = 2;
    const TemporaryFile one("one.csv", swinging(first)), two("two.csv", swinging(second));
    const json settings = identified(one.name + " " + two.name);
    const Sensor found = sensor_of(settings);
    for (int j = 0; j < 7; ++j) {
      CAPTURE(j);
      // The sensors' white noise, as SensorModel::noise counts it. While a joint turns round it sticks, and its
      // friction is anything between the two signs: that is noise to the model.
      const double white = first.torque_noise[j] * std::sqrt(kPeriod / (2 * found.noise_correlation_time));
      CHECK(found.noise[j] > 0.8 * white);
      CHECK(found.noise[j] < (friction_shows ? 6 : 1.25) * white);
      CHECK(found.coulomb_mean[j] == Approx(friction_shows ? first.friction.coulomb[j] : 0).margin(0.015));
      CHECK(found.viscous_mean[j] == Approx(friction_shows ? first.friction.viscous[j] : 0).margin(0.025));
      CHECK(found.coulomb_std[j] < 0.02);
      CHECK(found.viscous_std[j] < 0.03);
      CHECK(found.stiction[j] < 0.02);
      // Root mean square of the logs' offsets and the preset's.
      const double offset = first.torque_offset[j], preset = Sensor::joint_friction().offset[j];
      CHECK(found.offset[j] == Approx(std::sqrt((5 * offset * offset + preset * preset) / 3)).margin(0.01));
    }
    if (friction_shows) continue;
    CHECK(found.noise_correlation_time == 0.02);
    // Nothing in these logs crosses the thresholds as they are.
    const rme::EventEstimatorConfig<double, 7> defaults;
    CHECK(settings["onset_jump"] == defaults.onset_jump);
    CHECK(settings["detector"]["edge_average"] == defaults.detector.edge_average);
  }
}

TEST_CASE("identify_noise: where the arm never moved, the preset's friction is kept", "[identify_noise]") {
  const TemporaryFile unfiltered("unfiltered.json", R"({"window": {"observer_bandwidth": 0}})");
  const TemporaryFile log("rest.csv", resting(0.05, 0, 6));
  for (const auto& [name, preset] :
       {std::pair("link_side", Sensor::link_side()), {"joint_friction", Sensor::joint_friction()}}) {
    CAPTURE(name);
    const Sensor found =
        sensor_of(identified(log.name + " --config " + unfiltered.name + " --preset " + std::string(name)));
    CHECK(found.coulomb_mean == preset.coulomb_mean);
    CHECK(found.coulomb_std == preset.coulomb_std);
    CHECK(found.viscous_mean == preset.viscous_mean);
    CHECK(found.viscous_std == preset.viscous_std);
    for (int j = 0; j < 7; ++j) CHECK(found.stiction[j] >= preset.stiction[j]);
  }
}

TEST_CASE("identify_noise: noise that stays for longer gets a longer correlation time", "[identify_noise]") {
  const TemporaryFile unfiltered("unfiltered.json", R"({"window": {"observer_bandwidth": 0}})");
  const TemporaryFile white("white.csv", resting(0.05, 0, 30)), slow("slow.csv", resting(0.05, 0.04, 30));
  const std::string options = " --config " + unfiltered.name;
  CHECK(sensor_of(identified(white.name + options)).noise_correlation_time == 0.02);
  CHECK(sensor_of(identified(slow.name + options)).noise_correlation_time >= 0.05);
}

TEST_CASE("identify_noise: thresholds rise over what a log shows while nothing happens", "[identify_noise]") {
  const TemporaryFile unfiltered("unfiltered.json", R"({"window": {"observer_bandwidth": 0}})");
  const TemporaryFile log("restless.csv", resting(1, 0.02, 6));
  const json settings = identified(log.name + " --config " + unfiltered.name);
  const rme::EventEstimatorConfig<double, 7> defaults;
  CHECK(settings["onset_jump"] > defaults.onset_jump);
  CHECK(settings["unrest"] > defaults.unrest);
  CHECK(settings["detector"]["activation_threshold"] > defaults.detector.activation_threshold);
  CHECK(settings["detector"]["edge_average"] > defaults.detector.edge_average);
}

TEST_CASE("identify_noise: replay_log reads the settings that are written, and finds the same payload",
          "[identify_noise]") {
  SyntheticArmConfig<7> faults = rme::examples::with_typical_faults(panda(), 3);
  faults.sensing = TorqueSensing::LinkSide;
  const TemporaryFile log("swinging.csv", swinging(faults)), settings("settings.json", "");
  REQUIRE(run(RME_IDENTIFY_NOISE, log.name + " --output " + settings.name, Stream::Output).exit_code == 0);
  json written;
  std::ifstream(settings.name) >> written;
  CHECK(rme::event_estimator_config_to_json(rme::event_estimator_config_from_json<double, 7>(written)) == written);
  const Result replayed =
      run(RME_REPLAY_EVENTS, "--json --config " + settings.name + " \"" RME_TEST_DATA "/mujoco/link_side.csv.gz\"",
          Stream::Output);
  REQUIRE(replayed.exit_code == 0);
  std::istringstream lines(replayed.text);
  std::string first;
  std::getline(lines, first);
  CHECK(json::parse(first)["mass"].get<double>() == Approx(0.7).margin(0.02));
}

TEST_CASE("identify_noise: unusable arguments end with exit code 2, the reason and the usage", "[identify_noise]") {
  struct Case {
    std::string arguments;
    const char* reason;
  };
  const TemporaryFile settings("bad.json", R"({"colection": 0.2})");
  for (const Case& c : {Case{"", "LOG.csv: missing"},
                        {"--bogus log.csv", "--bogus: unknown option"},
                        {"log.csv --preset best", "--preset: \"best\" is none of"},
                        {"log.csv --span 1", "--span: \"1\" is not 2 finite numbers"},
                        {"log.csv --span 2:1", "--span: T0 must be below T1"},
                        {"log.csv --output", "--output: needs a value"},
                        {"log.csv --config " + settings.name, "bad.json: colection: unknown field"}}) {
    CAPTURE(c.arguments);
    const Result errors = errors_of(c.arguments);
    CHECK(errors.exit_code == 2);
    CHECK_THAT(errors.text, contains("identify_noise: ") && contains(c.reason) && contains("usage: identify_noise"));
  }
}

TEST_CASE("identify_noise: an unusable log ends with exit code 3 and the reason", "[identify_noise]") {
  const std::string header = "t,q1,q2,q3,q4,q5,q6,q7,tau_ext1,tau_ext2,tau_ext3,tau_ext4,tau_ext5,tau_ext6,tau_ext7\n";
  const std::string zeros = ",0,0,0,0,0,0,0,0,0,0,0,0,0,0\n";
  const std::string one_row = header + "0" + zeros;
  const std::string bad_cell = one_row + "0.001,0,x,0,0,0,0,0,0,0,0,0,0,0,0\n";
  const std::string slow = one_row + "0.1" + zeros;
  struct Case {
    std::string content;
    const char* message;
  };
  for (const Case& c :
       {Case{bad_cell, "bad.csv:3: column q2: \"x\""},
        {one_row, "bad.csv: has fewer than two rows"},
        {"t,q1,q2,q3,q4,q5,q6,q7\n0,0,0,0,0,0,0,0\n", "bad.csv:1: columns tau_ext1..tau_ext7 are missing"},
        {slow, "EventEstimatorConfig::onset_span"},
        {resting(0.05, 0, 2), "bad.csv: 10 windows of 0.5 s are needed, the log holds 3"}}) {
    CAPTURE(c.message);
    const TemporaryFile file("bad.csv", c.content);
    const Result errors = errors_of(file.name);
    CHECK(errors.exit_code == 3);
    CHECK_THAT(errors.text, contains("identify_noise: ") && contains(c.message));
  }
  const Result loaded = errors_of("\"" RME_TEST_DATA "/mujoco/link_side.csv.gz\"");
  CHECK(loaded.exit_code == 3);
  CHECK_THAT(loaded.text, contains("column m: the hand holds something from t = 1.0"));
  const Result missing = errors_of("no_such_log.csv");
  CHECK(missing.exit_code == 3);
  CHECK_THAT(missing.text, contains("no_such_log.csv: cannot be opened"));
}

}  // namespace
