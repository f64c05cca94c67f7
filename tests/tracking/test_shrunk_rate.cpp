#include <cmath>
#include <random>
#include <rme/tracking/shrunk_rate.hpp>

#include "support/catch.hpp"

namespace {

using rme::RateNoise;
using Known = rme::ShrunkRate<double, RateNoise::Known>;
using Learned = rme::ShrunkRate<double, RateNoise::Learned>;

/// Acceleration of moves by 0.3 that take a second, with a second of rest after each, in blocks of 20 ms.
double move_and_rest(int block) {
  const double t = 0.02 * (block % 100);
  return t < 1 ? 0.3 * (60 * t - 180 * t * t + 120 * t * t * t) : 0;
}

TEST_CASE("ShrunkRate: of the information that noise at rest would give, less than a thousandth is left", "[rate]") {
  // k x stands in the regressor, and the information against the payload is the sum of its squares.
  const unsigned seed = 711;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const int blocks = 200'000;
  Known known;
  Learned learned, bounded;
  double left = 0, left_learned = 0, left_bounded = 0, variance = 0;
  for (int i = 0; i < blocks; ++i) {
    const double x = 0.08 * normal(random);
    const auto posterior = known.update(x, 0.0064);
    left += std::pow(posterior.share * x / 0.08, 2) / blocks;
    left_bounded += std::pow(bounded.update(x, 0.003).share * x / 0.08, 2) / blocks;
    variance += posterior.variance / 0.0064 / blocks;
    if (i > 4) left_learned += std::pow(learned.update(x, 0).share * x / 0.08, 2) / blocks;
  }
  CHECK(left < 5e-4);
  CHECK(left_bounded < 1e-3);  // the noise is twice as large as it is said to be
  CHECK(left_learned < 1e-3);
  // Nothing is missing: the variance is that of the statistics.
  CHECK(variance < 0.2);
}

TEST_CASE("ShrunkRate: in motion the posterior mean dilutes no regressor, and its variance is that of its error",
          "[rate]") {
  const unsigned seed = 712;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const double noise = 0.006;  // 2 mrad/s of dq, 20 samples in 20 ms
  Known rate;
  double dilution = 0, plain = 0, information = 0, error = 0, variance = 0;
  int count = 0;
  for (int i = 0; i < 50'000; ++i) {
    const double a = move_and_rest(i), x = a + std::sqrt(noise) * normal(random);
    const auto p = rate.update(x, noise);
    if (i % 100 >= 50) continue;
    dilution += p.share * x * (a - p.share * x);
    plain += x * (a - x);
    information += p.share * p.share * x * x;
    error += (a - p.share * x) * (a - p.share * x);
    variance += p.variance;
    ++count;
  }
  CHECK(std::abs(dilution / information) < 0.003);
  CHECK(plain / information < -0.004);
  CHECK(error / count < 1.5 * noise);
  CHECK(variance / error == Approx(1).epsilon(0.3));
}

TEST_CASE("ShrunkRate: the mean of a learned rate has little of a block's own noise, and all of a clear change",
          "[rate]") {
  const unsigned seed = 716;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Learned rate;
  const double deviation = 0.5;
  double own = 0, plain = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double e = deviation * normal(random);
    const auto posterior = rate.update(5 + e, 0);
    if (i < 100) continue;
    own += posterior.mean * e;
    plain += posterior.share * (5 + e) * e;
  }
  CHECK(own < 0.2 * plain);
  CHECK(rate.update(15, 0).mean == Approx(15).epsilon(0.05));
  CHECK(rate.update(-20, 0).mean == Approx(-20).epsilon(0.05));
}

