#pragma once
/// A recording played through the estimator, sample by sample, as a live host would have fed it.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <optional>
#include <rme/estimator.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <vector>

#include "io/log_reader.hpp"
#include "synthetic_arm/panda.hpp"

namespace rme::examples {

/// What to do with a log.
struct ReplayOptions {
  EstimatorConfig<double, 7> estimator;
  std::optional<double> at;  ///< [s]: the estimate is made from [at, at + collection), no detector
  std::optional<std::pair<double, double>> baseline;  ///< [s, s]: when the hand is known to be empty
};

/// One estimate, in the log's own time.
struct ReplayedEstimate {
  int event = 0;
  bool final = true;  ///< else early: the change was still going on
  double t = 0;       ///< when a live host would have had it [s]
  std::optional<double> detected_at;
  double window_begin = 0, window_end = 0;
  PayloadGaussian<double> posterior;
  Verdict<double> verdict;
  double elapsed_us = 0;                   ///< of the tick that made it
  const Vector4<double>* truth = nullptr;  ///< at t, in the log; null if it has none
};

/// A change that was found to be no payload.
struct ReplayedRejection {
  double t = 0;  ///< when a live host would have known [s]
  double detected_at = 0;
  Verdict<double> verdict;
};

struct ReplaySummary {
  std::size_t samples = 0;
  int estimates = 0;  ///< final ones
  int rejected = 0;
};

/// Median time step [s]: the rate of a log whose stamps jitter. Needs two samples.
inline double nominal_period(const std::vector<double>& t) {
  std::vector<double> steps(t.size() - 1);
  for (std::size_t i = 0; i + 1 < t.size(); ++i) steps[i] = t[i + 1] - t[i];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

/// Joint velocities by backward differences, for a log without them.
inline std::vector<JointVector<double, 7>> differentiated(const std::vector<JointVector<double, 7>>& q, double dt) {
  std::vector<JointVector<double, 7>> dq(q.size(), JointVector<double, 7>::Zero());
  for (std::size_t i = 1; i < q.size(); ++i) dq[i] = (q[i] - q[i - 1]) / dt;
  return dq;
}

/// External torque of a log that holds the measured one: the Panda's friction taken off, then a momentum observer.
inline std::vector<JointVector<double, 7>> observed(const Log<7>& log, const std::vector<JointVector<double, 7>>& dq,
                                                    double dt, double bandwidth) {
  MomentumObserverConfig<double, 7> config;
  config.gain.setConstant(bandwidth);
  MomentumObserver<double, 7> observer(dt, config);
  std::vector<JointVector<double, 7>> tau_ext;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const auto arm = panda().dynamics(log.q[i], dq[i]);
    (void)observer.update(log.tau[i] - panda_friction(dq[i]), dq[i], arm.mass_matrix, arm.coriolis_transpose,
                          arm.gravity);  // the reader has refused what is not finite
    tau_ext.push_back(observer.tau_ext());
  }
  return tau_ext;
}

/// Plays the log; `report` is called with each ReplayedEstimate and each ReplayedRejection.
/// @param prior  where the estimator's priors come from
template <typename PriorSource, typename Report>
ReplaySummary replay(const Log<7>& log, const ReplayOptions& options, const PriorSource& prior, Report&& report) {
  const double dt = nominal_period(log.t);
  const auto dq = log.dq.empty() ? differentiated(log.q, dt) : log.dq;
  const double bandwidth = options.estimator.window.observer_bandwidth;
  const auto tau_ext = log.tau_ext.empty() ? observed(log, dq, dt, bandwidth) : log.tau_ext;

  Estimator<double, 7, PriorSource> estimator(dt, options.estimator, prior);
  std::vector<std::size_t> rows;  // of the ticks that the estimator has taken
  ReplaySummary summary;
  bool triggered = false, tared = false;
  for (std::size_t i = 0; i < log.size(); ++i) {
    ++summary.samples;
    if (options.baseline && !tared && log.t[i] >= options.baseline->second) {
      estimator.tare(options.baseline->second - options.baseline->first);
      tared = true;
    }
    if (options.at && !triggered && log.t[i] >= *options.at) {
      estimator.trigger();
      triggered = true;
    }
    const auto pose = panda().kinematics(log.q[i]);
    const Proprioception<double, 7> sample{tau_ext[i], pose.jacobian, pose.rotation, dq[i]};
    const auto start = std::chrono::steady_clock::now();
    const Status status = estimator.update(sample);
    const std::chrono::duration<double, std::micro> elapsed = std::chrono::steady_clock::now() - start;
    if (status != Status::Ok) continue;
    rows.push_back(i);
    if (options.at && !triggered) continue;
    const auto row = [&](double time) { return rows[static_cast<std::size_t>(std::lround(time / dt))]; };
    if (estimator.rejected()) {
      ++summary.rejected;
      report(ReplayedRejection{log.t[i], log.t[row(estimator.detected_at() - dt)], estimator.verdict()});
    }
    if (!estimator.estimated() && !estimator.refreshed()) continue;
    const auto& estimate = estimator.estimate();
    ReplayedEstimate out;
    out.event = summary.estimates;
    out.final = estimate.final;
    if (estimate.final) ++summary.estimates;
    out.t = log.t[i];
    if (!options.at) out.detected_at = log.t[row(estimate.detected_at - dt)];
    out.window_begin = log.t[row(estimate.window_begin)];
    out.window_end = log.t[i];
    out.posterior = estimate.posterior;
    out.verdict = estimator.verdict();
    out.elapsed_us = elapsed.count();
    if (!log.truth.empty()) out.truth = &log.truth[i];
    report(out);
    if (options.at && estimate.final) break;
  }
  return summary;
}

}  // namespace rme::examples
