#include "synthetic_arm/random_pose.hpp"

#include <Eigen/Eigenvalues>

namespace rme::examples {

double smallest_mobility(const Jacobian<double, 7>& jacobian) {
  const Matrix6<double> mobility = jacobian * jacobian.transpose();
  return Eigen::SelfAdjointEigenSolver<Matrix6<double>>(mobility, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

}  // namespace rme::examples
