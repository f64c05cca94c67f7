#pragma once
/// A payload whose mass changes at an unknown, nearly constant rate.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/joint_torque_model.hpp>
#include <rme/tracking/payload_belief.hpp>
#include <rme/tracking/rate.hpp>
#include <rme/tracking/star_gaussian.hpp>

namespace rme {

/// The rate of (m, m r), part of the state of a filter while something is poured (docs/theory.md (T22)): a Gaussian
/// that is correlated with the star's x. Real time: nothing allocates.
template <typename Scalar, int Dofs>
class Pour {
 public:
  using Star = StarGaussian<Scalar, Dofs>;  ///< state of the filter

  /// A payload that is taken up slowly is taken for friction and offset at first. Supposes that the empty hand of
  /// `star` already holds as much as they can have hidden so far.
  /// @param model  of the arm
  /// @param star   state, with an empty hand
  /// @param prior  of what may be held
  static void suppose_hidden(const JointTorqueModel<Scalar, Dofs>& model, Star& star,
                             const PayloadPrior<Scalar>& prior) noexcept {
    Vector4<Scalar> along;
    along[0] = 1;
    for (int i = 0; i < 3; ++i) along[1 + i] = prior.com_mean[i];
    std::array<typename Star::Beta, static_cast<std::size_t>(Dofs)> shift;
    Scalar precision = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      const JointObservation<Scalar> o = model.observation(j, Load<Scalar, Dofs>());
      Scalar torque = Scalar(0), able = Scalar(0);
      for (int i = 0; i < 4; ++i) torque += model.block().regressor(j, i) * along[i];
      auto& absorbed = shift[static_cast<std::size_t>(j)];
      const auto V = star.nuisance_covariance(j);
      for (int n = 0; n < kJointNuisances; ++n) {
        absorbed[n] = V(n, n) * o.c[n];
        able += absorbed[n] * o.c[n];
      }
      absorbed *= -torque / (able + o.noise);
      precision += torque * torque / (able + o.noise);
    }
    const Scalar mass = Scalar(kHidden) / std::sqrt(std::max(precision, Scalar(1e-6)));
    for (auto& s : shift) s *= mass;
    star.suppose_payload(detail::scaled(mass, along), mass * prior.square_arm(), shift);
  }
  /// A pour that nothing is known of.
  /// @param star           state; from here on it has what is poured as unknowns of its own
  /// @param prior          of what may be held
  /// @param rated_payload  [kg]
  /// @param quick          it is taken up within seconds: handed over, or lifted off a table
  void begin(Star& star, const PayloadPrior<Scalar>& prior, Scalar rated_payload, bool quick) noexcept {
    quick_ = quick;
    star.extend(Star::Last::Poured);
    rate_ = {};
    square_arm_ = prior.square_arm();
    rate_.covariance = stationary(star, prior, rated_payload);
  }
  /// Time update of the rate, an Ornstein-Uhlenbeck process about zero, and of the payload, which it changes.
  /// @param star           state; an empty hand begins to hold something
  /// @param duration       of the block [s]
  /// @param prior          of what may be held
  /// @param rated_payload  [kg]
  void predict(Star& star, Scalar duration, const PayloadPrior<Scalar>& prior, Scalar rated_payload) noexcept {
    using std::exp;
    const Matrix4<Scalar> noise = stationary(star, prior, rated_payload);
    const Scalar keep = exp(-duration / Scalar(quick_ ? kQuickTime : kRateTime));
    rate_.mean *= keep;
    rate_.cross *= keep;
    rate_.covariance *= keep * keep;
    detail::add_scaled(rate_.covariance, Scalar(1) - keep * keep, noise);
    const Matrix4<Scalar> flow = detail::scaled(duration * Scalar(quick_ ? kQuickFlowTime : kFlowTime), noise);
    rate_.drift(star, duration, flow);
  }
  /// Updates the rate with an observation; to be called before star.observe(j, p).
  void observe(const Star& star, const typename Star::Prediction& p) noexcept { rate_.observe(star, p); }
  /// What is held some time after the middle of the last block, if it pours on as it does.
  /// @param star  state
  /// @param time  since then [s]
  InertialGaussian<Scalar> payload_after(const Star& star, Scalar time) const noexcept {
    InertialGaussian<Scalar> out{star.payload_mean(), star.payload_covariance()};
    for (int k = 0; k < 4; ++k) {
      out.mean[k] += time * rate_.mean[k];
      for (int i = 0; i < kInertial; ++i) {  // cov(phi, rate)
        const Scalar cross = rate_.cross(kPayload + i, k) + (i < 4 ? rate_.cross(kPoured + i, k) : Scalar(0));
        out.covariance(i, k) += time * cross;
        out.covariance(k, i) += time * cross;
      }
      for (int i = 0; i < 4; ++i) out.covariance(i, k) += time * time * rate_.covariance(i, k);
    }
    const Scalar entry = inertia_variance(star);
    for (int i = 4; i < kInertial; ++i) out.covariance(i, i) += entry;
    return out;
  }
  Scalar rate() const noexcept { return rate_.mean[0]; }  ///< of the mass [kg/s]
  /// What has been poured so far becomes part of the payload's phi. Each beta_j keeps its moments with it. Nothing is
  /// known of the inertia of what was poured but its size: that of the mass (docs/theory.md (T72)).
  void end(Star& star) const noexcept {
    if (star.last() != Star::Last::Poured) return;
    const Scalar entry = inertia_variance(star);
    star.merge_poured();
    star.template widen<kPayload + 4, kInertial - 4>(Eigen::Matrix<Scalar, kInertial - 4, 1>::Constant(entry));
  }

