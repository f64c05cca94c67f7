#pragma once
/// What may have happened to the payload in a block of samples.
#include <array>
#include <cstddef>
#include <cstdint>

namespace rme::bank {

/// What may have happened to the payload in a block. There is one filter for each hypothesis, all with the same state
/// (docs/theory.md, "Hypotheses").
enum class Hypothesis : std::uint8_t {
  Empty,      ///< nothing is in the hand
  Steady,     ///< the payload is the same as in the block before
  Filling,    ///< the payload's mass drifts
  Exchanged,  ///< the payload is another one: attached, added to, or taken off in part
  Pushed,     ///< the payload is the same, and a wrench acts in addition
};
inline constexpr std::size_t kHypotheses = 5;  ///< number of hypotheses

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

/// One value for each hypothesis.
template <typename Scalar>
struct PerHypothesis {
  std::array<Scalar, kHypotheses> values{};  ///< in the order of the enumerators
  /// The value for h.
  Scalar& operator[](Hypothesis h) noexcept { return values[static_cast<std::size_t>(h)]; }
  /// The value for h.
  const Scalar& operator[](Hypothesis h) const noexcept { return values[static_cast<std::size_t>(h)]; }
};

/// P(hypothesis of this block | hypothesis of the block before), the T of docs/theory.md (T19): rows from, columns to.
/// While nothing happens, an exchange and a push are each expected once in 20 s. On average, an exchange lasts three
/// blocks of 20 ms, a push 0.7 s and filling 2.7 s. The log evidence of a block is tens of nats, so a factor of two or
/// three in a probability does not matter. Therefore the table also serves for the blocks of up to 60 ms of an arm with
/// noisy dq.
inline constexpr std::array<std::array<double, kHypotheses>, kHypotheses> kTransitions = {{
    // Empty  Steady  Filling Exchanged Pushed
    {0.9978, 0, 0.0002, 0.001, 0.001},      // from Empty
    {0.0003, 0.9967, 0.001, 0.001, 0.001},  // from Steady
    {0.0003, 0.003, 0.9927, 0.002, 0.002},  // from Filling
    {0.010, 0.29, 0.005, 0.69, 0.005},      // from Exchanged
    {0.012, 0.012, 0.002, 0.003, 0.971},    // from Pushed
}};

}  // namespace rme::bank
