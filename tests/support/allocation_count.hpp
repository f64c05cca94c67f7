#pragma once
// Counts heap allocations: Eigen calls malloc, the standard library operator new, which calls malloc or, for types that
// ask for more alignment, aligned_alloc. Replaces the C library's functions, so only one file of a program may include
// it. RME_COUNTS_ALLOCATIONS is defined where that works.
#include <cstddef>
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
namespace {
int allocations = 0;
}
extern "C" void* __libc_malloc(std::size_t);
extern "C" void* __libc_calloc(std::size_t, std::size_t);
extern "C" void* __libc_realloc(void*, std::size_t);
extern "C" void* __libc_memalign(std::size_t, std::size_t);
extern "C" void* malloc(std::size_t size) {
  ++allocations;
  return __libc_malloc(size);
}
extern "C" void* calloc(std::size_t count, std::size_t size) {
  ++allocations;
  return __libc_calloc(count, size);
}
extern "C" void* realloc(void* block, std::size_t size) {
  ++allocations;
  return __libc_realloc(block, size);
}
extern "C" void* aligned_alloc(std::size_t alignment, std::size_t size) {
  ++allocations;
  return __libc_memalign(alignment, size);
}
#endif
