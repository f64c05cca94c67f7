// touch: a collision-sensitive arm that carries 2 kg and stops at a touch of 5 N. Who notices the touch, and when?
//
// A Panda (carrying_arm.hpp) picks up 2 kg that it knows nothing of, and moves along a sine path at 0.5 Hz. Then something
// pushes its tip, in a random direction at a random phase of the path: the force grows within 0.1 s and stays for a period
// of the path. When the touch is noticed, the target stops where it is. The same touches happen to three arms, which
// notice them in three ways:
//
//   raw     the external torque of a joint is above the joint's threshold, as in a robot's own collision detection
//   static  the same, without the gravity torque of the payload that rme has estimated
//   rme     rme::ContactState::contact
//
// The thresholds of the first two are as low as they can be: the largest torques on the same path, until it repeats after
// 200 s, without a touch. That of rme follows from its rate of false alarms. Prints how many touches each has noticed,
// when, and at what force; with --output DIR writes the seconds about the first touch as CSV (plot.py draws them).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <limits>
#include <memory>
#include <optional>
#include <random>
#include <rme/core/compensation.hpp>
#include <rme/estimator.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "carrying_arm.hpp"
#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Eigen::Vector3d;
using Joints = rme::JointVector<double, 7>;

constexpr double kPeriod = 1e-3;  // of the control loop [s]
constexpr double kMass = 2;       // [kg]
constexpr double kSettled = 10;   // nothing is counted before [s]
constexpr double kRepeats = 200;  // of the path: 100 turns of the position, 83 of the rotation [s]
constexpr double kGrow = 0.1;     // how long the force of a touch grows [s]
constexpr double kTouch = 2;      // how long a touch lasts: a period of the path [s]
constexpr double kResume = 1;     // after a stop, time until the arm has its speed again [s]
constexpr double kQuiet = 2;      // after a touch, time from which an alarm is a false one [s]
constexpr double kShown = 3;      // before and after the first touch, what --output writes [s]

constexpr const char* kUsage = R"(usage: rme_touch [options]

Prints how soon a touch of an arm that carries 2 kg is noticed: by thresholds of the external torque, by thresholds of
what the estimated payload's gravity leaves of it, and by rme.

  --touches N     how many, each in a random direction (default 36)
  --force F       of a touch, after 0.1 s [N], above 0 (default 5)
  --seed N        of everything random (default 1)
  --physics NAME  synthetic (default), or mujoco if this was built with it
  --output DIR    write touch.csv there: the seconds about the first touch; the folder is made if need be
  --help          this text

Exit codes: 0 done; 1 rme has not noticed a touch; 2 unusable arguments.
)";

struct Options {
  std::size_t touches = 36;
  double force = 5;  // [N]
  CarryingArm arm;
  std::optional<std::string> output;
};

enum class Detector { Raw, Static, Rme };

struct Touch {
  double at;           ///< where on the path, as time along it [s]
  Vector3d direction;  ///< world axes
};

std::vector<Touch> draw_touches(const Options& options) {
  std::mt19937_64 random(options.arm.seed * 1013 + 7);
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> phase(0, 1 / CarryingArm::kFrequency);
  std::vector<Touch> touches;
  double from = 2 * kSettled;
  for (std::size_t i = 0; i < options.touches; ++i) {
    const double at = from + phase(random);
    touches.push_back({at, Vector3d{normal(random), normal(random), normal(random)}.normalized()});
    from = at + kTouch + kQuiet + 1;
  }
  return touches;
}

/// Where the target is on its path: it stops at once, and sets off slowly.
class Progress {
 public:
  double along() const { return along_; }  ///< time along the path [s]
  double rate() const { return rate_; }    ///< 1 is the path's own speed
  void stop() { goes_ = false, rate_ = 0; }
  void resume() { goes_ = true; }
  void step() {
    along_ += rate_ * kPeriod;
    if (goes_) rate_ = std::min(1.0, rate_ + kPeriod / kResume);
  }

 private:
  double along_ = 0, rate_ = 1;
  bool goes_ = true;
};

/// The arm, its controller and the estimator, tick by tick: sense(), then step().
class Carrier {
 public:
  explicit Carrier(const Options& options) : arm_(panda(), options.arm.faults(), panda().ready) {}

