#include "io/arguments.hpp"

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <system_error>

#include "io/number.hpp"

namespace rme::examples {

namespace {

/// "-1" and "-9.81,0,0" are values, "--at" and "-h" are not.
bool is_option(const std::string& word) {
  return word.size() > 1 && word[0] == '-' && !parse_number(word.substr(0, word.find(',')));
}

std::string expected(std::size_t count, char separator) {
  return count == 1 ? "a finite number" : std::to_string(count) + " finite numbers with '" + separator + "' in between";
}

}  // namespace

void make_folder(const std::string& option, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw ArgumentError(option + ": cannot make " + folder + ": " + error.message());
}

Arguments::Arguments(int argc, const char* const* argv) : words_(argv + std::min(argc, 1), argv + argc), all_(words_) {}

bool Arguments::flag(const std::string& option) {
  const auto found = std::find(words_.begin(), words_.end(), option);
  if (found == words_.end()) return false;
  words_.erase(found);
  if (std::find(words_.begin(), words_.end(), option) != words_.end()) throw ArgumentError(option + ": given twice");
  return true;
}

std::optional<std::string> Arguments::text(const std::string& option) {
  const auto found = std::find(words_.begin(), words_.end(), option);
  if (found == words_.end()) return std::nullopt;
  if (found + 1 == words_.end() || is_option(found[1])) throw ArgumentError(option + ": needs a value");
  std::string value = found[1];
  words_.erase(found + 1);
  flag(option);  // takes the option itself, and refuses a second one
  return value;
}

std::optional<std::vector<double>> Arguments::numbers(const std::string& option, std::size_t count, char separator) {
  const auto value = text(option);
  if (!value) return std::nullopt;
  std::vector<double> parsed;
  for (std::size_t begin = 0, end = 0; begin <= value->size(); begin = end + 1) {
    end = std::min(value->find(separator, begin), value->size());
    const auto number = parse_number(std::string_view(*value).substr(begin, end - begin));
    if (!number) throw ArgumentError(option + ": \"" + *value + "\" is not " + expected(count, separator));
    parsed.push_back(*number);
  }
  if (parsed.size() != count) throw ArgumentError(option + ": \"" + *value + "\" is not " + expected(count, separator));
  return parsed;
}

std::optional<double> Arguments::number(const std::string& option) {
  const auto value = numbers(option, 1);
  return value ? std::optional<double>(value->front()) : std::nullopt;
}

std::optional<std::size_t> Arguments::whole(const std::string& option, std::size_t least, std::size_t most) {
  const auto value = number(option);
  if (!value) return std::nullopt;
  if (!(*value >= static_cast<double>(least) && *value <= static_cast<double>(most) && *value == std::floor(*value)))
    throw ArgumentError(option + ": must be a whole number from " + std::to_string(least) + " to " +
                        std::to_string(most));
  return static_cast<std::size_t>(*value);
}

std::string Arguments::positional(const std::string& meaning) {
  if (words_.empty()) throw ArgumentError(meaning + ": missing");
  if (is_option(words_.front())) throw ArgumentError(words_.front() + ": unknown option");
  std::string word = words_.front();
  words_.erase(words_.begin());
  return word;
}

std::string Arguments::with(const std::string& options) const {
  std::vector<std::string> words = all_, more;
  for (std::size_t i = 0; i < options.size();) {  // words end at spaces that are not between quotes
    std::string word;
    bool quoted = false;
    for (; i < options.size() && (quoted || options[i] != ' '); ++i) {
      if (options[i] == '\'')
        quoted = !quoted;
      else
        word += options[i];
    }
    ++i;
    if (!word.empty()) more.push_back(word);
  }
  for (std::size_t i = 0; i < more.size();) {
    const std::string option = more[i++];
    const bool has_value = i < more.size() && !is_option(more[i]);
    const auto given = std::find(words.begin(), words.end(), option);
    if (given != words.end()) words.erase(given, has_value ? given + 2 : given + 1);
    words.push_back(option);
    if (has_value) words.push_back(more[i++]);
  }
  std::string out;
  for (const std::string& word : words) {
    const bool plain = word.find_first_of(" *'\"$&;()<>|?[]{}~#!\\") == std::string::npos && !word.empty();
    out += (out.empty() ? "" : " ") + (plain ? word : "'" + word + "'");
  }
  return out;
}

void Arguments::finish() const {
  if (words_.empty()) return;
  throw ArgumentError(words_.front() + (is_option(words_.front()) ? ": unknown option" : ": one word too many"));
}

}  // namespace rme::examples
