#pragma once
/// A log of an empty hand, prepared as an Estimator would have prepared it, and how restless it is.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <rme/event_estimator_config.hpp>
#include <rme/sensing/mismatch_detector.hpp>
#include <rme/sensing/onset.hpp>
#include <rme/sensing/sample_window.hpp>

#include "event_replay/replay.hpp"

namespace rme::examples {

/// Calls visit(past) after each sample of the log: the observer's lag taken off, the sign rme's.
template <typename Visit>
void for_each_sample(const Log<7>& log, const EventEstimatorConfig<double, 7>& settings, Visit&& visit) {
  const double dt = nominal_period(log.t);
  const auto dq = log.dq.empty() ? differentiated(log.q, dt) : log.dq;
  const auto tau_ext = log.tau_ext.empty() ? observed(log, dq, dt, settings.window.observer_bandwidth) : log.tau_ext;
  SampleWindow<double, 7> past(dt, settings.window);
  for (std::size_t i = 0; i < log.size(); ++i) {
    const auto pose = panda().kinematics(log.q[i]);
    const JointVector<double, 7> tau = tau_ext[i] * static_cast<int>(settings.torque_sign);
    if (past.push({tau, pose.jacobian, pose.rotation, dq[i]}) != Status::Ok) continue;
    if (i > 0) visit(past);  // an observer starts at zero, whatever the torque
  }
}

/// The largest changes in logs in which nothing happens; all norms over the joints [N m].
struct Restlessness {
  double step = 0;       ///< found in a collection by find_onset()
  double unrest = 0;     ///< between the quarters of a collection
  double change = 0;     ///< between means over `span` within the detector's window
  bool noticed = false;  ///< the detector as it stands took one for the beginning of an event
};

/// Takes one log into account.
/// @param span  over which the torque is averaged [s], at most a quarter of the detector's window
inline void measure(const Log<7>& log, const EventEstimatorConfig<double, 7>& settings, double span,
                    Restlessness& out) {
  const double dt = nominal_period(log.t);
  const auto ticks_of = [dt](double seconds) { return static_cast<std::size_t>(std::lround(seconds / dt)); };
  const std::size_t collection = ticks_of(settings.collection), step = ticks_of(settings.onset_span);
  const std::size_t count = ticks_of(span), window = ticks_of(settings.detector.window);
  MismatchDetector<7> detector(dt, settings.detector);
  std::size_t ticks = 0;
  for_each_sample(log, settings, [&](const SampleWindow<double, 7>& past) {
    if (detector.update(past.newest().tau) == Status::Ok) out.noticed = out.noticed || detector.rapid_change();
    if (++ticks % step != 0) return;  // often enough
    if (past.size() > collection) {
      out.step = std::max(out.step, find_onset(past, collection, step).jump);
      out.unrest = std::max(out.unrest, unrest(past, collection));
    }
    if (past.size() <= window) return;
    const auto mean = [&](std::size_t age) {
      JointVector<double, 7> sum = JointVector<double, 7>::Zero();
      for (std::size_t i = 0; i < count; ++i) sum += past.newest(age + i).tau;
      return JointVector<double, 7>(sum / static_cast<double>(count));
    };
    for (std::size_t age = count; age + count <= window; age += count)
      out.change = std::max(out.change, (mean(0) - mean(age)).norm());
  });
}

/// Raises the thresholds over what happened while nothing happened. A detector that the logs would have set off gets
/// means over `span` and thresholds to match; otherwise it stays as it is.
inline void raise_thresholds(const Restlessness& measured, double span, EventEstimatorConfig<double, 7>& settings) {
  constexpr double kMargin = 1.1;
  settings.onset_jump = std::max(settings.onset_jump, kMargin * measured.step);
  settings.unrest = std::max(settings.unrest, kMargin * measured.unrest);
  if (!measured.noticed) return;
  MismatchDetectorConfig& detector = settings.detector;
  detector.edge_average = detector.newest_average = detector.check_average = span;
  detector.check_age = {span, 2 * span, 3 * span};
  detector.activation_threshold = std::max(detector.activation_threshold, kMargin * measured.change);
  detector.stabilisation_threshold = std::max(detector.stabilisation_threshold, kMargin * measured.change);
}

}  // namespace rme::examples
