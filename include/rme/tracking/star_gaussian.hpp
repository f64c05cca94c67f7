#pragma once
/// The Gaussian state of one filter: what all joints share, and the nuisances of each joint's torque.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <rme/core/singular_cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/inertial_parameters.hpp>
#include <rme/tracking/joint_observation.hpp>

namespace rme {

/// Gaussian over x and the joints' nuisances beta_1 .. beta_n. It has the form of a star: given x, the joints are
/// independent (docs/theory.md (T15)),
///
///     x ~ N(mean, F F^T),   beta_j | x ~ N(b_j + B_j x, V_j)
///
/// A joint's torque depends only on x and on its own beta_j. So observe() keeps this form exactly, at a fifth of the
/// cost of a dense covariance. To forget entries of x, or to add noise to them, would couple the joints.
/// forget_payload(), add() and their like give the nearest star instead, which has the right mean and covariance of
/// every pair (x, beta_j) (docs/theory.md, "The star").
///
/// F is a square root of the covariance of x, and is updated as such (Potter's form: Maybeck, Stochastic Models,
/// Estimation, and Control 1, 7.3). So rounding cannot make the covariance indefinite, even in float. An empty hand has
/// no phi: its rows are zero and cost nothing; nor do the last entries unless something pours or swings. Initially the
/// hand is empty and everything is zero. Real time: no call allocates.
template <typename Scalar, int Dofs>
class StarGaussian {
 public:
  using X = SharedVector<Scalar>;                                 ///< 21x1
  using XMatrix = SharedMatrix<Scalar>;                           ///< 21x21
  using Beta = JointNuisanceVector<Scalar>;                       ///< 6x1
  using BetaMatrix = JointNuisanceMatrix<Scalar>;                 ///< 6x6
  using Slope = Eigen::Matrix<Scalar, kShared, kJointNuisances>;  ///< 21x6
  using Cross = Eigen::Matrix<Scalar, kShared, 4>;                ///< covariance of x and four other unknowns
  using Absorbed = Eigen::Matrix<Scalar, 4, kJointNuisances>;     ///< d beta_j / d (m, m r)^T
  /// What the last entries of x are.
  enum class Last : std::uint8_t {
    Nothing,  ///< they are zero
    Poured,   ///< what has been poured into the payload: kPoured
    Force,    ///< the force of a payload that swings: kSwing
  };
  /// Gaussian of beta_j given x.
  struct Joint {
    Beta mean = Beta::Zero();                    ///< b_j
    Slope slope = Slope::Zero();                 ///< B_j^T
    BetaMatrix covariance = BetaMatrix::Zero();  ///< V_j
  };

