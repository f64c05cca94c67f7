#pragma once
/// Checks of settings, at construction and when JSON is read. rme throws nowhere else.
#include <cmath>
#include <string>
#if defined(__cpp_exceptions)
#include <stdexcept>
#else
#include <cstdlib>
#endif

namespace rme::detail {

/// Refuses a configuration value: throws std::invalid_argument. Without exceptions (-fno-exceptions) it aborts. That is
/// safe, since objects are constructed before the control loop starts.
[[noreturn]] inline void refuse(const std::string& message) {
#if defined(__cpp_exceptions)
  throw std::invalid_argument(message);
#else
  (void)message;
  std::abort();
#endif
}

/// Refuses `value` unless `good`. Write the condition so that a NaN fails it: require(x > 0, ...), not !(x <= 0).
/// @param field     what a user would have to change, e.g. "MismatchDetectorConfig::window"
/// @param expected  e.g. "> 0 s"
template <typename Scalar>
void require(bool good, const char* field, const char* expected, Scalar value) {
  if (!good) refuse(std::string(field) + ": expected " + expected + ", got " + std::to_string(value));
}

/// Refuses `value` unless it is finite and above zero.
template <typename Scalar>
void require_positive(Scalar value, const char* field, const char* expected) {
  require(value > 0 && std::isfinite(value), field, expected, value);
}

}  // namespace rme::detail
