// posterior_families: how much accuracy is lost with a simpler family of posteriors, or with the published solver?
//
// Simulates a Panda that holds a random pose under an impedance law. Its torque sensors have noise and offsets, its
// joints have friction, and in every other arm the sensed torque contains the friction. After one second an unknown
// payload is attached to the flange, and 200 ms of samples are collected once the arm has settled, as in the paper. All
// four solvers then infer from the same samples: the exact posterior, the Gaussian of full covariance, the diagonal
// Gaussian, and the published stochastic ELBO. They do so first with a likelihood in which the observer is matched and
// offset and friction are marginalised, then with the published one (50 samples, white noise). The last line is the
// published inference but for the prior: there is no network here, and all solvers use the same fixed prior.
//
// Prints the mean absolute error of each parameter, how often its 90 % interval holds the truth, by how much the ELBO
// is below the exact log evidence, and the time of one call.
#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <cstdio>
#include <optional>
#include <random>
#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/fixed_prior.hpp>
#include <rme/inference/mean_field.hpp>
#include <rme/inference/published_likelihood.hpp>
#include <rme/inference/sensor_model.hpp>
#include <rme/inference/stochastic_vi.hpp>
#include <rme/inference/variational_inference.hpp>
#include <rme/sensing/sample_window.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/program.hpp"
#include "paper/calibration/random_host.hpp"
#include "paper/calibration/scores.hpp"

namespace {

using namespace rme::examples;
using Likelihood = rme::PayloadLikelihood<double>;
using Sums = rme::PayloadStatistics<double, 7>;
using Window = rme::SampleWindow<double, 7>;

constexpr double kAttach = 1;     // time of the attach [s]
constexpr double kSettled = 1.5;  // from the attach until samples are collected: the arm sags no more [s]
constexpr int kCollected = 200;   // samples, as in the paper
constexpr int kQuiet = 300;       // samples before the attach, from which the sensors' offsets are estimated

constexpr const char* kUsage =
    R"(usage: rme_posterior_families [options]

Infers the same simulated payloads with four solvers and two likelihoods, and prints the errors and the time of each.

  --events N        payloads (default 1000)
  --truth NAME      distribution of the payloads: prior (that of the inference, default) or uniform (0.2 to 2 kg).
                    Only with prior do exact posteriors hold the truth as often as they state
  --seed N          of everything random (default 1)
  --quick           100 payloads; fails unless the ELBOs are ordered as they must be, the intervals of the exact and the
                    full posterior hold the truth often enough, and those of the diagonal one less often
  --help            this text

Exit codes: 0 done; 1 an inference failed, or what --quick checks; 2 unusable arguments.
)";

constexpr std::size_t kExact = 0, kFull = 1, kMeanField = 2, kSolvers = 4;  // 3 is stochastic VI
constexpr const char* kSolverNames[] = {"exact", "full covariance", "mean field", "stochastic VI"};
constexpr std::size_t kMarginalised = 0, kPublished = 1, kModels = 2;
constexpr const char* kModelNames[] = {"observer matched, offset and friction marginalised",
                                       "the published likelihood"};

struct Options {
  std::size_t events = 1000;
  std::uint64_t seed = 1;
  bool from_prior = true;
  bool quick = false;
};

Options parse(Arguments& arguments) {
  Options options;
  options.quick = arguments.flag("--quick");
  options.events = arguments.whole("--events", 1, 1000000).value_or(options.quick ? 100 : 1000);
  options.seed = arguments.whole("--seed", 0).value_or(1);
  options.from_prior = arguments.choice<bool>("--truth", {{"prior", true}, {"uniform", false}}).value_or(true);
  arguments.finish();
  return options;
}

/// The sample of this age (0: the newest). The arm is at rest, or nearly so.
/// @param matched  whether the observer's lag is removed from the torque
rme::PayloadObservation<double, 7> observation(const Window& window, int age, bool matched) {
  const auto& s = window.newest(static_cast<std::size_t>(age));
  return {matched ? s.tau : s.raw.tau_ext,
          rme::payload_regressor<double, 7>(s.raw.jacobian, s.raw.rotation, panda().gravity_vector), s.direction,
          s.raw.dq};
}

