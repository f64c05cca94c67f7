#include <rme/network/mlp.hpp>

#include "support/catch.hpp"

namespace {

TEST_CASE("SharedMlp: each repeat applies the same block, and nothing is rectified between repeats", "[mlp]") {
  // f(x) = -2 relu(x + 1) + 1 relu(x - 1) - 1. By hand: f(3) = -8 + 2 - 1 = -7, f(-7) = -1, f(-1) = -1, f(0) = -3.
  // Were the -7 rectified on its way into the second repeat, f(0) would come out.
  rme::SharedMlp<double, 1, 2, 1> once;
  once.expand.weight << 1, 1;
  once.expand.bias << 1, -1;
  once.contract.weight << -2, 1;
  once.contract.bias << -1;
  Eigen::Matrix<double, 1, 1> x(3);
  once.forward(x);
  CHECK(x[0] == -7);

  const rme::SharedMlp<double, 1, 2, 2> twice{once.expand, once.contract};
  x[0] = 3;
  twice.forward(x);
  CHECK(x[0] == -1);
}

}  // namespace
