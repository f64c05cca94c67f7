#include <Eigen/Eigenvalues>
#include <cmath>
#include <random>
#include <rme/tracking/payload_belief.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using rme::kInertial;
using Gaussian = rme::InertialGaussian<double>;
constexpr double kLargest = 3;

/// Correlated, with a mass of this mean and deviation.
Gaussian random_gaussian(std::mt19937& random, double mass, double deviation) {
  const oracle::Matrix L = 0.3 * oracle::random_matrix(random, kInertial, kInertial);
  Gaussian out;
  out.mean = oracle::random_matrix(random, kInertial, 1);
  out.mean[0] = mass;
  out.covariance = L * L.transpose();
  const double scale = deviation / std::sqrt(out.covariance(0, 0));
  out.covariance.row(0) *= scale;
  out.covariance.col(0) *= scale;
  return out;
}

/// Mean and covariance of (mass, phi_k) with the mass in [0, largest]: sums of the joint density over a grid, which
/// goes eight deviations to either side.
struct Moments {
  Eigen::Vector2d mean;
  Eigen::Matrix2d covariance;
};
Moments on_a_grid(const Gaussian& free, int k) {
  Eigen::Matrix2d P;
  P << free.covariance(0, 0), free.covariance(0, k), free.covariance(k, 0), free.covariance(k, k);
  const Eigen::Matrix2d precision = P.inverse();
  const double dm = std::sqrt(P(0, 0)), dx = std::sqrt(P(1, 1));
  const double low = std::max(0.0, free.mean[0] - 8 * dm), high = std::min(kLargest, free.mean[0] + 8 * dm);
  constexpr int kMass = 600, kOther = 600;
  double total = 0;
  Eigen::Vector2d first = Eigen::Vector2d::Zero();
  Eigen::Matrix2d second = Eigen::Matrix2d::Zero();
  for (int i = 0; i < kMass; ++i) {
    const double m = low + (high - low) * (i + 0.5) / kMass - free.mean[0];
    for (int j = 0; j < kOther; ++j) {
      const double x = dx * (16 * (j + 0.5) / kOther - 8);
      const Eigen::Vector2d d(m, x);
      const double density = std::exp(-0.5 * d.dot(precision * d));
      total += density;
      first += density * d;
      second += density * d * d.transpose();
    }
  }
  first /= total;
  return {Eigen::Vector2d(free.mean[0], free.mean[k]) + first, second / total - first * first.transpose()};
}

TEST_CASE("within_rated: a belief that is cut has the moments of the truncated density", "[belief]") {
  const unsigned seed = 550;
  CAPTURE(seed);
  std::mt19937 random(seed);
  // mean, deviation: cut below, above, on both sides, and nearly all of it cut away
  for (const auto& [mass, deviation] :
       {std::pair(0.1, 0.2), std::pair(-0.3, 0.2), std::pair(0.3, 0.1), std::pair(2.9, 0.3), std::pair(3.4, 0.3),
        std::pair(1.0, 2.0), std::pair(-0.6, 0.2)}) {
    const Gaussian free = random_gaussian(random, mass, deviation);
    const Gaussian cut = rme::within_rated(free, kLargest);
    CHECK(cut.mean[0] > 0);
    CHECK(cut.mean[0] < kLargest);
    for (const int k : {1, 4, 9}) {
      CAPTURE(mass, deviation, k);
      const Moments exact = on_a_grid(free, k);
      const double scale = std::sqrt(free.covariance(k, k));
      CHECK(cut.mean[0] == Approx(exact.mean[0]).margin(2e-4 * deviation));
      CHECK(cut.mean[k] == Approx(exact.mean[1]).margin(2e-4 * scale));
      CHECK(cut.covariance(0, 0) == Approx(exact.covariance(0, 0)).margin(4e-4 * deviation * deviation));
      CHECK(cut.covariance(0, k) == Approx(exact.covariance(0, 1)).margin(4e-4 * deviation * scale));
      CHECK(cut.covariance(k, k) == Approx(exact.covariance(1, 1)).margin(4e-4 * scale * scale));
    }
  }
}

