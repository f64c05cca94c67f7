#pragma once
/// For controllers on libfranka (0.9 or newer): the estimator's input from a robot's state, a torque control loop with
/// compensation, and the hand-over of a payload to the robot's own load. Needs libfranka; rme.hpp does not include it.
#include <franka/model.h>
#include <franka/robot.h>

#include <Eigen/Geometry>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/estimator_config.hpp>
#include <rme/host/hand_over.hpp>
#include <rme/host/payload_compensation.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/tracking/inertial_parameters.hpp>

namespace rme {

/// Settings for what a Franka arm reports.
inline EstimatorConfig<double, 7> franka_config() {
  EstimatorConfig<double, 7> config;
  config.torque_sign = TorqueSign::Reaction;
  config.rated_payload = 3;        // [kg]
  config.observer_bandwidth = 50;  // [rad/s]; undocumented: measure it
  return config;
}

/// The estimator's input from a robot's state; without the arm's gravity torque, which needs a franka::Model.
/// @param jacobian  6x7 of the end effector in base axes, columns first, as libfranka's model and franka_ros2 give it
/// @param state     of this tick
/// @param period    measured [s]; 0 means the nominal period
inline Proprioception<double, 7> franka_sample(const std::array<double, 42>& jacobian, const franka::RobotState& state,
                                               double period) {
  using Vector = JointVector<double, 7>;
  Proprioception<double, 7> sample;
  sample.tau_ext = Eigen::Map<const Vector>(state.tau_ext_hat_filtered.data());
  sample.jacobian = Eigen::Map<const Jacobian<double, 7>>(jacobian.data());
  sample.rotation = Eigen::Map<const Matrix4<double>>(state.O_T_EE.data()).topLeftCorner<3, 3>();
  sample.dq = Eigen::Map<const Vector>(state.dq.data());
  sample.period = period;
  return sample;
}
/// The estimator's input in one call of a control callback.
/// @param model   the robot's
/// @param state   of this call
/// @param period  of this call: more than a millisecond after lost packets; 0 in the first call
inline Proprioception<double, 7> franka_sample(const franka::Model& model, const franka::RobotState& state,
                                               franka::Duration period) {
  Proprioception<double, 7> sample =
      franka_sample(model.zeroJacobian(franka::Frame::kEndEffector, state), state, period.toSec());
  sample.gravity_torque.emplace();
  for (int axis = 0; axis < 3; ++axis) {
    std::array<double, 3> along{};
    along[static_cast<std::size_t>(axis)] = 1;
    const std::array<double, 7> torque = model.gravity(state, along);
    sample.gravity_torque->col(axis) = Eigen::Map<const JointVector<double, 7>>(torque.data());
  }
  return sample;
}

/// Commands your controller's torques plus the compensation, until your controller finishes the motion.
/// @param robot    is controlled until `nominal` finishes the motion
/// @param model    of the robot
/// @param payload  begins at zero torque; what it knows stays
/// @param nominal  callable (const franka::RobotState&, franka::Duration) -> franka::Torques, without gravity, which
///                 libfranka adds
/// @return Ok: `nominal` has finished the motion. Otherwise, what was wrong with the sample that ended it
template <typename Nominal>
Status franka_control(franka::Robot& robot, const franka::Model& model, PayloadCompensation<double, 7>& payload,
                      Nominal&& nominal) {
  Status status = Status::Ok;
  franka::Torques tau(std::array<double, 7>{});
  payload.restart();  // libfranka begins at zero torque, and takes a step for a fault
  robot.control([&](const franka::RobotState& state, franka::Duration period) -> franka::Torques {
    status = payload.update(franka_sample(model, state, period));
    if (status != Status::Ok) return franka::MotionFinished(tau);  // with the command of the last tick
    tau = nominal(state, period);
    Eigen::Map<JointVector<double, 7>>(tau.tau_J.data()) += payload.torque();
    return tau;
  });
  return status;
}

/// A load of the robot's, as setLoad() takes it; all zero means none.
struct FrankaLoad {
  double mass = 0;                  ///< [kg]
  std::array<double, 3> com{};      ///< [m], flange axes
  std::array<double, 9> inertia{};  ///< about the centre of mass [kg m^2], flange axes, columns first

