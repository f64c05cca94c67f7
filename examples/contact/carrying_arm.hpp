#pragma once
/// The arm of the contact programs: a Panda under an impedance law that tracks a path, with typical sensor faults and an
/// error of 1 % in its links' masses.
#include <cstdint>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

namespace rme::examples {

/// What a user may choose of the arm.
struct CarryingArm {
  bool friction = false;   ///< whether the torque contains joint friction
  double noise = 0;        ///< standard deviation of the noise of dq [rad/s]
  std::uint64_t seed = 1;  ///< of everything random

  SyntheticArmConfig<7> faults() const {
    SyntheticArmConfig<7> config = with_typical_faults(panda(), seed);
    if (!friction) config.friction = {};
    config.dq_noise.setConstant(noise);
    config.noisy_observer = true;
    config.mass_error = 0.01;
    config.com_error = 1e-3;
    return config;
  }
  /// Stiff enough to follow a path at 0.5 Hz.
  static PoseImpedance<7> controller() {
    PoseImpedanceConfig stiff;
    stiff.rate = 8;
    stiff.lambda1 = stiff.lambda2 = 120;
    stiff.rotation_stiffness = 60;
    stiff.rotation_damping = 6;
    return {panda(), panda().ready, stiff};
  }
};

}  // namespace rme::examples