TEST_CASE("within_rated: what is four deviations inside is not touched", "[belief]") {
  const unsigned seed = 551;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const Gaussian free = random_gaussian(random, 1, 0.2);
  const Gaussian same = rme::within_rated(free, kLargest);
  CHECK(same.mean == free.mean);
  CHECK(same.covariance == free.covariance);
}

template <typename Scalar>
void check_far_out() {
  for (const double mass : {-50.0, -3.0, -0.9, 3.9, 6.0, 50.0}) {
    for (const double deviation : {0.0, 1e-9, 1e-3, 0.05, 0.2}) {
      CAPTURE(mass, deviation);
      rme::InertialGaussian<Scalar> free;
      free.mean[0] = Scalar(mass);
      free.mean[3] = Scalar(0.1 * mass);
      free.covariance(0, 0) = Scalar(deviation * deviation);
      free.covariance(0, 3) = free.covariance(3, 0) = Scalar(0.1 * deviation * deviation);
      free.covariance(3, 3) = Scalar(0.011 * deviation * deviation);
      const auto cut = rme::within_rated(free, Scalar(kLargest));
      CHECK(cut.mean.allFinite());
      CHECK(cut.covariance.allFinite());
      CHECK(cut.mean[0] >= 0);
      CHECK(cut.mean[0] <= Scalar(kLargest));
      CHECK(cut.covariance(0, 0) >= 0);
      const double distance = mass < 0 ? -mass : mass - kLargest;
      const double from_bound = mass < 0 ? double(cut.mean[0]) : kLargest - double(cut.mean[0]);
      if (distance > 5 * deviation) {  // a contradiction: as unsure as it is large
        CHECK(from_bound == 0);
        if (deviation > 1e-6 * kLargest)
          CHECK(double(cut.covariance(0, 0)) == Approx(std::max(deviation * deviation, 0.25 * distance * distance)));
      } else {  // the tail falls off over less than deviation^2 / distance (Mills' ratio)
        CHECK(from_bound <= 1.1 * deviation * deviation / distance);
        CHECK(cut.covariance(0, 0) <= free.covariance(0, 0));
      }
      // A determinant that is not negative: still a covariance.
      const double det = double(cut.covariance(0, 0)) * double(cut.covariance(3, 3)) -
                         double(cut.covariance(0, 3)) * double(cut.covariance(0, 3));
      CHECK(det >= -1e-6 * double(cut.covariance(0, 0)) * double(cut.covariance(3, 3)));
    }
  }
}

TEST_CASE("within_rated: a belief far out of what is possible ends at the bound, finite and unsure", "[belief]") {
  check_far_out<double>();
  check_far_out<float>();
}

TEST_CASE("payload_of: of a mass that is known well, mean and covariance of (m, r) are those of samples", "[belief]") {
  const unsigned seed = 552;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto prior = rme::PayloadPrior<double>::of(3);
  for (int trial = 0; trial < 3; ++trial) {
    CAPTURE(trial);
    Gaussian phi;
    phi.mean << 1.2, 0.05, -0.03, 0.13, 0.01, 0, 0, 0.01, 0, 0.01;
    // 2 % of the mass, 5 mm of the centre, correlated.
    oracle::Matrix L = 0.01 * oracle::random_matrix(random, 4, 4);
    L.row(0) *= 2;
    L.bottomRows(3) *= 0.5;
    phi.covariance.topLeftCorner<4, 4>() = L * L.transpose();
    const auto out = rme::payload_of(phi, prior);
    constexpr int kSamples = 400'000;
    rme::Vector4<double> mean = rme::Vector4<double>::Zero();
    rme::Matrix4<double> square = rme::Matrix4<double>::Zero();
    std::normal_distribution<double> n;
    for (int k = 0; k < kSamples; ++k) {
      rme::Vector4<double> x = rme::Vector4<double>::NullaryExpr([&] { return n(random); });
      x = phi.mean.head<4>() + L * x;
      x.tail<3>() /= x[0];
      const rme::Vector4<double> d = x - out.mean;
      mean += d / kSamples;
      square += d * d.transpose() / kSamples;
    }
    const rme::Vector4<double> deviation = out.standard_deviation();
    for (int i = 0; i < 4; ++i) {
      CAPTURE(i);
      // To first order: what is left out is a share of (2 to 4 %) of a deviation.
      CHECK(std::abs(mean[i]) < 0.05 * deviation[i]);
      for (int k = 0; k < 4; ++k)
        CHECK(std::abs(square(i, k) - out.covariance(i, k)) < 0.03 * deviation[i] * deviation[k]);
    }
  }
}

