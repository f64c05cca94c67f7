#pragma once
/// What acts on the arm beside the payload: a wrench at the tip that changes slowly, or a jolt on single joints.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <limits>
#include <rme/core/cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/joint_torque_model.hpp>
#include <rme/tracking/star_gaussian.hpp>

namespace rme {

/// How a disturbance changes from block to block.
enum class Disturbing : std::uint8_t {
  Hand,     ///< the wrench changes in any way, by a tenth of what a hand can do
  Growing,  ///< the wrench grows or shrinks along itself: contact that begins or ends softly
  Still,    ///< the wrench stays as it is
  Jolt,     ///< single joints are shaken, anew in each block
};

/// A Gaussian over the wrench of a disturbance, w: force [N] and moment [N m] about the end-effector origin, world axes.
/// The torque of a block is then the payload's and the arm's, plus J^T w, plus, for a jolt, an independent torque on
/// each joint (docs/theory.md (T43)). The payload is not learned from such a block. The arm's nuisances are, given the
/// wrench. Real time: nothing allocates.
template <typename Scalar, int Dofs>
class Disturbance {
 public:
  using Star = StarGaussian<Scalar, Dofs>;       ///< state of the filter
  using Model = JointTorqueModel<Scalar, Dofs>;  ///< model of the arm

  /// A wrench that nothing is known of: N(0, W) with W for hands and obstacles beside an arm for `rated_payload` [kg].
  void begin(Scalar rated_payload) noexcept {
    mean_.setZero();
    covariance_ = any(rated_payload);
  }
  /// Time update: the wrench changes from block to block.
  /// @param how            what the wrench does
  /// @param duration       of the block [s]
  /// @param rated_payload  [kg]
  void predict(Disturbing how, Scalar duration, Scalar rated_payload) noexcept {
    const Scalar blocks = duration / Scalar(kTrembleTime);
    const double share = how == Disturbing::Hand ? kTremble : how == Disturbing::Growing ? kOwn : 0;
    detail::add_scaled(covariance_, Scalar(share * share) * blocks, any(rated_payload));
    if (how != Disturbing::Growing) return;
    Scalar square = Scalar(0.01) * rated_payload * rated_payload;
    for (int i = 0; i < 3; ++i) square = std::max(square, mean_[i] * mean_[i]);
    const Scalar growth = Scalar(kGrowth * kGrowth) * rated_payload * rated_payload * blocks / square;
    detail::add_outer(covariance_, detail::scaled(growth, mean_), mean_);
  }
  /// Takes in the block of the model's last begin(): learns the wrench, and the arm's nuisances in `star`.
  /// @param model  of the arm
  /// @param star   state before the block; its x is kept
  /// @param jolt   standard deviation of an independent torque on each joint, times its scale [N m]; 0 for none
  /// @param squared  on return e^T S^-1 e without the disturbance, joints taken one by one
  /// @return log p(block) [nats], without the constant factor of 2 pi
  Scalar observe(const Model& model, Star& star, Scalar jolt, Scalar& squared) noexcept {
    squared = Scalar(0);
    const Jacobian<Scalar, Dofs>& J = model.block().jacobian;
    JointVector<Scalar, Dofs> e;
    Eigen::Matrix<Scalar, Dofs, kShared> spread;
    Eigen::Matrix<Scalar, Dofs, Dofs> total;
    std::array<typename Star::Prediction, static_cast<std::size_t>(Dofs)> predictions;
    for (int j = 0; j < Dofs; ++j) {
      auto& p = predictions[static_cast<std::size_t>(j)];
      p = star.predict(j, model.observation(j, star.mass()));
      squared += p.innovation * p.innovation / p.variance;
      const Scalar own = jolt * model.arm().residual[j];
      p.given_shared += own * own;
      e[j] = p.innovation;
      for (int i = 0; i < kShared; ++i) spread(j, i) = p.spread[i];
    }
    const Eigen::Matrix<Scalar, Dofs, 6> cross = detail::transposed_product(J, covariance_);
    total = detail::product(cross, J);
    total += detail::outer_square(spread);
    Scalar largest = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      total(j, j) += predictions[static_cast<std::size_t>(j)].given_shared;
      largest = std::max(largest, total(j, j));
    }
    // Combinations of torques that no wrench makes have standard deviations a hundred times smaller than the others. In
    // float, their variances are hardly above the rounding errors of the pivots.
    for (int j = 0; j < Dofs; ++j) total(j, j) += 16 * Eigen::NumTraits<Scalar>::epsilon() * largest;
    const Cholesky<Scalar, Dofs> factor(total);
    if (!factor.positive_definite()) return -std::numeric_limits<Scalar>::infinity();
    const JointVector<Scalar, Dofs> white =
        factor.solve_lower(detail::difference(e, JointVector<Scalar, Dofs>(detail::transposed_product(J, mean_))));
    const Eigen::Matrix<Scalar, Dofs, 6> gain = factor.solve_lower(cross);
    // The arm is learned given the wrench as it was known before this block: what the block shows of the wrench is not
    // known independently of the arm.
    for (int j = 0; j < Dofs; ++j) {
      auto& p = predictions[static_cast<std::size_t>(j)];
      Scalar wrench = Scalar(0), variance = Scalar(0);
      for (int i = 0; i < 6; ++i) {
        wrench += J(i, j) * mean_[i];
        variance += cross(j, i) * J(i, j);
      }
      p.conditional_error -= wrench;
      p.given_shared += Scalar(kCommon) * std::max(variance, Scalar(0));
      star.observe_nuisances(j, p);
    }
    detail::add_scaled(mean_, Scalar(1), detail::transposed_product(gain, white));
    detail::add_scaled(covariance_, Scalar(-1), detail::transposed_product(gain, gain));
    return Scalar(-0.5) * detail::dot(white, white) - factor.log_det_lower();
  }

  const Vector6<Scalar>& mean() const noexcept { return mean_; }                          ///< of w [N, N m]
  const Eigen::Matrix<Scalar, 6, 6>& covariance() const noexcept { return covariance_; }  ///< of w

 private:
  // The error of the wrench is the same for as long as the hand pushes in the same way. The nuisances take it for new
  // in each block, so it counts this many times: that of four seconds.
  static constexpr double kCommon = 200;
  static constexpr double kForce = 4;           // standard deviation of a new wrench's force per rated payload [N/kg]
  static constexpr double kMoment = 0.5;        // the same of its moment [N m/kg]
  static constexpr double kTremble = 0.1;       // change of the wrench within kTrembleTime, as a share of a new one
  static constexpr double kTrembleTime = 0.02;  // [s]
  static constexpr double kOwn = 2e-4;          // tremble of a growing wrench in all directions
  static constexpr double kGrowth = 0.0265;     // its growth along itself in kTrembleTime, per rated payload [N/kg]
  static Eigen::Matrix<Scalar, 6, 6> any(Scalar rated) noexcept {
    Eigen::Matrix<Scalar, 6, 6> W = Eigen::Matrix<Scalar, 6, 6>::Zero();
    for (int i = 0; i < 6; ++i) {
      const Scalar deviation = Scalar(i < 3 ? kForce : kMoment) * rated;
      W(i, i) = deviation * deviation;
    }
    return W;
  }
  Vector6<Scalar> mean_ = Vector6<Scalar>::Zero();
  Eigen::Matrix<Scalar, 6, 6> covariance_ = Eigen::Matrix<Scalar, 6, 6>::Zero();
};

}  // namespace rme
