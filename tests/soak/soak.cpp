// soak: minutes or hours of simulated 1 kHz operation of one estimator, never reset.
//
// Objects come and go at random, one or two at a time, often within a second of each other; something is poured in or
// out; hands push; the arm moves between poses while all this happens; samples are spoilt, lost, frozen and wild.
//
// With --hard the arm is as arms are: torques have gain errors, a tool is not the one that the robot's model has, the base
// is tilted, dq is noisy, and all noise jumps. Objects are also taken up little by little, single joints are jolted, and the
// arm rests for ten minutes at a time. Then hardly any change may be missed (kHard).
// --friction adds joint friction to tau_ext; at rest, it stays as it was when the joint stopped.
// Nothing is asked while something changes and in the half second after that. Then what is believed to be in the hand
// has to be what is there. Ends with 0 if
//  - it never was further off than 0.1 kg and four of its own deviations for 0.2 s: not after an attachment, a removal,
//    a pour or a move; after pushes and faults hardly ever (kExcused, and two deviations of such a count). A payload in
//    an empty hand, and one that was believed to be there when it had gone, are counted apart, and there may be none
//    but for pushes and faults;
//  - hardly any push was carried as payload for more than 0.2 s while it lasted (kTaken);
//  - what is poured is followed to kLag;
//  - every compensation torque was finite;
//  - the same event without noise, repeated all along, gives the same estimate to kDrift: nothing has accumulated;
//  - the estimator has allocated nothing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>
#include <rme/estimator.hpp>

#include "io/program.hpp"
#include "support/allocation_count.hpp"
#include "support/held_arm.hpp"

namespace {

using rme::Payload;
using rme::examples::ArgumentError;
using rme::examples::Arguments;
using rme::testing::HeldArm;

constexpr const char* kUsage =
    R"(usage: soak [options]

  --minutes M   of simulated operation (default 10)
  --seed N      of everything random (default 1)
  --hard        gain errors, a wrong tool, a tilted base, noise that jumps, jolts, slow take-ups, long rests
  --friction    tau_ext contains joint friction
  --help        this text

Exit codes: 0 all is as it should be; 1 not; 2 unusable arguments.
)";
using Estimator = rme::Estimator<double, 7>;
using Tick = rme::Proprioception<double, 7>;

constexpr double kWrong = 0.1;      // of a belief that is to count as a wrong one, at least [kg]
constexpr double kSure = 4;         // and more than so many of its own deviations
constexpr double kBriefly = 0.2;    // for which it may be [s]
constexpr double kUnsettled = 0.5;  // after a change, before anything is asked [s]
constexpr double kAfterFault = 2;   // for which a fault is an excuse [s]
constexpr double kExcused = 0.01;   // share of the pushes, and of the faults, that may do harm
constexpr double kTaken = 0.02;  // share of the pushes that may be carried while they last: some are what a payload is
constexpr double kLag = 0.15;    // behind what is poured [kg]
constexpr double kDrift = 0.01;  // of the event without noise [kg]
// With --hard.
constexpr double kHard = 0.005;       // share of what happens after which the belief may be wrong
constexpr double kGain = 0.02;        // standard deviation of a joint's gain error
constexpr double kTool = 0.2;         // of the tool's mass error [kg], at
constexpr double kToolArm = 0.05;     // from the flange [m]
constexpr double kTilt = 0.05;        // of the base [rad]
constexpr double kSpeedNoise = 1e-3;  // of dq [rad/s]
constexpr double kJump = 60;          // mean time between two jumps of the noise [s]
constexpr double kHardestJolt = 5;    // [N m]
constexpr double kLongRest = 600;     // [s]

/// What was going on last.
enum Cause : std::size_t { kAttach, kTakeUp, kRemoval, kPour, kMove, kRest, kPush, kJolt, kFault, kCauses };
constexpr std::array<const char*, kCauses> kCauseNames = {"attachment", "take-up", "removal", "pour", "move",
                                                          "rest",       "push",    "jolt",    "fault"};
/// How the arm is.
struct Options {
  bool hard = false, friction = false;
};

/// Two things in one hand.
Payload<double> together(const Payload<double>& a, const Payload<double>& b) {
  const double mass = a.mass + b.mass;
  if (mass == 0) return {};
  return {mass, (a.mass * a.com + b.mass * b.com) / mass};
}