TEST_CASE("payload_of: a payload too light to show its centre has the prior's", "[belief]") {
  const auto prior = rme::PayloadPrior<double>::of(3);
  Gaussian phi;
  for (const double mass : {0.0, 0.01, 0.049}) {
    CAPTURE(mass);
    phi.mean[0] = mass;
    phi.mean.segment<3>(1).setConstant(7);
    phi.covariance.setIdentity();
    phi.covariance(0, 0) = 0.05 * 0.05;
    const auto out = rme::payload_of(phi, prior);
    CHECK(out.mean[0] == mass);
    CHECK(out.mean.tail<3>() == prior.com_mean);
    CHECK(out.covariance(0, 0) == phi.covariance(0, 0));
    CHECK(out.covariance.diagonal().tail<3>() == prior.com_std.cwiseAbs2());
  }
}

TEST_CASE("within_prior: where the ratio says less of the centre than the prior does, it is the best linear estimate",
          "[belief]") {
  const unsigned seed = 554;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> n;
  const auto prior = rme::PayloadPrior<double>::of(3);
  // A centre from twice the prior, and a ratio that is off by far more, by an error that goes with the mass.
  const rme::Vector3<double> width = 2 * prior.com_std, noise(0.5, 1, 50);
  rme::PayloadGaussian<double> ratio;
  ratio.mean << 0.05, 3, -0.4, 11;
  ratio.covariance.setZero();
  ratio.covariance(0, 0) = 0.01 * 0.01;
  for (int i = 0; i < 3; ++i) {
    ratio.covariance(1 + i, 1 + i) = width[i] * width[i] + noise[i] * noise[i];
    ratio.covariance(0, 1 + i) = ratio.covariance(1 + i, 0) = 0.005 * noise[i];
  }
  ratio.covariance(1, 2) = ratio.covariance(2, 1) = 0.1;
  const auto out = rme::within_prior(ratio, prior);
  for (int i = 0; i < 3; ++i) {
    CAPTURE(i);
    const double gain = width[i] * width[i] / ratio.covariance(1 + i, 1 + i);
    CHECK(out.mean[1 + i] == Approx(prior.com_mean[i] + gain * (ratio.mean[1 + i] - prior.com_mean[i])));
    CHECK(out.standard_deviation()[1 + i] == Approx(width[i]));
    CHECK(out.covariance(0, 1 + i) == Approx(gain * ratio.covariance(0, 1 + i)));
    CHECK(out.covariance(1 + i, 0) == out.covariance(0, 1 + i));
  }
  CHECK(out.mean[0] == ratio.mean[0]);
  CHECK(out.covariance(0, 0) == ratio.covariance(0, 0));
  // An error of the ratio that is drawn leaves the centre within what is stated, as often as it should.
  int held = 0;
  constexpr int kDraws = 100'000;
  for (int k = 0; k < kDraws; ++k) {
    const double centre = prior.com_mean[0] + width[0] * n(random);
    rme::PayloadGaussian<double> drawn = ratio;
    drawn.mean[1] = centre + noise[0] * n(random);
    const double off = rme::within_prior(drawn, prior).mean[1] - centre;
    held += std::abs(off) < 1.645 * width[0] ? 1 : 0;
  }
  CHECK(held > 0.9 * kDraws);
}

