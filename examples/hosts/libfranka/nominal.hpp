#pragma once
/// Two controllers for libfranka_payload, as users have them: without gravity, which libfranka adds, and without payload.
#include <franka/model.h>
#include <franka/robot.h>

#include <Eigen/Geometry>
#include <algorithm>
#include <array>
#include <cmath>
#include <rme/core/types.hpp>

namespace hosts {

using Vector7 = rme::JointVector<double, 7>;

/// Limits the rate of a controller's torque to half of what the robot allows; the other half is for the compensation.
/// The step is counted from this controller's own last torque: tau_J_d includes the compensation.
class HalfTheRate {
 public:
  franka::Torques operator()(const Vector7& wanted) {
    last_ += (wanted - last_).cwiseMax(-0.5).cwiseMin(0.5);  // [N m] in a millisecond
    franka::Torques torques(std::array<double, 7>{});
    Eigen::Map<Vector7>(torques.tau_J.data()) = last_;
    return torques;
  }

 private:
  Vector7 last_ = Vector7::Zero();
};

/// Springs and dampers at the joints, from the pose in which the loop begins.
class JointHold {
 public:
  JointHold(const franka::Model& model, const franka::RobotState& begin)
      : model_(model), held_(Eigen::Map<const Vector7>(begin.q.data())) {}

  franka::Torques operator()(const franka::RobotState& state, franka::Duration, bool) {
    const Vector7 stiffness = (Vector7() << 600, 600, 600, 600, 100, 100, 50).finished();  // [N m/rad]
    const Vector7 damping = (Vector7() << 40, 40, 40, 40, 4, 4, 1).finished();             // [N m s/rad]
    const std::array<double, 7> coriolis = model_.coriolis(state);
    return limited_(stiffness.cwiseProduct(held_ - Eigen::Map<const Vector7>(state.q.data())) -
                    damping.cwiseProduct(Eigen::Map<const Vector7>(state.dq.data())) +
                    Eigen::Map<const Vector7>(coriolis.data()));
  }

 private:
  const franka::Model& model_;
  Vector7 held_;
  HalfTheRate limited_;
};

/// A soft hand: springs of 150 N/m and 10 N m/rad between it and a pose, critically damped for 1 kg and 1 kg m^2. The
/// pose may go round a vertical circle, once in four seconds, and tilt to both sides meanwhile.
class SoftHand {
 public:
  /// @param radius  of the circle [m]; 0: the pose in which the loop begins
  SoftHand(const franka::Model& model, const franka::RobotState& begin, double radius)
      : model_(model), held_(pose_of(begin)), radius_(radius) {}

  /// @param halt  slows the circle down to rest
  franka::Torques operator()(const franka::RobotState& state, franka::Duration period, bool halt) {
    using Vector3 = Eigen::Vector3d;
    const std::array<double, 42> columns = model_.zeroJacobian(franka::Frame::kEndEffector, state);
    const std::array<double, 7> coriolis = model_.coriolis(state);
    const Eigen::Map<const rme::Jacobian<double, 7>> jacobian(columns.data());
    const Eigen::Affine3d pose = pose_of(state);

    const double change = kSpeed / kStart * period.toSec();
    speed_ = halt ? std::max(0.0, speed_ - change) : std::min(kSpeed, speed_ + change);
    angle_ += speed_ * period.toSec();
    const Vector3 goal = held_.translation() + radius_ * Vector3(0, std::sin(angle_), std::cos(angle_) - 1);
    const Vector3 goal_velocity = radius_ * speed_ * Vector3(0, std::cos(angle_), -std::sin(angle_));
    const Eigen::AngleAxisd tilt(radius_ > 0 ? kTilt * std::sin(angle_) : 0, Vector3::UnitX());
    const Eigen::AngleAxisd turned(Eigen::Matrix3d(tilt * held_.linear() * pose.linear().transpose()));

    const rme::Vector6<double> twist = jacobian * Eigen::Map<const Vector7>(state.dq.data());
    rme::Vector6<double> wrench;
    wrench << 150 * (goal - pose.translation()) + 24.5 * (goal_velocity - twist.head<3>()),
        10 * turned.angle() * turned.axis() - 6.3 * twist.tail<3>();
    return limited_(jacobian.transpose() * wrench + Eigen::Map<const Vector7>(coriolis.data()));
  }

 private:
  static Eigen::Affine3d pose_of(const franka::RobotState& state) {
    return Eigen::Affine3d(Eigen::Map<const Eigen::Matrix4d>(state.O_T_EE.data()));
  }

  static constexpr double kSpeed = 1.5708;  // of the angle on the circle [rad/s]
  static constexpr double kStart = 2;       // how long it takes to rise [s]
  static constexpr double kTilt = 0.5;      // [rad]
  const franka::Model& model_;
  Eigen::Affine3d held_;
  double radius_, speed_ = 0, angle_ = 0;
  HalfTheRate limited_;
};

}  // namespace hosts
