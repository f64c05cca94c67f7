#pragma once
/// Recordings of an arm, made by a host while its controller ran.
#include <algorithm>
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

/// A column of a file and what becomes of its numbers: factor * number + offset.
struct LogColumn {
  std::string name;
  double factor = 1;
  double offset = 0;
};

/// Where a file has the quantities of a log, in the order of the arm's joints. Empty: it has none.
struct LogColumns {
  std::vector<LogColumn> t;  ///< their sum is the time [s]: seconds and nanoseconds may have columns of their own
  std::vector<LogColumn> q, dq, tau_ext, tau;  ///< one for each joint
};

namespace detail {

/// Names of the columns of a joint vector: name1, name2, ...
template <int Dofs>
std::vector<LogColumn> joint_columns(const std::string& name) {
  std::vector<LogColumn> columns;
  for (int j = 1; j <= Dofs; ++j) columns.push_back({name + std::to_string(j)});
  return columns;
}

/// The columns, or none if the file has none of them. If it has some, the others are reported as missing.
inline std::vector<LogColumn> if_any(const CsvReader& csv, const std::vector<LogColumn>& columns) {
  const bool any =
      std::any_of(columns.begin(), columns.end(), [&](const auto& c) { return csv.find(c.name).has_value(); });
  return any ? columns : std::vector<LogColumn>();
}

/// Columns that have been looked up in the header.
class FoundColumns {
 public:
  FoundColumns(const CsvReader& csv, const std::vector<LogColumn>& columns) : columns_(columns) {
    for (const LogColumn& column : columns) found_.push_back(csv.at(column.name));
  }
  /// Appends the row's vector to `values`, unless there are no columns.
  template <typename Vector>
  void append(const CsvReader& csv, std::vector<Vector>& values) const {
    if (columns_.empty()) return;
    Vector value;
    for (std::size_t i = 0; i < columns_.size(); ++i) value[static_cast<Eigen::Index>(i)] = at(csv, i);
    values.push_back(value);
  }
  double sum(const CsvReader& csv) const {
    double total = 0;
    for (std::size_t i = 0; i < columns_.size(); ++i) total += at(csv, i);
    return total;
  }
  std::size_t front() const { return found_.front(); }

 private:
  double at(const CsvReader& csv, std::size_t i) const {
    return columns_[i].factor * csv.number(found_[i]) + columns_[i].offset;
  }
  std::vector<LogColumn> columns_;
  std::vector<std::size_t> found_;
};

}  // namespace detail

/// The columns of docs/conventions.md that the file has: t, q1.. needed; dq1.., tau_ext1.., tau1.. optional.
/// @throws LogError if it has a part of a vector, or more joints
template <int Dofs>
LogColumns usual_columns(const CsvReader& csv) {
  const auto optional = [&](const char* name) { return detail::if_any(csv, detail::joint_columns<Dofs>(name)); };
  const std::string beyond = "q" + std::to_string(Dofs + 1);
  if (csv.find(beyond))
    throw LogError(csv.name() + ":1: column " + beyond + ": the arm has " + std::to_string(Dofs) + " joints");
  return {{{"t"}}, detail::joint_columns<Dofs>("q"), optional("dq"), optional("tau_ext"), optional("tau")};
}

/// Reads a log from CSV text. Other columns are ignored, but for the truth m, rx, ry, rz.
/// @param name     of the file, for messages
/// @param columns  needed, in the units of docs/conventions.md with their factors; t and q not empty
/// @throws LogError on anything that is not such a log, naming file, line and column
template <int Dofs>
Log<Dofs> parse_log(std::string_view text, const std::string& name, const LogColumns& columns) {
  CsvReader csv(text, name);
  const detail::FoundColumns t(csv, columns.t), q(csv, columns.q), dq(csv, columns.dq), tau_ext(csv, columns.tau_ext),
      tau(csv, columns.tau), truth(csv, detail::if_any(csv, {{"m"}, {"rx"}, {"ry"}, {"rz"}}));
  Log<Dofs> log;
  log.name = name;
  while (csv.next()) {
    const double time = t.sum(csv);
    if (!log.t.empty() && time < log.t.back()) csv.fail(t.front(), "time does not increase from the row before");
    if (!log.t.empty() && time == log.t.back()) {
      ++log.same_instant;
      continue;
    }
    log.t.push_back(time);
    q.append(csv, log.q);
    dq.append(csv, log.dq);
    tau_ext.append(csv, log.tau_ext);
    tau.append(csv, log.tau);
    truth.append(csv, log.truth);
  }
  if (log.t.empty()) throw LogError(name + ": has a header but no rows");
  return log;
}

/// Reads a log of the usual columns from CSV text.
template <int Dofs = 7>
Log<Dofs> parse_log(std::string_view text, const std::string& name) {
  return parse_log<Dofs>(text, name, usual_columns<Dofs>(CsvReader(text, name)));
}

// Compiled in log_reader.cpp.
extern template Log<4> parse_log(std::string_view, const std::string&, const LogColumns&);
extern template Log<5> parse_log(std::string_view, const std::string&, const LogColumns&);
extern template Log<6> parse_log(std::string_view, const std::string&, const LogColumns&);
extern template Log<7> parse_log(std::string_view, const std::string&, const LogColumns&);
extern template Log<8> parse_log(std::string_view, const std::string&, const LogColumns&);

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
