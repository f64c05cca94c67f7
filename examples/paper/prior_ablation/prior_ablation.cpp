// prior_ablation: what is the network's guess worth as a prior? Figure 10 of the paper.
//
// Simulates a Panda in random poses that holds still under an impedance law; its torque sensors have noise and offsets,
// its joints friction, which the sensors of every other arm feel. After one second an unknown payload hangs on its
// flange. The same samples are then inferred from with three priors: the network's, one of the same widths around zero,
// and the fixed prior that needs no training; and with two likelihoods: the estimator's, and the published one (50
// samples, white noise), which goes with the published widths around the network's bare guess. Printed are the mean
// square error of each parameter and how often its 90 % interval holds the truth, beside what the network says on its
// own.
//
// Posteriors of the published likelihood are Gaussians of full covariance as well: the paper's are diagonal, and their
// intervals therefore narrower.
#include <array>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <rme/inference/published_likelihood.hpp>
#include <rme/inference/variational_inference.hpp>
#include <string>
#include <vector>

#include "io/program.hpp"
#include "paper/calibration/random_host.hpp"
#include "paper/calibration/scores.hpp"
#include "run_network/network_file.hpp"
#include "synthetic_arm/random_pose.hpp"

namespace {

using namespace rme::examples;

constexpr double kAttach = 1;   // when the payload comes [s]
constexpr double kWatched = 2;  // how long it may take until it is noticed [s]

constexpr const char* kUsage =
    R"(usage: rme_prior_ablation --weights W.json [options]

Infers simulated payloads with the network's prior, a zero prior and the fixed one, and says how far off they are.

  --weights W.json  the network: examples/models/panda.json
  --data-sets N     payloads to simulate (default 100)
  --seed N          of everything random (default 1)
  --pose NAME       any (default), or ready: N(0, 0.1 rad) around the ready pose, as in the paper
  --quick           60 payloads; fails unless the network's prior halves the zero prior's mean square error along the
                    flange's axis, and is better in each coordinate of the centre of mass under the published
                    likelihood, where a guess that is off does harm
  --output DIR      write data_sets.csv there; the folder is made if need be. plot.py draws it
  --help            this text

Exit codes: 0 done; 1 a simulation failed, or what --quick checks; 2 unusable arguments.
)";

enum Prior : std::size_t { kNetwork, kZero, kFixed, kPriors };
constexpr const char* kPriorNames[] = {"network", "zero", "fixed"};
enum Likelihood : std::size_t { kEstimator, kPublished, kLikelihoods };
constexpr const char* kLikelihoodNames[] = {"estimator", "published"};

struct Options {
  std::size_t data_sets = 100;
  std::uint64_t seed = 1;
  bool quick = false;
  bool ready = false;  // near the ready pose, or anywhere
  NetworkFile network;
  std::optional<std::string> output;
};

Options parse(Arguments& arguments) {
  Options options;
  options.quick = arguments.flag("--quick");
  options.data_sets = arguments.whole("--data-sets", 1, 1000000).value_or(options.quick ? 60 : 100);
  options.seed = arguments.whole("--seed", 0).value_or(1);
  options.ready = arguments.choice<bool>("--pose", {{"any", false}, {"ready", true}}).value_or(false);
  options.output = arguments.text("--output");
  const auto weights = arguments.text("--weights");
  if (!weights) throw ArgumentError("--weights: missing");
  arguments.finish();
  try {
    options.network = read_network_file(*weights);
  } catch (const std::exception& error) {
    throw ArgumentError("--weights: " + *weights + ": " + error.what());
  }
  return options;
}

/// What happened when a prior was asked: the network's own guess, if it is one, and what the published inference makes
/// of the samples.
struct Record {
  std::optional<Eigen::Vector4d> guess;
  rme::PayloadGaussian<double> published;
};

/// One of the priors. Keeps a record of the last time it was asked.
class AblationPrior {
 public:
  /// @param record  must outlive the prior
  AblationPrior(Prior kind, const NetworkFile& file, Record& record)
      : kind_(kind), network_(*file.network, kPeriod, file.config), record_(&record) {}

