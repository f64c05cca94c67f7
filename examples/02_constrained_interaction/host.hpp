#pragma once
// What a host's 1 kHz loop looks like when rme is the controller: dynamical systems, passive law, barriers, CPIC,
// compensation, passivity monitor. Shared by the two programs of this folder.
#include <algorithm>
#include <optional>
#include <rme/control/barriers.hpp>
#include <rme/control/compensation.hpp>
#include <rme/control/cpic.hpp>
#include <rme/control/limit_cycle.hpp>
#include <rme/control/linear_attractor.hpp>
#include <rme/control/orientation_attractor.hpp>
#include <rme/control/passive_controller.hpp>
#include <rme/control/passivity_monitor.hpp>
#include <rme/control/posture.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

namespace rme::examples {

/// A plane that the flange must not pass: n.x >= offset.
struct Wall {
  Eigen::Vector3d normal = Eigen::Vector3d::UnitX();
  double offset = -10;  // [m]
};

/// A push that comes and goes like a person's: rises, holds, falls.
struct Push {
  double start = 0, rise = 0.15, hold = 0;  // [s]
  Eigen::Vector3d force = Eigen::Vector3d::Zero();

  Eigen::Vector3d at(double t) const {
    const double s = t - start;
    return std::clamp(std::min(s, 2 * rise + hold - s) / rise, 0.0, 1.0) * force;
  }
};

struct HostConfig {
  double period = 1e-3;                // [s]
  bool constrained = true;             // CPIC with its rows, or only the unconstrained law cut to the torque limits
  std::optional<Wall> wall;            // a soft row: limits of the arm itself go first
  Eigen::Vector3d target;              // of the linear attractor, or the centre of the cycle [m]
  std::optional<double> cycle_radius;  // [m]; turns in the y-z plane
  Eigen::Quaterniond orientation;      // target
  Payload<double> estimate;            // of the payload, compensated from the first tick on
};

/// The controller. Everything that may throw happens in the constructor.
class Host {
 public:
  using Vector = JointVector<double, 7>;
  using Rows = ConstraintRows<double, 7, 16>;

  Host(const ArmModel<7>& model, const HostConfig& config)
      : config_(config),
        attractor_({config.target, 1.5, 0.4}),
        cycle_(cycle_config(config)),
        orientation_({config.orientation, 3}),
        posture_({model.ready, 4, 3}),
        limits_(limits_config(model)),
        cpic_(cpic_config(model)),
        ramp_(config.period),
        monitor_(config.period) {}

  /// One tick.
  /// @param payload  what hangs on the flange; enters the books of the monitor, never the controller
  /// @return the torque to command [N m], gravity included
  const Vector& update(const SyntheticArm<7>& arm, const Eigen::Vector3d& push) noexcept {
    const Kinematics<7>& kinematics = arm.kinematics();
    const Dynamics<7>& dynamics = arm.dynamics();
    const Vector &q = arm.q(), &dq = arm.dq();
    const Twist<double> twist = Twist<double>::from_vector(kinematics.jacobian * dq);

    const Flow<double> flow = config_.cycle_radius ? cycle_(kinematics.position) : attractor_(kinematics.position);
    status_ = passive_.update(flow, orientation_(kinematics.rotation), twist);

    // Nominal dynamics, and whatever else acts on the joints as the arm reports it: a push or an uncompensated payload.
    (void)ramp_.update(compensation_torque<double, 7>(config_.estimate, kinematics.jacobian, kinematics.rotation));
    CpicInput<double, 7> input;
    input.jacobian = kinematics.jacobian;
    input.mass_matrix = dynamics.mass_matrix;
    input.bias = dynamics.coriolis - arm.tau_ext() - ramp_.torque();
    input.wrench = passive_.wrench();
    input.null_torque = posture_.torque(q, dq);
    input.other_torque = dynamics.gravity + ramp_.torque();

    rows_.clear();
    if (config_.constrained) {
      (void)limits_.append(q, dq, rows_);
      if (config_.wall) {
        const auto J_v = kinematics.jacobian.topRows<3>();
        if (!previous_jacobian_) previous_jacobian_ = J_v;
        const PointMotion<double, 7> flange = {kinematics.position, twist.linear, J_v,
                                               (J_v - *previous_jacobian_) / config_.period * dq};
        previous_jacobian_ = J_v;
        (void)add_barrier(half_space(flange, config_.wall->normal, config_.wall->offset), dq, {6.0, 30.0}, rows_, 1e3);
      }
    }
    status_ = cpic_.update(input, rows_);
    torque_ = cpic_.torque() + input.other_torque;

    // Books: stored is the kinetic energy and lambda_1 V; supplied is the push's power and that of every torque beside
    // gravity compensation and J^T F_c.
    const Vector passive = kinematics.jacobian.transpose() * passive_.wrench().vector();
    const RigidBody payload = arm.payload();
    const Dynamics<7> actual = arm.model().dynamics(q, dq, payload);
    const Vector mismatch = ramp_.torque() - (actual.gravity - dynamics.gravity);  // J^T dF_mm
    const double supplied =
        twist.linear.dot(push) + passive_.injected_power() + dq.dot(cpic_.torque() - passive) + dq.dot(mismatch);
    (void)monitor_.update(kinetic_energy<double, 7>(actual.mass_matrix, dq) + passive_.potential_energy(), supplied);
    return torque_;
  }

  Status status() const noexcept { return status_; }
  const Cpic<double, 7, 16>& cpic() const noexcept { return cpic_; }
  const PassiveController<double>& passive() const noexcept { return passive_; }
  PassivityMonitor<double>& monitor() noexcept { return monitor_; }
  const Vector& compensation() const noexcept { return ramp_.torque(); }

 private:
  static LimitCycleConfig<double> cycle_config(const HostConfig& config) {
    LimitCycleConfig<double> cycle;
    cycle.center = config.target;
    cycle.radius = config.cycle_radius.value_or(cycle.radius);
    return cycle;
  }
  static JointLimitsConfig<double, 7> limits_config(const ArmModel<7>& model) {
    JointLimitsConfig<double, 7> limits;
    limits.q_min = model.q_min;
    limits.q_max = model.q_max;
    limits.velocity_limit = model.dq_max;
    return limits;
  }
  static CpicConfig<double, 7> cpic_config(const ArmModel<7>& model) {
    CpicConfig<double, 7> cpic;
    cpic.torque_limit = model.tau_max;
    return cpic;
  }

  HostConfig config_;
  LinearAttractor<double> attractor_;
  LimitCycle<double> cycle_;
  OrientationAttractor<double> orientation_;
  PassiveController<double> passive_;
  Posture<double, 7> posture_;
  JointLimits<double, 7> limits_;
  Cpic<double, 7, 16> cpic_;
  CompensationRamp<double, 7> ramp_;
  PassivityMonitor<double> monitor_;
  Rows rows_;
  std::optional<Eigen::Matrix<double, 3, 7>> previous_jacobian_;
  Vector torque_ = Vector::Zero();
  Status status_ = Status::Ok;
};

}  // namespace rme::examples
