#pragma once
/// The constrained passive interaction controller: the torque nearest to a passive task force that keeps the
/// constraints.
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/control/active_set_solver.hpp>
#include <rme/control/constraint_rows.hpp>
#include <rme/control/null_space.hpp>
#include <rme/core/cholesky.hpp>
#include <rme/core/householder.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/core/wrench.hpp>

namespace rme {

/// Settings of Cpic; the torque limits are the arm's and have no default. Together they set the range of the cost's
/// weights, max(1, l, eps^-1/2) / min(eps^-1/2, sigma_0 min(1, l)), with sigma_0 = null_space.clearance. Above 2e-3 of
/// the inverse machine epsilon, 9e12 in double and 1.7e4 in float, rows that can be kept would be called infeasible,
/// and the constructor refuses. In float, l = 1 allows eps down to 9e-6, and eps = 1e-3 an l down to 0.1.
template <typename Scalar, int Dofs>
struct CpicConfig {
  JointVector<Scalar, Dofs> torque_limit = JointVector<Scalar, Dofs>::Zero();  ///< |tau| <= this [N m], > 0
  /// eps > 0 [1/m^2]: what a null-space torque of 1 N m costs against a task force error of 1 N, squared. Small: the
  /// constraints use up the null space before they disturb the task.
  Scalar null_space_weight = Scalar(1e-3);
  /// l > 0 [m]: a moment error of 1 N m counts as a force error of 1 / l newton. 1 is the paper's cost. About the size
  /// of the hand keeps a constraint on its position from being met by swinging it round the wrist.
  Scalar moment_arm = Scalar(1);
  NullSpaceConfig<Scalar> null_space = NullSpaceConfig<Scalar>();  ///< near singular poses
};

/// What CPIC needs to know each tick. Units [kg m^2], [N m]; world axes.
template <typename Scalar, int Dofs>
struct CpicInput {
  Jacobian<Scalar, Dofs> jacobian;        ///< J, 6xDofs
  JointMatrix<Scalar, Dofs> mass_matrix;  ///< M, symmetric positive definite
  /// h in the prediction M ddq = tau - h on which the constraints rest: C dq + g less all torques that act beside tau
  /// (the arm's own gravity compensation, an external torque that is known). Nominal: the payload is not in it.
  JointVector<Scalar, Dofs> bias;
  Wrench<Scalar> wrench;  ///< F_c, the task force asked for
  /// tau_0, of which only the part without a wrench, N tau_0, is used.
  JointVector<Scalar, Dofs> null_torque = JointVector<Scalar, Dofs>::Zero();
  /// Torque that the host adds to the command afterwards (payload compensation). It takes its share of the limits:
  /// |tau + other_torque| <= torque_limit.
  JointVector<Scalar, Dofs> other_torque = JointVector<Scalar, Dofs>::Zero();
};

/// Each tick solves
///
///     min  |W (J^+T tau - F_c)|^2 + eps |N (tau - tau_0)|^2,   W = diag(1, 1, 1, 1/l, 1/l, 1/l)
///     s.t. lower_i <= grad_i^T ddq <= upper_i,   M ddq = tau - h,   |tau + other_torque| <= torque_limit
///
/// [RME, Eq. 21 to 27, for redundant arms; docs/theory_control.md (C1 to C6)]. The unconstrained answer is J^T F_c + N
/// tau_0; the inverse of the cost's Hessian is (J^T W^-2 J + N / eps) / 2, of which a root is known without factorising
/// it. Rows come from barriers.hpp or the host, in the same order each tick, so that the last active set is a good
/// first guess.
///
/// Near singular poses N is damped (null_space.hpp): torques whose wrench J is about to lose become cheap to use for the
/// constraints, and N tau_0 may disturb the hand, |J N| <= lambda / 2. J^T F_c is never damped.
///
/// Real time: no allocation, a bounded number of iterations.
/// @tparam MaxRows  most rows in a tick
template <typename Scalar, int Dofs, int MaxRows = 28>
class Cpic {
 public:
  using Rows = ConstraintRows<Scalar, Dofs, MaxRows>;  ///< on ddq
  using Vector = JointVector<Scalar, Dofs>;            ///< joint torque [N m] or acceleration [rad/s^2]

  /// @throws std::invalid_argument naming the field out of range, or those that are so together
  explicit Cpic(const CpicConfig<Scalar, Dofs>& config);

