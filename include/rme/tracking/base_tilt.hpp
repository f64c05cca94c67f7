#pragma once
/// A base that is not level: what the robot's own model then has wrong of gravity, joint by joint.
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/joint_observation.hpp>
#include <rme/tracking/star_gaussian.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

/// The arm's own gravity torque per unit of gravity along each world axis, as in Proprioception::gravity_torque, for
/// links as they are on average: the first is the heaviest, each further one lighter by the same amount, and each has
/// its centre halfway between its joint and the next one (docs/theory.md (T69)). The Jacobian shows where the joints'
/// axes are; a joint is taken to be where its axis is nearest to the joint that it carries.
/// @param J     Jacobian of the end effector, world axes, linear part first
/// @param mass  of the arm [kg]
/// @return nx3 [N m / (m/s^2)]
template <typename Scalar, int Dofs>
Eigen::Matrix<Scalar, Dofs, 3> usual_gravity_torque(const Jacobian<Scalar, Dofs>& J, Scalar mass) noexcept {
  Eigen::Matrix<Scalar, Dofs, 3> torque = Eigen::Matrix<Scalar, Dofs, 3>::Zero();
  Vector3<Scalar> end = Vector3<Scalar>::Zero();  // of the link, seen from the end effector
  for (int link = Dofs - 1; link >= 0; --link) {
    const Vector3<Scalar> axis = J.col(link).template tail<3>(), velocity = J.col(link).template head<3>();
    Vector3<Scalar> joint = axis.cross(velocity);
    joint += axis * axis.dot(end - joint);
    const Vector3<Scalar> centre = Scalar(0.5) * (joint + end);
    const Scalar share = mass * Scalar(2 * (Dofs - link)) / Scalar(Dofs * (Dofs + 1));
    for (int j = 0; j <= link; ++j) {
      const Vector3<Scalar> turns = J.col(j).template tail<3>(), moves = J.col(j).template head<3>();
      torque.row(j) -= share * (moves + turns.cross(centre)).transpose();
    }
    end = joint;
  }
  return torque;
}

/// The tilt of a base: a small rotation about two axes across gravity. In: a block. Out: the torque that the arm's own
/// weight makes of the tilt (docs/theory.md (T24), (T69)), and what the tilt makes of the payload's weight. Real time:
/// nothing allocates.
template <typename Scalar, int Dofs>
class BaseTilt {
 public:
  using Matrix2 = Eigen::Matrix<Scalar, 2, 2>;                   ///< [rad^2]
  using Regressor = Eigen::Matrix<Scalar, Dofs, 2>;              ///< d tau / d angles [N m/rad]
  using Weight = std::array<Eigen::Matrix<Scalar, Dofs, 4>, 2>;  ///< of each angle [N m/rad per kg and per kg m]
  static constexpr double kLevelled =
      0.02;  ///< standard deviation of each angle, if nobody says that the base is tilted [rad]

  /// @param gravity        g [m/s^2], world axes, as the robot's own model has it
  /// @param rated_payload  [kg], > 0
  BaseTilt(const Vector3<Scalar>& gravity, Scalar rated_payload) noexcept
      : arm_mass_(Scalar(kArmMass) * rated_payload) {
    const int least = std::abs(gravity[0]) < std::abs(gravity[2]) ? 0 : 2;
    Vector3<Scalar> first = gravity.cross(Vector3<Scalar>::Unit(least));
    first /= std::sqrt(detail::dot(first, first));
    const Vector3<Scalar> second = gravity.cross(first) / std::sqrt(detail::dot(gravity, gravity));
    along_[0] = first.cross(gravity);  // turning gravity by a small angle about e adds e x g to it
    along_[1] = second.cross(gravity);
  }
  /// How the arm's own weight shows the tilt. If the host does not say what gravity does to the arm, its links are
  /// usual ones.
  Regressor regressor(const TorqueBlock<Scalar, Dofs>& block) const noexcept {
    const Eigen::Matrix<Scalar, Dofs, 3> pull =
        block.gravity_torque ? *block.gravity_torque : usual_gravity_torque<Scalar, Dofs>(block.jacobian, arm_mass_);
    Regressor out = Regressor::Zero();
    for (int j = 0; j < Dofs; ++j)
      for (int k = 0; k < 2; ++k)
        for (int axis = 0; axis < 3; ++axis) out(j, k) -= pull(j, axis) * along_[static_cast<std::size_t>(k)][axis];
    return out;
  }
  /// How the weight of what is held shows the tilt: the regressor of (m, m r) per radian of each angle.
  /// @param block  for its pose
  Weight weight(const TorqueBlock<Scalar, Dofs>& block) const noexcept {
    Weight out;
    for (std::size_t k = 0; k < 2; ++k) {
      const Matrix3<Scalar> lever = detail::product(skew(along_[k]), block.rotation);
      out[k].setZero();
      for (int j = 0; j < Dofs; ++j) {
        for (int axis = 0; axis < 3; ++axis) {
          out[k](j, 0) += block.jacobian(axis, j) * along_[k][axis];
          for (int i = 0; i < 3; ++i) out[k](j, 1 + i) -= block.jacobian(3 + axis, j) * lever(axis, i);
        }
      }
    }
    return out;
  }
  /// What links that weigh other than usual ones make of the torque that a tilt is expected to show, as variances of
  /// the joints' torques [(N m)^2]. 0 if the tilt is known not to be.
  /// @param regressor  of the block
  /// @param star       of a story
  static JointVector<Scalar, Dofs> unlike_variance(const Regressor& regressor,
                                                   const StarGaussian<Scalar, Dofs>& star) noexcept {
    const Matrix2 square = star.tilt_square();
    JointVector<Scalar, Dofs> out;
    for (int j = 0; j < Dofs; ++j) {
      out[j] = Scalar(0);
      for (int i = 0; i < 2; ++i)
        for (int k = 0; k < 2; ++k)
          out[j] += Scalar(kUnlike * kUnlike) * regressor(j, i) * square(i, k) * regressor(j, k);
    }
    return out;
  }

 private:
  static constexpr double kArmMass = 5;    // of the arm itself, per rated payload
  static constexpr double kUnlike = 0.34;  // how far the torque is from that of usual links, as a share of it
  Scalar arm_mass_;                        // [kg]
  std::array<Vector3<Scalar>, 2> along_;   // by how much gravity changes with each angle [m/s^2]
};

}  // namespace rme
