#include <Eigen/Cholesky>
#include <limits>
#include <random>
#include <rme/core/cholesky.hpp>
#include <utility>

#include "support/catch.hpp"

namespace {

template <int Size>
void compare_with_eigen(std::mt19937_64& random) {
  using Matrix = Eigen::Matrix<double, Size, Size>;
  std::normal_distribution<double> normal;
  for (int k = 0; k < 200; ++k) {
    CAPTURE(Size, k);
    const Matrix X = Matrix::NullaryExpr([&] { return normal(random); });
    const Matrix A = X * X.transpose() + 0.1 * Matrix::Identity();
    const Eigen::Matrix<double, Size, 3> b =
        Eigen::Matrix<double, Size, 3>::NullaryExpr([&] { return normal(random); });
    Matrix lower_only = A;
    lower_only.template triangularView<Eigen::StrictlyUpper>().setConstant(std::nan(""));
    const rme::Cholesky<double, Size> factor(lower_only);
    const Eigen::LLT<Matrix> llt(A);
    const Matrix L = llt.matrixL();
    REQUIRE(factor.positive_definite());
    // Conditions of up to some hundreds: 1e-12 leaves room for another order of summation.
    CHECK((factor.lower() - L).norm() <= 1e-12 * L.norm());
    CHECK(factor.log_det_lower() == Approx(L.diagonal().array().log().sum()).margin(1e-12));
    CHECK((L * factor.solve_lower(b) - b).norm() <= 1e-12 * (b.norm() + 1));
    CHECK((A * factor.solve(b) - b).norm() <= 1e-11 * (b.norm() + 1));
    const Matrix inverse = factor.inverse();
    CHECK((A * inverse - Matrix::Identity()).norm() <= 1e-11);
    CHECK((inverse - inverse.transpose()).norm() == 0);
  }
}

TEST_CASE("Cholesky: factor, solutions and inverse are Eigen's", "[cholesky]") {
  const unsigned seed = 601;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  compare_with_eigen<3>(random);
  compare_with_eigen<4>(random);
  compare_with_eigen<6>(random);
}

TEST_CASE("Cholesky: what is not positive definite, or no number, is recognised", "[cholesky]") {
  Eigen::Matrix3d A = Eigen::Matrix3d::Identity();
  CHECK(rme::Cholesky<double, 3>(A).positive_definite());
  A(2, 2) = 0;
  CHECK_FALSE(rme::Cholesky<double, 3>(A).positive_definite());
  A(2, 2) = -1;
  CHECK_FALSE(rme::Cholesky<double, 3>(A).positive_definite());
  A(2, 2) = 1;
  A(2, 0) = 2;
  CHECK_FALSE(rme::Cholesky<double, 3>(A).positive_definite());
  A(2, 0) = std::numeric_limits<double>::quiet_NaN();
  CHECK_FALSE(rme::Cholesky<double, 3>(A).positive_definite());
}

using Factor = rme::Cholesky<double, 4>;
static_assert(
    noexcept(Factor(std::declval<const Eigen::Matrix4d&>())) && noexcept(std::declval<const Factor&>().inverse()));
static_assert(noexcept(std::declval<const Factor&>().solve(std::declval<const Eigen::Vector4d&>())));

}  // namespace
