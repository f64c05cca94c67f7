#include <check_arm/link_correction.hpp>
#include <filesystem>
#include <io/json_file.hpp>
#include <random>
#include <replay_log/settings_model.hpp>
#include <sstream>
#include <string>
#include <urdf_arm/urdf_chain.hpp>

#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using namespace rme::examples;
using rme::testing::run;
using rme::testing::Stream;
using rme::testing::TemporaryFile;
using Vector = rme::JointVector<double, 6>;

constexpr const char* kUrdf = RME_TEST_DATA "/urdf/six_joints_5kg.urdf";

UrdfChain arm() {
  return read_urdf(kUrdf, "base_link", "tool0");
}

Vector drawn(std::mt19937& random, double bound) {
  std::uniform_real_distribution<double> uniform(-bound, bound);
  return Vector::NullaryExpr([&] { return uniform(random); });
}

TEST_CASE("to_urdf: the arm that is written is the arm that is read", "[link_correction]") {
  for (const auto& [file, base, tip] : {std::tuple(kUrdf, "base_link", "tool0"),
                                        std::tuple(RME_TEST_DATA "/urdf/six_joints_10kg.urdf", "world", "tool0")}) {
    CAPTURE(file);
    const UrdfChain chain = read_urdf(file, base, tip);
    const UrdfChain back = parse_urdf(to_urdf(chain), "written.urdf", base, tip);
    const ArmModel<6> model = arm_model<6>(chain), again = arm_model<6>(back);
    CHECK(again.q_min == model.q_min);
    CHECK(again.tau_max == model.tau_max);
    const unsigned seed = 9;
    CAPTURE(seed);
    std::mt19937 random(seed);
    for (int k = 0; k < 10; ++k) {
      const Vector q = drawn(random, 3), dq = drawn(random, 2);
      CHECK((again.kinematics(q).position - model.kinematics(q).position).norm() < 1e-13);
      CHECK((again.kinematics(q).rotation - model.kinematics(q).rotation).norm() < 1e-13);
      CHECK((again.dynamics(q, dq).mass_matrix - model.dynamics(q, dq).mass_matrix).norm() < 1e-12);
      CHECK((again.dynamics(q, dq).gravity - model.dynamics(q, dq).gravity).norm() < 1e-11);
      CHECK((again.dynamics(q, dq).coriolis - model.dynamics(q, dq).coriolis).norm() < 1e-12);
    }
  }
}

TEST_CASE("link_kinematics: the last link's is the flange's without a flange, and others do not feel joints beyond",
          "[link_correction]") {
  ArmModel<6> model = arm_model<6>(arm());
  model.flange.setZero();
  model.flange_rotation.setIdentity();
  std::mt19937 random(4);
  const Vector q = drawn(random, 2);
  const auto last = link_kinematics(model, q, 5), flange = model.kinematics(q);
  CHECK((last.position - flange.position).norm() < 1e-14);
  CHECK((last.jacobian - flange.jacobian).norm() < 1e-14);
  const auto third = link_kinematics(model, q, 2);
  CHECK(third.jacobian.rightCols<3>().norm() == 0);
  Vector other = q;
  other.tail<3>() = drawn(random, 2).tail<3>();
  CHECK((link_kinematics(model, other, 2).rotation - third.rotation).norm() < 1e-14);
}

TEST_CASE("check_arm: an arm that is not its URDF is told, and what is written instead is nearer to it",
          "[link_correction]") {
  // The forearm carries half a kilogram that the URDF does not know of, the shoulder's rotor turns with the joint, and
  // friction grows with what a joint carries.
  ArmModel<6> real = arm_model<6>(arm());
  real.links[2].body = real.links[2].body + box(0.5, {0.05, 0.02, 0.2}, {0.1, 0.1, 0.1});
  constexpr double kRotor = 1.5, kLoadFriction = 0.06;
  std::mt19937 random(6);
  std::normal_distribution<double> noise(0, 0.05);
  std::ostringstream text;
  text.precision(10);
  text << "t";
  for (const char* name : {"q", "dq", "tau"})
    for (int j = 1; j <= 6; ++j) text << ',' << name << j;
  for (double t = 0; t < 20; t += 0.004) {
    Vector q, dq, ddq;
    for (int j = 0; j < 6; ++j) {
      const double w = 1.7 + 0.37 * j, start = j == 1 ? -1.1 : j == 2 ? 1.3 : 0.6;
      q[j] = start + 0.5 * (1 - std::cos(w * t));
      dq[j] = 0.5 * w * std::sin(w * t);
      ddq[j] = 0.5 * w * w * std::cos(w * t);
    }
    const auto terms = real.dynamics(q, dq);
    Vector tau = terms.mass_matrix * ddq + terms.coriolis + terms.gravity;
    tau[0] += kRotor * ddq[0];
    for (int j = 0; j < 6; ++j)
      tau[j] += (0.3 + kLoadFriction * std::abs(terms.gravity[j])) * (dq[j] > 0 ? 1 : -1) + 0.2 * dq[j] + noise(random);
    text << '\n' << t;
    for (const Vector& v : {q, dq, tau})
      for (int j = 0; j < 6; ++j) text << ',' << v[j];
  }
  const TemporaryFile log("heavier.csv", text.str() + '\n'), folder("corrected", "");
  std::filesystem::remove(folder.name);
  const std::string command = log.name + " --urdf \"" + kUrdf + "\" --base base_link --tip tool0 --rated-payload 5" +
                              " --output " + folder.name;
  const auto told = run(RME_CHECK_ARM, command, Stream::Output);
  CHECK(told.exit_code == 0);
  CHECK_THAT(told.text, contains("the same logs, with these links, rotors of"));
  const nlohmann::json settings = read_json_file(folder.name + "/settings.json");
  ArmRequest request;
  request.chain = arm();
  CHECK_THAT(use_model(settings.at("model"), folder.name + "/settings.json", request),
             contains(folder.name + "/corrected.urdf"));
  CHECK(request.rotor_inertia.at(0) == Approx(kRotor).epsilon(0.1));
  CAPTURE(told.text);
  for (const std::size_t j : {1U, 2U}) CHECK(request.load_friction.at(j) == Approx(kLoadFriction).epsilon(0.2));
  const ArmModel<6> urdf = arm_model<6>(arm());
  const ArmModel<6> better = arm_model<6>(*request.chain);
  double before = 0, after = 0;
  for (int k = 0; k < 50; ++k) {  // poses like those of the log
    Vector q = drawn(random, 0.5);
    q += Vector(1.1, -0.6, 1.8, 1.1, 1.1, 1.1);
    const Vector rest = Vector::Zero();
    before += (urdf.dynamics(q, rest).gravity - real.dynamics(q, rest).gravity).squaredNorm();
    after += (better.dynamics(q, rest).gravity - real.dynamics(q, rest).gravity).squaredNorm();
  }
  CAPTURE(before, after);
  CHECK(std::sqrt(after) < 0.2 * std::sqrt(before));
  CHECK_THAT(run(RME_CHECK_ARM, command + " --keep-links", Stream::Output).text, !contains("the same logs, with"));
  CHECK_FALSE(read_json_file(folder.name + "/settings.json").contains("model"));
  std::filesystem::remove_all(folder.name);
}

}  // namespace
