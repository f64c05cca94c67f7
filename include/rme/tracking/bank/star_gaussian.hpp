#pragma once
/// The Gaussian state of one filter: a payload's inertial parameters, and the nuisances of each joint's torque.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/inertial_parameters.hpp>

namespace rme::bank {

/// What a joint's torque contains in addition to the payload's torque. Nuisance vectors have this order.
enum Nuisance : int {
  kOffset,   ///< offset of the torque sensor [N m]
  kCoulomb,  ///< Coulomb friction of a moving joint, against its motion [N m]
  kViscous,  ///< viscous friction [N m s/rad]
  /// In place of viscous friction with link-side sensing, which sees none: lag of the torque [s]. The torque minus lag
  /// times its rate is in time with the motion.
  kLag = kViscous,
  kResidual,  ///< error of the arm's rigid-body model; changes as the arm moves [N m]
  kStiction,  ///< friction torque of a resting joint [N m]
};
inline constexpr int kJointNuisances = 5;  ///< number of nuisances of a joint

template <typename Scalar>
using JointNuisanceVector = Eigen::Matrix<Scalar, kJointNuisances, 1>;  ///< beta_j, in the order of Nuisance
template <typename Scalar>
using JointNuisanceMatrix = Eigen::Matrix<Scalar, kJointNuisances, kJointNuisances>;  ///< covariance of beta_j

/// Measurement of one joint's torque, averaged over a block of samples (docs/theory.md (T14)): y = h^T phi + c^T beta_j
/// + noise.
template <typename Scalar>
struct JointObservation {
  Scalar torque;                  ///< y [N m]
  InertialVector<Scalar> h;       ///< regressor of phi
  JointNuisanceVector<Scalar> c;  ///< regressor of the joint's nuisances
  Scalar noise;                   ///< variance of the noise [(N m)^2], > 0
};

/// Gaussian over phi and the joints' nuisances beta_1 .. beta_n. It has the form of a star: given phi, the joints are
/// independent (docs/theory.md (T15)),
///
///     phi ~ N(mean, F F^T),   beta_j | phi ~ N(b_j + B_j phi, V_j)
///
/// A joint's torque depends only on phi and on its own beta_j. So observe() keeps this form exactly, at a fifth of the
/// cost of a dense covariance. replace_payload(), diffuse() and mix() would couple the joints. Each of them gives the
/// nearest star instead, which has the right mean and covariance of every pair (phi, beta_j) (docs/theory.md, "The
/// star").
///
/// F is a square root of the covariance of phi, and is updated as such (Potter's form: Maybeck, Stochastic Models,
/// Estimation, and Control 1, 7.3). So rounding cannot make the covariance indefinite, even in float. Initially the
/// hand is empty and all nuisances are zero. Real time: no call allocates.
template <typename Scalar, int Dofs>
class StarGaussian {
 public:
  using Phi = InertialVector<Scalar>;                               ///< 10x1
  using PhiMatrix = InertialMatrix<Scalar>;                         ///< 10x10
  using Beta = JointNuisanceVector<Scalar>;                         ///< 5x1
  using BetaMatrix = JointNuisanceMatrix<Scalar>;                   ///< 5x5
  using Slope = Eigen::Matrix<Scalar, kInertial, kJointNuisances>;  ///< 10x5
  /// Gaussian of beta_j given phi.
  struct Joint {
    Beta mean = Beta::Zero();                    ///< b_j
    Slope slope = Slope::Zero();                 ///< B_j^T
    BetaMatrix covariance = BetaMatrix::Zero();  ///< V_j
  };

  const Phi& mean() const noexcept { return mean_; }  ///< of phi
  /// Covariance of phi, F F^T.
  PhiMatrix covariance() const noexcept { return detail::outer_square(factor_); }
  /// Variance of the mass [kg^2].
  Scalar mass_variance() const noexcept {
    Scalar sum = Scalar(0);
    for (int k = 0; k < kInertial; ++k) sum += factor_(0, k) * factor_(0, k);
    return sum;
  }
  /// Gaussian of beta_j given phi, j from 0 to Dofs - 1.
  Joint& joint(int j) noexcept { return joints_[static_cast<std::size_t>(j)]; }
  /// Gaussian of beta_j given phi, j from 0 to Dofs - 1.
  const Joint& joint(int j) const noexcept { return joints_[static_cast<std::size_t>(j)]; }
  /// Marginal mean of beta_j.
  Beta nuisance_mean(int j) const noexcept {
    Beta mean = joint(j).mean;
    if (!empty_) mean += detail::transposed_product(joint(j).slope, mean_);
    return mean;
  }
  /// Marginal covariance of beta_j.
  BetaMatrix nuisance_covariance(int j) const noexcept {
    BetaMatrix V = joint(j).covariance;
    if (empty_) return V;
    const Slope spread = detail::transposed_product(factor_, joint(j).slope);
    V += detail::transposed_product(spread, spread);
    return V;
  }

