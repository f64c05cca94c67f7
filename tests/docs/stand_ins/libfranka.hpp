#pragma once
// As much of libfranka as the snippets of docs/embedding.md use, by its names and signatures. The arm behind Robot is
// the one that a test hands in through `simulation`. What the robot refuses throws.
#include <array>
#include <cmath>
#include <cstdint>
#include <functional>
#include <stdexcept>
#include <synthetic_arm/panda.hpp>

namespace franka {

struct CommandException : std::runtime_error {
  using std::runtime_error::runtime_error;
};

class Duration {
 public:
  explicit Duration(std::uint64_t milliseconds) : milliseconds_(milliseconds) {}
  double toSec() const { return 1e-3 * static_cast<double>(milliseconds_); }

 private:
  std::uint64_t milliseconds_;
};

/// Poses are column-major.
struct RobotState {
  std::array<double, 16> O_T_EE{};
  std::array<double, 16> F_T_EE{};
  std::array<double, 7> q{};
  std::array<double, 7> dq{};
  std::array<double, 7> tau_ext_hat_filtered{};
};

struct Finishable {
  bool motion_finished = false;
};

class Torques : public Finishable {
 public:
  Torques(const std::array<double, 7>& torques) : tau_J(torques) {}
  std::array<double, 7> tau_J;
};

inline Torques MotionFinished(Torques command) {
  command.motion_finished = true;
  return command;
}

enum class Frame { kFlange, kEndEffector };

class Model {
 public:
  /// 6x7, column-major.
  std::array<double, 42> zeroJacobian(Frame frame, const RobotState& state) const {
    const auto at = rme::examples::panda().kinematics(Eigen::Map<const rme::JointVector<double, 7>>(state.q.data()));
    const auto F_T_EE = Eigen::Map<const rme::Matrix4<double>>(state.F_T_EE.data());
    std::array<double, 42> out;
    auto jacobian = Eigen::Map<rme::Jacobian<double, 7>>(out.data());
    jacobian = at.jacobian;
    if (frame == Frame::kEndEffector)  // v_EE = v_F + omega x (R p)
      jacobian.topRows<3>() -= rme::skew(at.rotation * F_T_EE.topRightCorner<3, 1>()) * at.jacobian.bottomRows<3>();
    return out;
  }
};

class Robot {
 public:
  struct Simulation {
    std::function<RobotState()> read;
    std::function<void(const Torques&)> command;
    std::function<void(double, const Eigen::Vector3d&, const Eigen::Matrix3d&)> set_load;
    std::function<std::uint64_t()> lost = [] { return std::uint64_t{0}; };  // packets, before this one
  };
  explicit Robot(const Simulation& simulation) : simulation_(simulation) {}

  void control(std::function<Torques(const RobotState&, Duration)> control_callback) {
    running_ = true;
    for (bool first = true;; first = false) {  // the first call's Duration is zero
      const std::uint64_t lost = simulation_.lost();
      const Torques torques = control_callback(simulation_.read(), Duration(first ? 0 : 1 + lost));
      for (const double tau : torques.tau_J)
        if (!std::isfinite(tau)) throw std::invalid_argument("Commanding value is infinite or NaN.");
      simulation_.command(torques);
      if (torques.motion_finished) break;
    }
    running_ = false;
  }
  /// @param F_x_Cload     centre of mass, flange axes [m]
  /// @param load_inertia  about the centre of mass, flange axes, column-major [kg m^2]
  void setLoad(double load_mass, const std::array<double, 3>& F_x_Cload, const std::array<double, 9>& load_inertia) {
    const Eigen::Map<const Eigen::Matrix3d> inertia(load_inertia.data());
    if (running_) throw CommandException("libfranka: set_load command rejected: command not possible in current mode");
    if (load_mass < 0 || !inertia.isApprox(inertia.transpose()) || !(inertia.determinant() >= 0))
      throw CommandException("libfranka: set_load command rejected: invalid argument");
    simulation_.set_load(load_mass, Eigen::Map<const Eigen::Vector3d>(F_x_Cload.data()), inertia);
  }

 private:
  Simulation simulation_;
  bool running_ = false;
};

}  // namespace franka
