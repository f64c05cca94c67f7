#pragma once
/// What an estimator may meet.
#include <cmath>
#include <cstdint>
#include <vector>

#include "support/held_arm.hpp"

namespace rme::testing {

/// Six seconds in the life of an arm: an object comes, a hand pushes, the arm moves, the object goes.
inline std::vector<Proprioception<double, 7>> life(std::uint64_t seed) {
  HeldArm arm(seed);
  std::vector<Proprioception<double, 7>> ticks;
  for (int k = 0; k < 6000; ++k) {
    if (k == 1000) arm.hold({1.1, {0.05, 0.02, 0.13}});
    if (k == 2000) arm.push({{10, -8, 0}, Eigen::Vector3d::Zero()});
    if (k == 2800) arm.push({});
    if (k == 3600) arm.move(arm.pose() + 0.3 * HeldArm::Vector::Ones(), 0.8);
    if (k == 4800) arm.hold({});
    ticks.push_back(arm.tick());
  }
  return ticks;
}

/// Some samples are no good.
inline void spoil(std::vector<Proprioception<double, 7>>& ticks) {
  for (std::size_t k = 5; k < ticks.size(); k += 97) ticks[k].tau_ext[int(k % 7)] = std::nan("");
  for (std::size_t k = 6; k < ticks.size(); k += 101) ticks[k].rotation *= 1.1;
}

}  // namespace rme::testing
