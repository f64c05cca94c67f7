#include <cmath>
#include <limits>
#include <random>
#include <rme/inference/mean_field.hpp>
#include <rme/inference/stochastic_vi.hpp>

#include "inference/likelihoods.hpp"
#include "support/catch.hpp"

namespace {

using rme::Status;
using rme::testing::random_event;
using rme::testing::wide_prior;
using Likelihood = rme::PayloadLikelihood<double>;
using Prior = rme::PayloadGaussian<double>;
using Result = rme::InferenceResult<double>;

Likelihood random_likelihood(std::mt19937_64& random) {
  const auto event = random_event(random, 20);
  return rme::testing::likelihood_of(event, 0.01 * event.precision);  // a posterior of some 30 g and 1 cm
}

/// Small steps and many of them, unbiased: to the optimum, wherever that is.
rme::StochasticViConfig patient() {
  rme::StochasticViConfig config;
  config.learning_rate = 2e-5;
  config.gradient_norm = std::numeric_limits<double>::infinity();
  config.max_steps = 2000000;
  config.small_change = 0;
  config.evidence_draws = 20000;
  return config;
}

TEST_CASE("infer_payload: a long run of stochastic VI finds the mean field's closed form", "[stochastic_vi]") {
  // The last iterate wanders about the optimum: by sqrt(rate / 2 sd) standard deviations, with each gradient as noisy
  // as it is large. With deviations above 5 mm that is below 5 %.
  const unsigned seed = 70;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 3; ++k) {
    CAPTURE(k);
    const Likelihood likelihood = random_likelihood(random);
    Result closed, run;
    REQUIRE(rme::infer_payload(likelihood, wide_prior(), closed, rme::MeanFieldConfig()) == Status::Ok);
    REQUIRE(rme::infer_payload(likelihood, wide_prior(), run, patient(), random) == Status::NotConverged);
    const Eigen::Array4d sd = closed.posterior.standard_deviation();
    CHECK(((run.posterior.mean - closed.posterior.mean).array().abs() / sd).maxCoeff() < 0.15);
    CHECK((run.posterior.standard_deviation().array() / sd - 1).abs().maxCoeff() < 0.05);
    CHECK(run.log_evidence == Approx(closed.log_evidence).margin(0.1));
  }
}

TEST_CASE("infer_payload: stochastic VI takes any likelihood, here a linear one with a known posterior",
          "[stochastic_vi]") {
  // y = A theta + e, e ~ N(0, 1): the posterior's precision is P = A^T A + P0, its mean P^-1 (A^T y + P0 mu0). The best
  // diagonal q has that mean and the variances 1 / P_ii.
  const unsigned seed = 71;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  const Prior prior = wide_prior();
  const Eigen::Matrix4d P0 = prior.covariance.inverse();
  Eigen::Matrix4d A = Eigen::Matrix4d::NullaryExpr([&] { return n(random); });
  A = A * prior.standard_deviation().cwiseInverse().asDiagonal();
  const Eigen::Vector4d y = Eigen::Vector4d::NullaryExpr([&] { return 2 * n(random); });
  const auto log_likelihood = [&](const Eigen::Vector4d& theta, Eigen::Vector4d& gradient) noexcept {
    const Eigen::Vector4d e = y - A * theta;
    gradient = A.transpose() * e;
    return -0.5 * e.squaredNorm();
  };
  Result run;
  REQUIRE(rme::infer_payload(log_likelihood, prior, run, patient(), random) == Status::NotConverged);
  const Eigen::Matrix4d P = A.transpose() * A + P0;
  const Eigen::Vector4d mean = P.inverse() * (A.transpose() * y + P0 * prior.mean);
  const Eigen::Array4d sd = P.diagonal().cwiseInverse().cwiseSqrt();
  CHECK(((run.posterior.mean - mean).array().abs() / sd).maxCoeff() < 0.15);
  CHECK((run.posterior.standard_deviation().array() / sd - 1).abs().maxCoeff() < 0.05);
}

TEST_CASE("infer_payload: stochastic VI is Adam as its paper prints it, on the clipped one-sample gradient",
          "[stochastic_vi]") {
  // Kingma and Ba, Algorithm 1, in scalars, with the draws in the same order.
  const unsigned seed = 72;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const Likelihood l = random_likelihood(random);
  const Prior prior = wide_prior();
  rme::StochasticViConfig config;
  config.max_steps = 50;
  std::mt19937_64 mine(9), theirs(9);
  double x[8], m[8] = {}, v[8] = {};
  for (int i = 0; i < 4; ++i) x[i] = prior.mean[i], x[4 + i] = std::log(config.initial_deviation[std::size_t(i)]);
  std::normal_distribution<double> normal;
  for (int t = 1; t <= config.max_steps; ++t) {
    double epsilon[4], g[8];
    Eigen::Vector4d theta;
    for (int i = 0; i < 4; ++i) {
      epsilon[i] = normal(mine);
      theta[i] = x[i] + std::exp(x[4 + i]) * epsilon[i];
    }
    double norm = 0;
    for (int i = 0; i < 4; ++i) {
      // Central differences: the likelihood is of second degree in each entry, so they are exact.
      const Eigen::Vector4d h = 0.01 * Eigen::Vector4d::Unit(i);
      g[i] = (l.log_likelihood(theta + h) - l.log_likelihood(theta - h)) / 0.02 -
             (theta[i] - prior.mean[i]) / prior.covariance(i, i);
      g[4 + i] = g[i] * std::exp(x[4 + i]) * epsilon[i] + 1;
      norm += g[i] * g[i] + g[4 + i] * g[4 + i];
    }
    norm = std::sqrt(norm);
    for (int i = 0; i < 8; ++i) {
      if (norm > 1) g[i] /= norm;
      m[i] = 0.9 * m[i] + 0.1 * g[i];
      v[i] = 0.999 * v[i] + 0.001 * g[i] * g[i];
      x[i] += 0.025 * (m[i] / (1 - std::pow(0.9, t))) / (std::sqrt(v[i] / (1 - std::pow(0.999, t))) + 1e-8);
    }
  }
  Result run;
  REQUIRE(rme::infer_payload(l, prior, run, config, theirs) == Status::NotConverged);
  for (int i = 0; i < 4; ++i) {
    CHECK(run.posterior.mean[i] == Approx(x[i]).epsilon(1e-6).margin(1e-8));
    CHECK(run.posterior.standard_deviation()[i] == Approx(std::exp(x[4 + i])).epsilon(1e-6));
  }
}