  /// @param along  time along the path [s]
  /// @param rate   1 is the path's own speed
  void sense(double along, double rate) {
    if (!attached_ && time() > CarryingArm::kAttach) attached_ = arm_.attach(CarryingArm::payload(kMass)) > 0;
    PoseTarget target = CarryingArm::path(home_, along);
    target.velocity *= rate;
    target.angular_velocity *= rate;
    controller_.follow(target);
    const auto& [position, rotation, jacobian] = arm_.kinematics();
    const rme::Status status = estimator_->update({arm_.tau_ext(), jacobian, rotation, arm_.dq()});
    if (status != rme::Status::Ok) throw std::runtime_error(to_string(status));
  }
  /// @param force  at the tip [N]
  void step(const Vector3d& force) {
    const auto& [position, rotation, jacobian] = arm_.kinematics();
    arm_.push({force, Vector3d::Zero()});
    arm_.step(controller_.torque(arm_.q(), arm_.dq(), arm_.kinematics(), arm_.dynamics()) +
              estimator_->compensation(jacobian, rotation));
  }

  double time() const { return arm_.time(); }                                                    ///< [s]
  double speed() const { return (arm_.kinematics().jacobian.topRows<3>() * arm_.dq()).norm(); }  ///< of the tip [m/s]
  const rme::ContactState<double, 7>& contact() const { return estimator_->contact(); }
  /// What a detector compares with its thresholds [N m].
  Joints torque(Detector detector) const {
    if (detector == Detector::Raw) return arm_.tau_ext();
    // The torque that carries the payload is the opposite of the one that it makes.
    const auto& [position, rotation, jacobian] = arm_.kinematics();
    return arm_.tau_ext() + compensation_torque(estimator_->state().payload.payload(), jacobian, rotation);
  }

 private:
  SyntheticArm<7> arm_;
  PoseImpedance<7> controller_ = CarryingArm::controller();
  Kinematics<7> home_ = panda().kinematics(panda().ready);
  std::unique_ptr<rme::Estimator<double, 7>> estimator_ = std::make_unique<rme::Estimator<double, 7>>(kPeriod);
  bool attached_ = false;
};

/// Of each joint [N m], by detector; that of rme is a mean, and for information only.
using Thresholds = std::array<Joints, 3>;

/// From a run without a touch.
Thresholds learn_thresholds(const Options& options) {
  Thresholds thresholds = {Joints::Zero(), Joints::Zero(), Joints::Zero()};
  Carrier carrier(options);
  while (carrier.time() < kSettled + kRepeats) {
    carrier.sense(carrier.time(), 1);
    if (carrier.time() >= kSettled) {
      for (const Detector detector : {Detector::Raw, Detector::Static}) {
        Joints& largest = thresholds[static_cast<std::size_t>(detector)];
        largest = largest.cwiseMax(carrier.torque(detector).cwiseAbs());
      }
      thresholds[2] += carrier.contact().threshold * kPeriod / kRepeats;
    }
    carrier.step(Vector3d::Zero());
  }
  return thresholds;
}

/// What a detector makes of one tick.
struct Reading {
  double level;  ///< 1 at its threshold
  bool contact;
};

Reading read(const Carrier& carrier, Detector detector, const Thresholds& thresholds) {
  const auto& contact = carrier.contact();
  if (detector == Detector::Rme) return {std::sqrt(contact.statistic), contact.contact};  // the statistic is a square
  const Joints& threshold = thresholds[static_cast<std::size_t>(detector)];
  const double level = carrier.torque(detector).cwiseAbs().cwiseQuotient(threshold).maxCoeff();
  return {level, level > 1};
}

/// A tick of those that --output writes.
struct Row {
  double since, level, force, speed;  ///< since the first touch [s]; the detector's; of the touch [N]; of the tip [m/s]
};

struct Result {
  std::vector<double> delay, force;  ///< of each touch, when it was noticed [ms], [N]; infinite if it was not
  int false_alarms = 0;
  double watched = 0;     ///< time in which they could have happened [s]
  std::vector<Row> rows;  ///< about the first touch

  int noticed() const {
    return static_cast<int>(std::count_if(delay.begin(), delay.end(), [](double d) { return std::isfinite(d); }));
  }
};

/// Of a row of the table: a number, or a dash if more than half of the touches were not noticed.
std::string median(std::vector<double> values, const char* format) {
  const auto middle = values.begin() + static_cast<long>(values.size() / 2);
  std::nth_element(values.begin(), middle, values.end());
  if (!std::isfinite(*middle)) return "-";
  std::array<char, 32> text;
  std::snprintf(text.data(), text.size(), format, *middle);
  return text.data();
}

