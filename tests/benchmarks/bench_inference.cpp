// How long do the building blocks take? One thread, seven joints, double, random events.
#include <cstddef>
#include <cstdio>
#include <random>
#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/mean_field.hpp>
#include <rme/inference/payload_enclosure.hpp>
#include <rme/inference/published_likelihood.hpp>
#include <rme/inference/stochastic_vi.hpp>
#include <rme/inference/variational_inference.hpp>
#include <rme/sensing/mismatch_detector.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/sensing/pseudo_wrench.hpp>
#include <string>
#include <vector>

#include "benchmarks/stopwatch.hpp"
#include "support/random_events.hpp"

using namespace rme;
using testing::kDofs;

int main(int argc, char** argv) {
  const std::size_t runs = benchmarks::quick(argc, argv) ? 10 : 20000;
  std::mt19937_64 random(1);
  std::vector<testing::Event> events;
  for (int k = 0; k < 200; ++k) events.push_back(testing::random_event(random, 200, k % 2 == 1));
  const auto event = [&events](std::size_t i) -> const testing::Event& { return events[i % events.size()]; };
  const PayloadGaussian<double> prior = testing::wide_prior();
  std::vector<PayloadLikelihood<double>> likelihoods;
  for (const auto& e : events) likelihoods.push_back(testing::likelihood_of(e));
  const testing::Pose pose = testing::random_pose(random);

  std::vector<Proprioception<double, kDofs>> ticks(1000);
  std::normal_distribution<double> normal;
  for (auto& tick : ticks) {
    tick.jacobian = pose.jacobian;
    tick.rotation = pose.rotation;
    tick.tau_ext = tick.tau_ext.NullaryExpr([&] { return normal(random); });
    tick.dq = 0.1 * tick.dq.NullaryExpr([&] { return normal(random); });
  }
  const auto tick = [&ticks](std::size_t i) -> const auto& {
    return ticks[i % ticks.size()];
  };

  benchmarks::print_head("Sensing, 7 joints, double");
  MismatchDetector<kDofs> detector(1e-3);
  benchmarks::measure("MismatchDetector::update, per tick", runs, 20, [&](std::size_t i) {
    (void)detector.update(tick(i).tau_ext);
    benchmarks::keep(detector);
  });
  benchmarks::measure("pseudo_wrench", runs, 20, [&](std::size_t i) {
    Wrench<double> wrench;
    (void)pseudo_wrench(tick(i).jacobian, tick(i).tau_ext, 0.01, wrench);
    benchmarks::keep(wrench);
  });

  benchmarks::print_head("Inference, 7 joints, double");
  PayloadStatistics<double, kDofs> sums;
  benchmarks::measure("PayloadStatistics::add, per tick", runs, 20, [&](std::size_t i) {
    sums.add(events[0].samples[i % events[0].samples.size()]);
    benchmarks::keep(sums);
  });
  benchmarks::measure("payload_regressor, per tick", runs, 20, [&](std::size_t i) {
    const auto& sample = tick(i);
    const auto regressor =
        payload_regressor<double, kDofs>(sample.jacobian, sample.rotation, standard_gravity<double>());
    benchmarks::keep(regressor);
  });
  benchmarks::measure("PayloadStatistics::likelihood", runs, 1, [&](std::size_t i) {
    const auto likelihood = event(i).statistics.likelihood(event(i).precision);
    benchmarks::keep(likelihood);
  });
  benchmarks::measure("infer_payload: full covariance, from the likelihood", runs, 1, [&](std::size_t i) {
    InferenceResult<double> result;
    (void)infer_payload(likelihoods[i % likelihoods.size()], prior, result);
    benchmarks::keep(result);
  });
  benchmarks::measure("infer_payload: mean field, from the likelihood", runs, 1, [&](std::size_t i) {
    InferenceResult<double> result;
    (void)infer_payload(likelihoods[i % likelihoods.size()], prior, result, MeanFieldConfig());
    benchmarks::keep(result);
  });
  benchmarks::measure("infer_payload: exact with evidence, from the likelihood", runs, 1, [&](std::size_t i) {
    InferenceResult<double> result;
    (void)infer_payload(likelihoods[i % likelihoods.size()], prior, result, ExactQuadrature());
    benchmarks::keep(result);
  });
  benchmarks::measure(
      "infer_payload: stochastic VI as published, from the likelihood", runs / 10, 1, [&](std::size_t i) {
        InferenceResult<double> result;
        (void)infer_payload(likelihoods[i % likelihoods.size()], prior, result, StochasticViConfig(), random);
        benchmarks::keep(result);
      });
  benchmarks::measure("published_likelihood, from 200 samples", runs, 1, [&](std::size_t i) {
    PayloadLikelihood<double> likelihood;
    const auto& samples = event(i).samples;
    const auto at = [&samples](int k) { return samples[static_cast<std::size_t>(k)]; };
    (void)published_likelihood<double, kDofs>(static_cast<int>(samples.size()), at, likelihood);
    benchmarks::keep(likelihood);
  });

  // Of one pose, and of three in which all readings count against each other; errors are within their bounds.
  benchmarks::print_head("Enclosure, 7 joints, double");
  PayloadEnclosureConfig<double, kDofs> config;
  config.drift.setConstant(0.06);
  config.mass_limit = 3;
  config.com_lower.setConstant(-0.25);
  config.com_upper.setConstant(0.25);
  config.link.setConstant(0.1);
  using Enclosure = PayloadEnclosure<double, kDofs, 3>;
  const Payload<double> held{1.1, {0.05, 0.02, 0.13}};
  std::uniform_real_distribution<double> within(-0.06, 0.06);
  for (const int poses : {1, 3}) {
    std::vector<Enclosure> enclosures;
    for (int k = 0; k < 200; ++k) {
      Enclosure enclosure(config);
      for (int p = 0; p < poses; ++p) {
        const auto [J, R] = testing::random_pose(random);
        const auto regressor = payload_regressor<double, kDofs>(J, R, standard_gravity<double>());
        JointVector<double, kDofs> error;
        for (int j = 0; j < kDofs; ++j) error[j] = within(random);
        const JointVector<double, kDofs> before = JointVector<double, kDofs>::Constant(0.3);
        (void)enclosure.add_change(before, before + regressor.torque(held) + error, regressor);
      }
      enclosures.push_back(enclosure);
    }
    const std::string of = poses == 1 ? ", one pose" : ", three poses";
    benchmarks::measure("PayloadEnclosure::solve" + of, runs, 1, [&](std::size_t i) {
      PayloadBox<double> box;
      (void)enclosures[i % enclosures.size()].solve(box);
      benchmarks::keep(box);
    });
    const auto regressor = payload_regressor<double, kDofs>(pose.jacobian, pose.rotation, standard_gravity<double>());
    benchmarks::measure("PayloadEnclosure::range, torque of 7 joints" + of, runs, 1, [&](std::size_t i) {
      JointVector<double, kDofs> lower, upper;
      (void)enclosures[i % enclosures.size()].range(regressor, lower, upper);
      benchmarks::keep(upper);
    });
  }
}
