#pragma once
/// The Gaussian of one filter: a payload's inertial parameters, and what each joint's torque carries beside them.
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/types.hpp>
#include <rme/tracking/inertial_parameters.hpp>

namespace rme {

/// What a joint's torque carries beside the payload; the order of every nuisance vector.
enum Nuisance : int {
  kOffset,    ///< of the torque sensor [N m]
  kCoulomb,   ///< friction of a moving joint, against its motion [N m]
  kViscous,   ///< the same per joint velocity [N m s/rad]
  kResidual,  ///< of the arm's rigid-body model: wanders as the arm moves [N m]
  kStiction,  ///< friction torque of a resting joint [N m]
};
inline constexpr int kJointNuisances = 5;

template <typename Scalar>
using JointNuisanceVector = Eigen::Matrix<Scalar, kJointNuisances, 1>;
template <typename Scalar>
using JointNuisanceMatrix = Eigen::Matrix<Scalar, kJointNuisances, kJointNuisances>;

/// y = h^T phi + c^T beta_j + noise: the torque of one joint, averaged over a block of samples.
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
/// A joint's torque says something of phi and of its own beta alone, so that observe() keeps this form exactly, at a
/// fifth of what a dense covariance costs. replace_payload(), diffuse() and mix() would couple the joints: each gives
/// the nearest star, which has the right moments of phi and every beta_j, pair by pair (docs/theory.md, "The star").
///
/// F is a square root of the covariance and is updated as such (Potter's form: Maybeck, Stochastic Models, Estimation,
/// and Control 1, 7.3), so that the covariance cannot lose its positive definiteness to rounding, in float either.
/// Real time: no call allocates.
template <typename Scalar, int Dofs>
class StarGaussian {
 public:
  using Phi = InertialVector<Scalar>;
  using PhiMatrix = InertialMatrix<Scalar>;
  using Beta = JointNuisanceVector<Scalar>;
  using BetaMatrix = JointNuisanceMatrix<Scalar>;
  using Slope = Eigen::Matrix<Scalar, kInertial, kJointNuisances>;
  struct Joint {
    Beta mean = Beta::Zero();                    ///< b_j
    Slope slope = Slope::Zero();                 ///< B_j^T
    BetaMatrix covariance = BetaMatrix::Zero();  ///< V_j
  };

  const Phi& mean() const noexcept { return mean_; }
  PhiMatrix covariance() const noexcept { return factor_.lazyProduct(factor_.transpose()); }
  Scalar mass_variance() const noexcept { return factor_.row(0).squaredNorm(); }
  Joint& joint(int j) noexcept { return joints_[static_cast<std::size_t>(j)]; }
  const Joint& joint(int j) const noexcept { return joints_[static_cast<std::size_t>(j)]; }
  /// Mean of beta_j, whatever phi is.
  Beta nuisance_mean(int j) const noexcept { return joint(j).mean + joint(j).slope.transpose().lazyProduct(mean_); }
  /// Covariance of beta_j, whatever phi is.
  BetaMatrix nuisance_covariance(int j) const noexcept {
    const Slope spread = factor_.transpose().lazyProduct(joint(j).slope);
    return joint(j).covariance + spread.transpose().lazyProduct(spread);
  }

