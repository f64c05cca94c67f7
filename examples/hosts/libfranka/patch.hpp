#pragma once
/// The lines that a libfranka controller gains: those that docs/embedding.md shows.
// <snippet franka_patch>
#include <rme/host/franka.hpp>  // rme
// </snippet>

#include <array>
#include <cstddef>

namespace hosts {

// <snippet franka_patch>
/// Settings of the compensation, as a user of the controller sees them.
struct CarryOptions {  // rme
  bool carry = false;  // rme: off by default
  double bound = 20;   // rme: at most so much is added on a joint [N m]
};

/// Your loop. nominal(state, period) computes your torques, without gravity, within half of the robot's torque rate.
template <typename Nominal>
void run(franka::Robot& robot, const franka::Model& model, Nominal&& nominal, const CarryOptions& options) {
  rme::PayloadCompensationConfig<double, 7> config;                            // rme
  config.estimator = rme::franka_config();                                     // rme
  config.torque_bound = rme::JointVector<double, 7>::Constant(options.bound);  // rme
  config.enabled = options.carry;                                              // rme
  rme::PayloadCompensation<double, 7> payload(0.001, config);                  // rme
  franka::Torques tau(std::array<double, 7>{});
  robot.control([&](const franka::RobotState& state, franka::Duration period) -> franka::Torques {
    if (payload.update(rme::franka_sample(model, state, period)) != rme::Status::Ok)  // rme
      return franka::MotionFinished(tau);                                             // rme: the last command
    tau = nominal(state, period);
    for (std::size_t j = 0; j < 7; ++j)                                // rme
      tau.tau_J[j] += payload.torque()[static_cast<Eigen::Index>(j)];  // rme
    return tau;
  });
}
// </snippet>

}  // namespace hosts
