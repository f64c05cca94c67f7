#pragma once
/// How a JSON value is named in an error message.
#include <cmath>
#include <cstddef>
#include <nlohmann/json.hpp>
#include <string>

namespace rme::detail {

/// A short text for any value. For an array only its size: writing out its entries would recurse, and may be long.
inline std::string describe(const nlohmann::json& value) {
  if (value.is_array()) return "an array of " + std::to_string(value.size());
  if (value.is_object()) return "an object";
  if (value.is_number_float() && !std::isfinite(value.get<double>())) return std::to_string(value.get<double>());
  std::string text = value.dump(-1, ' ', false, nlohmann::json::error_handler_t::replace);
  constexpr std::size_t longest = 60;
  if (text.size() > longest) {
    text.resize(longest);
    text += "...";
  }
  return text;
}

}  // namespace rme::detail
