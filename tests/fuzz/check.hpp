#pragma once
/// How a fuzzer reports a property that does not hold.
#include <cstdlib>

namespace fuzzing {

/// Ends the program, which libFuzzer takes for a crash, unless `good`.
inline void check(bool good) {
  if (!good) std::abort();
}

}  // namespace fuzzing
