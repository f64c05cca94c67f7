// prior_ablation: how much does the network's guess improve the estimates if it is used as the prior? Figure 10 of the
// paper.
//
// Simulates a Panda that holds a random pose under an impedance law, with the tracker's compensation. Its torque
// sensors have noise and offsets, its joints have friction, and in one of two kinds of arm the sensed torque contains
// the friction. After one second an unknown payload is attached to the flange. The same samples are then passed to
//  - the network alone, half a second after the attachment;
//  - the published pipeline with the network, and with a prior of the same widths around zero (Appendix D): with the
//    published solver, and with each of the other three.
// The tracker's estimate half a second after the attachment is listed as well. It has no network.
// Prints the mean square error of each parameter and how often its 90 % interval holds the truth.
#include <array>
#include <cmath>
#include <cstdio>
#include <exception>
#include <filesystem>
#include <fstream>
#include <optional>
#include <rme/published/fixed_guess.hpp>
#include <rme/published/published_pipeline.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "io/network_file.hpp"
#include "io/program.hpp"
#include "paper/calibration/random_host.hpp"
#include "paper/calibration/scores.hpp"
#include "synthetic_arm/random_pose.hpp"

namespace {

using namespace rme::examples;
using Eigen::Vector4d;

constexpr double kAttach = 1;     // time of the attachment [s]
constexpr double kSettled = 0.5;  // time after the attachment of the network's guess and the tracker's estimate [s]
constexpr double kWatched = 2;    // time after the attachment during which the published pipeline may estimate [s]

constexpr const char* kUsage =
    R"(usage: rme_prior_ablation --weights W.json [options]

Infers simulated payloads with the network's guess as prior and without, and prints the errors.

  --weights W.json  the network: examples/models/panda.json
  --data-sets N     payloads to simulate on each kind of arm (default 500; 60 with --quick)
  --seed N          of everything random (default 1)
  --pose NAME       any (default), or ready: N(0, 0.1 rad) around the ready pose, as in the paper
  --quick           fewer payloads; fails unless the network's prior is better than zero in each coordinate of the
                    centre of mass in the published pipeline with the published solver
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

using Gaussian = rme::PayloadGaussian<double>;
using Samples = std::vector<rme::Proprioception<double, 7>>;
using rme::PublishedSolver;

/// A solver of the published pipeline, and what the tables call it.
struct NamedSolver {
  PublishedSolver solver;
  const char* name;
};
constexpr std::array<NamedSolver, 4> kSolvers = {{{PublishedSolver::Stochastic, "published pipeline"},
                                                  {PublishedSolver::ClosedForm, "pipeline (closed form)"},
                                                  {PublishedSolver::MeanField, "pipeline (mean field)"},
                                                  {PublishedSolver::Exact, "pipeline (exact)"}}};

/// The estimates of the published pipeline with one solver; none where it has made no estimate.
struct Published {
  std::optional<Gaussian> with_network, with_zero;
};

/// One data set: the true payload and all estimates of it.
struct DataSet {
  Vector4d truth;
  std::optional<Vector4d> guess;  // the network's
  std::array<Published, kSolvers.size()> published;
  Gaussian tracker;
};

void require_ok(rme::Status status) {
  if (status != rme::Status::Ok) throw std::runtime_error(to_string(status));
}

template <typename Network>
std::optional<Gaussian> published(const Samples& samples, const Network& network, double damping,
                                  PublishedSolver solver) {
  rme::PublishedPipelineConfig<double> config;
  config.damping = damping;
  config.solver = solver;
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
  run_until(kAttach + kSettled);

  DataSet out;
  out.truth << draw.payload.mass, draw.payload.com;
  out.tracker = host.state().payload;
  constexpr int kWindow = 200;  // samples of the network's window
  const NetworkFile& file = options.network;
  out.guess = file.guess<7>(
      kWindow, [&](int i) -> const auto& { return samples[samples.size() - kWindow + static_cast<std::size_t>(i)]; });
  run_until(kAttach + kWatched);
  for (std::size_t i = 0; i < kSolvers.size(); ++i) {
    const PublishedSolver solver = kSolvers[i].solver;
    out.published[i].with_network = published(samples, *file.network, file.damping, solver);
    out.published[i].with_zero = published(samples, rme::FixedGuess<double>(), file.damping, solver);
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
  Answers guesses, tracker;
  for (const DataSet& d : data) {
    if (d.guess) guesses.add(d.truth, Gaussian::independent(*d.guess, Vector4d::Ones()));
    tracker.add(d.truth, d.tracker);
  }
  print("network alone", guesses, false);
  bool better = true;
  for (std::size_t i = 0; i < kSolvers.size(); ++i) {
    Answers network, zero;
    for (const DataSet& d : data) {
      if (d.published[i].with_network) network.add(d.truth, *d.published[i].with_network);
      if (d.published[i].with_zero) zero.add(d.truth, *d.published[i].with_zero);
    }
    const std::string name = kSolvers[i].name;
    const Vector4d with = print(name, network), without = print(name + ", zero prior", zero);
    const Vector4d ratio = with.cwiseQuotient(without);
    print_ratio(ratio);
    if (kSolvers[i].solver == PublishedSolver::Stochastic) better = ratio.tail<3>().maxCoeff() < 1;
  }
  print("tracker, 0.5 s after the attachment", tracker);
  return better;
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
      const auto row = [&](const std::string& by, const Vector4d& estimate) {
        file_ << kind << ',' << by << ',' << d.truth.format(cells) << ',' << estimate.format(cells) << '\n';
      };
      if (d.guess) row("network alone", *d.guess);
      for (std::size_t i = 0; i < kSolvers.size(); ++i) {
        const std::string name = kSolvers[i].name;
        if (d.published[i].with_network) row(name, d.published[i].with_network->mean);
        if (d.published[i].with_zero) row(name + " without network", d.published[i].with_zero->mean);
      }
      row("tracker", d.tracker.mean);
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
