#pragma once
// The closed form of CPIC with one active row, (26) and (27) of the paper with their signs put right.
#include "support/linear_algebra.hpp"

namespace oracle {

/// (23): Q tau + p - A^T lambda = 0 and A tau = v, so tau = Q^-1 (A^T lambda - p), lambda = (A Q^-1 A^T)^-1 (v + A Q^-1
/// p).
struct OneRow {
  Eigen::Matrix<long double, Eigen::Dynamic, 1> torque;
  long double multiplier;  ///< lambda
  double cancellation;     ///< |v| over |v + A Q^-1 p|

  double relative_error(const Vector& found) const;
};

/// Formed literally, in extended precision: Q's condition of 1e5 would cost the oracle what is to be shown.
/// @param gradient, bound  of the row: gradient . ddq >= bound
OneRow one_active_row(const Matrix& jacobian, const Matrix& mass_matrix, const Vector& bias, const Vector& wrench,
                      const Vector& null_torque, double null_space_weight, const Vector& gradient, double bound);

}  // namespace oracle
