#pragma once
/// A weights file, ready to serve as a prior.
#include <memory>
#include <rme/network/network_prior.hpp>
#include <string>

namespace rme::examples {

/// The network of a weights file and the settings of NetworkPrior that belong to it.
struct NetworkFile {
  std::shared_ptr<const MismatchNetwork<float>> network;  ///< never null
  NetworkPriorConfig<double> config;  ///< the defaults, with the damping that the network was trained with
};

/// The network of a weights file.
/// @throws std::runtime_error if the file cannot be read, std::invalid_argument if it contains no network
NetworkFile read_network_file(const std::string& path);

}  // namespace rme::examples
