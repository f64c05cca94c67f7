#pragma once
/// The interacting-multiple-model filter over the hypotheses, for one kind of torque sensing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/bank/hypothesis.hpp>
#include <rme/tracking/bank/joint_torque_model.hpp>
#include <rme/tracking/bank/pour_monitor.hpp>
#include <rme/tracking/bank/push_filter.hpp>
#include <rme/tracking/bank/star_gaussian.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme::bank {

/// Five filters, one for each hypothesis, and the probabilities of the hypotheses: an interacting-multiple-model filter
/// (Blom and Bar-Shalom, IEEE Trans. Automatic Control 1988; docs/theory.md, "Hypotheses"). For each block, call
/// begin(), then evaluate() for each step from 0 to kHypotheses - 1, then finish(). The calls may be spread over
/// several ticks. The results change only in finish(). A hypothesis that is too improbable is not computed. Real time:
/// no call allocates; evaluate() costs some 3,000 multiplications for 7 joints, twice as many if states have to be
/// mixed.
template <typename Scalar, int Dofs>
class HypothesisBank {
 public:
  using Star = StarGaussian<Scalar, Dofs>;  ///< state of each filter

  /// At first, the hand is probably empty. Parameters as in Tracker; `sensing` is the kind that this bank assumes.
  HypothesisBank(Sensing sensing, const ArmPrior<Scalar, Dofs>& arm, const PayloadPrior<Scalar>& payload,
                 Scalar rated_payload) noexcept;

  /// Starts a block: computes the probabilities before the block is used (docs/theory.md (T19)).
  /// @param block    the next block
  /// @param regime   which joints rest in it
  /// @param context  what else is known of it
  void begin(const TorqueBlock<Scalar, Dofs>& block, const FrictionRegime<Scalar, Dofs>& regime,
             const BlockContext<Scalar>& context) noexcept;
  /// Mixes, predicts and updates the filter of one hypothesis.
  /// @param step  0 .. kHypotheses - 1. Step 0 is the likelier one of Empty and Steady. If it explains the block, most
  ///              of the others are not computed
  void evaluate(std::size_t step) noexcept;
  /// Ends a block: updates the probabilities (docs/theory.md (T21)), and learns noise and residual if nothing happened.
  /// @return log p(block | all blocks before) [nats], up to a constant that all banks share
  Scalar finish() noexcept;

  Scalar probability(Hypothesis h) const noexcept { return probability_[h]; }  ///< after the last block
  /// State of the filter of h after the last block.
  const Star& star(Hypothesis h) const noexcept { return stars_[index(h)]; }
  /// e^T S^-1 e per joint in the last block, of one of Empty, Steady and Filling: the one that was likeliest before the
  /// block. 1 on average if the torque is as the model predicts it (docs/theory.md (T30)).
  Scalar innovation_squared() const noexcept { return innovation_squared_; }
  const SensorNoise<Scalar, Dofs>& noise() const noexcept { return model_.noise(); }  ///< learned noise and residual

  /// The host says that `h` holds: multiplies all probabilities by 1 - probability, and adds `probability` (0 to 1) to
  /// that of h. For Empty, the filter restarts with the nuisances of the likeliest hypothesis.
  void believe(Hypothesis h, Scalar probability) noexcept;
  /// Sets the payload of Steady to N(mean, factor factor^T), with the nuisances of the likeliest hypothesis.
  void set_payload(const InertialVector<Scalar>& mean, const InertialMatrix<Scalar>& factor) noexcept;
  /// Adds the offsets' prior variances to their variances: part of a payload's torque may have been taken for offset.
  void reopen_offsets() noexcept;

