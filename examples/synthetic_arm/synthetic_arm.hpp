#pragma once
/// A simulated torque-controlled arm that reports what a real one reports: joint state and observed external torque.
#include <algorithm>
#include <cstdint>
#include <memory>
#include <random>
#include <rme/core/payload.hpp>
#include <rme/core/require.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <synthetic_arm/runge_kutta.hpp>
#include <vector>

namespace rme::examples {

/// Where the torque sensors sit, seen from the joint friction.
enum class TorqueSensing {
  MotorSide,  ///< before the gears: friction acts behind the sensor and shows in tau_ext
  LinkSide,   ///< behind the gears: the sensor feels the friction, so tau_ext is free of it
};

/// Settings of SyntheticArm; as they stand the arm is ideal, without friction, noise or offsets.
template <int Dofs>
struct SyntheticArmConfig {
  using Vector = JointVector<double, Dofs>;
  MakePhysics<Dofs> physics = RungeKutta<Dofs>::make;
  double dt = 1e-3;  ///< control period, over which the torque is held [s]
  int substeps = 1;  ///< integration steps in a control period
  JointFriction<Dofs> friction;
  TorqueSensing sensing = TorqueSensing::MotorSide;
  Vector torque_noise = Vector::Zero();   ///< standard deviation of the sensors' white noise [N m]
  Vector torque_offset = Vector::Zero();  ///< what the sensors report too much [N m]; shows in tau_ext with minus sign
  Vector observer_gain = Vector::Constant(50);  ///< of the momentum observer [rad/s]
  std::uint64_t seed = 1;                       ///< of the noise
};

/// Faults drawn at random around what the arm's table calls typical: offsets, noise, friction within half of typical.
template <int Dofs>
SyntheticArmConfig<Dofs> with_typical_faults(const ArmModel<Dofs>& model, std::uint64_t seed) {
  SyntheticArmConfig<Dofs> config;
  config.seed = seed;
  config.torque_noise = model.typical_noise;
  std::mt19937_64 random(seed ^ 0x9e3779b97f4a7c15u);  // another stream than the noise
  std::normal_distribution<double> normal;
  std::uniform_real_distribution<double> factor(0.5, 1.5);
  for (int i = 0; i < Dofs; ++i) {
    config.torque_offset[i] = model.typical_offset[i] * normal(random);
    config.friction.coulomb[i] = model.typical_coulomb[i] * factor(random);
    config.friction.viscous[i] = model.typical_viscous[i] * factor(random);
  }
  return config;
}

/// The arm. Everything that it reports belongs to the instant time(); step() goes to the next control period.
template <int Dofs>
class SyntheticArm {
 public:
  using Vector = JointVector<double, Dofs>;

  /// @param q  where the arm starts, at rest [rad]
  /// @throws std::invalid_argument naming the field out of range
  SyntheticArm(const ArmModel<Dofs>& model, const SyntheticArmConfig<Dofs>& config, const Vector& q,
               const Vector& dq = Vector::Zero());

  /// Advances by one control period under the commanded joint torque, gravity included and cut to the arm's limits.
  void step(const Vector& tau_commanded);

  double time() const { return static_cast<double>(ticks_) * config_.dt; }  ///< [s]
  const Vector& q() const { return state_.q; }                              ///< [rad]
  const Vector& dq() const { return state_.dq; }                            ///< [rad/s]
  const Vector& tau_ext() const { return observer_.tau_ext(); }             ///< the momentum observer's output [N m]
  const Vector& tau_measured() const { return tau_measured_; }  ///< torque sensors over the last period [N m]
  const Kinematics<Dofs>& kinematics() const { return kinematics_; }
  const Dynamics<Dofs>& dynamics() const { return dynamics_; }  ///< nominal: without the payload
  const ArmModel<Dofs>& model() const { return model_; }

  /// Welds a payload to the flange, beside those already there. The arm's velocity stays as it is.
  /// @param body   flange axes
  /// @param ramp   time in which it weighs in [s]; 0 is at once. A hand-over takes 0.5 to 2 s
  /// @return       what detach() wants
  int attach(const RigidBody& body, double ramp = 0);
  /// Takes a payload off again, at once or in `ramp` seconds. An unknown handle changes nothing.
  void detach(int handle, double ramp = 0);
  /// Pushes at the flange origin until told otherwise.
  void push(const Wrench<double>& wrench) { push_ = wrench; }

