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
#include <rme/tracking/bank/hypothesis_bank.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/histories.hpp>
#include <rme/tracking/mode.hpp>
#include <rme/tracking/payload_belief.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

/// The estimate after a block.
template <typename Scalar>
struct TrackerBelief {
  PerMode<Scalar> probability;              ///< of each mode, sum 1
  Scalar empty = Scalar(1);                 ///< probability that the hand holds nothing
  InertialGaussian<Scalar> payload;         ///< of phi, given that the hand is not empty
  std::array<Scalar, kSensings> sensing{};  ///< probability of each kind of torque sensing, sum 1
  /// Normalised innovation squared, averaged over a second (docs/theory.md (T30)): 1 if the torque is as the model
  /// predicts it, at most 100.
  Scalar health = Scalar(1);
};

/// Runs a filter for each kind of torque sensing, and averages their estimates by the probabilities of the kinds
/// (docs/theory.md, "The tracker"): a HypothesisBank where the arm's model is good, Histories where it is rough and a
/// decision has to wait for seconds. The kind is a property of the arm: its probabilities follow from how well each
/// filter predicts the torque while the arm moves, and are remembered from event to event.
///
/// Real time: nothing allocates. The work for a block is divided into calls of advance(), one filter each.
template <typename Scalar, int Dofs>
class Tracker {
 public:
  /// @param arm            sizes of noise, offset, residual and friction before the first sample
  /// @param payload        what may be picked up
  /// @param rated_payload  [kg], > 0
  /// @param known          kind of torque sensing, if the host knows it; otherwise it is found out while the arm moves
  /// @param gravity        g [m/s^2], world axes
  Tracker(const ArmPrior<Scalar, Dofs>& arm, const PayloadPrior<Scalar>& payload, Scalar rated_payload,
          std::optional<Sensing> known, const Vector3<Scalar>& gravity) noexcept
      : payload_(payload),
        rated_(rated_payload),
        banks_{Bank(Sensing::LinkSide, arm, payload, rated_payload),
               Bank(Sensing::JointFriction, arm, payload, rated_payload)},
        rough_(kind_of(Sensing::RoughModel), arm, payload, rated_payload, gravity) {
    if (known) {
      evidence_.fill(-kDecided);
      evidence_[static_cast<std::size_t>(*known)] = 0;
    }
    belief_.probability[Mode::Empty] = Scalar(1);
    belief_.sensing = sensing();
  }

  /// Starts to process a block. If the last block is not finished, it is finished first.
  /// @param block            the next block
  /// @param exchange_likely  whether the host says that the payload changes now
  void begin(const TorqueBlock<Scalar, Dofs>& block, bool exchange_likely) noexcept {
    settle();
    regime_.update(block);
    duration_ = block.duration;
    speed_ = block.velocity.norm();
    last_axis_ = detail::transposed_product(block.rotation, Vector3<Scalar>(block.jacobian.col(Dofs - 1).tail(3)));
    bank::BlockContext<Scalar> context;
    context.exchange_likely = exchange_likely;
    context.friction_shows = belief_.sensing[static_cast<std::size_t>(Sensing::LinkSide)] < Scalar(kCertain);
    const InertialVector<Scalar> carried = detail::scaled(Scalar(1) - belief_.empty, belief_.payload.mean);
    context.compensation_change = detail::difference(carried, carried_);
    carried_ = carried;
    for (std::size_t k = 0; k < kBanks; ++k) {
      context.kind_likely = belief_.sensing[k] > Scalar(kUnlikely);
      banks_[k].begin(block, regime_, context);
    }
    BlockContext<Scalar, Dofs> rough;
    rough.exchange_likely = exchange_likely;
    rough.log_share = static_cast<Scalar>(evidence_[kBanks]);
    rough.friction_shows = context.friction_shows;
    rough.compensation_change =
        detail::product(block.regressor, detail::scaled(Scalar(-1), context.compensation_change));
    rough_.begin(block, regime_, rough, children_);
    step_ = 0;
    busy_ = true;
  }
  /// Does one step of the work for the block; nothing if there is none to do.
  /// @return whether it was the last step: belief() has then been updated
  bool advance() noexcept {
    if (!busy_) return false;
    if (step_ < kBanks * bank::kHypotheses) {
      banks_[step_ / bank::kHypotheses].evaluate(step_ % bank::kHypotheses);
      ++step_;
      return false;
    }
    if (!rough_.advance(children_)) return false;
    busy_ = false;
    finish();
    return true;
  }
  bool busy() const noexcept { return busy_; }  ///< whether a block is not finished

