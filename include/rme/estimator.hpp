#pragma once
/// The object that a host owns: fed each tick, it notices a payload, estimates it and says what torque carries it.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <rme/control/compensation.hpp>
#include <rme/core/payload.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/event_inference.hpp>
#include <rme/inference/fixed_prior.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/inference/payload_statistics.hpp>
#include <rme/inference/sensor_model.hpp>
#include <rme/inference/variational_inference.hpp>
#include <rme/sensing/mismatch_detector.hpp>
#include <rme/sensing/onset.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/sensing/sample_window.hpp>
#include <vector>

namespace rme {

/// Where an Estimator is in its life cycle: Watching -> Collecting -> Estimating -> Compensating or Watching again.
enum class Phase : std::uint8_t {
  Watching,      ///< the hand is empty; waits for a change
  Collecting,    ///< a change was noticed; gathers samples
  Estimating,    ///< this tick has made an estimate
  Compensating,  ///< something is in the hand; waits for the next change
};

constexpr const char* to_string(Phase phase) noexcept {
  switch (phase) {
    case Phase::Watching:
      return "Watching";
    case Phase::Collecting:
      return "Collecting";
    case Phase::Estimating:
      return "Estimating";
    case Phase::Compensating:
      return "Compensating";
  }
  return "unknown";
}

/// Which torque the arm reports as external.
enum class TorqueSign : std::int8_t {
  External = 1,   ///< what the environment exerts on the arm (the convention of rme)
  Reaction = -1,  ///< what the arm exerts on the environment
};

/// Settings of Estimator; the defaults suit a seven-joint arm of the Panda's size at any rate. docs/tuning.md
template <typename Scalar, int Dofs>
struct EstimatorConfig {
  Vector3<Scalar> gravity = standard_gravity<Scalar>();  ///< g [m/s^2], world axes
  TorqueSign torque_sign = TorqueSign::External;
  MismatchDetectorConfig detector;
  /// Watch the norm of tau_ext, as published, in place of every joint's torque less the known payload's.
  bool watch_norm = false;
  SampleWindowConfig window;
  /// What the arm's torque sensing is like; several are averaged by their evidence, event by event. At least one.
  std::vector<SensorModel<Scalar, Dofs>> sensors = {SensorModel<Scalar, Dofs>::link_side(),
                                                    SensorModel<Scalar, Dofs>::joint_friction()};
  double collection = 0.2;        ///< how long samples are gathered after the detection [s], > 0
  double baseline = 0.3;          ///< length of the quiet window before the change [s], >= 0; 0 uses none
  double baseline_guard = 0.02;   ///< between the quiet window and the change [s], >= 0
  double onset_span = 0.01;       ///< of the means whose difference finds the instant of the change [s], > 0
  double onset_jump = 0.4;        ///< a smaller step is no onset [N m], > 0
  double onset_guard = 0.04;      ///< after the change: samples left out while the observer catches up [s], >= 0
  double unrest = 0.8;            ///< a collection in which the torque changes by more starts again [N m], > 0
  double gyration_radius = 0.03;  ///< of a payload about its own centre of mass, roughly [m], >= 0
  PushPrior push;                 ///< what a change may be that is no payload
  VariationalInferenceConfig inference;

  /// @throws std::invalid_argument naming the field out of range
  void validate(double dt) const;
};

/// An estimate and where it comes from. Times count from the estimator's construction or reset [s].
template <typename Scalar>
struct Estimate {
  PayloadGaussian<Scalar> posterior;  ///< of everything in the hand, not of what was added last
  bool empty = true;                  ///< nothing in the hand, as far as the torque can tell: the mean is then zero
  double detected_at = 0;
  double window_begin = 0, window_end = 0;  ///< of the samples used