 private:
  static constexpr std::size_t index(Hypothesis h) noexcept { return static_cast<std::size_t>(h); }
  static constexpr double kNegligible = 1e-4;  // smallest weight with which a component enters a mixture
  /// If Empty or Steady explains a block, hypotheses with a smaller probability before the block are not computed. The
  /// second bound applies if the arm is unlikely to have this kind of torque sensing.
  static constexpr double kImprobable = 0.002, kImprobableKind = 0.02;
  /// Factor of a rough model's prior probability of an exchange: starts and stops of such an arm look like one.
  static constexpr double kRoughExchange = 0.0125;
  static constexpr double kAge = 0.1 - 1e-6;        // at this age recent_ becomes before_ [s]
  static constexpr double kDoubtful = 0.04 - 1e-6;  // how long a new payload may turn out to be a push [s]
  static constexpr double kSettling = 0.1 - 1e-6;   // from an exchange until the observer's error has decayed [s]
  static constexpr double kSpoilt = 4;              // e^T S^-1 e per joint above which no payload explains a block
  static constexpr double kLate = 10;               // evidence lost once if the torque is late, as on few arms [nats]

  Star& next(Hypothesis h) noexcept { return next_[index(h)]; }
  std::size_t likeliest() const noexcept {
    const auto& p = probability_.values;
    return static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin());
  }
  /// kTransitions, with the change of the pour monitor between Steady and Filling.
  Scalar transition(std::size_t from, std::size_t to) const noexcept;
  const Star& source(std::size_t from, Hypothesis to) const noexcept;
  void take_in(Hypothesis h) noexcept;
  void mix(Hypothesis h) noexcept;
  Scalar update(Star& star) noexcept;
  Scalar push_likelihood(const Star& star) noexcept;
  void evaluate_exchange(Star& star) noexcept;
  InertialMatrix<Scalar> filling(const Star& star) const noexcept;
  /// Log probability that the mass is plausible: neither indistinguishable from zero nor too large for the arm.
  Scalar log_plausible(const Star& star) const noexcept;
  bool settled_explains() const noexcept;
  void follow_exchange(Hypothesis settled) noexcept;
  void follow_pour() noexcept;

  JointTorqueModel<Scalar, Dofs> model_;
  PayloadPrior<Scalar> payload_;
  Scalar rated_;
  PushFilter<Scalar, Dofs> push_;
  PourMonitor<Scalar, Dofs> pour_;
  std::array<Star, kHypotheses> stars_, next_;
  // States after a block in which nothing happened, since then only predicted: 0.1 to 0.2 s old, and younger.
  Star before_, recent_;
  // Age of recent_, and time in which nothing happened, at most 1 s [s]; at first, half of the latter replaces kAge.
  Scalar age_ = Scalar(0), known_ = Scalar(0);
  Scalar since_exchange_ = Scalar(kSettling);  // time since Exchanged was last believed [s]
  Scalar worst_ = Scalar(0);                   // largest innovation_squared_ since then
  PerHypothesis<Scalar> probability_;

  // of the present block
  PerHypothesis<Scalar> predicted_;   // p(h | past)
  PerHypothesis<Scalar> likelihood_;  // log p(block | h)
  PerHypothesis<bool> in_question_;
  PerHypothesis<Scalar> squared_;  // e^T S^-1 e per joint
  PerHypothesis<JointVector<Scalar, Dofs>> innovation_, variance_;
  Scalar goes_on_ = Scalar(0);   // P(the block before was pushed, given that this one is)
  Scalar unloaded_ = Scalar(0);  // weight of all other hypotheses in the last mixture
  bool exchange_likely_ = false;
  bool exchange_anew_ = false;  // the exchange is estimated again with this block
  bool late_ = false;           // the last block has shown that the torque is late
  bool paid_ = false;           // kLate has been lost
  bool kind_likely_ = true;     // the arm may have this bank's kind of torque sensing
  Scalar innovation_squared_ = Scalar(1);
};

