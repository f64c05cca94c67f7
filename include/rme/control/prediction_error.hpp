#pragma once
/// How far the arm's acceleration may be from its prediction.
#include <algorithm>
#include <cmath>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// A bound on the error of a predicted joint acceleration, for each side separately:
///
///     predicted - below <= ddq <= predicted + above      [rad/s^2], both >= 0
///
/// barriers.hpp moves the bounds of its rows inwards by this error, so that they hold although the prediction is wrong
/// (E in docs/theory_control.md (C13)). Zero by default.
template <typename Scalar, int Dofs>
struct AccelerationError {
  JointVector<Scalar, Dofs> below;  ///< [rad/s^2], >= 0
  JointVector<Scalar, Dofs> above;  ///< [rad/s^2], >= 0

  AccelerationError() noexcept { below = above = JointVector<Scalar, Dofs>::Zero(); }
  /// Both in [rad/s^2], >= 0.
  AccelerationError(const JointVector<Scalar, Dofs>& below_, const JointVector<Scalar, Dofs>& above_) noexcept
      : below(below_), above(above_) {}
  /// The most by which gradient . ddq may lie below its prediction, >= 0: E of (C13).
  /// @param gradient  grad_q h [u/rad], Dofs; the result is in u/s^2
  Scalar along(const JointVector<Scalar, Dofs>& gradient) const noexcept {
    return gradient.cwiseMax(Scalar(0)).dot(below) - gradient.cwiseMin(Scalar(0)).dot(above);
  }
};

/// Settings of PredictionErrorWatch.
template <typename Scalar, int Dofs>
struct PredictionErrorConfig {
  /// A bound that the host sets; it is always added [rad/s^2], >= 0.
  JointVector<Scalar, Dofs> stated = JointVector<Scalar, Dofs>::Zero();
  /// Time constant with which an error that was seen is forgotten [s], > 0.
  Scalar memory = Scalar(0.02);
};

/// Bounds the error of the next prediction by the errors seen so far, (dq_k - dq_k-1) / T - predicted_k-1: the largest
/// of each sign, forgotten exponentially, plus `stated`. An error that lasts, such as that of a push, is covered from
/// its second tick on. This is a heuristic: the first tick of a new error is not covered, so a guarantee needs `stated`
/// (docs/theory_control.md, "Sampled barriers").
template <typename Scalar, int Dofs>
class PredictionErrorWatch {
 public:
  using Vector = JointVector<Scalar, Dofs>;  ///< dq [rad/s] or ddq [rad/s^2]

  /// @param period  T, from one observe() to the next [s], > 0
  /// @param config  the host's bound, and the memory
  /// @throws std::invalid_argument naming the field out of range
  explicit PredictionErrorWatch(
      Scalar period, const PredictionErrorConfig<Scalar, Dofs>& config = PredictionErrorConfig<Scalar, Dofs>())
      : config_(config), period_(period), keep_(std::exp(-period / config.memory)) {
    detail::require_positive(period, "PredictionErrorWatch::period", "> 0 s");
    detail::require_positive(config.memory, "PredictionErrorConfig::memory", "> 0 s");
    for (int j = 0; j < Dofs; ++j) {
      detail::require(config.stated[j] >= 0 && plausible(config.stated[j]), "PredictionErrorConfig::stated",
                      ">= 0 rad/s^2", config.stated[j]);
    }
    error_.below = error_.above = config.stated;
  }

  /// Compares this tick's velocity with the prediction, if predict() was called since the last observe().
  /// @param dq  joint velocity [rad/s]
  /// @return Ok, or NonFiniteInput: the bounds stay as they were, and the prediction is dropped
  Status observe(const Vector& dq) noexcept {
    const bool comparable = predicted_known_;
    predicted_known_ = false;
    observed_ = plausible(dq);
    if (!observed_) return Status::NonFiniteInput;
    below_ *= keep_;
    above_ *= keep_;
    if (comparable) {
      const Vector off = (dq - dq_) / period_ - predicted_;
      below_ = below_.cwiseMax(-off);
      above_ = above_.cwiseMax(off);
    }
    error_.below = config_.stated + below_;
    error_.above = config_.stated + above_;
    dq_ = dq;
    return Status::Ok;
  }
  /// Stores the predicted acceleration of this tick's torque [rad/s^2], Cpic::acceleration(). There is no prediction if
  /// it is not finite, or if observe() has refused this tick's velocity: then the next difference of velocities would
  /// span two periods.
  void predict(const Vector& ddq) noexcept {
    predicted_ = ddq;
    predicted_known_ = observed_ && ddq.allFinite();
  }

  /// The bound on the error of the next prediction [rad/s^2].
  const AccelerationError<Scalar, Dofs>& error() const noexcept { return error_; }

 private:
  PredictionErrorConfig<Scalar, Dofs> config_;
  Scalar period_, keep_;
  Vector dq_ = Vector::Zero(), predicted_ = Vector::Zero();
  bool observed_ = false, predicted_known_ = false;
  Vector below_ = Vector::Zero(), above_ = Vector::Zero();
  AccelerationError<Scalar, Dofs> error_;
};

}  // namespace rme
