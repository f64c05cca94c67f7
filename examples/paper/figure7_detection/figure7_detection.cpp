// figure7_detection: Figure 7 of the paper, and what it does not show. What do the published detection conditions
// (Algorithm 1, on the norm of tau_ext) and the estimator's own make of a payload that is attached, one that is
// removed, slow hand-overs, and a push?
//
// Both watch the same arm, which holds its pose under CPIC with the estimator's compensation.
#include <algorithm>
#include <cmath>
#include <cstdio>

#include "paper/experiment/report.hpp"
#include "paper/experiment/trial.hpp"

namespace {

using namespace rme::examples;

constexpr double kEvent = 1;    // when it happens [s]
constexpr double kRemoval = 4;  // in that scenario [s]

constexpr const char* kUsage = R"(usage: rme_figure7_detection [options]

Figure 7 of the paper: detection of a payload attached, removed or handed over slowly, and of a push.

Exit codes: 0 the estimator found every payload and took no push for one; 1 not; 2 unusable arguments.

  --trials N        of each scenario (default 20; 2 with --quick)
)";

struct Scenario {
  const char* name;
  double ramp = 0;       // in which the payload weighs in [s]
  bool removal = false;  // looks at the second event
  Push push;             // in place of a payload

  bool is_push() const { return !push.force.isZero(); }
  double event() const { return removal ? kRemoval : kEvent; }
  double end() const { return event() + ramp + 3; }
};

const std::vector<Scenario>& scenarios() {
  static const std::vector<Scenario> all = {{"attach", 0, false, {}},
                                            {"removal", 0, true, {}},
                                            {"hand-over in 0.5 s", 0.5, false, {}},
                                            {"hand-over in 1 s", 1, false, {}},
                                            {"hand-over in 2 s", 2, false, {}},
                                            {"push of 12 N for 1 s", 0, false, {kEvent, 0.15, 0.7, {0, 12, 0}}}};
  return all;
}

/// Times count from the event [s]; what did not happen is missing.
struct Outcome {
  std::optional<double> published;     // the published conditions hold
  std::optional<double> early, final;  // estimates
  double error = 0;                    // of the final mass, or of what is taken to be there in the end [kg]
  bool rejected = false;
};

Outcome run_trial(const Setup& setup, const Scenario& scenario, std::uint64_t number, CsvFile* csv) {
  const auto& q = panda().ready;
  Trial trial(setup.arm(number), HostConfig::hold(panda(), q), q, true);
  rme::MismatchDetector<1> published(kPeriod, rme::MismatchDetectorConfig::published());
  Outcome out;
  int handle = 0;
  for (int k = 0; k < static_cast<int>(scenario.end() / kPeriod); ++k) {
    const double t = k * kPeriod, since = t - scenario.event();
    if (!scenario.is_push() && k == static_cast<int>(kEvent / kPeriod))
      handle = trial.arm.attach(experiment_payload(1.1, {0.05, 0.02, 0.13}), scenario.ramp);
    if (scenario.removal && k == static_cast<int>(kRemoval / kPeriod)) trial.arm.detach(handle);
    if (scenario.is_push()) trial.arm.push({scenario.push.at(t), Eigen::Vector3d::Zero()});
    const double norm = trial.arm.tau_ext().norm();
    (void)published.update(Eigen::Matrix<double, 1, 1>(norm));
    trial.tick();
    const auto& estimator = trial.estimator;
    if (since > 0) {
      if (published.detected() && !out.published) out.published = since;
      if (estimator.refreshed() && !out.early) out.early = since;
      if (estimator.estimated() && !out.final) out.final = since;
      out.rejected = out.rejected || estimator.rejected();
    }
    if (csv && k % 5 == 0)
      csv->row(scenario.name, since, norm, published.rapid_change(), published.stabilised(), published.detected(),
               rme::to_string(estimator.phase()), estimator.estimate().payload().mass, trial.arm.payload().mass);
  }
  out.error = trial.estimator.estimate().payload().mass - trial.arm.payload().mass;
  return out;
}

// "12 of 20, 656 ms": how often, and the median time.
std::string often(std::vector<double> times, std::size_t all) {
  if (times.empty()) return text("0 of %zu", all);
  std::sort(times.begin(), times.end());
  return text("%zu of %zu, %.0f ms", times.size(), all, 1e3 * times[times.size() / 2]);
}

int run(Arguments& arguments) {
  const Setup setup = Setup::parse(arguments);
  const std::size_t trials = arguments.whole("--trials", 1, 1000).value_or(setup.quick ? 2 : 20);
  arguments.finish();

  CsvFile csv(setup.output, "detection.csv", "scenario,t,norm,rapid_change,stabilised,detected,phase,mass,true_mass");
  MarkdownTable table({"event", "published conditions hold", "first early estimate", "final estimate",
                       "taken for no payload", "worst mass error in the end [kg]"});
  bool good = true;
  std::size_t number = 0;
  for (const Scenario& scenario : scenarios()) {
    std::vector<double> published, early, final;
    double worst = 0;
    std::size_t rejected = 0;
    for (std::size_t k = 0; k < trials; ++k) {
      const Outcome out = run_trial(setup, scenario, ++number, k == 0 ? &csv : nullptr);
      if (out.published) published.push_back(*out.published);
      if (out.early) early.push_back(*out.early);
      if (out.final) final.push_back(*out.final);
      rejected += out.rejected && !out.final ? 1 : 0;
      worst = std::max(worst, std::abs(out.error));
      progress("figure7_detection", number, trials * scenarios().size());
    }
    good = good && final.size() == (scenario.is_push() ? 0 : trials);
    table.row({scenario.name, often(published, trials), often(early, trials), often(final, trials),
               text("%zu of %zu", rejected, trials), text("%.3f", worst)});
  }
  std::printf("%s, 1.1 kg, %zu trials each, seed %llu; median times since the event.\n\n", setup.name().c_str(), trials,
              static_cast<unsigned long long>(setup.seed));
  table.print();
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_figure7_detection", std::string(kUsage) + Setup::kUsage, argc, argv, run);
}
