#pragma once
#include "pinocchio/multibody/model.hpp"

namespace pinocchio {

/// M, its upper triangle alone; g; joint placements and Jacobians, but no frame's placement; the whole arm's mass, and
/// the Jacobian of its centre of mass.
template <typename Q, typename V>
void computeAllTerms(const Model& model, Data& data, const Eigen::MatrixBase<Q>& q, const Eigen::MatrixBase<V>& v) {
  stand_in::check_size(v.size(), model.nv);
  const auto dynamics = stand_in::arm_of(model).dynamics(stand_in::angles(model, q), stand_in::of_arm(v));
  const Eigen::Index n = stand_in::joints_of_arm(model);
  data.M.topLeftCorner(n, n).triangularView<Eigen::Upper>() = dynamics.mass_matrix.topLeftCorner(n, n);
  data.g.head(n) = dynamics.gravity.head(n);
  data.flange = model.arm.kinematics(stand_in::angles(model, q));
  data.mass[0] = 2.5;  // of the base; it has a part in the mass, and makes the centre move less
  for (const rme::examples::Link& link : model.arm.links) data.mass[0] += link.body.mass;
  rme::examples::ArmModel<7> arm = model.arm;
  for (int axis = 0; axis < 3; ++axis) {
    arm.gravity_vector = Eigen::Vector3d::Unit(axis);
    data.Jcom.row(axis).head(n) =
        -arm.dynamics(stand_in::angles(model, q), Eigen::Matrix<double, 7, 1>::Zero()).gravity.head(n).transpose() /
        data.mass[0];
  }
}

}  // namespace pinocchio
