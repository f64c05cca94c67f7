#include <cstdio>
#include <filesystem>
#include <fstream>
#include <io/log_reader.hpp>
#include <make_logs/recording.hpp>
#include <map>
#include <nlohmann/json.hpp>
#include <rme/core/payload.hpp>
#include <string>
#include <synthetic_arm/panda.hpp>

#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using nlohmann::json;
using rme::examples::Log;
using rme::examples::panda;
using Vector = rme::JointVector<double, 7>;

/// A folder of recordings for as long as the test runs.
class Recordings {
 public:
  explicit Recordings(const std::string& arguments) {
    static int count = 0;
    folder_ = std::to_string(::getpid()) + "_logs" + std::to_string(count++);
    const auto result =
        rme::testing::run(RME_MAKE_LOGS, "--output " + folder_ + " " + arguments, rme::testing::Stream::Errors);
    CAPTURE(result.text);
    REQUIRE(result.exit_code == 0);
    std::ifstream(folder_ + "/manifest.json") >> manifest_;
  }
  ~Recordings() { std::filesystem::remove_all(folder_); }
  Recordings(const Recordings&) = delete;
  Recordings& operator=(const Recordings&) = delete;

  const json& manifest() const { return manifest_; }
  std::string text(const json& run) const {
    return rme::examples::read_file(folder_ + "/" + run["file"].get<std::string>());
  }
  Log<7> log(const json& run) const { return rme::examples::parse_log<7>(text(run), run["name"]); }
  /// Of the first run.
  Log<7> log() const { return log(manifest_["runs"][0]); }

 private:
  std::string folder_;
  json manifest_;
};

Eigen::Vector3d vector3(const json& numbers) {
  return {numbers[0].get<double>(), numbers[1].get<double>(), numbers[2].get<double>()};
}
Vector vector7(const json& numbers) {
  Vector out;
  for (std::size_t i = 0; i < 7; ++i) out[static_cast<int>(i)] = numbers[i].get<double>();
  return out;
}

// What the row's payload does to the resting joints, by the conventions' payload wrench.
Vector payload_torque(const Log<7>& log, std::size_t k) {
  const auto at = panda().kinematics(log.q[k]);
  const rme::Payload<double> payload{log.truth[k][0], log.truth[k].tail<3>()};
  return at.jacobian.transpose() * rme::payload_wrench(payload, at.rotation).vector();
}

std::size_t row(double t) {
  return static_cast<std::size_t>(std::lround(1e3 * t));
}

TEST_CASE("make_logs: what the manifest says is what happens in the recordings", "[make_logs]") {
  const Recordings recordings("--runs 1 --seed 4 --plain");
  REQUIRE(recordings.manifest()["runs"].size() == 7);
  for (const json& run : recordings.manifest()["runs"]) {
    CAPTURE(run["name"].get<std::string>());
    const Log<7> log = recordings.log(run);
    REQUIRE(log.size() == row(run["T"]) + 1);
    for (std::size_t k = 0; k < log.size(); ++k) REQUIRE(log.t[k] == Approx(1e-3 * static_cast<double>(k)));
    CHECK((log.q[0] - vector7(run["q0"])).norm() < 1e-7);
    CHECK(log.tau_ext[0].isZero(0));

    // The truth: what the events so far add up to, filled in a straight line where they say so.
    for (std::size_t k = 0; k < log.size(); k += 37) {
      std::map<std::string, std::pair<double, Eigen::Vector3d>> held;
      for (const json& event : run["events"]) {
        const std::string slot = event["slot"];
        const double since = log.t[k] - event["t"].get<double>();
        if (since < -1e-6) continue;
        if (event["action"] == "detach") {
          held.erase(slot);
          continue;
        }
        const double share = event.contains("ramp") ? std::min(1.0, since / event["ramp"].get<double>()) : 1.0;
        const double before = held.count(slot) ? held[slot].first : 0.0;
        held[slot] = {before + share * (event["m"].get<double>() - before), vector3(event["r"])};
      }
      double mass = 0;
      Eigen::Vector3d moment = Eigen::Vector3d::Zero();
      for (const auto& [slot, body] : held) {
        mass += body.first;
        moment += body.first * body.second;
      }
      CAPTURE(log.t[k]);
      CHECK(log.truth[k][0] == Approx(mass).margin(2e-5));
      if (mass > 0) CHECK((log.truth[k].tail<3>() - moment / mass).norm() < 2e-5);
    }
  }
}

