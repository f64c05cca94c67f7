#pragma once
/// A libfranka torque controller that carries an unknown payload, and the hand-over of that payload to the robot.
#include <franka/model.h>
#include <franka/robot.h>

#include <array>

#include "hosts/payload_compensation.hpp"

namespace hosts {

// <snippet libfranka>
/// Settings for what a Franka arm reports.
inline rme::EstimatorConfig<double, 7> franka_config() {
  rme::EstimatorConfig<double, 7> config;
  config.torque_sign = rme::TorqueSign::Reaction;
  config.rated_payload = 3;        // [kg]
  config.observer_bandwidth = 50;  // [rad/s]; undocumented: measure it (see the check-list)
  return config;
}

/// Commands your controller's torques plus the compensation, until your controller finishes the motion.
/// @param nominal  callable (const franka::RobotState&) -> franka::Torques, without gravity, which libfranka adds
/// @return Ok: `nominal` has finished the motion. Otherwise, what was wrong with the sample that ended it
template <typename Nominal>
rme::Status control(franka::Robot& robot, const franka::Model& model, PayloadCompensation<7>& payload,
                    Nominal&& nominal) {
  using Vector = rme::JointVector<double, 7>;
  rme::Status status = rme::Status::Ok;
  franka::Torques tau(std::array<double, 7>{});
  payload.restart();  // libfranka begins at zero torque, and takes a step for a fault
  robot.control([&](const franka::RobotState& state, franka::Duration period) -> franka::Torques {
    const std::array<double, 42> jacobian = model.zeroJacobian(franka::Frame::kEndEffector, state);
    rme::Proprioception<double, 7> sample;
    sample.tau_ext = Eigen::Map<const Vector>(state.tau_ext_hat_filtered.data());
    sample.jacobian = Eigen::Map<const rme::Jacobian<double, 7>>(jacobian.data());
    sample.rotation = Eigen::Map<const rme::Matrix4<double>>(state.O_T_EE.data()).topLeftCorner<3, 3>();
    sample.dq = Eigen::Map<const Vector>(state.dq.data());
    sample.period = period.toSec();  // lost packets are time that passed
    status = payload.update(sample);
    if (status != rme::Status::Ok) return franka::MotionFinished(tau);  // with the command of the last tick
    tau = nominal(state);
    Eigen::Map<Vector>(tau.tau_J.data()) += payload.torque();
    return tau;
  });
  return status;
}
// </snippet>

// <snippet hand_over>
/// From now on the robot carries the payload, in addition to the load that it was told of before, and for rme the hand
/// is empty. Only between two control loops: within one, setLoad is refused.
/// @param state  read after the last loop
/// @return whether it was handed over: not before the estimate is sure and the payload has settled
inline bool hand_over(franka::Robot& robot, const franka::RobotState& state, PayloadCompensation<7>& payload) {
  using Body = rme::InertialParameters<double>;
  const rme::EstimatorState<double>& believed = payload.estimator().state();
  if (believed.empty() || believed.changing || believed.confidence < 0.95) return false;
  // The inertia is as good as the motion so far has shown it; a body has at least that of a ball of 4.5 cm radius.
  const Body found = Body::from_vector(believed.inertial.mean).made_consistent(0.02);
  // libfranka takes flange axes, the inertia about the centre of mass, and columns first.
  const Eigen::Affine3d F_T_EE(Eigen::Map<const rme::Matrix4<double>>(state.F_T_EE.data()));
  const rme::Matrix3<double> R = F_T_EE.linear();
  const Body more =
      Body::of_body({found.mass, F_T_EE * found.payload().com}, R * found.inertia_about_com() * R.transpose());
  const Body before = Body::of_body({state.m_load, Eigen::Map<const rme::Vector3<double>>(state.F_x_Cload.data())},
                                    Eigen::Map<const rme::Matrix3<double>>(state.I_load.data()));
  const Body sum = Body::from_vector(before.vector() + more.vector());  // both about the flange's origin
  std::array<double, 3> com;
  std::array<double, 9> inertia;
  Eigen::Map<rme::Vector3<double>>(com.data()) = sum.payload().com;
  Eigen::Map<rme::Matrix3<double>>(inertia.data()) = sum.inertia_about_com();
  robot.setLoad(sum.mass, com, inertia);  // throws if the robot does not take it; then rme goes on carrying
  payload.reset();
  return true;
}
// </snippet>

}  // namespace hosts
