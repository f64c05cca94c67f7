#include "integration/kdl_arm.hpp"

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <kdl_parser/kdl_parser.hpp>
#include <stdexcept>
#include <vector>

namespace rme::testing {

namespace {

const KDL::Vector kGravity(0, 0, -9.81);

}  // namespace

KdlArm::KdlArm(const std::string& urdf, const std::string& tip) {
  if (!kdl_parser::treeFromFile(urdf, tree_)) throw std::runtime_error(urdf + ": KDL cannot read it");
  if (!tree_.getChain(tree_.getRootSegment()->first, tip, chain_)) throw std::runtime_error(tip + ": no such link");
  for (KDL::Segment& segment : chain_.segments)
    segment.setInertia(with_branches(tree_.getSegment(segment.getName())->second));
  bare_tip_ = chain_.segments.back().getInertia();
  heavy_ = std::make_unique<KDL::ChainIdSolver_RNE>(chain_, kGravity);
  weightless_ = std::make_unique<KDL::ChainIdSolver_RNE>(chain_, KDL::Vector::Zero());
  dynamics_ = std::make_unique<KDL::ChainDynParam>(chain_, kGravity);
}

// A segment's inertia, and that of what hangs on it beside the chain, in the segment's axes.
KDL::RigidBodyInertia KdlArm::with_branches(const KDL::TreeElement& element) const {
  KDL::RigidBodyInertia out = element.segment.getInertia();
  for (const auto& child : element.children) {
    const KDL::Segment& segment = child->second.segment;
    bool in_chain = false;
    for (const KDL::Segment& other : chain_.segments) in_chain = in_chain || other.getName() == segment.getName();
    if (!in_chain) out = out + segment.pose(0) * with_branches(child->second);
  }
  return out;
}

void KdlArm::attach(const examples::RigidBody& body) {
  const auto& I = body.inertia;
  const KDL::RigidBodyInertia inertia(body.mass, KDL::Vector(body.com.x(), body.com.y(), body.com.z()),
                                      KDL::RotationalInertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)));
  chain_.segments.back().setInertia(bare_tip_ + inertia);
}

KDL::JntArray KdlArm::joints(const Eigen::VectorXd& values) const {
  KDL::JntArray out(chain_.getNrOfJoints());
  out.data = values;
  return out;
}

Eigen::VectorXd KdlArm::inverse_dynamics(const Eigen::VectorXd& q, const Eigen::VectorXd& dq,
                                         const Eigen::VectorXd& ddq, bool gravity) const {
  KDL::JntArray torque(chain_.getNrOfJoints());
  const KDL::Wrenches none(chain_.getNrOfSegments(), KDL::Wrench::Zero());
  if ((gravity ? heavy_ : weightless_)->CartToJnt(joints(q), joints(dq), joints(ddq), none, torque) < 0)
    throw std::runtime_error("KDL: no inverse dynamics");
  return torque.data;
}

Eigen::MatrixXd KdlArm::mass_matrix(const Eigen::VectorXd& q) const {
  KDL::JntSpaceInertiaMatrix out(static_cast<int>(chain_.getNrOfJoints()));
  if (dynamics_->JntToMass(joints(q), out) < 0) throw std::runtime_error("KDL: no mass matrix");
  return out.data;
}

Eigen::VectorXd KdlArm::tree_dynamics(const Eigen::VectorXd& q, const Eigen::VectorXd& dq,
                                      const Eigen::VectorXd& ddq) const {
  const unsigned n = tree_.getNrOfJoints();
  KDL::JntArray position(n), velocity(n), acceleration(n), torque(n);
  std::vector<unsigned> index;  // of our joints in the tree
  for (const KDL::Segment& segment : chain_.segments)
    if (segment.getJoint().getType() != KDL::Joint::Fixed)
      index.push_back(tree_.getSegment(segment.getName())->second.q_nr);
  for (std::size_t j = 0; j < index.size(); ++j) {
    position(index[j]) = q[static_cast<Eigen::Index>(j)];
    velocity(index[j]) = dq[static_cast<Eigen::Index>(j)];
    acceleration(index[j]) = ddq[static_cast<Eigen::Index>(j)];
  }
  KDL::TreeIdSolver_RNE solver(tree_, kGravity);
  if (solver.CartToJnt(position, velocity, acceleration, KDL::WrenchMap(), torque) < 0)
    throw std::runtime_error("KDL: no inverse dynamics");
  Eigen::VectorXd out(dofs());
  for (std::size_t j = 0; j < index.size(); ++j) out[static_cast<Eigen::Index>(j)] = torque(index[j]);
  return out;
}

Eigen::Vector3d KdlArm::position(const Eigen::VectorXd& q) const {
  KDL::Frame frame;
  KDL::ChainFkSolverPos_recursive(chain_).JntToCart(joints(q), frame);
  return {frame.p.x(), frame.p.y(), frame.p.z()};
}

Eigen::Matrix3d KdlArm::rotation(const Eigen::VectorXd& q) const {
  KDL::Frame frame;
  KDL::ChainFkSolverPos_recursive(chain_).JntToCart(joints(q), frame);
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(frame.M.data);
}

Eigen::MatrixXd KdlArm::jacobian(const Eigen::VectorXd& q) const {
  KDL::Jacobian out(static_cast<unsigned>(dofs()));
  KDL::ChainJntToJacSolver(chain_).JntToJac(joints(q), out);
  return out.data;
}

}  // namespace rme::testing
