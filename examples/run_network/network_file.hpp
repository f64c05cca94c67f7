#pragma once
/// A weights file, ready to serve as a prior.
#include <cstddef>
#include <memory>
#include <optional>
#include <rme/network/network_prior.hpp>
#include <string>

namespace rme::examples {

/// The network of a weights file and the settings of NetworkPrior that belong to it.
struct NetworkFile {
  std::shared_ptr<const MismatchNetwork<float>> network;
  NetworkPriorConfig<double> config;  ///< the defaults, with the damping that the network was trained with
};

/// @throws std::runtime_error if the file cannot be read, std::invalid_argument if it holds no network
NetworkFile read_network_file(const std::string& path);

/// A prior source for Estimator that is chosen at run time: a network's guess, or the fixed prior.
class AnyPrior {
 public:
  AnyPrior() = default;  ///< the fixed prior
  /// @param dt  control period [s]
  AnyPrior(const NetworkFile& file, double dt)
      : network_(file.network), guess_(std::in_place, *file.network, dt, file.config) {}

  PayloadGaussian<double> operator()(const SampleWindow<double, 7>& window, std::size_t count) const noexcept {
    return guess_ ? (*guess_)(window, count) : FixedPrior<double>()(window, count);
  }

 private:
  std::shared_ptr<const MismatchNetwork<float>> network_;  // what guess_ refers to
  std::optional<NetworkPrior<double>> guess_;
};

}  // namespace rme::examples
