#pragma once
/// Plays a recording through the estimator, sample by sample, as a live host would have passed the samples.
#include <cstddef>
#include <functional>
#include <optional>
#include <rme/estimator_config.hpp>
#include <rme/estimator_state.hpp>
#include <rme/sensing/proprioception.hpp>
#include <string>
#include <vector>

#include "io/log_reader.hpp"
#include "urdf_arm/recorded_arm.hpp"

namespace rme::examples {

/// How to replay a log.
template <int Dofs>
struct ReplayOptions {
  RecordedArm<Dofs> arm;
  EstimatorConfig<double, Dofs> estimator;
  std::optional<double> at;        ///< when expect_change() is called; the replay ends `window` later [s]
  double window = 0.2;             ///< [s]
  std::optional<double> empty_at;  ///< when declare_empty() is called [s]
};

/// The estimate at one instant. All times are the log's.
struct ReplayedEstimate {
  int event = 0;      ///< number of earlier events, without pushes
  bool final = true;  ///< the first estimate after an event is over; false for all others
  double t = 0;       ///< when a live host would have had it [s]
  std::optional<double> detected_at;
  double window_begin = 0, window_end = 0;  ///< from the event's onset to the newest sample [s]
  EstimatorState<double> state;
  double elapsed_us = 0;                   ///< computing time of that tick [us]
  const Vector4<double>* truth = nullptr;  ///< at t, in the log; null if it has none
};

/// An event that was a push.
struct ReplayedPush {
  double t = 0;  ///< when a live host would have known [s]
  double detected_at = 0;
  EstimatorState<double> state;
};

struct ReplaySummary {
  std::size_t samples = 0;
  int estimates = 0;  ///< final ones
  int rejected = 0;   ///< pushes
};

/// How a log's time stamps are spaced.
struct LogTiming {
  double period = 0;             ///< median step [s]
  double shortest = 0;           ///< [s]
  double longest = 0;            ///< [s], gaps left out
  std::size_t gaps = 0;          ///< steps of more than three periods
  double longest_gap = 0;        ///< [s]
  std::size_t same_instant = 0;  ///< rows with the time stamp of the row before, left out
  std::size_t held = 0;          ///< rows that repeat all of the row before while the arm moves, left out

  /// Remarks for the user, a sentence each; none if all steps are within a tenth of the period.
  std::vector<std::string> notes() const;
};

/// Median time step [s], also if time stamps jitter. Needs two samples.
double nominal_period(const std::vector<double>& t);

/// Weight of a step's torque in an observer's output after the step: 1 - (1 - K 1 ms)^(period / 1 ms), as if the
/// observer ran at 1 kHz. BlockAverager removes the observer in the same way.
/// @param bandwidth  K [rad/s]; 0: no observer, the weight is 1
/// @param period     of the step [s]
double observer_blend(double bandwidth, double period);

/// The samples that a host would have passed to the estimator.
template <int Dofs>
struct Samples {
  std::vector<std::size_t> row;                      ///< of the log, for each sample
  std::vector<Proprioception<double, Dofs>> sample;  ///< with the time since the sample before as its period
  double bandwidth = 0;  ///< of the filter that the external torque has passed [rad/s]; 0 if none
  TorqueSign sign = TorqueSign::External;
  LogTiming timing;
};

/// The external torque is that of the log, or is computed from measured torque. In the second case it is, for each step
/// of length h between two rows, the mean torque that explains the change of the momentum p,
///
///     (p_k - p_k-1) / h - mean(tau) - mean(C^T dq - g),
///
/// passed through an observer of the config's bandwidth, which is discretised in the way in which the estimator removes
/// it.
/// @param config  its observer_bandwidth and torque_sign are those of the log's torque
/// @throws LogError if the log has a single row, or fewer than 10 rows a second
template <int Dofs>
Samples<Dofs> samples_of(const Log<Dofs>& log, const RecordedArm<Dofs>& arm,
                         const EstimatorConfig<double, Dofs>& config);

/// Plays the log. Calls `on_estimate` for each block during an event and half a second after it, and ten times a second
/// otherwise; `on_push` for each event that was a push.
template <int Dofs>
ReplaySummary replay(const Log<Dofs>& log, const Samples<Dofs>& samples, const ReplayOptions<Dofs>& options,
                     const std::function<void(const ReplayedEstimate&)>& on_estimate,
                     const std::function<void(const ReplayedPush&)>& on_push);

}  // namespace rme::examples
