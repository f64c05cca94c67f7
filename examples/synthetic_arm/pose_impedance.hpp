#pragma once
/// A passive impedance law that holds a pose: what the host's own controller may look like.
#include <Eigen/Geometry>
#include <synthetic_arm/arm_model.hpp>

namespace rme::examples {

/// Gains of PoseImpedance. Along the way to the target the translation is as stiff as lambda1 rate = 180 N/m.
struct PoseImpedanceConfig {
  double rate = 3;                 ///< of the linear dynamical system f(x) = -rate (x - x*) [1/s]
  double lambda1 = 60;             ///< damping along f(x) [N s/m]
  double lambda2 = 80;             ///< damping across f(x) [N s/m]
  double rotation_stiffness = 20;  ///< [N m/rad]
  double rotation_damping = 2;     ///< [N m s/rad]
  double posture_stiffness = 4;    ///< null space [N m/rad]
  double posture_damping = 1;      ///< null space [N m s/rad]
};

/// tau = J^T [ -D(x) (xdot - f(x)) ; K_r e - D_r omega ] + N (K_n (q* - q) - D_n dq) + C dq + g
///
/// D = lambda1 e1 e1^T + lambda2 (1 - e1 e1^T) with e1 along f(x); e = angle axis of R* R^T in world axes, N the
/// projector onto torques that make no wrench. C dq and g are the nominal model's: what the payload adds is not in it.
template <int Dofs>
class PoseImpedance {
 public:
  using Vector = JointVector<double, Dofs>;

  /// Holds the pose and the posture of `q`.
  PoseImpedance(const ArmModel<Dofs>& model, const Vector& q, const PoseImpedanceConfig& config = {})
      : config_(config), target_(model.kinematics(q)), posture_(q) {}

  /// Joint torque for now [N m].
  Vector torque(const Vector& q, const Vector& dq, const Kinematics<Dofs>& at, const Dynamics<Dofs>& nominal) const;

  /// How far the flange is from where it should be, world axes [m].
  Eigen::Vector3d position_error(const Kinematics<Dofs>& at) const { return at.position - target_.position; }

 private:
  PoseImpedanceConfig config_;
  Kinematics<Dofs> target_;
  Vector posture_;
};

template <int Dofs>
auto PoseImpedance<Dofs>::torque(const Vector& q, const Vector& dq, const Kinematics<Dofs>& at,
                                 const Dynamics<Dofs>& nominal) const -> Vector {
  const Vector6<double> twist = at.jacobian * dq;
  const Eigen::Vector3d f = -config_.rate * position_error(at), slip = twist.head<3>() - f;
  // At the target f has no direction; D f vanishes there whatever the direction, and damping is then lambda2 all round.
  const Eigen::Vector3d e1 = f.stableNormalized();
  Vector6<double> wrench;
  wrench.head<3>() = -config_.lambda2 * slip - (config_.lambda1 - config_.lambda2) * e1.dot(slip) * e1;
  const Eigen::AngleAxisd turn(target_.rotation * at.rotation.transpose());
  wrench.tail<3>() =
      config_.rotation_stiffness * turn.angle() * turn.axis() - config_.rotation_damping * twist.tail<3>();

  const Vector posture = config_.posture_stiffness * (posture_ - q) - config_.posture_damping * dq;
  // N = 1 - J^T (J J^T)^-1 J; the small term keeps it defined at a singular pose.
  const Matrix6<double> JJt = at.jacobian * at.jacobian.transpose() + 1e-9 * Matrix6<double>::Identity();
  return at.jacobian.transpose() * (wrench - JJt.ldlt().solve(at.jacobian * posture)) + posture + nominal.coriolis +
         nominal.gravity;
}

}  // namespace rme::examples
