#pragma once
// For tests of classes whose number of joints is known at run time. Link rme_precompiled_any_joints.
#include <cmath>
#include <precompiled/any_joints.hpp>
#include <rme/core/compensation.hpp>
#include <rme/sensing/proprioception.hpp>

namespace rme::testing {

/// Samples of a made-up arm that moves, and gets a kilogram after half a second.
template <int Dofs>
Proprioception<double, Dofs> sample_at(int tick) {
  const double t = 1e-3 * tick;
  Proprioception<double, Dofs> sample;
  const double angle = 0.3 * std::sin(t);
  sample.rotation << std::cos(angle), 0, std::sin(angle), 0, 1, 0, -std::sin(angle), 0, std::cos(angle);
  for (int j = 0; j < Dofs; ++j) {
    for (int i = 0; i < 6; ++i) sample.jacobian(i, j) = std::sin(1.0 + i + 2 * j + 0.2 * std::sin(t));
    sample.dq[j] = 0.01 * std::cos(t + j);
  }
  const double mass = tick > 500 ? 1 : 0;
  sample.tau_ext = -compensation_torque<double>({mass, {0.01, 0, 0.1}}, sample.jacobian, sample.rotation);
  for (int j = 0; j < Dofs; ++j) sample.tau_ext[j] += 0.01 * std::sin(1.7 * tick * (j + 1));
  sample.period = tick % 7 == 0 ? 0.002 : 0;
  return sample;
}

}  // namespace rme::testing
