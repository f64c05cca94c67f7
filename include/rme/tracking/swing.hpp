#pragma once
/// A payload that swings: it hangs, or the grip is soft.
#include <algorithm>
#include <cmath>
#include <rme/core/singular_cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/rate.hpp>
#include <rme/tracking/star_gaussian.hpp>

namespace rme {

/// The force of a swing, with which a payload pulls at the hand in addition to its weight and its inertia. Its mean is
/// zero, so what the hand holds is learned all the same. In each direction it changes at a rate of its own
/// (docs/theory.md (T55)),
///
///     df/dt = r,   dr/dt = -L^2 f - 2 L r + noise
///
/// f is part of the star's x, r a Gaussian that is correlated with x. Their size is learned.
///
/// Until it ends, nothing is learned of the tool: new force couples the joints, and what a star loses of that would let
/// the tool drift against the joints' offsets. In the tool's place in x there is what a hand that leads the arm carries
/// of the payload, or adds to it: like an error of the tool, of which the joints' offsets have taken over what showed
/// so far. Real time: nothing allocates.
template <typename Scalar, int Dofs>
class Swing {
 public:
  using Star = StarGaussian<Scalar, Dofs>;  ///< state of the filter

  /// A swing that nothing is known of.
  /// @param star    state, in which nothing is poured; from here on it has the force as an unknown of its own
  /// @param weight  of the payload [N], > 0
  /// @param goes    whether it has begun before; otherwise the force is 0 at first
  /// @param led     variance of what a hand that leads the arm carries, (m, m r) [kg^2, (kg m)^2]
  void begin(Star& star, Scalar weight, bool goes, const Vector4<Scalar>& led) noexcept {
    const Scalar force = Scalar(kForce) * weight;
    *this = Swing();
    variance_.setConstant(force * force);
    SharedMatrix<Scalar> factor = star.factor();
    for (int i = 0; i < 4; ++i) {
      tool_mean_[i] = star.mean()[kTool + i];
      tool_variance_[i] = star.variance(kTool + i);
      for (int k = 0; k < kShared; ++k) factor(kTool + i, k) = Scalar(0);
    }
    if (led[0] > 0) {
      SharedMatrix<Scalar> total = detail::outer_square(factor);
      for (int i = 0; i < 4; ++i) total(kTool + i, kTool + i) = led[i];
      if (const SingularCholesky<Scalar, kShared> carried(total); carried.finite()) factor = carried.lower();
    }
    for (int i = 0; i < 3; ++i) factor(kSwing + i, kSwing + i) = goes ? force : Scalar(0);
    star.set_shared(star.mean(), factor);
    star.extend(Star::Last::Force);
    for (int i = 0; i < 3; ++i) rate_.covariance(i, i) = Scalar(kReturn * kReturn) * variance_[i];
  }
  /// Time update of the force and of its rate.
  /// @param star      state
  /// @param duration  of the block [s]
  void predict(Star& star, Scalar duration) noexcept {
    // (f, r) <- A (f, r) + noise, A = [stays gains; pulls keeps] e^(-L T), whose stationary covariance is s (1, L^2).
    const Scalar L = Scalar(kReturn), T = duration, fade = std::exp(-L * T);
    const Scalar stays = fade * (1 + L * T), gains = fade * T, pulls = -fade * L * L * T, keeps = fade * (1 - L * T);
    const Scalar again = pulls / stays;  // of f after the update, in its rate
    const SharedMatrix<Scalar> before = star.covariance();
    Matrix4<Scalar> after = Matrix4<Scalar>::Zero(), noise = after;
    Vector4<Scalar> mixed = Vector4<Scalar>::Zero();  // cov(noise of f, noise of r)
    for (int i = 0; i < 3; ++i) {
      const Scalar s = variance_[i];
      noise(i, i) = s * (1 - stays * stays - L * L * gains * gains);
      mixed[i] = -s * (stays * pulls + L * L * gains * keeps);
      after(i, i) = s * (L * L - pulls * pulls - L * L * keeps * keeps);
    }
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k)
        after(i, k) += pulls * pulls * before(kSwing + i, kSwing + k) + keeps * keeps * rate_.covariance(i, k) +
                       pulls * keeps * (rate_.cross(kSwing + i, k) + rate_.cross(kSwing + k, i));
    Vector4<Scalar> mean = detail::scaled(keeps, rate_.mean);
    for (int i = 0; i < 3; ++i) mean[i] += pulls * star.mean()[kSwing + i];
    star.scale_last(stays);
    for (int i = 0; i < 3; ++i)
      for (int k = 0; k < 3; ++k) rate_.cross(kSwing + i, k) *= stays;
    rate_.drift(star, gains, noise);
    // r = again f + (keeps - again gains) r_before + noise, with f after the update.
    const SharedMatrix<Scalar> total = star.covariance();
    rate_.cross *= keeps - again * gains;
    for (int k = 0; k < 3; ++k) {
      for (int i = 0; i < kShared; ++i) rate_.cross(i, k) += again * total(i, kSwing + k);
      rate_.cross(kSwing + k, k) += mixed[k] - again * noise(k, k);
    }
    rate_.mean = mean;
    rate_.covariance = after;
  }
  /// The payload swings no more: marginalises the force, and what a hand carries. What is known of the tool is as it
  /// was before the swing.
  void end(Star& star) const noexcept {
    if (!star.swings()) return;
    SharedVector<Scalar> mean = star.mean();
    SharedMatrix<Scalar> factor = star.factor();
    for (int i = 0; i < 4; ++i) {  // the joints' nuisances are what they are without such a hand
      mean[kTool + i] = tool_mean_[i];
      for (int k = 0; k < kShared; ++k) factor(kTool + i, k) = Scalar(0);
    }
    star.set_shared(mean, factor);
    star.forget_last();
    Eigen::Matrix<Scalar, kArmShared, 1> variance = Eigen::Matrix<Scalar, kArmShared, 1>::Zero();
    for (int i = 0; i < 4; ++i) variance[kTool + i] = tool_variance_[i];
    star.widen_arm(variance);
  }
  /// Mean of the tool error, (m, m r), as it was before the swing [kg, kg m].
  const Vector4<Scalar>& tool_mean() const noexcept { return tool_mean_; }
  /// Updates the rate with an observation; to be called before star.observe(j, p).
  void observe(const Star& star, const typename Star::Prediction& p) noexcept { rate_.observe(star, p); }
  /// Learns the size of the swing and its frequency. The size is that of the rate: a force that stays belongs to the
  /// payload.
  /// @param star      state, after the block
  /// @param duration  of the block [s]
  /// @param weight    of the payload [N], > 0
  void learn(const Star& star, Scalar duration, Scalar weight) noexcept {
    const Scalar share = Scalar(1) - std::exp(-duration / Scalar(kMemory));
    const Scalar slow = Scalar(1) - std::exp(-duration / Scalar(kMiddle));
    const Scalar least = Scalar(kLeast) * weight, most = Scalar(kMost) * weight;
    int axis = 0;
    Vector3<Scalar> off;
    for (int i = 0; i < 3; ++i) {
      const Scalar square = (rate_.mean[i] * rate_.mean[i] + rate_.covariance(i, i)) / Scalar(kReturn * kReturn);
      variance_[i] += share * (square - variance_[i]);
      variance_[i] = std::max(least * least, std::min(most * most, variance_[i]));
      off[i] = star.mean()[kSwing + i] - middle_[i];
      middle_[i] += slow * off[i];
      moves_[i] += slow * (off[i] * off[i] - moves_[i]);
      if (moves_[i] > moves_[axis]) axis = i;
    }
    since_ += duration;
    if (off[axis] * off[axis] < Scalar(kEdge * kEdge) * moves_[axis]) return;
    const int side = off[axis] > 0 ? 1 + axis : -1 - axis;
    if (side == side_) return;
    if (side == -side_ && turns_ > 0) half_ = half_ > 0 ? half_ + Scalar(kNewest) * (since_ - half_) : since_;
    turns_ = side == -side_ ? 1 : 0;
    side_ = side;
    since_ = Scalar(0);
  }
  /// Whether the force has had both signs. A force that only grows may be a touch.
  bool shown() const noexcept { return half_ > 0; }
  /// Mean square of the force in each direction in the last second [N^2], world axes; 0 until it is shown().
  Vector3<Scalar> square() const noexcept { return shown() ? moves_ : Vector3<Scalar>(Vector3<Scalar>::Zero()); }
  /// Frequency of the swing, from the times between its turns; 0 until it is shown() [Hz].
  Scalar frequency() const noexcept { return shown() ? Scalar(0.5) / half_ : Scalar(0); }