/// What has happened so far.
struct Counts {
  long ticks = 0, bad_torques = 0;
  std::array<long, kCauses> happened{}, wrong{};  // and what was believed afterwards was wrong
  long ghosts = 0;                                // of those, a payload in an empty hand; not after pushes and faults
  long carried = 0;                               // pushes carried as payload while they lasted
  double lag = 0;                                 // largest [kg]
  double mass_error = 0;                          // sum over the ticks at which something was asked [kg]
  long asked = 0;
};

class Soak {
 public:
  Soak(std::uint64_t seed, const Options& options)
      : options_(options), arm_(seed), random_(seed + 1), estimator_(HeldArm::kPeriod) {
    if (!options.hard) return;
    Vector gain;
    for (int j = 0; j < 7; ++j) gain[j] = 1 + kGain * normal_(random_);
    arm_.set_gain(gain);
    tool_ = {uniform(0, 1) < 0.5 ? kTool : -kTool, {0, 0, kToolArm}};
    const double about = uniform(0, 2 * 3.14159265358979);
    gravity_ = Eigen::AngleAxisd(kTilt, Eigen::Vector3d(std::cos(about), std::sin(about), 0)) * gravity_;
    arm_.set_gravity(gravity_);
    hold({});
    estimator_.tare();
    move(rme::examples::panda().ready.array() + 0.3, 3);
    since_ = 0;
    run(3, false);
    move(rme::examples::panda().ready, 3);
    run(4, false);
  }

  /// Random operation; ends with an empty hand in the ready pose.
  void operate(double seconds) {
    const long end = counts.ticks + static_cast<long>(seconds / HeldArm::kPeriod);
    while (counts.ticks < end) happen();
    while (things_ > 0) take_away(1);
    move(rme::examples::panda().ready, 2);
    run(3);
  }

  /// The event that is always the same: after the same move, 1.1 kg comes and goes, without noise.
  /// @return the mass that is believed in, 0 if it was not seen for what it is
  double reference() {
    faulty_ = false;
    arm_.set_noise(0);
    const rme::JointVector<double, 7> ready = arm_.pose();
    move(ready.array() - 0.1, 1);
    run(1);
    move(ready, 1);
    run(3);
    const bool empty = estimator_.state().empty();
    set({1.1, {0.05, 0.02, 0.13}}, kAttach);
    run(2);
    const double mass = estimator_.state().payload.mean[0];
    set({}, kRemoval);
    run(2);
    arm_.set_noise(1);
    faulty_ = true;
    return empty && estimator_.state().empty() ? mass : 0;
  }

  Counts counts;

