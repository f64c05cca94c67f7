#include "qp_oracle.hpp"

#include <Eigen/Dense>
#include <cmath>
#include <limits>

namespace oracle {

Residuals kkt_residuals(const Matrix& Q, const Vector& x_u, const Vector& x,
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

bool enumerate_active_sets(const Matrix& Q, const Vector& x_u, const std::vector<Constraint>& constraints,
                           Vector& best) {
  const int n = static_cast<int>(x_u.size()), m = static_cast<int>(constraints.size());
  const Matrix P = inverse(Q);
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
      const Eigen::FullPivLU<Matrix> lu(congruence(A, P));
      if (lu.rank() < k) continue;
      const Vector gap = b - A * x_u;
      const Vector multipliers = lu.solve(gap);
      if (multipliers.minCoeff() < -1e-9 * multipliers.cwiseAbs().maxCoeff()) continue;
      const Vector pull = A.transpose() * multipliers;
      x += P * pull;
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

}  // namespace oracle
