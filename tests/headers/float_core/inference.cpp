#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/published_likelihood.hpp>
#include <rme/inference/variational_inference.hpp>

#include "headers/float_core/float_core.hpp"
#include "headers/float_core/inference.hpp"
#include "support/random_events.hpp"

namespace float_core {
namespace {

/// The likelihood of a random event's samples.
rme::PayloadLikelihood<float> event_likelihood(Random& random, rme::Vector4<float>& truth) {
  const auto event = rme::testing::random_event(random);
  truth = event.truth.cast<float>();
  const auto l = rme::testing::likelihood_of(event);
  rme::PayloadLikelihood<float> out;
  out.yy = float(l.yy), out.ya = float(l.ya), out.aa = float(l.aa);
  out.yB = l.yB.cast<float>(), out.aB = l.aB.cast<float>(), out.BB = l.BB.cast<float>();
  return out;
}
rme::PayloadGaussian<float> prior() {
  const auto wide = rme::testing::wide_prior();
  return {wide.mean.cast<float>(), wide.covariance.cast<float>()};
}

}  // namespace

bool finds_the_payload(Solver solve) {
  Random random(2);
  for (int k = 0; k < 30; ++k) {
    rme::Vector4<float> truth;
    rme::InferenceResult<float> exact, result;
    const rme::PayloadLikelihood<float> likelihood = event_likelihood(random, truth);
    if (rme::infer_payload(likelihood, prior(), exact, rme::ExactQuadrature()) != Status::Ok) return false;
    if (solve(likelihood, prior(), result) != Status::Ok) return false;
    const Eigen::Array4f sd = exact.posterior.standard_deviation();
    if (!(((exact.posterior.mean - truth).array().abs() / sd).maxCoeff() < 5)) return false;
    if (!(((result.posterior.mean - exact.posterior.mean).array().abs() / sd).maxCoeff() < 0.5F)) return false;
  }
  return true;
}

namespace {

bool full_covariance_finds_the_payload() {
  return finds_the_payload([](const auto& likelihood, const auto& prior, auto& result) {
    return rme::infer_payload(likelihood, prior, result, rme::VariationalInferenceConfig());
  });
}

bool published_likelihood_is_a_quarter_of_the_range() {
  // One joint with torque 0 .. 4 N m and a = 2: sigma = 1 N m, so that over 50 samples aa = 200 and ya = 2 sum y = 200.
  const auto at = [](int i) {
    rme::PayloadObservation<float, 7> o;
    o.tau[0] = 4 * float(i) / 49;
    o.regressor.a[0] = 2;
    return o;
  };
  rme::PayloadLikelihood<float> l;
  return rme::published_likelihood<float, 7>(50, at, l) == Status::Ok && near(l.aa, 200, 1e-2) && near(l.ya, 200, 1e-2);
}

}  // namespace

const std::vector<Case> kInference = {
    {"infer_payload: quadrature and full covariance find the payload", full_covariance_finds_the_payload},
    {"published_likelihood: a quarter of the range", published_likelihood_is_a_quarter_of_the_range},
};

}  // namespace float_core
