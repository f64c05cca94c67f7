#pragma once
/// The estimator for hosts that learn the number of joints at run time.
#include <cstddef>
#include <optional>
#include <rme/core/flange_motion.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/estimator.hpp>
#include <rme/estimator_config.hpp>
#include <rme/estimator_state.hpp>
#include <string>
#include <type_traits>
#include <utility>
#include <variant>

namespace rme {

namespace detail {

template <typename Scalar, int Fewest, typename Counts>
struct EstimatorOfAny;
template <typename Scalar, int Fewest, std::size_t... More>
struct EstimatorOfAny<Scalar, Fewest, std::index_sequence<More...>> {
  using Type = std::variant<Estimator<Scalar, Fewest + static_cast<int>(More)>...>;
};

}  // namespace detail

/// An Estimator (estimator.hpp) for vectors of dynamic size. It gives the same results to the last bit. Sizes are
/// checked in each call. An object contains the Estimator for its number of joints. The class is compiled for all
/// numbers from Fewest to Most; RuntimeEstimator<double, 6, 7> is compiled for 6 and 7 only.
///
///     RuntimeEstimator<double> estimator(model.nv, 0.001);
///     estimator.update(tau_ext, jacobian, rotation, dq);
///     if (estimator.compensation(jacobian, rotation, torque) == Status::Ok) tau_command += torque;
///
/// Real time: no call but the constructor allocates or throws. Vectors and matrices may be anywhere in memory, in any
/// storage order (Eigen::Map, Eigen::Ref, blocks). If an argument is an expression that must be evaluated first, Eigen
/// allocates.
template <typename Scalar, int Fewest = 4, int Most = 8>
class RuntimeEstimator {
  static_assert(1 <= Fewest && Fewest <= Most, "RuntimeEstimator: numbers of joints, from the fewest to the most");

 public:
  using Vector = JointVector<Scalar, Eigen::Dynamic>;              ///< of joint torques or velocities
  using Config = EstimatorConfig<Scalar, Eigen::Dynamic>;          ///< its settings
  using GravityTorque = Eigen::Matrix<Scalar, Eigen::Dynamic, 3>;  ///< of Proprioception::gravity_torque

  /// @param joints  of the arm, Fewest to Most
  /// @param dt      nominal control period [s], above 0 and at most 0.1
  /// @param config  as Estimator's; the vectors of `arm` have one entry per joint
  /// @throws std::invalid_argument naming the argument or the field out of range
  RuntimeEstimator(int joints, double dt, const Config& config = Config())
      : joints_(joints), any_(make<Fewest>(joints, dt, config)) {}

  /// The number of joints, as constructed.
  int joints() const noexcept { return joints_; }

  /// Advances by one sample: Estimator::update(). The arguments are the fields of Proprioception.
  /// @param tau_ext         external joint torque [N m], joints()
  /// @param jacobian        J, 6 x joints()
  /// @param rotation        R, end-effector axes to world axes
  /// @param dq              joint velocity [rad/s], joints()
  /// @param period          time since the last sample [s], >= 0; 0 means the nominal period
  /// @param motion          of the flange, if the host knows it better than from differences of J dq
  /// @param compensation    torque that the host really adds to its command for the payload [N m], joints(); without
  ///                        entries: what compensation() returned, as it is
  /// @param gravity_torque  the arm's own gravity torque per unit of gravity along each world axis [N m / (m/s^2)],
  ///                        joints() x 3; without entries: not known
  /// @return Ok; WrongSize, NonFiniteInput or NotARotation: the estimator is then as it was; NotAMeasurement: tau_ext
  ///         is frozen, and only the time counts
  template <typename Torque, typename Matrix, typename Velocity, typename Carried = Vector,
            typename Gravity = GravityTorque>
  Status update(const Eigen::MatrixBase<Torque>& tau_ext, const Eigen::MatrixBase<Matrix>& jacobian,
                const Eigen::Ref<const Matrix3<Scalar>>& rotation, const Eigen::MatrixBase<Velocity>& dq,
                double period = 0, const std::optional<FlangeMotion<Scalar>>& motion = std::nullopt,
                const Eigen::MatrixBase<Carried>& compensation = Carried(),
                const Eigen::MatrixBase<Gravity>& gravity_torque = Gravity()) noexcept {
    if (!fits(tau_ext, joints_, 1) || !fits(jacobian, 6, joints_) || !fits(dq, joints_, 1) ||
        !(compensation.size() == 0 || fits(compensation, joints_, 1)) ||
        !(gravity_torque.size() == 0 || fits(gravity_torque, joints_, 3)))
      return Status::WrongSize;
    return std::visit(
        [&](auto& estimator) {
          Proprioception<Scalar, dofs<decltype(estimator)>> sample;
          sample.tau_ext = tau_ext;
          sample.jacobian = jacobian;
          sample.rotation = rotation;
          sample.dq = dq;
          sample.period = period;
          sample.motion = motion;
          if (compensation.size() > 0) sample.compensation.emplace() = compensation;
          if (gravity_torque.size() > 0) sample.gravity_torque.emplace() = gravity_torque;
          return estimator.update(sample);
        },
        any_);
  }
  /// The current estimate, and what happens to the payload: Estimator::state().
  const EstimatorState<Scalar>& state() const noexcept {
    return std::visit([](const auto& e) -> const EstimatorState<Scalar>& { return e.state(); }, any_);
  }

