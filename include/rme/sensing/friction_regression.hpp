#pragma once
/// Learns the torque of joint friction from a residual torque. In: residual torque and joint velocity. Out: the part of the
/// residual that goes with the direction of motion and with its speed, (T61).
#include <algorithm>
#include <cmath>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Recursive least squares for each joint by itself, with forgetting:
///
///     s = o + c F(dq / (|dq| + 5 mrad/s)) + d F(dq)                                     (docs/theory.md (T61))
///
/// F is the filter of the observer that s comes from. The offset o is learned with the others, since the residual has one,
/// and is not part of the explanation. Real time: nothing allocates or throws.
template <typename Scalar, int Dofs>
class FrictionRegression {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint

  /// @param lag    time constant of the observer's filter [s], >= 0
  /// @param scale  of each joint: size of its friction relative to a Panda's, > 0
  FrictionRegression(double lag, const Vector& scale) noexcept : lag_(static_cast<Scalar>(lag)), scale_(scale) {
    for (int j = 0; j < Dofs; ++j) covariance_[j] = prior(j);
  }

  /// Advances by one tick.
  /// @param dq  joint velocity [rad/s]
  /// @param dt  time since the last tick [s], > 0
  void update(const Vector& dq, Scalar dt) noexcept {
    const Scalar blend = dt / (dt + lag_);
    for (int j = 0; j < Dofs; ++j) {
      direction_[j] += blend * (dq[j] / (std::abs(dq[j]) + Scalar(kStill)) - direction_[j]);
      velocity_[j] += blend * (dq[j] - velocity_[j]);
    }
  }
  /// Torque of the friction [N m].
  Vector torque() const noexcept { return coulomb_.cwiseProduct(direction_) + viscous_.cwiseProduct(velocity_); }
  /// Coulomb friction of each joint [N m].
  const Vector& coulomb() const noexcept { return coulomb_; }
  /// Learns from a residual in which nothing but the arm shows.
  /// @param residual  s [N m]
  void learn(const Vector& residual) noexcept {
    for (int j = 0; j < Dofs; ++j) {
      const Vector3<Scalar> x(Scalar(1), direction_[j], velocity_[j]);
      Matrix3<Scalar>& P = covariance_[j];
      const Scalar noise = Scalar(kNoise * kNoise) * scale_[j] * scale_[j];
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
      detail::add_scaled(P, Scalar(kForget), detail::difference(prior(j), P));
    }
  }

 private:
  static constexpr double kStill = 0.005;  // speed at which the direction is half known [rad/s]
  static constexpr double kForget = 1e-6;  // share of the prior's covariance that returns with each sample
  static constexpr double kNoise = 0.3;    // of a sample, whose errors last for several samples [N m]
  static constexpr double kLargest = 3;    // bound of an error in standard deviations
  static constexpr double kOffset = 1, kCoulomb = 1, kViscous = 0.5;  // prior standard deviations [N m], [N m s/rad]

  Matrix3<Scalar> prior(int j) const noexcept {
    Matrix3<Scalar> P = Matrix3<Scalar>::Zero();
    const Scalar square = scale_[j] * scale_[j];
    P(0, 0) = Scalar(kOffset * kOffset) * square;
    P(1, 1) = Scalar(kCoulomb * kCoulomb) * square;
    P(2, 2) = Scalar(kViscous * kViscous) * square;
    return P;
  }

  Scalar lag_;
  Vector scale_;
  Vector direction_ = Vector::Zero(), velocity_ = Vector::Zero();  // filtered
  Vector offset_ = Vector::Zero(), coulomb_ = Vector::Zero(), viscous_ = Vector::Zero();
  Matrix3<Scalar> covariance_[Dofs];
};

}  // namespace rme
