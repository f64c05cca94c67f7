// 01_static_payload: an arm holds a pose; after one second an unknown payload is attached to its flange. How far does
// the arm sag, and what does rme estimate?
//
// A simulated Panda holds its ready pose under a passive impedance law whose model does not include the payload. The
// same four seconds run twice: with rme's compensation added to the torque, and without. Prints the estimate, the true
// payload and the position errors of the flange; with --output DIR writes both runs as CSV (plot.py draws them).
#include <algorithm>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <optional>
#include <rme/core/compensation.hpp>
#include <rme/estimator.hpp>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Torque = rme::JointVector<double, 7>;

constexpr double kPeriod = 1e-3;   // of the control loop [s]
constexpr double kAttach = 1;      // when the payload appears [s]
constexpr double kEnd = 4;         // [s]
constexpr double kLater = 2;       // time from the payload's appearance to the comparison of the errors [s]
constexpr double kMaxMass = 3;     // rated payload of a Panda [kg]
constexpr double kMaxReach = 0.5;  // largest coordinate of the payload's centre of mass [m]

constexpr const char* kUsage =
    R"(usage: rme_01_static_payload [options]

An arm holds a pose; after 1 s an unknown payload hangs on its flange. Prints what rme estimates and what its
compensation is worth.

  --mass KG         mass of the payload, above 0 to 3 (default 1.1)
  --com X,Y,Z       its centre of mass in flange axes [m], each within 0.5 (default 0.05,0.02,0.13)
  --seed N          of sensor noise, sensor offsets and friction, all drawn at random (default 1)
  --no-noise        torque sensors without white noise
  --no-offset       torque sensors without constant offset
  --friction        an arm that measures torque before its gears: joint friction holds the arm back, and shows in the
                    measured torque. Without it, torque is measured behind the gears, as on a real Panda
  --output DIR      write compensated.csv and uncompensated.csv there; the folder is made if need be
  --help            this text

Exit codes: 0 done; 1 the payload was not noticed, or compensation did not help; 2 unusable arguments.
)";

struct Options {
  RigidBody payload;
  SyntheticArmConfig<7> arm;
  bool friction = false;
  std::optional<std::string> output;
};

Options parse(Arguments& arguments) {
  const double mass = arguments.number("--mass").value_or(1.1);
  const std::vector<double> com = arguments.numbers("--com", 3).value_or(std::vector<double>{0.05, 0.02, 0.13});
  const std::size_t seed = arguments.whole("--seed", 0).value_or(1);
  const bool no_noise = arguments.flag("--no-noise"), no_offset = arguments.flag("--no-offset");
  Options options;
  options.friction = arguments.flag("--friction");
  options.output = arguments.text("--output");
  arguments.finish();

  if (!(mass > 0 && mass <= kMaxMass)) throw ArgumentError("--mass: must be above 0 and at most 3 kg");
  for (const double x : com)
    if (std::abs(x) > kMaxReach) throw ArgumentError("--com: must lie within 0.5 m of the flange in each direction");

  options.payload = box(mass, {com[0], com[1], com[2]}, {0.06, 0.06, 0.1});
  options.arm = with_typical_faults(panda(), seed);
  options.arm.dt = kPeriod;
  if (no_noise) options.arm.torque_noise.setZero();
  if (no_offset) options.arm.torque_offset.setZero();
  if (!options.friction) options.arm.friction = {};
  return options;
}

struct Row {
  double t;
  Torque q, dq, tau_ext, compensation;
  Eigen::Vector3d error;        // flange from its target [m]
  double mass, mass_deviation;  // estimate and its standard deviation [kg]
  rme::Mode likeliest;
};

struct Run {
  std::vector<Row> rows;
  rme::EstimatorState<double> first, over, last;  // payload first estimated; its event over; end of the run
  double mean_time = 0, longest_time = 0;         // of the estimator's update() [s]

  double error_at(double t) const { return rows[static_cast<std::size_t>(std::lround(t / kPeriod))].error.norm(); }
  double worst_error() const {
    double worst = 0;
    for (const Row& row : rows) worst = std::max(worst, row.error.norm());
    return worst;
  }
};

rme::Mode likeliest(const rme::EstimatorState<double>& state) {
  const auto& p = state.probability.values;
  return static_cast<rme::Mode>(std::max_element(p.begin(), p.end()) - p.begin());
}

