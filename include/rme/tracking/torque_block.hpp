#pragma once
/// Averages samples over 20 to 60 ms: the tracker's measurement.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <optional>
#include <rme/core/flange_motion.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/core/wrench.hpp>
#include <rme/sensing/proprioception.hpp>
#include <rme/tracking/inertial_parameters.hpp>
#include <rme/tracking/shrunk_rate.hpp>

namespace rme {

inline constexpr int kBlockParts = 4;  ///< parts of a block, for which velocity and regressor are computed separately

/// Averages over a block of samples.
template <typename Scalar, int Dofs>
struct TorqueBlock {
  double end = 0;                 ///< instant of its last sample [s]
  Scalar duration = Scalar(0);    ///< [s], > 0
  JointVector<Scalar, Dofs> tau;  ///< external torque, the observer's lag removed [N m]
  /// Rate of change of the filtered tau_ext, its posterior mean: zero unless it is above its noise [N m/s].
  JointVector<Scalar, Dofs> torque_rate;
  /// J^T Y of (T10): d tau / d phi. The flange's acceleration in it is the posterior mean, unless the host gives it.
  Eigen::Matrix<Scalar, Dofs, kInertial> regressor;
  Jacobian<Scalar, Dofs> jacobian;  ///< of the last sample
  Matrix3<Scalar> rotation;         ///< of the last sample
  /// Mean of dq [rad/s]. If dq is rounded, what is no more than three quarters of its smallest change so far is zero,
  /// here and in `velocities`: a joint at rest may report half a step for ever. So is everything before the first
  /// change.
  JointVector<Scalar, Dofs> velocity;
  Eigen::Matrix<Scalar, Dofs, kBlockParts> velocities;  ///< mean of dq over each part of the block [rad/s]
  JointVector<Scalar, Dofs> torque_step;                ///< smallest change of tau_ext so far; 0 if none [N m]
  JointVector<Scalar, Dofs> velocity_noise;             ///< learned variance of the noise of dq [(rad/s)^2]
  int samples = 0;                                      ///< number of samples
  /// Time between the last block and this one: that of the samples that restart() has left out [s].
  Scalar skipped = Scalar(0);
  /// Duration of the blocks from which noise is learned, if it is clearly longer than this one's; else 0 [s].
  Scalar usual = Scalar(0);
  /// Posterior variance of the flange's linear acceleration in `regressor`, mean over the axes [(m/s^2)^2]. It is a
  /// noise of the torque, m^2 times as large per axis. 0 if the host gives the motion.
  Scalar acceleration_variance = Scalar(0);
  Scalar angular_acceleration_variance = Scalar(0);  ///< the same of the angular acceleration [(rad/s^2)^2]
  /// Mean of what the host adds to its command for the payload [N m], averaged like tau; absent unless the samples of
  /// more than half of the block have it.
  std::optional<JointVector<Scalar, Dofs>> carried = std::nullopt;
  Scalar observer_time =
      Scalar(0.02);  ///< time constant of the stated observer [s]; that of 50 rad/s if none is stated
  /// The last sample's: the arm's own gravity torque per unit of gravity along each world axis [N m / (m/s^2)].
  std::optional<Eigen::Matrix<Scalar, Dofs, 3>> gravity_torque = std::nullopt;

