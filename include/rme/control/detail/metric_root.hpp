#pragma once
/// A root of the inverse Hessian of a quadratic program.
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/core/types.hpp>
#include <rme/core/unroll.hpp>

namespace rme::detail {

/// B = L^T with P = L L^T by Cholesky's method, and as many rows of zeros as Root has more. For a P whose smallest
/// eigenvalues its own rounding has taken, pivots have a floor.
template <typename Root, typename Scalar, int Size>
void metric_root(const Eigen::Matrix<Scalar, Size, Size>& P, Root& B) noexcept {
  // Columns leave one after the other. Nothing waits for a root, and as little as may be for the division.
  Eigen::Matrix<Scalar, Size, Size> rest = P;  // below the diagonal
  B.setZero();
  RME_UNROLL
  for (int j = 0; j < Size; ++j) {
    const Scalar pivot = std::max(rest(j, j), std::numeric_limits<Scalar>::epsilon() * P(j, j));
    const Scalar inverse = Scalar(1) / pivot, root = std::sqrt(pivot), inverse_root = inverse * root;
    B(j, j) = root;
    RME_UNROLL
    for (int k = j + 1; k < Size; ++k) {
      B(j, k) = rest(k, j) * inverse_root;
      RME_UNROLL
      for (int i = k; i < Size; ++i) rest(i, k) -= rest(i, j) * rest(k, j) * inverse;
    }
  }
}

}  // namespace rme::detail
