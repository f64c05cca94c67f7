// A guard, not #pragma once: g++ forgets the pragma of a header that came in through a precompiled one.
#ifndef RME_TESTS_SUPPORT_CATCH_HPP
#define RME_TESTS_SUPPORT_CATCH_HPP
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
#endif