  bool empty() const noexcept { return size_ == kArmShared; }  ///< whether the hand is empty for certain
  const X& mean() const noexcept { return mean_; }             ///< of x
  XMatrix covariance() const noexcept { return detail::outer_square(factor_); }  ///< of x, F F^T
  const XMatrix& factor() const noexcept { return factor_; }                     ///< F
  Last last() const noexcept { return last_; }                                   ///< what the last entries of x are
  bool swings() const noexcept { return last_ == Last::Force; }                  ///< whether the payload swings
  /// Mean of the payload's mass, with what was poured [kg].
  Scalar mass() const noexcept { return mean_[kPayload] + poured_mass(); }
  /// Mean of the payload's phi, with what was poured.
  InertialVector<Scalar> payload_mean() const noexcept {
    InertialVector<Scalar> phi;
    for (int i = 0; i < kInertial; ++i) phi[i] = mean_[kPayload + i] + (poured(i) ? mean_[kPoured + i] : Scalar(0));
    return phi;
  }
  /// Mean of the mass that has been poured since the pour began [kg]; 0 if nothing is poured.
  Scalar poured_mass() const noexcept { return poured(0) ? mean_[kPoured] : Scalar(0); }
  /// Covariance of the payload's phi, with what was poured.
  InertialMatrix<Scalar> payload_covariance() const noexcept {
    Eigen::Matrix<Scalar, kInertial, kShared> rows;
    for (int i = 0; i < kInertial; ++i)
      for (int k = 0; k < kShared; ++k)
        rows(i, k) = factor_(kPayload + i, k) + (poured(i) ? factor_(kPoured + i, k) : Scalar(0));
    return detail::outer_square(rows);
  }
  /// Variance of the payload's mass [kg^2].
  Scalar mass_variance() const noexcept {
    Scalar sum = Scalar(0);
    for (int k = 0; k < size_; ++k) {
      const Scalar f = factor_(kPayload, k) + (poured(0) ? factor_(kPoured, k) : Scalar(0));
      sum += f * f;
    }
    return sum;
  }
  /// Variance of entry i of x.
  Scalar variance(int i) const noexcept {
    Scalar sum = Scalar(0);
    for (int k = 0; k < size_; ++k) sum += factor_(i, k) * factor_(i, k);
    return sum;
  }
  /// Gaussian of beta_j given x, j from 0 to Dofs - 1.
  Joint& joint(int j) noexcept { return joints_[static_cast<std::size_t>(j)]; }
  /// Gaussian of beta_j given x, j from 0 to Dofs - 1.
  const Joint& joint(int j) const noexcept { return joints_[static_cast<std::size_t>(j)]; }
  /// Marginal mean of beta_j.
  Beta nuisance_mean(int j) const noexcept {
    Beta mean = joint(j).mean;
    mean += detail::transposed_product(joint(j).slope, mean_);
    return mean;
  }
  /// The same of one nuisance.
  Scalar nuisance_mean(int j, Nuisance n) const noexcept {
    return joint(j).mean[n] + detail::column(joint(j).slope, n).dot(detail::column(mean_, 0));
  }
  /// Marginal covariance of beta_j.
  BetaMatrix nuisance_covariance(int j) const noexcept {
    BetaMatrix V = joint(j).covariance;
    const Slope spread = detail::transposed_product(factor_, joint(j).slope);
    V += detail::transposed_product(spread, spread);
    return V;
  }
  /// Sets the variance of the arm's shared unknowns, which are independent at first.
  void set_arm(const Eigen::Matrix<Scalar, kArmShared, 1>& variance) noexcept {
    using std::sqrt;
    for (int i = 0; i < kArmShared; ++i) factor_(i, i) = sqrt(variance[i]);
  }
  /// E[a a^T] of the tilt a [rad^2].
  Eigen::Matrix<Scalar, 2, 2> tilt_square() const noexcept {
    Eigen::Matrix<Scalar, 2, 2> out;
    for (int i = 0; i < 2; ++i)
      for (int k = 0; k < 2; ++k) {
        out(i, k) = mean_[kTilt + i] * mean_[kTilt + k];
        for (int l = 0; l < size_; ++l) out(i, k) += factor_(kTilt + i, l) * factor_(kTilt + k, l);
      }
    return out;
  }
  /// Sets the standard deviation of the tilt [rad], of which nothing has been learned yet.
  void set_tilt(Scalar deviation) noexcept { factor_(kTilt, kTilt) = factor_(kTilt + 1, kTilt + 1) = deviation; }

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
    Scalar given_shared;       ///< v, the variance of y for a known x, noise included [(N m)^2]
    X gain_row;                ///< u = h + B_j^T c: how y depends on x, directly and through beta_j
    X spread;                  ///< F^T u
    Beta nuisance_spread;      ///< V_j c
    Scalar conditional_error;  ///< y - c^T b_j
  };
  /// Predicts the torque of joint j (docs/theory.md (T16)).
  /// @param j  0 .. Dofs - 1
  /// @param o  the observation
  Prediction predict(int j, const JointObservation<Scalar>& o) const noexcept {
    const Joint& joint = this->joint(j);
    Prediction p;
    p.nuisance_spread = detail::product(joint.covariance, o.c);
    p.given_shared = detail::dot(o.c, p.nuisance_spread) + o.noise;
    p.conditional_error = o.torque - detail::dot(o.c, joint.mean);
    if (size_ == kArmShared)
      predict_shared<kArmShared>(joint, o, p);
    else if (size_ == kHeldShared)
      predict_shared<kHeldShared>(joint, o, p);
    else
      predict_shared<kShared>(joint, o, p);
    return p;
  }
  /// Updates the state with an observation (docs/theory.md (T17, T18)).
  /// @param j  0 .. Dofs - 1
  /// @param p  predict() of this observation, for the same j and the present state
  void observe(int j, const Prediction& p) noexcept {
    if (size_ == kArmShared)
      observe_shared<kArmShared>(p);
    else if (size_ == kHeldShared)
      observe_shared<kHeldShared>(p);
    else
      observe_shared<kShared>(p);
    observe_nuisances(j, p);
  }
  /// Updates only the nuisances of joint j, given x; x keeps its distribution (Schmidt's filter; docs/theory.md (T18)).
  void observe_nuisances(int j, const Prediction& p) noexcept {
    Joint& joint = this->joint(j);
    const Beta minus_gain = detail::scaled(Scalar(-1) / p.given_shared, p.nuisance_spread);
    for (int i = 0; i < kJointNuisances; ++i)
      for (int k = 0; k < size_; ++k) joint.slope(k, i) += p.gain_row[k] * minus_gain[i];
    detail::add_scaled(joint.mean, -p.conditional_error, minus_gain);
    detail::add_outer(joint.covariance, minus_gain, p.nuisance_spread);
  }
  /// F^T u without what the payload has in u: how an error of what belongs to the arm shows in an observation.
  X arm_spread(const Prediction& p) const noexcept {
    X out;
    for (int k = 0; k < kShared; ++k) {
      out[k] = Scalar(0);
      for (int i = 0; i < kArmShared; ++i) out[k] += factor_(i, k) * p.gain_row[i];
    }
    return out;
  }
  /// cov(x, y) = F F^T u of an observation.
  X covariance_row(const Prediction& p) const noexcept { return detail::product(factor_, p.spread); }

