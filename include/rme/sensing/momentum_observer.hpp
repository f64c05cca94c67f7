#pragma once
/// The external joint torque of an arm that measures its joint torques and knows its own model.
#include <cmath>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Settings of MomentumObserver.
template <typename Scalar, int Dofs>
struct MomentumObserverConfig {
  JointVector<Scalar, Dofs> gain = JointVector<Scalar, Dofs>::Constant(Scalar(50));  ///< K [rad/s], 0 < K dt <= 1
};

/// Generalised-momentum observer (De Luca and Mattone, ICRA 2005; docs/theory.md (T45), its filter (T7)).
///
/// With p = M dq the dynamics read dp/dt = tau + C^T dq - g + tau_ext, so tau_ext is the part of dp/dt that the model
/// does not explain. u_k is the average of tau_ext over the period that ends with sample k, and r_k is the observer's
/// output:
///
///     u_k = (p_k - p_k-1) / dt - tau_k - (s_k-1 + s_k) / 2,    s = C^T dq - g
///     r_k = r_k-1 + K dt (u_k - r_k-1),                        r_0 = 0
///
/// So r is tau_ext after the first-order filter K / (s + K), discretised by Euler's rule as on nearly all arms. An
/// external torque that begins at sample k first appears at sample k + 1, with K dt of its size. If the host measures
/// its period h, u_k is the average over h, and the filter advances by h / dt periods at once:
///
///     r_k = r_k-1 + (1 - (1 - K dt)^(h / dt)) (u_k - r_k-1)
///
/// For a constant external torque, r then does not depend on how the time was divided into samples, and lost ticks
/// count as time that passed. To compare r with a model x of tau_ext, average x over the period that ends with sample k
/// and pass it through the same filter, or invert the filter (docs/theory.md (T8)).
///
/// Sign: r is what the environment exerts on the arm, tau_ext in M ddq + C dq + g = tau + tau_ext. r also contains
/// joint friction that the torque sensor does not measure, and an offset of the torque sensor with the opposite sign.
/// Real time: update() is O(Dofs^2), and with a period one exponential per joint; it allocates and throws nothing.
template <typename Scalar, int Dofs>
class MomentumObserver {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< one number per joint

  /// @param dt      control period [s], > 0
  /// @param config  the gain
  /// @throws std::invalid_argument naming the field out of range; the only call that throws
  explicit MomentumObserver(Scalar dt, const MomentumObserverConfig<Scalar, Dofs>& config = {});

  /// Advances by one period. The first call after construction or reset() only records the arm's momentum.
  /// @param tau                 joint torque that the motors exerted over the period that ends now, gravity and payload
  ///                            compensation included [N m]: as measured, or else the command of the last tick
  /// @param dq                  joint velocity now [rad/s]
  /// @param mass_matrix         M(q) now [kg m^2], of the arm without payload
  /// @param coriolis_transpose  C(q, dq)^T dq now, for C with dM/dt = C + C^T [N m]
  /// @param gravity             g(q) now, the term of the dynamics above [N m]
  /// @param period              time since the last sample, if it is measured [s]; 0 means the nominal period dt
  /// @return Ok; NonFiniteInput, also for a period below 0 and for torques, momenta and periods beyond
  ///         kLargestPlausible: the observer is then as it was
  Status update(const Vector& tau, const Vector& dq, const JointMatrix<Scalar, Dofs>& mass_matrix,
                const Vector& coriolis_transpose, const Vector& gravity, double period = 0) noexcept;

  /// r, the filtered external torque [N m]; zero until the second update().
  const Vector& tau_ext() const noexcept { return residual_; }

  /// Returns to the state after construction.
  void reset() noexcept;

 private:
  Scalar dt_;
  Vector blend_;  // K dt
  Vector rate_;   // ln(1 - K dt) / dt [1/s], so that exp(h rate_) = (1 - K dt)^(h / dt); -infinity where K dt is 1
  Vector residual_ = Vector::Zero();
  Vector momentum_ = Vector::Zero();  // p_k-1
  Vector drift_ = Vector::Zero();     // s_k-1
  bool started_ = false;
};

template <typename Scalar, int Dofs>
MomentumObserver<Scalar, Dofs>::MomentumObserver(Scalar dt, const MomentumObserverConfig<Scalar, Dofs>& config)
    : dt_(dt) {
  detail::require_positive(dt, "MomentumObserver::dt", "> 0 s");
  for (int i = 0; i < Dofs; ++i)
    detail::require(config.gain[i] > 0 && config.gain[i] * dt <= 1, "MomentumObserverConfig::gain",
                    "> 0 rad/s and at most one over the period", config.gain[i]);
  blend_ = config.gain * dt;
  for (int i = 0; i < Dofs; ++i) rate_[i] = std::log1p(-blend_[i]) / dt;
}

template <typename Scalar, int Dofs>
Status MomentumObserver<Scalar, Dofs>::update(const Vector& tau, const Vector& dq,
                                              const JointMatrix<Scalar, Dofs>& mass_matrix,
                                              const Vector& coriolis_transpose, const Vector& gravity,
                                              double period) noexcept {
  if (!(period >= 0 && plausible(period))) return Status::NonFiniteInput;
  const Scalar h = period > 0 ? static_cast<Scalar>(period) : dt_;
  const Vector momentum = mass_matrix * dq;
  const Vector drift = coriolis_transpose - gravity;
  const Vector remainder = (momentum - momentum_) / h - tau - Scalar(0.5) * (drift + drift_);
  // Any NaN or infinity among the inputs, and any overflow, ends up in these.
  if (!plausible(momentum) || !plausible(drift) || !plausible(tau) || !remainder.allFinite())
    return Status::NonFiniteInput;
  if (started_) {
    Vector blend = blend_;
    if (period > 0)
      for (int i = 0; i < Dofs; ++i) blend[i] = -std::expm1(rate_[i] * h);
    residual_ += blend.cwiseProduct(remainder - residual_);
  }
  momentum_ = momentum;
  drift_ = drift;
  started_ = true;
  return Status::Ok;
}

template <typename Scalar, int Dofs>
void MomentumObserver<Scalar, Dofs>::reset() noexcept {
  residual_.setZero();
  momentum_.setZero();
  drift_.setZero();
  started_ = false;
}

}  // namespace rme
