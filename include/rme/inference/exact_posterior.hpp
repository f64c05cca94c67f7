#pragma once
/// The exact posterior of a payload, by quadrature over the mass.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
#include <rme/core/cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/inference_result.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/inference/payload_likelihood.hpp>

namespace rme {

/// Mean and covariance of the exact posterior, the exact evidence, and how far from Gaussian it is.
template <typename Scalar>
struct ExactPosterior : InferenceResult<Scalar> {
  Scalar skewness = Scalar(0);         ///< of the mass
  Scalar excess_kurtosis = Scalar(0);  ///< of the mass; 0 for a Gaussian
};

/// Selects the exact posterior as the solver. It has no settings.
struct ExactQuadrature {};

/// Integrates over r in closed form and over m by the trapezoidal rule, which converges geometrically for a smooth
/// density that is negligible at both ends (docs/theory.md, "The exact posterior"). A coarse pass finds the modes. It
/// covers the prior's mean +- 6 standard deviations, and goes on beyond an end where the density still rises. A
/// golden-section search refines each mode. The fine pass covers all masses whose density is above e^-20 of the highest
/// mode's.
///
/// Real time: one 3x3 eigendecomposition, at most 196 evaluations of the mass's density and 233 for each refined mode,
/// each with a logarithm and three divisions; no allocation. Usually there are three modes, one of which counts, and
/// about 300 evaluations.
/// @param likelihood   of the window
/// @param prior        over (m, r), covariance positive definite
/// @param[out] result  as it was unless the status is Ok
/// @return Ok; NonFiniteInput; NotPositiveDefinite (the prior's covariance)
template <typename Scalar>
Status exact_posterior(const PayloadLikelihood<Scalar>& likelihood, const PayloadGaussian<Scalar>& prior,
                       ExactPosterior<Scalar>& result) noexcept;

/// exact_posterior() in the form that all solvers share (inference_result.hpp), with the same status.
template <typename Scalar>
Status infer_payload(const PayloadLikelihood<Scalar>& likelihood, const PayloadGaussian<Scalar>& prior,
                     InferenceResult<Scalar>& result, const ExactQuadrature& /*config*/) noexcept {
  ExactPosterior<Scalar> exact;
  const Status status = exact_posterior(likelihood, prior, exact);
  if (status == Status::Ok) result = exact;
  return status;
}

namespace detail {

/// p(m | y) and p(r | m, y) in coordinates in which no matrix is needed for each m. Given m, the prior of r has a mean
/// that is linear in m: r = e + k m + s. With s = T z, where z ~ N(0, 1) and T^T BB T = diag(lambda)
/// (docs/theory.md (T42)),
///
///     z | m, y ~ N(u / (1 + m^2 lambda), 1 / (1 + m^2 lambda)),   u = T^T (m yB - m^2 (aB + BB (e + k m)))
template <typename Scalar>
class MassMarginal {
 public:
  struct Conditional {
    Vector3<Scalar> mean, variance;  ///< of z
    Scalar log_density;              ///< log p(y, m) - log p(y | m = 0), up to the normaliser of m's prior
  };

  /// @param com_factor  L with L L^T the prior covariance of r given m
  MassMarginal(const PayloadLikelihood<Scalar>& l, const PayloadGaussian<Scalar>& prior,
               const Matrix3<Scalar>& com_factor) noexcept
      : mass_(prior.mean[0]), mass_precision_(1 / prior.covariance(0, 0)) {
    k_ = prior.covariance.template block<3, 1>(1, 0) * mass_precision_;
    e_ = prior.mean.template tail<3>() - k_ * mass_;
    const Eigen::SelfAdjointEigenSolver<Matrix3<Scalar>> eigen(
        detail::transposed_product(com_factor, detail::product(l.BB, com_factor)));
    lambda_ = eigen.eigenvalues();
    T_ = detail::product(com_factor, eigen.eigenvectors());
    const Vector3<Scalar> BB_e = l.BB * e_, BB_k = l.BB * k_;
    // u = m (u1 + m (u2 + m u3)); the part of the exponent without z is m (c1 + m (c2 + m (c3 + m c4))).
    u1_ = T_.transpose() * l.yB;
    u2_ = -T_.transpose() * (l.aB + BB_e);
    u3_ = -T_.transpose() * BB_k;
    c1_ = l.ya + l.yB.dot(e_);
    c2_ = l.yB.dot(k_) - Scalar(0.5) * (l.aa + (2 * l.aB + BB_e).dot(e_));
    c3_ = -(l.aB + BB_e).dot(k_);
    c4_ = Scalar(-0.5) * k_.dot(BB_k);
  }

