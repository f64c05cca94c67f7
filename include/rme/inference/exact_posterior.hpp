#pragma once
/// The exact posterior of a payload, by quadrature over the mass.
#include <Eigen/Cholesky>
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <array>
#include <cmath>
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

/// Chooses the exact posterior. There is nothing to set.
struct ExactQuadrature {};

/// Integrates over r in closed form and over m by the trapezoidal rule, which converges geometrically for a smooth
/// density that has died out at both ends (docs/theory.md, "The exact posterior"). A coarse pass over the prior's mean
/// +- 6 standard deviations finds the mode, a golden-section search sharpens it, and the fine pass covers whatever lies
/// within e^-20 of it. Real time: one 3x3 eigendecomposition and at most 65 + 40 + 64 + 130 evaluations of the mass's
/// density, each with a logarithm and three divisions; no allocation.
/// @param[out] result  as it was unless the status is Ok
/// @return Ok; NonFiniteInput; NotPositiveDefinite (the prior's covariance)
template <typename Scalar>
Status exact_posterior(const PayloadLikelihood<Scalar>& likelihood, const PayloadGaussian<Scalar>& prior,
                       ExactPosterior<Scalar>& result) noexcept;

/// The same in the form that all solvers share.
template <typename Scalar>
Status infer(const PayloadLikelihood<Scalar>& likelihood, const PayloadGaussian<Scalar>& prior,
             InferenceResult<Scalar>& result, const ExactQuadrature& /*config*/) noexcept {
  ExactPosterior<Scalar> exact;
  const Status status = exact_posterior(likelihood, prior, exact);
  if (status == Status::Ok) result = exact;
  return status;
}

namespace detail {

/// p(m | y) and p(r | m, y) in coordinates in which they cost no matrices. Given m, the prior of r has a mean that is
/// linear in m: r = e + k m + s. With s = T z, where z ~ N(0, 1) and T^T BB T = diag(lambda),
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
    const Eigen::SelfAdjointEigenSolver<Matrix3<Scalar>> eigen(com_factor.transpose() * l.BB * com_factor);
    lambda_ = eigen.eigenvalues();
    T_ = com_factor * eigen.eigenvectors();
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
    return linear * of_m_z * linear.transpose();
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
  using std::log;
  using std::sqrt;
  if (!likelihood.all_finite() || !prior.mean.allFinite() || !prior.covariance.allFinite())
    return Status::NonFiniteInput;
  if (!(prior.covariance(0, 0) > 0)) return Status::NotPositiveDefinite;
  const Scalar prior_sd = sqrt(prior.covariance(0, 0));
  const Vector3<Scalar> row = prior.covariance.template block<3, 1>(1, 0) / prior_sd;
  const Eigen::LLT<Matrix3<Scalar>> com_llt(prior.covariance.template block<3, 3>(1, 1) - row * row.transpose());
  if (com_llt.info() != Eigen::Success) return Status::NotPositiveDefinite;
  const detail::MassMarginal<Scalar> marginal(likelihood, prior, com_llt.matrixL());
  int evaluations = 0;
  const auto at = [&](Scalar m) noexcept {
    ++evaluations;
    return marginal(m);
  };
  const auto log_density = [&at](Scalar m) noexcept { return at(m).log_density; };
  constexpr Scalar kNegligible = Scalar(20);  // e^-20 of the peak

  // Coarse pass.
  constexpr int kCoarse = 64;
  const Scalar spacing = 12 * prior_sd / kCoarse;
  const Scalar first = prior.mean[0] - 6 * prior_sd;
  std::array<Scalar, kCoarse + 1> coarse;
  int best = 0;
  for (int i = 0; i <= kCoarse; ++i) {
    coarse[std::size_t(i)] = log_density(first + Scalar(i) * spacing);
    if (coarse[std::size_t(i)] > coarse[std::size_t(best)]) best = i;
  }
  // The mode between the best node's neighbours.
  Scalar lo = first + Scalar(best - 1) * spacing, hi = lo + 2 * spacing;
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
  const Scalar mode = f1 > f2 ? x1 : x2;
  const Scalar peak = std::max(f1, f2);
  // The range: outwards from the mode in growing strides, then to any coarse node that still counts (a second mode).
  const auto reach = [&](Scalar direction) noexcept {
    Scalar distance = spacing * Scalar(1e-4);
    for (int i = 0; i < 32 && peak - log_density(mode + direction * distance) < kNegligible; ++i)
      distance *= Scalar(1.5);
    return mode + direction * distance;
  };
  Scalar from = reach(Scalar(-1)), to = reach(Scalar(1));
  for (int i = 0; i <= kCoarse; ++i) {
    if (peak - coarse[std::size_t(i)] > kNegligible) continue;
    from = std::min(from, first + Scalar(i - 1) * spacing);
    to = std::max(to, first + Scalar(i + 1) * spacing);
  }
  // Fine pass: moments about the mode, so that no large numbers cancel.
  constexpr int kFine = 128;
  const Scalar h = (to - from) / kFine;
  const Vector3<Scalar> centre = at(mode).mean;
  Scalar p0 = 0, p1 = 0, p2 = 0, p3 = 0, p4 = 0;
  Vector3<Scalar> z1 = Vector3<Scalar>::Zero(), mz = Vector3<Scalar>::Zero();
  Matrix3<Scalar> zz = Matrix3<Scalar>::Zero();
  for (int i = 0; i <= kFine; ++i) {
    const Scalar m = from + Scalar(i) * h;
    const auto com = at(m);
    const Scalar p = exp(com.log_density - peak);
    const Scalar d = m - mode;
    const Vector3<Scalar> z = com.mean - centre;
    p0 += p, p1 += p * d, p2 += p * d * d, p3 += p * d * d * d, p4 += p * d * d * d * d;
    z1 += p * z;
    mz += p * d * z;
    zz += p * z * z.transpose();
    zz.diagonal() += p * com.variance;
  }
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
  result.log_evidence = peak + log(p0 * h / (kSqrt2Pi * prior_sd));
  result.iterations = evaluations;
  return Status::Ok;
}

}  // namespace rme
