#pragma once
/// The network's guess as the estimator's prior.
#include <cmath>
#include <cstddef>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/inference/fixed_prior.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/network/mismatch_network.hpp>
#include <rme/sensing/pseudo_wrench.hpp>
#include <rme/sensing/sample_window.hpp>

namespace rme {

/// Settings of NetworkPrior.
template <typename Scalar>
struct NetworkPriorConfig {
  /// Standard deviations around the guess (m [kg], r_x, r_y, r_z [m]), each > 0. The published mass, since the window
  /// itself settles that; the centre of mass by how far the network is usually off.
  Vector4<Scalar> standard_deviation = {Scalar(0.5), Scalar(0.03), Scalar(0.03), Scalar(0.05)};
  /// A window with a sample further than this many standard deviations of the training data from their mean is none
  /// that the network has learned from, and `unknown` is the prior; > 0.
  Scalar farthest = Scalar(4);
  FixedPrior<Scalar> unknown;     ///< the prior where the network cannot be asked
  double spacing = 0.01;          ///< between the samples that the network sees [s], > 0
  Scalar damping = Scalar(0.01);  ///< lambda of the pseudo-wrench, as in training, > 0; the published one by default
};

/// A prior source for Estimator: a Gaussian centred on the network's output. A payload far outside the training
/// distribution is not dragged back into it: its window is recognised as foreign, and the wide fixed prior used
/// instead.
///
///     const auto network = std::make_unique<MismatchNetwork<double>>(model.weights);  // must outlive the estimator
///     Estimator<double, 7, NetworkPrior<double>> estimator(0.001, {}, NetworkPrior<double>(*network, 0.001));
template <typename Scalar, typename Architecture = PublishedArchitecture>
class NetworkPrior {
 public:
  using Network = MismatchNetwork<Scalar, Architecture>;

  /// @param network  is kept by reference
  /// @param dt       control period [s], > 0
  /// @throws std::invalid_argument naming the field out of range
  NetworkPrior(const Network& network, double dt,
               const NetworkPriorConfig<Scalar>& config = NetworkPriorConfig<Scalar>());

  /// The prior of an event whose newest `count` samples were collected.
  template <int Dofs>
  PayloadGaussian<Scalar> operator()(const SampleWindow<Scalar, Dofs>& window, std::size_t count) const noexcept;

 private:
  const Network* network_;
  NetworkPriorConfig<Scalar> config_;
  std::size_t stride_;
};

template <typename Scalar, typename Architecture>
NetworkPrior<Scalar, Architecture>::NetworkPrior(const Network& network, double dt,
                                                 const NetworkPriorConfig<Scalar>& config)
    : network_(&network), config_(config), stride_(1) {
  static_assert(Network::Output::RowsAtCompileTime == 4, "a prior needs m, r_x, r_y, r_z");
  for (int i = 0; i < 4; ++i) {
    detail::require(config.standard_deviation[i] > 0, "NetworkPriorConfig::standard_deviation", "> 0",
                    config.standard_deviation[i]);
  }
  detail::require(config.farthest > 0, "NetworkPriorConfig::farthest", "> 0", config.farthest);
  detail::require(config.damping > 0, "NetworkPriorConfig::damping", "> 0", config.damping);
  detail::require(dt > 0 && std::isfinite(dt), "NetworkPrior::dt", "> 0 s", dt);
  detail::require(config.spacing / dt >= 1 && config.spacing / dt < 1e5, "NetworkPriorConfig::spacing",
                  "1 to 1e5 samples", config.spacing / dt);
  stride_ = static_cast<std::size_t>(std::lround(config.spacing / dt));
}

template <typename Scalar, typename Architecture>
template <int Dofs>
PayloadGaussian<Scalar> NetworkPrior<Scalar, Architecture>::operator()(const SampleWindow<Scalar, Dofs>& window,
                                                                       std::size_t count) const noexcept {
  using Input = typename Network::Window;
  constexpr int samples = Input::RowsAtCompileTime;
  const PayloadGaussian<Scalar> unknown = config_.unknown(window, count);
  // A shorter collection would show the network what was before the event.
  if (stride_ * samples > count) return unknown;
  Input input;
  for (int i = 0; i < samples; ++i) {
    const Proprioception<Scalar, Dofs>& tick = window.newest(stride_ * static_cast<std::size_t>(samples - 1 - i)).raw;
    Wrench<Scalar> wrench;
    if (pseudo_wrench<Scalar, Dofs>(tick.jacobian, tick.tau_ext, config_.damping, wrench) != Status::Ok) return unknown;
    if (network_->frame() == InputFrame::EndEffector) wrench = in_end_effector_axes<Scalar>(wrench, tick.rotation);
    input.row(i) = wrench.vector().transpose();
  }
  Input normalized;
  network_->normalization().forward(input, normalized);
  if (!(normalized.cwiseAbs().maxCoeff() <= config_.farthest)) return unknown;
  typename Network::Output guess;
  if (network_->forward(input, guess) != Status::Ok) return unknown;
  return PayloadGaussian<Scalar>::independent(guess, config_.standard_deviation);
}

}  // namespace rme
