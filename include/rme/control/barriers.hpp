#pragma once
/// Exponential control barrier functions: where the arm may go, written as rows on its joint accelerations.
#include <algorithm>
#include <rme/control/constraint_rows.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// The gains of a barrier as the poles of h'' + k_2 h' + k_1 h = 0: k_1 = p_1 p_2, k_2 = p_1 + p_2. Two real, stable
/// poles are what the guarantee needs: from h >= 0 and h' >= -p h for one of the poles, h never becomes negative. The
/// slower pole says how early the arm brakes: from speed v at a distance of v / p, decelerating with p v at most.
template <typename Scalar>
class BarrierPoles {
 public:
  /// @param first, second  p_1, p_2 > 0 [1/s]
  /// @throws std::invalid_argument for a pole that is not stable
  BarrierPoles(Scalar first, Scalar second) : k1(first * second), k2(first + second) {
    detail::require_positive(first, "BarrierPoles::first", "> 0 1/s (a stable pole)");
    detail::require_positive(second, "BarrierPoles::second", "> 0 1/s (a stable pole)");
  }
  Scalar k1;  ///< [1/s^2]
  Scalar k2;  ///< [1/s]
};

/// A barrier h(q) >= 0 at the present state: what a host's own barrier has to provide.
template <typename Scalar, int Dofs>
struct BarrierValue {
  Scalar h;                            ///< in any unit u; negative means violated
  JointVector<Scalar, Dofs> gradient;  ///< grad_q h [u/rad]
  Scalar curvature;                    ///< dq^T hess_q h dq [u/s^2]
};

/// Appends grad_h^T ddq >= -k_1 h - k_2 grad_h^T dq - dq^T hess_h dq [RME, Eq. 19, 20].
/// @param weight  of a soft barrier; a miss of the row by s [u/s^2] costs weight * s^2
/// @return see ConstraintRows::add
template <typename Scalar, int Dofs, int MaxRows>
Status add_barrier(const BarrierValue<Scalar, Dofs>& barrier, const JointVector<Scalar, Dofs>& dq,
                   const BarrierPoles<Scalar>& poles, ConstraintRows<Scalar, Dofs, MaxRows>& rows,
                   Scalar weight = ConstraintRows<Scalar, Dofs, MaxRows>::kHard) noexcept {
  const Scalar bound = -poles.k1 * barrier.h - poles.k2 * barrier.gradient.dot(dq) - barrier.curvature;
  return rows.add(barrier.gradient, bound, rows.kFree, weight);
}

/// A point of the arm in motion, world axes.
template <typename Scalar, int Dofs>
struct PointMotion {
  Vector3<Scalar> position;                 ///< x [m]
  Vector3<Scalar> velocity;                 ///< xdot = J_v dq [m/s]
  Eigen::Matrix<Scalar, 3, Dofs> jacobian;  ///< J_v; for the end-effector origin the top three rows of J
  Vector3<Scalar> velocity_product;         ///< Jdot_v dq [m/s^2], the acceleration of the point at ddq = 0
};

/// Keeps a point on the side of a plane to which `normal` points: h = n.x - offset [m].
/// @param normal  n, of unit length
template <typename Scalar, int Dofs>
BarrierValue<Scalar, Dofs> half_space(const PointMotion<Scalar, Dofs>& point, const Vector3<Scalar>& normal,
                                      Scalar offset) noexcept {
  return {normal.dot(point.position) - offset, point.jacobian.transpose() * normal, normal.dot(point.velocity_product)};
}

/// The side of a sphere on which a point has to stay.
enum class SphereSide { Outside, Inside };

/// Keeps a point outside or inside a sphere: h = +-(|x - c|^2 - r^2) / (2 r), which near the surface is the distance to
/// it [m] and, unlike the distance, is smooth at the centre.
/// @param radius  r [m], > 0
template <typename Scalar, int Dofs>
BarrierValue<Scalar, Dofs> sphere(const PointMotion<Scalar, Dofs>& point, const Vector3<Scalar>& center, Scalar radius,
                                  SphereSide side) noexcept {
  const Scalar sign = side == SphereSide::Outside ? Scalar(1) : Scalar(-1);
  const Vector3<Scalar> away = point.position - center;
  const Vector3<Scalar> gradient = sign / radius * away;  // by x
  return {sign * (away.squaredNorm() - radius * radius) / (2 * radius), point.jacobian.transpose() * gradient,
          sign / radius * point.velocity.squaredNorm() + gradient.dot(point.velocity_product)};
}

