#pragma once
/// A recording of an empty hand, to which payloads are added afterwards.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <optional>
#include <rme/event_estimator.hpp>
#include <rme/inference/payload_regressor.hpp>
#include <vector>

#include "event_replay/replay.hpp"
#include "paper/calibration/scores.hpp"

namespace rme::examples {

/// A log as the estimator sees it, and how the flange really moved.
struct Recording {
  double dt = 0;                                 ///< [s]
  std::vector<double> t;                         ///< [s]
  std::vector<Proprioception<double, 7>> ticks;  ///< as a host would feed them
  std::vector<FlangeMotion<double>> motion;      ///< without the noise of a causal derivative
};

/// @param bandwidth  of the observer, for a log of measured torque [rad/s]
inline Recording recording_of(const Log<7>& log, double bandwidth) {
  constexpr double kSlope = 0.02;  // the acceleration is the slope of the twist over this time to either side [s]
  Recording out;
  out.dt = nominal_period(log.t);
  out.t = log.t;
  const auto dq = log.dq.empty() ? differentiated(log.q, out.dt) : log.dq;
  const auto tau_ext = log.tau_ext.empty() ? observed(log, dq, out.dt, bandwidth) : log.tau_ext;
  std::vector<Vector6<double>> twist;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const auto pose = panda().kinematics(log.q[i]);
    out.ticks.push_back({tau_ext[i], pose.jacobian, pose.rotation, dq[i]});
    twist.push_back(pose.jacobian * dq[i]);
  }
  const auto half = std::lround(kSlope / out.dt), last = static_cast<long>(twist.size()) - 1;
  for (long i = 0; i <= last; ++i) {
    Vector6<double> slope = Vector6<double>::Zero();
    double squares = 0;
    for (long k = 1; k <= half; ++k) {
      const auto before = static_cast<std::size_t>(std::max(i - k, 0L)),
                 after = static_cast<std::size_t>(std::min(i + k, last));
      slope += static_cast<double>(k) * (twist[after] - twist[before]);
      squares += 2 * static_cast<double>(k * k);
    }
    slope /= squares * out.dt;
    out.motion.push_back({twist[static_cast<std::size_t>(i)].tail<3>(), slope.head<3>(), slope.tail<3>()});
  }
  return out;
}

/// A payload that is in the hand from a row on.
struct Injected {
  std::size_t row = 0;
  Payload<double> payload;
  double gyration_radius = 0;  ///< about its own centre of mass [m]
};

/// What the estimator made of it.
struct Outcome {
  std::optional<Scored> scored;  ///< the first final estimate
  bool empty = false;            ///< which said that the hand is empty
  int refused = 0;               ///< changes before it that were found to be no payload
};

/// Plays the recording about the payload's instant, its torque added: m (a + B r + Q products(r)) with the flange's
/// motion, seen through the observer's filter. An observer is linear in the measured torque, so that this is also what
/// comes out if the torque is taken off the measured one.
/// @param before, after  how long it is played before and after the instant [s]
/// @param known          whether the host tells the estimator the instant
inline Outcome estimate_injected(const Recording& recording, const EventEstimatorConfig<double, 7>& config,
                                 const Injected& injected, double before, double after, bool known) {
  const double dt = recording.dt;
  const double blend = config.window.observer_bandwidth > 0 ? config.window.observer_bandwidth * dt : 1;
  const auto ticks_before = static_cast<std::size_t>(before / dt), ticks_after = static_cast<std::size_t>(after / dt);
  const std::size_t first = injected.row - std::min(injected.row, ticks_before);
  const std::size_t end = std::min(recording.ticks.size(), injected.row + ticks_after);
  EventEstimator<double, 7> estimator(dt, config);
  JointVector<double, 7> seen = JointVector<double, 7>::Zero();  // of the payload, by the observer
  Outcome out;
  for (std::size_t i = first; i < end; ++i) {
    Proprioception<double, 7> tick = recording.ticks[i];
    if (i >= injected.row) {
      const auto regressor = payload_regressor<double, 7>(tick.jacobian, tick.rotation, config.gravity,
                                                          recording.motion[i], injected.gyration_radius);
      seen += blend * (regressor.torque(injected.payload) - seen);
      tick.tau_ext += static_cast<int>(config.torque_sign) * seen;
    }
    if (known && i == injected.row) estimator.trigger();
    if (estimator.update(tick) != Status::Ok) continue;
    const double since = (static_cast<double>(i) - static_cast<double>(injected.row)) * dt;
    if (since < 0) continue;
    if (estimator.rejected()) ++out.refused;
    if (!estimator.estimated()) continue;
    const auto& estimate = estimator.estimate();
    if (estimate.empty && !known) continue;
    Scored s;
    s.truth = injected.payload.vector();
    s.error = estimate.posterior.mean - s.truth;
    s.deviation = estimate.posterior.standard_deviation();
    s.delay = since;
    s.detection_delay = estimate.detected_at - static_cast<double>(injected.row - first) * dt;
    out.scored = s;
    out.empty = estimate.empty;
    break;
  }
  return out;
}

}  // namespace rme::examples
