#pragma once
/// The shipped weights, compiled in: the benchmarks read no files.
#include <algorithm>
#include <memory>
#include <rme/network/mismatch_network.hpp>
#include <vector>

#include "panda_weights.hpp"  // made by weights_to_header from examples/models/panda.json

namespace rme::benchmarks {

template <typename Scalar>
std::unique_ptr<MismatchNetwork<Scalar>> shipped_network() {
  std::vector<float> numbers;
  for_each_tensor(panda_weights,
                  [&](auto, auto, const auto& array) { numbers.insert(numbers.end(), array.begin(), array.end()); });
  const auto weights = std::make_unique<MismatchNetworkWeights<Scalar>>();
  weights->frame = panda_weights.frame;
  std::copy(panda_weights.normalization_mean.begin(), panda_weights.normalization_mean.end(),
            weights->normalization_mean.begin());
  std::copy(panda_weights.normalization_std.begin(), panda_weights.normalization_std.end(),
            weights->normalization_std.begin());
  auto next = numbers.begin();
  for_each_tensor(*weights, [&](auto, auto, auto& array) {
    for (auto& value : array) value = static_cast<Scalar>(*next++);
  });
  return std::make_unique<MismatchNetwork<Scalar>>(*weights);
}

}  // namespace rme::benchmarks
