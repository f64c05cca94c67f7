#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <new>
#include <rme/control/energy_tank.hpp>
#include <rme/core/compensation.hpp>
#include <rme/inference/payload_statistics.hpp>
#include <rme/inference/variational_inference.hpp>
#include <rme/network/mismatch_network.hpp>
#include <rme/runtime_estimator.hpp>
#include <rme/sensing/mismatch_detector.hpp>
#include <rme/sensing/pseudo_wrench.hpp>

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
  int refused = 0, contacts = 0;
  double largest = 0;
  const int count = allocations_of([&] {
    for (int round = 0; round < 3; ++round) {
      for (std::size_t k = 0; k < ticks.size(); ++k) {
        if (round > 0 && k % 1000 == 990) estimator.expect_change();
        if (round == 1 && k == 900) estimator.declare_empty();
        if (round == 2 && k == 900) refused += estimator.set_payload(said) != Status::Ok;
        if (round == 2 && k == 2000) estimator.tare();
        if (round == 2 && k % 1500 == 0) estimator.in_contact(k % 3000 == 0);
        refused += estimator.update(ticks[k]) != Status::Ok;
        met[static_cast<int>(estimator.state().event.kind)] = true;
        refused += ramp.update(estimator.compensation(ticks[k].jacobian, ticks[k].rotation)) != Status::Ok;
        largest = std::max(largest, ramp.torque().norm());
        const auto moved = estimator.payload_torque(ticks[k].jacobian, ticks[k].rotation, rme::FlangeMotion<double>());
        largest = std::max(largest, moved.norm());
        contacts += estimator.contact().contact && estimator.contact().likeliest_link() > 0;
      }
      estimator.reset();
    }
  });
  CHECK(count == 0);
  for (const bool kind : met) CHECK(kind);
  CHECK(refused > 300);
  CHECK(contacts > 300);
  CHECK(largest > 1);
}

TEST_CASE("Allocations: none in the estimator for a number of joints that is known at run time", "[realtime]") {
  const std::uint64_t seed = 301;
  CAPTURE(seed);
  rme::testing::HeldArm arm(seed);
  rme::RuntimeEstimator<double, 7, 7> estimator(7, kPeriod);
  Eigen::VectorXd tau_ext(7), dq(7), carried = Eigen::VectorXd::Zero(7);
  Eigen::MatrixXd jacobian(6, 7);
  Eigen::Matrix<double, Eigen::Dynamic, 3> gravity(7, 3);
  int refused = 0, contacts = 0;
  const int count = allocations_of([&] {
    for (int k = 0; k < 2000; ++k) {
      if (k == 1000) arm.hold({1, {0, 0, 0.1}});
      const auto& sample = arm.tick();
      tau_ext = sample.tau_ext;
      dq = sample.dq;
      jacobian = sample.jacobian;
      gravity.setZero();
      refused += (k % 3 == 0   ? estimator.update(tau_ext, jacobian, sample.rotation, dq)
                  : k % 3 == 1 ? estimator.update(tau_ext, jacobian, sample.rotation, dq, kPeriod, {}, carried)
                               : estimator.update(tau_ext, jacobian, sample.rotation, dq, 0, {}, carried, gravity)) !=
                 Status::Ok;
      refused += estimator.compensation(jacobian, sample.rotation, carried) != Status::Ok;
      contacts += estimator.contact().contact;
    }
    estimator.expect_change();
    estimator.in_contact(true);
  });
  CHECK(count == 0);
  CHECK(refused == 0);
  CHECK(contacts > 10);
  CHECK(carried.norm() > 1);
}

TEST_CASE("Allocations: none in the building blocks: detector, pseudo-wrench, network, sums, energy tank",
          "[realtime]") {
  const std::uint64_t seed = 302;
  CAPTURE(seed);
  auto ticks = life(seed);
  spoil(ticks);
  const auto network = std::make_unique<rme::MismatchNetwork<float>>(*golden::random_weights<float>());
  rme::MismatchDetector<7> detector(kPeriod);
  rme::MismatchDetector<1> published(kPeriod, rme::MismatchDetectorConfig::published());
  rme::PayloadStatistics<double, 7> sums;
  rme::EnergyTank<double, 7> tank(kPeriod);
  rme::MismatchNetwork<float>::Window window;
  rme::MismatchNetwork<float>::Output guess;
  int detected = 0, asked = 0, inferred = 0;
  const int count = allocations_of([&] {
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      const auto& tick = ticks[k];
      if (check_sample(tick) != Status::Ok) continue;
      const bool watched = detector.update(tick.tau_ext) == Status::Ok;
      const bool heard = published.update(Eigen::Matrix<double, 1, 1>(tick.tau_ext.norm())) == Status::Ok;
      detected += watched && heard && (detector.detected() || published.detected());
      sums.add({tick.tau_ext,
                rme::payload_regressor<double, 7>(tick.jacobian, tick.rotation, rme::standard_gravity<double>())});
      if (k % 500 != 499) continue;
      rme::InferenceResult<double> result;
      const auto likelihood = sums.likelihood(rme::JointVector<double, 7>::Constant(100));
      inferred += rme::infer_payload(likelihood, Gaussian(), result) == Status::Ok;
      rme::Wrench<double> wrench;
      if (rme::pseudo_wrench(tick.jacobian, tick.tau_ext, 0.01, wrench) == Status::Ok)
        wrench = rme::in_end_effector_axes(wrench, tick.rotation);
      window.rowwise() = wrench.vector().cast<float>().transpose();
      asked += network->forward(window, guess) == Status::Ok;
      inferred += tank.update(tick.dq, tick.tau_ext, wrench.force.norm()) == Status::Ok;  // any will do
      sums = {};
    }
    detector.reset();
  });
  CHECK(count == 0);
  CHECK(detected > 0);
  CHECK(asked > 5);
  CHECK(inferred > 15);
}

}  // namespace

#endif
