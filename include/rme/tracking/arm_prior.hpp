#pragma once
/// Priors before the first sample: of an arm's torque errors, and of what it may pick up.
#include <cmath>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/tracking/inertial_parameters.hpp>
#include <rme/tracking/sensing_kind.hpp>

namespace rme {

/// Prior of the joints' noise, offset, residual and friction. An arm's torques grow with the payload that it is made
/// for, so one number scales them: the defaults are those of a Panda (3 kg) times rated_payload / 3 kg. For the last
/// three joints, the wrist, they are multiplied by 0.4. All numbers are > 0.
template <typename Scalar, int Dofs>
struct ArmPrior {
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint
  Vector noise;     ///< standard deviation of a block's mean torque, before it is learned [N m]
  Vector offset;    ///< standard deviation of the torque sensor's offset [N m]
  Vector residual;  ///< scale of the joint: size of its noise and residual relative to a Panda's (no unit)
  Vector coulomb;   ///< mean of the Coulomb friction [N m]
  Vector viscous;   ///< mean of the viscous friction [N m s/rad]
  /// Standard deviation of both, relative to their means. Of an arm that was never measured, half; friction that is
  /// known better hides less of a payload that is held from the start.
  Scalar friction_std = Scalar(0.5);

  /// The defaults.
  /// @param rated_payload  [kg], > 0
  static ArmPrior of(Scalar rated_payload) noexcept {
    Vector share = Vector::Ones();
    for (int j = Dofs > 3 ? Dofs - 3 : 0; j < Dofs; ++j) share[j] = Scalar(0.4);
    share *= rated_payload / Scalar(3);
    return {detail::scaled(Scalar(0.03), share), detail::scaled(Scalar(0.15), share), share,
            detail::scaled(Scalar(0.2), share), detail::scaled(Scalar(0.1), share)};
  }
};

/// Prior of what a hand may pick up: a Gaussian over phi.
template <typename Scalar>
struct PayloadPrior {
  Scalar mass_mean;          ///< mean of the mass [kg], 0 to the rated payload
  Scalar mass_std;           ///< standard deviation of the mass [kg], > 0
  Vector3<Scalar> com_mean;  ///< mean of the centre of mass [m], end-effector axes, from the end-effector origin
  Vector3<Scalar> com_std;   ///< standard deviations of its entries [m], > 0

  /// The default: a mass of 0.25 +- 0.3 of the rated payload, with its centre at (0, 0, 10) +- (6, 6, 7) cm.
  /// @param rated_payload  [kg], > 0
  static PayloadPrior of(Scalar rated_payload) noexcept {
    return {Scalar(0.25) * rated_payload, Scalar(0.3) * rated_payload, Vector3<Scalar>(0, 0, Scalar(0.1)),
            Vector3<Scalar>(Scalar(0.06), Scalar(0.06), Scalar(0.07))};
  }

  /// Mean of phi, 10x1; that of the inertia is zero.
  InertialVector<Scalar> mean() const noexcept {
    InertialVector<Scalar> phi = InertialVector<Scalar>::Zero();
    phi[0] = mass_mean;
    for (int i = 0; i < 3; ++i) phi[1 + i] = mass_mean * com_mean[i];
    return phi;
  }
  /// Lower triangular factor L of the covariance L L^T of phi, 10x10. With r independent of m (docs/theory.md (T13)),
  ///
  ///     cov(m, m r) = r0 var(m),   cov(m r) = r0 r0^T var(m) + Sigma_r E[m^2]
  ///
  /// @param square_mass  E[m^2] [kg^2], > 0. That of the prior, square_mass(), hardly constrains the centre of mass of
  ///                     a light object, so pass a better guess if there is one
  InertialMatrix<Scalar> factor(Scalar square_mass) const noexcept {
    using std::sqrt;
    const Scalar mass = sqrt(square_mass);
    InertialMatrix<Scalar> L = InertialMatrix<Scalar>::Zero();
    L(0, 0) = mass_std;
    for (int i = 0; i < 3; ++i) {
      L(1 + i, 0) = com_mean[i] * mass_std;
      L(1 + i, 1 + i) = com_std[i] * mass;
    }
    // Standard deviation of each entry of the inertia.
    for (int i = 4; i < kInertial; ++i) L(i, i) = mass * square_arm();
    return L;
  }
  /// E[m^2] of this prior [kg^2].
  Scalar square_mass() const noexcept { return mass_mean * mass_mean + mass_std * mass_std; }
  /// E[|r|^2] of this prior [m^2]: the standard deviation of each entry of the inertia per mass.
  Scalar square_arm() const noexcept { return detail::dot(com_mean, com_mean) + detail::dot(com_std, com_std); }
};

}  // namespace rme
