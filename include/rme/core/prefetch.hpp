#pragma once
/// Memory that is asked for before it is needed.
#include <cstddef>

namespace rme::detail {

/// Asks for one of `shares` equal parts of [begin, end), to be in the cache by the time that it is used. In a control
/// loop megabytes of a host's other work pass between two uses of a network, and memory takes longer to bring
/// its weights than the arithmetic takes with them. Asked for all at once they would be queued rather than brought, so
/// that the calls belong between pieces of work. Without any effect but on time.
inline void prefetch(const void* begin, const void* end, int share, int shares) noexcept {
#ifdef __GNUC__
  constexpr std::ptrdiff_t line = 64;  // bytes
  const char* const first = static_cast<const char*>(begin);
  const std::ptrdiff_t lines = (static_cast<const char*>(end) - first + line - 1) / line;
  for (std::ptrdiff_t i = lines * share / shares; i < lines * (share + 1) / shares; ++i)
    __builtin_prefetch(first + line * i);
#else
  (void)begin, (void)end, (void)share, (void)shares;
#endif
}

}  // namespace rme::detail
