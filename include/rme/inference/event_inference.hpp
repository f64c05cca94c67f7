#pragma once
/// Everything that a window says about what is in the hand, whichever of several sensor models the arm follows.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/payload.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/evidence.hpp>
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
  /// Mean square of what the payload's posterior leaves of the event, in units of the likeliest sensor model's noise,
  /// but at least 1. Far above that, the arm does what no model says.
  Scalar excess = Scalar(1);

  /// The payload changed, to another one or to none.
  bool is_payload() const noexcept { return std::max(payload, empty) > std::max(unchanged, push); }
  bool is_empty() const noexcept { return empty >= payload; }
  /// Log odds that the payload changed [nats].
  Scalar log_odds() const noexcept { return std::max(payload, empty) - std::max(unchanged, push); }
};

/// Holds the sensor models and, for each, what is known of the nuisances; answers questions about PayloadStatistics.
/// Where the models disagree, the one that predicts the window better counts for more, in proportion to its evidence:
/// an arm whose friction shows is told from one whose friction does not by the data, event by event. A window that is
/// noisier than the likeliest model says, as of an arm in fast motion, raises the noise of all to what it shows, by the
/// same factor in all joints; it never lowers it. Real time: no call but the constructor allocates or throws; each
/// costs one to three inferences (of three microseconds or so) per model.
template <typename Scalar, int Dofs>
class EventInference {
 public:
  using Statistics = PayloadStatistics<Scalar, Dofs>;
  static constexpr std::size_t kMaxSensors = 4;

  /// @param sensors      one to kMaxSensors
  /// @param learn_noise  whether a noisier window raises the noise
  /// @throws std::invalid_argument naming the field out of range
  EventInference(Scalar dt, const std::vector<SensorModel<Scalar, Dofs>>& sensors, const PushPrior& push,
                 const VariationalInferenceConfig& config, bool learn_noise = true);

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
  /// @param[out] posterior  of the payload given the whole event, as from posterior(); what it held is lost
  Verdict<Scalar> judge(const Statistics& settled, const Statistics& event, const PayloadGaussian<Scalar>& prior,
                        const Payload<Scalar>& before, const Jacobian<Scalar, Dofs>& jacobian,
                        ModelAverage<Scalar>& posterior) const noexcept;
  /// The same where the settled samples are all there is.
  Verdict<Scalar> judge(const Statistics& settled, const PayloadGaussian<Scalar>& prior, const Payload<Scalar>& before,
                        const Jacobian<Scalar, Dofs>& jacobian) const noexcept {
    ModelAverage<Scalar> posterior;
    return judge(settled, settled, prior, before, jacobian, posterior);
  }

 private:
  struct Inferred {
    PayloadGaussian<Scalar> posterior;
    Scalar log_evidence = Scalar(0), misfit = Scalar(0);
    bool valid = false;
  };
  /// What each sensor model makes of a window, if the noise's variance is `excess` times what it says.
  /// @param nearby  what it makes of nearly the same data, to start from if valid
  using All = std::array<Inferred, kMaxSensors>;
  Inferred infer_with(std::size_t sensor, Scalar excess, const Statistics& window, const PayloadGaussian<Scalar>& prior,
                      const Inferred& nearby) const noexcept;
  /// The same from the likelihood of a window of `count` samples.
  Inferred infer_from(const PayloadLikelihood<Scalar>& likelihood, std::size_t sensor, Scalar excess, int count,
                      const PayloadGaussian<Scalar>& prior, const Inferred& nearby) const noexcept;
  /// The same with the excess, at least 1, that the likeliest model shows.
  All infer_all(const Statistics& window, const PayloadGaussian<Scalar>& prior, Scalar& excess) const noexcept;
  /// Of the noise, in a log evidence.
  Scalar log_factor(std::size_t sensor, Scalar excess, int count) const noexcept {
    using std::log;
    const SensorModel<Scalar, Dofs>& model = sensors_[sensor];
    return model.log_factor(dt_, count) - Scalar(0.5 * Dofs) * model.independent_samples(dt_, count) * log(excess);
  }

  Scalar dt_;
  std::vector<SensorModel<Scalar, Dofs>> sensors_;
  std::vector<NuisanceGaussian<Scalar, Dofs>> nuisances_;  // one for each sensor model
  PushPrior push_;
  VariationalInferenceConfig config_;
  bool learn_noise_;
};

