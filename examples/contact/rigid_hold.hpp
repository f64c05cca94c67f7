#pragma once
/// An arm under soft impedance control whose hand is held by something rigid, or lifts something off a table.
#include <algorithm>
#include <cmath>
#include <memory>
#include <rme/estimator.hpp>
#include <stdexcept>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

namespace rme::examples {

/// What happens: after 2 s, the target rises.
struct RigidHold {
  double stiffness = 200;   ///< of the impedance [N/m]
  double rise = 0.01;       ///< of the target [m]
  double duration = 1;      ///< of the rise [s]
  double mass = 0;          ///< of what stands on the table [kg]; 0: the hand is held by something that does not move
  bool compensates = true;  ///< whether the controller adds rme's compensation
  bool announced = false;   ///< whether the host calls expect_change() during the rise
  std::uint64_t seed = 1;   ///< of everything random
};

/// What came of it.
struct RigidHoldResult {
  double force = 0;     ///< largest force between the hand and what holds it [N]
  double believed = 0;  ///< mass at the end [kg]
  double std = 0;       ///< its standard deviation [kg]
  double sag = 0;       ///< how far the hand was below its target at most, from 0.3 s after the rise [m]
};

/// Simulates 10 s.
inline RigidHoldResult hold_fast(const RigidHold& hold) {
  constexpr double kPeriod = 1e-3, kGrasps = 1, kRises = 2, kEnds = 10;  // [s]
  constexpr double kRigid = 1e4, kTable = 2e4, kDamping = 40;            // [N/m], [N s/m]
  SyntheticArmConfig<7> faults = with_typical_faults(panda(), hold.seed);
  faults.friction = {};
  faults.noisy_observer = true;
  faults.dq_noise.setConstant(0.002);
  SyntheticArm<7> arm(panda(), faults, panda().ready);
  PoseImpedanceConfig soft;
  soft.lambda1 = soft.lambda2 = 2 * std::sqrt(8 * hold.stiffness);
  soft.rate = hold.stiffness / soft.lambda1;
  PoseImpedance<7> controller(panda(), panda().ready, soft);
  const Kinematics<7> home = panda().kinematics(panda().ready);
  EstimatorConfig<double, 7> config;
  config.sensing = Sensing::LinkSide;
  const auto estimator = std::make_unique<Estimator<double, 7>>(kPeriod, config);
  const RigidBody body = box(hold.mass, {0.02, 0.01, 0.10}, {0.06, 0.06, 0.1});

  RigidHoldResult result;
  bool grasped = false;
  double stands = 0;    // height at which the table bears all [m]
  bool lifted = false;  // off the table
  Eigen::Vector3d held = home.position;
  while (arm.time() < kEnds) {
    const double t = arm.time(), s = std::clamp((t - kRises) / hold.duration, 0.0, 1.0);
    const Kinematics<7> now = arm.kinematics();
    const Eigen::Vector3d velocity = now.jacobian.topRows<3>() * arm.dq();
    PoseTarget target{home.position, home.rotation};
    target.position.z() += hold.rise * s * s * s * (10 + s * (6 * s - 15));
    target.velocity.z() = hold.rise / hold.duration * 30 * s * s * (1 - s) * (1 - s);
    controller.follow(target);
    if (!grasped && t > kGrasps) {
      grasped = true;
      held = now.position;
      stands = now.position.z() + 9.81 * hold.mass / kTable;
      if (hold.mass > 0) arm.attach(body);
    }
    Eigen::Vector3d force = Eigen::Vector3d::Zero();
    if (grasped && hold.mass > 0)
      force.z() = std::max(0.0, kTable * (stands - now.position.z()) - (lifted ? 0 : kDamping * velocity.z()));
    else if (grasped)
      force = -kRigid * (now.position - held) - kDamping * velocity;
    if (grasped && t > kRises) {
      result.force = std::max(result.force, force.norm());
      lifted = lifted || !(force.z() > 0);
      if (t > kRises + hold.duration + 0.3) result.sag = std::max(result.sag, target.position.z() - now.position.z());
    }
    if (hold.announced && t > kRises && t < kRises + hold.duration) estimator->expect_change();
    if (const Status status = estimator->update({arm.tau_ext(), now.jacobian, now.rotation, arm.dq()});
        status != Status::Ok)
      throw std::runtime_error(to_string(status));
    JointVector<double, 7> torque = controller.torque(arm.q(), arm.dq(), now, arm.dynamics());
    if (hold.compensates) torque += estimator->compensation(now.jacobian, now.rotation);
    arm.push({force, Eigen::Vector3d::Zero()});
    arm.step(torque);
  }
  const PayloadGaussian<double>& payload = estimator->state().payload;
  result.believed = payload.mean[0];
  result.std = std::sqrt(payload.covariance(0, 0));
  return result;
}

}  // namespace rme::examples
