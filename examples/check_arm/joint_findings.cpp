#include "check_arm/joint_findings.hpp"

#include <Eigen/Cholesky>
#include <algorithm>
#include <cmath>

namespace rme::examples {

namespace {

constexpr double kLeast = 1e-6;  // smaller values are rounding errors [N m]
constexpr double kGravity = 2;   // least rms of the model's gravity torque about its mean for the test of gravity [N m]
constexpr double kOutlier = 5;   // robust standard deviations

/// Standard deviation by the median of the absolute values, which a few large values do not change.
double deviation(Eigen::VectorXd values) {
  if (values.size() == 0) return 0;
  values = values.cwiseAbs();
  double* const middle = values.data() + values.size() / 2;
  std::nth_element(values.data(), middle, values.data() + values.size());
  return *middle / 0.6745;
}

/// Offset for each log, Coulomb and viscous friction, by least squares over the blocks in which the joint moves.
void fit_friction(const std::vector<LogBlocks>& logs, Eigen::Index j, JointFindings& out) {
  const auto n = static_cast<Eigen::Index>(logs.size());
  bool with_coulomb = out.friction_known, with_viscous = out.friction_known;
  for (int attempt = 0; attempt < 3; ++attempt) {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n + 2, n + 2);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 2);
    for (Eigen::Index k = 0; k < n; ++k) {
      const LogBlocks& log = logs[static_cast<std::size_t>(k)];
      for (Eigen::Index i = 0; i < log.blocks(); ++i) {
        const bool moves = log.resting(i, j) == 0 && std::abs(log.direction(i, j)) == 1;
        if (out.friction_known && !moves) continue;
        Eigen::VectorXd row = Eigen::VectorXd::Zero(n + 2);
        row[k] = 1;
        if (with_coulomb) row[n] = -log.direction(i, j);
        if (with_viscous) row[n + 1] = -log.velocity(i, j);
        A += row * row.transpose();
        b += row * log.tau(i, j);
      }
    }
    A.diagonal().array() += 1e-9 * std::max(1.0, A.diagonal().maxCoeff());  // for a log in which the joint never moves
    const Eigen::VectorXd x = solve(A, b);
    out.offset.assign(x.data(), x.data() + n);
    out.coulomb = with_coulomb ? x[n] : 0;
    out.viscous = with_viscous ? x[n + 1] : 0;
    // Friction is never negative: fit again without the coefficient that is.
    if (with_viscous && out.viscous < 0) {
      with_viscous = false;
    } else if (with_coulomb && out.coulomb < 0) {
      with_coulomb = false;
    } else {
      break;
    }
  }
}

/// Increase of Coulomb friction per N m of load; 0 unless it explains data to which it was not fitted much better.
double fit_load_friction(const std::vector<LogBlocks>& logs, Eigen::Index j) {
  constexpr double kSpread = 1;        // least standard deviation of the load for a fit [N m]
  constexpr double kWorthwhile = 0.9;  // largest share of the rms residual that may be left, out of sample
  const auto n = static_cast<Eigen::Index>(logs.size());
  const auto row_of = [&](Eigen::Index k, Eigen::Index i, bool with_load) {
    const LogBlocks& log = logs[static_cast<std::size_t>(k)];
    Eigen::VectorXd row = Eigen::VectorXd::Zero(n + 3);
    row[k] = 1;
    row[n] = -log.direction(i, j);
    row[n + 1] = -log.velocity(i, j);
    if (with_load) row[n + 2] = -log.direction(i, j) * std::abs(log.gravity(i, j));
    return row;
  };
  // Calls the function for the blocks in which the joint moves, of one half of each log (0, 1) or of both (2).
  const auto each = [&](int half, const auto& function) {
    for (Eigen::Index k = 0; k < n; ++k) {
      const LogBlocks& log = logs[static_cast<std::size_t>(k)];
      for (Eigen::Index i = 0; i < log.blocks(); ++i) {
        const bool moves = log.resting(i, j) == 0 && std::abs(log.direction(i, j)) == 1;
        if (moves && (half == 2 || (2 * i < log.blocks()) == (half == 0))) function(k, i, log.tau(i, j));
      }
    }
  };
  const auto fit = [&](int half, bool with_load) -> Eigen::VectorXd {
    Eigen::MatrixXd A = Eigen::MatrixXd::Zero(n + 3, n + 3);
    Eigen::VectorXd b = Eigen::VectorXd::Zero(n + 3);
    each(half, [&](Eigen::Index k, Eigen::Index i, double tau) {
      const Eigen::VectorXd row = row_of(k, i, with_load);
      A += row * row.transpose();
      b += row * tau;
    });
    A.diagonal().array() += 1e-9 * std::max(1.0, A.diagonal().maxCoeff());
    return solve(A, b);
  };
  double loads = 0, squares = 0, blocks = 0;
  each(2, [&](Eigen::Index k, Eigen::Index i, double) {
    const double load = std::abs(logs[static_cast<std::size_t>(k)].gravity(i, j));
    loads += load;
    squares += load * load;
    ++blocks;
  });
  if (!(blocks > 1) || squares / blocks - std::pow(loads / blocks, 2) < kSpread * kSpread) return 0;
  double left[2] = {0, 0};
  for (const int half : {0, 1}) {
    for (const bool with_load : {false, true}) {
      const Eigen::VectorXd x = fit(half, with_load);
      if (with_load && !(x[n + 2] > 0)) return 0;
      double mean = 0, count = 0, square = 0;  // the offset may have changed: the mean does not count
      each(1 - half, [&](Eigen::Index k, Eigen::Index i, double tau) {
        const double e = tau - row_of(k, i, with_load).dot(x);
        mean += e;
        square += e * e;
        ++count;
      });
      if (count > 0) left[with_load ? 1 : 0] += square - mean * mean / count;
    }
  }
  return std::sqrt(left[1]) < kWorthwhile * std::sqrt(left[0]) ? fit(2, true)[n + 2] : 0;
}