  /// Mean square of the relative error that a swing has caused in a payload before it was noticed. One that has been
  /// there for longer would have been noticed.
  /// @param held_for  since the payload was drawn [s]
  static Scalar hidden(Scalar held_for) noexcept {
    return Scalar(kHidden * kHidden) * std::exp(-held_for / Scalar(kUnnoticed));
  }
  /// Whether a swing that begins now may be a hand that leads the arm: it does not belong to the pick-up.
  /// @param held_for  since the payload was drawn [s]
  static bool may_be_led(Scalar held_for) noexcept { return held_for > Scalar(kPickUp); }
  /// Variance of what a hand that leads the arm carries of a payload, (m, m r) [kg^2, (kg m)^2].
  /// @param held_for  since the payload was drawn [s]
  /// @param mass      of the payload [kg]
  static Vector4<Scalar> led(Scalar held_for, Scalar mass) noexcept {
    const Scalar square = may_be_led(held_for) ? mass * mass : Scalar(0);
    Vector4<Scalar> out = Vector4<Scalar>::Constant(square * Scalar(kLedArm * kLedArm));
    out[0] = square * Scalar(kLed * kLed);
    return out;
  }

 private:
  static constexpr double kForce = 0.1;   // standard deviation of the force in each direction at first, per weight
  static constexpr double kReturn = 20;   // L, how quickly the force returns to zero [1/s]
  static constexpr double kMemory = 0.3;  // time constant with which the size is learned [s]
  static constexpr double kLeast = 0.01, kMost = 0.1;   // bounds of the size, per weight
  static constexpr double kHidden = 0.03;               // relative error of a payload that swings unnoticed
  static constexpr double kUnnoticed = 0.3;             // for how long a swing stays unnoticed [s]
  static constexpr double kPickUp = 1;                  // how long a swing may belong to the pick-up [s]
  static constexpr double kLed = 0.3, kLedArm = 0.1;    // what a hand carries: share of the payload; at [m]
  static constexpr double kMiddle = 1;                  // memory of the middle of the swing [s]
  static constexpr double kEdge = 0.3;                  // distance from it where a side begins, in standard deviations
  static constexpr double kNewest = 0.3;                // share of the newest half period in the frequency
  Vector3<Scalar> variance_ = Vector3<Scalar>::Zero();  // size: of the force in each direction [N^2], world axes
  Vector4<Scalar> tool_mean_ = Vector4<Scalar>::Zero(), tool_variance_ = Vector4<Scalar>::Zero();  // before it swung
  Rate<Scalar, Dofs> rate_;                           // r [N/s]; its fourth entry is 0
  Vector3<Scalar> middle_ = Vector3<Scalar>::Zero();  // mean of the force's estimate in the last second [N]
  Vector3<Scalar> moves_ = Vector3<Scalar>::Zero();   // its variance [N^2]
  Scalar since_ = Scalar(0), half_ = Scalar(0);       // time since the last turn, and half the period; 0: unknown [s]
  int side_ = 0, turns_ = 0;  // on which side it is: 1 + axis, or minus that; whether the last side was the other one
};

}  // namespace rme
