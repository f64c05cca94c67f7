#pragma once
// What a host's 1 kHz loop looks like when rme is the controller: dynamical systems, passive law, barriers, CPIC and
// compensation; and the energy books that only a simulation can keep exactly. Shared by the programs of this folder.
#include <algorithm>
#include <cmath>
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
#include <rme/sensing/momentum_observer.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

namespace rme::examples {

/// A plane that the flange must not pass: n.x >= offset.
struct Wall {
  Eigen::Vector3d normal;  // of unit length
  double offset;           // [m]
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
  double period = 1e-3;     // [s]
  bool constrained = true;  // with the rows of CPIC, or the passive law alone, cut to the torque limits
  // Where the barriers stand inside the mechanical limits [rad]: what an unknown torque may push through them.
  double margin = 0.005;
  std::optional<Wall> wall;            // a soft row: the arm's own limits go first
  Eigen::Vector3d target;              // of the linear attractor, or the centre of the cycle [m]
  std::optional<double> cycle_radius;  // [m]; turns in the y-z plane
  Eigen::Quaterniond orientation;      // target
};

/// The controller. Everything that may throw happens in the constructor.
class Host {
 public:
  using Vector = JointVector<double, 7>;

  Host(const ArmModel<7>& model, const HostConfig& config)
      : config_(config),
        attractor_({config.target, 1.5, 0.4}),
        cycle_(cycle_config(config)),
        orientation_({config.orientation, 3}),
        posture_({model.ready, 4, 3}),
        limits_(limits_config(model, config.margin)),
        cpic_(cpic_config(model)),
        ramp_(config.period),
        disturbance_(config.period, {Vector::Constant(400)}),
        limit_(model.tau_max) {}

  /// What to compensate from the next tick on.
  void set_estimate(const Payload<double>& estimate) noexcept { estimate_ = estimate; }

  /// One tick.
  /// @return the torque to command [N m], gravity included
  const Vector& update(const SyntheticArm<7>& arm) noexcept {
    const Kinematics<7>& kinematics = arm.kinematics();
    const Dynamics<7>& dynamics = arm.dynamics();  // nominal: the payload is not in it
    const Vector &q = arm.q(), &dq = arm.dq();
    const Twist<double> twist = Twist<double>::from_vector(kinematics.jacobian * dq);
    const Flow<double> flow = config_.cycle_radius ? cycle_(kinematics.position) : attractor_(kinematics.position);
    status_ = passive_.update(flow, orientation_(kinematics.rotation), twist);
    if (status_ != Status::Ok) return torque_;
    status_ = ramp_.update(compensation_torque<double, 7>(estimate_, kinematics.jacobian, kinematics.rotation));
    if (status_ != Status::Ok) return torque_;

    // The rows rest on a prediction of ddq. What the last command does not explain of the motion since (a push,
    // friction, a payload's weight) is taken to last: an observer fed with commands, fast, since no offset of a sensor
    // is in it.
    status_ = disturbance_.update(torque_, dq, dynamics.mass_matrix, dynamics.coriolis_transpose, dynamics.gravity);
    if (status_ != Status::Ok) return torque_;
    CpicInput<double, 7> input;
    input.jacobian = kinematics.jacobian;
    input.mass_matrix = dynamics.mass_matrix;
    input.bias = dynamics.coriolis - ramp_.torque() - disturbance_.tau_ext();
    input.wrench = passive_.wrench();
    input.null_torque = posture_.torque(q, dq);
    input.other_torque = dynamics.gravity + ramp_.torque();

    rows_.clear();
    if (config_.constrained) {
      status_ = limits_.append(q, dq, rows_);
      if (status_ == Status::Ok && config_.wall) status_ = add_wall(kinematics, twist, dq);
      if (status_ != Status::Ok) return torque_;
    }
    status_ = cpic_.update(input, rows_);
    if (status_ == Status::NonFiniteInput || status_ == Status::NotPositiveDefinite) return torque_;
    // Within the limits already, but for the last bit of this sum.
    torque_ = (cpic_.torque() + input.other_torque).cwiseMax(-limit_).cwiseMin(limit_);
    return torque_;
  }

  /// Of the last update; Infeasible and NotConverged come with a torque, every other failure repeats the last one.
  Status status() const noexcept { return status_; }
  const Cpic<double, 7, 8>& cpic() const noexcept { return cpic_; }
  const PassiveController<double>& passive() const noexcept { return passive_; }
  const Vector& compensation() const noexcept { return ramp_.torque(); }

