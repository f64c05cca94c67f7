#pragma once
/// Variational inference over a payload with independent entries, in closed form.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <rme/core/cholesky.hpp>
#include <rme/core/status.hpp>
#include <rme/core/sum_of_logs.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/inference_result.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/inference/payload_likelihood.hpp>
#include <rme/inference/variational_inference.hpp>

namespace rme {

/// Selects the mean-field family, which is the published one: a diagonal Gaussian. Mass and centre of mass are
/// correlated, so its intervals are too narrow. The full covariance (VariationalInferenceConfig) costs no more.
struct MeanFieldConfig {
  int max_iterations = 50;  ///< bound on the number of sweeps; about 6 are needed
  double tolerance = 1e-4;  ///< stop when a step is below this many posterior standard deviations
};

/// The diagonal Gaussian q that maximises the ELBO, by coordinate ascent over three blocks: the four means, the
/// variance of the mass, the variances of the centre of mass. The variances have their optimum in closed form
/// (docs/theory.md (T39)),
///
///     1 / v_i = -E_q[hess log p]_ii
///
/// Each mean has one as well, given the others. But mass and centre of mass are correlated: if they are updated in
/// turn, they need many sweeps. So all means are updated together by a Newton step, which is halved until the ELBO does
/// not fall. If no such step is found, they are updated in turn.
/// Real time: at most max_iterations sweeps with at most 20 halvings each, all 4x4, no allocation.
/// @param likelihood   of the window
/// @param prior        over (m, r), covariance positive definite
/// @param[out] result  the best iterate; as it was if the status is NonFiniteInput or NotPositiveDefinite
/// @param config       bounds on the work
/// @return Ok; NotConverged (result holds the best iterate); NonFiniteInput; NotPositiveDefinite (prior's covariance)
template <typename Scalar>
Status infer_payload(const PayloadLikelihood<Scalar>& likelihood, const PayloadGaussian<Scalar>& prior,
                     InferenceResult<Scalar>& result, const MeanFieldConfig& config) noexcept;

namespace detail {

/// The current q = N(mean, diag(variance)), and the sweeps that increase its ELBO.
template <typename Scalar>
class MeanFieldAscent {
 public:
  MeanFieldAscent(const ExpectedLogJoint<Scalar>& joint, const Vector4<Scalar>& mean) noexcept
      : joint_(joint),
        mean_(mean),
        variance_(joint.precision(mean, Matrix4<Scalar>::Zero()).diagonal().cwiseInverse()) {
    objective_ = objective(mean_);
  }

  const Vector4<Scalar>& mean() const noexcept { return mean_; }
  const Vector4<Scalar>& variance() const noexcept { return variance_; }
  /// The ELBO, up to a constant.
  Scalar objective() const noexcept { return objective_; }

  /// One sweep over the blocks. The objective does not fall by more than its round-off.
  /// @return the longest step of a mean or relative change of a deviation, in standard deviations
  Scalar sweep(Scalar tolerance) noexcept {
    const Vector4<Scalar> mean_before = mean_, variance_before = variance_;
    if (!step_together(tolerance)) step_in_turn();
    // Given the means: first the variance of the mass, since the precision of the centre of mass contains E[m^2].
    variance_[0] = 1 / precision()(0, 0);
    variance_.template tail<3>() = precision().diagonal().template tail<3>().cwiseInverse();
    objective_ = objective(mean_);
    const auto deviation = variance_.array().sqrt();
    const Scalar moved = ((mean_ - mean_before).array().abs() / deviation).maxCoeff();
    return std::max(moved, ((variance_before.array().sqrt() / deviation) - Scalar(1)).abs().maxCoeff());
  }

 private:
  Matrix4<Scalar> precision() const noexcept { return joint_.precision(mean_, variance_.asDiagonal()); }
  Scalar objective(const Vector4<Scalar>& mean) const noexcept {
    return joint_.value(mean, variance_.asDiagonal()) + Scalar(0.5) * sum_of_logs(variance_);
  }

  /// A Newton step of all means.
  /// @return whether a step was found that does not lower the objective
  bool step_together(Scalar tolerance) noexcept {
    const Cholesky<Scalar, 4> factor(precision());
    if (!factor.positive_definite()) return false;
    const Vector4<Scalar> direction = factor.solve(joint_.gradient(mean_, variance_.asDiagonal()));
    // Such a short step changes the objective by less than its round-off, so the objectives are not compared.
    if ((direction.array().abs() < tolerance * variance_.array().sqrt()).all()) {
      mean_ += direction;
      return true;
    }
    const Scalar round_off = 8 * Eigen::NumTraits<Scalar>::epsilon() * std::abs(objective_);
    for (Scalar step = Scalar(1); step > Scalar(1e-6); step *= Scalar(0.5)) {
      const Vector4<Scalar> next = mean_ + step * direction;
      if (!(objective(next) >= objective_ - round_off)) continue;
      mean_ = next;
      return true;
    }
    return false;
  }

  /// The mass given the centre of mass, then the centre of mass given the mass: each is the maximum of a parabola.
  void step_in_turn() noexcept {
    mean_[0] += joint_.gradient(mean_, variance_.asDiagonal())[0] / precision()(0, 0);
    const Cholesky<Scalar, 3> factor(precision().template bottomRightCorner<3, 3>());
    const Vector3<Scalar> gradient = joint_.gradient(mean_, variance_.asDiagonal()).template tail<3>();
    mean_.template tail<3>() += factor.solve(gradient);
  }

  const ExpectedLogJoint<Scalar>& joint_;
  Vector4<Scalar> mean_, variance_;
  Scalar objective_;
};

}  // namespace detail

template <typename Scalar>
Status infer_payload(const PayloadLikelihood<Scalar>& likelihood, const PayloadGaussian<Scalar>& prior,
                     InferenceResult<Scalar>& result, const MeanFieldConfig& config) noexcept {
  if (!likelihood.all_finite() || !prior.mean.allFinite() || !prior.covariance.allFinite())
    return Status::NonFiniteInput;
  const Cholesky<Scalar, 4> prior_factor(prior.covariance);
  if (!prior_factor.positive_definite()) return Status::NotPositiveDefinite;
  const Matrix4<Scalar> prior_precision = prior_factor.inverse();
  const ExpectedLogJoint<Scalar> joint(likelihood, prior.mean, prior_precision);
  using std::sqrt;
  // In float, round-off of the gradient does not allow a smaller tolerance.
  const Scalar tolerance = std::max(Scalar(config.tolerance), 32 * sqrt(Eigen::NumTraits<Scalar>::epsilon()));

  detail::MeanFieldAscent<Scalar> q(joint, detail::initial_mean(likelihood, prior.mean, prior_precision));
  Status status = Status::NotConverged;
  int iteration = 0;
  while (iteration < config.max_iterations && status == Status::NotConverged) {
    ++iteration;
    if (q.sweep(tolerance) < tolerance) status = Status::Ok;
  }
  if (!std::isfinite(q.objective())) return Status::NonFiniteInput;
  result.posterior = {q.mean(), q.variance().asDiagonal()};
  // Entropy of q and normaliser of the prior; their powers of 2 pi cancel.
  result.log_evidence = q.objective() + Scalar(2) - prior_factor.log_det_lower();
  result.iterations = iteration;
  return status;
}

}  // namespace rme
