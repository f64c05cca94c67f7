#pragma once
/// The class that a host owns. It takes a sample each tick, and gives the payload and the torque that carries it.
#include <algorithm>
#include <cmath>
#include <new>
#include <rme/core/compensation.hpp>
#include <rme/core/flange_motion.hpp>
#include <rme/core/payload.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/estimator_config.hpp>
#include <rme/estimator_state.hpp>
#include <rme/sensing/contact_state.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/sensing/stale_torque.hpp>
#include <rme/tracking/contact_watch.hpp>
#include <rme/tracking/inertial_parameters.hpp>
#include <rme/tracking/removal_guard.hpp>
#include <rme/tracking/torque_block.hpp>
#include <rme/tracking/tracker.hpp>

namespace rme {

/// Tracks the payload of one arm. Every sample counts (docs/theory.md, "The tracker"):
///
///     samples -> blocks of 20 ms -> weighted stories, per kind of torque sensing -> belief -> events, compensation
///
///     Estimator<double, 7> estimator(0.001);                        // may throw: before the loop
///     estimator.update({tau_ext, jacobian, rotation, dq});          // each tick
///     tau_command += estimator.compensation(jacobian, rotation);    // through a CompensationRamp
///     estimator.state().payload                                     // mass and centre of mass, with covariance
///
/// Real time: no call but the constructor allocates or throws. The children of a block's stories are computed on the
/// tick that ends it and on the ticks after it: at 1 kHz five on one tick, below 400 Hz all of them. Each costs at most
/// two updates of a filter of 21 + 5 Dofs unknowns. On all other ticks update() is O(Dofs).
template <typename Scalar, int Dofs>
class Estimator {
  static_assert(Dofs != Eigen::Dynamic, "Estimator: the number of joints has to be known at compile time");
  static_assert(Dofs >= 1, "Estimator: an arm has joints");

 public:
  using Config = EstimatorConfig<Scalar, Dofs>;  ///< settings
  using Torque = JointVector<Scalar, Dofs>;      ///< [N m]

  /// @param dt      nominal control period [s], above 0 and at most 0.1
  /// @param config  settings: what the estimator cannot find out by itself
  /// @throws std::invalid_argument naming the field out of range
  explicit Estimator(double dt, const Config& config = Config());

  /// Advances by one sample.
  /// @param sample  tau_ext, J, R and dq of this tick
  /// @return Ok; NonFiniteInput (also for numbers beyond kLargestPlausible) or NotARotation: the estimator is then as
  ///         it was, and the sample does not count; NotAMeasurement: tau_ext is frozen, or exactly zero though its
  ///         noise rules that out (stale_torque.hpp). Then only the time counts: the estimate stays, and its mass
  ///         becomes less certain, since the payload may be exchanged or dropped meanwhile. The next measurement is
  ///         used as usual
  Status update(const Proprioception<Scalar, Dofs>& sample) noexcept;
  /// The current estimate, and what happens to the payload.
  const EstimatorState<Scalar>& state() const noexcept { return state_; }
  /// What acts on the arm and is explained neither by the payload nor by what the arm has shown so far: each tick
  /// (docs/contact.md). An object that is put into the hand is a contact, too, until it is known as payload.
  const ContactState<Scalar, Dofs>& contact() const noexcept { return watch_.state(); }

  /// The joint torque that carries the payload, to be added to the command [N m], Dofs x 1 (docs/theory.md (T34)):
  ///
  ///     tau_comp = -J^T (share c w(payload) + w(tool)),   c = m^2 / (m^2 + std^2)
  ///
  /// Without a tool that the robot does not know, it is nearly zero for an empty hand. If the payload's weight is
  /// suddenly missing in tau_ext, the removal guard reduces `share` from 1 towards 0 within milliseconds, before it is
  /// known whether the object was dropped or lifted (T35). If the pose is not plausible (plausible.hpp), that of the
  /// last good sample is used.
  /// @param jacobian  J, 6 x Dofs, world axes, linear rows first
  /// @param rotation  R, end-effector axes to world axes
  Torque compensation(const Jacobian<Scalar, Dofs>& jacobian, const Matrix3<Scalar>& rotation) const noexcept {
    return payload_torque(jacobian, rotation, FlangeMotion<Scalar>());
  }
  /// The joint torque that carries payload and tool and moves them [N m], Dofs x 1, for a controller that knows the
  /// motion that it commands (T10): compensation() if `motion` is zero.
  /// @param jacobian  J, 6 x Dofs, world axes, linear rows first
  /// @param rotation  R, end-effector axes to world axes
  /// @param motion    of the end effector that is commanded, world axes; if it is not plausible, it counts as zero
  Torque payload_torque(const Jacobian<Scalar, Dofs>& jacobian, const Matrix3<Scalar>& rotation,
                        const FlangeMotion<Scalar>& motion) const noexcept;

