#pragma once
/// QR factorisation by Householder reflections, of matrices whose size the compiler knows.
#include <cmath>
#include <rme/core/types.hpp>

namespace rme::detail {

/// A = H_0 .. H_n-1 [R; 0] with reflections H_k = I - v_k v_k^T, |v_k|^2 = 2 (Golub and Van Loan, Matrix Computations,
/// 5.2).
/// @param[in,out] A      afterwards v_k in column k from the diagonal on, and R above the diagonal
/// @param[out] diagonal  the diagonal of R
template <typename Scalar, int Rows, int Columns>
void householder(Eigen::Matrix<Scalar, Rows, Columns>& A, Eigen::Matrix<Scalar, Columns, 1>& diagonal) noexcept {
  static_assert(Rows >= Columns, "householder: a matrix with at least as many rows as columns");
  using std::abs;
  using std::sqrt;
  for (int k = 0; k < Columns; ++k) {
    Scalar squared = Scalar(0);
    for (int i = k; i < Rows; ++i) squared += A(i, k) * A(i, k);
    const Scalar norm = sqrt(squared);
    diagonal[k] = A(k, k) > 0 ? -norm : norm;
    if (!(norm > 0)) continue;
    const Scalar scale = Scalar(1) / sqrt(squared + norm * abs(A(k, k)));
    A(k, k) -= diagonal[k];
    for (int i = k; i < Rows; ++i) A(i, k) *= scale;
    for (int j = k + 1; j < Columns; ++j) {
      Scalar dot = Scalar(0);
      for (int i = k; i < Rows; ++i) dot += A(i, k) * A(i, j);
      for (int i = k; i < Rows; ++i) A(i, j) -= dot * A(i, k);
    }
  }
}

}  // namespace rme::detail
