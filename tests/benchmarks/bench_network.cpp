// How long does one forward pass take? One thread, random weights and windows: neither changes the work.
#include <memory>
#include <rme/network/mismatch_network.hpp>

#include "network/golden.hpp"
#include "support/catch.hpp"

namespace {

TEMPLATE_TEST_CASE("MismatchNetwork: forward", "[benchmark]", float, double) {
  using Network = rme::MismatchNetwork<TestType>;
  const auto network = std::make_unique<Network>(*golden::random_weights<TestType>());
  std::vector<typename Network::Window> windows;
  for (const auto& window : golden::random_windows(std::vector<double>(6, 0), std::vector<double>(6, 4), 100)) {
    windows.push_back(window.template cast<TestType>());
  }
  typename Network::Output out = Network::Output::Zero();
  BENCHMARK_ADVANCED(sizeof(TestType) == sizeof(float) ? "float" : "double")(Catch::Benchmark::Chronometer meter) {
    meter.measure([&](int i) {
      (void)network->forward(windows[static_cast<std::size_t>(i) % windows.size()], out);
      return out[0];
    });
  };
}

}  // namespace
