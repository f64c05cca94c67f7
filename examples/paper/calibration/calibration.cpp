// calibration: do the intervals hold the truth as often as they claim? Are pushes taken for payloads or payloads for
// pushes, and are payloads found where there are none?
//
// Simulates a Panda that holds a random pose under an impedance law. Its torque sensors have noise and offsets, its
// joints have friction, all drawn anew for each run. One second after the start an unknown payload is attached to the
// flange, and two seconds after the start the arm begins to move. The tracker's estimates are compared with the truth
// at rest, half a second after the attachment, and after three seconds of motion. Prints for each parameter the errors,
// how often the 50, 80, 90 and 95 % intervals hold the truth, and the rank histogram (simulation-based calibration: how
// often the truth lies in each tenth of the posterior; all counts are equal if the posteriors are honest). This is done
// for arms with link-side sensing and for arms whose torque contains joint friction. The estimator is not told which it
// is, unless --told is given.
//
// --pushes N adds N runs in which a hand pushes an arm without payload, --quiet S adds S seconds without any event.
//
// A calibrated posterior has uniform ranks only if the truths come from its own prior, which is the default here.
// "--truth uniform" draws them from a uniform distribution over usual payloads, which is closer to a user's situation.
// Where the data say little (the centre of mass along gravity), the coverage then depends as much on the prior as on
// the inference.
#include <algorithm>
#include <array>
#include <atomic>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <mutex>
#include <optional>
#include <string>
#include <thread>
#include <vector>

#include "io/program.hpp"
#include "paper/calibration/random_host.hpp"
#include "paper/calibration/scores.hpp"

namespace {

using namespace rme::examples;

constexpr double kAttach = 1;     // when the payload is attached or the push begins [s]
constexpr double kRest = 0.5;     // the estimate at rest is read this long after the attachment [s]
constexpr double kSetOff = 2;     // when the arm begins to move [s]
constexpr double kEnd = 5;        // when the estimate after motion is read [s]
constexpr double kWatched = 2;    // how long a push is watched after its end [s]
constexpr double kGhost = 0.05;   // a larger estimated mass of an empty hand counts as a false payload [kg]
constexpr double kCarried = 0.2;  // how long a push may be taken for a payload [s]

constexpr const char* kUsage =
    R"(usage: rme_calibration [options]

Simulates random payloads on random arms and prints the errors of the tracker's estimates and how often its intervals hold
the truth.

  --events N        payloads to attach to each kind of arm (default 500)
  --sensing NAME    kind of arm: link_side (the torque contains no joint friction), joint_friction (it does), or both, one
                    after the other (default)
  --truth NAME      distribution of the payloads: prior (the tracker's own, default), or uniform (0.2 to 2 kg)
  --pushes N        also N pushes on each kind of arm with an empty hand, 0.3 to 2 s long. Half of them have 5 to 30 N in
                    any direction at the flange. The others resemble a payload: 6 N or more down (7.6 N on average) and
                    about 1 N aside, about 10 cm ahead of the flange
  --warm-up S       the arm moves for S seconds before anything else, and so shows what kind it is (default 0)
  --told            the estimator is told what kind of arm it is
  --quiet S         also S seconds with nothing attached: half at rest, half following a moving target
  --seed N          of everything random (default 1)
  --threads N       number of threads (default 1); the result does not depend on it
  --output DIR      write events.csv and ranks.csv there; the folder is created if it does not exist. plot.py draws them
  --help            this text

Exit codes: 0 every payload is believed in, the 90 % intervals hold 87 to 93 % of the truths after motion, and at most
1 % of the pushes are taken for a payload for more than 0.2 s; 1 not; 2 unusable arguments.
)";

struct Options {
  std::size_t events = 500, pushes = 0, threads = 1;
  double quiet = 0, warm_up = 0;
  bool told = false;
  std::uint64_t seed = 1;
  std::vector<Kind> kinds = {Kind::LinkSide, Kind::JointFriction};
  bool from_prior = true;
  std::optional<std::string> output;

