#pragma once
/// Command lines of the example programs. Unknown options are refused, never skipped.
#include <cstddef>
#include <optional>
#include <stdexcept>
#include <string>
#include <utility>
#include <vector>

namespace rme::examples {

/// Says what is wrong with a command line. Programs print it with their usage and end with exit code 2.
class ArgumentError : public std::runtime_error {
 public:
  using std::runtime_error::runtime_error;
};

/// Creates the folder that an option names, if it does not exist.
/// @throws ArgumentError naming the option if the folder cannot be created
void make_folder(const std::string& option, const std::string& folder);

/// The words of a command line. Each call removes the words that it reads; finish() refuses all that are left:
///
///     Arguments arguments(argc, argv);
///     const double mass = arguments.number("--mass").value_or(1.1);
///     const bool json = arguments.flag("--json");
///     const std::string log = arguments.positional("LOG.csv");  // after all options: it takes the first word left
///     arguments.finish();
///
/// All calls throw ArgumentError if the option is given twice, or its value is missing or not of the kind.
class Arguments {
 public:
  Arguments(int argc, const char* const* argv);

  /// Whether the option is there.
  bool flag(const std::string& option);

  /// The word after the option, or nothing if the option is not there.
  std::optional<std::string> text(const std::string& option);

  /// The finite numbers after the option, `count` of them with `separator` in between: --com 0.05,0.02,0.13.
  std::optional<std::vector<double>> numbers(const std::string& option, std::size_t count, char separator = ',');

  /// The finite number after the option.
  std::optional<double> number(const std::string& option);

  /// The whole number after the option, from `least` to `most`.
  std::optional<std::size_t> whole(const std::string& option, std::size_t least, std::size_t most = 1000000000);

  /// The value that belongs to the name after the option.
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
  /// @param meaning  its name in the message if it is missing, such as "LOG.csv"
  std::string positional(const std::string& meaning);

  /// Whether every word has been taken.
  bool empty() const noexcept { return words_.empty(); }

  /// All words as a shell takes them, whether taken or not, with these options in addition, or in place of those given.
  /// @param options  as a user would type them: "--columns 'q=p_*' --degrees"
  std::string with(const std::string& options) const;

  /// Refuses the words that no call has taken.
  void finish() const;

 private:
  std::vector<std::string> words_;
  std::vector<std::string> all_;
};

}  // namespace rme::examples
