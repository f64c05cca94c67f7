#pragma once
/// The samples of one event, as the sums that inference needs: from its onset on, whenever that comes to be known.
#include <algorithm>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <rme/core/types.hpp>
#include <rme/event_estimator_config.hpp>
#include <rme/inference/payload_regressor.hpp>
#include <rme/inference/payload_statistics.hpp>
#include <rme/inference/window_statistics.hpp>
#include <rme/sensing/onset.hpp>
#include <rme/sensing/sample_window.hpp>

namespace rme {

/// What is known of the change that is going on: the instant at which it happened, if that is sharp, and the sums of
/// the samples since then. Those after it has settled are kept apart, since they alone tell a payload from a push. Real
/// time: no call allocates or throws. locate() is O(range Dofs), sums() and quiet_sums() are O(count Dofs), all others
/// O(Dofs).
template <typename Scalar, int Dofs>
class EventSamples {
 public:
  using Statistics = PayloadStatistics<Scalar, Dofs>;

  /// @param dt      control period [s]
  /// @param config  valid (EventEstimatorConfig::validate()), with one sensor model at least
  EventSamples(double dt, const EventEstimatorConfig<Scalar, Dofs>& config) noexcept
      : gravity_(config.gravity),
        gyration_radius_(static_cast<Scalar>(config.gyration_radius)),
        jump_(static_cast<Scalar>(config.onset_jump)),
        span_(static_cast<std::size_t>(std::lround(config.onset_span / dt))),
        guard_(static_cast<std::size_t>(std::lround(config.onset_guard / dt))),
        block_(static_cast<int>(std::max(1L, std::lround(block_duration(config) / dt)))),
        since_onset_(block_),
        settled_(block_) {}

  /// What one kilogram would do in this sample.
  PayloadRegressor<Scalar, Dofs> regressor(const Sample<Scalar, Dofs>& sample) const noexcept {
    return payload_regressor<Scalar, Dofs>(sample.raw.jacobian, sample.raw.rotation, gravity_, sample.motion,
                                           gyration_radius_);
  }
  /// The sums of `count` samples, or as many as there are, the newest of them of age `newest`, as of a loaded hand.
  WindowStatistics<Scalar, Dofs> sums(const SampleWindow<Scalar, Dofs>& window, std::size_t newest,
                                      std::size_t count) const noexcept {
    WindowStatistics<Scalar, Dofs> out(block_);
    for (std::size_t age = std::min(window.size(), newest + count); age-- > newest;)
      out.add(observation(window.newest(age)));
    return out;
  }
  /// The same of an empty hand, about which there is no payload to ask.
  WindowStatistics<Scalar, Dofs> quiet_sums(const SampleWindow<Scalar, Dofs>& window, std::size_t newest,
                                            std::size_t count) const noexcept {
    WindowStatistics<Scalar, Dofs> out(block_);
    for (std::size_t age = std::min(window.size(), newest + count); age-- > newest;) {
      const Sample<Scalar, Dofs>& sample = window.newest(age);
      out.add({sample.tau, PayloadRegressor<Scalar, Dofs>(), sample.direction, sample.raw.dq});
    }
    return out;
  }

  /// Nothing is going on.
  void clear() noexcept {
    forget_onset();
    settled_.clear();
  }
  /// When it began is not known any more, and what was gathered before it settled does not count.
  void forget_onset() noexcept {
    onset_known_ = false;
    since_onset_.clear();
  }

  /// Adds the sample of this tick, if the onset is known.
  void add(const Sample<Scalar, Dofs>& sample, std::uint64_t tick) noexcept {
    if (onset_known_ && tick >= first_tick_) since_onset_.add(observation(sample));
  }
  /// Adds the sample of this tick to those after the change has settled.
  void add_settled(const Sample<Scalar, Dofs>& sample, std::uint64_t tick) noexcept {
    if (settled_.count() == 0) settled_tick_ = tick;
    settled_.add(observation(sample));
  }

  /// A step is an onset if it is sharp and large enough.
  bool is_onset(const Onset<Scalar>& onset) const noexcept { return onset.sharp() && onset.jump > jump_; }
  /// Looks for the instant of the change among the newest `range` samples. If it is another than before, all samples
  /// since then are gathered anew, the settled ones among them. Of a slow hand-over, which has no such instant, nothing
  /// is gathered.
  /// @param tick  of the newest sample
  /// @return whether there is one
  bool locate(const SampleWindow<Scalar, Dofs>& window, std::uint64_t tick, std::size_t range) noexcept;

  bool onset_known() const noexcept { return onset_known_; }
  /// Tick of the first sample that is in the sums.
  std::uint64_t first_tick() const noexcept { return onset_known_ ? first_tick_ : settled_tick_; }
  /// Samples since the change has settled.
  std::size_t settled_count() const noexcept { return static_cast<std::size_t>(settled_.count()); }
  /// Sums of all samples, and of the settled ones among them.
  struct Sums {
    Statistics all, settled;
  };
  /// For the model that is linear about com_guess [m], end-effector axes.
  Sums about(const Vector3<Scalar>& com_guess) const noexcept {
    Sums sums{since_onset_.about(com_guess), settled_.about(com_guess)};
    sums.all += sums.settled;
    return sums;
  }

 private:
  /// Of ticks whose noise is correlated: together they say little more than one of them.
  static double block_duration(const EventEstimatorConfig<Scalar, Dofs>& config) noexcept {
    return std::min(config.collection, 2 * static_cast<double>(config.sensors.front().noise_correlation_time));
  }
  PayloadObservation<Scalar, Dofs> observation(const Sample<Scalar, Dofs>& sample) const noexcept {
    return {sample.tau, regressor(sample), sample.direction, sample.raw.dq};
  }

  Vector3<Scalar> gravity_;
  Scalar gyration_radius_;
  Scalar jump_;               // that an onset needs [N m]
  std::size_t span_, guard_;  // ticks
  int block_;                 // ticks that are averaged before they enter the sums
  bool onset_known_ = false;
  std::uint64_t onset_tick_ = 0;                // of the first sample after the step
  std::uint64_t first_tick_ = 0;                // of the first one that is used
  std::uint64_t settled_tick_ = 0;              // of the first settled one
  WindowStatistics<Scalar, Dofs> since_onset_;  // until it has settled
  WindowStatistics<Scalar, Dofs> settled_;
};

template <typename Scalar, int Dofs>
bool EventSamples<Scalar, Dofs>::locate(const SampleWindow<Scalar, Dofs>& window, std::uint64_t tick,
                                        std::size_t range) noexcept {
  const Onset<Scalar> onset = find_onset(window, range, span_);
  if (!is_onset(onset)) return false;
  if (onset.age < span_ + 2) return true;  // the step is not wholly in view yet
  const std::uint64_t at = tick - onset.age;
  if (onset_known_ && at + span_ >= onset_tick_ && at <= onset_tick_ + span_) return true;  // as before
  onset_known_ = true;
  onset_tick_ = at;
  first_tick_ = at + guard_;
  settled_.clear();
  const std::size_t after = onset.age + 1;
  since_onset_ = sums(window, 0, after - std::min(after, guard_));
  return true;
}

}  // namespace rme
