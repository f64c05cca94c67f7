#pragma once
/// Likelihood of a push: the wrench of a hand on the end effector, tracked from block to block.
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/core/cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>

namespace rme::bank {

/// Computes the likelihood of a block's torque if a wrench w acts in addition to the payload (docs/theory.md (T43)).
/// The wrench of a new push may be any: w ~ N(0, W). The wrench of a push that goes on changes little from block to
/// block. So its six unknowns lower the evidence only once, as a payload's unknowns do, and a push and a payload are
/// compared by which of them fits better. Once a second the wrench is taken as new in any case, so that a payload which
/// was taken for a push can win.
///
/// Real time: O(Dofs^3), no allocation.
template <typename Scalar, int Dofs>
class PushFilter {
 public:
  using Covariance = Eigen::Matrix<Scalar, Dofs, Dofs>;  ///< of a block's torque [(N m)^2]

  /// @param rated_payload  [kg], > 0. The standard deviations in W are 4 N and 0.5 N m per kilogram of it
  explicit PushFilter(Scalar rated_payload) noexcept {
    const Scalar force = 4 * rated_payload, moment = Scalar(0.5) * rated_payload;
    for (int i = 0; i < 6; ++i) any_(i, i) = i < 3 ? force * force : moment * moment;
  }

  /// Updates the wrench with a block.
  /// @param innovation  e, the block's torque minus its prediction without a push [N m]
  /// @param covariance  S, the covariance of e [(N m)^2]
  /// @param jacobian    J, 6 x Dofs
  /// @param duration    of the block [s], > 0
  /// @param goes_on     P(the block before was pushed, given that this one is), 0 to 1
  /// @return log likelihood of e [nats], without the constant factor of 2 pi: that of a mixture of N(e; J^T w, S + J^T
  ///         cov(w) J) for the known and for a new wrench. Minus infinity if S is not positive definite
  Scalar update(const JointVector<Scalar, Dofs>& innovation, const Covariance& covariance,
                const Jacobian<Scalar, Dofs>& jacobian, Scalar duration, Scalar goes_on) noexcept {
    using std::abs;
    using std::exp;
    using std::log;
    Wrench other{Vector6<Scalar>::Zero(), any_};
    const Scalar anew = observe(other, innovation, covariance, jacobian);
    const Scalar stays = Scalar(kStays) * goes_on;
    lasted_ += duration;
    if (!known_ || !(stays > 0) || lasted_ > Scalar(kLongest) || !(anew > -std::numeric_limits<Scalar>::infinity())) {
      begin(other);
      return anew;
    }
    detail::add_scaled(wrench_.covariance, Scalar(kChange * kChange) * duration / Scalar(0.02), any_);
    const Scalar on = log(stays) + observe(wrench_, innovation, covariance, jacobian), off = log(1 - stays) + anew;
    if (off > on) begin(other);
    return std::max(on, off) + log(Scalar(1) + exp(-abs(on - off)));
  }
  void forget() noexcept { known_ = false; }  ///< says that nothing pushes: the next wrench is a new one

 private:
  static constexpr double kStays = 0.9;  // probability that the wrench of a lasting push goes on in the next block
  // Random walk of the wrench in 20 ms, as a share of W's standard deviations: a hand trembles. If it were larger,
  // *pushed* would explain noise better than *empty* does.
  static constexpr double kChange = 0.1;
  static constexpr double kLongest = 1;  // time after which the wrench is taken as new [s]

  struct Wrench {  // world axes, at the end-effector origin [N, N m]
    Vector6<Scalar> mean;
    Eigen::Matrix<Scalar, 6, 6> covariance;
  };

  void begin(const Wrench& wrench) noexcept {
    wrench_ = wrench;
    known_ = true;
    lasted_ = Scalar(0);
  }
  /// Kalman update of a wrench with a block.
  /// @return log likelihood of the block
  static Scalar observe(Wrench& wrench, const JointVector<Scalar, Dofs>& innovation, const Covariance& covariance,
                        const Jacobian<Scalar, Dofs>& jacobian) noexcept {
    const Eigen::Matrix<Scalar, Dofs, 6> cross = detail::transposed_product(jacobian, wrench.covariance);
    Covariance total = detail::product(cross, jacobian);
    total += covariance;
    // Allows for rounding errors of the pivots: combinations of torques that no wrench makes have standard deviations a
    // hundred times smaller than the others. In float, their variances are hardly above the rounding errors.
    Scalar largest = Scalar(0);
    for (int j = 0; j < Dofs; ++j) largest = std::max(largest, total(j, j));
    for (int j = 0; j < Dofs; ++j) total(j, j) += 16 * Eigen::NumTraits<Scalar>::epsilon() * largest;
    const Cholesky<Scalar, Dofs> factor(total);
    if (!factor.positive_definite()) return -std::numeric_limits<Scalar>::infinity();
    const JointVector<Scalar, Dofs> white = factor.solve_lower(
        detail::difference(innovation, JointVector<Scalar, Dofs>(detail::transposed_product(jacobian, wrench.mean))));
    const Eigen::Matrix<Scalar, Dofs, 6> gain = factor.solve_lower(cross);
    detail::add_scaled(wrench.mean, Scalar(1), detail::transposed_product(gain, white));
    detail::add_scaled(wrench.covariance, Scalar(-1), detail::transposed_product(gain, gain));
    return Scalar(-0.5) * detail::dot(white, white) - factor.log_det_lower();
  }

  Eigen::Matrix<Scalar, 6, 6> any_ = Eigen::Matrix<Scalar, 6, 6>::Zero();  // W
  Wrench wrench_{Vector6<Scalar>::Zero(), any_};
  bool known_ = false;         // whether wrench_ is that of the block before
  Scalar lasted_ = Scalar(0);  // time since it was new [s]
};

}  // namespace rme::bank