 private:
  using Vector = rme::JointVector<double, 7>;
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }
  /// In a cube of twice this size.
  Eigen::Vector3d anywhere(double size) {
    const double z = uniform(-size, size), y = uniform(-size, size), x = uniform(-size, size);
    return {x, y, z};
  }
  /// Until the next thing happens: half of the time less than a second.
  double pause() { return uniform(0, 1) < 0.5 ? uniform(0, 1) : uniform(1, 4); }

  /// One thing, and a pause.
  void happen() {
    const double what = uniform(0, 1);
    if (what < 0.2) {
      push();
    } else if (what < 0.35) {
      rme::JointVector<double, 7> pose = rme::examples::panda().ready;
      for (int j = 0; j < 7; ++j) pose[j] += uniform(-0.4, 0.4);
      move(pose, uniform(1.5, 3));
      run(uniform(0, 1) < 0.5 ? uniform(0, 2) : uniform(4, 6));  // the next thing happens on the way, or afterwards
    } else if (what < 0.42 && things_ > 0) {
      pour();
    } else if (options_.hard && what < 0.5) {
      uniform(0, 1) < 0.01 ? rest() : jolt();
    } else if (things_ < 2 && (things_ == 0 || what < 0.75)) {
      const Payload<double> thing = {uniform(0.3, 1.5),
                                     {uniform(-0.05, 0.05), uniform(-0.05, 0.05), uniform(0.05, 0.15)}};
      if (options_.hard && uniform(0, 1) < 0.3) {
        take_up(thing);
        return;
      }
      hand_[things_++] = thing;
      set(together(hand_[0], hand_[1]), kAttach);
      run(pause());
    } else {
      take_away(pause());
    }
  }

  void take_away(double seconds) {
    if (things_ == 2 && uniform(0, 1) < 0.5) std::swap(hand_[0], hand_[1]);
    hand_[--things_] = {};
    set(together(hand_[0], hand_[1]), kRemoval);
    run(seconds);
  }

  /// Little by little.
  void take_up(const Payload<double>& thing) {
    const double seconds = uniform(0.3, 3);
    Payload<double>& held = hand_[things_++];
    held = thing;
    ++counts.happened[kTakeUp];
    if (since_ > kUnsettled || cause_ < kPush) cause_ = kTakeUp;
    for (double t = 0.01; t < seconds; t += 0.01) {
      held.mass = thing.mass * t / seconds;
      hold(together(hand_[0], hand_[1]));
      since_ = 0;
      run(0.01);
    }
    held.mass = thing.mass;
    hold(together(hand_[0], hand_[1]));
    since_ = 0;
    run(pause());
  }

  void jolt() {
    ++counts.happened[kJolt];
    const auto joint = static_cast<Eigen::Index>(random_() % 7);
    cause_ = kJolt;
    since_ = 0;
    jolt_[joint] = uniform(-kHardestJolt, kHardestJolt);
    run(uniform(0.002, 0.03));
    jolt_.setZero();
    since_ = 0;
    run(pause());
  }

  void rest() {
    ++counts.happened[kRest];
    run(5);
    cause_ = kRest;
    run(kLongRest);
  }

  /// Into the last thing, or out of it.
  void pour() {
    Payload<double>& thing = hand_[things_ - 1];
    const double from = thing.mass, to = std::max(0.2, std::min(1.5, from + uniform(-0.6, 0.6)));
    const double seconds = uniform(4, 10);
    ++counts.happened[kPour];
    cause_ = kPour;
    for (double t = 0; t < seconds; t += 0.01) {
      thing.mass = from + (to - from) * t / seconds;
      hold(together(hand_[0], hand_[1]));
      since_ = 0;
      run(0.01);
      const double wrong = std::abs(estimator_.state().payload.mean[0] - truth_.mass);
      if (t > kUnsettled && !disturbed()) counts.lag = std::max(counts.lag, wrong);
    }
    run(pause());
  }

  void push() {
    ++counts.happened[kPush];
    const double before = truth_.mass;
    const Eigen::Vector3d force = anywhere(15);
    arm_.push({force, anywhere(1.5)});
    double carried = 0, longest = 0;
    for (double t = uniform(0.2, 2.5); t > 0; t -= 0.01) {
      cause_ = kPush;
      since_ = 0;
      run(0.01);
      carried = std::abs(estimator_.state().payload.mean[0] - before) > kWrong ? carried + 0.01 : 0;
      longest = std::max(longest, carried);
    }
    counts.carried += longest > kBriefly ? 1 : 0;
    arm_.push({});
    run(pause());
  }

  void move(const rme::JointVector<double, 7>& pose, double seconds) {
    ++counts.happened[kMove];
    if (since_ > kUnsettled) cause_ = kMove;
    arm_.move(pose, seconds);
  }

  /// The hand holds something else from now on.
  void set(const Payload<double>& payload, Cause cause) {
    ++counts.happened[cause];
    // What follows so quickly on a push or a fault is judged as that.
    if (since_ > kUnsettled || cause_ < kPush) cause_ = cause;
    since_ = 0;
    hold(payload);
  }
  void hold(const Payload<double>& payload) {
    truth_ = payload;
    arm_.hold(together(payload, tool_));
  }

  bool disturbed() const { return static_cast<double>(counts.ticks - last_fault_) < kAfterFault / HeldArm::kPeriod; }

  void run(double seconds, bool ask = true) {
    for (long k = std::lround(seconds / HeldArm::kPeriod); k > 0; --k) {
      ++counts.ticks;
      since_ += HeldArm::kPeriod;
      Tick now = arm_.tick();
      if (options_.hard || options_.friction) roughen(now);
      if (deliver(now)) counts.bad_torques += !estimator_.compensation(now.jacobian, now.rotation).allFinite();
      if (ask) judge();
    }
  }

  /// Makes of this tick what a real arm would report, and sets the joint torque of the next one.
  void roughen(Tick& now) {
    const auto& model = rme::examples::panda();
    Vector torque = jolt_;
    if (options_.friction) {  // a joint that rests keeps the friction with which it has stopped
      for (int j = 0; j < 7; ++j) {
        if (std::abs(now.dq[j]) > 1e-4) direction_[j] = now.dq[j] > 0 ? 1 : -1;
        torque[j] -= model.typical_coulomb[j] * direction_[j] + model.typical_viscous[j] * now.dq[j];
      }
    }
    if (options_.hard) {
      if (arm_.moving() || gravity_torque_.isZero(0)) {
        for (int axis = 0; axis < 3; ++axis) {
          pulled_.gravity_vector = Eigen::Vector3d::Unit(axis);
          gravity_torque_.col(axis) = pulled_.dynamics(arm_.pose(), Vector::Zero()).gravity;
        }
      }
      now.gravity_torque = gravity_torque_;
      torque += gravity_torque_ * (model.gravity_vector - gravity_);  // the robot's model has an upright base
      if (faulty_) {
        for (int j = 0; j < 7; ++j) now.dq[j] += kSpeedNoise * noise_ * normal_(random_);
        if (uniform(0, kJump) < HeldArm::kPeriod) {
          noise_ = uniform(0.5, 3);
          arm_.set_noise(noise_);
        }
      }
    }
    arm_.set_joint_torque(torque);
  }

  void judge() {
    if (since_ < kUnsettled) {
      wrong_ = 0;
      return;
    }
    const auto& belief = estimator_.state().payload;
    const double error = std::abs(belief.mean[0] - truth_.mass);
    counts.mass_error += error;
    ++counts.asked;
    wrong_ = error > std::max(kWrong, kSure * belief.standard_deviation()[0]) ? wrong_ + 1 : 0;
    if (wrong_ != std::lround(kBriefly / HeldArm::kPeriod)) return;
    const Cause cause = disturbed() ? kFault : cause_;
    ++counts.wrong[cause];
    counts.ghosts += truth_.mass == 0 && cause != kPush && cause != kFault;
  }

  enum class Fault { NotANumber, Lost, Frozen, Wild, Mirror };

  /// Hands a tick to the estimator, or what a fault makes of it.
  /// @return whether the estimator took it
  bool deliver(const Tick& now) {
    if (faulty_ && fault_left_ == 0 && random_() % 20000 == 0) {
      fault_ = static_cast<Fault>(random_() % 5);
      fault_left_ = fault_ == Fault::Wild ? 1 : 1 + static_cast<int>(random_() % 50);
      frozen_ = now;
      ++counts.happened[kFault];
    }
    if (fault_left_ == 0) return estimator_.update(now) == rme::Status::Ok;
    --fault_left_;
    last_fault_ = counts.ticks;
    Tick spoilt = fault_ == Fault::Frozen ? frozen_ : now;
    if (fault_ == Fault::Lost) return false;
    if (fault_ == Fault::NotANumber) spoilt.tau_ext[3] = std::numeric_limits<double>::quiet_NaN();
    if (fault_ == Fault::Mirror) spoilt.rotation.col(0) *= -1;
    if (fault_ == Fault::Wild) spoilt.tau_ext *= 100;
    return estimator_.update(spoilt) == rme::Status::Ok;
  }

  Options options_;
  HeldArm arm_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  Estimator estimator_;
  Payload<double> hand_[2], truth_;
  Payload<double> tool_;  // that the robot's model lacks, or has too much of
  Eigen::Vector3d gravity_ = rme::examples::panda().gravity_vector;
  rme::examples::ArmModel<7> pulled_ = rme::examples::panda();  // along one axis
  Eigen::Matrix<double, 7, 3> gravity_torque_ =
      Eigen::Matrix<double, 7, 3>::Zero();  // per unit of gravity along each axis
  Vector jolt_ = Vector::Zero(), direction_ = Vector::Zero();
  double noise_ = 1;
  int things_ = 0;
  Cause cause_ = kMove;
  double since_ = 1;  // what was going on last [s]
  long wrong_ = 0;    // ticks for which the belief has been wrong
  bool faulty_ = true;
  Fault fault_ = Fault::Lost;
  int fault_left_ = 0;  // ticks
  long last_fault_ = -100000;
  Tick frozen_;
};

