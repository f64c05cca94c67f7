#pragma once
/// Implementation of replay.hpp, for replay_dofs.cpp.in, which compiles it for each number of joints.
#include <algorithm>
#include <chrono>
#include <cmath>
#include <rme/estimator.hpp>

#include "replay_log/replay.hpp"

namespace rme::examples {

namespace detail {

/// Whether a row repeats the row before although the arm moves: the sensors were not read.
template <int Dofs>
bool is_held(const Log<Dofs>& log, std::size_t row) {
  constexpr double kMoves = 1e-3;  // [rad/s]
  if (row == 0 || log.q[row] != log.q[row - 1] || log.dq.empty() || log.dq[row] != log.dq[row - 1]) return false;
  if (!log.tau_ext.empty() && log.tau_ext[row] != log.tau_ext[row - 1]) return false;
  if (!log.tau.empty() && log.tau[row] != log.tau[row - 1]) return false;
  return log.dq[row].norm() > kMoves;
}

template <int Dofs>
LogTiming timing_of(const Log<Dofs>& log) {
  constexpr double kGap = 3;  // periods
  if (log.size() < 2) throw LogError(log.name + ": has a single row, which gives no sample rate");
  LogTiming out;
  out.period = out.shortest = out.longest = nominal_period(log.t);
  if (out.period > 0.1025)
    throw LogError(log.name + ": has a row each " + std::to_string(1e3 * out.period) +
                   " ms; at least 10 a second are needed");
  out.same_instant = log.same_instant;
  for (std::size_t i = 1; i < log.size(); ++i) {
    const double step = log.t[i] - log.t[i - 1];
    out.shortest = std::min(out.shortest, step);
    if (step > kGap * out.period) {
      ++out.gaps;
      out.longest_gap = std::max(out.longest_gap, step);
    } else {
      out.longest = std::max(out.longest, step);
    }
    out.held += is_held(log, i) ? 1 : 0;
  }
  return out;
}

}  // namespace detail

template <int Dofs>
Samples<Dofs> samples_of(const Log<Dofs>& log, const RecordedArm<Dofs>& arm,
                         const EstimatorConfig<double, Dofs>& config) {
  using Vector = JointVector<double, Dofs>;
  Samples<Dofs> out;
  out.timing = detail::timing_of(log);
  const bool measured = log.tau_ext.empty();
  out.bandwidth = config.observer_bandwidth;
  out.sign = measured ? TorqueSign::External : config.torque_sign;
  out.row.reserve(log.size());
  out.sample.reserve(log.size());
  const double sign = static_cast<double>(config.torque_sign);
  Vector momentum = Vector::Zero(), drift = Vector::Zero(), tau = Vector::Zero();  // of the row before
  Vector observed = Vector::Zero();
  for (std::size_t i = 0; i < log.size(); ++i) {
    if (detail::is_held(log, i)) continue;
    const auto pose = arm.model.kinematics(log.q[i]);
    Proprioception<double, Dofs> sample;
    sample.jacobian = pose.jacobian;
    sample.rotation = pose.rotation;
    sample.compensation = Vector::Zero();  // whatever the robot was commanded then did not follow from this estimate
    if (i > 0) sample.period = log.t[i] - log.t[out.row.back()];
    if (!log.dq.empty())
      sample.dq = log.dq[i];
    else if (i > 0)
      sample.dq = (log.q[i] - log.q[out.row.back()]) / sample.period;
    if (!measured) {
      sample.tau_ext = log.tau_ext[i];
    } else {
      const auto terms = arm.model.dynamics(log.q[i], sample.dq);
      const Vector p = terms.mass_matrix * sample.dq + arm.rotor_inertia.cwiseProduct(sample.dq),
                   s = terms.coriolis_transpose - terms.gravity;
      Vector torque = sign * arm.gains.cwiseProduct(log.tau[i]);
      if constexpr (Dofs == 7)
        if (arm.is_panda) torque -= panda_friction(sample.dq);
      if (arm.lacks_gravity) torque += terms.gravity;
      torque -= load_friction(arm, log.q[i], sample.dq);
      if (i > 0) {
        const Vector mean = (p - momentum) / sample.period - 0.5 * (torque + tau) - 0.5 * (s + drift);
        observed += observer_blend(out.bandwidth, sample.period) * (mean - observed);
        sample.tau_ext = observed;
      }
      momentum = p;
      drift = s;
      tau = torque;
    }
    out.row.push_back(i);
    out.sample.push_back(sample);
  }
  return out;
}

template <int Dofs>
ReplaySummary replay(const Log<Dofs>& log, const Samples<Dofs>& samples, const ReplayOptions<Dofs>& options,
                     const std::function<void(const ReplayedEstimate&)>& on_estimate,
                     const std::function<void(const ReplayedPush&)>& on_push) {
  constexpr double kAfter = 0.5, kSeldom = 0.1, kSlowest = 0.1;  // [s]
  const double dt = std::min(samples.timing.period, kSlowest);
  EstimatorConfig<double, Dofs> config = options.estimator;
  config.observer_bandwidth = samples.bandwidth;
  config.torque_sign = samples.sign;
  Estimator<double, Dofs> estimator(dt, config);
  ReplaySummary summary;
  const double start = log.t.front() - dt;  // at which the estimator's time is zero
  double updated = 0, printed = start, changed = start - 1;
  int events = 0;
  bool announced = false, declared = false;
  for (std::size_t k = 0; k < samples.sample.size(); ++k) {
    const std::size_t i = samples.row[k];
    const double t = log.t[i];
    ++summary.samples;
    if (options.empty_at && !declared && t >= *options.empty_at) {
      estimator.declare_empty();
      declared = true;
    }
    if (options.at && !announced && t >= *options.at) {
      estimator.expect_change();
      announced = true;
    }
    const auto before = std::chrono::steady_clock::now();
    const Status status = estimator.update(samples.sample[k]);
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
      if (!announced) continue;
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
