#pragma once
/// The published pipeline written down step by step: one vector of ticks, plain loops, the constants of the paper.
#include <Eigen/Cholesky>
#include <algorithm>
#include <array>
#include <cmath>
#include <random>
#include <rme/core/cholesky.hpp>
#include <rme/network/weights.hpp>
#include <rme/sensing/proprioception.hpp>
#include <vector>

namespace rme::testing {

/// What is counted in samples, at one control rate.
struct LiteralRate {
  int window;                              ///< of Algorithm 1
  int newest;                              ///< samples in the newest mean
  int check;                               ///< samples in each of the means compared with it
  std::array<int, 3> check_age;            ///< samples that are newer than each of those
  int collection;                          ///< N
  std::array<int, 20> network_samples;     ///< of the collection, 0 being its oldest
  std::array<int, 50> likelihood_samples;  ///< of the collection, 0 being its oldest
};

/// 1 kHz: samples 491..500, 431..450, 351..370 and 271..290 of 500; 200 are collected. The network sees the last of
/// each ten; the likelihood takes the nearest to 50 points on a line from the first to the last.
inline LiteralRate literal_1khz() {
  LiteralRate rate{500, 10, 20, {50, 130, 210}, 200, {}, {}};
  for (int i = 0; i < 20; ++i) rate.network_samples[std::size_t(i)] = 10 * i + 9;
  for (int k = 0; k < 50; ++k) rate.likelihood_samples[std::size_t(k)] = int(std::lround(k * 199.0 / 49.0));
  return rate;
}

/// 250 Hz: 500 ms are 125 samples, 10 ms 2.5 and hence 3, and so on. All of the 50 collected are in the likelihood.
inline LiteralRate literal_250hz() {
  LiteralRate rate{125, 3, 5, {13, 33, 53}, 50, {1, 4, 6, 9, 11, 14, 16, 19, 21, 24}, {}};
  for (std::size_t i = 0; i < 10; ++i) rate.network_samples[10 + i] = 25 + rate.network_samples[i];
  for (int k = 0; k < 50; ++k) rate.likelihood_samples[std::size_t(k)] = k;
  return rate;
}

template <typename Scalar>
struct LiteralEstimate {
  std::size_t detected = 0, made = 0;  ///< on which ticks, the first being number 1
  Eigen::Matrix<Scalar, 4, 1> mean, variance;
  int steps = 0;
  bool stopped = false;  ///< before the last step, by the stop rule
};

/// Keeps every tick since its construction.
///
/// Sums, products and elementary functions are Eigen's, of the same sizes as in the library, so that the results can
/// be equal to the last bit: Eigen's exp() is not the standard library's, and it may add in another order than a loop.
template <typename Scalar, int Dofs, typename Network>
class LiteralPipeline {
 public:
  using Sample = Proprioception<Scalar, Dofs>;
  using Vector4 = Eigen::Matrix<Scalar, 4, 1>;
  using Vector8 = Eigen::Matrix<Scalar, 8, 1>;

  LiteralPipeline(const Network& network, std::uint64_t seed, const LiteralRate& rate)
      : network_(network), rate_(rate), random_(seed) {}

  void update(const Sample& sample) {
    ticks_.push_back(sample);
    norms_.push_back(double(sample.tau_ext.norm()));
    const bool mismatch = algorithm_one();
    if (left_ > 0) {
      if (--left_ == 0) estimate();
    } else if (mismatch) {
      detected_ = ticks_.size();
      left_ = rate_.collection;
    }
  }

  const std::vector<LiteralEstimate<Scalar>>& estimates() const { return estimates_; }

 private:
  // Algorithm 1, with the absolute value that the scan drops.
  bool algorithm_one() const {
    if (int(norms_.size()) < rate_.window) return false;
    const auto age = [this](int a) { return norms_[norms_.size() - 1 - std::size_t(a)]; };
    const auto mean = [&age](int newest, int count) {
      double sum = 0;
      for (int a = newest; a < newest + count; ++a) sum += age(a);
      return sum / count;
    };
    const bool rapid_change = std::abs(age(0) - age(rate_.window - 1)) > 0.9;
    const double end = mean(0, rate_.newest);
    bool stabilisation = true;
    for (const int check : rate_.check_age)
      if (std::abs(mean(check, rate_.check) - end) > 0.2) stabilisation = false;
    return rapid_change && stabilisation;
  }

