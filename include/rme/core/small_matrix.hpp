#pragma once
/// Products and sums of matrices whose sizes the compiler knows, as plain loops.
///
/// Eigen's expressions would do the same, but the compiler instantiates class templates for each of them. That would
/// take most of the compile time of an Estimator or a Cpic.
#include <Eigen/Core>

namespace rme::detail {

/// Column j of a matrix, as an Eigen vector. Loops over it compile to vector instructions.
template <typename Scalar, int Rows, int Columns>
Eigen::Map<const Eigen::Matrix<Scalar, Rows, 1>> column(const Eigen::Matrix<Scalar, Rows, Columns>& A, int j) noexcept {
  return Eigen::Map<const Eigen::Matrix<Scalar, Rows, 1>>(A.data() + j * Rows);
}
template <typename Scalar, int Rows, int Columns>
Eigen::Map<Eigen::Matrix<Scalar, Rows, 1>> column(Eigen::Matrix<Scalar, Rows, Columns>& A, int j) noexcept {
  return Eigen::Map<Eigen::Matrix<Scalar, Rows, 1>>(A.data() + j * Rows);
}

/// A B.
template <typename Scalar, int Rows, int Inner, int Columns>
Eigen::Matrix<Scalar, Rows, Columns> product(const Eigen::Matrix<Scalar, Rows, Inner>& A,
                                             const Eigen::Matrix<Scalar, Inner, Columns>& B) noexcept {
  Eigen::Matrix<Scalar, Rows, Columns> out;
  for (int j = 0; j < Columns; ++j) {
    Eigen::Matrix<Scalar, Rows, 1> sum = column(A, 0) * B.coeff(0, j);
    for (int k = 1; k < Inner; ++k) sum += column(A, k) * B.coeff(k, j);
    column(out, j) = sum;
  }
  return out;
}

/// x^T y.
template <typename Scalar, int Size>
Scalar dot(const Eigen::Matrix<Scalar, Size, 1>& x, const Eigen::Matrix<Scalar, Size, 1>& y) noexcept {
  return column(x, 0).dot(column(y, 0));
}

/// A^T B.
template <typename Scalar, int Rows, int Inner, int Columns>
Eigen::Matrix<Scalar, Rows, Columns> transposed_product(const Eigen::Matrix<Scalar, Inner, Rows>& A,
                                                        const Eigen::Matrix<Scalar, Inner, Columns>& B) noexcept {
  Eigen::Matrix<Scalar, Rows, Columns> out;
  for (int j = 0; j < Columns; ++j)
    for (int i = 0; i < Rows; ++i) out.coeffRef(i, j) = column(A, i).dot(column(B, j));
  return out;
}

/// A A^T, symmetric to the last bit.
template <typename Scalar, int Rows, int Inner>
Eigen::Matrix<Scalar, Rows, Rows> outer_square(const Eigen::Matrix<Scalar, Rows, Inner>& A) noexcept {
  Eigen::Matrix<Scalar, Rows, Rows> out;
  for (int j = 0; j < Rows; ++j) {
    Eigen::Matrix<Scalar, Rows, 1> sum = column(A, 0) * A.coeff(j, 0);
    for (int k = 1; k < Inner; ++k) sum += column(A, k) * A.coeff(j, k);
    for (int i = j; i < Rows; ++i) out.coeffRef(i, j) = out.coeffRef(j, i) = sum[i];
  }
  return out;
}

/// M += x y^T.
template <typename Scalar, int Rows, int Columns>
void add_outer(Eigen::Matrix<Scalar, Rows, Columns>& M, const Eigen::Matrix<Scalar, Rows, 1>& x,
               const Eigen::Matrix<Scalar, Columns, 1>& y) noexcept {
  for (int j = 0; j < Columns; ++j) column(M, j) += column(x, 0) * y.coeff(j);
}

/// s X.
template <typename Scalar, int Rows, int Columns>
Eigen::Matrix<Scalar, Rows, Columns> scaled(Scalar s, const Eigen::Matrix<Scalar, Rows, Columns>& X) noexcept {
  Eigen::Matrix<Scalar, Rows, Columns> out;
  for (int j = 0; j < Columns; ++j) column(out, j) = column(X, j) * s;
  return out;
}

/// Y += s X.
template <typename Scalar, int Rows, int Columns>
void add_scaled(Eigen::Matrix<Scalar, Rows, Columns>& Y, Scalar s,
                const Eigen::Matrix<Scalar, Rows, Columns>& X) noexcept {
  for (int j = 0; j < Columns; ++j) column(Y, j) += column(X, j) * s;
}

/// X - Y.
template <typename Scalar, int Rows, int Columns>
Eigen::Matrix<Scalar, Rows, Columns> difference(const Eigen::Matrix<Scalar, Rows, Columns>& X,
                                                const Eigen::Matrix<Scalar, Rows, Columns>& Y) noexcept {
  Eigen::Matrix<Scalar, Rows, Columns> out;
  for (int j = 0; j < Columns; ++j)
    for (int i = 0; i < Rows; ++i) out.coeffRef(i, j) = X.coeff(i, j) - Y.coeff(i, j);
  return out;
}

/// Whether all entries are finite: zero times a NaN or an infinity is not zero.
template <typename Scalar, int Rows, int Columns>
bool finite(const Eigen::Matrix<Scalar, Rows, Columns>& X) noexcept {
  Eigen::Matrix<Scalar, Rows, 1> sum = column(X, 0) * Scalar(0);
  for (int j = 1; j < Columns; ++j) sum += column(X, j) * Scalar(0);
  bool good = true;
  for (int i = 0; i < Rows; ++i) good &= sum.coeff(i) == Scalar(0);
  return good;
}

}  // namespace rme::detail
