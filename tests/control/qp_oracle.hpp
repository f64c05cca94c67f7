#pragma once
// Oracles for quadratic programs min 1/2 (x - x_u)^T Q (x - x_u) s.t. a_i x >= b_i: KKT residuals and enumeration of
// active sets. Nothing here knows the solver.
#include <Eigen/Dense>
#include <cmath>
#include <limits>
#include <random>
#include <vector>

namespace oracle {

using Matrix = Eigen::MatrixXd;
using Vector = Eigen::VectorXd;

/// a x >= b, with the multiplier that a solver claims and the slack that it is allowed (0 if hard).
struct Constraint {
  Vector a;
  double b;
  double multiplier = 0;
  double slack = 0;
};

/// The four KKT conditions, each divided by the scale of the terms in it.
struct Residuals {
  double stationarity = 0, primal = 0, dual = 0, complementarity = 0;
  double worst() const { return std::max(std::max(stationarity, primal), std::max(dual, complementarity)); }
};

inline Residuals kkt_residuals(const Matrix& Q, const Vector& x_u, const Vector& x,
                               const std::vector<Constraint>& constraints) {
  Residuals r;
  Vector gradient = Q * (x - x_u);
  double gradient_scale = (Q * x).norm() + (Q * x_u).norm() + std::numeric_limits<double>::min();
  double largest = 0;
  for (const Constraint& c : constraints) largest = std::max(largest, std::abs(c.multiplier) * c.a.norm());
  for (const Constraint& c : constraints) {
    gradient -= c.multiplier * c.a;
    gradient_scale += std::abs(c.multiplier) * c.a.norm();
    // At the solution a x is a sum of x_u and of what the active constraints added; rounding is relative to both.
    const double scale = c.a.norm() * (x.norm() + x_u.norm()) + std::abs(c.b) + std::numeric_limits<double>::min();
    const double margin = c.a.dot(x) + c.slack - c.b;
    r.primal = std::max(r.primal, -margin / scale);
    if (c.multiplier < 0) r.dual = std::max(r.dual, -c.multiplier * c.a.norm() / largest);
    if (c.multiplier != 0) r.complementarity = std::max(r.complementarity, std::abs(margin) / scale);
  }
  r.stationarity = gradient.norm() / gradient_scale;
  return r;
}

/// The optimum by trying every set of at most n constraints as equalities: exact, exponential, without any cleverness.
/// @return false if no set satisfies the KKT conditions (an infeasible problem)
inline bool enumerate_active_sets(const Matrix& Q, const Vector& x_u, const std::vector<Constraint>& constraints,
                                  Vector& best) {
  const int n = static_cast<int>(x_u.size()), m = static_cast<int>(constraints.size());
  const Matrix P = Q.inverse();
  double best_cost = std::numeric_limits<double>::infinity();
  for (unsigned set = 0; set < (1u << m); ++set) {
    std::vector<int> active;
    for (int i = 0; i < m; ++i) {
      if (set >> i & 1u) active.push_back(i);
    }
    const int k = static_cast<int>(active.size());
    if (k > n) continue;
    Vector x = x_u;
    if (k > 0) {
      Matrix A(k, n);
      Vector b(k);
      for (int i = 0; i < k; ++i) {
        // Unit rows: the enumeration must not suffer from their scales.
        const double norm = constraints[static_cast<std::size_t>(active[static_cast<std::size_t>(i)])].a.norm();
        A.row(i) = constraints[static_cast<std::size_t>(active[static_cast<std::size_t>(i)])].a / norm;
        b[i] = constraints[static_cast<std::size_t>(active[static_cast<std::size_t>(i)])].b / norm;
      }
      const Eigen::FullPivLU<Matrix> lu(A * P * A.transpose());
      if (lu.rank() < k) continue;
      const Vector multipliers = lu.solve(b - A * x_u);
      if (multipliers.minCoeff() < -1e-9 * multipliers.cwiseAbs().maxCoeff()) continue;
      x += P * A.transpose() * multipliers;
    }
    bool feasible = true;
    for (const Constraint& c : constraints) {
      feasible = feasible && c.a.dot(x) - c.b > -1e-8 * (c.a.norm() * x.norm() + std::abs(c.b));
    }
    const double cost = (x - x_u).dot(Q * (x - x_u));
    if (feasible && cost < best_cost) {
      best_cost = cost;
      best = x;
    }
  }
  return best_cost < std::numeric_limits<double>::infinity();
}

inline Matrix random_matrix(std::mt19937& random, int rows, int columns) {
  std::normal_distribution<double> normal;
  Matrix m(rows, columns);
  for (int i = 0; i < m.size(); ++i) m.data()[i] = normal(random);
  return m;
}

inline Matrix random_rotation(std::mt19937& random, int n) {
  const Matrix gaussian = random_matrix(random, n, n);
  return Eigen::HouseholderQR<Matrix>(gaussian).householderQ() * Matrix::Identity(n, n);
}

}  // namespace oracle
