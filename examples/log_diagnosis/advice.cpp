#include "log_diagnosis/advice.hpp"

#include <cmath>
#include <cstdio>

namespace rme::examples {

namespace {

std::string number(double value, const char* format = "%.6g") {
  char text[40];
  std::snprintf(text, sizeof text, format, value);
  return text;
}

/// The column as --columns takes it.
std::string expression(const LogColumn& column, const std::string& name) {
  std::string out;
  if (column.factor == -1)
    out = "-";
  else if (column.factor != 1)
    out = number(column.factor) + "*";
  out += name;
  if (column.offset != 0) out += number(column.offset, "%+.6g");
  return out;
}

/// KEY=NAME* if all columns differ in the joint's number alone; otherwise an item for each joint.
std::string items(const std::string& key, const std::vector<LogColumn>& columns) {
  const std::string& head = columns.front().name;
  for (const int first : {1, 0}) {
    const std::size_t at = head.rfind(std::to_string(first));
    if (at == std::string::npos) continue;
    bool regular = true;
    for (std::size_t j = 0; j < columns.size(); ++j) {
      const LogColumn& c = columns[j];
      regular =
          regular && c.factor == columns[0].factor && c.offset == columns[0].offset &&
          c.name == head.substr(0, at) + std::to_string(static_cast<std::size_t>(first) + j) + head.substr(at + 1);
    }
    if (regular) return key + "=" + expression(columns[0], head.substr(0, at) + "*" + head.substr(at + 1));
  }
  std::string out;
  for (std::size_t j = 0; j < columns.size(); ++j)
    out += (j > 0 ? "," : "") + key + std::to_string(j + 1) + "=" + expression(columns[j], columns[j].name);
  return out;
}

}  // namespace

const std::vector<LogColumn>& Advice::columns(const std::string& key) const {
  const LogColumns& c = given_.columns;
  return key == "t" ? c.t : key == "q" ? c.q : key == "dq" ? c.dq : key == "tau" ? c.tau : c.tau_ext;
}

std::string Advice::option(const std::string& more) const {
  return "--columns '" + given_.format.columns + (given_.format.columns.empty() ? "" : ",") + more + "'";
}

std::string Advice::scaled(const std::string& key, double factor) const {
  std::vector<LogColumn> changed = columns(key);
  for (LogColumn& column : changed) {
    column.factor *= factor;
    column.offset *= factor;
  }
  return option(key == "t" ? "t=" + expression(changed.front(), changed.front().name) : items(key, changed));
}

std::string Advice::none(const std::string& key) const {
  return option(key + "=none");
}

std::string Advice::flipped(const std::string& key, const std::vector<Eigen::Index>& joints) const {
  std::string out;
  for (const Eigen::Index j : joints) {
    LogColumn column = columns(key)[static_cast<std::size_t>(j)];
    column.factor *= -1;
    column.offset *= -1;
    out += (out.empty() ? "" : ",") + key + std::to_string(j + 1) + "=" + expression(column, column.name);
  }
  return out;
}

std::string Advice::turned(const std::string& key, const std::vector<Eigen::Index>& joints) const {
  return option(flipped(key, joints));
}

std::string Advice::turned_joints(const std::vector<Eigen::Index>& joints) const {
  return option(flipped("q", joints) + (columns("dq").empty() ? "" : "," + flipped("dq", joints)));
}

std::string Advice::reordered(const std::vector<std::string>& keys, const std::vector<Eigen::Index>& order) const {
  std::string out;
  for (const std::string& key : keys) {
    const std::vector<LogColumn>& from = columns(key);
    for (std::size_t j = 0; j < from.size(); ++j) {
      const auto source = static_cast<std::size_t>(order[j]);
      if (source != j)
        out +=
            (out.empty() ? "" : ",") + key + std::to_string(j + 1) + "=" + expression(from[source], from[source].name);
    }
  }
  return option(out);
}

std::string Advice::shifted(Eigen::Index joint, double offset) const {
  LogColumn column = columns("q")[static_cast<std::size_t>(joint)];
  column.offset += given_.format.degrees ? offset / 0.017453292519943295 : offset;
  return option("q" + std::to_string(joint + 1) + "=" + expression(column, column.name));
}

std::string Advice::moved(const std::string& from, const std::string& to) const {
  return option(items(to, columns(from)) + "," + from + "=none");
}

std::string Advice::gains(const Eigen::VectorXd& gains) const {
  std::string out = "--gains ";
  for (Eigen::Index j = 0; j < gains.size(); ++j) out += (j > 0 ? "," : "") + number(gains[j], "%.4g");
  return out;
}

}  // namespace rme::examples
