#pragma once
/// Counts what a loop allocates.
#include "support/allocation_count.hpp"

#ifdef RME_COUNTS_ALLOCATIONS
namespace rme::testing {

/// Runs a loop, in which nothing may be CHECKed (Catch2 allocates), and says how often it went to the heap.
template <typename Loop>
int allocations_of(const Loop& loop) {
  const int before = allocations();
  loop();
  return allocations() - before;
}

}  // namespace rme::testing
#endif
