#pragma once
/// Watches the torque that neither payload nor arm explains, beside the tracker. In: each sample, and what the tracker makes
/// of each block. Out: the contact that a host reads (sensing/contact_state.hpp).
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/sensing/contact_monitor.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/event_monitor.hpp>
#include <rme/tracking/explained_torque.hpp>
#include <rme/tracking/inertial_parameters.hpp>
#include <rme/tracking/mode.hpp>
#include <rme/tracking/sensing_kind.hpp>
#include <rme/tracking/torque_block.hpp>
#include <rme/tracking/tracker.hpp>

namespace rme {

/// Explains the external torque by the payload as the tracker knows it, and has what remains watched, tick by tick
/// (docs/theory.md, "Contact"). The payload is taken over from the tracker while a payload, or none, explains a block. So
/// neither a push nor an object that is being attached gets into the explanation before the tracker knows what it is.
///
/// Real time: update() is O(Dofs), judge() O(100 Dofs); nothing allocates or throws.
template <typename Scalar, int Dofs>
class ContactWatch {
  using Monitor = ContactMonitor<Scalar, Dofs>;
  using Averager = BlockAverager<Scalar, Dofs>;

 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< joint torque [N m]

  /// @param false_alarms  how often a contact may be noticed while nothing touches the arm [1/h], > 0
  /// @param arm           sizes of the joints' errors and friction before the first sample
  /// @param bandwidth     K of the observer that computed tau_ext [rad/s]; 0 if tau_ext is unfiltered
  /// @param gravity       g [m/s^2], world axes
  /// @param dt            nominal control period [s], > 0
  ContactWatch(double false_alarms, const ArmPrior<Scalar, Dofs>& arm, double bandwidth, const Vector3<Scalar>& gravity,
               double dt) noexcept
      : explained_(bandwidth, Averager::kObserverPeriod, gravity),
        monitor_(false_alarms, arm.residual,
                 {bandwidth > 0 ? 1 / bandwidth : 0, arm.residual, arm.coulomb, arm.viscous}) {
    for (int i = 0; i < Monitor::kScales; ++i) {
      // White noise of a velocity, differentiated and averaged: over a time constant T alone its variance is that of the
      // velocity over T^2; the observer's filter comes first, and T averages over 2 T / dt of its values.
      const double average = Monitor::kAverage[i];
      const double filtered = bandwidth * bandwidth * dt / (dt + 2 * average);
      double gain = 1 / (average * average);
      if (bandwidth > 0) gain = std::min(gain, filtered);
      noise_gain_[i] = static_cast<Scalar>(gain);
    }
  }

  /// Advances by one tick.
  /// @param sample  one tick, for which check_sample() has returned Ok, tau_ext with the sign of TorqueSign::External
  /// @param dt      time since the last sample [s], > 0
  /// @param time    of this sample [s]
  void update(const Proprioception<Scalar, Dofs>& sample, double dt, double time) noexcept {
    explained_.update(sample, dt);
    monitor_.update(detail::difference(sample.tau_ext, explained_.torque()), sample.jacobian, sample.dq, dt, time);
  }
  /// Takes over what the tracker makes of a block.
  /// @param block   the block
  /// @param belief  after it
  /// @param events  after it
  void judge(const TorqueBlock<Scalar, Dofs>& block, const TrackerBelief<Scalar>& belief,
             const EventMonitor<Scalar>& events) noexcept {
    const PerMode<Scalar>& p = belief.probability;
    const bool settled = p[Mode::Empty] + p[Mode::Held] + p[Mode::Pouring] > Scalar(kSettled);
    // Without a change, and unless something is poured, a payload that is estimated anew is the same one.
    const bool same = settled_ && settled && p[Mode::Pouring] < Scalar(0.5);
    settled_ = settled;
    Vector change = Vector::Zero();
    if (settled) change = explained_.become(body(belief));
    for (int j = 0; j < Dofs; ++j) {
      moved_[j] = std::max(Scalar(kMoved) * moved_[j], std::abs(change[j]));
      changed_ = changed_ || std::abs(change[j]) > monitor_.state().threshold[j];
    }
    monitor_.expect_friction(Scalar(1) - belief.sensing[static_cast<std::size_t>(Sensing::LinkSide)]);
    monitor_.judge(settled, block.end - static_cast<double>(block.duration));
    expect(block, belief, settled && (!same || monitor_.state().contact));
    if (same)
      monitor_.refine(change);
    else
      monitor_.replace(change);
    decide(events, p[Mode::Disturbed] > Scalar(0.5), block.end);
  }
  /// The host says something of the payload, and the tracker believes it: tau_ext may change at once.
  void told(const TrackerBelief<Scalar>& belief) noexcept {
    explained_.become(body(belief));
    interrupt();
    monitor_.reopen();
  }
  /// While the host says that the arm is in contact, nothing is learned.
  void hold() noexcept { monitor_.judge(false, 0); }
  /// The next sample has no predecessor.
  void interrupt() noexcept {
    explained_.interrupt();
    monitor_.interrupt();
  }

  const ContactState<Scalar, Dofs>& state() const noexcept { return monitor_.state(); }  ///< what the host reads

