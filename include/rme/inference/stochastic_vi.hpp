#pragma once
/// Variational inference by stochastic gradients, as published: slow and noisy, for likelihoods of any form.
#include <Eigen/Cholesky>
#include <array>
#include <cmath>
#include <random>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/inference_result.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/inference/payload_likelihood.hpp>

namespace rme {

/// Selects the published solver; the defaults are the published settings. One learning rate serves for kg, m and
/// logarithms of standard deviations. With 0.025, the centre of mass fluctuates by about its prior's standard
/// deviation.
struct StochasticViConfig {
  double learning_rate = 0.025;  ///< of Adam, > 0
  double gradient_norm = 1;      ///< gradients are clipped to this norm, > 0; finite values bias the optimum
  int max_steps = 2500;          ///< bound on the work, >= 1
  int first_check = 700;         ///< steps before the first check for convergence, >= 0
  int check_interval = 10;       ///< steps between two checks, > 0
  double small_change = 0.04;    ///< a change of the eight parameters between two checks is small below this norm, >= 0
  int small_changes = 2;         ///< the run ends after this many small changes in a row, >= 1
  /// Standard deviations of q at the start [kg, m, m, m], each > 0; its mean is then the prior's.
  std::array<double, 4> initial_deviation = {1, 0.05, 0.05, 0.1};
  int evidence_draws = 100;  ///< number of draws over which the reported ELBO is averaged, > 0
};

/// Maximises the ELBO of a diagonal Gaussian q = N(mu, diag(exp(2 s))) by its one-sample reparametrised gradient: with
/// theta = mu + exp(s) epsilon, epsilon ~ N(0, 1), and g = grad log p(y, theta),
///
///     d/dmu = g,   d/ds = g exp(s) epsilon + 1                               (docs/theory.md (T40))
///
/// with Adam (Kingma and Ba, 2015), decay rates 0.9 and 0.999. The last iterate is the result, noise included. The work
/// is bounded, but too much for a control tick (docs/performance.md). No allocation. The settings are not checked.
/// @param log_likelihood  callable (const Vector4& theta, Vector4& gradient) -> Scalar, noexcept: log p(y | theta) up
///                        to a constant, which is then that of InferenceResult::log_evidence
/// @param prior           over (m, r), covariance positive definite
/// @param[out] result     the last iterate; as it was if the status is NonFiniteInput or NotPositiveDefinite
/// @param config          the defaults are the published ones
/// @param random          a generator in the sense of the standard library, which is advanced; it must not throw
/// @return Ok; NotConverged (max_steps was reached; the result is valid); NonFiniteInput, also if the likelihood is not
///         finite; NotPositiveDefinite (the prior's covariance)
template <typename LogLikelihood, typename Scalar, typename Random>
Status infer_payload(const LogLikelihood& log_likelihood, const PayloadGaussian<Scalar>& prior,
                     InferenceResult<Scalar>& result, const StochasticViConfig& config, Random& random) noexcept;

/// The same for the bilinear model.
template <typename Scalar, typename Random>
Status infer_payload(const PayloadLikelihood<Scalar>& likelihood, const PayloadGaussian<Scalar>& prior,
                     InferenceResult<Scalar>& result, const StochasticViConfig& config, Random& random) noexcept {
  if (!likelihood.all_finite()) return Status::NonFiniteInput;
  const auto ratio = [&likelihood](const Vector4<Scalar>& theta, Vector4<Scalar>& gradient) noexcept {
    return likelihood.log_likelihood_ratio(theta, gradient);
  };
  return infer_payload(ratio, prior, result, config, random);
}

namespace detail {

/// Adam with clipped gradients, which maximises over N parameters.
template <typename Scalar, int N>
class Adam {
 public:
  using Vector = Eigen::Matrix<Scalar, N, 1>;

  Adam(Scalar learning_rate, Scalar gradient_norm) noexcept : rate_(learning_rate), norm_(gradient_norm) {}

