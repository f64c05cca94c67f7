#pragma once
/// A network's weights as plain arrays, in PyTorch's layout.
#include <array>
#include <cstddef>
#include <cstdint>
#include <rme/network/architecture.hpp>

namespace rme {

/// The axes in which a network expects its pseudo-wrenches.
enum class InputFrame : std::uint8_t {
  World,        ///< as in the paper; such a network works only in the poses that it was trained in
  EndEffector,  ///< diag(R^T, R^T) W: the input shows gravity's direction, so that one network serves every pose
};

/// The weights of a MismatchNetwork: an aggregate of row-major arrays under PyTorch's names (dots become underscores).
/// In a program without files or JSON it can be a constant, which examples/training/weights_to_header writes. Its size
/// is 213 KB in float, 426 KB in double.
template <typename Scalar, typename Architecture = PublishedArchitecture>
struct MismatchNetworkWeights {
  using A = Architecture;  ///< the architecture's sizes
  static_assert(A::kConvKernel % 2 == 1 && A::kConvChannels % A::kHeads == 0 && A::kMlpRepeats >= 1);
  /// A row-major array of this shape.
  template <int... Sizes>
  using Array = std::array<Scalar, static_cast<std::size_t>((Sizes * ...))>;

  InputFrame frame = InputFrame::World;                                        ///< axes of the window's pseudo-wrenches
  Array<A::kChannels> normalization_mean{};                                    ///< force [N], moment [N m]
  Array<A::kChannels> normalization_std{};                                     ///< > 0
  Array<A::kConvChannels, A::kChannels, A::kConvKernel> convolution_weight{};  ///< PyTorch's shapes, here and below
  Array<A::kConvChannels> convolution_bias{};                                  ///< per channel
  Array<A::kSamples, A::kConvChannels> positional_embedding{};                 ///< added after the convolution
  Array<3, A::kConvChannels, A::kConvChannels> attention_in_proj_weight{};     ///< queries, keys, values
  Array<3, A::kConvChannels> attention_in_proj_bias{};                         ///< in that order
  Array<A::kConvChannels, A::kConvChannels> attention_out_proj_weight{};       ///< after the heads
  Array<A::kConvChannels> attention_out_proj_bias{};                           ///< per channel
  Array<A::kMlpHidden, A::kConvChannels> mlp_0_weight{};                       ///< first layer of the block
  Array<A::kMlpHidden> mlp_0_bias{};                                           ///< per hidden unit
  Array<A::kConvChannels, A::kMlpHidden> mlp_2_weight{};                       ///< second layer
  Array<A::kConvChannels> mlp_2_bias{};                                        ///< per channel
  Array<A::kOutputs, A::kConvChannels> head_weight{};                          ///< to theta
  Array<A::kOutputs> head_bias{};                                              ///< [kg], then [m]
};

/// Calls visit(name, shape, array) for each learned tensor, in the order of the members. name is PyTorch's; shape is a
/// std::array of one to three ints; array is row-major.
template <typename Weights, typename Visitor>
void for_each_tensor(Weights& w, Visitor&& visit) {
  using A = typename Weights::A;
  constexpr int C = A::kConvChannels;
  visit("convolution.weight", std::array{C, A::kChannels, A::kConvKernel}, w.convolution_weight);
  visit("convolution.bias", std::array{C}, w.convolution_bias);
  visit("positional_embedding", std::array{A::kSamples, C}, w.positional_embedding);
  visit("attention.in_proj_weight", std::array{3 * C, C}, w.attention_in_proj_weight);
  visit("attention.in_proj_bias", std::array{3 * C}, w.attention_in_proj_bias);
  visit("attention.out_proj.weight", std::array{C, C}, w.attention_out_proj_weight);
  visit("attention.out_proj.bias", std::array{C}, w.attention_out_proj_bias);
  visit("mlp.0.weight", std::array{A::kMlpHidden, C}, w.mlp_0_weight);
  visit("mlp.0.bias", std::array{A::kMlpHidden}, w.mlp_0_bias);
  visit("mlp.2.weight", std::array{C, A::kMlpHidden}, w.mlp_2_weight);
  visit("mlp.2.bias", std::array{C}, w.mlp_2_bias);
  visit("head.weight", std::array{A::kOutputs, C}, w.head_weight);
  visit("head.bias", std::array{A::kOutputs}, w.head_bias);
}

/// Number of learned parameters of an architecture; the normalisation is not learned.
template <typename Architecture>
constexpr int parameter_count() {
  using A = Architecture;
  constexpr int C = A::kConvChannels;
  constexpr int H = A::kMlpHidden;
  return (C * A::kChannels * A::kConvKernel + C) + A::kSamples * C + 4 * (C * C + C) + (H * C + H) + (C * H + C) +
         (A::kOutputs * C + A::kOutputs);
}
static_assert(parameter_count<PublishedArchitecture>() == 53252, "Table 4 of the paper");

}  // namespace rme
