#include "host.hpp"

namespace rme::examples {

namespace {

LimitCycleConfig<double> cycle_config(const HostConfig& config) {
  LimitCycleConfig<double> cycle;
  cycle.center = config.target;
  cycle.radius = config.cycle_radius.value_or(cycle.radius);
  return cycle;
}
JointLimitsConfig<double, 7> limits_config(const ArmModel<7>& model, const HostConfig& config) {
  JointLimitsConfig<double, 7> limits;
  limits.q_min = model.q_min.array() + config.margin;
  limits.q_max = model.q_max.array() - config.margin;
  if (config.sampled) limits.period = config.period;
  limits.velocity_limit = model.dq_max;
  limits.poles = {15.0, 80.0};
  return limits;
}
CpicConfig<double, 7> cpic_config(const ArmModel<7>& model) {
  CpicConfig<double, 7> cpic;
  cpic.torque_limit = model.tau_max;
  cpic.moment_arm = 0.1;  // the size of the hand
  return cpic;
}

}  // namespace

Host::Host(const ArmModel<7>& model, const HostConfig& config)
    : config_(config),
      attractor_({config.target, 1.5, 0.4}),
      cycle_(cycle_config(config)),
      orientation_({config.orientation, 3}),
      posture_({config.posture, 4, 3}),
      limits_(limits_config(model, config)),
      wall_poles_(config.sampled ? BarrierPoles<double>(6, 30).sampled(config.period) : BarrierPoles<double>(6, 30)),
      cpic_(cpic_config(model)),
      ramp_(config.period),
      prediction_(config.period),
      disturbance_(config.period, {Vector::Constant(400)}),
      limit_(model.tau_max) {}

auto Host::update(const SyntheticArm<7>& arm, const Vector& compensation) noexcept -> const Vector& {
  const Kinematics<7>& kinematics = arm.kinematics();
  const Dynamics<7>& dynamics = arm.dynamics();  // nominal: the payload is not in it
  const Vector &q = arm.q(), &dq = arm.dq();
  const Twist<double> twist = Twist<double>::from_vector(kinematics.jacobian * dq);
  const Flow<double> flow = config_.cycle_radius ? cycle_(kinematics.position) : attractor_(kinematics.position);
  status_ = passive_.update(flow, orientation_(kinematics.rotation), twist);
  if (status_ != Status::Ok) return torque_;
  status_ = ramp_.update(compensation);
  if (status_ != Status::Ok) return torque_;

  // The rows rest on a prediction of ddq. What the last command does not explain of the motion since (a push,
  // friction, a payload's weight) is taken to last: an observer fed with commands, fast, since no offset of a sensor
  // is in it.
  status_ = disturbance_.update(torque_, dq, dynamics.mass_matrix, dynamics.coriolis_transpose, dynamics.gravity);
  if (status_ != Status::Ok) return torque_;
  CpicInput<double, 7> input;
  input.jacobian = kinematics.jacobian;
  input.mass_matrix = dynamics.mass_matrix;
  input.bias = dynamics.coriolis;
  if (config_.prediction == Prediction::Observer) input.bias -= ramp_.torque() + disturbance_.tau_ext();
  input.wrench = passive_.wrench();
  input.null_torque = posture_.torque(q, dq);
  input.other_torque = dynamics.gravity + ramp_.torque();

  rows_.clear();
  status_ = prediction_.observe(dq);
  if (status_ != Status::Ok) return torque_;
  if (config_.sampled) error_ = prediction_.error();
  if (config_.payload_aware) {
    status_ =
        uncertainty_.update(payload_, probability_, kinematics.jacobian, kinematics.rotation, dynamics.mass_matrix);
    if (status_ != Status::Ok) return torque_;
    error_.below += uncertainty_.error().below;
    error_.above += uncertainty_.error().above;
  }
  if (config_.constrained) {
    status_ = limits_.append(q, dq, rows_, error_);
    if (status_ == Status::Infeasible) status_ = Status::Ok;  // what the error leaves room for
    if (status_ == Status::Ok && config_.wall) status_ = add_wall(kinematics, twist, dq);
    if (status_ != Status::Ok) return torque_;
  }
  status_ = cpic_.update(input, rows_);
  if (status_ == Status::NonFiniteInput || status_ == Status::NotPositiveDefinite) return torque_;
  prediction_.predict(cpic_.acceleration());
  // Within the limits already, but for the last bit of this sum.
  torque_ = (cpic_.torque() + input.other_torque).cwiseMax(-limit_).cwiseMin(limit_);
  return torque_;
}

Status Host::add_wall(const Kinematics<7>& kinematics, const Twist<double>& twist, const Vector& dq) noexcept {
  const Eigen::Matrix<double, 3, 7> J_v = kinematics.jacobian.topRows<3>();
  if (!started_) last_ = J_v;
  const Eigen::Matrix<double, 3, 7> rate = (J_v - last_) / config_.period;  // Jdot, over the last tick
  last_ = J_v;
  started_ = true;
  const PointMotion<double, 7> flange = {kinematics.position, twist.linear, J_v, rate * dq};
  return add_barrier(half_space(flange, config_.wall->normal, config_.wall->offset), dq, wall_poles_, rows_,
                     config_.wall_weight, error_);
}

}  // namespace rme::examples
