#pragma once
/// The running sums from which a payload is inferred, with offset and friction integrated out.
#include <array>
#include <rme/core/cholesky.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/payload_likelihood.hpp>
#include <rme/inference/payload_regressor.hpp>

namespace rme {

/// Number of nuisance coefficients of a joint. A joint's torque beside the payload's is
/// offset + coulomb * c + viscous * v, where c is the negative direction of motion and v the negative joint velocity,
/// since friction opposes motion.
inline constexpr int kNuisances = 3;
template <typename Scalar>
using NuisanceVector = Eigen::Matrix<Scalar, kNuisances, 1>;  ///< (offset [N m], coulomb [N m], viscous [N m s/rad])
template <typename Scalar>
using NuisanceMatrix = Eigen::Matrix<Scalar, kNuisances, kNuisances>;  ///< covariance of a NuisanceVector

/// Gaussian over the nuisance coefficients beta_j of every joint; the joints are independent.
template <typename Scalar, int Dofs>
struct NuisanceGaussian {
  std::array<NuisanceVector<Scalar>, Dofs> mean;        ///< mu, per joint
  std::array<NuisanceMatrix<Scalar>, Dofs> covariance;  ///< Lambda, per joint, positive definite
};

/// One tick: y = m (a + B r + Q p(r)) + N beta + noise, per joint.
template <typename Scalar, int Dofs>
struct PayloadObservation {
  JointVector<Scalar, Dofs> tau = JointVector<Scalar, Dofs>::Zero();        ///< y, external torque [N m]
  PayloadRegressor<Scalar, Dofs> regressor;                                 ///< a, B, Q
  JointVector<Scalar, Dofs> direction = JointVector<Scalar, Dofs>::Zero();  ///< of dry friction, in [-1, 1]
  JointVector<Scalar, Dofs> velocity = JointVector<Scalar, Dofs>::Zero();   ///< dq [rad/s]
};

/// Sums over a window, per joint: the Gram matrix of z = (y, a, B_x, B_y, B_z, 1, -direction, -velocity). They do not
/// depend on the noise level or on the priors of offset and friction, which are needed only for an inference. Sums of
/// two windows can be added. A tick costs O(Dofs), however long the window is. Q is left out, so that the model is
/// linear in (m, m r): it is exact at rest.
template <typename Scalar, int Dofs>
class PayloadStatistics {
 public:
  static constexpr int kColumns = 8;                                          ///< y, a, B, 1, -direction, -velocity
  static constexpr int kConstant = 5;                                         ///< the column of ones
  using Row = Eigen::Matrix<Scalar, kColumns, 1>;                             ///< z of one tick and joint
  using Grams = std::array<Eigen::Matrix<Scalar, kColumns, kColumns>, Dofs>;  ///< per joint

  PayloadStatistics() noexcept {
    for (auto& g : gram_) g.setZero();
  }

  /// z of one tick and joint.
  static Row row(const PayloadObservation<Scalar, Dofs>& o, int joint) noexcept {
    const auto& [a, B, Q] = o.regressor;
    Row z;
    z << o.tau[joint], a[joint], B(joint, 0), B(joint, 1), B(joint, 2), Scalar(1), -o.direction[joint],
        -o.velocity[joint];
    return z;
  }

  /// Adds one tick; its Q is not used. The numbers must be finite, which is not checked.
  void add(const PayloadObservation<Scalar, Dofs>& o) noexcept {
    for (int j = 0; j < Dofs; ++j) {
      const Row z = row(o, j);
      gram_[static_cast<std::size_t>(j)].noalias() += z * z.transpose();
    }
    ++count_;
  }

  /// Adds another window's sums.
  PayloadStatistics& operator+=(const PayloadStatistics& other) noexcept {
    for (std::size_t j = 0; j < gram_.size(); ++j) gram_[j] += other.gram_[j];
    count_ += other.count_;
    return *this;
  }

  int count() const noexcept { return count_; }  ///< ticks that were added

