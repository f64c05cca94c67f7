#pragma once
/// Errors of a method's masses during a log in which the hand holds the same all the time.
#include <vector>

#include "rivals/rivals.hpp"

namespace rme::examples {

struct RunScore {
  double mean_error = 0;     ///< mean over time, from 5 s on [kg]
  double largest_error = 0;  ///< after the arm has moved for 2 s in all [kg]
  double end_error = 0;      ///< of the last estimate [kg]
  double close = 0;          ///< after which the error has stayed below 10 % of the mass for a second [s]; NaN: never
  double largest_mass = 0;   ///< at any time [kg]: of an empty hand, the false mass
  double held = 0;  ///< share of the time from 5 s on in which the 90 % interval holds the mass; NaN: no interval
};

/// @param masses  of one method, in order of time; at least one
/// @param truth   mass in the hand [kg]
/// @param begin   of the log [s]
/// @param moved   when the arm has moved for 2 s in all [s], moved_for(log, 2)
RunScore score_run(const std::vector<MassAt>& masses, double truth, double begin, double moved);

/// The instant by which some joint of the arm has moved for this long in all [s]; the log's end if none has.
template <int Dofs>
double moved_for(const Log<Dofs>& log, const Samples<Dofs>& samples, double seconds) {
  constexpr double kMoves = 0.02;  // [rad/s]
  for (std::size_t k = 0; k < samples.sample.size(); ++k) {
    if (samples.sample[k].dq.cwiseAbs().maxCoeff() > kMoves) seconds -= samples.sample[k].period;
    if (seconds <= 0) return log.t[samples.row[k]];
  }
  return log.t.back();
}

}  // namespace rme::examples