  Scalar elapsed() const noexcept { return skipped + duration; }  ///< time since the end of the last block [s]
};

/// What is known of a block in addition to its samples.
template <typename Scalar, int Dofs>
struct BlockContext {
  bool exchange_likely = false;  ///< the host says that the payload changes now
  Scalar log_share = Scalar(0);  ///< log probability that the arm has this kind of torque sensing
  bool friction_shows = false;   ///< it is certain that tau_ext contains joint friction
  /// Change of the commanded compensation since the last block [N m].
  JointVector<Scalar, Dofs> compensation_change = JointVector<Scalar, Dofs>::Zero();
};

/// Averages samples over blocks.
///
/// The observer's filter r_k = r_k-1 + b (tau_k - r_k-1) is inverted: tau_k = r_k-1 + (r_k - r_k-1) / b (docs/theory.md
/// (T8)). For an observer of period p, b is 1 - (1 - K p)^(dt / p). Noise that was white before the filter is white
/// again. The errors of quantised, late or differently filtered samples cancel within a block, except at its two ends.
///
/// Torque and acceleration are averaged with the same weights, 6 s (1 - s) over the block (docs/theory.md (T9)). The
/// average of the differences of J dq is then the least-squares slope of J dq, which has the least variance of all
/// linear estimates of the acceleration, and the averaged torque belongs to this acceleration. Blocks last 20 ms, and
/// up to 60 ms if dq is noisy: the acceleration is part of the payload's regressor, and errors of a regressor do not
/// average out, but make the payload look lighter. So the part of each joint's acceleration that counts as noise of dq
/// is taken out of the regressor (ShrunkRate; docs/theory.md, "Noise in the regressor"). The rate of tau_ext, the
/// regressor of a lag, is treated in a similar way.
///
/// Periods of 0.1 ms to 0.1 s are possible. They may vary, and samples may be missing: each sample counts for the time
/// since the last one. If the host is so slow that a block is a single sample, the acceleration is the difference of
/// two, and what the second differences of dq show of its changes counts as noise of dq. Real time: add() is O(Dofs),
/// and O(10 Dofs) on the last sample of each part; nothing allocates.
template <typename Scalar, int Dofs>
class BlockAverager {
 public:
  static constexpr double kDuration = 0.02;          ///< duration of a block if dq has little noise [s]
  static constexpr double kLongest = 3 * kDuration;  ///< longest duration, if dq is noisy [s]
  /// Period p of the arm's own observer, which may run faster than the host's loop [s].
  static constexpr double kObserverPeriod = 0.001;

  /// @param bandwidth  K of the observer that computed tau_ext [rad/s]; 0 if tau_ext is unfiltered
  /// @param gravity    g [m/s^2], world axes
  /// @param longest    longest duration of a block if dq is noisy [s], >= kDuration
  BlockAverager(double bandwidth, const Vector3<Scalar>& gravity, double longest = kLongest) noexcept
      : bandwidth_(bandwidth), gravity_(gravity), longest_(longest) {
    if (bandwidth > 0) sums_.observer_time = static_cast<Scalar>(1 / bandwidth);
    clear();
  }

  /// Adds a sample.
  /// @param sample  one tick, for which check_sample() has returned Ok
  /// @param dt      time since the last sample [s], > 0
  /// @param time    time of this sample [s]
  /// @return whether the sample completed a block, which block() then returns
  bool add(const Proprioception<Scalar, Dofs>& sample, double dt, double time) noexcept;

  /// The last complete block. Requires that add() has returned true.
  const TorqueBlock<Scalar, Dofs>& block() const noexcept { return block_; }
  /// External torque of the last sample, with the observer's lag removed [N m].
  const JointVector<Scalar, Dofs>& torque() const noexcept { return torque_; }
  /// Something begins now: the samples before and after do not belong in one mean. Leaves out the samples of the
  /// current block, and makes the next one half as long: what begins is large against the noise. Further calls have no
  /// effect until that one is complete, so that there are blocks however often something begins.
  void restart() noexcept {
    if (begins_) return;
    begins_ = true;
    skipped_ = duration_ + part_duration_;
    begin();
  }
  /// The current block is not made longer for the noise of dq: what comes is large against it.
  void hurry() noexcept { hurries_ = true; }
  /// Discards the current block and the last sample. The noise of dq and the resolution of tau_ext are kept.
  void clear() noexcept {
    started_ = false;
    skipped_ = Scalar(0);
    begins_ = hurries_ = false;
    for (int j = 0; j < Dofs; ++j) {
      acceleration_[j].interrupt();
      torque_rate_[j].interrupt();
    }
    begin();
  }

 private:
  // Standard deviation of a block's acceleration due to noise of dq, above which blocks are made longer [m/s^2].
  static constexpr double kFeigned = 0.02;
  static constexpr int kNoiseMemory = 50;    // memory of the noise of dq in blocks: 1 s
  static constexpr double kResolved = 0.75;  // velocity that is none, per resolution of dq
  static constexpr double kNoisiest = 1e-4;  // bound of the variance of dq's noise in the first block [(rad/s)^2]

