#pragma once
/// A passive impedance law that holds a pose, or follows one: what the host's own controller may look like.
#include <Eigen/Cholesky>
#include <Eigen/Geometry>
#include <synthetic_arm/arm_model.hpp>

namespace rme::examples {

/// Gains of PoseImpedance. Towards the target the translation is as stiff as lambda1 rate = 180 N/m.
struct PoseImpedanceConfig {
  double rate = 3;                 ///< of the linear dynamical system f(x) = -rate (x - x*) [1/s]
  double lambda1 = 60;             ///< damping along f(x) [N s/m]
  double lambda2 = 80;             ///< damping across f(x) [N s/m]
  double direction_speed = 1e-3;   ///< |f(x)| at which lambda1 is half faded in [m/s]; f has no direction at x*
  double rotation_stiffness = 20;  ///< K_r [N m/rad]
  double rotation_damping = 2;     ///< D_r [N m s/rad]
  double posture_stiffness = 4;    ///< K_n, half of it for the last three joints [N m/rad]
  double posture_damping = 1;      ///< D_n, half of it for the last three joints [N m s/rad]
};

/// Where the flange is to be, and how it is to move there, world axes.
struct PoseTarget {
  Eigen::Vector3d position;                                    ///< [m]
  Eigen::Matrix3d rotation;                                    ///< flange axes to world axes
  Eigen::Vector3d velocity = Eigen::Vector3d::Zero();          ///< [m/s]
  Eigen::Vector3d angular_velocity = Eigen::Vector3d::Zero();  ///< [rad/s]
};

/// tau = J^T [ -D(x) (xdot - xdot* - f(x)) ; K_r e - D_r (omega - omega*) ] + N (K_n (q* - q) - D_n dq) + C dq + g
///
/// D has the eigenvalue lambda1 along f(x) and lambda2 across it; e is the angle axis of R* R^T in world axes;
/// N = 1 - J^T (J M^-1 J^T)^-1 J M^-1 lets the posture torque accelerate the elbow but not the flange. C dq and g are
/// the nominal model's: what a payload adds is not in it.
template <int Dofs>
class PoseImpedance {
 public:
  using Vector = JointVector<double, Dofs>;

  /// Holds the pose and the posture of `q`.
  PoseImpedance(const ArmModel<Dofs>& model, const Vector& q, const PoseImpedanceConfig& config = {})
      : config_(config), target_(at(model.kinematics(q))), posture_(q) {
    joint_weight_.template tail<3>().setConstant(0.5);
  }

  /// Another pose from now on, or the next point of a path. The posture stays.
  void follow(const PoseTarget& target) noexcept { target_ = target; }

  /// Joint torque for this tick [N m].
  /// @param at       flange pose and Jacobian at q
  /// @param nominal  dynamics at q and dq, without payload
  Vector torque(const Vector& q, const Vector& dq, const Kinematics<Dofs>& at,
                const Dynamics<Dofs>& nominal) const noexcept;

  /// Where the flange is, seen from where it should be, world axes [m].
  Eigen::Vector3d position_error(const Kinematics<Dofs>& at) const noexcept { return at.position - target_.position; }

 private:
  static PoseTarget at(const Kinematics<Dofs>& pose) { return {pose.position, pose.rotation}; }

  PoseImpedanceConfig config_;
  PoseTarget target_;
  Vector posture_;
  Vector joint_weight_ = Vector::Ones();
};

template <int Dofs>
auto PoseImpedance<Dofs>::torque(const Vector& q, const Vector& dq, const Kinematics<Dofs>& at,
                                 const Dynamics<Dofs>& nominal) const noexcept -> Vector {
  const Vector6<double> twist = at.jacobian * dq;
  const Eigen::Vector3d f = -config_.rate * position_error(at), slip = twist.head<3>() - target_.velocity - f;
  const Eigen::Vector3d e1 = f.stableNormalized();
  const double fade = f.norm() / (f.norm() + config_.direction_speed);
  Vector6<double> wrench;
  wrench.head<3>() = -config_.lambda2 * slip - fade * (config_.lambda1 - config_.lambda2) * e1.dot(slip) * e1;
  const Eigen::AngleAxisd turn(target_.rotation * at.rotation.transpose());
  wrench.tail<3>() = config_.rotation_stiffness * turn.angle() * turn.axis() -
                     config_.rotation_damping * (twist.tail<3>() - target_.angular_velocity);

  const Vector posture =
      joint_weight_.cwiseProduct(config_.posture_stiffness * (posture_ - q) - config_.posture_damping * dq);
  const Eigen::Matrix<double, Dofs, 6> MJ = nominal.mass_matrix.llt().solve(at.jacobian.transpose());
  // The flange's inverse inertia; the small term [1/kg, 1/(kg m^2)] keeps its inverse defined at a singular pose.
  const Matrix6<double> mobility = at.jacobian * MJ + 1e-9 * Matrix6<double>::Identity();
  wrench -= mobility.ldlt().solve(MJ.transpose() * posture);
  return at.jacobian.transpose() * wrench + posture + nominal.coriolis + nominal.gravity;
}

extern template class PoseImpedance<7>;

}  // namespace rme::examples