  /// The last entries of x, zero so far, become unknowns. If nothing else is known of them, they stay zero.
  void extend(Last last) noexcept {
    size_ = kShared;
    last_ = last;
  }
  /// Multiplies the last entries of x by `factor`, which is not 0.
  void scale_last(Scalar factor) noexcept {
    for (int i = kHeldShared; i < kShared; ++i) {
      mean_[i] *= factor;
      for (int k = 0; k < kShared; ++k) factor_(i, k) *= factor;
      for (Joint& joint : joints_)
        for (int n = 0; n < kJointNuisances; ++n) joint.slope(i, n) /= factor;
    }
  }
  /// Gives x another distribution, N(mean, factor factor^T). Each beta_j given x stays as it is.
  void set_shared(const X& mean, const XMatrix& factor) noexcept {
    mean_ = mean;
    factor_ = factor;
  }
  /// Adds d to `Size` entries of x, the first of which is `First`. Each beta_j keeps its moments with the old x
  /// (docs/theory.md (T71)).
  /// @param mean        of d
  /// @param covariance  of d
  /// @param cross       cov(x, d), x before; beta_j depends on d only through x
  /// @return false if the new covariance of x is not finite; then nothing has changed
  template <int First, int Size>
  bool add(const Eigen::Matrix<Scalar, Size, 1>& mean, const Eigen::Matrix<Scalar, Size, Size>& covariance,
           const Eigen::Matrix<Scalar, kShared, Size>& cross) noexcept {
    XMatrix total = this->covariance();
    Eigen::Matrix<Scalar, kShared, Size> shown = cross;  // cov(x, d), x afterwards
    for (int k = 0; k < Size; ++k) {
      for (int i = 0; i < kShared; ++i) total(i, First + k) += cross(i, k);
      for (int i = 0; i < Size; ++i) shown(First + i, k) += covariance(i, k);
      for (int i = 0; i < kShared; ++i) total(First + k, i) += shown(i, k);
    }
    const SingularCholesky<Scalar, kShared> factor(total);
    if (!factor.finite()) return false;
    factor_ = factor.lower();
    for (int i = 0; i < Size; ++i) mean_[First + i] += mean[i];
    // E[d | x] = at_zero + S^T x, and C = cov(d | x); beta_j depends on x - d as it did on x.
    const Eigen::Matrix<Scalar, kShared, Size> S = factor.solve(shown);
    Eigen::Matrix<Scalar, Size, Size> C = covariance;
    detail::add_scaled(C, Scalar(-1), Eigen::Matrix<Scalar, Size, Size>(detail::transposed_product(shown, S)));
    Eigen::Matrix<Scalar, Size, 1> at_zero = mean;
    detail::add_scaled(at_zero, Scalar(-1), Eigen::Matrix<Scalar, Size, 1>(detail::transposed_product(S, mean_)));
    for (Joint& joint : joints_) {
      Eigen::Matrix<Scalar, Size, kJointNuisances> on_d;
      for (int n = 0; n < kJointNuisances; ++n)
        for (int i = 0; i < Size; ++i) on_d(i, n) = -joint.slope(First + i, n);
      joint.slope += detail::product(S, on_d);
      absorb(joint, on_d, at_zero, C);
    }
    return true;
  }

