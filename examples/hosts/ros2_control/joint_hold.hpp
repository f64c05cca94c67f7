#pragma once
/// A plugin for ros2_control: holds the pose that the arm had at activation, and carries what it is handed.
#include <chrono>
#include <mutex>
#include <rclcpp/rclcpp.hpp>
#include <rme/host/payload_changes.hpp>

#include "hosts/ros2_control/payload_controller.hpp"

namespace hosts {

/// A spring and a damper at each joint, plus the gravity torque of model and payload. Parameters, in addition to those
/// of PayloadController: `stiffness` [N m/rad] and `damping` [N m s/rad], one number per joint; `robot_adds_gravity`:
/// the robot adds the gravity torque of its own model, and this controller does not.
template <int Dofs>
class JointHold : public PayloadController<Dofs> {
  using Base = PayloadController<Dofs>;

 public:
  using typename Base::CallbackReturn;
  using typename Base::return_type;
  using typename Base::Vector;

  CallbackReturn on_init() override {
    this->template auto_declare<std::vector<double>>("stiffness", std::vector<double>(Dofs, 100));
    this->template auto_declare<std::vector<double>>("damping", std::vector<double>(Dofs, 10));
    this->template auto_declare<bool>("robot_adds_gravity", false);
    return Base::on_init();
  }

  CallbackReturn on_configure(const rclcpp_lifecycle::State& previous) override {
    const auto node = this->get_node();
    const std::vector<double> stiffness = node->get_parameter("stiffness").as_double_array();
    const std::vector<double> damping = node->get_parameter("damping").as_double_array();
    if (stiffness.size() != Dofs || damping.size() != Dofs) {
      RCLCPP_ERROR(node->get_logger(), "stiffness, damping: expected %d numbers each", Dofs);
      return CallbackReturn::ERROR;
    }
    stiffness_ = Eigen::Map<const Vector>(stiffness.data());
    damping_ = Eigen::Map<const Vector>(damping.data());
    robot_adds_gravity_ = node->get_parameter("robot_adds_gravity").as_bool();
    // The node's executor runs report(), outside the control loop.
    report_ = node->create_wall_timer(std::chrono::milliseconds(200), [this] { report(); });
    return Base::on_configure(previous);
  }

  CallbackReturn on_activate(const rclcpp_lifecycle::State& previous) override {
    holding_ = false;
    return Base::on_activate(previous);
  }

  return_type update(const rclcpp::Time& time, const rclcpp::Duration& period) override {
    const return_type result = Base::update(time, period);
    // The control loop must not wait: if report() is reading, this state is left out.
    if (const std::unique_lock<std::mutex> lock(mutex_, std::try_to_lock); lock) state_ = this->payload().state();
    return result;
  }

 protected:
  Vector nominal_torque(const Vector& q, const Vector& dq, const Vector& gravity) override {
    if (!holding_) held_ = q;
    holding_ = true;
    const Vector torque = stiffness_.cwiseProduct(held_ - q) - damping_.cwiseProduct(dq);
    return robot_adds_gravity_ ? torque : Vector(torque + gravity);
  }

 private:
  /// Writes a line to the log when the payload may have changed, and while health is above 10.
  void report() {
    const rme::EstimatorState<double> state = [this] {
      const std::lock_guard<std::mutex> lock(mutex_);
      return state_;
    }();
    const auto logger = this->get_node()->get_logger();
    if (changes_.since_last(state))
      RCLCPP_INFO(logger, "payload: %.3f +- %.3f kg", state.payload.mean[0], state.payload.standard_deviation()[0]);
    if (state.health > 10)
      RCLCPP_WARN(logger, "the arm does not do what its model and the payload say: health %.0f", state.health);
  }

  Vector stiffness_, damping_, held_;
  bool holding_ = false, robot_adds_gravity_ = false;
  rclcpp::TimerBase::SharedPtr report_;
  std::mutex mutex_;
  rme::EstimatorState<double> state_;  // a copy for report(); under mutex_
  rme::PayloadChanges changes_;
};

using JointHold6 = JointHold<6>;
using JointHold7 = JointHold<7>;

}  // namespace hosts