 private:
  Status add_wall(const Kinematics<7>& kinematics, const Twist<double>& twist, const Vector& dq) noexcept {
    const Eigen::Matrix<double, 3, 7> J_v = kinematics.jacobian.topRows<3>();
    if (!started_) last_ = J_v;
    const Eigen::Matrix<double, 3, 7> rate = (J_v - last_) / config_.period;  // Jdot, over the last tick
    last_ = J_v;
    started_ = true;
    const PointMotion<double, 7> flange = {kinematics.position, twist.linear, J_v, rate * dq};
    return add_barrier(half_space(flange, config_.wall->normal, config_.wall->offset), dq, {6.0, 30.0}, rows_, 1e3);
  }
  static LimitCycleConfig<double> cycle_config(const HostConfig& config) {
    LimitCycleConfig<double> cycle;
    cycle.center = config.target;
    cycle.radius = config.cycle_radius.value_or(cycle.radius);
    return cycle;
  }
  static JointLimitsConfig<double, 7> limits_config(const ArmModel<7>& model, double margin) {
    JointLimitsConfig<double, 7> limits;
    limits.q_min = model.q_min.array() + margin;
    limits.q_max = model.q_max.array() - margin;
    limits.velocity_limit = model.dq_max;
    limits.poles = {15.0, 80.0};
    return limits;
  }
  static CpicConfig<double, 7> cpic_config(const ArmModel<7>& model) {
    CpicConfig<double, 7> cpic;
    cpic.torque_limit = model.tau_max;
    cpic.moment_arm = 0.1;  // the size of the hand
    return cpic;
  }

  HostConfig config_;
  Payload<double> estimate_;
  LinearAttractor<double> attractor_;
  LimitCycle<double> cycle_;
  OrientationAttractor<double> orientation_;
  PassiveController<double> passive_;
  Posture<double, 7> posture_;
  JointLimits<double, 7> limits_;
  Cpic<double, 7, 8> cpic_;
  CompensationRamp<double, 7> ramp_;
  MomentumObserver<double, 7> disturbance_;
  Vector limit_;  // of the torques [N m]
  ConstraintRows<double, 7, 8> rows_;
  Eigen::Matrix<double, 3, 7> last_ = Eigen::Matrix<double, 3, 7>::Zero();
  bool started_ = false;
  Vector torque_ = Vector::Zero();
  Status status_ = Status::Ok;
};

/// Stored against supplied energy, from what only a simulation knows: the payload and the push.
///
/// Stored is the kinetic energy, payload included, and lambda_1 V. Supplied is the power of the push, of the payload's
/// weight as far as it is not compensated (the wrench error of [RME, Eq. 35]), of the flow's driven part, and of every
/// torque that CPIC adds to J^T F_c: null space and constraints.
class EnergyBooks {
 public:
  explicit EnergyBooks(double period) : monitor_(period), period_(period) {}

  void update(const SyntheticArm<7>& arm, const Host& host, const Eigen::Vector3d& push) noexcept {
    const JointVector<double, 7>& dq = arm.dq();
    const Dynamics<7> actual = arm.model().dynamics(arm.q(), dq, arm.payload());
    const auto& J = arm.kinematics().jacobian;
    const JointVector<double, 7> passive = J.transpose() * host.passive().wrench().vector();
    const JointVector<double, 7> mismatch = host.compensation() - (actual.gravity - arm.dynamics().gravity);
    const double supplied = dq.dot(J.topRows<3>().transpose() * push + mismatch + host.cpic().torque() - passive) +
                            host.passive().injected_power();
    (void)monitor_.update(kinetic_energy<double, 7>(actual.mass_matrix, dq) + host.passive().potential_energy(),
                          supplied);
    const double dissipated = host.passive().dissipated_power();
    if (open_) dissipated_ += period_ * (dissipated + last_dissipated_) / 2;
    last_dissipated_ = dissipated;
    open_ = true;
  }
  void reset() noexcept {
    monitor_.reset();
    open_ = false;
    dissipated_ = 0;
  }

  double stored() const noexcept { return monitor_.storage(); }     // [J]
  double supplied() const noexcept { return monitor_.supplied(); }  // [J]
  /// Stored minus supplied [J]: never rises for a passive system.
  double residual() const noexcept { return monitor_.residual(); }
  /// Stored minus supplied plus dissipated [J]: zero in continuous time, so all of it is the error of the step.
  double imbalance() const noexcept { return monitor_.residual() + dissipated_; }

 private:
  PassivityMonitor<double> monitor_;
  double period_;
  double dissipated_ = 0, last_dissipated_ = 0;
  bool open_ = false;
};

}  // namespace rme::examples
