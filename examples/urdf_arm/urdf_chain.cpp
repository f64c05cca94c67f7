#include "urdf_arm/urdf_chain.hpp"

#include <console_bridge/console.h>
#include <urdf_model/model.h>
#include <urdf_parser/urdf_parser.h>

#include <Eigen/Eigenvalues>
#include <cmath>
#include <limits>
#include <map>
#include <set>

#include "io/csv.hpp"

namespace rme::examples {

namespace {

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// Collects the parser's error messages while it exists, so that they are not printed.
class ParserErrors : public console_bridge::OutputHandler {
 public:
  ParserErrors() { console_bridge::useOutputHandler(this); }
  ~ParserErrors() override { console_bridge::restorePreviousOutputHandler(); }
  ParserErrors(const ParserErrors&) = delete;
  ParserErrors& operator=(const ParserErrors&) = delete;

  void log(const std::string& said, console_bridge::LogLevel level, const char*, int) override {
    if (level < console_bridge::CONSOLE_BRIDGE_LOG_ERROR) return;
    text += (text.empty() ? "" : "; ") + said;
  }

  std::string text;
};

Eigen::Isometry3d isometry(const urdf::Pose& pose) {
  Eigen::Quaterniond turn;
  pose.rotation.getQuaternion(turn.x(), turn.y(), turn.z(), turn.w());
  return Eigen::Translation3d(pose.position.x, pose.position.y, pose.position.z) * turn.normalized();
}

RigidBody moved(const RigidBody& body, const Eigen::Isometry3d& to) {
  return moved(body, to.translation(), to.linear());
}

/// The smallest rotation that maps z to the joint's axis.
Eigen::Matrix3d from_z(const Eigen::Vector3d& axis) {
  return Eigen::Quaterniond::FromTwoVectors(Eigen::Vector3d::UnitZ(), axis).toRotationMatrix();
}

const char* type_name(int type) {
  switch (type) {
    case urdf::Joint::PRISMATIC:
      return "prismatic";
    case urdf::Joint::FLOATING:
      return "floating";
    case urdf::Joint::PLANAR:
      return "planar";
    default:
      return "of an unknown type";
  }
}

/// A parsed URDF; its errors name the file.
class Reader {
 public:
  Reader(const std::string& text, const std::string& file) : file_(file) {
    if (text.find("<xacro:") != std::string::npos)
      fail("is a xacro file, not a URDF: run xacro on it, and give what comes out");
    ParserErrors errors;
    try {
      model_ = urdf::parseURDF(text);
    } catch (const std::exception& error) {
      fail(std::string("is no URDF: ") + error.what());
    }
    if (!model_) fail("is no URDF that can be used" + (errors.text.empty() ? "" : ": " + errors.text));
    refuse_loops();
  }

  UrdfChain chain(const std::string& base, const std::string& tip) const {
    const auto path = path_of(base, tip);
    UrdfChain out;
    out.name = model_->getName();
    out.base = base;
    out.tip_link = tip;
    Eigen::Isometry3d at = Eigen::Isometry3d::Identity();  // the URDF's link in the axes of the last moving link
    std::set<const urdf::Joint*> along(path.begin(), path.end());
    for (std::size_t k = 0; k < path.size(); ++k) {
      const urdf::Joint& joint = *path[k];
      at = at * isometry(joint.parent_to_joint_origin_transform);
      if (joint.type == urdf::Joint::FIXED) continue;
      if (joint.type != urdf::Joint::REVOLUTE && joint.type != urdf::Joint::CONTINUOUS)
        fail("joint " + joint.name + " between " + base + " and " + tip + " is " + type_name(joint.type) +
             "; only revolute and continuous joints are supported there");
      if (joint.mimic)
        fail("joint " + joint.name + " between " + base + " and " + tip + " mimics " + joint.mimic->joint_name +
             "; a joint of the arm has to move on its own");
      const Eigen::Vector3d axis(joint.axis.x, joint.axis.y, joint.axis.z);
      if (!(axis.norm() > 1e-9) || !axis.allFinite()) fail("joint " + joint.name + " has no axis");
      const Eigen::Matrix3d turn = from_z(axis.normalized());
      const Eigen::Isometry3d to_link(Eigen::Quaterniond(Eigen::Matrix3d(turn.transpose())));
      std::set<const urdf::Joint*> beyond;  // all that is attached to the next moving joint belongs to the next link
      for (std::size_t n = k + 1; n < path.size(); ++n)
        if (path[n]->type != urdf::Joint::FIXED) beyond.insert(path[n]);
      const RigidBody body = welded(*link(joint.child_link_name), Eigen::Isometry3d(turn.transpose()), beyond);
      if (!(body.mass > 0))
        fail("link " + joint.child_link_name + ", which joint " + joint.name +
             " moves, has no inertia, nor has what is welded to it");
      out.links.push_back({at.translation(), at.linear() * turn, body});
      out.joints.push_back(limits(joint));
      at = to_link;
    }
    out.tip = at.translation();
    out.tip_rotation = at.linear();
    if (out.dofs() < kFewestJoints || out.dofs() > kMostJoints)
      fail("there are " + std::to_string(out.dofs()) + " joints that move between " + base + " and " + tip +
           "; the programs are compiled for " + std::to_string(kFewestJoints) + " to " + std::to_string(kMostJoints));
    return out;
  }

