#pragma once
#include "pinocchio/multibody/model.hpp"

namespace pinocchio {

/// After computeAllTerms. Writes the columns of the joints that move the frame, and no others.
template <typename Matrix>
void getFrameJacobian(const Model& model, Data& data, FrameIndex frame_id, ReferenceFrame reference_frame,
                      const Eigen::MatrixBase<Matrix>& J) {
  if (frame_id >= model.frames.size()) throw std::invalid_argument("the index of the frame is out of bounds");
  stand_in::check_size(J.rows(), 6);
  stand_in::check_size(J.cols(), model.nv);
  auto& out = const_cast<Eigen::MatrixBase<Matrix>&>(J);  // Eigen's way to write to an argument of any type
  Eigen::Matrix<double, 6, 7> jacobian = data.flange.jacobian;
  if (reference_frame == LOCAL) {
    jacobian.topRows<3>() = data.flange.rotation.transpose() * data.flange.jacobian.topRows<3>();
    jacobian.bottomRows<3>() = data.flange.rotation.transpose() * data.flange.jacobian.bottomRows<3>();
  } else if (reference_frame == WORLD) {
    jacobian.topRows<3>() += rme::skew(data.flange.position) * data.flange.jacobian.bottomRows<3>();
  }
  for (Eigen::Index j = 0; j < std::min<Eigen::Index>(7, J.cols()); ++j) out.col(j) = jacobian.col(j);
}

inline const SE3& updateFramePlacement(const Model& model, Data& data, FrameIndex frame_id) {
  (void)model.frames.at(frame_id);
  return data.oMf[frame_id] = SE3(data.flange.rotation, data.flange.position);
}

}  // namespace pinocchio
