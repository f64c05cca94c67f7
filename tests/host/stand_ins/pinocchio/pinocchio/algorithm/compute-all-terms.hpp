#pragma once
#include "pinocchio/multibody/model.hpp"

namespace pinocchio {

/// M, its upper triangle alone; g; joint placements and Jacobians, but no frame's placement.
template <typename Q, typename V>
void computeAllTerms(const Model& model, Data& data, const Eigen::MatrixBase<Q>& q, const Eigen::MatrixBase<V>& v) {
  stand_in::check_size(v.size(), model.nv);
  const auto dynamics = stand_in::arm_of(model).dynamics(stand_in::angles(model, q), stand_in::of_arm(v));
  data.M.topLeftCorner<7, 7>().triangularView<Eigen::Upper>() = dynamics.mass_matrix;
  data.g.head<7>() = dynamics.gravity;
  data.flange = model.arm.kinematics(stand_in::angles(model, q));
}

}  // namespace pinocchio
