#pragma once
/// What an arm's torque sensing is like, measured from what it shows while the hand is empty.
#include <Eigen/Cholesky>
#include <Eigen/Core>
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/types.hpp>
#include <rme/event_estimator_config.hpp>
#include <rme/inference/fixed_prior.hpp>
#include <rme/inference/payload_regressor.hpp>
#include <rme/inference/sensor_model.hpp>
#include <rme/sensing/sample_window.hpp>
#include <vector>

#include "identify_noise/quiet_log.hpp"

namespace rme::examples {

/// A log in means over blocks; per joint, a row each: torque [N m]; the regressors of its nuisances, (1, -direction,
/// -dq [rad/s]); the torque of a payload of 1 kg at the prior's centre of mass, and what a standard deviation of its x,
/// y and z adds [N m].
using LogBlocks = std::array<Eigen::Matrix<double, Eigen::Dynamic, 8>, 7>;

/// @param block  length of a block [s], >= one period
inline LogBlocks blocks_of(const Log<7>& log, const EventEstimatorConfig<double, 7>& settings, double block) {
  const auto ticks = static_cast<double>(std::lround(block / nominal_period(log.t)));
  const auto prior = FixedPrior<double>().gaussian;
  std::vector<Eigen::Matrix<double, 7, 8>> means;
  Eigen::Matrix<double, 7, 8> sum = Eigen::Matrix<double, 7, 8>::Zero();
  for_each_sample(log, settings, [&](const SampleWindow<double, 7>& past) {
    const auto& sample = past.newest();
    const auto regressor = payload_regressor<double, 7>(sample.raw.jacobian, sample.raw.rotation, settings.gravity,
                                                        sample.motion, settings.gyration_radius);
    const Payload<double> payload{1, prior.payload().com};
    const JointVector<double, 7> weight = regressor.torque(payload);
    sum.col(0) += sample.tau;
    sum.col(1).array() += 1;
    sum.col(2) -= sample.direction;
    sum.col(3) -= sample.raw.dq;
    sum.col(4) += weight;
    for (int k = 0; k < 3; ++k) {
      Payload<double> shifted = payload;
      shifted.com[k] += prior.standard_deviation()[1 + k];
      sum.col(5 + k) += regressor.torque(shifted) - weight;
    }
    if (sum(0, 1) < ticks) return;
    means.push_back(sum / ticks);
    sum.setZero();
  });
  LogBlocks out;
  for (int j = 0; j < 7; ++j) {
    auto& blocks = out[static_cast<std::size_t>(j)];
    blocks.resize(static_cast<Eigen::Index>(means.size()), Eigen::NoChange);
    for (std::size_t k = 0; k < means.size(); ++k) blocks.row(static_cast<Eigen::Index>(k)) = means[k].row(j);
  }
  return out;
}

/// What the logs say about an arm's torque sensing.
struct IdentifiedSensor {
  SensorModel<double, 7> model;
  /// Per joint, whether the logs tell; the preset's value is kept otherwise.
  std::array<bool, 7> stiction_known{}, coulomb_known{}, viscous_known{};
  /// Largest correlation of neighbouring blocks in any joint, the noise's share. Should be small.
  double correlation = 0;
  /// How many standard deviations of the model above an empty hand looks like a payload, rms, before all were widened.
  double surprise = 0;
};

/// Finds the sensor model that makes the logs the most likely. In every window of a log a joint's torque follows the
/// regression that the estimator makes of it (docs/theory.md, "Faults that do not average out"),
///
///     y = N beta + noise,   beta ~ N((o, c, v), Lambda),   Lambda = diag(stiction^2, coulomb_std^2, viscous_std^2)
///
/// with an offset o for each log and friction coefficients c, v for all. In turns, these means are set by generalised
/// least squares given Lambda and the noise, and those by expectation maximisation given the means.
///
/// Joints are independent to the model. On an arm whose own model is wrong they are not: the error of a link's mass
/// looks like a payload. So every window is asked how much like a payload it looks, and the model is widened until that
/// is no surprise (the Birge ratio).
class SensorIdentification {
 public:
  static constexpr double kWindow = 0.5;    ///< length of a window, about that of an event and its baseline [s]
  static constexpr int kLeastWindows = 10;  ///< in all logs together

  /// @param preset      what is kept where the logs say nothing; also gives the noise's correlation time
  /// @param collection  length of the windows that an event is estimated from [s]
  SensorIdentification(const SensorModel<double, 7>& preset, double collection)
      : preset_(preset),
        per_window_(std::lround(kWindow / block())),
        per_event_(std::max(1L, std::lround(collection / block()))) {}

  /// Length of a block [s].
  double block() const { return 2 * preset_.noise_correlation_time; }

  /// Adds a log, of which the blocks beyond its last whole window are left out.
  void add(const LogBlocks& log) {
    windows_ += static_cast<int>(log[0].rows() / per_window_);
    logs_.push_back(log);
  }
  int windows() const { return windows_; }

