#pragma once
// Catch2 2 (Debian 12) and 3 (newer systems) behind one include.
#include <string>
#if RME_CATCH2_VERSION == 3
#include <catch2/catch_all.hpp>
using Catch::Approx;
/// Matcher: the text contains `part`.
inline auto contains(const std::string& part) {
  return Catch::Matchers::ContainsSubstring(part);
}
#else
#include <catch2/catch.hpp>
/// Matcher: the text contains `part`.
inline auto contains(const std::string& part) {
  return Catch::Matchers::Contains(part);
}
#endif