  /// All that is attached now, as one body in flange axes: the truth that an estimator looks for.
  RigidBody payload() const { return payload_at(time()); }

 private:
  struct Attached {
    int handle;
    RigidBody body;
    double start, ramp;  // [s]
    double from, to;     // share of the mass before and after the ramp
    double share(double t) const {
      return ramp > 0 ? from + (to - from) * std::clamp((t - start) / ramp, 0.0, 1.0) : to;
    }
  };

  RigidBody payload_at(double t) const;
  void observe();

  ArmModel<Dofs> model_;
  SyntheticArmConfig<Dofs> config_;
  MomentumObserver<double, Dofs> observer_;
  std::unique_ptr<Physics<Dofs>> physics_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  long ticks_ = 0;
  JointState<Dofs> state_;
  Vector tau_measured_ = Vector::Zero();
  std::vector<Attached> attached_;
  int handles_ = 0;
  Wrench<double> push_;
  Kinematics<Dofs> kinematics_;
  Dynamics<Dofs> dynamics_;
};

template <int Dofs>
SyntheticArm<Dofs>::SyntheticArm(const ArmModel<Dofs>& model, const SyntheticArmConfig<Dofs>& config, const Vector& q,
                                 const Vector& dq)
    : model_(model),
      config_(config),
      observer_(config.dt, {config.observer_gain}),
      physics_(config.physics(model, config.friction)),
      random_(config.seed),
      state_{q, dq} {
  rme::detail::require(config.substeps > 0, "SyntheticArmConfig::substeps", ">= 1", config.substeps);
  for (int i = 0; i < Dofs; ++i) {
    rme::detail::require(config.torque_noise[i] >= 0, "SyntheticArmConfig::torque_noise", ">= 0 N m",
                         config.torque_noise[i]);
  }
  observe();
}

template <int Dofs>
void SyntheticArm<Dofs>::step(const Vector& tau_commanded) {
  const Vector tau = tau_commanded.cwiseMax(-model_.tau_max).cwiseMin(model_.tau_max);
  const double h = config_.dt / config_.substeps;
  Vector friction = Vector::Zero();
  for (int k = 0; k < config_.substeps; ++k)
    friction += physics_->step(h, {tau, payload_at(time() + (k + 0.5) * h), push_}, state_) / config_.substeps;
  ++ticks_;
  attached_.erase(std::remove_if(attached_.begin(), attached_.end(),
                                 [this](const Attached& a) { return a.to == 0 && a.share(time()) == 0; }),
                  attached_.end());

  tau_measured_ = tau + config_.torque_offset;
  if (config_.sensing == TorqueSensing::LinkSide) tau_measured_ += friction;
  for (int i = 0; i < Dofs; ++i) tau_measured_[i] += config_.torque_noise[i] * normal_(random_);
  observe();
}

template <int Dofs>
int SyntheticArm<Dofs>::attach(const RigidBody& body, double ramp) {
  attached_.push_back({++handles_, body, time(), ramp, 0, 1});
  return handles_;
}

template <int Dofs>
void SyntheticArm<Dofs>::detach(int handle, double ramp) {
  for (Attached& a : attached_)
    if (a.handle == handle) a = {handle, a.body, time(), ramp, a.share(time()), 0};
}

template <int Dofs>
RigidBody SyntheticArm<Dofs>::payload_at(double t) const {
  RigidBody sum;
  for (const Attached& a : attached_) sum = sum + a.share(t) * a.body;
  return sum;
}

template <int Dofs>
void SyntheticArm<Dofs>::observe() {
  const auto& [q, dq] = state_;
  kinematics_ = model_.kinematics(q);
  dynamics_ = model_.dynamics(q, dq);
  (void)observer_.update(tau_measured_, dq, dynamics_.mass_matrix, dynamics_.coriolis_transpose, dynamics_.gravity);
}

extern template class SyntheticArm<6>;
extern template class SyntheticArm<7>;

}  // namespace rme::examples
