#pragma once
/// Numbers that an arm can report, told from those that only a fault makes.
#include <cmath>
#include <rme/core/types.hpp>

namespace rme {

/// Beyond this no input is believed [N m, m, rad/s, ...]. Far above what any arm reports, and far below where products
/// and sums over a window overflow in float: what is believed never becomes an infinity or a NaN later on.
inline constexpr double kLargestPlausible = 1048576;  // 2^20

/// Whether |x| <= kLargestPlausible; of a NaN false.
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
