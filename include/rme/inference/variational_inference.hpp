#pragma once
/// Gaussian variational inference over a payload, in closed form.
#include <algorithm>
#include <cmath>
#include <rme/core/cholesky.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/inference_result.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/inference/payload_likelihood.hpp>

namespace rme {

/// Expectations of log p(y, theta) = L(theta) + log N(theta; prior) under a Gaussian. L is a quartic polynomial, so
/// each expectation is exact (Isserlis; docs/theory.md (T37)).
template <typename Scalar>
class ExpectedLogJoint {
 public:
  /// @param likelihood       of the window
  /// @param prior_mean       4x1
  /// @param prior_precision  inverse of the prior's covariance
  ExpectedLogJoint(const PayloadLikelihood<Scalar>& likelihood, const Vector4<Scalar>& prior_mean,
                   const Matrix4<Scalar>& prior_precision) noexcept
      : l_(likelihood), prior_mean_(prior_mean), prior_precision_(prior_precision) {}

  /// E_q[log p(y, theta)] under q = N(mu, Sigma), up to a constant. The term yy is left out: it is so large that the
  /// others would be lost to rounding.
  Scalar value(const Vector4<Scalar>& mu, const Matrix4<Scalar>& Sigma) const noexcept {
    const Moments q(mu, Sigma);
    const Scalar m2_rQr =
        q.m2 * (q.r.dot(l_.BB * q.r) + trace_bb(q)) + 4 * q.m * q.r.dot(l_.BB * q.c) + 2 * q.c.dot(l_.BB * q.c);
    const Scalar likelihood =
        q.m * l_.ya + l_.yB.dot(q.m_r) - Scalar(0.5) * (q.m2 * l_.aa + 2 * l_.aB.dot(q.m2_r) + m2_rQr);
    const Vector4<Scalar> d = mu - prior_mean_;
    return likelihood - Scalar(0.5) * (d.dot(prior_precision_ * d) + prior_precision_.cwiseProduct(Sigma).sum());
  }

  /// E_q[grad log p(y, theta)], 4x1.
  Vector4<Scalar> gradient(const Vector4<Scalar>& mu, const Matrix4<Scalar>& Sigma) const noexcept {
    const Moments q(mu, Sigma);
    const Vector3<Scalar> BB_r = l_.BB * q.r;
    Vector4<Scalar> g;
    g[0] = l_.ya + l_.yB.dot(q.r) - q.m * l_.aa - 2 * l_.aB.dot(q.m_r) - q.m * (q.r.dot(BB_r) + trace_bb(q)) -
           2 * BB_r.dot(q.c);
    g.template tail<3>() = q.m * l_.yB - q.m2 * l_.aB - l_.BB * q.m2_r;
    return g - prior_precision_ * (mu - prior_mean_);
  }

  /// -E_q[hess log p(y, theta)], 4x4: at the optimum, the inverse of Sigma.
  Matrix4<Scalar> precision(const Vector4<Scalar>& mu, const Matrix4<Scalar>& Sigma) const noexcept {
    const Moments q(mu, Sigma);
    Matrix4<Scalar> P;
    P(0, 0) = l_.aa + 2 * l_.aB.dot(q.r) + q.r.dot(l_.BB * q.r) + trace_bb(q);
    P.template block<3, 1>(1, 0) = 2 * (q.m * l_.aB + l_.BB * q.m_r) - l_.yB;
    P.template block<1, 3>(0, 1) = P.template block<3, 1>(1, 0).transpose();
    P.template block<3, 3>(1, 1) = q.m2 * l_.BB;
    return P + prior_precision_;
  }

