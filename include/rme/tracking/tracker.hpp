#pragma once
/// The filter over the payload, for all kinds of torque sensing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <optional>
#include <rme/core/singular_cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/histories.hpp>
#include <rme/tracking/mode.hpp>
#include <rme/tracking/payload_belief.hpp>
#include <rme/tracking/torque_block.hpp>
#include <rme/tracking/transitions.hpp>

namespace rme {

/// The estimate after a block.
template <typename Scalar>
struct TrackerBelief {
  PerMode<Scalar> probability;       ///< of each mode, sum 1
  Scalar empty = Scalar(1);          ///< probability that the hand holds nothing, disturbed or not
  InertialGaussian<Scalar> payload;  ///< of phi, given that something is held
  /// Mean of what the robot's own model lacks at the last link: (m, m r) [kg, kg m], end-effector axes.
  Vector4<Scalar> tool = Vector4<Scalar>::Zero();
  Scalar undecided = Scalar(0);  ///< share of the payload that may be no weight (Undecided), if something is held
  std::array<Scalar, kSensings> sensing{};  ///< probability of each kind of torque sensing, sum 1
  /// Normalised innovation squared, averaged over a second (docs/theory.md (T30)): 1 if the torque is as the model
  /// predicts it, at most 100.
  Scalar health = Scalar(1);
  Scalar swinging = Scalar(0);         ///< probability that what is held swings
  Scalar swing_frequency = Scalar(0);  ///< of the likeliest story in which it does; 0 if unknown [Hz]
  Scalar swing_begins = Scalar(0);     ///< probability of a swing that has not gone to both sides yet
  Vector3<Scalar> swing_square = Vector3<Scalar>::Zero();  ///< mean square of the swing's force [N^2], world axes
};

/// Runs Histories for each kind of torque sensing, and averages their estimates by the probabilities of the kinds
/// (docs/theory.md, "The tracker"). The kind is a property of the arm: its probabilities follow from how well the
/// stories of each kind predict the torque while the arm moves, and are remembered from event to event.
///
/// Real time: nothing allocates. The work for a block is divided into calls of advance(), one child of a story each.
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
        kinds_{Histories<Scalar, Dofs>(kind_of(Sensing::LinkSide), arm, payload, rated_payload, gravity),
               Histories<Scalar, Dofs>(kind_of(Sensing::JointFriction), arm, payload, rated_payload, gravity),
               Histories<Scalar, Dofs>(kind_of(Sensing::RoughModel), arm, payload, rated_payload, gravity)} {
    for (std::size_t k = 0; k < kSensings; ++k)
      evidence_[k] = !known ? kSensingKinds[k].evidence : k == static_cast<std::size_t>(*known) ? 0 : -kDecided;
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
    BlockContext<Scalar, Dofs> context;
    context.exchange_likely = exchange_likely;
    context.friction_shows = belief_.sensing[static_cast<std::size_t>(Sensing::LinkSide)] < Scalar(kCertain);
    JointVector<Scalar, Dofs> carried;
    if (block.carried)
      carried = *block.carried;
    else
      carried = detail::product(block.regressor, detail::scaled(Scalar(-1), carried_body()));
    if (carries_) context.compensation_change = detail::difference(carried, carried_);
    carries_ = true;
    carried_ = carried;
    for (std::size_t k = 0; k < kSensings; ++k) {
      context.log_share = static_cast<Scalar>(evidence_[k]);
      kinds_[k].begin(block, regime_, context, children_);
    }
    kind_ = 0;
    busy_ = true;
  }
  /// Does one step of the work for the block; nothing if there is none to do.
  /// @return whether it was the last step: belief() has then been updated
  bool advance() noexcept {
    if (!busy_) return false;
    if (kinds_[kind_].advance(children_)) ++kind_;
    if (kind_ < kSensings) return false;
    busy_ = false;
    finish();
    return true;
  }
  bool busy() const noexcept { return busy_; }  ///< whether a block is not finished

  /// The estimate after the last finished block.
  const TrackerBelief<Scalar>& belief() const noexcept { return belief_; }
  /// The stories of the likeliest kind of torque sensing.
  const Histories<Scalar, Dofs>& histories() const noexcept {
    return kinds_[static_cast<std::size_t>(std::max_element(evidence_.begin(), evidence_.end()) - evidence_.begin())];
  }
  const Histories<Scalar, Dofs>& histories(Sensing kind) const noexcept {  ///< the stories of one kind
    return kinds_[static_cast<std::size_t>(kind)];
  }

