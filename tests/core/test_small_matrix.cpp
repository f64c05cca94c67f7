#include <limits>
#include <random>
#include <rme/core/small_matrix.hpp>
#include <rme/sensing/proprioception.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using namespace rme;

/// The same numbers, of any size.
template <typename Derived>
oracle::Matrix same(const Derived& m) {
  oracle::Matrix out(m.rows(), m.cols());
  for (Eigen::Index j = 0; j < m.cols(); ++j)
    for (Eigen::Index i = 0; i < m.rows(); ++i) out(i, j) = m(i, j);
  return out;
}

/// The largest difference to Eigen's own product and sums, of random matrices of these sizes.
template <typename Scalar, int Rows, int Inner, int Columns>
double largest_difference(std::mt19937_64& random) {
  const auto draw = [&](auto matrix) {
    std::normal_distribution<double> normal;
    for (Eigen::Index i = 0; i < matrix.size(); ++i) matrix(i) = static_cast<Scalar>(normal(random));
    return matrix;
  };
  const auto A = draw(Eigen::Matrix<Scalar, Rows, Inner>());
  const auto B = draw(Eigen::Matrix<Scalar, Inner, Columns>());
  const auto C = draw(Eigen::Matrix<Scalar, Inner, Rows>());
  const auto X = draw(Eigen::Matrix<Scalar, Rows, Columns>()), Y = draw(X);
  const auto x = draw(Eigen::Matrix<Scalar, Rows, 1>()), z = draw(x);
  const auto y = draw(Eigen::Matrix<Scalar, Columns, 1>());
  const Scalar s = Scalar(0.7);
  double worst = 0;
  const auto compare = [&](const auto& ours, const oracle::Matrix& theirs) {
    REQUIRE(ours.rows() == theirs.rows());
    REQUIRE(ours.cols() == theirs.cols());
    REQUIRE(ours.allFinite());
    worst = std::max(worst, (same(ours) - theirs).cwiseAbs().maxCoeff());
  };
  compare(detail::product(A, B), oracle::product(same(A), same(B)));
  compare(detail::transposed_product(C, B), oracle::product(oracle::transposed(same(C)), same(B)));
  compare(detail::outer_square(A), oracle::square(same(A)));
  auto outer = X;
  detail::add_outer(outer, x, y);
  compare(outer, same(X) + oracle::product(same(x), oracle::transposed(same(y))));
  auto sum = X;
  detail::add_scaled(sum, s, Y);
  compare(sum, same(X) + double(s) * same(Y));
  compare(detail::scaled(s, X), double(s) * same(X));
  compare(detail::difference(X, Y), same(X) - same(Y));
  const double dot = oracle::product(oracle::transposed(same(x)), same(z))(0, 0);
  return std::max(worst, std::abs(double(detail::dot(x, z)) - dot));
}

TEST_CASE("small_matrix: products and sums are Eigen's, whatever the sizes", "[small_matrix]") {
  constexpr unsigned kSeed = 83;
  CAPTURE(kSeed);
  std::mt19937_64 random(kSeed);
  for (int i = 0; i < 20; ++i) {
    CHECK(largest_difference<double, 1, 1, 1>(random) < 1e-13);
    CHECK(largest_difference<double, 3, 3, 6>(random) < 1e-13);
    CHECK(largest_difference<double, 6, 7, 2>(random) < 1e-13);
    CHECK(largest_difference<double, 10, 10, 5>(random) < 1e-13);
    CHECK(largest_difference<double, 5, 10, 5>(random) < 1e-13);
    CHECK(largest_difference<float, 7, 6, 10>(random) < 1e-5);
    CHECK(largest_difference<float, 4, 5, 3>(random) < 1e-5);
  }
}

TEST_CASE("small_matrix: one entry that is not finite is found wherever it stands", "[small_matrix]") {
  using Matrix = Eigen::Matrix<double, 5, 3>;
  const double infinity = std::numeric_limits<double>::infinity();
  const double huge = std::numeric_limits<double>::max();
  CHECK(detail::finite(Matrix(Matrix::Constant(huge))));
  for (int i = 0; i < 5; ++i) {
    for (int j = 0; j < 3; ++j) {
      for (const double bad : {infinity, -infinity, std::numeric_limits<double>::quiet_NaN()}) {
        Matrix X = Matrix::Ones();
        X(i, j) = bad;
        CHECK_FALSE(detail::finite(X));
      }
    }
  }
}

TEST_CASE("is_rotation: accepts a rotation to a thousandth, and refuses a mirrored or stretched one and a NaN",
          "[small_matrix]") {
  constexpr unsigned kSeed = 84;
  CAPTURE(kSeed);
  std::mt19937_64 random(kSeed);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 50; ++i) {
    const Eigen::Quaterniond q{normal(random), normal(random), normal(random), normal(random)};
    const Matrix3<double> R = q.normalized().toRotationMatrix();
    CHECK(detail::is_rotation(R));
    CHECK(detail::is_rotation<double>(R * 1.0004));
    CHECK_FALSE(detail::is_rotation<double>(R * 1.0006));
    CHECK_FALSE(detail::is_rotation<double>(-R));
    for (int row = 0; row < 3; ++row) {
      Matrix3<double> mirror = R;
      mirror.row(row) *= -1;
      CHECK_FALSE(detail::is_rotation(mirror));
      mirror(row, 1) = std::numeric_limits<double>::quiet_NaN();
      CHECK_FALSE(detail::is_rotation(mirror));
    }
  }
}

}  // namespace
