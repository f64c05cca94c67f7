#pragma once
/// The network in TorchScript, compiled apart: its headers are large, and full of what our warnings object to.
#include <memory>
#include <rme/network/mismatch_network.hpp>
#include <string>

namespace rme::benchmarks {

/// A model of tests/benchmarks/trace.py, on one thread.
class TorchNetwork {
 public:
  using Network = MismatchNetwork<float>;

  explicit TorchNetwork(const std::string& path);
  ~TorchNetwork();
  TorchNetwork(const TorchNetwork&) = delete;
  TorchNetwork& operator=(const TorchNetwork&) = delete;

  Network::Output forward(const Network::Window& window);

 private:
  struct State;
  std::unique_ptr<State> state_;
};

}  // namespace rme::benchmarks
