#pragma once
/// Derivatives of sampled signals without delay: least-squares quadratics through the samples around each instant
/// (Savitzky and Golay, Analytical Chemistry 1964, for samples that need not be evenly spaced).
#include <Eigen/Core>
#include <algorithm>
#include <cstddef>
#include <vector>

namespace rme::examples {

/// Value, slope and second derivative of a quadratic at its middle.
struct LocalQuadratic {
  double value = 0, slope = 0, curvature = 0;
};

/// Half the width of the windows in which rows count [s]: 25 ms, or two and a half rows if that is longer.
/// @param period  between rows [s]
inline double zero_phase_half_width(double period) {
  return std::max(0.025, 2.5 * period);
}

/// The least-squares quadratic through (t, values) at the rows [first, last), with its middle at `at`.
/// With fewer than three rows it is their mean.
/// @param value  of a row
template <typename Value>
LocalQuadratic local_quadratic(const std::vector<double>& t, std::size_t first, std::size_t last, double at,
                               const Value& value) {
  // Normal equations in x = (t - at) / scale, by Cramer's rule.
  const double scale = std::max(at - t[first], t[last - 1] - at);
  double m[5] = {0, 0, 0, 0, 0}, y[3] = {0, 0, 0};
  for (std::size_t i = first; i < last; ++i) {
    const double x = scale > 0 ? (t[i] - at) / scale : 0, v = value(i);
    double power = 1;
    for (int k = 0; k < 5; ++k, power *= x) {
      m[k] += power;
      if (k < 3) y[k] += power * v;
    }
  }
  LocalQuadratic out;
  Eigen::Matrix3d A;
  A << m[0], m[1], m[2], m[1], m[2], m[3], m[2], m[3], m[4];
  const double determinant = A.determinant();
  if (last - first < 3 || !(determinant > 1e-9)) {
    out.value = y[0] / m[0];
    return out;
  }
  const Eigen::Vector3d x = A.inverse() * Eigen::Vector3d(y[0], y[1], y[2]);
  out.value = x[0];
  out.slope = x[1] / scale;
  out.curvature = 2 * x[2] / (scale * scale);
  return out;
}

/// The derivative of `q` at each row.
/// @param t  [s], strictly increasing
template <typename Vector>
std::vector<Vector> zero_phase_derivative(const std::vector<double>& t, const std::vector<Vector>& q) {
  std::vector<double> steps;
  for (std::size_t i = 1; i < t.size(); ++i) steps.push_back(t[i] - t[i - 1]);
  std::nth_element(steps.begin(), steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2), steps.end());
  const double half = zero_phase_half_width(steps[steps.size() / 2]);
  std::vector<Vector> out(t.size(), Vector::Zero());
  for (std::size_t i = 0, first = 0, last = 0; i < t.size(); ++i) {
    while (t[first] < t[i] - half) ++first;
    while (last < t.size() && t[last] <= t[i] + half) ++last;
    for (Eigen::Index j = 0; j < out[i].size(); ++j)
      out[i][j] = local_quadratic(t, first, last, t[i], [&](std::size_t k) { return q[k][j]; }).slope;
  }
  return out;
}

}  // namespace rme::examples
