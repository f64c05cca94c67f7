#pragma once
// As much of Pinocchio as the snippets of docs/embedding.md use, by its names and signatures. Every model is a Panda.
// What the real functions leave alone holds NaN here.
#include <cstddef>
#include <limits>
#include <string>
#include <synthetic_arm/panda.hpp>

namespace pinocchio {

using FrameIndex = std::size_t;
enum ReferenceFrame { WORLD, LOCAL, LOCAL_WORLD_ALIGNED };

class SE3 {
 public:
  const Eigen::Matrix3d& rotation() const { return rotation_; }
  void rotation(const Eigen::Matrix3d& R) { rotation_ = R; }

 private:
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
};

struct Model {
  FrameIndex getFrameId(const std::string& name) const { return name == "flange" ? 0 : 1; }  // 1 is none
};

struct Data {
  explicit Data(const Model&) {}
  static Eigen::MatrixXd nowhere(int rows, int columns) {
    return Eigen::MatrixXd::Constant(rows, columns, std::numeric_limits<double>::quiet_NaN());
  }
  Eigen::MatrixXd M = nowhere(7, 7), C = nowhere(7, 7);
  Eigen::VectorXd g = nowhere(7, 1);
  SE3 oMf;
  rme::examples::Kinematics<7> flange;  // not Pinocchio's: what stands for its joint placements and Jacobians
};

template <typename Q, typename V>
void computeAllTerms(const Model&, Data& data, const Eigen::MatrixBase<Q>& q, const Eigen::MatrixBase<V>& v) {
  const auto dynamics = rme::examples::panda().dynamics(q, v);
  data.M.triangularView<Eigen::Upper>() = dynamics.mass_matrix;
  data.g = dynamics.gravity;
  data.flange = rme::examples::panda().kinematics(q);
}

/// C with C dq and C^T dq as they are: the one of least norm that has both.
template <typename Q, typename V>
const Eigen::MatrixXd& computeCoriolisMatrix(const Model&, Data& data, const Eigen::MatrixBase<Q>& q,
                                             const Eigen::MatrixBase<V>& v) {
  const auto dynamics = rme::examples::panda().dynamics(q, v);
  const double vv = v.squaredNorm();
  data.C.setZero();
  if (vv > 0)
    data.C.noalias() = (dynamics.coriolis * v.transpose() + v * dynamics.coriolis_transpose.transpose()) / vv -
                       v * (v.dot(dynamics.coriolis) / (vv * vv)) * v.transpose();
  return data.C;
}

template <typename Matrix>
void getFrameJacobian(const Model&, Data& data, FrameIndex, ReferenceFrame frame, const Eigen::MatrixBase<Matrix>& J) {
  auto& jacobian = const_cast<Eigen::MatrixBase<Matrix>&>(J);  // Eigen's way to write to an argument of any type
  jacobian = data.flange.jacobian;
  if (frame == LOCAL) {
    jacobian.template topRows<3>() = data.flange.rotation.transpose() * data.flange.jacobian.topRows<3>();
    jacobian.template bottomRows<3>() = data.flange.rotation.transpose() * data.flange.jacobian.bottomRows<3>();
  } else if (frame == WORLD) {
    jacobian.template topRows<3>() += rme::skew(data.flange.position) * data.flange.jacobian.bottomRows<3>();
  }
}

inline const SE3& updateFramePlacement(const Model&, Data& data, FrameIndex) {
  data.oMf.rotation(data.flange.rotation);
  return data.oMf;
}

namespace urdf {
inline Model& buildModelFromXML(const std::string& /*xml_stream*/, Model& model) {
  return model;
}
}  // namespace urdf

}  // namespace pinocchio
