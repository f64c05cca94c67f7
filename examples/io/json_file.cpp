#include "io/json_file.hpp"

#include <fstream>
#include <istream>
#include <set>
#include <stdexcept>
#include <vector>

namespace rme::examples {

nlohmann::json parse_strictly(std::istream& text) {
  using nlohmann::json;
  // Without this, nlohmann-json would silently keep the last of two equal keys.
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

nlohmann::json read_json_file(const std::string& path) {
  std::ifstream file(path);
  if (!file) throw std::runtime_error(path + ": cannot be opened");
  try {
    return parse_strictly(file);
  } catch (const std::exception& error) {
    throw std::runtime_error(path + ": " + error.what());
  }
}

}  // namespace rme::examples