Sums sums(const Window& window, int count) {
  Sums sums;
  for (int age = count; age-- > 0;) sums.add(observation(window, age, true));
  return sums;
}

void require_ok(rme::Status status) {
  if (status != rme::Status::Ok) throw std::runtime_error(to_string(status));
}

/// The true payload of a run, and the two likelihoods of the samples.
struct Data {
  Eigen::Vector4d truth;
  Likelihood likelihood[kModels];
};

Data simulate(const Options& options, std::size_t run) {
  RandomHost random(options.seed, run);
  std::optional<rme::PayloadGaussian<double>> prior;
  if (options.from_prior) prior = rme::FixedPrior<double>().gaussian;
  const Draw draw = random.draw(run % 2 == 0 ? Kind::LinkSide : Kind::JointFriction, prior);
  SyntheticArm<7> arm(panda(), draw.arm, draw.start);
  const PoseImpedance<7> controller(panda(), draw.target);
  Window window(kPeriod);
  const auto run_until = [&](double time) {
    while (arm.time() < time - kPeriod / 2) {
      const auto& [position, rotation, jacobian] = arm.kinematics();
      require_ok(window.push({arm.tau_ext(), jacobian, rotation, arm.dq()}));
      arm.step(controller.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()));
    }
  };
  const auto sensor =
      draw.friction_shows ? rme::SensorModel<double, 7>::joint_friction() : rme::SensorModel<double, 7>::link_side();
  const Torque precision = sensor.precision(kPeriod);

  run_until(kAttach);
  rme::NuisanceGaussian<double, 7> baseline;
  require_ok(sums(window, kQuiet).nuisance_posterior(precision, sensor.prior(), baseline));
  arm.attach(draw.payload);
  run_until(kAttach + kSettled + kCollected * kPeriod);

  Data data;
  data.truth << draw.payload.mass, draw.payload.com;
  require_ok(
      sums(window, kCollected).likelihood(precision, sensor.after_event(baseline), data.likelihood[kMarginalised]));
  const auto oldest_first = [&window](int i) { return observation(window, kCollected - 1 - i, false); };
  require_ok(rme::published_likelihood<double, 7>(kCollected, oldest_first, data.likelihood[kPublished]));
  return data;
}

/// One solver's answers for all events.
struct Answers {
  std::vector<Scored> scored;
  std::vector<double> log_evidence, microseconds;
};

/// Runs a solver on all events, and measures the time of each call.
/// @param solver  callable (const Likelihood&, rme::InferenceResult<double>&) -> rme::Status
template <typename Infer>
Answers ask(const std::vector<Data>& events, std::size_t model, const Infer& solver) {
  Answers answers;
  for (const Data& event : events) {
    rme::InferenceResult<double> result;
    const auto start = std::chrono::steady_clock::now();
    const rme::Status status = solver(event.likelihood[model], result);
    const auto elapsed = std::chrono::steady_clock::now() - start;
    if (status != rme::Status::NotConverged) require_ok(status);  // the published solver may run out of steps
    Scored s;
    s.truth = event.truth;
    s.error = result.posterior.mean - event.truth;
    s.deviation = result.posterior.standard_deviation();
    answers.scored.push_back(s);
    answers.log_evidence.push_back(result.log_evidence);
    answers.microseconds.push_back(std::chrono::duration<double, std::micro>(elapsed).count());
  }
  return answers;
}

/// Runs all solvers.
std::array<Answers, kSolvers> ask_all(const std::vector<Data>& events, std::size_t model, std::uint64_t seed) {
  const auto prior = rme::FixedPrior<double>().gaussian;
  std::mt19937_64 random(seed);
  const auto with = [&](const auto& config, auto&... generator) {
    return ask(events, model, [&](const Likelihood& likelihood, rme::InferenceResult<double>& result) {
      return infer_payload(likelihood, prior, result, config, generator...);
    });
  };
  return {with(rme::ExactQuadrature()), with(rme::VariationalInferenceConfig()), with(rme::MeanFieldConfig()),
          with(rme::StochasticViConfig(), random)};
}

