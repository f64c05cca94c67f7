#include <random>
#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/mean_field.hpp>
#include <rme/inference/published_likelihood.hpp>
#include <rme/inference/stochastic_vi.hpp>
#include <rme/inference/variational_inference.hpp>

#include "realtime/allocations_of.hpp"
#include "support/catch.hpp"

#ifdef RME_COUNTS_ALLOCATIONS

namespace {

using rme::Status;
using rme::testing::allocations_of;
using Gaussian = rme::PayloadGaussian<double>;

TEST_CASE("Allocations: none in the four solvers and the published likelihood", "[realtime]") {
  const std::uint64_t seed = 303;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  rme::PayloadObservation<double, 7> observations[90];  // of an arm at rest that nobody has built
  const auto J = rme::Jacobian<double, 7>::NullaryExpr([&] { return 0.5 * normal(random); }).eval();
  for (auto& o : observations) {
    o.regressor =
        rme::payload_regressor<double, 7>(J, rme::Matrix3<double>::Identity(), rme::standard_gravity<double>());
    o.tau = o.regressor.torque({1.1, {0.05, 0.02, 0.13}});
    for (double& tau : o.tau) tau += 0.05 * normal(random);
  }
  const auto observation = [&](int i) { return observations[i]; };
  const auto prior = Gaussian::independent({0.8, 0, 0, 0.1}, {0.6, 0.05, 0.05, 0.06});
  rme::PayloadLikelihood<double> likelihood;
  rme::InferenceResult<double> result;
  double mass[4] = {};
  int solved = 0;
  const int count = allocations_of([&] {
    solved += rme::published_likelihood<double, 7>(90, observation, likelihood) == Status::Ok;
    solved += rme::infer_payload(likelihood, prior, result, rme::VariationalInferenceConfig()) == Status::Ok;
    mass[0] = result.posterior.mean[0];
    solved += rme::infer_payload(likelihood, prior, result, rme::MeanFieldConfig()) == Status::Ok;
    mass[1] = result.posterior.mean[0];
    solved += rme::infer_payload(likelihood, prior, result, rme::ExactQuadrature()) == Status::Ok;
    mass[2] = result.posterior.mean[0];
    const Status stochastic = rme::infer_payload(likelihood, prior, result, rme::StochasticViConfig(), random);
    solved += stochastic == Status::Ok || stochastic == Status::NotConverged;
    mass[3] = result.posterior.mean[0];
  });
  CHECK(count == 0);
  CHECK(solved == 5);
  for (const double m : mass) CHECK(m == Approx(1.1).margin(0.2));
}

}  // namespace

#endif
