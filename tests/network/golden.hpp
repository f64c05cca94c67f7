#pragma once
// The generator of examples/training/golden.py, and the networks and windows that it makes.
#include <array>
#include <cstdint>
#include <memory>
#include <rme/network/mismatch_network.hpp>
#include <string>
#include <utility>
#include <vector>

namespace golden {

/// Knuth's 64-bit linear congruential generator; the top 53 bits as a double in [-1, 1).
class Uniform {
 public:
  explicit Uniform(std::uint64_t seed) : state_(seed) {}
  double operator()() {
    state_ = state_ * 6364136223846793005u + 1442695040888963407u;
    return 2 * static_cast<double>(state_ >> 11) * 0x1p-53 - 1;
  }

 private:
  std::uint64_t state_;
};

/// An architecture as small as one can be.
struct SmallArchitecture {
  static constexpr int kSamples = 3, kChannels = 2, kConvChannels = 2, kConvKernel = 3, kHeads = 1, kMlpHidden = 3,
                       kMlpRepeats = 2, kOutputs = 2;
  static constexpr std::array<const char*, kOutputs> kOutputNames{"mass", "com_x"};
};

/// golden.py's random_network(Uniform(1)).
template <typename Scalar, typename Architecture = rme::PublishedArchitecture>
std::unique_ptr<rme::MismatchNetworkWeights<Scalar, Architecture>> random_weights() {
  const auto width = [](const std::string& name) {
    if (name == "positional_embedding") return 1.0;
    if (name.rfind("convolution.", 0) == 0 || name.rfind("attention.in_proj", 0) == 0) return 0.3;
    return name.rfind("mlp.2.", 0) == 0 ? 0.1 : 0.2;
  };
  Uniform uniform(1);
  auto weights = std::make_unique<rme::MismatchNetworkWeights<Scalar, Architecture>>();
  for (auto& value : weights->normalization_mean) value = Scalar(5 * uniform());
  for (auto& value : weights->normalization_std) value = Scalar(3 + 2 * uniform());
  rme::for_each_tensor(*weights, [&](const char* name, const auto&, auto& array) {
    for (auto& value : array) value = Scalar(width(name) * uniform());
  });
  return weights;
}

/// golden.py's random_windows(Uniform(2), ...).
inline std::vector<Eigen::Matrix<double, 20, 6>> random_windows(const std::vector<double>& mean,
                                                                const std::vector<double>& std, int count) {
  Uniform uniform(2);
  std::vector<Eigen::Matrix<double, 20, 6>> windows(static_cast<std::size_t>(count));
  for (auto& window : windows) {
    for (int t = 0; t < 20; ++t) {
      for (int c = 0; c < 6; ++c) {
        const auto channel = static_cast<std::size_t>(c);
        window(t, c) = mean[channel] + 3 * std[channel] * uniform();
      }
    }
  }
  return windows;
}

}  // namespace golden
