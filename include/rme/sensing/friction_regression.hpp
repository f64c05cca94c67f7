#pragma once
/// Learns the torque of joint friction from a residual torque. In: residual torque and joint velocity. Out: the part of
/// the residual that goes with the direction of motion and with its speed, (T61).
#include <algorithm>
#include <cmath>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Recursive least squares for each joint by itself, with forgetting:
///
///     s = o + c F(dq / (|dq| + 5 mrad/s)) + d F(dq)                                     (docs/theory.md (T61))
///
/// F is the filter of the observer that s comes from. The offset o is learned with the others, since the residual has
/// one, and is not part of the explanation. Real time: nothing allocates or throws.
template <typename Scalar, int Dofs>
class FrictionRegression {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint

  /// @param lag      time constant of the observer's filter [s], >= 0
  /// @param scale    of each joint: size of its offset and noise relative to a Panda's, > 0
  /// @param coulomb  size of its Coulomb friction before anything was learned [N m], > 0
  /// @param viscous  size of its viscous friction before anything was learned [N m s/rad], > 0
  FrictionRegression(double lag, const Vector& scale, const Vector& coulomb, const Vector& viscous) noexcept
      : lag_(static_cast<Scalar>(lag)), noise_(detail::scaled(Scalar(kNoise), scale)) {
    const Vector offset = detail::scaled(Scalar(kOffset), scale);
    for (int j = 0; j < Dofs; ++j)
      prior_[j] = covariance_[j] = Vector3<Scalar>(offset[j], coulomb[j], viscous[j]).cwiseAbs2().asDiagonal();
  }

  /// Advances by one tick.
  /// @param dq  joint velocity [rad/s]
  /// @param dt  time since the last tick [s], > 0
  void update(const Vector& dq, Scalar dt) noexcept {
    const Scalar blend = dt / (dt + lag_);
    for (int j = 0; j < Dofs; ++j) {
      direction_[j] += blend * (dq[j] / (std::abs(dq[j]) + Scalar(kStill)) - direction_[j]);
      velocity_[j] += blend * (dq[j] - velocity_[j]);
      rest_[j] = Scalar(kRest * kRest) / (Scalar(kRest * kRest) + dq[j] * dq[j]);
    }
  }
  /// Torque of the friction [N m].
  Vector torque() const noexcept { return coulomb_.cwiseProduct(direction_) + viscous_.cwiseProduct(velocity_); }
  /// How much each joint rests, 0 to 1.
  const Vector& rest() const noexcept { return rest_; }
  /// Variance of the error of torque() [(N m)^2]: c and d are not known exactly, and the friction of a joint that rests
  /// is anywhere between -c and c. Of a c that has been learned, half of that range is in the residual's mean by then.
  /// @param share  probability that the residual contains friction
  Vector variance(Scalar share) const noexcept {
    Vector out;
    for (int j = 0; j < Dofs; ++j) {
      const Matrix3<Scalar>& P = covariance_[j];
      const Scalar d = direction_[j], v = velocity_[j];
      out[j] = share * (d * d * P(1, 1) + 2 * d * v * P(1, 2) + v * v * P(2, 2)) + stiction(j, share);
    }
    return out;
  }
  /// Learns from a residual in which nothing but the arm shows.
  /// @param residual  s [N m]
  void learn(const Vector& residual) noexcept {
    for (int j = 0; j < Dofs; ++j) {
      const Vector3<Scalar> x(Scalar(1), direction_[j], velocity_[j]);
      Matrix3<Scalar>& P = covariance_[j];
      const Scalar noise = noise_[j] * noise_[j];
      const Vector3<Scalar> gain = detail::product(P, x);
      const Scalar variance = noise + detail::dot(x, gain);
      Scalar e = residual[j] - offset_[j] - coulomb_[j] * direction_[j] - viscous_[j] * velocity_[j];
      const Scalar bound = Scalar(kLargest) * std::sqrt(variance);
      e = std::max(-bound, std::min(bound, e)) / variance;
      offset_[j] += gain[0] * e;
      coulomb_[j] += gain[1] * e;
      viscous_[j] += gain[2] * e;
      detail::add_outer(P, detail::scaled(Scalar(-1) / variance, gain), gain);
      // Old samples count less, but a joint that rests forgets no friction: the covariance returns to the prior's.
      detail::add_scaled(P, Scalar(kForget), detail::difference(prior_[j], P));
    }
  }

 private:
  static constexpr double kStill = 0.005;  // speed at which the direction is half known [rad/s]
  static constexpr double kRest = 0.02;    // speed at which a joint half rests [rad/s]
  static constexpr double kForget = 1e-6;  // share of the prior's covariance that returns with each sample
  static constexpr double kNoise = 0.3;    // of a sample, whose errors last for several samples [N m]
  static constexpr double kLargest = 3;    // bound of an error in standard deviations
  static constexpr double kOffset = 1;     // prior standard deviation of the offset [N m]

  /// Variance of a uniform distribution, if the joint rests.
  Scalar stiction(int j, Scalar share) const noexcept {
    return rest_[j] * (coulomb_[j] * coulomb_[j] / Scalar(12) + share * covariance_[j](1, 1) / Scalar(3));
  }

  Scalar lag_;
  Vector noise_;                                                   // standard deviation of a sample [N m]
  Vector direction_ = Vector::Zero(), velocity_ = Vector::Zero();  // filtered
  Vector rest_ = Vector::Ones();
  Vector offset_ = Vector::Zero(), coulomb_ = Vector::Zero(), viscous_ = Vector::Zero();
  Matrix3<Scalar> prior_[Dofs], covariance_[Dofs];  // of (o, c, d)
};

}  // namespace rme
