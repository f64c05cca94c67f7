#pragma once
/// All that a host can read from an Estimator, as one plain struct.
#include <algorithm>
#include <array>
#include <cmath>
#include <rme/core/payload.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/event_monitor.hpp>
#include <rme/tracking/mode.hpp>
#include <rme/tracking/payload_belief.hpp>

namespace rme {

/// The current estimate, and what happens to the payload. Times count from the estimator's construction or reset [s].
template <typename Scalar>
struct EstimatorState {
  double time = 0;     ///< of the last sample
  double updated = 0;  ///< of the last sample in the estimate: behind `time` by a block and the time to compute it
  /// Mass and centre of mass of all that is in the hand [kg, m, m, m], end-effector axes. While empty() holds, the
  /// centre of mass is zero, with the prior's standard deviations.
  PayloadGaussian<Scalar> payload;
  /// The ten inertial parameters (inertial_parameters.hpp) with their covariance, given that something is held. Unlike
  /// that of `payload`, this covariance does not grow with `health`.
  InertialGaussian<Scalar> inertial;
  PerMode<Scalar> probability = {{Scalar(1)}};  ///< of each mode, sum 1; at first an empty hand
  Scalar held = Scalar(0);                      ///< probability that something is held, disturbed or not
  Scalar swinging = Scalar(0);                  ///< probability that what is held swings: it hangs, or the grip is soft
  Scalar swing_frequency = Scalar(0);           ///< of the swing [Hz]; 0 if it is not known
  /// Share of `payload` that may be no weight, but something rigid that holds the hand: what has appeared little by
  /// little since the hand last moved up or down. A fifth of it is carried (docs/contact.md).
  Scalar undecided = Scalar(0);
  /// How far to trust `payload`, 0 to 1: m^2 / (m^2 + std^2), divided by health / 3 while health is above 3.
  Scalar confidence = Scalar(0);
  /// Normalised innovation squared, averaged over the last second (docs/theory.md (T30)): about 1 or less if the torque
  /// is as the model and this payload predict it, above 10 if not; 100 at most. Above 3, the covariance of `payload` is
  /// multiplied by health / 3.
  Scalar health = Scalar(1);
  std::array<Scalar, kSensings> sensing{};  ///< probability of each kind of torque sensing (Sensing), sum 1
  /// (m, m r) [kg, kg m] of what the robot's own model lacks at the last link, end-effector axes: the error of its
  /// tool, learned in motion, and what Estimator::tare() has counted as tool. It is no part of `payload`, and is
  /// carried with it.
  Vector4<Scalar> tool = Vector4<Scalar>::Zero();
  bool changing = false;      ///< an event is going on
  double change_onset = 0;    ///< when the current or the last event began
  double change_noticed = 0;  ///< when that event was noticed
  Event event;                ///< the last event that is over

  /// Probability that what is held is heavier than this.
  /// @param mass  [kg], >= 0
  Scalar heavier_than(Scalar mass) const noexcept {
    const Scalar variance = inertial.covariance(0, 0) * std::max(Scalar(1), health / Scalar(kHealthy));
    const Scalar above = inertial.mean[0] - mass;
    if (!(variance > 0)) return above > 0 ? held : Scalar(0);
    return held * Scalar(0.5) * std::erfc(-above / std::sqrt(2 * variance));
  }
  static constexpr double kHealthy = 3;  ///< health up to which the covariance of `payload` is not increased

  /// Whether the hand is probably empty.
  bool empty() const noexcept { return held < Scalar(0.5); }
  /// Probability that tau_ext contains joint friction.
  Scalar friction_shows() const noexcept { return Scalar(1) - sensing[static_cast<std::size_t>(Sensing::LinkSide)]; }
};

}  // namespace rme
