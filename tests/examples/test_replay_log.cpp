#include <algorithm>
#include <nlohmann/json.hpp>
#include <random>
#include <rme/core/payload.hpp>
#include <sstream>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <urdf_arm/urdf_chain.hpp>
#include <vector>

#include "examples/bad_urdfs.hpp"
#include "support/catch.hpp"
#include "support/program.hpp"

// The program itself, as its users run it.

namespace {

using nlohmann::json;
using rme::testing::Result;
using rme::testing::run;
using rme::testing::Stream;
using rme::testing::TemporaryFile;

Result output_of(const std::string& arguments) {
  return run(RME_REPLAY_LOG, arguments, Stream::Output);
}
Result errors_of(const std::string& arguments) {
  return run(RME_REPLAY_LOG, arguments, Stream::Errors);
}

/// The lines of `--json`, each parsed for itself.
std::vector<json> replayed(const std::string& arguments) {
  const Result result = output_of("--json " + arguments);
  REQUIRE(result.exit_code == 0);
  std::vector<json> lines;
  std::istringstream stream(result.text);
  for (std::string line; std::getline(stream, line);) lines.push_back(json::parse(line));
  REQUIRE(!lines.empty());
  return lines;
}

/// The last word on each event, and the summary.
std::vector<json> settled(std::vector<json> lines) {
  lines.erase(std::remove_if(lines.begin(), lines.end(),
                             [](const json& line) { return line.contains("final") && line["final"] == false; }),
              lines.end());
  return lines;
}

std::string log_of(const std::string& name) {
  return "\"" RME_TEST_DATA "/mujoco/" + name + ".csv.gz\"";
}

/// mass and centre of mass, in that order
std::vector<double> theta_of(const json& estimate) {
  std::vector<double> theta = {estimate["mass"]};
  for (const double x : estimate["com"]) theta.push_back(x);
  return theta;
}

TEST_CASE("replay_log: the payload of a MuJoCo recording is found, with and without joint friction", "[replay_log]") {
  // 0.7 kg at (0.06, 0, 0.13) m comes at 1.000 s. Behind the gears 10 g can be told; friction of 0.1 to 0.3 N m carries
  // part of the weight, and at 0.55 m of reach 0.3 N m is 60 g.
  struct Recording {
    const char* name;
    double mass_bound;
  };
  for (const auto& [name, mass_bound] : {Recording{"link_side", 0.010}, Recording{"joint_friction", 0.060}}) {
    CAPTURE(name);
    const auto all = replayed(log_of(name)), lines = settled(all);
    REQUIRE(lines.size() == 2);
    const json& estimate = lines[0];
    CHECK(estimate["kind"] == "attached");
    CHECK(estimate["truth"] == json({0.7, 0.06, 0, 0.13}));
    const std::vector<double> theta = theta_of(estimate), truth = estimate["truth"];
    CHECK(std::abs(theta[0] - 0.7) < mass_bound);
    for (std::size_t i = 0; i < 4; ++i) {
      CAPTURE(i, theta[i], truth[i]);
      CHECK(std::abs(theta[i] - truth[i]) < 4 * estimate["std"][i].get<double>());
    }
    // Noticed after a block of 20 ms or two, over after a tenth of a second of quiet.
    CHECK(estimate["detected_at"].get<double>() > 1.0);
    CHECK(estimate["detected_at"].get<double>() < 1.06);
    CHECK(estimate["window"][0].get<double>() == Approx(1.0).margin(0.021));
    CHECK(estimate["t"].get<double>() < 1.3);
    // Before it comes, the hand is empty; 60 ms after it, nearly the same is believed as in the end.
    REQUIRE(all.size() > 10);
    CHECK(all[0]["final"] == false);
    CHECK(all[0]["kind"] == "none");
    CHECK(all[0]["mass"].get<double>() < 0.01);
    CHECK(all[0]["detected_at"].is_null());
    int early = 0;
    for (const json& line : all) {
      if (line["type"] != "estimate" || line["final"] == true || line["t"] < 1.045 || line["t"] > 1.1) continue;
      ++early;
      CHECK(line["kind"] == "changing");
      CHECK(line["event"] == estimate["event"]);
      CHECK(std::abs(line["mass"].get<double>() - 0.7) < 0.07);
    }
    CHECK(early >= 2);
  }
}

TEST_CASE("replay_log: --json prints one object per line with every field, and a summary last", "[replay_log]") {
  const auto lines = settled(replayed(log_of("link_side")));
  REQUIRE(lines.size() == 2);
  const json& estimate = lines[0];
  CHECK(estimate.at("type") == "estimate");
  CHECK(estimate.at("event") == 0);
  CHECK(estimate.at("final") == true);
  CHECK(estimate.at("kind") == "attached");
  const double t = estimate.at("t"), detected_at = estimate.at("detected_at");
  CHECK(t > detected_at);
  REQUIRE(estimate.at("window").size() == 2);
  CHECK(estimate["window"][1] == t);
  CHECK(estimate.at("mass").is_number());
  CHECK(estimate.at("com").size() == 3);
  CHECK(estimate.at("std").size() == 4);
  REQUIRE(estimate.at("covariance").size() == 4);
  for (std::size_t i = 0; i < 4; ++i) {
    REQUIRE(estimate["covariance"][i].size() == 4);
    const double sd = estimate["std"][i];
    CHECK(sd > 0);
    CHECK(estimate["covariance"][i][i].get<double>() == Approx(sd * sd));
    for (std::size_t j = 0; j < 4; ++j)
      CHECK(estimate["covariance"][i][j].get<double>() ==
            Approx(estimate["covariance"][j][i].get<double>()).margin(1e-12));
  }
  CHECK(estimate.at("elapsed_us").get<double>() > 0);
  CHECK(estimate.at("truth").size() == 4);
  double sum = 0;
  for (const char* name : {"empty", "held", "pouring", "disturbed", "changing"})
    sum += estimate.at("probability").at(name).get<double>();
  CHECK(estimate["probability"].size() == 5);
  CHECK(sum == Approx(1));
  CHECK(estimate.at("log_odds").get<double>() > 5);  // no push
  CHECK(estimate.at("held").get<double>() > 0.99);
  CHECK(estimate.at("health").get<double>() > 0);
  CHECK(estimate.at("confidence").get<double>() > 0.5);
  CHECK(estimate.at("confidence").get<double>() <= 1);
  REQUIRE(estimate.at("inertial").size() == 10);
  CHECK(estimate["inertial"][0].get<double>() == Approx(estimate["mass"].get<double>()).epsilon(1e-3));
  CHECK(lines[1] == json({{"type", "summary"}, {"samples", 1301}, {"estimates", 1}, {"rejected", 0}}));
}

TEST_CASE("replay_log: with --at the change is announced, and the last word comes a window later", "[replay_log]") {
  for (const double window : {0.2, 0.1}) {
    CAPTURE(window);
    const auto lines = settled(
        replayed("--at 1.0 --baseline 0.55:0.95 --window " + std::to_string(window) + " " + log_of("link_side")));
    REQUIRE(lines.size() == 2);
    CHECK(lines[0]["window"][0].get<double>() == Approx(1.0));
    // With the first block that ends at or after T + window.
    CHECK(lines[0]["t"].get<double>() > 1.0 + window - 1e-3);
    CHECK(lines[0]["t"].get<double>() < 1.0 + window + 0.03);
    // The attachment is in the middle of a block, so that for a tenth of a second the torque may also be late.
    const double error = std::abs(lines[0]["mass"].get<double>() - 0.7), deviation = lines[0]["std"][0];
    CHECK(error < 2 * deviation);
    CHECK(deviation < (window > 0.15 ? 0.02 : 0.05));
    CHECK(lines[1]["estimates"] == 1);
  }
}

TEST_CASE("replay_log: settings come from a file, and options go before it", "[replay_log]") {
  const TemporaryFile config("settings.json", R"({"rated_payload": 0.5})");
  // Nothing above what the arm is said to be rated for is believed.
  const auto light = settled(replayed("--config " + config.name + " " + log_of("link_side")));
  for (const json& line : light)
    if (line["type"] == "estimate") CHECK(line["mass"].get<double>() <= 0.5);
  const auto rated = settled(replayed("--config " + config.name + " --rated-payload 5 " + log_of("link_side")));
  REQUIRE(rated.size() == 2);
  CHECK(rated[0]["mass"].get<double>() == Approx(0.7).margin(0.02));
  const TemporaryFile wrong("wrong.json", R"({"rated_paylod": 0.5})");
  const Result refused = errors_of("--config " + wrong.name + " " + log_of("link_side"));
  CHECK(refused.exit_code == 2);
  CHECK_THAT(refused.text, contains(wrong.name) && contains("rated_paylod: unknown field"));
  const Result absent = errors_of("--config absent.json " + log_of("link_side"));
  CHECK(absent.exit_code == 3);
  CHECK_THAT(absent.text, contains("absent.json: cannot be opened"));
}

/// A panda that rests in its ready pose for 1.6 s; from 1 s on something hangs on it. Then the sensors show
/// g(q) - J^T w: what holds the arm, less what the payload adds to gravity's pull.
std::string measured_torque_log(const rme::Payload<double>& payload) {
  const auto& arm = rme::examples::panda();
  const auto at = arm.kinematics(arm.ready);
  const rme::JointVector<double, 7> rest = rme::JointVector<double, 7>::Zero();
  const rme::JointVector<double, 7> empty = arm.dynamics(arm.ready, rest).gravity;
  const rme::JointVector<double, 7> loaded =
      empty - at.jacobian.transpose() * rme::payload_wrench(payload, at.rotation).vector();
  std::ostringstream text;
  text.precision(12);
  text << "t";
  for (const char* name : {"q", "dq", "tau"})
    for (int j = 1; j <= 7; ++j) text << ',' << name << j;
  for (int k = 0; k < 1600; ++k) {
    text << '\n' << 1e-3 * k;
    for (const auto& v : {arm.ready, rest, k < 1000 ? empty : loaded})
      for (int j = 0; j < 7; ++j) text << ',' << v[j];
  }
  return text.str() + '\n';
}

TEST_CASE("replay_log: measured torque goes through the arm's own observer first", "[replay_log]") {
  const TemporaryFile log("measured_torque.csv", measured_torque_log({1.0, {0.05, 0, 0.1}}));
  const auto lines = settled(replayed(log.name));
  REQUIRE(lines.size() == 2);
  CHECK(lines[0]["truth"].is_null());
  // The sign: a payload is a positive mass. Nothing but the prior's pull is in the way of the truth.
  CHECK(lines[0]["mass"].get<double>() == Approx(1.0).margin(0.01));
  CHECK(lines[0]["com"][0].get<double>() == Approx(0.05).margin(0.006));
}

/// A panda that rests in its ready pose for 6 s, with an external torque on joint 1 from 1 s to `end`: a hand that pushes
/// sideways, which no weight does.
std::string pushed_log(double end) {
  const auto& arm = rme::examples::panda();
  std::ostringstream text;
  text.precision(12);
  text << "t";
  for (const char* name : {"q", "tau_ext"})
    for (int j = 1; j <= 7; ++j) text << ',' << name << j;
  for (int k = 0; k < 1500; ++k) {
    const double t = 4e-3 * k;
    text << '\n' << t;
    for (int j = 0; j < 7; ++j) text << ',' << arm.ready[j];
    for (int j = 0; j < 7; ++j) text << ',' << (j == 0 && t >= 1 && t < end ? 8.0 : 0.01 * std::sin(900.0 * k + j));
  }
  return text.str() + '\n';
}

TEST_CASE("replay_log: a push has a row, also if it is not over when the log ends", "[replay_log]") {
  const TemporaryFile over("over.csv", pushed_log(4)), goes_on("goes_on.csv", pushed_log(10));
  const std::string ended = output_of("--bandwidth 0 " + over.name).text,
                    ongoing = output_of("--bandwidth 0 " + goes_on.name).text;
  CHECK_THAT(ended, contains("pushed\n") && !contains("not over"));
  CHECK_THAT(ongoing, contains("pushed, not over at the end of the log, 4.9 s later") || contains("5.0 s later"));
  const auto lines = replayed("--bandwidth 0 " + goes_on.name);
  REQUIRE(lines.size() > 1);
  const json& last = lines[lines.size() - 2];
  CHECK(last["type"] == "ongoing");
  CHECK(last["kind"] == "pushed");
  CHECK(last["detected_at"].get<double>() == Approx(1.03).margin(0.05));
  for (const json& line : replayed("--bandwidth 0 " + over.name)) CHECK(line["type"] != "ongoing");
}

TEST_CASE("replay_log: --compare shows what other methods estimate in the same log", "[replay_log]") {
  const TemporaryFile log("compared.csv", measured_torque_log({1.0, {0.05, 0, 0.1}}));
  const std::string options = "--compare ";
  double last = -1;
  for (const json& line : replayed(options + log.name)) {
    if (line["type"] != "rival" || line["by"] != "recursive least squares") continue;
    CHECK(line["t"].get<double>() > last);
    last = line["t"];
    if (last > 1.55) CHECK(line["mass"].get<double>() > 0.2);  // of 1 kg for a third of the time that it remembers
    if (last < 0.9) CHECK(std::abs(line["mass"].get<double>()) < 0.01);
  }
  CHECK(last > 1.55);
  const std::string table = output_of(options + log.name).text;
  for (const char* by : {"\nrme ", "\nrecursive least squares ", "\nobserver-matched ", "\nbatch least squares "})
    CHECK_THAT(table, contains(by));
  const std::string weights = " --weights \"" RME_NETWORK "\" ";
  CHECK_THAT(output_of(options + weights + log.name).text, contains("\npublished pipeline "));
  CHECK_THAT(output_of(options + log_of("link_side")).text, contains("mean error [kg]"));  // it has the truth
  CHECK(errors_of("--tare " + log.name + " " + log.name).exit_code == 2);
  CHECK_THAT(errors_of(options + "--tare " + log_of("link_side") + " " + log.name).text,
             contains("the hand holds something"));
}

#ifdef RME_HAS_URDFDOM
const std::string six_joints = "--urdf \"" RME_TEST_DATA "/urdf/six_joints_5kg.urdf\" --base base_link --tip tool0 ";

/// How a recording of a six-joint arm, which swings and holds 2 kg at (0.04, -0.03, 0.09) m from 2 s to 5 s, is
/// written.
struct Recording {
  double shortest = 0.01, longest = 0.012;          ///< steps, evenly spread [s]
  std::array<double, 6> gain = {1, 1, 1, 1, 1, 1};  ///< [N m] for what is written
  Eigen::Vector3d gravity = {0, 0, -9.81};
  double gap_from = 9, gap_to = 9;  ///< no rows in between [s]
  bool repeats = false;             ///< each fifth row is there twice, each seventh once more at the next instant
};

std::string recording(const Recording& how) {
  auto arm = rme::examples::arm_model<6>(
      rme::examples::read_urdf(RME_TEST_DATA "/urdf/six_joints_5kg.urdf", "base_link", "tool0"));
  arm.gravity_vector = how.gravity;
  const auto payload = rme::examples::box(2, {0.04, -0.03, 0.09}, {0.1, 0.1, 0.1});
  std::mt19937 random(1);
  std::uniform_real_distribution<double> step(how.shortest, how.longest);
  std::ostringstream text;
  text.precision(12);
  text << "t";
  for (const char* name : {"q", "dq", "tau"})
    for (int j = 1; j <= 6; ++j) text << ',' << name << j;
  std::string row;
  int number = 0;
  for (double t = 0; t < 6; t += step(random), ++number) {
    if (t > how.gap_from && t < how.gap_to) continue;
    if (how.repeats && number % 7 == 3) {  // the sensors were not read
      text << '\n' << t << row;
      continue;
    }
    rme::JointVector<double, 6> q, dq, ddq;
    for (int j = 0; j < 6; ++j) {
      const double w = 1.2 + 0.17 * j, start = j == 1 ? -1.1 : j == 2 ? 1.3 : 0.6;
      q[j] = start + 0.35 * (1 - std::cos(w * t));
      dq[j] = 0.35 * w * std::sin(w * t);
      ddq[j] = 0.35 * w * w * std::cos(w * t);
    }
    const auto terms = arm.dynamics(q, dq, t > 2 && t < 5 ? payload : rme::examples::RigidBody{});
    const rme::JointVector<double, 6> tau = terms.mass_matrix * ddq + terms.coriolis + terms.gravity;
    std::ostringstream cells;
    cells.precision(12);
    for (int j = 0; j < 6; ++j) cells << ',' << q[j];
    for (int j = 0; j < 6; ++j) cells << ',' << dq[j];
    for (int j = 0; j < 6; ++j) cells << ',' << tau[j] / how.gain[static_cast<std::size_t>(j)];
    row = cells.str();
    text << '\n' << t << row;
    if (how.repeats && number % 5 == 0) text << '\n' << t << row;
  }
  return text.str() + '\n';
}

/// What is believed just before 5 s, when the payload goes.
json held_in(const std::string& options, const Recording& how) {
  const TemporaryFile log("six.csv", recording(how));
  json last;
  for (const json& line : replayed(six_joints + options + log.name))
    if (line["type"] == "estimate" && line["t"] < 4.97) last = line;
  return last;
}

TEST_CASE("replay_log: an arm comes from its URDF, and its torque from time stamps, at 50 Hz to 4 kHz",
          "[replay_log]") {
  struct Case {
    const char* what;
    std::string options;
    Recording how;
  };
  Recording currents, wall, reaction, gap, repeats;
  currents.gain = {12, 12, 10, 11, 11, -11};
  wall.gravity = {6, 0, -7};
  reaction.gain = {-1, -1, -1, -1, -1, -1};
  gap.gap_from = 3;
  gap.gap_to = 3.4;
  repeats.repeats = true;
  for (const Case& c : {Case{"10 to 12 ms", "", {}},
                        {"50 Hz", "", {0.02, 0.02}},
                        {"1 kHz, steps twice as long as others", "", {0.0007, 0.0014}},
                        {"4 kHz", "", {0.00025, 0.00025}},
                        {"a gap", "", gap},
                        {"rows twice, and held", "", repeats},
                        {"motor currents", "--gains 12,12,10,11,11,-11 ", currents},
                        {"on a wall", "--gravity 6,0,-7 ", wall},
                        {"reaction", "--torque-sign reaction ", reaction}}) {
    CAPTURE(c.what);
    const json held = held_in("--rated-payload 5 " + c.options, c.how);
    CHECK(held["mass"].get<double>() == Approx(2).epsilon(0.01));
    CHECK(held["com"][0].get<double>() == Approx(0.04).margin(0.003));
    CHECK(held["com"][1].get<double>() == Approx(-0.03).margin(0.003));
    CHECK(held["com"][2].get<double>() == Approx(0.09).margin(0.003));
  }
}

TEST_CASE("replay_log: what is odd about time stamps, and what was assumed, is said once", "[replay_log]") {
  Recording how;
  how.shortest = 0.009;
  how.longest = 0.014;
  how.gap_from = 3;
  how.gap_to = 3.4;
  how.repeats = true;
  const TemporaryFile log("odd.csv", recording(how));
  const Result errors = errors_of(six_joints + log.name);
  CHECK(errors.exit_code == 0);
  for (const char* said :
       {"steps of 9.0", "1 gap, the longest of 0.4", "have the time stamp of the row before",
        "repeat the row before while the arm moves", "rated payload 7.9 kg, from the effort limits"}) {
    CHECK_THAT(errors.text, contains(said));
    CHECK(errors.text.find(said) == errors.text.rfind(said));
  }
  std::size_t notes = 0;
  for (const json& line : replayed(six_joints + log.name)) notes += line["type"] == "note" ? 1 : 0;
  CHECK(notes == 5);
  CHECK(errors_of(log_of("link_side")).text.empty());
}

TEST_CASE("replay_log: a URDF that does not fit is refused, and why", "[replay_log]") {
  const TemporaryFile log("short.csv",
                          "t,q1,q2,q3,q4,q5,q6,tau1,tau2,tau3,tau4,tau5,tau6\n0,0,0,0,0,0,0,0,0,0,0,0,0\n");
  const std::string urdf = "--urdf \"" RME_TEST_DATA "/urdf/six_joints_5kg.urdf\" ";
  struct Case {
    std::string arguments;
    int exit_code;
    const char* reason;
  };
  for (const Case& c :
       {Case{urdf + log.name, 2, "--base: missing"},
        {urdf + "--base base_link " + log.name, 2, "--tip: missing"},
        {"--tip tool0 " + log.name, 2, "--tip: means nothing without --urdf"},
        {six_joints + "--gains 1,2,3 " + log.name, 2, "--gains: \"1,2,3\" is not 6 finite numbers"},
        {six_joints + "--gains 1,2,3,4,5,0 " + log.name, 2, "--gains: must not be zero"},
        {six_joints + "--gravity 0,0,0 " + log.name, 2, "--gravity: must not be zero"},
        {six_joints + "--torque-sign up " + log.name, 2, "--torque-sign: \"up\" is none of external"},
        {six_joints + "--bandwidth -1 " + log.name, 2, "EstimatorConfig::observer_bandwidth"},
        {urdf + "--base base_link --tip flange " + log.name, 3, "has no link flange; there are base_link"},
        {"--urdf absent.urdf --base a --tip b " + log.name, 3, "absent.urdf: cannot be opened"},
        {six_joints + log.name, 3, "columns dq1..dq6 are missing"},
        {six_joints + log_of("link_side"), 3, "columns q1..q6 are missing"}}) {
    CAPTURE(c.arguments);
    const Result errors = errors_of(c.arguments);
    CHECK(errors.exit_code == c.exit_code);
    CHECK_THAT(errors.text, contains("replay_log: ") && contains(c.reason));
  }
  for (const auto& bad : rme::testing::bad_urdfs()) {
    CAPTURE(bad.text, bad.base, bad.tip);
    const TemporaryFile file("bad.urdf", bad.text);
    const Result errors =
        errors_of("--urdf " + file.name + " --base " + bad.base + " --tip " + bad.tip + " " + log.name);
    CHECK(errors.exit_code == 3);
    CHECK_THAT(errors.text, contains("replay_log: ") && contains(file.name + ": ") && contains(bad.reason));
  }
  const TemporaryFile slow("slow.csv", recording({0.11, 0.11}));
  CHECK_THAT(errors_of(six_joints + slow.name).text, contains("at least 10 a second are needed"));
}
#endif

TEST_CASE("replay_log: unusable arguments end with exit code 2, the reason and the usage", "[replay_log]") {
  struct Case {
    std::string arguments;
    const char* reason;
  };
  const std::string log = log_of("link_side");
  for (const Case& c : {Case{"", "LOG.csv"},
                        {"--bogus " + log, "--bogus: unknown option"},
                        {log + " again.csv", "again.csv: one word too many"},
                        {"--at soon " + log, "--at: \"soon\" is not a finite number"},
                        {"--at nan " + log, "--at: \"nan\" is not a finite number"},
                        {"--at", "--at: needs a value"},
                        {"--window 0 " + log, "--window"},
                        {"--window 100 " + log, "--window"},
                        {"--preset best " + log, "--preset: \"best\" is none of"},
                        {"--detector own " + log, "--detector: unknown option"},
                        {"--rated-payload -1 " + log, "EstimatorConfig::rated_payload"},
                        {"--rated-payload much " + log, "--rated-payload: \"much\" is not a finite number"},
                        {"--baseline 2:1 " + log, "--baseline: \"2:1\" is none of"},
                        {"--baseline 0.5 " + log, "--baseline: \"0.5\" is none of"},
                        {"--at 1 --baseline 0.5:1.5 " + log, "--baseline: \"0.5:1.5\" ends after --at"},
                        {"--json --json " + log, "--json: given twice"}}) {
    CAPTURE(c.arguments);
    const Result errors = errors_of(c.arguments);
    CHECK(errors.exit_code == 2);
    CHECK_THAT(errors.text, contains("replay_log: ") && contains(c.reason) && contains("usage: replay_log LOG.csv"));
    CHECK(output_of(c.arguments).text.empty());
  }
}

TEST_CASE("replay_log: an unreadable log ends with exit code 3, file, line and column, and no result", "[replay_log]") {
  const std::string header = "t,q1,q2,q3,q4,q5,q6,q7,tau_ext1,tau_ext2,tau_ext3,tau_ext4,tau_ext5,tau_ext6,tau_ext7\n";
  const std::string zeros = ",0,0,0,0,0,0,0,0,0,0,0,0,0,0\n";
  struct Case {
    std::string content;
    const char* message;
  };
  const std::vector<Case> cases = {
      {"", "bad.csv: is empty"},
      {header, "bad.csv: has a header but no rows"},
      {header + "0" + zeros, "bad.csv: has 1 rows; at least 10 are needed"},
      {"t,q1,q2,q3,q4,q5,q6\n0,0,0,0,0,0,0\n", "bad.csv:1: columns q1..q7 are missing"},
      {"t,q1,q2,q3,q4,q5,q6,q7\n0,0,0,0,0,0,0,0\n", "bad.csv:1: columns tau_ext1..tau_ext7 are missing"},
      {header + "0" + zeros + "0.001,1,2\n", "bad.csv:3: column q3"},
      {header + "0" + zeros + "nan" + zeros, "bad.csv:3: column t: \"nan\""},
      {header + "0" + zeros + "0.001,0,x,0,0,0,0,0,0,0,0,0,0,0,0\n", "bad.csv:3: column q2: \"x\""},
      {header + "0.001" + zeros + "0" + zeros, "bad.csv:3: column t: time does not increase"},
      {header + "0" + zeros + "0.001,0,-inf,0,0,0,0,0,0,0,0,0,0,0,0\n", "bad.csv:3: column q2: \"-inf\""},
      {header + "0,0,0,0,0,0,0,0,0,0,0,0,0,0,0,0\n", "bad.csv:2: column 16: the row has 16 cells, the header 15"},
      {"t,q1,q1,q3,q4,q5,q6,q7\n0,0,0,0,0,0,0,0\n", "bad.csv:1: columns q1..q7 are missing"},
      {"0" + zeros + "0.001" + zeros, "bad.csv:1: column t is missing"},
      {std::string("\x1f\x8b\x08\x00", 4), "bad.csv: the gzip data are"},
  };
  for (const Case& c : cases) {
    CAPTURE(c.message);
    const TemporaryFile file("bad.csv", c.content);
    for (const char* format : {"", "--json "}) {
      const Result errors = errors_of(format + file.name);
      CHECK(errors.exit_code == 3);
      CHECK_THAT(errors.text, contains("replay_log: ") && contains(c.message));
      CHECK(output_of(format + file.name).text.empty());
    }
  }
  const Result missing = errors_of("no_such_log.csv.gz");
  CHECK(missing.exit_code == 3);
  CHECK_THAT(missing.text, contains("no_such_log.csv.gz: cannot be opened"));
}

}  // namespace
