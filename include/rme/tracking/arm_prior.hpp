#pragma once
/// What is believed of an arm and of what it may pick up, before the first sample.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/tracking/inertial_parameters.hpp>

namespace rme {

/// What kind of torque sensing an arm has; the tracker finds out which, and remembers it.
enum class Sensing : std::uint8_t {
  LinkSide,       ///< behind the gears: the sensor sees no friction
  JointFriction,  ///< joint friction shows in tau_ext
  RoughModel,     ///< so does what the arm's model gets wrong: motor currents, heavy gears, quick motion
};
inline constexpr std::size_t kSensings = 3;  ///< kinds of torque sensing

/// Priors over the joints' nuisances, per joint. An arm's torques grow with what it lifts, so that one number scales
/// them: the defaults are what a Panda (3 kg) shows, times rated_payload / 3 kg; the last three joints, the wrist's,
/// have 0.4 of the others'.
template <typename Scalar, int Dofs>
struct ArmPrior {
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint
  Vector noise;     ///< standard deviation of a block's mean torque: where its learning begins [N m]
  Vector offset;    ///< standard deviation of the torque sensor's offset [N m]
  Vector residual;  ///< scale of the joint: relative size of the rigid-body model's residual, whose size is learned
  Vector coulomb;   ///< Coulomb friction: mean, with half of it as standard deviation [N m]
  Vector viscous;   ///< viscous friction, likewise [N m s/rad]

  /// The defaults of an arm that is made for this payload [kg], > 0.
  static ArmPrior of(Scalar rated_payload) noexcept {
    Vector share = Vector::Ones();
    for (int j = Dofs > 3 ? Dofs - 3 : 0; j < Dofs; ++j) share[j] = Scalar(0.4);
    share *= rated_payload / Scalar(3);
    return {detail::scaled(Scalar(0.03), share), detail::scaled(Scalar(0.15), share), share,
            detail::scaled(Scalar(0.2), share), detail::scaled(Scalar(0.1), share)};
  }
};

/// What a hand may pick up: N over phi.
template <typename Scalar>
struct PayloadPrior {
  Scalar mass_mean;          ///< [kg]
  Scalar mass_std;           ///< [kg]
  Vector3<Scalar> com_mean;  ///< [m], end-effector axes, from the end-effector origin
  Vector3<Scalar> com_std;   ///< [m]

  /// Mass of 0.25 +- 0.3 of the rated payload, centre 10 cm ahead of the flange and near its axis.
  static PayloadPrior of(Scalar rated_payload) noexcept {
    return {Scalar(0.25) * rated_payload, Scalar(0.3) * rated_payload, Vector3<Scalar>(0, 0, Scalar(0.1)),
            Vector3<Scalar>(Scalar(0.06), Scalar(0.06), Scalar(0.07))};
  }

  /// Mean of phi; that of the inertia is zero.
  InertialVector<Scalar> mean() const noexcept {
    InertialVector<Scalar> phi = InertialVector<Scalar>::Zero();
    phi[0] = mass_mean;
    for (int i = 0; i < 3; ++i) phi[1 + i] = mass_mean * com_mean[i];
    return phi;
  }
  /// Covariance of phi, lower triangular factor. The moments of m r for a mass that is known roughly: with r
  /// independent of m, cov(m, m r) = r0 var(m) and cov(m r) = r0 r0^T var(m) + Sigma_r E[m^2] (docs/theory.md (T13));
  /// with the prior's own E[m^2], the centre of mass of a light object would hardly be constrained, so pass a better
  /// guess where there is one.
  /// @param square_mass  E[m^2] [kg^2], > 0
  InertialMatrix<Scalar> factor(Scalar square_mass) const noexcept {
    using std::sqrt;
    const Scalar mass = sqrt(square_mass);
    InertialMatrix<Scalar> L = InertialMatrix<Scalar>::Zero();
    L(0, 0) = mass_std;
    for (int i = 0; i < 3; ++i) {
      L(1 + i, 0) = com_mean[i] * mass_std;
      L(1 + i, 1 + i) = com_std[i] * mass;
    }
    // Of m (|r|^2 - ...) with |r| up to twice its prior's spread.
    const Scalar arm = detail::dot(com_mean, com_mean) + detail::dot(com_std, com_std);
    for (int i = 4; i < kInertial; ++i) L(i, i) = mass * arm;
    return L;
  }
  /// E[m^2] [kg^2].
  Scalar square_mass() const noexcept { return mass_mean * mass_mean + mass_std * mass_std; }
};

}  // namespace rme
