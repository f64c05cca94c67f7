#pragma once
/// A recording played through the estimator, sample by sample, as a live host would have fed it.
#include <functional>
#include <optional>
#include <rme/estimator.hpp>
#include <vector>

#include "io/log_reader.hpp"
#include "synthetic_arm/panda.hpp"

namespace rme::examples {

/// What to do with a log.
struct ReplayOptions {
  EstimatorConfig<double, 7> estimator;
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

/// Median time step [s]: the rate of a log whose stamps jitter. Needs two samples.
double nominal_period(const std::vector<double>& t);

/// The log as a host would have fed it, external torque by a momentum observer where the log has only the measured one.
/// @param bandwidth  of that observer [rad/s]
std::vector<Proprioception<double, 7>> samples_of(const Log<7>& log, double bandwidth);

/// Plays the log. A belief is handed on for each block while something changes and half a second after that, and ten
/// times a second otherwise.
ReplaySummary replay(const Log<7>& log, const ReplayOptions& options,
                     const std::function<void(const ReplayedEstimate&)>& on_estimate,
                     const std::function<void(const ReplayedPush&)>& on_push);

}  // namespace rme::examples
