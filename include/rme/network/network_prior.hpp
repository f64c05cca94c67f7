#pragma once
/// The network's guess as a prior.
#include <Eigen/Core>
#include <cmath>
#include <cstddef>
#include <rme/core/cholesky.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/fixed_prior.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/network/mismatch_network.hpp>
#include <rme/sensing/pseudo_wrench.hpp>
#include <rme/sensing/sample_window.hpp>

namespace rme {

/// Settings of NetworkPrior.
template <typename Scalar>
struct NetworkPriorConfig {
  /// Standard deviations around the guess (m [kg], r_x, r_y, r_z [m]), each > 0. That of the mass is the published one:
  /// it is large, since the samples themselves determine the mass better. Those of the centre of mass are the network's
  /// usual error across gravity.
  Vector4<Scalar> standard_deviation = {Scalar(0.5), Scalar(0.02), Scalar(0.02), Scalar(0.02)};
  /// If a channel of a sample is more than this many standard deviations of the training data from their mean, the
  /// network is not used, and `unknown` is the prior; > 0.
  Scalar farthest = Scalar(4);
  FixedPrior<Scalar> unknown;                            ///< the prior where the network is not used, and along gravity
  Vector3<Scalar> gravity = standard_gravity<Scalar>();  ///< g [m/s^2], world axes
  double spacing = 0.01;          ///< between the samples that the network takes [s]: 1 to 1e5 periods
  Scalar damping = Scalar(0.01);  ///< lambda of the pseudo-wrench [m^2], > 0: must be as in training
};

/// A Gaussian around the network's output, except along gravity. That part of the centre of mass does not show at rest,
/// so the network's guess of it is the mean of its training data plus noise. There, the fixed prior is used. With d the
/// direction of gravity in end-effector axes,
///
///     r = (1 - d d^T) r_network + d d^T r_fixed, and the covariance likewise.
///
/// For a window far from the training data, the fixed prior is used instead of the network. docs/weights.md shows how
/// much the guess improves the estimates.
///
///     const auto network = std::make_unique<MismatchNetwork<float>>(model.weights);  // must outlive the prior
///     const NetworkPrior<double> prior(*network, 0.001);
///     PayloadGaussian<double> payload = prior(window, 200);  // of the newest 200 samples of a SampleWindow
///
/// @tparam NetworkScalar  of the network. Weights are learned in float: for a prior in double, a network in float is as
///                        accurate as one in double, and needs half the time and half the memory
template <typename Scalar, typename Architecture = PublishedArchitecture, typename NetworkScalar = float>
class NetworkPrior {
 public:
  using Network = MismatchNetwork<NetworkScalar, Architecture>;  ///< the network that it uses

  /// @param network  is kept by reference
  /// @param dt       control period [s], > 0
  /// @param config   settings
  /// @throws std::invalid_argument naming the field out of range
  NetworkPrior(const Network& network, double dt,
               const NetworkPriorConfig<Scalar>& config = NetworkPriorConfig<Scalar>());

  /// The network's output for the newest samples of the window.
  /// @param window    the samples
  /// @param count     number of samples since the event; the network takes the newest 20 of them that are `spacing` apart
  /// @param[out] out  theta = (m [kg], r [m]), 4x1; as it was if the result is false
  /// @return false if `count` is too small or above window.size(), if the samples are too far from the training data, or
  ///         if the network or a pseudo-wrench gives no finite result
  template <int Dofs>
  bool guess(const SampleWindow<Scalar, Dofs>& window, std::size_t count, Vector4<Scalar>& out) const noexcept;

  /// The prior of the payload in the newest `count` samples of the window: `unknown` where there is no guess().
  template <int Dofs>
  PayloadGaussian<Scalar> operator()(const SampleWindow<Scalar, Dofs>& window, std::size_t count) const noexcept;

