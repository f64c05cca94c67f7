#pragma once
// Random arm states for CPIC whose pseudo-inverse is known by construction.
#include <rme/control/cpic.hpp>

#include "qp_oracle.hpp"

namespace oracle {

/// J = U diag(sigma) V^T with sigma in [0.1, 1.5]; M with the joints of a Panda: correlated, diagonal 1.4 to 0.005 kg
/// m^2. The rows are those of joint limits (two-sided) and of random gradients, and a torque that keeps them exists.
template <int Dofs, int MaxRows>
struct RandomArm {
  Eigen::Matrix<double, Dofs, 6> pseudo_inverse;     // J^+
  Eigen::Matrix<double, Dofs, Dofs> null_projector;  // N
  rme::CpicInput<double, Dofs> input;
  rme::ConstraintRows<double, Dofs, MaxRows> rows;
  rme::JointVector<double, Dofs> torque_limit;

  /// @param axes      how many joints have limits
  /// @param general   how many rows with a random gradient
  /// @param tightness how far beyond the feasible torque the task force asks to go [N]
  RandomArm(std::mt19937& random, int axes, int general, double tightness) {
    std::uniform_real_distribution<double> uniform;
    const Matrix U = random_rotation(random, 6), V = random_rotation(random, Dofs);
    Vector sigma(6);
    for (int i = 0; i < 6; ++i) sigma[i] = 0.1 * std::pow(15.0, uniform(random));
    input.jacobian = U * sigma.asDiagonal() * V.leftCols(6).transpose();
    pseudo_inverse = V.leftCols(6) * sigma.cwiseInverse().asDiagonal() * U.transpose();
    null_projector = V.rightCols(Dofs - 6) * V.rightCols(Dofs - 6).transpose();

    const Matrix samples = random_matrix(random, Dofs, 3 * Dofs);
    const Matrix covariance = samples * samples.transpose();
    const double inertia[] = {1.0, 1.4, 0.8, 0.9, 0.04, 0.03, 0.005};
    Vector scale(Dofs);
    for (int j = 0; j < Dofs; ++j) scale[j] = std::sqrt(inertia[j + 7 - Dofs] / covariance(j, j));
    input.mass_matrix = scale.asDiagonal() * covariance * scale.asDiagonal();
    input.bias = 10 * random_matrix(random, Dofs, 1);
    input.null_torque = 3 * random_matrix(random, Dofs, 1);
    for (int j = 0; j < Dofs; ++j) torque_limit[j] = j < 4 ? 87 : 12;

    rme::JointVector<double, Dofs> feasible;
    for (int j = 0; j < Dofs; ++j) feasible[j] = (2 * uniform(random) - 1) * torque_limit[j];
    const rme::JointVector<double, Dofs> ddq = input.mass_matrix.inverse() * (feasible - input.bias);
    const rme::Vector6<double> wrench = pseudo_inverse.transpose() * feasible + tightness * random_matrix(random, 6, 1);
    input.wrench = rme::Wrench<double>::from_vector(wrench);
    for (int j = 0; j < axes; ++j) {
      const double room = 30 * uniform(random);
      (void)rows.add_axis(j, ddq[j] - room * uniform(random), ddq[j] + room);
    }
    for (int k = 0; k < general; ++k) {
      const rme::JointVector<double, Dofs> gradient = random_matrix(random, Dofs, 1).normalized();
      const double room = uniform(random) < 0.05 ? 0 : 20 * uniform(random);
      (void)rows.add(gradient, gradient.dot(ddq) - room);
    }
  }

  /// Q = 2 (J^+ W^2 J^+T + eps N), where W weighs moments by 1 / l
  Eigen::Matrix<double, Dofs, Dofs> hessian(double eps, double moment_arm = 1) const {
    Eigen::Matrix<double, Dofs, 6> weighted = pseudo_inverse;
    weighted.template rightCols<3>() /= moment_arm;
    return 2 * (weighted * weighted.transpose() + eps * null_projector);
  }
  /// J^T F_c + N tau_0
  Vector unconstrained() const {
    return input.jacobian.transpose() * input.wrench.vector() + null_projector * input.null_torque;
  }
  /// The rows as the paper writes them, A tau >= v with A = grad^T M^-1 and v = bound + A h, with a controller's
  /// answers.
  template <typename Controller>
  std::vector<Constraint> constraints(const Controller& cpic) const {
    std::vector<Constraint> all;
    const Eigen::LDLT<Matrix> inertia(input.mass_matrix);
    for (int i = 0; i < rows.size(); ++i) {
      const Vector a = inertia.solve(rows[i].a);
      const double shift = a.dot(input.bias), l = cpic.multiplier(i);
      all.push_back({a, rows[i].lower + shift, std::max(l, 0.0)});
      if (rows[i].upper < rows.kFree) all.push_back({-a, -rows[i].upper - shift, std::max(-l, 0.0)});
    }
    for (int j = 0; j < Dofs; ++j) {
      const double l = cpic.torque_multiplier(j), other = input.other_torque[j];
      all.push_back({Vector::Unit(Dofs, j), -torque_limit[j] - other, std::max(l, 0.0)});
      all.push_back({-Vector::Unit(Dofs, j), -torque_limit[j] + other, std::max(-l, 0.0)});
    }
    return all;
  }
};

}  // namespace oracle