  rme::PayloadGaussian<double> operator()(const rme::SampleWindow<double, 7>& window,
                                          std::size_t count) const noexcept {
    const rme::PayloadGaussian<double> fixed = rme::FixedPrior<double>()(window, count);
    rme::PayloadGaussian<double> prior = kind_ == kFixed ? fixed : network_(window, count), published = fixed;
    Eigen::Vector4d guess;
    record_->guess.reset();
    if (network_.guess(window, count, guess)) record_->guess = guess;
    if (kind_ != kFixed)
      published = rme::PayloadGaussian<double>::independent(record_->guess.value_or(fixed.mean),
                                                            Eigen::Vector4d(0.5, 0.02, 0.02, 0.05));
    if (kind_ == kZero) {
      prior.mean.setZero();
      published.mean.setZero();
    }
    rme::PayloadLikelihood<double> likelihood;
    rme::InferenceResult<double> result;
    const auto observation = [&](int i) {  // raw torque, gravity alone
      const auto& sample = window.newest(count - 1 - static_cast<std::size_t>(i)).raw;
      rme::PayloadObservation<double, 7> o;
      o.tau = sample.tau_ext;
      o.regressor =
          rme::payload_regressor<double, 7>(sample.jacobian, sample.rotation, rme::standard_gravity<double>());
      return o;
    };
    if (rme::published_likelihood<double, 7>(static_cast<int>(count), observation, likelihood) != rme::Status::Ok)
      return prior;
    const rme::Status status = rme::infer(likelihood, published, result);
    // Not converged is the best iterate; anything else cannot happen to a finite window.
    if (status == rme::Status::Ok || status == rme::Status::NotConverged) record_->published = result.posterior;
    return prior;
  }

 private:
  Prior kind_;
  rme::NetworkPrior<double> network_;
  Record* record_;
};

/// One data set: what is true, what the network guessed, and the posteriors.
struct DataSet {
  Eigen::Vector4d truth;
  std::optional<Eigen::Vector4d> guess;  // of the network, unless the window was foreign to it
  rme::PayloadGaussian<double> posterior[kLikelihoods][kPriors];
};

/// @return nothing if an estimator has noticed no payload
std::optional<DataSet> simulate(const Options& options, std::size_t run) {
  RandomHost random(options.seed, run);
  Draw draw = random.draw(Sensing::Mixed, Truth::Uniform);
  // Poses as the network was trained in, if not these.
  draw.start = options.ready ? Torque(panda().ready + Torque::NullaryExpr([&] { return random.normal(0, 0.1); }))
                             : random_panda_pose([&](double low, double high) { return random.uniform(low, high); });
  draw.target = draw.start + Torque::NullaryExpr([&] { return random.normal(0, 0.005); });
  std::array<Record, kPriors> records;
  std::vector<AblationPrior> priors;
  for (const Prior kind : {kNetwork, kZero, kFixed}) priors.emplace_back(kind, options.network, records[kind]);
  // How good the estimates are is the question, not whether this is a payload: next to no push is expected.
  rme::EventEstimatorConfig<double, 7> config;
  config.push = {1e-3, 1e-3};
  config.refresh = 0;  // early estimates of one prior would move the arm while all of them listen
  Host<AblationPrior> host(draw, std::vector(kPriors, config), priors);
  while (host.arm().time() < kAttach - kPeriod / 2) host.tick();
  host.arm().attach(draw.payload);
  // Nothing is in the hand before, so that all of them collect the same samples and judge them at the same tick.
  while (host.arm().time() < kAttach + kWatched && host.answers(kNetwork).empty()) host.tick();

  DataSet out;
  out.truth << draw.payload.mass, draw.payload.com;
  out.guess = records[kNetwork].guess;
  for (std::size_t k = 0; k < kPriors; ++k) {
    if (host.answers(k).size() != 1 || host.answers(k)[0].rejected || host.answers(k)[0].empty) return std::nullopt;
    out.posterior[kEstimator][k] = host.answers(k)[0].posterior;
    out.posterior[kPublished][k] = records[k].published;
  }
  return out;
}

Scored scored(const DataSet& data, const Eigen::Vector4d& estimate, const Eigen::Vector4d& deviation) {
  Scored s;
  s.truth = data.truth;
  s.error = estimate - data.truth;
  s.deviation = deviation;
  return s;
}

using MeanSquares = Eigen::Vector4d;  // [g^2, mm^2, mm^2, mm^2]