TEST_CASE("ShrunkRate: with a clean dq, motion passes to 1e-3 from its first block on", "[rate]") {
  const unsigned seed = 713;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const double noise = 1.5e-5;  // 0.1 mrad/s
  Known rate;
  double worst = 0;
  for (int i = 0; i < 5000; ++i) {
    const double a = move_and_rest(i + 50), x = a + std::sqrt(noise) * normal(random);
    const double share = rate.update(x, noise).share;
    if (std::abs(a) > 0.2) worst = std::max(worst, 1 - share);
  }
  CHECK(worst < 1e-3);
  // A jolt of one block, after a long rest and without any noise.
  Known quiet;
  for (int i = 0; i < 100; ++i) CHECK(quiet.update(0, 0).share == 0);
  CHECK(quiet.update(2, 0).share == 1);
  CHECK(quiet.update(-2, 0).share == 1);
}

TEST_CASE("ShrunkRate: a quarter of a second after a motion its noise is shut out, and within a motion never",
          "[rate]") {
  const unsigned seed = 716;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const double noise = 0.006;
  Known stops, swings;
  double after = 0, least = 1;
  for (int i = 0; i < 50'000; ++i) {
    const double share = stops.update(move_and_rest(i) + std::sqrt(noise) * normal(random), noise).share;
    if (i % 100 >= 63) after += share / (50'000 * 0.37);
    const double x =
        3 * std::sin(6.283 * 5 * 0.02 * i) + std::sqrt(noise) * normal(random);  // 5 Hz, zero each 5 blocks
    const double swing = swings.update(x, noise).share;
    if (i > 20) least = std::min(least, swing);
  }
  CHECK(after < 0.01);
  CHECK(least > 0.98);
}

TEST_CASE("ShrunkRate: noise that is larger than it is said to be shows in its changes", "[rate]") {
  // As dq that the arm has filtered: its second differences are far smaller than those of white noise.
  const unsigned seed = 714;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Known rate;
  double left = 0;
  for (int i = 0; i < 20'000; ++i) {
    const double x = normal(random);
    const double share = rate.update(x, 0.01).share;
    if (i > 100) left += share * share * x * x / 20'000;
  }
  CHECK(left < 5e-3);
}

TEST_CASE("ShrunkRate: one huge rate leaves no doubt about the small ones after it", "[rate]") {
  Known rate;
  for (int k = 0; k < 100; ++k) rate.update(k % 2 == 0 ? 0.01 : -0.01, 1e-4);
  rate.update(50, 1e-4);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    CHECK(rate.update(k % 2 == 0 ? 0.01 : -0.01, 1e-4).variance <= 1e-4 + 1e-4 + 1e-12);
  }
}

TEST_CASE("ShrunkRate: a rate whose sign changes from block to block counts as variance, not as a prior", "[rate]") {
  Known rate;
  Known::Posterior p;
  for (int i = 0; i < 100; ++i) p = rate.update(i % 2 == 0 ? 0.3 : -0.3, 0.01);
  CHECK(p.share == 0);
  CHECK(p.variance == Approx(0.09 - 0.01).epsilon(1e-3));
}

TEST_CASE("ShrunkRate: a step after quiet passes in full", "[rate]") {
  const unsigned seed = 715;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Learned rate;
  for (int i = 0; i < 500; ++i) CHECK(rate.update(0.8 * normal(random), 0).share < 0.5);
  // The observer's response to 5 N m: 50 rad/s, in blocks of 20 ms.
  for (const double x : {158.0, 58.0, 21.0}) CHECK(rate.update(x, 0).share > 0.98);
}

TEST_CASE("ShrunkRate: across an interruption, rates have no predecessor", "[rate]") {
  Known rate, interrupted;
  for (int i = 0; i < 50; ++i) {
    (void)rate.update(0.1, 0.01);
    (void)interrupted.update(0.1, 0.01);
  }
  CHECK(rate.update(0.1, 0.01).share == interrupted.update(0.1, 0.01).share);
  interrupted.interrupt();
  const double with = rate.update(-0.2, 0.01).variance;
  CHECK(interrupted.update(-0.2, 0.01).variance == Approx(with).epsilon(0.5));
  Known first;
  first.interrupt();
  CHECK(first.update(0.3, 0.01).share == 0);  // 3 standard deviations and no second one
}

}  // namespace
