#pragma once
/// A recording played through the estimator, sample by sample, as a live host would have fed it.
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

/// What to do with a log.
template <int Dofs>
struct ReplayOptions {
  RecordedArm<Dofs> arm;
  EstimatorConfig<double, Dofs> estimator;
  std::optional<double> at;        ///< [s]: the host says that the payload changes; the replay ends `window` later
  double window = 0.2;             ///< [s]
  std::optional<double> empty_at;  ///< [s]: the host says that the hand is empty
};

/// What is believed at one instant, in the log's own time.
struct ReplayedEstimate {
  int event = 0;      ///< events that were over before, pushes left out
  bool final = true;  ///< the first of an event that is over; else a belief on the way
  double t = 0;       ///< when a live host would have had it [s]
  std::optional<double> detected_at;
  double window_begin = 0, window_end = 0;  ///< from the event's onset to the newest sample [s]
  EstimatorState<double> state;
  double elapsed_us = 0;                   ///< of the tick that made it
  const Vector4<double>* truth = nullptr;  ///< at t, in the log; null if it has none
};

/// A change that was found to be no payload.
struct ReplayedPush {
  double t = 0;  ///< when a live host would have known [s]
  double detected_at = 0;
  EstimatorState<double> state;
};

struct ReplaySummary {
  std::size_t samples = 0;
  int estimates = 0;  ///< final ones
  int rejected = 0;
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

  /// What a user should know of it, a sentence each; nothing if all steps are alike within a tenth.
  std::vector<std::string> notes() const;
};

/// Median time step [s]: the rate of a log whose stamps jitter. Needs two samples.
double nominal_period(const std::vector<double>& t);

/// The weight of a step's torque in what an observer says after it: that of a period of a millisecond, as often as it
/// fits in, which is how BlockAverager takes the observer out again.
/// @param bandwidth  [rad/s]; 0: no observer, 1
/// @param period     of the step [s]
double observer_blend(double bandwidth, double period);

/// A log as a host would have fed it.
template <int Dofs>
struct Samples {
  std::vector<std::size_t> row;                      ///< of the log, for each sample
  std::vector<Proprioception<double, Dofs>> sample;  ///< with the time since the sample before as its period
  double bandwidth = 0;  ///< of the filter that the external torque has gone through [rad/s]; 0 if none
  TorqueSign sign = TorqueSign::External;
  LogTiming timing;
};

/// External torque is the log's own, or comes from the measured torque: over each step of the log's own length, the
/// mean that explains how the momentum has changed,
///
///     (p_k - p_k-1) / h - mean(tau) - mean(C^T dq - g),
///
/// through an observer of the config's bandwidth, whose discretisation is the one that the estimator takes out again.
/// @param config  its observer_bandwidth and torque_sign are those of the log's torque
/// @throws LogError if the log has a single row, or fewer than 50 rows a second
template <int Dofs>
Samples<Dofs> samples_of(const Log<Dofs>& log, const RecordedArm<Dofs>& arm,
                         const EstimatorConfig<double, Dofs>& config);

/// Plays the log. A belief is handed on for each block while something changes and half a second after that, and ten
/// times a second otherwise.
template <int Dofs>
ReplaySummary replay(const Log<Dofs>& log, const Samples<Dofs>& samples, const ReplayOptions<Dofs>& options,
                     const std::function<void(const ReplayedEstimate&)>& on_estimate,
                     const std::function<void(const ReplayedPush&)>& on_push);

}  // namespace rme::examples
