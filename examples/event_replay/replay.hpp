#pragma once
/// A recording played through the estimator, sample by sample, as a live host would have fed it.
#include <functional>
#include <optional>
#include <rme/event_estimator.hpp>
#include <utility>
#include <vector>

#include "io/log_reader.hpp"
#include "run_network/network_file.hpp"
#include "synthetic_arm/panda.hpp"

namespace rme::examples {

/// What to do with a log.
struct ReplayOptions {
  EventEstimatorConfig<double, 7> estimator;
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
double nominal_period(const std::vector<double>& t);

/// Joint velocities by backward differences, for a log without them.
std::vector<JointVector<double, 7>> differentiated(const std::vector<JointVector<double, 7>>& q, double dt);

/// External torque of a log that holds the measured one: the Panda's friction taken off, then a momentum observer.
std::vector<JointVector<double, 7>> observed(const Log<7>& log, const std::vector<JointVector<double, 7>>& dq,
                                             double dt, double bandwidth);

/// Plays the log.
/// @param prior         where the estimator's priors come from
/// @param on_estimate   called with each estimate, early ones included
/// @param on_rejection  called with each change that was no payload
ReplaySummary replay(const Log<7>& log, const ReplayOptions& options, const AnyPrior& prior,
                     const std::function<void(const ReplayedEstimate&)>& on_estimate,
                     const std::function<void(const ReplayedRejection&)>& on_rejection);

}  // namespace rme::examples
