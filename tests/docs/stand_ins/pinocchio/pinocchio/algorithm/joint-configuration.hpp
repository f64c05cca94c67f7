#pragma once
#include "pinocchio/multibody/model.hpp"

namespace pinocchio {

inline Eigen::VectorXd neutral(const Model& model) {
  return Eigen::VectorXd::Zero(model.nq);
}

}  // namespace pinocchio
