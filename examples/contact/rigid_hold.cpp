// rigid_hold: how far do compensation and belief drive each other up if the hand is held by something rigid?
//
// A Panda under soft impedance control (rigid_hold.hpp), an empty hand. Something that does not move holds the hand, and the
// target rises. Prints the largest force between both, without and with rme's compensation, and what rme believes to hold.
// Then objects that stand on a table are lifted by 50 mm: how far is the hand below its target from 0.3 s after the lift on?
#include "rigid_hold.hpp"

#include <algorithm>
#include <cstdio>
#include <vector>

#include "io/program.hpp"

namespace {

using namespace rme::examples;

constexpr const char* kUsage = R"(usage: rme_rigid_hold [options]

Prints the force on a hand that is held by something rigid, and the sag of one that lifts an object off a table.

  --runs N  of each row (default 12)
  --seed N  of the first run (default 1)
  --help    this text

Exit codes: 0 done; 1 the median force is larger than that without compensation by more than a fifth and 0.5 N; 2 unusable
arguments.
)";

struct Runs {
  std::vector<RigidHoldResult> results;
  template <typename Get>
  double quantile(double share, const Get& get) const {
    std::vector<double> values;
    for (const RigidHoldResult& r : results) values.push_back(get(r));
    std::sort(values.begin(), values.end());
    return values[static_cast<std::size_t>(share * static_cast<double>(values.size() - 1) + 0.5)];
  }
};

Runs repeat(RigidHold hold, std::uint64_t seed, std::size_t runs) {
  Runs out;
  for (std::size_t k = 0; k < runs; ++k) {
    hold.seed = seed + k;
    out.results.push_back(hold_fast(hold));
    std::fprintf(stderr, "\r%zu of %zu ", k + 1, runs);
  }
  std::fprintf(stderr, "\r            \r");
  return out;
}

double force(const RigidHoldResult& r) {
  return r.force;
}
double believed(const RigidHoldResult& r) {
  return r.believed;
}
double deviation(const RigidHoldResult& r) {
  return r.std;
}
double sag(const RigidHoldResult& r) {
  return 1e3 * r.sag;
}

int run(Arguments& arguments) {
  const std::size_t runs = arguments.whole("--runs", 1, 1000).value_or(12);
  const std::uint64_t seed = arguments.whole("--seed", 0).value_or(1);
  arguments.finish();

  bool good = true;
  std::printf("A hand that is held by 10 kN/m while its target rises within 1 s. Medians and worst of %zu runs.\n\n",
              runs);
  std::printf("| stiffness | rise | force without | with rme | worst | believed then |\n");
  std::printf("|---:|---:|---:|---:|---:|---:|\n");
  for (const auto& [stiffness, rise] :
       {std::pair(200.0, 0.005), std::pair(200.0, 0.01), std::pair(200.0, 0.03), std::pair(1000.0, 0.02)}) {
    RigidHold hold;
    hold.stiffness = stiffness;
    hold.rise = rise;
    const Runs with = repeat(hold, seed, runs);
    hold.compensates = false;
    const Runs without = repeat(hold, seed, runs);
    const double before = without.quantile(0.5, force), after = with.quantile(0.5, force);
    good = good && after < 1.2 * before + 0.5;
    std::printf("| %4.0f N/m | %2.0f mm | %4.1f N | %4.1f N | %4.1f N | %.2f +- %.2f kg |\n", stiffness, 1e3 * rise,
                before, after, with.quantile(1, force), with.quantile(0.5, believed), with.quantile(0.5, deviation));
    std::fflush(stdout);
  }
  std::printf("\n1 kg is lifted off a table by 50 mm at 200 N/m: largest sag from 0.3 s after the lift on.\n\n");
  std::printf("| lift | without rme | with rme | worst | with expect_change() | worst |\n");
  std::printf("|---:|---:|---:|---:|---:|---:|\n");
  for (const double duration : {1.0, 2.0}) {
    RigidHold hold;
    hold.rise = 0.05;
    hold.mass = 1;
    hold.duration = duration;
    const Runs with = repeat(hold, seed, runs);
    hold.announced = true;
    const Runs announced = repeat(hold, seed, runs);
    hold.announced = hold.compensates = false;
    std::printf("| %.0f s | %.1f mm | %.1f mm | %.1f mm | %.1f mm | %.1f mm |\n", duration,
                repeat(hold, seed, runs).quantile(0.5, sag), with.quantile(0.5, sag), with.quantile(1, sag),
                announced.quantile(0.5, sag), announced.quantile(1, sag));
    std::fflush(stdout);
  }
  return good ? 0 : 1;
}

}  // namespace

int main(int argc, char** argv) {
  return run_program("rme_rigid_hold", kUsage, argc, argv, run);
}
