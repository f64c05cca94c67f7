#include <check_arm/observer_step.hpp>
#include <filesystem>
#include <fstream>
#include <nlohmann/json.hpp>
#include <random>
#include <sstream>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <vector>

#include "support/catch.hpp"
#include "support/program.hpp"

// The program itself, as its users run it.

namespace {

using nlohmann::json;
using rme::testing::Result;
using rme::testing::run;
using rme::testing::Stream;
using rme::testing::TemporaryFile;
using Vector = rme::JointVector<double, 7>;

/// How an arm with an empty hand shows itself.
struct Shown {
  double coulomb = 0.4, viscous = 0.2, offset = 0.1, noise = 0.02;  // [N m], [N m s/rad]
  double per_load = 0;                                              // Coulomb friction for each N m of gravity torque
  double factor = 1;                                                // of the torque that is written
  double seconds = 12;
  double repeats = 0;               // period after which the path is the same again [s]; 0: never
  std::string columns = "tau_ext";  // or tau
};

/// A Panda that moves all joints to and fro at 250 Hz.
std::string recording(const Shown& shown) {
  const unsigned seed = 7;
  std::mt19937 random(seed);
  std::normal_distribution<double> normal(0, shown.noise);
  const auto& arm = rme::examples::panda();
  std::ostringstream text;
  text.precision(10);
  text << "t";
  for (const std::string& name : {std::string("q"), std::string("dq"), shown.columns})
    for (int j = 1; j <= 7; ++j) text << ',' << name << j;
  for (double t = 0; t < shown.seconds; t += 0.004) {
    Vector q = arm.ready, dq, ddq, tau, coulomb;
    for (int j = 0; j < 7; ++j) {
      const double turn = 2 * 3.141592653589793 * (j % 2 + 1);
      const double w = shown.repeats > 0 ? turn / shown.repeats : 1.1 + 0.23 * j;
      q[j] += 0.4 * std::sin(w * t);
      dq[j] = 0.4 * w * std::cos(w * t);
      ddq[j] = -0.4 * w * w * std::sin(w * t);
    }
    const auto terms = arm.dynamics(q, dq);
    coulomb = Vector::Constant(shown.coulomb) + shown.per_load * terms.gravity.cwiseAbs();
    for (int j = 0; j < 7; ++j)
      tau[j] = -(coulomb[j] * (dq[j] > 0 ? 1 : -1) + shown.viscous * dq[j]) + shown.offset + normal(random);
    if (shown.columns == "tau") {  // what is measured: all that moves the arm, less what comes from outside
      tau = terms.mass_matrix * ddq + terms.coriolis + terms.gravity - tau + rme::examples::panda_friction(dq);
    }
    text << '\n' << t;
    for (const Vector& v : {q, dq, Vector(shown.factor * tau)})
      for (int j = 0; j < 7; ++j) text << ',' << v[j];
  }
  return text.str() + '\n';
}

Result check(const std::string& arguments, Stream kept = Stream::Output) {
  return run(RME_CHECK_ARM, arguments, kept);
}

/// The settings that are written.
/// @param text  what is printed, if it is not null
json settings_of(const std::string& arguments, std::string* text = nullptr) {
  const TemporaryFile folder("checked", "");
  std::filesystem::remove(folder.name);
  const Result result = check(arguments + " --output " + folder.name);
  REQUIRE(result.exit_code == 0);
  if (text) *text = result.text;
  json settings;
  std::ifstream(folder.name + "/settings.json") >> settings;
  CHECK(std::filesystem::file_size(folder.name + "/blocks.csv") > 10000);
  CHECK(std::filesystem::file_size(folder.name + "/trials.csv") > 1000);
  std::filesystem::remove_all(folder.name);
  return settings;
}

TEST_CASE("check_arm: noise, offset and friction of a moving arm are found and written as settings", "[check_arm]") {
  for (const char* columns : {"tau_ext", "tau"}) {
    CAPTURE(columns);
    Shown shown;
    shown.columns = columns;
    const TemporaryFile log("shown.csv", recording(shown));
    const json settings = settings_of("--bandwidth 0 " + log.name);
    CHECK(settings["sensing"] == "joint_friction");
    CHECK(settings["rated_payload"] == 3);
    for (std::size_t j = 0; j < 7; ++j) {
      CAPTURE(j);
      const json& arm = settings["arm"];
      CHECK(arm["coulomb"][j].get<double>() == Approx(0.4).epsilon(0.1));
      CHECK(arm["viscous"][j].get<double>() == Approx(0.2).epsilon(0.2));
      CHECK(arm["friction_std"] == 0.3);
      // With one log, half of the variance is the usual arm's, 0.15 or 0.06 N m.
      const double usual = j < 4 ? 0.15 : 0.06;
      CHECK(arm["offset"][j].get<double>() == Approx(std::sqrt((0.01 + usual * usual) / 2)).epsilon(0.1));
      // Five samples of 0.02 N m in a block; differences of a block with others leave room for its turns.
      CHECK(arm["noise"][j].get<double>() > 0.02 / std::sqrt(5) * 0.8);
      CHECK(arm["noise"][j].get<double>() < 0.06);
    }
  }
}

/// The promise for a moving arm a second after the attachment.
struct Said {
  double answers = 0, error = 0, worst = 0, coverage = 0;
  std::string text;
};

Said promise_of(const std::string& arguments) {
  Said said;
  said.text = check(arguments).text;
  CAPTURE(said.text);
  const std::string row = "      1.0   moves ";
  const std::size_t at = said.text.find(row);
  REQUIRE(at != std::string::npos);
  std::istringstream words(said.text.substr(at + row.size()));
  words >> said.answers >> said.error >> said.worst >> said.coverage;
  REQUIRE(words);
  return said;
}

TEST_CASE("check_arm: more noise, a larger error is promised", "[check_arm]") {
  const auto promised = [](double noise) {
    Shown shown;
    shown.noise = noise;
    const TemporaryFile log("noise.csv", recording(shown));
    return promise_of("--preset joint_friction --bandwidth 0 " + log.name);
  };
  const Said quiet = promised(0.02), noisy = promised(1);
  CHECK(noisy.error > 3 * quiet.error);
  for (const Said& said : {quiet, noisy}) {
    CHECK(said.error < said.worst);
    CHECK(said.coverage >= 80);
  }
  // Means over 5 samples of 0.02 N m, a lever of half a metre: a gram or two; friction is known to 0.05 N m or 10 g.
  CHECK(quiet.error < 0.03);
  CHECK_THAT(quiet.text, contains("false payloads: 0 in 12 s") && contains("lightest payload that is found in 95 %"));
  // One recording knows only its day.
  const TemporaryFile one("one.csv", recording(Shown())), other("other.csv", recording(Shown()));
  const std::string options = "--preset joint_friction --bandwidth 0 ",
                    day = "one recording shows nothing of what differs";
  CHECK_THAT(check(options + one.name).text, contains(day));
  CHECK_THAT(check(options + one.name + " " + other.name).text, contains("the promise") && !contains(day));
}

TEST_CASE("check_arm: settings whose intervals hold too seldom are widened, and it says so", "[check_arm]") {
  Shown shown;
  shown.columns = "tau";
  shown.factor = 1.05;
  const TemporaryFile log("widened.csv", recording(shown));
  // A gain that is off by 5 %, 2 N m of gravity, and the user says that the torque is as good as a link-side sensor's.
  std::string said;
  const json wide = settings_of("--preset link_side --bandwidth 0 " + log.name, &said),
             usual = settings_of("--bandwidth 0 " + log.name);
  CHECK_THAT(said, contains("noise, offset and residual in the settings are") &&
                       contains("times what the logs show, since intervals held too seldom"));
  for (const char* field : {"noise", "offset", "residual"})
    CHECK(wide["arm"][field][0].get<double>() > 1.4 * usual["arm"][field][0].get<double>());
  CHECK(wide["arm"]["coulomb"] == usual["arm"]["coulomb"]);
}

TEST_CASE("check_arm: a path that is repeated promises nothing", "[check_arm]") {
  Shown shown;
  shown.repeats = 3;
  const TemporaryFile log("repeated.csv", recording(shown));
  const Result result = check("--bandwidth 0 " + log.name);
  CHECK(result.exit_code == 0);
  CHECK_THAT(result.text, contains("no promise: these logs show one path only") && !contains("the promise:"));
}

TEST_CASE("check_arm: friction that grows with the load is found where it does, and nowhere else", "[check_arm]") {
  const auto growth = [](const Shown& shown) {
    const TemporaryFile log("load.csv", recording(shown));
    const std::string text = check("--bandwidth 0 " + log.name).text, name = "more for each N m of load";
    CAPTURE(text);
    CHECK((text.find("friction grows with what joint 2, 3, 4 carries") != std::string::npos) == (shown.per_load > 0));
    std::istringstream row(text.substr(text.find(name) + name.size()));
    std::vector<double> found(7);
    for (double& v : found) row >> v;
    REQUIRE(row);
    return found;
  };
  Shown shown;
  shown.seconds = 24;
  shown.per_load = 0.05;
  const std::vector<double> some = growth(shown);
  for (const std::size_t j : {1u, 3u}) CHECK(some[j] == Approx(0.05).epsilon(0.1));  // they carry 10 to 35 N m
  CHECK(some[0] == 0);                                                               // it turns about the vertical
  shown.per_load = 0;
  for (const double v : growth(shown)) CHECK(v == 0);
}

TEST_CASE("check_arm: a log that cannot be right is refused, with the command that mends it", "[check_arm]") {
  Shown shown;
  shown.columns = "tau";
  shown.factor = -1;
  const TemporaryFile opposite("opposite.csv", recording(shown));
  const Result sign = check(opposite.name);
  CHECK(sign.exit_code == 1);
  CHECK_THAT(sign.text,
             contains("the torque has the opposite sign: --torque-sign reaction") &&
                 contains("\ntry: check_arm " + opposite.name + " --torque-sign reaction --output checked\n"));
  CHECK(check("--torque-sign reaction " + opposite.name).exit_code == 0);
  shown.factor = 0.1;
  const TemporaryFile currents("currents.csv", recording(shown));
  const Result unit = check(currents.name);
  CHECK(unit.exit_code == 1);
  CHECK_THAT(unit.text, contains("all joints' torque is 0.1 times what the arm needs: --gains 10,10,10,10,10,10,10"));
  CHECK(check("--gains 10,10,10,10,10,10,10 " + currents.name).exit_code == 0);
}

TEST_CASE("check_arm: a log that is too short to try a payload for 5 s says so, and not that none is found",
          "[check_arm]") {
  Shown shown;
  shown.seconds = 6;
  const TemporaryFile first("first.csv", recording(shown)), second("second.csv", recording(shown));
  const std::string text = promise_of("--bandwidth 0 " + first.name + " " + second.name).text;
  CHECK_THAT(text, contains("lightest payload that is found in 95 %") && contains("not tried for 5 s"));
  CHECK_THAT(text, !contains("within 5 s"));
}

TEST_CASE("check_arm: a log that says nothing of an empty hand is refused", "[check_arm]") {
  Shown brief;
  brief.seconds = 3;
  const TemporaryFile log("brief.csv", recording(brief));
  const Result refused = check(log.name, Stream::Errors);
  CHECK(refused.exit_code == 3);
  CHECK_THAT(refused.text, contains("5 s of an empty hand are needed, the logs hold 2996 ms"));
  const Result held = check("\"" RME_TEST_DATA "/mujoco/link_side.csv.gz\"", Stream::Errors);
  CHECK(held.exit_code == 3);
  CHECK_THAT(held.text, contains("column m: the hand holds something"));
  for (const char* bad : {"", "--mass 1 log.csv", "--span 2:1 log.csv", "--span 1 log.csv", "--windows 3 log.csv"}) {
    CAPTURE(bad);
    const Result usage = check(bad, Stream::Errors);
    CHECK(usage.exit_code == 2);
    CHECK_THAT(usage.text, contains("usage: check_arm"));
  }
}

TEST_CASE("fastest_step: the bandwidth of a filter is read off a step that went through it", "[check_arm]") {
  for (const double bandwidth : {25.0, 50.0, 200.0}) {
    CAPTURE(bandwidth);
    std::vector<double> t;
    std::vector<Eigen::Vector2d> tau, dq;
    std::mt19937 random(2);
    std::normal_distribution<double> noise(0, 0.01);
    for (int k = 0; k < 2000; ++k) {
      t.push_back(1e-3 * k);
      const double since = t.back() - 1;
      tau.emplace_back(noise(random), (since > 0 ? 4 * (1 - std::exp(-bandwidth * since)) : 0) + noise(random));
      dq.emplace_back(0, 0);
    }
    CHECK(rme::examples::fastest_step(t, tau, dq) == Approx(bandwidth).epsilon(0.15));
    for (auto& v : dq) v[0] = 0.5;  // it moves
    CHECK(rme::examples::fastest_step(t, tau, dq) == 0);
  }
}

}  // namespace