  /// The estimate after the last finished block.
  const TrackerBelief<Scalar>& belief() const noexcept { return belief_; }
  const Histories<Scalar, Dofs>& histories() const noexcept { return rough_; }  ///< the stories of a rough model

  /// The host says that the hand is empty. If the next blocks contradict this, the estimate follows them.
  void declare_empty() noexcept {
    settle();
    for (auto& bank : banks_) {
      bank.reopen_offsets();
      bank.believe(bank::Hypothesis::Empty, Scalar(kHostIsRight));
    }
    rough_.reopen_offsets();
    rough_.believe_empty(Scalar(kHostIsRight));
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
    if (!bank::StarGaussian<Scalar, Dofs>::factorise(P, factor)) return;
    for (auto& bank : banks_) {
      bank.reopen_offsets();
      bank.set_payload(mean, factor);
      bank.believe(bank::Hypothesis::Steady, Scalar(kHostIsRight));
    }
    rough_.reopen_offsets();
    rough_.believe_held(mean, detail::scaled(Scalar(1 / kRough.spread), factor), Scalar(kHostIsRight));
    summarise();
  }

 private:
  using Bank = bank::HypothesisBank<Scalar, Dofs>;
  static constexpr std::size_t kBanks = 2;       // kinds with a bank: those before RoughModel
  static constexpr double kHostIsRight = 0.999;  // probability of what the host says
  // Log probability of each kind of sensing before the first sample, up to a constant [nats]. It is worse to take
  // friction for weight than to look for friction in vain. A rough model explains nearly anything, so it has to predict
  // much better than the others.
  static constexpr std::array<double, kSensings> kEvidence = {-8, 0, -40};
  // The residual of a rough model is the same again wherever the arm comes back to, but its filters treat it as new. So
  // they are too certain: the reported standard deviations are `spread` times theirs (docs/theory.md, "Friction").
  static constexpr SensingKind kRough = kind_of(Sensing::RoughModel);
  static constexpr double kAcross = 0.15;  // share of a link's error that counts across the last joint's axis (T28)
  // Largest difference between the log probabilities of two kinds [nats]: small enough that an arm which was changed,
  // for example at a service, is recognised after some seconds of motion.
  static constexpr double kDecided = 300;
  static constexpr double kUnlikely = 1e-3;  // probability of a kind below which less is computed for it
  static constexpr double kCertain = 1e-6;   // probability of link-side sensing below which friction is certain to show
  static constexpr double kNegligible = 1e-6;  // weight below which a part of the mixture does not count
  static constexpr double kLargestHealth = 100;
  static constexpr double kPushed = 0.9;     // share of a block's weight that is lost while a push is likely
  static constexpr double kFullSpeed = 0.2;  // norm of dq from which a block has its full weight [rad/s]

  void settle() noexcept {
    while (busy_) advance();
  }

