#pragma once
/// Strict parsing of numbers, for logs and command lines.
#include <charconv>
#include <cmath>
#include <optional>
#include <string_view>

namespace rme::examples {

/// `text` without the spaces and tabs around it.
inline std::string_view trimmed(std::string_view text) noexcept {
  const std::size_t first = text.find_first_not_of(" \t");
  if (first == std::string_view::npos) return {};
  return text.substr(first, text.find_last_not_of(" \t") - first + 1);
}

/// The finite number that `text` consists of, with spaces around it allowed, in any locale; nothing otherwise.
inline std::optional<double> parse_number(std::string_view text) noexcept {
  text = trimmed(text);
  // from_chars knows no '+'; it would take the sign of "+-1", which is not a number.
  if (text.size() > 1 && text[0] == '+' && text[1] != '-') text.remove_prefix(1);
  double value = 0;
  const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), value);
  if (error != std::errc() || end != text.data() + text.size() || !std::isfinite(value)) return std::nullopt;
  return value;
}

}  // namespace rme::examples