/// Prints a line; mean square errors in 1e-3 kg^2 and mm^2.
MeanSquares print(const char* name, const std::vector<Scored>& all, bool intervals) {
  MeanSquares squares;
  double coverage[4];
  for (int i = 0; i < 4; ++i) {
    const Summary summary = summarise(all, i);
    squares[i] = summary.rms * summary.rms;
    coverage[i] = summary.coverage[2];
  }
  std::printf("%-15s %9.2f %9.1f %9.1f %9.1f", name, 1e-3 * squares[0], squares[1], squares[2], squares[3]);
  if (intervals)
    for (const double c : coverage) std::printf(" %6.0f", c);
  std::printf("\n");
  return squares;
}

/// Prints the table of one likelihood.
/// @return the zero prior's mean square errors over those of the network's
MeanSquares print(const std::vector<DataSet>& data, Likelihood likelihood) {
  std::printf("\n%s likelihood\n%-15s %9s %9s %9s %9s   90 %% intervals that hold\n", kLikelihoodNames[likelihood],
              "mean square of", "m [g kg]", "x [mm^2]", "y [mm^2]", "z [mm^2]");
  MeanSquares squares[kPriors];
  for (std::size_t k = 0; k < kPriors; ++k) {
    std::vector<Scored> all;
    for (const DataSet& d : data) {
      const auto& posterior = d.posterior[likelihood][k];
      all.push_back(scored(d, posterior.mean, posterior.standard_deviation()));
    }
    squares[k] = print((std::string(kPriorNames[k]) + " prior").c_str(), all, true);
  }
  MeanSquares ratio = squares[kZero].cwiseQuotient(squares[kNetwork]);
  std::printf("%-15s %9.2f %9.2f %9.2f %9.2f\n", "zero / network", ratio[0], ratio[1], ratio[2], ratio[3]);
  return ratio;
}

void write_csv(const Options& options, const std::vector<DataSet>& data) {
  std::ofstream file(std::filesystem::path(*options.output) / "data_sets.csv");
  file << "likelihood,prior,mass,x,y,z,mass_estimate,x_estimate,y_estimate,z_estimate,mass_std,x_std,y_std,z_std\n";
  const Eigen::IOFormat cells(Eigen::StreamPrecision, Eigen::DontAlignCols, ",", ",");
  const auto row = [&](const char* likelihood, const char* prior, const DataSet& d, const Eigen::Vector4d& estimate,
                       const Eigen::Vector4d& deviation) {
    file << likelihood << ',' << prior << ',' << d.truth.format(cells) << ',' << estimate.format(cells) << ','
         << deviation.format(cells) << '\n';
  };
  for (const DataSet& d : data) {
    if (d.guess) row("none", "network", d, *d.guess, options.network.config.standard_deviation);
    for (std::size_t l = 0; l < kLikelihoods; ++l)
      for (std::size_t k = 0; k < kPriors; ++k)
        row(kLikelihoodNames[l], kPriorNames[k], d, d.posterior[l][k].mean, d.posterior[l][k].standard_deviation());
  }
  if (!file.flush()) throw ArgumentError("--output: cannot write to " + *options.output);
}

int run(Arguments& arguments) {
  const Options options = parse(arguments);
  if (options.output) make_folder("--output", *options.output);
  std::vector<DataSet> data;
  for (std::size_t run = 0; run < options.data_sets; ++run)
    if (const auto d = simulate(options, run)) data.push_back(*d);
  std::printf("%zu payloads, %zu of them noticed with every prior\n\n%-15s %9s %9s %9s %9s\n", options.data_sets,
              data.size(), "mean square of", "m [g kg]", "x [mm^2]", "y [mm^2]", "z [mm^2]");
  if (data.empty()) return 1;
  std::vector<Scored> guesses;
  for (const DataSet& d : data)
    if (d.guess) guesses.push_back(scored(d, *d.guess, options.network.config.standard_deviation));
  print("network alone", guesses, false);
  std::printf("(%zu windows were beyond what it has learned from: the fixed prior stood in)\n",
              data.size() - guesses.size());
  const MeanSquares estimator = print(data, kEstimator), published = print(data, kPublished);
  if (options.output) write_csv(options, data);
  return !options.quick || (estimator[3] >= 2 && published.tail<3>().minCoeff() > 1) ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_prior_ablation", kUsage, argc, argv, run);
}