TEST_CASE("make_logs: at rest tau_ext is J^T of the true payload's wrench, less the sensors' offset", "[make_logs]") {
  const Recordings recordings("--scenario A,B,F --runs 2 --plain");
  for (const json& run : recordings.manifest()["runs"]) {
    CAPTURE(run["name"].get<std::string>());
    const Log<7> log = recordings.log(run);
    Vector mean = Vector::Zero();  // over the last 0.2 s
    for (std::size_t k = log.size() - 200; k < log.size(); ++k) mean += (log.tau_ext[k] - payload_torque(log, k)) / 200;
    // The observer leaves 0.008 N m of 0.05 N m of white noise, and its 20 ms make a tenth of that of 0.2 s.
    // Scenarios A and B end before the arm is quite at rest.
    CHECK((mean + vector7(run["noise"]["tau_bias"])).cwiseAbs().maxCoeff() < 0.04);
    CHECK(payload_torque(log, log.size() - 1).norm() > 0.5);
  }
}

TEST_CASE("make_logs: joint friction and a wrong model show in tau_ext of the empty hand at rest", "[make_logs]") {
  const auto left_over = [](const std::string& kind) {
    const Recordings recordings("--scenario F --runs 1 --seed 2 --plain --kind " + kind);
    const json& run = recordings.manifest()["runs"][0];
    const Log<7> log = recordings.log();
    Vector mean = Vector::Zero();
    for (std::size_t k = 700; k < 1000; ++k) mean += (log.tau_ext[k] + vector7(run["noise"]["tau_bias"])) / 300;
    return mean.norm();
  };
  CHECK(left_over("link_side") < 0.02);
  CHECK(left_over("joint_friction") > 0.05);
  CHECK(left_over("model_error") > 0.05);
}

TEST_CASE("make_logs: in the scenarios with motion the arm moves and turns as far as it should", "[make_logs]") {
  const Recordings recordings("--scenario E,M --runs 2 --plain");
  for (const json& run : recordings.manifest()["runs"]) {
    CAPTURE(run["name"].get<std::string>());
    const Log<7> log = recordings.log(run);
    const auto home = panda().kinematics(log.q[0]);
    double turned = 0, moved = 0, slowest = 10;
    for (std::size_t k = row(run["scenario"] == "E" ? 5 : 2); k < log.size(); ++k) {
      const auto at = panda().kinematics(log.q[k]);
      turned = std::max(turned, Eigen::AngleAxisd(home.rotation.transpose() * at.rotation).angle());
      moved = std::max(moved, (at.position - home.position).norm());
      slowest = std::min(slowest, log.dq[k].norm());
    }
    CHECK((turned > 0.4 && turned < 1.3));
    CHECK((moved > 0.05 && moved < 0.4));
    CHECK(slowest > 0.02);  // [rad/s]
  }
}

TEST_CASE("make_logs: pushes of 5 to 15 N show in tau_ext while they last", "[make_logs]") {
  const Recordings recordings("--scenario D --runs 2 --plain");
  for (const json& run : recordings.manifest()["runs"]) {
    CAPTURE(run["name"].get<std::string>());
    const Log<7> log = recordings.log(run);
    REQUIRE(run["pushes"].size() >= 4);
    for (const json& push : run["pushes"]) {
      const Eigen::Vector3d force = vector3(push["F"]);
      CHECK((force.norm() >= 5 && force.norm() <= 15));
      // 0.15 s in, the observer has come within exp(-7.5) of it; the arm gives way and its inertia is not in tau_ext.
      const std::size_t k = row(push["t0"].get<double>() + 0.15), before = row(push["t0"]);
      const Vector rise = log.tau_ext[k] - log.tau_ext[before];
      const Vector expected = panda().kinematics(log.q[k]).jacobian.topRows<3>().transpose() * force;
      CHECK((rise - expected).norm() < 0.25 * expected.norm() + 0.1);
    }
  }
}

TEST_CASE("make_logs: the same seed writes the same recordings, another seed others, also compressed", "[make_logs]") {
  const auto text = [](const std::string& arguments) {
    const Recordings recordings("--scenario A --runs 2 " + arguments);
    return recordings.text(recordings.manifest()["runs"][1]);
  };
  const std::string first = text("--seed 5 --plain");
  CHECK(text("--seed 5") == first);
  CHECK(text("--seed 6") != first);
  CHECK(first.substr(0, 8) == "t,q1,q2,");
}

