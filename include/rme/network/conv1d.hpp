#pragma once
/// Convolution over time.
#include <Eigen/Core>
#include <rme/network/linear.hpp>

namespace rme {

/// Cross-correlation over time, with zero padding so that there are as many output samples as input samples
/// (torch.nn.Conv1d with padding (Kernel - 1) / 2):
///
///     y_t = b + sum_c sum_k W[:, c, k] x[t + k - (Kernel - 1) / 2, c]
///
/// It is a Linear layer on patches. Patch t has the Kernel samples around t, channel by channel: entry c * Kernel + k.
template <typename Scalar, int Samples, int In, int Out, int Kernel>
struct Conv1d {
  static_assert(Kernel % 2 == 1, "an even kernel has no middle");
  static constexpr int kPatch = In * Kernel;         ///< numbers in a patch
  using Input = Eigen::Matrix<Scalar, Samples, In>;  ///< one sample per row
  /// One patch per row, so that time is contiguous in memory, as in the input.
  using Patches = Eigen::Matrix<Scalar, Samples, kPatch>;

  Linear<Scalar, kPatch, Out> patch_layer;  ///< weight: Out x (In * Kernel), PyTorch's [Out][In][Kernel] flattened

  /// The patches of x.
  /// @param x             Samples x In, one sample per row
  /// @param[out] patches  Samples x kPatch, one patch per row
  static void unfold(const Input& x, Patches& patches) noexcept {
    constexpr int middle = (Kernel - 1) / 2;
    for (int c = 0; c < In; ++c) {
      for (int k = 0; k < Kernel; ++k) {
        for (int t = 0; t < Samples; ++t) {
          const int source = t + k - middle;
          patches(t, c * Kernel + k) = source >= 0 && source < Samples ? x(source, c) : Scalar(0);
        }
      }
    }
  }

  /// The layer's output.
  /// @param x       Samples x In, one sample per row
  /// @param[out] y  Out x Samples, one sample per column
  void forward(const Input& x, Eigen::Matrix<Scalar, Out, Samples>& y) const noexcept {
    Patches patches;
    unfold(x, patches);
    const Eigen::Matrix<Scalar, kPatch, Samples> columns = patches.transpose();
    patch_layer.forward(columns, y);
  }
};

}  // namespace rme
