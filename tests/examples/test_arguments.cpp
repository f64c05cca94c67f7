#include "io/arguments.hpp"

#include <string>
#include <vector>

#include "support/catch.hpp"

namespace {

using rme::examples::ArgumentError;
using rme::examples::Arguments;

Arguments arguments(std::vector<const char*> words) {
  words.insert(words.begin(), "program");
  return Arguments(static_cast<int>(words.size()), words.data());
}

TEST_CASE("Arguments: options and the positional word are found in any order", "[arguments]") {
  for (const auto& words : std::vector<std::vector<const char*>>{
           {"--json", "--at", "-1.5", "--com", "1,-2,3e-1", "log.csv"},
           {"log.csv", "--com", "1,-2,3e-1", "--at", "-1.5", "--json"},
       }) {
    Arguments given = arguments(words);
    CHECK(given.flag("--json"));
    CHECK(given.number("--at") == -1.5);
    CHECK(given.numbers("--com", 3) == std::vector<double>{1, -2, 0.3});
    CHECK(given.positional("LOG.csv") == "log.csv");
    CHECK_NOTHROW(given.finish());
  }
}

TEST_CASE("Arguments: options that are not there have no value", "[arguments]") {
  Arguments given = arguments({});
  CHECK_FALSE(given.flag("--json"));
  CHECK_FALSE(given.text("--weights").has_value());
  CHECK_FALSE(given.number("--at").has_value());
  CHECK_FALSE(given.numbers("--baseline", 2, ':').has_value());
  CHECK_NOTHROW(given.finish());
}

TEST_CASE("Arguments: what is not understood is refused by name", "[arguments]") {
  CHECK_THROWS_WITH(arguments({"--speed"}).finish(), "--speed: unknown option");
  CHECK_THROWS_WITH(arguments({"-h"}).positional("LOG.csv"), "-h: unknown option");
  CHECK_THROWS_WITH(arguments({"b.csv"}).finish(), "b.csv: one word too many");
  CHECK_THROWS_WITH(arguments({}).positional("LOG.csv"), "LOG.csv: missing");
  CHECK_THROWS_WITH(arguments({"--json", "--json"}).flag("--json"), "--json: given twice");
  CHECK_THROWS_WITH(arguments({"--at", "1", "--at", "2"}).number("--at"), "--at: given twice");
  CHECK_THROWS_WITH(arguments({"--at"}).number("--at"), "--at: needs a value");
  CHECK_THROWS_WITH(arguments({"--at", "--json"}).number("--at"), "--at: needs a value");
}

TEST_CASE("Arguments: a value that is not the numbers asked for is refused", "[arguments]") {
  const char* const bad = GENERATE("", "x", "1s", "nan", "1,", ",1", "1,2", "1:2");
  CAPTURE(bad);
  CHECK_THROWS_WITH(arguments({"--at", bad}).number("--at"),
                    "--at: \"" + std::string(bad) + "\" is not a finite number");
  CHECK_THROWS_WITH(arguments({"--com", bad}).numbers("--com", 3),
                    "--com: \"" + std::string(bad) + "\" is not 3 finite numbers with ',' in between");
}

TEST_CASE("Arguments: a range is two numbers with a colon in between", "[arguments]") {
  CHECK(arguments({"--baseline", "0.1:0.3"}).numbers("--baseline", 2, ':') == std::vector<double>{0.1, 0.3});
  CHECK_THROWS_AS(arguments({"--baseline", "0.1:0.3:"}).numbers("--baseline", 2, ':'), ArgumentError);
  CHECK_THROWS_AS(arguments({"--baseline", "0.1,0.3"}).numbers("--baseline", 2, ':'), ArgumentError);
}

TEST_CASE("Arguments: a whole number has no fraction and keeps its bounds", "[arguments]") {
  CHECK(arguments({"--trials", "1"}).whole("--trials", 1, 20) == 1u);
  CHECK(arguments({"--trials", "2e1"}).whole("--trials", 1, 20) == 20u);
  CHECK_FALSE(arguments({}).whole("--trials", 1, 20).has_value());
  const char* const bad = GENERATE("0", "21", "-1", "1.5", "1e300");
  CHECK_THROWS_WITH(arguments({"--trials", bad}).whole("--trials", 1, 20),
                    "--trials: must be a whole number from 1 to 20");
}

TEST_CASE("Arguments: a choice is one of the names that are known", "[arguments]") {
  const std::vector<std::pair<std::string, int>> choices = {{"one", 1}, {"two", 2}};
  CHECK(arguments({"--take", "two"}).choice("--take", choices) == 2);
  CHECK_FALSE(arguments({}).choice("--take", choices).has_value());
  CHECK_THROWS_WITH(arguments({"--take", "three"}).choice("--take", choices), "--take: \"three\" is none of one, two");
}

}  // namespace