/// Resident memory [MB]; 0 where the system does not say.
double resident() {
  long pages = 0;
  if (std::FILE* file = std::fopen("/proc/self/statm", "r")) {
    if (std::fscanf(file, "%*d %ld", &pages) != 1) pages = 0;
    std::fclose(file);
  }
  return static_cast<double>(pages) * 4096 / 1e6;
}

int run(Arguments& arguments) {
  const double minutes = arguments.number("--minutes").value_or(10);
  const std::size_t seed = arguments.whole("--seed", 0).value_or(1);
  Options options;
  options.hard = arguments.flag("--hard");
  options.friction = arguments.flag("--friction");
  arguments.finish();
  if (!(minutes > 0)) throw ArgumentError("--minutes: must be above 0");
  std::printf("seed %zu; how often something happened, and what was believed afterwards was wrong\n%8s", seed,
              "minutes");
  for (const char* name : kCauseNames) std::printf(" %13s", name);
  std::printf(" %7s %8s %6s %8s %8s %6s %7s\n", "ghosts", "carried", "lag g", "error g", "drift g", "alloc", "RSS MB");
  Soak soak(seed, options);
  const int parts = std::max(2, static_cast<int>(std::lround(minutes / 60)));
  const double first = soak.reference();
  bool seen = first > 0;
  double drift = 0;
  int allocated = 0;
  for (int part = 1; part <= parts; ++part) {
#ifdef RME_COUNTS_ALLOCATIONS
    const int before = rme::testing::allocations();
#endif
    soak.operate(minutes * 60 / parts);
    const double now = soak.reference();
#ifdef RME_COUNTS_ALLOCATIONS
    allocated += rme::testing::allocations() - before;
#endif
    seen = seen && now > 0;
    drift = std::max(drift, std::abs(now - first));
    const Counts& c = soak.counts;
    std::printf("%8.1f", static_cast<double>(c.ticks) * HeldArm::kPeriod / 60);
    for (std::size_t i = 0; i < kCauses; ++i) std::printf(" %7ld %5ld", c.happened[i], c.wrong[i]);
    std::printf(" %7ld %8ld %6.1f %8.2f %8.2f %6d %7.2f\n", c.ghosts, c.carried, 1e3 * c.lag,
                1e3 * c.mass_error / static_cast<double>(c.asked), 1e3 * drift, allocated, resident());
    std::fflush(stdout);
  }
  const Counts& c = soak.counts;
  int failures = 0;
  const auto expect = [&failures](bool holds, const char* what) {
    if (!holds) std::printf("%s\n", what);
    failures += holds ? 0 : 1;
  };
  const auto at_most = [](long count, double share, long of) {  // to two deviations of the count
    const double expected = share * static_cast<double>(of);
    return static_cast<double>(count) <= std::ceil(expected + 2 * std::sqrt(expected));
  };
  const bool rough = options.hard || options.friction;
  const auto none = [&](Cause cause) { return at_most(c.wrong[cause], rough ? kHard : 0, c.happened[cause]); };
  expect(rough || c.ghosts == 0, "a payload was believed in that was not there");
  expect(none(kAttach), "attached objects were not found, or weighed wrongly");
  expect(none(kRemoval), "removals were not noticed");
  expect(none(kPour) && c.lag < kLag, "what was poured was not followed");
  expect(none(kTakeUp), "what was taken up little by little was not found, or weighed wrongly");
  expect(none(kMove), "motion was taken for a payload");
  expect(none(kRest), "a payload at rest was lost, or one was found");
  expect(at_most(c.wrong[kJolt], kExcused, c.happened[kJolt]), "jolts left something behind");
  expect(at_most(c.wrong[kPush], kExcused, c.happened[kPush]), "pushes left something behind");
  expect(at_most(c.carried, kTaken, c.happened[kPush]), "pushes were carried as payload");
  expect(at_most(c.wrong[kFault], kExcused, c.happened[kFault]), "faults did harm");
  expect(c.bad_torques == 0, "torques were not finite");
  expect(rough || seen, "the event without noise was not seen for what it is");
  expect(rough || drift <= kDrift, "the estimate of the event without noise has moved");
  expect(allocated == 0, "memory was allocated");
  return failures == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return rme::examples::run_program("soak", kUsage, argc, argv, run);
}
