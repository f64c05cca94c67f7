#pragma once
/// A hand's wrench on the flange, followed from block to block.
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/core/cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// How likely a block's torque is if a wrench w acts beside what is held (docs/theory.md (T48)). A wrench that is new
/// may be any: w ~ N(0, W). One that goes on is nearly what it was in the block before, so that its six unknowns lower
/// the evidence once, as a payload's do: a push that lasts and a payload that does not quite fit are then told apart by
/// what fits better. Once a second it is taken to be new in any case, so that a payload that was taken for a push has a
/// chance against it.
///
/// Real time: O(Dofs^3), no allocation.
template <typename Scalar, int Dofs>
class PushFilter {
 public:
  using Covariance = Eigen::Matrix<Scalar, Dofs, Dofs>;  ///< of a block's torque

  /// @param rated_payload  [kg], > 0: pushes grow with what the arm lifts, 4 N and 0.5 N m for each kilogram
  explicit PushFilter(Scalar rated_payload) noexcept {
    const Scalar force = 4 * rated_payload, moment = Scalar(0.5) * rated_payload;
    for (int i = 0; i < 6; ++i) any_(i, i) = i < 3 ? force * force : moment * moment;
  }

  /// Takes in a block.
  /// @param innovation  e of its torque, if nobody pushed [N m]
  /// @param covariance  S of e [(N m)^2]
  /// @param jacobian    6xDofs
  /// @param duration    of the block [s]
  /// @param goes_on     P(the block before was pushed as well, given that this one is), 0 to 1
  /// @return log N(e; J^T w, S + J^T cov(w) J) without its factor of 2 pi; minus infinity if S is not positive definite
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
  void forget() noexcept { known_ = false; }  ///< nobody pushes

 private:
  static constexpr double kStays = 0.9;  // in a block: hands grasp anew, and let go
  // Of W's deviations, in 20 ms: a hand trembles, and following it must not explain noise better than an empty hand
  // does.
  static constexpr double kChange = 0.1;
  static constexpr double kLongest = 1;  // that a wrench is taken for granted [s]

  struct Wrench {  // world axes, at the end-effector origin [N, N m]
    Vector6<Scalar> mean;
    Eigen::Matrix<Scalar, 6, 6> covariance;
  };

  void begin(const Wrench& wrench) noexcept {
    wrench_ = wrench;
    known_ = true;
    lasted_ = Scalar(0);
  }
  /// @return log likelihood of the block
  static Scalar observe(Wrench& wrench, const JointVector<Scalar, Dofs>& innovation, const Covariance& covariance,
                        const Jacobian<Scalar, Dofs>& jacobian) noexcept {
    const Eigen::Matrix<Scalar, Dofs, 6> cross = detail::transposed_product(jacobian, wrench.covariance);
    Covariance total = detail::product(cross, jacobian);
    total += covariance;
    // What rounding may take off a pivot: torques that no wrench makes are known a hundred times better than those
    // that one does, which is as far as a float's square reaches.
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
  bool known_ = false;         // that of the block before
  Scalar lasted_ = Scalar(0);  // since it was new [s]
};

}  // namespace rme
