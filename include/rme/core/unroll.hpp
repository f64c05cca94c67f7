#pragma once
/// Unrolls short loops, which g++ and clang do not always do at -O2.

/// In front of a loop of at most eight turns. A compiler that has no such request leaves the loop as it is.
#if defined(__GNUC__)
#define RME_UNROLL _Pragma("GCC unroll 8")
#else
#define RME_UNROLL
#endif
