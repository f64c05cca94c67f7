// soak: minutes or hours of simulated 1 kHz operation of one estimator, never reset.
//
// Objects come and go at random, one or two at a time; hands push; the arm moves between poses; samples are spoilt,
// lost, frozen and wild. Ends with 0 if
//  - every attach and removal that changes the joint torque by 1 N m or more was noticed, and at most one in a thousand
//    was taken for a push (kMissedByFault: the share that may be missed either way where a fault falls into it);
//  - every compensation torque was finite;
//  - the same noise-free event, repeated all along, gives the same estimate to 1e-9: nothing has accumulated;
//  - the estimator has allocated nothing.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstdio>
#include <limits>
#include <random>
#include <rme/event_estimator.hpp>

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
  --help        this text

Exit codes: 0 all is as it should be; 1 not; 2 unusable arguments.
)";
using Estimator = rme::EventEstimator<double, 7>;
using Tick = rme::Proprioception<double, 7>;
using Estimate = rme::Estimate<double>;

constexpr double kFair = 1.0;            // change of joint torque that may not be missed [N m]; the threshold is 0.7
constexpr double kMisjudged = 0.001;     // share of those noticed that may be taken for a push
constexpr double kMissedByFault = 0.01;  // share of the events into which a fault falls
constexpr double kDrift = 1e-9;          // of the noise-free event [kg, m], and of its covariance

/// Two things in one hand.
Payload<double> together(const Payload<double>& a, const Payload<double>& b) {
  const double mass = a.mass + b.mass;
  if (!(mass > 0)) return {};
  return {mass, (a.mass * a.com + b.mass * b.com) / mass};
}

/// What has happened so far.
struct Counts {
  long ticks = 0, bad_torques = 0;
  long events = 0, unnoticed = 0, misjudged = 0;      // attaches and removals of at least kFair
  long events_with_fault = 0, missed_with_fault = 0;  // those with a fault next to them
  long pushes = 0, moves = 0, faults = 0;
  long unasked = 0;  // final estimates that no attach or removal explains
  double mass_error = 0;
  long mass_errors = 0;
};

class Soak {
 public:
  explicit Soak(std::uint64_t seed) : arm_(seed), random_(seed + 1), estimator_(HeldArm::kPeriod) {}

  /// Random operation; ends with an empty hand in the ready pose.
  void operate(double seconds) {
    const long end = counts.ticks + static_cast<long>(seconds / HeldArm::kPeriod);
    while (counts.ticks < end) happen();
    while (things_ > 0) take_away();
    arm_.move(rme::examples::panda().ready, 2);
    run(3);
  }

  /// The event that is always the same: after the same move, which friction would remember, 1.1 kg comes and goes,
  /// without noise.
  /// @return false if it was not seen for what it is
  bool reference(Estimate& estimate) {
    faulty_ = false;
    arm_.set_noise(0);
    const rme::JointVector<double, 7> ready = arm_.pose();
    arm_.move(ready.array() - 0.1, 1);
    run(1);
    arm_.move(ready, 1);
    run(3);
    const bool watching = estimator_.phase() == rme::Phase::Watching;
    arm_.hold({1.1, {0.05, 0.02, 0.13}});
    const int seen = run(2);
    estimate = estimator_.estimate();
    arm_.hold({});
    const int gone = run(2);
    arm_.set_noise(1);
    faulty_ = true;
    return watching && seen == 1 && gone == 1 && estimator_.estimate().empty;
  }

  Counts counts;

 private:
  double uniform(double from, double to) { return std::uniform_real_distribution<double>(from, to)(random_); }

  /// One thing, and time for it to settle.
  void happen() {
    const double what = uniform(0, 1);
    if (what < 0.25) {
      ++counts.pushes;
      const Eigen::Vector3d force(uniform(-15, 15), uniform(-15, 15), uniform(-15, 15));
      arm_.push({force, Eigen::Vector3d(uniform(-1.5, 1.5), uniform(-1.5, 1.5), uniform(-1.5, 1.5))});
      counts.unasked += run(uniform(0.2, 2.5));
      arm_.push({});
      counts.unasked += run(uniform(1.5, 3));
    } else if (what < 0.35) {
      ++counts.moves;
      rme::JointVector<double, 7> pose = rme::examples::panda().ready;
      for (int j = 0; j < 7; ++j) pose[j] += uniform(-0.4, 0.4);
      arm_.move(pose, uniform(1.5, 3));
      counts.unasked += run(uniform(4, 6));
    } else if (things_ < 2 && (things_ == 0 || what < 0.7)) {
      const Payload<double> thing = {uniform(0.3, 1.5),
                                     {uniform(-0.05, 0.05), uniform(-0.05, 0.05), uniform(0.05, 0.15)}};
      hand_[things_++] = thing;
      change(arm_.torque(thing).norm());
    } else {
      take_away();
    }
  }

  void take_away() {
    if (things_ == 2 && uniform(0, 1) < 0.5) std::swap(hand_[0], hand_[1]);
    const Payload<double> thing = hand_[--things_];
    hand_[things_] = {};
    change(arm_.torque(thing).norm());
  }

