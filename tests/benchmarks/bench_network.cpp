// How long does one forward pass take? One thread, the shipped weights, windows within what they were trained on; the
// work depends on neither. The weights stay in the caches from one pass to the next; bench_published has a pass with
// other things in them.
#include <rme/network/mismatch_network.hpp>
#include <vector>

#include "benchmarks/shipped_network.hpp"
#include "benchmarks/stopwatch.hpp"
#include "network/golden.hpp"

namespace {

template <typename Scalar>
void time_forward(const char* what, std::size_t runs) {
  using Network = rme::MismatchNetwork<Scalar>;
  const auto network = rme::benchmarks::shipped_network<Scalar>();
  const std::vector<double> mean(panda_weights.normalization_mean.begin(), panda_weights.normalization_mean.end());
  const std::vector<double> deviation(panda_weights.normalization_std.begin(), panda_weights.normalization_std.end());
  std::vector<typename Network::Window> windows;
  for (const auto& window : golden::random_windows(mean, deviation, 100))
    windows.push_back(window.template cast<Scalar>());
  typename Network::Output out = Network::Output::Zero();
  rme::benchmarks::measure(what, runs, 1, [&](std::size_t i) {
    (void)network->forward(windows[i % windows.size()], out);
    rme::benchmarks::keep(out);
  });
}

}  // namespace

int main(int argc, char** argv) {
  const std::size_t runs = rme::benchmarks::quick(argc, argv) ? 10 : 50000;
  rme::benchmarks::print_head("Network, one forward pass of many in a row, " RME_BENCHMARK_FLAGS);
  time_forward<float>("MismatchNetwork<float>::forward, " RME_BENCHMARK_FLAGS, runs);
  time_forward<double>("MismatchNetwork<double>::forward, " RME_BENCHMARK_FLAGS, runs);
}
