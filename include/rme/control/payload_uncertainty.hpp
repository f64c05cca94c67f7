#pragma once
/// By how much an uncertain payload may change the accelerations that the constraints predict.
#include <algorithm>
#include <cmath>
#include <rme/control/prediction_error.hpp>
#include <rme/core/cholesky.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/tracking/hypothesis.hpp>

namespace rme {

/// Settings of PayloadUncertainty.
template <typename Scalar>
struct PayloadUncertaintyConfig {
  Scalar deviations = Scalar(3);  ///< k >= 0: the error covers k standard deviations of the payload's acceleration
  /// 0 to 1: an empty hand, or another object, counts as possible if its probability is at least this.
  Scalar likely = Scalar(0.01);
  Scalar rated_mass = Scalar(3);         ///< mass of the heaviest object that may be attached [kg], >= 0
  Scalar rated_distance = Scalar(0.15);  ///< rho, largest distance of its CoM from the end-effector origin [m], >= 0
  Vector3<Scalar> gravity = standard_gravity<Scalar>();  ///< [m/s^2], world axes
};

/// Turns a belief about the payload into a torque for CPIC's prediction and an error bound for its rows
/// (docs/theory_control.md (C14)). With the payload's static torque tau_p(theta) and its derivative A by theta at the
/// mean,
///
///     mean torque  tau_p(mean)               to be subtracted from CpicInput::bias
///     error_j      k sqrt(a_j Sigma a_j^T),  a_j = row j of M^-1 A
///
/// If the hand may be empty, the error also covers the difference between the mean and no payload. If the object may be
/// another one, it covers the difference between the mean and any object up to the rated one. If the belief is right,
/// and to first order, the payload's part of a joint's acceleration lies outside the error bound with a probability of
/// at most erfc(k / sqrt 2), plus `likely` for each hypothesis that is left out.
///
/// Optional: the published controller adds the compensation after CPIC, and CPIC knows of no payload (Appendix B).
template <typename Scalar, int Dofs>
class PayloadUncertainty {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< joint torque [N m] or acceleration [rad/s^2]

  /// @throws std::invalid_argument naming the field out of range
  explicit PayloadUncertainty(const PayloadUncertaintyConfig<Scalar>& config = PayloadUncertaintyConfig<Scalar>());

  /// @param belief       mean and covariance of (m, r), EstimatorState::payload
  /// @param probability  of the hypotheses, EstimatorState::probability
  /// @param jacobian     J, 6xDofs
  /// @param rotation     R, end-effector axes to world axes
  /// @param mass_matrix  M [kg m^2], the same as in CpicInput
  /// @return Ok; NonFiniteInput, also for numbers beyond kLargestPlausible; NotPositiveDefinite for M. After both,
  ///         nothing has changed
  Status update(const PayloadGaussian<Scalar>& belief, const PerHypothesis<Scalar>& probability,
                const Jacobian<Scalar, Dofs>& jacobian, const Matrix3<Scalar>& rotation,
                const JointMatrix<Scalar, Dofs>& mass_matrix) noexcept;

  const Vector& torque() const noexcept { return torque_; }                         ///< tau_p(mean) [N m]
  const AccelerationError<Scalar, Dofs>& error() const noexcept { return error_; }  ///< for the rows [rad/s^2]

 private:
  PayloadUncertaintyConfig<Scalar> config_;
  Vector torque_ = Vector::Zero();
  AccelerationError<Scalar, Dofs> error_;
};

template <typename Scalar, int Dofs>
PayloadUncertainty<Scalar, Dofs>::PayloadUncertainty(const PayloadUncertaintyConfig<Scalar>& config) : config_(config) {
  detail::require(config.deviations >= 0 && plausible(config.deviations), "PayloadUncertaintyConfig::deviations",
                  ">= 0", config.deviations);
  detail::require(config.likely >= 0 && config.likely <= 1, "PayloadUncertaintyConfig::likely", "0 to 1",
                  config.likely);
  detail::require(config.rated_mass >= 0 && plausible(config.rated_mass), "PayloadUncertaintyConfig::rated_mass",
                  ">= 0 kg", config.rated_mass);
  detail::require(config.rated_distance >= 0 && plausible(config.rated_distance),
                  "PayloadUncertaintyConfig::rated_distance", ">= 0 m", config.rated_distance);
  detail::require(plausible(config.gravity), "PayloadUncertaintyConfig::gravity", "finite numbers",
                  config.gravity.norm());
}

template <typename Scalar, int Dofs>
Status PayloadUncertainty<Scalar, Dofs>::update(const PayloadGaussian<Scalar>& belief,
                                                const PerHypothesis<Scalar>& probability,
                                                const Jacobian<Scalar, Dofs>& jacobian, const Matrix3<Scalar>& rotation,
                                                const JointMatrix<Scalar, Dofs>& mass_matrix) noexcept {
  const Scalar empty = probability[Hypothesis::Empty], exchanged = probability[Hypothesis::Exchanged];
  if (!plausible(belief.mean) || !plausible(belief.covariance) || !plausible(jacobian) || !plausible(rotation) ||
      !plausible(mass_matrix) || !plausible(empty) || !plausible(exchanged))
    return Status::NonFiniteInput;
  const Cholesky<Scalar, Dofs> cholesky(mass_matrix);
  if (!cholesky.positive_definite()) return Status::NotPositiveDefinite;

  // tau_p = m (a + B r) with a = J_v^T g and B = -J_w^T [g]x R.
  const Scalar mass = belief.mean[0];
  const Vector3<Scalar> com = belief.mean.template tail<3>();
  Eigen::Matrix<Scalar, Dofs, 4> weight;  // a, B
  weight.col(0) = jacobian.template topRows<3>().transpose() * config_.gravity;
  weight.template rightCols<3>() = -jacobian.template bottomRows<3>().transpose() * (skew(config_.gravity) * rotation);
  const Eigen::Matrix<Scalar, Dofs, 4> pull = cholesky.solve(weight);  // M^-1 [a, B]
  const Vector per_mass = pull.col(0) + pull.template rightCols<3>() * com;
  const Vector mean = mass * per_mass;
  if (!plausible(mean)) return Status::NotPositiveDefinite;  // M positive by rounding alone

  AccelerationError<Scalar, Dofs> error;
  for (int j = 0; j < Dofs; ++j) {
    Vector4<Scalar> slope;
    slope << per_mass[j], mass * pull.template rightCols<3>().row(j).transpose();
    const Scalar variance = slope.dot(belief.covariance * slope);
    Scalar below = config_.deviations * std::sqrt(std::max(variance, Scalar(0))), above = below;
    if (empty >= config_.likely) {
      below = std::max(below, mean[j]);
      above = std::max(above, -mean[j]);
    }
    if (exchanged >= config_.likely) {
      const Scalar swing = config_.rated_distance * pull.template rightCols<3>().row(j).norm();
      const Scalar least = config_.rated_mass * std::min(pull(j, 0) - swing, Scalar(0));
      const Scalar most = config_.rated_mass * std::max(pull(j, 0) + swing, Scalar(0));
      below = std::max(below, mean[j] - least);
      above = std::max(above, most - mean[j]);
    }
    error.below[j] = below;
    error.above[j] = above;
  }
  if (!plausible(error.below) || !plausible(error.above)) return Status::NonFiniteInput;
  torque_ = mass * (weight.col(0) + weight.template rightCols<3>() * com);
  error_ = error;
  return Status::Ok;
}

}  // namespace rme
