#pragma once
#include "pinocchio/multibody/model.hpp"

namespace pinocchio {

/// C with C dq and C^T dq as they are: the one of least norm that has both.
template <typename Q, typename V>
const Eigen::MatrixXd& computeCoriolisMatrix(const Model& model, Data& data, const Eigen::MatrixBase<Q>& q,
                                             const Eigen::MatrixBase<V>& v) {
  stand_in::check_size(v.size(), model.nv);
  const Eigen::Matrix<double, 7, 1> dq = stand_in::of_arm(v);
  const auto dynamics = model.arm.dynamics(stand_in::angles(model, q), dq);
  const double vv = dq.squaredNorm();
  data.C.setZero();
  const Eigen::Index n = stand_in::joints_of_arm(model);
  if (vv > 0) {
    const Eigen::Matrix<double, 7, 7> C =
        (dynamics.coriolis * dq.transpose() + dq * dynamics.coriolis_transpose.transpose()) / vv -
        dq * (dq.dot(dynamics.coriolis) / (vv * vv)) * dq.transpose();
    data.C.topLeftCorner(n, n) = C.topLeftCorner(n, n);
  }
  return data.C;
}

/// g, which is data.g as well.
template <typename Q>
const Eigen::VectorXd& computeGeneralizedGravity(const Model& model, Data& data, const Eigen::MatrixBase<Q>& q) {
  const Eigen::Index n = stand_in::joints_of_arm(model);
  data.g.head(n) =
      stand_in::arm_of(model).dynamics(stand_in::angles(model, q), Eigen::Matrix<double, 7, 1>::Zero()).gravity.head(n);
  return data.g;
}

}  // namespace pinocchio
