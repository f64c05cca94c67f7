#pragma once
/// About how gravity pulls at the joints of an arm whose links nobody has weighed.
#include <rme/core/types.hpp>

namespace rme {

/// The arm's own gravity torque per unit of gravity along each world axis, as in Proprioception::gravity_torque, for links
/// as they are on average: the first is the heaviest, each further one lighter by the same amount, and each has its centre
/// halfway between its joint and the next one (docs/theory.md (T69)). The Jacobian shows where the joints' axes are; a
/// joint is taken to be where its axis is nearest to the joint that it carries.
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

}  // namespace rme