  /// Says that the hand is empty. This call and the four below tell the estimator what the host knows. None of them is
  /// needed. If the samples contradict what the host says, the estimate follows the samples.
  void declare_empty() noexcept;
  /// Says what is in the hand.
  /// @param payload  mass [kg], >= 0, and centre of mass [m], end-effector axes; covariance positive semidefinite
  /// @return Ok; NonFiniteInput, also for a mass or a variance below 0: nothing is changed then
  Status set_payload(const PayloadGaussian<Scalar>& payload) noexcept;
  /// Says that what the hand holds now is part of the tool: a gripper that the robot does not know, or an error of its
  /// mass. From then on state().payload is what comes in addition. What was held is carried as before, and known better
  /// once the arm has moved.
  void tare() noexcept;
  /// Says that the payload is about to change, for example because the gripper closes or opens. For 0.3 s, a change
  /// then has as much prior probability as everything else together, and blocks are not made longer for the noise of
  /// dq.
  void expect_change() noexcept { expected_ = kExpected; }
  /// Says whether the arm is in contact. While it is, nothing is learned, and the estimate stays as it is. The removal
  /// guard still works: it reduces the compensation if the payload's weight is missing, since the object may have been
  /// dropped. When the contact is over, in_contact(false) has the effect of expect_change().
  void in_contact(bool contact) noexcept {
    if (contact_ && !contact) expect_change();
    contact_ = contact;
  }

  const Config& config() const noexcept { return config_; }  ///< as constructed
  /// Returns to the state after construction. What was learned of the arm is forgotten, too.
  void reset() noexcept;

 private:
  static constexpr double kExpected = 0.3;  // how long a change is expected after expect_change() [s]
  // How often a payload is exchanged while nothing is measured [1/s]: as often as the tracker expects it on an arm
  // whose torque shows it at once, SensingKind::change = 1e-3 per block.
  static constexpr double kExchanges = 0.05;
  static constexpr int kChildren = 20;        // children that a busy block has, over all kinds of sensing
  static constexpr int kManyChildren = 1000;  // more than a block can have
  static constexpr double kJolt = 0.01;       // longest onset of what is sudden [s]

  /// phi of the payload, as state() has it; but the first moment, known together with the mass, is not bounded.
  InertialVector<Scalar> body() const noexcept {
    InertialVector<Scalar> phi = detail::scaled(state_.held, state_.inertial.mean);
    phi[0] = carried_[0];
    for (int i = 1; i < 4; ++i) phi[i] = carried_[0] * carried_[i];
    return phi;
  }
  Scalar share() const noexcept {
    const Scalar mass = state_.payload.mean[0], variance = state_.payload.covariance(0, 0);
    const Scalar square = mass * mass;  // may underflow to zero
    return mass > 0 && square + variance > 0 ? square / (square + variance) : Scalar(0);
  }
  /// Variance of a mass of which a share is a weight or none [kg^2].
  Scalar doubt(Scalar mass) const noexcept { return Scalar(0.25) * state_.undecided * state_.undecided * mass * mass; }
  Scalar excess() const noexcept {
    return std::max(Scalar(1), state_.health / Scalar(EstimatorState<Scalar>::kHealthy));
  }
  /// Whether something has begun within milliseconds: what comes slowly, a short block would not tell.
  bool jolted() const noexcept {
    const ContactEvent<Scalar>& last = contact().last;
    return contact().contact && last.noticed - last.onset <= kJolt;
  }
  void process() noexcept;
  void publish() noexcept;
  void forget(double dt) noexcept;