  /// The hand holds something else from now on.
  void change(double torque) {
    const Payload<double> all = together(hand_[0], hand_[1]);
    arm_.hold(all);
    const long faults = counts.faults;
    const bool disturbed_before = counts.ticks - last_fault_ < 600;
    rejections_ = 0;
    const int estimates = run(uniform(1.5, 4));
    const bool disturbed = disturbed_before || counts.faults > faults;
    if (torque >= kFair && disturbed) {
      ++counts.events_with_fault;
      counts.missed_with_fault += estimates == 0;
    } else if (torque >= kFair) {
      ++counts.events;
      counts.unnoticed += estimates == 0 && rejections_ == 0;
      counts.misjudged += estimates == 0 && rejections_ > 0;
    }
    counts.unasked += std::max(0, estimates - 1);
    if (estimates == 0) return;
    counts.mass_error += std::abs(estimator_.estimate().posterior.mean[0] - all.mass);
    ++counts.mass_errors;
  }

  /// @return final estimates
  int run(double seconds) {
    int estimates = 0;
    for (long k = std::lround(seconds / HeldArm::kPeriod); k > 0; --k) {
      ++counts.ticks;
      const Tick& now = arm_.tick();
      if (!deliver(now)) continue;
      estimates += estimator_.estimated();
      rejections_ += estimator_.rejected();
      counts.bad_torques += !estimator_.compensation(now.jacobian, now.rotation).allFinite();
    }
    return estimates;
  }

  enum class Fault { NotANumber, Lost, Frozen, Wild, Mirror };

  /// Hands a tick to the estimator, or what a fault makes of it.
  /// @return whether the estimator took it
  bool deliver(const Tick& now) {
    if (faulty_ && fault_left_ == 0 && random_() % 20000 == 0) {
      fault_ = static_cast<Fault>(random_() % 5);
      fault_left_ = fault_ == Fault::Wild ? 1 : 1 + static_cast<int>(random_() % 50);
      frozen_ = now;
      ++counts.faults;
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

  HeldArm arm_;
  std::mt19937_64 random_;
  Estimator estimator_;
  Payload<double> hand_[2];
  int things_ = 0;
  int rejections_ = 0;  // since the last change
  bool faulty_ = true;
  Fault fault_ = Fault::Lost;
  int fault_left_ = 0;  // ticks
  long last_fault_ = -1000;
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

double difference(const Estimate& a, const Estimate& b) {
  return std::max((a.posterior.mean - b.posterior.mean).cwiseAbs().maxCoeff(),
                  (a.posterior.covariance - b.posterior.covariance).cwiseAbs().maxCoeff());
}

int run(Arguments& arguments) {
  const double minutes = arguments.number("--minutes").value_or(10);
  const std::size_t seed = arguments.whole("--seed", 0).value_or(1);
  arguments.finish();
  if (!(minutes > 0)) throw ArgumentError("--minutes: must be above 0");
  std::printf("seed %zu\n%8s %9s %7s %9s %9s %7s %7s %7s %7s %10s %8s %6s %7s\n", seed, "minutes", "ticks", "events",
              "unnoticed", "misjudged", "faulty", "missed", "pushes", "unasked", "mass err g", "drift", "alloc",
              "RSS MB");
  Soak soak(seed);
  const int parts = std::max(2, static_cast<int>(std::lround(minutes / 60)));
  Estimate first, now;
  bool seen = soak.reference(first);
  double drift = 0;
  int allocated = 0;
  for (int part = 1; part <= parts; ++part) {
#ifdef RME_COUNTS_ALLOCATIONS
    const int before = rme::testing::allocations();
#endif
    soak.operate(minutes * 60 / parts);
    seen = soak.reference(now) && seen;
#ifdef RME_COUNTS_ALLOCATIONS
    allocated += rme::testing::allocations() - before;
#endif
    drift = std::max(drift, difference(first, now));
    Counts& c = soak.counts;
    std::printf("%8.1f %9ld %7ld %9ld %9ld %7ld %7ld %7ld %7ld %10.2f %8.1e %6d %7.2f\n",
                static_cast<double>(c.ticks) * HeldArm::kPeriod / 60, c.ticks, c.events, c.unnoticed, c.misjudged,
                c.events_with_fault, c.missed_with_fault, c.pushes, c.unasked,
                1e3 * c.mass_error / static_cast<double>(c.mass_errors), drift, allocated, resident());
    std::fflush(stdout);
    c.mass_error = 0;
    c.mass_errors = 0;
  }
  const Counts& c = soak.counts;
  const auto at_most = [](long count, double share, long of) {
    return static_cast<double>(count) <= std::ceil(share * static_cast<double>(of));
  };
  const bool fair = c.unnoticed == 0 && at_most(c.misjudged, kMisjudged, c.events) &&
                    at_most(c.missed_with_fault, kMissedByFault, c.events_with_fault);
  if (!fair) std::printf("objects were missed\n");
  if (c.bad_torques > 0) std::printf("%ld torques were not finite\n", c.bad_torques);
  if (!seen) std::printf("the noise-free event was not seen for what it is\n");
  if (!(drift <= kDrift)) std::printf("the noise-free event's estimate has moved\n");
  if (allocated > 0) std::printf("memory was allocated\n");
  return fair && c.bad_torques == 0 && seen && drift <= kDrift && allocated == 0 ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return rme::examples::run_program("soak", kUsage, argc, argv, run);
}
