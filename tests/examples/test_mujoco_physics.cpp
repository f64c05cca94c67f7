#include <mujoco_arm/mujoco_physics.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/six_joint_arm.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

#include "support/catch.hpp"

namespace {

using rme::examples::ArmModel;
using rme::examples::box;
using rme::examples::MujocoPhysics;
using rme::examples::panda;
using rme::examples::PoseImpedance;
using rme::examples::six_joint_arm;
using rme::examples::SyntheticArm;
using rme::examples::SyntheticArmConfig;

const Eigen::Vector3d kSize(0.06, 0.06, 0.1);

template <int Dofs>
SyntheticArmConfig<Dofs> with_mujoco(SyntheticArmConfig<Dofs> config = {}) {
  config.physics = MujocoPhysics<Dofs>::make;
  config.substeps = 4;
  return config;
}

/// Three seconds of a held pose: a payload appears, a second one weighs in slowly, a push, the first one goes.
std::vector<rme::JointVector<double, 7>> held_pose(const SyntheticArmConfig<7>& config) {
  SyntheticArm<7> arm(panda(), config, panda().ready);
  const PoseImpedance<7> law(panda(), panda().ready);
  std::vector<rme::JointVector<double, 7>> trajectory;
  int first = 0;
  for (int k = 0; k < 3000; ++k) {
    if (k == 300) first = arm.attach(box(1.1, {0.05, 0.02, 0.13}, kSize));
    if (k == 900) arm.attach(box(0.6, {-0.04, 0.03, 0.1}, kSize), 0.5);
    if (k == 1800) arm.push({{12, -8, 5}, {0.5, 0, -0.3}});
    if (k == 2200) arm.push({});
    if (k == 2400) arm.detach(first);
    arm.step(law.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()));
    trajectory.push_back(arm.q());
  }
  return trajectory;
}

TEST_CASE("MujocoPhysics: a held arm with payloads and a push moves as under our own physics", "[mujoco_physics]") {
  const auto ours = held_pose({}), theirs = held_pose(with_mujoco<7>());
  double apart = 0, way = 0;
  for (std::size_t k = 0; k < ours.size(); ++k) {
    apart = std::max(apart, (ours[k] - theirs[k]).cwiseAbs().maxCoeff());
    way = std::max(way, (ours[k] - ours[0]).cwiseAbs().maxCoeff());
  }
  CAPTURE(apart, way);
  CHECK(way > 0.1);     // [rad]
  CHECK(apart < 1e-5);  // [rad]
}

TEMPLATE_TEST_CASE_SIG("MujocoPhysics: an arm that falls freely with a payload falls as under our own physics",
                       "[mujoco_physics]", ((int Dofs), Dofs), 6, 7) {
  const auto& model = []() -> const ArmModel<Dofs>& {
    if constexpr (Dofs == 6)
      return six_joint_arm();
    else
      return panda();
  }();
  SyntheticArmConfig<Dofs> config;
  config.substeps = 4;
  SyntheticArm<Dofs> ours(model, config, model.ready), theirs(model, with_mujoco<Dofs>(), model.ready);
  for (auto* arm : {&ours, &theirs}) arm->attach(box(0.8, {0.03, -0.02, 0.1}, kSize));
  for (int k = 0; k < 400; ++k) {
    ours.step(rme::JointVector<double, Dofs>::Zero());
    theirs.step(rme::JointVector<double, Dofs>::Zero());
  }
  CAPTURE(ours.q().transpose(), theirs.q().transpose());
  CHECK((ours.q() - model.ready).norm() > 0.3);
  CHECK((ours.q() - theirs.q()).cwiseAbs().maxCoeff() < 1e-5);
  CHECK((ours.dq() - theirs.dq()).cwiseAbs().maxCoeff() < 1e-4);
  CHECK((ours.tau_ext() - theirs.tau_ext()).cwiseAbs().maxCoeff() < 1e-3);
}

TEST_CASE("MujocoPhysics: a joint below its breakaway torque rests, and link-side sensors feel the friction",
          "[mujoco_physics]") {
  SyntheticArmConfig<7> config = with_mujoco<7>();
  config.friction.coulomb = panda().typical_coulomb;
  config.friction.viscous = panda().typical_viscous;
  config.sensing = rme::examples::TorqueSensing::LinkSide;
  SyntheticArm<7> arm(panda(), config, panda().ready);
  const rme::JointVector<double, 7> gravity = arm.dynamics().gravity, half = 0.5 * config.friction.coulomb;
  for (int k = 0; k < 2000; ++k) arm.step(gravity + half);
  CHECK((arm.q() - panda().ready).cwiseAbs().maxCoeff() < 5e-6);  // [rad], in 2 s
  CHECK((arm.tau_measured() - gravity).cwiseAbs().maxCoeff() < 1e-3);
}

}  // namespace
