// injected: is a push noticed on a real arm, and how often is one noticed that is none?
//
// A recording in which somebody pushes a real arm with a known force is hard to obtain, one that nobody touches is not. A
// known force at the tip makes a known joint torque, J^T f. If this torque, passed through the observer's filter, is
// added to the recorded one, the sum is what the arm would have reported if it had made the same motion while it was
// pushed. Noise, friction and errors of the model remain those of the real arm. What is missing is how the arm would have
// given way, and the friction of joints that rest, which would have carried a part of the push.
//
// Plays the recording as it is: every contact is a false alarm, except within 1 s after a change of the payload, if the
// recording says when it changes. Then plays it again and again with pushes of 0.3 s in random directions, one each 2 to
// 3 s. Prints how many were noticed before they were over, and after what time, beside what thresholds on the torque
// itself notice. These are in favour of the thresholds: they are as low as they can be without more false alarms on this
// very recording, which nobody knows beforehand.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <memory>
#include <optional>
#include <random>
#include <string>
#include <vector>

#include "io/program.hpp"
#include "paper/injection/payload_injection.hpp"
#include "precompiled/any_joints.hpp"
#include "replay_log/options.hpp"

namespace {

using namespace rme::examples;

constexpr double kPush = 0.3;              // how long a push lasts [s]
constexpr double kSeldom = 2, kOften = 3;  // least and largest time between the onsets of two pushes [s]
constexpr double kChange = 1;              // how long after a change of the payload a contact is that change [s]
constexpr double kReady = 1;               // in which a new estimator notices no contact [s]

constexpr const char* kUsage =
    "usage: rme_injected_contacts LOG.csv[.gz] [options]\n"
    "\n"
    "Adds pushes to a log in which nothing touches the arm, and prints how many are noticed.\n"
    "\n";
constexpr const char* kOwnUsage =
    "  --force F           of each push, at the tip [N] (10)\n"
    "  --pushes N          how many, over as many replays as the log's length needs (200)\n"
    "  --from S            pushes and false alarms count from S seconds after the log's begin on [s] (2)\n"
    "  --add KG            mass of a payload that is simulated from the log's begin on, 6 cm from the tip [kg] (0)\n"
    "  --tare LOG.csv      log of an empty hand, whose mean torque the raw thresholds count from (the log itself)\n"
    "  --seed N            of everything random (1)\n"
    "  --name TEXT         name of the log, for the table\n"
    "  --header            print the table's header as well\n"
    "\n"
    "Exit codes: 0 done; 2 unusable arguments; 3 unusable log.\n";

struct Options {
  double force = 10, from = 2, added = 0;  // [N], [s], [kg]
  std::size_t pushes = 200, seed = 1;
  std::optional<std::string> tare, name;
  bool header = false;
};

Options parse(Arguments& arguments) {
  Options options;
  options.force = arguments.number("--force").value_or(options.force);
  options.pushes = arguments.whole("--pushes", 1, 100000).value_or(options.pushes);
  options.from = arguments.number("--from").value_or(options.from);
  options.added = arguments.number("--add").value_or(options.added);
  options.tare = arguments.text("--tare");
  options.seed = arguments.whole("--seed", 0).value_or(options.seed);
  options.name = arguments.text("--name");
  options.header = arguments.flag("--header");
  if (!(options.force > 0)) throw ArgumentError("--force: must be above 0 N");
  if (!(options.added >= 0)) throw ArgumentError("--add: must be the mass of a simulated payload, 0 or more kg");
  if (!(options.from >= kReady)) throw ArgumentError("--from: must be 1 s or more: before, no contact is noticed");
  return options;
}

/// Thresholds on the external torque of each joint.
template <int Dofs>
class RawThresholds {
 public:
  using Vector = rme::JointVector<double, Dofs>;
  /// @param mean     of the torque of an empty hand [N m]
  /// @param largest  distance from it of each joint, of which the thresholds are a share [N m]
  RawThresholds(const Vector& mean, const Vector& largest) : mean_(mean), largest_(largest) {}
  void restart(double share) {
    share_ = share;
    last_ = -1e9;
  }
  /// @return whether a contact begins: a joint is above its threshold, and none was for 0.2 s
  bool update(const Vector& tau_ext, double t) {
    constexpr double kOver = 0.2;  // as rme ends a contact [s]
    if (((tau_ext - mean_).cwiseAbs().array() <= share_ * largest_.array()).all()) return false;
    const bool begins = t - last_ > kOver;
    last_ = t;
    return begins;
  }

