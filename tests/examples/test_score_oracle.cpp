#include <array>
#include <cstdio>
#include <filesystem>
#include <string>

#include "support/catch.hpp"
#include "support/program.hpp"

namespace {

using rme::testing::run;
using rme::testing::Stream;

TEST_CASE("score_oracle: an oracle that knows offsets and instant is right to grams, and better the longer it looks",
          "[score_oracle]") {
  const std::string folder = std::to_string(::getpid()) + "_oracle_logs";
  const auto made =
      run(RME_MAKE_LOGS, "--kind link_side --scenario E --runs 4 --seed 7 --output " + folder, Stream::Errors);
  CAPTURE(made.text);
  REQUIRE(made.exit_code == 0);
  const auto scored = run(RME_SCORE_ORACLE, folder + " --preset link_side", Stream::Output);
  std::filesystem::remove_all(folder);
  CAPTURE(scored.text);
  REQUIRE(scored.exit_code == 0);
  std::array<double, 3> oracle{}, own{};  // [g]
  std::size_t rows = 0;
  for (std::size_t at = scored.text.find("| E "); at != std::string::npos; at = scored.text.find("| E ", at + 1)) {
    REQUIRE(rows < oracle.size());
    int runs = 0;
    double after = 0;
    REQUIRE(std::sscanf(scored.text.c_str() + at, "| E  | %d | %lf | %lf | %lf |", &runs, &after, &oracle[rows],
                        &own[rows]) == 4);
    CHECK(runs == 4);
    ++rows;
  }
  REQUIRE(rows == oracle.size());
  // White noise of some hundredths of a newton metre on 50 samples shows a mass to some grams, and on 2,000 to less than one.
  CHECK(oracle[0] < 10);
  CHECK(oracle[1] < oracle[0]);
  CHECK(oracle[2] < 1);
  for (std::size_t k = 0; k < rows; ++k) CHECK(own[k] > 0.7 * oracle[k]);  // of four runs
}

}  // namespace
