#pragma once
/// Bodies of ActiveSetSolver; include active_set_solver.hpp.
#include <rme/control/active_set_solver.hpp>

namespace rme {

template <typename Scalar, int Size, int MaxRows>
Status ActiveSetSolver<Scalar, Size, MaxRows>::solve(const Matrix& P, const Vector& x_u, const Rows& rows,
                                                     const Vector& x_min, const Vector& x_max) noexcept {
  P_ = &P;
  x_u_ = &x_u;
  rows_ = &rows;
  x_min_ = &x_min;
  x_max_ = &x_max;
  relaxed_ = false;
  iterations_ = 0;
  held_.fill(false);
  for (int k = 0, previous = std::exchange(count_, 0); k < previous; ++k) {
    const int row = active_[index(k)].row;
    // push() never writes beyond the entry being read, so the old list is walked while the new one grows.
    if (row >= MaxRows || row < rows.size()) push(make(row, active_[index(k)].sign));
  }
  restore();

  Status status = Status::Ok;
  int row = 0;
  Scalar sign = 0;
  while (most_violated(row, sign)) {
    if (iterations_ >= kMaxIterations) {
      status = Status::NotConverged;
      break;
    }
    if (enter(make(row, sign))) {
      solve_multipliers();
      move();
    } else if (!relaxed_) {
      relax();
    } else {
      status = Status::NotConverged;
      break;
    }
  }
  publish();
  return status == Status::Ok && relaxed_ ? Status::Infeasible : status;
}

/// The constraint (row, sign) of the present problem, not yet pushed.
template <typename Scalar, int Size, int MaxRows>
auto ActiveSetSolver<Scalar, Size, MaxRows>::make(int row, Scalar sign) const noexcept -> Active {
  Active a;
  a.row = row;
  a.sign = sign;
  a.multiplier = 0;
  Scalar bound;
  if (row >= MaxRows) {
    const int j = row - MaxRows;
    a.normal = sign * Vector::Unit(j);
    a.image = sign * P_->col(j);
    bound = sign > 0 ? (*x_min_)[j] : (*x_max_)[j];
  } else {
    const auto& r = (*rows_)[row];
    a.normal = sign * r.a;
    a.image.noalias() = *P_ * a.normal;
    bound = sign > 0 ? r.lower : r.upper;
  }
  a.curvature = a.normal.dot(a.image);
  a.rise = sign * bound - a.normal.dot(*x_u_);
  a.compliance = compliance(a);
  return a;
}

template <typename Scalar, int Size, int MaxRows>
Scalar ActiveSetSolver<Scalar, Size, MaxRows>::compliance(const Active& a) const noexcept {
  if (a.row >= MaxRows) return 0;
  const Scalar soft = Scalar(1) / (2 * (*rows_)[a.row].weight);
  return soft > 0 || !relaxed_ ? soft : std::sqrt(kEpsilon) * a.curvature;
}

/// y = L^-1 (n_k^T P n)_k over the first `count` active constraints; returns the pivot n P n + c - y^T y that the
/// constraint would get.
template <typename Scalar, int Size, int MaxRows>
Scalar ActiveSetSolver<Scalar, Size, MaxRows>::project(const Active& a, int count, Column& y) const noexcept {
  Scalar pivot = a.curvature + a.compliance;
  for (int k = 0; k < count; ++k) {
    Scalar sum = active_[index(k)].image.dot(a.normal);
    for (int l = 0; l < k; ++l) sum -= factor_[index(k)][index(l)] * y[index(l)];
    y[index(k)] = sum * inverse_pivot_[index(k)];
    pivot -= y[index(k)] * y[index(k)];
  }
  return pivot;
}

/// y <- L^-T y
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::back_substitute(Column& y) const noexcept {
  for (int k = count_ - 1; k >= 0; --k) {
    y[index(k)] *= inverse_pivot_[index(k)];
    for (int l = 0; l < k; ++l) y[index(l)] -= factor_[index(k)][index(l)] * y[index(k)];
  }
}

template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::store(const Active& a, const Column& y, Scalar pivot) noexcept {
  active_[index(count_)] = a;
  for (int k = 0; k < count_; ++k) factor_[index(count_)][index(k)] = y[index(k)];
  inverse_pivot_[index(count_)] = Scalar(1) / std::sqrt(pivot);
  held_[index(a.row)] = true;
  ++count_;
}

/// Appends a constraint of an earlier active set, unless it depends on those before it.
template <typename Scalar, int Size, int MaxRows>
bool ActiveSetSolver<Scalar, Size, MaxRows>::push(const Active& a) noexcept {
  Column y;
  const Scalar pivot = project(a, count_, y);
  // A generous threshold: a constraint left out here comes back through enter() if the optimum needs it.
  if (!(pivot > std::sqrt(kEpsilon) * a.curvature) || !std::isfinite(a.rise)) return false;
  store(a, y, pivot);
  return true;
}

template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::drop(int k) noexcept {
  held_[index(active_[index(k)].row)] = false;
  for (int l = k + 1; l < count_; ++l) active_[index(l - 1)] = active_[index(l)];
  --count_;
  refactor(k);
}

/// Computes the rows of L from `from` on anew.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::refactor(int from) noexcept {
  for (int k = from; k < count_; ++k) {
    const Scalar pivot = project(active_[index(k)], k, factor_[index(k)]);
    // S stays positive definite when rows and columns leave it; the floor only guards against rounding.
    inverse_pivot_[index(k)] = Scalar(1) / std::sqrt(std::max(pivot, kEpsilon * active_[index(k)].curvature));
  }
}