  /// What to compensate for: the posterior's mean, or nothing for an empty hand.
  Payload<Scalar> payload() const noexcept { return empty ? Payload<Scalar>() : posterior.payload(); }
};

/// Watches, collects, estimates, compensates (paper, Figure 2). One per arm.
///
///     Estimator<double, 7> estimator(0.001);                        // may throw: before the loop
///     estimator.update({tau_ext, jacobian, rotation, dq});          // each tick
///     tau_command += estimator.compensation(jacobian, rotation);
///
/// Each event is estimated from all samples since its onset, and always as the total payload: adding an object,
/// removing it, and returning to an empty hand are the same event to it. While nothing is in the hand, the quiet window
/// before the event tells the sensor's offset; later events reuse it.
///
/// Real time: no call but the constructor allocates or throws. update() is O(Dofs) while watching and collecting; on
/// the tick that completes a collection it passes at most twice over the samples since the onset, then runs the
/// inference.
/// @tparam PriorSource  callable (const SampleWindow&, size_t count) -> PayloadGaussian, noexcept
template <typename Scalar, int Dofs, typename PriorSource = FixedPrior<Scalar>>
class Estimator {
 public:
  using Config = EstimatorConfig<Scalar, Dofs>;
  using Torque = JointVector<Scalar, Dofs>;

  /// @param dt  control period [s], > 0
  /// @throws std::invalid_argument naming the field out of range
  explicit Estimator(double dt, const Config& config = Config(), const PriorSource& prior = PriorSource());

  /// Advances by one period.
  /// @return Ok; NonFiniteInput or NotARotation: the estimator is then as it was, and the tick does not count
  Status update(const Proprioception<Scalar, Dofs>& sample) noexcept;

  /// Says that the payload changes now: collecting starts at the next sample, whatever the detector thinks. For hosts
  /// that know when the gripper closes. If the weight comes later in the collection, what was before it is left out.
  void trigger() noexcept;
  /// Says that the hand has been empty for the last `duration` seconds: what the sensor showed is the baseline of all
  /// events to come, and no other is learned.
  void tare(double duration) noexcept;

  Phase phase() const noexcept { return phase_; }
  /// The latest estimate; an empty hand before the first.
  const Estimate<Scalar>& estimate() const noexcept { return estimate_; }
  /// True on the tick that made an estimate.
  bool estimated() const noexcept { return phase_ == Phase::Estimating; }
  /// True on the tick that found a change to be no payload: estimate() is still the one before.
  bool rejected() const noexcept { return rejected_; }
  /// When the last collection began [s].
  double detected_at() const noexcept { return detected_at_; }
  /// What the last collection was judged to be.
  const Verdict<Scalar>& verdict() const noexcept { return verdict_; }
  /// tau_comp = -J^T w(payload) [N m]; zero for an empty hand. Pass it through a CompensationRamp.
  Torque compensation(const Jacobian<Scalar, Dofs>& jacobian, const Matrix3<Scalar>& rotation) const noexcept {
    return compensation_torque<Scalar, Dofs>(estimate_.payload(), jacobian, rotation, config_.gravity);
  }
  /// Seconds since construction or reset.
  double time() const noexcept { return static_cast<double>(ticks_) * dt_; }
  const MismatchDetector<Dofs>& detector() const noexcept { return detector_; }
  const Config& config() const noexcept { return config_; }
  /// An empty hand and no past.
  void reset() noexcept;

 private:
  using Statistics = PayloadStatistics<Scalar, Dofs>;

  std::size_t ticks_of(double seconds) const noexcept { return static_cast<std::size_t>(std::lround(seconds / dt_)); }
  double time_of(std::size_t age) const noexcept { return time() - static_cast<double>(age) * dt_; }
  bool is_onset(const Onset<Scalar>& onset) const noexcept {
    return onset.sharp() && onset.jump > static_cast<Scalar>(config_.onset_jump);
  }
  using Signal = Eigen::Matrix<double, Dofs, 1>;
  Signal watched(std::size_t age) const noexcept;
  Signal level(std::size_t newest) const noexcept;
  bool changed() noexcept;
  void remember_quiet(std::size_t quiet_age) noexcept;
  PayloadRegressor<Scalar, Dofs> regressor(const Sample<Scalar, Dofs>& sample,
                                           const Vector3<Scalar>& com) const noexcept {
    return payload_regressor<Scalar, Dofs>(sample.raw.jacobian, sample.raw.rotation, config_.gravity, sample.motion,
                                           com, static_cast<Scalar>(config_.gyration_radius));
  }
  void begin_collection(bool triggered) noexcept;
  void learn_baseline(std::size_t newest, std::size_t count) noexcept;
  Statistics statistics(std::size_t oldest, std::size_t newest, const Vector3<Scalar>& com_guess) const noexcept;
  void make_estimate() noexcept;