  Conditional operator()(Scalar m) const noexcept {
    using std::log;
    Conditional c;
    const Vector3<Scalar> precision = Vector3<Scalar>::Ones() + (m * m) * lambda_;
    c.variance = precision.cwiseInverse();
    const Vector3<Scalar> u = m * (u1_ + m * (u2_ + m * u3_));
    c.mean = c.variance.cwiseProduct(u);
    const Scalar d = m - mass_;
    c.log_density = m * (c1_ + m * (c2_ + m * (c3_ + m * c4_))) +
                    Scalar(0.5) * (u.dot(c.mean) - mass_precision_ * d * d - log(precision.prod()));
    return c;
  }

  Vector3<Scalar> com(Scalar m, const Vector3<Scalar>& z) const noexcept { return e_ + k_ * m + T_ * z; }
  /// Covariance of (m, r), from that of (m, z).
  Matrix4<Scalar> covariance(const Matrix4<Scalar>& of_m_z) const noexcept {
    Matrix4<Scalar> linear = Matrix4<Scalar>::Zero();
    linear(0, 0) = Scalar(1);
    linear.template block<3, 1>(1, 0) = k_;
    linear.template block<3, 3>(1, 1) = T_;
    const Matrix4<Scalar> half = detail::product(linear, of_m_z);
    return half * linear.transpose();
  }

