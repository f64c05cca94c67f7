#include <algorithm>
#include <cmath>
#include <random>
#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/variational_inference.hpp>
#include <vector>

#include "inference/likelihoods.hpp"
#include "support/catch.hpp"

namespace {

using rme::Status;
using rme::testing::likelihood_of;
using rme::testing::random_event;
using rme::testing::wide_prior;

TEST_CASE("exact_posterior: moments and evidence are those of a dense four-dimensional grid", "[exact]") {
  const unsigned seed = 40;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 3; ++k) {
    CAPTURE(k);
    const auto event = random_event(random, 3);  // few samples: wide, skewed posteriors
    const auto likelihood = likelihood_of(event, 0.0005 * event.precision);
    auto prior = wide_prior();
    if (k == 2) {  // heavy things are long, and stick out sideways
      const Eigen::Vector4d direction(0.6, 0.02, -0.03, 0.04);
      prior.covariance += direction * direction.transpose();
    }
    rme::ExactPosterior<double> exact;
    REQUIRE(rme::exact_posterior(likelihood, prior, exact) == Status::Ok);
    const Eigen::Matrix4d prior_precision = prior.covariance.inverse();
    // Midpoint rule over the prior's mean +- 5.5 standard deviations.
    constexpr int n = 44;
    const Eigen::Vector4d sd = prior.standard_deviation();
    const auto node = [&](int axis, int i) { return prior.mean[axis] + sd[axis] * (11.0 * (i + 0.5) / n - 5.5); };
    double p0 = 0;
    Eigen::Vector4d p1 = Eigen::Vector4d::Zero();
    Eigen::Matrix4d p2 = Eigen::Matrix4d::Zero();
    for (int a = 0; a < n; ++a)
      for (int b = 0; b < n; ++b)
        for (int c = 0; c < n; ++c)
          for (int d = 0; d < n; ++d) {
            const Eigen::Vector4d theta(node(0, a), node(1, b), node(2, c), node(3, d));
            const Eigen::Vector4d offset = theta - prior.mean;
            const double p = std::exp(likelihood.log_likelihood(theta) + 0.5 * likelihood.yy -
                                      0.5 * offset.dot(prior_precision * offset));
            p0 += p;
            p1 += p * theta;
            p2 += p * theta * theta.transpose();
          }
    const Eigen::Vector4d mean = p1 / p0;
    const Eigen::Matrix4d covariance = p2 / p0 - mean * mean.transpose();
    // A cell's volume, and the prior's normaliser.
    const double cell = std::pow(11.0 / n, 4) * sd.prod() /
                        (std::pow(2 * std::acos(-1.0), 2) * std::sqrt(prior.covariance.determinant()));
    CHECK(((exact.posterior.mean - mean).cwiseQuotient(sd)).norm() < 1e-3);
    const Eigen::Matrix4d error = exact.posterior.covariance - covariance;
    CHECK(error.cwiseQuotient(sd * sd.transpose()).norm() < 1e-3);
    CHECK(exact.log_evidence == Approx(std::log(p0 * cell)).margin(1e-3));
  }
}

/// Moments of the mass and evidence by the trapezoidal rule on 60,000 nodes over 12 prior deviations, with r integrated
/// out by 3x3 algebra at each. For a prior of independent entries.
struct DenseMass {
  double mean, variance, log_evidence;
};
DenseMass dense_mass(const rme::PayloadLikelihood<double>& l, const rme::PayloadGaussian<double>& prior) {
  const int n = 60000;
  const double sd = std::sqrt(prior.covariance(0, 0)), h = 12 * sd / n;
  const Eigen::Matrix3d P = prior.covariance.block<3, 3>(1, 1).inverse();
  const Eigen::Vector3d r0 = prior.mean.tail<3>();
  std::vector<double> f;
  for (int i = 0; i <= n; ++i) {
    const double m = prior.mean[0] - 6 * sd + i * h, z = (m - prior.mean[0]) / sd;
    const Eigen::Matrix3d A = P + m * m * l.BB;
    const Eigen::Vector3d b = P * r0 + m * l.yB - m * m * l.aB;
    f.push_back(m * l.ya - 0.5 * (m * m * l.aa + z * z + r0.dot(P * r0) - b.dot(A.inverse() * b)) -
                0.5 * std::log(A.determinant() / P.determinant()));
  }
  const double peak = *std::max_element(f.begin(), f.end());
  double p0 = 0, p1 = 0, p2 = 0;
  for (int i = 0; i <= n; ++i) {
    const double p = std::exp(f[static_cast<std::size_t>(i)] - peak), d = i * h - 6 * sd;
    p0 += p, p1 += p * d, p2 += p * d * d;
  }
  p1 /= p0;
  return {prior.mean[0] + p1, p2 / p0 - p1 * p1, peak + std::log(p0 * h / (std::sqrt(2 * std::acos(-1.0)) * sd))};
}

void check_against_dense_nodes(const rme::PayloadLikelihood<double>& l, const rme::PayloadGaussian<double>& prior) {
  const DenseMass dense = dense_mass(l, prior);
  rme::ExactPosterior<double> exact;
  REQUIRE(rme::exact_posterior(l, prior, exact) == Status::Ok);
  CHECK(exact.posterior.mean[0] == Approx(dense.mean).margin(1e-5 * std::sqrt(dense.variance)));
  CHECK(exact.posterior.covariance(0, 0) == Approx(dense.variance).epsilon(1e-5));
  CHECK(exact.log_evidence == Approx(dense.log_evidence).epsilon(1e-10).margin(1e-6));
}

