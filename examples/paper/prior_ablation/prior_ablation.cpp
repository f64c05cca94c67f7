// prior_ablation: how much does the network's guess improve the estimates if it is used as the prior? Figure 10 of the
// paper, and the same question for the tracker.
//
// Simulates a Panda that holds a random pose under an impedance law, with the tracker's compensation. Its torque
// sensors have noise and offsets, its joints have friction, and in one of two kinds of arm the sensed torque contains
// the friction. After one second an unknown payload is attached to the flange. The same samples are then passed to
//  - the network alone, half a second after the attach;
//  - the published pipeline with the network, and with a prior of the same widths around zero (Appendix D);
//  - trackers with different priors of what may be picked up. The first has the default PayloadPrior. The others have
//    the network's guess from the samples of the first 50 ms, 100 ms or 0.5 s after the attach: either through
//    NetworkPrior, which takes the centre of mass along gravity from the fixed prior, or as published, with the
//    guess for all parameters. These trackers run over all samples from the start, so they have the guess as prior
//    before they get the samples that it was made from. No way of using the network in the tracker could do more.
// Prints the mean square error of each parameter and how often its 90 % interval holds the truth.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <rme/published/fixed_guess.hpp>
#include <rme/published/published_pipeline.hpp>
#include <rme/sensing/sample_window.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/program.hpp"
#include "paper/calibration/random_host.hpp"
#include "paper/calibration/scores.hpp"
#include "run_network/network_file.hpp"
#include "synthetic_arm/random_pose.hpp"

namespace {

using namespace rme::examples;
using Eigen::Vector4d;

constexpr double kAttach = 1;     // time of the attach [s]
constexpr double kWatched = 2;    // time after the attach during which the published pipeline may estimate [s]
constexpr double kEarned = 0.8;   // a parameter has gained if its mean square error falls to this share or less
constexpr double kHarmed = 1.02;  // and has lost if it grows to more than this

constexpr const char* kUsage =
    R"(usage: rme_prior_ablation --weights W.json [options]

Infers simulated payloads with the network's guess as prior and without, and prints the errors.

  --weights W.json  the network: examples/models/panda.json
  --data-sets N     payloads to simulate on each kind of arm (default 500; 60 with --quick)
  --seed N          of everything random (default 1)
  --pose NAME       any (default), or ready: N(0, 0.1 rad) around the ready pose, as in the paper
  --quick           fewer payloads; fails unless the network's prior is better than zero in each coordinate of the
                    centre of mass in the published pipeline
  --output DIR      write data_sets.csv there; the folder is made if need be. plot.py draws it
  --help            this text

Exit codes: 0 done; 1 a simulation failed, or what --quick checks; 2 unusable arguments.
)";

struct Options {
  std::size_t data_sets = 500;
  std::uint64_t seed = 1;
  bool quick = false;
  bool ready = false;  // near the ready pose, or anywhere
  NetworkFile network;
  std::optional<std::string> output;
};