  void finish() noexcept {
    using std::exp;
    // A possible push shows little of the kind of sensing: another kind can explain it by errors of its model.
    const auto pushed = static_cast<double>(belief_.probability[Mode::Disturbed]);
    const double weight = std::min(1.0, static_cast<double>(speed_) / kFullSpeed) * (1 - kPushed * pushed);
    for (std::size_t k = 0; k < kBanks; ++k) evidence_[k] += weight * static_cast<double>(banks_[k].finish());
    evidence_[kBanks] += weight * static_cast<double>(rough_.evidence());
    const double best = *std::max_element(evidence_.begin(), evidence_.end());
    for (double& evidence : evidence_) evidence = std::max(-kDecided, evidence - best);
    const auto squared = std::min(Scalar(kLargestHealth), likeliest_innovation());
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

  /// e^T S^-1 e per joint of the likeliest kind.
  Scalar likeliest_innovation() const noexcept {
    const auto best = std::max_element(evidence_.begin(), evidence_.end()) - evidence_.begin();
    const auto k = static_cast<std::size_t>(best);
    return k < kBanks ? banks_[k].innovation_squared() : rough_.innovation_squared();
  }
  /// The mode that a hypothesis of a bank stands for.
  static constexpr Mode mode_of(bank::Hypothesis h) noexcept {
    switch (h) {
      case bank::Hypothesis::Empty:
        return Mode::Empty;
      case bank::Hypothesis::Steady:
        return Mode::Held;
      case bank::Hypothesis::Filling:
        return Mode::Pouring;
      case bank::Hypothesis::Exchanged:
        return Mode::Changing;
      case bank::Hypothesis::Pushed:
        return Mode::Disturbed;
    }
    return Mode::Empty;
  }
  /// Calls use(mode, weight, something held, mean of phi, covariance of phi) for all that may be the case. The last
  /// two are functions, since the first pass does not need a covariance.
  template <typename Use>
  void each(const std::array<Scalar, kSensings>& share, const Use& use) const noexcept {
    for (std::size_t k = 0; k < kBanks; ++k) {
      for (std::size_t i = 0; i < bank::kHypotheses; ++i) {
        const auto h = static_cast<bank::Hypothesis>(i);
        const auto& star = banks_[k].star(h);
        use(
            mode_of(h), share[k] * banks_[k].probability(h), h != bank::Hypothesis::Empty, [&] { return star.mean(); },
            [&] { return star.covariance(); });
      }
    }
    if (!(share[kBanks] > Scalar(kNegligible))) return;
    for (int i = 0; i < rough_.count(); ++i) {
      use(
          rough_.story(i).mode, share[kBanks] * rough_.weight(i), rough_.holds(i),
          [&] { return rough_.payload(i).mean; },
          [&] {
            const InertialGaussian<Scalar> payload = rough_.payload(i);
            InertialMatrix<Scalar> P = detail::scaled(Scalar(kRough.spread * kRough.spread), payload.covariance);
            detail::add_outer(P, detail::scaled(Scalar(kRough.gain * kRough.gain), payload.mean), payload.mean);
            return P;
          });
    }
  }

  void summarise() noexcept {
    const std::array<Scalar, kSensings> share = sensing();
    TrackerBelief<Scalar> out;
    out.health = belief_.health;
    out.sensing = share;
    InertialVector<Scalar> mean = InertialVector<Scalar>::Zero();
    Scalar held = Scalar(0);
    each(share, [&](Mode mode, Scalar w, bool holds, const auto& phi, const auto&) {
      out.probability[mode] += w;
      if (!holds) return;
      held += w;
      detail::add_scaled(mean, w, phi());
    });
    out.empty = std::max(Scalar(0), Scalar(1) - held);
    if (held > 0) mean /= held;
    out.payload.mean = mean;
    each(share, [&](Mode, Scalar w, bool holds, const auto& phi, const auto& covariance) {
      if (!holds || !(w > Scalar(kNegligible) * held)) return;
      const InertialVector<Scalar> d = detail::difference(phi(), mean);
      detail::add_scaled(out.payload.covariance, w / held, covariance());
      detail::add_outer(out.payload.covariance, detail::scaled(w / held, d), d);
    });
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
    for (std::size_t k = 0; k < kBanks; ++k) variance += share[k] * banks_[k].noise().first_moment_variance();
    for (int i = 0; i < 3; ++i) {
      covariance(1 + i, 1 + i) += Scalar(kAcross * kAcross) * variance;
      for (int j = 0; j < 3; ++j) covariance(1 + i, 1 + j) += variance * last_axis_[i] * last_axis_[j];
    }
  }

  PayloadPrior<Scalar> payload_;
  Scalar rated_;
  FrictionRegime<Scalar, Dofs> regime_;
  std::array<Bank, kBanks> banks_;
  Histories<Scalar, Dofs> rough_;
  typename Histories<Scalar, Dofs>::Children children_;  // of rough_'s stories
  std::array<double, kSensings> evidence_ = kEvidence;   // log probability, up to a constant [nats]
  std::size_t step_ = 0;                                 // steps of the banks done for this block
  bool busy_ = false;
  Scalar duration_ = Scalar(0), speed_ = Scalar(0);
  TrackerBelief<Scalar> belief_;
  Vector3<Scalar> last_axis_ = Vector3<Scalar>::Zero();              // axis of the last joint, in end-effector axes
  InertialVector<Scalar> carried_ = InertialVector<Scalar>::Zero();  // (1 - P(Empty)) phi at the last begin()
};

}  // namespace rme
