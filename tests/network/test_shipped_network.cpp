#include <cmath>
#include <io/network_file.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <vector>

#include "support/catch.hpp"

namespace {

using namespace rme::examples;
using Sample = rme::Proprioception<double, 7>;

/// What a Panda at its ready pose, with a typical arm's noise, offsets and friction, reports in the 200 ms that end half
/// a second after a payload was handed to it.
std::vector<Sample> after_attach(const RigidBody& payload, std::uint64_t seed) {
  const ArmModel<7>& model = panda();
  SyntheticArm<7> arm(model, with_typical_faults(model, seed), model.ready);
  const PoseImpedance<7> controller(model, model.ready);
  std::vector<Sample> samples;
  for (int k = 0; k < 1500; ++k) {
    if (k == 1000) arm.attach(payload);
    const auto& [position, rotation, jacobian] = arm.kinematics();
    if (k >= 1300) samples.push_back({arm.tau_ext(), jacobian, rotation, arm.dq()});
    arm.step(controller.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()));
  }
  return samples;
}

TEST_CASE("MismatchNetwork: the shipped one guesses a payload to three times the errors that its documentation states",
          "[network]") {
  const NetworkFile file = read_network_file(RME_PANDA_MODEL);
  CHECK(file.damping == 1e-3);
  const Eigen::Vector3d com(0.04, -0.02, 0.1);
  for (const std::uint64_t seed : {1U, 2U, 3U}) {
    CAPTURE(seed);
    const auto samples = after_attach(box(1.1, com, {0.06, 0.06, 0.1}), seed);
    const auto at = [&samples](int i) -> const Sample& { return samples[static_cast<std::size_t>(i)]; };
    const auto guess = file.guess<7>(200, at);
    REQUIRE(guess.has_value());
    CHECK(std::abs((*guess)[0] - 1.1) < 0.22);
    // Gravity is along z, of which the torque says nothing.
    CHECK((guess->segment<2>(1) - com.head<2>()).cwiseAbs().maxCoeff() < 0.066);
    CHECK_FALSE(file.guess<7>(19, at).has_value());  // the network takes 20 samples
  }
}

}  // namespace
