#pragma once
/// The filter over the payload, for all kinds of torque sensing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/hypothesis.hpp>
#include <rme/tracking/hypothesis_bank.hpp>
#include <rme/tracking/payload_belief.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

/// The estimate after a block.
template <typename Scalar>
struct TrackerBelief {
  PerHypothesis<Scalar> probability;        ///< of each hypothesis, sum 1
  InertialGaussian<Scalar> payload;         ///< of phi, given that the hand is not empty
  std::array<Scalar, kSensings> sensing{};  ///< probability of each kind of torque sensing, sum 1
  /// Normalised innovation squared, averaged over a second (docs/theory.md (T30)): 1 if the torque is as the model
  /// predicts it, at most 100.
  Scalar health = Scalar(1);
};

/// Runs a HypothesisBank for each kind of torque sensing, and averages their estimates by the probabilities of the
/// kinds (docs/theory.md, "The tracker"). The kind is a property of the arm: its probabilities follow from how well
/// each bank predicts the torque while the arm moves, and are remembered from event to event.
///
/// Real time: nothing allocates. The work for a block is divided into kSteps calls of advance(), one filter each.
template <typename Scalar, int Dofs>
class Tracker {
 public:
  /// @param arm            sizes of noise, offset, residual and friction before the first sample
  /// @param payload        what may be picked up
  /// @param rated_payload  [kg], > 0
  /// @param known          kind of torque sensing, if the host knows it; otherwise it is found out while the arm moves
  Tracker(const ArmPrior<Scalar, Dofs>& arm, const PayloadPrior<Scalar>& payload, Scalar rated_payload,
          std::optional<Sensing> known) noexcept
      : payload_(payload),
        rated_(rated_payload),
        banks_{HypothesisBank<Scalar, Dofs>(Sensing::LinkSide, arm, payload, rated_payload),
               HypothesisBank<Scalar, Dofs>(Sensing::JointFriction, arm, payload, rated_payload),
               HypothesisBank<Scalar, Dofs>(Sensing::RoughModel, arm, payload, rated_payload)} {
    if (known) {
      evidence_.fill(-kDecided);
      evidence_[static_cast<std::size_t>(*known)] = 0;
    }
    belief_.probability[Hypothesis::Empty] = Scalar(1);
    belief_.sensing = sensing();
  }

  /// Number of advance() calls for one block.
  static constexpr int kSteps = static_cast<int>(kSensings * kHypotheses) + 1;

  /// Starts to process a block. If the last block is not finished, it is finished first.
  /// @param block            the next block
  /// @param exchange_likely  whether the host says that the payload changes now
  void begin(const TorqueBlock<Scalar, Dofs>& block, bool exchange_likely) noexcept {
    settle();
    regime_.update(block);
    duration_ = block.duration;
    speed_ = block.velocity.norm();
    last_axis_ = detail::transposed_product(block.rotation, Vector3<Scalar>(block.jacobian.col(Dofs - 1).tail(3)));
    BlockContext<Scalar> context;
    context.exchange_likely = exchange_likely;
    context.friction_shows = belief_.sensing[static_cast<std::size_t>(Sensing::LinkSide)] < Scalar(kCertain);
    const InertialVector<Scalar> carried =
        detail::scaled(Scalar(1) - belief_.probability[Hypothesis::Empty], belief_.payload.mean);
    context.compensation_change = detail::difference(carried, carried_);
    carried_ = carried;
    for (std::size_t k = 0; k < kSensings; ++k) {
      context.kind_likely = belief_.sensing[k] > Scalar(kUnlikely);
      banks_[k].begin(block, regime_, context);
    }
    step_ = kSteps;
  }
  /// Does one step of the work for the block; nothing if there is none to do.
  /// @return whether it was the last step: belief() has then been updated
  bool advance() noexcept {
    if (step_ == 0) return false;
    --step_;
    if (step_ == 0) {
      finish();
      return true;
    }
    const int done = kSteps - 1 - step_;
    banks_[static_cast<std::size_t>(done / static_cast<int>(kHypotheses))].evaluate(
        static_cast<std::size_t>(done % static_cast<int>(kHypotheses)));
    return false;
  }
  bool busy() const noexcept { return step_ > 0; }  ///< whether a block is not finished

