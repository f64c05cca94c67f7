#pragma once
/// Errors of a set of estimates, and how often their intervals hold the truth.
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <vector>

namespace rme::examples {

constexpr std::array<const char*, 4> kParameters = {"mass [g]", "x [mm]", "y [mm]", "z [mm]"};
constexpr std::array<int, 4> kLevels = {50, 80, 90, 95};                                 // of the intervals [%]
constexpr std::array<double, 4> kHalfWidths = {0.674490, 1.281552, 1.644854, 1.959964};  // [standard deviations]
constexpr std::size_t kBins = 10;                                                        // of a rank histogram

/// One estimate and the truth.
struct Scored {
  Eigen::Vector4d truth, error, deviation;  ///< (m, r): error is estimate minus truth [kg, m, m, m]
  double across = 0;                        ///< error of the centre of mass across gravity [m]
  bool friction_shows = false;
};

/// Where the truth lies in the posterior, from 0 to 1: uniform if the posteriors are calibrated. For a Gaussian this is
/// the rank of the truth among infinitely many draws from it.
inline double rank(const Scored& s, int parameter) {
  return 0.5 * std::erfc(s.error[parameter] / s.deviation[parameter] / std::sqrt(2.0));
}

/// Summary of one parameter; lengths in mm, masses in g.
struct Summary {
  double mean_absolute = 0, rms = 0, bias = 0;
  std::array<double, kLevels.size()> coverage{};  ///< [%]
  double half_width = 0;                          ///< of the 90 % interval, mean
  std::array<int, kBins> ranks{};
};

inline Summary summarise(const std::vector<Scored>& scored, int parameter) {
  Summary out;
  const double n = static_cast<double>(scored.size());
  for (const Scored& s : scored) {
    const double error = 1e3 * s.error[parameter], deviation = 1e3 * s.deviation[parameter];
    out.mean_absolute += std::abs(error) / n;
    out.rms += error * error / n;
    out.bias += error / n;
    for (std::size_t i = 0; i < kLevels.size(); ++i)
      out.coverage[i] += std::abs(error) <= kHalfWidths[i] * deviation ? 100 / n : 0;
    out.half_width += kHalfWidths[2] * deviation / n;
    const auto bin = static_cast<std::size_t>(rank(s, parameter) * static_cast<double>(kBins));
    ++out.ranks[bin < kBins ? bin : kBins - 1];
  }
  out.rms = std::sqrt(out.rms);
  return out;
}

/// Smallest and largest count in a bin of a uniform rank histogram of `n` estimates, in 99 % of cases (normal
/// approximation of the binomial distribution).
inline std::array<double, 2> expected_counts(std::size_t n) {
  const double p = 1.0 / static_cast<double>(kBins), mean = static_cast<double>(n) * p;
  const double spread = 2.575829 * std::sqrt(mean * (1 - p));
  return {mean - spread, mean + spread};
}

}  // namespace rme::examples
