#pragma once
/// The object that a host owns: fed each tick, it notices a payload, estimates it and says what torque carries it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <rme/control/compensation.hpp>
#include <rme/core/payload.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/estimate.hpp>
#include <rme/event_estimator_config.hpp>
#include <rme/event_samples.hpp>
#include <rme/inference/event_inference.hpp>
#include <rme/inference/fixed_prior.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/inference/payload_statistics.hpp>
#include <rme/sensing/mismatch_detector.hpp>
#include <rme/sensing/onset.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/sensing/sample_window.hpp>

namespace rme {

/// Watches, collects, estimates, compensates (paper, Figure 2). One per arm.
///
///     EventEstimator<double, 7> estimator(0.001);                        // may throw: before the loop
///     estimator.update({tau_ext, jacobian, rotation, dq});          // each tick
///     tau_command += estimator.compensation(jacobian, rotation);
///
/// Each event is estimated from all samples since its onset, and always as the total payload: adding an object,
/// removing it, and returning to an empty hand are the same event to it. While nothing is in the hand, the quiet window
/// before the event tells the sensor's offset; later events reuse it.
///
/// While a change settles and is collected, early estimates refresh every few milliseconds, and compensation() follows
/// them as far as they can be trusted. One final estimate, or a rejection, ends the event.
///
/// Real time: no call but the constructor allocates or throws. update() is O(Dofs) on most ticks; one that makes an
/// estimate runs the inference, whose cost does not depend on the length of the window. The tick that notices a change,
/// and those that place its onset anew, pass over at most the detector's window.
/// @tparam PriorSource  callable (const SampleWindow&, size_t count) -> PayloadGaussian, noexcept. count: newest
///                      samples collected since the change settled; fewer than all while an estimate is early. On the
///                      tick before the collection is complete it is asked once in vain
template <typename Scalar, int Dofs, typename PriorSource = FixedPrior<Scalar>>
class EventEstimator {
 public:
  using Config = EventEstimatorConfig<Scalar, Dofs>;
  using Torque = JointVector<Scalar, Dofs>;

  /// @param dt  control period [s], > 0
  /// @throws std::invalid_argument naming the field out of range
  explicit EventEstimator(double dt, const Config& config = Config(), const PriorSource& prior = PriorSource());

  /// Advances by one period.
  /// @return Ok; NonFiniteInput or NotARotation: the estimator is then as it was, and the tick does not count
  Status update(const Proprioception<Scalar, Dofs>& sample) noexcept;

  /// Says that the payload changes now: collecting starts at the next sample, whatever the detector thinks. For hosts
  /// that know when the gripper closes. If the weight comes later in the collection, what was before it is left out.
  void trigger() noexcept;
  /// Says that the hand has been empty for the last `duration` seconds: what the sensor showed is the baseline of all
  /// events to come, and no other is learned. Without samples, or for a duration that is not > 0, it says nothing.
  void tare(double duration) noexcept;

  Phase phase() const noexcept { return phase_; }
  /// The latest estimate, early ones included; an empty hand before the first.
  const Estimate<Scalar>& estimate() const noexcept { return latest_; }
  /// True on the tick that made a final estimate.
  bool estimated() const noexcept { return phase_ == Phase::Estimating; }
  /// True on the tick that made an early one.
  bool refreshed() const noexcept { return refreshed_; }
  /// True on the tick that found a change to be no payload: estimate() is the final one of the event before.
  bool rejected() const noexcept { return rejected_; }
  /// When the last collection began [s].
  double detected_at() const noexcept { return detected_at_; }
  /// What the window of the last estimate, or of the last attempt at one, was judged to be.
  const Verdict<Scalar>& verdict() const noexcept { return verdict_; }
  /// tau_comp = -J^T w(payload) [N m]; zero for an empty hand. While an estimate is early, its confidence's share of
  /// the way from the payload before to the new one. Pass it through a CompensationRamp. For a pose that is not
  /// plausible (plausible.hpp) it is that of the last good sample's pose.
  Torque compensation(const Jacobian<Scalar, Dofs>& jacobian, const Matrix3<Scalar>& rotation) const noexcept;
  /// Seconds since construction or reset.
  double time() const noexcept { return static_cast<double>(ticks_) * dt_; }
  const MismatchDetector<Dofs>& detector() const noexcept { return detector_; }
  const Config& config() const noexcept { return config_; }
  /// An empty hand and no past.
  void reset() noexcept;