void print(const char* name, const Answers& answers, const Answers& exact) {
  std::printf("%-16s", name);
  Summary summary[4];
  for (int i = 0; i < 4; ++i) summary[i] = summarise(answers.scored, i);
  for (const Summary& s : summary) std::printf(" %6.1f", s.mean_absolute);
  std::printf(" |");
  for (const Summary& s : summary) std::printf(" %5.1f", s.coverage[2]);
  std::printf(" |");
  for (const Summary& s : summary) std::printf(" %6.1f", s.half_width);
  double gap = 0;
  for (std::size_t k = 0; k < exact.log_evidence.size(); ++k)
    gap += (exact.log_evidence[k] - answers.log_evidence[k]) / static_cast<double>(exact.log_evidence.size());
  std::vector<double> times = answers.microseconds;
  std::nth_element(times.begin(), times.begin() + static_cast<std::ptrdiff_t>(times.size() / 2), times.end());
  std::printf(" | %8.3f | %8.1f\n", gap, times[times.size() / 2]);
}

/// What --quick checks, with the likelihood that marginalises. @return whether all of it holds
bool check(const std::array<Answers, kSolvers>& answers) {
  bool good = true;
  const auto expect = [&good](bool holds, const char* what) {
    if (!holds) std::fprintf(stderr, "rme_posterior_families: %s\n", what);
    good = good && holds;
  };
  bool ordered = true;
  for (std::size_t k = 0; k < answers[kExact].log_evidence.size(); ++k) {
    const double exact = answers[kExact].log_evidence[k], full = answers[kFull].log_evidence[k];
    const double slack = 1e-6 + 1e-9 * std::abs(exact);
    ordered = ordered && full <= exact + slack && answers[kMeanField].log_evidence[k] <= full + slack;
  }
  expect(ordered, "a bound lies above that of a family that contains it");
  double full = 0, mean_field = 0;
  for (int i = 0; i < 4; ++i) {
    for (const std::size_t solver : {kExact, kFull}) {
      const double coverage = summarise(answers[solver].scored, i).coverage[2];
      expect(coverage >= 80, "fewer than 80 % of an honest posterior's 90 % intervals hold the truth");
    }
    full += summarise(answers[kFull].scored, i).coverage[2] / 4;
    mean_field += summarise(answers[kMeanField].scored, i).coverage[2] / 4;
  }
  expect(mean_field < full - 10, "the diagonal posterior's intervals hold the truth almost as often as the full one's");
  return good;
}

int run(Arguments& arguments) {
  const Options options = parse(arguments);
  std::vector<Data> events;
  for (std::size_t run = 0; run < options.events; ++run) {
    events.push_back(simulate(options, run));
    if ((run + 1) % 100 == 0) std::fprintf(stderr, "%zu of %zu payloads\n", run + 1, options.events);
  }
  std::printf("%zu payloads, seed %llu\n", options.events, static_cast<unsigned long long>(options.seed));
  bool good = true;
  for (const std::size_t model : {kMarginalised, kPublished}) {
    const auto answers = ask_all(events, model, options.seed);
    std::printf("\n%s\n%-16s %-27s | %-23s | %-27s | %8s | %8s\n%-16s", kModelNames[model], "", "mean absolute error",
                "90 % intervals hold [%]", "half width of these", "ELBO", "median", "");
    std::printf(" %6s %6s %6s %6s |", "m [g]", "x [mm]", "y", "z");
    std::printf(" %5s %5s %5s %5s |", "m", "x", "y", "z");
    std::printf(" %6s %6s %6s %6s | %8s | %8s\n", "m [g]", "x [mm]", "y", "z", "short by", "us");
    for (std::size_t k = 0; k < kSolvers; ++k) print(kSolverNames[k], answers[k], answers[kExact]);
    if (options.quick && model == kMarginalised) good = check(answers);
  }
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_posterior_families", kUsage, argc, argv, run);
}