double least_squares_slope(const Eigen::VectorXd& y, const Eigen::VectorXd& x) {
  const Eigen::VectorXd dx = x.array() - x.mean();
  const double xx = dx.squaredNorm();
  return xx > 1e-9 ? dx.dot(y) / xx : 0;
}

}  // namespace

Eigen::VectorXd solve(const Eigen::MatrixXd& A, const Eigen::VectorXd& b) {
  return A.ldlt().solve(b);
}

Eigen::MatrixXd unexplained(const LogBlocks& log, std::size_t number, const std::vector<JointFindings>& joints) {
  Eigen::MatrixXd out = log.tau;
  for (Eigen::Index j = 0; j < log.joints(); ++j) {
    const JointFindings& joint = joints[static_cast<std::size_t>(j)];
    out.col(j).array() -= joint.offset[number];
    out.col(j) += joint.coulomb * log.direction.col(j) + joint.viscous * log.velocity.col(j);
  }
  return out;
}

std::vector<JointFindings> find_joints(const std::vector<LogBlocks>& logs) {
  const Eigen::Index dofs = logs.front().joints();
  std::vector<JointFindings> out(static_cast<std::size_t>(dofs));
  for (Eigen::Index j = 0; j < dofs; ++j) {
    JointFindings& joint = out[static_cast<std::size_t>(j)];
    double forward = 0, backward = 0, rest = 0;
    for (const LogBlocks& log : logs) {
      for (Eigen::Index i = 0; i < log.blocks(); ++i) {
        if (log.resting(i, j) == 1) rest += log.duration[i];
        if (log.resting(i, j) == 0 && log.direction(i, j) == 1) forward += log.duration[i];
        if (log.resting(i, j) == 0 && log.direction(i, j) == -1) backward += log.duration[i];
      }
    }
    joint.friction_known = forward >= 1 && backward >= 1;
    joint.rests = rest >= 1;
    fit_friction(logs, j, joint);
    if (joint.friction_known) joint.coulomb_per_load = fit_load_friction(logs, j);
  }
  for (Eigen::Index j = 0; j < dofs; ++j) {
    JointFindings& joint = out[static_cast<std::size_t>(j)];
    // Autocovariance of what is left, up to five seconds.
    double stiction = 0, at_rest = 0, duration = 0, blocks = 0;
    std::vector<double> covariance(251, 0.0), count(251, 0.0);
    for (std::size_t k = 0; k < logs.size(); ++k) {
      const LogBlocks& log = logs[k];
      Eigen::VectorXd e = unexplained(log, k, out).col(j);
      const double bound = kOutlier * deviation(e);  // an emergency stop says little about an arm at work
      e = e.cwiseMax(-bound).cwiseMin(bound);
      for (Eigen::Index i = 0; i < log.blocks(); ++i) {
        duration += log.duration[i];
        ++blocks;
        if (log.resting(i, j) == 1) {
          stiction += e[i] * e[i];
          ++at_rest;
        }
        for (Eigen::Index lag = 0; lag <= std::min<Eigen::Index>(250, i); ++lag) {
          covariance[static_cast<std::size_t>(lag)] += e[i] * e[i - lag];
          ++count[static_cast<std::size_t>(lag)];
        }
      }
    }
    for (std::size_t lag = 0; lag < covariance.size(); ++lag)
      if (count[lag] > 0) covariance[lag] /= count[lag];
    const double block = blocks > 0 ? duration / blocks : 0.02;
    joint.stiction = at_rest > 0 ? std::sqrt(stiction / at_rest) : 0;
    // The covariance of blocks that are two or more apart is the residual's. Neighbouring blocks may share the noise of
    // a sample.
    double shared = 0;
    for (std::size_t lag = 2; lag <= 6; ++lag) shared += covariance[lag] / 5;
    shared = std::max(0.0, std::min(covariance[0], shared));
    const double noise = covariance[0] - shared;
    joint.noise = std::sqrt(std::max(kLeast * kLeast, noise));
    joint.residual = std::sqrt(shared);
    std::size_t lag = 2;
    while (lag + 1 < covariance.size() && covariance[lag] > shared * std::exp(-1.0)) ++lag;
    joint.correlation_time = block * static_cast<double>(lag);
    // Does the torque follow gravity?
    Eigen::VectorXd tau(0), gravity(0);
    for (const LogBlocks& log : logs) {
      const Eigen::Index n = tau.size();
      tau.conservativeResize(n + log.blocks());
      gravity.conservativeResize(n + log.blocks());
      tau.tail(log.blocks()) = log.tau.col(j);
      gravity.tail(log.blocks()) = log.gravity.col(j);
    }
    joint.gravity_seen = std::sqrt((gravity.array() - gravity.mean()).square().mean()) > kGravity;
    joint.gravity_slope = least_squares_slope(tau, gravity);
  }
  return out;
}

}  // namespace rme::examples
