#include <cmath>
#include <rme/event_estimator.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

#include "network/shipped_prior.hpp"
#include "support/catch.hpp"

namespace {

using namespace rme::examples;

/// The estimate of a payload that is handed to a Panda at its ready pose, with a typical arm's noise, offsets and
/// friction.
rme::PayloadGaussian<double> estimate(const ShippedPrior& prior, const RigidBody& payload, std::uint64_t seed) {
  const ArmModel<7>& model = panda();
  SyntheticArm<7> arm(model, with_typical_faults(model, seed), model.ready);
  const PoseImpedance<7> controller(model, model.ready);
  rme::EventEstimator<double, 7, ShippedPrior> estimator(0.001, {}, prior);
  for (int k = 0; k < 3000 && !estimator.estimated(); ++k) {
    if (k == 1000) arm.attach(payload);
    const auto& [position, rotation, jacobian] = arm.kinematics();
    REQUIRE(estimator.update({arm.tau_ext(), jacobian, rotation, arm.dq()}) == rme::Status::Ok);
    arm.step(controller.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()));
  }
  REQUIRE(estimator.estimated());
  return estimator.estimate().posterior;
}

TEST_CASE("NetworkPrior: the estimator finds a payload with the shipped network as its prior", "[network_prior]") {
  const ShippedPrior prior;
  const Eigen::Vector3d com(0.04, -0.02, 0.1);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    CAPTURE(seed);
    const auto posterior = estimate(prior, box(1.1, com, {0.06, 0.06, 0.1}), seed);
    REQUIRE(prior.asked());
    // Gravity is along z. The network alone: three times the errors of docs/weights.md.
    CHECK(std::abs(prior.said().mean[0] - 1.1) < 0.22);
    CHECK((prior.said().mean.segment<2>(1) - com.head<2>()).cwiseAbs().maxCoeff() < 0.066);
    // The estimate, which must be better: within a tenth of the mass and 25 mm.
    CHECK(std::abs(posterior.mean[0] - 1.1) < 0.11);
    CHECK((posterior.mean.segment<2>(1) - com.head<2>()).cwiseAbs().maxCoeff() < 0.025);
  }
}

TEST_CASE("NetworkPrior: a payload of 4 kg, twice the heaviest of the training, is not dragged to the lighter ones",
          "[network_prior]") {
  const ShippedPrior prior;
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    CAPTURE(seed);
    const auto posterior = estimate(prior, box(4, {0.02, 0.01, 0.08}, {0.1, 0.1, 0.1}), seed);
    CHECK_FALSE(prior.asked());
    // Within 3 %, and the interval is honest about it.
    CHECK(std::abs(posterior.mean[0] - 4) < 0.12);
    CHECK(std::abs(posterior.mean[0] - 4) < 3 * posterior.standard_deviation()[0]);
  }
}

}  // namespace
