#pragma once
// A recorded log of a seven-joint arm: header t, q1..7, dq1..7, tau_c1..7, tau_ext1..7, then one row each millisecond.
#include <Eigen/Core>
#include <fstream>
#include <sstream>
#include <stdexcept>
#include <string>
#include <vector>

struct ArmLogRow {
  using Vector = Eigen::Matrix<double, 7, 1>;
  double t;
  Vector q, dq, tau_c, tau_ext;
};

inline std::vector<ArmLogRow> read_arm_log(const std::string& path) {
  std::ifstream file(path);
  std::string line;
  if (!std::getline(file, line)) throw std::runtime_error("cannot read " + path);
  std::vector<ArmLogRow> rows;
  while (std::getline(file, line)) {
    for (char& c : line)
      if (c == ',') c = ' ';
    std::istringstream numbers(line);
    ArmLogRow row;
    numbers >> row.t;
    for (ArmLogRow::Vector* v : {&row.q, &row.dq, &row.tau_c, &row.tau_ext})
      for (double& x : *v) numbers >> x;
    if (!numbers) throw std::runtime_error("short row in " + path);
    rows.push_back(row);
  }
  return rows;
}