 private:
  const Network* network_;
  NetworkPriorConfig<Scalar> config_;
  std::size_t stride_;
};

template <typename Scalar, typename Architecture, typename NetworkScalar>
NetworkPrior<Scalar, Architecture, NetworkScalar>::NetworkPrior(const Network& network, double dt,
                                                                const NetworkPriorConfig<Scalar>& config)
    : network_(&network), config_(config), stride_(1) {
  static_assert(Network::Output::RowsAtCompileTime == 4, "a prior needs m, r_x, r_y, r_z");
  for (int i = 0; i < 4; ++i) {
    detail::require_positive(config.standard_deviation[i], "NetworkPriorConfig::standard_deviation", "> 0");
  }
  detail::require(plausible(config.gravity) && config.gravity.norm() > 0, "NetworkPriorConfig::gravity",
                  "finite and not zero", config.gravity.norm());
  detail::require(config.unknown.gaussian.mean.allFinite() && config.unknown.gaussian.covariance.allFinite() &&
                      Cholesky<Scalar, 4>(config.unknown.gaussian.covariance).positive_definite(),
                  "NetworkPriorConfig::unknown", "a finite mean and a positive definite covariance, all variances > 0",
                  config.unknown.gaussian.covariance.diagonal().minCoeff());
  detail::require(config.farthest > 0, "NetworkPriorConfig::farthest", "> 0", config.farthest);
  detail::require_positive(config.damping, "NetworkPriorConfig::damping", "> 0");
  detail::require_positive(dt, "NetworkPrior::dt", "> 0 s");
  detail::require(config.spacing / dt >= 1 && config.spacing / dt < 1e5, "NetworkPriorConfig::spacing",
                  "1 to 1e5 samples", config.spacing / dt);
  stride_ = static_cast<std::size_t>(std::lround(config.spacing / dt));
}

template <typename Scalar, typename Architecture, typename NetworkScalar>
template <int Dofs>
bool NetworkPrior<Scalar, Architecture, NetworkScalar>::guess(const SampleWindow<Scalar, Dofs>& window,
                                                              std::size_t count, Vector4<Scalar>& out) const noexcept {
  using Input = typename Network::Window;
  constexpr int samples = Input::RowsAtCompileTime;
  // With fewer samples, the network's input would include samples from before the event.
  if (stride_ * samples > count || count > window.size()) return false;
  Input input;
  for (int i = 0; i < samples; ++i) {
    const Proprioception<Scalar, Dofs>& tick = window.newest(stride_ * static_cast<std::size_t>(samples - 1 - i)).raw;
    Wrench<Scalar> wrench;
    if (pseudo_wrench(tick.jacobian, tick.tau_ext, config_.damping, wrench) != Status::Ok) return false;
    if (network_->frame() == InputFrame::EndEffector) wrench = in_end_effector_axes<Scalar>(wrench, tick.rotation);
    input.row(i) = wrench.vector().transpose().template cast<NetworkScalar>();
  }
  Input normalized;
  network_->normalization().forward(input, normalized);
  typename Network::Output said;
  if (!(normalized.cwiseAbs().maxCoeff() <= NetworkScalar(config_.farthest)) ||
      network_->forward(input, said) != Status::Ok)
    return false;
  out = said.template cast<Scalar>();
  return true;
}

template <typename Scalar, typename Architecture, typename NetworkScalar>
template <int Dofs>
PayloadGaussian<Scalar> NetworkPrior<Scalar, Architecture, NetworkScalar>::operator()(
    const SampleWindow<Scalar, Dofs>& window, std::size_t count) const noexcept {
  PayloadGaussian<Scalar> fixed = config_.unknown(window, count);
  Vector4<Scalar> mean;
  if (!guess(window, count, mean)) return fixed;
  auto prior = PayloadGaussian<Scalar>::independent(mean, config_.standard_deviation);
  const Vector3<Scalar> down = window.newest().raw.rotation.transpose() * config_.gravity.normalized();
  const Matrix3<Scalar> along = down * down.transpose();
  const Matrix3<Scalar> across = Matrix3<Scalar>::Identity() - along;
  prior.mean.template tail<3>() = across * mean.template tail<3>() + along * fixed.mean.template tail<3>();
  const Matrix3<Scalar> spread = prior.covariance.template bottomRightCorner<3, 3>();
  prior.covariance.template bottomRightCorner<3, 3>() =
      across * spread * across + along * fixed.covariance.template bottomRightCorner<3, 3>() * along;
  return prior;
}

}  // namespace rme
