#pragma once
/// All that a controller adds to its command for an unknown payload: estimator, bound, fade and ramp in one object.
#include <algorithm>
#include <cmath>
#include <memory>
#include <optional>
#include <rme/core/compensation.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/estimator.hpp>
#include <rme/host/hand_over.hpp>
#include <rme/host/largest_levers.hpp>
#include <rme/host/load_watch.hpp>
#include <rme/sensing/proprioception.hpp>

namespace rme {

/// Settings of PayloadCompensation and RuntimePayloadCompensation.
template <typename Scalar, int Dofs>
struct PayloadCompensationConfig {
  EstimatorConfig<Scalar, Dofs> estimator;  ///< of the estimator
  /// How fast the torque of each joint may change [N m/s], > 0; absent: the default of CompensationRampConfig.
  std::optional<JointVector<Scalar, Dofs>> torque_rate = std::nullopt;
  /// The largest torque that is added on each joint [N m], > 0; absent: no bound. If one joint's bound is reached, the
  /// torque of all is reduced by the same factor: it is that of a lighter payload.
  std::optional<JointVector<Scalar, Dofs>> torque_bound = std::nullopt;
  Scalar fade_time = Scalar(0.5);  ///< how long enable(true) and enable(false) take [s], > 0
  bool enabled = true;             ///< whether a torque is added from the start
  /// hand_over() refuses while a joint's torque could be wrong by more than this in any pose [N m], > 0.
  Scalar hand_over_error = Scalar(0.3);
  /// The largest distance of the end-effector origin from each joint's axis in any pose [m], >= 0; of a prismatic
  /// joint: 1. Absent: computed from the Jacobian (largest_levers.hpp), for revolute joints.
  std::optional<JointVector<Scalar, Dofs>> levers = std::nullopt;
};

/// The torque that carries an unknown payload, ready to be added to a controller's own:
///
///     PayloadCompensation<double, 7> payload(0.001, config);        // may throw: before the loop
///     status = payload.update({tau_ext, jacobian, rotation, dq});   // each tick
///     tau_command += payload.torque();                              // last, after your own limits
///
/// The torque is the estimator's, faded (enable()), bounded and moved at the ramp's rate, in this order:
///
///     target = share (tau_comp - missing t),  |target_j| <= torque_bound_j
///
/// The second term is zero unless the robot was told of a load by handed_over() and that load is gone: then it takes
/// back the torque t with which the robot still carries it. What the torque was is told to the estimator
/// (Proprioception::compensation), unless the host says so itself.
///
/// The object is small; the estimator, which is several hundred kB, is on the heap. Real time: no call but the
/// constructor allocates or throws.
template <typename Scalar, int Dofs>
class PayloadCompensation {
 public:
  using Torque = JointVector<Scalar, Dofs>;                ///< [N m]
  using Config = PayloadCompensationConfig<Scalar, Dofs>;  ///< settings
  using Sample = Proprioception<Scalar, Dofs>;             ///< what the arm reports in one tick
  using Body = InertialParameters<Scalar>;                 ///< a load, end-effector axes

  /// @param period  nominal control period [s], above 0 and at most 0.1
  /// @param config  settings
  /// @throws std::invalid_argument naming the field out of range
  explicit PayloadCompensation(double period, const Config& config = Config())
      : estimator_(std::make_unique<Estimator<Scalar, Dofs>>(period, config.estimator)),
        ramp_(static_cast<Scalar>(period), config.torque_rate
                                               ? CompensationRampConfig<Scalar, Dofs>{*config.torque_rate}
                                               : CompensationRampConfig<Scalar, Dofs>()),
        watch_(config.estimator.observer_bandwidth),
        config_(config),
        period_(period),
        enabled_(config.enabled),
        share_(config.enabled ? 1 : 0) {
    detail::require_positive(config.fade_time, "PayloadCompensationConfig::fade_time", "> 0 s");
    detail::require_positive(config.hand_over_error, "PayloadCompensationConfig::hand_over_error", "> 0 N m");
    for (int j = 0; j < Dofs; ++j) {
      if (config.torque_bound)
        detail::require((*config.torque_bound)[j] > 0, "PayloadCompensationConfig::torque_bound", "> 0 N m",
                        (*config.torque_bound)[j]);
      if (config.levers)
        detail::require((*config.levers)[j] >= 0, "PayloadCompensationConfig::levers", ">= 0 m", (*config.levers)[j]);
    }
  }
  /// A settings object for the estimator alone.
  /// @param period     nominal control period [s], above 0 and at most 0.1
  /// @param estimator  its settings; all others have their defaults
  PayloadCompensation(double period, const EstimatorConfig<Scalar, Dofs>& estimator)
      : PayloadCompensation(period, with(estimator)) {}

  /// Advances by one tick.
  /// @param sample  tau_ext, J, R and dq of this tick
  /// @return Ok; NonFiniteInput or NotARotation: nothing has changed, torque() included; NotAMeasurement: tau_ext is
  ///         frozen. The torque then follows the estimate, which becomes less certain with time
  Status update(const Sample& sample) noexcept;
  /// The torque to add to the command now [N m]; zero before the first update().
  const Torque& torque() const noexcept { return ramp_.torque(); }

  /// Switches the torque on or off, with a fade of fade_time. The estimate goes on meanwhile.
  void enable(bool on) noexcept { enabled_ = on; }
  /// Whether the torque is on, or being faded in.
  bool enabled() const noexcept { return enabled_; }

