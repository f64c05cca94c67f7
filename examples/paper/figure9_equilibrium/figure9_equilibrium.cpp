// figure9_equilibrium: Figure 9 of the paper. An arm holds its pose under CPIC, and a payload is attached. How far does
// the payload move the arm without compensation, with the published pipeline's compensation, and with the tracker's?
//
// Every trial draws its own sensor offsets and noise. With --output the first trial of each payload is written as CSV:
// the errors over time, and the joint angles for a picture of the arm.
#include <algorithm>
#include <cstdio>

#include "paper/experiment/report.hpp"
#include "paper/experiment/trial.hpp"

namespace {

using namespace rme::examples;

constexpr double kAttach = 1;    // [s]
constexpr double kEnd = 6;       // [s]
constexpr double kSteady = 0.5;  // length of the last part, over which the steady error is averaged [s]
constexpr double kDegree = 180 / 3.14159265358979323846;
constexpr double kPositionTarget = 4e-3, kOrientationTarget = 0.5;  // with the tracker [m], [degrees]

constexpr const char* kUsage = R"(usage: rme_figure9_equilibrium [options]

Figure 9 of the paper: six payloads on an arm that holds its pose, without compensation, with that of the published
pipeline, and with that of the tracker.

Exit codes: 0 with the tracker and link-side sensing, every steady error is at most 4 mm and 0.5 degrees (with
--friction: at most that without compensation); 1 not; 2 unusable arguments.

  --trials N        of each payload (default 5; 1 with --quick)
)";

/// Errors of position [m] and orientation [degrees].
struct Errors {
  double position = 0, orientation = 0;
  void keep_worst(const Errors& o) {
    position = std::max(position, o.position);
    orientation = std::max(orientation, o.orientation);
  }
};
struct Result {
  Errors steady, peak;
};

struct Files {
  CsvFile errors, with, without;  // errors; joint angles with the tracker's compensation, and without compensation
};

Result run_trial(const Setup& setup, const PublishedTrial& payload, std::uint64_t number, Method method, Files* files) {
  const auto& q = panda().ready;
  Trial trial(setup.arm(number), HostConfig::hold(panda(), q), q, method);
  Result result;
  double ticks = 0;
  for (int k = 0; k < static_cast<int>(kEnd / kPeriod); ++k) {
    const double t = k * kPeriod;
    if (k == static_cast<int>(kAttach / kPeriod)) trial.arm.attach(experiment_payload(payload.mass, payload.com));
    trial.tick();
    const Errors now = {trial.position_error().norm(), kDegree * trial.orientation_error()};
    result.peak.keep_worst(now);
    if (t > kEnd - kSteady) {
      result.steady.position += now.position;
      result.steady.orientation += now.orientation;
      ++ticks;
    }
    if (files && k % 10 == 0) {
      const auto& at = trial.arm.q();
      files->errors.row(payload.mass, name_of(method), t - kAttach, now.position, now.orientation);
      if (method == Method::Published) continue;
      (method == Method::Tracker ? files->with : files->without)
          .row(payload.mass, t - kAttach, at[0], at[1], at[2], at[3], at[4], at[5], at[6]);
    }
  }
  result.steady.position /= ticks;
  result.steady.orientation /= ticks;
  return result;
}

int run(Arguments& arguments) {
  const Setup setup = Setup::parse(arguments);
  const std::size_t trials = arguments.whole("--trials", 1, 1000).value_or(setup.quick ? 1 : 5);
  arguments.finish();

  const std::string joints = "m,t,q1,q2,q3,q4,q5,q6,q7";
  Files files{{setup.output, "errors.csv", "m,method,t,position,orientation"},
              {setup.output, "equilibrium_with.csv", joints},
              {setup.output, "equilibrium_without.csv", joints}};
  MarkdownTable steady(
      {"payload [kg]", "no compensation [mm]", "[deg]", "published pipeline [mm]", "[deg]", "tracker [mm]", "[deg]"});
  MarkdownTable peak({"payload [kg]", "no compensation [mm]", "published pipeline [mm]", "tracker [mm]"});
  std::size_t number = 0;
  bool reached = true;
  for (const PublishedTrial& payload : published_trials()) {
    std::array<Result, kMethods.size()> worst;
    for (std::size_t k = 0; k < trials; ++k) {
      ++number;
      for (std::size_t i = 0; i < kMethods.size(); ++i) {
        const Result result = run_trial(setup, payload, number, kMethods[i], k == 0 ? &files : nullptr);
        worst[i].steady.keep_worst(result.steady);
        worst[i].peak.keep_worst(result.peak);
      }
      progress("figure9_equilibrium", number, trials * published_trials().size());
    }
    const auto& [alone, published, tracker] = worst;
    std::vector<std::string> cells = {text("%.3f", payload.mass)};
    for (const Result& r : worst) {
      cells.push_back(text("%.2f", 1e3 * r.steady.position));
      cells.push_back(text("%.3f", r.steady.orientation));
    }
    steady.row(cells);
    peak.row({text("%.3f", payload.mass), text("%.1f", 1e3 * alone.peak.position),
              text("%.1f", 1e3 * published.peak.position), text("%.1f", 1e3 * tracker.peak.position)});
    const Errors limit = setup.friction ? alone.steady : Errors{kPositionTarget, kOrientationTarget};
    reached = reached && tracker.steady.position <= limit.position && tracker.steady.orientation <= limit.orientation;
  }
  std::printf(
      "%s, seed %llu: position and orientation error, averaged from %.1f to %.1f s after the attachment;\n"
      "the largest average of %zu trials of each payload.\n\n",
      setup.name().c_str(), static_cast<unsigned long long>(setup.seed), kEnd - kSteady - kAttach, kEnd - kAttach,
      trials);
  steady.print();
  std::printf("The largest position error from the attachment on:\n\n");
  peak.print();
  return reached ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_figure9_equilibrium", std::string(kUsage) + Setup::kUsage, argc, argv, run);
}