  /// The host says that the hand is empty. If the next blocks contradict this, the estimate follows them.
  void declare_empty() noexcept {
    settle();
    for (auto& kind : kinds_) {
      kind.reopen_offsets();
      kind.believe_empty(Scalar(kHostIsRight));
    }
    summarise();
  }
  /// The host says that what the hand holds now belongs to the tool.
  void tare() noexcept {
    settle();
    const Scalar mass = Scalar(kTareMass) * rated_, moment = Scalar(kTareArm) * mass;
    Eigen::Matrix<Scalar, kArmShared, 1> variance = Eigen::Matrix<Scalar, kArmShared, 1>::Zero();
    variance[kTool] = mass * mass;
    for (int i = 1; i < 4; ++i) variance[kTool + i] = moment * moment;
    for (auto& kind : kinds_) {
      kind.reopen_offsets();
      kind.tare(variance);
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
    const SingularCholesky<Scalar, kInertial> factor(P);
    if (!factor.finite()) return;
    for (auto& kind : kinds_) {
      kind.reopen_offsets();
      const Scalar spread = static_cast<Scalar>(kind.model().kind().spread);
      kind.believe_held(mean, detail::scaled(1 / spread, factor.lower()), Scalar(kHostIsRight));
    }
    summarise();
  }

 private:
  static constexpr double kHostIsRight = 0.999;              // probability of what the host says
  static constexpr double kTareMass = 0.3, kTareArm = 0.15;  // spread of a tool after tare(), per rated payload; [m]
  static constexpr double kAcross = 0.15;  // share of a link's error that counts across the last joint's axis (T28)
  // Largest difference between the log probabilities of two kinds [nats]: small enough that an arm which was changed,
  // for example at a service, is recognised after some seconds of motion.
  static constexpr double kDecided = 300;
  static constexpr double kUnlikely = 1e-5;  // probability below which a kind computes less
  static constexpr double kCertain = 1e-6;   // probability of link-side sensing below which friction is certain to show
  static constexpr double kLargestHealth = 100;
  static constexpr double kDisturbed = 0.9;  // share of a block's weight that is lost while something disturbs
  static constexpr double kFullSpeed = 0.2;  // norm of dq from which a block has its full weight [rad/s]

  /// What the host carries, as far as the tracker knows: the payload, and what the robot's own model lacks.
  InertialVector<Scalar> carried_body() const noexcept {
    const Scalar share = (Scalar(1) - belief_.empty) * Undecided<Scalar>::carried(belief_.undecided);
    InertialVector<Scalar> phi = detail::scaled(share, belief_.payload.mean);
    for (int i = 0; i < 4; ++i) phi[i] += belief_.tool[i];
    return phi;
  }
  void settle() noexcept {
    while (busy_) advance();
  }

  void finish() noexcept {
    using std::exp;
    // A disturbance or a pour shows little of the kind of sensing: another kind can explain it by errors of its model.
    Scalar hidden = Scalar(0);
    for (std::size_t k = 0; k < kSensings; ++k)
      if (belief_.sensing[k] > Scalar(kUnlikely)) hidden = std::max(hidden, kinds_[k].disturbed());
    const double weight =
        std::min(1.0, static_cast<double>(speed_) / kFullSpeed) * (1 - kDisturbed * static_cast<double>(hidden));
    for (std::size_t k = 0; k < kSensings; ++k) evidence_[k] += weight * static_cast<double>(kinds_[k].evidence());
    const double best = *std::max_element(evidence_.begin(), evidence_.end());
    for (double& evidence : evidence_) evidence = std::max(-kDecided, evidence - best);
    const auto squared = std::min(Scalar(kLargestHealth), histories().innovation_squared());
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

  /// Calls use(histories, i, weight) for each story i of each kind that matters.
  template <typename Use>
  void each(const std::array<Scalar, kSensings>& share, const Use& use) const noexcept {
    for (std::size_t k = 0; k < kSensings; ++k) {
      if (!(share[k] > Scalar(kNegligible))) continue;
      for (int i = 0; i < kinds_[k].count(); ++i) {
        const Scalar weight = share[k] * kinds_[k].weight(i);
        if (weight > Scalar(kNegligible)) use(kinds_[k], i, weight);
      }
    }
  }

  void summarise() noexcept {
    using Kind = Histories<Scalar, Dofs>;
    const std::array<Scalar, kSensings> share = sensing();
    TrackerBelief<Scalar> out;
    out.health = belief_.health;
    out.sensing = share;
    InertialVector<Scalar> mean = InertialVector<Scalar>::Zero();
    InertialMatrix<Scalar> square = InertialMatrix<Scalar>::Zero();  // about the last mean, which is near
    const InertialVector<Scalar> near = belief_.payload.mean;
    Scalar held = Scalar(0), undecided = Scalar(0), all = Scalar(0), heaviest = Scalar(0);
    each(share, [&](const Kind& kind, int i, Scalar w) {
      const Story<Scalar, Dofs>& story = kind.story(i);
      out.probability[story.mode] += w;
      all += w;
      detail::add_scaled(out.tool, w, story.tool_mean());
      if (!kind.holds(i)) return;
      held += w;
      if (story.star.swings()) {
        out.swinging += w;
        if (!story.swing.shown()) out.swing_begins += w;
        detail::add_scaled(out.swing_square, w, story.swing.square());
        if (w > heaviest) out.swing_frequency = story.swing.frequency();
        heaviest = std::max(heaviest, w);
      }
      InertialGaussian<Scalar> payload = kind.payload(i);
      undecided += w * story.undecided.of(payload.mean[0]);
      const auto spread = static_cast<Scalar>(kind.model().kind().spread);
      const auto gain = static_cast<Scalar>(kind.model().kind().gain);
      payload.covariance *= spread * spread;
      // What the gains of all joints have in common cannot be told from the mass.
      const Scalar off = story.star.gains_off() ? Scalar(Transitions::kOffGain) : Scalar(0);
      const Scalar scale = gain * gain + off * off / Scalar(Dofs);
      detail::add_outer(payload.covariance, detail::scaled(scale, payload.mean), payload.mean);
      const InertialVector<Scalar> d = detail::difference(payload.mean, near);
      detail::add_scaled(mean, w, d);
      detail::add_scaled(square, w, payload.covariance);
      detail::add_outer(square, detail::scaled(w, d), d);
    });
    for (Scalar& p : out.probability.values) p /= all;
    out.tool /= all;
    out.swinging /= all;
    out.swing_begins /= all;
    out.swing_square /= all;
    out.empty = std::max(Scalar(0), (all - held) / all);
    if (held > 0) {
      mean /= held;
      square /= held;
      detail::add_outer(square, detail::scaled(Scalar(-1), mean), mean);
      mean += near;
      if (mean[0] > 0) out.undecided = std::min(Scalar(1), undecided / (held * mean[0]));
      out.payload = {mean, square};
      add_model_error(share, out.payload.covariance);
    }
    out.payload = within_rated(out.payload, rated_);
    for (int i = 0; i < kInertial; ++i) {  // rounding must not leave a variance below zero
      Scalar& variance = out.payload.covariance(i, i);
      variance = std::max(variance, Scalar(0));
    }
    if (!detail::finite(out.payload.mean) || !detail::finite(out.payload.covariance)) out.payload = belief_.payload;
    belief_ = out;
  }

  /// Adds the error of the arm's model that cannot be distinguished from the payload (docs/theory.md (T28)): the error
  /// of the first moment of the link that carries the payload. The link before it differs only by the turn of the last
  /// joint, so its error along that joint's axis has the same effect.
  void add_model_error(const std::array<Scalar, kSensings>& share, InertialMatrix<Scalar>& covariance) const noexcept {
    Scalar variance = Scalar(0);
    for (std::size_t k = 0; k < kSensings; ++k)
      variance += share[k] * kinds_[k].model().noise().first_moment_variance();
    for (int i = 0; i < 3; ++i) {
      covariance(1 + i, 1 + i) += Scalar(kAcross * kAcross) * variance;
      for (int j = 0; j < 3; ++j) covariance(1 + i, 1 + j) += variance * last_axis_[i] * last_axis_[j];
    }
  }

  static constexpr double kNegligible = 1e-6;  // weight below which a story does not count in what is reported

  PayloadPrior<Scalar> payload_;
  Scalar rated_;
  FrictionRegime<Scalar, Dofs> regime_;
  std::array<Histories<Scalar, Dofs>, kSensings> kinds_;
  typename Histories<Scalar, Dofs>::Children children_;  // of the kind whose turn it is
  std::array<double, kSensings> evidence_{};             // log probability, up to a constant [nats]
  std::size_t kind_ = 0;                                 // whose stories are computed next
  bool busy_ = false;
  Scalar duration_ = Scalar(0), speed_ = Scalar(0);
  TrackerBelief<Scalar> belief_;
  Vector3<Scalar> last_axis_ = Vector3<Scalar>::Zero();  // axis of the last joint, in end-effector axes
  JointVector<Scalar, Dofs> carried_ = JointVector<Scalar, Dofs>::Zero();  // compensation in the last block [N m]
  bool carries_ = false;                                                   // there was a last block
};

}  // namespace rme