  /// Whether all of it is finite: numbers that no arm reports may overflow, in float above all.
  bool finite() const noexcept {
    bool good = mean_.allFinite() && factor_.allFinite();
    for (const Joint& joint : joints_)
      good = good && joint.mean.allFinite() && joint.slope.allFinite() && joint.covariance.allFinite();
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
  Prediction predict(int j, const JointObservation<Scalar>& o) const noexcept {
    const Joint& joint = this->joint(j);
    Prediction p;
    p.gain_row = o.h;
    p.gain_row += joint.slope.lazyProduct(o.c);
    p.spread = factor_.transpose().lazyProduct(p.gain_row);
    p.nuisance_spread = joint.covariance.lazyProduct(o.c);
    p.given_payload = o.c.dot(p.nuisance_spread) + o.noise;
    p.variance = p.spread.squaredNorm() + p.given_payload;
    p.conditional_error = o.torque - o.c.dot(joint.mean);
    p.innovation = p.conditional_error - p.gain_row.dot(mean_);
    return p;
  }
  /// Takes the observation in. `p` is what predict() said of it.
  void observe(int j, const Prediction& p) noexcept {
    using std::sqrt;
    Joint& joint = this->joint(j);
    const Phi covariance_row = factor_.lazyProduct(p.spread);
    mean_ += covariance_row * (p.innovation / p.variance);
    const Scalar shrink = Scalar(1) / (p.variance * (Scalar(1) + sqrt(p.given_payload / p.variance)));
    factor_ -= Phi(shrink * covariance_row).lazyProduct(p.spread.transpose());
    const Beta gain = p.nuisance_spread / p.given_payload;
    joint.mean += gain * p.conditional_error;
    joint.slope -= p.gain_row.lazyProduct(gain.transpose());
    joint.covariance -= gain.lazyProduct(p.nuisance_spread.transpose());
  }

  /// phi is drawn anew, whatever it was: N(mean, factor factor^T). What was known of the joints stays.
  void replace_payload(const Phi& mean, const PhiMatrix& factor) noexcept {
    for (Joint& joint : joints_) {
      joint.mean += joint.slope.transpose().lazyProduct(mean_);
      const Slope spread = factor_.transpose().lazyProduct(joint.slope);
      joint.covariance += spread.transpose().lazyProduct(spread);
      joint.slope.setZero();
    }
    mean_ = mean;
    factor_ = factor;
  }
  /// The hand is empty: phi = 0.
  void empty_payload() noexcept { replace_payload(Phi::Zero(), PhiMatrix::Zero()); }

  /// phi += N(0, Q).
  void diffuse(const PhiMatrix& Q) noexcept {
    const PhiMatrix before = covariance();
    PhiMatrix lower;
    if (!factorise(before + Q, lower)) return;
    for (Joint& joint : joints_) {
      const Slope cross = before.lazyProduct(joint.slope);
      const Beta mean = joint.mean + joint.slope.transpose().lazyProduct(mean_);
      const BetaMatrix total = joint.covariance + joint.slope.transpose().lazyProduct(cross);
      joint.slope = solve(lower, cross);
      joint.covariance = total - joint.slope.transpose().lazyProduct(cross);
      symmetrise(joint.covariance);
      joint.mean = mean - joint.slope.transpose().lazyProduct(mean_);
    }
    factor_ = lower;
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
    if (!P.allFinite()) return false;
    PhiMatrix out = PhiMatrix::Zero();
    for (int j = 0; j < kInertial; ++j) {
      const Scalar pivot = P(j, j) - out.row(j).head(j).squaredNorm();
      // Relative to its own diagonal entry, since kilograms and kilogram square metres stand side by side.
      if (!(pivot > Eigen::NumTraits<Scalar>::epsilon() * 16 * P(j, j))) continue;
      out(j, j) = sqrt(pivot);
      for (int i = j + 1; i < kInertial; ++i)
        out(i, j) = (P(i, j) - out.row(i).head(j).dot(out.row(j).head(j))) / out(j, j);
    }
    L = out;
    return true;
  }

 private:
  /// (L L^T)^+ X of factorise()'s L.
  static Slope solve(const PhiMatrix& L, Slope X) noexcept {
    for (int i = 0; i < kInertial; ++i) {
      if (!(L(i, i) > 0)) {
        X.row(i).setZero();
        continue;
      }
      for (int k = 0; k < i; ++k) X.row(i) -= L(i, k) * X.row(k);
      X.row(i) /= L(i, i);
    }
    for (int i = kInertial - 1; i >= 0; --i) {
      if (!(L(i, i) > 0)) continue;
      for (int k = i + 1; k < kInertial; ++k) X.row(i) -= L(k, i) * X.row(k);
      X.row(i) /= L(i, i);
    }
    return X;
  }
  static void symmetrise(BetaMatrix& V) noexcept {
    const BetaMatrix transposed = V.transpose();
    V = Scalar(0.5) * (V + transposed);
    V.diagonal() = V.diagonal().cwiseMax(Scalar(0));
  }

  Phi mean_ = Phi::Zero();
  PhiMatrix factor_ = PhiMatrix::Zero();  // F
  std::array<Joint, static_cast<std::size_t>(Dofs)> joints_;
};

template <typename Scalar, int Dofs>
template <std::size_t Count>
StarGaussian<Scalar, Dofs> StarGaussian<Scalar, Dofs>::mix(const std::array<const StarGaussian*, Count>& parts,
                                                           const std::array<Scalar, Count>& weights) noexcept {
  StarGaussian out;
  std::array<PhiMatrix, Count> P;
  PhiMatrix total = PhiMatrix::Zero();
  for (std::size_t i = 0; i < Count; ++i)
    if (weights[i] > 0) out.mean_ += weights[i] * parts[i]->mean_;
  for (std::size_t i = 0; i < Count; ++i) {
    if (!(weights[i] > 0)) continue;
    const Phi d = parts[i]->mean_ - out.mean_;
    P[i] = parts[i]->covariance();
    total += weights[i] * (P[i] + d.lazyProduct(d.transpose()));
  }
  if (!factorise(total, out.factor_)) return out;
  for (int j = 0; j < Dofs; ++j) {
    Beta mean = Beta::Zero();
    for (std::size_t i = 0; i < Count; ++i)
      if (weights[i] > 0) mean += weights[i] * parts[i]->nuisance_mean(j);
    Slope cross = Slope::Zero();
    BetaMatrix V = BetaMatrix::Zero();
    for (std::size_t i = 0; i < Count; ++i) {
      if (!(weights[i] > 0)) continue;
      const Joint& part = parts[i]->joint(j);
      const Beta d = parts[i]->nuisance_mean(j) - mean;
      const Slope own = P[i].lazyProduct(part.slope);
      cross += weights[i] * (own + Phi(parts[i]->mean_ - out.mean_).lazyProduct(d.transpose()));
      V += weights[i] * (part.covariance + part.slope.transpose().lazyProduct(own) + d.lazyProduct(d.transpose()));
    }
    Joint& joint = out.joint(j);
    joint.slope = solve(out.factor_, cross);
    joint.covariance = V - joint.slope.transpose().lazyProduct(cross);
    symmetrise(joint.covariance);
    joint.mean = mean - joint.slope.transpose().lazyProduct(out.mean_);
  }
  return out;
}

template <typename Scalar, int Dofs>
template <std::size_t Count>
StarGaussian<Scalar, Dofs> StarGaussian<Scalar, Dofs>::mix_emptied(const std::array<const StarGaussian*, Count>& parts,
                                                                   const std::array<Scalar, Count>& weights) noexcept {
  StarGaussian out;
  for (int j = 0; j < Dofs; ++j) {
    std::array<Beta, Count> mean;
    Joint& joint = out.joint(j);
    for (std::size_t i = 0; i < Count; ++i) {
      if (!(weights[i] > 0)) continue;
      mean[i] = parts[i]->nuisance_mean(j);
      joint.mean += weights[i] * mean[i];
    }
    for (std::size_t i = 0; i < Count; ++i) {
      if (!(weights[i] > 0)) continue;
      const Beta d = mean[i] - joint.mean;
      joint.covariance += weights[i] * (parts[i]->nuisance_covariance(j) + d.lazyProduct(d.transpose()));
    }
  }
  return out;
}

}  // namespace rme
