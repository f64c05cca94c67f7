#pragma once
/// A fuzzer's input as JSON.
#include <cstddef>
#include <cstdint>
#include <exception>
#include <nlohmann/json.hpp>
#include <optional>
#include <sstream>
#include <string>

#include "io/json_file.hpp"

namespace fuzzing {

/// The JSON value that the bytes are, or nothing.
inline std::optional<nlohmann::json> json_of(const std::uint8_t* data, std::size_t size) {
  std::istringstream text(std::string(reinterpret_cast<const char*>(data), size));
  try {
    return rme::examples::parse_strictly(text);
  } catch (const std::exception&) {
    return std::nullopt;
  }
}

}  // namespace fuzzing