Run simulate(const Options& options, bool compensate) {
  using Clock = std::chrono::steady_clock;
  SyntheticArm<7> arm(panda(), options.arm, panda().ready);
  const PoseImpedance<7> controller(panda(), panda().ready);
  rme::Estimator<double, 7> estimator(kPeriod);
  rme::CompensationRamp<double, 7> ramp(kPeriod);

  Run run;
  bool attached = false;
  while (arm.time() < kEnd + kPeriod / 2) {
    if (!attached && arm.time() > kAttach - kPeriod / 2) attached = arm.attach(options.payload) > 0;
    const auto& [position, rotation, jacobian] = arm.kinematics();

    // What a host adds to its own loop. In: what the arm reports. Out: the torque that carries the payload.
    const auto start = Clock::now();
    const rme::Status status = estimator.update({arm.tau_ext(), jacobian, rotation, arm.dq()});
    const double elapsed = std::chrono::duration<double>(Clock::now() - start).count();
    if (status != rme::Status::Ok) throw std::runtime_error(rme::to_string(status));
    if (ramp.update(estimator.compensation(jacobian, rotation)) != rme::Status::Ok)
      throw std::runtime_error("the compensation is not finite");
    Torque tau = controller.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics());
    if (compensate) tau += ramp.torque();

    const rme::EstimatorState<double>& state = estimator.state();
    if (run.first.empty() && !state.empty()) run.first = state;
    if (run.over.event.number == 0 && state.event.number > 0) run.over = state;
    run.last = state;
    run.mean_time += elapsed * kPeriod / kEnd;
    run.longest_time = std::max(run.longest_time, elapsed);
    run.rows.push_back({arm.time(), arm.q(), arm.dq(), arm.tau_ext(),
                        compensate ? ramp.torque() : Torque::Zero().eval(), controller.position_error(arm.kinematics()),
                        state.payload.mean[0], state.payload.standard_deviation()[0], likeliest(state)});
    arm.step(tau);
  }
  return run;
}

// The file has the columns of a log (docs/conventions.md), with the truth m, rx, ry, rz, and the estimate.
void write_csv(const std::filesystem::path& path, const Run& run, const RigidBody& payload) {
  std::ofstream file(path);
  file.precision(9);
  file << "t";
  for (const char* name : {"q", "dq", "tau_ext", "tau_comp"})
    for (int i = 1; i <= 7; ++i) file << ',' << name << i;
  file << ",error_x,error_y,error_z,m,rx,ry,rz,mass,mass_std,mode\n";
  const Eigen::IOFormat cells(Eigen::StreamPrecision, Eigen::DontAlignCols, ",", ",");
  for (const Row& row : run.rows) {
    file << row.t;
    for (const Torque* v : {&row.q, &row.dq, &row.tau_ext, &row.compensation}) file << ',' << v->format(cells);
    Eigen::Vector4d truth = Eigen::Vector4d::Zero();
    if (row.t > kAttach - kPeriod / 2) truth << payload.mass, payload.com;
    file << ',' << row.error.format(cells) << ',' << truth.format(cells) << ',' << row.mass << ',' << row.mass_deviation
         << ',' << rme::to_string(row.likeliest) << '\n';
  }
  if (!file.flush()) throw ArgumentError("--output: cannot write " + path.string());
}

void print(const Options& options, const Run& with, const Run& without) {
  const RigidBody& truth = options.payload;
  std::printf("payload                    truth     estimate at %3.0f ms   std. dev.   at the end   std. dev.\n",
              1e3 * (with.over.time - kAttach));
  const auto row = [&](const char* name, double scale, int i, double value) {
    std::printf("  %s   %7.3f          %7.3f     %7.3f      %7.3f     %7.3f\n", name, scale * value,
                scale * with.over.payload.mean[i], scale * with.over.payload.standard_deviation()[i],
                scale * with.last.payload.mean[i], scale * with.last.payload.standard_deviation()[i]);
  };
  row("mass              kg", 1, 0, truth.mass);
  row("centre of mass x  mm", 1e3, 1, truth.com[0]);
  row("centre of mass y  mm", 1e3, 2, truth.com[1]);
  row("centre of mass z  mm", 1e3, 3, truth.com[2]);
  std::printf("\n");
  std::printf("first compensation   %6.0f ms after the attachment, for %.3f kg\n", 1e3 * (with.first.time - kAttach),
              with.first.payload.mean[0]);
  std::printf("event over           %6.0f ms after the attachment\n", 1e3 * (with.over.time - kAttach));
  std::printf("a tick takes         %6.1f us on average, %.0f us at most\n", 1e6 * with.mean_time,
              1e6 * with.longest_time);
  std::printf("\nposition error             before    at worst   %.0f s after\n", kLater);
  for (const auto& [name, run] :
       {std::pair("with compensation   ", &with), std::pair("without compensation", &without)})
    std::printf("  %s mm %7.1f     %7.1f    %7.1f\n", name, 1e3 * run->error_at(kAttach), 1e3 * run->worst_error(),
                1e3 * run->error_at(kAttach + kLater));
}

int run(Arguments& arguments) {
  const Options options = parse(arguments);
  const Run with = simulate(options, true), without = simulate(options, false);
  if (options.output) {
    make_folder("--output", *options.output);
    const std::filesystem::path folder = *options.output;
    write_csv(folder / "compensated.csv", with, options.payload);
    write_csv(folder / "uncompensated.csv", without, options.payload);
  }
  if (with.over.event.number == 0) {
    std::fprintf(stderr, "the payload was not noticed: it changes the external torque by too little\n");
    return 1;
  }
  print(options, with, without);
  return with.error_at(kAttach + kLater) < without.error_at(kAttach + kLater) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_01_static_payload", kUsage, argc, argv, run);
}
