#pragma once
/// The prior that needs no training.
#include <cstddef>
#include <rme/inference/payload_gaussian.hpp>

namespace rme {

/// Mean and standard deviation: 0.8 +- 0.6 kg, the centre of mass 10 +- 6 cm in front of the flange and 0 +- 5 cm from
/// its axis. It is called in the same way as NetworkPrior.
template <typename Scalar>
struct FixedPrior {
  /// The prior, for every window.
  PayloadGaussian<Scalar> gaussian = PayloadGaussian<Scalar>::independent(
      {Scalar(0.8), Scalar(0), Scalar(0), Scalar(0.1)}, {Scalar(0.6), Scalar(0.05), Scalar(0.05), Scalar(0.06)});

  /// `gaussian`, whatever the window.
  template <typename Window>
  PayloadGaussian<Scalar> operator()(const Window& /*window*/, std::size_t /*count*/) const noexcept {
    return gaussian;
  }
};

}  // namespace rme
