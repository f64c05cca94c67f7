#include <cmath>
#include <cstdlib>
#include <io/json_file.hpp>
#include <limits>
#include <memory>
#include <random>
#include <rme/network/json.hpp>
#include <rme/network/mismatch_network.hpp>

#include "network/golden.hpp"
#include "support/allocation_count.hpp"
#include "support/catch.hpp"

namespace {

template <typename Scalar>
using Network = rme::MismatchNetwork<Scalar>;

/// The reference: the layers one after the other, as design and paper draw them.
Eigen::Vector4d layer_by_layer(const rme::MismatchNetworkWeights<double>& w,
                               const Eigen::Matrix<double, 20, 6>& window) {
  using rme::detail::as_linear;
  using rme::detail::as_matrix;
  const rme::Normalization<double, 6> normalization{as_matrix<6, 1>(w.normalization_mean),
                                                    as_matrix<6, 1>(w.normalization_std)};
  const rme::Conv1d<double, 20, 6, 64, 5> convolution{as_linear<30, 64>(w.convolution_weight, w.convolution_bias)};
  const rme::SelfAttention<double, 20, 64, 8> attention{
      as_linear<64, 192>(w.attention_in_proj_weight, w.attention_in_proj_bias),
      as_linear<64, 64>(w.attention_out_proj_weight, w.attention_out_proj_bias)};
  const auto expand = as_linear<64, 256>(w.mlp_0_weight, w.mlp_0_bias);
  const auto contract = as_linear<256, 64>(w.mlp_2_weight, w.mlp_2_bias);
  const auto head = as_linear<64, 4>(w.head_weight, w.head_bias);

  Eigen::Matrix<double, 20, 6> normalized;
  normalization.forward(window, normalized);
  Eigen::Matrix<double, 64, 20> embedded, attended;
  convolution.forward(normalized, embedded);
  embedded += as_matrix<20, 64>(w.positional_embedding).transpose();
  attention.forward(embedded, attended);
  Eigen::Matrix<double, 64, 1> pooled = attended.rowwise().mean();
  for (int repeat = 0; repeat < 3; ++repeat) {
    Eigen::Matrix<double, 256, 1> hidden;
    expand.forward(pooled, hidden);
    hidden = hidden.cwiseMax(0.0);
    contract.forward(hidden, pooled);
  }
  Eigen::Matrix<double, 4, 1> out;
  head.forward(pooled, out);
  return out;
}

/// Largest difference from PyTorch's double-precision outputs over the windows of a golden file.
template <typename Scalar>
double largest_difference(const rme::MismatchNetworkWeights<double>& exact, const std::string& golden_file) {
  const auto golden = rme::examples::read_json_file(std::string(RME_TEST_DATA) + "/network/" + golden_file);
  const auto outputs = golden.at("outputs").get<std::vector<std::vector<double>>>();
  REQUIRE(outputs.size() == 1000);

  auto weights = std::make_unique<rme::MismatchNetworkWeights<Scalar>>();
  weights->frame = exact.frame;
  const auto copy = [](const auto& from, auto& to) {
    for (std::size_t i = 0; i < from.size(); ++i) to[i] = static_cast<Scalar>(from[i]);
  };
  copy(exact.normalization_mean, weights->normalization_mean);
  copy(exact.normalization_std, weights->normalization_std);
  std::vector<double> numbers;
  rme::for_each_tensor(exact, [&](auto, auto, const auto& a) { numbers.insert(numbers.end(), a.begin(), a.end()); });
  auto next = numbers.begin();
  rme::for_each_tensor(*weights, [&](auto, auto, auto& a) {
    for (auto& value : a) value = static_cast<Scalar>(*next++);
  });
  REQUIRE(next == numbers.end());

  const std::vector<double> mean(exact.normalization_mean.begin(), exact.normalization_mean.end());
  const std::vector<double> std(exact.normalization_std.begin(), exact.normalization_std.end());
  const auto windows = golden::random_windows(mean, std, 1000);
  const auto network = std::make_unique<Network<Scalar>>(*weights);
  double largest = 0;
  for (std::size_t i = 0; i < windows.size(); ++i) {
    typename Network<Scalar>::Output out = Network<Scalar>::Output::Zero();
    REQUIRE(network->forward(windows[i].template cast<Scalar>(), out) == rme::Status::Ok);
    const Eigen::Vector4d difference = out.template cast<double>() - Eigen::Vector4d(outputs[i].data());
    largest = std::max(largest, difference.cwiseAbs().maxCoeff());
  }
  return largest;
}

TEST_CASE("MismatchNetwork: PyTorch's answers to 1,000 windows, random weights", "[network]") {
  const auto weights = golden::random_weights<double>();
  const double in_double = largest_difference<double>(*weights, "golden_random.json");
  const double in_float = largest_difference<float>(*weights, "golden_random.json");
  CAPTURE(in_double, in_float);
  CHECK(in_double <= 1e-10);
  CHECK(in_float <= 1e-5);
}

TEST_CASE("MismatchNetwork: PyTorch's answers to 1,000 windows, the shipped weights", "[network]") {
  const auto model = std::make_unique<rme::MismatchModel<double>>(
      rme::model_from_json<double>(rme::examples::read_json_file(RME_PANDA_MODEL)));
  const double in_double = largest_difference<double>(model->weights, "golden_panda.json");
  const double in_float = largest_difference<float>(model->weights, "golden_panda.json");
  CAPTURE(in_double, in_float);
  CHECK(in_double <= 1e-10);
  CHECK(in_float <= 1e-5);
}

TEST_CASE("MismatchNetwork: what is multiplied out at construction agrees with layer after layer", "[network]") {
  const auto weights = golden::random_weights<double>();
  const auto network = std::make_unique<Network<double>>(*weights);
  for (const auto& window : golden::random_windows(std::vector<double>(6, 1), std::vector<double>(6, 4), 20)) {
    Eigen::Vector4d out = Eigen::Vector4d::Zero();
    REQUIRE(network->forward(window, out) == rme::Status::Ok);
    CHECK((out - layer_by_layer(*weights, window)).cwiseAbs().maxCoeff() <= 1e-12);
  }
}

TEMPLATE_TEST_CASE("MismatchNetwork: a window that is not finite is refused and the output stays", "[network]", float,
                   double) {
  const auto weights = golden::random_weights<TestType>();
  const auto network = std::make_unique<Network<TestType>>(*weights);
  using Limits = std::numeric_limits<TestType>;
  for (const TestType bad : {Limits::quiet_NaN(), Limits::infinity(), -Limits::infinity(), Limits::max()}) {
    for (const int place : {0, 57, 119}) {
      CAPTURE(bad, place);
      typename Network<TestType>::Window window = Network<TestType>::Window::Ones();
      window.data()[place] = bad;
      typename Network<TestType>::Output out = Network<TestType>::Output::Constant(7);
      CHECK(network->forward(window, out) == rme::Status::NonFiniteInput);
      CHECK(out == Network<TestType>::Output::Constant(7));
    }
  }
}

TEST_CASE("MismatchNetwork: construction names the tensor that holds a NaN", "[network]") {
  const auto weights = golden::random_weights<float>();
  SECTION("in a layer") {
    weights->mlp_2_weight[100] = std::numeric_limits<float>::quiet_NaN();
    CHECK_THROWS_WITH(std::make_unique<Network<float>>(*weights), contains("mlp.2.weight"));
  }
  SECTION("a standard deviation of zero") {
    weights->normalization_std[5] = 0;
    CHECK_THROWS_WITH(std::make_unique<Network<float>>(*weights), contains("normalization.std"));
  }
  SECTION("an infinite mean") {
    weights->normalization_mean[0] = std::numeric_limits<float>::infinity();
    CHECK_THROWS_WITH(std::make_unique<Network<float>>(*weights), contains("normalization.mean"));
  }
}

/// Another architecture: fewer samples, less of everything, a single pass of the block.
struct OtherArchitecture {
  static constexpr int kSamples = 5, kChannels = 2, kConvChannels = 4, kConvKernel = 3, kHeads = 2, kMlpHidden = 6,
                       kMlpRepeats = 1, kOutputs = 2;
};

TEST_CASE("MismatchNetwork: other sizes than the published ones work", "[network]") {
  // With zero projections the attention is uniform and the output a function of the biases alone:
  // relu(1 * 0 + 2) summed over 6 hidden units with weight 0.5, then b_2 = -1 and a head of ones over 4 channels.
  rme::MismatchNetworkWeights<double, OtherArchitecture> weights;
  weights.normalization_std.fill(1);
  weights.mlp_0_bias.fill(2);
  weights.mlp_2_weight.fill(0.5);
  weights.mlp_2_bias.fill(-1);
  weights.head_weight.fill(1);
  const rme::MismatchNetwork<double, OtherArchitecture> network(weights);
  Eigen::Vector2d out = Eigen::Vector2d::Zero();
  REQUIRE(network.forward(Eigen::Matrix<double, 5, 2>::Random(), out) == rme::Status::Ok);
  CHECK(out == Eigen::Vector2d(4 * (6 * 0.5 * 2 - 1), 4 * (6 * 0.5 * 2 - 1)));
}

TEMPLATE_TEST_CASE("MismatchNetwork: forward neither throws nor allocates", "[network]", float, double) {
  static_assert(noexcept(std::declval<const Network<TestType>&>().forward(
      std::declval<const typename Network<TestType>::Window&>(), std::declval<typename Network<TestType>::Output&>())));
#if defined(RME_COUNTS_ALLOCATIONS)
  const auto weights = golden::random_weights<TestType>();
  const int before_construction = rme::testing::allocations();
  const auto network = std::make_unique<Network<TestType>>(*weights);
  REQUIRE(rme::testing::allocations() > before_construction);  // or the counter counts nothing
  const typename Network<TestType>::Window window = Network<TestType>::Window::Ones();
  typename Network<TestType>::Output out = Network<TestType>::Output::Zero();
  const int before = rme::testing::allocations();
  const rme::Status status = network->forward(window, out);
  const int after = rme::testing::allocations();
  REQUIRE(status == rme::Status::Ok);
  CHECK(after == before);
#endif
}

}  // namespace