template <typename Scalar, int Dofs>
HypothesisBank<Scalar, Dofs>::HypothesisBank(Sensing sensing, const ArmPrior<Scalar, Dofs>& arm,
                                             const PayloadPrior<Scalar>& payload, Scalar rated_payload) noexcept
    : model_(sensing, arm,
             detail::dot(payload.com_mean, payload.com_mean) + detail::dot(payload.com_std, payload.com_std)),
      payload_(payload),
      rated_(rated_payload),
      push_(rated_payload) {
  const Star star = model_.prior();
  stars_.fill(star);
  before_ = recent_ = star;
  for (const Hypothesis h : {Hypothesis::Steady, Hypothesis::Filling, Hypothesis::Exchanged})
    stars_[index(h)].replace_payload(payload.mean(), payload.factor(payload.square_mass()));
  // Most arms are switched on with an empty hand. If not, the host or the first blocks say so.
  probability_.values = {Scalar(0.97), Scalar(0.01), Scalar(0.001), Scalar(0.009), Scalar(0.01)};
}

template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::believe(Hypothesis h, Scalar probability) noexcept {
  if (h == Hypothesis::Empty) {  // if something was held for long, this hypothesis has outdated offsets
    before_ = stars_[likeliest()];
    before_.empty_payload();
    stars_[index(h)] = recent_ = before_;
    age_ = known_ = Scalar(0);
  }
  for (Scalar& p : probability_.values) p *= Scalar(1) - probability;
  probability_[h] += probability;
}

template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::set_payload(const InertialVector<Scalar>& mean,
                                               const InertialMatrix<Scalar>& factor) noexcept {
  Star& steady = stars_[index(Hypothesis::Steady)];
  steady = stars_[likeliest()];
  steady.replace_payload(mean, factor);
  before_ = recent_ = steady;
  age_ = known_ = Scalar(0);
}

template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::reopen_offsets() noexcept {
  for (Star& star : stars_) model_.reopen_offset(star);
}

template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::begin(const TorqueBlock<Scalar, Dofs>& block,
                                         const FrictionRegime<Scalar, Dofs>& regime,
                                         const BlockContext<Scalar>& context) noexcept {
  model_.begin(block, regime, context);
  exchange_likely_ = context.exchange_likely;
  const bool settles = since_exchange_ < Scalar(kSettling) && since_exchange_ + block.duration >= Scalar(kSettling);
  exchange_anew_ = late_ || (!model_.learns_lag() && settles && worst_ > Scalar(kSpoilt));
  kind_likely_ = context.kind_likely;
  for (std::size_t to = 0; to < kHypotheses; ++to) {
    Scalar sum = Scalar(0);
    for (std::size_t from = 0; from < kHypotheses; ++from) sum += transition(from, to) * probability_.values[from];
    predicted_.values[to] = sum;
  }
  constexpr std::size_t pushed = index(Hypothesis::Pushed);
  goes_on_ = static_cast<Scalar>(kTransitions[pushed][pushed]) * probability_.values[pushed] /
             std::max(predicted_.values[pushed], Scalar(1e-30));
  if (model_.rough()) predicted_[Hypothesis::Exchanged] *= Scalar(kRoughExchange);
  if (context.exchange_likely) {  // as likely as all others together
    for (Scalar& p : predicted_.values) p *= Scalar(0.5);
    predicted_[Hypothesis::Exchanged] += Scalar(0.5);
  }
  for (std::size_t i = 0; i < kHypotheses; ++i) {
    in_question_.values[i] = predicted_.values[i] > Scalar(1e-6);
    squared_.values[i] = Scalar(1e6);
  }
}

/// Whether Empty or Steady is likely before the block and explains it. Hypotheses that are far less likely beforehand
/// cannot win then: they have unknowns, which lower their likelihood.
template <typename Scalar, int Dofs>
bool HypothesisBank<Scalar, Dofs>::settled_explains() const noexcept {
  for (const Hypothesis h : {Hypothesis::Empty, Hypothesis::Steady})
    if (in_question_[h] && predicted_[h] > Scalar(0.9) && squared_[h] < Scalar(1.5)) return true;
  return false;
}