/// An arm that stops when `detector` notices a touch.
Result run_arm(const Options& options, const std::vector<Touch>& touches, Detector detector,
               const Thresholds& thresholds) {
  constexpr double kNever = std::numeric_limits<double>::infinity();
  Carrier carrier(options);
  Progress progress;
  Result result;
  bool touched = false, noticed = false, alarm = false;
  double first = 0, began = 0, released = 0;  // begin of the first touch, begin and end of the last one [s]
  while (result.delay.size() < touches.size() || touched || carrier.time() < released + kShown) {
    const double t = carrier.time();
    carrier.sense(progress.along(), progress.rate());
    const Reading reading = read(carrier, detector, thresholds);
    const std::size_t next = result.delay.size();
    if (!touched && next < touches.size() && progress.along() >= touches[next].at && !reading.contact) {
      touched = true;
      noticed = false;
      began = t;
      if (next == 0) first = t;
      result.delay.push_back(kNever);
      result.force.push_back(kNever);
    }
    const double force = touched ? options.force * std::min(1.0, (t - began) / kGrow) : 0;  // [N]
    if (touched && !noticed && reading.contact) {
      noticed = true;
      result.delay.back() = 1e3 * (t - began);
      result.force.back() = force;
      progress.stop();
    }
    if (!touched && t > std::max(kSettled, released + kQuiet)) {
      result.watched += kPeriod;
      result.false_alarms += reading.contact && !alarm ? 1 : 0;
    }
    alarm = reading.contact;
    if (progress.along() >= touches[0].at - kShown && (result.delay.empty() || t - first < kShown))
      result.rows.push_back({t, reading.level, force, carrier.speed()});
    carrier.step(touched ? Vector3d(force * touches[result.delay.size() - 1].direction) : Vector3d::Zero());
    progress.step();
    if (touched && t - began > kTouch) {
      touched = false;
      released = t;
      progress.resume();
    }
  }
  for (Row& row : result.rows) row.since -= first;
  return result;
}

void write_csv(const std::string& folder, const std::array<Result, 3>& results) {
  make_folder("--output", folder);
  const std::filesystem::path path = std::filesystem::path(folder) / "touch.csv";
  std::ofstream file(path);
  file.precision(9);
  file << "t,force,raw,static,rme,raw_speed,static_speed,rme_speed\n";
  // A detector that raises a false alarm at that moment is touched a little later than the others.
  const std::size_t rows = std::min({results[0].rows.size(), results[1].rows.size(), results[2].rows.size()});
  for (std::size_t i = 0; i < rows; ++i) {
    const Row &raw = results[0].rows[i], &fixed = results[1].rows[i], &rme = results[2].rows[i];
    file << rme.since << ',' << rme.force << ',' << raw.level << ',' << fixed.level << ',' << rme.level << ','
         << raw.speed << ',' << fixed.speed << ',' << rme.speed << '\n';
  }
  if (!file.flush()) throw ArgumentError("--output: cannot write " + path.string());
}

int run(Arguments& arguments) {
  Options options;
  options.touches = arguments.whole("--touches", 1, 100000).value_or(36);
  options.force = arguments.number("--force").value_or(5);
  options.arm.seed = arguments.whole("--seed", 0).value_or(1);
  options.arm.engine = parse_engine(arguments);
  options.output = arguments.text("--output");
  arguments.finish();
  if (!(options.force > 0)) throw ArgumentError("--force: must be above 0");

  const std::vector<Touch> touches = draw_touches(options);
  const Thresholds thresholds = learn_thresholds(options);
  const std::array<Result, 3> results = {run_arm(options, touches, Detector::Raw, thresholds),
                                         run_arm(options, touches, Detector::Static, thresholds),
                                         run_arm(options, touches, Detector::Rme, thresholds)};
  if (options.output) write_csv(*options.output, results);

  std::printf("%g kg in motion, %zu touches of %g N, seed %zu.\n\n", kMass, options.touches, options.force,
              static_cast<std::size_t>(options.arm.seed));
  std::printf("| detector            | threshold [N m] | noticed | median [ms] | force then [N] | false alarms |\n");
  std::printf("|---------------------|----------------:|--------:|------------:|---------------:|-------------:|\n");
  constexpr std::array<const char*, 3> kNames = {"raw", "static compensation", "rme"};
  for (std::size_t i = 0; i < results.size(); ++i) {
    const Result& r = results[i];
    std::printf("| %-19s | %15.3f | %3d of %-2zu | %11s | %14s | %2d in %3.0f s |\n", kNames[i],
                thresholds[i].maxCoeff(), r.noticed(), options.touches, median(r.delay, "%.0f").c_str(),
                median(r.force, "%.1f").c_str(), r.false_alarms, r.watched);
  }
  std::printf(
      "\nThe threshold is that of the least sensitive joint. Time and force count a touch that was not noticed as\n"
      "infinite.\n");
  return results[2].noticed() == static_cast<int>(options.touches) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_touch", kUsage, argc, argv, run);
}
