#include <cmath>
#include <limits>
#include <random>
#include <rme/inference/mean_field.hpp>

#include "inference/likelihoods.hpp"
#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using rme::Status;
using rme::testing::random_event;
using rme::testing::wide_prior;
using Likelihood = rme::PayloadLikelihood<double>;
using Prior = rme::PayloadGaussian<double>;
using Result = rme::InferenceResult<double>;
using Vector8 = Eigen::Matrix<double, 8, 1>;  // means, logarithms of standard deviations
using Matrix8 = Eigen::Matrix<double, 8, 8>;

/// Every other one says little, so that its posterior is wide.
Likelihood random_likelihood(std::mt19937_64& random, int k) {
  const auto event = random_event(random, k % 2 == 0 ? 50 : 3, k % 3 == 0);
  return rme::testing::likelihood_of(event, (k % 2 == 0 ? 1 : 0.0005) * event.precision);
}

/// As wide as wide_prior(), its entries correlated.
Prior correlated_prior(std::mt19937_64& random) {
  std::normal_distribution<double> n;
  const Eigen::Matrix4d A = Eigen::Matrix4d::NullaryExpr([&] { return n(random); });
  Prior prior = wide_prior();
  const Eigen::Vector4d sd = prior.standard_deviation();
  prior.covariance = sd.asDiagonal() * (0.2 * A * A.transpose() + 0.3 * Eigen::Matrix4d::Identity()) * sd.asDiagonal();
  return prior;
}

/// The ELBO of a diagonal Gaussian by three-point Gauss-Hermite quadrature in each of four dimensions. It is exact: the
/// log joint density is of second degree in each entry of theta, and three points integrate the fifth.
double elbo_by_quadrature(const Likelihood& likelihood, const Prior& prior, const Vector8& x) {
  const double nodes[] = {-std::sqrt(3.0), 0, std::sqrt(3.0)}, weights[] = {1.0 / 6, 2.0 / 3, 1.0 / 6};
  const Eigen::Matrix4d prior_precision = prior.covariance.inverse();
  const Eigen::Vector4d sd = x.tail<4>().array().exp();
  double sum = 0;
  for (int i = 0; i < 81; ++i) {
    const int index[] = {i % 3, i / 3 % 3, i / 9 % 3, i / 27};
    Eigen::Vector4d theta = x.head<4>();
    double weight = 1;
    for (int axis = 0; axis < 4; ++axis) {
      theta[axis] += sd[axis] * nodes[index[axis]];
      weight *= weights[index[axis]];
    }
    const Eigen::Vector4d d = theta - prior.mean;
    sum += weight * (likelihood.log_likelihood(theta) + 0.5 * likelihood.yy - 0.5 * d.dot(prior_precision * d));
  }
  return sum + x.tail<4>().sum() + 2 - 0.5 * std::log(prior.covariance.determinant());
}

/// Levenberg-Marquardt with finite differences from the prior: knows nothing of the model.
Vector8 climb(const Likelihood& likelihood, const Prior& prior) {
  const auto f = [&](const Vector8& x) { return elbo_by_quadrature(likelihood, prior, x); };
  Vector8 x;
  x << prior.mean, prior.standard_deviation().array().log().matrix();
  double damping = 1;
  for (int iteration = 0; iteration < 200 && damping < 1e12; ++iteration) {
    Vector8 scale = Vector8::Ones();  // in which a unit is a standard deviation
    scale.head<4>() = x.tail<4>().array().exp();
    const double h = 1e-2;
    const auto at = [&](int i, double a, int j, double b) {
      Vector8 y = x;
      y[i] += a * h * scale[i];
      y[j] += b * h * scale[j];
      return f(y);
    };
    Vector8 gradient;
    Matrix8 hessian;
    for (int i = 0; i < 8; ++i) {
      gradient[i] = (at(i, 0.1, i, 0) - at(i, -0.1, i, 0)) / (0.2 * h);
      for (int j = 0; j < 8; ++j)
        hessian(i, j) = (at(i, 1, j, 1) - at(i, 1, j, -1) - at(i, -1, j, 1) + at(i, -1, j, -1)) / (4 * h * h);
    }
    if (gradient.norm() < 1e-6) break;
    while (damping < 1e12) {
      const Vector8 step = oracle::solve(damping * Matrix8::Identity() - hessian, gradient);
      const Vector8 next = x + step.cwiseMin(1).cwiseMax(-1).cwiseProduct(scale);
      if (f(next) > f(x)) {
        x = next;
        damping = std::max(damping / 5, 1e-9);
        break;
      }
      damping *= 5;
    }
  }
  return x;
}

TEST_CASE("infer_payload: the mean field is the diagonal Gaussian that a brute-force search of the ELBO finds",
          "[mean_field]") {
  const unsigned seed = 60;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 30; ++k) {
    CAPTURE(k);
    const Likelihood likelihood = random_likelihood(random, k);
    const Prior prior = k % 5 == 0 ? correlated_prior(random) : wide_prior();
    Result found;
    rme::MeanFieldConfig config;
    config.tolerance = 1e-7;
    REQUIRE(rme::infer_payload(likelihood, prior, found, config) == Status::Ok);
    const Vector8 best = climb(likelihood, prior);
    const Eigen::Array4d sd = best.tail<4>().array().exp();
    CHECK(((found.posterior.mean - best.head<4>()).array().abs() / sd).maxCoeff() < 1e-3);
    CHECK((found.posterior.standard_deviation().array() / sd - 1).abs().maxCoeff() < 1e-3);
    CHECK(found.log_evidence == Approx(elbo_by_quadrature(likelihood, prior, best)).epsilon(1e-9).margin(1e-6));
    CHECK(found.posterior.covariance.isDiagonal(0));
  }
}

