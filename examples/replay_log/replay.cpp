#include "replay_log/replay.hpp"

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

std::vector<Proprioception<double, 7>> samples_of(const Log<7>& log, double bandwidth) {
  const double dt = nominal_period(log.t);
  MomentumObserverConfig<double, 7> config;
  if (bandwidth > 0) config.gain.setConstant(std::min(bandwidth, 1 / dt));
  MomentumObserver<double, 7> observer(dt, config);
  std::vector<Proprioception<double, 7>> samples;
  samples.reserve(log.size());
  for (std::size_t i = 0; i < log.size(); ++i) {
    const auto pose = panda().kinematics(log.q[i]);
    Proprioception<double, 7> sample;
    sample.jacobian = pose.jacobian;
    sample.rotation = pose.rotation;
    if (i > 0) sample.period = log.t[i] - log.t[i - 1];
    if (!log.dq.empty())
      sample.dq = log.dq[i];
    else if (i > 0)
      sample.dq = (log.q[i] - log.q[i - 1]) / sample.period;
    if (!log.tau_ext.empty()) {
      sample.tau_ext = log.tau_ext[i];
    } else {
      const auto arm = panda().dynamics(log.q[i], sample.dq);
      (void)observer.update(log.tau[i] - panda_friction(sample.dq), sample.dq, arm.mass_matrix, arm.coriolis_transpose,
                            arm.gravity);  // the reader has refused what is not finite
      sample.tau_ext = observer.tau_ext();
    }
    samples.push_back(sample);
  }
  return samples;
}

ReplaySummary replay(const Log<7>& log, const ReplayOptions& options,
                     const std::function<void(const ReplayedEstimate&)>& on_estimate,
                     const std::function<void(const ReplayedPush&)>& on_push) {
  constexpr double kAfter = 0.5, kSeldom = 0.1;  // [s]
  const double dt = nominal_period(log.t);
  const auto samples = samples_of(log, options.estimator.observer_bandwidth);
  Estimator<double, 7> estimator(dt, options.estimator);
  ReplaySummary summary;
  const double start = log.t.front() - dt;  // at which the estimator's time is zero
  double updated = 0, printed = start, changed = start - 1;
  int events = 0;
  bool triggered = false, declared = false;
  for (std::size_t i = 0; i < log.size(); ++i) {
    const double t = log.t[i];
    ++summary.samples;
    if (options.empty_at && !declared && t >= *options.empty_at) {
      estimator.declare_empty();
      declared = true;
    }
    if (options.at && !triggered && t >= *options.at) {
      estimator.trigger();
      triggered = true;
    }
    const auto before = std::chrono::steady_clock::now();
    const Status status = estimator.update(samples[i]);
    const std::chrono::duration<double, std::micro> elapsed = std::chrono::steady_clock::now() - before;
    const EstimatorState<double>& state = estimator.state();
    if (status != Status::Ok || !(state.updated > updated)) continue;
    updated = state.updated;
    ReplayedEstimate out;
    out.event = summary.estimates;
    out.t = out.window_end = t;
    out.state = state;
    out.elapsed_us = elapsed.count();
    if (!log.truth.empty()) out.truth = &log.truth[i];
    if (options.at) {
      if (!triggered) continue;
      out.final = t + 0.5 * dt >= *options.at + options.window;
      out.window_begin = *options.at;
      summary.estimates += out.final ? 1 : 0;
      on_estimate(out);
      if (out.final) break;
      continue;
    }
    const bool over = state.event.number > events;
    events = state.event.number;
    if (state.changing || over) changed = t;
    if (over && state.event.kind == EventKind::Pushed) {
      ++summary.rejected;
      on_push({t, start + state.event.noticed, state});
    }
    out.final = over && state.event.kind != EventKind::Pushed;
    if (!out.final && t - changed > kAfter && t - printed < kSeldom - 0.5 * dt) continue;
    printed = t;
    out.detected_at = start + (state.changing ? state.change_noticed : state.event.noticed);
    out.window_begin = start + (state.changing ? state.change_onset : state.event.onset);
    if (!state.changing && state.event.number == 0) {
      out.detected_at.reset();
      out.window_begin = log.t.front();
    }
    summary.estimates += out.final ? 1 : 0;
    on_estimate(out);
  }
  return summary;
}

}  // namespace rme::examples
