#pragma once
/// An arm in Orocos KDL: another library's reading of the URDF, and its dynamics.
#include <Eigen/Core>
#include <kdl/chain.hpp>
#include <kdl/jntarray.hpp>
#include <kdl/tree.hpp>
#include <kdl/treeidsolver_recursive_newton_euler.hpp>
#include <memory>
#include <string>
#include <synthetic_arm/arm_model.hpp>
#include <vector>

namespace rme::testing {

/// All that moves between the root of a URDF and a link, with what hangs on it; world axes are the root's. Joints that
/// are not between them are at zero.
class KdlArm {
 public:
  KdlArm(const std::string& urdf, const std::string& tip);

  /// Welds a body to the tip, tip axes.
  void attach(const examples::RigidBody& body);
  void detach() { attach({}); }

  int dofs() const { return static_cast<int>(index_.size()); }
  /// Torque that makes the arm accelerate so, by recursive Newton-Euler over the whole tree.
  /// @param gravity  whether it pulls by 9.81 m/s^2 along -z of the root
  Eigen::VectorXd inverse_dynamics(const Eigen::VectorXd& q, const Eigen::VectorXd& dq, const Eigen::VectorXd& ddq,
                                   bool gravity = true) const;
  Eigen::MatrixXd mass_matrix(const Eigen::VectorXd& q) const;

  Eigen::Vector3d position(const Eigen::VectorXd& q) const;
  Eigen::Matrix3d rotation(const Eigen::VectorXd& q) const;
  Eigen::MatrixXd jacobian(const Eigen::VectorXd& q) const;

 private:
  void weld(const examples::RigidBody& body);
  KDL::JntArray chain_position(const Eigen::VectorXd& q) const;

  KDL::Tree bare_, tree_;
  std::unique_ptr<KDL::TreeIdSolver_RNE> heavy_, weightless_;  // of tree_, with gravity and without
  KDL::Chain chain_;
  std::string tip_;
  std::vector<unsigned> index_;  // of our joints in the tree
};

}  // namespace rme::testing
