#pragma once
/// The Gaussian of one filter: a payload's inertial parameters, and what else each joint's torque contains.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/inertial_parameters.hpp>

namespace rme {

/// What a joint's torque contains besides the payload's; the order of every nuisance vector.
enum Nuisance : int {
  kOffset,   ///< of the torque sensor [N m]
  kCoulomb,  ///< friction of a moving joint, against its motion [N m]
  kViscous,  ///< the same per joint velocity [N m s/rad]
  kLag =
      kViscous,  ///< of a sensor that sees no friction, in place of it: tau_ext minus lag times its rate is in time [s]
  kResidual,     ///< of the arm's rigid-body model: wanders as the arm moves [N m]
  kStiction,     ///< friction torque of a resting joint [N m]
};
inline constexpr int kJointNuisances = 5;  ///< enumerators of Nuisance

template <typename Scalar>
using JointNuisanceVector = Eigen::Matrix<Scalar, kJointNuisances, 1>;  ///< beta_j, in the order of Nuisance
template <typename Scalar>
using JointNuisanceMatrix = Eigen::Matrix<Scalar, kJointNuisances, kJointNuisances>;  ///< covariance of beta_j

/// y = h^T phi + c^T beta_j + noise: the torque of one joint, averaged over a block of samples (docs/theory.md (T14)).
template <typename Scalar>
struct JointObservation {
  Scalar torque;                  ///< y [N m]
  InertialVector<Scalar> h;       ///< regressor of phi
  JointNuisanceVector<Scalar> c;  ///< regressor of the joint's nuisances
  Scalar noise;                   ///< variance [(N m)^2], > 0
};

/// N over phi and beta_1 .. beta_n, the joints' nuisances, in the form of a star: given phi, the joints are
/// independent,
///
///     phi ~ N(mean, F F^T),   beta_j | phi ~ N(b_j + B_j phi, V_j)
///
/// A joint's torque depends only on phi and on its own beta, so that observe() keeps this form exactly, at a
/// fifth of what a dense covariance costs. replace_payload(), diffuse() and mix() would couple the joints: each gives
/// the nearest star, which has the right moments of phi and every beta_j, pair by pair (docs/theory.md, "The star"; the
/// form is (T15)).
///
/// F is a square root of the covariance and is updated as such (Potter's form: Maybeck, Stochastic Models, Estimation,
/// and Control 1, 7.3), so that the covariance cannot lose its positive definiteness to rounding, in float either.
/// Real time: no call allocates.
template <typename Scalar, int Dofs>
class StarGaussian {
 public:
  using Phi = InertialVector<Scalar>;                               ///< 10x1
  using PhiMatrix = InertialMatrix<Scalar>;                         ///< 10x10
  using Beta = JointNuisanceVector<Scalar>;                         ///< 5x1
  using BetaMatrix = JointNuisanceMatrix<Scalar>;                   ///< 5x5
  using Slope = Eigen::Matrix<Scalar, kInertial, kJointNuisances>;  ///< 10x5
  /// beta_j given phi.
  struct Joint {
    Beta mean = Beta::Zero();                    ///< b_j
    Slope slope = Slope::Zero();                 ///< B_j^T
    BetaMatrix covariance = BetaMatrix::Zero();  ///< V_j
  };

  const Phi& mean() const noexcept { return mean_; }  ///< of phi
  /// F F^T of phi.
  PhiMatrix covariance() const noexcept { return detail::outer_square(factor_); }
  /// Variance of the mass [kg^2].
  Scalar mass_variance() const noexcept {
    Scalar sum = Scalar(0);
    for (int k = 0; k < kInertial; ++k) sum += factor_(0, k) * factor_(0, k);
    return sum;
  }
  /// Joint j, 0 .. Dofs - 1.
  Joint& joint(int j) noexcept { return joints_[static_cast<std::size_t>(j)]; }
  /// Joint j, 0 .. Dofs - 1.
  const Joint& joint(int j) const noexcept { return joints_[static_cast<std::size_t>(j)]; }
  /// Mean of beta_j, whatever phi is.
  Beta nuisance_mean(int j) const noexcept {
    Beta mean = joint(j).mean;
    if (!empty_) mean += detail::transposed_product(joint(j).slope, mean_);
    return mean;
  }
  /// Covariance of beta_j, whatever phi is.
  BetaMatrix nuisance_covariance(int j) const noexcept {
    BetaMatrix V = joint(j).covariance;
    if (empty_) return V;
    const Slope spread = detail::transposed_product(factor_, joint(j).slope);
    V += detail::transposed_product(spread, spread);
    return V;
  }

