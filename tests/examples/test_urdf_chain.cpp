#include <random>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <urdf_arm/recorded_arm.hpp>
#include <urdf_arm/urdf_chain.hpp>

#include "examples/bad_urdfs.hpp"
#include "support/catch.hpp"

namespace {

using rme::examples::parse_urdf;
using rme::examples::read_urdf;
using rme::examples::UrdfChain;
using rme::examples::UrdfError;

std::string fixture(const std::string& name) {
  return RME_TEST_DATA "/urdf/" + name;
}

/// What it says of itself; nothing if it is read.
std::string refusal(const std::string& text, const std::string& base, const std::string& tip) {
  try {
    (void)parse_urdf(text, "arm.urdf", base, tip);
    return {};
  } catch (const UrdfError& error) {
    return error.what();
  }
}

TEST_CASE("read_urdf: the Panda's URDF is the built-in Panda", "[urdf_chain]") {
  const UrdfChain chain = read_urdf(fixture("panda.urdf"), "panda_link0", "panda_link8");
  REQUIRE(chain.dofs() == 7);
  CHECK(chain.joints[3].name == "panda_joint4");
  const auto model = rme::examples::arm_model<7>(chain);
  const auto& panda = rme::examples::panda();
  CHECK(model.q_min == panda.q_min);
  CHECK(model.q_max == panda.q_max);
  CHECK(model.dq_max == panda.dq_max);
  CHECK(model.tau_max == panda.tau_max);
  const unsigned seed = 11;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-3, 3);
  for (int k = 0; k < 20; ++k) {
    const auto draw = [&] { return uniform(random); };
    const rme::JointVector<double, 7> q = rme::JointVector<double, 7>::NullaryExpr(draw);
    const rme::JointVector<double, 7> dq = rme::JointVector<double, 7>::NullaryExpr(draw);
    const auto at = model.kinematics(q), at_panda = panda.kinematics(q);
    CHECK((at.position - at_panda.position).norm() < 1e-14);
    CHECK((at.rotation - at_panda.rotation).norm() < 1e-14);
    CHECK((at.jacobian - at_panda.jacobian).norm() < 1e-14);
    const auto terms = model.dynamics(q, dq), of_panda = panda.dynamics(q, dq);
    CHECK((terms.mass_matrix - of_panda.mass_matrix).norm() < 1e-13);
    CHECK((terms.gravity - of_panda.gravity).norm() < 1e-12);  // up to 60 N m
    CHECK((terms.coriolis - of_panda.coriolis).norm() < 1e-12);
    CHECK((terms.coriolis_transpose - of_panda.coriolis_transpose).norm() < 1e-12);
  }
}

TEST_CASE("read_urdf: what cannot move in the chain is welded to it, and continuous joints have no limits",
          "[urdf_chain]") {
  const UrdfChain chain = read_urdf(fixture("seven_joints_hand.urdf"), "base_link", "tool");
  REQUIRE(chain.dofs() == 7);
  CHECK(std::isinf(chain.joints[0].q_max));
  CHECK(chain.joints[1].q_max == 2.4);
  CHECK(chain.joints[6].tau_max == 13);
  // The light on the third link (0.05 kg); bracket, camera, hand and fingers (0.1 + 0.15 + 0.6 + 2 x 0.015 kg).
  CHECK(chain.links[2].body.mass == Approx(1.2 + 0.05));
  CHECK(chain.links[6].body.mass == Approx(0.4 + 0.88));
  // The arm stands on its base: with the link below, what is between them comes first.
  const UrdfChain mounted = read_urdf(fixture("seven_joints_hand.urdf"), "mount", "tool");
  CHECK((chain.links[0].offset - Eigen::Vector3d(0, 0, 0.156)).norm() < 1e-12);
  CHECK((mounted.links[0].offset - Eigen::Vector3d(0.1, -0.2, 0.3)).norm() == Approx(0.156));
}

TEST_CASE("read_urdf: a fixed tip may lie behind the last joint, turned", "[urdf_chain]") {
  const auto model = rme::examples::arm_model<6>(read_urdf(fixture("six_joints_5kg.urdf"), "base_link", "tool0"));
  // At zero everything is stretched along x and the last joint's axis is y. The tool's z axis is that axis.
  const auto at = model.kinematics(rme::JointVector<double, 6>::Zero());
  CHECK((at.rotation.col(2) - Eigen::Vector3d::UnitY()).norm() < 1e-12);
  CHECK(at.position.x() == Approx(0.42 + 0.39));
}

TEST_CASE("read_urdf: a URDF that cannot be used is refused, and what is wrong with it named", "[urdf_chain]") {
  CHECK(refusal(rme::testing::small_arm(), "l0", "l7").empty());
  for (const auto& bad : rme::testing::bad_urdfs()) {
    CAPTURE(bad.text, bad.base, bad.tip);
    CHECK_THAT(refusal(bad.text, bad.base, bad.tip), contains("arm.urdf: ") && contains(bad.reason));
  }
  CHECK_THROWS_WITH(read_urdf("absent.urdf", "a", "b"), contains("absent.urdf: cannot be opened"));
}

TEST_CASE("likely_rated_payload: effort limits say roughly what an arm is made for", "[urdf_chain]") {
  // Arms of such limits are made for 3, 5 and 10 kg. Roughly: a prior's scale is all that it is taken for.
  const auto likely = [](const char* file) {
    return likely_rated_payload(rme::examples::arm_model<6>(read_urdf(fixture(file), "base_link", "tool0")));
  };
  CHECK(likely_rated_payload(rme::examples::panda()) == Approx(3).epsilon(0.6));
  CHECK(likely("six_joints_5kg.urdf") == Approx(5).epsilon(0.6));
  CHECK(likely("six_joints_10kg.urdf") == Approx(10).epsilon(0.6));
  auto unbounded = rme::examples::panda();
  unbounded.tau_max[2] = std::numeric_limits<double>::infinity();
  CHECK_THROWS_WITH(likely_rated_payload(unbounded), contains("--rated-payload has to say"));
}

}  // namespace
