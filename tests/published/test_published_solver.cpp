// PublishedPipelineConfig::solver: the same collection, likelihood and prior, and four solvers.
#include <cmath>
#include <random>
#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/mean_field.hpp>
#include <rme/inference/published_likelihood.hpp>
#include <rme/inference/stochastic_vi.hpp>
#include <rme/inference/variational_inference.hpp>
#include <string>
#include <vector>

#include "published/changing_hand.hpp"
#include "published/pipelines.hpp"
#include "realtime/allocations_of.hpp"
#include "support/catch.hpp"

namespace {

using rme::PublishedSolver;
using rme::Status;
using rme::testing::cast;
using rme::testing::changing_hand;
using Ticks = std::vector<rme::Proprioception<double, 7>>;

constexpr double kPeriod = 1e-3;
constexpr PublishedSolver kSolvers[] = {PublishedSolver::Stochastic, PublishedSolver::ClosedForm,
                                        PublishedSolver::MeanField, PublishedSolver::Exact};
const rme::Payload<double> kFirst = {0.9, {0.03, -0.02, 0.12}}, kSecond = {1.5, {0.02, 0.04, 0.1}};

template <typename Scalar>
using Pipeline = rme::PublishedPipeline<Scalar, 7, rme::FixedGuess<Scalar>>;

template <typename Scalar>
rme::PublishedPipelineConfig<Scalar> with(PublishedSolver solver) {
  rme::PublishedPipelineConfig<Scalar> config;
  config.solver = solver;
  return config;
}

/// What a network might say of kFirst.
template <typename Scalar>
rme::FixedGuess<Scalar> guess() {
  return {{Scalar(0.8), Scalar(0.02), Scalar(-0.01), Scalar(0.1)}};
}

/// A solver's answer to the 200 ticks before `end`, around guess(), with the published likelihood and deviations.
template <typename Scalar>
Status solve(PublishedSolver solver, const Ticks& ticks, std::size_t end, std::mt19937_64& random,
             rme::InferenceResult<Scalar>& result) {
  const auto at = [&](int i) {
    const auto sample = cast<Scalar>(ticks[end - 200 + std::size_t(i)]);
    rme::PayloadObservation<Scalar, 7> out;
    out.tau = sample.tau_ext;
    out.regressor =
        rme::payload_regressor<Scalar, 7>(sample.jacobian, sample.rotation, rme::standard_gravity<Scalar>());
    return out;
  };
  rme::PayloadLikelihood<Scalar> likelihood;
  REQUIRE(rme::published_likelihood<Scalar, 7>(200, at, likelihood) == Status::Ok);
  const auto prior = rme::PayloadGaussian<Scalar>::independent(guess<Scalar>().theta,
                                                               {Scalar(0.5), Scalar(0.02), Scalar(0.02), Scalar(0.05)});
  switch (solver) {
    case PublishedSolver::ClosedForm:
      return infer_payload(likelihood, prior, result, rme::VariationalInferenceConfig());
    case PublishedSolver::MeanField:
      return infer_payload(likelihood, prior, result, rme::MeanFieldConfig());
    case PublishedSolver::Exact:
      return infer_payload(likelihood, prior, result, rme::ExactQuadrature());
    case PublishedSolver::Stochastic:
      break;
  }
  return infer_payload(likelihood, prior, result, rme::StochasticViConfig(), random);
}

TEMPLATE_TEST_CASE("PublishedPipeline: each solver's estimates are what the solver itself answers", "[published]",
                   double, float) {
  const unsigned seed = 540;
  CAPTURE(seed);
  const Ticks ticks = changing_hand(seed, kFirst, kSecond);
  const auto network = guess<TestType>();
  for (const PublishedSolver solver : kSolvers) {
    CAPTURE(to_string(solver));
    Pipeline<TestType> pipeline(kPeriod, network, with<TestType>(solver), seed);
    std::mt19937_64 random(seed);
    std::uint64_t estimates = 0;
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      REQUIRE(pipeline.update(cast<TestType>(ticks[k])) == Status::Ok);
      const auto& state = pipeline.state();
      if (state.estimates == estimates) continue;
      ++estimates;
      CAPTURE(k);
      rme::InferenceResult<TestType> expected;
      CHECK(state.outcome == solve<TestType>(solver, ticks, k + 1, random, expected));
      CHECK(state.iterations == expected.iterations);
      CHECK(state.posterior.mean == expected.posterior.mean);
      CHECK(state.posterior.covariance == expected.posterior.covariance);
      const bool diagonal = solver == PublishedSolver::Stochastic || solver == PublishedSolver::MeanField;
      CHECK(state.posterior.covariance.isDiagonal(TestType(0)) == diagonal);
    }
    CHECK(estimates >= 5);
  }
}