  const Sample& collected(int i) const {
    return ticks_[ticks_.size() - std::size_t(rate_.collection) + std::size_t(i)];
  }

  /// W_t = (J J^T + lambda I)^-1 J tau_ext, and what the network says to 20 of them.
  Vector4 ask_network() const {
    typename Network::Window input;
    for (int i = 0; i < 20; ++i) {
      const Sample& s = collected(rate_.network_samples[std::size_t(i)]);
      Eigen::Matrix<Scalar, 6, 6> damped = s.jacobian * s.jacobian.transpose();
      for (int d = 0; d < 6; ++d) damped(d, d) += Scalar(1e-2);
      const Eigen::Matrix<Scalar, 6, 1> b = s.jacobian * s.tau_ext, w = Cholesky<Scalar, 6>(damped).solve(b);
      Eigen::Matrix<Scalar, 3, 1> force = w.template head<3>(), moment = w.template tail<3>();
      if (network_.frame() == InputFrame::EndEffector) {
        force = (s.rotation.transpose() * force).eval();
        moment = (s.rotation.transpose() * moment).eval();
      }
      for (int c = 0; c < 3; ++c) {
        input(i, c) = typename Network::Output::Scalar(force[c]);
        input(i, 3 + c) = typename Network::Output::Scalar(moment[c]);
      }
    }
    typename Network::Output out = Network::Output::Zero();
    if (network_.forward(input, out) != Status::Ok) out.fill(0);
    return out.template cast<Scalar>();
  }

  /// Of tau_t ~ N(m (a_t + B_t r), diag(sigma_j^2)): sum over samples and joints of z z^T / sigma_j^2, z = (tau, a, B).
  Eigen::Matrix<Scalar, 5, 5> likelihood_sums() const {
    Eigen::Matrix<Scalar, 5, 5> total = Eigen::Matrix<Scalar, 5, 5>::Zero();
    const Scalar g = Scalar(-9.81);  // along z
    for (int j = 0; j < Dofs; ++j) {
      Scalar least = collected(0).tau_ext[j], most = least;
      Eigen::Matrix<Scalar, 5, 5> sums = Eigen::Matrix<Scalar, 5, 5>::Zero();
      for (const int t : rate_.likelihood_samples) {
        const Sample& s = collected(t);
        least = std::min(least, s.tau_ext[j]);
        most = std::max(most, s.tau_ext[j]);
        // The torque is J^T (m g ; R r x m g), and u x (0, 0, g) = (u_y g, -u_x g, 0).
        Eigen::Matrix<Scalar, 3, 3> moment;  // per kilogram and metre
        for (int k = 0; k < 3; ++k) {
          moment(0, k) = s.rotation(1, k) * g;
          moment(1, k) = -s.rotation(0, k) * g;
          moment(2, k) = 0;
        }
        const Eigen::Matrix<Scalar, Dofs, 3> B = s.jacobian.template bottomRows<3>().transpose() * moment;
        const Scalar z[] = {s.tau_ext[j], s.jacobian(2, j) * g, B(j, 0), B(j, 1), B(j, 2)};
        for (int i = 0; i < 5; ++i)
          for (int k = 0; k < 5; ++k) sums(i, k) += z[i] * z[k];
      }
      const Scalar sigma = std::max(Scalar(0.25) * (most - least), Scalar(0.1));
      const Scalar precision = 1 / (sigma * sigma);
      for (int i = 0; i < 5; ++i)
        for (int k = 0; k < 5; ++k) total(i, k) += precision * sums(i, k);
    }
    return total;
  }

