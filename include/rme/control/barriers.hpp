#pragma once
/// Exponential control barrier functions: where the arm may go, written as rows on its joint accelerations.
#include <algorithm>
#include <cmath>
#include <limits>
#include <rme/control/constraint_rows.hpp>
#include <rme/control/prediction_error.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// The gains of a barrier as the poles of h'' + k_2 h' + k_1 h = 0: k_1 = p_1 p_2, k_2 = p_1 + p_2
/// (docs/theory_control.md (C10)). The guarantee needs two real, stable poles: if h >= 0 and h' >= -p h hold at the
/// start for one of the poles p, h never becomes negative. The slower pole p sets how early the arm brakes: from speed
/// v at a distance of v / p, with a deceleration of at most p v.
template <typename Scalar>
class BarrierPoles {
 public:
  /// @param first, second  p_1, p_2 > 0 [1/s]
  /// @throws std::invalid_argument for a pole that is not stable
  BarrierPoles(Scalar first, Scalar second) : k1(first * second), k2(first + second), first_(first), second_(second) {
    detail::require_positive(first, "BarrierPoles::first", "> 0 1/s (a stable pole)");
    detail::require_positive(second, "BarrierPoles::second", "> 0 1/s (a stable pole)");
  }
  /// Gains for a torque that is held for a period T, instead of one that changes continuously. With the faster pole p,
  /// the slower pole s and D = T (1 + p T / 2),
  ///
  ///     k_1 = p (1 - e^-sT) / D,    k_2 = (1 - e^-sT + p T) / D
  ///
  /// If h >= 0 and h' >= -p h hold at one tick, and h'' >= -k_1 h - k_2 h' (with h and h' at the tick) over the period,
  /// both hold at the next tick, and h >= 0 in between, exactly (docs/theory_control.md (C13)). As T goes to zero, the
  /// gains go to those above.
  /// @param period  T [s], > 0, at most 2 / p
  /// @throws std::invalid_argument for another period
  BarrierPoles sampled(Scalar period) const {
    using std::expm1;
    const Scalar fast = std::max(first_, second_), slow = std::min(first_, second_);
    detail::require(period > 0 && fast * period <= 2, "BarrierPoles::sampled(period)",
                    "> 0 s, at most 2 over the faster pole", period);
    const Scalar share = -expm1(-slow * period), scale = period * (1 + fast * period / 2);
    BarrierPoles out = *this;
    out.k1 = fast * share / scale;
    out.k2 = (share + fast * period) / scale;
    return out;
  }
  Scalar k1;  ///< [1/s^2]
  Scalar k2;  ///< [1/s]

 private:
  Scalar first_, second_;
};

/// A barrier h(q) >= 0 at the present state (docs/theory_control.md (C11)); a host may compute its own.
template <typename Scalar, int Dofs>
struct BarrierValue {
  Scalar h;                            ///< in any unit u; negative means violated
  JointVector<Scalar, Dofs> gradient;  ///< grad_q h [u/rad]
  Scalar curvature;                    ///< dq^T hess_q h dq [u/s^2]
};

/// Appends grad_h^T ddq >= -k_1 h - k_2 grad_h^T dq - dq^T hess_h dq + e [RME, Eq. 19, 20;
/// docs/theory_control.md (C11), in sampled time (C13)].
/// @param barrier  h, its gradient and its curvature at the present state
/// @param dq       joint velocity [rad/s]
/// @param poles    gains k_1, k_2
/// @param rows     get one more row
/// @param weight   of a soft barrier, > 0: a violation of the row by s [u/s^2] costs weight * s^2
/// @param error    bound on the error of the predicted acceleration [rad/s^2]; e is the most by which grad_h^T ddq may
///                 then lie below its prediction
/// @return see ConstraintRows::add; Infeasible: the gradient is zero, and no acceleration gives what the barrier needs
template <typename Scalar, int Dofs, int MaxRows>
Status add_barrier(const BarrierValue<Scalar, Dofs>& barrier, const JointVector<Scalar, Dofs>& dq,
                   const BarrierPoles<Scalar>& poles, ConstraintRows<Scalar, Dofs, MaxRows>& rows,
                   Scalar weight = ConstraintRows<Scalar, Dofs, MaxRows>::kHard,
                   const AccelerationError<Scalar, Dofs>& error = AccelerationError<Scalar, Dofs>()) noexcept {
  const Scalar bound =
      -poles.k1 * barrier.h - poles.k2 * barrier.gradient.dot(dq) - barrier.curvature + error.along(barrier.gradient);
  return rows.add(barrier.gradient, bound, rows.kFree, weight);
}

