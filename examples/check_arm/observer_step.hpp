#pragma once
/// Bandwidth of an arm's observer, from a step in its external torque: a weight was hung on the resting arm or taken
/// off.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <utility>
#include <vector>

namespace rme::examples {

/// The bandwidth of a first-order filter whose step response is as fast as the fastest step: ln 4 / (time from 20 to
/// 80 %). A lower bound of the observer's, since the torque itself may change more slowly.
/// @param t        [s]
/// @param tau_ext  [N m], for each row
/// @param dq       [rad/s], for each row, or empty: an arm that always rests
/// @return [rad/s]; 0 if there is no step of 20 times the noise with 50 ms of quiet before and after it while the arm
///         rests
template <typename Vector>
double fastest_step(const std::vector<double>& t, const std::vector<Vector>& tau_ext, const std::vector<Vector>& dq) {
  constexpr double kQuiet = 0.05, kLongest = 0.3, kClear = 20, kRests = 0.02,
                   kLeast = 0.1;  // [s], [s], -, [rad/s], [N m]
  double fastest = 0;
  const auto mean_and_noise = [&](std::size_t begin, std::size_t end, Eigen::Index j) {
    double mean = 0, square = 0;
    for (std::size_t i = begin; i < end; ++i) mean += tau_ext[i][j] / static_cast<double>(end - begin);
    for (std::size_t i = begin; i < end; ++i)
      square += std::pow(tau_ext[i][j] - mean, 2) / static_cast<double>(end - begin);
    return std::pair(mean, std::sqrt(square));
  };
  const auto row_at = [&](double time) {
    return static_cast<std::size_t>(std::lower_bound(t.begin(), t.end(), time) - t.begin());
  };
  for (double begin = t.front(); begin + 2 * kQuiet + kLongest < t.back(); begin += kQuiet) {
    const std::size_t a = row_at(begin), b = row_at(begin + kQuiet), c = row_at(begin + kQuiet + kLongest),
                      d = row_at(begin + 2 * kQuiet + kLongest);
    if (b - a < 3 || d - c < 3) continue;
    bool rests = true;
    for (std::size_t i = a; i < d && rests && !dq.empty(); ++i) rests = dq[i].norm() < kRests;
    if (!rests) continue;
    for (Eigen::Index j = 0; j < tau_ext[a].size(); ++j) {
      const std::pair<double, double> start = mean_and_noise(a, b, j), end = mean_and_noise(c, d, j);
      const double before = start.first, step = end.first - before;
      if (!(std::abs(step) > kClear * std::max(start.second, end.second)) || std::abs(step) < kLeast) continue;
      const auto reached = [&](double share) {  // between rows, linearly
        std::size_t i = b;
        while (i < c && (tau_ext[i][j] - before) / step < share) ++i;
        const double now = (tau_ext[i][j] - before) / step, last = (tau_ext[i - 1][j] - before) / step;
        return t[i] - (now > last ? (now - share) / (now - last) : 0) * (t[i] - t[i - 1]);
      };
      const double rise = reached(0.8) - reached(0.2);
      if (rise > 0) fastest = std::max(fastest, std::log(4.0) / rise);
    }
  }
  return fastest;
}

}  // namespace rme::examples
