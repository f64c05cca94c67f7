#pragma once
/// Linear algebra of any size for oracles. Compiled once: Eigen's decompositions would take a test longer than what it
/// tests.
#include <Eigen/Core>
#include <random>

namespace oracle {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// Entries from N(0, 1).
Matrix random_matrix(std::mt19937& random, int rows, int columns);
/// An orthogonal matrix.
Matrix random_rotation(std::mt19937& random, int n);

/// U diag(sigma) V^T, with as many columns of U and V as sigma has numbers.
Matrix composed(const Matrix& U, const Vector& sigma, const Matrix& V);
/// Descending.
Vector singular_values(const Matrix& A);
/// Ascending, of a symmetric matrix.
Vector eigenvalues(const Matrix& A);

/// A B.
Matrix product(const Matrix& A, const Matrix& B);
/// A S A^T.
Matrix congruence(const Matrix& A, const Matrix& S);
/// L L^T.
Matrix square(const Matrix& L);
Matrix transposed(const Matrix& A);

Matrix inverse(const Matrix& A);
/// A^-1 B of a symmetric positive definite A.
Matrix solve(const Matrix& A, const Matrix& B);
/// log N(x; 0, covariance) without its factor of 2 pi.
double log_normal(const Vector& x, const Matrix& covariance);

}  // namespace oracle
