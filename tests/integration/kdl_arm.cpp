#include "integration/kdl_arm.hpp"

#include <kdl/chainfksolverpos_recursive.hpp>
#include <kdl/chainjnttojacsolver.hpp>
#include <kdl_parser/kdl_parser.hpp>
#include <stdexcept>

namespace rme::testing {

KdlArm::KdlArm(const std::string& urdf, const std::string& tip) : tip_(tip) {
  if (!kdl_parser::treeFromFile(urdf, bare_)) throw std::runtime_error(urdf + ": KDL cannot read it");
  if (!bare_.getChain(bare_.getRootSegment()->first, tip, chain_)) throw std::runtime_error(tip + ": no such link");
  for (const KDL::Segment& segment : chain_.segments)
    if (segment.getJoint().getType() != KDL::Joint::Fixed)
      index_.push_back(bare_.getSegment(segment.getName())->second.q_nr);
  attach({});
}

void KdlArm::attach(const examples::RigidBody& body) {
  tree_ = bare_;
  if (body.mass > 0) weld(body);
  heavy_ = std::make_unique<KDL::TreeIdSolver_RNE>(tree_, KDL::Vector(0, 0, -9.81));
  weightless_ = std::make_unique<KDL::TreeIdSolver_RNE>(tree_, KDL::Vector::Zero());
}

void KdlArm::weld(const examples::RigidBody& body) {
  const auto& I = body.inertia;
  const KDL::RigidBodyInertia inertia(body.mass, KDL::Vector(body.com.x(), body.com.y(), body.com.z()),
                                      KDL::RotationalInertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)));
  tree_.addSegment(KDL::Segment("payload", KDL::Joint(KDL::Joint::Fixed), KDL::Frame::Identity(), inertia), tip_);
}

Eigen::VectorXd KdlArm::inverse_dynamics(const Eigen::VectorXd& q, const Eigen::VectorXd& dq,
                                         const Eigen::VectorXd& ddq, bool gravity) const {
  const unsigned n = tree_.getNrOfJoints();
  KDL::JntArray position(n), velocity(n), acceleration(n), torque(n);
  for (std::size_t j = 0; j < index_.size(); ++j) {
    position(index_[j]) = q[static_cast<Eigen::Index>(j)];
    velocity(index_[j]) = dq[static_cast<Eigen::Index>(j)];
    acceleration(index_[j]) = ddq[static_cast<Eigen::Index>(j)];
  }
  if ((gravity ? heavy_ : weightless_)->CartToJnt(position, velocity, acceleration, KDL::WrenchMap(), torque) < 0)
    throw std::runtime_error("KDL: no inverse dynamics");
  Eigen::VectorXd out(dofs());
  for (std::size_t j = 0; j < index_.size(); ++j) out[static_cast<Eigen::Index>(j)] = torque(index_[j]);
  return out;
}

Eigen::MatrixXd KdlArm::mass_matrix(const Eigen::VectorXd& q) const {
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(dofs());
  Eigen::MatrixXd out(dofs(), dofs());
  for (int j = 0; j < dofs(); ++j) out.col(j) = inverse_dynamics(q, rest, Eigen::VectorXd::Unit(dofs(), j), false);
  return out;
}

KDL::JntArray KdlArm::chain_position(const Eigen::VectorXd& q) const {
  KDL::JntArray out(static_cast<unsigned>(dofs()));
  out.data = q;
  return out;
}

Eigen::Vector3d KdlArm::position(const Eigen::VectorXd& q) const {
  KDL::Frame frame;
  KDL::ChainFkSolverPos_recursive(chain_).JntToCart(chain_position(q), frame);
  return {frame.p.x(), frame.p.y(), frame.p.z()};
}

Eigen::Matrix3d KdlArm::rotation(const Eigen::VectorXd& q) const {
  KDL::Frame frame;
  KDL::ChainFkSolverPos_recursive(chain_).JntToCart(chain_position(q), frame);
  return Eigen::Map<const Eigen::Matrix<double, 3, 3, Eigen::RowMajor>>(frame.M.data);
}

Eigen::MatrixXd KdlArm::jacobian(const Eigen::VectorXd& q) const {
  KDL::Jacobian out(static_cast<unsigned>(dofs()));
  KDL::ChainJntToJacSolver(chain_).JntToJac(chain_position(q), out);
  return out.data;
}

}  // namespace rme::testing