template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::evaluate(std::size_t step) noexcept {
  const bool empty_first = predicted_[Hypothesis::Empty] > predicted_[Hypothesis::Steady];
  const auto h = static_cast<Hypothesis>(step < 2 && !empty_first ? 1 - step : step);
  const bool patient = model_.rough() && kind_likely_;  // a large residual may hide a payload for seconds
  const bool needed = exchange_likely_ || patient || (exchange_anew_ && h == Hypothesis::Exchanged);
  const auto improbable = static_cast<Scalar>(kind_likely_ ? kImprobable : kImprobableKind);
  if (step > 0 && !needed && predicted_[h] < improbable && settled_explains()) in_question_[h] = false;
  if (in_question_[h]) take_in(h);
  if (step + 1 < kHypotheses) return;
  model_.predict(before_);  // after the last use of both in this block
  model_.predict(recent_);
}

/// Computes the state of h at the start of the block, and updates it with the block.
template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::take_in(Hypothesis h) noexcept {
  mix(h);
  Star& star = next(h);
  model_.predict(star);
  switch (h) {
    case Hypothesis::Empty:
      if (unloaded_ > Scalar(kNegligible)) model_.unload(star, before_.mean(), unloaded_);
      likelihood_[h] = update(star);
      break;
    case Hypothesis::Filling:
      star.diffuse(filling(star));
      [[fallthrough]];
    case Hypothesis::Steady:
      likelihood_[h] = update(star);
      likelihood_[h] += log_plausible(star);
      break;
    case Hypothesis::Exchanged:
      evaluate_exchange(star);
      break;
    case Hypothesis::Pushed:
      likelihood_[h] = push_likelihood(star);
      break;
  }
}

template <typename Scalar, int Dofs>
Scalar HypothesisBank<Scalar, Dofs>::finish() noexcept {
  using std::exp;
  using std::log;
  Scalar highest = Scalar(-1e30);
  for (std::size_t i = 0; i < kHypotheses; ++i) {
    in_question_.values[i] = in_question_.values[i] && std::isfinite(likelihood_.values[i]) && next_[i].finite();
    if (in_question_.values[i]) highest = std::max(highest, likelihood_.values[i]);
  }
  follow_pour();
  if (!in_question_[Hypothesis::Pushed]) push_.forget();
  Scalar total = Scalar(0);
  PerHypothesis<Scalar> posterior;
  for (std::size_t i = 0; i < kHypotheses; ++i) {
    if (!in_question_.values[i]) continue;
    posterior.values[i] = predicted_.values[i] * exp(std::max(Scalar(-80), likelihood_.values[i] - highest));
    total += posterior.values[i];
  }
  if (!(total > 0)) return Scalar(0);
  Hypothesis settled = Hypothesis::Empty;
  for (std::size_t i = 0; i < kHypotheses; ++i) {
    probability_.values[i] = posterior.values[i] / total;
    if (in_question_.values[i]) stars_[i] = next_[i];
  }
  for (const Hypothesis h : {Hypothesis::Steady, Hypothesis::Filling})
    if (in_question_[h] && (!in_question_[settled] || predicted_[h] > predicted_[settled])) settled = h;
  innovation_squared_ = squared_[settled];
  follow_exchange(settled);
  const Hypothesis sure =
      probability_[Hypothesis::Empty] > probability_[Hypothesis::Steady] ? Hypothesis::Empty : Hypothesis::Steady;
  if (probability_[sure] > Scalar(0.9)) {
    age_ += model_.block().duration;
    known_ = std::min(Scalar(1), known_ + model_.block().duration);
    if (age_ > std::min(Scalar(kAge), Scalar(0.49) * known_)) {
      before_ = recent_;
      recent_ = stars_[index(sure)];
      age_ = Scalar(0);
    }
    model_.learn(sure == Hypothesis::Empty, innovation_[sure], variance_[sure]);
  } else {
    model_.interrupt();
  }
  const bool pays = late_ && !paid_;
  paid_ = paid_ || late_;
  return highest + log(total) - (pays ? Scalar(kLate) : Scalar(0));
}

}  // namespace rme::bank

#include <rme/tracking/bank/hypothesis_bank_impl.hpp>