TEST_CASE("infer_payload: the mean field's ELBO does not fall when more iterations are allowed", "[mean_field]") {
  const unsigned seed = 61;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 400; ++k) {
    CAPTURE(k);
    const Likelihood likelihood = random_likelihood(random, k);
    const Prior prior = k % 5 == 0 ? correlated_prior(random) : wide_prior();
    double last = -std::numeric_limits<double>::infinity();
    for (int iterations = 0; iterations <= 12; ++iterations) {
      CAPTURE(iterations);
      Result found;
      rme::MeanFieldConfig config;
      config.max_iterations = iterations;
      const Status status = rme::infer_payload(likelihood, prior, found, config);
      REQUIRE((status == Status::Ok || status == Status::NotConverged));
      REQUIRE(found.log_evidence >= last - 1e-9 * std::abs(last));
      last = found.log_evidence;
    }
  }
}

TEST_CASE("infer_payload: the mean field settles in a few sweeps where one mean at a time takes five times as many",
          "[mean_field]") {
  const unsigned seed = 62;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  int together = 0, in_turn = 0, most = 0;
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    const Likelihood l = random_likelihood(random, 0);
    const Prior prior = wide_prior();
    Result found;
    REQUIRE(rme::infer_payload(l, prior, found, rme::MeanFieldConfig()) == Status::Ok);
    together += found.iterations;
    most = std::max(most, found.iterations);
    // Plain coordinate ascent, each of the eight parameters set to its optimum given the others.
    Eigen::Vector4d mean = prior.mean, variance = prior.covariance.diagonal();
    const Eigen::Vector4d weight = prior.covariance.diagonal().cwiseInverse();
    const Eigen::Array4d sd = found.posterior.standard_deviation();
    int sweeps = 0;
    while (((mean - found.posterior.mean).array().abs() / sd).maxCoeff() > 1e-2 && ++sweeps < 10000) {
      const Eigen::Vector3d r = mean.tail<3>(), C = variance.tail<3>();
      variance[0] = 1 / (l.aa + 2 * l.aB.dot(r) + r.dot(l.BB * r) + l.BB.diagonal().dot(C) + weight[0]);
      mean[0] = variance[0] * (l.ya + l.yB.dot(r) + weight[0] * prior.mean[0]);
      const double m2 = mean[0] * mean[0] + variance[0];
      for (int i = 0; i < 3; ++i) {
        variance[i + 1] = 1 / (m2 * l.BB(i, i) + weight[i + 1]);
        const double others = l.BB.row(i).dot(mean.tail<3>()) - l.BB(i, i) * mean[i + 1];
        mean[i + 1] =
            variance[i + 1] * (mean[0] * l.yB[i] - m2 * (l.aB[i] + others) + weight[i + 1] * prior.mean[i + 1]);
      }
    }
    in_turn += sweeps;
  }
  INFO("sweeps: " << together / 200.0 << " together, " << in_turn / 200.0 << " in turn");
  CHECK(most <= 12);
  CHECK(in_turn > 5 * together);
}

TEST_CASE("infer_payload: without data the mean field keeps the prior's means and its conditional variances",
          "[mean_field]") {
  // KL(q || p) of two Gaussians, q diagonal, is least where 1 / v_i is the diagonal of p's precision.
  const unsigned seed = 63;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const Prior prior = correlated_prior(random);
  Result found;
  REQUIRE(rme::infer_payload(Likelihood(), prior, found, rme::MeanFieldConfig()) == Status::Ok);
  CHECK((found.posterior.mean - prior.mean).norm() < 1e-12);
  const Eigen::Vector4d variance = prior.covariance.inverse().diagonal().cwiseInverse();
  CHECK((found.posterior.covariance.diagonal() - variance).cwiseQuotient(variance).norm() < 1e-12);
  REQUIRE(rme::infer_payload(Likelihood(), wide_prior(), found, rme::MeanFieldConfig()) == Status::Ok);
  CHECK(std::abs(found.log_evidence) < 1e-12);  // q is the prior, and no data is no evidence
}

TEST_CASE("infer_payload: bad input to the mean field is named and leaves the result as it was", "[mean_field]") {
  Result found;
  found.iterations = 77;
  Likelihood likelihood;
  likelihood.BB(1, 2) = std::nan("");
  CHECK(rme::infer_payload(likelihood, wide_prior(), found, rme::MeanFieldConfig()) == Status::NonFiniteInput);
  auto prior = wide_prior();
  prior.covariance(2, 2) = -1;
  CHECK(rme::infer_payload(Likelihood(), prior, found, rme::MeanFieldConfig()) == Status::NotPositiveDefinite);
  prior = wide_prior();
  prior.mean[0] = std::numeric_limits<double>::infinity();
  CHECK(rme::infer_payload(Likelihood(), prior, found, rme::MeanFieldConfig()) == Status::NonFiniteInput);
  CHECK(found.iterations == 77);
}

}  // namespace
