#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <rme/control/energy_tank.hpp>
#include <rme/core/compensation.hpp>
#include <rme/estimator.hpp>
#include <rme/inference/evidence.hpp>
#include <rme/inference/sensor_model.hpp>
#include <rme/inference/variational_inference.hpp>
#include <rme/network/network_prior.hpp>
#include <rme/sensing/mismatch_detector.hpp>
#include <rme/sensing/pseudo_wrench.hpp>
#include <rme/sensing/sample_window.hpp>

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
  Eigen::MatrixXd matrix;
  CHECK(allocations_of([&] { matrix.resize(3, 3); }) == 1);
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

TEST_CASE("Allocations: none in the building blocks: window, detector, network prior, sums, inference, evidence",
          "[realtime]") {
  const std::uint64_t seed = 302;
  CAPTURE(seed);
  auto ticks = life(seed);
  spoil(ticks);
  const NetworkAndPrior with;
  const auto sensor = rme::SensorModel<double, 7>::link_side();
  rme::SampleWindow<double, 7> window(kPeriod);
  rme::MismatchDetector<7> detector(kPeriod);
  rme::MismatchDetector<1> published(kPeriod, rme::MismatchDetectorConfig::published());
  Statistics sums;
  rme::Wrench<double> wrench;
  rme::EnergyTank<double, 7> tank(kPeriod);
  int detected = 0, asked = 0, inferred = 0;
  double push = 0;
  const int count = allocations_of([&] {
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      if (window.push(ticks[k]) != Status::Ok) continue;
      const auto& sample = window.newest();
      const bool watched = detector.update(sample.tau) == Status::Ok;
      const bool heard = published.update(Eigen::Matrix<double, 1, 1>(sample.raw.tau_ext.norm())) == Status::Ok;
      detected += watched && heard && (detector.detected() || published.detected());
      sums.add({sample.tau,
                rme::payload_regressor<double, 7>(sample.raw.jacobian, sample.raw.rotation,
                                                  rme::standard_gravity<double>(), sample.motion, 0.05),
                sample.direction, sample.raw.dq});
      if (k % 500 != 499) continue;
      const Gaussian prior = (*with.prior)(window, 400);
      asked += prior.mean[0] == 1;
      rme::PayloadLikelihood<double> likelihood;
      rme::InferenceResult<double> result;
      const auto precision = sensor.precision(kPeriod);
      if (sums.likelihood(precision, sensor.prior(), likelihood) == Status::Ok)
        inferred += rme::infer_payload(likelihood, prior, result) == Status::Ok;
      Statistics::Marginals marginals;
      double log_evidence = 0;
      if (sums.marginals(precision, sensor.prior(), marginals) == Status::Ok &&
          rme::push_log_evidence<double, 7>(marginals, {}, sample.raw.jacobian, {}, log_evidence) == Status::Ok)
        push += log_evidence;
      if (rme::pseudo_wrench(sample.raw.jacobian, sample.raw.tau_ext, 0.01, wrench) == Status::Ok)
        wrench = rme::in_end_effector_axes(wrench, sample.raw.rotation);
      inferred += tank.update(sample.raw.dq, sample.raw.tau_ext, wrench.force.norm()) == Status::Ok;  // any will do
      sums = Statistics();
    }
    window.reset();
    detector.reset();
  });
  CHECK(count == 0);
  CHECK(detected > 0);
  CHECK(asked > 5);
  CHECK(inferred > 15);
  CHECK(push != 0);
}

}  // namespace

#endif
