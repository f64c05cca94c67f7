#pragma once
/// Takes the place of a network, and always gives the same guess.
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/network/architecture.hpp>
#include <rme/network/weights.hpp>

namespace rme {

/// A network whose output does not depend on the window. With theta = 0 it gives the paper's ablation (Appendix D,
/// Figure 10): mu_prior = 0 in place of mu_prior = f_nn.
template <typename Scalar>
struct FixedGuess {
  /// As MismatchNetwork::Window.
  using Window = Eigen::Matrix<Scalar, PublishedArchitecture::kSamples, PublishedArchitecture::kChannels>;
  using Output = Vector4<Scalar>;  ///< theta

  Output theta = Output::Zero();  ///< (m [kg], r_x, r_y, r_z [m]), end-effector axes, finite

  InputFrame frame() const noexcept { return InputFrame::World; }  ///< has no effect: the window is ignored
  /// Writes theta.
  /// @return Ok
  Status forward(const Window& /*window*/, Output& out) const noexcept {
    out = theta;
    return Status::Ok;
  }
};

}  // namespace rme