/// A point of the arm in motion, world axes: the input of half_space_barrier() and sphere_barrier()
/// (docs/theory_control.md (C12)).
template <typename Scalar, int Dofs>
struct PointMotion {
  Vector3<Scalar> position;                 ///< x [m]
  Vector3<Scalar> velocity;                 ///< xdot = J_v dq [m/s]
  Eigen::Matrix<Scalar, 3, Dofs> jacobian;  ///< J_v; for the end-effector origin the top three rows of J
  Vector3<Scalar> velocity_product;         ///< Jdot_v dq [m/s^2], the acceleration of the point at ddq = 0
};

/// Keeps a point on the side of a plane to which `normal` points: h = n.x - offset [m] (docs/theory_control.md (C12)).
/// @param point   of the arm, in motion
/// @param normal  n, of unit length, world axes
/// @param offset  of the plane from the world's origin, along n [m]
template <typename Scalar, int Dofs>
BarrierValue<Scalar, Dofs> half_space_barrier(const PointMotion<Scalar, Dofs>& point, const Vector3<Scalar>& normal,
                                              Scalar offset) noexcept {
  return {normal.dot(point.position) - offset, point.jacobian.transpose() * normal, normal.dot(point.velocity_product)};
}

/// The side of a sphere on which a point has to stay.
enum class SphereSide { Outside, Inside };

/// Keeps a point outside or inside a sphere: h = +-(|x - c|^2 - r^2) / (2 r) [m] (docs/theory_control.md (C12)). Near
/// the surface, h is the distance to it. Unlike the distance, h is smooth at the centre.
/// @param point   of the arm, in motion
/// @param center  c [m], world axes
/// @param radius  r [m], > 0
/// @param side    on which the point has to stay
template <typename Scalar, int Dofs>
BarrierValue<Scalar, Dofs> sphere_barrier(const PointMotion<Scalar, Dofs>& point, const Vector3<Scalar>& center,
                                          Scalar radius, SphereSide side) noexcept {
  const Scalar sign = side == SphereSide::Outside ? Scalar(1) : Scalar(-1);
  const Vector3<Scalar> away = point.position - center;
  const Vector3<Scalar> gradient = sign / radius * away;  // grad_x h
  return {sign * (away.squaredNorm() - radius * radius) / (2 * radius), point.jacobian.transpose() * gradient,
          sign / radius * point.velocity.squaredNorm() + gradient.dot(point.velocity_product)};
}

/// Settings of JointLimits.
template <typename Scalar, int Dofs>
struct JointLimitsConfig {
  JointVector<Scalar, Dofs> q_min;  ///< [rad]
  JointVector<Scalar, Dofs> q_max;  ///< [rad], above q_min
  /// |dq| [rad/s], > 0; infinite for none
  JointVector<Scalar, Dofs> velocity_limit =
      JointVector<Scalar, Dofs>::Constant(std::numeric_limits<Scalar>::infinity());
  BarrierPoles<Scalar> poles = {Scalar(8), Scalar(40)};     ///< of h = q - q_min and h = q_max - q
  Scalar velocity_pole = Scalar(40);                        ///< p > 0 [1/s]: ddq <= p (limit - dq)
  Scalar weight = std::numeric_limits<Scalar>::infinity();  ///< of the rows, > 0; infinite: hard
  /// T [s] for which a torque is held, at most 2 over the faster pole: rows for sampled time (BarrierPoles::sampled).
  /// 0: the paper's rows for continuous time.
  Scalar period = Scalar(0);
};