 private:
  [[noreturn]] void fail(const std::string& what) const { throw UrdfError(file_ + ": " + what); }

  urdf::LinkConstSharedPtr link(const std::string& name) const {
    if (auto found = model_->getLink(name)) return found;
    std::string all;
    for (const auto& entry : model_->links_) all += (all.empty() ? "" : ", ") + entry.first;
    fail("has no link " + name + "; there are " + all);
  }

  /// Refuses a link with two parents, or one that is its own ancestor: the parser accepts them.
  void refuse_loops() const {
    std::map<std::string, const urdf::Joint*> above;
    for (const auto& [name, joint] : model_->joints_) {
      const auto [first, is_first] = above.emplace(joint->child_link_name, joint.get());
      if (!is_first)
        fail("link " + joint->child_link_name + " hangs on joints " + first->second->name + " and " + name +
             ": a loop, and only trees are supported");
    }
    for (const auto& entry : above) {
      const std::string& name = entry.first;
      std::size_t steps = 0;
      for (auto at = above.find(name); at != above.end(); at = above.find(at->second->parent_link_name))
        if (++steps > above.size()) fail("link " + name + " hangs on itself: a loop, and only trees are supported");
    }
  }

  /// Joints from base to tip.
  std::vector<const urdf::Joint*> path_of(const std::string& base, const std::string& tip) const {
    (void)link(base);
    std::vector<const urdf::Joint*> path;
    for (auto at = link(tip); at->name != base; at = link(at->parent_joint->parent_link_name)) {
      if (!at->parent_joint) fail("link " + base + " is not between the root and link " + tip);
      path.push_back(at->parent_joint.get());
    }
    std::reverse(path.begin(), path.end());
    return path;
  }

  RigidBody body_of(const urdf::Link& link) const {
    if (!link.inertial) return {};
    const urdf::Inertial& i = *link.inertial;
    Eigen::Matrix3d tensor;
    tensor << i.ixx, i.ixy, i.ixz, i.ixy, i.iyy, i.iyz, i.ixz, i.iyz, i.izz;
    if (!(i.mass >= 0) || !std::isfinite(i.mass))
      fail("link " + link.name + " has a mass of " + std::to_string(i.mass));
    const double least = tensor.allFinite() ? tensor.selfadjointView<Eigen::Lower>().eigenvalues().minCoeff() : -1;
    if (!(least >= -1e-9 * std::max(1.0, tensor.norm())))
      fail("link " + link.name + " has an inertia that no body has: a principal moment is negative");
    return moved(RigidBody{i.mass, Eigen::Vector3d::Zero(), tensor}, isometry(i.origin));
  }

  /// The body of `link` with all that is attached to it, up to the joints `beyond`.
  /// @param at  pose of the link's axes
  RigidBody welded(const urdf::Link& link, const Eigen::Isometry3d& at,
                   const std::set<const urdf::Joint*>& beyond) const {
    RigidBody sum = moved(body_of(link), at);
    for (const auto& joint : link.child_joints) {
      if (beyond.count(joint.get()) > 0) continue;
      const RigidBody more =
          welded(*this->link(joint->child_link_name), at * isometry(joint->parent_to_joint_origin_transform), beyond);
      if (more.mass > 0) sum = sum.mass > 0 ? sum + more : more;
    }
    return sum;
  }

  static ChainJoint limits(const urdf::Joint& joint) {
    ChainJoint out{joint.name, -kInfinity, kInfinity, kInfinity, kInfinity};
    if (!joint.limits) return out;
    if (joint.type == urdf::Joint::REVOLUTE) {
      out.q_min = joint.limits->lower;
      out.q_max = joint.limits->upper;
    }
    if (joint.limits->velocity > 0) out.dq_max = joint.limits->velocity;
    if (joint.limits->effort > 0) out.tau_max = joint.limits->effort;
    return out;
  }

  std::string file_;
  urdf::ModelInterfaceSharedPtr model_;
};

}  // namespace

UrdfChain parse_urdf(const std::string& text, const std::string& file, const std::string& base,
                     const std::string& tip) {
  return Reader(text, file).chain(base, tip);
}

UrdfChain read_urdf(const std::string& file, const std::string& base, const std::string& tip) {
  std::string text;
  try {
    text = read_file(file);
  } catch (const LogError& error) {
    throw UrdfError(error.what());
  }
  return parse_urdf(text, file, base, tip);
}

}  // namespace rme::examples
