#pragma once
#include <chrono>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>

#include "ur_client_library/rtde/data_package.h"
#include "ur_client_library/types.h"

namespace urcl {

namespace comm {
enum class ControlMode : std::int32_t { MODE_IDLE = 0, MODE_SERVOJ = 1, MODE_SPEEDJ = 2, MODE_TORQUE = 8 };
}  // namespace comm

class RobotReceiveTimeout {
 public:
  static RobotReceiveTimeout millisec(const unsigned int milliseconds = 20) {
    return RobotReceiveTimeout(milliseconds);
  }
  const std::chrono::milliseconds timeout_;

 private:
  explicit RobotReceiveTimeout(unsigned int milliseconds) : timeout_(milliseconds) {}
};

/// The robot behind it is the one that a test hands in.
class UrDriver {
 public:
  struct Simulation {
    std::function<void(rtde_interface::DataPackage&)> read;
    std::function<void(const vector6d_t&)> command;
    /// @return whether it was written
    std::function<bool(double, const vector3d_t&, const vector6d_t&, double)> set_payload;
  };
  explicit UrDriver(Simulation simulation) : simulation_(std::move(simulation)) {}

  bool getDataPackage(rtde_interface::DataPackage& data_package) {
    simulation_.read(data_package);
    return true;
  }
  bool writeJointCommand(const vector6d_t& values, const comm::ControlMode control_mode,
                         const RobotReceiveTimeout& robot_receive_timeout = RobotReceiveTimeout::millisec(20)) {
    if (robot_receive_timeout.timeout_ > std::chrono::seconds(1)) throw std::invalid_argument("timeout above 1 s");
    if (control_mode != comm::ControlMode::MODE_TORQUE) throw std::invalid_argument("torque mode only here");
    for (const double value : values)
      if (!std::isfinite(value)) throw std::invalid_argument("a torque is infinite or NaN");
    simulation_.command(values);
    return true;
  }
  bool setTargetPayload(const float mass, const vector3d_t& cog, const vector6d_t& inertia = {0, 0, 0, 0, 0, 0},
                        const double transition_time = 0.0) {
    for (const std::size_t i : {0u, 1u, 2u})
      if (inertia[i] < 0) throw std::invalid_argument("a moment of inertia is negative");
    return simulation_.set_payload(static_cast<double>(mass), cog, inertia, transition_time);
  }

 private:
  Simulation simulation_;
};

}  // namespace urcl
