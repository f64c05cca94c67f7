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

/// Settings of Cpic; the torque limits are the arm's and have to be set. With sigma_0 = null_space.clearance, the
/// weights in the root of the cost span a range of max(1, l, eps^-1/2) / min(eps^-1/2, sigma_0 min(1, l)). The
/// constructor refuses a range above 2e-3 / machine epsilon (9e12 in double, 1.7e4 in float): rows that can be kept
/// could then be called infeasible. In float, l = 1 allows eps down to 9e-6, and eps = 1e-3 allows l down to 0.1.
template <typename Scalar, int Dofs>
struct CpicConfig {
  JointVector<Scalar, Dofs> torque_limit = JointVector<Scalar, Dofs>::Zero();  ///< |tau| <= this [N m], > 0
  /// eps > 0 [1/m^2]: a null-space torque that is 1 N m off tau_0 costs eps times as much as a task force error of 1 N.
  /// If eps is small, the constraints use up the null space before they disturb the task.
  Scalar null_space_weight = Scalar(1e-3);
  /// l > 0 [m]: a moment error of 1 N m counts as a force error of 1 / l newton. 1 is the paper's cost. With l about
  /// the size of the hand, CPIC does not keep a constraint on the hand's position by swinging the hand about the wrist.
  Scalar moment_arm = Scalar(1);
  NullSpaceConfig<Scalar> null_space = NullSpaceConfig<Scalar>();  ///< near singular poses
};

/// What CPIC needs to know each tick; J, M and the bias have no default. World axes.
template <typename Scalar, int Dofs>
struct CpicInput {
  Jacobian<Scalar, Dofs> jacobian;        ///< J, 6xDofs
  JointMatrix<Scalar, Dofs> mass_matrix;  ///< M [kg m^2], symmetric positive definite
  /// h_bias [N m] in the prediction M ddq = tau - h_bias of the constraints: C dq + g minus all torques that act beside
  /// tau (the arm's own gravity compensation, a known external torque). In the published controller it is nominal,
  /// without the payload.
  JointVector<Scalar, Dofs> bias;
  Wrench<Scalar> wrench;  ///< F_c, the desired task force [N, N m]
  /// tau_0 [N m] of (C5). Only N tau_0, the part without a wrench, is used.
  JointVector<Scalar, Dofs> null_torque = JointVector<Scalar, Dofs>::Zero();
  /// Torque that the host adds to the command afterwards (payload compensation) [N m]. It counts towards the limits:
  /// |tau + other_torque| <= torque_limit.
  JointVector<Scalar, Dofs> other_torque = JointVector<Scalar, Dofs>::Zero();
};

/// The controller: the torque nearest to a task force that keeps all rows and the torque limits. Each tick it solves
///
///     min  |W (J^+T tau - F_c)|^2 + eps |N (tau - tau_0)|^2,   W = diag(1, 1, 1, 1/l, 1/l, 1/l)
///     s.t. lower_i <= grad_i^T ddq <= upper_i,   M ddq = tau - h_bias,   |tau + other_torque| <= torque_limit
///
/// [RME, Eq. 21 to 27, for redundant arms; docs/theory_control.md (C1 to C6)]. The unconstrained answer is
/// J^T F_c + N tau_0. The inverse of the cost's Hessian is (J^T W^-2 J + N / eps) / 2; its root is known without
/// factorising it. Rows come from barriers.hpp or the host. They should come in the same order each tick, so that the
/// last active set is a good start.
///
/// Near singular poses N is damped (null_space.hpp): torques that make almost no wrench there cost little when a
/// constraint needs them, and N tau_0 may disturb the hand, |J N| <= lambda / 2. J^T F_c is never damped.
///
/// Real time: no allocation, a bounded number of iterations.
/// @tparam Dofs     number of joints, >= 6
/// @tparam MaxRows  most rows in a tick
template <typename Scalar, int Dofs, int MaxRows = 28>
class Cpic {
 public:
  using Rows = ConstraintRows<Scalar, Dofs, MaxRows>;  ///< on ddq
  using Vector = JointVector<Scalar, Dofs>;            ///< joint torque [N m] or acceleration [rad/s^2]

  /// @throws std::invalid_argument naming the field out of range, or the fields that are out of range together
  explicit Cpic(const CpicConfig<Scalar, Dofs>& config);

  /// @param input  dynamics, task force and posture of this tick
  /// @param rows   bounds on grad^T ddq; for a barrier h in the unit u, gradients in u/rad and bounds in u/s^2
  /// @return Ok: every row and limit holds to ActiveSetSolver::kTolerance, relative to the terms of the row written for
  ///         tau; Infeasible: the hard rows cannot all be kept within the torque limits, torque() violates them least;
  ///         NotConverged: torque() is only known to keep the torque limits. After NonFiniteInput (also for numbers
  ///         beyond kLargestPlausible), or NotPositiveDefinite for M, torque() is the last one and nothing has changed,
  ///         with one exception: if the solution overflowed, multipliers, slacks and active set are cleared.
  Status update(const CpicInput<Scalar, Dofs>& input, const Rows& rows) noexcept;
  /// Forgets the active set; all torques and accelerations become zero.
  void reset() noexcept;

  const Vector& torque() const noexcept { return torque_; }  ///< tau* [N m]
  /// M^-1 (tau* - h_bias) [rad/s^2]: the predicted acceleration, which keeps the rows.
  const Vector& acceleration() const noexcept { return acceleration_; }
  const Vector& unconstrained_torque() const noexcept { return unconstrained_; }  ///< J^T F_c + N tau_0 [N m]
  /// lambda_i [cost per unit of the row]: >= 0 if row i is active at its lower bound, <= 0 at its upper, 0 if inactive.
  Scalar multiplier(int row) const noexcept { return solver_.multiplier(row); }
  /// The same for the torque limits of a joint.
  Scalar torque_multiplier(int joint) const noexcept { return solver_.box_multiplier(joint); }
  /// By how much a soft row, or after Infeasible a hard one, is violated [unit of the row], >= 0.
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
/// divided by sqrt(2), where N = Z Z^T. Where N is damped, these are Dofs + 6 rows, and a QR factorisation reduces them
/// to Dofs.
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
    // The row was valid, so only an overflow can make it invalid.
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
