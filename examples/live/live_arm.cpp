#include "live/live_arm.hpp"

#include <rme/sensing/pseudo_wrench.hpp>

namespace rme::examples {

namespace {

constexpr double kDqNoise = 0.005;                                    // [rad/s]
constexpr double kTilt = 0.05;                                        // [rad]
const RigidBody kTool = box(0.35, {0, 0, 0.06}, {0.08, 0.08, 0.08});  // that the model does not have
const Eigen::Vector3d kHand(0, 0, 0.1), kHook(0, 0, 0.12);            // flange axes [m]

PayloadCompensationConfig<double, 7> rme_config(bool carries) {
  PayloadCompensationConfig<double, 7> config;
  config.enabled = carries;
  return config;
}

}  // namespace

LiveArm::LiveArm(std::uint64_t seed, bool carries)
    : random_(seed),
      observer_(kPeriod),
      impedance_(panda(), panda().ready),
      rme_(std::make_unique<PayloadCompensation<double, 7>>(kPeriod, rme_config(carries))),
      state_{panda().ready, Vector::Zero()} {
  for (int j = 0; j < 7; ++j) {
    torque_offset_[j] = model_.typical_offset[j] * random_();
    friction_.coulomb[j] = model_.typical_coulomb[j] * (0.5 + random_.uniform());
    friction_.viscous[j] = model_.typical_viscous[j] * (0.5 + random_.uniform());
  }
  for (int i = 0; i < 3; ++i) unit_gravity_[static_cast<std::size_t>(i)].gravity_vector = Eigen::Vector3d::Unit(i);
  late_.fill(Vector::Zero());
  kinematics_ = model_.kinematics(state_.q);
  target_ = {kinematics_.position, kinematics_.rotation};
  set_faults({});
  sense();
}

void LiveArm::set_faults(const Faults& faults) {
  faults_ = faults;
  ArmModel<7> truth = panda();
  if (faults.tilted) truth.gravity_vector = Eigen::AngleAxisd(kTilt, Eigen::Vector3d::UnitY()) * truth.gravity_vector;
  physics_ = RungeKutta<7>::make(truth, faults.friction ? friction_ : JointFriction<7>());
}

void LiveArm::constrain(bool on) {
  host_.reset();
  if (!on) return;
  HostConfig config = HostConfig::hold(model_, model_.ready);
  config.target = target_.position;
  config.orientation = Eigen::Quaterniond(target_.rotation);
  config.sampled = true;
  config.wall = kLiveWall;
  host_ = std::make_unique<Host>(model_, config);
}

void LiveArm::follow(const PoseTarget& target) {
  target_ = target;
  impedance_.follow(target);
  if (host_) host_->follow(target.position, Eigen::Quaterniond(target.rotation));
}

void LiveArm::hang(double mass, double length) {
  constexpr double kSwing = 0.4;  // [rad]: it is handed over swinging
  const Eigen::Vector3d hook = kinematics_.position + kinematics_.rotation * kHook;
  bag_ = Bag{mass, length, hook + length * Eigen::Vector3d(0, std::sin(kSwing), -std::cos(kSwing))};
}

void LiveArm::drop() {
  held_ = RigidBody();
  bag_.reset();
}

RigidBody LiveArm::welded() const {
  return faults_.wrong_tool ? held_ + kTool : held_;
}

RigidBody LiveArm::payload() const {
  return bag_ ? welded() + RigidBody{bag_->mass, kHook, Eigen::Matrix3d::Zero()} : welded();
}

Eigen::Vector3d LiveArm::hand() const {
  return kinematics_.position + kinematics_.rotation * kHand;
}

Wrench<double> LiveArm::residual() const {
  Wrench<double> out;
  const auto carried = compensation_torque<double>(state().payload.payload(), kinematics_.jacobian,
                                                   kinematics_.rotation);  // minus the payload's torque
  (void)pseudo_wrench(kinematics_.jacobian, tau_ext_ + carried, 1e-2, out);
  return out;
}

/// Advances the bag, and returns its pull and the push, at the flange.
Wrench<double> LiveArm::external() {
  const Eigen::Vector3d lever = kinematics_.rotation * kHand;
  Wrench<double> out{push_, lever.cross(push_)};
  if (!bag_) return out;
  constexpr int kSteps = 4;
  constexpr double kStiffness = 4000, kDamping = 30, kAir = 0.1;  // of the string [N/m, N s/m]; [N s/m]
  const Eigen::Vector3d arm = kinematics_.rotation * kHook, hook = kinematics_.position + arm;
  const Eigen::Vector3d hook_velocity =
      kinematics_.jacobian.topRows<3>() * state_.dq - arm.cross(kinematics_.jacobian.bottomRows<3>() * state_.dq);
  Eigen::Vector3d pull = Eigen::Vector3d::Zero();
  for (int i = 0; i < kSteps; ++i) {
    const Eigen::Vector3d way = bag_->position - hook, along = way.normalized();
    const double stretch = way.norm() - bag_->length, rate = (bag_->velocity - hook_velocity).dot(along);
    const double tension = stretch > 0 ? std::max(0.0, kStiffness * stretch + kDamping * rate) : 0;
    const Eigen::Vector3d force = -tension * along - kAir * bag_->velocity;
    bag_->velocity += kPeriod / kSteps * (force / bag_->mass + model_.gravity_vector);
    bag_->position += kPeriod / kSteps * bag_->velocity;
    pull += tension / kSteps * along;
  }
  out.force += pull;
  out.moment += arm.cross(pull);
  return out;
}

void LiveArm::sense() {
  Vector tau_measured = tau_ + torque_offset_;
  for (int j = 0; j < 7; ++j) tau_measured[j] += model_.typical_noise[j] * random_();
  dq_ = state_.dq;
  if (faults_.noise)
    for (int j = 0; j < 7; ++j) dq_[j] += kDqNoise * random_();
  kinematics_ = model_.kinematics(state_.q);
  dynamics_ = model_.dynamics(state_.q, dq_);
  (void)observer_.update(tau_measured, dq_, dynamics_.mass_matrix, dynamics_.coriolis_transpose, dynamics_.gravity);
  Vector& oldest = late_[ticks_ % late_.size()];
  tau_ext_ = faults_.late ? oldest : observer_.tau_ext();
  oldest = observer_.tau_ext();
}

void LiveArm::step() {
  Proprioception<double, 7> sample{tau_ext_, kinematics_.jacobian, kinematics_.rotation, dq_};
  sample.gravity_torque.emplace();
  for (int i = 0; i < 3; ++i)
    sample.gravity_torque->col(i) =
        unit_gravity_[static_cast<std::size_t>(i)].dynamics(state_.q, Vector::Zero()).gravity;
  (void)rme_->update(sample);

  const Vector nominal = impedance_.torque(state_.q, dq_, kinematics_, dynamics_);
  tau_ = host_ ? host_->update(state_.q, dq_, kinematics_, dynamics_, rme_->torque()) : nominal + rme_->torque();
  tau_ = tau_.cwiseMax(-model_.tau_max).cwiseMin(model_.tau_max);
  physics_->step(kPeriod, {tau_, welded(), external()}, state_);
  ++ticks_;
  sense();
}

}  // namespace rme::examples