  /// @param input  dynamics, task force and posture of this tick
  /// @param rows   bounds on grad^T ddq; gradient and bounds in any unit that the barrier's h has
  /// @return Ok: every row and limit holds to ActiveSetSolver::kTolerance, relative to the terms of the row written for
  ///         tau; Infeasible: the hard rows cannot all be kept within the torque limits, torque() violates them least;
  ///         NotConverged: torque() is only known to respect the limits. After NonFiniteInput (also for numbers beyond
  ///         kLargestPlausible), or NotPositiveDefinite for M, nothing has changed and torque() is the last one; where
  ///         it was the rows that overflowed, the next update starts without an active set.
  Status update(const CpicInput<Scalar, Dofs>& input, const Rows& rows) noexcept;
  /// Forgets torque and active set.
  void reset() noexcept;

  const Vector& torque() const noexcept { return torque_; }  ///< tau* [N m]
  /// M^-1 (tau* - h) [rad/s^2]: the acceleration on which the rows were held.
  const Vector& acceleration() const noexcept { return acceleration_; }
  const Vector& unconstrained_torque() const noexcept { return unconstrained_; }  ///< J^T F_c + N tau_0 [N m]
  /// lambda_i: >= 0 if row i pushes at its lower bound, <= 0 at its upper, 0 if inactive.
  Scalar multiplier(int row) const noexcept { return solver_.multiplier(row); }
  /// The same for the torque limits of a joint.
  Scalar torque_multiplier(int joint) const noexcept { return solver_.box_multiplier(joint); }
  /// By how much the bound of a soft row, or of a hard one in an infeasible set, is missed.
  Scalar slack(int row) const noexcept { return solver_.slack(row); }
  /// Rows and torque limits that were active in the last update().
  int active_count() const noexcept { return solver_.active_count(); }
  /// Changes of the active set in the last update().
  int iterations() const noexcept { return solver_.iterations(); }
  /// N of the last update()'s pose.
  const NullSpace<Scalar, Dofs>& null_space() const noexcept { return null_space_; }

 private:
  static constexpr double kLargestCondition = 2e-3;  // of the cost's root, times the machine epsilon
  using Solver = ActiveSetSolver<Scalar, Dofs, MaxRows>;

  typename Solver::Root cost_root(const Jacobian<Scalar, Dofs>& jacobian,
                                  const NullSpace<Scalar, Dofs>& null_space) const noexcept;

