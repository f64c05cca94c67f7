#pragma once
// Oracles for quadratic programs min 1/2 (x - x_u)^T Q (x - x_u) s.t. a_i x >= b_i: KKT residuals and enumeration of
// active sets. Nothing here knows the solver.
#include <algorithm>
#include <vector>

#include "support/linear_algebra.hpp"

namespace oracle {

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

Residuals kkt_residuals(const Matrix& Q, const Vector& x_u, const Vector& x,
                        const std::vector<Constraint>& constraints);

/// The optimum by trying every set of at most n constraints as equalities: exact, exponential, without any cleverness.
/// @return false if no set satisfies the KKT conditions (an infeasible problem)
bool enumerate_active_sets(const Matrix& Q, const Vector& x_u, const std::vector<Constraint>& constraints,
                           Vector& best);

}  // namespace oracle
