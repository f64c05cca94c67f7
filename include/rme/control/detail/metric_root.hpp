#pragma once
/// Roots of the inverse Hessian of a quadratic program.
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/core/householder.hpp>
#include <rme/core/types.hpp>
#include <rme/core/unroll.hpp>

namespace rme::detail {

/// B = L^T with P = L L^T by Cholesky's method, and rows of zeros below. Pivots are at least epsilon P_jj, since
/// rounding may have made a small eigenvalue of P zero or negative.
template <typename Root, typename Scalar, int Size>
void metric_root(const Eigen::Matrix<Scalar, Size, Size>& P, Root& B) noexcept {
  // The rest is updated with the inverse of the pivot, so that no column has to wait for a square root.
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

/// A root of B^T B + least^2 I: R of the QR factorisation of [B; least I].
template <typename Scalar, int Rows, int Size>
Eigen::Matrix<Scalar, Rows, Size> stretched_less(const Eigen::Matrix<Scalar, Rows, Size>& B, Scalar least) noexcept {
  Eigen::Matrix<Scalar, Rows + Size, Size> tall;
  for (int j = 0; j < Size; ++j) {
    for (int i = 0; i < Rows; ++i) tall(i, j) = B(i, j);
    for (int i = 0; i < Size; ++i) tall(Rows + i, j) = i == j ? least : Scalar(0);
  }
  Eigen::Matrix<Scalar, Size, 1> diagonal;
  householder(tall, diagonal);
  Eigen::Matrix<Scalar, Rows, Size> root = Eigen::Matrix<Scalar, Rows, Size>::Zero();
  for (int j = 0; j < Size; ++j) {
    for (int i = 0; i < j; ++i) root(i, j) = tall(i, j);
    root(j, j) = diagonal[j];
  }
  return root;
}

}  // namespace rme::detail
