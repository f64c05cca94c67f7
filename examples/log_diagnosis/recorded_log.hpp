#pragma once
/// The diagnosis of a recording, with its arm's model.
#include "log_diagnosis/log_diagnosis.hpp"
#include "urdf_arm/recorded_arm.hpp"

namespace rme::examples {

namespace detail {

template <int Dofs>
ModelTorque model_torque(const ArmModel<Dofs>& model, const Motion& motion, bool details) {
  using Vector = JointVector<double, Dofs>;
  // A load's torque is linear in mass and first moment, but for the inertia of its extent, which is made small here.
  constexpr double kHeavy = 1e3;  // [kg]
  const Eigen::Index n = motion.q.rows();
  ModelTorque out;
  out.inertial.resize(n, Dofs);
  out.gravity.resize(n, Dofs);
  if (details) {
    for (Eigen::MatrixXd& m : out.per_gravity) m.resize(n, Dofs);
    for (Eigen::MatrixXd& m : out.per_load) m.resize(n, Dofs);
  }
  std::array<ArmModel<Dofs>, 3> along = {model, model, model};
  for (int i = 0; i < 3; ++i) along[static_cast<std::size_t>(i)].gravity_vector = Eigen::Vector3d::Unit(i);
  for (Eigen::Index k = 0; k < n; ++k) {
    const Vector q = motion.q.row(k).transpose(), dq = motion.dq.row(k).transpose(),
                 ddq = motion.ddq.row(k).transpose();
    const auto inertial_of = [&](const Dynamics<Dofs>& terms) -> Vector {
      return terms.mass_matrix * ddq + terms.coriolis;
    };
    const auto own = model.dynamics(q, dq);
    out.inertial.row(k) = inertial_of(own).transpose();
    out.gravity.row(k) = own.gravity.transpose();
    if (!details) continue;
    for (std::size_t i = 0; i < 3; ++i) out.per_gravity[i].row(k) = along[i].dynamics(q, dq).gravity.transpose();
    const Vector without = inertial_of(own) + own.gravity;
    const auto with = [&](double mass, const Eigen::Vector3d& centre) -> Vector {
      const auto terms = model.dynamics(q, dq, {mass, centre, Eigen::Matrix3d::Zero()});
      return inertial_of(terms) + terms.gravity - without;
    };
    const Vector unit = with(1, Eigen::Vector3d::Zero());
    out.per_load[0].row(k) = unit.transpose();
    for (int i = 0; i < 3; ++i)
      out.per_load[static_cast<std::size_t>(i) + 1].row(k) =
          (with(kHeavy, Eigen::Vector3d::Unit(i) / kHeavy) - kHeavy * unit).transpose();
  }
  return out;
}

template <int Dofs>
Eigen::MatrixXd rows_of(const std::vector<JointVector<double, Dofs>>& values) {
  Eigen::MatrixXd out(static_cast<Eigen::Index>(values.size()), Dofs);
  for (std::size_t i = 0; i < values.size(); ++i) out.row(static_cast<Eigen::Index>(i)) = values[i].transpose();
  return out;
}

}  // namespace detail

/// @param rated_payload  [kg]
template <int Dofs>
DiagnosedArm diagnosed_arm(const RecordedArm<Dofs>& arm, double rated_payload) {
  return {
      arm.model.q_min,
      arm.model.q_max,
      arm.model.tau_max,
      rated_payload,
      arm.model.gravity_vector,
      [model = arm.model](const Motion& motion, bool details) { return detail::model_torque(model, motion, details); }};
}

/// Finds what is wrong with a recording.
/// @param config    its torque_sign and rated_payload are those of the log and the arm
/// @param format    with which the log was read
/// @param may_hold  the hand may hold something for a part of the log
/// @throws LogError as diagnose(), and if the log has neither tau nor tau_ext
template <int Dofs>
Diagnosis diagnose(const FormattedLog<Dofs>& read, const RecordedArm<Dofs>& arm,
                   const EstimatorConfig<double, Dofs>& config, const LogFormat& format, bool may_hold) {
  const Log<Dofs>& log = read.log;
  require_external_torque(log);
  DiagnosedLog given;
  given.name = log.name;
  given.t = log.t;
  given.q = detail::rows_of<Dofs>(log.q);
  given.dq = detail::rows_of<Dofs>(log.dq);
  given.measured = log.tau_ext.empty();
  given.differentiated = read.differentiated;
  given.may_hold = may_hold;
  given.tau = detail::rows_of<Dofs>(given.measured ? log.tau : log.tau_ext) * static_cast<double>(config.torque_sign);
  if (given.measured) {
    given.tau.array().rowwise() *= arm.gains.transpose().array();
    if (arm.lacks_gravity)
      for (std::size_t i = 0; i < log.size(); ++i)
        given.tau.row(static_cast<Eigen::Index>(i)) += arm.model.dynamics(log.q[i], log.dq[i]).gravity.transpose();
  }
  return diagnose(given, diagnosed_arm(arm, config.rated_payload),
                  {format, read.columns, arm.gains, config.torque_sign == TorqueSign::External});
}

}  // namespace rme::examples
