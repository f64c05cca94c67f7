#include "check_arm/held_out.hpp"

#include <algorithm>

namespace rme::examples {

namespace {

constexpr double kLeast = 5;         // of a part, and of a rest [s]
constexpr double kShortest = 1;      // of a rest's spans [s]
constexpr double kStep = 0.02;       // along a path [rad]
constexpr std::size_t kMost = 1000;  // poses of a part

/// Poses of the spans, kStep apart or more.
Eigen::MatrixXd poses(const std::vector<LogPath>& logs, const std::vector<LogSpan>& spans) {
  std::vector<Eigen::RowVectorXd> path;
  for (const LogSpan& span : spans) {
    const LogPath& log = logs[span.log];
    for (std::size_t i = 0; i < log.t.size(); ++i) {
      if (log.t[i] < span.begin || log.t[i] >= span.end) continue;
      const Eigen::RowVectorXd q = log.q.row(static_cast<Eigen::Index>(i));
      if (path.empty() || (q - path.back()).cwiseAbs().maxCoeff() > kStep) path.push_back(q);
    }
  }
  const std::size_t stride = path.size() / kMost + 1;
  Eigen::MatrixXd out(static_cast<Eigen::Index>((path.size() + stride - 1) / stride), logs.front().q.cols());
  for (Eigen::Index i = 0; i < out.rows(); ++i) out.row(i) = path[static_cast<std::size_t>(i) * stride];
  return out;
}

/// The spans of the logs outside the part in which the arm is on another path.
std::vector<LogSpan> rest_of(const std::vector<LogPath>& logs, const std::vector<LogSpan>& part) {
  constexpr double kEvery = 0.02;  // [s]
  const Eigen::MatrixXd path = poses(logs, part);
  std::vector<LogSpan> out;
  for (std::size_t k = 0; k < logs.size(); ++k) {
    const LogPath& log = logs[k];
    double begin = log.t.front(), looked = begin - kEvery;
    const auto close = [&](double end) {
      if (end - begin >= kShortest) out.push_back({k, begin, end});
    };
    for (std::size_t i = 0; i < log.t.size(); ++i) {
      const double t = log.t[i];
      if (t - looked < kEvery) continue;
      looked = t;
      const bool inside = std::any_of(part.begin(), part.end(), [&](const LogSpan& span) {
        return span.log == k && t >= span.begin && t < span.end;
      });
      const auto q = log.q.row(static_cast<Eigen::Index>(i));
      if (!inside && (path.rowwise() - q).cwiseAbs().rowwise().maxCoeff().minCoeff() >= kOtherPath) continue;
      close(t);
      begin = t + kEvery;
    }
    close(log.t.back());
  }
  return out;
}

double length(const std::vector<LogSpan>& spans) {
  double sum = 0;
  for (const LogSpan& span : spans) sum += span.end - span.begin;
  return sum;
}

/// The parts that are long enough, and have a rest that is.
std::vector<HeldOut> usable(const std::vector<LogPath>& logs, const std::vector<std::vector<LogSpan>>& parts) {
  std::vector<HeldOut> out;
  for (const std::vector<LogSpan>& part : parts) {
    if (length(part) < kLeast) continue;
    const std::vector<LogSpan> rest = rest_of(logs, part);
    if (length(rest) >= kLeast) out.push_back({part, rest});
  }
  return out;
}

/// A piece of each log, pieces of the same length.
std::vector<LogSpan> piece(const std::vector<LogPath>& logs, int number, int pieces) {
  std::vector<LogSpan> out;
  for (std::size_t k = 0; k < logs.size(); ++k) {
    const double first = logs[k].t.front(), step = (logs[k].t.back() - first) / pieces;
    out.push_back({k, first + number * step, first + (number + 1) * step});
  }
  return out;
}

}  // namespace

std::vector<HeldOut> held_out_parts(const std::vector<LogPath>& logs) {
  std::vector<std::vector<LogSpan>> parts;
  if (logs.size() > 1)
    for (std::size_t k = 0; k < logs.size(); ++k) parts.push_back({{k, logs[k].t.front(), logs[k].t.back()}});
  std::vector<HeldOut> out = usable(logs, parts);
  for (int pieces = 2; out.empty() && pieces <= 4; ++pieces) {
    parts.clear();
    for (int i = 0; i < pieces; ++i) parts.push_back(piece(logs, i, pieces));
    out = usable(logs, parts);
  }
  return out;
}

}  // namespace rme::examples
