#pragma once
/// The last seconds of samples, in the form that inference needs.
#include <cmath>
#include <cstddef>
#include <rme/core/flange_motion.hpp>
#include <rme/core/require.hpp>
#include <rme/core/ring_buffer.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/core/wrench.hpp>
#include <rme/sensing/friction_direction.hpp>
#include <rme/sensing/proprioception.hpp>

namespace rme {

/// Settings of SampleWindow.
struct SampleWindowConfig {
  double duration = 1.5;  ///< how far back samples are kept [s]: 2 to 1e6 periods
  /// Bandwidth of the first-order filter through which tau_ext comes [rad/s]: the gain K of the arm's momentum
  /// observer, with 1e-6 <= K dt <= 1; or 0 if the torque is unfiltered. For a filter that is discretised exactly and
  /// not by Euler's rule, set (1 - exp(-K dt)) / dt.
  double observer_bandwidth = 50;
  double rest_velocity = 1e-3;  ///< joints slower than this count as resting [rad/s], > 0
};

/// One tick, with what is computed from it.
template <typename Scalar, int Dofs>
struct WindowSample {
  Proprioception<Scalar, Dofs> raw;  ///< as it was passed to push()
  /// External torque over the period that ends with this tick [N m], with the observer's lag removed.
  JointVector<Scalar, Dofs> tau = JointVector<Scalar, Dofs>::Zero();
  JointVector<Scalar, Dofs> direction = JointVector<Scalar, Dofs>::Zero();  ///< d of dry friction: FrictionDirection
  FlangeMotion<Scalar> motion;                                              ///< over the same period
};

/// Keeps the samples of the last seconds. When a sample is pushed, its external torque, direction of friction and
/// motion are computed.
///
/// The observer's filter r_k = r_k-1 + K dt (tau_k - r_k-1) is inverted: tau_k = r_k-1 + (r_k - r_k-1) / (K dt)
/// (docs/theory.md (T8)). This keeps all information, and the instant at which the filter started need not be known.
/// Noise that was white before the filter is white again.
///
/// Unless the host passes the flange's motion, its acceleration is the backward difference of J dq, which belongs to
/// the same period as tau_k. Samples are taken to be dt apart: Proprioception::period is not used.
template <typename Scalar, int Dofs>
class SampleWindow {
 public:
  /// @param dt       control period [s], > 0
  /// @param config   settings
  /// @param coulomb  Coulomb friction to expect in tau_ext [N m], >= 0, per joint; a resting joint may show less of it
  /// @throws std::invalid_argument naming the field out of range
  explicit SampleWindow(double dt, const SampleWindowConfig& config = SampleWindowConfig(),
                        const JointVector<Scalar, Dofs>& coulomb = JointVector<Scalar, Dofs>::Zero());

  /// Appends one tick. The first tick after construction or reset() has no predecessor: its tau is tau_ext, and its
  /// acceleration is zero.
  /// @param sample          one tick
  /// @param payload_steady  false while the payload is known to change (FrictionDirection)
  /// @return Ok; NonFiniteInput or NotARotation: the window is then as it was
  Status push(const Proprioception<Scalar, Dofs>& sample, bool payload_steady = true) noexcept;

  std::size_t size() const noexcept { return samples_.size(); }          ///< samples kept now
  std::size_t capacity() const noexcept { return samples_.capacity(); }  ///< samples kept at most
  /// The sample `age` ticks ago, 0 being the newest. Requires age < size().
  const WindowSample<Scalar, Dofs>& newest(std::size_t age = 0) const noexcept { return samples_.newest(age); }
  /// Forgets all samples.
  void reset() noexcept {
    samples_.clear();
    friction_.reset();
  }

 private:
  Scalar dt_;
  Scalar blend_;  // K dt
  FrictionDirection<Scalar, Dofs> friction_;
  RingBuffer<WindowSample<Scalar, Dofs>> samples_;
};

template <typename Scalar, int Dofs>
SampleWindow<Scalar, Dofs>::SampleWindow(double dt, const SampleWindowConfig& config,
                                         const JointVector<Scalar, Dofs>& coulomb)
    : dt_(static_cast<Scalar>(dt)),
      blend_(config.observer_bandwidth > 0 ? static_cast<Scalar>(config.observer_bandwidth * dt) : Scalar(1)),
      friction_(dt, static_cast<Scalar>(config.rest_velocity), coulomb),
      samples_(1) {
  detail::require_positive(dt, "SampleWindow::dt", "> 0 s");
  detail::require(config.duration / dt >= 2 && config.duration / dt < 1e6, "SampleWindowConfig::duration",
                  "2 to 1e6 samples", config.duration / dt);
  const double blend = config.observer_bandwidth * dt;
  detail::require(blend == 0 || (blend >= 1e-6 && blend <= 1), "SampleWindowConfig::observer_bandwidth",
                  "0 rad/s, or 1e-6 to 1 over the period", config.observer_bandwidth);
  detail::require_positive(config.rest_velocity, "SampleWindowConfig::rest_velocity", "> 0 rad/s");
  samples_ = RingBuffer<WindowSample<Scalar, Dofs>>(static_cast<std::size_t>(std::lround(config.duration / dt)));
}

template <typename Scalar, int Dofs>
Status SampleWindow<Scalar, Dofs>::push(const Proprioception<Scalar, Dofs>& in, bool payload_steady) noexcept {
  const Status status = check_sample(in);
  if (status != Status::Ok) return status;
  WindowSample<Scalar, Dofs> sample;
  sample.raw = in;
  sample.tau = in.tau_ext;
  const auto twist = Twist<Scalar>::from_vector(in.jacobian * in.dq);
  sample.motion.angular_velocity = twist.angular;
  if (!samples_.empty()) {
    const WindowSample<Scalar, Dofs>& last = samples_.newest();
    sample.tau = last.raw.tau_ext + (in.tau_ext - last.raw.tau_ext) / blend_;
    const auto last_twist = Twist<Scalar>::from_vector(last.raw.jacobian * last.raw.dq);
    sample.motion.linear_acceleration = (twist.linear - last_twist.linear) / dt_;
    sample.motion.angular_acceleration = (twist.angular - last_twist.angular) / dt_;
  }
  if (in.motion) sample.motion = *in.motion;
  // If dt is nearly zero, these overflow. They are refused here, before they reach the inference.
  if (!sample.tau.allFinite() || !sample.motion.linear_acceleration.allFinite() ||
      !sample.motion.angular_acceleration.allFinite())
    return Status::NonFiniteInput;
  sample.direction = friction_.update(sample.tau, in.dq, sample.motion.linear_acceleration, payload_steady);
  samples_.push(sample);
  return Status::Ok;
}

}  // namespace rme
