#pragma once
/// The paper's estimator as published: detect, collect 200 ms, ask the network, infer, compensate.
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <random>
#include <rme/core/compensation.hpp>
#include <rme/core/plausible.hpp>
#include <rme/core/require.hpp>
#include <rme/core/ring_buffer.hpp>
#include <rme/core/status.hpp>
#include <rme/core/types.hpp>
#include <rme/inference/exact_posterior.hpp>
#include <rme/inference/inference_result.hpp>
#include <rme/inference/mean_field.hpp>
#include <rme/inference/payload_gaussian.hpp>
#include <rme/inference/payload_likelihood.hpp>
#include <rme/inference/payload_regressor.hpp>
#include <rme/inference/payload_statistics.hpp>
#include <rme/inference/published_likelihood.hpp>
#include <rme/inference/stochastic_vi.hpp>
#include <rme/inference/variational_inference.hpp>
#include <rme/network/mismatch_network.hpp>
#include <rme/published/pseudo_wrench_sequence.hpp>
#include <rme/published/published_config.hpp>
#include <rme/published/published_state.hpp>
#include <rme/sensing/mismatch_detector.hpp>
#include <rme/sensing/proprioception.hpp>

namespace rme {

/// Rapid mismatch estimation as in the paper (Section 4.1, Algorithm 1, Appendices A to F): for its tables and for
/// comparisons. For a robot, use Estimator.
///
///  1. Algorithm 1 watches ||tau_ext||_2. A removal is a change as well, and starts an estimate in the same way.
///  2. The samples of the 200 ms after the detection are collected: N = 200 at 1 kHz.
///  3. M = 20 pseudo-wrenches from these samples go to the network, whose output is the mean of the prior.
///  4. 50 of the samples make the likelihood: raw tau_ext, a payload at rest, white noise, no offset and no friction.
///  5. Stochastic variational inference; the diagonal Gaussian that it ends with is the estimate. Another solver may
///     take its place: PublishedPipelineConfig::solver.
///  6. compensation() uses it from that tick on, and Algorithm 1 watches again.
///
/// Algorithm 1 looks at the last 500 ms only. So a change that has settled is detected and estimated again as long as
/// its beginning is in these 500 ms: usually there are two estimates. A sharp change may be detected before the means
/// move; its first estimate then includes the transient. While samples are collected, the detector is updated, but its
/// result is ignored.
///
/// The published solver amplifies rounding errors: its steps are about as long as the prior's standard deviations. So a
/// change of the torque by one part in 10^15 may move the estimate by centimetres. Compilers that round differently
/// give different estimates from the same seed.
///
/// The tick that ends a collection runs the whole inference. The published solver takes about half a millisecond for
/// 2,500 steps on a desktop: too long for the loop of a host. In the paper, it ran in a process of its own and took
/// 226 ms. The other solvers take some microseconds.
/// No call but the constructor allocates or throws; the work is bounded.
/// @tparam Network  MismatchNetwork, or a type with its Window, Output, frame() and forward(), all noexcept; without a
///                  network, FixedGuess. Its Scalar may differ from the pipeline's
template <typename Scalar, int Dofs, typename Network = MismatchNetwork<float>>
class PublishedPipeline {
 public:
  using Config = PublishedPipelineConfig<Scalar>;  ///< settings
  using State = PublishedState<Scalar>;            ///< its output
  using Torque = JointVector<Scalar, Dofs>;        ///< [N m]

  /// @param dt       control period [s], > 0
  /// @param network  is kept by reference
  /// @param config   the defaults are the published ones
  /// @param seed     of the published solver's random generator, a std::mt19937_64, which is not seeded again between
  ///                 estimates
  /// @throws std::invalid_argument naming the field out of range
  PublishedPipeline(double dt, const Network& network, const Config& config = Config(), std::uint64_t seed = 1);
  /// Deleted: a temporary network would no longer exist at the first tick.
  PublishedPipeline(double, const Network&&, const Config& = Config(), std::uint64_t = 1) = delete;

  /// Advances by one period dt.
  /// @param sample  tau_ext (what the environment exerts on the arm), J and R are used; the rest must be plausible
  /// @return Ok; NonFiniteInput or NotARotation: the pipeline is then as it was, and the tick does not count
  Status update(const Proprioception<Scalar, Dofs>& sample) noexcept;

  const State& state() const noexcept { return state_; }  ///< after the last update()
  /// tau_comp = -J^T w(theta_hat) [N m], Dofs x 1, where theta_hat is the mean of the last estimate; zero before the
  /// first. If the pose is not plausible (plausible.hpp), that of the last good sample is used.
  /// @param jacobian  J, 6 x Dofs, world axes, linear rows first
  /// @param rotation  R, end-effector axes to world axes
  Torque compensation(const Jacobian<Scalar, Dofs>& jacobian, const Matrix3<Scalar>& rotation) const noexcept;
  /// Seconds since construction or reset.
  double time() const noexcept { return static_cast<double>(ticks_) * dt_; }
  const Config& config() const noexcept { return config_; }  ///< as constructed
  /// Returns to the state after construction: an empty hand, no samples, the random generator at its seed.
  void reset() noexcept;

 private:
  static_assert(Network::Output::RowsAtCompileTime == 4, "a prior needs m, r_x, r_y, r_z");

  Status infer(InferenceResult<Scalar>& result) noexcept;
  Status solve(const PayloadLikelihood<Scalar>& likelihood, const PayloadGaussian<Scalar>& prior,
               InferenceResult<Scalar>& result) noexcept;
  void make_estimate() noexcept;