 private:
  using Statistics = PayloadStatistics<Scalar, Dofs>;
  using Signal = Eigen::Matrix<double, Dofs, 1>;
  static constexpr int kMaxRestarts = 5;
  /// Centres of mass that are nearer to each other make the same sums [m]: what the model of one leaves out at the
  /// other is the inertia torque of this squared, 4e-6 N m for 1 kg at 1 rad/s^2.
  static constexpr double kSameCom = 0.002;

  // An arm of which it is not known whether its friction shows is taken for one whose friction does: to a sensor model
  // without friction the direction says nothing.
  static Torque largest_friction(const Config& config) noexcept {
    Torque largest = Torque::Zero();
    for (const auto& sensor : config.sensors) largest = largest.cwiseMax(sensor.coulomb_mean);
    return largest;
  }
  std::size_t ticks_of(double seconds) const noexcept { return static_cast<std::size_t>(std::lround(seconds / dt_)); }
  double time_of(std::uint64_t tick) const noexcept { return static_cast<double>(tick) * dt_; }
  Phase resting_phase() const noexcept { return known_.empty ? Phase::Watching : Phase::Compensating; }
  bool refresh_due(std::uint64_t since) const noexcept {
    return config_.refresh > 0 && since > 0 && since % ticks_of(config_.refresh) == 0;
  }
  Signal watched(std::size_t age) const noexcept;
  Signal level(std::size_t newest) const noexcept;

  void watch() noexcept;
  void begin_change() noexcept;
  void remember_quiet(std::size_t quiet_age) noexcept;
  void learn_baseline(std::size_t newest, std::size_t count) noexcept;
  void locate_onset() noexcept;
  void begin_collection(bool triggered) noexcept;
  void collect() noexcept;
  void forget_event() noexcept;
  void make_early_estimate() noexcept;
  void make_estimate() noexcept;
  void store(Estimate<Scalar>& estimate, const PayloadGaussian<Scalar>& posterior, bool empty, bool final) noexcept;

  Config config_;
  PriorSource prior_;
  double dt_;
  MismatchDetector<Dofs> detector_;
  SampleWindow<Scalar, Dofs> window_;
  EventInference<Scalar, Dofs> inference_;
  EventSamples<Scalar, Dofs> event_;
  Phase phase_ = Phase::Watching;
  std::uint64_t ticks_ = 0;
  Estimate<Scalar> known_;   // the last final one: what was in the hand before the event
  Estimate<Scalar> latest_;  // the same between events, an early one within
  Verdict<Scalar> verdict_;
  bool refreshed_ = false, rejected_ = false;
  bool tared_ = false;
  bool pushed_ = false;  // the last change was a push: what follows it is no baseline

