#pragma once
/// What a Panda's momentum observer reports while the arm is held or moved along a path, and things come and go in its
/// hand. No dynamics, so that hours of it take seconds.
#include <algorithm>
#include <cstdint>
#include <random>
#include <rme/core/payload.hpp>
#include <rme/core/wrench.hpp>
#include <rme/sensing/proprioception.hpp>
#include <synthetic_arm/panda.hpp>

namespace rme::testing {

/// The sensors have the Panda's typical offset and white noise, and an observer of 50 rad/s. The path is followed
/// exactly, whatever pulls; a payload's inertia force is that of a point mass. Allocates nothing after construction.
class HeldArm {
 public:
  using Vector = JointVector<double, 7>;
  static constexpr double kPeriod = 1e-3;  ///< [s]

  explicit HeldArm(std::uint64_t seed) : random_(seed) {
    for (int j = 0; j < 7; ++j) offset_[j] = model_.typical_offset[j] * normal_(random_);
    sample_.tau_ext = offset_;
    place();
  }

  /// What is in the hand from the next tick on.
  void hold(const Payload<double>& payload) { payload_ = payload; }
  /// What else acts on the flange: world axes, until told otherwise.
  void push(const Wrench<double>& wrench) { push_ = wrench; }
  /// Sets out for a pose [rad], with a jerk that is bounded.
  void move(const Vector& goal, double seconds) {
    start_ = q_;
    way_ = goal - q_;
    progress_ = 0;
    step_ = kPeriod / seconds;
  }
  bool moving() const { return progress_ < 1; }
  /// Of the torque of payload and push: 1 is right.
  void set_gain(const Vector& gain) { gain_ = gain; }
  /// The gravity that pulls at the payload, world axes [m/s^2].
  void set_gravity(const Eigen::Vector3d& gravity) { gravity_ = gravity; }
  /// What else tau_ext shows, before the observer: friction, jolts, errors of the arm's model [N m].
  void set_joint_torque(const Vector& torque) { joint_torque_ = torque; }
  /// Of the sensors' noise: 1 is the typical one.
  void set_noise(double factor) { noise_ = factor; }

  /// Advances by one period.
  const Proprioception<double, 7>& tick() {
    Vector tau = moving() ? advance() : torque(payload_);
    tau += sample_.jacobian.transpose() * push_.vector();
    tau = tau.cwiseProduct(gain_) + joint_torque_ + offset_;
    if (noise_ > 0)
      for (int j = 0; j < 7; ++j) tau[j] += noise_ * model_.typical_noise[j] * normal_(random_);
    sample_.tau_ext += 50 * kPeriod * (tau - sample_.tau_ext);
    return sample_;
  }

  /// The joint torque of a payload here, at rest [N m].
  Vector torque(const Payload<double>& payload) const {
    return sample_.jacobian.transpose() * payload_wrench<double>(payload, sample_.rotation, gravity_).vector();
  }
  const Vector& pose() const { return q_; }

 private:
  void place() {
    const auto at = model_.kinematics(q_);
    sample_.jacobian = at.jacobian;
    sample_.rotation = at.rotation;
  }
  /// One period along the path; the joint torque of the payload, which Newton's law gives as a point mass at p = R r:
  /// its force is m (g - a_p), with a_p = a + alpha x p + omega x (omega x p).
  Vector advance() {
    const auto last = Twist<double>::from_vector(sample_.jacobian * sample_.dq);
    progress_ = std::min(1.0, progress_ + step_);
    const double s = progress_, rest = s * (1 - s);
    q_ = start_ + s * s * s * (10 - 15 * s + 6 * s * s) * way_;
    sample_.dq = 30 * rest * rest * step_ / kPeriod * way_;
    place();
    const auto twist = Twist<double>::from_vector(sample_.jacobian * sample_.dq);
    const Eigen::Vector3d omega = twist.angular, alpha = (omega - last.angular) / kPeriod;
    const Eigen::Vector3d p = sample_.rotation * payload_.com;
    const Eigen::Vector3d a_p = (twist.linear - last.linear) / kPeriod + alpha.cross(p) + omega.cross(omega.cross(p));
    const Eigen::Vector3d force = payload_.mass * (gravity_ - a_p);
    return sample_.jacobian.transpose() * Wrench<double>{force, p.cross(force)}.vector();
  }

  const examples::ArmModel<7>& model_ = examples::panda();
  std::mt19937_64 random_;
  std::normal_distribution<double> normal_;
  Vector offset_, gain_ = Vector::Ones(), joint_torque_ = Vector::Zero();
  Eigen::Vector3d gravity_ = model_.gravity_vector;
  double noise_ = 1;
  Payload<double> payload_;
  Wrench<double> push_;
  Vector q_ = model_.ready, start_ = q_, way_ = Vector::Zero();
  double progress_ = 1, step_ = 0;  // along the way, 0 to 1; per tick
  Proprioception<double, 7> sample_;
};

}  // namespace rme::testing
