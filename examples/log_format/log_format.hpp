#pragma once
/// Reads logs whose columns or units are not those of docs/conventions.md.
#include <cmath>
#include <string>
#include <vector>

#include "io/arguments.hpp"
#include "io/log_reader.hpp"
#include "log_format/column_layout.hpp"
#include "log_format/zero_phase.hpp"

namespace rme::examples {

constexpr const char* kFormatUsage =
    "  --columns LIST      where the log has what: 'q=position_*,dq=none,q2=-q2,t=0.001*time', * for the joints' "
    "numbers\n"
    "  --degrees           q and dq are in degrees and degrees per second\n"
    "  --torque-delay S    the log's torque is late: that of a row belongs to the arm S seconds before [s] (0)\n";

/// The values of the options above.
struct LogFormat {
  std::string columns;
  bool degrees = false;
  double torque_delay = 0;  ///< [s]
};

/// Takes the options above out of `arguments`.
/// @throws ArgumentError naming what is wrong
LogFormat parse_format(Arguments& arguments);

/// A log, and how it was read.
template <int Dofs>
struct FormattedLog {
  Log<Dofs> log;
  LogColumns columns;
  bool differentiated = false;     ///< dq is not in the file: it was computed from q
  std::vector<std::string> notes;  ///< for the user, a sentence each
};

namespace detail {

/// Adds or subtracts whole turns where a joint's angle jumps by one.
/// @return the number of jumps
template <typename Vector>
std::size_t unwrap(std::vector<Vector>& q) {
  constexpr double kTurn = 6.283185307179586;
  std::size_t jumps = 0;
  if (q.empty()) return jumps;
  Vector turns = Vector::Zero();
  for (std::size_t i = 1; i < q.size(); ++i) {
    for (Eigen::Index j = 0; j < turns.size(); ++j) {
      const double step = q[i][j] + turns[j] - q[i - 1][j], whole = std::round(step / kTurn);
      if (std::abs(whole) != 1 || std::abs(step - whole * kTurn) > 0.1 * kTurn) continue;
      turns[j] -= whole * kTurn;
      ++jumps;
    }
    q[i] += turns;
  }
  return jumps;
}

/// Shifts the torque by `delay` to earlier instants; in between, it is interpolated. Rows without torque are removed.
template <int Dofs>
void advance_torque(Log<Dofs>& log, double delay) {
  const auto at = [&](const std::vector<JointVector<double, Dofs>>& of, double t) -> JointVector<double, Dofs> {
    const auto after = std::lower_bound(log.t.begin(), log.t.end(), t) - log.t.begin();
    const auto k = static_cast<std::size_t>(std::max<std::ptrdiff_t>(after, 1));
    const double share = (t - log.t[k - 1]) / (log.t[k] - log.t[k - 1]);
    return of[k - 1] + share * (of[k] - of[k - 1]);
  };
  const Log<Dofs> kept = cropped(log, log.t.front() - std::min(0.0, delay), log.t.back() - std::max(0.0, delay));
  if (kept.size() < 2) throw LogError(log.name + ": lasts less than --torque-delay, " + std::to_string(delay) + " s");
  Log<Dofs> out = kept;
  for (std::size_t i = 0; i < kept.size(); ++i) {
    if (!log.tau.empty()) out.tau[i] = at(log.tau, kept.t[i] + delay);
    if (!log.tau_ext.empty()) out.tau_ext[i] = at(log.tau_ext, kept.t[i] + delay);
  }
  out.same_instant = log.same_instant;
  log = out;
}

}  // namespace detail

/// Reads a log, plain or gzip-compressed. Time stamps of a calendar are counted from the first one, jumps of q by a
/// whole turn are undone, and if there is no dq, it is the derivative of q, at zero phase.
/// @param joints  names of the arm's joints, from the base on
/// @throws LogError as parse_log() and column_layout()
template <int Dofs>
FormattedLog<Dofs> read_formatted_log(const std::string& path, const LogFormat& format,
                                      const std::vector<std::string>& joints) {
  constexpr double kDegree = 0.017453292519943295;  // [rad]
  constexpr double kCalendar = 1e6;                 // [s]: no recording lasts so long
  const std::string text = read_file(path);
  const ColumnLayout layout = column_layout(CsvReader(text, path).header(), path, joints, format.columns);
  FormattedLog<Dofs> out{parse_log<Dofs>(text, path, layout.columns), layout.columns, false, layout.notes};
  Log<Dofs>& log = out.log;
  if (log.t.front() > kCalendar) {
    // Recorders count nanoseconds, microseconds or milliseconds since 1970: seconds have ten digits.
    double unit = 1;
    while (log.t.front() * unit > 1e11) unit *= 1e-3;
    const double first = log.t.front();
    for (double& t : log.t) t = (t - first) * unit;
    out.notes.push_back("t counts from the first row");
  }
  if (format.degrees) {
    for (auto* values : {&log.q, &log.dq})
      for (auto& v : *values) v *= kDegree;
  }
  if (const std::size_t jumps = detail::unwrap(log.q); jumps > 0)
    out.notes.push_back("q jumps by a whole turn " + std::to_string(jumps) + " times: undone");
  if (log.dq.empty() && log.size() > 2) {
    log.dq = zero_phase_derivative(log.t, log.q);
    out.differentiated = true;
    out.notes.push_back("dq is not in the log: it is the derivative of q, by quadratics through the rows around each");
  }
  if (format.torque_delay != 0) detail::advance_torque(log, format.torque_delay);
  return out;
}

}  // namespace rme::examples
