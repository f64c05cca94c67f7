#pragma once
/// One arm of the live page: physics, sensors with their faults, controller, and rme in its loop.
#include <array>
#include <cpic_host/host.hpp>
#include <memory>
#include <optional>
#include <rme/host/payload_compensation.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/runge_kutta.hpp>

#include "live/standard_normal.hpp"

namespace rme::examples {

/// What is wrong with the arm, beside the noise and the offsets of its torque sensors. Its controller knows of nothing.
struct Faults {
  bool friction = false;    ///< joint friction, which the torque sensors do not measure
  bool noise = false;       ///< on the reported joint velocities
  bool tilted = false;      ///< the base
  bool wrong_tool = false;  ///< the hand is heavier than the arm's model says
  bool late = false;        ///< tau_ext is reported late
};

/// A bag on a string, as a point mass.
struct Bag {
  double mass;                                                   ///< [kg]
  double length;                                                 ///< of the string [m]
  Eigen::Vector3d position, velocity = Eigen::Vector3d::Zero();  ///< world axes [m, m/s]
};

/// The wall of LiveArm::constrain(): y <= 0.12 m.
inline const Wall kLiveWall{{0, -1, 0}, -0.12};

/// A Panda that holds a pose, with whatever is in its hand. Each step is a tick of a host's control loop.
class LiveArm {
 public:
  using Vector = JointVector<double, 7>;
  static constexpr double kPeriod = 1e-3;  ///< [s]

  /// @param carries  whether the torque that rme computes is added to the command
  LiveArm(std::uint64_t seed, bool carries);

  /// Advances by kPeriod.
  void step();

  void set_faults(const Faults& faults);
  /// Turns CPIC on, which keeps the wall and the joint limits, or off. Only for the arm that carries.
  void constrain(bool on);
  void follow(const PoseTarget& target);                        ///< where the flange is to be now
  void push(const Eigen::Vector3d& force) { push_ = force; }    ///< at hand() [N], world axes
  void attach(const RigidBody& body) { held_ = held_ + body; }  ///< flange axes
  void hang(double mass, double length);                        ///< a bag [kg, m]
  void drop();                                                  ///< all of it

  const Vector& q() const { return state_.q; }
  const Kinematics<7>& kinematics() const { return kinematics_; }
  const EstimatorState<double>& state() const { return rme_->state(); }
  const Vector& compensation() const { return rme_->torque(); }  ///< [N m]
  const std::optional<Bag>& bag() const { return bag_; }
  /// All that hangs on the hand and is not in the arm's model; the bag as if it were fixed to its hook.
  RigidBody payload() const;
  Eigen::Vector3d position_error() const { return kinematics_.position - target_.position; }  ///< [m]
  Eigen::Vector3d hand() const;  ///< where pushes act, world axes [m]
  /// The wrench that fits tau_ext less the torque of the estimated payload, at the flange, world axes.
  Wrench<double> residual() const;
  int active_constraints() const { return host_ ? host_->cpic().active_count() : 0; }

 private:
  void sense();
  RigidBody welded() const;
  Wrench<double> external();

  ArmModel<7> model_ = panda();                                         // as controller and observer know it
  std::array<ArmModel<7>, 3> unit_gravity_{panda(), panda(), panda()};  // for gravity of size 1 along each axis
  Faults faults_;
  StandardNormal random_;
  Vector torque_offset_;
  JointFriction<7> friction_;
  std::unique_ptr<Physics<7>> physics_;
  MomentumObserver<double, 7> observer_;
  PoseImpedance<7> impedance_;
  std::unique_ptr<Host> host_;
  std::unique_ptr<PayloadCompensation<double, 7>> rme_;
  PoseTarget target_;

  JointState<7> state_;
  Vector dq_ = Vector::Zero(), tau_ = Vector::Zero(), tau_ext_ = Vector::Zero();
  Kinematics<7> kinematics_;
  Dynamics<7> dynamics_;
  std::array<Vector, 10> late_;  // the last tau_ext, a ring
  std::size_t ticks_ = 0;
  RigidBody held_;
  std::optional<Bag> bag_;
  Eigen::Vector3d push_ = Eigen::Vector3d::Zero();
};

}  // namespace rme::examples