  static constexpr int kSignals = 6;  ///< entries of u = (y, a, B_x, B_y, B_z, 1)
  /// The sums of one joint with its nuisances integrated out.
  struct Marginal {
    /// Products of u, with y - N mu in place of y, weighted by the marginal precision; symmetric. The last column
    /// belongs to a constant torque of this joint.
    Eigen::Matrix<Scalar, kSignals, kSignals> products;
    Scalar log_factor;  ///< -1/2 (log det of the nuisances' posterior precision - log det of their prior precision)
  };

  /// Integrates the nuisances of a joint out of its sums, by Woodbury's identity (docs/theory.md (T39)):
  ///
  ///     w G_uu - w^2 G_un (Lambda^-1 + w G_nn)^-1 G_nu
  ///
  /// @param joint      0 .. Dofs - 1
  /// @param precision  w [1/(N m)^2], > 0
  /// @param nuisance   beta ~ N(mu, Lambda)
  /// @param[out] out   as it was unless the status is Ok
  /// @return Ok; NotPositiveDefinite (the covariance of `nuisance`)
  Status marginal(int joint, Scalar precision, const NuisanceGaussian<Scalar, Dofs>& nuisance,
                  Marginal& out) const noexcept {
    const auto j = static_cast<std::size_t>(joint);
    const Scalar w = precision;
    // With Lambda = L L^T: (Lambda^-1 + w G)^-1 = L (1 + w L^T G L)^-1 L^T, which needs no inverse of Lambda.
    const Cholesky<Scalar, kNuisances> prior(nuisance.covariance[j]);
    if (!prior.positive_definite()) return Status::NotPositiveDefinite;
    const NuisanceMatrix<Scalar>& L = prior.lower();
    const NuisanceMatrix<Scalar> nn = gram_[j].template bottomRightCorner<kNuisances, kNuisances>();
    const Cholesky<Scalar, kNuisances> inner(NuisanceMatrix<Scalar>::Identity() + w * L.transpose() * nn * L);
    if (!inner.positive_definite()) return Status::NotPositiveDefinite;
    // The constant column is also the first nuisance's regressor, so the Gram matrix has it only once.
    Signals uu = gram_[j].template topLeftCorner<kSignals, kSignals>();
    Cross un = gram_[j].template topRightCorner<kSignals, kNuisances>();
    const NuisanceVector<Scalar>& mu = nuisance.mean[j];
    const Eigen::Matrix<Scalar, kSignals, 1> shift = un * mu;
    uu.row(0) -= shift.transpose();
    uu.col(0) -= shift;
    uu(0, 0) += mu.dot(nn * mu);
    un.row(0) -= (nn * mu).transpose();
    const auto half = inner.solve_lower(Eigen::Matrix<Scalar, kNuisances, kSignals>((un * L).transpose()));
    out.products.noalias() = w * uu;
    out.products.noalias() -= (w * w) * half.transpose() * half;
    out.log_factor = -inner.log_det_lower();
    return Status::Ok;
  }

  using Marginals = std::array<Marginal, Dofs>;  ///< per joint

  /// marginal() of every joint.
  /// @param precision  per joint and sample [1/(N m)^2], > 0
  /// @param nuisance   beta ~ N(mu, Lambda)
  /// @param[out] out   one for each joint; not usable unless the status is Ok
  /// @return Ok; NotPositiveDefinite (the covariance of `nuisance`)
  Status marginals(const JointVector<Scalar, Dofs>& precision, const NuisanceGaussian<Scalar, Dofs>& nuisance,
                   Marginals& out) const noexcept {
    for (int j = 0; j < Dofs; ++j) {
      const Status status = marginal(j, precision[j], nuisance, out[static_cast<std::size_t>(j)]);
      if (status != Status::Ok) return status;
    }
    return Status::Ok;
  }

