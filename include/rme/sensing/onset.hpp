#pragma once
/// When did it happen? The instant of a step in the external torque, looked for backwards.
#include <algorithm>
#include <cstddef>
#include <rme/core/types.hpp>
#include <rme/sensing/sample_window.hpp>

namespace rme {

/// A step found in a SampleWindow.
template <typename Scalar>
struct Onset {
  std::size_t age = 0;       ///< of the first sample after the step [ticks]
  Scalar jump = Scalar(0);   ///< size of the step, ||mean after - mean before||_2 [N m]
  Scalar total = Scalar(0);  ///< how far any mean of the range searched lies from its oldest one [N m]

  Scalar usual = Scalar(0);  ///< size of a step anywhere in the range, on average [N m]

  /// Whether the step is most of what changed, and stands out. A slow hand-over has a largest step too, but it is a
  /// small part of it; noise has many that are as large.
  bool sharp() const noexcept { return jump > Scalar(0.5) * total && jump > 4 * usual; }
};

/// Finds where the means of the `span` samples before and after differ most, among the newest `range` samples. With the
/// observer's lag taken out, an object that is attached is a step from one sample to the next.
/// Real time: O(range Dofs). Needs range >= 2 span, and as many samples; otherwise jump is 0.
template <typename Scalar, int Dofs>
Onset<Scalar> find_onset(const SampleWindow<Scalar, Dofs>& window, std::size_t range, std::size_t span) noexcept {
  Onset<Scalar> onset;
  range = std::min(range, window.size());
  if (span == 0 || range < 2 * span) return onset;
  const auto mean = [&](std::size_t age) {  // of the span samples from `age` on backwards
    JointVector<Scalar, Dofs> sum = JointVector<Scalar, Dofs>::Zero();
    for (std::size_t i = 0; i < span; ++i) sum += window.newest(age + i).tau;
    return JointVector<Scalar, Dofs>(sum / Scalar(span));
  };
  // Sums over the two spans that meet between ages k - 1 and k; each move by one tick swaps two samples.
  JointVector<Scalar, Dofs> after = mean(0), before = mean(span);
  const JointVector<Scalar, Dofs> oldest = mean(range - span);
  for (std::size_t k = span;; ++k) {
    const Scalar jump = (after - before).norm();
    onset.total = std::max(onset.total, (after - oldest).norm());
    onset.usual += jump / Scalar(range - 2 * span + 1);
    if (jump > onset.jump) {
      onset.jump = jump;
      onset.age = k - 1;
    }
    if (k + span >= range) break;
    after += (window.newest(k).tau - window.newest(k - span).tau) / Scalar(span);
    before += (window.newest(k + span).tau - window.newest(k).tau) / Scalar(span);
  }
  return onset;
}

/// Whether anything happened within a span of `count` samples, fed one by one: largest distance between the mean
/// torques of its four quarters, ||.||_2 [N m], small at rest. What `count` has over a multiple of four is left out at
/// the beginning. Real time: O(Dofs) per call.
template <typename Scalar, int Dofs>
class Unrest {
 public:
  explicit Unrest(std::size_t count) noexcept : quarter_(count / 4), left_out_(count % 4) {}

  void clear() noexcept {
    sum_.setZero();
    added_ = 0;
  }
  /// Samples after the `count`th say nothing.
  void add(const JointVector<Scalar, Dofs>& tau) noexcept {
    const std::size_t index = added_++;
    if (index >= left_out_ && index < left_out_ + 4 * quarter_)
      sum_.col(static_cast<int>((index - left_out_) / quarter_)) += tau;
  }
  /// Of the whole span; 0 if that is shorter than four samples. Requires `count` samples.
  Scalar value() const noexcept {
    Scalar largest = Scalar(0);
    if (quarter_ == 0) return largest;
    for (int i = 0; i < 4; ++i)
      for (int j = 0; j < i; ++j) largest = std::max(largest, (sum_.col(i) - sum_.col(j)).norm());
    return largest / Scalar(quarter_);
  }

 private:
  std::size_t quarter_, left_out_, added_ = 0;
  Eigen::Matrix<Scalar, Dofs, 4> sum_ = Eigen::Matrix<Scalar, Dofs, 4>::Zero();
};

/// The same of the newest `count` samples of a window, or all that it has. Real time: O(count Dofs).
template <typename Scalar, int Dofs>
Scalar unrest(const SampleWindow<Scalar, Dofs>& window, std::size_t count) noexcept {
  count = std::min(count, window.size());
  Unrest<Scalar, Dofs> out(count);
  for (std::size_t age = count; age-- > 0;) out.add(window.newest(age).tau);
  return out.value();
}

}  // namespace rme