  /// Whether all of it is finite: numbers that no arm reports may overflow, in float above all.
  bool finite() const noexcept {
    bool good = detail::finite(mean_) && detail::finite(factor_);
    for (const Joint& joint : joints_)
      good = good && detail::finite(joint.mean) && detail::finite(joint.slope) && detail::finite(joint.covariance);
    return good;
  }

  /// What an observation is expected to be.
  struct Prediction {
    Scalar innovation;         ///< e = y - E[y]
    Scalar variance;           ///< S of e
    Scalar given_payload;      ///< variance of y for a known phi, noise included
    Phi gain_row;              ///< h + B_j^T c: how y depends on phi, the nuisances' share included
    Phi spread;                ///< F^T gain_row
    Beta nuisance_spread;      ///< V_j c
    Scalar conditional_error;  ///< y - c^T b_j
  };
  /// What is expected of the torque of joint j (docs/theory.md (T16)).
  Prediction predict(int j, const JointObservation<Scalar>& o) const noexcept {
    const Joint& joint = this->joint(j);
    Prediction p;
    p.gain_row = o.h;
    if (empty_) {
      p.spread.setZero();
    } else {
      p.gain_row += detail::product(joint.slope, o.c);
      p.spread = detail::transposed_product(factor_, p.gain_row);
    }
    p.nuisance_spread = detail::product(joint.covariance, o.c);
    p.given_payload = detail::dot(o.c, p.nuisance_spread) + o.noise;
    p.variance = detail::dot(p.spread, p.spread) + p.given_payload;
    p.conditional_error = o.torque - detail::dot(o.c, joint.mean);
    p.innovation = p.conditional_error - detail::dot(p.gain_row, mean_);
    return p;
  }
  /// Takes the observation in (docs/theory.md (T17, T18)). `p` is what predict() said of it.
  void observe(int j, const Prediction& p) noexcept {
    using std::sqrt;
    Joint& joint = this->joint(j);
    const Beta minus_gain = detail::scaled(Scalar(-1) / p.given_payload, p.nuisance_spread);
    if (!empty_) {
      const Phi covariance_row = detail::product(factor_, p.spread);
      detail::add_scaled(mean_, p.innovation / p.variance, covariance_row);
      const Scalar shrink = Scalar(1) / (p.variance * (Scalar(1) + sqrt(p.given_payload / p.variance)));
      detail::add_outer(factor_, detail::scaled(-shrink, covariance_row), p.spread);
      detail::add_outer(joint.slope, p.gain_row, minus_gain);
    }
    detail::add_scaled(joint.mean, -p.conditional_error, minus_gain);
    detail::add_outer(joint.covariance, minus_gain, p.nuisance_spread);
  }

  /// phi is drawn anew, whatever it was: N(mean, factor factor^T). What was known of the joints stays.
  void replace_payload(const Phi& mean, const PhiMatrix& factor) noexcept {
    for (int j = 0; j < Dofs; ++j) {
      Joint& joint = this->joint(j);
      if (!empty_) {
        joint.mean = nuisance_mean(j);
        joint.covariance = nuisance_covariance(j);
      }
      joint.slope.setZero();
    }
    mean_ = mean;
    factor_ = factor;
    empty_ = false;
  }
  /// The hand is empty: phi = 0.
  void empty_payload() noexcept {
    if (empty_) return;
    replace_payload(Phi::Zero(), PhiMatrix::Zero());
    empty_ = true;
  }

  /// phi += N(0, Q).
  void diffuse(const PhiMatrix& Q) noexcept {
    const PhiMatrix before = covariance();
    PhiMatrix total = before, lower;
    total += Q;
    if (!factorise(total, lower)) return;
    const PhiMatrix inverse = inverted(lower);
    for (int j = 0; j < Dofs; ++j) {
      Joint& joint = this->joint(j);
      const Slope cross = detail::product(before, joint.slope);
      BetaMatrix V = joint.covariance;
      V += detail::transposed_product(joint.slope, cross);
      joint = given_payload(inverse, mean_, nuisance_mean(j), cross, V);
    }
    factor_ = lower;
    empty_ = false;
  }

