#pragma once
/// The interacting-multiple-model filter over the hypotheses, for one kind of torque sensing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/hypothesis.hpp>
#include <rme/tracking/joint_torque_model.hpp>
#include <rme/tracking/pour_monitor.hpp>
#include <rme/tracking/push_filter.hpp>
#include <rme/tracking/star_gaussian.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

/// Five filters and their probabilities (Blom and Bar-Shalom, IEEE Trans. Automatic Control 1988; docs/theory.md,
/// "Hypotheses"). A block is taken in by begin(), evaluate() of every hypothesis, finish(), in that order; they may be
/// spread over several ticks; results change in finish() only.
///
/// Real time: no call allocates. evaluate() costs some 3,000 multiplications for 7 joints, twice that where hypotheses
/// have to be mixed; one that is too improbable is not computed.
template <typename Scalar, int Dofs>
class HypothesisBank {
 public:
  using Star = StarGaussian<Scalar, Dofs>;  ///< what each filter is over

  /// An empty hand, most likely; rated_payload in [kg], > 0.
  HypothesisBank(Sensing sensing, const ArmPrior<Scalar, Dofs>& arm, const PayloadPrior<Scalar>& payload,
                 Scalar rated_payload) noexcept;

  /// Starts a block: probabilities before it is looked at (docs/theory.md (T19)).
  /// @param block    the next one
  /// @param regime   which joints rest in it
  /// @param context  what else is known of it
  void begin(const TorqueBlock<Scalar, Dofs>& block, const FrictionRegime<Scalar, Dofs>& regime,
             const BlockContext<Scalar>& context) noexcept;
  /// Mixes, predicts and updates one hypothesis, the one that comes `step`th, 0 .. kHypotheses - 1: first the likeliest
  /// one that needs no event. If that explains the block, most others are out of the question.
  void evaluate(std::size_t step) noexcept;
  /// Ends a block: new probabilities (docs/theory.md (T21)), and what the noise has been learned to be.
  /// @return log p(block | all blocks before) [nats], up to a constant that all banks share
  Scalar finish() noexcept;

  Scalar probability(Hypothesis h) const noexcept { return probability_[h]; }  ///< after the last block
  /// The filter of h after the last block.
  const Star& star(Hypothesis h) const noexcept { return stars_[index(h)]; }
  /// e^T S^-1 e per joint of the likeliest hypothesis that is neither an exchange nor a push, at the last block: 1 on
  /// average if the arm does what the model says (docs/theory.md (T30)).
  Scalar innovation_squared() const noexcept { return innovation_squared_; }
  /// What has been learned of the joints' noise and residual.
  const SensorNoise<Scalar, Dofs>& noise() const noexcept { return model_.noise(); }

  /// Gives `h` this probability, 0 to 1, and scales those of all others down.
  void believe(Hypothesis h, Scalar probability) noexcept;
  /// What is held becomes N(mean, factor factor^T).
  void set_payload(const InertialVector<Scalar>& mean, const InertialMatrix<Scalar>& factor) noexcept;
  /// Forgets how sure the offsets were: what a host says of the payload may contradict them.
  void reopen_offsets() noexcept;

 private:
  static constexpr std::size_t index(Hypothesis h) noexcept { return static_cast<std::size_t>(h); }
  /// Of a hypothesis that enters another by less than this, nothing is mixed in.
  static constexpr double kNegligible = 1e-4;
  /// Below it, a hypothesis is left out of a block that a more likely one explains; and so where the arm hardly has this
  /// kind of torque sensing.
  static constexpr double kImprobable = 0.002, kImprobableKind = 0.02;
  /// A rough arm's torque changes by what a payload makes more often than its payload does.
  static constexpr double kRoughExchange = 0.0125;
  static constexpr double kAge = 0.1 - 1e-6;        // [s]
  static constexpr double kDoubtful = 0.04 - 1e-6;  // that a payload may turn out to be a push [s]
  static constexpr double kSettling = 0.1 - 1e-6;   // after an exchange: observers' tails are over [s]
  static constexpr double kSpoilt = 4;              // e^T S^-1 e per joint that no payload explains
  static constexpr double kLate = 10;               // against torque that comes late [nats]: on most arms it does not

