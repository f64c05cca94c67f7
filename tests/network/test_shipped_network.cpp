#include <cmath>
#include <rme/sensing/sample_window.hpp>
#include <run_network/network_file.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

#include "support/catch.hpp"

namespace {

using namespace rme::examples;
using Window = rme::SampleWindow<double, 7>;

/// What a Panda at its ready pose, with a typical arm's noise, offsets and friction, reports half a second after a
/// payload was handed to it.
Window after_attach(const RigidBody& payload, std::uint64_t seed) {
  const ArmModel<7>& model = panda();
  SyntheticArm<7> arm(model, with_typical_faults(model, seed), model.ready);
  const PoseImpedance<7> controller(model, model.ready);
  Window window(0.001);
  for (int k = 0; k < 1500; ++k) {
    if (k == 1000) arm.attach(payload);
    const auto& [position, rotation, jacobian] = arm.kinematics();
    REQUIRE(window.push({arm.tau_ext(), jacobian, rotation, arm.dq()}) == rme::Status::Ok);
    arm.step(controller.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()));
  }
  return window;
}

const NetworkFile& shipped() {
  static const NetworkFile file = read_network_file(RME_PANDA_MODEL);
  return file;
}

TEST_CASE("NetworkPrior: the shipped network guesses a payload to three times the errors that its documentation states",
          "[network_prior]") {
  const rme::NetworkPrior<double> prior(*shipped().network, 0.001, shipped().config);
  const Eigen::Vector3d com(0.04, -0.02, 0.1);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    CAPTURE(seed);
    const Window window = after_attach(box(1.1, com, {0.06, 0.06, 0.1}), seed);
    Eigen::Vector4d guess;
    REQUIRE(prior.guess(window, 400, guess));
    const auto gaussian = prior(window, 400);
    CHECK(std::abs(gaussian.mean[0] - 1.1) < 0.22);
    CHECK(gaussian.mean[0] == guess[0]);
    // Gravity is along z, where the fixed prior stands.
    CHECK((gaussian.mean.segment<2>(1) - com.head<2>()).cwiseAbs().maxCoeff() < 0.066);
    CHECK(gaussian.mean[3] == Approx(shipped().config.unknown.gaussian.mean[3]).margin(0.01));
  }
}

TEST_CASE("NetworkPrior: a payload of 4 kg, twice the heaviest of the training, is foreign to it", "[network_prior]") {
  const rme::NetworkPrior<double> prior(*shipped().network, 0.001, shipped().config);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    CAPTURE(seed);
    const Window window = after_attach(box(4, {0.02, 0.01, 0.08}, {0.1, 0.1, 0.1}), seed);
    Eigen::Vector4d guess;
    CHECK_FALSE(prior.guess(window, 400, guess));
    CHECK(prior(window, 400).mean == shipped().config.unknown.gaussian.mean);
  }
}

}  // namespace
