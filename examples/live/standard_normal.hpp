#pragma once
/// Normal random numbers that are the same with every standard library; std::normal_distribution's are not.
#include <cmath>
#include <cstdint>
#include <random>

namespace rme::examples {

/// Draws from N(0, 1), by Box and Muller's method, from the 64-bit Mersenne twister.
class StandardNormal {
 public:
  explicit StandardNormal(std::uint64_t seed) : random_(seed) {}

  double operator()() {
    constexpr double kTurn = 6.283185307179586;
    const double u = uniform(), v = uniform();
    return std::sqrt(-2 * std::log(u)) * std::cos(kTurn * v);
  }
  /// From (0, 1].
  double uniform() { return (static_cast<double>(random_() >> 11) + 1) * 0x1p-53; }

 private:
  std::mt19937_64 random_;
};

}  // namespace rme::examples
