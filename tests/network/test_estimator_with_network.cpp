#include <cmath>
#include <rme/estimator.hpp>
#include <run_network/network_file.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

#include "support/catch.hpp"

namespace {

using namespace rme::examples;
constexpr double kPeriod = 1e-3;

/// What the shipped network's prior said, and what the estimator made of it.
struct Outcome {
  rme::PayloadGaussian<double> prior, posterior;
};

/// A prior that remembers what it said.
struct Remembering {
  AnyPrior prior;
  rme::PayloadGaussian<double>* said;

  template <typename Window>
  rme::PayloadGaussian<double> operator()(const Window& window, std::size_t count) const noexcept {
    return *said = prior(window, count);
  }
};

/// A Panda near its ready pose, with a typical arm's noise, offsets and friction, is handed a payload.
Outcome estimate(const NetworkFile& network, const RigidBody& payload, std::uint64_t seed) {
  const ArmModel<7>& model = panda();
  SyntheticArm<7> arm(model, with_typical_faults(model, seed), model.ready);
  const PoseImpedance<7> controller(model, model.ready);
  Outcome outcome;
  rme::Estimator<double, 7, Remembering> estimator(kPeriod, {}, {AnyPrior(network, kPeriod), &outcome.prior});
  for (int k = 0; k < 3000; ++k) {
    if (k == 1000) arm.attach(payload);
    const auto& [position, rotation, jacobian] = arm.kinematics();
    REQUIRE(estimator.update({arm.tau_ext(), jacobian, rotation, arm.dq()}) == rme::Status::Ok);
    if (estimator.estimated()) {
      outcome.posterior = estimator.estimate().posterior;
      return outcome;
    }
    arm.step(controller.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()));
  }
  FAIL("no estimate within two seconds of the attach");
  return outcome;
}

TEST_CASE("NetworkPrior: the estimator finds a payload with the shipped network as its prior", "[network_prior]") {
  const NetworkFile network = read_network_file(RME_PANDA_MODEL);
  const Eigen::Vector3d com(0.04, -0.02, 0.1);
  for (const std::uint64_t seed : {1, 2, 3}) {
    CAPTURE(seed);
    const Outcome outcome = estimate(network, box(1.1, com, {0.06, 0.06, 0.1}), seed);
    // The network has been asked, and on its own is as good as docs/weights.md says: three times its errors there.
    CHECK(outcome.prior.mean != rme::FixedPrior<double>().gaussian.mean);
    CHECK(std::abs(outcome.prior.mean[0] - 1.1) < 0.22);
    CHECK((outcome.prior.mean.segment<2>(1) - com.head<2>()).cwiseAbs().maxCoeff() < 0.066);
    // The estimate is better: a tenth of the mass, 25 mm across gravity, which is along z.
    CHECK(std::abs(outcome.posterior.mean[0] - 1.1) < 0.11);
    CHECK((outcome.posterior.mean.segment<2>(1) - com.head<2>()).cwiseAbs().maxCoeff() < 0.025);
  }
}

TEST_CASE("NetworkPrior: a payload of 4 kg, twice the heaviest of the training, is not dragged to the lighter ones",
          "[network_prior]") {
  const NetworkFile network = read_network_file(RME_PANDA_MODEL);
  for (const std::uint64_t seed : {1, 2, 3}) {
    CAPTURE(seed);
    const Outcome outcome = estimate(network, box(4, {0.02, 0.01, 0.08}, {0.1, 0.1, 0.1}), seed);
    // Within 3 % of the mass, which is what the estimator misses lighter payloads by on arms whose friction shows.
    CHECK(std::abs(outcome.posterior.mean[0] - 4) < 0.12);
    // And the interval is honest about it.
    CHECK(std::abs(outcome.posterior.mean[0] - 4) < 3 * outcome.posterior.standard_deviation()[0]);
  }
}

}  // namespace
