#pragma once
/// What a story says of a block of samples.
#include <array>
#include <cstddef>
#include <cstdint>

namespace rme {

/// What happens to the hand in a block (docs/theory.md, "Stories").
enum class Mode : std::uint8_t {
  Empty,      ///< nothing is in the hand
  Held,       ///< the payload is the same as in the block before
  Pouring,    ///< the payload's mass changes at an unknown, nearly constant rate
  Disturbed,  ///< the payload is the same, and something else acts on the arm in addition
  Changing,   ///< no payload explains this block: the old one is gone, and the next one is not all there yet
};
inline constexpr std::size_t kModes = 5;  ///< number of modes

/// The enumerator's name, for logs.
constexpr const char* to_string(Mode mode) noexcept {
  switch (mode) {
    case Mode::Empty:
      return "empty";
    case Mode::Held:
      return "held";
    case Mode::Pouring:
      return "pouring";
    case Mode::Disturbed:
      return "disturbed";
    case Mode::Changing:
      return "changing";
  }
  return "unknown";
}

/// One value for each mode.
template <typename Scalar>
struct PerMode {
  std::array<Scalar, kModes> values{};  ///< in the order of the enumerators
  /// The value for m.
  Scalar& operator[](Mode m) noexcept { return values[static_cast<std::size_t>(m)]; }
  /// The value for m.
  const Scalar& operator[](Mode m) const noexcept { return values[static_cast<std::size_t>(m)]; }
};

}  // namespace rme
