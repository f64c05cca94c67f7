#pragma once
/// PayloadCompensation for hosts that learn the number of joints at run time.
#include <optional>
#include <rme/core/any_dofs.hpp>
#include <rme/core/flange_motion.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/estimator_state.hpp>
#include <rme/host/payload_compensation.hpp>
#include <rme/runtime_estimator.hpp>
#include <type_traits>
#include <variant>

namespace rme {

namespace detail {

/// The settings for Dofs joints.
/// @throws std::invalid_argument naming the vector that has another length
template <int Dofs, typename Scalar>
PayloadCompensationConfig<Scalar, Dofs> fixed_config(const PayloadCompensationConfig<Scalar, Eigen::Dynamic>& config) {
  PayloadCompensationConfig<Scalar, Dofs> out;
  out.estimator = fixed_config<Dofs>(config.estimator);
  if (config.torque_rate)
    out.torque_rate = per_joint<Dofs>(*config.torque_rate, "PayloadCompensationConfig::torque_rate");
  if (config.torque_bound)
    out.torque_bound = per_joint<Dofs>(*config.torque_bound, "PayloadCompensationConfig::torque_bound");
  out.fade_time = config.fade_time;
  out.enabled = config.enabled;
  out.hand_over_error = config.hand_over_error;
  if (config.levers) out.levers = per_joint<Dofs>(*config.levers, "PayloadCompensationConfig::levers");
  return out;
}

}  // namespace detail

/// A PayloadCompensation (payload_compensation.hpp, where the calls are described) for vectors of dynamic size, with
/// the same results to the last bit. Sizes are checked in each call. The class is compiled for all numbers of joints
/// from Fewest to Most; RuntimePayloadCompensation<double, 6, 7> is compiled for 6 and 7 only.
///
///     RuntimePayloadCompensation<double> payload(model.nv, 0.001, config);
///     status = payload.update(tau_ext, jacobian, rotation, dq);
///     tau_command += payload.torque();
///
/// Real time: no call but the constructor allocates or throws. If an argument is an expression that must be evaluated
/// first, Eigen allocates.
template <typename Scalar, int Fewest = 4, int Most = 8>
class RuntimePayloadCompensation {
 public:
  using Vector = JointVector<Scalar, Eigen::Dynamic>;                ///< of joint torques or velocities
  using Config = PayloadCompensationConfig<Scalar, Eigen::Dynamic>;  ///< its settings
  using GravityTorque = Eigen::Matrix<Scalar, Eigen::Dynamic, 3>;    ///< of Proprioception::gravity_torque
  using Body = InertialParameters<Scalar>;                           ///< a load, end-effector axes

  /// @param joints  of the arm, Fewest to Most
  /// @param period  nominal control period [s], above 0 and at most 0.1
  /// @param config  settings; each vector has one number per joint
  /// @throws std::invalid_argument naming the argument or the field out of range
  RuntimePayloadCompensation(int joints, double period, const Config& config = Config())
      : joints_(joints),
        any_(detail::make_any_dofs<PayloadCompensation, Scalar, Fewest, Most>(
            "RuntimePayloadCompensation", joints, period,
            [&](auto dofs) { return detail::fixed_config<dofs>(config); })) {}

  /// The number of joints, as constructed.
  int joints() const noexcept { return joints_; }

