#pragma once
/// Cholesky factorisation of small matrices whose size the compiler knows.
#include <Eigen/Core>
#include <cmath>
#include <rme/core/sum_of_logs.hpp>
#include <rme/core/unroll.hpp>

namespace rme {

/// A = L L^T of a symmetric positive definite matrix; only its lower triangle is read. Real time: Size^3 / 6
/// multiplications, no allocation.
template <typename Scalar, int Size>
class Cholesky {
 public:
  using Matrix = Eigen::Matrix<Scalar, Size, Size>;  ///< A and L

  /// Factorises A; positive_definite() says whether that worked.
  explicit Cholesky(const Matrix& A) noexcept {
    using std::sqrt;
    RME_UNROLL
    for (int j = 0; j < Size; ++j) {
      Scalar pivot = A(j, j);
      RME_UNROLL
      for (int k = 0; k < j; ++k) pivot -= L_(j, k) * L_(j, k);
      if (!(pivot > 0)) return;
      L_(j, j) = sqrt(pivot);
      inverse_diagonal_[j] = Scalar(1) / L_(j, j);
      RME_UNROLL
      for (int i = j + 1; i < Size; ++i) {
        Scalar sum = A(i, j);
        RME_UNROLL
        for (int k = 0; k < j; ++k) sum -= L_(i, k) * L_(j, k);
        L_(i, j) = sum * inverse_diagonal_[j];
      }
    }
    positive_definite_ = true;
  }

  /// Whether A is positive definite. If not, no other member means anything.
  bool positive_definite() const noexcept { return positive_definite_; }
  /// L, lower triangular: zero above the diagonal.
  const Matrix& lower() const noexcept { return L_; }
  /// log det L = 1/2 log det A.
  Scalar log_det_lower() const noexcept { return sum_of_logs(L_.diagonal()); }

  /// L^-1 X.
  template <int Columns>
  Eigen::Matrix<Scalar, Size, Columns> solve_lower(Eigen::Matrix<Scalar, Size, Columns> X) const noexcept {
    for (int c = 0; c < Columns; ++c) {
      RME_UNROLL
      for (int i = 0; i < Size; ++i) {
        Scalar sum = X(i, c);
        RME_UNROLL
        for (int k = 0; k < i; ++k) sum -= L_(i, k) * X(k, c);
        X(i, c) = sum * inverse_diagonal_[i];
      }
    }
    return X;
  }

  /// A^-1 X.
  template <int Columns>
  Eigen::Matrix<Scalar, Size, Columns> solve(const Eigen::Matrix<Scalar, Size, Columns>& X) const noexcept {
    Eigen::Matrix<Scalar, Size, Columns> Y = solve_lower(X);
    for (int c = 0; c < Columns; ++c) {
      RME_UNROLL
      for (int i = Size - 1; i >= 0; --i) {
        Scalar sum = Y(i, c);
        RME_UNROLL
        for (int k = i + 1; k < Size; ++k) sum -= L_(k, i) * Y(k, c);
        Y(i, c) = sum * inverse_diagonal_[i];
      }
    }
    return Y;
  }

  /// A^-1, symmetric to the last bit.
  Matrix inverse() const noexcept {
    Matrix inverse_lower = Matrix::Zero();
    RME_UNROLL
    for (int j = 0; j < Size; ++j) {
      inverse_lower(j, j) = inverse_diagonal_[j];
      RME_UNROLL
      for (int i = j + 1; i < Size; ++i) {
        Scalar sum = Scalar(0);
        RME_UNROLL
        for (int k = j; k < i; ++k) sum -= L_(i, k) * inverse_lower(k, j);
        inverse_lower(i, j) = sum * inverse_diagonal_[i];
      }
    }
    Matrix out;
    RME_UNROLL
    for (int j = 0; j < Size; ++j) {
      RME_UNROLL
      for (int i = j; i < Size; ++i) {
        Scalar sum = Scalar(0);
        RME_UNROLL
        for (int k = i; k < Size; ++k) sum += inverse_lower(k, i) * inverse_lower(k, j);
        out(i, j) = out(j, i) = sum;
      }
    }
    return out;
  }

 private:
  Matrix L_ = Matrix::Zero();
  Eigen::Matrix<Scalar, Size, 1> inverse_diagonal_ = Eigen::Matrix<Scalar, Size, 1>::Zero();
  bool positive_definite_ = false;
};

}  // namespace rme
