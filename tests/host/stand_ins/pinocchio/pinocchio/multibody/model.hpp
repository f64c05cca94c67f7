#pragma once
// As much of Pinocchio as the hosts use, by its names and signatures, each function in the header that it has there.
// Which robot a URDF means is told by its joints' names (parsers/urdf.hpp). What the real functions leave alone holds
// NaN here; what they refuse throws, and so does what they would read out of bounds.
#include <Eigen/Core>
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <limits>
#include <stdexcept>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <vector>

namespace pinocchio {

using Index = std::size_t;
using JointIndex = Index;
using FrameIndex = Index;
enum ReferenceFrame { WORLD, LOCAL, LOCAL_WORLD_ALIGNED };
enum FrameType { OP_FRAME = 1, JOINT = 2, FIXED_JOINT = 4, BODY = 8, SENSOR = 16 };

class SE3 {
 public:
  SE3() = default;
  SE3(const Eigen::Matrix3d& R, const Eigen::Vector3d& p) : rotation_(R), translation_(p) {}
  static SE3 Identity() { return {Eigen::Matrix3d::Identity(), Eigen::Vector3d::Zero()}; }
  const Eigen::Matrix3d& rotation() const { return rotation_; }
  const Eigen::Vector3d& translation() const { return translation_; }

 private:
  Eigen::Matrix3d rotation_ = Eigen::Matrix3d::Constant(std::numeric_limits<double>::quiet_NaN());
  Eigen::Vector3d translation_ = Eigen::Vector3d::Constant(std::numeric_limits<double>::quiet_NaN());
};

/// Of a model, its gravity: the linear part is an acceleration.
class Motion {
 public:
  const Eigen::Vector3d& linear() const { return linear_; }
  template <typename Vector>
  void linear(const Eigen::MatrixBase<Vector>& v) {
    linear_ = v;
  }

 private:
  Eigen::Vector3d linear_ = {0, 0, -9.81};
};

/// Mass, centre of mass, inertia about that centre.
class Inertia {
 public:
  Inertia(double mass, const Eigen::Vector3d& com, const Eigen::Matrix3d& rotational_inertia)
      : body_{mass, com, rotational_inertia} {}
  double mass() const { return body_.mass; }
  const rme::examples::RigidBody& body() const { return body_; }  // not Pinocchio's

 private:
  rme::examples::RigidBody body_;
};

struct Frame {
  Frame(const std::string& frame_name, JointIndex joint, FrameIndex parent_frame, const SE3& frame_placement,
        FrameType frame_type)
      : name(frame_name), parentJoint(joint), parentFrame(parent_frame), placement(frame_placement), type(frame_type) {}
  std::string name;
  JointIndex parentJoint;
  FrameIndex parentFrame;
  SE3 placement;
  FrameType type;
};

struct Model {
  int nq = 0, nv = 0, njoints = 1, nframes = 0;
  std::vector<std::string> names = {"universe"};
  std::vector<JointIndex> parents = {0};
  std::vector<int> nqs = {0}, nvs = {0}, idx_qs = {0};
  std::vector<Inertia> inertias = {Inertia(0, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero())};
  std::vector<Frame> frames;
  Motion gravity;
  rme::examples::ArmModel<7>
      arm{};  // not Pinocchio's; if the robot has six joints, with a seventh that carries nothing

