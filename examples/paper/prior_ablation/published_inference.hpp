#pragma once
/// The paper's likelihood: white noise of a width taken from the window itself, nothing else.
#include <algorithm>
#include <cstddef>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/inference/payload_likelihood.hpp>
#include <rme/inference/payload_regressor.hpp>
#include <rme/inference/variational_inference.hpp>
#include <rme/sensing/sample_window.hpp>

namespace rme::examples {

/// tau_ext,t ~ N(J_t^T w_t(theta), diag(sigma_j^2)) over 50 of the newest `count` samples, uniformly spaced, with
/// sigma_j = max(0.25 (max_t - min_t), 0.1 N m); gravity alone, neither observer, motion, friction nor offset.
template <int Dofs>
PayloadLikelihood<double> published_likelihood(const SampleWindow<double, Dofs>& window, std::size_t count) noexcept {
  constexpr std::size_t samples = 50;
  const auto sample = [&](std::size_t i) -> const Proprioception<double, Dofs>& {
    return window.newest(i * count / samples).raw;
  };
  JointVector<double, Dofs> least = sample(0).tau_ext, most = least;
  for (std::size_t i = 1; i < samples; ++i) {
    least = least.cwiseMin(sample(i).tau_ext);
    most = most.cwiseMax(sample(i).tau_ext);
  }
  const JointVector<double, Dofs> precision = (0.25 * (most - least)).cwiseMax(0.1).cwiseAbs2().cwiseInverse();
  PayloadLikelihood<double> sums;
  for (std::size_t i = 0; i < samples; ++i) {
    const auto& [tau, jacobian, rotation, dq] = sample(i);
    const auto regressor = payload_regressor<double, Dofs>(jacobian, rotation, standard_gravity<double>());
    const auto& a = regressor.a;
    const auto& B = regressor.B;
    const JointVector<double, Dofs> y_W = precision.cwiseProduct(tau), a_W = precision.cwiseProduct(a);
    sums.yy += y_W.dot(tau);
    sums.ya += y_W.dot(a);
    sums.aa += a_W.dot(a);
    sums.yB += B.transpose() * y_W;
    sums.aB += B.transpose() * a_W;
    sums.BB += B.transpose() * precision.asDiagonal() * B;
  }
  return sums;
}

}  // namespace rme::examples
