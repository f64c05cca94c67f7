#pragma once
/// The unknowns of a filter, and what a joint's torque says of them.
#include <Eigen/Core>
#include <rme/core/types.hpp>
#include <rme/tracking/inertial_parameters.hpp>

namespace rme {

/// What all joints share, x: first what belongs to the arm, then the payload. Each is the index of a first entry.
enum Shared : int {
  kLag = 0,      ///< lag of the torque beyond the stated observer, in time constants of that observer (no unit)
  kTool = 1,     ///< mass and first moment that the robot's own model lacks at the last link, 4 entries [kg, kg m]
  kTilt = 5,     ///< error of gravity's direction: rotation about two axes across gravity, 2 entries [rad]
  kPayload = 7,  ///< phi of the payload, 10 entries; if something is poured, phi before that
  kPoured = 17,  ///< what has been poured in so far, (m, m r), 4 entries [kg, kg m]
  kSwing = 17,   ///< in its place, if the payload swings: the force of that, 3 entries, world axes [N]
};
inline constexpr int kArmShared = kPayload;  ///< number of shared unknowns of an empty hand
inline constexpr int kHeldShared = kPoured;  ///< the same, if something is held
inline constexpr int kShared = kPoured + 4;  ///< the same, if something is poured, or swings: all of them
template <typename Scalar>
using SharedVector = Eigen::Matrix<Scalar, kShared, 1>;  ///< x, in the order of Shared
template <typename Scalar>
using SharedMatrix = Eigen::Matrix<Scalar, kShared, kShared>;  ///< covariance of x, or a factor of it

/// What a joint's torque contains of its own. Nuisance vectors have this order.
enum Nuisance : int {
  kOffset,    ///< offset of the torque sensor [N m]
  kCoulomb,   ///< Coulomb friction of a moving joint, against its motion [N m]
  kViscous,   ///< viscous friction [N m s/rad]
  kResidual,  ///< error of the arm's rigid-body model; changes as the arm moves [N m]
  kStiction,  ///< friction torque of a resting joint [N m]
  kGain,      ///< relative error of the torque, of what the payload makes of it (no unit)
};
inline constexpr int kJointNuisances = 6;  ///< number of nuisances of a joint

template <typename Scalar>
using JointNuisanceVector = Eigen::Matrix<Scalar, kJointNuisances, 1>;  ///< beta_j, in the order of Nuisance
template <typename Scalar>
using JointNuisanceMatrix = Eigen::Matrix<Scalar, kJointNuisances, kJointNuisances>;  ///< covariance of beta_j

/// Measurement of one joint's torque, averaged over a block of samples (docs/theory.md (T14)): y = h^T x + c^T beta_j
/// + noise.
template <typename Scalar>
struct JointObservation {
  Scalar torque;                  ///< y [N m]
  SharedVector<Scalar> h;         ///< regressor of x
  JointNuisanceVector<Scalar> c;  ///< regressor of the joint's nuisances
  Scalar noise;                   ///< variance of the noise [(N m)^2], > 0
};

}  // namespace rme
