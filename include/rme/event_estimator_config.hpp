#pragma once
/// Settings of the estimator.
#include <algorithm>
#include <cmath>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/evidence.hpp>
#include <rme/inference/sensor_model.hpp>
#include <rme/inference/variational_inference.hpp>
#include <rme/sensing/mismatch_detector.hpp>
#include <rme/sensing/sample_window.hpp>
#include <rme/sensing/torque_sign.hpp>
#include <vector>

namespace rme {

/// Settings of EventEstimator; the defaults suit a seven-joint arm of the Panda's size at any rate. docs/tuning.md
template <typename Scalar, int Dofs>
struct EventEstimatorConfig {
  Vector3<Scalar> gravity = standard_gravity<Scalar>();  ///< g [m/s^2], world axes
  TorqueSign torque_sign = TorqueSign::External;
  MismatchDetectorConfig detector;
  /// Watch the norm of tau_ext, as published, in place of every joint's torque less the known payload's.
  bool watch_norm = false;
  SampleWindowConfig window;
  /// What the arm's torque sensing is like; several are averaged by their evidence, event by event. At least one.
  std::vector<SensorModel<Scalar, Dofs>> sensors = {SensorModel<Scalar, Dofs>::link_side(),
                                                    SensorModel<Scalar, Dofs>::joint_friction()};
  double collection = 0.2;       ///< how long samples are gathered after the detection [s], > 0
  double baseline = 0.3;         ///< length of the quiet window before the change [s], >= 0; 0 uses none
  double baseline_guard = 0.02;  ///< between the quiet window and the change [s], >= 0
  double onset_span = 0.01;      ///< of the means whose difference finds the instant of the change [s], > 0
  double onset_jump = 0.4;       ///< a smaller step is no onset [N m], > 0
  double onset_guard = 0.02;     ///< after the change: samples left out, for the instant is not known exactly [s], >= 0
  double unrest = 0.8;           ///< a collection in which the torque changes by more starts again [N m], > 0
  double odds = 0;               ///< log odds that the payload changed, against push or nothing, that it takes [nats]
  double refresh = 0.01;         ///< between early estimates, made while the change settles [s]; 0 makes none
  double early_window = 0.03;    ///< samples since the change that an early estimate needs [s], > 0
  double gentle_window = 0.1;    ///< newest samples that are used while the weight is still coming [s], > 0
  double early_odds = 3;         ///< log odds of payload against push that an early estimate needs [nats]
  double early_excess = 4;       ///< excess of noise above which no early estimate is believed, > 0
  double gyration_radius = 0.03;  ///< of a payload about its own centre of mass, roughly [m], >= 0
  bool learn_noise = true;  ///< of a window noisier than the likeliest sensor model says, as of an arm in fast motion
  PushPrior push;           ///< what a change may be that is no payload
  VariationalInferenceConfig inference;

  /// @throws std::invalid_argument naming the field out of range
  void validate(double dt) const;
};

template <typename Scalar, int Dofs>
void EventEstimatorConfig<Scalar, Dofs>::validate(double dt) const {
  detail::require_positive(dt, "EventEstimator::dt", "> 0 s");
  detail::require(torque_sign == TorqueSign::External || torque_sign == TorqueSign::Reaction,
                  "EventEstimatorConfig::torque_sign", "1 or -1", static_cast<int>(torque_sign));
  detail::require(plausible(gravity) && gravity.norm() > 0, "EventEstimatorConfig::gravity", "finite and not zero",
                  gravity.norm());
  detail::require(detector.window >= 2 * dt, "MismatchDetectorConfig::window", ">= 2 samples [s]", detector.window);
  detail::require(collection >= 2 * dt, "EventEstimatorConfig::collection", ">= 2 samples [s]", collection);
  detail::require(baseline >= 0, "EventEstimatorConfig::baseline", ">= 0 s", baseline);
  detail::require(baseline_guard >= 0, "EventEstimatorConfig::baseline_guard", ">= 0 s", baseline_guard);
  const double needed = detector.window + std::max(collection, baseline + baseline_guard) + 2 * dt;
  detail::require(window.duration >= needed, "SampleWindowConfig::duration",
                  "at least the detector's window + the longer of collection and baseline", window.duration);
  detail::require(onset_span >= dt && onset_span <= detector.window, "EventEstimatorConfig::onset_span",
                  "1 sample to the detector's window [s]", onset_span);
  detail::require(onset_jump > 0, "EventEstimatorConfig::onset_jump", "> 0 N m", onset_jump);
  detail::require(onset_guard >= 0 && onset_guard <= detector.window, "EventEstimatorConfig::onset_guard",
                  "0 s to the detector's window", onset_guard);
  detail::require(refresh == 0 || (refresh >= dt && refresh <= window.duration), "EventEstimatorConfig::refresh",
                  "0 or 1 sample to the sample window [s]", refresh);
  detail::require(early_window >= 2 * dt && early_window <= window.duration, "EventEstimatorConfig::early_window",
                  "2 samples to the sample window [s]", early_window);
  detail::require(gentle_window >= 2 * dt && gentle_window <= detector.window, "EventEstimatorConfig::gentle_window",
                  "2 samples to the detector's window [s]", gentle_window);
  detail::require(std::isfinite(odds), "EventEstimatorConfig::odds", "finite", odds);
  detail::require(std::isfinite(early_odds), "EventEstimatorConfig::early_odds", "finite", early_odds);
  detail::require(early_excess > 0, "EventEstimatorConfig::early_excess", "> 0", early_excess);
  detail::require(unrest > 0, "EventEstimatorConfig::unrest", "> 0 N m", unrest);
  detail::require(gyration_radius >= 0 && gyration_radius <= 10, "EventEstimatorConfig::gyration_radius", "0 to 10 m",
                  gyration_radius);
}

}  // namespace rme