  /// Requires kLeastWindows.
  IdentifiedSensor identify() const {
    IdentifiedSensor out;
    out.model = preset_;
    for (int j = 0; j < 7; ++j) identify(j, out);
    out.surprise = surprise(out.model);
    const double widened = std::max(1.0, out.surprise);
    for (auto* spread :
         {&out.model.noise, &out.model.offset, &out.model.stiction, &out.model.coulomb_std, &out.model.viscous_std})
      *spread *= widened;
    return out;
  }

 private:
  static constexpr int kIterations = 300;
  static constexpr double kLeast = 1e-4;  // that a standard deviation may be [N m, N m s/rad]
  static constexpr double kFast = 0.1;    // slower motion says nothing about viscous friction [rad/s]

  using Regressors = Eigen::Matrix<double, Eigen::Dynamic, 3>;  // of the nuisances, a row per block
  using Weights = Eigen::Matrix<double, Eigen::Dynamic, 4>;     // of a payload (m, m r)

  /// What is unknown of a joint. The means are (o of each log, c, v).
  struct Unknowns {
    Eigen::VectorXd means;
    Eigen::Vector3d lambda;  // Lambda's diagonal
    double noise = 0;        // variance of a block
    Eigen::Vector3d beta(std::size_t log) const {
      return {means[static_cast<Eigen::Index>(log)], means[means.size() - 2], means[means.size() - 1]};
    }
  };

  /// Calls visit(log, y, N) with each window of a joint.
  template <typename Visit>
  void for_each_window(int joint, Visit&& visit) const {
    for (std::size_t log = 0; log < logs_.size(); ++log) {
      const auto& blocks = logs_[log][static_cast<std::size_t>(joint)];
      for (Eigen::Index row = 0; row + per_window_ <= blocks.rows(); row += per_window_) {
        const auto window = blocks.middleRows(row, per_window_);
        visit(log, Eigen::VectorXd(window.col(0)), Regressors(window.middleCols<3>(1)));
      }
    }
  }

  /// (noise + N Lambda N^T)^-1 of a window.
  static Eigen::LLT<Eigen::MatrixXd> whitener(double noise, const Eigen::Matrix3d& lambda, const Regressors& N) {
    Eigen::MatrixXd V = N * lambda * N.transpose();
    V.diagonal().array() += noise;
    return Eigen::LLT<Eigen::MatrixXd>(V);
  }

  /// Generalised least squares for the means. @return the standard deviations of c and v
  Eigen::Vector2d fit_means(int joint, Unknowns& u) const {
    const Eigen::Index size = u.means.size();
    Eigen::MatrixXd normal = Eigen::MatrixXd::Zero(size, size);
    Eigen::VectorXd rhs = Eigen::VectorXd::Zero(size);
    for_each_window(joint, [&](std::size_t log, const Eigen::VectorXd& y, const Regressors& N) {
      const Regressors VN = whitener(u.noise, u.lambda.asDiagonal(), N).solve(N);
      const Eigen::Matrix3d F = N.transpose() * VN;
      const Eigen::Vector3d f = VN.transpose() * y;
      const Eigen::Index at[] = {static_cast<Eigen::Index>(log), size - 2, size - 1};
      for (int a = 0; a < 3; ++a) {
        rhs[at[a]] += f[a];
        for (int b = 0; b < 3; ++b) normal(at[a], at[b]) += F(a, b);
      }
    });
    // Next to no information about the friction, so that there is a solution for a joint that never moved.
    normal(size - 2, size - 2) += 1e-2;
    normal(size - 1, size - 1) += 1e-2;
    const Eigen::LLT<Eigen::MatrixXd> llt(normal);
    u.means = llt.solve(rhs);
    return llt.solve(Eigen::MatrixXd::Identity(size, size)).diagonal().tail<2>().cwiseSqrt();
  }

  /// One step of expectation maximisation for Lambda and the noise. @return the correlation of neighbouring blocks
  double fit_spreads(int joint, Unknowns& u) const {
    const Eigen::Matrix3d lambda = u.lambda.asDiagonal();
    Eigen::Vector3d spread = Eigen::Vector3d::Zero();
    double rest = 0, variance = 0, covariance = 0;
    for_each_window(joint, [&](std::size_t log, const Eigen::VectorXd& y, const Regressors& N) {
      const auto V = whitener(u.noise, lambda, N);
      const Eigen::VectorXd error = y - N * u.beta(log);
      const Eigen::Vector3d deviation = lambda * (N.transpose() * V.solve(error));  // of beta, its posterior mean
      const Eigen::Matrix3d doubt = lambda - lambda * (N.transpose() * V.solve(N)) * lambda;
      const Eigen::VectorXd noise = error - N * deviation;
      spread += deviation.cwiseAbs2() + doubt.diagonal();
      rest += noise.squaredNorm() + (N * doubt * N.transpose()).trace();
      variance += noise.squaredNorm();
      covariance += noise.head(noise.size() - 1).dot(noise.tail(noise.size() - 1));
    });
    u.lambda = (spread / windows_).cwiseMax(kLeast * kLeast);
    u.noise = std::max(rest / static_cast<double>(windows_ * per_window_), kLeast * kLeast);
    return covariance / variance;
  }

