#pragma once
/// A weights file, ready for the published pipeline.
#include <memory>
#include <optional>
#include <rme/network/mismatch_network.hpp>
#include <rme/published/pseudo_wrench_sequence.hpp>
#include <string>

namespace rme::examples {

/// The network of a weights file, and what its input must be made with.
struct NetworkFile {
  std::shared_ptr<const MismatchNetwork<float>> network;  ///< never null
  /// lambda of the pseudo-wrenches that the network was trained with [m^2]; the published one if the file names none.
  double damping = 0.01;

  /// The network's output (m [kg], r [m]) for a window of samples; none if there are too few or one is not usable.
  /// @param count  samples in the window
  /// @param at     as pseudo_wrench_sequence() takes it
  template <int Dofs, typename At>
  std::optional<Vector4<double>> guess(int count, const At& at) const {
    MismatchNetwork<float>::Window window;
    MismatchNetwork<float>::Output theta;
    if (pseudo_wrench_sequence<double, Dofs>(count, at, damping, network->frame(), window) != Status::Ok ||
        network->forward(window, theta) != Status::Ok)
      return std::nullopt;
    return theta.cast<double>();
  }
};

/// The network of a weights file.
/// @throws std::runtime_error if the file cannot be read, std::invalid_argument if it contains no network
NetworkFile read_network_file(const std::string& path);

}  // namespace rme::examples
