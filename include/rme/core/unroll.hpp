#pragma once
/// Unrolls short loops, which g++ and clang do not always do at -O2.

/// Stands before a loop of at most eight turns. For a compiler without such a pragma it is empty.
#if defined(__GNUC__)
#define RME_UNROLL _Pragma("GCC unroll 8")
#else
#define RME_UNROLL
#endif