/// S lambda = d
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::solve_multipliers() noexcept {
  Column y;
  for (int k = 0; k < count_; ++k) {
    Scalar sum = active_[index(k)].rise;
    for (int l = 0; l < k; ++l) sum -= factor_[index(k)][index(l)] * y[index(l)];
    y[index(k)] = sum * inverse_pivot_[index(k)];
  }
  back_substitute(y);
  for (int k = 0; k < count_; ++k) active_[index(k)].multiplier = y[index(k)];
}

/// Drops constraints until all multipliers are non-negative: from there on the dual method may start.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::restore() noexcept {
  while (count_ > 0) {
    solve_multipliers();
    int worst = 0;
    for (int k = 1; k < count_; ++k) {
      if (active_[index(k)].multiplier < active_[index(worst)].multiplier) worst = k;
    }
    if (active_[index(worst)].multiplier >= 0) break;
    drop(worst);
    ++iterations_;
  }
  move();
}

/// x = x_u + sum lambda_k P n_k
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::move() noexcept {
  x_ = *x_u_;
  for (int k = 0; k < count_; ++k) x_ += active_[index(k)].multiplier * active_[index(k)].image;
  if (count_ > 1) refine();
}

/// One step of iterative refinement on the active constraints: nearly parallel ones have large multipliers whose terms
/// cancel in x. The correction is added to x as it is, not to the sum, where it would drown in the same rounding.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::refine() noexcept {
  const Vector moved = x_ - *x_u_;
  Column y;
  for (int k = 0; k < count_; ++k) {
    const Active& a = active_[index(k)];
    Scalar sum = a.rise - a.normal.dot(moved) - a.compliance * a.multiplier;
    for (int l = 0; l < k; ++l) sum -= factor_[index(k)][index(l)] * y[index(l)];
    y[index(k)] = sum * inverse_pivot_[index(k)];
  }
  back_substitute(y);
  for (int k = 0; k < count_; ++k) {
    active_[index(k)].multiplier += y[index(k)];
    x_ += y[index(k)] * active_[index(k)].image;
  }
}

