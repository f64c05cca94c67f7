#pragma once
/// The bound beyond which a number can only come from a fault.
#include <cmath>
#include <rme/core/types.hpp>

namespace rme {

/// Inputs with a larger absolute value are refused [N m, m, rad/s, ...]. The bound is far above what any arm reports,
/// and so far below overflow that no product or sum over a window becomes infinite or NaN, even in float.
inline constexpr double kLargestPlausible = 1048576;  // 2^20

/// Whether |x| <= kLargestPlausible; false for a NaN.
inline bool plausible(double x) noexcept {
  return std::abs(x) <= kLargestPlausible;
}
/// Whether every entry is plausible.
template <typename Derived>
bool plausible(const Eigen::MatrixBase<Derived>& x) noexcept {
  using std::abs;
  bool good = true;
  for (Eigen::Index j = 0; j < x.cols(); ++j)
    for (Eigen::Index i = 0; i < x.rows(); ++i)
      good &= abs(x.coeff(i, j)) <= typename Derived::Scalar(kLargestPlausible);
  return good;
}

}  // namespace rme
