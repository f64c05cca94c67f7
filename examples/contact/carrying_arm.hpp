#pragma once
/// The arm of the contact programs: a Panda under an impedance law that tracks a path, with typical sensor faults and an
/// error of 1 % in its links' masses.
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <mujoco_arm/physics_option.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

namespace rme::examples {

/// What a user may choose of the arm.
struct CarryingArm {
  bool friction = false;   ///< whether the torque contains joint friction
  double noise = 0;        ///< standard deviation of the noise of dq [rad/s]
  std::uint64_t seed = 1;  ///< of everything random
  Engine engine = Engine::Synthetic;

  SyntheticArmConfig<7> faults() const {
    SyntheticArmConfig<7> config = with_typical_faults(panda(), seed);
    if (!friction) config.friction = {};
    config.dq_noise.setConstant(noise);
    config.noisy_observer = true;
    config.mass_error = 0.01;
    config.com_error = 1e-3;
    use_engine(engine, config);
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
  /// A sine path about the pose `home`, which the arm rests in at first. The rotation has another frequency than the
  /// position, so that the phases differ from one period to the next.
  /// @param t  [s]
  static PoseTarget path(const Kinematics<7>& home, double t) {
    PoseTarget target{home.position, home.rotation};
    if (t < kMove) return target;
    const double omega = 2 * kPi * kFrequency, s = t - kMove, grown = std::min(1.0, s / 2);
    const Eigen::Vector3d way(0.03, 0.10, 0.06), axis(0.6, 0.0, 0.8);
    target.position += grown * std::sin(omega * s) * way;
    target.velocity = grown * omega * std::cos(omega * s) * way;
    target.rotation = Eigen::AngleAxisd(grown * 0.35 * std::sin(0.83 * omega * s), axis) * home.rotation;
    target.angular_velocity = grown * 0.35 * 0.83 * omega * std::cos(0.83 * omega * s) * axis;
    return target;
  }
  /// What it carries.
  /// @param mass  [kg]
  static RigidBody payload(double mass) { return box(mass, {0.03, 0.02, 0.10}, {0.06, 0.06, 0.1}); }

  static constexpr double kAttach = 1;       ///< when the payload is attached [s]
  static constexpr double kMove = 2;         ///< when the path begins [s]
  static constexpr double kFrequency = 0.5;  ///< of the path [Hz]

 private:
  static constexpr double kPi = 3.14159265358979323846;
};

}  // namespace rme::examples
