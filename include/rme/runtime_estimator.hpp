#pragma once
/// The estimator for hosts that learn the number of joints at run time.
#include <optional>
#include <rme/core/any_dofs.hpp>
#include <rme/core/flange_motion.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/estimator.hpp>
#include <rme/estimator_config.hpp>
#include <rme/estimator_state.hpp>
#include <rme/sensing/contact_state.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <type_traits>
#include <variant>

namespace rme {

namespace detail {

/// The settings for Dofs joints.
/// @throws std::invalid_argument naming the vector that has another length
template <int Dofs, typename Scalar>
EstimatorConfig<Scalar, Dofs> fixed_config(const EstimatorConfig<Scalar, Eigen::Dynamic>& config) {
  EstimatorConfig<Scalar, Dofs> out;
  out.gravity = config.gravity;
  out.torque_sign = config.torque_sign;
  out.rated_payload = config.rated_payload;
  out.observer_bandwidth = config.observer_bandwidth;
  out.contact_false_alarms = config.contact_false_alarms;
  out.sensing = config.sensing;
  out.payload = config.payload;
  if (!config.arm) return out;
  out.arm = ArmPrior<Scalar, Dofs>{per_joint<Dofs>(config.arm->noise, "ArmPrior::noise"),
                                   per_joint<Dofs>(config.arm->offset, "ArmPrior::offset"),
                                   per_joint<Dofs>(config.arm->residual, "ArmPrior::residual"),
                                   per_joint<Dofs>(config.arm->coulomb, "ArmPrior::coulomb"),
                                   per_joint<Dofs>(config.arm->viscous, "ArmPrior::viscous"),
                                   config.arm->friction_std};
  return out;
}

/// A sample from vectors and matrices of dynamic size; `compensation` and `gravity_torque` without entries are absent.
/// @return Ok; WrongSize: `sample` is then as it was
template <typename Scalar, int Dofs, typename Torque, typename Matrix, typename Velocity, typename Carried,
          typename Gravity>
Status fill_sample(const Eigen::MatrixBase<Torque>& tau_ext, const Eigen::MatrixBase<Matrix>& jacobian,
                   const Eigen::Ref<const Matrix3<Scalar>>& rotation, const Eigen::MatrixBase<Velocity>& dq,
                   double period, const std::optional<FlangeMotion<Scalar>>& motion,
                   const Eigen::MatrixBase<Carried>& compensation, const Eigen::MatrixBase<Gravity>& gravity_torque,
                   Proprioception<Scalar, Dofs>& sample) noexcept {
  if (!has_size(tau_ext, Dofs, 1) || !has_size(jacobian, 6, Dofs) || !has_size(dq, Dofs, 1) ||
      !(compensation.size() == 0 || has_size(compensation, Dofs, 1)) ||
      !(gravity_torque.size() == 0 || has_size(gravity_torque, Dofs, 3)))
    return Status::WrongSize;
  sample.tau_ext = tau_ext;
  sample.jacobian = jacobian;
  sample.rotation = rotation;
  sample.dq = dq;
  sample.period = period;
  sample.motion = motion;
  if (compensation.size() > 0) sample.compensation.emplace() = compensation;
  if (gravity_torque.size() > 0) sample.gravity_torque.emplace() = gravity_torque;
  return Status::Ok;
}

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
  using Contact = ContactState<Scalar, Eigen::Dynamic>;            ///< Estimator::contact()
  using GravityTorque = Eigen::Matrix<Scalar, Eigen::Dynamic, 3>;  ///< of Proprioception::gravity_torque

  /// @param joints  of the arm, Fewest to Most
  /// @param dt      nominal control period [s], above 0 and at most 0.1
  /// @param config  as Estimator's; the vectors of `arm` have one entry per joint
  /// @throws std::invalid_argument naming the argument or the field out of range
  RuntimeEstimator(int joints, double dt, const Config& config = Config())
      : joints_(joints),
        any_(detail::make_any_dofs<Estimator, Scalar, Fewest, Most>(
            "RuntimeEstimator", joints, dt, [&](auto count) { return detail::fixed_config<count>(config); })) {
    for (Vector* v : {&contact_.residual, &contact_.variance, &contact_.threshold, &contact_.link}) v->setZero(joints);
  }

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
    return std::visit(
        [&](auto& estimator) {
          Proprioception<Scalar, dofs<decltype(estimator)>> sample;
          const Status status = detail::fill_sample<Scalar>(tau_ext, jacobian, rotation, dq, period, motion,
                                                            compensation, gravity_torque, sample);
          if (status != Status::Ok) return status;
          const Status out = estimator.update(sample);
          copy(estimator.contact());
          return out;
        },
        any_);
  }
  /// The current estimate, and what happens to the payload: Estimator::state().
  const EstimatorState<Scalar>& state() const noexcept {
    return std::visit([](const auto& e) -> const EstimatorState<Scalar>& { return e.state(); }, any_);
  }

