#include "synthetic_arm/light_arm.hpp"

namespace rme::examples {

const ArmModel<7>& light_arm() {
  static const ArmModel<7> model = [] {
    constexpr double quarter = 1.5707963267948966;
    ArmModel<7> m{};
    m.name = "light arm";
    m.links = {
        link({0, 0, 0.12}, 0, 1.0, {0, 0.002, -0.01}, {0.0014, 0.0013, 0.0010, 0, 0, 0}),
        link({0, 0, 0}, -quarter, 0.6, {0, -0.05, 0.004}, {0.0011, 0.0006, 0.0010, 0, 0, 0}),
        link({0, -0.22, 0}, quarter, 1.0, {0.002, 0.001, -0.06}, {0.0043, 0.0042, 0.0007, 0, 0, 0}),
        link({0.03, 0, 0}, quarter, 0.6, {-0.02, 0.05, 0.002}, {0.0011, 0.0006, 0.0010, 0, 0, 0}),
        link({-0.03, 0.21, 0}, -quarter, 0.5, {0, 0.001, -0.05}, {0.0006, 0.0006, 0.0003, 0, 0, 0}),
        link({0, 0, 0}, quarter, 0.4, {0.002, -0.015, 0}, {0.0003, 0.0002, 0.0003, 0, 0, 0}),
        link({0.035, 0, 0}, quarter, 0.4, {0.001, 0, 0.05}, {0.0004, 0.0004, 0.0002, 0, 0, 0}),
    };
    m.flange = {0, 0, 0.1};
    m.ready << 0, -0.4, 0, -1.7, 0, 1.3, 0;
    m.q_min << -2.9, -1.9, -2.9, -2.6, -1.6, -1.6, -1.6;
    m.q_max << 2.9, 1.9, 2.9, 0.1, 1.6, 2.2, 1.6;
    m.dq_max << 10, 10, 5, 5, 15, 15, 15;
    m.ddq_max << 20, 20, 20, 20, 30, 30, 30;
    m.tau_max << 40, 40, 27, 27, 7, 7, 7;
    m.dtau_max.setConstant(2000);
    m.typical_coulomb << 0.5, 0.5, 0.35, 0.35, 0.08, 0.08, 0.08;
    m.typical_viscous << 0.4, 0.4, 0.2, 0.2, 0.03, 0.03, 0.03;
    m.typical_noise << 0.06, 0.06, 0.04, 0.04, 0.02, 0.02, 0.02;
    m.typical_offset << 0.1, 0.1, 0.08, 0.08, 0.03, 0.03, 0.03;
    return m;
  }();
  return model;
}

}  // namespace rme::examples
