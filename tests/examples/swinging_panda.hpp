#pragma once
/// A recording of a Panda that swings all joints, made in memory.
#include <io/log_reader.hpp>
#include <random>
#include <synthetic_arm/panda.hpp>

namespace rme::testing {

/// What the swinging arm's torque sensors show.
struct Swing {
  double seconds = 12, period = 0.004;  ///< [s]
  double phase = 0;                     ///< of the swing at the beginning [s]: another one is another path
  double coulomb = 0, viscous = 0, offset = 0, noise = 0;  ///< [N m], [N m s/rad], [N m], [N m]
  examples::RigidBody payload;                             ///< in the hand, all the time
};

/// The log, with tau: all that the motors give.
inline examples::Log<7> swinging_panda(const Swing& swing) {
  std::mt19937 random(7);
  std::normal_distribution<double> normal;
  const auto& arm = examples::panda();
  examples::Log<7> log;
  log.name = "swing";
  for (int k = 0; k * swing.period < swing.seconds; ++k) {
    const double t = k * swing.period;
    JointVector<double, 7> q = arm.ready, dq, ddq;
    for (int j = 0; j < 7; ++j) {
      const double w = 1.1 + 0.23 * j, x = w * (t + swing.phase);
      q[j] += 0.4 * std::sin(x);
      dq[j] = 0.4 * w * std::cos(x);
      ddq[j] = -0.4 * w * w * std::sin(x);
    }
    const auto terms = arm.dynamics(q, dq, swing.payload);
    JointVector<double, 7> tau = terms.mass_matrix * ddq + terms.coriolis + terms.gravity;
    for (int j = 0; j < 7; ++j)
      tau[j] +=
          (dq[j] > 0 ? 1 : -1) * swing.coulomb + swing.viscous * dq[j] - swing.offset + swing.noise * normal(random);
    log.t.push_back(t);
    log.q.push_back(q);
    log.dq.push_back(dq);
    log.tau.push_back(tau);
  }
  return log;
}

}  // namespace rme::testing