  /// Marginalises the payload, with what was poured: the hand is empty afterwards, and everything else keeps its
  /// marginal distribution. A swing has to be over (Swing::end()).
  void forget_payload() noexcept {
    if (last_ != Last::Nothing) forget_last();
    if (!empty() && marginalise<kArmShared, kInertial>()) size_ = kArmShared;
  }
  /// What has been poured becomes part of the payload's phi.
  void merge_poured() noexcept {
    count_as<kPayload, kPoured>();
    forget_last();
  }
  /// Marginalises the last entries of x: they are zero afterwards.
  void forget_last() noexcept {
    if (!marginalise<kHeldShared, kShared - kHeldShared>()) return;
    size_ = kHeldShared;
    last_ = Last::Nothing;
  }
  /// Puts a payload phi ~ N(mean, factor factor^T), independent of everything else, in place of the present one.
  void draw_payload(const InertialVector<Scalar>& mean, const InertialMatrix<Scalar>& factor) noexcept {
    forget_payload();
    for (int i = 0; i < kInertial; ++i) {
      mean_[kPayload + i] = mean[i];
      for (int k = 0; k < kInertial; ++k) factor_(kPayload + i, kPayload + k) = factor(i, k);
    }
    size_ = kHeldShared;
  }
  /// The hand may hold a payload phi ~ N(0, factor factor^T), and the joints' nuisances have taken it for their own:
  /// beta_j is then off by absorbed[j]^T (m, m r). The hand has to be empty.
  void suppose_payload(const InertialMatrix<Scalar>& factor,
                       const std::array<Absorbed, static_cast<std::size_t>(Dofs)>& absorbed) noexcept {
    draw_payload(InertialVector<Scalar>::Zero(), factor);
    for (int j = 0; j < Dofs; ++j)
      for (int i = 0; i < 4; ++i)
        for (int n = 0; n < kJointNuisances; ++n)
          joint(j).slope(kPayload + i, n) = absorbed[static_cast<std::size_t>(j)](i, n);
  }
  /// The payload turns out to be none: everything else is as it is given phi = 0. Nothing may pour or swing. The hand
  /// is empty afterwards.
  /// @return log density of phi at 0 before [nats], without the constant factor of 2 pi (docs/theory.md (T51))
  Scalar payload_is_none() noexcept {
    if (empty()) return Scalar(0);
    Scalar log_density = Scalar(0);
    for (int i = kPayload; i < kPayload + kInertial; ++i) {
      Prediction p;
      for (int k = 0; k < kShared; ++k) p.spread[k] = factor_(i, k);
      const Scalar square = detail::dot(p.spread, p.spread);
      if (!(square > 0)) continue;
      p.given_shared = Scalar(0);
      p.variance = square;
      p.innovation = -mean_[i];
      log_density -= Scalar(0.5) * (p.innovation * p.innovation / p.variance + std::log(p.variance));
      observe_shared<kHeldShared>(p);
    }
    (void)marginalise<kArmShared, kInertial>();  // nothing of it is unknown any more
    size_ = kArmShared;
    return log_density;
  }
  /// Counts the payload as part of the tool. Nothing may pour or swing. The hand is empty afterwards.
  void payload_is_tool() noexcept {
    if (empty()) return;
    count_as<kTool, kPayload>();
    forget_payload();
  }
  /// The offset of joint j turns into what makes the torque of an observation zero.
  /// @param j         0 .. Dofs - 1
  /// @param o         the observation; its torque does not matter
  /// @param variance  of that torque afterwards [(N m)^2]
  void zero_torque(int j, const JointObservation<Scalar>& o, Scalar variance) noexcept {
    Joint& joint = this->joint(j);
    Beta rest = detail::scaled(Scalar(-1), o.c);  // of the nuisances: the offset is now rest^T beta_j - h^T x
    rest[kOffset] = Scalar(0);
    joint.mean[kOffset] = detail::dot(rest, joint.mean);
    for (int k = 0; k < size_; ++k) {
      Scalar slope = -o.h[k];
      for (int n = 0; n < kJointNuisances; ++n) slope += rest[n] * joint.slope(k, n);
      joint.slope(k, kOffset) = slope;
    }
    const Beta row = detail::product(joint.covariance, rest);
    for (int n = 0; n < kJointNuisances; ++n) joint.covariance(kOffset, n) = joint.covariance(n, kOffset) = row[n];
    joint.covariance(kOffset, kOffset) = detail::dot(rest, row) + variance;
  }
  /// Adds noise, independent from joint to joint, to a nuisance of each.
  /// @param n         which one
  /// @param variance  of the noise, >= 0
  void widen_nuisance(Nuisance n, Scalar variance) noexcept {
    for (Joint& joint : joints_) joint.covariance(n, n) += variance;
  }
  /// Variance of nuisance n given x, mean over the joints.
  Scalar nuisance_variance(Nuisance n) const noexcept {
    Scalar sum = Scalar(0);
    for (const Joint& joint : joints_) sum += joint.covariance(n, n);
    return sum / Scalar(Dofs);
  }
  /// Whether the gains of the torque may be off.
  bool gains_off() const noexcept { return nuisance_variance(kGain) > 0; }
  /// Adds independent noise to `Size` entries of x, the first of which is `First`. Each beta_j keeps its moments with x
  /// as they were.
  /// @param variance  of the noise of each, >= 0
  template <int First, int Size>
  void widen(const Eigen::Matrix<Scalar, Size, 1>& variance) noexcept {
    Eigen::Matrix<Scalar, Size, Size> noise = Eigen::Matrix<Scalar, Size, Size>::Zero();
    for (int i = 0; i < Size; ++i) noise(i, i) = variance[i];
    add<First>(Eigen::Matrix<Scalar, Size, 1>(Eigen::Matrix<Scalar, Size, 1>::Zero()), noise,
               Eigen::Matrix<Scalar, kShared, Size>(Eigen::Matrix<Scalar, kShared, Size>::Zero()));
  }
  /// The same of what belongs to the arm, in the order of Shared.
  void widen_arm(const Eigen::Matrix<Scalar, kArmShared, 1>& variance) noexcept { widen<0, kArmShared>(variance); }

