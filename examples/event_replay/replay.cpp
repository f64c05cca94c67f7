#include "event_replay/replay.hpp"

#include <algorithm>
#include <chrono>
#include <cmath>
#include <rme/sensing/momentum_observer.hpp>

namespace rme::examples {

double nominal_period(const std::vector<double>& t) {
  std::vector<double> steps(t.size() - 1);
  for (std::size_t i = 0; i + 1 < t.size(); ++i) steps[i] = t[i + 1] - t[i];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

std::vector<JointVector<double, 7>> differentiated(const std::vector<JointVector<double, 7>>& q, double dt) {
  std::vector<JointVector<double, 7>> dq(q.size(), JointVector<double, 7>::Zero());
  for (std::size_t i = 1; i < q.size(); ++i) dq[i] = (q[i] - q[i - 1]) / dt;
  return dq;
}

std::vector<JointVector<double, 7>> observed(const Log<7>& log, const std::vector<JointVector<double, 7>>& dq,
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

ReplaySummary replay(const Log<7>& log, const ReplayOptions& options, const AnyPrior& prior,
                     const std::function<void(const ReplayedEstimate&)>& on_estimate,
                     const std::function<void(const ReplayedRejection&)>& on_rejection) {
  const double dt = nominal_period(log.t);
  const auto dq = log.dq.empty() ? differentiated(log.q, dt) : log.dq;
  const double bandwidth = options.estimator.window.observer_bandwidth;
  const auto tau_ext = log.tau_ext.empty() ? observed(log, dq, dt, bandwidth) : log.tau_ext;

  EventEstimator<double, 7, AnyPrior> estimator(dt, options.estimator, prior);
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
      on_rejection({log.t[i], log.t[row(estimator.detected_at() - dt)], estimator.verdict()});
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
    on_estimate(out);
    if (options.at && estimate.final) break;
  }
  return summary;
}

}  // namespace rme::examples