  /// For a control loop that starts at zero torque, such as libfranka's: the torque becomes zero at once, and comes
  /// back at the ramp's rate. The estimate stays. A torque step: only while the arm is not commanded.
  void restart() noexcept { ramp_.reset(); }
  /// Returns to the state after construction: the estimate, what was learned of the arm, and the load of handed_over()
  /// are forgotten. A torque step, as restart().
  void reset() noexcept {
    estimator_->reset();
    ramp_.reset();
    load_ = Payload<Scalar>();
    watch_.reset();
    seen_ = false;
    enabled_ = config_.enabled;
    share_ = Scalar(enabled_ ? 1 : 0);
  }

  /// Whether the payload is known well enough for the robot's own load, and its parameters. Judged by the torque that
  /// is needed to hold it, in all poses: so both mass and centre of mass have to be certain. Changes nothing. Not for
  /// the loop: some 50,000 operations; it does not allocate.
  HandOver<Scalar> hand_over() const noexcept;
  /// Says that from now on the robot carries `body`, in addition to what it carried. For the estimator the hand is then
  /// empty; what it has learned of the arm stays. torque() becomes zero at once, since the robot's torque replaces it.
  /// From then on it is watched whether the load is still there.
  /// @param body  what the robot took, end-effector axes
  void handed_over(const Body& body) noexcept {
    const Scalar mass = load_.mass + body.mass;
    const Vector3<Scalar> moment = load_.mass * load_.com + body.first_moment;
    if (!(mass > 0) || !plausible(static_cast<double>(mass)) || !plausible(moment)) return;
    load_ = {mass, moment / mass};
    estimator_->declare_empty();
    ramp_.reset();
    watch_.reset();
  }
  /// Whether a load of handed_over() has been missing for a quarter of a second: it was dropped, and the robot pushes
  /// upwards with its weight. torque() already acts against that. Clear the robot's load, and call load_cleared().
  bool load_lost() const noexcept { return watch_.lost(); }
  /// Says that the robot's load is again what it was before the first handed_over(). What is in the hand, if anything,
  /// is estimated anew. torque() becomes zero at once.
  void load_cleared() noexcept {
    load_ = Payload<Scalar>();
    watch_.reset();
    ramp_.reset();
    estimator_->declare_empty();
    estimator_->expect_change();
  }

  Estimator<Scalar, Dofs>& estimator() noexcept { return *estimator_; }              ///< what it tells and can be told
  const Estimator<Scalar, Dofs>& estimator() const noexcept { return *estimator_; }  ///< the same
  /// What is held, and what happens to it: Estimator::state().
  const EstimatorState<Scalar>& state() const noexcept { return estimator_->state(); }
  const Config& config() const noexcept { return config_; }  ///< as constructed

 private:
  static Config with(const EstimatorConfig<Scalar, Dofs>& estimator) {
    Config config;
    config.estimator = estimator;
    return config;
  }
  Torque target(const Sample& sample) noexcept;

  std::unique_ptr<Estimator<Scalar, Dofs>> estimator_;
  CompensationRamp<Scalar, Dofs> ramp_;
  LoadWatch<Scalar, Dofs> watch_;
  Config config_;
  double period_;
  bool enabled_, seen_ = false;                                       // whether there was a good sample
  Scalar share_;                                                      // of the torque, 0 to 1
  Payload<Scalar> load_;                                              // that the robot carries because of handed_over()
  Jacobian<Scalar, Dofs> jacobian_ = Jacobian<Scalar, Dofs>::Zero();  // of the last good sample
};

template <typename Scalar, int Dofs>
Status PayloadCompensation<Scalar, Dofs>::update(const Sample& sample) noexcept {
  Sample told = sample;
  if (!told.compensation) told.compensation = ramp_.torque();
  const Status status = estimator_->update(told);
  if (status != Status::Ok && status != Status::NotAMeasurement) return status;
  jacobian_ = sample.jacobian;
  seen_ = true;
  // The nominal period: a late tick must not make a step.
  const Scalar step = static_cast<Scalar>(period_) / config_.fade_time;
  share_ = std::max(Scalar(0), std::min(Scalar(1), share_ + (enabled_ ? step : -step)));
  const Status moved = ramp_.update(target(sample));
  return status == Status::Ok ? moved : status;
}

template <typename Scalar, int Dofs>
auto PayloadCompensation<Scalar, Dofs>::target(const Sample& sample) noexcept -> Torque {
  Torque out = estimator_->compensation(sample.jacobian, sample.rotation);
  if (load_.mass > 0) {
    const Torque load = compensation_torque(load_, sample.jacobian, sample.rotation, config_.estimator.gravity);
    const Torque tau_ext = detail::scaled(Scalar(static_cast<int>(config_.estimator.torque_sign)), sample.tau_ext);
    watch_.update(tau_ext, load, sample.period > 0 ? sample.period : period_);
    detail::add_scaled(out, -watch_.missing(), load);
  }
  out *= share_;
  if (config_.torque_bound) {
    Scalar factor = Scalar(1);
    for (int j = 0; j < Dofs; ++j) {
      const Scalar size = std::abs(out[j]), bound = (*config_.torque_bound)[j];
      if (size > bound) factor = std::min(factor, bound / size);
    }
    out *= factor;
  }
  return out;
}

template <typename Scalar, int Dofs>
HandOver<Scalar> PayloadCompensation<Scalar, Dofs>::hand_over() const noexcept {
  if (!seen_) {
    HandOver<Scalar> out;
    out.torque_limit = config_.hand_over_error;
    return out;
  }
  const Torque levers = config_.levers ? *config_.levers : largest_levers(jacobian_);
  return judge_hand_over(estimator_->state(), levers, config_.estimator.gravity.norm(), config_.hand_over_error);
}

}  // namespace rme
