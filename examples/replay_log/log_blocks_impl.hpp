#pragma once
/// Implementation of log_blocks.hpp, for replay_dofs.cpp.in, which compiles it for each number of joints.
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/torque_block.hpp>

#include "replay_log/log_blocks.hpp"

namespace rme::examples {

template <int Dofs>
LogBlocks blocks_of(const Log<Dofs>& log, const Samples<Dofs>& samples, const RecordedArm<Dofs>& arm) {
  using Averager = BlockAverager<double, Dofs>;
  Averager averager(samples.bandwidth, arm.model.gravity_vector, Averager::kDuration);
  FrictionRegime<double, Dofs> regime;
  struct Row {
    TorqueBlock<double, Dofs> block;
    JointVector<double, Dofs> direction, resting, gravity;
  };
  std::vector<Row> rows;
  const double sign = static_cast<double>(samples.sign);
  for (std::size_t k = 0; k < samples.sample.size(); ++k) {
    Proprioception<double, Dofs> sample = samples.sample[k];
    sample.tau_ext *= sign;
    const double t = log.t[samples.row[k]];
    if (!averager.add(sample, sample.period > 0 ? sample.period : samples.timing.period, t)) continue;
    Row row{averager.block(), {}, {}, {}};
    regime.update(row.block);
    for (int j = 0; j < Dofs; ++j) {
      row.direction[j] = regime.joint(j).direction;
      row.resting[j] = regime.joint(j).resting;
    }
    const JointVector<double, Dofs> rest = JointVector<double, Dofs>::Zero();
    row.gravity = arm.model.dynamics(log.q[samples.row[k]], rest).gravity;
    rows.push_back(row);
  }
  LogBlocks out;
  out.name = log.name;
  const auto n = static_cast<Eigen::Index>(rows.size());
  out.end.resize(n);
  out.duration.resize(n);
  for (Eigen::MatrixXd* m : {&out.tau, &out.velocity, &out.direction, &out.resting, &out.gravity}) m->resize(n, Dofs);
  out.payload.assign(Dofs, Eigen::MatrixXd(n, 4));
  for (Eigen::Index i = 0; i < n; ++i) {
    const Row& row = rows[static_cast<std::size_t>(i)];
    out.end[i] = row.block.end;
    out.duration[i] = row.block.duration;
    out.tau.row(i) = row.block.tau.transpose();
    out.velocity.row(i) = row.block.velocity.transpose();
    out.direction.row(i) = row.direction.transpose();
    out.resting.row(i) = row.resting.transpose();
    out.gravity.row(i) = row.gravity.transpose();
    for (int j = 0; j < Dofs; ++j)
      out.payload[static_cast<std::size_t>(j)].row(i) = row.block.regressor.row(j).template head<4>();
  }
  return out;
}

}  // namespace rme::examples