  void identify(int j, IdentifiedSensor& out) const {
    const auto s = static_cast<std::size_t>(j);
    const auto logs = static_cast<double>(logs_.size());
    SensorModel<double, 7>& model = out.model;
    Unknowns u;
    u.means = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(logs_.size()) + 2);
    // Expectation maximisation shrinks a spread that is too large, but hardly widens one that is far too small.
    u.lambda.setConstant(0.3 * 0.3);
    u.noise = 0.3 * 0.3;
    Eigen::Vector2d doubt;
    double correlation = 0;
    for (int i = 0; i < kIterations; ++i) {
      doubt = fit_means(j, u);
      correlation = fit_spreads(j, u);
    }
    out.correlation = std::max(out.correlation, correlation);
    // The means, found from the same windows, have taken their share of what varies from window to window.
    const double freedom = windows_ - static_cast<double>(u.means.size());
    u.lambda *= windows_ / std::max(1.0, freedom);
    const Eigen::Index c = u.means.size() - 2;
    out.coulomb_known[s] =
        moves_both_ways(j) && take(u.means[c], doubt[0], u.lambda[1], model.coulomb_mean[j], model.coulomb_std[j]);
    out.viscous_known[s] =
        moves_fast(j) && take(u.means[c + 1], doubt[1], u.lambda[2], model.viscous_mean[j], model.viscous_std[j]);
    model.noise[j] = std::sqrt(u.noise);
    // A handful of logs says little about how far offsets spread: the preset counts as one more.
    model.offset[j] = std::sqrt((u.means.head(c).squaredNorm() + preset_.offset[j] * preset_.offset[j]) / (logs + 1));
    const double stiction = std::sqrt(u.lambda[0]);
    out.stiction_known[s] = out.coulomb_known[s] && freedom >= 5;
    if (out.stiction_known[s] || stiction > model.stiction[j]) model.stiction[j] = stiction;
  }

  /// Whether a joint's log tells its Coulomb friction from an offset, and its viscous friction from either.
  bool moves_both_ways(int joint) const {
    return largest(joint, [](const auto& blocks) { return blocks.col(2).maxCoeff(); }) > 0.5 &&
           largest(joint, [](const auto& blocks) { return -blocks.col(2).minCoeff(); }) > 0.5;
  }
  bool moves_fast(int joint) const {
    return largest(joint, [](const auto& blocks) { return blocks.col(3).cwiseAbs().maxCoeff(); }) > kFast;
  }
  template <typename Of>
  double largest(int joint, Of&& of) const {
    double out = 0;
    for (const LogBlocks& log : logs_) out = std::max(out, double(of(log[static_cast<std::size_t>(joint)])));
    return out;
  }

  /// Replaces a friction coefficient of the preset, unless it is known better than the logs tell it and may be true.
  static bool take(double measured, double doubt, double spread, double& mean, double& deviation) {
    const double total = std::sqrt(spread + doubt * doubt);
    if (total > deviation && std::abs(measured - mean) < 2 * doubt) return false;
    mean = std::max(measured, 0.0);
    deviation = std::hypot(total, measured - mean);
    return true;
  }

  /// By how many standard deviations the logs look like a payload in windows as long as an event, rms over the windows
  /// and over the four directions of (m, m r).
  double surprise(const SensorModel<double, 7>& model) const {
    const auto prior = model.prior();
    double squares = 0;
    int directions = 0;
    for (const LogBlocks& log : logs_) {
      for (Eigen::Index row = 0; row + per_event_ <= log[0].rows(); row += per_event_) {
        Eigen::Matrix4d information = Eigen::Matrix4d::Zero();
        Eigen::Vector4d score = Eigen::Vector4d::Zero();
        for (std::size_t j = 0; j < 7; ++j) {
          const auto blocks = log[j].middleRows(row, per_event_);
          const Regressors N = blocks.middleCols<3>(1);
          const Weights payload = blocks.rightCols<4>();
          const double noise = model.noise[static_cast<Eigen::Index>(j)];
          const Weights whitened = whitener(noise * noise, prior.covariance[j], N).solve(payload);
          information += payload.transpose() * whitened;
          score += whitened.transpose() * (blocks.col(0) - N * prior.mean[j]);
        }
        squares += score.dot(information.ldlt().solve(score));
        directions += 4;
      }
    }
    return std::sqrt(squares / directions);
  }

  SensorModel<double, 7> preset_;
  Eigen::Index per_window_, per_event_;
  std::vector<LogBlocks> logs_;
  int windows_ = 0;
};

}  // namespace rme::examples