 private:
  Vector mean_, largest_;
  double share_ = 1, last_ = -1e9;  // -, when a joint was above its threshold the last time [s]
};

struct Push {
  std::size_t number = 0;
  double begin = 0;  ///< [s]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();
};

/// The pushes of a replay, in order of time.
class Pushes {
 public:
  explicit Pushes(const std::vector<Push>& all) : all_(all) {}
  /// @param t  never decreases from call to call [s]
  /// @return the push at that time; null if there is none
  const Push* at(double t) {
    while (next_ < all_.size() && t >= all_[next_].begin + kPush) ++next_;
    return next_ < all_.size() && t >= all_[next_].begin ? &all_[next_] : nullptr;
  }

 private:
  const std::vector<Push>& all_;
  std::size_t next_ = 0;
};

/// What a detector makes of all pushes.
class Score {
 public:
  void notice(const Push& push, double t) {
    if (push.number == last_) return;
    last_ = push.number;
    delay_.push_back(1e3 * (t - push.begin));
  }
  std::size_t noticed() const { return delay_.size(); }
  /// Delay of those that were noticed [ms].
  double quantile(double share) {
    if (delay_.empty()) return std::nan("");
    std::sort(delay_.begin(), delay_.end());
    return delay_[std::min(delay_.size() - 1, static_cast<std::size_t>(share * static_cast<double>(delay_.size())))];
  }

