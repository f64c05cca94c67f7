#pragma once
/// The momentum observer for hosts that learn the number of joints at run time.
#include <rme/core/any_dofs.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <variant>

namespace rme {

/// A MomentumObserver (sensing/momentum_observer.hpp) for vectors and matrices of dynamic size, with the same results
/// to the last bit. Real time: no call but the constructors allocates or throws. If an argument is an expression that
/// must be evaluated first, Eigen allocates.
template <typename Scalar, int Fewest = 1, int Most = 8>
class RuntimeMomentumObserver {
 public:
  using Vector = JointVector<Scalar, Eigen::Dynamic>;  ///< one number per joint

  /// @param joints  of the arm, Fewest to Most
  /// @param dt      control period [s], > 0
  /// @param gain    K of each joint [rad/s], 0 < K dt <= 1; joints numbers
  /// @throws std::invalid_argument naming the argument out of range
  RuntimeMomentumObserver(int joints, Scalar dt, const Vector& gain)
      : joints_(joints),
        any_(detail::make_any_dofs<MomentumObserver, Scalar, Fewest, Most>(
            "RuntimeMomentumObserver", joints, dt, [&](auto dofs) {
              return MomentumObserverConfig<Scalar, dofs>{
                  detail::per_joint<dofs>(gain, "MomentumObserverConfig::gain")};
            })) {}
  /// The same, with the default gain.
  /// @param joints  of the arm, Fewest to Most
  /// @param dt      control period [s], > 0
  RuntimeMomentumObserver(int joints, Scalar dt)
      : joints_(joints),
        any_(detail::make_any_dofs<MomentumObserver, Scalar, Fewest, Most>(
            "RuntimeMomentumObserver", joints, dt, [](auto dofs) { return MomentumObserverConfig<Scalar, dofs>(); })) {}

  /// The number of joints, as constructed.
  int joints() const noexcept { return joints_; }
  /// MomentumObserver::update(), where the arguments are described.
  /// @param tau                 [N m], joints() numbers
  /// @param dq                  [rad/s], joints() numbers
  /// @param mass_matrix         M(q) [kg m^2], joints() x joints()
  /// @param coriolis_transpose  C(q, dq)^T dq [N m], joints() numbers
  /// @param gravity             g(q) [N m], joints() numbers
  /// @param period              measured [s]; 0 means the nominal period
  /// @return Ok; WrongSize or NonFiniteInput: the observer is then as it was
  template <typename Torque, typename Velocity, typename Matrix, typename Coriolis, typename Gravity>
  Status update(const Eigen::MatrixBase<Torque>& tau, const Eigen::MatrixBase<Velocity>& dq,
                const Eigen::MatrixBase<Matrix>& mass_matrix, const Eigen::MatrixBase<Coriolis>& coriolis_transpose,
                const Eigen::MatrixBase<Gravity>& gravity, double period = 0) noexcept {
    if (!detail::has_size(tau, joints_, 1) || !detail::has_size(dq, joints_, 1) ||
        !detail::has_size(mass_matrix, joints_, joints_) || !detail::has_size(coriolis_transpose, joints_, 1) ||
        !detail::has_size(gravity, joints_, 1))
      return Status::WrongSize;
    return std::visit(
        [&](auto& observer) {
          using Fixed = std::decay_t<decltype(observer.tau_ext())>;
          const Fixed torque = tau, velocity = dq, coriolis = coriolis_transpose, weight = gravity;
          const JointMatrix<Scalar, static_cast<int>(Fixed::RowsAtCompileTime)> mass = mass_matrix;
          return observer.update(torque, velocity, mass, coriolis, weight, period);
        },
        any_);
  }
  /// r, the filtered external torque [N m], joints() numbers; a view of this object's.
  Eigen::Map<const Vector> tau_ext() const noexcept {
    return {std::visit([](const auto& observer) { return observer.tau_ext().data(); }, any_), joints_};
  }
  /// MomentumObserver::reset().
  void reset() noexcept {
    std::visit([](auto& observer) { observer.reset(); }, any_);
  }

 private:
  int joints_;
  detail::AnyDofs<MomentumObserver, Scalar, Fewest, Most> any_;
};

}  // namespace rme
