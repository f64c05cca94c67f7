#include <cmath>
#include <random>
#include <rme/core/flange_motion.hpp>
#include <rme/tracking/explained_torque.hpp>
#include <synthetic_arm/panda.hpp>

#include "support/catch.hpp"

namespace {

using Eigen::Vector3d;
using rme::examples::panda;
using Explained = rme::ExplainedTorque<double, 7>;
using Joints = rme::JointVector<double, 7>;
using Phi = rme::InertialVector<double>;
using Sample = rme::Proprioception<double, 7>;

/// 2 kg, 30 mm aside and 100 mm ahead, with the inertia of a box about the end-effector origin.
Phi body() {
  Phi phi;
  phi << 2, 0.06, 0.04, 0.2, 0.03, -0.001, -0.006, 0.032, -0.004, 0.006;
  return phi;
}

Sample sample_at(const Joints& q) {
  Sample sample;
  const auto at = panda().kinematics(q);
  sample.jacobian = at.jacobian;
  sample.rotation = at.rotation;
  return sample;
}

TEST_CASE("ExplainedTorque: of a motion that is said, it is J^T Y phi behind a first-order filter", "[contact]") {
  const unsigned seed = 510;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const Vector3d gravity(0.3, -0.2, -9.7);
  Explained explained(50, 1e-3, gravity);
  Joints filtered = Joints::Zero();
  for (int k = 0; k < 100; ++k) {
    Joints q = panda().ready;
    for (int j = 0; j < 7; ++j) q[j] += 0.1 * normal(random);
    Sample sample = sample_at(q);
    const auto any = [&] { return Vector3d{normal(random), normal(random), normal(random)}; };
    sample.motion = rme::FlangeMotion<double>{any(), any(), any()};
    const double dt = k % 3 == 0 ? 2e-3 : 1e-3;
    explained.update(sample, dt);
    // The regressor has a test of its own, against a rigid body.
    const Joints now =
        sample.jacobian.transpose() * rme::inertial_wrench_regressor(sample.rotation, gravity, *sample.motion) * body();
    if (k == 0) filtered = now;
    filtered += (1 - std::pow(1 - 0.05, dt / 1e-3)) * (now - filtered);
    REQUIRE((explained.regressor() * body() - filtered).norm() < 1e-10 * (1 + filtered.norm()));
  }
}

TEST_CASE("ExplainedTorque: the flange's acceleration is the difference of J dq, and none after an interruption",
          "[contact]") {
  const Vector3d gravity(0, 0, -9.81);
  Explained explained(0, 1e-3, gravity);  // unfiltered
  Sample sample = sample_at(panda().ready);
  const auto at = [&](const Vector3d& linear, const Vector3d& angular) {
    rme::FlangeMotion<double> motion;
    motion.linear_acceleration = linear;
    motion.angular_acceleration = angular;
    motion.angular_velocity = (sample.jacobian * sample.dq).tail<3>();
    return Joints(sample.jacobian.transpose() * rme::inertial_wrench_regressor(sample.rotation, gravity, motion) *
                  body());
  };
  explained.update(sample, 1e-3);
  CHECK((explained.regressor() * body() - at(Vector3d::Zero(), Vector3d::Zero())).norm() < 1e-10);
  sample.dq = Joints::LinSpaced(0.01, 0.07);
  explained.update(sample, 1e-3);
  const rme::Vector6<double> acceleration = 1e3 * sample.jacobian * sample.dq;
  CHECK((explained.regressor() * body() - at(acceleration.head<3>(), acceleration.tail<3>())).norm() < 1e-9);
  sample.dq *= 3;
  explained.interrupt();
  explained.update(sample, 1e-3);
  CHECK((explained.regressor() * body() - at(Vector3d::Zero(), Vector3d::Zero())).norm() < 1e-10);
}

TEST_CASE("ExplainedTorque: a body at rest shows its weight at once, and nothing before the first sample",
          "[contact]") {
  Explained explained(50, 1e-3, {0, 0, -9.81});
  CHECK(explained.regressor().isZero(0));
  const Sample sample = sample_at(panda().ready);
  explained.update(sample, 1e-3);
  // (m g, r x m g) by hand, in world axes.
  const Phi phi = body();
  const Vector3d weight(0, 0, -9.81 * phi[0]);
  rme::Vector6<double> wrench;
  wrench << weight, (sample.rotation * phi.segment<3>(1)).cross(Vector3d(0, 0, -9.81));
  CHECK((explained.regressor() * phi - sample.jacobian.transpose() * wrench).norm() < 1e-10);
  CHECK((explained.regressor() * phi).norm() > 5);
}

}  // namespace
