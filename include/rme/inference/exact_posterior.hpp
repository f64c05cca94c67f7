#pragma once
/// The exact posterior of a payload, by quadrature over the mass.
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/inference/payload_likelihood.hpp>

namespace rme {

/// Mean and covariance of the exact posterior, and the evidence.
template <typename Scalar>
struct ExactPosterior {
  PayloadGaussian<Scalar> moments;     ///< the posterior itself need not be Gaussian; see excess_kurtosis
  Scalar log_evidence = Scalar(0);     ///< log p(y), up to the constant that every model of the same window shares
  Scalar skewness = Scalar(0);         ///< of the mass
  Scalar excess_kurtosis = Scalar(0);  ///< of the mass; 0 for a Gaussian
};

namespace detail {

/// p(r | m, y) = N(mean, P^-1), and log p(y, m) with r integrated out.
template <typename Scalar>
struct ConditionalCom {
  ConditionalCom(const PayloadLikelihood<Scalar>& l, const PayloadGaussian<Scalar>& prior,
                 const Matrix4<Scalar>& prior_precision, Scalar m) noexcept {
    const auto P_rr = prior_precision.template block<3, 3>(1, 1);
    const auto P_rm = prior_precision.template block<3, 1>(1, 0);
    const Scalar d = m - prior.mean[0];
    llt.compute(P_rr + m * m * l.BB);
    // Information of r: the prior's, given m, plus the data's.
    const Vector3<Scalar> b = P_rr * prior.mean.template tail<3>() - d * P_rm + m * l.yB - m * m * l.aB;
    mean = llt.solve(b);
    const Vector3<Scalar> r0 = prior.mean.template tail<3>();
    log_joint = m * l.ya - Scalar(0.5) * m * m * l.aa - Scalar(0.5) * prior_precision(0, 0) * d * d + d * P_rm.dot(r0) -
                Scalar(0.5) * r0.dot(P_rr * r0) + Scalar(0.5) * b.dot(mean) -
                llt.matrixLLT().diagonal().array().log().sum();
  }
  Eigen::LLT<Matrix3<Scalar>> llt;
  Vector3<Scalar> mean;
  Scalar log_joint;
};

}  // namespace detail

/// Integrates over r in closed form and over m by the trapezoidal rule, which converges geometrically for a smooth
/// density that has died out at both ends (docs/theory.md, "The exact posterior"). A coarse pass over the prior's mean
/// +- 6 standard deviations finds the mode, a golden-section search sharpens it, and the fine pass covers whatever lies
/// within e^-20 of it. Real time: at most 65 + 40 + 64 + 129 evaluations of 3x3 algebra, no allocation.
/// @param[out] result  as it was unless the status is Ok
/// @return Ok; NonFiniteInput; NotPositiveDefinite (the prior's covariance)
template <typename Scalar>
Status exact_posterior(const PayloadLikelihood<Scalar>& likelihood, const PayloadGaussian<Scalar>& prior,
                       ExactPosterior<Scalar>& result) noexcept {
  using std::exp;
  using std::log;
  using std::sqrt;
  if (!likelihood.all_finite() || !prior.mean.allFinite() || !prior.covariance.allFinite())
    return Status::NonFiniteInput;
  const Eigen::LLT<Matrix4<Scalar>> prior_llt(prior.covariance);
  if (prior_llt.info() != Eigen::Success) return Status::NotPositiveDefinite;
  const Matrix4<Scalar> prior_precision = prior_llt.solve(Matrix4<Scalar>::Identity());
  const auto at = [&](Scalar m) noexcept {
    return detail::ConditionalCom<Scalar>(likelihood, prior, prior_precision, m);
  };
  constexpr Scalar kNegligible = Scalar(20);  // e^-20 of the peak

  // Coarse pass.
  constexpr int kCoarse = 64;
  const Scalar prior_sd = sqrt(prior.covariance(0, 0));
  const Scalar spacing = 12 * prior_sd / kCoarse;
  const Scalar first = prior.mean[0] - 6 * prior_sd;
  std::array<Scalar, kCoarse + 1> coarse;
  int best = 0;
  for (int i = 0; i <= kCoarse; ++i) {
    coarse[std::size_t(i)] = at(first + Scalar(i) * spacing).log_joint;
    if (coarse[std::size_t(i)] > coarse[std::size_t(best)]) best = i;
  }
  // The mode between the best node's neighbours.
  Scalar lo = first + Scalar(best - 1) * spacing, hi = lo + 2 * spacing;
  constexpr Scalar kGolden = Scalar(0.6180339887498949);
  Scalar x1 = hi - kGolden * (hi - lo), x2 = lo + kGolden * (hi - lo);
  Scalar f1 = at(x1).log_joint, f2 = at(x2).log_joint;
  for (int i = 0; i < 38 && hi - lo > Scalar(1e-7) * prior_sd; ++i) {
    if (f1 > f2) {
      hi = x2, x2 = x1, f2 = f1;
      x1 = hi - kGolden * (hi - lo), f1 = at(x1).log_joint;
    } else {
      lo = x1, x1 = x2, f1 = f2;
      x2 = lo + kGolden * (hi - lo), f2 = at(x2).log_joint;
    }
  }
  const Scalar mode = f1 > f2 ? x1 : x2;
  const Scalar peak = std::max(f1, f2);
  // The range: outwards from the mode in growing strides, then to any coarse node that still counts (a second mode).
  const auto reach = [&](Scalar direction) noexcept {
    Scalar distance = spacing * Scalar(1e-4);
    for (int i = 0; i < 32 && peak - at(mode + direction * distance).log_joint < kNegligible; ++i)
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
  Scalar p0 = 0, p1 = 0, p2 = 0, p3 = 0, p4 = 0;
  Vector3<Scalar> r1 = Vector3<Scalar>::Zero(), mr = Vector3<Scalar>::Zero();
  Matrix3<Scalar> rr = Matrix3<Scalar>::Zero();
  Vector3<Scalar> centre = at(mode).mean;
  for (int i = 0; i <= kFine; ++i) {
    const Scalar m = from + Scalar(i) * h;
    const detail::ConditionalCom<Scalar> com = at(m);
    const Scalar p = exp(com.log_joint - peak);
    const Scalar d = m - mode;
    const Vector3<Scalar> r = com.mean - centre;
    p0 += p, p1 += p * d, p2 += p * d * d, p3 += p * d * d * d, p4 += p * d * d * d * d;
    r1 += p * r;
    mr += p * d * r;
    rr += p * (r * r.transpose() + com.llt.solve(Matrix3<Scalar>::Identity()));
  }
  p1 /= p0, p2 /= p0, p3 /= p0, p4 /= p0, r1 /= p0, mr /= p0, rr /= p0;
  if (!std::isfinite(p2) || !r1.allFinite() || !rr.allFinite()) return Status::NonFiniteInput;
  const Scalar variance = p2 - p1 * p1;
  result.moments.mean[0] = mode + p1;
  result.moments.mean.template tail<3>() = centre + r1;
  result.moments.covariance(0, 0) = variance;
  result.moments.covariance.template block<3, 1>(1, 0) = mr - p1 * r1;
  result.moments.covariance.template block<1, 3>(0, 1) = (mr - p1 * r1).transpose();
  result.moments.covariance.template block<3, 3>(1, 1) = rr - r1 * r1.transpose();
  const Scalar third = p3 - 3 * p1 * p2 + 2 * p1 * p1 * p1;
  const Scalar fourth = p4 - 4 * p1 * p3 + 6 * p1 * p1 * p2 - 3 * p1 * p1 * p1 * p1;
  result.skewness = third / (variance * sqrt(variance));
  result.excess_kurtosis = fourth / (variance * variance) - 3;
  constexpr Scalar kHalfLog2Pi = Scalar(0.9189385332046727);
  result.log_evidence = peak + log(p0 * h) - Scalar(0.5) * likelihood.yy - kHalfLog2Pi -
                        prior_llt.matrixLLT().diagonal().array().log().sum();
  return Status::Ok;
}

}  // namespace rme