  /// Adam (0.025) up the one-sample gradient of the ELBO, clipped to 1; every 10 steps after 700 it is asked whether
  /// mean and logarithms of deviations have moved by less than 0.04, and it stops when that is so twice in a row.
  void estimate() {
    const Vector4 prior_mean = ask_network();
    const Eigen::Matrix<Scalar, 5, 5> sums = likelihood_sums();
    const Eigen::Matrix<Scalar, 3, 1> yB = sums.template block<3, 1>(2, 0), aB = sums.template block<3, 1>(2, 1);
    const Eigen::Matrix<Scalar, 3, 3> BB = sums.template block<3, 3>(2, 2);
    const Scalar ya = sums(0, 1), aa = sums(1, 1);

    Eigen::Matrix<Scalar, 4, 4> covariance = Eigen::Matrix<Scalar, 4, 4>::Zero();
    const Scalar deviation[] = {Scalar(0.5), Scalar(0.02), Scalar(0.02), Scalar(0.05)};
    for (int i = 0; i < 4; ++i) covariance(i, i) = deviation[i] * deviation[i];
    const Eigen::Matrix<Scalar, 4, 4> prior_precision =
        Eigen::LLT<Eigen::Matrix<Scalar, 4, 4>>(covariance).solve(Eigen::Matrix<Scalar, 4, 4>::Identity());

    Vector4 mu = prior_mean, s;
    const double start[] = {1, 0.05, 0.05, 0.1};
    for (int i = 0; i < 4; ++i) s[i] = Scalar(std::log(start[i]));
    std::normal_distribution<Scalar> normal;  // anew for each estimate
    Vector8 momentum = Vector8::Zero(), square = Vector8::Zero(), at_check = Vector8::Zero();
    Scalar beta1 = 1, beta2 = 1;  // powers of 0.9 and 0.999
    LiteralEstimate<Scalar> out;
    for (int small = 0; out.steps < 2500 && small < 2;) {
      ++out.steps;
      Vector4 epsilon;
      for (int i = 0; i < 4; ++i) epsilon[i] = normal(random_);
      const Vector4 width = s.array().exp(), theta = mu + width.cwiseProduct(epsilon);
      const Scalar m = theta[0];
      const Eigen::Matrix<Scalar, 3, 1> r = theta.template tail<3>(), slope = aB + BB * r;
      Vector4 gradient;
      gradient[0] = ya + yB.dot(r) - m * (aa + (aB + slope).dot(r));
      for (int i = 0; i < 3; ++i) gradient[1 + i] = m * yB[i] - m * m * slope[i];
      gradient -= prior_precision * (theta - prior_mean);
      Vector8 uphill;
      for (int i = 0; i < 4; ++i) {
        uphill[i] = gradient[i];
        uphill[4 + i] = gradient[i] * width[i] * epsilon[i] + 1;
      }
      const Scalar length = uphill.norm();
      if (length > 1) uphill *= 1 / length;
      beta1 *= Scalar(0.9);
      beta2 *= Scalar(0.999);
      for (int i = 0; i < 8; ++i) {
        momentum[i] = Scalar(0.9) * momentum[i] + (1 - Scalar(0.9)) * uphill[i];
        square[i] = Scalar(0.999) * square[i] + (1 - Scalar(0.999)) * (uphill[i] * uphill[i]);
      }
      const Vector8 root = (square / (1 - beta2)).cwiseSqrt();
      for (int i = 0; i < 8; ++i) {
        const Scalar change = Scalar(0.025) / (1 - beta1) * (momentum[i] / (root[i] + Scalar(1e-8)));
        (i < 4 ? mu[i] : s[i - 4]) += change;
      }
      if (out.steps < 700 || (out.steps - 700) % 10 != 0) continue;
      Vector8 now;
      now << mu, s;
      const bool moved_little = (now - at_check).norm() < Scalar(0.04);
      small = out.steps > 700 && moved_little ? small + 1 : 0;  // the first has none to be compared with
      at_check = now;
      out.stopped = small == 2;
    }
    for (int i = 0; i < 400; ++i) (void)normal(random_);  // the library's ELBO: 100 draws, of which the paper has none
    out.detected = detected_;
    out.made = ticks_.size();
    out.mean = mu;
    for (int i = 0; i < 4; ++i) out.variance[i] = std::exp(2 * s[i]);
    estimates_.push_back(out);
  }

  const Network& network_;
  LiteralRate rate_;
  std::mt19937_64 random_;
  std::vector<Sample> ticks_;
  std::vector<double> norms_;
  int left_ = 0;  // of the collection that is going on
  std::size_t detected_ = 0;
  std::vector<LiteralEstimate<Scalar>> estimates_;
};

}  // namespace rme::testing
