// bench_published [MODEL.pt] [--quick]: the published pipeline against the tracker, on the same events in the same run.
//
// An estimate as it was published is the network in TorchScript (MODEL.pt comes from tests/benchmarks/trace.py; without
// it the network is left out) and the stochastic VI with its early stop, each step over all residuals of 50 samples and
// 7 joints: in C++, although it was published in Python. It is timed without the early stop as well.
// PublishedPipeline does the same from sums, with rme's network; timed is its tick that estimates. The tracker's side
// is all that it does in the 200 ms after the attachment, which is as long as the pipeline collects before it computes;
// and its slowest tick among these, of each event. Of the 200 ms before the attachment, the ticks of both are timed as
// well.
//
// A network is asked once in each event, its weights long out of the fastest caches: both networks are timed so (the
// first pass, which counts in the published estimate) and once more at once. TorchScript's first 200 calls, in which it
// optimises itself, come before the first event and do not count.
#include <array>
#include <cstdio>
#include <cstring>
#include <deque>
#include <memory>
#include <random>
#include <rme/estimator.hpp>
#include <rme/inference/published_likelihood.hpp>
#include <rme/inference/stochastic_vi.hpp>
#include <rme/published/published_pipeline.hpp>
#include <string>
#include <vector>

#include "benchmarks/shipped_network.hpp"
#include "benchmarks/stopwatch.hpp"
#include "support/held_arm.hpp"
#ifdef RME_WITH_TORCH
#include "benchmarks/torch_network.hpp"
#endif

namespace {

using namespace rme;
using testing::HeldArm;
using Tick = Proprioception<double, 7>;
using Ticks = std::deque<Tick>;
using Network = MismatchNetwork<float>;

constexpr int kSamples = 50;  // of the published likelihood
constexpr double kDamping = 1e-2;

/// The published likelihood as it is written: every step passes over all residuals.
struct Residuals {
  explicit Residuals(const Ticks& ticks) {
    HeldArm::Vector least = ticks.front().tau_ext, most = least;
    for (int k = 0; k < kSamples; ++k) {
      const Tick& tick = ticks[static_cast<std::size_t>(k) * (ticks.size() - 1) / (kSamples - 1)];
      samples[static_cast<std::size_t>(k)] = &tick;
      least = least.cwiseMin(tick.tau_ext);
      most = most.cwiseMax(tick.tau_ext);
    }
    precision = (0.25 * (most - least)).cwiseMax(0.1).cwiseAbs2().cwiseInverse();
  }

  double operator()(const Vector4<double>& theta, Vector4<double>& gradient) const noexcept {
    const double m = theta[0];
    const Vector3<double> r = theta.tail<3>(), g = standard_gravity<double>();
    double sum = 0;
    gradient.setZero();
    for (const Tick* tick : samples) {
      const Vector3<double> lever = tick->rotation * r, moment = lever.cross(g);  // per kilogram
      Vector6<double> wrench;
      wrench << g, moment;
      const HeldArm::Vector per_mass = tick->jacobian.transpose() * wrench;
      const HeldArm::Vector residual = tick->tau_ext - m * per_mass;
      const HeldArm::Vector weighted = precision.cwiseProduct(residual);
      sum -= 0.5 * residual.dot(weighted);
      gradient[0] += weighted.dot(per_mass);
      const Vector3<double> turned = tick->jacobian.bottomRows<3>() * weighted;  // d sum / d moment, over m
      gradient.tail<3>() += m * (tick->rotation.transpose() * g.cross(turned));
    }
    return sum;
  }

  std::array<const Tick*, kSamples> samples;
  HeldArm::Vector precision;
};

/// The network's input: 20 pseudo-wrenches, the newest of 10 ms each.
Network::Window network_input(const Ticks& ticks, InputFrame frame) {
  Network::Window input;
  for (std::size_t i = 0; i < 20; ++i) {
    const Tick& tick = ticks[ticks.size() - 1 - 10 * (19 - i)];
    Wrench<double> wrench;
    (void)pseudo_wrench(tick.jacobian, tick.tau_ext, kDamping, wrench);
    if (frame == InputFrame::EndEffector) wrench = in_end_effector_axes(wrench, tick.rotation);
    input.row(static_cast<int>(i)) = wrench.vector().transpose().cast<float>();
  }
  return input;
}

struct Times {
  std::vector<double> tracker, slowest, tracker_before, pipeline_before, pipeline_tick;
  std::vector<double> network, network_again, torch, torch_again, steps, all_steps, published, published_all_steps;
};

/// Takes everything else out of the caches that belong to a core.
void fill_caches() {
  static std::vector<char> other(std::size_t(8) << 20);
  for (std::size_t i = 0; i < other.size(); i += 64) ++other[i];
  benchmarks::keep(other);
}

}  // namespace