  /// Adds a relative error to what is known of the payload: phi becomes (1 + e) phi, e independent of everything else.
  /// Each beta_j keeps its moments with the old x.
  /// @param square  E[e^2]
  void widen_payload(Scalar square) noexcept {
    InertialVector<Scalar> phi;
    for (int i = 0; i < kInertial; ++i) phi[i] = mean_[kPayload + i];
    InertialMatrix<Scalar> noise = InertialMatrix<Scalar>::Zero();
    detail::add_outer(noise, detail::scaled(square, phi), phi);
    add<kPayload, kInertial>(InertialVector<Scalar>::Zero(), noise, Eigen::Matrix<Scalar, kShared, kInertial>::Zero());
  }

 private:
  /// Adds one (m, m r) of x to another, as whose part it counts from now on. Each beta_j depends on x as before, so in
  /// the new x it depends on the added one as far as it did so otherwise than on the other.
  template <int Other, int Added>
  void count_as() noexcept {
    for (int i = 0; i < 4; ++i) {
      mean_[Other + i] += mean_[Added + i];
      for (int k = 0; k < kShared; ++k) factor_(Other + i, k) += factor_(Added + i, k);
      for (Joint& joint : joints_)
        for (int n = 0; n < kJointNuisances; ++n) joint.slope(Added + i, n) -= joint.slope(Other + i, n);
    }
  }
  /// Whether something has been poured into entry i of phi.
  bool poured(int i) const noexcept { return i < 4 && last_ == Last::Poured; }
  template <int Size>
  using Head = Eigen::Map<Eigen::Matrix<Scalar, Size, 1>>;
  template <int Size>
  using ConstHead = Eigen::Map<const Eigen::Matrix<Scalar, Size, 1>>;

  template <int Size>
  void predict_shared(const Joint& joint, const JointObservation<Scalar>& o, Prediction& p) const noexcept {
    p.gain_row = o.h;
    Head<Size> u(p.gain_row.data());
    for (int n = 0; n < kJointNuisances; ++n)
      if (o.c[n] != Scalar(0)) u += o.c[n] * ConstHead<Size>(joint.slope.data() + n * kShared);
    Scalar square = Scalar(0);
    for (int k = 0; k < Size; ++k) {
      p.spread[k] = ConstHead<Size>(factor_.data() + k * kShared).dot(u);
      square += p.spread[k] * p.spread[k];
    }
    for (int k = Size; k < kShared; ++k) p.spread[k] = p.gain_row[k] = Scalar(0);
    p.variance = square + p.given_shared;
    p.innovation = p.conditional_error - ConstHead<Size>(mean_.data()).dot(u);
  }
  template <int Size>
  void observe_shared(const Prediction& p) noexcept {
    using std::sqrt;
    X row = X::Zero();
    Head<Size> covariance_row(row.data());
    for (int k = 0; k < Size; ++k) covariance_row += p.spread[k] * ConstHead<Size>(factor_.data() + k * kShared);
    Head<Size>(mean_.data()) += (p.innovation / p.variance) * covariance_row;
    const Scalar shrink = Scalar(1) / (p.variance * (Scalar(1) + sqrt(p.given_shared / p.variance)));
    for (int k = 0; k < Size; ++k) Head<Size>(factor_.data() + k * kShared) -= (shrink * p.spread[k]) * covariance_row;
  }