  /// The likelihood of a payload with every joint's nuisances integrated out.
  static PayloadLikelihood<Scalar> likelihood(const Marginals& joints) noexcept {
    Signals total = Signals::Zero();
    Scalar log_factor = Scalar(0);
    for (const Marginal& joint : joints) {
      total += joint.products;
      log_factor += joint.log_factor;
    }
    PayloadLikelihood<Scalar> out = PayloadLikelihood<Scalar>::from_products(total.template topLeftCorner<5, 5>());
    out.log_factor = log_factor;
    return out;
  }
  /// The same, directly from the sums.
  /// @param precision  per joint and sample [1/(N m)^2], > 0
  /// @param nuisance   beta ~ N(mu, Lambda)
  /// @param[out] out   as it was unless the status is Ok
  /// @return Ok; NotPositiveDefinite (the covariance of `nuisance`)
  Status likelihood(const JointVector<Scalar, Dofs>& precision, const NuisanceGaussian<Scalar, Dofs>& nuisance,
                    PayloadLikelihood<Scalar>& out) const noexcept {
    Marginals joints;
    const Status status = marginals(precision, nuisance, joints);
    if (status == Status::Ok) out = likelihood(joints);
    return status;
  }

  /// The likelihood of a payload without nuisances: all error of the torque is white noise.
  /// @param precision  per joint and sample [1/(N m)^2], > 0
  PayloadLikelihood<Scalar> white_likelihood(const JointVector<Scalar, Dofs>& precision) const noexcept {
    Signals total = Signals::Zero();
    for (int j = 0; j < Dofs; ++j)
      total += precision[j] * gram_[static_cast<std::size_t>(j)].template topLeftCorner<kSignals, kSignals>();
    PayloadLikelihood<Scalar> out = PayloadLikelihood<Scalar>::from_products(total.template topLeftCorner<5, 5>());
    out.log_factor = Scalar(0.5) * static_cast<Scalar>(count_) * precision.array().log().sum();
    return out;
  }

  /// Posterior of each joint's nuisances beta ~ N(mu, Lambda) after the window, for an empty hand: the baseline.
  /// @param precision  per joint and sample [1/(N m)^2], > 0
  /// @param prior      beta ~ N(mu, Lambda)
  /// @param[out] out   as it was unless the status is Ok
  /// @return Ok; NotPositiveDefinite (the covariance of `prior`)
  Status nuisance_posterior(const JointVector<Scalar, Dofs>& precision, const NuisanceGaussian<Scalar, Dofs>& prior,
                            NuisanceGaussian<Scalar, Dofs>& out) const noexcept {
    NuisanceGaussian<Scalar, Dofs> posterior;
    for (std::size_t j = 0; j < std::size_t(Dofs); ++j) {
      const Scalar w = precision[static_cast<int>(j)];
      const NuisanceMatrix<Scalar> nn = gram_[j].template bottomRightCorner<kNuisances, kNuisances>();
      const NuisanceVector<Scalar> ny = gram_[j].template topRightCorner<1, kNuisances>().transpose();
      const Cholesky<Scalar, kNuisances> factor(prior.covariance[j]);
      if (!factor.positive_definite()) return Status::NotPositiveDefinite;
      const NuisanceMatrix<Scalar>& L = factor.lower();
      const Cholesky<Scalar, kNuisances> inner(NuisanceMatrix<Scalar>::Identity() + w * L.transpose() * nn * L);
      if (!inner.positive_definite()) return Status::NotPositiveDefinite;
      const NuisanceMatrix<Scalar> half = inner.solve_lower(NuisanceMatrix<Scalar>(L.transpose()));
      posterior.covariance[j] = half.transpose() * half;
      posterior.mean[j] = prior.mean[j] + w * posterior.covariance[j] * (ny - nn * prior.mean[j]);
    }
    out = posterior;
    return Status::Ok;
  }

 private:
  using Signals = Eigen::Matrix<Scalar, kSignals, kSignals>;
  using Cross = Eigen::Matrix<Scalar, kSignals, kNuisances>;

  Grams gram_;
  int count_ = 0;
};

}  // namespace rme
