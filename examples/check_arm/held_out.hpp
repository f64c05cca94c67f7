#pragma once
/// Parts of an arm's logs, and what of the rest shows other poses. Settings from that rest are tested on the part.
#include <Eigen/Core>
#include <cstddef>
#include <vector>

#include "io/log_reader.hpp"

namespace rme::examples {

/// Rows of a log with begin <= t < end [s].
struct LogSpan {
  std::size_t log;
  double begin, end;
};

/// The poses of a log.
struct LogPath {
  std::vector<double> t;  ///< [s]
  Eigen::MatrixXd q;      ///< a row for each instant, a column for each joint [rad]
};

/// A part of the logs, and the rest of them on another path: each pose of the rest differs from each pose of the part by
/// kOtherPath or more in some joint, to within the 0.02 rad in which a path is looked at.
struct HeldOut {
  std::vector<LogSpan> part, rest;
};

constexpr double kOtherPath = 0.1;  ///< [rad]

/// Parts whose settings can be tested: each log if there are several, or else halves, thirds or quarters of the logs,
/// whichever comes first. Part and rest last five seconds or more; a rest has only spans of a second or more.
/// @return none if the logs show one path only
std::vector<HeldOut> held_out_parts(const std::vector<LogPath>& logs);

template <int Dofs>
LogPath path_of(const Log<Dofs>& log) {
  LogPath out{log.t, Eigen::MatrixXd(static_cast<Eigen::Index>(log.size()), Dofs)};
  for (std::size_t i = 0; i < log.size(); ++i) out.q.row(static_cast<Eigen::Index>(i)) = log.q[i].transpose();
  return out;
}

}  // namespace rme::examples
