#pragma once
// A Franka arm behind the stand-in for libfranka.
#include <franka/model.h>
#include <franka/robot.h>

#include <cmath>
#include <cstdint>
#include <limits>
#include <rme/sensing/momentum_observer.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

namespace rme::testing {

using Vector7 = JointVector<double, 7>;

inline examples::RigidBody unknown_kilogram() {
  return examples::box(1, {0.03, -0.02, 0.16}, {0.08, 0.06, 0.1});
}

/// What it takes to hold `body` where the arm is: J^T [ -m g ; -(R r) x (m g) ], written out.
inline Vector7 torque_that_holds(const examples::RigidBody& body, const examples::Kinematics<7>& at) {
  const Eigen::Vector3d weight(0, 0, -9.81 * body.mass);
  Vector6<double> wrench;
  wrench << -weight, -(at.rotation * body.com).cross(weight);
  return at.jacobian.transpose() * wrench;
}

/// Carries its own weight and the load that it was told of, and reports what torque it exerts beyond that.
struct FrankaArm {
  FrankaArm() {
    // The end effector is a hand, turned and ahead of the flange.
    F_T_EE.translate(Eigen::Vector3d(0.01, 0, 0.1034)).rotate(Eigen::AngleAxisd(-0.7854, Eigen::Vector3d::UnitZ()));
  }

  franka::RobotState read() const {
    franka::RobotState state;
    Eigen::Isometry3d O_T_F = Eigen::Isometry3d::Identity();
    O_T_F.linear() = arm.kinematics().rotation;
    O_T_F.translation() = arm.kinematics().position;
    Eigen::Map<Matrix4<double>>(state.O_T_EE.data()) = (O_T_F * F_T_EE).matrix();
    Eigen::Map<Matrix4<double>>(state.F_T_EE.data()) = F_T_EE.matrix();
    state.m_load = load.mass;
    Eigen::Map<Eigen::Vector3d>(state.F_x_Cload.data()) = load.com;
    Eigen::Map<Eigen::Matrix3d>(state.I_load.data()) = load.inertia;
    state.m_total = state.m_load;  // the hand is a part of the arm
    state.F_x_Ctotal = state.F_x_Cload;
    Eigen::Map<Vector7>(state.q.data()) = arm.q();
    Eigen::Map<Vector7>(state.dq.data()) = arm.dq();
    const Vector7 reported = -observer.tau_ext();
    Eigen::Map<Vector7>(state.tau_ext_hat_filtered.data()) =
        ticks == spoilt_tick ? Vector7(Vector7::Constant(std::numeric_limits<double>::quiet_NaN())) : reported;
    return state;
  }
  void command(const franka::Torques& torques) {
    commanded = Eigen::Map<const Vector7>(torques.tau_J.data());
    step();
    ++ticks;
  }
  void step() {
    arm.step(commanded + arm.dynamics().gravity + torque_that_holds(load, arm.kinematics()));
    const examples::Dynamics<7> known = arm.model().dynamics(arm.q(), arm.dq(), load);
    (void)observer.update(arm.tau_measured(), arm.dq(), known.mass_matrix, known.coriolis_transpose, known.gravity);
  }
  /// Some packets never arrive: the robot goes on with the last command.
  std::uint64_t lose() {
    if (loses_every == 0 || ticks == 0 || ticks % loses_every != 0) return 0;
    for (int i = 0; i < 3; ++i) step();
    return 3;
  }
  franka::Robot::Simulation simulation() {
    return {[this] { return read(); }, [this](const franka::Torques& torques) { command(torques); },
            [this](double mass, const Eigen::Vector3d& com, const Eigen::Matrix3d& inertia) {
              ++loads_set;
              if (takes > 0) load = {takes * mass, com, inertia};
            },
            [this] { return lose(); }};
  }

  Eigen::Isometry3d F_T_EE = Eigen::Isometry3d::Identity();
  Vector7 pose = examples::panda().ready + Vector7::Constant(0.1);
  examples::SyntheticArm<7> arm{examples::panda(), examples::SyntheticArmConfig<7>(), pose};
  MomentumObserver<double, 7> observer{1e-3};  // of the robot: it knows the load's inertia too
  examples::RigidBody load;
  int loads_set = 0;
  double takes = 1;  // share of the load's mass that setLoad() takes
  Vector7 commanded = Vector7::Zero();
  int ticks = 0;
  int spoilt_tick = -1;
  int loses_every = 0;
};

}  // namespace rme::testing
