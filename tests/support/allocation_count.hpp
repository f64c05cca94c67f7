#pragma once
// Counts heap allocations: Eigen calls malloc, the standard library operator new, which calls malloc or, for types that
// ask for more alignment, aligned_alloc. Link rme_allocation_count, which replaces the C library's functions.
// RME_COUNTS_ALLOCATIONS is defined where that works.
#include <cstdlib>

// Two compilers, two ways to say that a sanitizer brings a heap of its own.
#if defined(__SANITIZE_ADDRESS__)
#define RME_ADDRESS_SANITIZER
#elif defined(__has_feature)
#if __has_feature(address_sanitizer)
#define RME_ADDRESS_SANITIZER
#endif
#endif

#if defined(__GLIBC__) && !defined(RME_ADDRESS_SANITIZER)
#define RME_COUNTS_ALLOCATIONS
namespace rme::testing {

/// Of this program, so far.
int allocations() noexcept;

}  // namespace rme::testing
#endif
