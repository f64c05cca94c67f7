// calibration: are the intervals honest? Do pushes pass for payloads, or payloads for pushes, and is anything seen
// where there is nothing?
//
// Simulates a Panda in random poses that holds still under an impedance law; its torque sensors have noise and offsets,
// its joints friction, all drawn anew for each run. After one second an unknown payload hangs on its flange. Printed
// are for each parameter the errors, how often the 50, 80, 90 and 95 % intervals hold the truth, and the rank histogram
// (simulation-based calibration: where the truth lies in the posterior, in tenths; level if the posteriors are honest).
// This is done for the estimator as it comes, which averages over both kinds of arm, and for one that knows which kind
// of arm it has.
//
// --pushes adds as many runs in which a hand pushes an empty arm, --quiet that many seconds in which nothing happens.
//
// A calibrated posterior has level ranks only if the truths come from its own prior. "--truth prior" draws them there.
// The default draws them uniformly from the payloads that one may meet, which is what a user cares about; where the
// data say little (the centre of mass along gravity), coverage then says as much about the prior as about the
// inference. Either way a payload too light to be noticed gets no estimate and is not in the tables, only in the count
// of those missed.
#include <algorithm>
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

constexpr double kAttach = 1;   // when the payload or the push comes [s]
constexpr double kWatched = 2;  // how long an event is watched from then on, and a push after its end [s]

constexpr const char* kUsage =
    R"(usage: rme_calibration [options]

Simulates random payloads on a random arm and says how good and how honest the estimates are.

  --events N        payloads to attach (default 500)
  --sensing NAME    what the torque sensors see of the joint friction: link_side, joint_friction, or mixed, one or the
                    other with even odds (default)
  --preset NAME     what the estimator takes the arm for: unknown (average over both), link_side, joint_friction, or
                    matching (the kind that it is); default: unknown and matching, one after the other
  --truth NAME      where payloads come from: uniform (0.2 to 2 kg, default) or prior (the estimator's own prior)
  --pushes N        also N pushes of 5 to 30 N that last 0.3 to 2 s, in any direction
  --quiet S         also S seconds with nothing attached: half at rest, half following a moving target
  --seed N          of everything random (default 1)
  --threads N       (default 1); the result does not depend on it
  --output DIR      write events.csv and ranks.csv there; the folder is made if need be. plot.py draws them
  --help            this text

Exit codes: 0 done; 1 no payload was noticed; 2 unusable arguments.
)";

struct Options {
  std::size_t events = 500, pushes = 0, threads = 1;
  double quiet = 0;
  std::uint64_t seed = 1;
  Sensing sensing = Sensing::Mixed;
  Truth truth = Truth::Uniform;
  std::vector<std::string> presets = {"unknown", "matching"};
  std::optional<std::string> output;
};

Options parse(Arguments& arguments) {
  Options options;
  options.events = arguments.whole("--events", 1, 1000000).value_or(options.events);
  options.pushes = arguments.whole("--pushes", 0, 1000000).value_or(0);
  options.threads = arguments.whole("--threads", 1, 1000).value_or(1);
  options.seed = arguments.whole("--seed", 0).value_or(1);
  options.quiet = arguments.number("--quiet").value_or(0);
  if (!(options.quiet >= 0 && options.quiet <= 1e6)) throw ArgumentError("--quiet: must be from 0 to 1e6 s");
  options.sensing = arguments
                        .choice<Sensing>("--sensing", {{"link_side", Sensing::LinkSide},
                                                       {"joint_friction", Sensing::JointFriction},
                                                       {"mixed", Sensing::Mixed}})
                        .value_or(Sensing::Mixed);
  options.truth = arguments.choice<Truth>("--truth", {{"uniform", Truth::Uniform}, {"prior", Truth::Prior}})
                      .value_or(Truth::Uniform);
  using Presets = std::vector<std::string>;
  options.presets = arguments
                        .choice<Presets>("--preset", {{"unknown", {"unknown"}},
                                                      {"link_side", {"link_side"}},
                                                      {"joint_friction", {"joint_friction"}},
                                                      {"matching", {"matching"}}})
                        .value_or(options.presets);
  options.output = arguments.text("--output");
  arguments.finish();
  return options;
}