int main(int argc, char** argv) {
  const bool quick = argc > 1 && std::strcmp(argv[argc - 1], "--quick") == 0;
  const int events = quick ? 3 : 1000;
  const auto network = benchmarks::shipped_network<float>();
#ifdef RME_WITH_TORCH
  std::unique_ptr<benchmarks::TorchNetwork> torch;
  if (argc > 1 && argv[1][0] != '-') torch = std::make_unique<benchmarks::TorchNetwork>(argv[1]);
  double largest = 0;  // difference of the two networks
#endif
  StochasticViConfig all_steps;
  all_steps.small_change = 0;  // never stops early

  std::mt19937_64 random(403);
  std::uniform_real_distribution<double> u(-1, 1);
  Times times;
  for (int k = 0; k < events; ++k) {
    HeldArm arm(random());
    const Payload<double> payload = {1.1 + 0.7 * u(random),
                                     {0.05 * u(random), 0.05 * u(random), 0.1 + 0.08 * u(random)}};
    Estimator<double, 7> tracker(HeldArm::kPeriod);
    PublishedPipeline<double, 7> pipeline(HeldArm::kPeriod, *network, {}, random());
    Ticks ticks;
    double since_attach = 0, slowest = 0, tracker_before = 0, pipeline_before = 0;
    for (int tick = 0; tick < 3000 && pipeline.state().estimates == 0; ++tick) {
      if (tick == 1000) arm.hold(payload);
      const Tick& sample = arm.tick();
      ticks.push_back(sample);
      if (ticks.size() > 200) ticks.pop_front();
      Status status;
      HeldArm::Vector torque;
      const double time = benchmarks::time_of([&] {
        status = tracker.update(sample);
        torque = tracker.compensation(sample.jacobian, sample.rotation);
      });
      benchmarks::keep(torque);
      if (tick >= 1000 && tick < 1200) {
        since_attach += time;
        slowest = std::max(slowest, time);
      }
      const double estimating = benchmarks::time_of([&] {
        status = pipeline.update(sample);
        torque = pipeline.compensation(sample.jacobian, sample.rotation);
      });
      benchmarks::keep(torque);
      if (status == Status::Ok && pipeline.state().estimates > 0) times.pipeline_tick.push_back(estimating);
      if (tick >= 800 && tick < 1000) {
        tracker_before += time;
        pipeline_before += estimating;
      }
    }
    benchmarks::rest();
    if (pipeline.state().estimates == 0) continue;
    times.tracker.push_back(since_attach);
    times.slowest.push_back(slowest);
    times.tracker_before.push_back(tracker_before);
    times.pipeline_before.push_back(pipeline_before);

    Network::Output guess = Network::Output::Zero();
    const auto ask = [&] {
      (void)network->forward(network_input(ticks, network->frame()), guess);
      benchmarks::keep(guess);
    };
    fill_caches();
    times.network.push_back(benchmarks::time_of(ask));
    times.network_again.push_back(benchmarks::time_of(ask));
    double asking = 0;
#ifdef RME_WITH_TORCH
    if (torch) {
      const Network::Output ours = guess;
      const auto ask_torch = [&] { guess = torch->forward(network_input(ticks, network->frame())); };
      fill_caches();
      asking = benchmarks::time_of(ask_torch);
      times.torch.push_back(asking);
      times.torch_again.push_back(benchmarks::time_of(ask_torch));
      largest = std::max(largest, double((guess - ours).cwiseAbs().maxCoeff()));
    }
#endif
    const auto prior = PayloadGaussian<double>::independent(guess.cast<double>(), {0.5, 0.02, 0.02, 0.05});
    const auto stepping = [&](const StochasticViConfig& config) {
      InferenceResult<double> result;
      return benchmarks::time_of([&] {
        (void)infer_payload(Residuals(ticks), prior, result, config, random);
        benchmarks::keep(result);
      });
    };
    times.steps.push_back(stepping({}));
    times.all_steps.push_back(stepping(all_steps));
    times.published.push_back(asking + times.steps.back());
    times.published_all_steps.push_back(asking + times.all_steps.back());
  }
  benchmarks::print_head("The published pipeline, in C++, on the same data, " RME_BENCHMARK_FLAGS);
  benchmarks::print_row("tracker: the 200 ticks before the attachment, together", times.tracker_before);
  benchmarks::print_row("tracker: the 200 ticks after the attachment, together", times.tracker);
  benchmarks::print_row("tracker: the slowest of the 200 after the attachment", times.slowest);
  benchmarks::print_row("PublishedPipeline: the 200 before the attachment, together", times.pipeline_before);
  benchmarks::print_row("PublishedPipeline: the tick that estimates", times.pipeline_tick);
  benchmarks::print_row("rme: network with its input, first pass", times.network);
  benchmarks::print_row("rme: network with its input, again", times.network_again);
  if (!times.torch.empty()) {
    benchmarks::print_row("TorchScript: network with its input, first pass", times.torch);
    benchmarks::print_row("TorchScript: network with its input, again", times.torch_again);
  }
  benchmarks::print_row("published: stochastic VI with its early stop", times.steps);
  benchmarks::print_row("published: stochastic VI, all of 2,500 steps", times.all_steps);
  const std::string estimate = times.torch.empty() ? "published estimate without network" : "published estimate";
  benchmarks::print_row(estimate + ", early stop", times.published);
  benchmarks::print_row(estimate + ", all steps", times.published_all_steps);
#ifdef RME_WITH_TORCH
  if (torch) std::printf("\nlargest difference of the two networks %.1e\n", largest);
#endif
  std::printf("\nseed 403, %zu events\n", times.tracker.size());
}
