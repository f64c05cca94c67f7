#pragma once
// libfranka's model of the arm, here the synthetic one.
#include "franka/robot.h"

namespace franka {

enum class Frame { kFlange, kEndEffector };

class Model {
 public:
  Model(Model&&) noexcept = default;
  Model& operator=(Model&&) noexcept = default;

  /// 6x7, column-major.
  std::array<double, 42> zeroJacobian(Frame frame, const RobotState& state) const {
    const auto at = rme::examples::panda().kinematics(Eigen::Map<const rme::JointVector<double, 7>>(state.q.data()));
    const auto F_T_EE = Eigen::Map<const rme::Matrix4<double>>(state.F_T_EE.data());
    std::array<double, 42> out;
    auto jacobian = Eigen::Map<rme::Jacobian<double, 7>>(out.data());
    jacobian = at.jacobian;
    if (frame == Frame::kEndEffector)  // v_EE = v_F + omega x (R p)
      jacobian.topRows<3>() -= rme::skew(at.rotation * F_T_EE.topRightCorner<3, 1>()) * at.jacobian.bottomRows<3>();
    return out;
  }
  std::array<double, 7> coriolis(const RobotState& state) const noexcept {
    using Vector = rme::JointVector<double, 7>;
    std::array<double, 7> out;
    Eigen::Map<Vector>(out.data()) =
        rme::examples::panda()
            .dynamics(Eigen::Map<const Vector>(state.q.data()), Eigen::Map<const Vector>(state.dq.data()))
            .coriolis;
    return out;
  }
  /// With the load that the robot was told of: the end effector's own mass is a part of the arm here.
  std::array<double, 7> gravity(const RobotState& state, const std::array<double, 3>& gravity_earth) const noexcept {
    using Vector = rme::JointVector<double, 7>;
    rme::examples::ArmModel<7> arm = nameless_;
    arm.gravity_vector = Eigen::Map<const Eigen::Vector3d>(gravity_earth.data());
    const rme::examples::RigidBody load{state.m_total, Eigen::Map<const Eigen::Vector3d>(state.F_x_Ctotal.data()),
                                        Eigen::Matrix3d::Zero()};
    std::array<double, 7> out;
    Eigen::Map<Vector>(out.data()) =
        arm.dynamics(Eigen::Map<const Vector>(state.q.data()), Vector::Zero(), load).gravity;
    return out;
  }

 private:
  friend class Robot;                  // there, too, a model comes from a robot alone
  Model() { nameless_.name.clear(); }  // so that a copy allocates nothing

  rme::examples::ArmModel<7> nameless_ = rme::examples::panda();
};

inline Model Robot::loadModel() {
  return Model();
}

}  // namespace franka
