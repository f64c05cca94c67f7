#pragma once
/// Whether a payload is known well enough to be told to the robot, judged by the joint torque in all poses.
#include <Eigen/Eigenvalues>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <rme/core/types.hpp>
#include <rme/estimator_state.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/tracking/inertial_parameters.hpp>
#include <rme/tracking/mode.hpp>

namespace rme {

/// What the judgement of a hand-over says.
enum class HandOverVerdict : std::uint8_t {
  Ready,        ///< the robot may be told
  Empty,        ///< the hand is probably empty
  Changing,     ///< an event is going on: the payload changes, or something pushes
  Uncertain,    ///< in some pose, a joint's torque could be wrong by more than the limit
  NotMeasured,  ///< no good sample has been seen since construction or reset()
  NotRevolute,  ///< a joint is not revolute, so that the levers have to be given: PayloadCompensationConfig::levers
};

/// The enumerator as a sentence, for messages.
constexpr const char* to_string(HandOverVerdict verdict) noexcept {
  switch (verdict) {
    case HandOverVerdict::Ready:
      return "ready";
    case HandOverVerdict::Empty:
      return "the hand is probably empty";
    case HandOverVerdict::Changing:
      return "the payload is changing, or something pushes";
    case HandOverVerdict::Uncertain:
      return "mass or centre of mass is not certain enough: tilt the hand";
    case HandOverVerdict::NotMeasured:
      return "no sample yet";
    case HandOverVerdict::NotRevolute:
      return "a joint is not revolute: set PayloadCompensationConfig::levers";
  }
  return "unknown";
}

/// A payload, and whether the robot may be told of it.
template <typename Scalar>
struct HandOver {
  HandOverVerdict verdict = HandOverVerdict::NotMeasured;  ///< Ready, or why not
  /// What is held: end-effector axes, the inertia about the end-effector origin and physically possible. Only motion
  /// shows the inertia.
  InertialParameters<Scalar> body;
  /// In all poses, the torque of `body` at rest is wrong by at most this, on every joint, with a probability of 95 %
  /// according to the estimate [N m]
  Scalar torque_error = Scalar(0);
  int joint = 0;                    ///< on which the torque may be wrong by so much, from 0
  Scalar torque_limit = Scalar(0);  ///< the largest torque_error that is accepted [N m]

  /// Whether the robot may be told.
  bool ready() const noexcept { return verdict == HandOverVerdict::Ready; }
};

/// An upper bound, over all poses, of each joint's torque error at rest (docs/theory_control.md (C25, C26)).
/// @param payload  mean and covariance of mass and centre of mass
/// @param levers   largest |J_v,j| of each joint [m], as from largest_levers(); a prismatic joint's is 1
/// @param gravity  |g| [m/s^2]
/// @return error that no pose exceeds with a probability of 95 % [N m], Dofs x 1
template <typename Scalar, int Dofs>
JointVector<Scalar, Dofs> largest_torque_error(const PayloadGaussian<Scalar>& payload,
                                               const JointVector<Scalar, Dofs>& levers, Scalar gravity) noexcept {
  using std::sqrt;
  // sqrt of the 95 % point of chi^2 with four degrees of freedom: |(a . x)| <= kBound sqrt(a^T P a) for all a at once.
  constexpr double kBound = 3.0802;
  Matrix4<Scalar> derivative = Matrix4<Scalar>::Identity(), transposed = derivative;  // of (m, m r) by (m, r)
  for (int i = 1; i < 4; ++i) {
    derivative(i, 0) = transposed(0, i) = payload.mean[i];
    derivative(i, i) = transposed(i, i) = payload.mean[0];
  }
  const Matrix4<Scalar> P = detail::product(detail::product(derivative, payload.covariance), transposed);
  // About the point c of the hand, errors of mass and of first moment are uncorrelated.
  const Scalar variance = std::max(P(0, 0), Scalar(0));
  Vector3<Scalar> c = Vector3<Scalar>::Zero();
  Matrix3<Scalar> moment = P.template bottomRightCorner<3, 3>();
  if (variance > 0) {
    c = P.template block<3, 1>(1, 0) / variance;
    moment -= c * c.transpose() * variance;
  }
  Eigen::SelfAdjointEigenSolver<Matrix3<Scalar>> solver;
  solver.computeDirect(moment, Eigen::EigenvaluesOnly);
  const Scalar largest = std::max(solver.eigenvalues()[2], Scalar(0)), offset = c.norm();
  JointVector<Scalar, Dofs> error;
  for (int j = 0; j < static_cast<int>(levers.size()); ++j) {
    const Scalar lever = levers[j] + offset;
    error[j] = Scalar(kBound) * gravity * sqrt(lever * lever * variance + largest);
  }
  return error;
}

/// Judges a hand-over.
/// @param state    what the estimator says
/// @param levers   as for largest_torque_error(); infinity where not known
/// @param gravity  |g| [m/s^2]
/// @param limit    the largest torque error that is accepted, > 0 [N m]
template <typename Scalar, int Dofs>
HandOver<Scalar> judge_hand_over(const EstimatorState<Scalar>& state, const JointVector<Scalar, Dofs>& levers,
                                 Scalar gravity, Scalar limit) noexcept {
  constexpr double kSure = 0.95;    // probability that something is held, and nothing else goes on
  constexpr double kExtent = 0.02;  // a body has at least the inertia of a ball of 4.5 cm radius [m]
  HandOver<Scalar> out;
  out.torque_limit = limit;
  if (!(state.held >= Scalar(kSure))) {
    out.verdict = HandOverVerdict::Empty;
    return out;
  }
  out.body = InertialParameters<Scalar>::from_vector(state.inertial.mean).made_consistent(Scalar(kExtent));
  const JointVector<Scalar, Dofs> error = largest_torque_error(state.payload, levers, gravity);
  for (int j = 1; j < static_cast<int>(error.size()); ++j)
    if (error[j] > error[out.joint]) out.joint = j;
  out.torque_error = error[out.joint];
  if (state.changing || !(state.probability[Mode::Held] >= Scalar(kSure)))
    out.verdict = HandOverVerdict::Changing;
  else if (!(levers.array() < std::numeric_limits<Scalar>::infinity()).all())
    out.verdict = HandOverVerdict::NotRevolute;
  else
    out.verdict = out.torque_error <= limit ? HandOverVerdict::Ready : HandOverVerdict::Uncertain;
  return out;
}

}  // namespace rme