  /// The torque that carries the payload: Estimator::compensation().
  /// @param jacobian     J, 6 x joints()
  /// @param rotation     R, end-effector axes to world axes
  /// @param[out] torque  the result [N m], joints()
  /// @return Ok; WrongSize: `torque` is then as it was
  template <typename Matrix>
  Status compensation(const Eigen::MatrixBase<Matrix>& jacobian, const Eigen::Ref<const Matrix3<Scalar>>& rotation,
                      Eigen::Ref<Vector> torque) const noexcept {
    if (!fits(jacobian, 6, joints_) || torque.size() != joints_) return Status::WrongSize;
    std::visit(
        [&](const auto& estimator) {
          const Jacobian<Scalar, dofs<decltype(estimator)>> fixed = jacobian;
          torque = estimator.compensation(fixed, rotation);
        },
        any_);
    return Status::Ok;
  }

  /// The host says that the hand is empty: Estimator::declare_empty().
  void declare_empty() noexcept {
    std::visit([](auto& e) { e.declare_empty(); }, any_);
  }
  /// The host says what is held: Estimator::set_payload().
  /// @param payload  mass [kg] and centre of mass [m], end-effector axes
  /// @return Ok; NonFiniteInput: nothing is changed then
  Status set_payload(const PayloadGaussian<Scalar>& payload) noexcept {
    return std::visit([&](auto& e) { return e.set_payload(payload); }, any_);
  }
  /// The host says that the payload is about to change: Estimator::expect_change().
  void expect_change() noexcept {
    std::visit([](auto& e) { e.expect_change(); }, any_);
  }
  /// The host says whether the arm is in contact: Estimator::in_contact().
  void in_contact(bool contact) noexcept {
    std::visit([&](auto& e) { e.in_contact(contact); }, any_);
  }
  /// Returns to the state after construction: Estimator::reset().
  void reset() noexcept {
    std::visit([](auto& e) { e.reset(); }, any_);
  }

 private:
  using Any =
      typename detail::EstimatorOfAny<Scalar, Fewest,
                                      std::make_index_sequence<static_cast<std::size_t>(Most - Fewest + 1)>>::Type;

  template <typename Reference>
  static constexpr int dofs = static_cast<int>(std::decay_t<Reference>::Torque::RowsAtCompileTime);

  template <typename Derived>
  static bool fits(const Eigen::MatrixBase<Derived>& x, int rows, int columns) noexcept {
    return x.rows() == rows && x.cols() == columns;
  }

  template <int Dofs>
  static Any make(int joints, double dt, const Config& config) {
    if (joints == Dofs) return Any(std::in_place_type<Estimator<Scalar, Dofs>>, dt, fixed<Dofs>(config));
    if constexpr (Dofs < Most) {
      return make<Dofs + 1>(joints, dt, config);
    } else {
      detail::refuse("RuntimeEstimator::joints: expected " + std::to_string(Fewest) + " to " + std::to_string(Most) +
                     ", got " + std::to_string(joints));
    }
  }
  template <int Dofs>
  static EstimatorConfig<Scalar, Dofs> fixed(const Config& config) {
    EstimatorConfig<Scalar, Dofs> out;
    out.gravity = config.gravity;
    out.torque_sign = config.torque_sign;
    out.rated_payload = config.rated_payload;
    out.observer_bandwidth = config.observer_bandwidth;
    out.sensing = config.sensing;
    out.payload = config.payload;
    if (!config.arm) return out;
    const auto copy = [](const Vector& from, const char* field) {
      if (from.size() != Dofs)
        detail::refuse(std::string(field) + ": expected " + std::to_string(Dofs) + " numbers, one per joint, got " +
                       std::to_string(from.size()));
      return JointVector<Scalar, Dofs>(from);
    };
    out.arm = ArmPrior<Scalar, Dofs>{
        copy(config.arm->noise, "ArmPrior::noise"), copy(config.arm->offset, "ArmPrior::offset"),
        copy(config.arm->residual, "ArmPrior::residual"), copy(config.arm->coulomb, "ArmPrior::coulomb"),
        copy(config.arm->viscous, "ArmPrior::viscous")};
    return out;
  }

  int joints_;
  Any any_;
};

}  // namespace rme
