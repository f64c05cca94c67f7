#pragma once
/// Everything that a window says about what is in the hand, whichever of several sensor models the arm follows.
#include <algorithm>
#include <cstddef>
#include <rme/core/payload.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/event_evidence.hpp>
#include <rme/inference/inference_result.hpp>
#include <rme/inference/model_average.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/inference/payload_statistics.hpp>
#include <rme/inference/sensor_model.hpp>
#include <rme/inference/variational_inference.hpp>
#include <vector>

namespace rme {

/// Log evidence of what a change may have been, up to a constant that all share.
template <typename Scalar>
struct Verdict {
  Scalar payload = Scalar(0);    ///< another payload is in the hand
  Scalar empty = Scalar(0);      ///< nothing is in the hand
  Scalar unchanged = Scalar(0);  ///< the payload is what it was
  Scalar push = Scalar(0);       ///< the payload is what it was, and something pushes

  /// The payload changed, to another one or to none.
  bool is_payload() const noexcept { return std::max(payload, empty) > std::max(unchanged, push); }
  bool is_empty() const noexcept { return empty >= payload; }
  /// Log odds that the payload changed [nats].
  Scalar log_odds() const noexcept { return std::max(payload, empty) - std::max(unchanged, push); }
};

/// Holds the sensor models and, for each, what is known of the nuisances; answers questions about PayloadStatistics.
/// Where the models disagree, the one that predicts the window better counts for more, in proportion to its evidence:
/// an arm whose friction shows is told from one whose friction does not by the data, event by event. Real time: no call
/// but the constructor allocates or throws; each costs one inference (a few microseconds) per model.
template <typename Scalar, int Dofs>
class EventInference {
 public:
  using Statistics = PayloadStatistics<Scalar, Dofs>;

  /// @param sensors  at least one
  /// @throws std::invalid_argument naming the field out of range
  EventInference(Scalar dt, const std::vector<SensorModel<Scalar, Dofs>>& sensors, const PushPrior& push,
                 const VariationalInferenceConfig& config);

  /// Nothing is known of the nuisances but the sensor models.
  void forget_baseline() noexcept;
  /// The nuisances of the next event, from a window in which the hand was empty.
  void learn_baseline(const Statistics& quiet) noexcept;

  /// The payload, averaged over the sensor models. Empty if the inference failed in all of them.
  ModelAverage<Scalar> posterior(const Statistics& window, const PayloadGaussian<Scalar>& prior) const noexcept;

  /// Which explanation of a settled window is the best. Each sensor model judges for itself and counts for as much as
  /// it predicts of the whole event: a model with little noise may explain a window at rest best in any way, and a push
  /// explains what it cannot.
  /// @param event     all samples of the event, the settled ones included
  /// @param before    the payload that was known
  /// @param jacobian  J of the settled window
  Verdict<Scalar> judge(const Statistics& settled, const Statistics& event, const PayloadGaussian<Scalar>& prior,
                        const Payload<Scalar>& before, const Jacobian<Scalar, Dofs>& jacobian) const noexcept;
  /// The same where the settled samples are all there is.
  Verdict<Scalar> judge(const Statistics& settled, const PayloadGaussian<Scalar>& prior, const Payload<Scalar>& before,
                        const Jacobian<Scalar, Dofs>& jacobian) const noexcept {
    return judge(settled, settled, prior, before, jacobian);
  }

 private:
  /// Posterior and log evidence of one sensor model. @return whether the inference succeeded
  bool infer_with(std::size_t sensor, const Statistics& window, const PayloadGaussian<Scalar>& prior,
                  PayloadGaussian<Scalar>& posterior, Scalar& log_evidence) const noexcept;

