#pragma once
/// Corrects the masses, centres of mass and inertias of a URDF's links from the torque of an empty hand.
#include <Eigen/Core>
#include <array>
#include <cmath>
#include <rme/tracking/inertial_parameters.hpp>
#include <rme/tracking/torque_block.hpp>
#include <string>
#include <vector>

#include "check_arm/joint_findings.hpp"

namespace rme::examples {

/// For each joint a matrix with a row per block: the joint torque [N m] per unit of each link's ten inertial
/// parameters, link after link.
using LinkRegressors = std::vector<Eigen::MatrixXd>;

/// Pose of a link of the arm, and the Jacobian of its origin.
template <int Dofs>
Kinematics<Dofs> link_kinematics(const ArmModel<Dofs>& model, const JointVector<double, Dofs>& q, int link) {
  ArmModel<Dofs> upto = model;  // the joints beyond the link do not move it: they are placed at its origin, at zero
  upto.flange.setZero();
  upto.flange_rotation.setIdentity();
  JointVector<double, Dofs> angles = q;
  for (int j = link + 1; j < Dofs; ++j) {
    upto.links[static_cast<std::size_t>(j)].offset.setZero();
    upto.links[static_cast<std::size_t>(j)].rotation.setIdentity();
    angles[j] = 0;
  }
  Kinematics<Dofs> out = upto.kinematics(angles);
  for (int j = link + 1; j < Dofs; ++j) out.jacobian.col(j).setZero();
  return out;
}

/// The regressors of all links, in the blocks of blocks_of(log, samples, arm).
template <int Dofs>
LinkRegressors link_regressors(const Log<Dofs>& log, const Samples<Dofs>& samples, const RecordedArm<Dofs>& arm) {
  std::vector<Eigen::Matrix<double, Dofs, kInertial>> rows;
  LinkRegressors out(Dofs);
  for (int link = 0; link < Dofs; ++link) {
    // As in blocks_of(): blocks of the same instants for every link.
    using Averager = BlockAverager<double, Dofs>;
    Averager averager(samples.bandwidth, arm.model.gravity_vector, Averager::kDuration);
    rows.clear();
    for (std::size_t k = 0; k < samples.sample.size(); ++k) {
      Proprioception<double, Dofs> sample = samples.sample[k];
      const std::size_t row = samples.row[k];
      const auto at = link_kinematics(arm.model, log.q[row], link);
      sample.jacobian = at.jacobian;
      sample.rotation = at.rotation;
      if (averager.add(sample, sample.period > 0 ? sample.period : samples.timing.period, log.t[row]))
        rows.push_back(averager.block().regressor);
    }
    for (int j = 0; j < Dofs; ++j) {
      Eigen::MatrixXd& mine = out[static_cast<std::size_t>(j)];
      mine.conservativeResize(static_cast<Eigen::Index>(rows.size()), Eigen::Index{kInertial} * Dofs);
      for (std::size_t i = 0; i < rows.size(); ++i)
        mine.block<1, kInertial>(static_cast<Eigen::Index>(i), Eigen::Index{kInertial} * link) = rows[i].row(j);
    }
  }
  return out;
}

struct LinkCorrection {
  /// Additions to the links' inertial parameters, link axes, about the links' origins.
  std::vector<InertialVector<double>> addition;
  std::vector<double> rotor;  ///< inertia of each joint's rotor, seen through its gear; not in a URDF [kg m^2]
  /// Root mean square of the unexplained torque with the corrections, divided by that without them. Out of sample: for
  /// each fifth of the logs, with what was fitted to the other four.
  double left = 1;
};

/// Ridge regression towards the URDF, together with each joint's offset, friction, friction that grows with the load,
/// and rotor inertia.
/// @param bodies  the URDF's links
LinkCorrection correct_links(const std::vector<LogBlocks>& logs, const std::vector<LinkRegressors>& regressors,
                             const std::vector<JointFindings>& joints, const std::vector<RigidBody>& bodies);

/// The body with an addition to its inertial parameters, changed if need be so that it is physically consistent.
RigidBody corrected(const RigidBody& body, const InertialVector<double>& addition);

/// A URDF of the arm between the same base and tip. It has one link for each moving joint, which includes all that was
/// fixed to it.
std::string to_urdf(const UrdfChain& chain);

}  // namespace rme::examples
