#include "one_active_row.hpp"

#include <Eigen/LU>
#include <cmath>

namespace oracle {

namespace {

using Extended = Eigen::Matrix<long double, Eigen::Dynamic, Eigen::Dynamic>;

Extended extended(const Matrix& A) {
  return A.cast<long double>();
}
Extended inverted(const Extended& A) {
  return A.fullPivLu().inverse();
}

}  // namespace

double OneRow::relative_error(const Vector& found) const {
  return static_cast<double>((found.cast<long double>() - torque).norm() / torque.norm());
}

OneRow one_active_row(const Matrix& jacobian, const Matrix& mass_matrix, const Vector& bias, const Vector& wrench,
                      const Vector& null_torque, double null_space_weight, const Vector& gradient, double bound) {
  const Extended J = extended(jacobian), Jt = J.transpose();
  const Extended pseudo_inverse = Jt * inverted(J * Jt);
  const Extended N = Extended::Identity(J.cols(), J.cols()) - pseudo_inverse * J;
  const long double eps = null_space_weight;
  const Extended Q = 2 * (pseudo_inverse * pseudo_inverse.transpose() + eps * N);
  const Extended p = -2 * (pseudo_inverse * extended(wrench) + eps * N * extended(null_torque));
  const Extended At = inverted(extended(mass_matrix)) * extended(gradient);
  const long double v = bound + At.cwiseProduct(extended(bias)).sum();
  const Extended Q_inverse = inverted(Q);
  const Extended Q_inverse_At = Q_inverse * At;
  const long double gap = v + Q_inverse_At.cwiseProduct(p).sum();
  const long double multiplier = gap / Q_inverse_At.cwiseProduct(At).sum();
  return {Q_inverse_At * multiplier - Q_inverse * p, multiplier, static_cast<double>(std::abs(v / gap))};
}

}  // namespace oracle
