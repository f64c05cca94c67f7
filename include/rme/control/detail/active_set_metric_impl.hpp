#pragma once
/// The functions of ActiveSetSolver that depend on the metric P. Do not include this file, but active_set_solver.hpp.
#include <rme/control/active_set_solver.hpp>

namespace rme {

/// Sets `a` to the constraint (row, sign) of the present problem (docs/theory_control.md (C8)).
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::make(int row, Scalar sign, Active& a) noexcept {
  a.row = row;
  a.sign = sign;
  a.multiplier = 0;
  if (row >= MaxRows) {
    const int j = row - MaxRows;
    a.normal = sign * Vector::Unit(j);
    a.norm = 1;
    a.bound = sign * (sign > 0 ? (*x_min_)[j] : (*x_max_)[j]);
    a.rise = a.bound - sign * (*x_u_)[j];
  } else {
    const auto& r = (*rows_)[row];
    a.normal = sign * r.a;
    a.norm = std::sqrt(r.squared_norm);
    a.bound = sign * (sign > 0 ? r.lower : r.upper);
    a.rise = a.bound - a.normal.dot(*x_u_);
  }
  look(a);
  a.compliance = compliance(a);
}

/// Sets image and curvature of a constraint.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::look(Active& a) noexcept {
  if (B_ == nullptr) {
    const Vector along = *P_ * a.normal;
    a.image.setZero();
    a.image.template head<Size>() = along;
    a.curvature = a.normal.dot(along);
    return;
  }
  if (a.row >= MaxRows) {
    a.image = a.sign * B_->col(a.row - MaxRows);
  } else {
    // In local variables: the compiler could not exclude that a.image is a part of B. In two sums that do not wait for
    // each other.
    Image even = a.normal[0] * B_->col(0), odd = Image::Zero();
    RME_UNROLL
    for (int i = 1; i < Size; ++i) (i % 2 == 0 ? even : odd) += a.normal[i] * B_->col(i);
    a.image = even + odd;
  }
  a.curvature = a.image.squaredNorm();
}

/// Splits a constraint against the first `count` active ones.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::split(const Active& a, int count, Split& s) const noexcept {
  if (B_ == nullptr) {
    Image n = Image::Zero();
    n.template head<Size>() = a.normal;
    factor_.split_without_root(a.image, n, a.curvature, a.compliance, count, s);
  } else {
    factor_.split(a.image, a.curvature, a.compliance, count, s);
  }
}

/// Splits a constraint against the active ones. P is accurate enough, and the time for a root is saved, as long as the
/// squared length of the orthogonal part is above 64 sqrt(epsilon) sum_i n_i^2 P_ii: the rounding error of n P n is a
/// few epsilon times this sum, and refine() squares the relative error that is left.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::split_safely(Active& a, Split& s) noexcept {
  split(a, count_, s);
  if (B_ != nullptr || s.squared > 64 * std::sqrt(kEpsilon) * a.normal.cwiseAbs2().dot(P_->diagonal())) return;
  needs_root_ = true;
  take_root();  // only the images of the active constraints change
  for (int k = 0; k < count_; ++k) look(active_[index(k)]);
  refactor(0);
  look(a);
  split(a, count_, s);
}

/// From here on a root B of P is used: the host's, or else one computed from P.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::take_root() noexcept {
  if (given_ == nullptr) detail::metric_root(*P_, root_);
  B_ = given_ != nullptr ? given_ : &root_;
}

/// x <- x + B^T z, or x + z without a root, for z = sum_k w_k q_k with the orthogonalised images q_k (C9).
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::shift(const Image& z) noexcept {
  if (B_ == nullptr) {
    x_ += z.template head<Size>();
  } else {
    RME_UNROLL
    for (int i = 0; i < Size; ++i) x_[i] += B_->col(i).dot(z);
  }
}

/// c of (C8): 0 for the box and for hard rows, unless these have become soft.
template <typename Scalar, int Size, int MaxRows>
Scalar ActiveSetSolver<Scalar, Size, MaxRows>::compliance(const Active& a) const noexcept {
  if (a.row >= MaxRows) return 0;
  const Scalar soft = Scalar(1) / (2 * (*rows_)[a.row].weight);
  return soft > 0 || !relaxed_ ? soft : std::sqrt(kEpsilon) * a.curvature;
}

/// Rows may seem to contradict each other only because the metric is ill-conditioned and rounded. So the method goes on
/// in the metric of P + epsilon tr(P) I, whose root has a condition number of at most about epsilon^-1/2.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::stretch_less() noexcept {
  stretched_less_ = true;
  if (B_ == nullptr) take_root();
  root_ = detail::stretched_less(*B_, std::sqrt(kEpsilon) * B_->norm());
  B_ = &root_;
  remake();
}

/// Makes the hard rows soft and goes on from the present active set, in the metric that was given.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::relax() noexcept {
  relaxed_ = true;
  take_root();
  remake();
}

/// Computes the active constraints anew, after a change of metric or compliance.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::remake() noexcept {
  for (int k = 0; k < count_; ++k) make(active_[index(k)].row, active_[index(k)].sign, active_[index(k)]);
  refactor(0);
  restore();
}

/// Rounding error of g - sum_k r_k g_k, in machine epsilons: the terms of B n are as large as |B| |n|.
template <typename Scalar, int Size, int MaxRows>
Scalar ActiveSetSolver<Scalar, Size, MaxRows>::noise(const Active& a, const Column& r) const noexcept {
  Vector sum = a.normal.cwiseAbs();
  for (int k = 0; k < count_; ++k) sum += std::abs(r[index(k)]) * active_[index(k)].normal.cwiseAbs();
  Image terms = Image::Zero();
  for (int i = 0; i < Size; ++i) terms += sum[i] * B_->col(i).cwiseAbs();
  return terms.norm();
}

}  // namespace rme