  Config config_;
  double dt_;
  PayloadPrior<Scalar> payload_prior_;
  BlockAverager<Scalar, Dofs> averager_;
  Tracker<Scalar, Dofs> tracker_;
  EventMonitor<Scalar> events_;
  StaleTorque<Scalar, Dofs> stale_;
  RemovalGuard<Scalar, Dofs> guard_;
  ContactWatch<Scalar, Dofs> watch_;
  EstimatorState<Scalar> state_;
  Vector4<Scalar> carried_ = Vector4<Scalar>::Zero();                 // (m, r) of body()
  Jacobian<Scalar, Dofs> jacobian_ = Jacobian<Scalar, Dofs>::Zero();  // of the last good sample
  Matrix3<Scalar> rotation_ = Matrix3<Scalar>::Identity();
  int steps_per_tick_;
  double expected_ = 0;  // how long a change is still expected [s]
  bool contact_ = false;
};

template <typename Scalar, int Dofs>
Estimator<Scalar, Dofs>::Estimator(double dt, const Config& config)
    : config_((config.validate(dt), config)),
      dt_(dt),
      payload_prior_(config.payload.value_or(PayloadPrior<Scalar>::of(config.rated_payload))),
      averager_(config.observer_bandwidth, config.gravity),
      tracker_(config.arm.value_or(ArmPrior<Scalar, Dofs>::of(config.rated_payload)), payload_prior_,
               config.rated_payload, config.sensing, config.gravity),
      watch_(config.contact_false_alarms, config.arm.value_or(ArmPrior<Scalar, Dofs>::of(config.rated_payload)),
             config.observer_bandwidth, config.gravity, dt) {
  // A block is processed in a quarter of the ticks until the next one, so that the estimate is soon up to date.
  const int ticks = static_cast<int>(BlockAverager<Scalar, Dofs>::kDuration / dt / 4);
  steps_per_tick_ = ticks > 1 ? kChildren / ticks + 1 : kManyChildren;
  publish();
}

template <typename Scalar, int Dofs>
void Estimator<Scalar, Dofs>::reset() noexcept {
  // In place: a second object of more than 100 kB does not fit on the stack of a control thread.
  const double dt = dt_;
  const Config config = config_;
  this->~Estimator();
  ::new (static_cast<void*>(this)) Estimator(dt, config);
}

template <typename Scalar, int Dofs>
Status Estimator<Scalar, Dofs>::update(const Proprioception<Scalar, Dofs>& in) noexcept {
  const Status status = check_sample(in);
  if (status != Status::Ok) return status;
  const double dt = in.period > 0 ? in.period : dt_;
  Proprioception<Scalar, Dofs> sample = in;
  sample.tau_ext *= Scalar(static_cast<int>(config_.torque_sign));
  state_.time += dt;
  if (!stale_.update(in.tau_ext, in.dq, dt)) {
    averager_.clear();
    watch_.interrupt();
    process();
    forget(dt);
    return Status::NotAMeasurement;
  }
  jacobian_ = in.jacobian;
  rotation_ = in.rotation;
  const bool complete = averager_.add(sample, dt, state_.time);
  const Vector6<Scalar> weight =
      payload_wrench(Payload<Scalar>::from_vector(carried_), in.rotation, config_.gravity).vector();
  guard_.update(averager_.torque(), Torque(detail::transposed_product(in.jacobian, weight)), static_cast<Scalar>(dt));
  const bool touched = contact().contact;
  watch_.update(sample, dt, state_.time);
  if (!touched && jolted()) averager_.restart();  // no block is a mean of before and after
  if (contact_) watch_.hold();
  expected_ = std::max(0.0, expected_ - dt);
  // With a Jacobian of zeros, tau_ext does not depend on the payload.
  if (complete && !contact_ && in.jacobian.squaredNorm() > 0) tracker_.begin(averager_.block(), expected_ > 0);
  if (complete && expected_ > 0) averager_.hurry();
  process();
  return Status::Ok;
}

/// Does the next steps of the work for the last block.
template <typename Scalar, int Dofs>
void Estimator<Scalar, Dofs>::process() noexcept {
  for (int i = 0; i < steps_per_tick_; ++i) {
    if (!tracker_.advance()) continue;
    const TorqueBlock<Scalar, Dofs>& block = averager_.block();
    publish();
    PayloadGaussian<Scalar> felt = state_.payload;  // for an event it does not matter whether it is a weight
    felt.covariance(0, 0) -= doubt(felt.mean[0]);
    events_.update(state_.probability, block.end - static_cast<double>(block.duration), block.end, state_.time, felt);
    state_.updated = block.end;
    watch_.judge(block, tracker_.belief(), events_);
    const auto& probability = state_.probability;
    const bool pushed = probability[Mode::Disturbed] > Scalar(0.9);
    if (pushed || probability[Mode::Held] + probability[Mode::Pouring] > Scalar(0.9))
      guard_.learn(block.tau, detail::product(block.regressor, state_.inertial.mean), pushed, block.elapsed());
  }
  state_.changing = events_.changing();
  state_.change_onset = events_.onset();
  state_.change_noticed = events_.noticed();
  state_.event = events_.last();
}

/// A tick in which tau_ext was no measurement. The variance of the mass approaches that of a payload from the prior,
/// about the mean that is kept: after a time t, the payload has been exchanged with the probability 1 - exp(-t / 20 s).
template <typename Scalar, int Dofs>
void Estimator<Scalar, Dofs>::forget(double dt) noexcept {
  const Scalar away = payload_prior_.mass_mean - state_.payload.mean[0];
  const Scalar exchanged = payload_prior_.mass_std * payload_prior_.mass_std + away * away;
  Scalar& variance = state_.payload.covariance(0, 0);
  if (variance < exchanged) variance += static_cast<Scalar>(1 - std::exp(-kExchanges * dt)) * (exchanged - variance);
  state_.confidence = share() / excess();
}

/// Writes the tracker's belief into the state that the host reads (docs/theory.md (T33)).
template <typename Scalar, int Dofs>
void Estimator<Scalar, Dofs>::publish() noexcept {
  const TrackerBelief<Scalar>& belief = tracker_.belief();
  state_.probability = belief.probability;
  state_.held = Scalar(1) - belief.empty;
  state_.swinging = belief.swinging;
  state_.swing_frequency = belief.swing_frequency;
  state_.inertial = belief.payload;
  state_.health = belief.health;
  state_.sensing = belief.sensing;
  state_.tool = belief.tool;
  const PayloadGaussian<Scalar> free = payload_of(belief.payload, payload_prior_);
  PayloadGaussian<Scalar> held = within_prior(free, payload_prior_);
  // If innovations are far larger than the model predicts, the covariance that it predicts is too small as well.
  held.covariance = no_wider_than_prior<Scalar>(excess() * held.covariance, payload_prior_);
  const Scalar empty = belief.empty, mass = held.mean[0];
  // A mass below this cannot be distinguished from an offset. It is larger for an empty hand, whose mass no block has
  // measured.
  const Scalar least = Scalar(state_.empty() ? 3e-4 : 1e-4) * config_.rated_payload;
  // Moments of a mixture: an empty hand with probability `empty`, otherwise `held`.
  const Scalar variance = (Scalar(1) - empty) * (held.covariance(0, 0) + empty * mass * mass);
  held.mean[0] = (Scalar(1) - empty) * mass;
  if (state_.empty()) {
    held.covariance.setZero();
    for (int i = 0; i < 3; ++i) {
      held.covariance(1 + i, 1 + i) = payload_prior_.com_std[i] * payload_prior_.com_std[i];
      held.mean[1 + i] = Scalar(0);
    }
  }
  state_.undecided = belief.undecided;
  held.covariance(0, 0) = std::max(variance, least * least) + doubt(held.mean[0]);
  carried_ = held.mean;
  for (int i = 1; i < 4 && !state_.empty(); ++i) carried_[i] = free.mean[i];
  state_.payload = held;
  state_.confidence = share() / excess();
}

template <typename Scalar, int Dofs>
auto Estimator<Scalar, Dofs>::payload_torque(const Jacobian<Scalar, Dofs>& jacobian, const Matrix3<Scalar>& rotation,
                                             const FlangeMotion<Scalar>& motion) const noexcept -> Torque {
  const Scalar carried = Undecided<Scalar>::carried(state_.undecided);
  InertialVector<Scalar> phi = detail::scaled(share() * guard_.share() * carried, body());
  for (int i = 0; i < 4; ++i) phi[i] += state_.tool[i];
  const bool good = plausible(jacobian) && plausible(rotation);
  const bool moves = plausible(motion.angular_velocity) && plausible(motion.linear_acceleration) &&
                     plausible(motion.angular_acceleration);
  const Eigen::Matrix<Scalar, 6, kInertial> regressor = inertial_wrench_regressor<Scalar>(
      good ? rotation : rotation_, config_.gravity, moves ? motion : FlangeMotion<Scalar>());
  const Vector6<Scalar> wrench = detail::product(regressor, phi);
  return detail::scaled(Scalar(-1), Torque(detail::transposed_product(good ? jacobian : jacobian_, wrench)));
}

template <typename Scalar, int Dofs>
void Estimator<Scalar, Dofs>::declare_empty() noexcept {
  tracker_.declare_empty();
  averager_.clear();  // a load that the robot has taken over changes tau_ext at once, not through the observer
  events_.believe(true);
  publish();
  watch_.told(tracker_.belief());
}

template <typename Scalar, int Dofs>
void Estimator<Scalar, Dofs>::tare() noexcept {
  tracker_.tare();
  events_.believe(true);
  publish();
  watch_.told(tracker_.belief());
}

template <typename Scalar, int Dofs>
Status Estimator<Scalar, Dofs>::set_payload(const PayloadGaussian<Scalar>& payload) noexcept {
  if (!plausible(payload.mean) || !plausible(payload.covariance) || !(payload.mean[0] >= 0) ||
      !(payload.covariance(0, 0) >= 0 && payload.covariance(1, 1) >= 0 && payload.covariance(2, 2) >= 0 &&
        payload.covariance(3, 3) >= 0))
    return Status::NonFiniteInput;
  tracker_.set_payload(payload);
  averager_.clear();
  events_.believe(false);
  publish();
  watch_.told(tracker_.belief());
  return Status::Ok;
}

}  // namespace rme