  static constexpr FrameType kAnyFrame = static_cast<FrameType>(OP_FRAME | JOINT | FIXED_JOINT | BODY | SENSOR);
  bool existFrame(const std::string& name, const FrameType& type = kAnyFrame) const {
    for (const Frame& frame : frames)
      if (frame.name == name && (frame.type & type) != 0) return true;
    return false;
  }
  /// nframes if there is none.
  FrameIndex getFrameId(const std::string& name, const FrameType& type = kAnyFrame) const {
    FrameIndex found = frames.size();
    for (FrameIndex i = frames.size(); i-- > 0;) {
      if (frames[i].name != name || (frames[i].type & type) == 0) continue;
      if (found < frames.size()) throw std::invalid_argument("several frames are called " + name);
      found = i;
    }
    return found;
  }
  FrameIndex addFrame(const Frame& frame) {
    frames.push_back(frame);
    return static_cast<FrameIndex>(nframes++);
  }
  void appendBodyToJoint(JointIndex joint, const Inertia& inertia, const SE3& placement) {
    const rme::examples::RigidBody& body = inertia.body();
    const Eigen::Matrix3d& R = placement.rotation();
    rme::examples::RigidBody& link = arm.links.at(joint - 1).body;
    link = link + rme::examples::RigidBody{body.mass, R * body.com + placement.translation(),
                                           R * body.inertia * R.transpose()};
  }
  void append(const std::string& joint, int positions, double mass) {  // not Pinocchio's
    parents.push_back(names.size() - 1);
    names.push_back(joint);
    inertias.emplace_back(mass, Eigen::Vector3d::Zero(), Eigen::Matrix3d::Zero());
    idx_qs.push_back(nq);
    nqs.push_back(positions);
    nvs.push_back(1);
    nq += positions;
    ++nv, ++njoints;
  }
};

struct Data {
  explicit Data(const Model& model)
      : M(nowhere(model.nv, model.nv)),
        C(nowhere(model.nv, model.nv)),
        g(nowhere(model.nv, 1)),
        Jcom(nowhere(3, model.nv)),
        mass(static_cast<std::size_t>(model.njoints), std::numeric_limits<double>::quiet_NaN()),
        oMf(model.frames.size()) {}
  static Eigen::MatrixXd nowhere(int rows, int columns) {
    return Eigen::MatrixXd::Constant(rows, columns, std::numeric_limits<double>::quiet_NaN());
  }
  Eigen::MatrixXd M, C;
  Eigen::VectorXd g;
  Eigen::Matrix<double, 3, Eigen::Dynamic> Jcom;
  std::vector<double> mass;
  std::vector<SE3> oMf;
  rme::examples::Kinematics<7> flange;  // not Pinocchio's: what stands for its joint placements and Jacobians
};

namespace stand_in {  // not Pinocchio's

inline void check_size(Eigen::Index size, int expected) {
  if (size != expected)
    throw std::invalid_argument("wrong argument size: expected " + std::to_string(expected) + ", got " +
                                std::to_string(size));
}

/// The arm's part of a configuration, the fingers' left out. A continuous joint's two numbers are those of an angle.
template <typename Vector>
Eigen::Matrix<double, 7, 1> angles(const Model& model, const Eigen::MatrixBase<Vector>& q) {
  check_size(q.size(), model.nq);
  Eigen::Matrix<double, 7, 1> out = Eigen::Matrix<double, 7, 1>::Zero();
  for (std::size_t i = 1; i < 8 && i < model.names.size(); ++i) {
    const int at = model.idx_qs[i];
    if (model.nqs[i] == 2 && std::abs(q[at] * q[at] + q[at + 1] * q[at + 1] - 1) > 1e-9)
      throw std::invalid_argument("not a cosine and a sine");
    out[static_cast<Eigen::Index>(i) - 1] = model.nqs[i] == 2 ? std::atan2(q[at + 1], q[at]) : q[at];
  }
  return out;
}

/// The arm's part of a vector of velocities, the fingers' left out.
template <typename Vector>
Eigen::Matrix<double, 7, 1> of_arm(const Eigen::MatrixBase<Vector>& v) {
  Eigen::Matrix<double, 7, 1> out = Eigen::Matrix<double, 7, 1>::Zero();
  for (Eigen::Index i = 0; i < 7 && i < v.size(); ++i) out[i] = v[i];
  return out;
}

/// How many of the model's joints are the arm's.
inline Eigen::Index joints_of_arm(const Model& model) {
  return std::min(7, model.nv);
}

inline rme::examples::ArmModel<7> arm_of(const Model& model) {
  rme::examples::ArmModel<7> arm = model.arm;  // its name is empty, so that this allocates nothing
  arm.gravity_vector = model.gravity.linear();
  return arm;
}

}  // namespace stand_in
}  // namespace pinocchio
