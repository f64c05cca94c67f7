#include "paper/calibration/random_host.hpp"

#include "synthetic_arm/random_pose.hpp"

namespace rme::examples {

Draw RandomHost::draw(Kind kind, const std::optional<PayloadGaussian<double>>& prior, bool with_payload) {
  Draw d;
  d.friction_shows = kind == Kind::JointFriction || (kind == Kind::Mixed && uniform(0, 1) < 0.5);
  d.arm = faults(d.friction_shows);
  while (true) {
    pose(d.start);
    d.payload = with_payload ? payload(prior) : RigidBody();
    const Torque held = panda().dynamics(d.start, Torque::Zero(), d.payload).gravity;
    if ((held.array().abs() < 0.9 * panda().tau_max.array()).all()) break;
    ++d.skipped;
  }
  // The arm starts some millimetres beside its target, like an arm that has just arrived.
  for (int i = 0; i < 7; ++i) d.target[i] = normal(d.start[i], 0.005);
  return d;
}

// A torque sensor of typical noise and offset, joints of typical friction.
SyntheticArmConfig<7> RandomHost::faults(bool friction_shows) {
  SyntheticArmConfig<7> arm;
  arm.dt = kPeriod;
  arm.seed = random_();
  arm.sensing = friction_shows ? TorqueSensing::MotorSide : TorqueSensing::LinkSide;
  arm.torque_noise = panda().typical_noise;
  for (int i = 0; i < 7; ++i) {
    const bool proximal = i < 4;
    arm.torque_offset[i] = normal(0, panda().typical_offset[i]);
    arm.friction.coulomb[i] = proximal ? uniform(0.1, 0.3) : uniform(0.05, 0.1);
    arm.friction.viscous[i] = proximal ? uniform(0.05, 0.1) : uniform(0.02, 0.04);
  }
  return arm;
}

// Well inside the limits, well conditioned, the flange above the table and away from the base. The flange may point in
// any direction.
void RandomHost::pose(Torque& q) {
  while (true) {
    for (int i = 0; i < 7; ++i) {
      const double margin = 0.15 * (panda().q_max[i] - panda().q_min[i]);
      q[i] = uniform(panda().q_min[i] + margin, panda().q_max[i] - margin);
    }
    const auto at = panda().kinematics(q);
    if (is_mobile(at.jacobian, 0.1) && at.position.z() > 0.2 && at.position.head<2>().norm() > 0.3) return;
  }
}

RigidBody RandomHost::payload(const std::optional<PayloadGaussian<double>>& prior) {
  Eigen::Vector4d theta;
  if (prior) {
    do
      for (int i = 0; i < 4; ++i) theta[i] = normal(prior->mean[i], prior->standard_deviation()[i]);
    while (theta[0] < 0.05 || theta[0] > 3);
  } else {
    theta << uniform(0.2, 2), uniform(-0.08, 0.08), uniform(-0.08, 0.08), uniform(0, 0.2);
  }
  return box(theta[0], theta.tail<3>(), {uniform(0.04, 0.1), uniform(0.04, 0.1), uniform(0.04, 0.1)});
}

}  // namespace rme::examples
