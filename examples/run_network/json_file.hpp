#pragma once
// Reads a JSON file, strictly: one value, no key twice in an object, no number too large for a double.
#include <fstream>
#include <istream>
#include <nlohmann/json.hpp>
#include <set>
#include <stdexcept>
#include <string>
#include <vector>

namespace rme::examples {

/// The JSON value that a text consists of.
/// @throws std::exception saying where it is not JSON
inline nlohmann::json parse_strictly(std::istream& text) {
  using nlohmann::json;
  // nlohmann-json keeps the last of two equal keys without a word.
  std::vector<std::set<std::string>> keys;
  const auto refuse_duplicates = [&](int, json::parse_event_t event, json& parsed) {
    if (event == json::parse_event_t::object_start) keys.emplace_back();
    if (event == json::parse_event_t::object_end) keys.pop_back();
    if (event == json::parse_event_t::key && !keys.back().insert(parsed.get<std::string>()).second) {
      throw std::runtime_error("the key " + parsed.dump() + " stands twice in one object");
    }
    return true;
  };
  return json::parse(text, refuse_duplicates);
}

/// The JSON value in a file.
/// @throws std::runtime_error naming the file, and the line where it is not JSON
inline nlohmann::json read_json_file(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be opened");
  try {
    return parse_strictly(file);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace rme::examples
