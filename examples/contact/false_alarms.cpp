// false_alarms: how often is a contact noticed that is none?
//
// A Panda (carrying_arm.hpp) moves between random poses, and rests in between for up to 4 s. Objects of 0.1 to 2.5 kg, at
// most two at a time, come and go at once or within seconds, at any time of a move. Nothing touches the arm. Every contact
// is counted that is noticed later than 1 s after a change of the payload: until then, it is the change. And each second that
// is later than 2 s after one, the mass that is believed to be held is compared with the true one.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <random>
#include <rme/estimator.hpp>
#include <stdexcept>
#include <vector>

#include "carrying_arm.hpp"
#include "io/program.hpp"

namespace {

using namespace rme::examples;
using Eigen::Vector3d;

constexpr double kPeriod = 1e-3, kStart = 2;  // [s]
constexpr double kChange = 1;                 // how long after a change of the payload a contact is that change [s]
constexpr double kKnown = 2;                  // how long after a change the payload is asked for [s]
constexpr double kLost = 0.1, kSure = 4;      // an error beyond both is a wrong belief: [kg], and standard deviations
constexpr double kLongest = 10;               // how long one may last [s]
constexpr double kInside = 0.9;               // least share of the seconds within three standard deviations

constexpr const char* kUsage = R"(usage: rme_false_alarms [options]

Prints how often a contact is noticed while nothing touches the arm, and how far the believed mass is off meanwhile.

  --hours H     of simulated operation (default 0.1)
  --rate R      EstimatorConfig::contact_false_alarms [1/h] (default 0.1)
  --friction    the torque contains joint friction
  --noise N     standard deviation of the noise of dq [rad/s] (default 0)
  --list        print a line for each false alarm
  --seed N      of everything random (default 1)
  --help        this text

Exit codes: 0 done; 1 more false alarms than stated, by more than three standard deviations of their count and by more
than one, or the mass was off by more than 0.1 kg and four standard deviations for more than 10 s, or by more than three
standard deviations in a tenth of all seconds; 2 unusable arguments.
)";

/// Random moves from rest to rest, along minimum-jerk paths about the pose `home`.
class Moves {
 public:
  explicit Moves(const Kinematics<7>& home) : home_(home) {}
  PoseTarget at(double t, std::mt19937_64& random) {
    const auto uniform = [&random](double from, double to) {
      return std::uniform_real_distribution<double>(from, to)(random);
    };
    const auto anywhere = [&](double x, double y, double z) {
      const double a = uniform(-x, x), b = uniform(-y, y), c = uniform(-z, z);
      return Vector3d(a, b, c);
    };
    if (t > start_ + duration_ + rest_) {
      start_ = t;
      duration_ = uniform(0.8, 3.3);
      rest_ = uniform(0, 1) < 0.5 ? 0 : 4 * uniform(0, 1) * uniform(0, 1);
      from_ = to_;
      turned_from_ = turned_to_;
      to_ = anywhere(0.12, 0.2, 0.15);
      turned_to_ = anywhere(0.4, 0.4, 0.4);
    }
    const double s = std::clamp((t - start_) / duration_, 0.0, 1.0);
    const double share = s * s * s * (10 - 15 * s + 6 * s * s), rate = 30 * s * s * (1 - s) * (1 - s) / duration_;
    PoseTarget target{home_.position, home_.rotation};
    target.position += from_ + share * (to_ - from_);
    target.velocity = rate * (to_ - from_);
    const Vector3d turned = turned_from_ + share * (turned_to_ - turned_from_);
    if (turned.norm() > 1e-9) target.rotation = Eigen::AngleAxisd(turned.norm(), turned.normalized()) * home_.rotation;
    target.angular_velocity = rate * (turned_to_ - turned_from_);
    return target;
  }
  double since(double t) const { return t - start_; }  ///< the last start [s]

 private:
  Kinematics<7> home_;
  Vector3d from_ = Vector3d::Zero(), to_ = from_;                // of the position [m]
  Vector3d turned_from_ = Vector3d::Zero(), turned_to_ = from_;  // rotation vectors [rad]
  double start_ = kStart, duration_ = 1, rest_ = 0;              // [s]
};

/// Objects that come and go.
class Hand {
 public:
  void update(SyntheticArm<7>& arm, std::mt19937_64& random) {
    const double t = arm.time();
    if (t < next_) return;
    const auto uniform = [&random](double from, double to) {
      return std::uniform_real_distribution<double>(from, to)(random);
    };
    double ramp = 0;
    if (held_.empty() || (held_.size() < 2 && uniform(0, 1) < 0.5)) {
      const double kind = uniform(0, 1);
      ramp = kind < 0.4 ? 0 : kind < 0.7 ? uniform(0.3, 1.8) : uniform(2, 5);
      const double mass = held_.empty() ? uniform(0.1, 2.5) : uniform(0.1, 0.7);
      std::normal_distribution<double> aside(0, 0.04);
      const double x = aside(random), y = aside(random), z = uniform(0.05, 0.15);
      held_.push_back(arm.attach(box(mass, {x, y, z}, {0.06, 0.06, 0.1}), ramp));
    } else {
      ramp = uniform(0, 1) < 0.7 ? 0 : 0.3;
      arm.detach(held_.back(), ramp);
      held_.pop_back();
    }
    ++changes;
    over_ = t + ramp;
    next_ = over_ + uniform(5, 30);
  }
  double since(double t) const { return t - over_; }  ///< the last change was over [s]
  int changes = 0;

