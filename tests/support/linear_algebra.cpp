#include "support/linear_algebra.hpp"

#include <Eigen/Dense>
#include <algorithm>
#include <functional>

namespace oracle {

namespace {

// Of Jacobi's methods, which take a few: they converge quadratically. Eigen's decompositions take seconds to compile.
constexpr int kSweeps = 20;

}  // namespace

Matrix random_matrix(std::mt19937& random, int rows, int columns) {
  std::normal_distribution<double> normal;
  Matrix m(rows, columns);
  for (int i = 0; i < m.size(); ++i) m.data()[i] = normal(random);
  return m;
}

Matrix random_rotation(std::mt19937& random, int n) {
  // The Q of a Gaussian matrix, one reflection after another: HouseholderQR does the same in blocks, which take long to
  // compile.
  Matrix gaussian = random_matrix(random, n, n);
  Vector scale(n), workspace(n);
  for (int k = 0; k < n; ++k) {
    double length = 0;
    gaussian.col(k).tail(n - k).makeHouseholderInPlace(scale[k], length);
    gaussian.bottomRightCorner(n - k, n - k - 1)
        .applyHouseholderOnTheLeft(gaussian.col(k).tail(n - k - 1), scale[k], workspace.data());
  }
  Matrix Q = Matrix::Identity(n, n);
  for (int k = n - 1; k >= 0; --k) {
    Q.bottomRightCorner(n - k, n).applyHouseholderOnTheLeft(gaussian.col(k).tail(n - k - 1), scale[k],
                                                            workspace.data());
  }
  return Q;
}

Matrix composed(const Matrix& U, const Vector& sigma, const Matrix& V) {
  const Matrix scaled = U.leftCols(sigma.size()) * sigma.asDiagonal(), axes = V.leftCols(sigma.size());
  return scaled * axes.transpose();
}

Matrix product(const Matrix& A, const Matrix& B) {
  return A * B;
}

Matrix congruence(const Matrix& A, const Matrix& S) {
  const Matrix AS = A * S;
  return AS * A.transpose();
}

Matrix square(const Matrix& L) {
  return L * L.transpose();
}

Matrix transposed(const Matrix& A) {
  return A.transpose();
}

Matrix inverse(const Matrix& A) {
  return A.inverse();
}

Vector singular_values(const Matrix& A) {
  // Pairs of columns are turned until all are orthogonal: their lengths then are the singular values.
  Matrix B = A.rows() < A.cols() ? transposed(A) : A;
  const auto n = B.cols();
  Eigen::JacobiRotation<double> turn;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (Eigen::Index p = 0; p < n; ++p) {
      for (Eigen::Index q = p + 1; q < n; ++q) {
        turn.makeJacobi(B.col(p).squaredNorm(), B.col(p).dot(B.col(q)), B.col(q).squaredNorm());
        B.applyOnTheRight(p, q, turn);
      }
    }
  }
  Vector lengths(n);
  for (Eigen::Index p = 0; p < n; ++p) lengths[p] = B.col(p).norm();
  std::sort(lengths.data(), lengths.data() + n, std::greater<>());
  return lengths;
}

Vector eigenvalues(const Matrix& A) {
  // Jacobi's method: one off-diagonal pair after another is turned to zero.
  Matrix B = A;
  const auto n = B.cols();
  Eigen::JacobiRotation<double> turn;
  for (int sweep = 0; sweep < kSweeps; ++sweep) {
    for (Eigen::Index p = 0; p < n; ++p) {
      for (Eigen::Index q = p + 1; q < n; ++q) {
        turn.makeJacobi(B, p, q);
        B.applyOnTheRight(p, q, turn);
        B.applyOnTheLeft(p, q, turn.transpose());
      }
    }
  }
  Vector values = B.diagonal();
  std::sort(values.data(), values.data() + n);
  return values;
}

Matrix solve(const Matrix& A, const Matrix& B) {
  return A.ldlt().solve(B);
}

double log_normal(const Vector& x, const Matrix& covariance) {
  const Eigen::LDLT<Matrix> ldlt(covariance);
  const Matrix weighted = ldlt.solve(Matrix(x));
  return -0.5 * (x.dot(weighted.col(0)) + ldlt.vectorD().array().log().sum());
}

}  // namespace oracle
