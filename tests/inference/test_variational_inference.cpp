#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/variational_inference.hpp>

#include "inference/likelihoods.hpp"
#include "support/catch.hpp"

namespace {

using rme::Status;
using rme::testing::in_float;
using rme::testing::likelihood_of;
using rme::testing::random_event;
using rme::testing::wide_prior;

TEST_CASE("infer_payload: 10,000 random events agree with the exact posterior wherever that is close to Gaussian",
          "[vi]") {
  const unsigned seed = 20;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  int compared = 0;
  for (int k = 0; k < 10000; ++k) {
    CAPTURE(k);
    const auto event = random_event(random, 20, k % 2 == 1);
    const auto likelihood = likelihood_of(event);
    rme::ExactPosterior<double> exact;
    REQUIRE(rme::exact_posterior(likelihood, wide_prior(), exact) == Status::Ok);
    rme::InferenceResult<double> vi;
    REQUIRE(rme::infer_payload(likelihood, wide_prior(), vi) == Status::Ok);
    // Close to Gaussian, decided without looking at the approximation: the mass's third and fourth moments, which a
    // Gaussian has not, are small, and so is its coefficient of variation, since p(r | m, y) has a covariance that goes
    // with 1/m^2 (a Gaussian's conditional covariance is constant).
    const double variation = std::sqrt(exact.posterior.covariance(0, 0)) / exact.posterior.mean[0];
    if (std::abs(exact.skewness) > 0.05 || std::abs(exact.excess_kurtosis) > 0.05 || variation > 0.02) continue;
    ++compared;
    const Eigen::Array4d sd = exact.posterior.standard_deviation();
    REQUIRE(((vi.posterior.mean - exact.posterior.mean).array().abs() / sd).maxCoeff() < 0.02);
    REQUIRE((vi.posterior.standard_deviation().array() / sd - 1).abs().maxCoeff() < 0.02);
  }
  INFO("compared " << compared);
  CHECK(compared > 4000);
}

TEST_CASE("ExpectedLogJoint: gradient and precision are the derivatives of the expected log joint", "[vi]") {
  // Bonnet and Price: d/dmu E_q[f] = E_q[grad f], d^2/dmu^2 E_q[f] = E_q[hess f]; finite differences of value().
  const unsigned seed = 21;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 50; ++k) {
    CAPTURE(k);
    const auto event = random_event(random);
    const auto prior = wide_prior();
    const rme::ExpectedLogJoint<double> joint(likelihood_of(event), prior.mean, prior.covariance.inverse());
    const Eigen::Vector4d mu = event.truth + Eigen::Vector4d(0.2, 0.02, -0.01, 0.03);
    Eigen::Matrix4d A = Eigen::Matrix4d::Random();
    const Eigen::Vector4d size(0.1, 0.02, 0.02, 0.03);
    const Eigen::Matrix4d Sigma =
        size.asDiagonal() * (A * A.transpose() + Eigen::Matrix4d::Identity()) * size.asDiagonal();
    const Eigen::Vector4d g = joint.gradient(mu, Sigma);
    const Eigen::Matrix4d P = joint.precision(mu, Sigma);
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector4d h = 1e-4 * Eigen::Vector4d::Unit(i);
      const double slope = (joint.value(mu + h, Sigma) - joint.value(mu - h, Sigma)) / 2e-4;
      CHECK(slope == Approx(g[i]).epsilon(1e-5).margin(1e-5 * g.norm()));
      const Eigen::Vector4d curvature = (joint.gradient(mu + h, Sigma) - joint.gradient(mu - h, Sigma)) / 2e-4;
      CHECK((curvature + P.col(i)).norm() < 1e-5 * P.norm());
    }
  }
}

TEST_CASE("ExpectedLogJoint: the expectation is that of 200,000 draws", "[vi]") {
  const unsigned seed = 22;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto event = random_event(random);
  const auto likelihood = likelihood_of(event);
  const auto prior = wide_prior();
  const rme::ExpectedLogJoint<double> joint(likelihood, prior.mean, prior.covariance.inverse());
  const Eigen::Vector4d mu = event.truth;
  Eigen::Matrix4d L;
  L << 0.3, 0, 0, 0, 0.03, 0.05, 0, 0, -0.02, 0.01, 0.04, 0, 0.03, 0.02, -0.01, 0.06;
  std::normal_distribution<double> n;
  const int draws = 200000;
  double sum = 0, squares = 0;
  for (int k = 0; k < draws; ++k) {
    const Eigen::Vector4d theta = mu + L * Eigen::Vector4d(n(random), n(random), n(random), n(random));
    const Eigen::Vector4d d = theta - prior.mean;
    const double f =
        likelihood.log_likelihood(theta) + 0.5 * likelihood.yy - 0.5 * d.dot(prior.covariance.inverse() * d);
    sum += f;
    squares += f * f;
  }
  const double mean = sum / draws;
  const double standard_error = std::sqrt((squares / draws - mean * mean) / draws);
  CHECK(std::abs(joint.value(mu, L * L.transpose()) - mean) < 4 * standard_error);
  CHECK(standard_error < 0.01 * std::abs(mean));
}

