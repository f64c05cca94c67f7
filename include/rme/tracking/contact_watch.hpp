#pragma once
/// Watches the torque that neither payload nor arm explains, beside the tracker. In: each sample, and what the tracker
/// makes of each block. Out: the contact that a host reads (sensing/contact_state.hpp).
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

/// Explains the external torque by the payload as the tracker knows it, and has the rest watched by a ContactMonitor,
/// tick by tick (docs/theory.md, "Contact"). The payload is taken over from the tracker while a payload, or none,
/// explains a block. So neither a push nor an object that is being attached gets into the explanation before the
/// tracker knows what it is.
///
/// Real time: update() is O(Dofs), judge() O(100 Dofs); nothing allocates or throws.
template <typename Scalar, int Dofs>
class ContactWatch {
  using Monitor = ContactMonitor<Scalar, Dofs>;
  using Averager = BlockAverager<Scalar, Dofs>;
  using Regressor = typename ExplainedTorque<Scalar, Dofs>::Regressor;

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
      // White noise of a velocity, differentiated and averaged: over a time constant T alone its variance is that of
      // the velocity over T^2; the observer's filter comes first, and T averages over 2 T / dt of its values.
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
    const Vector explained = detail::product(explained_.regressor(), phi_);
    monitor_.update(detail::difference(sample.tau_ext, explained), sample.jacobian, sample.dq, dt, time);
    since_expected_ += dt;
    if (since_expected_ >= kExpect - 1e-9) expect(sample.jacobian);
  }
  /// Takes over what the tracker makes of a block.
  /// @param block   the block
  /// @param belief  after it
  /// @param events  after it
  void judge(const TorqueBlock<Scalar, Dofs>& block, const TrackerBelief<Scalar>& belief,
             const EventMonitor<Scalar>& events) noexcept {
    const PerMode<Scalar>& p = belief.probability;
    // A swing that has not gone to both sides yet explains what a touch would be.
    const bool settled = p[Mode::Empty] + p[Mode::Held] + p[Mode::Pouring] - belief.swing_begins > Scalar(kSettled);
    // Without a change, and unless something is poured, a payload that is estimated anew is the same one.
    const bool same = settled_ && settled && p[Mode::Pouring] < Scalar(0.5);
    settled_ = settled;
    take_in();
    Vector change = Vector::Zero();
    InertialVector<Scalar> step = InertialVector<Scalar>::Zero();
    if (settled) {
      step = detail::difference(body(belief), phi_);
      change = detail::product(explained_.regressor(), step);
      phi_ += step;
    }
    for (int j = 0; j < Dofs; ++j) {
      moved_[j] = std::max(Scalar(kMoved) * moved_[j], std::abs(change[j]));
      changed_ = changed_ || std::abs(change[j]) > monitor_.state().threshold[j];
    }
    expect_arm(belief);
    monitor_.judge(settled, block.end - static_cast<double>(block.duration));
    know(block, belief);
    if (settled && (!same || monitor_.state().contact))
      for (Regressor& r : usual_) r.setZero();  // no mean has taken in any of a new payload's errors
    swing_ = belief.swing_square;
    expect(block.jacobian);
    if (same)
      monitor_.refine(change, {detail::product(usual_[0], step), detail::product(usual_[1], step)});
    else
      monitor_.replace(change);
    changed_ = changed_ || (monitor_.state().contact && belief.swinging - belief.swing_begins > Scalar(0.5));
    decide(events, p[Mode::Disturbed] > Scalar(0.5), block.end);
  }
  /// The host says something of the payload, and the tracker believes it: tau_ext may change at once.
  void told(const TrackerBelief<Scalar>& belief) noexcept {
    phi_ = body(belief);
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
  static constexpr double kExpect = 0.005;  // time between two computations of what the payload's errors may show [s]
  static constexpr double kKeep = 0.999;    // share of a payload's noise that is kept per block after it is gone
  static constexpr double kPatience = 0.5;  // how long after a contact an event may still be found that explains it [s]

  /// Payload and tool, phi.
  static InertialVector<Scalar> body(const TrackerBelief<Scalar>& belief) noexcept {
    InertialVector<Scalar> phi = detail::scaled(Scalar(1) - belief.empty, belief.payload.mean);
    for (int i = 0; i < 4; ++i) phi[i] += belief.tool[i];
    return phi;
  }

  /// What is known of the payload's errors after a block.
  void know(const TorqueBlock<Scalar, Dofs>& block, const TrackerBelief<Scalar>& belief) noexcept {
    const Scalar held = Scalar(1) - belief.empty;
    covariance_ = detail::scaled(held, belief.payload.covariance);
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
    // Kept for a while: what the arm has shown with a payload is not what it shows without.
    for (int i = 0; i < Monitor::kScales; ++i)
      noise_[i] = detail::scaled(Scalar(kKeep), noise_[i]).cwiseMax(detail::scaled(noise_gain_[i], noise));
  }
  /// What the errors of the payload add to the variance of the residual, (T62). A mean has taken in the error that is
  /// the same all the time: what counts is how the regressor differs from its own mean. What swings pulls at the hand.
  void expect(const Jacobian<Scalar, Dofs>& jacobian) noexcept {
    Vector known[Monitor::kScales];
    take_in();
    for (int i = 0; i < Monitor::kScales; ++i) {
      const Regressor change = detail::difference(explained_.regressor(), usual_[i]);
      for (int j = 0; j < Dofs; ++j) {
        const Scalar behind = Scalar(kBehind) * moved_[j];
        Scalar swings = Scalar(0);
        for (int axis = 0; axis < 3; ++axis) swings += jacobian(axis, j) * jacobian(axis, j) * swing_[axis];
        const InertialVector<Scalar> row = change.row(j).transpose();
        known[i][j] =
            behind * behind + swings + std::max(Scalar(0), detail::dot(row, detail::product(covariance_, row)));
      }
    }
    since_expected_ = 0;
    monitor_.expect(known, noise_);
  }

  /// What the kinds of sensing say of an arm of which nothing was seen yet.
  void expect_arm(const TrackerBelief<Scalar>& belief) noexcept {
    Scalar friction = Scalar(0), turn = Scalar(0);
    for (std::size_t k = 0; k < kSensings; ++k) {
      const SensingKind& kind = kSensingKinds[k];
      friction += belief.sensing[k] * static_cast<Scalar>(kind.friction);
      turn += belief.sensing[k] * static_cast<Scalar>(kind.residual * kind.residual * kind.stiction);
    }
    monitor_.expect_arm(friction, turn);
  }
  /// How the means depend on the payload's errors, now.
  void take_in() noexcept {
    for (int i = 0; i < Monitor::kScales; ++i) {
      const Vector share = monitor_.taken_in(i);
      for (int j = 0; j < Dofs; ++j) usual_[i].row(j) += share[j] * (explained_.regressor().row(j) - usual_[i].row(j));
    }
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

  ExplainedTorque<Scalar, Dofs> explained_;
  InertialVector<Scalar> phi_ = InertialVector<Scalar>::Zero();
  Monitor monitor_;
  Scalar noise_gain_[Monitor::kScales];
  Regressor usual_[Monitor::kScales] = {Regressor::Zero(), Regressor::Zero()};  // means, as those of the residual
  Eigen::Matrix<Scalar, kInertial, kInertial> covariance_ = Eigen::Matrix<Scalar, kInertial, kInertial>::Zero();
  Vector3<Scalar> swing_ = Vector3<Scalar>::Zero();                    // mean square of the swing's force [N^2]
  double since_expected_ = 0;                                          // [s]
  Vector noise_[Monitor::kScales] = {Vector::Zero(), Vector::Zero()};  // of the acceleration [(N m)^2]
  Vector moved_ = Vector::Zero();                                      // last changes of the explanation [N m]
  bool settled_ = true;                                                // payload and arm explained the last block
  int number_ = 0;                                                     // of the contact that disturbed_ belongs to
  bool disturbed_ = false;                                             // a block was disturbed during the contact
  bool changed_ = false;  // since the contact began, the payload that explains the torque has changed, or has swung
};

}  // namespace rme
