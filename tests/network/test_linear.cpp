#include <rme/network/linear.hpp>

#include "support/catch.hpp"

namespace {

// By hand: W = [1 2 3; 4 5 6], b = (10, 20), x = (1, 0, -1) and (2, 1, 0).
rme::Linear<double, 3, 2> example() {
  rme::Linear<double, 3, 2> layer;
  layer.weight << 1, 2, 3, 4, 5, 6;
  layer.bias << 10, 20;
  return layer;
}

TEST_CASE("Linear: gives W x + b for each column", "[linear]") {
  Eigen::Matrix<double, 3, 2> x;
  x << 1, 2, 0, 1, -1, 0;
  Eigen::Matrix<double, 2, 2> y;
  example().forward(x, y);
  Eigen::Matrix<double, 2, 2> expected;
  expected << 8, 14, 18, 33;
  CHECK(y == expected);
}

TEST_CASE("Linear: compose_layers gives the layer that does one and then the other", "[linear]") {
  rme::Linear<double, 2, 1> outer;
  outer.weight << 3, -1;
  outer.bias << 0.5;
  const rme::Linear<double, 3, 1> both = rme::compose_layers(outer, example());
  // By hand: 3 * (first row) - (second row), 3 * 10 - 20 + 0.5.
  CHECK(both.weight == Eigen::RowVector3d(-1, 1, 3));
  CHECK(both.bias[0] == 10.5);
}

}  // namespace