  /// The star with the moments of a mixture of stars.
  /// @param parts    the components that count; those whose weight is 0 are not looked at
  /// @param weights  sum to one
  template <std::size_t Count>
  static StarGaussian mix(const std::array<const StarGaussian*, Count>& parts,
                          const std::array<Scalar, Count>& weights) noexcept;
  /// The same, of the nuisances alone: the hand is empty, whatever each component says of the payload.
  template <std::size_t Count>
  static StarGaussian mix_emptied(const std::array<const StarGaussian*, Count>& parts,
                                  const std::array<Scalar, Count>& weights) noexcept;

  /// P = L L^T, L lower triangular. A direction of which P says nothing, to rounding, gets a column of zeros.
  /// @return false if P is not finite; then L is as it was
  static bool factorise(const PhiMatrix& P, PhiMatrix& L) noexcept {
    using std::sqrt;
    if (!detail::finite(P)) return false;
    PhiMatrix out = PhiMatrix::Zero();
    for (int j = 0; j < kInertial; ++j) {
      Scalar pivot = P(j, j);
      for (int k = 0; k < j; ++k) pivot -= out(j, k) * out(j, k);
      // Relative to its own diagonal entry, since kilograms and kilogram square metres stand side by side.
      if (!(pivot > Eigen::NumTraits<Scalar>::epsilon() * 16 * P(j, j))) continue;
      out(j, j) = sqrt(pivot);
      for (int i = j + 1; i < kInertial; ++i) {
        Scalar sum = P(i, j);
        for (int k = 0; k < j; ++k) sum -= out(i, k) * out(j, k);
        out(i, j) = sum / out(j, j);
      }
    }
    L = out;
    return true;
  }

 private:
  /// L^+ of factorise()'s L, with zeros in the rows and columns of directions of which it says nothing.
  static PhiMatrix inverted(const PhiMatrix& L) noexcept {
    PhiMatrix out = PhiMatrix::Zero();
    for (int j = 0; j < kInertial; ++j) {
      if (!(L(j, j) > 0)) continue;
      out(j, j) = Scalar(1) / L(j, j);
      for (int i = j + 1; i < kInertial; ++i) {
        if (!(L(i, i) > 0)) continue;
        Scalar sum = Scalar(0);
        for (int k = j; k < i; ++k) sum -= L(i, k) * out(k, j);
        out(i, j) = sum / L(i, i);
      }
    }
    return out;
  }
  /// What a joint's nuisances are for a known payload, from moments of both.
  /// @param inverse          inverted() of the factor of the payload's covariance
  /// @param phi              the payload's mean
  /// @param mean, cross, V   E[beta], cov(phi, beta), cov(beta), whatever the payload is
  static Joint given_payload(const PhiMatrix& inverse, const Phi& phi, const Beta& mean, const Slope& cross,
                             const BetaMatrix& V) noexcept {
    const Slope white = detail::product(inverse, cross);
    Joint joint{mean, detail::transposed_product(inverse, white), V};
    detail::add_scaled(joint.mean, Scalar(-1), detail::transposed_product(joint.slope, phi));
    for (int i = 0; i < kJointNuisances; ++i) {
      for (int k = 0; k <= i; ++k) {
        const Scalar shown = detail::column(white, i).dot(detail::column(white, k));
        joint.covariance(i, k) = joint.covariance(k, i) = Scalar(0.5) * (V(i, k) + V(k, i)) - shown;
      }
      joint.covariance(i, i) = std::max(joint.covariance(i, i), Scalar(0));
    }
    return joint;
  }

  Phi mean_ = Phi::Zero();
  PhiMatrix factor_ = PhiMatrix::Zero();  // F
  bool empty_ = true;                     // phi = 0 for certain, so that slopes, whatever they are, count for nothing
  std::array<Joint, static_cast<std::size_t>(Dofs)> joints_;
};

}  // namespace rme

#include <rme/tracking/detail/star_gaussian_impl.hpp>