  /// The estimate after the last finished block.
  const TrackerBelief<Scalar>& belief() const noexcept { return belief_; }
  /// The bank of the likeliest kind of torque sensing.
  const HypothesisBank<Scalar, Dofs>& bank() const noexcept {
    return banks_[static_cast<std::size_t>(std::max_element(evidence_.begin(), evidence_.end()) - evidence_.begin())];
  }

  /// The host says that the hand is empty. If the next blocks contradict this, the estimate follows them.
  void declare_empty() noexcept {
    settle();
    for (auto& bank : banks_) {
      bank.reopen_offsets();
      bank.believe(Hypothesis::Empty, Scalar(kHostIsRight));
    }
    summarise();
  }
  /// The host says what the hand holds. The moments of (m, m r) follow from the payload's; the inertia has its prior
  /// for this mass. If the next blocks contradict this, the estimate follows them.
  /// @param payload  mass [kg], >= 0, and centre of mass [m]; finite, covariance positive semidefinite
  void set_payload(const PayloadGaussian<Scalar>& payload) noexcept {
    settle();
    const Scalar mass = payload.mean[0], variance = payload.covariance(0, 0);
    const Vector4<Scalar>& theta = payload.mean;
    const Matrix4<Scalar>& V = payload.covariance;
    InertialVector<Scalar> mean = InertialVector<Scalar>::Zero();
    mean[0] = mass;
    InertialMatrix<Scalar> P =
        detail::outer_square(payload_.factor(std::max(mass * mass + variance, Scalar(1e-6) * rated_ * rated_)));
    P(0, 0) = variance;
    for (int i = 1; i < 4; ++i) {
      mean[i] = mass * theta[i] + V(i, 0);
      P(i, 0) = P(0, i) = theta[i] * variance + mass * V(i, 0);
      for (int j = 1; j < 4; ++j)
        P(i, j) = theta[i] * theta[j] * variance + mass * (V(i, 0) * theta[j] + theta[i] * V(j, 0)) +
                  (mass * mass + variance) * V(i, j);
    }
    InertialMatrix<Scalar> factor;
    if (!StarGaussian<Scalar, Dofs>::factorise(P, factor)) return;
    for (std::size_t k = 0; k < kSensings; ++k) {
      banks_[k].reopen_offsets();
      banks_[k].set_payload(mean, detail::scaled(Scalar(1) / spread(k), factor));
      banks_[k].believe(Hypothesis::Steady, Scalar(kHostIsRight));
    }
    summarise();
  }

 private:
  static constexpr double kHostIsRight = 0.999;  // probability of what the host says
  // Log probability of each kind of sensing before the first sample, up to a constant [nats]. It is worse to take
  // friction for weight than to look for friction in vain. A rough model explains nearly anything, so it has to predict
  // much better than the others.
  static constexpr std::array<double, kSensings> kEvidence = {-8, 0, -40};
  // The residual of a rough model is the same again wherever the arm comes back to, but its filters treat it as new. So
  // they are too certain: the reported standard deviations are 1.7 times theirs (docs/theory.md, "Friction").
  static constexpr double kRoughSpread = 1.7;
  static constexpr double kAcross = 0.15;  // share of a link's error that counts across the last joint's axis (T28)
  // Largest difference between the log probabilities of two kinds [nats]: small enough that an arm which was changed,
  // for example at a service, is recognised after some seconds of motion.
  static constexpr double kDecided = 300;
  static constexpr double kUnlikely = 1e-3;  // probability of a kind below which its bank omits more hypotheses
  static constexpr double kCertain = 1e-6;   // probability of link-side sensing below which friction is certain to show
  static constexpr double kLargestHealth = 100;
  static constexpr double kPushed = 0.9;     // share of a block's weight that is lost while a push is likely
  static constexpr double kFullSpeed = 0.2;  // norm of dq from which a block has its full weight [rad/s]

  static constexpr Scalar spread(std::size_t kind) noexcept {
    return static_cast<Scalar>(kind == static_cast<std::size_t>(Sensing::RoughModel) ? kRoughSpread : 1);
  }

  void settle() noexcept {
    while (step_ > 0) advance();
  }