  /// The step to take.
  Vector operator()(const Vector& gradient) noexcept {
    constexpr Scalar kFirst = Scalar(0.9), kSecond = Scalar(0.999), kSmall = Scalar(1e-8);
    const Scalar norm = gradient.norm();
    const Vector g = norm > norm_ ? Vector(gradient * (norm_ / norm)) : gradient;
    mean_ = kFirst * mean_ + (1 - kFirst) * g;
    square_ = kSecond * square_ + (1 - kSecond) * g.cwiseAbs2();
    mean_left_ *= kFirst;
    square_left_ *= kSecond;
    return (rate_ / (1 - mean_left_)) *
           mean_.cwiseQuotient(((square_ / (1 - square_left_)).cwiseSqrt().array() + kSmall).matrix());
  }

 private:
  Scalar rate_, norm_;
  Vector mean_ = Vector::Zero(), square_ = Vector::Zero();  // decaying averages of the gradients
  Scalar mean_left_ = Scalar(1), square_left_ = Scalar(1);  // weight of their start at zero
};

}  // namespace detail

template <typename LogLikelihood, typename Scalar, typename Random>
Status infer_payload(const LogLikelihood& log_likelihood, const PayloadGaussian<Scalar>& prior,
                     InferenceResult<Scalar>& result, const StochasticViConfig& config, Random& random) noexcept {
  if (!prior.mean.allFinite() || !prior.covariance.allFinite()) return Status::NonFiniteInput;
  const Eigen::LLT<Matrix4<Scalar>> prior_llt(prior.covariance);
  if (prior_llt.info() != Eigen::Success) return Status::NotPositiveDefinite;
  const Matrix4<Scalar> prior_precision = prior_llt.solve(Matrix4<Scalar>::Identity());

  Vector4<Scalar> mu = prior.mean, s, epsilon, gradient;
  for (int i = 0; i < 4; ++i) s[i] = Scalar(std::log(config.initial_deviation[std::size_t(i)]));
  std::normal_distribution<Scalar> normal;
  // log p(y, theta) at one draw from q, and its gradient, up to the prior's normaliser.
  const auto draw = [&]() noexcept {
    for (int i = 0; i < 4; ++i) epsilon[i] = normal(random);
    const Vector4<Scalar> theta = mu + s.array().exp().matrix().cwiseProduct(epsilon), d = theta - prior.mean;
    const Vector4<Scalar> slope = prior_precision * d;
    const Scalar value = log_likelihood(theta, gradient) - Scalar(0.5) * d.dot(slope);
    gradient -= slope;
    return value;
  };

  using Parameters = Eigen::Matrix<Scalar, 8, 1>;  // (mu, s)
  detail::Adam<Scalar, 8> adam(Scalar(config.learning_rate), Scalar(config.gradient_norm));
  Parameters at_check = Parameters::Zero();
  int in_a_row = 0, step = 0, next_check = config.first_check;
  Status status = Status::NotConverged;
  while (step < config.max_steps && status == Status::NotConverged) {
    ++step;
    if (!std::isfinite(draw()) || !gradient.allFinite()) return Status::NonFiniteInput;
    Parameters uphill;
    uphill << gradient, (gradient.array() * s.array().exp() * epsilon.array() + Scalar(1)).matrix();
    const Parameters change = adam(uphill);
    mu += change.template head<4>();
    s += change.template tail<4>();
    if (step < next_check) continue;
    next_check = step + config.check_interval;
    Parameters now;
    now << mu, s;
    const bool small = step > config.first_check && (now - at_check).norm() < Scalar(config.small_change);
    in_a_row = small ? in_a_row + 1 : 0;
    if (in_a_row >= config.small_changes) status = Status::Ok;
    at_check = now;
  }

  Scalar sum = Scalar(0);
  for (int k = 0; k < config.evidence_draws; ++k) sum += draw();
  // Entropy of q and normaliser of the prior; their powers of 2 pi cancel.
  const Scalar log_evidence =
      sum / Scalar(config.evidence_draws) + s.sum() + Scalar(2) - prior_llt.matrixLLT().diagonal().array().log().sum();
  if (!std::isfinite(log_evidence)) return Status::NonFiniteInput;
  result.posterior = {mu, (2 * s).array().exp().matrix().asDiagonal()};
  result.log_evidence = log_evidence;
  result.iterations = step;
  return status;
}

}  // namespace rme
