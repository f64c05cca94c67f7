#pragma once
// As much of the Kortex API's messages as its host uses, by their names and signatures.
#include <cstdint>
#include <stdexcept>
#include <vector>

namespace Kinova::Api::BaseCyclic {

class ActuatorFeedback {
 public:
  float position() const { return position_; }  // [deg], 0 to 360
  void set_position(float value) { position_ = value; }
  float velocity() const { return velocity_; }  // [deg/s]
  void set_velocity(float value) { velocity_ = value; }
  float torque() const { return torque_; }  // [N m]
  void set_torque(float value) { torque_ = value; }

 private:
  float position_ = 0, velocity_ = 0, torque_ = 0;
};

class ActuatorCommand {
 public:
  std::uint32_t command_id() const { return command_id_; }
  void set_command_id(std::uint32_t value) { command_id_ = value; }
  float position() const { return position_; }
  void set_position(float value) { position_ = value; }
  float torque_joint() const { return torque_joint_; }
  void set_torque_joint(float value) { torque_joint_ = value; }

 private:
  std::uint32_t command_id_ = 0;
  float position_ = 0, torque_joint_ = 0;
};

class Feedback {
 public:
  int actuators_size() const { return static_cast<int>(actuators_.size()); }
  const ActuatorFeedback& actuators(int index) const { return actuators_.at(static_cast<std::size_t>(index)); }
  ActuatorFeedback* mutable_actuators(int index) { return &actuators_.at(static_cast<std::size_t>(index)); }
  ActuatorFeedback* add_actuators() { return &actuators_.emplace_back(); }

 private:
  std::vector<ActuatorFeedback> actuators_;
};

class Command {
 public:
  std::uint32_t frame_id() const { return frame_id_; }
  void set_frame_id(std::uint32_t value) { frame_id_ = value; }
  int actuators_size() const { return static_cast<int>(actuators_.size()); }
  const ActuatorCommand& actuators(int index) const { return actuators_.at(static_cast<std::size_t>(index)); }
  ActuatorCommand* mutable_actuators(int index) { return &actuators_.at(static_cast<std::size_t>(index)); }
  ActuatorCommand* add_actuators() { return &actuators_.emplace_back(); }

 private:
  std::uint32_t frame_id_ = 0;
  std::vector<ActuatorCommand> actuators_;
};

}  // namespace Kinova::Api::BaseCyclic
