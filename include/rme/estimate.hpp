#pragma once
/// What an Estimator says, and where it is in its life cycle.
#include <cstdint>
#include <rme/core/payload.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>

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

/// An estimate and where it comes from. Times count from the estimator's construction or reset [s].
template <typename Scalar>
struct Estimate {
  PayloadGaussian<Scalar> posterior;  ///< of everything in the hand, not of what was added last
  bool empty = true;                  ///< nothing in the hand, as far as the torque can tell: the mean is then zero
  bool final = true;                  ///< from the whole event; else early, while it is still going on
  /// How much of the change to compensate for, 0 to 1: the odds against a push, times m^2 / (m^2 + std^2). 1 if final.
  Scalar confidence = Scalar(1);
  double detected_at = 0;                   ///< when the change had settled; of an early estimate when it was noticed
  double window_begin = 0, window_end = 0;  ///< of the samples used

  /// What to compensate for: the posterior's mean, or nothing for an empty hand.
  Payload<Scalar> payload() const noexcept { return empty ? Payload<Scalar>() : posterior.payload(); }
};

}  // namespace rme
