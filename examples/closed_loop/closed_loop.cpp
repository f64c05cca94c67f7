// closed_loop: the estimator's compensation moves the arm, and this motion is part of the estimator's input. How large
// is the error of the flange's position?
//
// A Panda follows a path under a Cartesian impedance of 200 N/m whose model does not include payloads. An object is
// attached to its flange at 1 s, moved and turned from 4 s to 7 s, and dropped at 8 s, all unannounced. Prints the
// distance of the flange from a run without payload: without compensation, with that of rme, and with that of a host
// that always knows the payload. Then prints, for rme's compensation, the distances after drops of other payloads, at
// rest and in the middle of the move.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <rme/core/compensation.hpp>
#include <rme/estimator.hpp>
#include <stdexcept>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <vector>

#include "paper/experiment/report.hpp"
#include "paper/experiment/setup.hpp"

namespace {

using namespace rme::examples;
using Vector = rme::JointVector<double, 7>;

constexpr double kAttach = 1, kMove = 4, kArrive = 7, kDrop = 8, kEnd = 10;  // [s]
constexpr double kDropInMotion = (kMove + kArrive) / 2;                      // [s]
constexpr double kTurn = 40 * kPi / 180;                                     // [rad]
constexpr double kStiffness = 200;                                           // of the impedance [N/m]
constexpr double kNear = 0.01;                                               // the flange is back within this [m]

constexpr const char* kUsage = R"(usage: rme_closed_loop [options]

Prints how far an unknown payload takes the flange of a Panda from where it would be without, from the attachment to the
drop: without compensation, with the estimator's, and with that of somebody who knows.

  --runs N          with other noise, another centre of mass, another axis to turn about (default 20)
  --mass KG         of the payload of the first table, above 0 to 3 (default 1.2)
  --dq-noise W      white noise on the joint velocity that the host sees [rad/s] (default 0.002)
  --noisy-observer  tau_ext is observed from that velocity too
)";
// The options of Setup follow. But here the default of --physics is MuJoCo, if it was found.

struct Options {
  Setup setup;
  std::size_t runs = 20;
  double mass = 1.2;       // [kg]
  double dq_noise = 2e-3;  // [rad/s]
  bool noisy_observer = false;
};

Options parse(Arguments& arguments) {
  Options options;
  options.setup = Setup::parse(arguments, independent_engine());
  options.runs = arguments.whole("--runs", 1, 1000).value_or(options.setup.quick ? 2 : 20);
  options.mass = arguments.number("--mass").value_or(1.2);
  options.dq_noise = arguments.number("--dq-noise").value_or(2e-3);
  options.noisy_observer = arguments.flag("--noisy-observer");
  arguments.finish();
  if (!(options.mass > 0 && options.mass <= 3)) throw ArgumentError("--mass: must be above 0 and at most 3 kg");
  if (!(options.dq_noise >= 0 && options.dq_noise < 1)) throw ArgumentError("--dq-noise: must be from 0 to below 1");
  return options;
}

/// What is random in a run: the arm's faults, the payload's centre of mass, the axis about which the hand turns.
struct Draw {
  SyntheticArmConfig<7> arm;
  Eigen::Vector3d com;   // flange axes [m]
  Eigen::Vector3d axis;  // horizontal, world axes
};

Draw draw(const Options& options, std::size_t run) {
  Draw out;
  out.arm = options.setup.arm(run);
  out.arm.torque_noise.setConstant(0.05);
  out.arm.dq_noise.setConstant(options.dq_noise);
  out.arm.noisy_observer = options.noisy_observer;
  std::mt19937_64 random(options.setup.seed * 1000003 + run);
  const auto uniform = [&](double low, double high) { return std::uniform_real_distribution(low, high)(random); };
  const double x = uniform(-0.05, 0.05), y = uniform(-0.05, 0.05), z = uniform(0.03, 0.15), angle = uniform(-kPi, kPi);
  out.com = {x, y, z};
  out.axis = {std::cos(angle), std::sin(angle), 0};
  return out;
}

/// The desired pose of the flange: at rest until kMove; from kArrive on, at rest 16 cm away and turned by kTurn.
PoseTarget path(const PoseTarget& home, const Eigen::Vector3d& axis, double t) {
  const double x = std::clamp((t - kMove) / (kArrive - kMove), 0.0, 1.0), rest = x * (1 - x);
  const double share = x * x * x * (10 + x * (6 * x - 15)), rate = 30 * rest * rest / (kArrive - kMove);
  const Eigen::Vector3d way(0.08, 0.12, 0.06);
  return {home.position + share * way, Eigen::AngleAxisd(share * kTurn, axis) * home.rotation, rate * way,
          rate * kTurn * axis};
}