  Scalar dt_;
  std::vector<SensorModel<Scalar, Dofs>> sensors_;
  std::vector<NuisanceGaussian<Scalar, Dofs>> nuisances_;  // one for each sensor model
  PushPrior push_;
  VariationalInferenceConfig config_;
};

template <typename Scalar, int Dofs>
EventInference<Scalar, Dofs>::EventInference(Scalar dt, const std::vector<SensorModel<Scalar, Dofs>>& sensors,
                                             const PushPrior& push, const VariationalInferenceConfig& config)
    : dt_(dt), sensors_(sensors), nuisances_(sensors.size()), push_(push), config_(config) {
  detail::require(!sensors.empty(), "EstimatorConfig::sensors", "at least one", sensors.size());
  for (const auto& sensor : sensors) {
    sensor.validate();
    detail::require(sensor.noise_correlation_time == sensors.front().noise_correlation_time,
                    "SensorModel::noise_correlation_time", "the same in all sensor models",
                    sensor.noise_correlation_time);
  }
  detail::require(push.force > 0, "PushPrior::force", "> 0 N", push.force);
  detail::require(push.moment > 0, "PushPrior::moment", "> 0 N m", push.moment);
  detail::require(config.max_iterations > 0, "VariationalInferenceConfig::max_iterations", ">= 1",
                  config.max_iterations);
  forget_baseline();
}

template <typename Scalar, int Dofs>
void EventInference<Scalar, Dofs>::forget_baseline() noexcept {
  for (std::size_t k = 0; k < sensors_.size(); ++k) nuisances_[k] = sensors_[k].prior();
}

template <typename Scalar, int Dofs>
void EventInference<Scalar, Dofs>::learn_baseline(const Statistics& quiet) noexcept {
  for (std::size_t k = 0; k < sensors_.size(); ++k) {
    NuisanceGaussian<Scalar, Dofs> posterior;
    const NuisanceGaussian<Scalar, Dofs> prior = sensors_[k].prior();
    const bool known = quiet.nuisance_posterior(sensors_[k].precision(dt_), prior, posterior) == Status::Ok;
    nuisances_[k] = known ? sensors_[k].after_event(posterior) : prior;
  }
}

template <typename Scalar, int Dofs>
bool EventInference<Scalar, Dofs>::infer_with(std::size_t sensor, const Statistics& window,
                                              const PayloadGaussian<Scalar>& prior, PayloadGaussian<Scalar>& posterior,
                                              Scalar& log_evidence) const noexcept {
  PayloadLikelihood<Scalar> likelihood;
  InferenceResult<Scalar> result;
  if (window.likelihood(sensors_[sensor].precision(dt_), nuisances_[sensor], likelihood) != Status::Ok) return false;
  const Status status = infer(likelihood, prior, result, config_);
  if (status != Status::Ok && status != Status::NotConverged) return false;
  posterior = result.posterior;
  log_evidence = result.log_evidence - Scalar(0.5) * likelihood.yy + likelihood.log_factor +
                 sensors_[sensor].log_factor(dt_, window.count());
  return true;
}

template <typename Scalar, int Dofs>
ModelAverage<Scalar> EventInference<Scalar, Dofs>::posterior(const Statistics& window,
                                                             const PayloadGaussian<Scalar>& prior) const noexcept {
  ModelAverage<Scalar> average;
  PayloadGaussian<Scalar> posterior;
  Scalar log_evidence;
  for (std::size_t k = 0; k < sensors_.size(); ++k)
    if (infer_with(k, window, prior, posterior, log_evidence)) average.add(posterior, log_evidence);
  return average;
}

template <typename Scalar, int Dofs>
Verdict<Scalar> EventInference<Scalar, Dofs>::judge(const Statistics& settled, const Statistics& event,
                                                    const PayloadGaussian<Scalar>& prior, const Payload<Scalar>& before,
                                                    const Jacobian<Scalar, Dofs>& jacobian) const noexcept {
  LogSum<Scalar> payload, empty, unchanged, pushed;
  bool judged = false;
  for (std::size_t k = 0; k < sensors_.size(); ++k) {
    const JointVector<Scalar, Dofs> precision = sensors_[k].precision(dt_);
    const Scalar factor = sensors_[k].log_factor(dt_, settled.count());
    PayloadLikelihood<Scalar> likelihood;
    PayloadGaussian<Scalar> posterior;
    Scalar of_event, of_payload, of_push;
    if (settled.likelihood(precision, nuisances_[k], likelihood) != Status::Ok ||
        push_log_evidence(settled, precision, nuisances_[k], before, jacobian, push_, of_push) != Status::Ok ||
        !infer_with(k, settled, prior, posterior, of_payload) || !infer_with(k, event, prior, posterior, of_event))
      continue;
    const Scalar of_empty = factor + payload_log_evidence(likelihood, Payload<Scalar>());
    const Scalar of_unchanged = factor + payload_log_evidence(likelihood, before);
    of_push += factor;
    LogSum<Scalar> all;
    for (const Scalar x : {of_payload, of_empty, of_unchanged, of_push}) all.add(x);
    const Scalar weight = of_event - all.value();
    payload.add(weight + of_payload);
    empty.add(weight + of_empty);
    unchanged.add(weight + of_unchanged);
    pushed.add(weight + of_push);
    judged = true;
  }
  if (!judged) return {Scalar(0), Scalar(0), Scalar(1), Scalar(0)};  // nothing can be said: unchanged
  return {payload.value(), empty.value(), unchanged.value(), pushed.value()};
}

}  // namespace rme
