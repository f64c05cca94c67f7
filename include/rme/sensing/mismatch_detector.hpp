#pragma once
/// Detects that an object was attached, added or removed (Algorithm 1 of the paper).
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/ring_buffer.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>

namespace rme {

/// Settings of MismatchDetector. Ages are seconds before the newest sample.
struct MismatchDetectorConfig {
  double window = 0.5;                   ///< age of the oldest sample, compared with the newest [s]: 2 to 1e7 periods
  double activation_threshold = 0.7;     ///< a change above this is rapid [N m], > 0
  double stabilisation_threshold = 0.2;  ///< how far the means below may lie from the newest one [N m], > 0
  double stabilisation_ratio = 0.05;     ///< the same as a share of the change, 0 <= ratio < 1; the larger counts
  double newest_average = 0.01;          ///< span of the newest mean [s], 0 to window
  double check_average = 0.02;           ///< span of each of the means compared with it [s], 0 to window
  std::array<double, 3> check_age = {0.05, 0.13, 0.21};  ///< of the newest sample in each span [s], >= 0
  /// Span of the two means whose difference is the rapid change [s], 0 to window. 0 compares two single samples, as
  /// published. A single sample jumps at once, while the stabilisation means are still at the old level. So the
  /// published form detects a sharp step after a few milliseconds, and its collection includes the transient. With
  /// means this does not happen.
  double edge_average = 0.02;

  /// Algorithm 1 as published, for the norm of tau_ext.
  static MismatchDetectorConfig published() {
    MismatchDetectorConfig config;
    config.activation_threshold = 0.9;
    config.stabilisation_ratio = 0;
    config.edge_average = 0;
    return config;
  }
};

/// Watches a signal s of `Channels` numbers. A mismatch is detected if the signal has changed rapidly over the window
/// and has settled since (docs/theory.md (T44)):
///
///     ||s(newest) - s(oldest)|| > activation    and    ||mean_i - mean(newest)|| <= stabilisation,  i = 1, 2, 3
///
/// With one channel, s = ||tau_ext||_2, this is Algorithm 1. With one channel per joint, changes that leave the norm as
/// it was are detected too. Each mean is the difference of two running sums, which are 64-bit integers in units of
/// 2^-32 N m. So update() is O(Channels) for any span, and rounding errors do not accumulate.
template <int Channels>
class MismatchDetector {
 public:
  using Signal = Eigen::Matrix<double, Channels, 1>;  ///< [N m]

  /// @param dt      control period [s], > 0
  /// @param config  thresholds and spans
  /// @throws std::invalid_argument naming the field out of range
  explicit MismatchDetector(double dt, const MismatchDetectorConfig& config = MismatchDetectorConfig());

  /// Advances by one period.
  /// @param signal  s [N m], Channels x 1
  /// @return Ok; NonFiniteInput, also for an entry beyond kLargestPlausible: the detector is then as it was
  Status update(const Signal& signal) noexcept;

  bool rapid_change() const noexcept { return rapid_change_; }             ///< false until the window is full
  bool stabilised() const noexcept { return stabilised_; }                 ///< false until the window is full
  bool detected() const noexcept { return rapid_change_ && stabilised_; }  ///< both
  /// Forgets all samples: nothing is detected until a whole window has passed.
  void reset() noexcept;

 private:
  static constexpr double kResolution = 1.0 / 4294967296.0;  // 2^-32 N m
  // Unsigned, since a running sum may wrap around; differences are right even then.
  using Sums = std::array<std::uint64_t, static_cast<std::size_t>(Channels)>;
  struct Span {  // samples of age begin .. begin + count - 1
    std::size_t begin = 0, count = 1;
  };

  Signal mean(const Span& span) const noexcept {
    const Sums& newer = sums_.newest(span.begin);
    const Sums& older = sums_.newest(span.begin + span.count);
    Signal out;
    for (std::size_t i = 0; i < newer.size(); ++i)
      out[static_cast<int>(i)] =
          static_cast<double>(static_cast<std::int64_t>(newer[i] - older[i])) * (kResolution / double(span.count));
    return out;
  }