  CpicConfig<Scalar, Dofs> config_;
  NullSpace<Scalar, Dofs> null_space_;
  Scalar wrench_scale_, null_scale_;  // 1 / sqrt(2), 1 / sqrt(2 eps)
  Solver solver_;
  Rows torque_rows_;  // the rows of ddq, written for tau
  Vector torque_ = Vector::Zero();
  Vector unconstrained_ = Vector::Zero();
  Vector acceleration_ = Vector::Zero();
};

template <typename Scalar, int Dofs, int MaxRows>
Cpic<Scalar, Dofs, MaxRows>::Cpic(const CpicConfig<Scalar, Dofs>& config)
    : config_(config),
      null_space_(config.null_space),
      wrench_scale_(Scalar(1) / std::sqrt(Scalar(2))),
      null_scale_(Scalar(1) / std::sqrt(2 * config.null_space_weight)) {
  for (int joint = 0; joint < Dofs; ++joint) {
    detail::require(config.torque_limit[joint] > 0, "CpicConfig::torque_limit", "> 0 N m", config.torque_limit[joint]);
  }
  detail::require_positive(config.null_space_weight, "CpicConfig::null_space_weight", "> 0");
  detail::require_positive(config.moment_arm, "CpicConfig::moment_arm", "> 0 m");
  const Scalar null_space = Scalar(1) / std::sqrt(config.null_space_weight), l = config.moment_arm;
  const Scalar condition = std::max(null_space, std::max(l, Scalar(1))) /
                           std::min(null_space, config.null_space.clearance * std::min(l, Scalar(1)));
  detail::require(condition * std::numeric_limits<Scalar>::epsilon() <= Scalar(kLargestCondition),
                  "CpicConfig::null_space_weight, moment_arm and null_space.clearance (eps, l, sigma_0)",
                  "max(1, l, eps^-1/2) / min(eps^-1/2, sigma_0 min(1, l)) <= 2e-3 / machine epsilon "
                  "(9e12 in double, 1.7e4 in float)",
                  condition);
}

template <typename Scalar, int Dofs, int MaxRows>
void Cpic<Scalar, Dofs, MaxRows>::reset() noexcept {
  solver_.reset();
  torque_.setZero();
  unconstrained_.setZero();
  acceleration_.setZero();
}

/// B with B^T B = (J^T W^-2 J + N / eps) / 2 (docs/theory_control.md (C6)): the rows of W^-1 J and of Z^T / sqrt(eps),
/// N = Z Z^T, over sqrt(2). Near singular poses these are six more than joints, and a QR factorisation leaves as many.
template <typename Scalar, int Dofs, int MaxRows>
auto Cpic<Scalar, Dofs, MaxRows>::cost_root(const Jacobian<Scalar, Dofs>& jacobian,
                                            const NullSpace<Scalar, Dofs>& null_space) const noexcept ->
    typename Solver::Root {
  typename Solver::Root root = Solver::Root::Zero();
  const JointMatrix<Scalar, Dofs>& Z = null_space.root();
  const Scalar moment_scale = wrench_scale_ * config_.moment_arm;
  const auto wrench_entry = [&](int i, int j) { return (i < 3 ? wrench_scale_ : moment_scale) * jacobian(i, j); };
  if (null_space.damping() > 0) {
    Eigen::Matrix<Scalar, 6 + Dofs, Dofs> tall;
    for (int j = 0; j < Dofs; ++j) {
      for (int i = 0; i < 6; ++i) tall(i, j) = wrench_entry(i, j);
      for (int i = 0; i < Dofs; ++i) tall(6 + i, j) = null_scale_ * Z(j, i);
    }
    Vector diagonal;
    detail::householder(tall, diagonal);
    for (int j = 0; j < Dofs; ++j) {
      for (int i = 0; i < j; ++i) root(i, j) = tall(i, j);
      root(j, j) = diagonal[j];
    }
    return root;
  }
  for (int j = 0; j < Dofs; ++j) {
    for (int i = 0; i < 6; ++i) root(i, j) = wrench_entry(i, j);
    for (int i = 6; i < Dofs; ++i) root(i, j) = null_scale_ * Z(j, i);
  }
  return root;
}

template <typename Scalar, int Dofs, int MaxRows>
Status Cpic<Scalar, Dofs, MaxRows>::update(const CpicInput<Scalar, Dofs>& input, const Rows& rows) noexcept {
  const Vector6<Scalar> wrench = input.wrench.vector();
  if (!plausible(input.jacobian) || !plausible(input.mass_matrix) || !plausible(input.bias) || !plausible(wrench) ||
      !plausible(input.null_torque) || !plausible(input.other_torque)) {
    return Status::NonFiniteInput;
  }
  const Cholesky<Scalar, Dofs> cholesky(input.mass_matrix);
  if (!cholesky.positive_definite()) return Status::NotPositiveDefinite;
  const JointMatrix<Scalar, Dofs> inverse_mass = cholesky.inverse();
  if (!plausible(inverse_mass)) return Status::NotPositiveDefinite;  // positive by rounding alone

  torque_rows_.clear();
  for (int i = 0; i < rows.size(); ++i) {
    const auto& row = rows[i];
    const Vector a =
        row.axis < 0 ? detail::product(inverse_mass, row.a) : Vector(detail::column(inverse_mass, row.axis));
    const Scalar shift = detail::dot(a, input.bias);
    // The row was good, so that only an overflow can spoil it.
    if (torque_rows_.add(a, row.lower + shift, row.upper + shift, row.weight) != Status::Ok)
      return Status::NonFiniteInput;
  }

  NullSpace<Scalar, Dofs> null_space = null_space_;
  if (null_space.update(input.jacobian) != Status::Ok) return Status::NonFiniteInput;
  const JointMatrix<Scalar, Dofs>& N = null_space.projector();
  Vector unconstrained = detail::transposed_product(input.jacobian, wrench);
  unconstrained += detail::product(N, input.null_torque);
  const typename Solver::Root root = cost_root(input.jacobian, null_space);
  if (!detail::finite(root)) return Status::NonFiniteInput;
  const Vector largest = detail::difference(config_.torque_limit, input.other_torque);
  Vector least = detail::scaled(Scalar(-1), config_.torque_limit);
  least -= input.other_torque;
  const Status status = solver_.solve_from_root(root, unconstrained, torque_rows_, least, largest);
  if (!detail::finite(solver_.solution())) {
    solver_.reset();
    return Status::NonFiniteInput;
  }
  null_space_ = null_space;
  unconstrained_ = unconstrained;
  torque_ = solver_.solution();
  acceleration_ = detail::product(inverse_mass, detail::difference(torque_, input.bias));
  return status;
}

}  // namespace rme