TEST_CASE("exact_posterior: sharp posteriors are integrated as well wherever they lie among the coarse nodes",
          "[exact]") {
  const unsigned seed = 43;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 40; ++k) {
    CAPTURE(k);
    const auto event = random_event(random, 20);
    // White noise alone: the mass is known to a gram or less.
    const rme::PayloadLikelihood<double> l = event.statistics.likelihood(10 * event.precision);
    // In steps of less than 3 grams a whole spacing onwards.
    auto prior = wide_prior();
    const double spacing = 12 * prior.standard_deviation()[0] / 64;
    prior.mean[0] = event.truth[0] + 3 * prior.standard_deviation()[0] + spacing * k / 40;
    check_against_dense_nodes(l, prior);
  }
}

TEST_CASE("exact_posterior: a mass that the prior all but excludes is found", "[exact]") {
  const unsigned seed = 45;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 40; ++k) {
    CAPTURE(k);
    const auto event = random_event(random, 20);
    const rme::PayloadLikelihood<double> l = event.statistics.likelihood(event.precision);
    // 6.5 to 14 deviations of 0.1 kg too heavy, or, where that is a mass still, too light.
    auto prior = wide_prior();
    const double deviations = 6.5 + 0.2 * k;
    prior.covariance(0, 0) = 0.01;
    prior.mean[0] = event.truth[0] + (event.truth[0] > 0.1 * deviations + 0.7 ? -0.1 : 0.1) * deviations;
    rme::ExactPosterior<double> exact;
    rme::InferenceResult<double> vi;
    REQUIRE(rme::exact_posterior(l, prior, exact) == Status::Ok);
    REQUIRE(rme::infer_payload(l, prior, vi) == Status::Ok);
    // The data are sharp, so that the posterior is close to Gaussian.
    CHECK(std::abs(exact.posterior.mean[0] - vi.posterior.mean[0]) < 0.05 * vi.posterior.standard_deviation()[0]);
    CHECK(exact.log_evidence >= vi.log_evidence - 1e-6);
  }
}

TEST_CASE("exact_posterior: both modes count where a light payload far out cannot be told from its mirror image",
          "[exact]") {
  // With a nearly zero the data know m r alone, and (-m, -r) explains it as well as (m, r).
  const unsigned seed = 44;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  double smallest_share = 1;
  for (int k = 0; k < 40; ++k) {
    CAPTURE(k);
    rme::PayloadLikelihood<double> l;
    l.BB = Eigen::Vector3d(1e6, 8e5, 3e5).asDiagonal();
    l.yB << 1.4e4, 1e3 * u(random), 1e3 * u(random);
    l.aa = 1e4 * (1 + 0.5 * u(random));
    l.ya = 5 * u(random);
    auto prior = wide_prior();
    prior.mean << 0.05 * u(random), 0, 0, 0;
    check_against_dense_nodes(l, prior);
    rme::ExactPosterior<double> exact;
    REQUIRE(rme::exact_posterior(l, prior, exact) == Status::Ok);
    smallest_share =
        std::min(smallest_share, std::abs(exact.posterior.mean[0]) / exact.posterior.standard_deviation()[0]);
  }
  CHECK(smallest_share < 0.2);  // there are two modes of nearly equal weight
}

TEST_CASE("exact_posterior: with the mass known it is the linear-Gaussian posterior of the centre of mass", "[exact]") {
  std::mt19937_64 random(41);
  const auto event = random_event(random);
  const auto l = likelihood_of(event);
  const double m = event.truth[0];
  const auto prior = rme::PayloadGaussian<double>::independent({m, 0, 0, 0.1}, {1e-9, 0.05, 0.05, 0.06});
  rme::ExactPosterior<double> exact;
  REQUIRE(rme::exact_posterior(l, prior, exact) == Status::Ok);
  const Eigen::Matrix3d P0 = prior.covariance.block<3, 3>(1, 1).inverse();
  const Eigen::Matrix3d C = (P0 + m * m * l.BB).inverse();
  const Eigen::Vector3d r = C * (P0 * prior.mean.tail<3>() + m * l.yB - m * m * l.aB);
  CHECK((exact.posterior.mean.tail<3>() - r).norm() < 1e-7);
  CHECK((exact.posterior.covariance.block<3, 3>(1, 1) - C).norm() < 1e-6 * C.norm());
  CHECK(exact.posterior.mean[0] == Approx(m).margin(1e-9));
}

TEST_CASE("infer_payload: the ELBO bounds the exact log evidence from below, and closely", "[exact][vi]") {
  const unsigned seed = 42;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    const auto l = likelihood_of(random_event(random, 20));
    rme::ExactPosterior<double> exact;
    rme::InferenceResult<double> vi;
    REQUIRE(rme::exact_posterior(l, wide_prior(), exact) == Status::Ok);
    REQUIRE(rme::infer_payload(l, wide_prior(), vi) == Status::Ok);
    const double gap = exact.log_evidence - vi.log_evidence;
    CHECK(gap > -1e-6);
    CHECK(gap < 0.3);
  }
}

TEST_CASE("exact_posterior: bad input is named and leaves the result as it was", "[exact]") {
  rme::ExactPosterior<double> exact;
  exact.log_evidence = 3;
  rme::PayloadLikelihood<double> likelihood;
  likelihood.yy = std::nan("");
  CHECK(rme::exact_posterior(likelihood, wide_prior(), exact) == Status::NonFiniteInput);
  auto prior = wide_prior();
  prior.covariance(0, 0) = 0;
  CHECK(rme::exact_posterior(rme::PayloadLikelihood<double>(), prior, exact) == Status::NotPositiveDefinite);
  CHECK(exact.log_evidence == 3);
}

}  // namespace
