#pragma once
/// The small strictly convex quadratic program of each tick, solved exactly by a dual active-set method.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <rme/control/constraint_rows.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <utility>

namespace rme {

/// Solves
///
///     min  1/2 (x - x_u)^T Q (x - x_u) + sum_soft w_i s_i^2     s.t.  l_i <= a_i x <= u_i (+- s_i),   x_min <= x <=
///     x_max
///
/// from the inverse P = Q^-1 alone (docs/theory_control.md, the dual method). With signed active normals n_k the
/// optimum is x = x_u + P sum_k lambda_k n_k, where S lambda = d, S_kl = n_k^T P n_l + delta_kl c_k and c_k = 1 / (2
/// w_k), 0 if hard: one row gives the paper's closed form (26), (27), several the method of [Goldfarb & Idnani 1983]
/// with the Cholesky factor of S, and no feasible row costs more than its check. The next solve starts from this one's
/// active set.
///
/// The box x_min..x_max always holds. When hard rows contradict each other or the box, all of them become soft, with
/// the compliance sqrt(machine epsilon) a_i P a_i^T: the least sum of squared violations, each measured by the cost of
/// removing it, up to that factor, among all x in the box.
///
/// Real time: no allocation, at most kMaxIterations changes of the active set.
/// @tparam Size     dimension of x
/// @tparam MaxRows  most rows beside the box
template <typename Scalar, int Size, int MaxRows>
class ActiveSetSolver {
 public:
  using Vector = Eigen::Matrix<Scalar, Size, 1>;
  using Matrix = Eigen::Matrix<Scalar, Size, Size>;
  using Rows = ConstraintRows<Scalar, Size, MaxRows>;
  static constexpr int kMaxIterations = 4 * (MaxRows + Size);

  /// All arguments are finite but the bounds, which may be infinite; P is symmetric positive definite; x_min <= x_max.
  /// @return Ok; Infeasible: the hard rows do not hold together, solution() violates them least; NotConverged:
  ///         kMaxIterations was reached, solution() is only known to lie in the box
  Status solve(const Matrix& P, const Vector& x_u, const Rows& rows, const Vector& x_min, const Vector& x_max) noexcept;
  /// Forgets the active set, so that the next solve starts cold, and the solution.
  void reset() noexcept {
    count_ = iterations_ = 0;
    multiplier_.fill(0);
    slack_.fill(0);
    x_.setZero();
  }

  const Vector& solution() const noexcept { return x_; }
  /// Multiplier of a row, >= 0 if it pushes at its lower bound, <= 0 at its upper, 0 if inactive.
  Scalar multiplier(int row) const noexcept { return multiplier_[index(row)]; }
  /// Multiplier of the box in coordinate j, signed likewise.
  Scalar box_multiplier(int j) const noexcept { return multiplier_[index(MaxRows + j)]; }
  /// By how much a soft row, or in an infeasible set a hard one, is missed; >= 0, in units of a x.
  Scalar slack(int row) const noexcept { return slack_[index(row)]; }
  int active_count() const noexcept { return count_; }     ///< rows and box sides held at the solution
  int iterations() const noexcept { return iterations_; }  ///< changes of the active set that the last solve made

 private:
  // Each row is active at most once; so is each coordinate of the box.
  static constexpr int kMaxActive = MaxRows + Size;
  static constexpr Scalar kEpsilon = std::numeric_limits<Scalar>::epsilon();
  static constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  static constexpr Scalar kFeasible = 512 * kEpsilon;  // a violation below this, relative to a x, is rounding
  static constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

  // A constraint n x >= b held as an equality (less its slack): a row, or for row >= MaxRows a side of the box.
  struct Active {
    int row;
    Scalar sign;        // +1 at the lower bound, -1 at the upper: n = sign a
    Vector normal;      // n
    Vector image;       // P n
    Scalar curvature;   // n P n
    Scalar rise;        // d = b - n x_u, what x has to gain along n
    Scalar compliance;  // c
    Scalar multiplier;  // lambda
  };
  using Column = std::array<Scalar, index(kMaxActive)>;

  Active make(int row, Scalar sign) const noexcept;
  Scalar compliance(const Active& a) const noexcept;
  Scalar project(const Active& a, int count, Column& y) const noexcept;
  void back_substitute(Column& y) const noexcept;
  bool push(const Active& a) noexcept;
  void store(const Active& a, const Column& y, Scalar pivot) noexcept;
  void drop(int k) noexcept;
  void refactor(int from) noexcept;
  void solve_multipliers() noexcept;
  void restore() noexcept;
  void refine() noexcept;
  void move() noexcept;
  bool enter(Active a) noexcept;
  bool most_violated(int& row, Scalar& sign) const noexcept;
  void relax() noexcept;
  void publish() noexcept;

  // The problem being solved; valid inside solve() only.
  const Matrix* P_ = nullptr;
  const Vector* x_u_ = nullptr;
  const Rows* rows_ = nullptr;
  const Vector* x_min_ = nullptr;
  const Vector* x_max_ = nullptr;

  std::array<Active, index(kMaxActive)> active_;
  std::array<Column, index(kMaxActive)> factor_;  // L with S = L L^T, by rows, below the diagonal
  Column inverse_pivot_;                          // 1 / L_kk
  std::array<bool, index(kMaxActive)> held_;      // by row: is it in active_?
  Column multiplier_{}, slack_{};                 // by row
  Vector x_ = Vector::Zero();
  int count_ = 0;
  int iterations_ = 0;
  bool relaxed_ = false;
};

}  // namespace rme

#include <rme/control/detail/active_set_solver_impl.hpp>
