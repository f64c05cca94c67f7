#pragma once
// As much of libfranka as the hosts use, by its names and signatures. The arm behind Robot is the one that a test hands
// in as a Simulation, or under an address. What the robot refuses throws, as it does there.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <functional>
#include <initializer_list>
#include <map>
#include <memory>
#include <stdexcept>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <utility>

#include "franka/exception.h"

namespace franka {

class Duration {
 public:
  Duration() noexcept : milliseconds_(0) {}
  explicit Duration(std::uint64_t milliseconds) noexcept : milliseconds_(milliseconds) {}
  double toSec() const noexcept { return 1e-3 * static_cast<double>(milliseconds_); }
  std::uint64_t toMSec() const noexcept { return milliseconds_; }

 private:
  std::uint64_t milliseconds_;
};

/// Matrices are column-major.
struct RobotState {
  std::array<double, 16> O_T_EE{};
  std::array<double, 16> F_T_EE{};
  double m_load{};
  std::array<double, 9> I_load{};
  std::array<double, 3> F_x_Cload{};
  double m_total{};
  std::array<double, 3> F_x_Ctotal{};
  std::array<double, 7> q{};
  std::array<double, 7> dq{};
  std::array<double, 7> tau_ext_hat_filtered{};
};

struct Finishable {
  bool motion_finished = false;
};

class Torques : public Finishable {
 public:
  Torques(const std::array<double, 7>& torques) noexcept : tau_J(torques) {}
  Torques(std::initializer_list<double> torques) {
    if (torques.size() != tau_J.size()) throw std::invalid_argument("wrong number of torques");
    std::copy(torques.begin(), torques.end(), tau_J.begin());
  }
  std::array<double, 7> tau_J{};
};

inline Torques MotionFinished(Torques command) noexcept {
  command.motion_finished = true;
  return command;
}

enum class RealtimeConfig { kEnforce, kIgnore };
constexpr double kDefaultCutoffFrequency = 100;

class Model;

class Robot {
 public:
  struct Simulation {
    std::function<RobotState()> read;
    std::function<void(const Torques&)> command;
    std::function<void(double, const Eigen::Vector3d&, const Eigen::Matrix3d&)> set_load;
    std::function<std::uint64_t()> lost = [] { return std::uint64_t{0}; };  // packets, before this one
  };
  static std::map<std::string, Simulation>& simulations() {  // by address
    static std::map<std::string, Simulation> all;
    return all;
  }

  explicit Robot(const Simulation& simulation) : simulation_(std::make_unique<Simulation>(simulation)) {}
  explicit Robot(const std::string& franka_address, RealtimeConfig = RealtimeConfig::kEnforce, std::size_t = 50) {
    const auto found = simulations().find(franka_address);
    if (found == simulations().end()) throw NetworkException("no robot at " + franka_address);
    simulation_ = std::make_unique<Simulation>(found->second);
  }
  Robot(Robot&&) noexcept = default;
  Robot& operator=(Robot&&) noexcept = default;
  virtual ~Robot() noexcept = default;

  /// Throws what the callback throws, and for what the robot stops at.
  void control(std::function<Torques(const RobotState&, Duration)> control_callback, bool /*limit_rate*/ = false,
               double /*cutoff_frequency*/ = kDefaultCutoffFrequency) {
    require_idle();
    const Running running(running_);
    std::array<double, 7> last{};              // a motion begins at zero torque
    for (bool first = true;; first = false) {  // and the first call's Duration is zero
      const std::uint64_t lost = simulation_->lost();
      const Torques torques = control_callback(simulation_->read(), Duration(first ? 0 : 1 + lost));
      for (std::size_t j = 0; j < 7; ++j) {
        if (!std::isfinite(torques.tau_J[j])) throw std::invalid_argument("a commanded torque is infinite or NaN");
        if (std::abs(torques.tau_J[j] - last[j]) > kTorqueStep * static_cast<double>(1 + lost))
          throw ControlException("controller_torque_discontinuity at joint " + std::to_string(j + 1));
      }
      last = torques.tau_J;
      simulation_->command(torques);
      if (torques.motion_finished) return;
    }
  }
  virtual RobotState readOnce() {
    require_idle();
    return simulation_->read();
  }
  void setCollisionBehavior(const std::array<double, 7>& lower_torque_thresholds,
                            const std::array<double, 7>& upper_torque_thresholds,
                            const std::array<double, 6>& lower_force_thresholds,
                            const std::array<double, 6>& upper_force_thresholds) {
    for (std::size_t j = 0; j < 7; ++j) require_ordered(lower_torque_thresholds[j], upper_torque_thresholds[j]);
    for (std::size_t j = 0; j < 6; ++j) require_ordered(lower_force_thresholds[j], upper_force_thresholds[j]);
  }
  /// @param F_x_Cload     centre of mass, flange axes [m]
  /// @param load_inertia  about the centre of mass, flange axes, column-major [kg m^2]
  void setLoad(double load_mass, const std::array<double, 3>& F_x_Cload, const std::array<double, 9>& load_inertia) {
    const Eigen::Map<const Eigen::Matrix3d> inertia(load_inertia.data());
    if (running_) throw CommandException("set_load: not possible in this mode");
    if (!(load_mass >= 0) || !inertia.isApprox(inertia.transpose()) || !(inertia.determinant() >= 0))
      throw CommandException("set_load: invalid argument");
    simulation_->set_load(load_mass, Eigen::Map<const Eigen::Vector3d>(F_x_Cload.data()), inertia);
  }
  Model loadModel();

 private:
  static constexpr double kTorqueStep = 1;  // [N m] in a millisecond
  struct Running {
    explicit Running(bool& flag) : flag_(flag) { flag_ = true; }
    ~Running() { flag_ = false; }
    bool& flag_;
  };
  void require_idle() const {
    if (running_) throw InvalidOperationException("another control or read operation is running");
  }
  static void require_ordered(double lower, double upper) {
    if (!(lower > 0 && lower <= upper)) throw CommandException("set_collision_behavior: invalid argument");
  }

  std::unique_ptr<Simulation> simulation_;
  bool running_ = false;
};

}  // namespace franka
