#pragma once
/// The functions of ActiveSetSolver. Do not include this file, but active_set_solver.hpp.
#include <rme/control/active_set_solver.hpp>

namespace rme {

template <typename Scalar, int Size, int MaxRows>
Status ActiveSetSolver<Scalar, Size, MaxRows>::run(const Vector& x_u, const Rows& rows, const Vector& x_min,
                                                   const Vector& x_max) noexcept {
  x_u_ = &x_u;
  rows_ = &rows;
  x_min_ = &x_min;
  x_max_ = &x_max;
  origin_ = x_u.norm();
  relaxed_ = stretched_less_ = false;
  B_ = given_;
  needs_root_ = needs_root_ && count_ > 1;  // as in the last solve
  if (B_ == nullptr && needs_root_) take_root();
  iterations_ = 0;
  held_.fill(false);
  factor_.clear();
  for (int k = 0, previous = std::exchange(count_, 0); k < previous; ++k) {
    const int row = active_[index(k)].row;
    // push() never writes beyond the entry that is read here, so the new list can replace the old one in place.
    if (row >= MaxRows || row < rows.size()) push(row, active_[index(k)].sign);
  }
  restore();

  Status status = Status::Ok;
  int row = 0;
  Scalar sign = 0;
  Active entering;
  for (;;) {
    if (!most_violated(row, sign)) {
      if (!exact_ && !active_hold(kFeasible, false)) status = Status::NotConverged;
      break;
    }
    if (iterations_ >= kMaxIterations) {
      status = Status::NotConverged;
      break;
    }
    make(row, sign, entering);
    if (enter(entering)) {
      Column w;
      solve_multipliers(w);
      move(w);
    } else if (!relaxed_ && !stretched_less_) {
      stretch_less();
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

/// Appends a constraint that was split against the active ones.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::store(const Active& a, const Split& s) noexcept {
  active_[index(count_)] = a;
  factor_.set(count_, s);
  held_[index(a.row)] = true;
  ++count_;
}

/// Appends a constraint of the last active set, unless it is linearly dependent on those before it.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::push(int row, Scalar sign) noexcept {
  Active& a = active_[index(count_)];
  make(row, sign, a);
  Split s;
  split_safely(a, s);
  // A generous threshold: a constraint left out here comes back through enter() if the optimum needs it.
  if (!(s.squared > std::sqrt(kEpsilon) * a.curvature) || !std::isfinite(a.rise)) return;
  factor_.set(count_++, s);
  held_[index(row)] = true;
}

template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::drop(int k) noexcept {
  held_[index(active_[index(k)].row)] = false;
  for (int l = k + 1; l < count_; ++l) active_[index(l - 1)] = active_[index(l)];
  --count_;
  refactor(k);
}

/// Computes the columns anew, starting with number `from`.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::refactor(int from) noexcept {
  Split s;
  for (int k = from; k < count_; ++k) {
    const Active& a = active_[index(k)];
    split(a, k, s);
    // Columns stay independent when others leave; the floor only guards against rounding.
    s.squared = std::max(s.squared, kEpsilon * kEpsilon * a.curvature);
    factor_.set(k, s);
  }
}

/// Solves R^T D w = d and R lambda = w ((C9), with the diagonal D of squared lengths).
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::solve_multipliers(Column& w) noexcept {
  Column y;
  for (int k = 0; k < count_; ++k) {
    w[index(k)] = active_[index(k)].rise;
    factor_.forward(w, k);
  }
  for (int k = 0; k < count_; ++k) {
    factor_.scale(w, k);
    y[index(k)] = w[index(k)];
  }
  factor_.backward(y, count_);
  for (int k = 0; k < count_; ++k) active_[index(k)].multiplier = y[index(k)];
}

/// Drops constraints until all multipliers are non-negative: then the dual method can start.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::restore() noexcept {
  Column w;
  while (count_ > 0) {
    solve_multipliers(w);
    int worst = 0;
    for (int k = 1; k < count_; ++k) {
      if (active_[index(k)].multiplier < active_[index(worst)].multiplier) worst = k;
    }
    if (active_[index(worst)].multiplier >= 0) break;
    drop(worst);
    ++iterations_;
  }
  move(w);
}

/// x = x_u + B^T sum_k w_k q_k (docs/theory_control.md (C9)). The multipliers are not used: those of nearly parallel
/// rows are large and would have to cancel.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::move(const Column& w) noexcept {
  x_ = *x_u_;
  if (count_ > 0) shift(factor_.combine(w, count_));
  reach_ = origin_ + x_.norm();
  exact_ = active_hold(kRounding, true);
  if (!exact_) refine();
}

