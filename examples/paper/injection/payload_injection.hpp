#pragma once
/// Adds payloads to a recording of an empty hand.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <rme/tracking/inertial_parameters.hpp>
#include <vector>

#include "replay_log/replay.hpp"

namespace rme::examples {

/// Motion of the end effector at each sample. The acceleration uses samples before and after it, and so is less noisy
/// than one that a live host could compute.
template <int Dofs>
std::vector<FlangeMotion<double>> motion_of(const Log<Dofs>& log, const Samples<Dofs>& samples) {
  constexpr double kSlope = 0.02;  // the acceleration is the slope of the twist over this time to either side [s]
  const std::size_t n = samples.sample.size();
  std::vector<Vector6<double>> twist;
  for (const auto& sample : samples.sample) twist.push_back(sample.jacobian * sample.dq);
  std::vector<FlangeMotion<double>> out;
  std::size_t begin = 0, end = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const double t = log.t[samples.row[i]];
    while (begin < i && log.t[samples.row[begin]] < t - kSlope) ++begin;
    while (end < n && log.t[samples.row[end]] <= t + kSlope) ++end;
    Vector6<double> slope = Vector6<double>::Zero(), mean = slope;
    double mean_time = 0, squares = 0;
    const double count = static_cast<double>(end - begin);
    for (std::size_t k = begin; k < end; ++k) {
      mean += twist[k] / count;
      mean_time += log.t[samples.row[k]] / count;
    }
    for (std::size_t k = begin; k < end; ++k) {
      const double since = log.t[samples.row[k]] - mean_time;
      slope += since * (twist[k] - mean);
      squares += since * since;
    }
    if (squares > 0) slope /= squares;
    out.push_back({twist[i].tail<3>(), slope.head<3>(), slope.tail<3>()});
  }
  return out;
}

/// A payload that is in the hand from an instant on.
struct Injected {
  double t = 0;  ///< [s]
  InertialParameters<double> payload;
};

/// The samples from `begin` to `end` [s], with the torque that the payload would have added to their external torque:
/// that of the wrench of its ten inertial parameters under the end effector's motion, passed through the observer's
/// filter. An observer is linear in the measured torque, so the result is the same as if the payload's torque were
/// subtracted from the measured torque before the observer.
template <int Dofs>
Samples<Dofs> injected(const Log<Dofs>& log, const Samples<Dofs>& samples,
                       const std::vector<FlangeMotion<double>>& motion, const Eigen::Vector3d& gravity,
                       const Injected& injection, double begin, double end) {
  Samples<Dofs> out;
  out.bandwidth = samples.bandwidth;
  out.sign = samples.sign;
  out.timing = samples.timing;
  JointVector<double, Dofs> seen = JointVector<double, Dofs>::Zero();  // payload's torque after the observer's filter
  for (std::size_t i = 0; i < samples.sample.size(); ++i) {
    const double t = log.t[samples.row[i]];
    if (t < begin || t > end) continue;
    Proprioception<double, Dofs> sample = samples.sample[i];
    if (t >= injection.t) {
      const auto wrench = inertial_wrench_regressor<double>(sample.rotation, gravity, motion[i]);
      const JointVector<double, Dofs> torque = sample.jacobian.transpose() * (wrench * injection.payload.vector());
      const double period = sample.period > 0 ? sample.period : samples.timing.period;
      seen += observer_blend(samples.bandwidth, period) * (torque - seen);
      sample.tau_ext += static_cast<double>(samples.sign) * seen;
    }
    out.row.push_back(samples.row[i]);
    out.sample.push_back(sample);
  }
  return out;
}

}  // namespace rme::examples
