#pragma once
/// Recordings of an arm, made by a host while its controller ran.
#include <algorithm>
#include <array>
#include <cstddef>
#include <rme/core/types.hpp>
#include <string>
#include <string_view>
#include <vector>

#include "io/csv.hpp"

namespace rme::examples {

/// A recording, one entry per row, in the units and signs of docs/conventions.md. A quantity that is not in the file is
/// an empty vector.
template <int Dofs = 7>
struct Log {
  std::string name;                                ///< name of the file, for messages
  std::vector<double> t;                           ///< [s], strictly increasing
  std::vector<JointVector<double, Dofs>> q;        ///< [rad]
  std::vector<JointVector<double, Dofs>> dq;       ///< [rad/s], or empty
  std::vector<JointVector<double, Dofs>> tau_ext;  ///< external torque [N m], or empty
  std::vector<JointVector<double, Dofs>> tau;      ///< measured torque, gravity included [N m], or empty
  std::vector<Vector4<double>> truth;  ///< payload (m, r_x, r_y, r_z), zero while the hand is empty; or empty
  std::size_t same_instant = 0;        ///< rows that were left out, since they had the time stamp of the row before

  std::size_t size() const noexcept { return t.size(); }
};

namespace detail {

/// The columns of these names, all of them needed.
template <std::size_t Size>
std::vector<std::size_t> columns(const CsvReader& csv, const std::array<std::string, Size>& names) {
  std::vector<std::size_t> found(Size);
  std::transform(names.begin(), names.end(), found.begin(), [&](const std::string& name) { return csv.at(name); });
  return found;
}

/// The same, or nothing if none of them is there. If only some are there, the others are reported as missing.
template <std::size_t Size>
std::vector<std::size_t> optional_columns(const CsvReader& csv, const std::array<std::string, Size>& names) {
  const bool any =
      std::any_of(names.begin(), names.end(), [&](const auto& name) { return csv.find(name).has_value(); });
  return any ? columns(csv, names) : std::vector<std::size_t>();
}

/// Names of the columns of a joint vector: name1, name2, ...
template <int Dofs>
std::array<std::string, Dofs> joint_columns(const std::string& name) {
  std::array<std::string, Dofs> names;
  for (std::size_t j = 0; j < Dofs; ++j) names[j] = name + std::to_string(j + 1);
  return names;
}

/// Appends the row's vector to `values`, unless the file does not have it.
template <typename Vector>
void append(const CsvReader& csv, const std::vector<std::size_t>& columns, std::vector<Vector>& values) {
  if (columns.empty()) return;
  Vector value;
  for (std::size_t i = 0; i < columns.size(); ++i) value[static_cast<Eigen::Index>(i)] = csv.number(columns[i]);
  values.push_back(value);
}

}  // namespace detail

/// Reads a log from CSV text. Columns are found by their names, in any order: t, q1.. needed; dq1.., tau_ext1..,
/// tau1.. and the truth m, rx, ry, rz optional; all others ignored.
/// @param name  of the file, for messages
/// @throws LogError on anything that is not such a log, naming file, line and column
template <int Dofs = 7>
Log<Dofs> parse_log(std::string_view text, const std::string& name) {
  CsvReader csv(text, name);
  const std::size_t t = csv.at("t");
  const auto q = detail::columns(csv, detail::joint_columns<Dofs>("q"));
  const auto dq = detail::optional_columns(csv, detail::joint_columns<Dofs>("dq"));
  const auto tau_ext = detail::optional_columns(csv, detail::joint_columns<Dofs>("tau_ext"));
  const auto tau = detail::optional_columns(csv, detail::joint_columns<Dofs>("tau"));
  const auto truth = detail::optional_columns(csv, std::array<std::string, 4>{"m", "rx", "ry", "rz"});
  const std::string beyond = "q" + std::to_string(Dofs + 1);
  if (csv.find(beyond))
    throw LogError(name + ":1: column " + beyond + ": the arm has " + std::to_string(Dofs) + " joints");

  Log<Dofs> log;
  log.name = name;
  while (csv.next()) {
    const double time = csv.number(t);
    if (!log.t.empty() && time < log.t.back()) csv.fail(t, "time does not increase from the row before");
    if (!log.t.empty() && time == log.t.back()) {
      ++log.same_instant;
      continue;
    }
    log.t.push_back(time);
    detail::append(csv, q, log.q);
    detail::append(csv, dq, log.dq);
    detail::append(csv, tau_ext, log.tau_ext);
    detail::append(csv, tau, log.tau);
    detail::append(csv, truth, log.truth);
  }
  if (log.t.empty()) throw LogError(name + ": has a header but no rows");
  return log;
}

// Compiled in log_reader.cpp.
extern template Log<4> parse_log(std::string_view, const std::string&);
extern template Log<5> parse_log(std::string_view, const std::string&);
extern template Log<6> parse_log(std::string_view, const std::string&);
extern template Log<7> parse_log(std::string_view, const std::string&);
extern template Log<8> parse_log(std::string_view, const std::string&);

/// Reads a log from a CSV file, plain or gzip-compressed; see parse_log.
template <int Dofs = 7>
Log<Dofs> read_log(const std::string& path) {
  return parse_log<Dofs>(read_file(path), path);
}

/// The rows of the log with begin <= t < end.
template <int Dofs>
Log<Dofs> cropped(const Log<Dofs>& log, double begin, double end) {
  const auto row = [&log](double t) { return std::lower_bound(log.t.begin(), log.t.end(), t) - log.t.begin(); };
  const auto first = row(begin), last = row(end);
  const auto crop = [&](const auto& from, auto& to) {
    if (!from.empty()) to.assign(from.begin() + first, from.begin() + last);
  };
  Log<Dofs> out;
  out.name = log.name;
  crop(log.t, out.t);
  crop(log.q, out.q);
  crop(log.dq, out.dq);
  crop(log.tau_ext, out.tau_ext);
  crop(log.tau, out.tau);
  crop(log.truth, out.truth);
  return out;
}

/// Refuses a log that has neither tau_ext, nor tau and dq for a momentum observer.
/// @throws LogError naming what is missing
template <int Dofs>
void require_external_torque(const Log<Dofs>& log) {
  if (!log.tau_ext.empty()) return;
  const auto range = [](const std::string& column) { return column + "1.." + column + std::to_string(Dofs); };
  if (log.tau.empty()) {
    throw LogError(log.name + ":1: columns " + range("tau_ext") + " are missing (or " + range("tau") + " and " +
                   range("dq") + ", measured torque with gravity, in their place)");
  }
  if (log.dq.empty()) {
    throw LogError(log.name + ":1: columns " + range("dq") + " are missing: without " + range("tau_ext") +
                   ", the external torque comes from " + range("tau") + " and them");
  }
}

/// Refuses a log whose true payload is not zero throughout.
/// @throws LogError naming the first instant at which the hand holds something
template <int Dofs>
void require_empty_hand(const Log<Dofs>& log) {
  for (std::size_t i = 0; i < log.truth.size(); ++i) {
    if (log.truth[i][0] == 0) continue;
    throw LogError(log.name + ": column m: the hand holds something from t = " + std::to_string(log.t[i]) +
                   " s on; --span leaves that out");
  }
}

}  // namespace rme::examples
