// 02_constrained_interaction: somebody pushes an arm against a wall and up to a joint limit. What does the constrained
// passive controller (CPIC) do, and what does the same controller do without its constraints?
//
// A linear attractor holds a simulated Panda in front of a wall. A scripted person pushes it into the wall at 1 s, then
// back and down at 4 s, until a joint reaches its limit. The same eight seconds run twice: with CPIC, and with the
// unconstrained passive controller, clamped to the torque limits. Prints the distances to wall and limit and the
// energies; with --output DIR writes both runs as CSV (plot.py draws them).
#include <cmath>
#include <cpic_host/energy_books.hpp>
#include <cpic_host/host.hpp>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <string>
#include <synthetic_arm/panda.hpp>

#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Vector = Host::Vector;

constexpr double kPeriod = 1e-3;  // [s]
constexpr double kEnd = 8;        // [s]
constexpr double kRoom = 0.1;     // distance of the flange to the wall at the start [m]

constexpr const char* kUsage =
    R"(usage: rme_02_constrained_interaction [options]

Somebody pushes an arm into a wall and up to a joint limit, with CPIC and without. Prints how close it came to both.

  --force N         how hard each push is, 10 to 60 (default 45)
  --output DIR      write constrained.csv and unconstrained.csv there; the folder is made if need be
  --help            this text

Exit codes: 0 CPIC kept wall and joint limits; 1 it did not; 2 unusable arguments.
)";

struct Result {
  double wall = 1;      // least distance of the flange to the wall [m]; negative: inside the wall
  double limit = 10;    // least distance of a joint to its limit [rad]; negative: beyond the limit
  double torque = 0;    // largest share of a torque limit
  double stored = 0;    // most energy stored [J]
  double residual = 0;  // largest rise of stored minus supplied energy [J]
  double active = 0;    // time with an active constraint [s]
};

Result run(bool constrained, double force, std::ofstream* csv) {
  const ArmModel<7>& model = panda();
  const Vector start = model.ready;
  const Kinematics<7> at = model.kinematics(start);
  const Wall wall{-Eigen::Vector3d::UnitX(), -(at.position.x() + kRoom)};
  HostConfig config = HostConfig::hold(model, start);
  config.constrained = constrained;
  config.wall = wall;
  const Push forward{1, 0.2, 1.2, force * Eigen::Vector3d::UnitX()};
  const Push back{4, 0.2, 1.6, -force * Eigen::Vector3d(1, 0, 1).normalized()};

  SyntheticArm<7> arm(model, {}, start);
  Host host(model, config);  // may throw; nothing in the loop does
  EnergyBooks books(kPeriod);
  Result result;
  double lowest = 0;
  if (csv) {
    *csv << "t,push_x,push_z,h_wall,h_limit,stored,supplied,residual,active";
    for (int j = 1; j <= 7; ++j) *csv << ",tau" << j;
    *csv << '\n';
  }
  for (int k = 0; k < static_cast<int>(kEnd / kPeriod); ++k) {
    const double t = k * kPeriod;
    const Eigen::Vector3d push = forward.at(t) + back.at(t);
    arm.push({push, Eigen::Vector3d::Zero()});
    const Vector torque = host.update(arm, Vector::Zero());  // what a robot's torque callback would call
    books.update(arm, host, push);

    const double h_wall = wall.normal.dot(arm.kinematics().position) - wall.offset;
    const double h_limit = std::min((model.q_max - arm.q()).minCoeff(), (arm.q() - model.q_min).minCoeff());
    result.wall = std::min(result.wall, h_wall);
    result.limit = std::min(result.limit, h_limit);
    result.torque = std::max(result.torque, torque.cwiseAbs().cwiseQuotient(model.tau_max).maxCoeff());
    result.stored = std::max(result.stored, books.stored());
    lowest = std::min(lowest, books.residual());
    result.residual = std::max(result.residual, books.residual() - lowest);
    result.active += host.cpic().active_count() > 0 ? kPeriod : 0;
    if (csv && k % 5 == 0) {
      *csv << t << ',' << push.x() << ',' << push.z() << ',' << h_wall << ',' << h_limit << ',' << books.stored() << ','
           << books.supplied() << ',' << books.residual() << ',' << host.cpic().active_count();
      for (int j = 0; j < 7; ++j) *csv << ',' << torque[j];
      *csv << '\n';
    }
    arm.step(torque);
  }
  return result;
}

int run(Arguments& arguments) {
  const double force = arguments.number("--force").value_or(45);
  const std::optional<std::string> output = arguments.text("--output");
  arguments.finish();
  if (!(force >= 10 && force <= 60)) throw ArgumentError("--force: expected 10 to 60 N");
  if (output) make_folder("--output", *output);

  Result results[2];
  for (const bool constrained : {true, false}) {
    std::ofstream csv;
    if (output) {
      csv.exceptions(std::ofstream::failbit | std::ofstream::badbit);
      csv.open(std::filesystem::path(*output) / (constrained ? "constrained.csv" : "unconstrained.csv"));
    }
    results[constrained ? 0 : 1] = run(constrained, force, output ? &csv : nullptr);
  }

  const auto& [with, without] = results;
  std::printf("pushes of %.0f N                          with CPIC   without\n", force);
  const auto row = [](const char* what, const char* unit, double a, double b) {
    std::printf("  %-28s %-5s %10.3f %10.3f\n", what, unit, a, b);
  };
  row("least distance to the wall", "mm", 1e3 * with.wall, 1e3 * without.wall);
  row("least distance to a limit", "mrad", 1e3 * with.limit, 1e3 * without.limit);
  row("largest share of a torque", "%", 100 * with.torque, 100 * without.torque);
  row("most energy stored", "J", with.stored, without.stored);
  row("rise of stored - supplied", "J", with.residual, without.residual);
  row("time with an active row", "s", with.active, without.active);
  return with.wall > -5e-3 && with.limit > -1e-3 ? 0 : 1;  // the wall is a soft row
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_02_constrained_interaction", kUsage, argc, argv, run);
}
