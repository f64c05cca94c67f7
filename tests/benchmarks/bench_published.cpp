// bench_published [MODEL.pt] [--quick]: the published pipeline against rme's whole estimate, on the same events in the
// same run. The pipeline is the network in TorchScript (MODEL.pt comes from tests/benchmarks/trace.py; without it the
// network is left out) and the stochastic VI with all of its 2,500 steps, each over all residuals of 50 samples and 7
// joints: in C++, although it was published in Python. rme's side is the tick that makes the final estimate, from the
// window's last sample to payload, covariance and compensation torque, its network in float.
#include <array>
#include <cstdio>
#include <cstring>
#include <deque>
#include <memory>
#include <random>
#include <rme/event_estimator.hpp>
#include <rme/inference/published_likelihood.hpp>
#include <rme/inference/stochastic_vi.hpp>
#include <rme/network/network_prior.hpp>
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
using Prior = NetworkPrior<double>;

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
  std::vector<double> ours, network, torch, steps, steps_from_sums, pipeline;
};

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
    EventEstimator<double, 7, Prior> estimator(HeldArm::kPeriod, {}, Prior(*network, HeldArm::kPeriod));
    Ticks ticks;
    for (int tick = 0; tick < 3000 && !estimator.estimated(); ++tick) {
      if (tick == 1000) arm.hold(payload);
      const Tick& sample = arm.tick();
      ticks.push_back(sample);
      if (ticks.size() > 200) ticks.pop_front();
      Status status;
      HeldArm::Vector torque;
      const double time = benchmarks::time_of([&] {
        status = estimator.update(sample);
        torque = estimator.compensation(sample.jacobian, sample.rotation);
      });
      benchmarks::keep(torque);
      if (status == Status::Ok && estimator.estimated()) times.ours.push_back(time);
    }
    benchmarks::rest();
    if (!estimator.estimated()) continue;

    Network::Output guess = Network::Output::Zero();
    times.network.push_back(benchmarks::time_of([&] {
      (void)network->forward(network_input(ticks, network->frame()), guess);
      benchmarks::keep(guess);
    }));
    double asking = 0;
#ifdef RME_WITH_TORCH
    if (torch) {
      const Network::Output ours = guess;
      asking = benchmarks::time_of([&] { guess = torch->forward(network_input(ticks, network->frame())); });
      times.torch.push_back(asking);
      largest = std::max(largest, double((guess - ours).cwiseAbs().maxCoeff()));
    }
#endif
    const auto prior = PayloadGaussian<double>::independent(guess.cast<double>(), {0.5, 0.02, 0.02, 0.05});
    InferenceResult<double> result;
    const double stepping = benchmarks::time_of([&] {
      (void)infer(Residuals(ticks), prior, result, all_steps, random);
      benchmarks::keep(result);
    });
    times.steps.push_back(stepping);
    times.pipeline.push_back(asking + stepping);
    times.steps_from_sums.push_back(benchmarks::time_of([&] {
      PayloadLikelihood<double> likelihood;
      const auto at = [&ticks](int i) {
        const Tick& tick = ticks[static_cast<std::size_t>(i)];
        return PayloadObservation<double, 7>{
            tick.tau_ext, payload_regressor<double, 7>(tick.jacobian, tick.rotation, standard_gravity<double>()),
            HeldArm::Vector::Zero(), HeldArm::Vector::Zero()};
      };
      (void)published_likelihood<double, 7>(static_cast<int>(ticks.size()), at, likelihood);
      (void)infer(likelihood, prior, result, all_steps, random);
      benchmarks::keep(result);
    }));
  }
  benchmarks::print_head("The published pipeline, in C++, on the same data, " RME_BENCHMARK_FLAGS);
  benchmarks::print_row("rme: whole estimate, network included", times.ours);
  benchmarks::print_row("rme: network with its input", times.network);
  if (!times.torch.empty()) benchmarks::print_row("published: network in TorchScript, with its input", times.torch);
  benchmarks::print_row("published: stochastic VI, 2,500 steps", times.steps);
  benchmarks::print_row("the same 2,500 steps from rme's sums", times.steps_from_sums);
  benchmarks::print_row(times.torch.empty() ? "published pipeline, without its network" : "published pipeline",
                        times.pipeline);
#ifdef RME_WITH_TORCH
  if (torch) std::printf("\nlargest difference of the two networks %.1e\n", largest);
#endif
  std::printf("\nseed 403, %zu events\n", times.ours.size());
}