PoseImpedanceConfig impedance() {
  PoseImpedanceConfig config;
  config.rate = 4;
  config.lambda1 = config.lambda2 = kStiffness / config.rate;
  return config;
}

/// What a host adds to its loop: the only place here that knows the estimator.
class Compensator {
 public:
  Vector update(const SyntheticArm<7>& arm) {
    const auto& [position, rotation, jacobian] = arm.kinematics();
    const rme::Status status = estimator_.update({arm.tau_ext(), jacobian, rotation, arm.dq()});
    if (status != rme::Status::Ok) throw std::runtime_error(rme::to_string(status));
    return estimator_.compensation(jacobian, rotation);
  }
  double mass() const { return estimator_.state().payload.mean[0]; }  // [kg]

 private:
  rme::Estimator<double, 7> estimator_{kPeriod};
};

enum class Knowledge { None, Estimated, Perfect };

struct Course {
  std::vector<Eigen::Vector3d> position;  // of the flange at each tick, world axes [m]
  std::vector<double> mass;               // the estimate [kg]
};

/// Runs ten seconds.
/// @param payload    with zero mass for an empty hand
/// @param drop       when it is dropped [s]
/// @param knowledge  source of the compensation
Course run_arm(const Draw& draw, const RigidBody& payload, double drop, Knowledge knowledge) {
  SyntheticArm<7> arm(panda(), draw.arm, panda().ready);
  PoseImpedance<7> law(panda(), panda().ready, impedance());
  const PoseTarget home{arm.kinematics().position, arm.kinematics().rotation};
  Compensator compensator;
  rme::CompensationRamp<double, 7> ramp(kPeriod);
  const auto tick = [](double t) { return std::lround(t / kPeriod); };

  Course course;
  int handle = 0;
  for (long k = 0; k <= tick(kEnd); ++k) {
    if (k == tick(kAttach) && payload.mass > 0) handle = arm.attach(payload);
    if (k == tick(drop)) arm.detach(handle);
    const auto& [position, rotation, jacobian] = arm.kinematics();
    Vector compensation = Vector::Zero();
    if (knowledge == Knowledge::Estimated) compensation = compensator.update(arm);
    if (knowledge == Knowledge::Perfect) {
      const RigidBody held = arm.payload();
      compensation = rme::compensation_torque<double>({held.mass, held.com}, jacobian, rotation);
    }
    if (ramp.update(compensation) != rme::Status::Ok) throw std::runtime_error("the compensation is not finite");
    course.position.push_back(position);
    course.mass.push_back(compensator.mass());
    law.follow(path(home, draw.axis, arm.time()));
    // The input of the arm's observer is this command, compensation included.
    arm.step(law.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()) + ramp.torque());
  }
  return course;
}

/// The largest distance between the courses from one instant until before another [m].
double furthest(const Course& course, const Course& empty, double from, double until) {
  double most = 0;
  const auto end = static_cast<std::size_t>(std::lround(until / kPeriod));
  for (auto k = static_cast<std::size_t>(std::lround(from / kPeriod)); k < end; ++k)
    most = std::max(most, (course.position[k] - empty.position[k]).norm());
  return most;
}

/// Time from an instant until the distance stays below kNear [s].
double back_after(const Course& course, const Course& empty, double from) {
  std::size_t k = course.position.size();
  while (k > 0 && (course.position[k - 1] - empty.position[k - 1]).norm() < kNear) --k;
  return std::max(0.0, static_cast<double>(k) * kPeriod - from);
}

std::string median_and_worst(std::vector<double> values, double unit, const char* format) {
  std::sort(values.begin(), values.end());
  const std::size_t n = values.size();
  return text(format, unit * (values[(n - 1) / 2] + values[n / 2]) / 2, unit * values.back());
}

/// The distances of all runs, for one row of the first table.
struct Distances {
  std::vector<double> attach, sagging, moving, dropped;  // [m]
};

void measure(const Course& course, const Course& empty, Distances& out) {
  out.attach.push_back(furthest(course, empty, kAttach, kMove));
  out.sagging.push_back(furthest(course, empty, kMove - 0.1, kMove));
  out.moving.push_back(furthest(course, empty, kMove, kArrive));
  out.dropped.push_back(furthest(course, empty, kDrop, kEnd));
}

void write_course(const Options& options, const Course& empty, const std::vector<Course>& courses) {
  CsvFile file(options.setup.output, "closed_loop.csv", "t,without,estimated,known,estimated_mass");
  for (std::size_t k = 0; k < empty.position.size(); ++k) {
    const auto distance = [&](std::size_t i) { return (courses[i].position[k] - empty.position[k]).norm(); };
    file.row(static_cast<double>(k) * kPeriod, distance(0), distance(1), distance(2), courses[1].mass[k]);
  }
}

