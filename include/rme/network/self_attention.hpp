#pragma once
/// Multi-head self-attention.
#include <Eigen/Core>
#include <cmath>
#include <rme/network/exponential.hpp>
#include <rme/network/linear.hpp>

namespace rme {

/// Numerators of one head's softmax of q_t . k_s over the keys, scaled so that the largest of each row is 1.
/// @param queries          Samples x Size, one query per row, already scaled by 1 / sqrt(Size)
/// @param keys             Samples x Size, one key per row
/// @param[out] numerators  Samples x Samples: row t has the numerators of query t
/// @return the sum of each row, Samples x 1: the denominator of each query
template <typename Queries, typename Keys, typename Scalar, int Samples>
Eigen::Matrix<Scalar, Samples, 1> softmax_numerators(const Eigen::MatrixBase<Queries>& queries,
                                                     const Eigen::MatrixBase<Keys>& keys,
                                                     Eigen::Matrix<Scalar, Samples, Samples>& numerators) noexcept {
  // Queries are contiguous in memory, so that maximum, exponential and sum vectorise.
  numerators.noalias() = queries.lazyProduct(keys.transpose());
  const Eigen::Matrix<Scalar, Samples, 1> highest = numerators.rowwise().maxCoeff();
  numerators.colwise() -= highest;
  // Below -80, exponentials add nothing to the sum, and denormal numbers take a hundred times as long.
  numerators = numerators.cwiseMax(Scalar(-80));
  Scalar* const all = numerators.data();
  for (int i = 0; i < Samples * Samples; ++i) all[i] = softmax_exp(all[i]);
  return numerators.rowwise().sum();
}

/// Attention weights of one head: the softmax of q_t . k_s over the keys.
/// @param queries       Samples x Size, one query per row, already scaled by 1 / sqrt(Size)
/// @param keys          Samples x Size, one key per row
/// @param[out] weights  Samples x Samples: row t has the weights of query t over the samples; each row sums to 1
template <typename Queries, typename Keys, typename Scalar, int Samples>
void attention_weights(const Eigen::MatrixBase<Queries>& queries, const Eigen::MatrixBase<Keys>& keys,
                       Eigen::Matrix<Scalar, Samples, Samples>& weights) noexcept {
  const Eigen::Matrix<Scalar, Samples, 1> total = softmax_numerators(queries, keys, weights);
  weights.array().colwise() /= total.array();
}

/// Mean of attention_weights() over the queries.
/// @param queries  Samples x Size, one query per row, already scaled by 1 / sqrt(Size)
/// @param keys     Samples x Size, one key per row
/// @return the mean weight of each sample, Samples x 1; sums to 1
template <typename Scalar, int Samples, typename Queries, typename Keys>
Eigen::Matrix<Scalar, Samples, 1> mean_attention_weights(const Eigen::MatrixBase<Queries>& queries,
                                                         const Eigen::MatrixBase<Keys>& keys) noexcept {
  Eigen::Matrix<Scalar, Samples, Samples> numerators;
  const Eigen::Matrix<Scalar, Samples, 1> total = softmax_numerators(queries, keys, numerators);
  return numerators.transpose() * (Scalar(Samples) * total).cwiseInverse();
}

/// torch.nn.MultiheadAttention(Embed, Heads, batch_first=True) with query = key = value, without dropout: no residual,
/// no layer norm.
template <typename Scalar, int Samples, int Embed, int Heads>
struct SelfAttention {
  static_assert(Embed % Heads == 0, "each head takes an equal share of the embedding");
  static constexpr int kHeadSize = Embed / Heads;          ///< embedding that a head sees
  using Sequence = Eigen::Matrix<Scalar, Embed, Samples>;  ///< one sample per column

  Linear<Scalar, Embed, 3 * Embed> in_proj;  ///< queries, then keys, then values; head h is rows h * kHeadSize onwards
  Linear<Scalar, Embed, Embed> out_proj;     ///< its input is the heads' outputs, one after the other

  /// The layer's output.
  /// @param x       Embed x Samples
  /// @param[out] y  Embed x Samples
  void forward(const Sequence& x, Sequence& y) const noexcept {
    Eigen::Matrix<Scalar, 3 * Embed, Samples> projected;
    in_proj.forward(x, projected);
    const Scalar scale = Scalar(1) / std::sqrt(Scalar(kHeadSize));
    Sequence heads;
    for (int h = 0; h < Heads; ++h) {
      const auto queries = projected.template middleRows<kHeadSize>(h * kHeadSize);
      const auto keys = projected.template middleRows<kHeadSize>(Embed + h * kHeadSize);
      const auto values = projected.template middleRows<kHeadSize>(2 * Embed + h * kHeadSize);
      Eigen::Matrix<Scalar, Samples, Samples> weights;
      attention_weights(scale * queries.transpose(), keys.transpose(), weights);
      heads.template middleRows<kHeadSize>(h * kHeadSize).noalias() = values * weights.transpose();
    }
    out_proj.forward(heads, y);
  }
};

}  // namespace rme
