#include "synthetic_arm/six_joint_arm.hpp"

namespace rme::examples {

const ArmModel<6>& six_joint_arm() {
  static const ArmModel<6> model = [] {
    constexpr double quarter = 1.5707963267948966;
    ArmModel<6> m{};
    m.name = "six-joint arm";
    m.links = {
        link({0, 0, 0.163}, 0, 3.8, {0, -0.002, -0.026}, {0.0113, 0.0113, 0.0107, 0, 0, 0}),
        link({0, 0.138, 0}, -quarter, 8.1, {0.2125, 0, -0.024}, {0.0146, 0.1292, 0.1292, 0, 0, 0}),
        link({0.425, 0, -0.131}, 0, 2.9, {0.152, 0, 0.026}, {0.0033, 0.0389, 0.0389, 0, 0, 0}),
        link({0.392, 0, 0.127}, 0, 1.4, {0, -0.002, 0.016}, {0.008, 0.008, 0.007, 0, 0, 0}),
        link({0, -0.1, 0}, quarter, 1.3, {0, 0.002, 0.016}, {0.008, 0.008, 0.007, 0, 0, 0}),
        link({0, 0.1, 0}, -quarter, 0.4, {0, 0, 0.075}, {0.006, 0.006, 0.006, 0, 0, 0}),
    };
    m.flange = {0, 0, 0.1};
    m.ready << 0, -quarter, quarter, -quarter, -quarter, 0;
    m.q_max.setConstant(2 * 3.141592653589793);
    m.q_max[2] = 3.141592653589793;
    m.q_min = -m.q_max;
    m.dq_max.setConstant(3.14);
    m.ddq_max.setConstant(14);
    m.tau_max << 150, 150, 150, 28, 28, 28;
    m.dtau_max.setConstant(1500);
    m.typical_coulomb << 0.4, 0.4, 0.3, 0.1, 0.1, 0.1;
    m.typical_viscous << 0.2, 0.2, 0.15, 0.05, 0.05, 0.05;
    m.typical_noise << 0.08, 0.08, 0.08, 0.04, 0.04, 0.04;
    m.typical_offset << 0.15, 0.15, 0.15, 0.06, 0.06, 0.06;
    return m;
  }();
  return model;
}

}  // namespace rme::examples
