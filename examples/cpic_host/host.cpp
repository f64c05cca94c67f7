#include "host.hpp"

namespace rme::examples {

namespace {

LinearAttractorConfig<double> attractor_config(const Eigen::Vector3d& target) {
  return {target, 1.5, 0.4};
}
OrientationAttractorConfig<double> orientation_config(const Eigen::Quaterniond& target) {
  return {target, 3};
}
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
      attractor_(attractor_config(config.target)),
      cycle_(cycle_config(config)),
      orientation_(orientation_config(config.orientation)),
      posture_({config.posture, 4, 3}),
      limits_(limits_config(model, config)),
      wall_poles_(config.sampled ? BarrierPoles<double>(6, 30).sampled(config.period) : BarrierPoles<double>(6, 30)),
      cpic_(cpic_config(model)),
      ramp_(config.period),
      prediction_(config.period),
      disturbance_(config.period, {Vector::Constant(400)}),
      limit_(model.tau_max) {
  if (config.tank) tank_.emplace(config.period, *config.tank);
}

void Host::follow(const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation) {
  attractor_ = LinearAttractor<double>(attractor_config(position));
  orientation_ = OrientationAttractor<double>(orientation_config(orientation));
}

auto Host::update(const Vector& q, const Vector& dq, const Kinematics<7>& kinematics, const Dynamics<7>& dynamics,
                  const Vector& compensation) noexcept -> const Vector& {
  const Twist<double> twist = Twist<double>::from_vector(kinematics.jacobian * dq);
  const Flow<double> flow = config_.cycle_radius ? cycle_(kinematics.position) : attractor_(kinematics.position);
  status_ = passive_.update(flow, orientation_(kinematics.rotation), twist);
  if (status_ != Status::Ok) return torque_;
  status_ = ramp_.update(compensation);
  if (status_ != Status::Ok) return torque_;
  compensation_ = ramp_.torque();
  if (tank_) {  // p counts from the target, in the middle of the workspace
    status_ = tank_->update(
        q, ramp_.torque(),
        compensation_potential<double>(payload_, kinematics.position - config_.target, kinematics.rotation));
    if (status_ != Status::Ok) return torque_;
    compensation_ = tank_->torque();
  }

  // The rows need a prediction of ddq. A fast observer, whose input is the last command, sees the torque that this
  // command does not explain (a push, friction, a payload's weight). The prediction takes this torque to last. The
  // observer can be fast because its output contains no sensor offset.
  status_ = disturbance_.update(torque_, dq, dynamics.mass_matrix, dynamics.coriolis_transpose, dynamics.gravity);
  if (status_ != Status::Ok) return torque_;
  CpicInput<double, 7> input;
  input.jacobian = kinematics.jacobian;
  input.mass_matrix = dynamics.mass_matrix;
  input.bias = dynamics.coriolis;
  if (config_.prediction == Prediction::Observer) input.bias -= compensation_ + disturbance_.tau_ext();
  input.wrench = passive_.wrench();
  input.null_torque = posture_.torque(q, dq);
  input.other_torque = dynamics.gravity + compensation_;

  status_ = prediction_.observe(dq);
  if (status_ != Status::Ok) return torque_;
  if (config_.wall) track_flange(kinematics, twist, dq);
  status_ = solve(input, q, dq, config_.sampled ? prediction_.error() : AccelerationError<double, 7>());
  if (status_ == Status::NonFiniteInput || status_ == Status::NotPositiveDefinite) return torque_;
  prediction_.predict(cpic_.acceleration());
  // CPIC has kept the limits; this only removes the rounding error of the sum.
  torque_ = (cpic_.torque() + input.other_torque).cwiseMax(-limit_).cwiseMin(limit_);
  return torque_;
}

Status Host::solve(const CpicInput<double, 7>& input, const Vector& q, const Vector& dq,
                   const AccelerationError<double, 7>& error) noexcept {
  rows_.clear();
  Status limits = Status::Ok;  // Infeasible if the error is too large; there are rows, and an answer, even then
  if (config_.constrained) {
    limits = limits_.append(q, dq, rows_, error);
    if (limits != Status::Ok && limits != Status::Infeasible) return limits;
    if (config_.wall) {
      const Status wall = add_barrier(half_space_barrier(flange_, config_.wall->normal, config_.wall->offset), dq,
                                      wall_poles_, rows_, config_.wall_weight, error);
      if (wall != Status::Ok && wall != Status::Infeasible) return wall;
      if (wall == Status::Infeasible) limits = wall;  // the arm cannot move along the wall's normal: there is no row
    }
  }
  const Status status = cpic_.update(input, rows_);
  return status == Status::Ok ? limits : status;
}

/// Computes the flange's motion, with Jdot from the change of J over the last tick.
void Host::track_flange(const Kinematics<7>& kinematics, const Twist<double>& twist, const Vector& dq) noexcept {
  const Eigen::Matrix<double, 3, 7> J_v = kinematics.jacobian.topRows<3>();
  if (!started_) last_ = J_v;
  const Eigen::Matrix<double, 3, 7> rate = (J_v - last_) / config_.period;
  last_ = J_v;
  started_ = true;
  flange_ = {kinematics.position, twist.linear, J_v, rate * dq};
}

}  // namespace rme::examples
