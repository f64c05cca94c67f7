#pragma once
/// What a host's 1 kHz loop looks like when rme is the controller: dynamical systems, passive law, barriers, CPIC and
/// compensation. Shared by the example programs.
#include <algorithm>
#include <cmath>
#include <optional>
#include <rme/control/barriers.hpp>
#include <rme/control/cpic.hpp>
#include <rme/control/energy_tank.hpp>
#include <rme/control/limit_cycle.hpp>
#include <rme/control/linear_attractor.hpp>
#include <rme/control/orientation_attractor.hpp>
#include <rme/control/passive_controller.hpp>
#include <rme/control/posture.hpp>
#include <rme/control/prediction_error.hpp>
#include <rme/core/compensation.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

namespace rme::examples {

/// A plane that the flange must not cross: n.x >= offset.
struct Wall {
  Eigen::Vector3d normal;  // n, of unit length, world axes
  double offset;           // [m]
};

/// A push like a person's: the force rises, stays, and falls.
struct Push {
  double start = 0, rise = 0.15, hold = 0;          // [s]; it falls in the same time as it rises
  Eigen::Vector3d force = Eigen::Vector3d::Zero();  // the largest [N], world axes

  Eigen::Vector3d at(double t) const {
    const double s = t - start;
    return std::clamp(std::min(s, 2 * rise + hold - s) / rise, 0.0, 1.0) * force;
  }
};

/// Which torque beside tau the host's bias contains.
enum class Prediction {
  Nominal,   ///< only the nominal model's, as published: the compensation is added afterwards and taken to be right
  Observer,  ///< also the compensation, and all that a fast observer sees
};

struct HostConfig {
  double period = 1e-3;     // [s]
  bool constrained = true;  // false: CPIC without rows, with the torque limits only
  // How far inside the mechanical limits the barriers are [rad], since an unknown torque may push a joint beyond them.
  double margin = 0.005;
  bool sampled = false;  // rows for sampled time, tightened by the error of the prediction that was seen
  Prediction prediction = Prediction::Observer;
  std::optional<EnergyTankConfig> tank;  // pays for the compensation, with the payload of set_payload()
  std::optional<Wall> wall;              // by default a soft row: the arm's own limits have priority
  double wall_weight = 1e3;              // infinite: hard
  Eigen::Vector3d target;                // of the linear attractor, or the centre of the cycle [m]
  std::optional<double> cycle_radius;    // [m]; if set, a limit cycle in the y-z plane replaces the attractor
  Eigen::Quaterniond orientation;        // target
  JointVector<double, 7> posture;        // rest pose of the posture torque [rad]

  /// The settings for holding the pose of `q`.
  static HostConfig hold(const ArmModel<7>& model, const JointVector<double, 7>& q) {
    const Kinematics<7> at = model.kinematics(q);
    HostConfig config;
    config.target = at.position;
    config.orientation = Eigen::Quaterniond(at.rotation);
    config.posture = q;
    return config;
  }
};

/// The controller. Everything that may throw happens in the constructor.
class Host {
 public:
  using Vector = JointVector<double, 7>;

  Host(const ArmModel<7>& model, const HostConfig& config);

  /// One tick.
  /// @param compensation  torque that carries the payload [N m]; a CompensationRamp limits its rate
  /// @return the torque to command [N m], gravity included
  const Vector& update(const SyntheticArm<7>& arm, const Vector& compensation) noexcept {
    return update(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics(), compensation);
  }
  /// The same with what an arm reports.
  /// @param dynamics  nominal: the payload is not in it
  const Vector& update(const Vector& q, const Vector& dq, const Kinematics<7>& kinematics, const Dynamics<7>& dynamics,
                       const Vector& compensation) noexcept;
  /// Another pose from now on, for the attractors; a cycle and the tank stay where they are. Not for a control thread:
  /// throws if a number is not finite.
  void follow(const Eigen::Vector3d& position, const Eigen::Quaterniond& orientation);

  /// Sets the estimate of the payload, for the tank's potential. Until the first call, the hand is empty.
  void set_payload(const Payload<double>& payload) noexcept { payload_ = payload; }

  /// Of the last update. Infeasible and NotConverged come with a new torque; every other failure repeats the last
  /// torque.
  Status status() const noexcept { return status_; }
  const Cpic<double, 7, 8>& cpic() const noexcept { return cpic_; }
  const PassiveController<double>& passive() const noexcept { return passive_; }
  /// The torque that the last update returned [N m].
  const Vector& torque() const noexcept { return torque_; }
  /// The compensation in the command [N m], after ramp and tank.
  const Vector& compensation() const noexcept { return compensation_; }
  /// The tank's share, 0 to 1, by which the compensation is multiplied; 1 without a tank.
  double tank_share() const noexcept { return tank_ ? tank_->share() : 1; }

 private:
  /// Updates CPIC with rows that are tightened by this error of the prediction.
  Status solve(const CpicInput<double, 7>& input, const Vector& q, const Vector& dq,
               const AccelerationError<double, 7>& error) noexcept;
  void track_flange(const Kinematics<7>& kinematics, const Twist<double>& twist, const Vector& dq) noexcept;

  HostConfig config_;
  LinearAttractor<double> attractor_;
  LimitCycle<double> cycle_;
  OrientationAttractor<double> orientation_;
  PassiveController<double> passive_;
  Posture<double, 7> posture_;
  JointLimits<double, 7> limits_;
  BarrierPoles<double> wall_poles_;
  Cpic<double, 7, 8> cpic_;
  CompensationRamp<double, 7> ramp_;
  std::optional<EnergyTank<double, 7>> tank_;
  Vector compensation_ = Vector::Zero();
  PredictionErrorWatch<double, 7> prediction_;
  PointMotion<double, 7> flange_;
  Payload<double> payload_;
  MomentumObserver<double, 7> disturbance_;
  Vector limit_;  // of the torques [N m]
  ConstraintRows<double, 7, 8> rows_;
  Eigen::Matrix<double, 3, 7> last_ = Eigen::Matrix<double, 3, 7>::Zero();
  bool started_ = false;
  Vector torque_ = Vector::Zero();
  Status status_ = Status::Ok;
};

}  // namespace rme::examples
