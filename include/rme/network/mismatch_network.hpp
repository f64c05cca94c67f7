#pragma once
/// The network that guesses a payload from 200 ms of pseudo-wrenches.
#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <rme/core/require.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/status.hpp>
#include <rme/network/conv1d.hpp>
#include <rme/network/linear.hpp>
#include <rme/network/normalization.hpp>
#include <rme/network/self_attention.hpp>
#include <rme/network/weights.hpp>

namespace rme {

/// Its layers are: normalisation, convolution over time, positional embedding, self-attention, mean over time, the
/// shared MLP block, head (docs/weights.md has the formulas).
///
/// Consecutive linear layers are merged at construction, in double:
///  - convolution, positional embedding and projection to queries and keys become one layer on patches of the input;
///  - the mean over time is taken of the attention weights instead of the outputs, so that each head computes its
///    values only for one weighted mean of the samples;
///  - the MLP's last layer becomes part of the head.
/// The output projection is not merged with the MLP's first layer: that would save a fortieth of the arithmetic, but
/// make the weights a quarter larger.
///
/// Real time: forward() allocates nothing, throws nothing and always does the same arithmetic. The object holds
/// everything by value, 190 KB in float and 380 KB in double: do not put it on a small stack.
template <typename Scalar, typename Architecture = PublishedArchitecture>
class MismatchNetwork {
  using A = Architecture;

 public:
  using Weights = MismatchNetworkWeights<Scalar, Architecture>;  ///< what it is constructed from
  /// Pseudo-wrenches, one sample per row, oldest first: force [N] x3, moment [N m] x3, in the axes of frame().
  using Window = Eigen::Matrix<Scalar, A::kSamples, A::kChannels>;
  using Output = Eigen::Matrix<Scalar, A::kOutputs, 1>;  ///< theta = (m [kg], r_x, r_y, r_z [m])

  /// @param weights  are copied
  /// @throws std::invalid_argument naming the tensor if a number is not finite or a standard deviation is not > 0
  explicit MismatchNetwork(const Weights& weights);

  /// The network's output for a window.
  /// @param window    20 x 6 with the published architecture
  /// @param[out] out  theta, 4 x 1; as it was unless the status is Ok
  /// @return Ok; NonFiniteInput, also for numbers so large that the result overflows
  Status forward(const Window& window, Output& out) const noexcept;

  InputFrame frame() const noexcept { return frame_; }  ///< axes of the window's pseudo-wrenches
  /// The normalisation that forward() applies to the window first.
  const Normalization<Scalar, A::kChannels>& normalization() const noexcept { return normalization_; }

 private:
  static constexpr int kEmbed = A::kConvChannels;
  static constexpr int kHeadSize = kEmbed / A::kHeads;
  using Convolution = Conv1d<Scalar, A::kSamples, A::kChannels, kEmbed, A::kConvKernel>;
  static constexpr int kPatch = Convolution::kPatch;
  template <int Rows, int Columns>
  using Matrix = Eigen::Matrix<Scalar, Rows, Columns>;

