#pragma once
/// The small, strictly convex quadratic program of each tick, solved exactly by a dual active-set method.
#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <rme/control/constraint_rows.hpp>
#include <rme/control/detail/active_factor.hpp>
#include <rme/control/detail/metric_root.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/core/unroll.hpp>
#include <utility>

namespace rme {

/// A solver of small quadratic programs with two-sided rows, hard or soft, and a box:
///
///     min   1/2 (x - x_u)^T Q (x - x_u) + sum_soft w_i s_i^2
///     s.t.  l_i <= a_i x <= u_i (+- s_i),   x_min <= x <= x_max
///
/// from the inverse P = Q^-1 = B^T B alone, by the dual method of [Goldfarb & Idnani 1983]
/// (docs/theory_control.md (C8, C9)). With the normals n_k of the active rows, signed so that lambda_k >= 0,
///
///     x = x_u + P sum_k lambda_k n_k,   S lambda = d,   S_kl = n_k^T P n_l + delta_kl c_k
///
/// where the compliance c_k is 1 / (2 w_k) for a soft row and 0 for a hard one. For one row this is the paper's closed
/// form (26), (27). Given P, S is factorised by Cholesky's method while it is well-conditioned. Otherwise, and given B,
/// the columns B n_k are orthogonalised; the error then grows only with the square root of S's condition number. Each
/// solve starts from the active set of the last one.
///
/// Ok says that x is in the box and that every row holds: none is missed by more than
///
///     kTolerance (|a| (|x| + |x_u|) + |bound|)
///
/// and a soft row by no more than this beyond its slack. If rows seem to contradict each other only because an
/// ill-conditioned P is rounded, x is the optimum for P + epsilon tr(P) I.
///
/// x is always in the box x_min..x_max. If hard rows contradict each other or the box, all hard rows become soft with
/// the compliance sqrt(epsilon) a_i P a_i^T, with the machine epsilon. With the violations v_i, x then has the least
/// sum of v_i^2 / (a_i P a_i^T) in the box, to within sqrt(epsilon) (x - x_u)^T Q (x - x_u).
///
/// The host chooses the units: x in u, a x in v, P in u^2 per unit of cost. A multiplier is in cost per v, a weight in
/// cost per v^2.
///
/// Real time: no allocation, at most kMaxIterations changes of the active set.
/// @tparam Size     dimension of x
/// @tparam MaxRows  most rows beside the box
template <typename Scalar, int Size, int MaxRows>
class ActiveSetSolver {
 public:
  /// Size x 1: x, x_u, the box.
  using Vector = Eigen::Matrix<Scalar, Size, 1>;
  /// Size x Size: P.
  using Matrix = Eigen::Matrix<Scalar, Size, Size>;
  /// The rows a x, beside the box.
  using Rows = ConstraintRows<Scalar, Size, MaxRows>;
  /// A root B of P. Its number of rows is Size, rounded up to a multiple of four; the surplus rows are zero.
  using Root = Eigen::Matrix<Scalar, (Size + 3) / 4 * 4, Size>;
  static constexpr int kMaxIterations = 4 * (MaxRows + Size);  ///< changes of the active set in a solve()

  /// By how much Ok allows a row to be missed, relative to |a| (|x| + |x_u|) + |bound|: 2e-13 in double, 1e-4 in float.
  static constexpr Scalar kTolerance = 1024 * std::numeric_limits<Scalar>::epsilon();

  /// All arguments have to be finite; only bounds may be infinite. The solver does not check this.
  /// @param P             Q^-1, Size x Size, symmetric positive definite
  /// @param x_u           the optimum without rows and box, Size x 1
  /// @param rows          l_i <= a_i x <= u_i, best in the order of the last solve: its active set is then a good start
  /// @param x_min, x_max  the box, Size x 1, x_min <= x_max
  /// @return Ok; Infeasible: the hard rows cannot all hold in the box, solution() violates them least; NotConverged:
  ///         kMaxIterations was reached or a row is missed by too much, solution() is only known to lie in the box
  Status solve(const Matrix& P, const Vector& x_u, const Rows& rows, const Vector& x_min,
               const Vector& x_max) noexcept {
    P_ = &P;
    given_ = nullptr;
    return run(x_u, rows, x_min, x_max);
  }
  /// The same from a root B of P = B^T B, of full column rank. B keeps small eigenvalues of P that rounding would take
  /// from the entries of P.
  Status solve_from_root(const Root& B, const Vector& x_u, const Rows& rows, const Vector& x_min,
                         const Vector& x_max) noexcept {
    given_ = &B;
    return run(x_u, rows, x_min, x_max);
  }
  /// Forgets the solution and the active set: the next solve starts without one.
  void reset() noexcept {
    count_ = iterations_ = 0;
    multiplier_.fill(0);
    slack_.fill(0);
    x_.setZero();
  }

