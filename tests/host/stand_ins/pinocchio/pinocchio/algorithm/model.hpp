#pragma once
#include <algorithm>

#include "pinocchio/multibody/model.hpp"

namespace pinocchio {

/// Only the fingers can be locked here.
inline Model buildReducedModel(const Model& model, std::vector<JointIndex> list_of_joints_to_lock,
                               const Eigen::VectorXd& reference_configuration) {
  stand_in::check_size(reference_configuration.size(), model.nq);
  std::sort(list_of_joints_to_lock.begin(), list_of_joints_to_lock.end());
  Model out = model;
  for (std::size_t i = list_of_joints_to_lock.size(); i-- > 0;) {
    const JointIndex joint = list_of_joints_to_lock[i];
    if (joint == 0 || joint >= model.names.size()) throw std::invalid_argument("joint index out of range");
    if (joint < 8) throw std::invalid_argument("the stand-in's arm has seven joints");
    const auto at = static_cast<std::ptrdiff_t>(joint);
    out.names.erase(out.names.begin() + at);
    out.parents.erase(out.parents.begin() + at);
    out.nqs.erase(out.nqs.begin() + at);
    out.nvs.erase(out.nvs.begin() + at);
    out.idx_qs.erase(out.idx_qs.begin() + at);  // the fingers are last
    out.inertias.erase(out.inertias.begin() + at);
    --out.nq, --out.nv, --out.njoints;
  }
  return out;
}

}  // namespace pinocchio