 private:
  static constexpr double kSettled = 0.9;  // probability above which payload and arm explain a block
  static constexpr double kMoved = 0.8;    // share of the last changes of the explanation that is kept per block
  // The tracker is behind by half a block, its computation and the next block: nearly two blocks.
  static constexpr double kBehind = 2;
  static constexpr double kKeep = 0.999;    // share of a payload's noise that is kept per block after it is gone
  static constexpr double kPatience = 0.5;  // how long after a contact an event may still be found that explains it [s]

  /// Payload and tool, phi.
  static InertialVector<Scalar> body(const TrackerBelief<Scalar>& belief) noexcept {
    InertialVector<Scalar> phi = detail::scaled(Scalar(1) - belief.empty, belief.payload.mean);
    for (int i = 0; i < 4; ++i) phi[i] += belief.tool[i];
    return phi;
  }

  /// What the errors of the payload's parameters add to the variance of the residual, (T62).
  /// @param fresh  the payload may be another one since this block: no mean has taken in any of its errors
  void expect(const TorqueBlock<Scalar, Dofs>& block, const TrackerBelief<Scalar>& belief, bool fresh) noexcept {
    Vector known[Monitor::kScales];
    const Scalar held = Scalar(1) - belief.empty;
    Vector noise;  // of the acceleration, made by a mass at the flange
    for (int j = 0; j < Dofs; ++j) {
      noise[j] = Scalar(0);
      for (int i = 0; i < Dofs; ++i) {
        Scalar coupling = Scalar(0);
        for (int axis = 0; axis < 3; ++axis) coupling += block.jacobian(axis, j) * block.jacobian(axis, i);
        noise[j] += coupling * coupling * block.velocity_noise[i];
      }
      noise[j] *= held * belief.payload.mean[0] * belief.payload.mean[0];
    }
    for (int i = 0; i < Monitor::kScales; ++i) {
      for (int j = 0; j < Dofs; ++j) {
        const Scalar behind = Scalar(kBehind) * moved_[j];
        known[i][j] = behind * behind;
      }
      // Kept for a while: what the arm has shown with a payload is not what it shows without.
      noise_[i] = detail::scaled(Scalar(kKeep), noise_[i]).cwiseMax(detail::scaled(noise_gain_[i], noise));
      // The mean has taken in the error that is the same all the time: what counts is how the regressor has changed.
      if (regressors_ == 0) regressor_[i] = block.regressor;
      if (fresh) regressor_[i].setZero();
      const Regressor change = detail::difference(block.regressor, regressor_[i]);
      const auto time = static_cast<Scalar>(Monitor::kMean[i]);
      detail::add_scaled(regressor_[i], block.duration / (block.duration + time), change);
      for (int j = 0; j < Dofs && held > Scalar(0.01); ++j) {
        const InertialVector<Scalar> row = change.row(j).transpose();
        known[i][j] += held * std::max(Scalar(0), detail::dot(row, detail::product(belief.payload.covariance, row)));
      }
    }
    regressors_ = 1;
    monitor_.expect(known, noise_);
  }

  /// Says what the last contact turned out to be, as soon as it is known.
  void decide(const EventMonitor<Scalar>& events, bool disturbed, double now) noexcept {
    const ContactEvent<Scalar>& last = monitor_.state().last;
    if (last.number != number_) {
      number_ = last.number;
      disturbed_ = changed_ = false;
    }
    if (last.number == 0 || last.cause != ContactCause::Undecided) return;
    disturbed_ = disturbed_ || (disturbed && now > last.noticed);
    // An event that was going on at some time of the contact, or begins right after it.
    const Event& event = events.last();
    if (event.number > 0 && event.over > last.noticed) {
      monitor_.decide(event.kind == EventKind::Pushed ? ContactCause::Contact : ContactCause::Payload);
      return;
    }
    if (monitor_.state().contact || events.changing() || now < last.over + kPatience) return;
    // Without an event: what the payload has taken up was one; what stayed until the mean had followed, the arm's own
    // error; and what went away by itself, a contact.
    ContactCause cause = ContactCause::Contact;
    if (!disturbed_ && changed_)
      cause = ContactCause::Payload;
    else if (!disturbed_ && monitor_.followed())
      cause = ContactCause::Arm;
    monitor_.decide(cause);
  }

  using Regressor = Eigen::Matrix<Scalar, Dofs, kInertial>;
  ExplainedTorque<Scalar, Dofs> explained_;
  Monitor monitor_;
  Scalar noise_gain_[Monitor::kScales];
  Regressor regressor_[Monitor::kScales];                              // slow means of the blocks' regressors
  Vector noise_[Monitor::kScales] = {Vector::Zero(), Vector::Zero()};  // of the acceleration [(N m)^2]
  Vector moved_ = Vector::Zero();                                      // last changes of the explanation [N m]
  bool settled_ = true;                                                // payload and arm explained the last block
  int regressors_ = 0;
  int number_ = 0;          // of the contact that disturbed_ belongs to
  bool disturbed_ = false;  // a block was disturbed during the contact
  bool changed_ = false;    // the payload that explains the torque has changed since the contact began
};

}  // namespace rme