  const Vector& solution() const noexcept { return x_; }  ///< x of the last solve(); zero after reset()
  /// Multiplier of a row: >= 0 if it is active at its lower bound, <= 0 at its upper, 0 if inactive.
  Scalar multiplier(int row) const noexcept { return multiplier_[index(row)]; }
  /// Multiplier of the box in coordinate j, with the same signs.
  Scalar box_multiplier(int j) const noexcept { return multiplier_[index(MaxRows + j)]; }
  /// By how much a soft row, or after Infeasible a hard one, is violated; >= 0, in units of a x.
  Scalar slack(int row) const noexcept { return slack_[index(row)]; }
  int active_count() const noexcept { return count_; }     ///< rows and sides of the box that are active
  int iterations() const noexcept { return iterations_; }  ///< changes of the active set in the last solve

 private:
  // Each row is active at most once; so is each coordinate of the box.
  static constexpr int kMaxActive = MaxRows + Size;
  static constexpr Scalar kEpsilon = std::numeric_limits<Scalar>::epsilon();
  static constexpr Scalar kInfinity = std::numeric_limits<Scalar>::infinity();
  // A violation below this, relative as kTolerance is, counts as rounding. Half of kTolerance: cutting x to the box at
  // the end may add the other half.
  static constexpr Scalar kFeasible = kTolerance / 2;
  static constexpr Scalar kRounding = 8 * kEpsilon;  // an active row that is further off makes refine() necessary
  static constexpr std::size_t index(int i) noexcept { return static_cast<std::size_t>(i); }

  using Factor = detail::ActiveFactor<Scalar, Size, kMaxActive>;
  using Column = typename Factor::Column;
  using Image = typename Factor::Image;
  using Split = typename Factor::Split;

  // A constraint n x >= b held as an equality (less its slack): a row, or for row >= MaxRows a side of the box.
  struct Active {
    int row;
    Scalar sign;        // +1 at the lower bound, -1 at the upper: n = sign a
    Vector normal;      // n
    Scalar norm;        // |n|
    Image image;        // g = B n, or P n while there is no B
    Scalar curvature;   // n P n
    Scalar bound;       // b
    Scalar rise;        // d = b - n x_u
    Scalar compliance;  // c
    Scalar multiplier;  // lambda
  };

  Status run(const Vector& x_u, const Rows& rows, const Vector& x_min, const Vector& x_max) noexcept;
  void make(int row, Scalar sign, Active& a) noexcept;
  Scalar compliance(const Active& a) const noexcept;
  void look(Active& a) noexcept;
  void take_root() noexcept;
  void shift(const Image& z) noexcept;
  void push(int row, Scalar sign) noexcept;
  void split(const Active& a, int count, Split& s) const noexcept;
  void split_safely(Active& a, Split& s) noexcept;
  void store(const Active& a, const Split& s) noexcept;
  void drop(int k) noexcept;
  void refactor(int from) noexcept;
  void solve_multipliers(Column& w) noexcept;
  void restore() noexcept;
  void move(const Column& w) noexcept;
  void refine() noexcept;
  bool enter(Active& a) noexcept;
  Scalar noise(const Active& a, const Column& r) const noexcept;
  bool most_violated(int& row, Scalar& sign) const noexcept;
  bool active_hold(Scalar tolerance, bool exactly) const noexcept;
  void stretch_less() noexcept;
  void relax() noexcept;
  void remake() noexcept;
  void publish() noexcept;

  // The problem being solved; valid inside solve() only.
  const Matrix* P_ = nullptr;
  const Root* given_ = nullptr;  // the host's B; null if it gave P
  const Root* B_ = nullptr;      // null as long as P is accurate enough
  const Vector* x_u_ = nullptr;
  const Rows* rows_ = nullptr;
  const Vector* x_min_ = nullptr;
  const Vector* x_max_ = nullptr;

  Root root_;  // of P, if the host gave none; or of P + epsilon tr(P) I
  std::array<Active, index(kMaxActive)> active_;
  Factor factor_;
  std::array<bool, index(kMaxActive)> held_;  // by row: whether it is in active_
  Column multiplier_{}, slack_{};             // by row
  Vector x_ = Vector::Zero();
  Scalar origin_ = 0, reach_ = 0;  // |x_u|, |x_u| + |x|
  int count_ = 0;
  int iterations_ = 0;
  bool needs_root_ = false;      // whether P was too inaccurate in this solve or, at its start, in the last one
  bool relaxed_ = false;         // whether hard rows have become soft
  bool stretched_less_ = false;  // whether the metric is, or has been, that of P + epsilon tr(P) I
  bool exact_ = true;            // whether the active rows held to kRounding when x_ was computed
};

}  // namespace rme

#include <rme/control/detail/active_set_metric_impl.hpp>
#include <rme/control/detail/active_set_solver_impl.hpp>
