#include <rme/inference/evidence.hpp>
#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/payload_statistics.hpp>
#include <rme/inference/published_likelihood.hpp>
#include <rme/inference/sensor_model.hpp>
#include <rme/inference/variational_inference.hpp>

#include "headers/float_core/float_core.hpp"
#include "headers/float_core/inference.hpp"
#include "support/random_events.hpp"

namespace float_core {
namespace {

/// What a random event's samples say, summed in float.
bool event_likelihood(Random& random, rme::PayloadLikelihood<float>& likelihood, rme::Vector4<float>& truth) {
  const auto event = rme::testing::random_event(random);
  truth = event.truth.cast<float>();
  rme::PayloadStatistics<float, 7> statistics;
  for (const auto& o : event.samples) {
    rme::PayloadObservation<float, 7> cast;
    cast.tau = o.tau.cast<float>();
    cast.regressor.a = o.regressor.a.cast<float>();
    cast.regressor.B = o.regressor.B.cast<float>();
    statistics.add(cast);
  }
  rme::NuisanceGaussian<float, 7> nuisance;
  for (std::size_t j = 0; j < 7; ++j) {
    nuisance.mean[j] = event.nuisance.mean[j].cast<float>();
    nuisance.covariance[j] = event.nuisance.covariance[j].cast<float>();
  }
  return statistics.likelihood(event.precision.cast<float>(), nuisance, likelihood) == Status::Ok;
}
rme::PayloadGaussian<float> prior() {
  const auto wide = rme::testing::wide_prior();
  return {wide.mean.cast<float>(), wide.covariance.cast<float>()};
}

}  // namespace

bool finds_the_payload(Solver solve) {
  Random random(2);
  for (int k = 0; k < 30; ++k) {
    rme::PayloadLikelihood<float> likelihood;
    rme::Vector4<float> truth;
    rme::InferenceResult<float> exact, result;
    if (!event_likelihood(random, likelihood, truth)) return false;
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

bool object_and_push_are_told_apart() {
  Random random(6);
  const auto pose = rme::testing::random_pose(random);
  const Jacobian7 J = pose.jacobian.cast<float>();
  const auto regressor =
      rme::payload_regressor<float, 7>(J, pose.rotation.cast<float>(), rme::standard_gravity<float>());
  const rme::NuisanceGaussian<float, 7> nuisance = rme::SensorModel<float, 7>::link_side().prior();
  const Vector7 precision = Vector7::Constant(1 / (40 * 0.03F * 0.03F));  // noise that stays the same for 40 ticks
  // Log odds of the payload against a push.
  const auto odds = [&](const Vector7& tau) {
    rme::PayloadStatistics<float, 7> window;
    for (int k = 0; k < 200; ++k) {
      rme::PayloadObservation<float, 7> still;  // of no velocity and no direction, which braces would leave undefined
      still.tau = tau + gaussian<Vector7>(random, 0.03F);
      still.regressor = regressor;
      window.add(still);
    }
    rme::PayloadLikelihood<float> likelihood;
    rme::InferenceResult<float> payload;
    rme::PayloadStatistics<float, 7>::Marginals marginals;
    float push = 0;
    if (window.likelihood(precision, nuisance, likelihood) != Status::Ok ||
        rme::infer_payload(likelihood, prior(), payload, rme::ExactQuadrature()) != Status::Ok ||
        window.marginals(precision, nuisance, marginals) != Status::Ok ||
        rme::push_log_evidence<float, 7>(marginals, {}, J, {}, push) != Status::Ok)
      return kNan;
    // The one counts from an empty hand, the other does not.
    return payload.log_evidence + rme::payload_log_evidence(likelihood, rme::Payload<float>()) - push;
  };
  const Vector7 object = regressor.torque({1.2F, {0.02F, -0.03F, 0.12F}});
  const Vector7 push = J.transpose() * (Vector6() << 12, -9, 4, 0.5F, 0.8F, -1).finished();
  return odds(object) > 3 && odds(push) < -3;
}

bool offset_outlives_an_event_and_stiction_does_not() {
  const auto model = rme::SensorModel<float, 7>::joint_friction();  // offset and stiction of the same size
  rme::NuisanceGaussian<float, 7> baseline = model.prior();
  baseline.mean[0][0] = 0.4F;
  return near(model.after_event(baseline).mean[0][0], 0.2, 1e-6);
}

}  // namespace

const std::vector<Case> kInference = {
    {"infer_payload: quadrature and full covariance find the payload", full_covariance_finds_the_payload},
    {"published_likelihood: a quarter of the range", published_likelihood_is_a_quarter_of_the_range},
    {"push_log_evidence: object and push told apart", object_and_push_are_told_apart},
    {"SensorModel: the offset outlives an event, stiction does not", offset_outlives_an_event_and_stiction_does_not},
};

}  // namespace float_core
