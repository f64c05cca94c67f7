#pragma once
/// A ros2_control effort controller that carries an unknown payload.
#include <cmath>
#include <controller_interface/controller_interface.hpp>
#include <cstddef>
#include <exception>
#include <initializer_list>
#include <optional>
#include <pinocchio/parsers/urdf.hpp>
#include <rme/host/payload_compensation.hpp>
#include <rme/host/pinocchio.hpp>
#include <stdexcept>
#include <string>
#include <vector>

#include "hosts/ros2_control/versions.hpp"
#include "hosts/settings.hpp"

namespace hosts {

/// An effort controller whose nominal_torque() is what your update() computes today, gravity included. Parameters:
/// `joints`, names of the arm's Dofs joints from the base; `end_effector`, name of a frame; `rated_payload` [kg], or
/// `settings`, a file that check_arm wrote; `effort_lacks_gravity`, where `effort` is the torque less the model's gravity, as
/// a UR's can be; `gains` [N m/A], where the state interface `effort` is a motor current; and
/// `rotor_inertia` [kg m^2] and `load_friction`, where the settings have a "model".
template <int Dofs>
class PayloadController : public controller_interface::ControllerInterface {
 public:
  using Vector = rme::JointVector<double, Dofs>;
  using CallbackReturn = controller_interface::CallbackReturn;
  using return_type = controller_interface::return_type;

  CallbackReturn on_init() override {
    auto_declare<std::vector<std::string>>("joints", {});
    auto_declare<std::string>("end_effector", "");
    declare_robot_description(*this);
    auto_declare<double>("rated_payload", 0);
    auto_declare<bool>("effort_lacks_gravity", false);
    auto_declare<std::string>("settings", "");
    auto_declare<std::vector<double>>("gains", std::vector<double>(Dofs, 1));
    auto_declare<std::vector<double>>("rotor_inertia", std::vector<double>(Dofs, 0));
    auto_declare<std::vector<double>>("load_friction", std::vector<double>(Dofs, 0));
    return CallbackReturn::SUCCESS;
  }
  controller_interface::InterfaceConfiguration command_interface_configuration() const override {
    return interfaces({"effort"});
  }
  controller_interface::InterfaceConfiguration state_interface_configuration() const override {
    return interfaces({"position", "velocity", "effort"});
  }

  CallbackReturn on_configure(const rclcpp_lifecycle::State&) override {
    try {  // what is wrong with the model or the settings throws here
      joints_ = get_node()->get_parameter("joints").as_string_array();
      if (joints_.size() != Dofs) throw std::invalid_argument("joints: expected " + std::to_string(Dofs) + " names");
      const std::vector<double> gains = get_node()->get_parameter("gains").as_double_array();
      const std::vector<double> rotors = get_node()->get_parameter("rotor_inertia").as_double_array();
      const std::vector<double> friction = get_node()->get_parameter("load_friction").as_double_array();
      if (gains.size() != Dofs || rotors.size() != Dofs || friction.size() != Dofs)
        throw std::invalid_argument("gains, rotor_inertia, load_friction: expected " + std::to_string(Dofs) +
                                    " numbers each");
      const std::string settings = get_node()->get_parameter("settings").as_string();
      rme::EstimatorConfig<double, Dofs> config;
      if (!settings.empty()) config = read_settings<Dofs>(settings);
      effort_lacks_gravity_ = get_node()->get_parameter("effort_lacks_gravity").as_bool();
      const double rated_payload = get_node()->get_parameter("rated_payload").as_double();
      if (rated_payload > 0) config.rated_payload = rated_payload;
      if (settings.empty() && !(rated_payload > 0)) throw std::invalid_argument("rated_payload, or settings: missing");
      if (get_update_rate() == 0)
        throw std::invalid_argument("update_rate: 0; in Humble, set this controller's own parameter update_rate");
      // <snippet ros2_control>
      // In on_configure(); what is wrong with the model or the settings throws.
      const double period = 1.0 / get_update_rate();
      pinocchio::Model robot;
      pinocchio::urdf::buildModelFromXML(robot_description(*this), robot);
      sensing_.emplace(rme::pinocchio_arm(robot, joints_), get_node()->get_parameter("end_effector").as_string(),
                       period, config, Eigen::Map<const Vector>(gains.data()), Eigen::Map<const Vector>(rotors.data()),
                       Eigen::Map<const Vector>(friction.data()));
      payload_.emplace(period, config);
      // </snippet>
    } catch (const std::exception& error) {
      RCLCPP_ERROR(get_node()->get_logger(), "%s", error.what());
      return CallbackReturn::ERROR;
    }
    return CallbackReturn::SUCCESS;
  }

  CallbackReturn on_activate(const rclcpp_lifecycle::State&) override {
    // <snippet ros2_control>
    // In on_activate().
    sensing_->reset();
    payload_->reset();
    // </snippet>
    refused_ = 0;
    return CallbackReturn::SUCCESS;
  }

  return_type update(const rclcpp::Time&, const rclcpp::Duration& period) override {
    Vector q, dq, effort;
    auto state = state_interfaces_.cbegin();  // joint by joint, in the order of state_interface_configuration()
    for (int j = 0; j < Dofs; ++j)
      for (Vector* v : {&q, &dq, &effort}) (*v)[j] = read(*state++);
    if (effort_lacks_gravity_ && q.allFinite()) effort += sensing_->gravity(q);
    // <snippet ros2_control>
    // In update(), with what the state interfaces position, velocity and effort say.
    rme::Status status = sensing_->update(q, dq, effort, period.seconds(), sample_);
    if (status == rme::Status::Ok) status = payload_->update(sample_);
    const Vector command = nominal_torque(q, dq, sensing_->gravity()) + payload_->torque();
    // </snippet>
    bool commanded = false;
    if (status == rme::Status::Ok) {
      commanded = command.allFinite();
      for (int j = 0; commanded && j < Dofs; ++j)
        commanded = write(command_interfaces_[static_cast<std::size_t>(j)], command[j]);
    }
    refused_ = commanded ? 0 : refused_ + 1;  // the last command stays, for a few ticks
    return refused_ < 5 ? return_type::OK : return_type::ERROR;
  }

 protected:
  /// @param gravity  of the arm with an empty hand, for a robot that does not add it by itself [N m]
  virtual Vector nominal_torque(const Vector& q, const Vector& dq, const Vector& gravity) = 0;
  rme::PayloadCompensation<double, Dofs>& payload() { return *payload_; }

 private:
  controller_interface::InterfaceConfiguration interfaces(std::initializer_list<const char*> names) const {
    controller_interface::InterfaceConfiguration out{controller_interface::interface_configuration_type::INDIVIDUAL,
                                                     {}};
    for (const std::string& joint : joints_)
      for (const char* name : names) out.names.push_back(joint + "/" + name);
    return out;
  }

  std::vector<std::string> joints_;
  // <snippet ros2_control>
  // Members.
  std::optional<rme::PinocchioSensing<Dofs>> sensing_;
  std::optional<rme::PayloadCompensation<double, Dofs>> payload_;
  rme::Proprioception<double, Dofs> sample_;
  // </snippet>
  bool effort_lacks_gravity_ = false;
  int refused_ = 0;  // ticks in a row without a command
};

}  // namespace hosts
