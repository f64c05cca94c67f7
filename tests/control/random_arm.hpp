#pragma once
// Random arm states for CPIC whose pseudo-inverse is known by construction.
#include <rme/control/cpic.hpp>

#include "qp_oracle.hpp"

namespace oracle {

/// J = U diag(sigma) V^T with sigma in [0.1, 1.5]; M with the joints of a Panda: correlated, diagonal 1.4 to 0.005 kg
/// m^2. The rows are those of joint limits (two-sided) and of random gradients, and a torque that keeps them exists.
template <int Dofs, int MaxRows>
struct RandomArm {
  Eigen::Matrix<double, Dofs, 6> pseudo_inverse;  // J^+
  Matrix null_projector;                          // N, Dofs x Dofs
  rme::CpicInput<double, Dofs> input;
  rme::ConstraintRows<double, Dofs, MaxRows> rows;
  rme::JointVector<double, Dofs> torque_limit;

  /// @param axes      how many joints have limits
  /// @param general   how many rows with a random gradient
  /// @param tightness how far beyond the feasible torque the task force asks to go [N]
  RandomArm(std::mt19937& random, int axes, int general, double tightness);

  /// Q = 2 (J^+ W^2 J^+T + eps N), where W weighs moments by 1 / l
  Matrix hessian(double eps, double moment_arm = 1) const;
  /// J^T F_c + N tau_0
  Vector unconstrained() const;
  /// The rows as the paper writes them, A tau >= v with A = grad^T M^-1 and v = bound + A h, with a controller's
  /// answers.
  std::vector<Constraint> constraints(const rme::Cpic<double, Dofs>& cpic) const;
};

extern template struct RandomArm<6, 28>;
extern template struct RandomArm<7, 28>;

}  // namespace oracle
