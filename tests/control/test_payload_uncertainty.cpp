#include <cmath>
#include <random>
#include <rme/control/payload_uncertainty.hpp>
#include <rme/core/compensation.hpp>
#include <synthetic_arm/panda.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using Vector7 = rme::JointVector<double, 7>;
using rme::Hypothesis;
using rme::examples::panda;

struct Pose {
  rme::examples::Kinematics<7> kinematics;
  rme::examples::Dynamics<7> dynamics;
  oracle::Matrix inverse_mass;
  explicit Pose(std::mt19937& random) {
    const Vector7 q = panda().ready + 0.4 * oracle::random_matrix(random, 7, 1);
    kinematics = panda().kinematics(q);
    dynamics = panda().dynamics(q, Vector7::Zero());
    inverse_mass = oracle::inverse(dynamics.mass_matrix);
  }
  Vector7 torque(const rme::Payload<double>& payload) const {
    return -rme::compensation_torque<double>(payload, kinematics.jacobian, kinematics.rotation);
  }
};

rme::PayloadGaussian<double> belief_of(double mass, double mass_std, double com_std) {
  return rme::PayloadGaussian<double>::independent(Eigen::Vector4d(mass, 0.02, -0.01, 0.06),
                                                   Eigen::Vector4d(mass_std, com_std, com_std, com_std));
}

TEST_CASE("PayloadUncertainty: of payloads drawn from the belief, each joint leaves the error as often as k says",
          "[payload-uncertainty]") {
  // Two deviations to both sides: erfc(2 / sqrt(2)) = 4.55 %. The belief is narrow enough for the torque to be linear
  // in it.
  const unsigned seed = 4331;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  rme::PayloadUncertaintyConfig<double> config;
  config.deviations = 2;
  rme::PayloadUncertainty<double, 7> uncertainty(config);
  rme::PerHypothesis<double> steady;
  steady[Hypothesis::Steady] = 1;
  int outside = 0, all = 0;
  for (int i = 0; i < 20; ++i) {
    const Pose pose(random);
    rme::PayloadGaussian<double> belief = belief_of(1.2, 0.03, 0.004);
    belief.covariance(0, 3) = belief.covariance(3, 0) = -0.8 * 0.03 * 0.004;  // heavier and nearer, as data leave it
    REQUIRE(uncertainty.update(belief, steady, pose.kinematics.jacobian, pose.kinematics.rotation,
                               pose.dynamics.mass_matrix) == rme::Status::Ok);
    CHECK((uncertainty.torque() - pose.torque(belief.payload())).norm() < 1e-12);
    const Eigen::Matrix4d root = Eigen::Matrix4d(belief.covariance.llt().matrixL());
    for (int k = 0; k < 2000; ++k) {
      const Eigen::Vector4d theta =
          belief.mean + root * Eigen::Vector4d{normal(random), normal(random), normal(random), normal(random)};
      const Vector7 off =
          pose.inverse_mass * (pose.torque(rme::Payload<double>::from_vector(theta)) - uncertainty.torque());
      for (int j = 1; j < 7; ++j, ++all)  // joint 0 of an upright arm turns about gravity
        outside += off[j] > uncertainty.error().above[j] || -off[j] > uncertainty.error().below[j] ? 1 : 0;
    }
  }
  CHECK(static_cast<double>(outside) / all == Approx(std::erfc(std::sqrt(2.0))).margin(0.003));
}

TEST_CASE(
    "PayloadUncertainty: while it is likely, what an empty hand or any object up to the rated one does is covered",
    "[payload-uncertainty]") {
  const unsigned seed = 4332;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform;
  rme::PayloadUncertainty<double, 7> uncertainty;
  const rme::PayloadGaussian<double> belief = belief_of(1.2, 1e-4, 1e-4);
  const auto covered = [&](const Pose& pose, const rme::Payload<double>& actual) {
    const Vector7 off = pose.inverse_mass * (pose.torque(actual) - uncertainty.torque());
    return (off.array() <= uncertainty.error().above.array() + 1e-9).all() &&
           (-off.array() <= uncertainty.error().below.array() + 1e-9).all();
  };
  for (int i = 0; i < 50; ++i) {
    const Pose pose(random);
    for (const double likely : {0.0, 0.02}) {
      CAPTURE(i, likely);
      rme::PerHypothesis<double> probability;
      probability[Hypothesis::Empty] = likely;
      REQUIRE(uncertainty.update(belief, probability, pose.kinematics.jacobian, pose.kinematics.rotation,
                                 pose.dynamics.mass_matrix) == rme::Status::Ok);
      CHECK(covered(pose, {}) == (likely > 0));
      probability[Hypothesis::Empty] = 0;
      probability[Hypothesis::Exchanged] = likely;
      REQUIRE(uncertainty.update(belief, probability, pose.kinematics.jacobian, pose.kinematics.rotation,
                                 pose.dynamics.mass_matrix) == rme::Status::Ok);
      for (int k = 0; k < 50; ++k) {
        const Eigen::Vector3d com = oracle::random_matrix(random, 3, 1).normalized() * 0.15 * uniform(random);
        const bool good = covered(pose, {k == 0 ? 3.0 : 3 * uniform(random), com});
        if (likely > 0) REQUIRE(good);
      }
    }
  }
}

TEST_CASE("PayloadUncertainty: bad input is named and changes nothing", "[payload-uncertainty]") {
  std::mt19937 random(4333);
  const Pose pose(random);
  rme::PayloadUncertainty<double, 7> uncertainty;
  rme::PerHypothesis<double> steady;
  steady[Hypothesis::Steady] = 1;
  const auto& [position, rotation, jacobian] = pose.kinematics;
  REQUIRE(uncertainty.update(belief_of(1, 0.1, 0.01), steady, jacobian, rotation, pose.dynamics.mass_matrix) ==
          rme::Status::Ok);
  const Vector7 torque = uncertainty.torque(), below = uncertainty.error().below;
  CHECK(uncertainty.update(belief_of(std::nan(""), 0.1, 0.01), steady, jacobian, rotation, pose.dynamics.mass_matrix) ==
        rme::Status::NonFiniteInput);
  CHECK(uncertainty.update(belief_of(2, 0.1, 0.01), steady, jacobian, rotation, -pose.dynamics.mass_matrix) ==
        rme::Status::NotPositiveDefinite);
  steady[Hypothesis::Empty] = std::numeric_limits<double>::infinity();
  CHECK(uncertainty.update(belief_of(2, 0.1, 0.01), steady, jacobian, rotation, pose.dynamics.mass_matrix) ==
        rme::Status::NonFiniteInput);
  CHECK(uncertainty.torque() == torque);
  CHECK(uncertainty.error().below == below);
  rme::PayloadUncertaintyConfig<double> config;
  config.likely = 1.1;
  CHECK_THROWS_WITH((rme::PayloadUncertainty<double, 7>(config)), contains("PayloadUncertaintyConfig::likely"));
  config = {};
  config.deviations = -1;
  CHECK_THROWS_WITH((rme::PayloadUncertainty<double, 7>(config)), contains("PayloadUncertaintyConfig::deviations"));
}

}  // namespace
