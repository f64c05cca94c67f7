#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/variational_inference.hpp>

#include "support/catch.hpp"
#include "support/random_events.hpp"

namespace {

using rme::Status;
using rme::testing::random_event;
using rme::testing::wide_prior;

TEST_CASE("exact_posterior: moments and evidence are those of a dense four-dimensional grid", "[exact]") {
  const unsigned seed = 40;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 3; ++k) {
    CAPTURE(k);
    const auto event = random_event(random, 3);  // few samples: wide, skewed posteriors
    rme::PayloadLikelihood<double> likelihood;
    auto precision = event.precision;
    precision *= 0.0005;
    REQUIRE(event.statistics.likelihood(precision, event.nuisance, likelihood) == Status::Ok);
    const auto prior = wide_prior();
    rme::ExactPosterior<double> exact;
    REQUIRE(rme::exact_posterior(likelihood, prior, exact) == Status::Ok);
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
            const Eigen::Vector4d z = (theta - prior.mean).cwiseQuotient(sd);
            const double p = std::exp(likelihood.log_likelihood(theta) + 0.5 * likelihood.yy - 0.5 * z.squaredNorm());
            p0 += p;
            p1 += p * theta;
            p2 += p * theta * theta.transpose();
          }
    const Eigen::Vector4d mean = p1 / p0;
    const Eigen::Matrix4d covariance = p2 / p0 - mean * mean.transpose();
    const double cell = std::pow(11.0 / n, 4) / std::pow(2 * std::acos(-1.0), 2);  // the standard normal's constant
    CHECK(((exact.posterior.mean - mean).cwiseQuotient(sd)).norm() < 1e-3);
    const Eigen::Matrix4d error = exact.posterior.covariance - covariance;
    CHECK(error.cwiseQuotient(sd * sd.transpose()).norm() < 1e-3);
    CHECK(exact.log_evidence == Approx(std::log(p0 * cell)).margin(1e-3));
  }
}

TEST_CASE("exact_posterior: with the mass known it is the linear-Gaussian posterior of the centre of mass", "[exact]") {
  std::mt19937_64 random(41);
  const auto event = random_event(random);
  rme::PayloadLikelihood<double> l;
  REQUIRE(event.statistics.likelihood(event.precision, event.nuisance, l) == Status::Ok);
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

TEST_CASE("infer: the ELBO bounds the exact log evidence from below, and closely", "[exact][vi]") {
  const unsigned seed = 42;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    const auto event = random_event(random, 20);
    rme::PayloadLikelihood<double> l;
    REQUIRE(event.statistics.likelihood(event.precision, event.nuisance, l) == Status::Ok);
    rme::ExactPosterior<double> exact;
    rme::InferenceResult<double> vi;
    REQUIRE(rme::exact_posterior(l, wide_prior(), exact) == Status::Ok);
    REQUIRE(rme::infer(l, wide_prior(), vi) == Status::Ok);
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