  std::optional<rme::PayloadGaussian<double>> truth() const {
    if (!from_prior) return std::nullopt;
    const auto prior = rme::PayloadPrior<double>::of(rme::EstimatorConfig<double, 7>().rated_payload);
    Eigen::Vector4d mean, deviation;
    mean << prior.mass_mean, prior.com_mean;
    deviation << prior.mass_std, prior.com_std;
    return rme::PayloadGaussian<double>::independent(mean, deviation);
  }
};

Options parse(Arguments& arguments) {
  Options options;
  options.events = arguments.whole("--events", 1, 1000000).value_or(options.events);
  options.pushes = arguments.whole("--pushes", 0, 1000000).value_or(0);
  options.threads = arguments.whole("--threads", 1, 1000).value_or(1);
  options.seed = arguments.whole("--seed", 0).value_or(1);
  options.quiet = arguments.number("--quiet").value_or(0);
  if (!(options.quiet >= 0 && options.quiet <= 1e6)) throw ArgumentError("--quiet: must be from 0 to 1e6 s");
  options.warm_up = arguments.number("--warm-up").value_or(0);
  if (!(options.warm_up >= 0 && options.warm_up <= 1e4)) throw ArgumentError("--warm-up: must be from 0 to 1e4 s");
  options.told = arguments.flag("--told");
  using Kinds = std::vector<Kind>;
  options.kinds = arguments
                      .choice<Kinds>("--sensing", {{"link_side", {Kind::LinkSide}},
                                                   {"joint_friction", {Kind::JointFriction}},
                                                   {"both", options.kinds}})
                      .value_or(options.kinds);
  options.from_prior = arguments.choice<bool>("--truth", {{"uniform", false}, {"prior", true}}).value_or(true);
  options.output = arguments.text("--output");
  arguments.finish();
  return options;
}

constexpr const char* name_of(Kind kind) {
  return kind == Kind::JointFriction ? "joint friction" : "link side";
}

/// Calls work(0) ... work(count - 1), spread over threads, and prints the progress to stderr.
template <typename Work>
void for_each(std::size_t count, const Options& options, const std::string& what, const Work& work) {
  std::atomic<std::size_t> next{0}, done{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto worker = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        work(i);
        if (++done % 100 == 0) std::fprintf(stderr, "%zu of %zu %s\n", done.load(), count, what.c_str());
      }
    } catch (...) {
      const std::lock_guard<std::mutex> lock(mutex);
      failure = std::current_exception();
    }
  };
  std::vector<std::thread> threads;
  for (std::size_t k = 1; k < std::min(options.threads, count); ++k) threads.emplace_back(worker);
  worker();
  for (std::thread& thread : threads) thread.join();
  if (failure) std::rethrow_exception(failure);
}

/// Joint angles of a target that swings, relative to its start.
class Swing {
 public:
  explicit Swing(RandomHost& random) {
    for (int i = 0; i < 7; ++i) {
      amplitude_[i] = random.uniform(0.05, 0.25);
      frequency_[i] = 2 * 3.14159265358979 * random.uniform(0.05, 0.3);
    }
  }
  /// [rad] after so many seconds.
  Torque at(double t) const { return 0.5 * amplitude_.array() * (1 - (frequency_ * t).array().cos()); }

 private:
  Torque amplitude_, frequency_;  // [rad], [rad/s]
};

/// A Host with the settings of the options, whose arm has moved for --warm-up and rests again.
class Bench : public Host {
 public:
  Bench(const Options& options, Kind kind, const Draw& draw, const Swing& swing)
      : Host(draw, settings(options, kind)), draw_(draw) {
    while (arm().time() < options.warm_up) {
      const double share = std::sin(3.14159265358979 * arm().time() / options.warm_up);
      move(share * share * swing.at(arm().time()));
      tick();
    }
    if (options.warm_up > 0) move(Torque::Zero());
    begin_ = arm().time();
  }
  double time() { return arm().time() - begin_; }  // since the warm-up [s]
  /// Moves the target to the drawn one plus this difference [rad].
  void move(const Torque& way) { hold(draw_.target + way); }

