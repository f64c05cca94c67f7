#pragma once
/// One account of what has happened to the hand so far, with its filter.
#include <cmath>
#include <optional>
#include <rme/core/types.hpp>
#include <rme/tracking/disturbance.hpp>
#include <rme/tracking/mode.hpp>
#include <rme/tracking/pour.hpp>
#include <rme/tracking/star_gaussian.hpp>
#include <rme/tracking/swing.hpp>
#include <rme/tracking/undecided.hpp>

namespace rme {

/// A story: what it says of the last block, which payload is held, and the filter that follows from it.
template <typename Scalar, int Dofs>
struct Story {
  StarGaussian<Scalar, Dofs> star;        ///< while changing or disturbed, the payload is as it was before
  Disturbance<Scalar, Dofs> disturbance;  ///< of Mode::Disturbed
  Pour<Scalar, Dofs> pour;                ///< of Mode::Pouring
  Swing<Scalar, Dofs> swing;              ///< if the payload swings: star.swings()
  Undecided<Scalar> undecided;            ///< part of the payload that may be no weight
  Mode mode = Mode::Empty;                ///< of the last block
  Disturbing how = Disturbing::Hand;      ///< of Mode::Disturbed
  bool quick = false;                     ///< of Mode::Pouring: it is taken up quickly
  bool tilted = false;               ///< the base is tilted, and the host does not say what gravity does to the arm
  int payload = 0;                   ///< which payload is held; 0 for none
  int next = 1;                      ///< name of the payload that will be held next
  Scalar held_for = Scalar(0);       ///< since the payload was drawn, disturbed blocks left out [s]
  Scalar log_weight = Scalar(0);     ///< log probability
  Scalar log_plausible = Scalar(0);  ///< log probability that the mass is plausible, as counted so far
  /// Log density at phi = 0 of the prior that the payload was drawn from; only if it was drawn, and nothing poured
  /// since.
  std::optional<Scalar> log_none;

  /// Whether both say the same of the present. They may differ in when it began.
  bool same(const Story& other) const noexcept {
    return mode == other.mode && payload == other.payload && (mode != Mode::Disturbed || how == other.how) &&
           (mode != Mode::Pouring || quick == other.quick) && star.swings() == other.star.swings() &&
           tilted == other.tilted && star.gains_off() == other.star.gains_off();
  }
  /// Mean of the tool error, (m, m r) [kg, kg m].
  Vector4<Scalar> tool_mean() const noexcept {
    return star.swings() ? swing.tool_mean() : Vector4<Scalar>(star.mean().template segment<4>(kTool));
  }
  /// Nothing pours or swings any more; what was poured is part of the payload.
  void settle() noexcept {
    pour.end(star);
    swing.end(star);
  }
  /// The name of a payload that is held from now on.
  int take_next() noexcept { return next++; }
  /// Whether a payload, or none, explains the last block.
  bool settled() const noexcept { return mode != Mode::Disturbed && mode != Mode::Changing; }
};

}  // namespace rme
