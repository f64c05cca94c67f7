#pragma once
#include "pinocchio/multibody/model.hpp"

namespace pinocchio {

inline Eigen::VectorXd neutral(const Model& model) {
  Eigen::VectorXd q = Eigen::VectorXd::Zero(model.nq);
  for (std::size_t i = 1; i < model.names.size(); ++i)
    if (model.nqs[i] == 2) q[model.idx_qs[i]] = 1;
  return q;
}

}  // namespace pinocchio
