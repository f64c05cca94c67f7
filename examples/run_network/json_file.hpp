#pragma once
// Reads a JSON file, strictly: one value, no key twice in an object, no number too large for a double.
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>

namespace rme::examples {

/// The JSON value that a text consists of.
/// @throws std::exception saying where it is not JSON
nlohmann::json parse_strictly(std::istream& text);

/// The JSON value in a file.
/// @throws std::runtime_error naming the file, and the line where it is not JSON
nlohmann::json read_json_file(const std::string& path);

}  // namespace rme::examples