  Config config_;
  const Network* network_;
  double dt_;
  std::uint64_t seed_;
  MismatchDetector<1> detector_;
  RingBuffer<Proprioception<Scalar, Dofs>> window_;  // as long as a collection
  std::mt19937_64 random_;
  std::uint64_t ticks_ = 0;
  std::size_t collected_ = 0;  // samples of the collection that is going on
  State state_;
};

template <typename Scalar, int Dofs, typename Network>
PublishedPipeline<Scalar, Dofs, Network>::PublishedPipeline(double dt, const Network& network, const Config& config,
                                                            std::uint64_t seed)
    : config_((config.validate(dt), config)),
      network_(&network),
      dt_(dt),
      seed_(seed),
      detector_(dt, config.detector),
      window_(static_cast<std::size_t>(std::lround(config.collection / dt))),
      random_(seed) {
  constexpr int kSamples = Network::Window::RowsAtCompileTime;
  detail::require(window_.capacity() >= static_cast<std::size_t>(kSamples), "PublishedPipelineConfig::collection",
                  "at least as many samples as the network sees", window_.capacity());
}

template <typename Scalar, int Dofs, typename Network>
void PublishedPipeline<Scalar, Dofs, Network>::reset() noexcept {
  detector_.reset();
  window_.clear();
  random_.seed(seed_);
  ticks_ = 0;
  collected_ = 0;
  state_ = State();
}

template <typename Scalar, int Dofs, typename Network>
Status PublishedPipeline<Scalar, Dofs, Network>::update(const Proprioception<Scalar, Dofs>& sample) noexcept {
  Status status = check_sample(sample);
  if (status != Status::Ok) return status;
  status = detector_.update(MismatchDetector<1>::Signal(static_cast<double>(sample.tau_ext.norm())));
  if (status != Status::Ok) return status;
  window_.push(sample);
  ++ticks_;
  if (state_.phase == PublishedPhase::Collecting) {
    if (++collected_ == window_.capacity()) make_estimate();
  } else if (detector_.detected()) {
    state_.phase = PublishedPhase::Collecting;
    state_.detected_at = time();
    ++state_.detections;
    collected_ = 0;
  }
  return Status::Ok;
}

template <typename Scalar, int Dofs, typename Network>
void PublishedPipeline<Scalar, Dofs, Network>::make_estimate() noexcept {
  InferenceResult<Scalar> result;
  state_.phase = PublishedPhase::Watching;
  state_.outcome = infer(result);
  if (state_.outcome != Status::Ok && state_.outcome != Status::NotConverged) return;
  ++state_.estimates;
  state_.estimated_at = time();
  state_.posterior = result.posterior;
  state_.iterations = result.iterations;
}

/// Infers the payload from the window, which contains exactly the collection when this is called.
template <typename Scalar, int Dofs, typename Network>
Status PublishedPipeline<Scalar, Dofs, Network>::infer(InferenceResult<Scalar>& result) noexcept {
  using Sample = Proprioception<Scalar, Dofs>;
  const auto at = [this](int i) noexcept -> const Sample& { return window_[static_cast<std::size_t>(i)]; };
  const int count = static_cast<int>(window_.size());

  typename Network::Window input;
  Status status = pseudo_wrench_sequence<Scalar, Dofs>(count, at, config_.damping, network_->frame(), input);
  typename Network::Output guess;
  if (status == Status::Ok) status = network_->forward(input, guess);
  if (status != Status::Ok) return status;
  const auto prior = PayloadGaussian<Scalar>::independent(guess.template cast<Scalar>(), config_.standard_deviation);

  const auto observation = [&](int i) noexcept {
    const Sample& sample = at(i);
    PayloadObservation<Scalar, Dofs> out;
    out.tau = sample.tau_ext;
    out.regressor = payload_regressor<Scalar, Dofs>(sample.jacobian, sample.rotation, config_.gravity);
    return out;
  };
  PayloadLikelihood<Scalar> likelihood;
  status = published_likelihood<Scalar, Dofs>(count, observation, likelihood, config_.likelihood);
  if (status != Status::Ok) return status;
  status = solve(likelihood, prior, result);
  // A payload that no arm carries could overflow in the compensation.
  return plausible(result.posterior.mean) ? status : Status::NonFiniteInput;
}

template <typename Scalar, int Dofs, typename Network>
Status PublishedPipeline<Scalar, Dofs, Network>::solve(const PayloadLikelihood<Scalar>& likelihood,
                                                       const PayloadGaussian<Scalar>& prior,
                                                       InferenceResult<Scalar>& result) noexcept {
  switch (config_.solver) {
    case PublishedSolver::ClosedForm:
      return infer_payload(likelihood, prior, result, VariationalInferenceConfig());
    case PublishedSolver::MeanField:
      return infer_payload(likelihood, prior, result, MeanFieldConfig());
    case PublishedSolver::Exact:
      return infer_payload(likelihood, prior, result, ExactQuadrature());
    case PublishedSolver::Stochastic:
      break;
  }
  return infer_payload(likelihood, prior, result, config_.inference, random_);
}

template <typename Scalar, int Dofs, typename Network>
auto PublishedPipeline<Scalar, Dofs, Network>::compensation(const Jacobian<Scalar, Dofs>& jacobian,
                                                            const Matrix3<Scalar>& rotation) const noexcept -> Torque {
  if (!plausible(jacobian) || !plausible(rotation)) {
    if (window_.empty()) return Torque::Zero();
    const Proprioception<Scalar, Dofs>& last = window_.newest();
    return compensation(last.jacobian, last.rotation);
  }
  return compensation_torque<Scalar>(state_.posterior.payload(), jacobian, rotation, config_.gravity);
}

}  // namespace rme
