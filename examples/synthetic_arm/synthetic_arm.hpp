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
  double mass_error = 0;  ///< links weigh something else than the model says: standard deviation, a share of the mass
  double com_error = 0;   ///< and their centres of mass lie elsewhere: standard deviation of each coordinate [m]
  Vector dq_noise = Vector::Zero();  ///< standard deviation of the white noise on the reported velocity [rad/s]
  bool noisy_observer = false;       ///< the observer is fed that velocity too, rather than the true one
  double torque_step = 0;            ///< tau_ext is reported in whole multiples of this; 0 for as it is [N m]
  int torque_delay = 0;              ///< how much later than it is known tau_ext is reported [control periods]
  double loss = 0;                   ///< probability that a period's report never arrives
  std::uint64_t seed = 1;            ///< of the noise, the losses and the model's errors
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

/// The arm as it is rather than as its model says: masses and centres of mass off by chance, inertias in proportion.
/// @param mass_error  standard deviation of each link's mass, as a share of it
/// @param com_error   standard deviation of each coordinate of each link's centre of mass [m]
/// @throws std::invalid_argument for a negative one
template <int Dofs>
ArmModel<Dofs> with_model_error(ArmModel<Dofs> model, double mass_error, double com_error, std::uint64_t seed) {
  rme::detail::require(mass_error >= 0, "SyntheticArmConfig::mass_error", ">= 0", mass_error);
  rme::detail::require(com_error >= 0, "SyntheticArmConfig::com_error", ">= 0 m", com_error);
  std::mt19937_64 random(seed ^ 0xd1b54a32d192ed03u);  // another stream than the noise
  std::normal_distribution<double> normal;
  for (Link& l : model.links) {
    const double factor = std::max(0.0, 1 + mass_error * normal(random));
    for (double& c : l.body.com) c += com_error * normal(random);
    l.body.mass *= factor;
    l.body.inertia *= factor;
  }
  return model;
}

/// The arm. Everything that it reports belongs to the instant time(), but for a tau_ext that comes late; step() goes to
/// the next control period.
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
  const Vector& dq() const { return dq_; }                                  ///< [rad/s]
  const Vector& tau_ext() const { return tau_ext_; }                        ///< the momentum observer's output [N m]
  const Vector& tau_measured() const { return tau_measured_; }  ///< torque sensors over the last period [N m]
  const Kinematics<Dofs>& kinematics() const { return kinematics_; }
  const Dynamics<Dofs>& dynamics() const { return dynamics_; }  ///< nominal: without the payload, at the observer's dq
  const ArmModel<Dofs>& model() const { return model_; }        ///< nominal: without its errors
  /// Whether this period's report never arrives: a host makes do without q, dq and tau_ext, a log has no such row.
  bool lost() const { return lost_; }

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
  void report();

  ArmModel<Dofs> model_;
  SyntheticArmConfig<Dofs> config_;
  MomentumObserver<double, Dofs> observer_;
  std::unique_ptr<Physics<Dofs>> physics_;
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  long ticks_ = 0;
  JointState<Dofs> state_;
  Vector tau_measured_ = Vector::Zero();
  // What is wrong with the reports comes from a stream of its own: it leaves the sensors' noise as it is.
  std::mt19937_64 report_random_;
  std::normal_distribution<double> report_normal_;
  Vector dq_, tau_ext_ = Vector::Zero();
  std::vector<Vector> late_;  // tau_ext of the last periods, a ring
  bool lost_ = false;
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
      physics_(
          config.physics(with_model_error(model, config.mass_error, config.com_error, config.seed), config.friction)),
      random_(config.seed),
      state_{q, dq},
      report_random_(config.seed ^ 0xbf58476d1ce4e5b9u) {
  rme::detail::require(config.substeps > 0, "SyntheticArmConfig::substeps", ">= 1", config.substeps);
  for (int i = 0; i < Dofs; ++i) {
    rme::detail::require(config.torque_noise[i] >= 0, "SyntheticArmConfig::torque_noise", ">= 0 N m",
                         config.torque_noise[i]);
    rme::detail::require(config.dq_noise[i] >= 0, "SyntheticArmConfig::dq_noise", ">= 0 rad/s", config.dq_noise[i]);
  }
  rme::detail::require(config.torque_step >= 0, "SyntheticArmConfig::torque_step", ">= 0 N m", config.torque_step);
  rme::detail::require(config.torque_delay >= 0, "SyntheticArmConfig::torque_delay", ">= 0", config.torque_delay);
  rme::detail::require(config.loss >= 0 && config.loss < 1, "SyntheticArmConfig::loss", "from 0 to below 1",
                       config.loss);
  late_.assign(static_cast<std::size_t>(config.torque_delay), Vector::Zero());
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
  const Vector& q = state_.q;
  dq_ = state_.dq;
  if ((config_.dq_noise.array() > 0).any())
    for (int i = 0; i < Dofs; ++i) dq_[i] += config_.dq_noise[i] * report_normal_(report_random_);
  const Vector& dq = config_.noisy_observer ? dq_ : state_.dq;
  kinematics_ = model_.kinematics(q);
  dynamics_ = model_.dynamics(q, dq);
  (void)observer_.update(tau_measured_, dq, dynamics_.mass_matrix, dynamics_.coriolis_transpose, dynamics_.gravity);
  report();
}

// What of the observer's output reaches the host, and whether anything does.
template <int Dofs>
void SyntheticArm<Dofs>::report() {
  tau_ext_ = observer_.tau_ext();
  if (!late_.empty()) std::swap(tau_ext_, late_[static_cast<std::size_t>(ticks_) % late_.size()]);
  const double step = config_.torque_step;
  if (step > 0) tau_ext_ = (tau_ext_ / step).array().round() * step;
  lost_ = config_.loss > 0 && std::bernoulli_distribution(config_.loss)(report_random_);
}

extern template class SyntheticArm<6>;
extern template class SyntheticArm<7>;

}  // namespace rme::examples
