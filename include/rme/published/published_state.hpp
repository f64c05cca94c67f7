#pragma once
/// What a PublishedPipeline says, and what it is doing.
#include <cstdint>
#include <rme/core/status.hpp>
#include <rme/inference/payload_gaussian.hpp>

namespace rme {

/// What a PublishedPipeline is doing.
enum class PublishedPhase : std::uint8_t {
  Watching,    ///< waits for Algorithm 1 to detect a mismatch
  Collecting,  ///< has detected one; gathers the samples of an estimate
};

/// The enumerator's name, for logs.
constexpr const char* to_string(PublishedPhase phase) noexcept {
  switch (phase) {
    case PublishedPhase::Watching:
      return "Watching";
    case PublishedPhase::Collecting:
      return "Collecting";
  }
  return "unknown";
}

/// Everything that a PublishedPipeline says; nothing in it is true for one tick only. Instants count from construction
/// or reset [s].
template <typename Scalar>
struct PublishedState {
  PublishedPhase phase = PublishedPhase::Watching;  ///< watching or collecting
  std::uint64_t detections = 0;                     ///< collections begun so far
  std::uint64_t estimates = 0;                      ///< made so far
  double detected_at = 0;                           ///< tick of the last detection; of no meaning before the first
  double estimated_at = 0;                          ///< tick of the last estimate; of no meaning before the first
  /// The last estimate: of everything in the hand, not of what was added last. Its covariance is diagonal. Before the
  /// first the mean is zero, an empty hand, and the covariance means nothing.
  PayloadGaussian<Scalar> posterior;
  int iterations = 0;  ///< steps of the variational inference that made it
  /// How the last attempt at an estimate ended: NotReady before the first; Ok (the stop rule ended the inference) or
  /// NotConverged (its bound on steps did), both valid; else it made no estimate, and the one before it stands.
  Status outcome = Status::NotReady;
};

}  // namespace rme