 private:
  std::size_t last_ = 0;  // number of the push that was noticed last
  std::vector<double> delay_;
};

/// For each sample, whether a contact counts: not at the log's begin, and not after a change of the payload.
template <int Dofs>
std::vector<bool> counting(const Log<Dofs>& log, const Samples<Dofs>& samples, double from) {
  std::vector<bool> out;
  double changed = log.t.front() - kChange;
  for (std::size_t k = 0; k < samples.row.size(); ++k) {
    const std::size_t row = samples.row[k];
    if (!log.truth.empty() && k > 0 && log.truth[row] != log.truth[samples.row[k - 1]]) changed = log.t[row];
    out.push_back(log.t[row] >= log.t.front() + from && log.t[row] >= changed + kChange);
  }
  return out;
}

/// The mean torque while the hand is empty, as far as the log says [N m].
template <int Dofs>
rme::JointVector<double, Dofs> mean_of_empty_hand(const Log<Dofs>& log, const Samples<Dofs>& samples) {
  rme::JointVector<double, Dofs> sum = rme::JointVector<double, Dofs>::Zero();
  double count = 0;
  for (std::size_t k = 0; k < samples.row.size(); ++k) {
    if (!log.truth.empty() && log.truth[samples.row[k]][0] > 0) continue;
    sum += samples.sample[k].tau_ext;
    ++count;
  }
  if (count == 0) throw LogError(log.name + ": the hand is never empty; --tare names a log in which it is");
  return sum / count;
}

/// The samples, with a cube of this mass in the hand [kg].
template <int Dofs>
Samples<Dofs> loaded(const Log<Dofs>& log, const Samples<Dofs>& samples, const Eigen::Vector3d& gravity, double mass) {
  if (mass == 0) return samples;
  constexpr double kCentre = 0.06, kWidth = 0.08;  // [m]
  const Eigen::Matrix3d inertia = mass * kWidth * kWidth / 6 * Eigen::Matrix3d::Identity();
  const Injected cube{log.t.front(), rme::InertialParameters<double>::of_body({mass, {0, 0, kCentre}}, inertia)};
  return injected(log, samples, motion_of(log, samples), gravity, cube, log.t.front(), log.t.back());
}

/// Plays the samples, and calls `on_tick` with the number of each and whether rme notices a contact at it.
template <int Dofs, typename OnTick>
void play(const Samples<Dofs>& samples, rme::EstimatorConfig<double, Dofs> config, OnTick&& on_tick) {
  config.observer_bandwidth = samples.bandwidth;
  config.torque_sign = samples.sign;
  const auto estimator = std::make_unique<rme::Estimator<double, Dofs>>(samples.timing.period, config);
  int number = 0;
  for (std::size_t k = 0; k < samples.sample.size(); ++k) {
    // A sample that is refused leaves the contact as it was, as on a host.
    static_cast<void>(estimator->update(samples.sample[k]));
    const int now = estimator->contact().last.number;
    on_tick(k, now > number);
    number = now;
  }
}

/// Random pushes for one replay, at instants at which contacts count.
/// @param first  number of the first push, > 0
template <int Dofs>
std::vector<Push> draw(const Log<Dofs>& log, const Samples<Dofs>& samples, const std::vector<bool>& counts,
                       const Options& options, std::size_t first, std::mt19937_64& random) {
  std::vector<Push> out;
  std::normal_distribution<double> normal;
  const auto uniform = [&random](double from, double to) {
    return std::uniform_real_distribution<double>(from, to)(random);
  };
  const auto all_count = [&](double begin, double end) {
    for (std::size_t k = 0; k < samples.row.size(); ++k) {
      const double t = log.t[samples.row[k]];
      if (t >= begin && t < end && !counts[k]) return false;
    }
    return true;
  };
  double t = log.t.front() + options.from + uniform(0, kSeldom);
  for (; t + kPush < log.t[samples.row.back()]; t += uniform(kSeldom, kOften)) {
    const double x = normal(random), y = normal(random), z = normal(random);
    if (all_count(t, t + kPush))
      out.push_back({first + out.size(), t, options.force * Eigen::Vector3d(x, y, z).normalized()});
  }
  return out;
}

/// The samples with the torque of the pushes. An observer is linear in the torque, so that its filter may be applied to
/// that of the pushes alone.
template <int Dofs>
Samples<Dofs> pushed(const Log<Dofs>& log, Samples<Dofs> samples, const std::vector<Push>& pushes) {
  rme::JointVector<double, Dofs> seen = rme::JointVector<double, Dofs>::Zero();
  Pushes at(pushes);
  for (std::size_t k = 0; k < samples.sample.size(); ++k) {
    auto& sample = samples.sample[k];
    rme::JointVector<double, Dofs> torque = rme::JointVector<double, Dofs>::Zero();
    if (const Push* push = at.at(log.t[samples.row[k]]))
      torque = sample.jacobian.template topRows<3>().transpose() * push->force;
    const double period = sample.period > 0 ? sample.period : samples.timing.period;
    seen += observer_blend(samples.bandwidth, period) * (torque - seen);
    sample.tau_ext += static_cast<double>(samples.sign) * seen;
  }
  return samples;
}

/// How often contacts begin at the thresholds while they count.
template <int Dofs>
int false_alarms(RawThresholds<Dofs>& raw, double share, const Log<Dofs>& log, const Samples<Dofs>& samples,
                 const std::vector<bool>& counts) {
  raw.restart(share);
  int count = 0;
  for (std::size_t k = 0; k < samples.sample.size(); ++k)
    count += raw.update(samples.sample[k].tau_ext, log.t[samples.row[k]]) && counts[k] ? 1 : 0;
  return count;
}

template <int Dofs>
Log<Dofs> read(const std::string& file) {
  Log<Dofs> log = read_log<Dofs>(file);
  require_external_torque(log);
  return log;
}

template <int Dofs>
int run(Arguments& arguments, const ArmRequest& request) {
  using Vector = rme::JointVector<double, Dofs>;
  const ArmSettings<Dofs> settings = parse_settings<Dofs>(arguments, request);
  const Options options = parse(arguments);
  const std::string file = arguments.positional("LOG.csv");
  arguments.finish();
  for (const std::string& note : settings.notes) std::fprintf(stderr, "rme_injected_contacts: %s\n", note.c_str());
  const Log<Dofs> log = read<Dofs>(file);
  const Samples<Dofs> recorded = samples_of(log, settings.arm, settings.config);
  const Samples<Dofs> samples = loaded(log, recorded, settings.arm.model.gravity_vector, options.added);
  const std::vector<bool> counts = counting(log, samples, options.from);

  if (std::find(counts.begin(), counts.end(), true) == counts.end())
    throw LogError(log.name + ": ends before --from, or is all within 1 s after changes of the payload");

  // The log as it is.
  int alarms = 0;
  double time = 0;  // in which contacts count [s]
  play(samples, settings.config, [&](std::size_t k, bool begins) {
    alarms += begins && counts[k] ? 1 : 0;
    time += counts[k] ? samples.sample[k].period : 0;
  });

  // As low as they can be without more false alarms.
  Vector mean, largest = Vector::Zero();
  if (options.tare) {
    const Log<Dofs> empty = read<Dofs>(*options.tare);
    mean = mean_of_empty_hand(empty, samples_of(empty, settings.arm, settings.config));
  } else {
    mean = mean_of_empty_hand(log, recorded);
  }
  for (std::size_t k = 0; k < samples.sample.size(); ++k)
    if (counts[k]) largest = largest.cwiseMax((samples.sample[k].tau_ext - mean).cwiseAbs());
  RawThresholds<Dofs> raw(mean, largest);
  constexpr double kStep = 0.98, kLeast = 0.01;
  double share = 1;
  while (share > kLeast && false_alarms(raw, kStep * share, log, samples, counts) <= alarms) share *= kStep;

  // With pushes.
  std::mt19937_64 random(options.seed);
  Score ours, theirs;
  std::size_t count = 0;
  int others = 0, in_vain = 0;  // contacts that begin between the pushes; draws without a push
  while (count < options.pushes) {
    std::vector<Push> pushes = draw(log, samples, counts, options, count + 1, random);
    if (pushes.size() > options.pushes - count) pushes.resize(options.pushes - count);
    if (pushes.empty() && ++in_vain == 100) throw LogError(log.name + ": leaves no time for a push after --from");
    if (pushes.empty()) continue;
    count += pushes.size();
    const Samples<Dofs> played = pushed(log, samples, pushes);
    raw.restart(share);
    Pushes at(pushes);
    play(played, settings.config, [&](std::size_t k, bool begins) {
      const double t = log.t[samples.row[k]];
      const Push* push = at.at(t);
      if (raw.update(played.sample[k].tau_ext, t) && push != nullptr) theirs.notice(*push, t);
      if (begins && push != nullptr) ours.notice(*push, t);
      others += begins && push == nullptr && counts[k] ? 1 : 0;
    });
  }

  if (options.header)
    std::printf(
        "| recording | push | count | noticed | median | 95 %% | false alarms | per hour | between pushes | raw: "
        "noticed | raw: median |\n"
        "|---|---:|---:|---:|---:|---:|---:|---:|---:|---:|---:|\n");
  const double percent = 100 / static_cast<double>(count);
  std::printf("| %s | %g N | %zu | %.1f %% | %.0f ms | %.0f ms | %d in %.0f s | %.0f | %d | %.1f %% | %.0f ms |\n",
              options.name.value_or(file.substr(file.rfind('/') + 1)).c_str(), options.force, count,
              percent * static_cast<double>(ours.noticed()), ours.quantile(0.5), ours.quantile(0.95), alarms, time,
              3600 * alarms / time, others, percent * static_cast<double>(theirs.noticed()), theirs.quantile(0.5));
  return 0;
}

int run(Arguments& arguments) {
  const ArmRequest request = parse_arm(arguments);
  return with_joint_count(request.dofs(), [&](auto dofs) { return run<dofs()>(arguments, request); });
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_injected_contacts", std::string(kUsage) + kArmUsage + kSettingsUsage + kOwnUsage, argc, argv,
                     run);
}