  /// PayloadCompensation::update(); the arguments are the fields of Proprioception, as in RuntimeEstimator::update().
  /// @param tau_ext         external joint torque [N m], joints()
  /// @param jacobian        J, 6 x joints()
  /// @param rotation        R, end-effector axes to world axes
  /// @param dq              joint velocity [rad/s], joints()
  /// @param period          time since the last sample [s], >= 0; 0 means the nominal period
  /// @param motion          of the flange, if the host knows it better than from differences of J dq
  /// @param compensation    torque that the host really adds to its command for the payload [N m], joints(); without
  ///                        entries: torque()
  /// @param gravity_torque  the arm's own gravity torque per unit of gravity along each world axis [N m / (m/s^2)],
  ///                        joints() x 3; without entries: not known
  /// @return as PayloadCompensation::update(), or WrongSize: nothing has changed
  template <typename Torque, typename Matrix, typename Velocity, typename Carried = Vector,
            typename Gravity = GravityTorque>
  Status update(const Eigen::MatrixBase<Torque>& tau_ext, const Eigen::MatrixBase<Matrix>& jacobian,
                const Eigen::Ref<const Matrix3<Scalar>>& rotation, const Eigen::MatrixBase<Velocity>& dq,
                double period = 0, const std::optional<FlangeMotion<Scalar>>& motion = std::nullopt,
                const Eigen::MatrixBase<Carried>& compensation = Carried(),
                const Eigen::MatrixBase<Gravity>& gravity_torque = Gravity()) noexcept {
    return std::visit(
        [&](auto& payload) {
          typename std::decay_t<decltype(payload)>::Sample sample;
          const Status status = detail::fill_sample<Scalar>(tau_ext, jacobian, rotation, dq, period, motion,
                                                            compensation, gravity_torque, sample);
          return status == Status::Ok ? payload.update(sample) : status;
        },
        any_);
  }
  /// The torque to add to the command now [N m], joints() numbers; a view of this object's.
  Eigen::Map<const Vector> torque() const noexcept {
    return {std::visit([](const auto& payload) { return payload.torque().data(); }, any_), joints_};
  }
  /// PayloadCompensation::enable().
  void enable(bool on) noexcept {
    std::visit([&](auto& payload) { payload.enable(on); }, any_);
  }
  /// PayloadCompensation::enabled().
  bool enabled() const noexcept {
    return std::visit([](const auto& payload) { return payload.enabled(); }, any_);
  }
  /// PayloadCompensation::restart().
  void restart() noexcept {
    std::visit([](auto& payload) { payload.restart(); }, any_);
  }
  /// PayloadCompensation::reset().
  void reset() noexcept {
    std::visit([](auto& payload) { payload.reset(); }, any_);
  }
  /// PayloadCompensation::hand_over().
  HandOver<Scalar> hand_over() const noexcept {
    return std::visit([](const auto& payload) { return payload.hand_over(); }, any_);
  }
  /// PayloadCompensation::handed_over().
  void handed_over(const Body& body) noexcept {
    std::visit([&](auto& payload) { payload.handed_over(body); }, any_);
  }
  /// PayloadCompensation::load_lost().
  bool load_lost() const noexcept {
    return std::visit([](const auto& payload) { return payload.load_lost(); }, any_);
  }
  /// PayloadCompensation::load_cleared().
  void load_cleared() noexcept {
    std::visit([](auto& payload) { payload.load_cleared(); }, any_);
  }

  /// What is held, and what happens to it: Estimator::state().
  const EstimatorState<Scalar>& state() const noexcept {
    return std::visit([](const auto& p) -> const EstimatorState<Scalar>& { return p.state(); }, any_);
  }
  /// Estimator::declare_empty().
  void declare_empty() noexcept {
    std::visit([](auto& payload) { payload.estimator().declare_empty(); }, any_);
  }
  /// Estimator::set_payload().
  /// @param known  mass [kg] and centre of mass [m], end-effector axes
  /// @return Ok; NonFiniteInput: nothing is changed then
  Status set_payload(const PayloadGaussian<Scalar>& known) noexcept {
    return std::visit([&](auto& payload) { return payload.estimator().set_payload(known); }, any_);
  }
  /// Estimator::expect_change().
  void expect_change() noexcept {
    std::visit([](auto& payload) { payload.estimator().expect_change(); }, any_);
  }
  /// Estimator::in_contact().
  void in_contact(bool contact) noexcept {
    std::visit([&](auto& payload) { payload.estimator().in_contact(contact); }, any_);
  }

 private:
  int joints_;
  detail::AnyDofs<PayloadCompensation, Scalar, Fewest, Most> any_;
};

}  // namespace rme
