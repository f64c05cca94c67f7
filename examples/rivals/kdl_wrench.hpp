#pragma once
/// Payload mass from the wrench at the tip that Orocos KDL's ChainExternalWrenchEstimator finds from an arm's torque.
#include <cstddef>
#include <kdl/chain.hpp>
#include <kdl/chainexternalwrenchestimator.hpp>
#include <kdl/jntarray.hpp>
#include <stdexcept>
#include <synthetic_arm/arm_model.hpp>

namespace rme::examples {

inline KDL::Vector kdl_vector(const Eigen::Vector3d& v) {
  return {v.x(), v.y(), v.z()};
}

/// An arm model as a chain of KDL.
/// @param rotors  inertia of each joint's rotor, seen through its gear [kg m^2]
template <int Dofs>
KDL::Chain kdl_chain(const ArmModel<Dofs>& model,
                     const JointVector<double, Dofs>& rotors = JointVector<double, Dofs>::Zero()) {
  const auto frame = [](const Eigen::Matrix3d& R, const Eigen::Vector3d& p) {
    return KDL::Frame(KDL::Rotation(R(0, 0), R(0, 1), R(0, 2), R(1, 0), R(1, 1), R(1, 2), R(2, 0), R(2, 1), R(2, 2)),
                      kdl_vector(p));
  };
  KDL::Chain out;
  for (int j = 0; j < Dofs; ++j) {
    const Link& link = model.links[static_cast<std::size_t>(j)];
    const KDL::Frame at = frame(link.rotation, link.offset);
    const bool last = j == Dofs - 1;  // KDL's frame is at a segment's tip: that of the last one is the end effector
    const Eigen::Matrix3d R = last ? model.flange_rotation : Eigen::Matrix3d(Eigen::Matrix3d::Identity());
    const Eigen::Vector3d tip = last ? model.flange : Eigen::Vector3d(Eigen::Vector3d::Zero());
    const RigidBody body = moved(link.body, -(R.transpose() * tip), R.transpose());
    const Eigen::Matrix3d& I = body.inertia;
    const KDL::RigidBodyInertia inertia(body.mass, kdl_vector(body.com),
                                        KDL::RotationalInertia(I(0, 0), I(1, 1), I(2, 2), I(0, 1), I(0, 2), I(1, 2)));
    const KDL::Joint joint(at.p, at.M.UnitZ(), KDL::Joint::RotAxis, 1, 0, rotors[j]);
    out.addSegment(KDL::Segment(joint, at * frame(R, tip), inertia));
  }
  return out;
}

/// A mass from KDL's wrench at the tip: its force along gravity, divided by gravity. KDL's estimator assumes a constant
/// period, whatever the time steps of a recording, and models neither friction nor the payload's inertia. The centre of
/// mass would follow from the moment over several poses, which is not done here.
template <int Dofs>
class KdlTipMass {
 public:
  using Vector = JointVector<double, Dofs>;

  /// @param period    of the samples [s]
  /// @param gain      of KDL's observer [1/s]
  /// @param singular  smaller singular values of J^T are left out when J^T is inverted; KDL's default is 1e-5
  KdlTipMass(const ArmModel<Dofs>& model, const Vector& rotors, double period, double gain, double singular)
      : model_(model),
        chain_(kdl_chain(model, rotors)),
        estimator_(chain_, kdl_vector(model.gravity_vector), 1 / period, gain, 0, singular) {}
  KdlTipMass(const KdlTipMass&) = delete;  // the estimator refers to the chain
  KdlTipMass& operator=(const KdlTipMass&) = delete;

  /// The mass after another sample.
  /// @param tau  joint torque, gravity included [N m]
  /// @return [kg]
  /// @throws std::runtime_error if KDL finds no wrench
  double update(const Vector& q, const Vector& dq, const Vector& tau) {
    const KDL::JntArray position = array(q), velocity = array(dq);
    if (!started_) estimator_.setInitialMomentum(position, velocity);
    started_ = true;
    KDL::Wrench wrench;
    if (estimator_.JntToExtWrench(position, velocity, array(tau), wrench) < 0)
      throw std::runtime_error("KDL: no external wrench");
    const Eigen::Vector3d force(wrench.force.x(), wrench.force.y(), wrench.force.z());  // tip's axes
    const Eigen::Vector3d& g = model_.gravity_vector;
    return g.dot(model_.kinematics(q).rotation * force) / g.squaredNorm();
  }

 private:
  static KDL::JntArray array(const Vector& v) {
    KDL::JntArray out(Dofs);
    out.data = v;
    return out;
  }

  ArmModel<Dofs> model_;
  KDL::Chain chain_;
  KDL::ChainExternalWrenchEstimator estimator_;
  bool started_ = false;
};

}  // namespace rme::examples