  /// Marginalises the `Gone` entries of x after the first `Kept`, which are zero afterwards, as all after them are
  /// already (docs/theory.md (T71)).
  /// @return false if the covariance is not finite; then nothing has changed
  template <int Kept, int Gone>
  bool marginalise() noexcept {
    Eigen::Matrix<Scalar, kShared, Kept> kept;  // rows of F, as columns
    Eigen::Matrix<Scalar, kShared, Gone> gone;
    for (int k = 0; k < kShared; ++k) {
      for (int i = 0; i < Kept; ++i) kept(k, i) = factor_(i, k);
      for (int i = 0; i < Gone; ++i) gone(k, i) = factor_(Kept + i, k);
    }
    const SingularCholesky<Scalar, Kept> factor(detail::transposed_product(kept, kept));
    if (!factor.finite()) return false;
    // E[those that go | those that stay] = at_zero + S^T those that stay, and C = cov(those that go | those that stay).
    const Eigen::Matrix<Scalar, Kept, Gone> S = factor.solve(detail::transposed_product(kept, gone));
    detail::add_scaled(gone, Scalar(-1), Eigen::Matrix<Scalar, kShared, Gone>(detail::product(kept, S)));
    const Eigen::Matrix<Scalar, Gone, Gone> C = detail::transposed_product(gone, gone);
    Eigen::Matrix<Scalar, Gone, 1> at_zero;
    for (int k = 0; k < Gone; ++k) {
      at_zero[k] = mean_[Kept + k];
      for (int i = 0; i < Kept; ++i) at_zero[k] -= S(i, k) * mean_[i];
      mean_[Kept + k] = Scalar(0);
    }
    for (Joint& joint : joints_) {
      Eigen::Matrix<Scalar, Gone, kJointNuisances> on_gone;
      for (int n = 0; n < kJointNuisances; ++n)
        for (int k = 0; k < Gone; ++k) on_gone(k, n) = joint.slope(Kept + k, n);
      const Eigen::Matrix<Scalar, Kept, kJointNuisances> through = detail::product(S, on_gone);
      for (int n = 0; n < kJointNuisances; ++n) {
        for (int i = 0; i < Kept; ++i) joint.slope(i, n) += through(i, n);
        for (int k = 0; k < Gone; ++k) joint.slope(Kept + k, n) = Scalar(0);
      }
      absorb(joint, on_gone, at_zero, C);
    }
    factor_.setZero();
    for (int k = 0; k < Kept; ++k)
      for (int i = k; i < Kept; ++i) factor_(i, k) = factor.lower()(i, k);
    return true;
  }
  /// Adds slope^T d to a joint's nuisances, where d ~ N(mean, covariance).
  template <int Size>
  static void absorb(Joint& joint, const Eigen::Matrix<Scalar, Size, kJointNuisances>& slope,
                     const Eigen::Matrix<Scalar, Size, 1>& mean,
                     const Eigen::Matrix<Scalar, Size, Size>& covariance) noexcept {
    joint.mean += detail::transposed_product(slope, mean);
    const Eigen::Matrix<Scalar, Size, kJointNuisances> spread = detail::product(covariance, slope);
    BetaMatrix& V = joint.covariance;
    for (int i = 0; i < kJointNuisances; ++i) {
      for (int k = 0; k <= i; ++k)
        V(i, k) = V(k, i) = Scalar(0.5) * (V(i, k) + V(k, i)) + detail::column(slope, i).dot(detail::column(spread, k));
      V(i, i) = std::max(V(i, i), Scalar(0));
    }
  }

  X mean_ = X::Zero();
  XMatrix factor_ = XMatrix::Zero();  // F
  int size_ = kArmShared;             // entries of x that are not zero for certain; the others have zero slopes
  Last last_ = Last::Nothing;
  std::array<Joint, static_cast<std::size_t>(Dofs)> joints_;
};

}  // namespace rme
