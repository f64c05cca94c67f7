#pragma once
/// The output of a PublishedPipeline.
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

/// The output of a PublishedPipeline; no field is true for one tick only. Times count from construction or reset [s].
template <typename Scalar>
struct PublishedState {
  PublishedPhase phase = PublishedPhase::Watching;  ///< watching or collecting
  std::uint64_t detections = 0;                     ///< collections begun so far
  std::uint64_t estimates = 0;                      ///< made so far
  double detected_at = 0;                           ///< time of the last detection; means nothing before the first
  double estimated_at = 0;                          ///< time of the last estimate; means nothing before the first
  /// The last estimate: of everything in the hand, not of what was added last. Its covariance is diagonal. Before the
  /// first the mean is zero, an empty hand, and the covariance means nothing.
  PayloadGaussian<Scalar> posterior;
  int iterations = 0;  ///< steps of the variational inference that made it
  /// How the last inference ended: NotReady before the first; Ok (early stop) or NotConverged (all steps taken), both
  /// with a valid estimate; otherwise it gave no estimate, and the one before it stays.
  Status outcome = Status::NotReady;
};

}  // namespace rme
