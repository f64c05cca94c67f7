#pragma once
// Reads a JSON file strictly: one value, no key twice in an object, no number too large for a double.
#include <iosfwd>
#include <nlohmann/json.hpp>
#include <string>

namespace rme::examples {

/// The JSON value of a text, which must contain nothing else.
/// @throws std::exception saying where the text is not JSON, or which key occurs twice
nlohmann::json parse_strictly(std::istream& text);

/// The JSON value in a file.
/// @throws std::runtime_error naming the file; if it is not JSON, the line too
nlohmann::json read_json_file(const std::string& path);

}  // namespace rme::examples
