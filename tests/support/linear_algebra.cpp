#include "support/linear_algebra.hpp"

#include <Eigen/Dense>

namespace oracle {

Matrix random_matrix(std::mt19937& random, int rows, int columns) {
  std::normal_distribution<double> normal;
  Matrix m(rows, columns);
  for (int i = 0; i < m.size(); ++i) m.data()[i] = normal(random);
  return m;
}

Matrix random_rotation(std::mt19937& random, int n) {
  const Matrix gaussian = random_matrix(random, n, n);
  return Eigen::HouseholderQR<Matrix>(gaussian).householderQ() * Matrix::Identity(n, n);
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
  return Eigen::JacobiSVD<Matrix>(A).singularValues();
}

Vector eigenvalues(const Matrix& A) {
  return Eigen::SelfAdjointEigenSolver<Matrix>(A, Eigen::EigenvaluesOnly).eigenvalues();
}

Matrix solve(const Matrix& A, const Matrix& B) {
  return A.ldlt().solve(B);
}

double log_normal(const Vector& x, const Matrix& covariance) {
  const Eigen::LLT<Matrix> llt(covariance);
  const Vector white = llt.matrixL().solve(x);
  return -0.5 * white.squaredNorm() - llt.matrixLLT().diagonal().array().log().sum();
}

}  // namespace oracle