  // The event that is going on.
  bool changing_ = false;                 // a change has begun; it may not have settled yet
  std::uint64_t change_tick_ = 0;         // when it began, roughly
  Signal level_before_ = Signal::Zero();  // of the watched signal, before it
  double noticed_at_ = 0, detected_at_ = 0;
  bool triggered_ = false;               // by the host, not by the detector
  Unrest<Scalar, Dofs> unrest_;          // of the collection
  std::size_t collected_ = 0;            // samples since the collection began
  int restarts_ = 0;                     // of this collection
  PayloadGaussian<Scalar> event_prior_;  // a member, or what is asked in vain might be optimised away
  std::size_t steady_ = 0;               // ticks for which early estimates have looked like a payload
};

template <typename Scalar, int Dofs, typename PriorSource>
EventEstimator<Scalar, Dofs, PriorSource>::EventEstimator(double dt, const Config& config, const PriorSource& prior)
    : config_((config.validate(dt), config)),
      prior_(prior),
      dt_(dt),
      detector_(dt, config.detector),
      window_(dt, config.window, largest_friction(config)),
      inference_(Scalar(dt), config.sensors, config.push, config.inference, config.learn_noise),
      event_(dt, config),
      unrest_(ticks_of(config.collection)) {}

template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::reset() noexcept {
  detector_.reset();
  window_.reset();
  inference_.forget_baseline();
  forget_event();
  phase_ = Phase::Watching;
  ticks_ = 0;
  known_ = latest_ = Estimate<Scalar>();
  verdict_ = Verdict<Scalar>();
  detected_at_ = noticed_at_ = 0;
  refreshed_ = rejected_ = tared_ = pushed_ = false;
}

template <typename Scalar, int Dofs, typename PriorSource>
auto EventEstimator<Scalar, Dofs, PriorSource>::compensation(const Jacobian<Scalar, Dofs>& jacobian,
                                                             const Matrix3<Scalar>& rotation) const noexcept -> Torque {
  if (!plausible(jacobian) || !plausible(rotation)) {
    if (window_.size() == 0) return Torque::Zero();
    const Proprioception<Scalar, Dofs>& last = window_.newest().raw;
    return compensation(last.jacobian, last.rotation);
  }
  const auto torque = [&](const Estimate<Scalar>& estimate) {
    return compensation_torque<Scalar, Dofs>(estimate.payload(), jacobian, rotation, config_.gravity);
  };
  Torque latest = torque(latest_);
  if (latest_.final) return latest;
  const Torque known = torque(known_);
  return known + latest_.confidence * (latest - known);
}

template <typename Scalar, int Dofs, typename PriorSource>
Status EventEstimator<Scalar, Dofs, PriorSource>::update(const Proprioception<Scalar, Dofs>& in) noexcept {
  Proprioception<Scalar, Dofs> sample = in;
  sample.tau_ext *= Scalar(static_cast<int>(config_.torque_sign));
  const Status status = window_.push(sample, !(changing_ && latest_.final));  // a change that no estimate explains yet
  if (status != Status::Ok) return status;
  ++ticks_;
  if (phase_ == Phase::Estimating) phase_ = resting_phase();
  refreshed_ = rejected_ = false;
  if (phase_ == Phase::Collecting)
    collect();
  else
    watch();
  return Status::Ok;
}

template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::watch() noexcept {
  if (detector_.update(watched(0)) != Status::Ok) return;
  if (detector_.rapid_change() && !changing_) begin_change();
  if (!changing_) return;
  // It does not settle: what was long ago counts no more.
  if (ticks_ - change_tick_ > window_.capacity()) event_.forget_onset();
  event_.add(window_.newest(), ticks_);
  if (refresh_due(ticks_ - change_tick_)) {
    locate_onset();
    make_early_estimate();
  }
  if (!detector_.stabilised()) return;
  // A compliant arm sags under a heavy payload for longer than the detector looks back: the level before the change is
  // then what counts.
  if (detector_.rapid_change() || (level(0) - level_before_).norm() > config_.detector.activation_threshold) {
    begin_collection(false);
  } else {
    forget_event();  // all is as it was
    latest_ = known_;
  }
}

/// A change has begun.
template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::begin_change() noexcept {
  const std::size_t span = ticks_of(config_.onset_span), window = ticks_of(config_.detector.window);
  const Onset<Scalar> onset = find_onset(window_, window + 2 * span, span);
  // Before the first baseline can be learned, an arm that starts to move looks like one that is handed something.
  const bool sharp = event_.is_onset(onset);
  if (!sharp && time() < config_.detector.window + config_.baseline + config_.baseline_guard) return;
  forget_event();
  changing_ = true;
  noticed_at_ = time();
  change_tick_ = ticks_ - (sharp ? onset.age : 0);
  remember_quiet(sharp ? onset.age + 1 : window);
}

/// Learns from the quiet past, whose newest sample that is sure to be quiet has this age.
template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::remember_quiet(std::size_t quiet_age) noexcept {
  quiet_age += ticks_of(config_.baseline_guard);
  level_before_ = level(quiet_age);
  if (known_.empty && !tared_ && !pushed_) learn_baseline(quiet_age, ticks_of(config_.baseline));
}

/// Mean of the watched signal over the span whose newest sample has this age.
template <typename Scalar, int Dofs, typename PriorSource>
auto EventEstimator<Scalar, Dofs, PriorSource>::level(std::size_t newest) const noexcept -> Signal {
  const std::size_t count = std::max<std::size_t>(1, ticks_of(config_.detector.check_average));
  Signal sum = Signal::Zero();
  for (std::size_t i = 0; i < count; ++i) sum += watched(std::min(newest + i, window_.size() - 1));
  return sum / static_cast<double>(count);
}

/// The signal in which changes are looked for, `age` ticks ago. When a loaded arm moves its torque changes without any
/// event, and when compensation sets in it is the payload's inertia that shows, so the known payload's share is taken
/// off.
template <typename Scalar, int Dofs, typename PriorSource>
auto EventEstimator<Scalar, Dofs, PriorSource>::watched(std::size_t age) const noexcept -> Signal {
  const Sample<Scalar, Dofs>& sample = window_.newest(age);
  if (config_.watch_norm)  // in one channel; the others stay zero
    return Signal::Unit(0) * static_cast<double>(sample.raw.tau_ext.norm());
  if (known_.empty) return sample.tau.template cast<double>();
  return (sample.tau - event_.regressor(sample).torque(known_.payload())).template cast<double>();
}

template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::trigger() noexcept {
  begin_collection(true);
}

template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::tare(double duration) noexcept {
  if (!(duration > 0)) return;
  const std::size_t count = ticks_of(std::min(duration, config_.window.duration));
  if (count == 0 || window_.size() == 0) return;
  learn_baseline(0, count);
  tared_ = true;
}

/// The nuisances of the coming event, from `count` samples of an empty hand, the newest of them of age `newest`.
template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::learn_baseline(std::size_t newest, std::size_t count) noexcept {
  if (count == 0 || window_.size() <= newest) {
    inference_.forget_baseline();
    return;
  }
  inference_.learn_baseline(event_.quiet_sums(window_, newest, count).about(Vector3<Scalar>::Zero()));
}

/// Nothing is going on.
template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::forget_event() noexcept {
  changing_ = triggered_ = false;
  steady_ = 0;
  event_.clear();
}

/// Looks for the instant of the change among the samples since it began, or since the host said so.
template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::locate_onset() noexcept {
  if (triggered_) {
    event_.locate(window_, ticks_, collected_);
    return;
  }
  const std::size_t since = static_cast<std::size_t>(ticks_ - change_tick_);
  if (since > ticks_of(config_.detector.window)) return;
  if (!event_.locate(window_, ticks_, since + 8 * ticks_of(config_.onset_span))) event_.forget_onset();
}

template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::begin_collection(bool triggered) noexcept {
  // The baseline of a collection that the host interrupts, or of a change that has been seen to begin, is from before
  // the change; a new one might not be.
  if (triggered) {
    if (phase_ != Phase::Collecting && !changing_) remember_quiet(0);
    forget_event();
    noticed_at_ = time();
  }
  triggered_ = triggered;
  phase_ = Phase::Collecting;
  collected_ = 0;
  unrest_.clear();
  restarts_ = 0;
  detected_at_ = time();
  if (!triggered) locate_onset();
}

template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::collect() noexcept {
  event_.add_settled(window_.newest(), ticks_);
  unrest_.add(window_.newest().tau);
  const std::size_t count = ticks_of(config_.collection);
  // A network's weights and code have left the cache since the last event. Asked in vain now, when there is time, it
  // answers sooner on the tick that everybody waits for.
  if (collected_ + 2 == count) event_prior_ = prior_(window_, std::min(count, window_.size()));
  if (++collected_ >= count) {
    if (triggered_) locate_onset();  // the weight may have come after the trigger
    make_estimate();
  } else if (refresh_due(collected_)) {
    if (triggered_) locate_onset();
    make_early_estimate();
  }
}

/// What can be said before the event is over. While the weight is still coming, or a hand is still getting hold, only
/// the newest samples count, and they must have looked like a payload's for as long again: a push that grows is neither
/// a payload nor a constant push, and now and then looks like the one rather than the other.
template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::make_early_estimate() noexcept {
  const PayloadGaussian<Scalar> prior = prior_(window_, event_.settled_count());
  const Vector3<Scalar> com_guess = (latest_.final ? prior : latest_.posterior).mean.template tail<3>();
  const auto gentle = ticks_of(config_.gentle_window);
  const bool sharp = event_.onset_known() || triggered_ || event_.settled_count() >= gentle;
  const Statistics sums = sharp ? event_.about(com_guess).all : event_.sums(window_, 0, gentle).about(com_guess);
  if (static_cast<std::size_t>(sums.count()) < ticks_of(config_.early_window)) return;
  ModelAverage<Scalar> average;
  verdict_ = inference_.judge(sums, sums, prior, known_.payload(), window_.newest().raw.jacobian, average);
  const bool likely = !average.empty() && verdict_.log_odds() > static_cast<Scalar>(config_.early_odds) &&
                      verdict_.excess < static_cast<Scalar>(config_.early_excess) &&
                      (verdict_.is_empty() || average.moments().mean[0] > 0);
  steady_ = likely ? steady_ + ticks_of(config_.refresh) : 0;
  if (average.empty() || verdict_.log_odds() < 0) {
    latest_ = known_;
  } else if (likely && (sharp || steady_ >= gentle || !latest_.final)) {  // one of this event was believed: go on
    using std::exp;
    store(latest_, average.moments(), verdict_.is_empty(), false);
    latest_.window_begin = time() - static_cast<double>(sums.count()) * dt_;
    latest_.confidence = 1 / (1 + exp(-verdict_.log_odds()));
    const Scalar mass = latest_.posterior.mean[0];
    if (!latest_.empty) latest_.confidence *= mass * mass / (mass * mass + latest_.posterior.covariance(0, 0));
    refreshed_ = true;
  }
}

template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::make_estimate() noexcept {
  if (!triggered_ && restarts_ < kMaxRestarts && unrest_.value() > Scalar(config_.unrest)) {
    ++restarts_;  // something else happens meanwhile: wait until it is over
    forget_event();
    changing_ = true;
    collected_ = 0;
    unrest_.clear();
    return;
  }
  event_prior_ = prior_(window_, event_.settled_count());
  const PayloadGaussian<Scalar>& prior = event_prior_;
  const Vector3<Scalar> com_guess = (latest_.final ? prior : latest_.posterior).mean.template tail<3>();
  detector_.reset();
  phase_ = resting_phase();  // unless an estimate is made

  // Payload or push is judged by the samples after the change has settled. The estimate is made from all of them, and
  // once more about the centre of mass found if that is another.
  const typename EventSamples<Scalar, Dofs>::Sums event = event_.about(com_guess);
  ModelAverage<Scalar> average;
  verdict_ = inference_.judge(triggered_ ? event.all : event.settled, event.all, prior, known_.payload(),
                              window_.newest().raw.jacobian, average);
  const bool accepted = (triggered_ || verdict_.log_odds() > static_cast<Scalar>(config_.odds)) && !average.empty();
  if (accepted) {
    const Vector3<Scalar> com = average.moments().mean.template tail<3>();
    if (!((com - com_guess).norm() < Scalar(kSameCom))) average = inference_.posterior(event_.about(com).all, prior);
  }
  if (accepted && !average.empty()) {
    pushed_ = false;
    store(known_, average.moments(), verdict_.is_empty(), true);
    known_.window_begin = time_of(event_.first_tick()) - dt_;
    phase_ = Phase::Estimating;
  } else {
    rejected_ = true;
    const bool push = verdict_.push > verdict_.unchanged;
    // One push after the other, and never the old state in between: what is known of the offset may be what is wrong.
    if (push && pushed_ && !tared_) inference_.forget_baseline();
    pushed_ = push;
  }
  latest_ = known_;
  forget_event();
}

template <typename Scalar, int Dofs, typename PriorSource>
void EventEstimator<Scalar, Dofs, PriorSource>::store(Estimate<Scalar>& estimate,
                                                      const PayloadGaussian<Scalar>& posterior, bool empty,
                                                      bool final) noexcept {
  estimate.posterior = posterior;
  if (empty) {  // what the mean is moved by counts as doubt
    const Vector4<Scalar> mean = posterior.mean;
    estimate.posterior.covariance += mean * mean.transpose();
    estimate.posterior.mean.setZero();
  }
  estimate.empty = empty;
  estimate.final = final;
  estimate.confidence = Scalar(1);
  estimate.detected_at = final ? detected_at_ : noticed_at_;
  estimate.window_end = time();
}

}  // namespace rme
