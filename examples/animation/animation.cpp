// animation: an arm is handed a cup, somebody pours something into it, the arm carries it elsewhere and lets go. What
// does an impedance-controlled arm do then, alone and with rme?
//
// The same ten seconds of a simulated Panda run three times: without the cup, which shows where the arm should be, with
// the cup and no compensation, and with the cup and rme's. With --output DIR all three are written as CSV, from which
// rme_render_arm and animate.py make the animation of the README (`bash examples/animation/all`).
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <rme/core/compensation.hpp>
#include <rme/estimator.hpp>
#include <stdexcept>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Vector = rme::JointVector<double, 7>;

constexpr double kPeriod = 1e-3;                                       // of the control loop [s]
constexpr double kHanded = 1, kPour = 2.5, kPoured = 4.5;              // [s]
constexpr double kCarry = 5.5, kCarried = 7.5, kDrop = 8, kEnd = 9.6;  // [s]
constexpr double kCup = 0.4, kContent = 1.1;                           // [kg]
constexpr int kWritten = 20;                                           // every so many ticks
const Eigen::Vector3d kWay = {-0.15, 0.12, 0.0};                       // along which it is carried [m]
const Eigen::Vector3d kCupCentre = {0.04, 0.02, 0.1}, kContentCentre = {0.04, 0.02, 0.13};  // flange axes [m]

constexpr const char* kUsage = R"(usage: rme_animation [options]

An arm is handed a cup at 1 s, which is filled from 2.5 to 4.5 s, carried from 5.5 to 7.5 s and dropped at 8 s. Prints
how far that takes the flange from where it is to be, without compensation and with rme's.

  --seed N          of sensor noise and sensor offsets (default 1)
  --output DIR      write nominal.csv, without.csv and with.csv there; the folder is made if need be
  --help            this text

Exit codes: 0 done; 1 compensation did not help; 2 unusable arguments.
)";

enum class Run { Nominal, Without, With };

struct Row {
  double t;
  Vector q;
  Eigen::Vector3d position;       // of the flange [m]
  double truth, mass, deviation;  // in the hand, and believed [kg]
};

/// From rest to rest in a straight line: a polynomial of fifth degree.
PoseTarget path(const PoseTarget& home, double t) {
  const double s = std::clamp((t - kCarry) / (kCarried - kCarry), 0.0, 1.0);
  PoseTarget target = home;
  target.position += s * s * s * (10 - 15 * s + 6 * s * s) * kWay;
  target.velocity = 30 * s * s * (1 - s) * (1 - s) / (kCarried - kCarry) * kWay;
  return target;
}

std::vector<Row> simulate(Run run, std::size_t seed) {
  SyntheticArmConfig<7> faults = with_typical_faults(panda(), seed);
  faults.friction = {};  // torque is measured behind the gears
  SyntheticArm<7> arm(panda(), faults, panda().ready);
  PoseImpedance<7> controller(panda(), panda().ready);
  const PoseTarget home{arm.kinematics().position, arm.kinematics().rotation};
  rme::Estimator<double, 7> estimator(kPeriod);
  rme::CompensationRamp<double, 7> ramp(kPeriod);

  std::vector<Row> rows;
  int cup = 0, content = 0;
  for (int tick = 0; tick * kPeriod <= kEnd; ++tick) {
    const double t = tick * kPeriod;
    const auto now = [&](double event) { return run != Run::Nominal && tick == std::lround(event / kPeriod); };
    if (now(kHanded)) cup = arm.attach(box(kCup, kCupCentre, {0.08, 0.08, 0.1}));
    if (now(kPour)) content = arm.attach(box(kContent, kContentCentre, {0.08, 0.08, 0.06}), kPoured - kPour);
    if (now(kDrop))
      for (const int handle : {cup, content}) arm.detach(handle);

    const auto& [position, rotation, jacobian] = arm.kinematics();
    rme::Status status = estimator.update({arm.tau_ext(), jacobian, rotation, arm.dq()});
    if (status == rme::Status::Ok) status = ramp.update(estimator.compensation(jacobian, rotation));
    if (status != rme::Status::Ok) throw std::runtime_error(rme::to_string(status));
    controller.follow(path(home, t));
    Vector tau = controller.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics());
    if (run == Run::With) tau += ramp.torque();

    const auto& payload = estimator.state().payload;
    if (tick % kWritten == 0)
      rows.push_back({t, arm.q(), position, arm.payload().mass, payload.mean[0], payload.standard_deviation()[0]});
    arm.step(tau);
  }
  return rows;
}

double distance(const Row& row, const Row& nominal) {
  return (row.position - nominal.position).norm();
}

// Readable as a log, as far as it has its columns.
void write_csv(const std::filesystem::path& path, const std::vector<Row>& rows, const std::vector<Row>& nominal) {
  std::ofstream file(path);
  file.precision(9);
  file << "t,q1,q2,q3,q4,q5,q6,q7,m,mass,mass_std,distance\n";
  const Eigen::IOFormat cells(Eigen::StreamPrecision, Eigen::DontAlignCols, ",", ",");
  for (std::size_t i = 0; i < rows.size(); ++i) {
    const Row& row = rows[i];
    file << row.t << ',' << row.q.format(cells) << ',' << row.truth << ',' << row.mass << ',' << row.deviation << ','
         << distance(row, nominal[i]) << '\n';
  }
  if (!file.flush()) throw ArgumentError("--output: cannot write " + path.string());
}

int run(Arguments& arguments) {
  const std::size_t seed = arguments.whole("--seed", 0).value_or(1);
  const std::optional<std::string> output = arguments.text("--output");
  arguments.finish();
  const std::vector<Row> nominal = simulate(Run::Nominal, seed), without = simulate(Run::Without, seed),
                         with = simulate(Run::With, seed);
  if (output) {
    make_folder("--output", *output);
    const std::filesystem::path folder = *output;
    write_csv(folder / "nominal.csv", nominal, nominal);
    write_csv(folder / "without.csv", without, nominal);
    write_csv(folder / "with.csv", with, nominal);
  }

  std::printf("largest distance of the flange from its way [mm]    without      with rme\n");
  double alone = 0, carried = 0;
  const auto row = [&](const char* name, double from, double to) {
    double worst[2] = {};
    for (std::size_t i = 0; i < nominal.size(); ++i) {
      if (nominal[i].t < from || nominal[i].t >= to) continue;
      worst[0] = std::max(worst[0], distance(without[i], nominal[i]));
      worst[1] = std::max(worst[1], distance(with[i], nominal[i]));
    }
    std::printf("  %-45s %10.1f    %10.1f\n", name, 1e3 * worst[0], 1e3 * worst[1]);
    alone = std::max(alone, worst[0]);
    carried = std::max(carried, worst[1]);
  };
  row("handed a cup of 0.4 kg", kHanded, kPour);
  row("1.1 kg are poured into it", kPour, kPoured);
  row("held", kPoured, kCarry);
  row("carried", kCarry, kDrop);
  row("dropped", kDrop, kEnd);
  return carried < alone ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_animation", kUsage, argc, argv, run);
}
