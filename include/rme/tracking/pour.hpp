#pragma once
/// A payload whose mass changes at an unknown, nearly constant rate.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/joint_torque_model.hpp>
#include <rme/tracking/payload_belief.hpp>
#include <rme/tracking/rate.hpp>
#include <rme/tracking/star_gaussian.hpp>

namespace rme {

/// What a pour is.
enum class PourKind : std::uint8_t {
  More,     ///< of what is held: a cup is filled, or emptied
  TakenUp,  ///< by an empty hand
  Quick,    ///< taken up within seconds: handed over, or lifted off a table
};

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
    std::array<typename Star::Absorbed, static_cast<std::size_t>(Dofs)> absorbed;
    Scalar precision = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      const JointObservation<Scalar> o = model.observation(j, Load<Scalar, Dofs>());
      typename Star::Beta share;
      Scalar torque = Scalar(0), able = Scalar(0);
      const auto V = star.nuisance_covariance(j);
      for (int n = 0; n < kJointNuisances; ++n) {
        share[n] = V(n, n) * o.c[n];
        able += share[n] * o.c[n];
      }
      for (int i = 0; i < 4; ++i) {
        const Scalar h = model.block().regressor(j, i);
        torque += h * along[i];
        for (int n = 0; n < kJointNuisances; ++n)
          absorbed[static_cast<std::size_t>(j)](i, n) = -share[n] * h / (able + o.noise);
      }
      precision += torque * torque / (able + o.noise);
    }
    const Scalar square = Scalar(1) / std::max(precision, Scalar(1e-6));  // of what one standard deviation hides
    PayloadPrior<Scalar> hidden = prior;
    hidden.mass_std = Scalar(kHidden) * std::sqrt(square);
    star.suppose_payload(hidden.factor(Scalar(kAside * kAside) * square), absorbed);
  }
  /// A pour that nothing is known of.
  /// @param star           state; from here on it has what is poured as unknowns of its own
  /// @param prior          of what may be held
  /// @param rated_payload  [kg]
  /// @param kind           what it is
  void begin(Star& star, const PayloadPrior<Scalar>& prior, Scalar rated_payload, PourKind kind) noexcept {
    kind_ = kind;
    star.extend(Star::Last::Poured);
    rate_ = {};
    square_arm_ = prior.square_arm();
    rate_.covariance = stationary(centre(star, prior, rated_payload), prior, rated_payload);
  }
  /// Time update of the rate, an Ornstein-Uhlenbeck process about zero, and of the payload, which it changes.
  /// @param star           state; an empty hand begins to hold something
  /// @param duration       of the block [s]
  /// @param prior          of what may be held
  /// @param rated_payload  [kg]
  void predict(Star& star, Scalar duration, const PayloadPrior<Scalar>& prior, Scalar rated_payload) noexcept {
    using std::exp;
    const Vector3<Scalar> r = centre(star, prior, rated_payload);
    const Matrix4<Scalar> noise = stationary(r, prior, rated_payload);
    const Scalar keep = exp(-duration / Scalar(quick() ? kQuickTime : kRateTime));
    rate_.mean *= keep;
    rate_.cross *= keep;
    rate_.covariance *= keep * keep;
    detail::add_scaled(rate_.covariance, Scalar(1) - keep * keep, noise);
    const Matrix4<Scalar> flow = detail::scaled(duration * Scalar(quick() ? kQuickFlowTime : kFlowTime), noise);
    if (kind_ == PourKind::More)
      rate_.drift(star, duration, flow, follows(star, duration, r));
    else
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
  static constexpr double kAside = 1.5;  // the same of the mass whose centre is not the prior's
  static constexpr double kRate = 0.03;  // standard deviation of the rate of mass per rated payload [1/s]
  static constexpr double kQuickRate = 1, kQuickTime = 0.5;  // the same of what is taken up quickly
  static constexpr double kRateTime = 3;                     // correlation time of the rate [s]
  static constexpr double kFlowTime = 0.02;  // the flow's own noise: what flows at kRate in this time, each time [s]
  static constexpr double kQuickFlowTime = 0.002;  // the same of what is taken up quickly
  static constexpr double kSpread = 0.4;      // spread of more of what is held about the payload's centre, in com_std
  static constexpr double kLightest = 0.007;  // mass from which the payload's centre is known, per rated payload

  bool quick() const noexcept { return kind_ == PourKind::Quick; }
  /// Centre of mass of what is held, as far as it is plausible [m].
  static Vector3<Scalar> centre(const Star& star, const PayloadPrior<Scalar>& prior, Scalar rated) noexcept {
    const InertialVector<Scalar> phi = star.payload_mean();
    Vector3<Scalar> r = prior.com_mean;
    for (int i = 0; i < 3 && phi[0] > Scalar(kLightest) * rated; ++i) {
      const Scalar most = 3 * prior.com_std[i];
      r[i] += std::max(-most, std::min(most, phi[1 + i] / phi[0] - prior.com_mean[i]));
    }
    return r;
  }
  /// Covariance of the rate before anything is known of it: along (1, r), and about it.
  Matrix4<Scalar> stationary(const Vector3<Scalar>& r, const PayloadPrior<Scalar>& prior, Scalar rated) const noexcept {
    const Scalar sigma = Scalar(quick() ? kQuickRate : kRate) * rated;
    Vector4<Scalar> along;
    along[0] = sigma;
    for (int i = 0; i < 3; ++i) along[1 + i] = sigma * r[i];
    Matrix4<Scalar> out = detail::outer_square(along);
    for (int i = 0; i < 3; ++i) {
      const Scalar s = Scalar(kind_ == PourKind::More ? kSpread : 1) * prior.com_std[i] * sigma;
      out(1 + i, 1 + i) += s * s;
    }
    return out;
  }
  /// More of what is held has the same centre of mass, whatever that is: an error of the payload's goes with it
  /// (docs/theory.md (T74)).
  /// @param r  the centre [m]
  typename Star::Cross follows(const Star& star, Scalar duration, const Vector3<Scalar>& r) const noexcept {
    typename Star::Cross out = Star::Cross::Zero();
    const Scalar before = star.mean()[kPayload];  // the pour began
    if (!(before > 0)) return out;
    const Scalar share = duration * rate_.mean[0] * before / (before * before + star.variance(kPayload));
    for (int i = 0; i < 3; ++i) {
      out(kPayload + 1 + i, 1 + i) = share;
      out(kPayload, 1 + i) = -share * r[i];
    }
    return out;
  }
  /// Variance of each entry of the inertia of what has been poured.
  Scalar inertia_variance(const Star& star) const noexcept {
    const Scalar mass = star.poured_mass();
    return square_arm_ * square_arm_ * (mass * mass + star.variance(kPoured));
  }
  PourKind kind_ = PourKind::More;
  Rate<Scalar, Dofs> rate_;
  Scalar square_arm_ = Scalar(0);  // E[|r|^2] of what may be held [m^2]
};

}  // namespace rme