TEST_CASE(
    "infer_payload: stochastic VI checks from step 700 on, each 10 steps, and stops after two small changes in a row",
    "[stochastic_vi]") {
  const unsigned seed = 73;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const Likelihood likelihood = random_likelihood(random);
  Result run;
  rme::StochasticViConfig config;
  config.small_change = 1e9;  // whatever happens is small: the checks at 710 and 720 end the run
  CHECK(rme::infer_payload(likelihood, wide_prior(), run, config, random) == Status::Ok);
  CHECK(run.iterations == 720);
  config.small_change = 0;
  CHECK(rme::infer_payload(likelihood, wide_prior(), run, config, random) == Status::NotConverged);
  CHECK(run.iterations == 2500);
  constexpr double kSmall = 0.05;  // about every other change
  // What a run says must follow from its own past: replay it, and look at every tenth step.
  config.small_change = kSmall;
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    const std::mt19937_64 start(static_cast<unsigned>(k));
    std::mt19937_64 generator = start;
    const Status status = rme::infer_payload(likelihood, wide_prior(), run, config, generator);
    int stops_at = 2500, in_a_row = 0;
    using Vector8 = Eigen::Matrix<double, 8, 1>;
    Vector8 before = Vector8::Zero(), now;
    for (int step = 700; step <= 2500 && stops_at == 2500; step += 10) {
      rme::StochasticViConfig part = config;
      part.max_steps = step;
      part.small_change = 0;
      Result at;
      generator = start;
      REQUIRE(rme::infer_payload(likelihood, wide_prior(), at, part, generator) == Status::NotConverged);
      now << at.posterior.mean, at.posterior.standard_deviation().array().log().matrix();
      in_a_row = step > 700 && (now - before).norm() < kSmall ? in_a_row + 1 : 0;
      before = now;
      if (in_a_row == 2) stops_at = step;
    }
    CHECK(run.iterations == stops_at);
    CHECK((status == Status::Ok) == (in_a_row == 2));
  }
}

TEST_CASE("infer_payload: the gradient that stochastic VI climbs along is that of the likelihood", "[stochastic_vi]") {
  const unsigned seed = 74;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 20; ++k) {
    const Likelihood l = random_likelihood(random);
    const Eigen::Vector4d theta = wide_prior().mean + 0.1 * Eigen::Vector4d::Random();
    Eigen::Vector4d gradient, unused;
    const double ratio = l.log_likelihood_ratio(theta, gradient);
    const double expected = l.log_likelihood(theta) - l.log_likelihood(Eigen::Vector4d::Zero());
    CHECK(ratio == Approx(expected).epsilon(1e-9));
    for (int i = 0; i < 4; ++i) {
      const Eigen::Vector4d h = 1e-3 * Eigen::Vector4d::Unit(i);
      const double slope =
          (l.log_likelihood_ratio(theta + h, unused) - l.log_likelihood_ratio(theta - h, unused)) / 2e-3;
      CHECK(slope == Approx(gradient[i]).epsilon(1e-7).margin(1e-7 * gradient.norm()));
    }
  }
}

TEST_CASE("infer_payload: bad input to stochastic VI is named and leaves the result as it was", "[stochastic_vi]") {
  std::mt19937_64 random(75);
  Result run;
  run.iterations = 77;
  const rme::StochasticViConfig config;
  Likelihood likelihood;
  likelihood.ya = std::nan("");
  CHECK(rme::infer_payload(likelihood, wide_prior(), run, config, random) == Status::NonFiniteInput);
  auto prior = wide_prior();
  prior.covariance(3, 3) = 0;
  CHECK(rme::infer_payload(Likelihood(), prior, run, config, random) == Status::NotPositiveDefinite);
  int calls = 0;
  const auto breaks_down = [&calls](const Eigen::Vector4d&, Eigen::Vector4d& gradient) noexcept {
    gradient.setZero();
    return ++calls < 100 ? 0.0 : std::nan("");
  };
  CHECK(rme::infer_payload(breaks_down, wide_prior(), run, config, random) == Status::NonFiniteInput);
  CHECK(calls == 100);
  CHECK(run.iterations == 77);
}

}  // namespace
