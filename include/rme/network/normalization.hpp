#pragma once
/// Input normalisation, per channel.
#include <Eigen/Core>

namespace rme {

/// (x - mean) / std in each channel, with the mean and standard deviation of the training data.
template <typename Scalar, int Channels>
struct Normalization {
  /// Channels x 1 [N, N m].
  Eigen::Matrix<Scalar, Channels, 1> mean = Eigen::Matrix<Scalar, Channels, 1>::Zero();
  Eigen::Matrix<Scalar, Channels, 1> std = Eigen::Matrix<Scalar, Channels, 1>::Ones();  ///< the same, > 0

  /// The normalised window.
  /// @param window  Samples x Channels, one sample per row
  /// @param[out] y  Samples x Channels
  template <int Samples>
  void forward(const Eigen::Matrix<Scalar, Samples, Channels>& window,
               Eigen::Matrix<Scalar, Samples, Channels>& y) const noexcept {
    y = (window.rowwise() - mean.transpose()).array().rowwise() / std.transpose().array();
  }
};

}  // namespace rme