 private:
  static rme::EstimatorConfig<double, 7> settings(const Options& options, Kind kind) {
    rme::EstimatorConfig<double, 7> config;
    if (options.told)
      config.sensing = kind == Kind::JointFriction ? rme::Sensing::JointFriction : rme::Sensing::LinkSide;
    return config;
  }
  Draw draw_;
  double begin_ = 0;
};

/// When an estimate is compared with the truth.
enum When : std::size_t { kAtRest, kAfterMotion, kWhens };
constexpr const char* kWhenNames[] = {"at rest", "after motion"};

/// The estimates of one payload.
struct Event {
  std::array<std::optional<Scored>, kWhens> scored;  // none if the hand is believed to be empty then
  double noticed = -1;                               // after the attachment [s]; -1 for never
  int skipped = 0;
};

Event attach_payload(const Options& options, Kind kind, std::size_t run) {
  RandomHost random(options.seed, run);
  const Draw draw = random.draw(kind, options.truth());
  const Swing swing(random);
  Bench host(options, kind, draw, swing);
  Event event;
  event.skipped = draw.skipped;
  const auto judge = [&](When when) {
    if (host.state().empty()) return;
    Scored s;
    s.truth << draw.payload.mass, draw.payload.com;
    s.error = host.state().payload.mean - s.truth;
    s.deviation = host.state().payload.standard_deviation();
    const Eigen::Vector3d com = s.error.tail<3>(),
                          down = host.arm().kinematics().rotation.transpose() * panda().gravity_vector.normalized();
    s.across = (com - down * down.dot(com)).norm();
    s.friction_shows = draw.friction_shows;
    event.scored[when] = s;
  };
  const auto run_until = [&](double time) {
    while (host.time() < time - kPeriod / 2) {
      if (host.time() > kSetOff) host.move(swing.at(host.time() - kSetOff));
      host.tick();
      if (host.time() > kAttach && event.noticed < 0 && !host.state().empty()) event.noticed = host.time() - kAttach;
    }
  };
  run_until(kAttach);
  host.arm().attach(draw.payload);
  run_until(kAttach + kRest);
  judge(kAtRest);
  run_until(kEnd);
  judge(kAfterMotion);
  return event;
}

/// @return whether the 90 % intervals hold 87 to 93 % of the truths
bool print(const std::vector<Scored>& scored) {
  std::printf("%-9s %7s %7s %7s |%7s%7s%7s%7s  %% hold |%11s | ranks in tenths\n", "", "mae", "rms", "bias", "50", "80",
              "90", "95", "half width");
  bool honest = true;
  for (int i = 0; i < 4; ++i) {
    const Summary s = summarise(scored, i);
    std::printf("%-9s %7.2f %7.2f %7.2f |", kParameters[static_cast<std::size_t>(i)], s.mean_absolute, s.rms, s.bias);
    for (const double coverage : s.coverage) std::printf("%7.1f", coverage);
    std::printf("         |%11.2f |", s.half_width);
    for (const int count : s.ranks) std::printf(" %3d", count);
    std::printf("\n");
    honest = honest && s.coverage[2] >= 87 && s.coverage[2] <= 93;
  }
  double across = 0;
  for (const Scored& s : scored) across += s.across / static_cast<double>(scored.size());
  const auto [least, most] = expected_counts(scored.size());
  std::printf("centre of mass across gravity: mean error %.2f mm\n", 1e3 * across);
  std::printf("half width: of the 90 %% interval; ranks of an honest posterior: %.0f to %.0f in 99 %% of cases\n",
              least, most);
  return honest;
}

