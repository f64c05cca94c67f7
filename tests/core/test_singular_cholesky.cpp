#include <cmath>
#include <limits>
#include <random>
#include <rme/core/singular_cholesky.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using oracle::Matrix;
constexpr int kSize = 10;
using Matrix10 = Eigen::Matrix<double, kSize, kSize>;
using Factor = rme::SingularCholesky<double, kSize>;

TEST_CASE("SingularCholesky: factorises singular matrices too, leaves out what is rounding, and refuses a NaN",
          "[cholesky]") {
  const unsigned seed = 516;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int rank = 0; rank <= kSize; ++rank) {
    CAPTURE(rank);
    const Matrix G = oracle::random_matrix(random, kSize, rank);
    Matrix scale = Matrix::Identity(kSize, kSize);
    for (int i = 4; i < kSize; ++i) scale(i, i) = 1e-4;  // kilograms beside kilogram square metres
    const Matrix10 P = oracle::congruence(scale, oracle::square(G));
    const Factor factor(P);
    REQUIRE(factor.finite());
    const Matrix10& L = factor.lower();
    CHECK(L.isLowerTriangular(0));
    if (rank == 1) CHECK((L.diagonal().array() > 0).count() == 1);
    // Entry by entry, relative to the diagonal's scale.
    const Matrix off = oracle::square(L) - P;
    for (int i = 0; i < kSize; ++i)
      for (int k = 0; k < kSize; ++k) CHECK(std::abs(off(i, k)) <= 1e-13 * std::sqrt(P(i, i) * P(k, k)));
  }
  // A direction of which P says nothing: a mass that is known exactly.
  Matrix10 P = Matrix10::Identity();
  P.row(0).setZero();
  P.col(0).setZero();
  CHECK(Factor(P).lower() == P);
  P(3, 3) = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(Factor(P).finite());
}

TEST_CASE("SingularCholesky: solves and inverts in the directions that have variance, and no other", "[cholesky]") {
  const unsigned seed = 17;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    // Some entries are known exactly: their rows and columns are zero.
    Matrix10 P = oracle::square(oracle::random_matrix(random, kSize, kSize));
    Matrix10 varies = Matrix10::Identity();
    for (int i = 0; i < kSize; ++i) varies(i, i) = random() % 3 == 0 ? 0 : 1;
    P = Matrix10(varies * P * varies);
    const Factor factor(P);
    REQUIRE(factor.finite());
    const Eigen::Matrix<double, kSize, 3> X = oracle::random_matrix(random, kSize, 3);
    // With ones in place of the zeros, P is regular and couples nothing new.
    const Matrix10 regular = P + Matrix10(Matrix10::Identity() - varies);
    CHECK((factor.solve(X) - varies * oracle::solve(regular, varies * X)).norm() < 1e-7);
    const Matrix10 inverse = factor.inverse_lower();
    CHECK((inverse * factor.lower() - varies).norm() < 1e-9);
    CHECK((inverse - varies * inverse * varies).norm() == 0);
  }
}

}  // namespace
