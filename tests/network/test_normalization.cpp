#include <rme/network/normalization.hpp>

#include "support/catch.hpp"

namespace {

TEMPLATE_TEST_CASE("Normalization: each channel is shifted and scaled by its own numbers", "[normalization]", float,
                   double) {
  rme::Normalization<TestType, 2> normalization;
  normalization.mean << 1, -2;
  normalization.std << 2, TestType(0.5);
  Eigen::Matrix<TestType, 3, 2> window;
  window << 1, -2, 3, -1, -3, 0;
  Eigen::Matrix<TestType, 3, 2> y;
  normalization.forward(window, y);
  Eigen::Matrix<TestType, 3, 2> expected;
  expected << 0, 0, 1, 2, -2, 4;
  CHECK(y == expected);
}

}  // namespace
