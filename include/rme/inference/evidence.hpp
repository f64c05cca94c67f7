#pragma once
/// Payload or push? The log evidence of a window of samples for each.
#include <rme/core/cholesky.hpp>
#include <rme/core/payload.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/payload_statistics.hpp>

namespace rme {

/// Prior of a push: a constant wrench w ~ N(0, S) in any direction, at the end-effector origin.
struct PushPrior {
  double force = 15;    ///< standard deviation of each component [N], > 0
  double moment = 1.5;  ///< standard deviation of each component [N m], > 0
};

/// log p(y | the hand holds exactly `payload`, and nothing else acts) [nats], with the nuisances integrated out, up to
/// a constant that is the same in push_log_evidence().
template <typename Scalar>
Scalar payload_log_evidence(const PayloadLikelihood<Scalar>& likelihood, const Payload<Scalar>& payload) noexcept {
  return likelihood.log_likelihood(payload.vector()) + likelihood.log_factor;
}

/// log p(y | the hand holds exactly `payload`, and a constant wrench w ~ N(0, S) acts as well), with w and the
/// nuisances integrated out (docs/theory.md (T47)):
///
///     log p = -1/2 (sum_j <e, e>_j - b^T P^-1 b) - 1/2 log det(P S),    e = y - m (a + B r)
///     b = sum_j J_j <1, e>_j,    P = S^-1 + sum_j J_j J_j^T <1, 1>_j
///
/// where j counts the joints, J_j is a column of J, and <., .>_j is the weighted sum over the samples of joint j.
/// @param joints             of the window, from PayloadStatistics::marginals
/// @param payload            what the hand holds
/// @param jacobian           J, 6 x Dofs, taken as constant over the window
/// @param prior              S
/// @param[out] log_evidence  [nats]; as it was unless the status is Ok
/// @return Ok, or NotPositiveDefinite if a number overflowed
template <typename Scalar, int Dofs>
Status push_log_evidence(const typename PayloadStatistics<Scalar, Dofs>::Marginals& joints,
                         const Payload<Scalar>& payload, const Jacobian<Scalar, Dofs>& jacobian, const PushPrior& prior,
                         Scalar& log_evidence) noexcept {
  Vector6<Scalar> deviation;
  deviation << Vector3<Scalar>::Constant(Scalar(prior.force)), Vector3<Scalar>::Constant(Scalar(prior.moment));
  // In units of the prior's standard deviations, P S is the identity plus the sum over the joints: well scaled always.
  Matrix6<Scalar> P = Matrix6<Scalar>::Identity();
  Vector6<Scalar> b = Vector6<Scalar>::Zero();
  Eigen::Matrix<Scalar, 5, 1> residual;  // y - m a - m B r as a combination of (y, a, B)
  residual << Scalar(1), -payload.mass, -payload.mass * payload.com;
  Scalar ee = Scalar(0), log_factor = Scalar(0);
  for (int j = 0; j < Dofs; ++j) {
    const auto& joint = joints[static_cast<std::size_t>(j)];
    const Vector6<Scalar> row = deviation.cwiseProduct(jacobian.col(j));
    ee += residual.dot(joint.products.template topLeftCorner<5, 5>() * residual);
    b += joint.products.template topRightCorner<5, 1>().dot(residual) * row;
    P += joint.products(5, 5) * row * row.transpose();
    log_factor += joint.log_factor;
  }
  const Cholesky<Scalar, 6> factor(P);
  if (!factor.positive_definite()) return Status::NotPositiveDefinite;
  log_evidence = Scalar(-0.5) * (ee - factor.solve_lower(b).squaredNorm()) - factor.log_det_lower() + log_factor;
  return Status::Ok;
}

}  // namespace rme
