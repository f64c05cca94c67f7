#pragma once
/// A root of the inverse Hessian of a quadratic program.
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/core/types.hpp>

namespace rme::detail {

/// B = L^T with P = L L^T by Cholesky's method, and as many rows of zeros as Root has more. For a P whose smallest
/// eigenvalues its own rounding has taken, pivots have a floor.
template <typename Root, typename Scalar, int Size>
void metric_root(const Eigen::Matrix<Scalar, Size, Size>& P, Root& B) noexcept {
  using Column = Eigen::Matrix<Scalar, Root::RowsAtCompileTime, 1>;  // of a length that vector instructions like
  Root rest = Root::Zero();
  rest.template topRows<Size>() = P;
  B.setZero();
  for (int j = 0; j < Size; ++j) {
    const Scalar pivot = std::max(rest(j, j), std::numeric_limits<Scalar>::epsilon() * P(j, j));
    const Column scaled = rest.col(j) * (Scalar(1) / pivot);
    for (int k = j + 1; k < Size; ++k) rest.col(k) -= rest(k, j) * scaled;
    const Scalar root = std::sqrt(pivot);
    for (int k = j; k < Size; ++k) B(j, k) = root * scaled[k];
  }
}

}  // namespace rme::detail