/// One step of iterative refinement on the active constraints. The correction is added to x, since rounding would take
/// it from w.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::refine() noexcept {
  const Vector moved = x_ - *x_u_;
  Column w, y;
  for (int k = 0; k < count_; ++k) {
    const Active& a = active_[index(k)];
    w[index(k)] = a.rise - a.normal.dot(moved) - a.compliance * a.multiplier;
    factor_.forward(w, k);
  }
  for (int k = 0; k < count_; ++k) {
    factor_.scale(w, k);
    y[index(k)] = w[index(k)];
  }
  factor_.backward(y, count_);
  for (int k = 0; k < count_; ++k) active_[index(k)].multiplier += y[index(k)];
  shift(factor_.combine(w, count_));
  reach_ = origin_ + x_.norm();
}

/// Adds a violated constraint to the active set, and drops those whose multiplier would become negative on the way.
/// @return false if it contradicts active constraints that cannot be dropped
template <typename Scalar, int Size, int MaxRows>
bool ActiveSetSolver<Scalar, Size, MaxRows>::enter(Active& a) noexcept {
  Scalar rise = a.rise - a.normal.dot(x_ - *x_u_);
  Split s;
  Column r;
  for (; iterations_ < kMaxIterations; ++iterations_) {
    split_safely(a, s);
    for (int k = 0; k < count_; ++k) r[index(k)] = s.within[index(k)];
    factor_.backward(r, count_);
    Scalar blocked = kInfinity;  // the step at which a multiplier reaches zero
    int blocking = -1;
    for (int k = 0; k < count_; ++k) {
      const Active& other = active_[index(k)];
      const Scalar rate = r[index(k)];
      if (rate > 0 && other.multiplier < blocked * rate) {
        blocked = std::max(other.multiplier, Scalar(0)) / rate;
        blocking = k;
      }
    }
    const Scalar pivot = s.squared;
    const bool dependent = s.cancelled && std::sqrt(pivot) <= 4 * kEpsilon * noise(a, r);
    const Scalar full = dependent ? kInfinity : rise / pivot;
    if (full < kInfinity && full <= blocked) {  // a pivot may be so small that the step overflows
      store(a, s);
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

/// Finds the inactive constraint with the largest violation as a distance in x.
/// @return false if none is violated
template <typename Scalar, int Size, int MaxRows>
bool ActiveSetSolver<Scalar, Size, MaxRows>::most_violated(int& row, Scalar& sign) const noexcept {
  Scalar furthest = 0;
  const auto consider = [&](int i, Scalar value, Scalar lower, Scalar upper, Scalar squared_norm) {
    const Scalar below = lower - value, above = value - upper;
    const Scalar violation = std::max(below, above);
    if (!(violation > 0)) return;
    const Scalar tolerance = kFeasible * (std::sqrt(squared_norm) * reach_ + std::abs(below > 0 ? lower : upper));
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

/// Whether the active constraints hold in x_, soft ones with their slack.
/// @param exactly  as equalities; otherwise x may also lie inside a bound, where rounding has left the multiplier at or
///                 below zero
template <typename Scalar, int Size, int MaxRows>
bool ActiveSetSolver<Scalar, Size, MaxRows>::active_hold(Scalar tolerance, bool exactly) const noexcept {
  for (int k = 0; k < count_; ++k) {
    const Active& a = active_[index(k)];
    const Scalar miss = a.bound - a.normal.dot(x_) - a.compliance * std::max(a.multiplier, Scalar(0));
    // For speed: a single row mostly holds to |b| alone, and then need not wait for the norm of x.
    if (count_ == 1 && std::abs(miss) <= tolerance * std::abs(a.bound)) return true;
    if (!((exactly ? std::abs(miss) : miss) <= tolerance * (a.norm * reach_ + std::abs(a.bound)))) return false;
  }
  return true;
}

/// Sets multipliers and slacks, and cuts x to the box.
template <typename Scalar, int Size, int MaxRows>
void ActiveSetSolver<Scalar, Size, MaxRows>::publish() noexcept {
  multiplier_.fill(0);
  slack_.fill(0);
  for (int k = 0; k < count_; ++k) {
    const Active& a = active_[index(k)];
    const Scalar positive = std::max(a.multiplier, Scalar(0));  // rounding can leave it below zero
    multiplier_[index(a.row)] = a.sign * positive;
    slack_[index(a.row)] = a.compliance * positive;
  }
  x_ = x_.cwiseMax(*x_min_).cwiseMin(*x_max_);
}

}  // namespace rme
