#pragma once
/// What the tests of the published pipeline are fed with.
#include <cstdint>
#include <memory>
#include <rme/network/mismatch_network.hpp>
#include <vector>

#include "network/golden.hpp"
#include "support/held_arm.hpp"

namespace rme::testing {

/// 5.6 s of a Panda that holds `first` from 0.8 s on, `second` from 2 s on while it moves, and nothing from 4.5 s on.
inline std::vector<Proprioception<double, 7>> changing_hand(std::uint64_t seed, const Payload<double>& first,
                                                            const Payload<double>& second) {
  HeldArm arm(seed);
  std::vector<Proprioception<double, 7>> ticks;
  for (int k = 0; k < 5600; ++k) {
    if (k == 800) arm.hold(first);
    if (k == 2000) arm.hold(second);
    if (k == 2100) arm.move(arm.pose() + 0.1 * HeldArm::Vector::Ones(), 1.5);
    if (k == 4500) arm.hold({});
    ticks.push_back(arm.tick());
  }
  return ticks;
}

template <typename Scalar>
Proprioception<Scalar, 7> cast(const Proprioception<double, 7>& tick) {
  Proprioception<Scalar, 7> out;
  out.tau_ext = tick.tau_ext.cast<Scalar>();
  out.jacobian = tick.jacobian.cast<Scalar>();
  out.rotation = tick.rotation.cast<Scalar>();
  return out;
}

/// A network that has learned nothing; its guesses depend on all of its input.
inline std::unique_ptr<MismatchNetwork<float>> random_network(InputFrame frame) {
  const auto weights = golden::random_weights<float>();
  weights->frame = frame;
  return std::make_unique<MismatchNetwork<float>>(*weights);
}

}  // namespace rme::testing