  double intended() const noexcept {  // duration of the current block [s]
    return begins_ ? 0.5 * target_ : hurries_ ? kDuration : target_;
  }
  void begin() noexcept;
  void learn_noise() noexcept;
  void shrink() noexcept;
  void begin_part() noexcept {
    part_velocity_.setZero();
    part_difference_.setZero();
    part_change_ = part_twist_ = Twist<Scalar>();
    part_duration_ = part_weight_ = part_motion_weight_ = Scalar(0);
    part_motion_ = FlangeMotion<Scalar>();
    part_jacobian_ = last_.jacobian;
    part_rotation_ = last_.rotation;
  }
  void end_part() noexcept;

  double bandwidth_;
  Vector3<Scalar> gravity_;
  double longest_;
  bool started_ = false;
  Proprioception<Scalar, Dofs> last_;
  Twist<Scalar> last_twist_;  // J dq of the last sample
  JointVector<Scalar, Dofs> torque_ = JointVector<Scalar, Dofs>::Zero();
  JointVector<Scalar, Dofs> difference_ = JointVector<Scalar, Dofs>::Zero();  // last change of dq, sample to sample
  JointVector<Scalar, Dofs> step_ = JointVector<Scalar, Dofs>::Zero();
  std::array<bool, static_cast<std::size_t>(Dofs)> rounds_{};  // two samples of dq were the same: it is rounded
  // Smallest change of dq so far [rad/s].
  JointVector<Scalar, Dofs> velocity_step_ = JointVector<Scalar, Dofs>::Constant(std::numeric_limits<Scalar>::max());
  int samples_ = 0;
  // Of the current part of the block.
  JointVector<Scalar, Dofs> part_velocity_, part_difference_;  // weighted sums of dq, and of its changes
  Twist<Scalar> part_change_, part_twist_;                     // weighted sums of the changes of J dq, and of J dq
  Scalar part_duration_ = Scalar(0), part_weight_ = Scalar(0), part_motion_weight_ = Scalar(0);
  FlangeMotion<Scalar> part_motion_;      // weighted sum of the motion that the host passes
  Jacobian<Scalar, Dofs> part_jacobian_;  // of the sample before its first one
  Matrix3<Scalar> part_rotation_;
  // Of the current block.
  int parts_ = 0, differences_ = 0;
  Scalar skipped_ = Scalar(0);  // time left out before it [s]
  bool begins_ = false;         // restart() began it
  bool hurries_ = false;        // hurry()
  Scalar duration_ = Scalar(0), weight_ = Scalar(0);
  JointVector<Scalar, Dofs> changes_;     // weighted sum of the changes of dq
  JointVector<Scalar, Dofs> unmeasured_;  // the same over the parts whose motion the host does not give
  Scalar unmeasured_weight_ = Scalar(0);
  Scalar shape_ = Scalar(0), roughness_ = Scalar(0);  // last sample's weight; sum of the squared changes of the weights
  JointVector<Scalar, Dofs> carried_;                 // weighted sum of the compensation
  Scalar carried_weight_ = Scalar(0);
  JointVector<Scalar, Dofs> squares_;  // sum of the squared second differences of dq, over 6
  TorqueBlock<Scalar, Dofs> sums_, block_;
  JointVector<Scalar, Dofs> noise_ = JointVector<Scalar, Dofs>::Constant(Scalar(1e-8));  // of dq [(rad/s)^2]
  int noise_blocks_ = 0;       // number of blocks that noise_ is the mean of, at most kNoiseMemory - 1
  double target_ = kDuration;  // duration of a block, unless something begins with it [s]
  ShrunkRate<Scalar, RateNoise::Known> acceleration_[Dofs];
  ShrunkRate<Scalar, RateNoise::Learned> torque_rate_[Dofs];
};

template <typename Scalar, int Dofs>
void BlockAverager<Scalar, Dofs>::begin() noexcept {
  begin_part();
  parts_ = differences_ = 0;
  duration_ = weight_ = unmeasured_weight_ = carried_weight_ = shape_ = roughness_ = Scalar(0);
  changes_.setZero();
  unmeasured_.setZero();
  carried_.setZero();
  sums_.tau.setZero();
  sums_.torque_rate.setZero();
  sums_.regressor.setZero();
  sums_.velocity.setZero();
  sums_.velocities.setZero();
  squares_.setZero();
  sums_.samples = 0;
}

/// Updates the noise of dq with the block's second differences, and computes the duration of the next block.
template <typename Scalar, int Dofs>
void BlockAverager<Scalar, Dofs>::learn_noise() noexcept {
  if (differences_ > 0) {
    // At first the mean of all blocks: the noise has to be known soon, before it is taken for motion.
    const Scalar blend = Scalar(1) / static_cast<Scalar>(noise_blocks_ + 1);
    for (int j = 0; j < Dofs; ++j) {
      const Scalar seen = squares_[j] / Scalar(differences_);
      // Single large values are limited: they come from changes of the acceleration, not from noise.
      const Scalar most = noise_blocks_ > 0 ? 25 * noise_[j] + Scalar(1e-8) : Scalar(kNoisiest);
      noise_[j] += blend * (std::min(seen, most) - noise_[j]);
    }
    noise_blocks_ = std::min(noise_blocks_ + 1, kNoiseMemory - 1);
  }
  // Variance of the noise of the flange's velocity, along the axis where it is largest.
  Scalar largest = Scalar(0);
  for (int axis = 0; axis < 3; ++axis) {
    Scalar sum = Scalar(0);
    for (int j = 0; j < Dofs; ++j) sum += last_.jacobian(axis, j) * last_.jacobian(axis, j) * noise_[j];
    largest = std::max(largest, sum);
  }
  const auto variance = static_cast<double>(largest);
  const double period = static_cast<double>(duration_) / std::max(1, sums_.samples);
  // The slope has the variance 12 variance / (n T^2) from n = T / period samples; solved for T.
  target_ = std::max(kDuration, std::min(longest_, std::cbrt(12 * period * variance / (kFeigned * kFeigned))));
}

/// Takes what counts as noise out of the block's accelerations and of the rate of its torque.
template <typename Scalar, int Dofs>
void BlockAverager<Scalar, Dofs>::shrink() noexcept {
  // A weighted mean of differences, sum_i c_i (x_i - x_i-1), is a weighted sum of samples with the weights c_i - c_i+1.
  // So white noise of variance 1 gives it the variance sum_i (c_i - c_i+1)^2: 12 / (n T^2) for many samples, 2 / T^2
  // for one.
  const Scalar slope = (roughness_ + shape_ * shape_) / (weight_ * weight_);
  const Scalar own = unmeasured_weight_ / weight_;  // share of the block whose motion the host does not give
  JointVector<Scalar, Dofs> noise;                  // the part of the accelerations that counts as noise [rad/s^2]
  Scalar linear = Scalar(0), angular = Scalar(0);
  for (int j = 0; j < Dofs; ++j) {
    const auto kept = acceleration_[j].update(changes_[j] / weight_, slope * noise_[j]);
    noise[j] = (Scalar(1) - kept.share) * unmeasured_[j] / weight_;
    for (int axis = 0; axis < 3; ++axis) {
      linear += kept.variance * last_.jacobian(axis, j) * last_.jacobian(axis, j);
      angular += kept.variance * last_.jacobian(3 + axis, j) * last_.jacobian(3 + axis, j);
    }
    // The rounding error of a quantised torque is at most half a step.
    const Scalar rounding = Scalar(0.25) * step_[j] * step_[j];
    sums_.torque_rate[j] = torque_rate_[j].update(sums_.torque_rate[j], slope * rounding).mean;
  }
  sums_.acceleration_variance = own * own * linear / 3;
  sums_.angular_acceleration_variance = own * own * angular / 3;
  // The regressor is linear in the acceleration: what has to be taken out is that of the noise alone.
  const Vector6<Scalar> twist = detail::product(last_.jacobian, noise);
  FlangeMotion<Scalar> motion;
  motion.linear_acceleration = twist.template head<3>();
  motion.angular_acceleration = twist.template tail<3>();
  const Eigen::Matrix<Scalar, 6, kInertial> wrench =
      inertial_wrench_regressor<Scalar>(last_.rotation, Vector3<Scalar>::Zero(), motion);
  detail::add_scaled(sums_.regressor, Scalar(-1), detail::transposed_product(last_.jacobian, wrench));
}

template <typename Scalar, int Dofs>
bool BlockAverager<Scalar, Dofs>::add(const Proprioception<Scalar, Dofs>& sample, double dt, double time) noexcept {
  const auto twist = Twist<Scalar>::from_vector(detail::product(sample.jacobian, sample.dq));
  if (!started_) {
    started_ = true;
    samples_ = 0;
    last_ = sample;
    last_twist_ = twist;
    torque_ = sample.tau_ext;
    begin();
    return false;
  }
  // The observer may run faster than the host: over n = dt / p of its periods, b = 1 - (1 - K p)^n.
  const double gain = std::min(1.0, bandwidth_ * kObserverPeriod);
  const auto blend = bandwidth_ > 0 ? static_cast<Scalar>(1 - std::pow(1 - gain, dt / kObserverPeriod)) : Scalar(1);
  const Scalar invert = Scalar(1) / std::max(blend, Scalar(1e-6));
  for (int j = 0; j < Dofs; ++j) {
    const Scalar change = sample.tau_ext[j] - last_.tau_ext[j], step = std::abs(change);
    torque_[j] = last_.tau_ext[j] + change * invert;
    if (step > Scalar(1e-7) && (step < step_[j] || step_[j] == Scalar(0))) step_[j] = step;
    // Second differences of dq are free of a constant acceleration. Noise of variance sigma^2 gives them 6 sigma^2.
    const Scalar difference = sample.dq[j] - last_.dq[j], second = difference - difference_[j];
    if (difference == Scalar(0))
      rounds_[static_cast<std::size_t>(j)] = true;
    else if (std::abs(difference) > Scalar(1e-7))
      velocity_step_[j] = std::min(velocity_step_[j], std::abs(difference));
    if (samples_ > 0) squares_[j] += second * second / Scalar(6);
    difference_[j] = difference;
  }
  if (samples_ > 0) ++differences_;
  ++samples_;
  const auto h = static_cast<Scalar>(dt);
  const Scalar along = (duration_ + part_duration_ + Scalar(0.5) * h) / static_cast<Scalar>(intended());
  // Kept above zero, since a block whose periods jitter may last longer than intended.
  const Scalar shape = std::max(Scalar(0.05), 6 * along * (Scalar(1) - along)), weight = h * shape;
  detail::add_scaled(sums_.tau, weight, torque_);
  detail::add_scaled(sums_.torque_rate, shape, detail::difference(sample.tau_ext, last_.tau_ext));
  detail::add_scaled(part_velocity_, h, sample.dq);
  detail::add_scaled(part_difference_, shape, difference_);
  roughness_ += (shape - shape_) * (shape - shape_);
  shape_ = shape;
  if (sample.compensation) {
    detail::add_scaled(carried_, weight, *sample.compensation);
    carried_weight_ += weight;
  }
  part_duration_ += h;
  part_weight_ += weight;
  detail::add_scaled(part_change_.linear, shape, detail::difference(twist.linear, last_twist_.linear));
  detail::add_scaled(part_change_.angular, shape, detail::difference(twist.angular, last_twist_.angular));
  detail::add_scaled(part_twist_.angular, Scalar(0.5) * weight, twist.angular);
  detail::add_scaled(part_twist_.angular, Scalar(0.5) * weight, last_twist_.angular);
  if (sample.motion) {
    detail::add_scaled(part_motion_.angular_velocity, weight, sample.motion->angular_velocity);
    detail::add_scaled(part_motion_.linear_acceleration, weight, sample.motion->linear_acceleration);
    detail::add_scaled(part_motion_.angular_acceleration, weight, sample.motion->angular_acceleration);
    part_motion_weight_ += weight;
  }
  last_ = sample;
  last_twist_ = twist;
  // A tolerance of half a period, so that jitter does not make every other block longer.
  const double slack = 0.5 * dt;
  ++sums_.samples;
  const bool complete = static_cast<double>(duration_ + part_duration_) + slack >= intended();
  // The end of this part on the block's time scale, so that errors of the parts' durations do not add up.
  const double end_of_part = intended() * (parts_ + 1) / kBlockParts;
  if (complete || static_cast<double>(duration_ + part_duration_) + slack >= end_of_part) end_part();
  if (!complete) return false;

  sums_.end = time;
  sums_.duration = duration_;
  sums_.skipped = skipped_;
  const bool brief = static_cast<double>(duration_) < 0.75 * target_;  // a slow host has no shorter one
  sums_.usual = brief ? static_cast<Scalar>(target_) : Scalar(0);
  skipped_ = Scalar(0);
  begins_ = hurries_ = false;
  sums_.tau /= weight_;
  sums_.torque_rate /= weight_;
  sums_.regressor /= weight_;
  sums_.velocity /= duration_;
  for (int j = 0; j < Dofs; ++j) {
    const Scalar least = rounds_[static_cast<std::size_t>(j)] ? Scalar(kResolved) * velocity_step_[j] : Scalar(0);
    const auto resolved = [least](Scalar v) { return std::abs(v) > least ? v : Scalar(0); };
    sums_.velocity[j] = resolved(sums_.velocity[j]);
    for (int i = 0; i < kBlockParts; ++i)
      sums_.velocities(j, i) = resolved(sums_.velocities(j, std::min(i, parts_ - 1)));
  }
  learn_noise();
  shrink();
  if (carried_weight_ > Scalar(0.5) * weight_)
    sums_.carried = detail::scaled(Scalar(1) / carried_weight_, carried_);
  else
    sums_.carried.reset();
  sums_.gravity_torque = sample.gravity_torque;
  sums_.velocity_noise = noise_;
  sums_.torque_step = step_;
  sums_.jacobian = sample.jacobian;
  sums_.rotation = sample.rotation;
  block_ = sums_;
  begin();
  return true;
}

template <typename Scalar, int Dofs>
void BlockAverager<Scalar, Dofs>::end_part() noexcept {
  FlangeMotion<Scalar> motion;
  if (part_motion_weight_ > Scalar(0.5) * part_weight_) {
    const Scalar mean = Scalar(1) / part_motion_weight_;
    motion.angular_velocity = detail::scaled(mean, part_motion_.angular_velocity);
    motion.linear_acceleration = detail::scaled(mean, part_motion_.linear_acceleration);
    motion.angular_acceleration = detail::scaled(mean, part_motion_.angular_acceleration);
  } else {
    const Scalar mean = Scalar(1) / part_weight_;
    motion.angular_velocity = detail::scaled(mean, part_twist_.angular);
    motion.linear_acceleration = detail::scaled(mean, part_change_.linear);
    motion.angular_acceleration = detail::scaled(mean, part_change_.angular);
    unmeasured_ += part_difference_;
    unmeasured_weight_ += part_weight_;
  }
  changes_ += part_difference_;
  sums_.velocity += part_velocity_;
  // In the pose of the middle of the part, the mean of those at its ends. At its end alone, torque and regressor would
  // be 2.5 ms apart: millimetres of a payload's centre after a quick turn.
  part_jacobian_ += last_.jacobian;
  part_jacobian_ *= Scalar(0.5);
  part_rotation_ += last_.rotation;
  part_rotation_ *= Scalar(0.5);
  const Eigen::Matrix<Scalar, 6, kInertial> wrench =
      inertial_wrench_regressor<Scalar>(part_rotation_, gravity_, motion);
  detail::add_scaled(sums_.regressor, part_weight_, detail::transposed_product(part_jacobian_, wrench));
  for (int j = 0; j < Dofs; ++j) sums_.velocities(j, parts_) = part_velocity_[j] / part_duration_;
  ++parts_;
  duration_ += part_duration_;
  weight_ += part_weight_;
  begin_part();
}

}  // namespace rme