  Star& next(Hypothesis h) noexcept { return next_[index(h)]; }
  std::size_t likeliest() const noexcept {
    const auto& p = probability_.values;
    return static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin());
  }
  /// kTransitions, and what the pour monitor adds to *steady* and *filling*.
  Scalar transition(std::size_t from, std::size_t to) const noexcept;
  const Star& source(std::size_t from, Hypothesis to) const noexcept;
  void take_in(Hypothesis h) noexcept;
  void mix(Hypothesis h) noexcept;
  Scalar update(Star& star) noexcept;
  Scalar push_likelihood(const Star& star) noexcept;
  void evaluate_exchange(Star& star) noexcept;
  InertialMatrix<Scalar> filling(const Star& star) const noexcept;
  /// log P(m is a mass that an arm can tell from nothing, and can hold) of a star.
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
  // Of a block in which nothing happened, 0.1 to 0.2 s ago, and of one less long ago, with what may have changed since.
  Star before_, recent_;
  // Age of recent_, and for how long nothing happened in all, up to a second [s]: of a life that is shorter than kAge
  // about half is known.
  Scalar age_ = Scalar(0), known_ = Scalar(0);
  Scalar since_exchange_ = Scalar(kSettling);  // time since one was believed in [s]
  Scalar worst_ = Scalar(0);                   // largest innovation_squared_ since then
  PerHypothesis<Scalar> probability_;

  // of the block that is being taken in
  PerHypothesis<Scalar> predicted_;   // probabilities before the block is looked at
  PerHypothesis<Scalar> likelihood_;  // log p(block | hypothesis)
  PerHypothesis<bool> in_question_;
  PerHypothesis<Scalar> squared_;  // e^T S^-1 e per joint
  PerHypothesis<JointVector<Scalar, Dofs>> innovation_, variance_;
  Scalar goes_on_ = Scalar(0);   // P(the block before was pushed as well, given that this one is)
  Scalar unloaded_ = Scalar(0);  // share of what the hypothesis taken in begins with in which something else was so
  bool exchange_likely_ = false;
  bool exchange_anew_ = false;  // the exchange is looked at anew
  bool late_ = false;           // the block before has shown that the torque of an exchange comes late
  bool paid_ = false;           // kLate has been lost: once, as the arm does not change
  bool kind_likely_ = true;     // that the arm has this bank's kind of torque sensing
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
  // An arm is switched on with an empty hand, or else says so soon.
  probability_.values = {Scalar(0.97), Scalar(0.01), Scalar(0.001), Scalar(0.009), Scalar(0.01)};
}

template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::believe(Hypothesis h, Scalar probability) noexcept {
  if (h == Hypothesis::Empty) {  // of a hand that was long not empty, the filter for an empty one knows old offsets
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
  if (context.exchange_likely) {  // as likely as all else
    for (Scalar& p : predicted_.values) p *= Scalar(0.5);
    predicted_[Hypothesis::Exchanged] += Scalar(0.5);
  }
  for (std::size_t i = 0; i < kHypotheses; ++i) {
    in_question_.values[i] = predicted_.values[i] > Scalar(1e-6);
    squared_.values[i] = Scalar(1e6);
  }
}

/// Whether the likeliest hypothesis explains the block well enough for all that are far less likely beforehand, and have
/// a prior of some dimensions to pay for, to be out of the question.
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
  const bool patient = model_.rough() && kind_likely_;  // a large residual hides for seconds what seems unlikely
  const bool needed = exchange_likely_ || patient || (exchange_anew_ && h == Hypothesis::Exchanged);
  const auto improbable = static_cast<Scalar>(kind_likely_ ? kImprobable : kImprobableKind);
  if (step > 0 && !needed && predicted_[h] < improbable && settled_explains()) in_question_[h] = false;
  if (in_question_[h]) take_in(h);
  if (step + 1 < kHypotheses) return;
  model_.predict(before_);  // now that nothing begins with them any more, they come up to this block
  model_.predict(recent_);
}

/// What h has begun with, and what the block says of it.
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

}  // namespace rme

#include <rme/tracking/detail/hypothesis_bank_impl.hpp>
