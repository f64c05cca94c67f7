#pragma once
/// The joint torques that make no wrench, and how far the pose is from a singular one.
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/core/cholesky.hpp>
#include <rme/core/householder.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Settings of NullSpace.
template <typename Scalar>
struct NullSpaceConfig {
  /// sigma_0 > 0: N is damped where clearance() is below this. The unit is that of J's singular values, with J in
  /// metres and radians; a Panda has a clearance of 0.15 in its ready pose.
  Scalar clearance = Scalar(0.02);
  Scalar damping = Scalar(0.02);  ///< lambda_0 > 0 at a singular pose, in the unit of J's singular values
};

/// The projector N = I - J^T (J J^T + lambda^2 I)^-1 J onto joint torques without a wrench
/// (docs/theory_control.md (C7)). Away from singular poses lambda = 0: N is exactly the orthogonal projector onto the
/// null space of J, zero for six joints. Where the clearance sigma is below sigma_0, N is damped with
/// lambda = lambda_0 (1 - (sigma / sigma_0)^2). Torques that make almost no wrench there count partly as null space, so
/// J N != 0. N is a continuous function of J, with eigenvalues in [0, 1].
///
/// @tparam Dofs  number of joints, >= 6
template <typename Scalar, int Dofs>
class NullSpace {
  static_assert(Dofs >= 6, "an arm with fewer than six joints cannot make every wrench: J^+ has no right inverse");

 public:
  /// @throws std::invalid_argument naming the field out of range
  explicit NullSpace(const NullSpaceConfig<Scalar>& config = NullSpaceConfig<Scalar>()) : config_(config) {
    detail::require_positive(config.clearance, "NullSpaceConfig::clearance", "> 0");
    detail::require_positive(config.damping, "NullSpaceConfig::damping", "> 0");
  }

  /// Computes N of the Jacobian J, 6xDofs.
  /// @return Ok, or NonFiniteInput, also for numbers beyond kLargestPlausible: N is then as it was
  Status update(const Jacobian<Scalar, Dofs>& jacobian) noexcept;

  const JointMatrix<Scalar, Dofs>& projector() const noexcept { return projector_; }  ///< N, DofsxDofs; zero at first
  /// Z with N = Z Z^T, DofsxDofs. The first six columns are zero unless N is damped. Z keeps small eigenvalues of N
  /// that rounding takes from the entries of N.
  const JointMatrix<Scalar, Dofs>& root() const noexcept { return root_; }
  /// sigma = |J^+|_F^-1, between sigma_min / sqrt(6) and sigma_min, J's smallest singular value; 0 at a singular pose.
  Scalar clearance() const noexcept { return clearance_; }
  Scalar damping() const noexcept { return damping_; }  ///< lambda

 private:
  NullSpaceConfig<Scalar> config_;
  /// Sets column m of Z to H_0 ... H_5 x, with the reflections whose vectors are in the columns of `a`.
  void set_root(int m, JointVector<Scalar, Dofs> x, const Eigen::Matrix<Scalar, Dofs, 6>& a) noexcept;

  JointMatrix<Scalar, Dofs> projector_ = JointMatrix<Scalar, Dofs>::Zero();
  JointMatrix<Scalar, Dofs> root_ = JointMatrix<Scalar, Dofs>::Zero();
  Scalar clearance_ = Scalar(0);
  Scalar damping_ = Scalar(0);
};

template <typename Scalar, int Dofs>
Status NullSpace<Scalar, Dofs>::update(const Jacobian<Scalar, Dofs>& jacobian) noexcept {
  if (!plausible(jacobian)) return Status::NonFiniteInput;
  // J^T = Q [R; 0]. J J^T would square the condition number, and its error would grow further when N is divided by the
  // small null-space weight.
  Eigen::Matrix<Scalar, Dofs, 6> a;
  for (int i = 0; i < Dofs; ++i)
    for (int k = 0; k < 6; ++k) a(i, k) = jacobian(k, i);
  Vector6<Scalar> diagonal;
  detail::householder(a, diagonal);

  // |J^+|_F = |R^-1|_F, column by column; a pivot of zero makes it infinite and the clearance zero.
  Scalar inverse_squared = 0;
  for (int j = 0; j < 6; ++j) {
    Vector6<Scalar> column;
    for (int i = j; i >= 0; --i) {
      Scalar sum = i == j ? Scalar(1) : Scalar(0);
      for (int l = i + 1; l <= j; ++l) sum -= a(i, l) * column[l];
      column[i] = sum / diagonal[i];
      inverse_squared += column[i] * column[i];
    }
  }
  // Where the inverse overflows (or is NaN from 0 / 0) the pose counts as singular.
  clearance_ = inverse_squared < Scalar(1) / std::numeric_limits<Scalar>::min() ? Scalar(1) / std::sqrt(inverse_squared)
                                                                                : Scalar(0);

  const Scalar ratio = clearance_ / config_.clearance;
  damping_ = config_.damping * std::max(Scalar(0), Scalar(1) - ratio * ratio);
  root_.setZero();
  for (int m = 6; m < Dofs; ++m) {  // Q's last columns: the null space
    JointVector<Scalar, Dofs> unit = JointVector<Scalar, Dofs>::Zero();
    unit[m] = Scalar(1);
    set_root(m, unit, a);
  }
  if (damping_ > 0) {
    // In Q's first six columns N is lambda^2 (R R^T + lambda^2 I)^-1 = (lambda C^-T)(lambda C^-T)^T, with the Cholesky
    // factor C of R R^T + lambda^2 I.
    Matrix6<Scalar> R = Matrix6<Scalar>::Zero(), identity = R;
    for (int i = 0; i < 6; ++i) {
      R(i, i) = diagonal[i];
      identity(i, i) = Scalar(1);
      for (int j = i + 1; j < 6; ++j) R(i, j) = a(i, j);
    }
    Matrix6<Scalar> damped = detail::outer_square(R);
    for (int i = 0; i < 6; ++i) damped(i, i) += damping_ * damping_;
    const Matrix6<Scalar> inverse = Cholesky<Scalar, 6>(damped).solve_lower(identity);  // C^-1
    for (int m = 0; m < 6; ++m) {
      JointVector<Scalar, Dofs> x = JointVector<Scalar, Dofs>::Zero();
      for (int i = 0; i <= m; ++i) x[i] = damping_ * inverse(m, i);
      set_root(m, x, a);
    }
  }
  projector_.setZero();
  for (int m = damping_ > 0 ? 0 : 6; m < Dofs; ++m) {
    const JointVector<Scalar, Dofs> z = detail::column(root_, m);
    detail::add_outer(projector_, z, z);
  }
  return Status::Ok;
}

template <typename Scalar, int Dofs>
void NullSpace<Scalar, Dofs>::set_root(int m, JointVector<Scalar, Dofs> x,
                                       const Eigen::Matrix<Scalar, Dofs, 6>& a) noexcept {
  for (int k = 5; k >= 0; --k) {
    Scalar dot = 0;
    for (int i = k; i < Dofs; ++i) dot += a(i, k) * x[i];
    for (int i = k; i < Dofs; ++i) x[i] -= dot * a(i, k);
  }
  detail::column(root_, m) = x;
}

}  // namespace rme
