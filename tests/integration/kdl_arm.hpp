#pragma once
/// An arm in Orocos KDL: another library's reading of the URDF, and its dynamics.
#include <Eigen/Core>
#include <kdl/chain.hpp>
#include <kdl/chaindynparam.hpp>
#include <kdl/chainidsolver_recursive_newton_euler.hpp>
#include <kdl/jntarray.hpp>
#include <kdl/tree.hpp>
#include <memory>
#include <string>
#include <synthetic_arm/arm_model.hpp>

namespace rme::testing {

/// All that moves between the root of a URDF and a link, with what hangs on it; world axes are the root's. Joints that
/// are not between them are at zero.
class KdlArm {
 public:
  KdlArm(const std::string& urdf, const std::string& tip);

  /// Welds a body to the tip, tip axes.
  void attach(const examples::RigidBody& body);
  void detach() { attach({}); }

  int dofs() const { return static_cast<int>(chain_.getNrOfJoints()); }
  /// Torque that makes the arm accelerate so, by recursive Newton-Euler.
  /// @param gravity  whether it pulls by 9.81 m/s^2 along -z of the root
  Eigen::VectorXd inverse_dynamics(const Eigen::VectorXd& q, const Eigen::VectorXd& dq, const Eigen::VectorXd& ddq,
                                   bool gravity = true) const;
  Eigen::MatrixXd mass_matrix(const Eigen::VectorXd& q) const;
  /// The same torque with nothing attached, over the whole tree as KDL read it: many times slower.
  Eigen::VectorXd tree_dynamics(const Eigen::VectorXd& q, const Eigen::VectorXd& dq, const Eigen::VectorXd& ddq) const;

  Eigen::Vector3d position(const Eigen::VectorXd& q) const;
  Eigen::Matrix3d rotation(const Eigen::VectorXd& q) const;
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& q) const;

 private:
  KDL::RigidBodyInertia with_branches(const KDL::TreeElement& element) const;
  KDL::JntArray joints(const Eigen::VectorXd& values) const;

  KDL::Tree tree_;
  KDL::Chain chain_;  // with the inertia of all that branches off its segments, and of the body
  KDL::RigidBodyInertia bare_tip_;
  // Of chain_, with gravity and without.
  std::unique_ptr<KDL::ChainIdSolver_RNE> heavy_, weightless_;
  std::unique_ptr<KDL::ChainDynParam> dynamics_;
};

}  // namespace rme::testing