/// events.csv and ranks.csv, or nothing without a folder.
class Files {
 public:
  explicit Files(const std::optional<std::string>& folder) : folder_(folder) {
    if (!folder_) return;
    events_.open(std::filesystem::path(*folder_) / "events.csv");
    ranks_.open(std::filesystem::path(*folder_) / "ranks.csv");
    events_ << "case,friction_shows,mass,x,y,z,mass_error,x_error,y_error,z_error,mass_std,x_std,y_std,z_std,across\n";
    ranks_ << "case,parameter,bin,count,least,most\n";
  }
  void add(const std::string& name, const std::vector<Scored>& scored) {
    if (!folder_) return;
    const Eigen::IOFormat cells(Eigen::StreamPrecision, Eigen::DontAlignCols, ",", ",");
    for (const Scored& s : scored)
      events_ << name << ',' << s.friction_shows << ',' << s.truth.format(cells) << ',' << s.error.format(cells) << ','
              << s.deviation.format(cells) << ',' << s.across << '\n';
    const auto [least, most] = expected_counts(scored.size());
    const char* names[] = {"mass", "x", "y", "z"};
    for (int i = 0; i < 4; ++i) {
      const Summary summary = summarise(scored, i);
      for (std::size_t bin = 0; bin < kBins; ++bin)
        ranks_ << name << ',' << names[i] << ',' << bin << ',' << summary.ranks[bin] << ',' << least << ',' << most
               << '\n';
    }
    if (!events_.flush() || !ranks_.flush()) throw ArgumentError("--output: cannot write to " + *folder_);
  }

 private:
  std::optional<std::string> folder_;
  std::ofstream events_, ranks_;
};

/// @return whether the intervals are honest after motion, and every payload is believed in
bool study_payloads(const Options& options, Kind kind, Files& files) {
  std::vector<Event> events(options.events);
  for_each(options.events, options, std::string("payloads, ") + name_of(kind),
           [&](std::size_t i) { events[i] = attach_payload(options, kind, i); });
  int skipped = 0;
  std::vector<double> noticed;
  for (const Event& event : events) {
    skipped += event.skipped;
    if (event.noticed >= 0) noticed.push_back(event.noticed);
  }
  std::sort(noticed.begin(), noticed.end());
  std::printf("%s: %zu payloads; %d draws skipped that the arm could not have held\n", name_of(kind), options.events,
              skipped);
  bool good = true;
  for (const When when : {kAtRest, kAfterMotion}) {
    std::vector<Scored> scored;
    for (const Event& event : events)
      if (event.scored[when]) scored.push_back(*event.scored[when]);
    std::printf("\n%s, %s\n", name_of(kind), kWhenNames[when]);
    if (scored.empty()) return false;
    const bool honest = print(scored);
    files.add(std::string(name_of(kind)) + " " + kWhenNames[when], scored);
    std::printf("believed in: %zu of %zu\n", scored.size(), options.events);
    good = good && scored.size() == options.events && (when == kAtRest || honest);
  }
  const std::size_t refused = options.events - noticed.size();
  std::printf("never believed in: %zu", refused);
  if (!noticed.empty()) std::printf("; the others after %.0f ms in the median", 1e3 * noticed[noticed.size() / 2]);
  std::printf("\n");
  return good;
}

/// What became of one push of an empty hand.
struct Push {
  double carried = 0;  ///< for how long an empty hand was believed to hold something [s], at the longest
  double across = 0;   ///< its force across gravity, which no payload at rest has [N]
};

Push push_arm(const Options& options, Kind kind, std::size_t run) {
  RandomHost random(options.seed + 1, run);
  const Draw draw = random.draw(kind, std::nullopt, false);
  Bench host(options, kind, draw, Swing(random));
  const Eigen::Vector3d direction = random.direction();
  Eigen::Vector3d force = random.uniform(5, 30) * direction, at = Eigen::Vector3d::Zero();
  if (run % 2 == 1) {  // nearly what a payload does
    const double down = 6 + 2 * std::abs(random.normal(0, 1)), left = random.normal(0, 1), ahead = random.normal(0, 1);
    force = Eigen::Vector3d(ahead, left, -down);
    const double z = random.normal(0.1, 0.03), y = random.normal(0, 0.05), x = random.normal(0, 0.05);
    at = Eigen::Vector3d(x, y, z);
  }
  const double duration = random.uniform(0.3, 2);
  constexpr double kRamp = 0.05;  // at both ends [s]
  double since = 0;
  Push push{0, force.head<2>().norm()};
  while (host.time() < kAttach + duration + kWatched) {
    const double t = host.time() - kAttach;
    const double share = std::clamp(std::min(t, duration - t) / kRamp, 0.0, 1.0);
    const Eigen::Vector3d lever = host.arm().kinematics().rotation * at;
    host.arm().push({share * force, share * lever.cross(force)});
    host.tick();
    since = host.state().payload.mean[0] > kGhost ? since + kPeriod : 0;
    push.carried = std::max(push.carried, since);
  }
  return push;
}