/// One estimator for each preset.
std::vector<rme::EventEstimatorConfig<double, 7>> configurations(const Options& options, bool friction_shows) {
  std::vector<rme::EventEstimatorConfig<double, 7>> configs;
  for (const std::string& preset : options.presets) {
    rme::EventEstimatorConfig<double, 7> config;
    if (preset == "link_side" || (preset == "matching" && !friction_shows))
      config.sensors = {rme::SensorModel<double, 7>::link_side()};
    else if (preset != "unknown")
      config.sensors = {rme::SensorModel<double, 7>::joint_friction()};
    configs.push_back(config);
  }
  return configs;
}

/// Calls work(0) ... work(count - 1), spread over threads, and says on stderr how far it has come.
template <typename Work>
void for_each(std::size_t count, const Options& options, const char* what, const Work& work) {
  std::atomic<std::size_t> next{0}, done{0};
  std::exception_ptr failure;
  std::mutex mutex;
  const auto worker = [&] {
    try {
      for (std::size_t i = next++; i < count; i = next++) {
        work(i);
        if (++done % 100 == 0) std::fprintf(stderr, "%zu of %zu %s\n", done.load(), count, what);
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

/// What one estimator made of one payload.
struct Event {
  std::optional<Scored> scored;  // the first estimate after the attach
  int refused = 0;               // rejections before it
  int surplus = 0;               // estimates before the attach and after the first
};

/// What all estimators made of it.
struct Events {
  std::vector<Event> of_preset;
  int skipped = 0;
};

Events attach_payload(const Options& options, std::size_t run) {
  RandomHost random(options.seed, run);
  const Draw draw = random.draw(options.sensing, options.truth);
  Host host(draw, configurations(options, draw.friction_shows));
  Eigen::Vector3d down = Eigen::Vector3d::Zero();  // at the attach, flange axes: the arm sags little
  while (host.arm().time() < kAttach - kPeriod / 2) host.tick();
  host.arm().attach(draw.payload);
  while (host.arm().time() < kAttach + kWatched) {
    host.tick();
    if (host.arm().time() < kAttach + kWatched / 4)
      down = host.arm().kinematics().rotation.transpose() * panda().gravity_vector.normalized();
  }
  Events events;
  events.skipped = draw.skipped;
  for (std::size_t k = 0; k < options.presets.size(); ++k) {
    Event event;
    for (const Answer& answer : host.answers(k)) {
      if (answer.rejected) {
        event.refused += event.scored || answer.t < kAttach ? 0 : 1;
      } else if (event.scored || answer.t < kAttach || answer.empty) {
        ++event.surplus;
      } else {
        Scored s;
        s.truth << draw.payload.mass, draw.payload.com;
        s.error = answer.posterior.mean - s.truth;
        s.deviation = answer.posterior.standard_deviation();
        const Eigen::Vector3d com = s.error.tail<3>();
        s.across = (com - down * down.dot(com)).norm();
        s.detection_delay = answer.detected_at - kAttach;
        s.delay = answer.t - kAttach;
        s.friction_shows = draw.friction_shows;
        event.scored = s;
      }
    }
    events.of_preset.push_back(event);
  }
  return events;
}

void print(const std::vector<Scored>& scored) {
  std::printf("%-9s %7s %7s %7s |%7s%7s%7s%7s  %% hold |%11s | ranks in tenths\n", "", "mae", "rms", "bias", "50", "80",
              "90", "95", "half width");
  for (int i = 0; i < 4; ++i) {
    const Summary s = summarise(scored, i);
    std::printf("%-9s %7.2f %7.2f %7.2f |", kParameters[static_cast<std::size_t>(i)], s.mean_absolute, s.rms, s.bias);
    for (const double coverage : s.coverage) std::printf("%7.1f", coverage);
    std::printf("         |%11.2f |", s.half_width);
    for (const int count : s.ranks) std::printf(" %3d", count);
    std::printf("\n");
  }
  double across = 0, detection = 0, delay = 0;
  const double n = static_cast<double>(scored.size());
  for (const Scored& s : scored) {
    across += s.across / n;
    detection += s.detection_delay / n;
    delay += s.delay / n;
  }
  const auto [least, most] = expected_counts(scored.size());
  std::printf("centre of mass across gravity: %.2f mm off on average; noticed after %.0f ms, estimated after %.0f ms\n",
              1e3 * across, 1e3 * detection, 1e3 * delay);
  std::printf("half width: of the 90 %% interval; ranks of an honest posterior: %.0f to %.0f in 99 %% of cases\n",
              least, most);
}

void write_csv(const std::filesystem::path& folder, const Options& options,
               const std::vector<std::vector<Scored>>& scored) {
  std::ofstream events(folder / "events.csv"), ranks(folder / "ranks.csv");
  events << "preset,friction_shows,mass,x,y,z,mass_error,x_error,y_error,z_error,mass_std,x_std,y_std,z_std,across,"
            "detection_delay,delay\n";
  ranks << "preset,parameter,bin,count,least,most\n";
  const Eigen::IOFormat cells(Eigen::StreamPrecision, Eigen::DontAlignCols, ",", ",");
  const char* names[] = {"mass", "x", "y", "z"};
  for (std::size_t k = 0; k < scored.size(); ++k) {
    for (const Scored& s : scored[k])
      events << options.presets[k] << ',' << s.friction_shows << ',' << s.truth.format(cells) << ','
             << s.error.format(cells) << ',' << s.deviation.format(cells) << ',' << s.across << ',' << s.detection_delay
             << ',' << s.delay << '\n';
    const auto [least, most] = expected_counts(scored[k].size());
    for (int i = 0; i < 4; ++i) {
      const Summary summary = summarise(scored[k], i);
      for (std::size_t bin = 0; bin < kBins; ++bin)
        ranks << options.presets[k] << ',' << names[i] << ',' << bin << ',' << summary.ranks[bin] << ',' << least << ','
              << most << '\n';
    }
  }
  if (!events.flush() || !ranks.flush()) throw ArgumentError("--output: cannot write to " + folder.string());
}

/// @return whether every preset has noticed a payload
bool study_payloads(const Options& options) {
  std::vector<Events> runs(options.events);
  for_each(options.events, options, "payloads", [&](std::size_t i) { runs[i] = attach_payload(options, i); });
  int skipped = 0;
  for (const Events& events : runs) skipped += events.skipped;
  std::printf("%zu payloads; %d draws skipped that the arm could not have held\n", options.events, skipped);
  std::vector<std::vector<Scored>> scored(options.presets.size());
  bool all = true;
  for (std::size_t k = 0; k < options.presets.size(); ++k) {
    int refused = 0, unnoticed = 0, surplus = 0;
    for (const Events& events : runs) {
      const Event& event = events.of_preset[k];
      if (event.scored)
        scored[k].push_back(*event.scored);
      else
        ++(event.refused > 0 ? refused : unnoticed);
      surplus += event.surplus;
    }
    std::printf("\nsensing of the arm: %s\n", options.presets[k].c_str());
    if (scored[k].empty())
      all = false;
    else
      print(scored[k]);
    std::printf("%zu estimated, %d not noticed, %d refused (%.2f %%); %d surplus estimates\n", scored[k].size(),
                unnoticed, refused, 100.0 * refused / static_cast<double>(options.events), surplus);
  }
  if (options.output) write_csv(*options.output, options, scored);
  return all;
}

/// @return for each preset the number of estimates, where there is nothing to estimate
std::vector<int> push_arm(const Options& options, std::size_t run) {
  RandomHost random(options.seed + 1, run);
  const Draw draw = random.draw(options.sensing, options.truth, false);
  Host host(draw, configurations(options, draw.friction_shows));
  const Eigen::Vector3d force = random.uniform(5, 30) * random.direction();
  const double duration = random.uniform(0.3, 2);
  constexpr double kRamp = 0.05;  // at both ends [s]
  while (host.arm().time() < kAttach + duration + kWatched) {
    const double since = host.arm().time() - kAttach;
    const double share = std::clamp(std::min(since, duration - since) / kRamp, 0.0, 1.0);
    host.arm().push({share * force, Eigen::Vector3d::Zero()});
    host.tick();
  }
  std::vector<int> accepted;
  for (std::size_t k = 0; k < options.presets.size(); ++k)
    accepted.push_back(static_cast<int>(std::count_if(host.answers(k).begin(), host.answers(k).end(),
                                                      [](const Answer& answer) { return !answer.rejected; })));
  return accepted;
}

void study_pushes(const Options& options) {
  std::vector<std::vector<int>> accepted(options.pushes);
  for_each(options.pushes, options, "pushes", [&](std::size_t i) { accepted[i] = push_arm(options, i); });
  std::printf("\n%zu pushes of 5 to 30 N\n", options.pushes);
  for (std::size_t k = 0; k < options.presets.size(); ++k) {
    int taken = 0;
    for (const auto& of_run : accepted) taken += of_run[k] > 0 ? 1 : 0;
    std::printf("sensing of the arm: %-15s %d taken for a payload (%.2f %%)\n", options.presets[k].c_str(), taken,
                100.0 * taken / static_cast<double>(options.pushes));
  }
}

constexpr double kQuietRun = 30;  // length of one quiet run [s]

/// An arm of its own, at rest or on the move. @return for each preset the number of estimates
std::vector<int> leave_alone(const Options& options, std::size_t run, double duration) {
  RandomHost random(options.seed + 2, run);
  Draw draw = random.draw(options.sensing, options.truth, false);
  Host host(draw, configurations(options, draw.friction_shows));
  Torque amplitude = Torque::Zero(), frequency;  // of the target [rad, rad/s]
  for (int i = 0; i < 7; ++i) {
    if (run % 2 == 1) amplitude[i] = random.uniform(0.05, 0.25);
    frequency[i] = 2 * 3.14159265358979 * random.uniform(0.05, 0.3);
  }
  while (host.arm().time() < duration) {
    if (run % 2 == 1)
      host.hold(draw.target + amplitude.cwiseProduct((frequency * host.arm().time()).array().sin().matrix()));
    host.tick();
  }
  std::vector<int> estimates;
  for (std::size_t k = 0; k < options.presets.size(); ++k)
    estimates.push_back(static_cast<int>(std::count_if(host.answers(k).begin(), host.answers(k).end(),
                                                       [](const Answer& answer) { return !answer.rejected; })));
  return estimates;
}

void study_quiet(const Options& options) {
  const auto runs = 2 * static_cast<std::size_t>(std::ceil(options.quiet / 2 / kQuietRun));
  const double duration = options.quiet / static_cast<double>(runs);
  std::vector<std::vector<int>> estimates(runs);
  for_each(runs, options, "quiet runs", [&](std::size_t i) { estimates[i] = leave_alone(options, i, duration); });
  std::printf("\n%.0f s with nothing attached\n", options.quiet);
  for (std::size_t k = 0; k < options.presets.size(); ++k) {
    int resting = 0, moving = 0;
    for (std::size_t i = 0; i < runs; ++i) (i % 2 == 1 ? moving : resting) += estimates[i][k];
    std::printf("sensing of the arm: %-15s %d false estimates at rest, %d on the move\n", options.presets[k].c_str(),
                resting, moving);
  }
}

int run(Arguments& arguments) {
  const Options options = parse(arguments);
  if (options.output) make_folder("--output", *options.output);
  const bool noticed = study_payloads(options);
  if (options.pushes > 0) study_pushes(options);
  if (options.quiet > 0) study_quiet(options);
  return noticed ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_calibration", kUsage, argc, argv, run);
}
