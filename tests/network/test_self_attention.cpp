#include <cmath>
#include <random>
#include <rme/network/self_attention.hpp>
#include <vector>

#include "support/catch.hpp"

namespace {

constexpr int kSamples = 5, kEmbed = 6, kHeads = 3, kSize = kEmbed / kHeads;
using Attention = rme::SelfAttention<double, kSamples, kEmbed, kHeads>;

TEMPLATE_TEST_CASE("SelfAttention: weights are a softmax over the keys, also where exp would overflow", "[attention]",
                   float, double) {
  // One query of each size against keys 0 and 1: the softmax of (0, q) is (1, e^q) / (1 + e^q).
  Eigen::Matrix<TestType, 2, 1> queries(1, 1000), keys(0, 1);
  Eigen::Matrix<TestType, 2, 2> weights;
  rme::attention_weights(queries, keys, weights);
  const auto e = std::exp(TestType(1));
  CHECK(weights(0, 0) == Approx(1 / (1 + e)));
  CHECK(weights(0, 1) == Approx(e / (1 + e)));
  CHECK(weights(1, 0) == Approx(0).margin(1e-30));  // no key gets less than exp(-80)
  CHECK(weights(1, 1) == 1);
}

TEMPLATE_TEST_CASE("SelfAttention: each row of numerators has 1 as its largest, and nothing beside them is written",
                   "[attention]", float, double) {
  struct {
    Eigen::Matrix<TestType, 5, 5> numerators;
    TestType beside = 7;
  } memory;
  static_assert(sizeof memory == 26 * sizeof(TestType));
  Eigen::Matrix<TestType, 5, 1> queries, keys;
  queries << -3, -1, TestType(0.5), 2, 20;
  keys << -2, -1, 0, 1, 3;
  const Eigen::Matrix<TestType, 5, 1> sums = rme::softmax_numerators(queries, keys, memory.numerators);
  CHECK((memory.numerators.rowwise().maxCoeff().array() == 1).all());
  CHECK((memory.numerators.rowwise().sum() - sums).norm() <= 8 * Eigen::NumTraits<TestType>::epsilon());
  CHECK(memory.beside == 7);
}

TEMPLATE_TEST_CASE("SelfAttention: mean weights are the mean over the queries", "[attention]", float, double) {
  const unsigned seed = 4;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<TestType> normal;
  Eigen::Matrix<TestType, kSamples, kSize> queries, keys;
  queries = queries.NullaryExpr([&] { return 3 * normal(random); });
  keys = keys.NullaryExpr([&] { return 3 * normal(random); });
  Eigen::Matrix<TestType, kSamples, kSamples> weights;
  rme::attention_weights(queries, keys, weights);
  const auto mean = rme::mean_attention_weights<TestType, kSamples>(queries, keys);
  CHECK((weights.colwise().mean().transpose() - mean).norm() < 4 * Eigen::NumTraits<TestType>::epsilon());
  CHECK(mean.sum() == Approx(1));
}

TEST_CASE("SelfAttention: agrees with the textbook formula, written out in loops", "[attention]") {
  const unsigned seed = 3;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto fill = [&](auto& m) { m = m.NullaryExpr(m.rows(), m.cols(), [&] { return normal(random); }).eval(); };
  Attention attention;
  fill(attention.in_proj.weight);
  fill(attention.in_proj.bias);
  fill(attention.out_proj.weight);
  fill(attention.out_proj.bias);
  Attention::Sequence x, y;
  fill(x);
  attention.forward(x, y);

  const auto projected = [&](int part, int channel, int t) {
    const int row = part * kEmbed + channel;
    double sum = attention.in_proj.bias[row];
    for (int i = 0; i < kEmbed; ++i) sum += attention.in_proj.weight(row, i) * x(i, t);
    return sum;
  };
  Attention::Sequence concatenated;
  for (int t = 0; t < kSamples; ++t) {
    for (int h = 0; h < kHeads; ++h) {
      std::vector<double> share(kSamples);
      double total = 0;
      for (int s = 0; s < kSamples; ++s) {
        double score = 0;
        for (int d = 0; d < kSize; ++d) score += projected(0, h * kSize + d, t) * projected(1, h * kSize + d, s);
        total += share[std::size_t(s)] = std::exp(score / std::sqrt(double(kSize)));
      }
      for (int d = 0; d < kSize; ++d) {
        double sum = 0;
        for (int s = 0; s < kSamples; ++s) sum += share[std::size_t(s)] / total * projected(2, h * kSize + d, s);
        concatenated(h * kSize + d, t) = sum;
      }
    }
  }
  for (int t = 0; t < kSamples; ++t) {
    for (int o = 0; o < kEmbed; ++o) {
      double sum = attention.out_proj.bias[o];
      for (int i = 0; i < kEmbed; ++i) sum += attention.out_proj.weight(o, i) * concatenated(i, t);
      CAPTURE(t, o);
      CHECK(y(o, t) == Approx(sum).margin(1e-12));
    }
  }
}

}  // namespace
