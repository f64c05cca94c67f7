#include <random>
#include <rme/core/householder.hpp>

#include "support/catch.hpp"

namespace {

using namespace rme;

template <int Rows, int Columns>
using Tall = Eigen::Matrix<double, Rows, Columns>;

/// H_0 .. H_n-1 [R; 0] of a factorisation.
template <int Rows, int Columns>
Tall<Rows, Columns> multiplied(const Tall<Rows, Columns>& factored, const Eigen::Matrix<double, Columns, 1>& diagonal) {
  Tall<Rows, Columns> out = Tall<Rows, Columns>::Zero();
  for (int j = 0; j < Columns; ++j) {
    for (int i = 0; i < j; ++i) out(i, j) = factored(i, j);
    out(j, j) = diagonal[j];
  }
  for (int k = Columns - 1; k >= 0; --k) {
    Eigen::Matrix<double, Rows, 1> v = Eigen::Matrix<double, Rows, 1>::Zero();
    v.tail(Rows - k) = factored.col(k).tail(Rows - k);
    out -= v * (v.transpose() * out).eval();
  }
  return out;
}

template <int Rows, int Columns>
void check(const Tall<Rows, Columns>& A, double scale) {
  Tall<Rows, Columns> factored = A;
  Eigen::Matrix<double, Columns, 1> diagonal;
  detail::householder(factored, diagonal);
  CHECK((multiplied(factored, diagonal) - A).cwiseAbs().maxCoeff() <= 1e-14 * scale);
}

TEST_CASE("householder: reflections times R are the matrix, whatever its size, scale and rank", "[householder]") {
  constexpr unsigned kSeed = 85;
  CAPTURE(kSeed);
  std::mt19937_64 random(kSeed);
  std::normal_distribution<double> normal;
  const auto draw = [&] { return normal(random); };
  for (const double scale : {1.0, 1e-8, 1e8}) {
    for (int i = 0; i < 20; ++i) {
      const Tall<7, 6> tall = scale * Tall<7, 6>::NullaryExpr(draw);
      const Tall<13, 7> taller = scale * Tall<13, 7>::NullaryExpr(draw);
      check<7, 6>(tall, 10 * scale);
      check<13, 7>(taller, 10 * scale);
      check<3, 3>(scale * Tall<3, 3>::NullaryExpr(draw), 10 * scale);
      Tall<7, 6> deficient = tall;
      deficient.col(3) = deficient.col(1);
      deficient.col(4).setZero();
      check<7, 6>(deficient, 10 * scale);
    }
  }
  check<7, 6>(Tall<7, 6>::Zero(), 1);
}

}  // namespace
