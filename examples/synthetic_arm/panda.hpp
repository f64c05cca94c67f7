#pragma once
/// The Franka Emika Panda: the numbers that its public models carry.
#include <synthetic_arm/arm_model.hpp>

namespace rme::examples {

/// The Panda without a hand. Inertias and friction: Gaz, Cognetti, Oliva, Robuffo Giordano, De Luca, "Dynamic
/// Identification of the Franka Emika Panda Robot With Retrieval of Feasible Parameters Using Penalty-Based
/// Optimization", RA-L 2019. Friction and sensor faults are typical, not identified (see panda_friction for those).
inline const ArmModel<7>& panda() {
  static const ArmModel<7> model = [] {
    constexpr double quarter = 1.5707963267948966;
    ArmModel<7> m{};
    m.name = "Franka Emika Panda";
    m.links = {
        link({0, 0, 0.333}, 0, 4.970684, {0.003875, 0.002081, -0.04762},
             {0.70337, 0.70661, 0.0091170, -0.00013900, 0.0067720, 0.019169}),
        link({0, 0, 0}, -quarter, 0.646926, {-0.003141, -0.02872, 0.003495},
             {0.0079620, 0.028110, 0.025995, -0.003925, 0.010254, 0.000704}),
        link({0, -0.316, 0}, quarter, 3.228604, {0.027518, 0.039252, -0.066502},
             {0.037242, 0.036155, 0.010830, -0.004761, -0.011396, -0.012805}),
        link({0.0825, 0, 0}, quarter, 3.587895, {-0.05317, 0.104419, 0.027454},
             {0.025853, 0.019552, 0.028323, 0.007796, -0.001332, 0.008641}),
        link({-0.0825, 0.384, 0}, -quarter, 1.225946, {-0.011953, 0.041065, -0.038437},
             {0.035549, 0.029474, 0.008627, -0.002117, -0.004037, 0.000229}),
        link({0, 0, 0}, quarter, 1.666555, {0.060149, -0.014117, -0.010517},
             {0.001964, 0.004354, 0.005433, 0.000109, -0.001158, 0.000341}),
        link({0.088, 0, 0}, quarter, 0.735522, {0.010517, -0.004252, 0.061597},
             {0.012516, 0.010027, 0.004815, -0.000428, -0.001196, -0.000741}),
    };
    m.flange = {0, 0, 0.107};
    m.ready << 0, -quarter / 2, 0, -1.5 * quarter, 0, quarter, quarter / 2;
    m.q_min << -2.8973, -1.7628, -2.8973, -3.0718, -2.8973, -0.0175, -2.8973;
    m.q_max << 2.8973, 1.7628, 2.8973, -0.0698, 2.8973, 3.7525, 2.8973;
    m.dq_max << 2.175, 2.175, 2.175, 2.175, 2.61, 2.61, 2.61;
    m.ddq_max << 15, 7.5, 10, 12.5, 15, 20, 20;
    m.tau_max << 87, 87, 87, 87, 12, 12, 12;
    m.dtau_max.setConstant(1000);
    m.typical_coulomb << 0.2, 0.2, 0.2, 0.2, 0.075, 0.075, 0.075;
    m.typical_viscous << 0.1, 0.1, 0.1, 0.1, 0.035, 0.035, 0.035;
    m.typical_noise << 0.05, 0.05, 0.05, 0.05, 0.03, 0.03, 0.03;
    m.typical_offset << 0.1, 0.1, 0.1, 0.1, 0.05, 0.05, 0.05;
    return m;
  }();
  return model;
}

/// Friction of one real Panda as identified by Gaz et al. (above): the torque by which the measured joint torque
/// exceeds the rigid-body model, same sign as dq [N m]. Zero at rest.
inline JointVector<double, 7> panda_friction(const JointVector<double, 7>& dq) {
  const Eigen::Array<double, 7, 1> a =
      (JointVector<double, 7>() << 0.54615, 0.87224, 0.64068, 1.2794, 0.83904, 0.30301, 0.56489).finished();
  const Eigen::Array<double, 7, 1> b =
      (JointVector<double, 7>() << 5.1181, 9.0657, 10.136, 5.5903, 8.3469, 17.133, 10.336).finished();
  const Eigen::Array<double, 7, 1> c =
      (JointVector<double, 7>() << 0.039533, 0.025882, -0.04607, 0.036194, 0.026226, -0.021047, 0.0035526).finished();
  return a / (1 + (-b * (dq.array() + c)).exp()) - a / (1 + (-b * c).exp());
}

}  // namespace rme::examples