 private:
  static constexpr double kHidden = 3;   // standard deviations of all joints together that may hide a payload
  static constexpr double kRate = 0.03;  // standard deviation of the rate of mass per rated payload [1/s]
  static constexpr double kQuickRate = 1, kQuickTime = 0.5;  // the same of what is taken up quickly
  static constexpr double kRateTime = 3;                     // correlation time of the rate [s]
  static constexpr double kFlowTime = 0.02;  // the flow's own noise: what flows at kRate in this time, each time [s]
  static constexpr double kQuickFlowTime = 0.002;  // the same of what is taken up quickly
  static constexpr double kSpread = 0.7;           // spread of what is poured about the payload's centre, in com_std

  /// Covariance of the rate before anything is known of it: along the payload's own (m, m r), and about it.
  Matrix4<Scalar> stationary(const Star& star, const PayloadPrior<Scalar>& prior, Scalar rated) const noexcept {
    const Scalar sigma = sigma_of() * rated, held = star.mass();
    const InertialVector<Scalar> phi = star.payload_mean();
    Vector4<Scalar> along;
    along[0] = sigma;
    for (int i = 0; i < 3; ++i) {
      const Scalar off = 3 * prior.com_std[i];
      const Scalar com = held > Scalar(kLightest) * rated ? phi[1 + i] / held - prior.com_mean[i] : Scalar(0);
      along[1 + i] = sigma * (prior.com_mean[i] + std::max(-off, std::min(off, com)));
    }
    Matrix4<Scalar> out = Matrix4<Scalar>::Zero();
    detail::add_outer(out, along, along);
    for (int i = 0; i < 3; ++i) {
      const Scalar s = Scalar(kSpread) * prior.com_std[i] * sigma;
      out(1 + i, 1 + i) += s * s;
    }
    return out;
  }
  static constexpr double kLightest = 0.007;  // mass from which the payload's centre is known, per rated payload

  /// Variance of each entry of the inertia of what has been poured.
  Scalar inertia_variance(const Star& star) const noexcept {
    const Scalar mass = star.poured_mass();
    return square_arm_ * square_arm_ * (mass * mass + star.variance(kPoured));
  }
  Scalar sigma_of() const noexcept { return static_cast<Scalar>(quick_ ? kQuickRate : kRate); }
  bool quick_ = false;
  Rate<Scalar, Dofs> rate_;
  Scalar square_arm_ = Scalar(0);  // E[|r|^2] of what may be held [m^2]
};

}  // namespace rme