TEST_CASE("make_logs: the options for late, stepped and lost torque change a recording in that way only",
          "[make_logs]") {
  const std::string same = "--scenario A --runs 1 --seed 3 --plain ";
  const Log<7> clean = Recordings(same).log();
  const Log<7> late = Recordings(same + "--late 5").log();
  const Log<7> stepped = Recordings(same + "--torque-step 0.05").log();
  const Log<7> holed = Recordings(same + "--lost 0.1").log();
  for (std::size_t k = 5; k < clean.size(); ++k) {
    REQUIRE(late.q[k] == clean.q[k]);
    REQUIRE(late.tau_ext[k] == clean.tau_ext[k - 5]);
    REQUIRE((stepped.tau_ext[k] - clean.tau_ext[k]).cwiseAbs().maxCoeff() < 0.025 + 1e-5);
    const Vector steps = stepped.tau_ext[k] / 0.05;
    REQUIRE((steps.array() - steps.array().round()).abs().maxCoeff() < 1e-6);
  }
  CHECK((holed.size() > 2551 && holed.size() < 2851));
  for (std::size_t k = 0; k < holed.size(); ++k) REQUIRE(holed.tau_ext[k] == clean.tau_ext[row(holed.t[k])]);
}

TEST_CASE("make_logs: noise on the velocity is not in the motion, and in tau_ext only if the observer takes it",
          "[make_logs]") {
  const auto roughness = [](const std::string& arguments) {
    const Recordings recordings("--scenario F --runs 1 --seed 3 --plain " + arguments);
    const Log<7> log = recordings.log();
    double dq = 0, torque = 0;
    for (std::size_t k = 201; k < 1000; ++k) {  // at rest; differences from row to row
      dq += (log.dq[k] - log.dq[k - 1]).squaredNorm() / 7 / 2 / 799;
      torque += (log.tau_ext[k] - log.tau_ext[k - 1]).squaredNorm() / 799;
    }
    return std::pair(std::sqrt(dq), std::sqrt(torque));
  };
  const auto [clean, clean_torque] = roughness("");
  const auto [noisy, noisy_torque] = roughness("--dq-noise 0.003");
  const auto [fed, fed_torque] = roughness("--dq-noise 0.003 --noisy-observer");
  CHECK(clean < 1e-4);
  CHECK(noisy == Approx(0.003).epsilon(0.05));
  CHECK(fed == Approx(0.003).epsilon(0.05));
  CHECK(noisy_torque < 2 * clean_torque);
  CHECK(fed_torque > 10 * clean_torque);
}

#ifdef RME_HAS_MUJOCO
TEST_CASE("make_logs: MuJoCo's physics makes the same recordings as ours", "[make_logs]") {
  const auto logs = [](const std::string& physics) {
    return Recordings("--scenario D --runs 1 --plain --physics " + physics).log();
  };
  const Log<7> ours = logs("synthetic"), theirs = logs("mujoco");
  REQUIRE(ours.size() == theirs.size());
  double q = 0, tau_ext = 0;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    q = std::max(q, (ours.q[k] - theirs.q[k]).cwiseAbs().maxCoeff());
    tau_ext = std::max(tau_ext, (ours.tau_ext[k] - theirs.tau_ext[k]).cwiseAbs().maxCoeff());
  }
  CHECK(q < 1e-6);
  CHECK(tau_ext < 1e-4);
}
#endif

TEST_CASE("make_logs: an arm that is asked to go through a joint limit or beyond its torque says so", "[make_logs]") {
  std::mt19937_64 random(1);
  const rme::examples::SyntheticArmConfig<7> config;
  rme::examples::Plan plan = rme::examples::draw_plan('A', random);
  CHECK(rme::examples::record(plan, config).refusal.empty());
  plan.events[0].body = rme::examples::box(0.5, {0, 0, 0.1}, {0.1, 0.1, 0.1});
  plan.q0 = panda().ready;
  plan.q0[5] = panda().q_max[5] - 0.06;
  plan.offset = {0, 0, -0.1};
  CHECK(rme::examples::record(plan, config).refusal == "joint limit");
  plan.q0 = panda().ready;
  plan.q0[3] = -0.15;  // all but stretched
  plan.offset.setZero();
  CHECK(rme::examples::record(plan, config).refusal == "singular pose");
  plan.q0 = panda().ready;
  plan.gains.lambda1 = 1e4;
  plan.offset = {0, 0, 0.5};
  CHECK(rme::examples::record(plan, config).refusal == "joint torque");
}

}  // namespace
