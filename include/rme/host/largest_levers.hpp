#pragma once
/// How far the end effector can be from each joint's axis, from a Jacobian in any one pose.
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/core/types.hpp>

namespace rme {

/// For each joint an upper bound of |J_v,j(q)|, the distance of the end-effector origin from its axis, over all poses
/// q.
///
/// In any pose, a chain of points, one on each axis from joint j's to the last and then the end-effector origin, is at
/// least as long as the distance from axis j to the origin. Two consecutive points are fixed to the same link, so that
/// the chain is equally long in all poses. One pose is therefore enough to compute it (docs/theory_control.md (C27)).
/// Every choice of the points gives a bound. They are moved along their axes, one after the other, to where the chain
/// is shortest. Joint limits are not used: they could only make the bound smaller.
/// @param jacobian  J of revolute joints, in the order of the chain: 6 x Dofs, linear rows first; in any pose
/// @return [m], Dofs x 1; infinity for a joint that is not revolute and for those before it, since the links between
///         have no fixed length then
template <typename Scalar, int Dofs>
JointVector<Scalar, Dofs> largest_levers(const Jacobian<Scalar, Dofs>& jacobian) noexcept {
  using std::abs;
  using Vector = Vector3<Scalar>;
  constexpr int kSweeps = 20;
  JointVector<Scalar, Dofs> levers = JointVector<Scalar, Dofs>::Constant(std::numeric_limits<Scalar>::infinity());
  // Points of the chain, relative to the end-effector origin, which is the last one.
  Eigen::Matrix<Scalar, 3, Dofs> foot, axis;  // point of each axis next to the origin; unit vector along it
  Eigen::Matrix<Scalar, 3, Dofs + 1> point;
  point.col(Dofs).setZero();
  for (int j = Dofs - 1; j >= 0; --j) {
    axis.col(j) = jacobian.template block<3, 1>(3, j);
    if (!(abs(axis.col(j).norm() - Scalar(1)) < Scalar(1e-3))) return levers;
    axis.col(j).normalize();
    const Vector velocity =
        jacobian.template block<3, 1>(0, j);  // axis x (origin - foot), so that axis x it is the foot
    const Vector direction = axis.col(j);
    foot.col(j) = direction.cross(velocity);
    const auto along = [&](int i, const Vector& p) { return axis.col(i).dot(Vector(p - foot.col(i))); };
    const auto beside = [&](int i, const Vector& p) {
      return Vector(p - foot.col(i) - along(i, p) * axis.col(i)).norm();
    };
    const auto move = [&](int i, Scalar s) { point.col(i) = foot.col(i) + s * axis.col(i); };
    move(j, along(j, point.col(j + 1)));
    for (int sweep = 0; sweep < kSweeps; ++sweep) {
      for (int i = j + 1; i < Dofs; ++i) {  // between its neighbours as a mirror would reflect
        const Vector before = point.col(i - 1), after = point.col(i + 1);
        const Scalar a = beside(i, before), b = beside(i, after);
        move(i, a + b > 0 ? (along(i, before) * b + along(i, after) * a) / (a + b) : along(i, before));
      }
      move(j, along(j, point.col(j + 1)));
    }
    levers[j] = Scalar(0);
    for (int i = j; i < Dofs; ++i) levers[j] += Vector(point.col(i + 1) - point.col(i)).norm();
  }
  return levers;
}

}  // namespace rme