  Config config_;
  PriorSource prior_;
  double dt_;
  MismatchDetector<Dofs> detector_;
  SampleWindow<Scalar, Dofs> window_;
  EventInference<Scalar, Dofs> inference_;
  int block_ = 1;  // ticks that are averaged before they enter the sums
  Phase phase_ = Phase::Watching;
  Estimate<Scalar> estimate_;
  Verdict<Scalar> verdict_;
  std::uint64_t ticks_ = 0;
  std::size_t collected_ = 0;  // samples since the collection began
  std::size_t onset_age_ = 0;  // at its beginning: samples before it that belong to the event
  static constexpr int kMaxRestarts = 5;
  int restarts_ = 0;        // of this collection
  bool triggered_ = false;  // by the host, not by the detector
  bool tared_ = false;
  bool rejected_ = false;
  bool pushed_ = false;  // the last change was a push: what follows it is no baseline
  double detected_at_ = 0;
  bool changing_ = false;                 // a change has begun; it may not have settled yet
  Signal level_before_ = Signal::Zero();  // of the watched signal, before it
};

template <typename Scalar, int Dofs>
void EstimatorConfig<Scalar, Dofs>::validate(double dt) const {
  detail::require(dt > 0 && std::isfinite(dt), "Estimator::dt", "> 0 s", dt);
  detail::require(gravity.allFinite() && gravity.norm() > 0, "EstimatorConfig::gravity", "finite and not zero",
                  gravity.norm());
  detail::require(collection >= 2 * dt, "EstimatorConfig::collection", ">= 2 samples [s]", collection);
  detail::require(baseline >= 0, "EstimatorConfig::baseline", ">= 0 s", baseline);
  detail::require(baseline_guard >= 0, "EstimatorConfig::baseline_guard", ">= 0 s", baseline_guard);
  detail::require(onset_span >= dt, "EstimatorConfig::onset_span", ">= 1 sample [s]", onset_span);
  detail::require(onset_jump > 0, "EstimatorConfig::onset_jump", "> 0 N m", onset_jump);
  detail::require(onset_guard >= 0, "EstimatorConfig::onset_guard", ">= 0 s", onset_guard);
  detail::require(unrest > 0, "EstimatorConfig::unrest", "> 0 N m", unrest);
  detail::require(gyration_radius >= 0, "EstimatorConfig::gyration_radius", ">= 0 m", gyration_radius);
  detail::require(detector.window > 0, "MismatchDetectorConfig::window", "> 0 s", detector.window);
  const double needed = detector.window + std::max(collection, baseline + baseline_guard) + 2 * dt;
  detail::require(window.duration >= needed, "SampleWindowConfig::duration",
                  "at least the detector's window + the longer of collection and baseline", window.duration);
}

template <typename Scalar, int Dofs, typename PriorSource>
Estimator<Scalar, Dofs, PriorSource>::Estimator(double dt, const Config& config, const PriorSource& prior)
    : config_((config.validate(dt), config)),
      prior_(prior),
      dt_(dt),
      detector_(dt, config.detector),
      window_(dt, config.window),
      inference_(Scalar(dt), config.sensors, config.push, config.inference) {
  double shortest = config.collection;
  for (const auto& sensor : config.sensors)
    shortest = std::min(shortest, 2 * static_cast<double>(sensor.noise_correlation_time));
  block_ = static_cast<int>(std::max<std::size_t>(1, ticks_of(shortest)));
}

template <typename Scalar, int Dofs, typename PriorSource>
void Estimator<Scalar, Dofs, PriorSource>::reset() noexcept {
  detector_.reset();
  window_.reset();
  inference_.forget_baseline();
  phase_ = Phase::Watching;
  estimate_ = Estimate<Scalar>();
  verdict_ = Verdict<Scalar>();
  detected_at_ = 0;
  ticks_ = 0;
  tared_ = pushed_ = rejected_ = changing_ = false;
}

template <typename Scalar, int Dofs, typename PriorSource>
Status Estimator<Scalar, Dofs, PriorSource>::update(const Proprioception<Scalar, Dofs>& in) noexcept {
  Proprioception<Scalar, Dofs> sample = in;
  sample.tau_ext *= Scalar(static_cast<int>(config_.torque_sign));
  const Status status = window_.push(sample);
  if (status != Status::Ok) return status;
  ++ticks_;
  if (phase_ == Phase::Estimating) phase_ = estimate_.empty ? Phase::Watching : Phase::Compensating;
  rejected_ = false;

  if (phase_ == Phase::Collecting) {
    if (++collected_ >= ticks_of(config_.collection)) make_estimate();
    return Status::Ok;
  }
  if (detector_.update(watched(0)) == Status::Ok && changed()) begin_collection(false);
  return Status::Ok;
}

/// Whether something has changed and settled. A compliant arm sags under a heavy payload for longer than the detector
/// looks back: what was before is therefore remembered as soon as the change begins.
template <typename Scalar, int Dofs, typename PriorSource>
bool Estimator<Scalar, Dofs, PriorSource>::changed() noexcept {
  if (detector_.rapid_change() && !changing_) {
    const std::size_t span = ticks_of(config_.onset_span), window = ticks_of(config_.detector.window);
    const Onset<Scalar> onset = find_onset(window_, window + 2 * span, span);
    remember_quiet(is_onset(onset) ? onset.age + 1 : window);
    changing_ = true;
  }
  if (!changing_ || !detector_.stabilised()) return false;
  if (detector_.rapid_change()) return true;
  changing_ = (level(0) - level_before_).norm() > config_.detector.activation_threshold;  // or all is as it was
  return changing_;
}

/// Learns from the quiet past, whose newest sample that is sure to be quiet has this age.
template <typename Scalar, int Dofs, typename PriorSource>
void Estimator<Scalar, Dofs, PriorSource>::remember_quiet(std::size_t quiet_age) noexcept {
  quiet_age += ticks_of(config_.baseline_guard);
  level_before_ = level(quiet_age);
  if (estimate_.empty && !tared_ && !pushed_) learn_baseline(quiet_age, ticks_of(config_.baseline));
}

/// Mean of the watched signal over the span whose newest sample has this age.
template <typename Scalar, int Dofs, typename PriorSource>
auto Estimator<Scalar, Dofs, PriorSource>::level(std::size_t newest) const noexcept -> Signal {
  const std::size_t count = std::max<std::size_t>(1, ticks_of(config_.detector.check_average));
  Signal sum = Signal::Zero();
  for (std::size_t i = 0; i < count; ++i) sum += watched(std::min(newest + i, window_.size() - 1));
  return sum / static_cast<double>(count);
}

/// The signal in which changes are looked for, `age` ticks ago. When a loaded arm moves its torque changes without any
/// event, and when compensation sets in it is the payload's inertia that shows, so the known payload's share is taken
/// off.
template <typename Scalar, int Dofs, typename PriorSource>
auto Estimator<Scalar, Dofs, PriorSource>::watched(std::size_t age) const noexcept -> Signal {
  const Sample<Scalar, Dofs>& sample = window_.newest(age);
  if (config_.watch_norm)  // in one channel; the others stay zero
    return Signal::Unit(0) * static_cast<double>(sample.raw.tau_ext.norm());
  if (estimate_.empty) return sample.tau.template cast<double>();
  const Payload<Scalar> payload = estimate_.payload();
  return (sample.tau - regressor(sample, payload.com).torque(payload)).template cast<double>();
}

template <typename Scalar, int Dofs, typename PriorSource>
void Estimator<Scalar, Dofs, PriorSource>::trigger() noexcept {
  begin_collection(true);
}

template <typename Scalar, int Dofs, typename PriorSource>
void Estimator<Scalar, Dofs, PriorSource>::tare(double duration) noexcept {
  learn_baseline(0, ticks_of(std::max(duration, 0.0)));
  tared_ = true;
}

template <typename Scalar, int Dofs, typename PriorSource>
void Estimator<Scalar, Dofs, PriorSource>::begin_collection(bool triggered) noexcept {
  const bool interrupted = phase_ == Phase::Collecting;
  phase_ = Phase::Collecting;
  collected_ = 0;
  onset_age_ = 0;
  restarts_ = 0;
  triggered_ = triggered;
  detected_at_ = time();
  const std::size_t span = ticks_of(config_.onset_span);
  const Onset<Scalar> onset = find_onset(window_, ticks_of(config_.detector.window) + 2 * span, span);
  // Where the quiet past ends. After a sharp step that the detector has noticed, every sample counts; of a slow
  // hand-over only what follows once it has settled.
  std::size_t quiet_age = triggered ? 0 : ticks_of(config_.detector.window);
  if (is_onset(onset)) {
    quiet_age = onset.age + 1;
    if (!triggered) onset_age_ = quiet_age - std::min(quiet_age, ticks_of(config_.onset_guard));
  }
  // The baseline of an interrupted collection, or of a change that has been seen to begin, is from before the change;
  // a new one might not be.
  if (!interrupted && !changing_) remember_quiet(quiet_age);
  changing_ = false;
}

/// The nuisances of the coming event, from `count` samples of an empty hand, the newest of them of age `newest`.
template <typename Scalar, int Dofs, typename PriorSource>
void Estimator<Scalar, Dofs, PriorSource>::learn_baseline(std::size_t newest, std::size_t count) noexcept {
  const std::size_t oldest = std::min(window_.size(), newest + count);
  if (oldest > newest)
    inference_.learn_baseline(statistics(oldest, newest, Vector3<Scalar>::Zero()));
  else
    inference_.forget_baseline();
}

/// Sums over the samples of ages oldest - 1 down to newest, in means over as long as the noise of SensorModel stays the
/// same. What varies from tick to tick is averaged out there: it would look like noise of another kind, and the
/// evidence of the sensor models would be about that.
template <typename Scalar, int Dofs, typename PriorSource>
PayloadStatistics<Scalar, Dofs> Estimator<Scalar, Dofs, PriorSource>::statistics(
    std::size_t oldest, std::size_t newest, const Vector3<Scalar>& com_guess) const noexcept {
  Statistics sums;
  PayloadObservation<Scalar, Dofs> mean;
  int ticks = 0;
  for (std::size_t age = oldest; age-- > newest;) {
    const Sample<Scalar, Dofs>& s = window_.newest(age);
    mean += {s.tau, regressor(s, com_guess), s.direction, s.raw.dq};
    if (++ticks < block_ && age > newest) continue;
    mean *= Scalar(1) / Scalar(ticks);
    sums.add(mean, ticks);
    mean = PayloadObservation<Scalar, Dofs>();
    ticks = 0;
  }
  return sums;
}

template <typename Scalar, int Dofs, typename PriorSource>
void Estimator<Scalar, Dofs, PriorSource>::make_estimate() noexcept {
  std::size_t collected = std::min(window_.size(), collected_);
  if (triggered_) {  // the weight may have come after the trigger
    const Onset<Scalar> onset = find_onset(window_, collected, ticks_of(config_.onset_span));
    if (is_onset(onset)) collected = onset.age + 1 - std::min(onset.age, ticks_of(config_.onset_guard));
  } else if (restarts_ < kMaxRestarts && unrest(window_, collected) > Scalar(config_.unrest)) {
    ++restarts_;  // something else happens meanwhile: wait until it is over
    collected_ = onset_age_ = 0;
    return;
  }
  const std::size_t count = std::min(window_.size(), collected + onset_age_);
  const PayloadGaussian<Scalar> prior = prior_(window_, collected);
  detector_.reset();
  phase_ = estimate_.empty ? Phase::Watching : Phase::Compensating;  // unless an estimate is made

  // Payload or push is judged by the samples after the change has settled.
  Vector3<Scalar> com_guess = prior.mean.template tail<3>();
  const Statistics settled = statistics(collected, 0, com_guess);
  Statistics sums = statistics(count, collected, com_guess);
  sums += settled;
  verdict_ = inference_.judge(settled, sums, prior, estimate_.payload(), window_.newest().raw.jacobian);
  if (!triggered_ && !verdict_.is_payload()) {
    rejected_ = true;
    pushed_ = verdict_.push > verdict_.unchanged;
    return;
  }
  // The estimate is made from all of them. The inertia force is expanded about a centre of mass: first the prior's,
  // then the one found.
  ModelAverage<Scalar> average = inference_.posterior(sums, prior);
  if (average.empty()) return;
  com_guess = average.moments().mean.template tail<3>();
  average = inference_.posterior(statistics(count, 0, com_guess), prior);
  if (average.empty()) return;
  pushed_ = false;
  estimate_.posterior = average.moments();
  estimate_.empty = verdict_.is_empty();
  if (estimate_.empty) estimate_.posterior.mean.setZero();
  estimate_.detected_at = detected_at_;
  estimate_.window_begin = time_of(count);
  estimate_.window_end = time();
  phase_ = Phase::Estimating;
}

}  // namespace rme