  /// The load that the robot says it has.
  static FrankaLoad of(const franka::RobotState& state) { return {state.m_load, state.F_x_Cload, state.I_load}; }
  /// The load of these inertial parameters, which are about the flange's origin.
  static FrankaLoad of(const InertialParameters<double>& body) {
    FrankaLoad load;
    load.mass = body.mass;
    Eigen::Map<Vector3<double>>(load.com.data()) = body.payload().com;
    Eigen::Map<Matrix3<double>>(load.inertia.data()) = body.inertia_about_com();
    return load;
  }
  /// Flange axes, about the flange's origin.
  InertialParameters<double> body() const {
    return InertialParameters<double>::of_body({mass, Eigen::Map<const Vector3<double>>(com.data())},
                                               Eigen::Map<const Matrix3<double>>(inertia.data()));
  }
};

/// Result of a hand-over.
struct FrankaHandOver {
  HandOver<double> judged;  ///< why nothing was handed over, unless it is ready
  FrankaLoad asked;         ///< the load that the robot was asked to take
  FrankaLoad taken;         ///< the one that it reports afterwards
  bool done = false;        ///< whether the robot took at least half of the payload's mass
};

/// The parameters of a body in other axes and about another origin.
/// @param body  in axes A, about the origin of A
/// @param B_T_A  pose of A in B
/// @return in axes B, about the origin of B
inline InertialParameters<double> moved(const InertialParameters<double>& body, const Eigen::Affine3d& B_T_A) {
  const Matrix3<double> R = B_T_A.linear();
  return InertialParameters<double>::of_body({body.mass, B_T_A * body.payload().com},
                                             R * body.inertia_about_com() * R.transpose());
}

// <snippet franka_hand_over>
/// Asks the robot to carry the payload, in addition to the load that it has, and reads back what it took: rme no longer
/// counts that as held. Only between two control loops: within one, setLoad is refused.
/// @return whether it was handed over, or why not: not before mass and centre of mass are certain in all poses
inline FrankaHandOver franka_hand_over(franka::Robot& robot, PayloadCompensation<double, 7>& payload) {
  FrankaHandOver result;
  result.judged = payload.hand_over();
  if (!result.judged.ready()) return result;
  const franka::RobotState state = robot.readOnce();
  const Eigen::Affine3d F_T_EE(Eigen::Map<const Matrix4<double>>(state.F_T_EE.data()));
  const InertialParameters<double> before = FrankaLoad::of(state).body();
  const InertialParameters<double> more = moved(result.judged.body, F_T_EE);
  const InertialParameters<double> sum = InertialParameters<double>::from_vector(before.vector() + more.vector());
  result.asked = FrankaLoad::of(sum);
  robot.setLoad(result.asked.mass, result.asked.com, result.asked.inertia);  // throws if it is refused
  for (int tries = 0; tries < 100 && !result.done; ++tries) {                // each waits for the next state
    result.taken = FrankaLoad::of(robot.readOnce());
    result.done = std::abs(result.taken.mass - before.mass) > 0.5 * more.mass;
  }
  if (!result.done) return result;  // rme goes on carrying
  const InertialParameters<double> taken =
      InertialParameters<double>::from_vector(result.taken.body().vector() - before.vector());
  payload.handed_over(moved(taken, F_T_EE.inverse()));
  return result;
}

/// Sets the robot's load, by default to none, when the object has been released or lost. Only between two control
/// loops.
inline void franka_clear_load(franka::Robot& robot, PayloadCompensation<double, 7>& payload,
                              const FrankaLoad& load = FrankaLoad()) {
  robot.setLoad(load.mass, load.com, load.inertia);  // throws if it is refused
  payload.load_cleared();
}
// </snippet>

}  // namespace rme