 private:
  Scalar mass_, mass_precision_;  // of the prior
  Vector3<Scalar> e_, k_;
  Matrix3<Scalar> T_;
  Vector3<Scalar> lambda_, u1_, u2_, u3_;
  Scalar c1_, c2_, c3_, c4_;
};

}  // namespace detail

template <typename Scalar>
Status exact_posterior(const PayloadLikelihood<Scalar>& likelihood, const PayloadGaussian<Scalar>& prior,
                       ExactPosterior<Scalar>& result) noexcept {
  using std::exp;
  using std::floor;
  using std::log;
  using std::sqrt;
  if (!likelihood.all_finite() || !prior.mean.allFinite() || !prior.covariance.allFinite())
    return Status::NonFiniteInput;
  if (!(prior.covariance(0, 0) > 0)) return Status::NotPositiveDefinite;
  const Scalar prior_sd = sqrt(prior.covariance(0, 0));
  const Vector3<Scalar> row = prior.covariance.template block<3, 1>(1, 0) / prior_sd;
  const Cholesky<Scalar, 3> com_factor(prior.covariance.template block<3, 3>(1, 1) - row * row.transpose());
  if (!com_factor.positive_definite()) return Status::NotPositiveDefinite;
  const detail::MassMarginal<Scalar> marginal(likelihood, prior, com_factor.lower());
  int evaluations = 0;
  const auto at = [&](Scalar m) noexcept {
    ++evaluations;
    return marginal(m);
  };
  const auto log_density = [&at](Scalar m) noexcept { return at(m).log_density; };
  constexpr Scalar kNegligible = Scalar(20);  // e^-20 of the peak

  // Coarse pass, with a node at m = 0 if that lies within.
  constexpr std::size_t kCoarse = 64;
  const Scalar spacing = 12 * prior_sd / Scalar(kCoarse);
  Scalar first = prior.mean[0] - 6 * prior_sd;
  if (first < 0 && first + 12 * prior_sd > 0) first = spacing * floor(first / spacing);
  std::array<Scalar, kCoarse + 1> coarse;
  for (std::size_t i = 0; i <= kCoarse; ++i) coarse[i] = log_density(first + Scalar(i) * spacing);

  // Modes: each lies between the neighbours of a coarse node that exceeds both. The coarse pass does not show which
  // mode is the highest, since a sharp one falls off by many powers of e within the spacing.
  struct Peak {
    Scalar mass, log_density;
  };
  const auto sharpen = [&](Scalar lo, Scalar hi) noexcept {
    constexpr Scalar kGolden = Scalar(0.6180339887498949);
    Scalar x1 = hi - kGolden * (hi - lo), x2 = lo + kGolden * (hi - lo);
    Scalar f1 = log_density(x1), f2 = log_density(x2);
    for (int i = 0; i < 38 && hi - lo > Scalar(1e-7) * prior_sd; ++i) {
      if (f1 > f2) {
        hi = x2, x2 = x1, f2 = f1;
        x1 = hi - kGolden * (hi - lo), f1 = log_density(x1);
      } else {
        lo = x1, x1 = x2, f1 = f2;
        x2 = lo + kGolden * (hi - lo), f2 = log_density(x2);
      }
    }
    return f1 > f2 ? Peak{x1, f1} : Peak{x2, f2};
  };
  // The mode beyond an end of the coarse pass, if the data contradict the prior: strides grow until the density falls.
  const auto climb = [&](Scalar m, Scalar stride) noexcept {
    Scalar here = log_density(m);
    for (int i = 0; i < 64; ++i, stride *= Scalar(1.1)) {
      const Scalar next = log_density(m + stride);
      if (!(next > here)) break;
      m += stride;
      here = next;
    }
    return sharpen(std::min(m - stride, m + stride), std::max(m - stride, m + stride));
  };
  std::array<Peak, kCoarse + 2> modes;
  std::size_t mode_count = 0, best = 0;
  const auto add = [&](const Peak& found) noexcept {
    modes[mode_count] = found;
    if (found.log_density > modes[best].log_density) best = mode_count;
    ++mode_count;
  };
  if (coarse[0] > coarse[1]) add(climb(first, -spacing));
  for (std::size_t i = 1; i < kCoarse; ++i) {
    const Scalar node = first + Scalar(i) * spacing;
    if (std::abs(node) < Scalar(0.25) * spacing) {
      // (-m, -r) explains much of what (m, r) explains: two modes, however near they are, with a valley at m = 0.
      add(sharpen(node - spacing, node));
      add(sharpen(node, node + spacing));
    } else if (coarse[i - 1] < coarse[i] && coarse[i + 1] <= coarse[i]) {
      add(sharpen(node - spacing, node + spacing));
    }
  }
  if (coarse[kCoarse] > coarse[kCoarse - 1]) add(climb(first + Scalar(kCoarse) * spacing, spacing));
  if (mode_count == 0) return Status::NonFiniteInput;
  const auto [mode, peak] = modes[best];

  // Fine pass. Moments are about the highest mode, so that no large numbers cancel. The interval of a mode reaches in
  // growing strides to where the density is negligible. Intervals that overlap are merged; each has its own nodes.
  const auto reach = [&, highest = peak](Scalar from, Scalar direction) noexcept {
    Scalar distance = spacing * Scalar(1e-4);
    for (int i = 0; i < 32 && highest - log_density(from + direction * distance) < kNegligible; ++i)
      distance *= Scalar(1.5);
    return from + direction * distance;
  };
  const Vector3<Scalar> centre = at(mode).mean;
  Scalar p0 = 0, p1 = 0, p2 = 0, p3 = 0, p4 = 0;
  Vector3<Scalar> z1 = Vector3<Scalar>::Zero(), mz = Vector3<Scalar>::Zero();
  Matrix3<Scalar> zz = Matrix3<Scalar>::Zero();
  const auto integrate = [&, about = mode, highest = peak](Scalar from, Scalar to) noexcept {
    constexpr int kFine = 128;
    const Scalar h = (to - from) / kFine;
    for (int i = 0; i <= kFine; ++i) {
      const Scalar m = from + Scalar(i) * h;
      const auto com = at(m);
      const Scalar p = h * exp(com.log_density - highest);
      const Scalar d = m - about;
      const Vector3<Scalar> z = com.mean - centre;
      p0 += p, p1 += p * d, p2 += p * d * d, p3 += p * d * d * d, p4 += p * d * d * d * d;
      z1 += p * z;
      mz += p * d * z;
      zz += p * z * z.transpose();
      zz.diagonal() += p * com.variance;
    }
  };
  bool pending = false;
  Scalar from = Scalar(0), to = Scalar(0);
  for (std::size_t k = 0; k < mode_count; ++k) {
    if (peak - modes[k].log_density > kNegligible) continue;
    const Scalar left = reach(modes[k].mass, Scalar(-1)), right = reach(modes[k].mass, Scalar(1));
    if (pending && left > to) integrate(from, to);
    from = pending && left <= to ? std::min(from, left) : left;
    to = pending && left <= to ? std::max(to, right) : right;
    pending = true;
  }
  integrate(from, to);
  p1 /= p0, p2 /= p0, p3 /= p0, p4 /= p0, z1 /= p0, mz /= p0, zz /= p0;
  if (!std::isfinite(p2) || !z1.allFinite() || !zz.allFinite()) return Status::NonFiniteInput;
  const Scalar variance = p2 - p1 * p1;
  Matrix4<Scalar> covariance;
  covariance << variance, (mz - p1 * z1).transpose(), mz - p1 * z1, zz - z1 * z1.transpose();
  result.posterior.mean << mode + p1, marginal.com(mode + p1, centre + z1);
  result.posterior.covariance = marginal.covariance(covariance);
  const Scalar third = p3 - 3 * p1 * p2 + 2 * p1 * p1 * p1;
  const Scalar fourth = p4 - 4 * p1 * p3 + 6 * p1 * p1 * p2 - 3 * p1 * p1 * p1 * p1;
  result.skewness = third / (variance * sqrt(variance));
  result.excess_kurtosis = fourth / (variance * variance) - 3;
  constexpr Scalar kSqrt2Pi = Scalar(2.5066282746310002);
  result.log_evidence = peak + log(p0 / (kSqrt2Pi * prior_sd));
  result.iterations = evaluations;
  return Status::Ok;
}

}  // namespace rme
