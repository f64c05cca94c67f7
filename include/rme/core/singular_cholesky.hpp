#pragma once
/// Cholesky factorisation of small matrices some of whose directions have no variance.
#include <Eigen/Core>
#include <cmath>
#include <rme/core/small_matrix.hpp>

namespace rme {

/// P = L L^T of a symmetric positive semidefinite matrix; only its lower triangle is read. A direction whose variance
/// is zero, to within rounding, gets a column of zeros. Real time: Size^3 / 6 multiplications, no allocation.
template <typename Scalar, int Size>
class SingularCholesky {
 public:
  using Matrix = Eigen::Matrix<Scalar, Size, Size>;  ///< P and L

  /// Factorises P; finite() says whether that worked.
  explicit SingularCholesky(const Matrix& P) noexcept {
    using std::sqrt;
    finite_ = detail::finite(P);
    if (!finite_) return;
    for (int j = 0; j < Size; ++j) {
      for (int i = j; i < Size; ++i) L_(i, j) = P(i, j);
      for (int k = 0; k < j; ++k) {
        const Scalar head = L_(j, k);
        for (int i = j; i < Size; ++i) L_(i, j) -= head * L_(i, k);
      }
      const Scalar pivot = L_(j, j);
      // Relative to its own diagonal entry, since the entries have different units.
      const bool varies = pivot > Eigen::NumTraits<Scalar>::epsilon() * 16 * P(j, j);
      const Scalar scale = varies ? Scalar(1) / sqrt(pivot) : Scalar(0);
      for (int i = j; i < Size; ++i) L_(i, j) *= scale;
    }
  }

  /// Whether P is finite. If not, no other member means anything.
  bool finite() const noexcept { return finite_; }
  /// L, lower triangular: zero above the diagonal.
  const Matrix& lower() const noexcept { return L_; }

  /// P^-1 X in the directions that have variance; the others are zero.
  template <int Columns>
  Eigen::Matrix<Scalar, Size, Columns> solve(Eigen::Matrix<Scalar, Size, Columns> X) const noexcept {
    for (int c = 0; c < Columns; ++c) {
      for (int i = 0; i < Size; ++i) {
        X(i, c) = L_(i, i) > 0 ? X(i, c) / L_(i, i) : Scalar(0);
        for (int k = i + 1; k < Size; ++k) X(k, c) -= L_(k, i) * X(i, c);
      }
      for (int i = Size - 1; i >= 0; --i) {
        Scalar sum = X(i, c);
        for (int k = i + 1; k < Size; ++k) sum -= L_(k, i) * X(k, c);
        X(i, c) = L_(i, i) > 0 ? sum / L_(i, i) : Scalar(0);
      }
    }
    return X;
  }
  /// L^-1 in the directions that have variance, with zeros in the rows and columns of the others.
  Matrix inverse_lower() const noexcept {
    Matrix out = Matrix::Zero();
    for (int j = 0; j < Size; ++j) {
      if (!(L_(j, j) > 0)) continue;
      out(j, j) = Scalar(1) / L_(j, j);
      for (int i = j + 1; i < Size; ++i) {
        if (!(L_(i, i) > 0)) continue;
        Scalar sum = Scalar(0);
        for (int k = j; k < i; ++k) sum -= L_(i, k) * out(k, j);
        out(i, j) = sum / L_(i, i);
      }
    }
    return out;
  }

 private:
  Matrix L_ = Matrix::Zero();
  bool finite_ = false;
};

}  // namespace rme
