#include "replay_log/replay.hpp"

#include <algorithm>
#include <cmath>
#include <cstdio>

namespace rme::examples {

double nominal_period(const std::vector<double>& t) {
  std::vector<double> steps(t.size() - 1);
  for (std::size_t i = 0; i + 1 < t.size(); ++i) steps[i] = t[i + 1] - t[i];
  const auto middle = steps.begin() + static_cast<std::ptrdiff_t>(steps.size() / 2);
  std::nth_element(steps.begin(), middle, steps.end());
  return *middle;
}

double observer_blend(double bandwidth, double period) {
  constexpr double kPeriod = 0.001;  // [s]
  return bandwidth > 0 ? 1 - std::pow(1 - std::min(1.0, bandwidth * kPeriod), period / kPeriod) : 1;
}

std::vector<std::string> LogTiming::notes() const {
  std::vector<std::string> out;
  const auto say = [&out](const char* format, auto... values) {
    char text[200];
    std::snprintf(text, sizeof text, format, values...);
    out.emplace_back(text);
  };
  if (longest > 1.1 * period || shortest < 0.9 * period)
    say("steps of %.3g to %.3g ms: every sample counts for the time that its stamp says", 1e3 * shortest,
        1e3 * longest);
  if (gaps > 0)
    say("%zu gap%s, the longest of %.3g s: what happened there is not known", gaps, gaps > 1 ? "s" : "", longest_gap);
  if (same_instant > 0) say("%zu rows have the time stamp of the row before: left out", same_instant);
  if (held > 0) say("%zu rows repeat the row before while the arm moves: left out", held);
  return out;
}

}  // namespace rme::examples