TEST_CASE("PublishedPipeline: on an arm that holds a payload, closed form and exact posterior agree", "[published]") {
  const auto network = guess<double>();
  for (const unsigned seed : {541U, 542U, 543U}) {
    CAPTURE(seed);
    const Ticks ticks = changing_hand(seed, kFirst, kSecond);
    rme::PayloadGaussian<double> posterior[4];
    for (const PublishedSolver solver : kSolvers) {
      Pipeline<double> pipeline(kPeriod, network, with<double>(solver), seed);
      for (std::size_t k = 0; k < 2000; ++k) REQUIRE(pipeline.update(ticks[k]) == Status::Ok);
      REQUIRE(pipeline.state().estimates >= 2);  // the last of them of a torque that has settled
      CHECK(pipeline.state().posterior.mean[0] == Approx(kFirst.mass).margin(0.15));
      posterior[int(solver)] = pipeline.state().posterior;
    }
    const auto& full = posterior[int(PublishedSolver::ClosedForm)];
    const auto& mean_field = posterior[int(PublishedSolver::MeanField)];
    const auto& exact = posterior[int(PublishedSolver::Exact)];
    const Eigen::Array4d deviation = exact.standard_deviation();
    CHECK(((full.mean - exact.mean).array().abs() / deviation).maxCoeff() < 0.02);
    CHECK((full.standard_deviation().array() / deviation - 1).abs().maxCoeff() < 0.01);
    CHECK((full.covariance - exact.covariance).norm() < 0.02 * exact.covariance.norm());
    // The diagonal family: the same means, and intervals that are too narrow where entries are correlated.
    CHECK(((mean_field.mean - exact.mean).array().abs() / deviation).maxCoeff() < 0.1);
    CHECK((mean_field.standard_deviation().array() / deviation).maxCoeff() < 1.01);
    CHECK((mean_field.standard_deviation().array() / deviation).minCoeff() < 0.9);
  }
}

TEST_CASE("PublishedPipeline: whatever the solver, an inference that fails makes no estimate", "[published]") {
  const Ticks ticks = changing_hand(544, kFirst, kSecond);
  for (const PublishedSolver solver : kSolvers) {
    CAPTURE(to_string(solver));
    for (const double mass : {std::nan(""), 1e7}) {
      CAPTURE(mass);
      rme::FixedGuess<double> wrong;
      wrong.theta[0] = mass;
      Pipeline<double> pipeline(kPeriod, wrong, with<double>(solver));
      for (std::size_t k = 0; k < 2000; ++k) REQUIRE(pipeline.update(ticks[k]) == Status::Ok);
      CHECK(pipeline.state().detections >= 2);
      if (solver == PublishedSolver::Stochastic || std::isnan(mass)) {
        CHECK(pipeline.state().outcome == Status::NonFiniteInput);
        CHECK(pipeline.state().estimates == 0);
      }
      CHECK(pipeline.state().posterior.mean.allFinite());
      CHECK(pipeline.compensation(ticks[0].jacobian, ticks[0].rotation).allFinite());
    }
  }
}

#ifdef RME_COUNTS_ALLOCATIONS
TEST_CASE("PublishedPipeline: no solver allocates", "[published]") {
  const Ticks ticks = changing_hand(545, kFirst, kSecond);
  const auto network = guess<double>();
  for (const PublishedSolver solver : kSolvers) {
    CAPTURE(to_string(solver));
    Pipeline<double> pipeline(kPeriod, network, with<double>(solver));
    int refused = 0;
    const int count = rme::testing::allocations_of([&] {
      for (const auto& tick : ticks) refused += pipeline.update(tick) != Status::Ok;
    });
    CHECK(count == 0);
    CHECK(refused == 0);
    CHECK(pipeline.state().estimates >= 5);
  }
}
#endif

TEST_CASE("PublishedPipelineConfig: the solver is the published one unless the host says otherwise", "[published]") {
  CHECK(rme::PublishedPipelineConfig<double>().solver == PublishedSolver::Stochastic);
  const char* names[] = {"Stochastic", "ClosedForm", "MeanField", "Exact"};
  for (const PublishedSolver solver : kSolvers) CHECK(std::string(to_string(solver)) == names[int(solver)]);
  const rme::FixedGuess<double> zero;
  CHECK_THROWS_WITH(Pipeline<double>(kPeriod, zero, with<double>(static_cast<PublishedSolver>(4))),
                    contains("PublishedPipelineConfig::solver: expected one of the enumerators, got 4"));
}

}  // namespace
