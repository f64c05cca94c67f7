#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <rme/control/compensation.hpp>
#include <rme/control/energy_tank.hpp>
#include <rme/estimator.hpp>
#include <rme/event_estimator.hpp>
#include <rme/network/network_prior.hpp>

#include "network/golden.hpp"
#include "realtime/allocations_of.hpp"
#include "realtime/life.hpp"
#include "support/catch.hpp"

#ifdef RME_COUNTS_ALLOCATIONS

namespace {

using rme::Status;
using rme::testing::allocations_of;
using rme::testing::life;
using rme::testing::spoil;
using Gaussian = rme::PayloadGaussian<double>;
using Statistics = rme::PayloadStatistics<double, 7>;
using Prior = rme::NetworkPrior<double>;

constexpr double kPeriod = rme::testing::HeldArm::kPeriod;

TEST_CASE("Allocations: whatever goes to the heap is counted", "[realtime]") {
  void* volatile kept = nullptr;  // or the compiler leaves the pairs out
  CHECK(allocations_of([&] { std::free(kept = std::malloc(8)); }) == 1);
  CHECK(allocations_of([&] { std::free(kept = std::calloc(1, 8)); }) == 1);
  CHECK(allocations_of([&] { std::free(kept = std::realloc(nullptr, 8)); }) == 1);
  CHECK(allocations_of([&] { ::operator delete(kept = ::operator new(8)); }) == 1);
  constexpr std::align_val_t kWide{64};
  CHECK(allocations_of([&] { ::operator delete(kept = ::operator new(64, kWide), kWide); }) == 1);
  CHECK(allocations_of([&] { Eigen::MatrixXd::Random(3, 3).eval(); }) == 1);
}

/// A network with much to compute that always guesses the same, and the prior that it makes.
struct NetworkAndPrior {
  NetworkAndPrior() {
    const auto weights = golden::random_weights<float>();
    weights->head_weight.fill(0);
    weights->head_bias = {1, 0, 0, 0.1F};
    network = std::make_unique<rme::MismatchNetwork<float>>(*weights);
    rme::NetworkPriorConfig<double> config;
    config.farthest = 1e6;
    prior = std::make_unique<Prior>(*network, kPeriod, config);
  }
  std::unique_ptr<rme::MismatchNetwork<float>> network;
  std::unique_ptr<Prior> prior;
};

TEST_CASE(
    "Allocations: none in the estimator, while things are attached, pushed, filled and removed, and a host says "
    "what it knows",
    "[realtime]") {
  const std::uint64_t seed = 300;
  CAPTURE(seed);
  auto ticks = life(seed);
  rme::testing::HeldArm arm(seed);  // a cup that is filled, changed and taken away
  for (int k = 0; k < 4000; ++k) {
    if (k >= 500 && k <= 2500) arm.hold({0.5 + 2.5e-4 * (k - 500), {0, 0, 0.1}});
    if (k == 3000) arm.hold({0.4, {0, 0, 0.1}});
    if (k == 3500) arm.hold({});
    ticks.push_back(arm.tick());
  }
  spoil(ticks);
  for (std::size_t k = 11; k < ticks.size(); k += 89) ticks[k].period = 3 * kPeriod;
  rme::Estimator<double, 7> estimator(kPeriod);
  rme::CompensationRamp<double, 7> ramp(kPeriod);
  const auto said = Gaussian::independent({1, 0, 0, 0.1}, {0.1, 0.05, 0.05, 0.05});
  bool met[6] = {};  // by kind of event
  int refused = 0;
  double largest = 0;
  const int count = allocations_of([&] {
    for (int round = 0; round < 3; ++round) {
      for (std::size_t k = 0; k < ticks.size(); ++k) {
        if (round > 0 && k % 1000 == 990) estimator.trigger();
        if (round == 1 && k == 900) estimator.declare_empty();
        if (round == 2 && k == 900) refused += estimator.set_payload(said) != Status::Ok;
        if (round == 2 && k % 1500 == 0) estimator.inhibit(k % 3000 == 0);
        refused += estimator.update(ticks[k]) != Status::Ok;
        met[static_cast<int>(estimator.state().event.kind)] = true;
        refused += ramp.update(estimator.compensation(ticks[k].jacobian, ticks[k].rotation)) != Status::Ok;
        largest = std::max(largest, ramp.torque().norm());
      }
      estimator.reset();
    }
  });
  CHECK(count == 0);
  for (const bool kind : met) CHECK(kind);
  CHECK(refused > 300);
  CHECK(largest > 1);
}

TEST_CASE("Allocations: none in the event estimator with a network, from the first tick to reset", "[realtime]") {
  const std::uint64_t seed = 301;
  CAPTURE(seed);
  auto ticks = life(seed);
  spoil(ticks);
  const NetworkAndPrior with;
  rme::EventEstimator<double, 7, Prior> estimator(kPeriod, {}, *with.prior);
  rme::CompensationRamp<double, 7> ramp(kPeriod);
  rme::EnergyTank<double> tank(kPeriod);
  int estimates = 0, early = 0, rejections = 0, refused = 0;
  double largest = 0;
  const int count = allocations_of([&] {
    for (int round = 0; round < 3; ++round) {
      for (std::size_t k = 0; k < ticks.size(); ++k) {
        if (round == 1 && k == 900) estimator.tare(0.5);
        if (round == 2 && k % 1000 == 990) estimator.trigger();
        refused += estimator.update(ticks[k]) != Status::Ok;
        estimates += estimator.estimated();
        early += estimator.refreshed();
        rejections += estimator.rejected();
        refused += ramp.update(estimator.compensation(ticks[k].jacobian, ticks[k].rotation)) != Status::Ok;
        refused += tank.update(ticks[k].dq.dot(ramp.torque())) != Status::Ok;
        largest = std::max(largest, tank.share() * ramp.torque().norm());
      }
      estimator.reset();
    }
  });
  CHECK(count == 0);
  CHECK(estimates >= 6);
  CHECK(early > 20);
  CHECK(rejections >= 2);
  CHECK(refused > 300);
  CHECK(largest > 1);
}

TEST_CASE("Allocations: none in what the event estimator is made of", "[realtime]") {
  const std::uint64_t seed = 302;
  CAPTURE(seed);
  auto ticks = life(seed);
  spoil(ticks);
  const NetworkAndPrior with;
  const rme::EventEstimatorConfig<double, 7> config;
  rme::SampleWindow<double, 7> window(kPeriod);
  rme::MismatchDetector<7> detector(kPeriod);
  rme::MismatchDetector<1> published(kPeriod, rme::MismatchDetectorConfig::published());
  rme::WindowStatistics<double, 7> sums(40);
  rme::EventInference<double, 7> inference(kPeriod, config.sensors, config.push, config.inference);
  rme::Wrench<double> wrench;
  rme::ModelAverage<double> average;
  int detected = 0, asked = 0, inferred = 0;
  double onsets = 0;
  const int count = allocations_of([&] {
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      if (window.push(ticks[k]) != Status::Ok) continue;
      const auto& sample = window.newest();
      const bool watched = detector.update(sample.tau) == Status::Ok;
      const bool heard = published.update(Eigen::Matrix<double, 1, 1>(sample.raw.tau_ext.norm())) == Status::Ok;
      detected += watched && heard && (detector.detected() || published.detected());
      const auto regressor = rme::payload_regressor<double, 7>(sample.raw.jacobian, sample.raw.rotation, config.gravity,
                                                               sample.motion, config.gyration_radius);
      sums.add({sample.tau, regressor, sample.direction, sample.raw.dq});
      if (k % 500 != 499) continue;
      const Gaussian prior = (*with.prior)(window, 400);
      asked += prior.mean[0] == 1;
      const Statistics about = sums.about(prior.mean.tail<3>());
      inference.learn_baseline(about);
      const auto verdict = inference.judge(about, about, prior, {}, sample.raw.jacobian, average);
      inferred += !average.empty() && !inference.posterior(about, prior).empty() && std::isfinite(verdict.log_odds());
      inference.forget_baseline();
      onsets += rme::find_onset(window, 600, 10).jump + rme::unrest(window, 200);
      if (rme::pseudo_wrench(sample.raw.jacobian, sample.raw.tau_ext, 0.01, wrench) == Status::Ok)
        wrench = rme::in_end_effector_axes(wrench, sample.raw.rotation);
      sums.clear();
    }
    window.reset();
    detector.reset();
  });
  CHECK(count == 0);
  CHECK(detected > 0);
  CHECK(asked > 5);
  CHECK(inferred > 5);
  CHECK(onsets > 1);
}

}  // namespace

#endif
