#pragma once
/// The output of a PublishedPipeline.
#include <cstdint>
#include <rme/core/status.hpp>
#include <rme/inference/payload_gaussian.hpp>

namespace rme {

/// What a PublishedPipeline is doing.
enum class PublishedPhase : std::uint8_t {
  Watching,    ///< waits for Algorithm 1 to detect a mismatch
  Collecting,  ///< has detected a mismatch; collects the samples of an estimate
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

/// The output of a PublishedPipeline; no field is set for one tick only. Times count from construction or reset [s].
template <typename Scalar>
struct PublishedState {
  PublishedPhase phase = PublishedPhase::Watching;  ///< watching or collecting
  std::uint64_t detections = 0;                     ///< number of collections that have begun
  std::uint64_t estimates = 0;                      ///< number of estimates so far
  double detected_at = 0;                           ///< time of the last detection; 0 before the first
  double estimated_at = 0;                          ///< time of the last estimate; 0 before the first
  /// The last estimate: of everything in the hand, not of what was added last [kg, m, m, m]. Its covariance is
  /// diagonal with the solvers Stochastic and MeanField. Before the first estimate, the mean is zero (an empty hand)
  /// and the covariance has no meaning.
  PayloadGaussian<Scalar> posterior;
  int iterations = 0;  ///< of the solver for the last estimate (InferenceResult::iterations)
  /// How the last inference ended. NotReady: there was none yet. Ok and NotConverged (all steps were taken): the
  /// estimate is valid. Otherwise the inference gave no estimate, and the previous one stays.
  Status outcome = Status::NotReady;
};

}  // namespace rme