  InputFrame frame_;
  Normalization<Scalar, A::kChannels> normalization_;
  Matrix<kPatch, 2 * kEmbed> query_key_weight_;         // queries and keys = patches * this + query_key_position_
  Matrix<A::kSamples, 2 * kEmbed> query_key_position_;  // the bias, different for each sample
  Matrix<kEmbed, kPatch> value_weight_;                 // multiplies the weighted mean patch of each head
  Matrix<kEmbed, A::kSamples> value_position_;          // multiplies the attention weights: the position's share
  Linear<Scalar, kEmbed, kEmbed> project_;              // output projection
  Linear<Scalar, kEmbed, A::kMlpHidden> expand_;        // mlp.0
  Linear<Scalar, A::kMlpHidden, kEmbed> contract_;      // mlp.2
  Linear<Scalar, A::kMlpHidden, A::kOutputs> last_;     // mlp.2 and head
};

namespace detail {

/// A weight as a double matrix; `array` is row-major.
template <int Rows, int Columns, typename Array>
Eigen::Matrix<double, Rows, Columns> as_matrix(const Array& array) {
  static_assert(std::tuple_size_v<Array> == Rows * Columns);
  Eigen::Matrix<double, Rows, Columns> out;
  for (int i = 0; i < Rows; ++i)
    for (int j = 0; j < Columns; ++j) out(i, j) = static_cast<double>(array[static_cast<std::size_t>(i * Columns + j)]);
  return out;
}

template <int In, int Out, typename Weight, typename Bias>
Linear<double, In, Out> as_linear(const Weight& weight, const Bias& bias) {
  return {as_matrix<Out, In>(weight), as_matrix<Out, 1>(bias)};
}

/// A matrix in another precision.
template <typename Scalar, int Rows, int Columns>
Eigen::Matrix<Scalar, Rows, Columns> cast(const Eigen::Matrix<double, Rows, Columns>& matrix) {
  return matrix.template cast<Scalar>();
}

template <typename Scalar, int In, int Out>
Linear<Scalar, In, Out> cast(const Linear<double, In, Out>& layer) {
  return {cast<Scalar>(layer.weight), cast<Scalar>(layer.bias)};
}

/// Refuses weights unless every number is finite and every standard deviation is positive.
template <typename Weights>
void require_usable(const Weights& weights) {
  const auto check = [](const char* name, const auto& array) {
    for (const auto value : array) require(std::isfinite(value), name, "finite numbers", value);
  };
  check("normalization.mean", weights.normalization_mean);
  check("normalization.std", weights.normalization_std);
  for (const auto value : weights.normalization_std) require(value > 0, "normalization.std", "> 0", value);
  for_each_tensor(weights, [&](const char* name, auto, const auto& array) { check(name, array); });
}

}  // namespace detail

template <typename Scalar, typename Architecture>
MismatchNetwork<Scalar, Architecture>::MismatchNetwork(const Weights& w) : frame_(w.frame) {
  using detail::as_linear;
  using detail::as_matrix;
  using detail::cast;
  detail::require_usable(w);
  normalization_.mean = cast<Scalar>(as_matrix<A::kChannels, 1>(w.normalization_mean));
  normalization_.std = cast<Scalar>(as_matrix<A::kChannels, 1>(w.normalization_std));

  const auto convolution = as_linear<kPatch, kEmbed>(w.convolution_weight, w.convolution_bias);
  const auto in_proj = as_linear<kEmbed, 3 * kEmbed>(w.attention_in_proj_weight, w.attention_in_proj_bias);
  // Before the projection, sample t is W_conv patch_t + position_t.
  const auto embedding = as_matrix<A::kSamples, kEmbed>(w.positional_embedding);
  Eigen::Matrix<double, kEmbed, A::kSamples> position;
  for (int t = 0; t < A::kSamples; ++t)
    for (int i = 0; i < kEmbed; ++i) position(i, t) = embedding(t, i) + convolution.bias[i];
  const auto projected_weight = detail::product(in_proj.weight, convolution.weight);
  const auto projected_position = detail::product(in_proj.weight, position);
  // Rows of in_proj: queries, keys, values. Queries are scaled by 1 / sqrt(head size).
  const double scale = 1 / std::sqrt(double(kHeadSize));
  for (int i = 0; i < 2 * kEmbed; ++i) {
    const double factor = i < kEmbed ? scale : 1;
    for (int k = 0; k < kPatch; ++k) query_key_weight_(k, i) = Scalar(factor * projected_weight(i, k));
    for (int t = 0; t < A::kSamples; ++t)
      query_key_position_(t, i) = Scalar(factor * (projected_position(i, t) + in_proj.bias[i]));
  }
  // The attention weights of a query sum to 1, so that the values' bias may be added before they are applied.
  for (int i = 0; i < kEmbed; ++i) {
    const int row = 2 * kEmbed + i;
    for (int k = 0; k < kPatch; ++k) value_weight_(i, k) = Scalar(projected_weight(row, k));
    for (int t = 0; t < A::kSamples; ++t)
      value_position_(i, t) = Scalar(projected_position(row, t) + in_proj.bias[row]);
  }

  const auto out_proj = as_linear<kEmbed, kEmbed>(w.attention_out_proj_weight, w.attention_out_proj_bias);
  const auto expand = as_linear<kEmbed, A::kMlpHidden>(w.mlp_0_weight, w.mlp_0_bias);
  const auto contract = as_linear<A::kMlpHidden, kEmbed>(w.mlp_2_weight, w.mlp_2_bias);
  const auto head = as_linear<kEmbed, A::kOutputs>(w.head_weight, w.head_bias);
  project_ = cast<Scalar>(out_proj);
  expand_ = cast<Scalar>(expand);
  contract_ = cast<Scalar>(contract);
  last_ = cast<Scalar>(compose_layers(head, contract));
}

template <typename Scalar, typename Architecture>
Status MismatchNetwork<Scalar, Architecture>::forward(const Window& window, Output& out) const noexcept {
  if (!window.allFinite()) return Status::NonFiniteInput;
  Window normalized;
  normalization_.forward(window, normalized);
  typename Convolution::Patches patches;
  Convolution::unfold(normalized, patches);

  Matrix<A::kSamples, 2 * kEmbed> query_key = detail::product(patches, query_key_weight_);
  query_key += query_key_position_;
  Matrix<kEmbed, 1> pooled;  // mean of the heads' outputs over time
  for (int h = 0; h < A::kHeads; ++h) {
    const int row = h * kHeadSize;
    const Matrix<A::kSamples, 1> mean_weights = mean_attention_weights<Scalar, A::kSamples>(
        query_key.template middleCols<kHeadSize>(row), query_key.template middleCols<kHeadSize>(kEmbed + row));
    const Matrix<kPatch, 1> mean_patch = detail::transposed_product(patches, mean_weights);
    pooled.template segment<kHeadSize>(row).noalias() =
        value_weight_.template middleRows<kHeadSize>(row) * mean_patch +
        value_position_.template middleRows<kHeadSize>(row) * mean_weights;
  }

  Matrix<kEmbed, 1> x;
  Matrix<A::kMlpHidden, 1> hidden;
  project_.forward(pooled, x);
  for (int repeat = 0; repeat < A::kMlpRepeats; ++repeat) {
    if (repeat > 0) contract_.forward(hidden, x);
    expand_.forward(x, hidden);
    hidden = hidden.cwiseMax(Scalar(0));
  }
  Output result;
  last_.forward(hidden, result);
  if (!result.allFinite()) return Status::NonFiniteInput;
  out = result;
  return Status::Ok;
}

}  // namespace rme
