#include <cmath>
#include <limits>
#include <random>
#include <rme/core/sum_of_logs.hpp>

#include "support/catch.hpp"

namespace {

template <typename Scalar, int Size>
void compare_with_logs_one_by_one(std::mt19937_64& random, double decades) {
  std::uniform_real_distribution<double> exponent(-decades, decades);
  for (int k = 0; k < 100; ++k) {
    const Eigen::Matrix<Scalar, Size, 1> x =
        Eigen::Matrix<Scalar, Size, 1>::NullaryExpr([&] { return Scalar(std::pow(10, exponent(random))); });
    double sum = 0, size = 1;
    for (const Scalar value : x) {
      sum += std::log(double(value));
      size += std::abs(std::log(double(value)));
    }
    CAPTURE(Size, k, sum);
    CHECK(std::abs(rme::sum_of_logs(x) - sum) < 4 * size * double(std::numeric_limits<Scalar>::epsilon()));
  }
}

TEST_CASE("sum_of_logs: the sum of the logarithms, of every size and up to the stated bounds", "[sum_of_logs]") {
  const unsigned seed = 610;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  compare_with_logs_one_by_one<double, 1>(random, 100);
  compare_with_logs_one_by_one<double, 2>(random, 100);
  compare_with_logs_one_by_one<double, 3>(random, 100);
  compare_with_logs_one_by_one<double, 4>(random, 100);
  compare_with_logs_one_by_one<double, 7>(random, 100);
  compare_with_logs_one_by_one<float, 3>(random, 12);
  compare_with_logs_one_by_one<float, 7>(random, 12);
}

TEST_CASE("sum_of_logs: zero, infinity and NaN show in the sum", "[sum_of_logs]") {
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  CHECK(std::isnan(rme::sum_of_logs(Eigen::Vector4d(1, nan, 1, 1))));
  CHECK(rme::sum_of_logs(Eigen::Vector4d(1, 0, 1, 1)) == -infinity);
  CHECK(rme::sum_of_logs(Eigen::Vector4d(1, 1, 1, infinity)) == infinity);
}

}  // namespace
