#include <random>
#include <rme/network/conv1d.hpp>

#include "support/catch.hpp"

namespace {

TEST_CASE("Conv1d: one channel by hand, a correlation with zeros beyond both ends", "[conv1d]") {
  rme::Conv1d<double, 4, 1, 1, 3> convolution;
  convolution.patch_layer.weight << 1, 10, 100;
  convolution.patch_layer.bias << 0.5;
  Eigen::Matrix<double, 1, 4> y;
  convolution.forward(Eigen::Vector4d(1, 2, 3, 4), y);
  // y_t = 1 x[t-1] + 10 x[t] + 100 x[t+1] + 0.5; a convolution proper would have 1 and 100 the other way round.
  CHECK(y == Eigen::RowVector4d(210.5, 321.5, 432.5, 43.5));
}

TEST_CASE("Conv1d: several channels agree with the defining sum", "[conv1d]") {
  constexpr int samples = 20, in = 6, out = 7, kernel = 5;
  const unsigned seed = 2;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  rme::Conv1d<double, samples, in, out, kernel> convolution;
  double weight[out][in][kernel];  // PyTorch's shape
  for (int o = 0; o < out; ++o) {
    convolution.patch_layer.bias[o] = normal(random);
    for (int c = 0; c < in; ++c) {
      for (int k = 0; k < kernel; ++k) {
        weight[o][c][k] = normal(random);
        convolution.patch_layer.weight(o, c * kernel + k) = weight[o][c][k];
      }
    }
  }
  const auto x = Eigen::Matrix<double, samples, in>::NullaryExpr([&] { return normal(random); }).eval();
  Eigen::Matrix<double, out, samples> y;
  convolution.forward(x, y);
  for (int t = 0; t < samples; ++t) {
    for (int o = 0; o < out; ++o) {
      double sum = convolution.patch_layer.bias[o];
      for (int c = 0; c < in; ++c) {
        for (int k = 0; k < kernel; ++k) {
          const int source = t + k - 2;
          if (source >= 0 && source < samples) sum += weight[o][c][k] * x(source, c);
        }
      }
      CAPTURE(t, o);
      CHECK(y(o, t) == Approx(sum).margin(1e-13));
    }
  }
}

}  // namespace
