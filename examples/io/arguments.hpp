#pragma once
/// Command lines of the example programs: options that are not understood are refused, never skipped.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <filesystem>
#include <optional>
#include <stdexcept>
#include <string>
#include <string_view>
#include <system_error>
#include <utility>
#include <vector>

#include "io/number.hpp"

namespace rme::examples {

/// Says what is wrong with a command line. Programs print it with their usage and end with exit code 2.
class ArgumentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Makes the folder that an option names, if need be.
/// @throws ArgumentError naming the option if that cannot be
inline void make_folder(const std::string& option, const std::string& folder) {
  std::error_code error;
  std::filesystem::create_directories(folder, error);
  if (error) throw ArgumentError(option + ": cannot make " + folder + ": " + error.message());
}

/// Hands out the words of a command line. Each question takes what answers it; finish() refuses what is left:
///
///     Arguments arguments(argc, argv);
///     const double mass = arguments.number("--mass").value_or(1.1);
///     const bool json = arguments.flag("--json");
///     const std::string log = arguments.positional("LOG.csv");  // options first: this takes the first word left
///     arguments.finish();
class Arguments {
 public:
  Arguments(int argc, const char* const* argv) : words_(argv + std::min(argc, 1), argv + argc) {}

  /// Whether the option is there.
  bool flag(const std::string& option) {
    const auto found = std::find(words_.begin(), words_.end(), option);
    if (found == words_.end()) return false;
    words_.erase(found);
    if (std::find(words_.begin(), words_.end(), option) != words_.end()) throw ArgumentError(option + ": given twice");
    return true;
  }

  /// The word after the option, or nothing if the option is not there.
  std::optional<std::string> text(const std::string& option) {
    const auto found = std::find(words_.begin(), words_.end(), option);
    if (found == words_.end()) return std::nullopt;
    if (found + 1 == words_.end() || is_option(found[1])) throw ArgumentError(option + ": needs a value");
    std::string value = found[1];
    words_.erase(found + 1);
    flag(option);  // takes the option itself, and refuses a second one
    return value;
  }

  /// The finite numbers after the option, `count` of them with `separator` in between: --com 0.05,0.02,0.13.
  std::optional<std::vector<double>> numbers(const std::string& option, std::size_t count, char separator = ',') {
    const auto value = text(option);
    if (!value) return std::nullopt;
    std::vector<double> parsed;
    for (std::size_t begin = 0, end = 0; begin <= value->size(); begin = end + 1) {
      end = std::min(value->find(separator, begin), value->size());
      const auto number = parse_number(std::string_view(*value).substr(begin, end - begin));
      if (!number) throw ArgumentError(option + ": \"" + *value + "\" is not " + expected(count, separator));
      parsed.push_back(*number);
    }
    if (parsed.size() != count)
      throw ArgumentError(option + ": \"" + *value + "\" is not " + expected(count, separator));
    return parsed;
  }

  /// The finite number after the option.
  std::optional<double> number(const std::string& option) {
    const auto value = numbers(option, 1);
    return value ? std::optional<double>(value->front()) : std::nullopt;
  }

  /// The whole number after the option, from `least` to `most`.
  std::optional<std::size_t> whole(const std::string& option, std::size_t least, std::size_t most = 1000000000) {
    const auto value = number(option);
    if (!value) return std::nullopt;
    if (!(*value >= static_cast<double>(least) && *value <= static_cast<double>(most) && *value == std::floor(*value)))
      throw ArgumentError(option + ": must be a whole number from " + std::to_string(least) + " to " +
                          std::to_string(most));
    return static_cast<std::size_t>(*value);
  }

  /// The value that goes with the name after the option.
  template <typename Value>
  std::optional<Value> choice(const std::string& option, const std::vector<std::pair<std::string, Value>>& choices) {
    const auto name = text(option);
    if (!name) return std::nullopt;
    std::string all;
    for (const auto& [known, value] : choices) {
      if (known == *name) return value;
      all += (all.empty() ? "" : ", ") + known;
    }
    throw ArgumentError(option + ": \"" + *name + "\" is none of " + all);
  }

  /// The first word left, which must not be an option.
  /// @param meaning  what to call it if it is missing, e.g. "LOG.csv"
  std::string positional(const std::string& meaning) {
    if (words_.empty()) throw ArgumentError(meaning + ": missing");
    if (is_option(words_.front())) throw ArgumentError(words_.front() + ": unknown option");
    std::string word = words_.front();
    words_.erase(words_.begin());
    return word;
  }

  /// Whether every word has been taken.
  bool empty() const noexcept { return words_.empty(); }

  /// Refuses whatever no question has taken.
  void finish() const {
    if (words_.empty()) return;
    throw ArgumentError(words_.front() + (is_option(words_.front()) ? ": unknown option" : ": one word too many"));
  }

 private:
  // "-1" is a value, "--at" and "-h" are not.
  static bool is_option(const std::string& word) { return word.size() > 1 && word[0] == '-' && !parse_number(word); }
  static std::string expected(std::size_t count, char separator) {
    return count == 1 ? "a finite number"
                      : std::to_string(count) + " finite numbers with '" + separator + "' in between";
  }

  std::vector<std::string> words_;
};

}  // namespace rme::examples
