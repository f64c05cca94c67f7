#pragma once
/// What may have happened to the payload in a block of samples.
#include <array>
#include <cstddef>
#include <cstdint>

namespace rme {

/// Each is a filter over the same state; they differ in what may have happened (docs/theory.md, "Hypotheses").
enum class Hypothesis : std::uint8_t {
  Empty,      ///< nothing in the hand
  Steady,     ///< the payload is what it was
  Filling,    ///< its mass drifts
  Exchanged,  ///< another payload: attached, added to, or taken off in part
  Pushed,     ///< a wrench acts in addition to the payload
};
inline constexpr std::size_t kHypotheses = 5;  ///< enumerators of Hypothesis

/// The enumerator's name, for logs.
constexpr const char* to_string(Hypothesis hypothesis) noexcept {
  switch (hypothesis) {
    case Hypothesis::Empty:
      return "empty";
    case Hypothesis::Steady:
      return "steady";
    case Hypothesis::Filling:
      return "filling";
    case Hypothesis::Exchanged:
      return "exchanged";
    case Hypothesis::Pushed:
      return "pushed";
  }
  return "unknown";
}

/// A number for each hypothesis.
template <typename Scalar>
struct PerHypothesis {
  std::array<Scalar, kHypotheses> values{};  ///< in the order of the enumerators
  /// That of h.
  Scalar& operator[](Hypothesis h) noexcept { return values[static_cast<std::size_t>(h)]; }
  /// That of h.
  const Scalar& operator[](Hypothesis h) const noexcept { return values[static_cast<std::size_t>(h)]; }
};

/// P(this block's hypothesis | the last block's): rows from, columns to. An exchange and a push are each expected once
/// in 20 s; a hand-over is done within three blocks; a push lasts 0.7 s, pouring 2.7 s (docs/theory.md (T19)). A
/// block's evidence is tens of nats, so that a factor of two or three does not matter; blocks of an arm with noisy dq
/// are longer by as much.
inline constexpr std::array<std::array<double, kHypotheses>, kHypotheses> kTransitions = {{
    // Empty  Steady  Filling Exchanged Pushed
    {0.9978, 0, 0.0002, 0.001, 0.001},      // from Empty
    {0.0003, 0.9967, 0.001, 0.001, 0.001},  // from Steady
    {0.0003, 0.003, 0.9927, 0.002, 0.002},  // from Filling
    {0.010, 0.29, 0.005, 0.69, 0.005},      // from Exchanged
    {0.012, 0.012, 0.002, 0.003, 0.971},    // from Pushed
}};

}  // namespace rme
