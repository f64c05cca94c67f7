#pragma once
/// The ten standard inertial parameters of a payload, in which its joint torque is linear.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <rme/core/flange_motion.hpp>
#include <rme/core/payload.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Number of inertial parameters. phi = (m, m r_x, m r_y, m r_z, I_xx, I_xy, I_xz, I_yy, I_yz, I_zz), in [kg, kg m, kg
/// m^2], end-effector axes, I about the end-effector origin (docs/theory.md (T10)).
inline constexpr int kInertial = 10;
template <typename Scalar>
using InertialVector = Eigen::Matrix<Scalar, kInertial, 1>;  ///< phi
template <typename Scalar>
using InertialMatrix = Eigen::Matrix<Scalar, kInertial, kInertial>;  ///< covariance of phi, or a factor of it

/// A rigid body on the end effector; all zero means an empty hand.
template <typename Scalar>
struct InertialParameters {
  Scalar mass = Scalar(0);                                 ///< m [kg]
  Vector3<Scalar> first_moment = Vector3<Scalar>::Zero();  ///< m r [kg m], end-effector axes
  Matrix3<Scalar> inertia = Matrix3<Scalar>::Zero();       ///< I [kg m^2], the same axes, about the end-effector origin

  /// phi, 10x1.
  InertialVector<Scalar> vector() const noexcept {
    const Matrix3<Scalar>& I = inertia;
    return (InertialVector<Scalar>() << mass, first_moment, I(0, 0), I(0, 1), I(0, 2), I(1, 1), I(1, 2), I(2, 2))
        .finished();
  }
  /// The inverse of vector().
  /// @param phi  10x1
  static InertialParameters from_vector(const InertialVector<Scalar>& phi) noexcept {
    InertialParameters out{phi[0], phi.template segment<3>(1), Matrix3<Scalar>()};
    out.inertia << phi[4], phi[5], phi[6], phi[5], phi[7], phi[8], phi[6], phi[8], phi[9];
    return out;
  }
  /// From mass and centre of mass, and the inertia about that centre, by the parallel-axis theorem.
  /// @param payload    mass [kg] and centre of mass [m], end-effector axes
  /// @param about_com  inertia about the centre of mass [kg m^2], end-effector axes
  static InertialParameters of_body(const Payload<Scalar>& payload, const Matrix3<Scalar>& about_com) noexcept {
    const Matrix3<Scalar> lever = skew(payload.com);
    return {payload.mass, payload.mass * payload.com, about_com - payload.mass * lever * lever};
  }

  /// Mass and centre of mass; an empty hand unless mass > 0.
  Payload<Scalar> payload() const noexcept {
    return mass > 0 ? Payload<Scalar>{mass, first_moment / mass} : Payload<Scalar>();
  }
  /// Inertia about the centre of mass [kg m^2], end-effector axes.
  Matrix3<Scalar> inertia_about_com() const noexcept {
    const Matrix3<Scalar> lever = skew(payload().com);
    return inertia + mass * lever * lever;
  }
  /// Whether a body of positive density can have these parameters: the mass is above zero, and the principal moments
  /// about the centre of mass obey the triangle inequalities. The pseudo-inertia is then positive definite (Wensing,
  /// Kim and Slotine, RA-L 2018).
  bool physically_consistent() const noexcept { return mass > 0 && least_density_moment() > 0; }
  /// The nearest parameters with the same mass and centre of mass whose second moment of density about the centre of
  /// mass has no eigenvalue below mass * radius^2. An empty hand unless mass > 0.
  /// @param radius  lower bound of the payload's root mean square extent along any axis [m], > 0
  InertialParameters made_consistent(Scalar radius) const noexcept {
    if (!(mass > 0)) return InertialParameters();
    Eigen::SelfAdjointEigenSolver<Matrix3<Scalar>> solver;
    solver.computeDirect(density_moment());
    const Vector3<Scalar> moments = solver.eigenvalues().cwiseMax(mass * radius * radius);
    const Matrix3<Scalar> sigma = solver.eigenvectors() * moments.asDiagonal() * solver.eigenvectors().transpose();
    return of_body(payload(), sigma.trace() * Matrix3<Scalar>::Identity() - sigma);
  }

 private:
  // Second moment of density: integral of rho s s^T over the body, s from its centre of mass. (tr I_c / 2) 1 - I_c.
  Matrix3<Scalar> density_moment() const noexcept {
    const Matrix3<Scalar> I = inertia_about_com();
    return Scalar(0.5) * I.trace() * Matrix3<Scalar>::Identity() - I;
  }
  Scalar least_density_moment() const noexcept {
    Eigen::SelfAdjointEigenSolver<Matrix3<Scalar>> solver;
    solver.computeDirect(density_moment(), Eigen::EigenvaluesOnly);
    return solver.eigenvalues()[0];
  }
};

/// Y, 6 x 10: a payload phi exerts the wrench Y phi on the end effector (force, then moment; world axes, moment about
/// the end-effector origin). Y follows from Newton's and Euler's equations about the end-effector origin,
///
///     f = m s - (alpha x + omega x omega x) m r,   n = m r x s - I alpha - omega x I omega,   s = g - a
///
/// with a the origin's acceleration (docs/theory.md (T11, T12)).
/// @param rotation  R, end-effector axes to world axes
/// @param gravity   g [m/s^2], world axes
/// @param motion    omega, alpha and a of the flange, world axes
template <typename Scalar>
Eigen::Matrix<Scalar, 6, kInertial> inertial_wrench_regressor(const Matrix3<Scalar>& rotation,
                                                              const Vector3<Scalar>& gravity,
                                                              const FlangeMotion<Scalar>& motion) noexcept {
  using Inertia = Eigen::Matrix<Scalar, 3, 6>;
  const Vector3<Scalar> specific_force = detail::difference(gravity, motion.linear_acceleration);
  const Vector3<Scalar> omega = detail::transposed_product(rotation, motion.angular_velocity);  // end-effector axes
  const Vector3<Scalar> alpha = detail::transposed_product(rotation, motion.angular_acceleration);
  // I v = [v] (I_xx, I_xy, I_xz, I_yy, I_yz, I_zz)
  const auto inertia_times = [](const Vector3<Scalar>& v) {
    Inertia m;
    m << v[0], v[1], v[2], 0, 0, 0, 0, v[0], 0, v[1], v[2], 0, 0, 0, v[0], 0, v[1], v[2];
    return m;
  };
  const Matrix3<Scalar> omega_cross = skew(omega);
  Matrix3<Scalar> acceleration = skew(alpha);  // maps a point's lever to its acceleration relative to the origin
  acceleration += detail::product(omega_cross, omega_cross);
  Inertia moment = inertia_times(alpha);
  moment += detail::product(omega_cross, inertia_times(omega));
  const Matrix3<Scalar> force_of_lever = detail::product(rotation, acceleration);
  const Matrix3<Scalar> moment_of_lever = detail::product(skew(specific_force), rotation);
  const Inertia moment_of_inertia = detail::product(rotation, moment);
  Eigen::Matrix<Scalar, 6, kInertial> Y = Eigen::Matrix<Scalar, 6, kInertial>::Zero();
  for (int i = 0; i < 3; ++i) {
    Y(i, 0) = specific_force[i];
    for (int j = 0; j < 3; ++j) {
      Y(i, 1 + j) = -force_of_lever(i, j);
      Y(3 + i, 1 + j) = -moment_of_lever(i, j);
    }
    for (int j = 0; j < 6; ++j) Y(3 + i, 4 + j) = -moment_of_inertia(i, j);
  }
  return Y;
}

}  // namespace rme
