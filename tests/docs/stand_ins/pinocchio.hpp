#pragma once
// As much of Pinocchio as the snippets of docs/embedding.md use, by its names and signatures. A URDF's model is a Panda
// with a hand: nine joints, the last two a gripper's fingers. What the real functions leave alone holds NaN here; what
// they refuse throws, and so does what they would read out of bounds.
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <vector>

namespace pinocchio {

using JointIndex = std::size_t;
using FrameIndex = std::size_t;
enum ReferenceFrame { WORLD, LOCAL, LOCAL_WORLD_ALIGNED };

class SE3 {
 public:
  SE3() = default;
  SE3(const Eigen::Matrix3d& R, const Eigen::Vector3d& p) : rotation_(R), translation_(p) {}
  const Eigen::Matrix3d& rotation() const { return rotation_; }
  const Eigen::Vector3d& translation() const { return translation_; }

 private:
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Eigen::Vector3d translation_ = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// Mass, centre of mass, inertia about that centre.
class Inertia {
 public:
  Inertia(double mass, const Eigen::Vector3d& com, const Eigen::Matrix3d& rotational_inertia)
      : body_{mass, com, rotational_inertia} {}
  const rme::examples::RigidBody& body() const { return body_; }  // not Pinocchio's

 private:
  rme::examples::RigidBody body_;
};

struct Frame {
  std::string name;
  JointIndex parentJoint;
  SE3 placement;
};

struct Model {
  int nq = 0, nv = 0, njoints = 1;
  std::vector<std::string> names = {"universe"};
  std::vector<Frame> frames;
  rme::examples::ArmModel<7> arm = rme::examples::panda();  // not Pinocchio's

  bool existFrame(const std::string& name) const { return getFrameId(name) < frames.size(); }
  FrameIndex getFrameId(const std::string& name) const {  // frames.size() if there is none
    FrameIndex i = 0;
    while (i < frames.size() && frames[i].name != name) ++i;
    return i;
  }
  void appendBodyToJoint(JointIndex joint, const Inertia& inertia, const SE3& placement) {
    const rme::examples::RigidBody& body = inertia.body();
    const Eigen::Matrix3d& R = placement.rotation();
    rme::examples::RigidBody& link = arm.links.at(joint - 1).body;
    link = link + rme::examples::RigidBody{body.mass, R * body.com + placement.translation(),
                                           R * body.inertia * R.transpose()};
  }
};

struct Data {
  explicit Data(const Model& model)
      : M(nowhere(model.nv, model.nv)), C(nowhere(model.nv, model.nv)), g(nowhere(model.nv, 1)) {}
  static Eigen::MatrixXd nowhere(int rows, int columns) {
    return Eigen::MatrixXd::Constant(rows, columns, std::numeric_limits<double>::quiet_NaN());
  }
  Eigen::MatrixXd M, C;
  Eigen::VectorXd g;
  std::vector<SE3> oMf = std::vector<SE3>(1);
  rme::examples::Kinematics<7> flange;  // not Pinocchio's: what stands for its joint placements and Jacobians
};

inline void check_size(Eigen::Index size, int expected) {
  if (size != expected) throw std::invalid_argument("wrong argument size: expected " + std::to_string(expected));
}

inline Eigen::VectorXd neutral(const Model& model) {
  return Eigen::VectorXd::Zero(model.nq);
}

/// Only the fingers can be locked here.
inline Model buildReducedModel(const Model& model, const std::vector<JointIndex>& list_of_joints_to_lock,
                               const Eigen::VectorXd& reference_configuration) {
  check_size(reference_configuration.size(), model.nq);
  Model out = model;
  for (std::size_t i = list_of_joints_to_lock.size(); i-- > 0;) {
    const JointIndex joint = list_of_joints_to_lock[i];
    if (joint < 8 || joint >= model.names.size()) throw std::invalid_argument("joint index out of range");
    out.names.erase(out.names.begin() + static_cast<std::ptrdiff_t>(joint));
    --out.nq, --out.nv, --out.njoints;
  }
  return out;
}

template <typename Q, typename V>
void computeAllTerms(const Model& model, Data& data, const Eigen::MatrixBase<Q>& q, const Eigen::MatrixBase<V>& v) {
  check_size(q.size(), model.nq);
  check_size(v.size(), model.nv);
  const auto dynamics = model.arm.dynamics(q.template head<7>(), v.template head<7>());
  data.M.topLeftCorner<7, 7>().triangularView<Eigen::Upper>() = dynamics.mass_matrix;
  data.g.head<7>() = dynamics.gravity;
  data.flange = model.arm.kinematics(q.template head<7>());
}

/// C with C dq and C^T dq as they are: the one of least norm that has both.
template <typename Q, typename V>
const Eigen::MatrixXd& computeCoriolisMatrix(const Model& model, Data& data, const Eigen::MatrixBase<Q>& q,
                                             const Eigen::MatrixBase<V>& v) {
  check_size(q.size(), model.nq);
  check_size(v.size(), model.nv);
  const auto dynamics = model.arm.dynamics(q.template head<7>(), v.template head<7>());
  const double vv = v.squaredNorm();
  data.C.setZero();
  if (vv > 0)
    data.C.noalias() = (dynamics.coriolis * v.transpose() + v * dynamics.coriolis_transpose.transpose()) / vv -
                       v * (v.dot(dynamics.coriolis) / (vv * vv)) * v.transpose();
  return data.C;
}

template <typename Matrix>
void getFrameJacobian(const Model& model, Data& data, FrameIndex frame_id, ReferenceFrame frame,
                      const Eigen::MatrixBase<Matrix>& J) {
  (void)model.frames.at(frame_id);
  check_size(J.cols(), model.nv);
  auto& jacobian = const_cast<Eigen::MatrixBase<Matrix>&>(J);  // Eigen's way to write to an argument of any type
  jacobian = data.flange.jacobian;
  if (frame == LOCAL) {
    jacobian.template topRows<3>() = data.flange.rotation.transpose() * data.flange.jacobian.topRows<3>();
    jacobian.template bottomRows<3>() = data.flange.rotation.transpose() * data.flange.jacobian.bottomRows<3>();
  } else if (frame == WORLD) {
    jacobian.template topRows<3>() += rme::skew(data.flange.position) * data.flange.jacobian.bottomRows<3>();
  }
}

inline const SE3& updateFramePlacement(const Model& model, Data& data, FrameIndex frame_id) {
  (void)model.frames.at(frame_id);
  data.oMf[0] = SE3(data.flange.rotation, data.flange.position);
  return data.oMf[0];
}

namespace urdf {
inline Model& buildModelFromXML(const std::string& /*xml_stream*/, Model& model) {
  for (int j = 1; j <= 7; ++j) model.names.push_back("panda_joint" + std::to_string(j));
  for (int j = 1; j <= 2; ++j) model.names.push_back("panda_finger_joint" + std::to_string(j));
  model.nq = model.nv = 9;
  model.njoints = 10;
  model.frames = {{"panda_link8", 7, SE3(Eigen::Matrix3d::Identity(), model.arm.flange)}};
  return model;
}
}  // namespace urdf

}  // namespace pinocchio
