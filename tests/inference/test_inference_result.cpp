#include <cmath>
#include <cstdlib>
#include <random>
#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/inference_result.hpp>
#include <rme/inference/mean_field.hpp>
#include <rme/inference/stochastic_vi.hpp>
#include <rme/inference/variational_inference.hpp>

#include "inference/likelihoods.hpp"
#include "published/pipelines.hpp"
#include "support/allocation_count.hpp"
#include "support/catch.hpp"

namespace {

using rme::Status;
using rme::testing::in_float;
using rme::testing::likelihood_of;
using rme::testing::random_event;
using rme::testing::wide_prior;

template <typename Scalar>
struct Results {
  rme::InferenceResult<Scalar> exact, full, mean_field, stochastic;
};

/// Asks all four solvers, in the one form that they share.
template <typename Scalar>
Results<Scalar> ask(const rme::PayloadLikelihood<Scalar>& likelihood, const rme::PayloadGaussian<Scalar>& prior,
                    std::mt19937_64& random) {
  static_assert(noexcept(rme::infer_payload(likelihood, prior, std::declval<rme::InferenceResult<Scalar>&>())), "");
  Results<Scalar> r;
  bool usable = rme::infer_payload(likelihood, prior, r.exact, rme::ExactQuadrature()) == Status::Ok;
  usable = rme::infer_payload(likelihood, prior, r.full, rme::VariationalInferenceConfig()) == Status::Ok && usable;
  usable = rme::infer_payload(likelihood, prior, r.mean_field, rme::MeanFieldConfig()) == Status::Ok && usable;
  const Status status = rme::infer_payload(likelihood, prior, r.stochastic, rme::StochasticViConfig(), random);
  usable = (status == Status::Ok || status == Status::NotConverged) && usable;
  if (!usable) r.exact.iterations = 0;  // no REQUIRE here: it allocates
  return r;
}

rme::PayloadLikelihood<double> random_likelihood(std::mt19937_64& random) {
  return likelihood_of(random_event(random, 20));
}

TEST_CASE("Solvers: each family's bound lies below that of the family that contains it", "[solvers]") {
  const unsigned seed = 90;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  double mean_field_gap = 0;
  for (int k = 0; k < 300; ++k) {
    CAPTURE(k);
    const auto r = ask(random_likelihood(random), wide_prior(), random);
    REQUIRE(r.exact.iterations > 0);
    const double slack = 1e-9 * std::abs(r.exact.log_evidence) + 1e-9;
    CHECK(r.full.log_evidence <= r.exact.log_evidence + slack);
    CHECK(r.mean_field.log_evidence <= r.full.log_evidence + slack);
    // An average over 100 draws, whose standard error is below 0.4 for what is near Gaussian.
    CHECK(r.stochastic.log_evidence < r.mean_field.log_evidence + 2);
    mean_field_gap += (r.full.log_evidence - r.mean_field.log_evidence) / 300;
    // The mean field's intervals are those of conditionals, which are the shorter ones.
    CHECK((r.mean_field.posterior.standard_deviation().array() < 1.01 * r.full.posterior.standard_deviation().array())
              .all());
  }
  CHECK(mean_field_gap > 0.5);  // the families differ, and the solvers with them
}

TEST_CASE("Solvers: none of them allocates", "[solvers]") {
#ifdef RME_COUNTS_ALLOCATIONS
  const unsigned seed = 91;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto likelihood = random_likelihood(random);
  const int before_any = rme::testing::allocations();
  void* volatile kept = std::malloc(8);  // or the compiler leaves the pair out
  std::free(kept);
  REQUIRE(rme::testing::allocations() > before_any);  // the counter counts
  const int before = rme::testing::allocations();
  const auto r = ask(likelihood, wide_prior(), random);
  const int during = rme::testing::allocations() - before;
  CHECK(during == 0);
  CHECK(r.exact.iterations > 0);
#endif
}

TEST_CASE("Solvers: in float, quadrature and mean field agree with double to 2 % of a deviation", "[solvers]") {
  const unsigned seed = 92;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    const auto l = random_likelihood(random);
    const auto d = ask(l, wide_prior(), random);
    const auto f = ask(in_float(l), in_float(wide_prior()), random);
    REQUIRE(d.exact.iterations > 0);
    REQUIRE(f.exact.iterations > 0);
    const auto agree = [](const auto& a, const auto& b) {
      const Eigen::Array4d sd = a.posterior.standard_deviation();
      const Eigen::Array4d apart = b.posterior.mean.template cast<double>() - a.posterior.mean;
      const Eigen::Array4d widths = b.posterior.standard_deviation().template cast<double>();
      return (apart.abs() / sd).maxCoeff() < 0.02 && (widths / sd - 1).abs().maxCoeff() < 0.02;
    };
    CHECK(agree(d.exact, f.exact));
    CHECK(agree(d.mean_field, f.mean_field));
  }
}

}  // namespace
