#include <cmath>
#include <random>
#include <rme/tracking/bank/pour_monitor.hpp>

#include "support/catch.hpp"

namespace {

constexpr int kDofs = 7;
constexpr double kBlock = 0.02;  // [s]
constexpr double kRated = 3;     // [kg]
using Joints = rme::JointVector<double, kDofs>;

/// A payload whose torque has a share in every joint, and innovations with the covariance that *steady* expects.
struct Held {
  explicit Held(unsigned seed) : random(seed) {
    std::uniform_real_distribution<double> any(-1, 1);
    block.duration = kBlock;
    phi.setZero();
    phi[0] = 1.2;
    phi[2] = 0.1;
    for (int j = 0; j < kDofs; ++j) {
      for (int i = 0; i < rme::kInertial; ++i) block.regressor(j, i) = 5 * any(random);
      variance[j] = std::exp(any(random)) * 1e-4;
      noise[j] = 0.8 * variance[j];
      load[j] = block.regressor(j, 0) * phi[0] + block.regressor(j, 2) * phi[2];
    }
  }
  /// White, and so many standard deviations along the payload's torque.
  Joints innovation(double along) {
    std::normal_distribution<double> normal;
    double square = 0;
    for (int j = 0; j < kDofs; ++j) square += load[j] * load[j] / variance[j];
    Joints e;
    for (int j = 0; j < kDofs; ++j)
      e[j] = normal(random) * std::sqrt(variance[j]) + along * load[j] / std::sqrt(square);
    return e;
  }

