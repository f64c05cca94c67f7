#include "rivals/run_score.hpp"

#include <algorithm>
#include <cmath>
#include <limits>

namespace rme::examples {

RunScore score_run(const std::vector<MassAt>& masses, double truth, double begin, double moved) {
  constexpr double kSettles = 5, kClose = 0.1, kStays = 1;  // [s], -, [s]
  constexpr double kNinety = 1.6448536269514722;            // half width of a Gaussian's 90 % interval
  RunScore out;
  double time = 0, near_since = masses.front().t;
  out.close = std::numeric_limits<double>::quiet_NaN();
  for (std::size_t i = 0; i < masses.size(); ++i) {
    const MassAt& now = masses[i];
    const double error = std::abs(now.mass - truth), step = i > 0 ? now.t - masses[i - 1].t : 0;
    out.largest_mass = std::max(out.largest_mass, now.mass);
    if (now.t >= moved) out.largest_error = std::max(out.largest_error, error);
    if (!(error < kClose * truth)) near_since = now.t;
    if (std::isnan(out.close) && now.t - near_since >= kStays) out.close = near_since - begin;
    if (now.t < begin + kSettles) continue;
    out.mean_error += step * error;
    out.held += std::isnan(now.deviation) ? now.deviation : (error <= kNinety * now.deviation ? step : 0);
    time += step;
  }
  out.end_error = std::abs(masses.back().mass - truth);
  if (time > 0) {
    out.mean_error /= time;
    out.held /= time;
  } else {  // one estimate, made at the end
    out.mean_error = out.end_error;
    out.held = std::numeric_limits<double>::quiet_NaN();
  }
  return out;
}

}  // namespace rme::examples
