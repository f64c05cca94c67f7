// rme_live: what does the live page compute? Runs a session that was recorded on the page, and prints all numbers that
// the page draws. The page's "save this session" writes such files, with seed and last tick in their names.
#include <cstdio>
#include <string>

#include "io/csv.hpp"
#include "io/program.hpp"
#include "live/simulation.hpp"

namespace {

using namespace rme::examples;

constexpr const char* kUsage =
    R"(usage: rme_live SESSION [options]

Runs the two arms of docs/live, without rme and with it, through a session, and prints each number of the page, as
"name value value ...". SESSION is a file with lines "TICK COMMAND", one tick for each millisecond; docs/live.md lists
the commands.

  --until T         the last tick (default 5000)
  --seed N          of sensor noise, sensor offsets and friction (default 1)
  --help            this text

Exit codes: 0 done; 2 unusable arguments; 3 unusable session.
)";

int run(Arguments& arguments) {
  const std::size_t until = arguments.whole("--until", 0).value_or(5000);
  const std::size_t seed = arguments.whole("--seed", 0).value_or(1);
  const std::string session = read_file(arguments.positional("SESSION"));
  arguments.finish();
  Simulation simulation(seed);
  simulation.run(session, static_cast<long>(until));
  const Snapshot snapshot = simulation.snapshot();
  for (const Snapshot::Field& field : snapshot.fields) {
    std::printf("%s", field.name.c_str());
    for (std::size_t i = 0; i < field.count; ++i) std::printf(" %.17g", snapshot.values[field.offset + i]);
    std::printf("\n");
  }
  return 0;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_live", kUsage, argc, argv, run);
}