RigidBody payload_of(const Draw& draw, double mass) {
  return box(mass, draw.com, {0.08, 0.08, 0.1});
}

/// The run of each draw with an empty hand.
std::vector<Course> empty_courses(const std::vector<Draw>& draws) {
  std::vector<Course> out;
  for (const Draw& d : draws) {
    out.push_back(run_arm(d, {}, kDrop, Knowledge::None));
    progress("empty hand", out.size(), draws.size());
  }
  return out;
}

/// @return worst distance in the move with the estimator's compensation, divided by that without compensation
double print_table(const Options& options, const std::vector<Draw>& draws, const std::vector<Course>& empty) {
  std::array<Distances, 4> rows;  // without, estimated, known; nothing in the hand, estimated
  for (std::size_t i = 0; i < draws.size(); ++i) {
    const RigidBody payload = payload_of(draws[i], options.mass);
    std::vector<Course> courses;
    for (const Knowledge knowledge : {Knowledge::None, Knowledge::Estimated, Knowledge::Perfect})
      courses.push_back(run_arm(draws[i], payload, kDrop, knowledge));
    if (i == 0) write_course(options, empty[i], courses);
    courses.push_back(run_arm(draws[i], {}, kDrop, Knowledge::Estimated));
    for (std::size_t r = 0; r < rows.size(); ++r) measure(courses[r], empty[i], rows[r]);
    progress("payload", i + 1, draws.size());
  }
  std::printf("Distance from the run without payload [mm], median / worst of %zu runs.\n\n", draws.size());
  MarkdownTable table({"compensation", "payload", "peak after the attachment", "3 s after it", "peak in the move",
                       "peak after the drop"});
  const std::array<const char*, 4> names = {"none", "estimated", "true payload", "estimated"};
  for (std::size_t r = 0; r < rows.size(); ++r) {
    std::vector<std::string> cells = {names[r], r < 3 ? text("%.2f kg", options.mass) : "nothing"};
    for (const auto& values : {rows[r].attach, rows[r].sagging, rows[r].moving, rows[r].dropped})
      cells.push_back(median_and_worst(values, 1e3, "%.1f / %.1f"));
    table.row(cells);
  }
  table.print();
  const auto worst = [](const std::vector<double>& values) { return *std::max_element(values.begin(), values.end()); };
  return worst(rows[1].moving) / worst(rows[0].moving);
}

void print_drops(const std::vector<Draw>& draws, const std::vector<Course>& empty) {
  const std::vector<double> masses = {0.5, 1.0, 1.5, 2.0};
  std::printf(
      "Drops, compensation estimated: largest distance after the drop, and the time until it stays below %.0f mm; "
      "median / worst.\n\n",
      1e3 * kNear);
  MarkdownTable table({"dropped", "at rest: peak [mm]", "back after [s]", "in the move: peak [mm]", "back after [s]"});
  std::size_t done = 0;
  for (const double mass : masses) {
    std::vector<std::string> cells = {text("%.1f kg", mass)};
    for (const double drop : {kDrop, kDropInMotion}) {
      std::vector<double> peak, back;
      for (std::size_t i = 0; i < draws.size(); ++i) {
        const Course course = run_arm(draws[i], payload_of(draws[i], mass), drop, Knowledge::Estimated);
        peak.push_back(furthest(course, empty[i], drop, kEnd));
        back.push_back(back_after(course, empty[i], drop));
      }
      cells.push_back(median_and_worst(peak, 1e3, "%.1f / %.1f"));
      cells.push_back(median_and_worst(back, 1, "%.2f / %.2f"));
      progress("drops", ++done, 2 * masses.size());
    }
    table.row(cells);
  }
  table.print();
}

int run(Arguments& arguments) {
  const Options options = parse(arguments);
  std::printf("%s, impedance of %.0f N/m, noise of %g rad/s on dq%s and of 0.05 N m on the torque.\n\n",
              options.setup.name().c_str(), kStiffness, options.dq_noise,
              options.noisy_observer ? ", felt by the observer," : "");
  std::vector<Draw> draws;
  for (std::size_t i = 0; i < options.runs; ++i) draws.push_back(draw(options, i));
  const std::vector<Course> empty = empty_courses(draws);
  const double share = print_table(options, draws, empty);
  print_drops(draws, empty);
  return share < 0.5 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  const std::string usage = std::string(kUsage) + Setup::kUsage +
                            "\nExit codes: 0 the estimator halves the worst distance in the move; 1 it does not; 2 "
                            "unusable arguments; 3 any other failure.\n";
  return run_program("rme_closed_loop", usage, argc, argv, run);
}