TEST_CASE("infer_payload: the ELBO does not fall when more iterations are allowed", "[vi]") {
  const unsigned seed = 23;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    const auto likelihood = likelihood_of(random_event(random, 5));
    double last = -1e300;
    for (int iterations = 1; iterations <= 15; ++iterations) {
      rme::VariationalInferenceConfig config;
      config.max_iterations = iterations;
      rme::InferenceResult<double> vi;
      const Status status = rme::infer_payload(likelihood, wide_prior(), vi, config);
      REQUIRE((status == Status::Ok || status == Status::NotConverged));
      REQUIRE(vi.log_evidence >= last - 1e-9 * std::abs(last));
      last = vi.log_evidence;
    }
  }
}

TEST_CASE("infer_payload: from the answer to nearly the same data it takes fewer steps to the same answer", "[vi]") {
  const unsigned seed = 25;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  int steps = 0, steps_from_nearby = 0;
  for (int k = 0; k < 500; ++k) {
    CAPTURE(k);
    auto event = random_event(random);
    rme::InferenceResult<double> nearby, vi, from_nearby;
    REQUIRE(rme::infer_payload(likelihood_of(event), wide_prior(), nearby) == Status::Ok);
    event.precision /= 2;  // as if the noise were found to be larger
    const auto likelihood = likelihood_of(event);
    REQUIRE(rme::infer_payload(likelihood, wide_prior(), vi) == Status::Ok);
    REQUIRE(rme::infer_payload(likelihood, wide_prior(), from_nearby, {}, &nearby.posterior.mean) == Status::Ok);
    const Eigen::Array4d sd = vi.posterior.standard_deviation();
    CHECK(((from_nearby.posterior.mean - vi.posterior.mean).array().abs() / sd).maxCoeff() < 1e-3);
    CHECK((from_nearby.posterior.standard_deviation().array() / sd - 1).abs().maxCoeff() < 1e-3);
    steps += vi.iterations;
    steps_from_nearby += from_nearby.iterations;
  }
  CAPTURE(steps, steps_from_nearby);
  CHECK(3 * steps_from_nearby < 2 * steps);
}

TEST_CASE("infer_payload: without data the posterior is the prior", "[vi]") {
  rme::InferenceResult<double> vi;
  REQUIRE(rme::infer_payload(rme::PayloadLikelihood<double>(), wide_prior(), vi) == Status::Ok);
  CHECK((vi.posterior.mean - wide_prior().mean).norm() < 1e-12);
  CHECK((vi.posterior.covariance - wide_prior().covariance).norm() < 1e-12);
}

TEST_CASE("infer_payload: float agrees with double to its precision", "[vi]") {
  const unsigned seed = 24;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 500; ++k) {
    CAPTURE(k);
    const auto l = likelihood_of(random_event(random));
    rme::InferenceResult<double> vi;
    rme::InferenceResult<float> vif;
    REQUIRE(rme::infer_payload(l, wide_prior(), vi) == Status::Ok);
    REQUIRE(rme::infer_payload(in_float(l), in_float(wide_prior()), vif) == Status::Ok);
    const Eigen::Array4d sd = vi.posterior.standard_deviation();
    CHECK(((vif.posterior.mean.cast<double>() - vi.posterior.mean).array().abs() / sd).maxCoeff() < 0.01);
  }
}

TEST_CASE("infer_payload: bad input is named and leaves the result as it was", "[vi]") {
  rme::InferenceResult<double> vi;
  vi.iterations = 77;
  rme::PayloadLikelihood<double> likelihood;
  likelihood.aB[1] = std::nan("");
  CHECK(rme::infer_payload(likelihood, wide_prior(), vi) == Status::NonFiniteInput);
  auto prior = wide_prior();
  prior.covariance(2, 2) = -1;
  CHECK(rme::infer_payload(rme::PayloadLikelihood<double>(), prior, vi) == Status::NotPositiveDefinite);
  const Eigen::Vector4d start = {1, 0, std::nan(""), 0};
  CHECK(rme::infer_payload(rme::PayloadLikelihood<double>(), wide_prior(), vi, {}, &start) == Status::NonFiniteInput);
  CHECK(vi.iterations == 77);
}

}  // namespace
