#pragma once
/// Fully connected layer.
#include <Eigen/Core>
#include <rme/core/small_matrix.hpp>

namespace rme {

/// y = W x + b (torch.nn.Linear), for one input or for several side by side.
template <typename Scalar, int In, int Out>
struct Linear {
  Eigen::Matrix<Scalar, Out, In> weight = Eigen::Matrix<Scalar, Out, In>::Zero();  ///< W, as in PyTorch
  Eigen::Matrix<Scalar, Out, 1> bias = Eigen::Matrix<Scalar, Out, 1>::Zero();      ///< b

  /// The layer's output.
  /// @param x       In x Columns, one input per column
  /// @param[out] y  Out x Columns; must not alias x
  template <int Columns>
  void forward(const Eigen::Matrix<Scalar, In, Columns>& x, Eigen::Matrix<Scalar, Out, Columns>& y) const noexcept {
    y.noalias() = weight * x;
    y.colwise() += bias;
  }
};

/// The layer that equals `inner` followed by `outer`: W = W_o W_i, b = W_o b_i + b_o.
template <typename Scalar, int In, int Between, int Out>
Linear<Scalar, In, Out> compose_layers(const Linear<Scalar, Between, Out>& outer,
                                       const Linear<Scalar, In, Between>& inner) {
  Linear<Scalar, In, Out> both;
  both.weight = detail::product(outer.weight, inner.weight);
  both.bias = detail::product(outer.weight, inner.bias) + outer.bias;
  return both;
}

}  // namespace rme
