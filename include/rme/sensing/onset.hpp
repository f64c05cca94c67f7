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

/// Largest distance between the mean torques of the four quarters of the newest `count` samples, ||.||_2 [N m]: small
/// when nothing happened within them. 0 for fewer than four samples. Real time: O(count Dofs).
template <typename Scalar, int Dofs>
Scalar unrest(const SampleWindow<Scalar, Dofs>& window, std::size_t count) noexcept {
  const std::size_t quarter = std::min(count, window.size()) / 4;
  if (quarter == 0) return Scalar(0);
  Eigen::Matrix<Scalar, Dofs, 4> mean = Eigen::Matrix<Scalar, Dofs, 4>::Zero();
  for (std::size_t age = 0; age < 4 * quarter; ++age)
    mean.col(static_cast<int>(age / quarter)) += window.newest(age).tau / Scalar(quarter);
  Scalar largest = Scalar(0);
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < i; ++j) largest = std::max(largest, (mean.col(i) - mean.col(j)).norm());
  return largest;
}

}  // namespace rme