/// Settings of JointLimits.
template <typename Scalar, int Dofs>
struct JointLimitsConfig {
  JointVector<Scalar, Dofs> q_min, q_max;  ///< [rad], q_min < q_max
  /// |dq| [rad/s], > 0; infinite for none
  JointVector<Scalar, Dofs> velocity_limit =
      JointVector<Scalar, Dofs>::Constant(std::numeric_limits<Scalar>::infinity());
  BarrierPoles<Scalar> poles = {Scalar(8), Scalar(40)};     ///< of h = q - q_min and h = q_max - q
  Scalar velocity_pole = Scalar(40);                        ///< p > 0 [1/s]: ddq <= p (limit - dq)
  Scalar weight = std::numeric_limits<Scalar>::infinity();  ///< infinite: hard
};

/// The limits of all joints, positions and velocities, as one two-sided row on each joint's acceleration:
///
///     -k_1 (q - q_min) - k_2 dq <= ddq <= k_1 (q_max - q) - k_2 dq,      -p (dq_max + dq) <= ddq <= p (dq_max - dq)
///
/// The tighter bound of each side counts. Where the two pairs contradict each other, which takes a joint that is both
/// too fast and next to its limit, the position limit wins.
template <typename Scalar, int Dofs>
class JointLimits {
 public:
  /// @throws std::invalid_argument naming the field out of range
  explicit JointLimits(const JointLimitsConfig<Scalar, Dofs>& config);

  /// Appends Dofs rows, joint 0 first.
  /// @return Ok; NonFiniteInput, also for numbers beyond kLargestPlausible; CapacityExceeded: then none has been added
  template <int MaxRows>
  Status append(const JointVector<Scalar, Dofs>& q, const JointVector<Scalar, Dofs>& dq,
                ConstraintRows<Scalar, Dofs, MaxRows>& rows) const noexcept;

 private:
  JointLimitsConfig<Scalar, Dofs> config_;
};

template <typename Scalar, int Dofs>
JointLimits<Scalar, Dofs>::JointLimits(const JointLimitsConfig<Scalar, Dofs>& config) : config_(config) {
  for (int j = 0; j < Dofs; ++j) {
    detail::require(config.q_min[j] < config.q_max[j], "JointLimitsConfig::q_min", "< q_max", config.q_min[j]);
    detail::require(config.velocity_limit[j] > 0, "JointLimitsConfig::velocity_limit", "> 0 rad/s",
                    config.velocity_limit[j]);
  }
  detail::require_positive(config.velocity_pole, "JointLimitsConfig::velocity_pole", "> 0 1/s");
  detail::require(config.weight > 0, "JointLimitsConfig::weight", "> 0", config.weight);
}

template <typename Scalar, int Dofs>
template <int MaxRows>
Status JointLimits<Scalar, Dofs>::append(const JointVector<Scalar, Dofs>& q, const JointVector<Scalar, Dofs>& dq,
                                         ConstraintRows<Scalar, Dofs, MaxRows>& rows) const noexcept {
  if (!plausible(q) || !plausible(dq)) return Status::NonFiniteInput;
  if (rows.size() + Dofs > MaxRows) return Status::CapacityExceeded;
  const auto& [k1, k2] = config_.poles;
  for (int j = 0; j < Dofs; ++j) {
    const Scalar lower = -k1 * (q[j] - config_.q_min[j]) - k2 * dq[j];
    const Scalar upper = k1 * (config_.q_max[j] - q[j]) - k2 * dq[j];
    const Scalar slowest = -config_.velocity_pole * (config_.velocity_limit[j] + dq[j]);
    const Scalar fastest = config_.velocity_pole * (config_.velocity_limit[j] - dq[j]);
    // lower < upper and slowest < fastest always; each velocity bound is clamped into the position bounds.
    const Status status = rows.add_axis(j, std::min(std::max(lower, slowest), upper),
                                        std::max(std::min(upper, fastest), lower), config_.weight);
    if (status != Status::Ok) return status;
  }
  return Status::Ok;
}

}  // namespace rme
