#include "random_arm.hpp"

#include <algorithm>
#include <cmath>

namespace oracle {

template <int Dofs, int MaxRows>
RandomArm<Dofs, MaxRows>::RandomArm(std::mt19937& random, int axes, int general, double tightness) {
  std::uniform_real_distribution<double> uniform;
  const Matrix U = random_rotation(random, 6), V = random_rotation(random, Dofs);
  Vector sigma(6);
  for (int i = 0; i < 6; ++i) sigma[i] = 0.1 * std::pow(15.0, uniform(random));
  input.jacobian = composed(U, sigma, V);
  pseudo_inverse = composed(V, sigma.cwiseInverse(), U);
  null_projector = square(V.rightCols(Dofs - 6));

  const Matrix samples = random_matrix(random, Dofs, 3 * Dofs);
  const Matrix covariance = square(samples);
  const double inertia[] = {1.0, 1.4, 0.8, 0.9, 0.04, 0.03, 0.005};
  Vector scale(Dofs);
  for (int j = 0; j < Dofs; ++j) scale[j] = std::sqrt(inertia[j + 7 - Dofs] / covariance(j, j));
  for (int i = 0; i < Dofs; ++i) {
    for (int j = 0; j < Dofs; ++j) input.mass_matrix(i, j) = scale[i] * covariance(i, j) * scale[j];
  }
  input.bias = 10 * random_matrix(random, Dofs, 1);
  input.null_torque = 3 * random_matrix(random, Dofs, 1);
  for (int j = 0; j < Dofs; ++j) torque_limit[j] = j < 4 ? 87 : 12;

  rme::JointVector<double, Dofs> feasible;
  for (int j = 0; j < Dofs; ++j) feasible[j] = (2 * uniform(random) - 1) * torque_limit[j];
  const rme::JointVector<double, Dofs> ddq = inverse(input.mass_matrix) * (feasible - input.bias);
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

template <int Dofs, int MaxRows>
Matrix RandomArm<Dofs, MaxRows>::hessian(double eps, double moment_arm) const {
  Matrix weighted = pseudo_inverse;
  weighted.rightCols(3) /= moment_arm;
  return 2 * (square(weighted) + eps * null_projector);
}

template <int Dofs, int MaxRows>
Vector RandomArm<Dofs, MaxRows>::unconstrained() const {
  return product(transposed(input.jacobian), input.wrench.vector()) + product(null_projector, input.null_torque);
}

template <int Dofs, int MaxRows>
std::vector<Constraint> RandomArm<Dofs, MaxRows>::constraints(const rme::Cpic<double, Dofs>& cpic) const {
  std::vector<Constraint> all;
  Matrix gradients(Dofs, rows.size());
  for (int i = 0; i < rows.size(); ++i) gradients.col(i) = rows[i].a;
  const Matrix columns = solve(input.mass_matrix, gradients);  // of A^T
  for (int i = 0; i < rows.size(); ++i) {
    const Vector a = columns.col(i);
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

template struct RandomArm<6, 28>;
template struct RandomArm<7, 28>;

}  // namespace oracle