  void finish() noexcept {
    using std::exp;
    // A possible push shows little of the kind of sensing: another kind can explain it by errors of its model.
    const auto pushed = static_cast<double>(belief_.probability[Hypothesis::Pushed]);
    const double weight = std::min(1.0, static_cast<double>(speed_) / kFullSpeed) * (1 - kPushed * pushed);
    for (std::size_t k = 0; k < kSensings; ++k) evidence_[k] += weight * static_cast<double>(banks_[k].finish());
    const double best = *std::max_element(evidence_.begin(), evidence_.end());
    for (double& evidence : evidence_) evidence = std::max(-kDecided, evidence - best);
    const auto squared = std::min(Scalar(kLargestHealth), bank().innovation_squared());
    belief_.health += (Scalar(1) - exp(-duration_)) * (squared - belief_.health);
    summarise();
  }

  std::array<Scalar, kSensings> sensing() const noexcept {
    using std::exp;
    const double best = *std::max_element(evidence_.begin(), evidence_.end());
    std::array<Scalar, kSensings> out;
    double sum = 0;
    for (const double evidence : evidence_) sum += exp(evidence - best);
    for (std::size_t k = 0; k < kSensings; ++k) out[k] = static_cast<Scalar>(exp(evidence_[k] - best) / sum);
    return out;
  }

  void summarise() noexcept {
    const std::array<Scalar, kSensings> share = sensing();
    TrackerBelief<Scalar> out;
    out.health = belief_.health;
    out.sensing = share;
    InertialVector<Scalar> mean = InertialVector<Scalar>::Zero();
    Scalar held = Scalar(0);
    for (std::size_t k = 0; k < kSensings; ++k) {
      for (std::size_t i = 0; i < kHypotheses; ++i) {
        const auto h = static_cast<Hypothesis>(i);
        const Scalar w = share[k] * banks_[k].probability(h);
        out.probability[h] += w;
        if (h == Hypothesis::Empty) continue;
        held += w;
        detail::add_scaled(mean, w, banks_[k].star(h).mean());
      }
    }
    if (held > 0) mean /= held;
    out.payload.mean = mean;
    for (std::size_t k = 0; k < kSensings && held > 0; ++k) {
      for (std::size_t i = 0; i < kHypotheses; ++i) {
        const auto h = static_cast<Hypothesis>(i);
        const Scalar w = share[k] * banks_[k].probability(h) / held;
        if (h == Hypothesis::Empty || !(w > Scalar(1e-6))) continue;
        const InertialVector<Scalar> d = detail::difference(banks_[k].star(h).mean(), mean);
        detail::add_scaled(out.payload.covariance, w * spread(k) * spread(k), banks_[k].star(h).covariance());
        detail::add_outer(out.payload.covariance, detail::scaled(w, d), d);
      }
    }
    if (held > 0) add_model_error(share, out.payload.covariance);
    out.payload = within_rated(out.payload, rated_);
    if (!detail::finite(out.payload.mean) || !detail::finite(out.payload.covariance)) out.payload = belief_.payload;
    belief_ = out;
  }

  /// Adds the error of the arm's model that cannot be distinguished from the payload (docs/theory.md (T28)): the error
  /// of the first moment of the link that carries the payload. The link before it differs only by the turn of the last
  /// joint, so its error along that joint's axis has the same effect.
  void add_model_error(const std::array<Scalar, kSensings>& share, InertialMatrix<Scalar>& covariance) const noexcept {
    Scalar variance = Scalar(0);
    for (std::size_t k = 0; k < kSensings; ++k) variance += share[k] * banks_[k].noise().first_moment_variance();
    for (int i = 0; i < 3; ++i) {
      covariance(1 + i, 1 + i) += Scalar(kAcross * kAcross) * variance;
      for (int j = 0; j < 3; ++j) covariance(1 + i, 1 + j) += variance * last_axis_[i] * last_axis_[j];
    }
  }

  PayloadPrior<Scalar> payload_;
  Scalar rated_;
  FrictionRegime<Scalar, Dofs> regime_;
  std::array<HypothesisBank<Scalar, Dofs>, kSensings> banks_;
  std::array<double, kSensings> evidence_ = kEvidence;  // log probability, up to a constant [nats]
  int step_ = 0;                                        // steps left for this block
  Scalar duration_ = Scalar(0), speed_ = Scalar(0);
  TrackerBelief<Scalar> belief_;
  Vector3<Scalar> last_axis_ = Vector3<Scalar>::Zero();              // axis of the last joint, in end-effector axes
  InertialVector<Scalar> carried_ = InertialVector<Scalar>::Zero();  // (1 - P(Empty)) phi at the last begin()
};

}  // namespace rme