  /// Whether all numbers are finite. Input that no real arm reports may overflow, above all in float.
  bool finite() const noexcept {
    bool good = detail::finite(mean_) && detail::finite(factor_);
    for (const Joint& joint : joints_)
      good = good && detail::finite(joint.mean) && detail::finite(joint.slope) && detail::finite(joint.covariance);
    return good;
  }

  /// Prediction of an observation, in the symbols of docs/theory.md (T16) and (T18).
  struct Prediction {
    Scalar innovation;         ///< e = y - E[y] [N m]
    Scalar variance;           ///< S, the variance of e [(N m)^2]
    Scalar given_payload;      ///< v, the variance of y for a known phi, noise included [(N m)^2]
    Phi gain_row;              ///< u = h + B_j^T c: how y depends on phi, directly and through beta_j
    Phi spread;                ///< F^T u
    Beta nuisance_spread;      ///< V_j c
    Scalar conditional_error;  ///< y - c^T b_j
  };
  /// Predicts the torque of joint j (docs/theory.md (T16)).
  /// @param j  0 .. Dofs - 1
  /// @param o  the observation
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
  /// Updates the state with an observation (docs/theory.md (T17, T18)).
  /// @param j  0 .. Dofs - 1
  /// @param p  predict() of this observation, for the same j and the present state
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

  /// Replaces the distribution of phi by N(mean, factor factor^T). Each beta_j keeps its marginal distribution and is
  /// independent of phi afterwards.
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
  /// Sets phi to 0 for certain: the hand is empty. Each beta_j keeps its marginal distribution.
  void empty_payload() noexcept {
    if (empty_) return;
    replace_payload(Phi::Zero(), PhiMatrix::Zero());
    empty_ = true;
  }

  /// Adds process noise to phi: phi += N(0, Q). Each beta_j keeps its moments with phi as they were.
  /// @param Q  positive semidefinite; if it is not finite, nothing changes
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
  /// @param parts    the components; one whose weight is 0 is not read
  /// @param weights  of the components, >= 0, sum 1
  template <std::size_t Count>
  static StarGaussian mix(const std::array<const StarGaussian*, Count>& parts,
                          const std::array<Scalar, Count>& weights) noexcept;
  /// The same for the nuisances alone: in the result the hand is empty, whatever phi is in the components. Parameters
  /// as in mix().
  template <std::size_t Count>
  static StarGaussian mix_emptied(const std::array<const StarGaussian*, Count>& parts,
                                  const std::array<Scalar, Count>& weights) noexcept;

  /// Cholesky factorisation P = L L^T, L lower triangular, for a positive semidefinite P. A direction whose variance is
  /// zero, to within rounding, gets a column of zeros.
  /// @return false if P is not finite; then L is as it was
  static bool factorise(const PhiMatrix& P, PhiMatrix& L) noexcept {
    using std::sqrt;
    if (!detail::finite(P)) return false;
    PhiMatrix out = PhiMatrix::Zero();
    for (int j = 0; j < kInertial; ++j) {
      Scalar pivot = P(j, j);
      for (int k = 0; k < j; ++k) pivot -= out(j, k) * out(j, k);
      // Relative to its own diagonal entry, since the entries have different units.
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
  /// Inverse of factorise()'s L in the directions that have variance, with zeros in the rows and columns of the others.
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
  /// Gaussian of a joint's nuisances given phi, from the moments of both.
  /// @param inverse         inverted() of the factor of cov(phi)
  /// @param phi             E[phi]
  /// @param mean, cross, V  E[beta], cov(phi, beta), cov(beta)
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
  bool empty_ = true;                     // phi = 0 for certain; slopes are then not used
  std::array<Joint, static_cast<std::size_t>(Dofs)> joints_;
};

}  // namespace rme::bank

#include <rme/tracking/bank/star_gaussian_impl.hpp>