  double activation_, stabilisation_, ratio_;
  Span oldest_edge_, newest_edge_, newest_;
  std::array<Span, 3> checks_;
  RingBuffer<Sums> sums_;  // running sums up to and including each sample
  bool rapid_change_ = false, stabilised_ = false;
};

namespace detail {
/// Seconds to whole samples.
inline std::size_t samples(double seconds, double dt) noexcept {
  return static_cast<std::size_t>(std::lround(seconds / dt));
}
}  // namespace detail

template <int Channels>
MismatchDetector<Channels>::MismatchDetector(double dt, const MismatchDetectorConfig& config)
    : activation_(config.activation_threshold),
      stabilisation_(config.stabilisation_threshold),
      ratio_(config.stabilisation_ratio),
      sums_(1) {
  using detail::require_positive;
  require_positive(dt, "MismatchDetector::dt", "> 0 s");
  require_positive(config.activation_threshold, "MismatchDetectorConfig::activation_threshold", "> 0 N m");
  require_positive(config.stabilisation_threshold, "MismatchDetectorConfig::stabilisation_threshold", "> 0 N m");
  require_positive(config.window, "MismatchDetectorConfig::window", "> 0 s");
  detail::require(ratio_ >= 0 && ratio_ < 1, "MismatchDetectorConfig::stabilisation_ratio", "0 to 1", ratio_);
  detail::require(config.window / dt >= 2 && config.window / dt < 1e7, "MismatchDetectorConfig::window",
                  "2 to 1e7 samples", config.window / dt);
  const std::size_t window = detail::samples(config.window, dt);
  const auto span = [&](double age, double length, const char* field) {
    Span s;
    detail::require(age >= 0 && length >= 0 && age + length <= config.window, field, "0 s to the window", age + length);
    s.count = std::max<std::size_t>(1, detail::samples(length, dt));
    s.begin = std::min(detail::samples(age, dt), window - s.count);
    return s;
  };
  newest_edge_ = span(0, config.edge_average, "MismatchDetectorConfig::edge_average");
  oldest_edge_ = newest_edge_;
  oldest_edge_.begin = window - oldest_edge_.count;
  newest_ = span(0, config.newest_average, "MismatchDetectorConfig::newest_average");
  detail::require(config.check_average >= 0 && config.check_average <= config.window,
                  "MismatchDetectorConfig::check_average", "0 s to the window", config.check_average);
  for (std::size_t i = 0; i < checks_.size(); ++i)
    checks_[i] = span(config.check_age[i], config.check_average, "MismatchDetectorConfig::check_age");
  sums_ = RingBuffer<Sums>(window + 1);
  reset();
}

template <int Channels>
void MismatchDetector<Channels>::reset() noexcept {
  sums_.clear();
  sums_.push(Sums{});
  rapid_change_ = stabilised_ = false;
}

template <int Channels>
Status MismatchDetector<Channels>::update(const Signal& signal) noexcept {
  if (!plausible(signal)) return Status::NonFiniteInput;
  Sums sums = sums_.newest();
  for (std::size_t i = 0; i < sums.size(); ++i)
    sums[i] += static_cast<std::uint64_t>(std::llround(signal[static_cast<int>(i)] / kResolution));
  sums_.push(sums);
  if (!sums_.full()) return Status::Ok;
  const double change = (mean(newest_edge_) - mean(oldest_edge_)).norm();
  const double allowed = std::max(stabilisation_, ratio_ * change);
  const Signal end = mean(newest_);
  rapid_change_ = change > activation_;
  stabilised_ = true;
  for (const Span& check : checks_)
    if ((mean(check) - end).norm() > allowed) stabilised_ = false;
  return Status::Ok;
}

}  // namespace rme
