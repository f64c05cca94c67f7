#pragma once
/// The MLP block and its repetition.
#include <Eigen/Core>
#include <rme/network/linear.hpp>

namespace rme {

/// x <- W_2 relu(W_1 x + b_1) + b_2, `Repeats` times with the same weights, and nothing between the repeats.
template <typename Scalar, int Width, int Hidden, int Repeats>
struct SharedMlp {
  static_assert(Repeats >= 1, "SharedMlp: at least one repeat");
  Linear<Scalar, Width, Hidden> expand;    ///< W_1, b_1: mlp.0
  Linear<Scalar, Hidden, Width> contract;  ///< W_2, b_2: mlp.2

  /// Applies the block.
  /// @param[in,out] x  Width x 1
  void forward(Eigen::Matrix<Scalar, Width, 1>& x) const noexcept {
    Eigen::Matrix<Scalar, Hidden, 1> hidden;
    for (int repeat = 0; repeat < Repeats; ++repeat) {
      expand.forward(x, hidden);
      hidden = hidden.cwiseMax(Scalar(0));
      contract.forward(hidden, x);
    }
  }
};

}  // namespace rme