  /// What acts on the arm and is not explained: Estimator::contact().
  const Contact& contact() const noexcept { return contact_; }

  /// The torque that carries the payload: Estimator::compensation().
  /// @param jacobian     J, 6 x joints()
  /// @param rotation     R, end-effector axes to world axes
  /// @param[out] torque  the result [N m], joints()
  /// @return Ok; WrongSize: `torque` is then as it was
  template <typename Matrix>
  Status compensation(const Eigen::MatrixBase<Matrix>& jacobian, const Eigen::Ref<const Matrix3<Scalar>>& rotation,
                      Eigen::Ref<Vector> torque) const noexcept {
    if (!detail::has_size(jacobian, 6, joints_) || torque.size() != joints_) return Status::WrongSize;
    std::visit(
        [&](const auto& estimator) {
          const Jacobian<Scalar, dofs<decltype(estimator)>> fixed = jacobian;
          torque = estimator.compensation(fixed, rotation);
        },
        any_);
    return Status::Ok;
  }

  /// The torque that carries the payload and moves it: Estimator::payload_torque().
  /// @param jacobian     J, 6 x joints()
  /// @param rotation     R, end-effector axes to world axes
  /// @param motion       of the end effector, world axes
  /// @param[out] torque  the result [N m], joints()
  /// @return Ok; WrongSize: `torque` is then as it was
  template <typename Matrix>
  Status payload_torque(const Eigen::MatrixBase<Matrix>& jacobian, const Eigen::Ref<const Matrix3<Scalar>>& rotation,
                        const FlangeMotion<Scalar>& motion, Eigen::Ref<Vector> torque) const noexcept {
    if (!detail::has_size(jacobian, 6, joints_) || torque.size() != joints_) return Status::WrongSize;
    std::visit(
        [&](const auto& estimator) {
          const Jacobian<Scalar, dofs<decltype(estimator)>> fixed = jacobian;
          torque = estimator.payload_torque(fixed, rotation, motion);
        },
        any_);
    return Status::Ok;
  }

  /// The host says that the hand is empty: Estimator::declare_empty().
  void declare_empty() noexcept {
    std::visit(
        [this](auto& e) {
          e.declare_empty();
          this->copy(e.contact());
        },
        any_);
  }
  /// The host says what is held: Estimator::set_payload().
  /// @param payload  mass [kg] and centre of mass [m], end-effector axes
  /// @return Ok; NonFiniteInput: nothing is changed then
  Status set_payload(const PayloadGaussian<Scalar>& payload) noexcept {
    return std::visit(
        [&](auto& e) {
          const Status status = e.set_payload(payload);
          this->copy(e.contact());
          return status;
        },
        any_);
  }
  /// The host says that what is held is part of the tool: Estimator::tare().
  void tare() noexcept {
    std::visit(
        [this](auto& e) {
          e.tare();
          this->copy(e.contact());
        },
        any_);
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
    std::visit(
        [this](auto& e) {
          e.reset();
          this->copy(e.contact());
        },
        any_);
  }

 private:
  template <typename Reference>
  static constexpr int dofs = static_cast<int>(std::decay_t<Reference>::Torque::RowsAtCompileTime);

  /// Into vectors that have the size already, so that nothing allocates.
  template <int Dofs>
  void copy(const ContactState<Scalar, Dofs>& from) noexcept {
    contact_.ready = from.ready;
    contact_.contact = from.contact;
    contact_.statistic = from.statistic;
    contact_.residual = from.residual;
    contact_.variance = from.variance;
    contact_.threshold = from.threshold;
    contact_.wrench = from.wrench;
    contact_.wrench_covariance = from.wrench_covariance;
    contact_.link = from.link;
    contact_.last = from.last;
  }

  int joints_;
  Contact contact_;
  detail::AnyDofs<Estimator, Scalar, Fewest, Most> any_;
};

}  // namespace rme