template <typename Scalar, int Dofs>
EventInference<Scalar, Dofs>::EventInference(Scalar dt, const std::vector<SensorModel<Scalar, Dofs>>& sensors,
                                             const PushPrior& push, const VariationalInferenceConfig& config,
                                             bool learn_noise)
    : dt_(dt), sensors_(sensors), nuisances_(sensors.size()), push_(push), config_(config), learn_noise_(learn_noise) {
  detail::require(!sensors.empty() && sensors.size() <= kMaxSensors, "EventEstimatorConfig::sensors", "one to four",
                  sensors.size());
  for (const auto& sensor : sensors) {
    sensor.validate();
    detail::require(sensor.noise_correlation_time == sensors.front().noise_correlation_time,
                    "SensorModel::noise_correlation_time", "the same in all sensor models",
                    sensor.noise_correlation_time);
  }
  detail::require_positive(push.force, "PushPrior::force", "> 0 N");
  detail::require_positive(push.moment, "PushPrior::moment", "> 0 N m");
  detail::require(config.max_iterations > 0, "VariationalInferenceConfig::max_iterations", ">= 1",
                  config.max_iterations);
  detail::require_positive(config.tolerance, "VariationalInferenceConfig::tolerance", "> 0");
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
auto EventInference<Scalar, Dofs>::infer_with(std::size_t sensor, Scalar excess, const Statistics& window,
                                              const PayloadGaussian<Scalar>& prior,
                                              const Inferred& nearby) const noexcept -> Inferred {
  PayloadLikelihood<Scalar> likelihood;
  const JointVector<Scalar, Dofs> precision = sensors_[sensor].precision(dt_) / excess;
  if (window.likelihood(precision, nuisances_[sensor], likelihood) != Status::Ok) return Inferred();
  return infer_from(likelihood, sensor, excess, window.count(), prior, nearby);
}

template <typename Scalar, int Dofs>
auto EventInference<Scalar, Dofs>::infer_from(const PayloadLikelihood<Scalar>& likelihood, std::size_t sensor,
                                              Scalar excess, int count, const PayloadGaussian<Scalar>& prior,
                                              const Inferred& nearby) const noexcept -> Inferred {
  Inferred out;
  InferenceResult<Scalar> result;
  const Status status = infer(likelihood, prior, result, config_, nearby.valid ? &nearby.posterior.mean : nullptr);
  out.valid = status == Status::Ok || status == Status::NotConverged;
  if (!out.valid) return out;
  out.posterior = result.posterior;
  out.log_evidence =
      result.log_evidence - Scalar(0.5) * likelihood.yy + likelihood.log_factor + log_factor(sensor, excess, count);
  out.misfit =
      -2 * likelihood.log_likelihood(out.posterior.mean) / (Dofs * sensors_[sensor].independent_samples(dt_, count));
  return out;
}

template <typename Scalar, int Dofs>
auto EventInference<Scalar, Dofs>::infer_all(const Statistics& window, const PayloadGaussian<Scalar>& prior,
                                             Scalar& excess) const noexcept -> All {
  All all;
  excess = Scalar(1);
  const Inferred* best = nullptr;
  for (std::size_t k = 0; k < sensors_.size(); ++k) {
    all[k] = infer_with(k, excess, window, prior, Inferred());
    if (all[k].valid && (best == nullptr || all[k].log_evidence > best->log_evidence)) best = &all[k];
  }
  if (!learn_noise_ || best == nullptr || !(best->misfit > 1)) return all;
  excess = best->misfit;
  for (std::size_t k = 0; k < sensors_.size(); ++k) all[k] = infer_with(k, excess, window, prior, all[k]);
  return all;
}

template <typename Scalar, int Dofs>
ModelAverage<Scalar> EventInference<Scalar, Dofs>::posterior(const Statistics& window,
                                                             const PayloadGaussian<Scalar>& prior) const noexcept {
  ModelAverage<Scalar> average;
  Scalar excess;
  for (const Inferred& inferred : infer_all(window, prior, excess))
    if (inferred.valid) average.add(inferred.posterior, inferred.log_evidence);
  return average;
}

template <typename Scalar, int Dofs>
Verdict<Scalar> EventInference<Scalar, Dofs>::judge(const Statistics& settled, const Statistics& event,
                                                    const PayloadGaussian<Scalar>& prior, const Payload<Scalar>& before,
                                                    const Jacobian<Scalar, Dofs>& jacobian,
                                                    ModelAverage<Scalar>& posterior) const noexcept {
  LogSum<Scalar> payload, empty, unchanged, pushed;
  posterior = ModelAverage<Scalar>();
  Scalar excess;
  const All of_event = infer_all(event, prior, excess);
  for (std::size_t k = 0; k < sensors_.size(); ++k) {
    if (!of_event[k].valid) continue;
    const JointVector<Scalar, Dofs> precision = sensors_[k].precision(dt_) / excess;
    typename Statistics::Marginals joints;
    Scalar of_push;
    if (settled.marginals(precision, nuisances_[k], joints) != Status::Ok ||
        push_log_evidence<Scalar, Dofs>(joints, before, jacobian, push_, of_push) != Status::Ok)
      continue;
    const PayloadLikelihood<Scalar> likelihood = Statistics::likelihood(joints);
    const Inferred of_payload =
        &settled == &event ? of_event[k] : infer_from(likelihood, k, excess, settled.count(), prior, of_event[k]);
    if (!of_payload.valid) continue;
    posterior.add(of_event[k].posterior, of_event[k].log_evidence);
    const Scalar factor = log_factor(k, excess, settled.count());
    const Scalar of_empty = factor + payload_log_evidence(likelihood, Payload<Scalar>());
    const Scalar of_unchanged = factor + payload_log_evidence(likelihood, before);
    of_push += factor;
    LogSum<Scalar> all;
    for (const Scalar x : {of_payload.log_evidence, of_empty, of_unchanged, of_push}) all.add(x);
    const Scalar weight = of_event[k].log_evidence - all.value();
    payload.add(weight + of_payload.log_evidence);
    empty.add(weight + of_empty);
    unchanged.add(weight + of_unchanged);
    pushed.add(weight + of_push);
  }
  if (posterior.empty()) return {Scalar(0), Scalar(0), Scalar(1), Scalar(0), Scalar(1)};  // nothing can be said
  return {payload.value(), empty.value(), unchanged.value(), pushed.value(), excess};
}

}  // namespace rme
