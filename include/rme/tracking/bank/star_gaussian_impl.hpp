#pragma once
/// Mixtures of StarGaussian.
#include <array>
#include <cstddef>
#include <rme/tracking/bank/star_gaussian.hpp>

namespace rme::bank {

/// The star with the moments of a mixture of stars.
template <typename Scalar, int Dofs>
template <std::size_t Count>
StarGaussian<Scalar, Dofs> StarGaussian<Scalar, Dofs>::mix(const std::array<const StarGaussian*, Count>& parts,
                                                           const std::array<Scalar, Count>& weights) noexcept {
  StarGaussian out;
  std::array<PhiMatrix, Count> P;
  PhiMatrix total = PhiMatrix::Zero();
  for (std::size_t i = 0; i < Count; ++i)
    if (weights[i] > 0) detail::add_scaled(out.mean_, weights[i], parts[i]->mean_);
  for (std::size_t i = 0; i < Count; ++i) {
    if (!(weights[i] > 0)) continue;
    const Phi d = detail::difference(parts[i]->mean_, out.mean_);
    P[i] = parts[i]->covariance();
    detail::add_scaled(total, weights[i], P[i]);
    detail::add_outer(total, detail::scaled(weights[i], d), d);
  }
  if (!factorise(total, out.factor_)) return out;
  const PhiMatrix inverse = inverted(out.factor_);
  out.empty_ = false;
  for (int j = 0; j < Dofs; ++j) {
    Beta mean = Beta::Zero();
    for (std::size_t i = 0; i < Count; ++i)
      if (weights[i] > 0) detail::add_scaled(mean, weights[i], parts[i]->nuisance_mean(j));
    Slope cross = Slope::Zero();
    BetaMatrix V = BetaMatrix::Zero();
    for (std::size_t i = 0; i < Count; ++i) {
      if (!(weights[i] > 0)) continue;
      const Joint& part = parts[i]->joint(j);
      const Beta d = detail::difference(parts[i]->nuisance_mean(j), mean);
      const Beta weighted = detail::scaled(weights[i], d);
      detail::add_outer(cross, detail::difference(parts[i]->mean_, out.mean_), weighted);
      detail::add_scaled(V, weights[i], part.covariance);
      detail::add_outer(V, weighted, d);
      if (parts[i]->empty_) continue;
      const Slope own = detail::product(P[i], part.slope);
      detail::add_scaled(cross, weights[i], own);
      detail::add_scaled(V, weights[i], detail::transposed_product(part.slope, own));
    }
    out.joint(j) = given_payload(inverse, out.mean_, mean, cross, V);
  }
  return out;
}

/// The same for the nuisances alone: phi is 0 in the result.
template <typename Scalar, int Dofs>
template <std::size_t Count>
StarGaussian<Scalar, Dofs> StarGaussian<Scalar, Dofs>::mix_emptied(const std::array<const StarGaussian*, Count>& parts,
                                                                   const std::array<Scalar, Count>& weights) noexcept {
  StarGaussian out;
  for (int j = 0; j < Dofs; ++j) {
    std::array<Beta, Count> mean;
    Joint& joint = out.joint(j);
    for (std::size_t i = 0; i < Count; ++i) {
      if (!(weights[i] > 0)) continue;
      mean[i] = parts[i]->nuisance_mean(j);
      detail::add_scaled(joint.mean, weights[i], mean[i]);
    }
    for (std::size_t i = 0; i < Count; ++i) {
      if (!(weights[i] > 0)) continue;
      const Beta d = detail::difference(mean[i], joint.mean);
      detail::add_scaled(joint.covariance, weights[i], parts[i]->nuisance_covariance(j));
      detail::add_outer(joint.covariance, detail::scaled(weights[i], d), d);
    }
  }
  return out;
}

}  // namespace rme::bank