/// @return whether at most 1 % of the pushes are taken for a payload
bool study_pushes(const Options& options, Kind kind) {
  std::vector<Push> pushes(options.pushes);
  for_each(options.pushes, options, std::string("pushes, ") + name_of(kind),
           [&](std::size_t i) { pushes[i] = push_arm(options, kind, i); });
  std::array<int, 2> carried{}, of{};
  double longest = 0;
  std::vector<double> across;  // of those that were carried
  for (std::size_t i = 0; i < pushes.size(); ++i) {
    ++of[i % 2];
    longest = std::max(longest, pushes[i].carried);
    if (!(pushes[i].carried > kCarried)) continue;
    ++carried[i % 2];
    across.push_back(pushes[i].across);
  }
  std::sort(across.begin(), across.end());
  const int all = carried[0] + carried[1];
  std::printf("\n%s: %zu pushes; taken for more than %.0f g for longer than %.1f s: %d (%.2f %%)\n", name_of(kind),
              pushes.size(), 1e3 * kGhost, kCarried, all, 100.0 * all / static_cast<double>(pushes.size()));
  std::printf("these are %d of %d pushes in any direction, %d of %d pushes down and aside; the longest for %.2f s\n",
              carried[0], of[0], carried[1], of[1], longest);
  if (!across.empty())
    std::printf("their force across gravity: below %.2f N for half of them, below %.2f N for nine tenths\n",
                across[across.size() / 2], across[across.size() * 9 / 10]);
  return 100 * all <= static_cast<int>(pushes.size());
}

constexpr double kQuietRun = 30;  // length of one quiet run [s]

/// Runs an arm without any event, at rest or in motion. @return false events, pushes not counted
int leave_alone(const Options& options, Kind kind, std::size_t run, double duration) {
  RandomHost random(options.seed + 2, run);
  const Draw draw = random.draw(kind, std::nullopt, false);
  const Swing swing(random);
  Bench host(options, kind, draw, swing);
  int found = 0, last = 0;
  while (host.time() < duration) {
    if (run % 2 == 1) host.move(swing.at(host.time()));
    host.tick();
    const rme::Event& event = host.state().event;
    found += event.number != last && event.kind != rme::EventKind::Pushed ? 1 : 0;
    last = event.number;
  }
  return found;
}

void study_quiet(const Options& options, Kind kind) {
  const auto runs = 2 * static_cast<std::size_t>(std::ceil(options.quiet / 2 / kQuietRun));
  const double duration = options.quiet / static_cast<double>(runs);
  std::vector<int> found(runs);
  for_each(runs, options, std::string("quiet runs, ") + name_of(kind),
           [&](std::size_t i) { found[i] = leave_alone(options, kind, i, duration); });
  std::array<int, 2> count{};
  for (std::size_t i = 0; i < runs; ++i) count[i % 2] += found[i];
  std::printf("\n%s: %.0f s with nothing attached: %d events found at rest, %d on the move\n", name_of(kind),
              options.quiet, count[0], count[1]);
}

int run(Arguments& arguments) {
  const Options options = parse(arguments);
  if (options.output) make_folder("--output", *options.output);
  Files files(options.output);
  std::printf("seed %llu\n", static_cast<unsigned long long>(options.seed));
  bool good = true;
  for (const Kind kind : options.kinds) {
    std::printf("\n");
    good = study_payloads(options, kind, files) && good;
    if (options.pushes > 0) good = study_pushes(options, kind) && good;
    if (options.quiet > 0) study_quiet(options, kind);
  }
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_calibration", kUsage, argc, argv, run);
}