  std::mt19937 random;
  rme::TorqueBlock<double, kDofs> block;
  rme::InertialVector<double> phi;
  Joints variance, noise, load;
  rme::bank::PourMonitor<double, kDofs> monitor;
};

TEST_CASE("PourMonitor: white innovations raise the odds of a pour as often as chance does", "[pour]") {
  // |N(0, 1)| > 3 in 0.27 % of the blocks; in runs of some ten blocks, of which 2e5 blocks see about 60.
  constexpr unsigned kSeed = 1;
  CAPTURE(kSeed);
  Held held(kSeed);
  held.noise = 0.01 * held.variance;  // *steady* follows quickly: the lean alone decides
  int raised = 0;
  constexpr int kBlocks = 200000;
  for (int k = 0; k < kBlocks; ++k) {
    held.monitor.follow_steady(held.block, held.phi, kRated, held.innovation(0), held.variance, held.noise);
    raised += held.monitor.onset() > 0 ? 1 : 0;
  }
  CAPTURE(raised);
  CHECK(raised > 0.0012 * kBlocks);
  CHECK(raised < 0.0054 * kBlocks);
}

TEST_CASE("PourMonitor: innovations that lean towards the payload's torque by half a deviation show within a second",
          "[pour]") {
  // The average of a lean l tends to l sqrt((1 + k) / (1 - k)) = 7 l: 3.5 here, and 3 is passed in 50 blocks or fewer
  // but for noise.
  for (const double sign : {-1.0, 1.0}) {
    int late = 0;
    for (unsigned seed = 1; seed < 101; ++seed) {
      Held held(seed);
      int k = 0;
      while (k < 1000 && !(held.monitor.onset() > 0)) {
        ++k;
        held.monitor.follow_steady(held.block, held.phi, kRated, held.innovation(0.7 * sign), held.variance,
                                   held.noise);
      }
      late += k > 50 ? 1 : 0;
    }
    CAPTURE(sign, late);
    CHECK(late < 10);
  }
}

TEST_CASE(
    "PourMonitor: innovations across the payload's torque are no pour, nor is a single block, nor what is forgotten",
    "[pour]") {
  Held held(3);
  // Across it, in the metric of S.
  Joints across = held.innovation(0);
  double along = 0, square = 0;
  for (int j = 0; j < kDofs; ++j) {
    along += held.load[j] * across[j] / held.variance[j];
    square += held.load[j] * held.load[j] / held.variance[j];
  }
  across -= along / square * held.load;
  for (int k = 0; k < 500; ++k) {
    held.monitor.follow_steady(held.block, held.phi, kRated, 10 * across, held.variance, held.noise);
    REQUIRE(held.monitor.onset() == 0);
  }
  const Joints wild = 1e3 * held.load;
  held.monitor.follow_steady(held.block, held.phi, kRated, wild, held.variance, held.noise);
  CHECK(held.monitor.onset() == 0);
  for (int k = 0; k < 20; ++k)
    held.monitor.follow_steady(held.block, held.phi, kRated, wild, held.variance, held.noise);
  CHECK(held.monitor.onset() > 0);
  held.monitor.forget_lean();
  CHECK(held.monitor.onset() == 0);
}

TEST_CASE("PourMonitor: what steady follows no faster than offsets drift is no pour", "[pour]") {
  // The load grows by `rate` of the rated payload in 20 ms, and *steady*, with the gain 1 - R / S, is behind it by what
  // it follows in a block over the gain.
  for (const double duration : {0.01, 0.02, 0.04}) {
    for (const double rate : {0.00002, 0.00004}) {
      Held held(5);
      held.block.duration = duration;
      const double gain = 0.01, mass = held.phi[0], poured = rate * kRated * duration / kBlock;
      held.noise = (1 - gain) * held.variance;
      for (int k = 0; k < 500; ++k)
        held.monitor.follow_steady(held.block, held.phi, kRated, poured / mass / gain * held.load, held.variance,
                                   held.noise);
      CAPTURE(duration, rate);
      CHECK(held.monitor.onset() == Approx(rate > 0.00003 ? 0.2 : 0));
    }
  }
}

TEST_CASE("PourMonitor: filling is to end once its pace is below 15 g/s of 3 kg", "[pour]") {
  for (const double pace : {-0.00012, -0.00009, 0.00009, 0.00012}) {
    Held held(6);
    CHECK(held.monitor.end() == 0);  // it may be any at first
    for (int k = 0; k < 200; ++k) held.monitor.follow_filling(pace, kBlock);
    CAPTURE(pace);
    CHECK(held.monitor.end() == Approx(std::abs(pace) < 0.0001 ? 0.03 : 0));
  }
}

TEST_CASE("PourMonitor: nothing held has no torque that innovations could lean to", "[pour]") {
  Held held(4);
  for (int k = 0; k < 100; ++k)
    held.monitor.follow_steady(held.block, rme::InertialVector<double>::Zero(), kRated, held.innovation(5),
                               held.variance, held.noise);
  CHECK(held.monitor.onset() == 0);
}

TEST_CASE("PourMonitor: the spread is three times what comes in a block, between its bounds, whatever a block's length",
          "[pour]") {
  for (const double duration : {0.01, 0.02, 0.04}) {
    const auto spread_at = [duration](double rate) {  // [1/s] of the rated payload
      rme::bank::PourMonitor<double, kDofs> monitor;
      for (int k = 0; k < 200; ++k) monitor.follow_filling(rate * duration, duration);
      return monitor.spread(duration);
    };
    const double root = std::sqrt(duration / kBlock);
    CAPTURE(duration);
    CHECK(spread_at(0.02) == Approx(3 * 0.02 * kBlock * root));
    CHECK(spread_at(-0.02) == Approx(3 * 0.02 * kBlock * root));
    CHECK(spread_at(0.0001) == Approx(0.00027 * root));
    CHECK(spread_at(1) == Approx(0.0027 * root));
  }
}

TEST_CASE("PourMonitor: a pour begins as any, is followed within some blocks, and is forgotten", "[pour]") {
  rme::bank::PourMonitor<double, kDofs> monitor;
  const double any = monitor.spread(kBlock);
  CHECK(any == Approx(0.0027));
  for (int time = 0; time < 2; ++time) {
    for (int k = 0; k < 10; ++k) monitor.follow_filling(0.0002, kBlock);
    // The first block's 0.0009 counts for 0.9^10 still.
    CHECK(monitor.spread(kBlock) == Approx(3 * (0.0002 + std::pow(0.9, 10) * 0.0007)));
    monitor.forget_pace();
    CHECK(monitor.spread(kBlock) == Approx(any));
  }
}

}  // namespace
