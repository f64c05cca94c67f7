#pragma once
// Counts heap allocations: Eigen calls malloc, the standard library operator new, which calls malloc. Replaces malloc,
// so only one file of a program may include it. RME_COUNTS_ALLOCATIONS is defined where that works.
#include <cstddef>
#include <cstdlib>

#if defined(__GLIBC__) && !defined(__SANITIZE_ADDRESS__)
#define RME_COUNTS_ALLOCATIONS
namespace {
int allocations = 0;
}
extern "C" void* __libc_malloc(std::size_t);
extern "C" void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
#endif