TEST_CASE(
    "within_prior: a centre that is known better than twice the prior is not touched, and no covariance becomes "
    "indefinite",
    "[belief]") {
  const unsigned seed = 555;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto prior = rme::PayloadPrior<double>::of(3);
  for (int trial = 0; trial < 1000; ++trial) {
    CAPTURE(trial);
    rme::PayloadGaussian<double> free;
    const oracle::Matrix L = std::pow(10.0, trial % 5 - 2) * oracle::random_matrix(random, 4, 4);
    free.covariance = L * L.transpose();
    free.mean = oracle::random_matrix(random, 4, 1);
    const auto out = rme::within_prior(free, prior);
    bool known = true;
    for (int i = 0; i < 3; ++i) {
      known = known && std::sqrt(free.covariance(1 + i, 1 + i)) <= 2 * prior.com_std[i];
      CHECK(out.standard_deviation()[1 + i] <= 2 * prior.com_std[i] * (1 + 1e-12));
    }
    if (known) CHECK((out.mean == free.mean && out.covariance == free.covariance));
    const rme::Matrix4<double> larger = rme::no_wider_than_prior<double>(10 * out.covariance, prior);
    for (int i = 0; i < 3; ++i)
      CHECK(std::sqrt(larger(1 + i, 1 + i)) ==
            Approx(std::min(2 * prior.com_std[i], std::sqrt(10 * out.covariance(1 + i, 1 + i)))));
    CHECK(larger(0, 0) == 10 * out.covariance(0, 0));
    for (const oracle::Matrix& covariance : {oracle::Matrix(out.covariance), oracle::Matrix(larger)})
      CHECK(Eigen::SelfAdjointEigenSolver<oracle::Matrix>(covariance).eigenvalues().minCoeff() >
            -1e-9 * covariance.norm());
  }
}

TEST_CASE("PayloadPrior: its Gaussian over (m, m r) has the moments of samples of (m, r)", "[belief]") {
  const unsigned seed = 553;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  const auto prior = rme::PayloadPrior<double>::of(3);
  const auto factor = prior.factor(prior.square_mass());
  const rme::InertialMatrix<double> covariance = factor * factor.transpose();
  constexpr int kSamples = 400'000;
  rme::Vector4<double> mean = rme::Vector4<double>::Zero();
  rme::Matrix4<double> square = rme::Matrix4<double>::Zero();
  for (int k = 0; k < kSamples; ++k) {
    const double m = prior.mass_mean + prior.mass_std * n(random);
    rme::Vector4<double> x;
    x[0] = m;
    for (int i = 0; i < 3; ++i) x[1 + i] = m * (prior.com_mean[i] + prior.com_std[i] * n(random));
    const rme::Vector4<double> d = x - prior.mean().head<4>();
    mean += d / kSamples;
    square += d * d.transpose() / kSamples;
  }
  for (int i = 0; i < 4; ++i) {
    CHECK(std::abs(mean[i]) < 0.01 * std::sqrt(covariance(i, i)));
    for (int k = 0; k < 4; ++k)
      CHECK(std::abs(square(i, k) - covariance(i, k)) < 0.02 * std::sqrt(covariance(i, i) * covariance(k, k)));
  }
}

TEST_CASE("ArmPrior: torques scale with what an arm lifts, and the wrist has less of them", "[belief]") {
  const auto panda = rme::ArmPrior<double, 7>::of(3), strong = rme::ArmPrior<double, 7>::of(12);
  CHECK(panda.offset[0] == Approx(0.15));
  CHECK(panda.offset[6] == Approx(0.06));
  for (int j = 0; j < 7; ++j) {
    CHECK(strong.offset[j] == Approx(4 * panda.offset[j]));
    CHECK(strong.coulomb[j] == Approx(4 * panda.coulomb[j]));
    CHECK(strong.viscous[j] == Approx(4 * panda.viscous[j]));
    CHECK(strong.noise[j] == Approx(4 * panda.noise[j]));
    CHECK(strong.residual[j] == Approx(4 * panda.residual[j]));
  }
}

}  // namespace