 private:
  /// Moments of q that the expectations are made of.
  struct Moments {
    Moments(const Vector4<Scalar>& mu, const Matrix4<Scalar>& Sigma) noexcept
        : m(mu[0]),
          r(mu.template tail<3>()),
          c(Sigma.template block<3, 1>(1, 0)),
          C(Sigma.template block<3, 3>(1, 1)),
          m2(m * m + Sigma(0, 0)),
          m_r(m * r + c),
          m2_r(m2 * r + 2 * m * c) {}
    Scalar m;              // E[m]
    Vector3<Scalar> r;     // E[r]
    Vector3<Scalar> c;     // cov(m, r)
    Matrix3<Scalar> C;     // cov(r)
    Scalar m2;             // E[m^2]
    Vector3<Scalar> m_r;   // E[m r]
    Vector3<Scalar> m2_r;  // E[m^2 r]
  };
  Scalar trace_bb(const Moments& q) const noexcept { return l_.BB.cwiseProduct(q.C).sum(); }

  PayloadLikelihood<Scalar> l_;
  Vector4<Scalar> prior_mean_;
  Matrix4<Scalar> prior_precision_;
};

/// Selects the Gaussian with full covariance, which is the default. Its expectations are in closed form, and it has the
/// correlation of mass and centre of mass.
struct VariationalInferenceConfig {
  int max_iterations = 50;  ///< bound on the number of steps; about 8 are needed
  double tolerance = 1e-4;  ///< stop when a step is below this many posterior standard deviations
};

/// The Gaussian q that maximises the ELBO, full covariance, by the fixed point (docs/theory.md (T38)) of
///
///     Sigma^-1 = -E_q[hess log p],   mu <- mu + Sigma E_q[grad log p]
///
/// with steps in the natural parameters, halved until the ELBO does not fall. Real time: at most max_iterations steps
/// with at most 20 halvings each, all 4x4, no allocation.
/// @param likelihood   of the window
/// @param prior        over (m, r), covariance positive definite
/// @param[out] result  the best iterate; as it was if the status is NonFiniteInput or NotPositiveDefinite
/// @param config       bounds on the work
/// @param start        the mean to start from, 4x1; a mean from nearly the same data saves steps. If it is null, the
///                     iteration starts at the prior's centre of mass and the mass that fits best there. The mass
///                     keeps the sign that it has at the start
/// @return Ok; NotConverged (result holds the best iterate); NonFiniteInput; NotPositiveDefinite (prior's covariance)
template <typename Scalar>
Status infer_payload(const PayloadLikelihood<Scalar>& likelihood, const PayloadGaussian<Scalar>& prior,
                     InferenceResult<Scalar>& result,
                     const VariationalInferenceConfig& config = VariationalInferenceConfig(),
                     const Vector4<Scalar>* start = nullptr) noexcept;

namespace detail {

/// Where the iteration starts: at the prior's centre of mass and the mass that fits best there. It then converges to
/// the mode on the prior's side of m = 0.
template <typename Scalar>
Vector4<Scalar> initial_mean(const PayloadLikelihood<Scalar>& l, const Vector4<Scalar>& prior_mean,
                             const Matrix4<Scalar>& prior_precision) noexcept {
  Vector4<Scalar> mu = prior_mean;
  const Vector3<Scalar> r = mu.template tail<3>();
  mu[0] = (l.ya + l.yB.dot(r) + prior_precision(0, 0) * prior_mean[0]) /
          (l.aa + 2 * l.aB.dot(r) + r.dot(l.BB * r) + prior_precision(0, 0));
  return mu;
}

}  // namespace detail

template <typename Scalar>
Status infer_payload(const PayloadLikelihood<Scalar>& likelihood, const PayloadGaussian<Scalar>& prior,
                     InferenceResult<Scalar>& result, const VariationalInferenceConfig& config,
                     const Vector4<Scalar>* start) noexcept {
  if (!likelihood.all_finite() || !prior.mean.allFinite() || !prior.covariance.allFinite() ||
      (start != nullptr && !start->allFinite()))
    return Status::NonFiniteInput;
  const Cholesky<Scalar, 4> prior_factor(prior.covariance);
  if (!prior_factor.positive_definite()) return Status::NotPositiveDefinite;
  const Matrix4<Scalar> prior_precision = prior_factor.inverse();
  const ExpectedLogJoint<Scalar> joint(likelihood, prior.mean, prior_precision);
  using std::sqrt;
  // In float, round-off of the gradient does not allow a smaller tolerance.
  const Scalar tolerance = std::max(Scalar(config.tolerance), 4 * sqrt(Eigen::NumTraits<Scalar>::epsilon()));

  // Entropy of q and normaliser of the prior; their powers of 2 pi cancel.
  const Scalar constant = Scalar(2) - prior_factor.log_det_lower();

  // One point of the iteration; log det Sigma comes from the factor of the precision P = Sigma^-1.
  struct Iterate {
    Vector4<Scalar> mu;
    Matrix4<Scalar> P, Sigma;
    Scalar log_det_P;
    Scalar elbo;
  };
  const auto invert = [](Iterate& q) noexcept {
    const Cholesky<Scalar, 4> factor(q.P);
    if (!factor.positive_definite()) return false;
    q.Sigma = factor.inverse();
    q.log_det_P = 2 * factor.log_det_lower();
    return true;
  };
  const auto evaluate = [&joint, constant](Iterate& q) noexcept {
    q.elbo = joint.value(q.mu, q.Sigma) - Scalar(0.5) * q.log_det_P + constant;
    return std::isfinite(q.elbo);
  };

  Iterate q;
  q.mu = start != nullptr ? *start : detail::initial_mean(likelihood, prior.mean, prior_precision);
  // The curvature at the start is positive definite if the fit is good or the prior dominates; the prior's always is.
  q.P = joint.precision(q.mu, Matrix4<Scalar>::Zero());
  if (!invert(q)) {
    q.P = prior_precision;
    if (!invert(q)) return Status::NotPositiveDefinite;
  }
  if (!evaluate(q)) return Status::NonFiniteInput;

  Status status = Status::NotConverged;
  int iteration = 0;
  while (iteration < config.max_iterations && status == Status::NotConverged) {
    ++iteration;
    const Vector4<Scalar> gradient = joint.gradient(q.mu, q.Sigma);
    const Matrix4<Scalar> target = joint.precision(q.mu, q.Sigma);
    // A difference of two ELBOs below this is round-off. In float, differences soon become as small as that.
    const Scalar round_off = 4 * Eigen::NumTraits<Scalar>::epsilon() * std::abs(q.elbo);
    Iterate next;
    bool found = false;
    // For a posterior far from Gaussian, full steps of the precision oscillate about the optimum; half steps do not.
    const Scalar damping = iteration <= 8 ? Scalar(1) : Scalar(0.5);
    for (Scalar step = Scalar(1); !found && step > Scalar(1e-6); step *= Scalar(0.5)) {
      next.P = q.P + damping * step * (target - q.P);
      if (!invert(next)) continue;
      const Vector4<Scalar> direction = next.Sigma * gradient;
      next.mu = q.mu + step * direction;
      if (!evaluate(next)) continue;
      if (step == Scalar(1)) {
        const auto deviation = next.Sigma.diagonal().array().sqrt();
        const Scalar moved = (direction.array().abs() / deviation).maxCoeff();
        const Scalar widened = (q.Sigma.diagonal().array().sqrt() / deviation - Scalar(1)).abs().maxCoeff();
        // Such a short step does not change the ELBO noticeably.
        if (moved < tolerance && widened < tolerance) status = Status::Ok;
      }
      found = status == Status::Ok || next.elbo >= q.elbo - round_off;
    }
    if (!found) {  // every representable step lowers the ELBO
      status = Status::Ok;
      break;
    }
    q = next;
  }
  result.posterior = {q.mu, q.Sigma};
  result.log_evidence = q.elbo;
  result.iterations = iteration;
  return status;
}

}  // namespace rme