/// Brings a violated constraint into the active set, dropping those whose multiplier would turn negative on the way.
/// @return false if it contradicts those that cannot be dropped
template <typename Scalar, int Size, int MaxRows>
bool ActiveSetSolver<Scalar, Size, MaxRows>::enter(Active a) noexcept {
  Scalar rise = a.rise - a.normal.dot(x_ - *x_u_);
  Column y, r;
  for (; iterations_ < kMaxIterations; ++iterations_) {
    const Scalar pivot = project(a, count_, y);
    r = y;
    back_substitute(r);
    Scalar blocked = kInfinity;  // the step at which a multiplier reaches zero
    int blocking = -1;
    int hard = 0;
    Scalar magnitude = std::sqrt(a.curvature + a.compliance);
    for (int k = 0; k < count_; ++k) {
      const Active& other = active_[index(k)];
      const Scalar rate = r[index(k)];
      if (rate > 0 && other.multiplier < blocked * rate) {
        blocked = std::max(other.multiplier, Scalar(0)) / rate;
        blocking = k;
      }
      magnitude += std::abs(rate) * std::sqrt(other.curvature + other.compliance);
      hard += other.compliance > 0 ? 0 : 1;
    }
    // The pivot is [-r 1] S [-r 1]^T, so rounding leaves it this uncertain; Size hard rows span everything.
    const bool dependent = pivot <= 16 * kEpsilon * magnitude * magnitude || (hard >= Size && !(a.compliance > 0));
    const Scalar full = dependent ? kInfinity : rise / pivot;
    if (full <= blocked && !dependent) {
      store(a, y, pivot);
      ++iterations_;
      return true;
    }
    if (blocking < 0) return false;
    for (int k = 0; k < count_; ++k) active_[index(k)].multiplier -= blocked * r[index(k)];
    if (!dependent) rise -= blocked * pivot;
    drop(blocking);
  }
  return true;
}

/// Finds the violated constraint that is furthest away in x; the active ones hold.
template <typename Scalar, int Size, int MaxRows>
bool ActiveSetSolver<Scalar, Size, MaxRows>::most_violated(int& row, Scalar& sign) const noexcept {
  const Scalar scale = x_u_->norm() + x_.norm();
  Scalar furthest = 0;
  const auto consider = [&](int i, Scalar value, Scalar lower, Scalar upper, Scalar squared_norm) {
    const Scalar below = lower - value, above = value - upper;
    const Scalar violation = std::max(below, above);
    if (!(violation > 0)) return;
    const Scalar tolerance = kFeasible * (std::sqrt(squared_norm) * scale + std::abs(below > 0 ? lower : upper));
    if (violation <= tolerance || !(violation * violation > furthest * squared_norm)) return;
    furthest = violation * violation / squared_norm;
    row = i;
    sign = below > 0 ? Scalar(1) : Scalar(-1);
  };
  for (int i = 0; i < rows_->size(); ++i) {
    const auto& r = (*rows_)[i];
    if (!held_[index(i)] && r.squared_norm > 0) consider(i, r.a.dot(x_), r.lower, r.upper, r.squared_norm);
  }
  for (int j = 0; j < Size; ++j) {
    if (!held_[index(MaxRows + j)]) consider(MaxRows + j, x_[j], (*x_min_)[j], (*x_max_)[j], Scalar(1));
  }
  return furthest > 0;
}

/// Makes the hard rows soft and goes on from the active set reached.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::relax() noexcept {
  relaxed_ = true;
  for (int k = 0; k < count_; ++k) active_[index(k)].compliance = compliance(active_[index(k)]);
  refactor(0);
  restore();
}

template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::publish() noexcept {
  multiplier_.fill(0);
  slack_.fill(0);
  for (int k = 0; k < count_; ++k) {
    const Active& a = active_[index(k)];
    const Scalar positive = std::max(a.multiplier, Scalar(0));  // what rounding left below zero is zero
    multiplier_[index(a.row)] = a.sign * positive;
    slack_[index(a.row)] = a.compliance * positive;
  }
  x_ = x_.cwiseMax(*x_min_).cwiseMin(*x_max_);
}

}  // namespace rme