 private:
  std::vector<int> held_;
  double next_ = 1, over_ = 0;  // [s]
};

/// How far the believed mass is off, over the seconds that are asked: those of a change do not end a wrong belief.
class MassError {
 public:
  /// @param off  error [kg]
  /// @param std  that the belief states [kg]
  void add(double off, double std) {
    ++seconds_;
    sum_ += std::abs(off);
    largest_ = std::max(largest_, std::abs(off));
    inside_ += std::abs(off) <= 3 * std ? 1 : 0;
    wrong_ = std::abs(off) > std::max(kLost, kSure * std) ? wrong_ + 1 : 0;
    longest_ = std::max(longest_, wrong_);
  }
  /// Whether no wrong belief lasted, and the stated deviations were kept to.
  bool good() const {
    return static_cast<double>(longest_) <= kLongest &&
           static_cast<double>(inside_) >= kInside * static_cast<double>(seconds_);
  }
  void print() const {
    const auto n = static_cast<double>(std::max(1L, seconds_));
    std::printf("Mass held, later than %g s after a change: off by %.1f g on average, %.0f g at most; ", kKnown,
                1e3 * sum_ / n, 1e3 * largest_);
    std::printf("%.1f %% within 3 stated deviations; longest wrong belief %ld s.\n",
                100 * static_cast<double>(inside_) / n, longest_);
  }

 private:
  long seconds_ = 0, inside_ = 0, wrong_ = 0, longest_ = 0;
  double sum_ = 0, largest_ = 0;  // [kg]
};

int run(Arguments& arguments) {
  CarryingArm settings;
  const double hours = arguments.number("--hours").value_or(0.1);
  rme::EstimatorConfig<double, 7> config;
  config.contact_false_alarms = arguments.number("--rate").value_or(config.contact_false_alarms);
  settings.friction = arguments.flag("--friction");
  settings.noise = arguments.number("--noise").value_or(0);
  const bool list = arguments.flag("--list");
  settings.seed = arguments.whole("--seed", 0).value_or(1);
  arguments.finish();
  if (!(hours > 0)) throw ArgumentError("--hours: must be above 0");

  SyntheticArm<7> arm(panda(), settings.faults(), panda().ready);
  PoseImpedance<7> controller = CarryingArm::controller();
  const auto estimator = std::make_unique<rme::Estimator<double, 7>>(kPeriod, config);
  std::mt19937_64 random(settings.seed * 977 + 5);
  Moves moves(panda().kinematics(panda().ready));
  Hand hand;
  int number = 0, alarms = 0, first_minutes = 0, at_change = 0;
  double threshold = 0;  // of the joint with the largest one, sum over the seconds [N m]
  long seconds = 0;
  MassError mass;
  for (long tick = 0; arm.time() < 3600 * hours; ++tick) {
    const double t = arm.time();
    hand.update(arm, random);
    controller.follow(moves.at(t, random));
    const auto& [position, rotation, jacobian] = arm.kinematics();
    const rme::Status status = estimator->update({arm.tau_ext(), jacobian, rotation, arm.dq()});
    if (status != rme::Status::Ok) throw std::runtime_error(to_string(status));
    const auto& contact = estimator->contact();
    if (tick % 1000 == 0 && t > 60) {
      threshold += contact.threshold.maxCoeff();
      ++seconds;
    }
    if (tick % 1000 == 0 && hand.since(t) > kKnown && arm.payload().mass > 0) {
      const auto& payload = estimator->state().payload;
      mass.add(payload.mean[0] - arm.payload().mass, std::sqrt(payload.covariance(0, 0)));
    }
    if (contact.last.number > number) {
      number = contact.last.number;
      if (hand.since(t) < kChange) {
        ++at_change;
      } else {
        ++alarms;
        first_minutes += t < 300 ? 1 : 0;
        if (list) {
          std::printf(
              "%9.3f s: statistic %.2f, %5.2f s after a change, %.2f s after a start, speed %.3f rad/s, residual", t,
              contact.statistic, hand.since(t), moves.since(t), arm.dq().norm());
          for (int j = 0; j < 7; ++j) std::printf(" %.2f", contact.residual[j]);
          std::printf(", deviation");
          for (int j = 0; j < 7; ++j) std::printf(" %.2f", std::sqrt(contact.variance[j]));
          std::printf("\n");
          std::fflush(stdout);
        }
      }
    }
    arm.step(controller.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()) +
             estimator->compensation(jacobian, rotation));
  }
  const double stated = config.contact_false_alarms * hours;
  std::printf("%.2f h, seed %zu: %d changes of the payload, %d contacts within 1 s of one.\n", hours,
              static_cast<std::size_t>(settings.seed), hand.changes, at_change);
  std::printf("False alarms: %d (%d of them in the first 5 min); stated are %.2f.\n", alarms, first_minutes, stated);
  if (seconds > 0)
    std::printf("Threshold of the least sensitive joint: %.3f N m.\n", threshold / static_cast<double>(seconds));
  mass.print();
  return alarms > std::max(1.0, stated + 3 * std::sqrt(stated)) || !mass.good() ? 1 : 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_false_alarms", kUsage, argc, argv, run);
}
