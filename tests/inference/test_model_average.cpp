#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <limits>
#include <random>
#include <rme/inference/model_average.hpp>
#include <vector>

#include "support/catch.hpp"

namespace {

using Gaussian = rme::PayloadGaussian<double>;

TEMPLATE_TEST_CASE("LogSum: equals the logarithm of the direct sum", "[model_average]", float, double) {
  const unsigned seed = 90;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-8, 8);
  const double tolerance = 30 * static_cast<double>(std::numeric_limits<TestType>::epsilon());
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    rme::LogSum<TestType> sum;
    double direct = 0;
    for (int i = 0; i < 1 + k % 7; ++i) {
      const auto x = static_cast<TestType>(u(random));
      sum.add(x);
      direct += std::exp(static_cast<double>(x));
    }
    CHECK(static_cast<double>(sum.value()) == Approx(std::log(direct)).margin(tolerance).epsilon(tolerance));
  }
}

TEMPLATE_TEST_CASE("LogSum: neither huge nor tiny terms overflow, in any order", "[model_average]", float, double) {
  // e^10000 is beyond any double, and so is e^-10000: log(3 e^x) = x + log 3.
  for (const double x : {10000.0, -10000.0}) {
    CAPTURE(x);
    std::array<double, 4> terms = {x, x, x, x - 5000};
    for (int k = 0; k < 4; ++k) {
      std::rotate(terms.begin(), terms.begin() + 1, terms.end());
      rme::LogSum<TestType> sum;
      for (const double term : terms) sum.add(static_cast<TestType>(term));
      CHECK(static_cast<double>(sum.value()) == Approx(x + std::log(3.0)).epsilon(1e-7));
    }
  }
  CHECK(rme::LogSum<TestType>().value() == -std::numeric_limits<TestType>::infinity());
}

struct Component {
  Gaussian gaussian;
  double log_evidence;
};

std::vector<Component> random_components(std::mt19937_64& random, int count) {
  std::normal_distribution<double> n;
  std::vector<Component> components;
  for (int i = 0; i < count; ++i) {
    const Eigen::Matrix4d A = Eigen::Matrix4d::NullaryExpr([&] { return 0.2 * n(random); });
    const Eigen::Vector4d mean = Eigen::Vector4d::NullaryExpr([&] { return n(random); });
    components.push_back({{mean, A * A.transpose()}, 2 * n(random)});
  }
  return components;
}

rme::ModelAverage<double> average_of(const std::vector<Component>& components, double shift = 0) {
  rme::ModelAverage<double> average;
  for (const Component& c : components) average.add(c.gaussian, c.log_evidence + shift);
  return average;
}

TEST_CASE("ModelAverage: mean and covariance are those of a million draws from the mixture", "[model_average]") {
  // A mean of N draws is off by sd / sqrt(N) = 1e-3 sd, a variance by about sqrt(2 / N) = 1.4e-3 of itself (the
  // mixture's tails are no heavier than its parts'): five of these.
  const unsigned seed = 91;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  const auto components = random_components(random, 3);
  std::vector<double> weights;
  std::vector<Eigen::Matrix4d> factors;
  for (const Component& c : components) {
    weights.push_back(std::exp(c.log_evidence));
    factors.push_back(c.gaussian.covariance.llt().matrixL());
  }
  std::discrete_distribution<std::size_t> which(weights.begin(), weights.end());
  constexpr int N = 1000000;
  Eigen::Vector4d sum = Eigen::Vector4d::Zero();
  Eigen::Matrix4d squares = Eigen::Matrix4d::Zero();
  for (int i = 0; i < N; ++i) {
    const std::size_t k = which(random);
    const Eigen::Vector4d z(n(random), n(random), n(random), n(random));
    const Eigen::Vector4d theta = components[k].gaussian.mean + factors[k] * z;
    sum += theta;
    squares += theta * theta.transpose();
  }
  const Eigen::Vector4d mean = sum / N;
  const Eigen::Matrix4d covariance = squares / N - mean * mean.transpose();
  const Gaussian found = average_of(components).moments();
  const Eigen::Vector4d sd = covariance.diagonal().cwiseSqrt();
  CHECK((found.mean - mean).cwiseQuotient(sd).cwiseAbs().maxCoeff() < 5e-3);
  CHECK((found.covariance - covariance).cwiseQuotient(sd * sd.transpose()).cwiseAbs().maxCoeff() < 7e-3);
}

TEST_CASE("ModelAverage: moments and evidence follow the law of total variance, in any order, at any scale",
          "[model_average]") {
  // mean = sum p_k m_k, covariance = sum p_k (C_k + (m_k - mean)(m_k - mean)^T), evidence = log sum e^l_k. Evidences
  // are known up to a constant: e^(+-3000) must change nothing but the evidence itself.
  const unsigned seed = 92;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 100; ++k) {
    CAPTURE(k);
    auto components = random_components(random, 1 + k % 5);
    double total = 0;
    Eigen::Vector4d mean = Eigen::Vector4d::Zero();
    Eigen::Matrix4d covariance = Eigen::Matrix4d::Zero();
    for (const Component& c : components) total += std::exp(c.log_evidence);
    for (const Component& c : components) mean += std::exp(c.log_evidence) / total * c.gaussian.mean;
    for (const Component& c : components) {
      const Eigen::Vector4d d = c.gaussian.mean - mean;
      covariance += std::exp(c.log_evidence) / total * (c.gaussian.covariance + d * d.transpose());
    }
    for (const double shift : {0.0, 3000.0, -3000.0}) {
      CAPTURE(shift);
      std::shuffle(components.begin(), components.end(), random);
      const auto average = average_of(components, shift);
      const Gaussian found = average.moments();
      // 3000 leaves 5e-13 of a log evidence.
      CHECK((found.mean - mean).norm() < 1e-11);
      CHECK((found.covariance - covariance).norm() < 1e-11);
      CHECK(average.log_evidence() == Approx(std::log(total) + shift).epsilon(1e-13).margin(1e-12));
    }
  }
}

TEST_CASE("ModelAverage: a model that explains nothing has no say, and of no model there is no average",
          "[model_average]") {
  std::mt19937_64 random(93);
  auto components = random_components(random, 2);
  components[1].log_evidence = components[0].log_evidence - 1e5;
  for (int order = 0; order < 2; ++order) {
    const Gaussian found = average_of(components).moments();
    const Component& good = components[order == 0 ? 0 : 1];
    CHECK((found.mean - good.gaussian.mean).norm() < 1e-14);
    CHECK((found.covariance - good.gaussian.covariance).norm() < 1e-14);
    std::swap(components[0], components[1]);
  }
  CHECK(rme::ModelAverage<double>().empty());
  CHECK_FALSE(average_of(components).empty());
}

static_assert(noexcept(std::declval<rme::ModelAverage<double>&>().add(std::declval<const Gaussian&>(), 0.0)));
static_assert(noexcept(std::declval<const rme::ModelAverage<double>&>().moments()));
static_assert(noexcept(std::declval<rme::LogSum<double>&>().add(0.0)));

}  // namespace