/// The limits of all joints, positions and velocities, as one two-sided row on each joint's acceleration
/// (docs/theory_control.md (C11), in sampled time (C13)):
///
///     -k_1 (q - q_min) - k_2 dq <= ddq <= k_1 (q_max - q) - k_2 dq,      -p (dq_max + dq) <= ddq <= p (dq_max - dq)
///
/// On each side, the tighter bound counts. If the two pairs contradict each other (the joint is too fast and next to
/// its limit), the position limit wins. In sampled time, (1 - e^-pT) / T takes the place of p. Each bound is moved
/// inwards by the error of the prediction. A velocity bound is moved by at most p dq_max: it then asks for ddq = -p dq,
/// which brings the joint to a standstill. A larger error may take a joint beyond its velocity limit; append() returns
/// Ok even then.
template <typename Scalar, int Dofs>
class JointLimits {
 public:
  /// @throws std::invalid_argument naming the field out of range
  explicit JointLimits(const JointLimitsConfig<Scalar, Dofs>& config);

  /// Appends Dofs rows on ddq [rad/s^2], joint 0 first.
  /// @param q      joint position [rad]
  /// @param dq     joint velocity [rad/s]
  /// @param rows   get Dofs more rows
  /// @param error  bound on the error of the predicted accelerations [rad/s^2]
  /// @return Ok; NonFiniteInput (also for numbers beyond kLargestPlausible) or CapacityExceeded: no row has been added;
  ///         Infeasible: with this error, no acceleration of some joint is sure to keep both its position limits. Then
  ///         its row asks for the middle of the two bounds, and all rows have been added
  template <int MaxRows>
  Status append(const JointVector<Scalar, Dofs>& q, const JointVector<Scalar, Dofs>& dq,
                ConstraintRows<Scalar, Dofs, MaxRows>& rows,
                const AccelerationError<Scalar, Dofs>& error = AccelerationError<Scalar, Dofs>()) const noexcept;

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
  detail::require(config.period >= 0, "JointLimitsConfig::period", ">= 0 s, at most 2 over the faster pole",
                  config.period);
  if (config.period > 0) {
    config_.poles = config.poles.sampled(config.period);
    config_.velocity_pole = -std::expm1(-config.velocity_pole * config.period) / config.period;
  }
}

template <typename Scalar, int Dofs>
template <int MaxRows>
Status JointLimits<Scalar, Dofs>::append(const JointVector<Scalar, Dofs>& q, const JointVector<Scalar, Dofs>& dq,
                                         ConstraintRows<Scalar, Dofs, MaxRows>& rows,
                                         const AccelerationError<Scalar, Dofs>& error) const noexcept {
  if (!plausible(q) || !plausible(dq) || !plausible(error.below) || !plausible(error.above))
    return Status::NonFiniteInput;
  if (rows.size() + Dofs > MaxRows) return Status::CapacityExceeded;
  const Scalar k1 = config_.poles.k1, k2 = config_.poles.k2;
  Status all = Status::Ok;
  for (int j = 0; j < Dofs; ++j) {
    Scalar lower = -k1 * (q[j] - config_.q_min[j]) - k2 * dq[j] + error.below[j];
    Scalar upper = k1 * (config_.q_max[j] - q[j]) - k2 * dq[j] - error.above[j];
    if (lower > upper) {
      lower = upper = (lower + upper) / 2;
      all = Status::Infeasible;
    }
    // A bound that the error has moved past standstill would drive the joint the other way: it stops at standstill.
    const Scalar stop = -config_.velocity_pole * dq[j], room = config_.velocity_pole * config_.velocity_limit[j];
    const Scalar slowest = stop - std::max(room - error.below[j], Scalar(0));
    const Scalar fastest = stop + std::max(room - error.above[j], Scalar(0));
    // lower <= upper here. The velocity bounds are clamped into the position bounds, then the lower to the upper one.
    const Scalar highest = std::max(std::min(upper, fastest), lower);
    const Status status = rows.add_axis(j, std::min(std::max(lower, slowest), highest), highest, config_.weight);
    if (status != Status::Ok) return status;
  }
  return all;
}

}  // namespace rme