Options parse(Arguments& arguments) {
  Options options;
  options.quick = arguments.flag("--quick");
  options.data_sets = arguments.whole("--data-sets", 1, 1000000).value_or(options.quick ? 60 : 500);
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

/// When the network's guess is made and the tracker's estimate is read.
struct Instant {
  double t;        // after the attach [s]
  double spacing;  // of the network's 20 input samples, so that all of them are after the attach; at most 10 ms [s]
  const char* name;
};
constexpr std::array<Instant, 3> kInstants = {{{0.05, 0.002, "50 ms"}, {0.1, 0.005, "100 ms"}, {0.5, 0.01, "0.5 s"}}};

/// Where the tracker's prior of an exchange comes from.
enum Source : std::size_t { kDefault, kNetworkAcross, kNetworkForAll, kSources };
constexpr const char* kSourceNames[] = {"tracker", "tracker, network across gravity", "tracker, network for all"};

using Gaussian = rme::PayloadGaussian<double>;
using Samples = std::vector<rme::Proprioception<double, 7>>;

/// One data set: the true payload and all estimates of it.
struct DataSet {
  Vector4d truth;
  std::optional<Vector4d> guess;                    // the network's; none if the window is too unlike its training data
  std::optional<Gaussian> with_network, with_zero;  // the published pipeline's; none if it has made no estimate
  std::array<std::array<Gaussian, kInstants.size()>, kSources> tracker;
};

void require_ok(rme::Status status) {
  if (status != rme::Status::Ok) throw std::runtime_error(to_string(status));
}

rme::PayloadPrior<double> any_payload() {
  return rme::PayloadPrior<double>::of(rme::EstimatorConfig<double, 7>().rated_payload);
}

/// The network's guess from the samples up to an instant, as a prior for the tracker.
std::optional<rme::PayloadPrior<double>> prior_of(const NetworkFile& file, const Samples& samples,
                                                  const Instant& instant, Source source) {
  rme::NetworkPriorConfig<double> config = file.config;
  const rme::PayloadPrior<double> any = any_payload();
  Vector4d mean, deviation;
  mean << any.mass_mean, any.com_mean;
  deviation << any.mass_std, any.com_std;
  config.unknown.gaussian = Gaussian::independent(mean, deviation);
  config.spacing = instant.spacing;
  const rme::NetworkPrior<double> prior(*file.network, kPeriod, config);
  rme::SampleWindow<double, 7> window(kPeriod);
  const auto end = static_cast<std::size_t>(std::lround((kAttach + instant.t) / kPeriod));
  const auto count = static_cast<std::size_t>(std::lround(instant.t / kPeriod));
  for (std::size_t i = end - count; i < end; ++i) require_ok(window.push(samples[i]));
  Vector4d guess;
  if (!prior.guess(window, count, guess)) return std::nullopt;
  const Gaussian gaussian =
      source == kNetworkAcross ? prior(window, count) : Gaussian::independent(guess, Vector4d(0.5, 0.02, 0.02, 0.05));
  const Vector4d spread = gaussian.standard_deviation();
  const double rated = rme::EstimatorConfig<double, 7>().rated_payload;
  return rme::PayloadPrior<double>{std::clamp(gaussian.mean[0], 0.0, rated), spread[0], gaussian.mean.tail<3>(),
                                   spread.tail<3>()};
}

/// A tracker's estimate at an instant.
/// @param prior  of what may be picked up; none: the default
Gaussian track(const Samples& samples, const Instant& instant, const std::optional<rme::PayloadPrior<double>>& prior) {
  rme::EstimatorConfig<double, 7> config;
  config.payload = prior;
  rme::Estimator<double, 7> estimator(kPeriod, config);
  const auto end = static_cast<std::size_t>(std::lround((kAttach + instant.t) / kPeriod));
  for (std::size_t i = 0; i < end; ++i) require_ok(estimator.update(samples[i]));
  return estimator.state().payload;
}

template <typename Network>
std::optional<Gaussian> published(const Samples& samples, const Network& network, double damping) {
  rme::PublishedPipelineConfig<double> config;
  config.damping = damping;
  rme::PublishedPipeline<double, 7, Network> pipeline(kPeriod, network, config);
  for (const auto& sample : samples) require_ok(pipeline.update(sample));
  if (pipeline.state().estimates == 0) return std::nullopt;
  return pipeline.state().posterior;
}

DataSet simulate(const Options& options, Kind kind, std::size_t run) {
  RandomHost random(options.seed, run);
  Draw draw = random.draw(kind, std::nullopt);
  // --pose any: poses like those of the network's training data.
  draw.start = options.ready ? Torque(panda().ready + Torque::NullaryExpr([&] { return random.normal(0, 0.1); }))
                             : random_panda_pose([&](double low, double high) { return random.uniform(low, high); });
  draw.target = draw.start + Torque::NullaryExpr([&] { return random.normal(0, 0.005); });
  Host host(draw);
  Samples samples;
  const auto run_until = [&](double time) {
    while (host.arm().time() < time - kPeriod / 2) {
      host.tick();
      samples.push_back(host.sample());
    }
  };
  run_until(kAttach);
  host.arm().attach(draw.payload);
  run_until(kAttach + kWatched);

  DataSet out;
  out.truth << draw.payload.mass, draw.payload.com;
  out.with_network = published(samples, *options.network.network, options.network.config.damping);
  out.with_zero = published(samples, rme::FixedGuess<double>(), options.network.config.damping);
  if (const auto prior = prior_of(options.network, samples, kInstants.back(), kNetworkForAll)) {
    out.guess = Vector4d::Zero();
    *out.guess << prior->mass_mean, prior->com_mean;
  }
  for (std::size_t i = 0; i < kInstants.size(); ++i) {
    for (const Source source : {kDefault, kNetworkAcross, kNetworkForAll}) {
      std::optional<rme::PayloadPrior<double>> prior;
      if (source != kDefault) prior = prior_of(options.network, samples, kInstants[i], source);
      out.tracker[source][i] = track(samples, kInstants[i], prior);
    }
  }
  return out;
}

/// One method's estimates of all data sets.
struct Answers {
  std::vector<Scored> all;
  void add(const Vector4d& truth, const Gaussian& answer) {
    Scored s;
    s.truth = truth;
    s.error = answer.mean - truth;
    s.deviation = answer.standard_deviation();
    all.push_back(s);
  }
  Vector4d mean_squares() const {  // [g^2, mm^2, mm^2, mm^2]
    Vector4d squares;
    for (int i = 0; i < 4; ++i) squares[i] = std::pow(summarise(all, i).rms, 2);
    return squares;
  }
};

/// Prints a line; mean square errors in 1e-3 kg^2 and mm^2.
Vector4d print(const std::string& name, const Answers& answers, bool intervals = true) {
  const Vector4d squares = answers.mean_squares();
  std::printf("%-32s %9.3f %9.1f %9.1f %9.1f", name.c_str(), 1e-3 * squares[0], squares[1], squares[2], squares[3]);
  for (int i = 0; intervals && i < 4; ++i) std::printf(" %6.0f", summarise(answers.all, i).coverage[2]);
  std::printf("  %5zu\n", answers.all.size());
  return squares;
}

void print_ratio(const Vector4d& ratio) {
  std::printf("%-32s %9.2f %9.2f %9.2f %9.2f\n", "  of that without the network", ratio[0], ratio[1], ratio[2],
              ratio[3]);
}

/// @return whether the network's prior is better than zero in the published pipeline
bool report(const std::vector<DataSet>& data, const char* kind) {
  std::printf("\n%s\n\n%-32s %9s %9s %9s %9s   90 %% intervals that hold   of\n", kind, "mean square of", "m [g kg]",
              "x [mm^2]", "y [mm^2]", "z [mm^2]");
  Answers guesses, network, zero;
  for (const DataSet& d : data) {
    if (d.guess) guesses.add(d.truth, Gaussian::independent(*d.guess, Vector4d::Ones()));
    if (d.with_network) network.add(d.truth, *d.with_network);
    if (d.with_zero) zero.add(d.truth, *d.with_zero);
  }
  print("network alone", guesses, false);
  const Vector4d with = print("published pipeline", network), without = print("published pipeline, zero prior", zero);
  print_ratio(with.cwiseQuotient(without));
  for (std::size_t i = 0; i < kInstants.size(); ++i) {
    std::printf("%s after the attach\n", kInstants[i].name);
    Vector4d plain = Vector4d::Ones();
    for (const Source source : {kDefault, kNetworkAcross, kNetworkForAll}) {
      Answers answers;
      for (const DataSet& d : data) answers.add(d.truth, d.tracker[source][i]);
      const Vector4d squares = print(kSourceNames[source], answers);
      if (source == kDefault) {
        plain = squares;
        continue;
      }
      const Vector4d ratio = squares.cwiseQuotient(plain);
      print_ratio(ratio);
      const bool earns = ratio.minCoeff() <= kEarned && ratio.maxCoeff() <= kHarmed;
      std::printf("  %s\n", earns ? "earns its place: a parameter a fifth better, none worse"
                                  : "does not earn its place: that needs a parameter a fifth better and none worse");
    }
  }
  return with.tail<3>().cwiseQuotient(without.tail<3>()).maxCoeff() < 1;
}

class File {
 public:
  explicit File(const std::optional<std::string>& folder) : folder_(folder) {
    if (!folder_) return;
    file_.open(std::filesystem::path(*folder_) / "data_sets.csv");
    file_ << "sensing,by,mass,x,y,z,mass_estimate,x_estimate,y_estimate,z_estimate\n";
  }
  void add(const char* kind, const std::vector<DataSet>& data) {
    if (!folder_) return;
    const Eigen::IOFormat cells(Eigen::StreamPrecision, Eigen::DontAlignCols, ",", ",");
    for (const DataSet& d : data) {
      const auto row = [&](const char* by, const Vector4d& estimate) {
        file_ << kind << ',' << by << ',' << d.truth.format(cells) << ',' << estimate.format(cells) << '\n';
      };
      if (d.guess) row("network alone", *d.guess);
      if (d.with_network) row("published pipeline", d.with_network->mean);
      if (d.with_zero) row("published pipeline without network", d.with_zero->mean);
      row("tracker with network", d.tracker[kNetworkAcross].back().mean);
      row("tracker", d.tracker[kDefault].back().mean);
    }
    if (!file_.flush()) throw ArgumentError("--output: cannot write to " + *folder_);
  }

 private:
  std::optional<std::string> folder_;
  std::ofstream file_;
};

int run(Arguments& arguments) {
  const Options options = parse(arguments);
  if (options.output) make_folder("--output", *options.output);
  File file(options.output);
  std::printf("%zu payloads for each kind of arm, seed %llu\n", options.data_sets,
              static_cast<unsigned long long>(options.seed));
  bool better = true;
  for (const Kind kind : {Kind::LinkSide, Kind::JointFriction}) {
    const char* name = kind == Kind::LinkSide ? "link side" : "joint friction";
    std::vector<DataSet> data;
    for (std::size_t run = 0; run < options.data_sets; ++run) {
      data.push_back(simulate(options, kind, run));
      if ((run + 1) % 100 == 0) std::fprintf(stderr, "%zu of %zu payloads, %s\n", run + 1, options.data_sets, name);
    }
    better = report(data, name) && better;
    file.add(name, data);
  }
  return !options.quick || better ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_prior_ablation", kUsage, argc, argv, run);
}
