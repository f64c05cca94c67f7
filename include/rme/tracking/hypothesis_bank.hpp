#pragma once
/// The interacting-multiple-model filter over the hypotheses, for one kind of torque sensing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <limits>
#include <rme/core/cholesky.hpp>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/hypothesis.hpp>
#include <rme/tracking/joint_torque_model.hpp>
#include <rme/tracking/star_gaussian.hpp>
#include <rme/tracking/torque_block.hpp>

namespace rme {

/// Five filters and their probabilities (Blom and Bar-Shalom, IEEE Trans. Automatic Control 1988; docs/theory.md,
/// "Hypotheses"). A block is taken in by begin(), evaluate() of every hypothesis, finish(), in that order; they may be
/// spread over several ticks, and until finish() everything else says what it said before.
///
/// Real time: no call allocates. evaluate() costs some 3,000 multiplications for 7 joints, twice that where hypotheses
/// have to be mixed; a hypothesis that is out of the question costs nothing.
template <typename Scalar, int Dofs>
class HypothesisBank {
 public:
  using Star = StarGaussian<Scalar, Dofs>;  ///< what each filter is over

  /// An empty hand, most likely; rated_payload in [kg], > 0.
  HypothesisBank(Sensing sensing, const ArmPrior<Scalar, Dofs>& arm, const PayloadPrior<Scalar>& payload,
                 Scalar rated_payload) noexcept;

  /// Starts a block: probabilities before it is looked at (docs/theory.md (T19)).
  /// @param block            the next one
  /// @param regime           which joints rest in it
  /// @param exchange_likely  the host says that the payload changes now
  /// @param kind_likely      the arm may well have this kind of torque sensing
  void begin(const TorqueBlock<Scalar, Dofs>& block, const FrictionRegime<Scalar, Dofs>& regime, bool exchange_likely,
             bool kind_likely) noexcept;
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
  /// average if the arm does what the model says (docs/theory.md (T26)).
  Scalar innovation_squared() const noexcept { return innovation_squared_; }
  /// What has been learned of the joints' noise and residual.
  const SensorNoise<Scalar, Dofs>& noise() const noexcept { return model_.noise(); }

  /// Believes that `h` is so, with the given odds against all else.
  void believe(Hypothesis h, Scalar probability) noexcept;
  /// What is held becomes N(mean, factor factor^T).
  void set_payload(const InertialVector<Scalar>& mean, const InertialMatrix<Scalar>& factor) noexcept;
  /// Forgets how sure the offsets were: what a host says of the payload may contradict them.
  void reopen_offsets() noexcept;

 private:
  static constexpr std::size_t index(Hypothesis h) noexcept { return static_cast<std::size_t>(h); }
  /// Of a hypothesis that enters another by less than this, nothing is mixed in.
  static constexpr double kNegligible = 1e-4;
  /// A rough arm's torque changes by what a payload makes more often than its payload does.
  static constexpr double kRoughExchange = 0.05;
  static constexpr double kAge = 0.1 - 1e-6;  // [s]

  Star& next(Hypothesis h) noexcept { return next_[index(h)]; }
  std::size_t likeliest() const noexcept {
    const auto& p = probability_.values;
    return static_cast<std::size_t>(std::max_element(p.begin(), p.end()) - p.begin());
  }
  const Star& source(std::size_t from, Hypothesis to) const noexcept;
  void mix(Hypothesis h) noexcept;
  Scalar update(Star& star) noexcept;
  Scalar push_likelihood(const Star& star) noexcept;
  void evaluate_exchange(Star& star) noexcept;
  InertialMatrix<Scalar> filling(const Star& star) const noexcept;
  /// log P(m is a mass that an arm can tell from nothing, and can hold) of a star.
  Scalar log_plausible(const Star& star) const noexcept;
  bool settled_explains() const noexcept;

  JointTorqueModel<Scalar, Dofs> model_;
  PayloadPrior<Scalar> payload_;
  Scalar rated_;
  std::array<Star, kHypotheses> stars_, next_;
  // Of a block in which nothing happened, 0.1 to 0.2 s ago, and of one less long ago, with what may have changed since.
  Star before_, recent_;
  // Age of recent_, and for how long nothing happened in all, up to a second [s]: of a life that is shorter than kAge
  // about half is known.
  Scalar age_ = Scalar(0), known_ = Scalar(0);
  PerHypothesis<Scalar> probability_;

  // of the block that is being taken in
  PerHypothesis<Scalar> predicted_;   // probabilities before the block is looked at
  PerHypothesis<Scalar> likelihood_;  // log p(block | hypothesis)
  PerHypothesis<bool> in_question_;
  PerHypothesis<Scalar> squared_;  // e^T S^-1 e per joint
  PerHypothesis<JointVector<Scalar, Dofs>> innovation_, variance_;
  bool exchange_likely_ = false;
  bool patient_ = false;  // what is unlikely is looked at all the same: a large residual hides it for seconds
  Scalar innovation_squared_ = Scalar(1);
};

template <typename Scalar, int Dofs>
HypothesisBank<Scalar, Dofs>::HypothesisBank(Sensing sensing, const ArmPrior<Scalar, Dofs>& arm,
                                             const PayloadPrior<Scalar>& payload, Scalar rated_payload) noexcept
    : model_(sensing, arm,
             detail::dot(payload.com_mean, payload.com_mean) + detail::dot(payload.com_std, payload.com_std)),
      payload_(payload),
      rated_(rated_payload) {
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
                                         const FrictionRegime<Scalar, Dofs>& regime, bool exchange_likely,
                                         bool kind_likely) noexcept {
  model_.begin(block, regime);
  exchange_likely_ = exchange_likely;
  patient_ = model_.rough() && kind_likely;
  for (std::size_t to = 0; to < kHypotheses; ++to) {
    Scalar sum = Scalar(0);
    for (std::size_t from = 0; from < kHypotheses; ++from)
      sum += static_cast<Scalar>(kTransitions[from][to]) * probability_.values[from];
    predicted_.values[to] = sum;
  }
  if (model_.rough()) predicted_[Hypothesis::Exchanged] *= Scalar(kRoughExchange);
  if (exchange_likely) {  // as likely as all else
    for (Scalar& p : predicted_.values) p *= Scalar(0.5);
    predicted_[Hypothesis::Exchanged] += Scalar(0.5);
  }
  for (std::size_t i = 0; i < kHypotheses; ++i) {
    in_question_.values[i] = predicted_.values[i] > Scalar(1e-6);
    squared_.values[i] = Scalar(1e6);
  }
}

/// Whether the likeliest hypothesis explains the block well enough for all that are hundreds of times less likely
/// beforehand, and have a prior of some dimensions to pay for, to be out of the question.
template <typename Scalar, int Dofs>
bool HypothesisBank<Scalar, Dofs>::settled_explains() const noexcept {
  for (const Hypothesis h : {Hypothesis::Empty, Hypothesis::Steady})
    if (in_question_[h] && predicted_[h] > Scalar(0.9) && squared_[h] < Scalar(1.5)) return true;
  return false;
}

template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::evaluate(std::size_t step) noexcept {
  if (step == 0) {
    model_.predict(before_);
    model_.predict(recent_);
  }
  const bool empty_first = predicted_[Hypothesis::Empty] > predicted_[Hypothesis::Steady];
  const auto h = static_cast<Hypothesis>(step < 2 && !empty_first ? 1 - step : step);
  if (!in_question_[h]) return;
  if (step > 0 && !exchange_likely_ && !patient_ && predicted_[h] < Scalar(0.002) && settled_explains()) {
    in_question_[h] = false;
    return;
  }
  mix(h);
  Star& star = next(h);
  model_.predict(star);
  switch (h) {
    case Hypothesis::Empty:
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
  return highest + log(total);
}

/// What is known of an arm in which `to` begins, having been in `from`. A change has gone on for a while before it is
/// noticed, and nuisances have taken on a share of it: what follows a change starts from before. An exchange that turns
/// out to be a push was none: what was held before it is held still.
template <typename Scalar, int Dofs>
auto HypothesisBank<Scalar, Dofs>::source(std::size_t from, Hypothesis to) const noexcept -> const Star& {
  const auto h = static_cast<Hypothesis>(from);
  const bool change = to == Hypothesis::Exchanged || (to == Hypothesis::Empty && h != to) ||
                      (to == Hypothesis::Pushed && h == Hypothesis::Exchanged);
  return change ? before_ : stars_[from];
}

/// What the filters said of the nuisances and the payload before this block, as far as each leads to `h`
/// (docs/theory.md (T20)).
template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::mix(Hypothesis h) noexcept {
  const bool anew = h == Hypothesis::Empty || h == Hypothesis::Exchanged;  // whatever the payload was before
  std::array<Scalar, kHypotheses> weight{};
  Scalar sum = Scalar(0);
  std::size_t parts = 0, last = index(h);
  for (std::size_t from = 0; from < kHypotheses; ++from) {
    const Scalar w = static_cast<Scalar>(kTransitions[from][index(h)]) * probability_.values[from];
    if (!(w > Scalar(kNegligible) * predicted_[h])) continue;
    weight[from] = w;
    sum += w;
    last = from;
    ++parts;
  }
  Star& out = next(h);
  if (parts <= 1 || h == Hypothesis::Exchanged) {
    out = source(last, h);
    if (anew) out.empty_payload();
    if (h == Hypothesis::Exchanged && model_.rough()) model_.reopen_residual(out);
    return;
  }
  std::array<const Star*, kHypotheses> from{};
  for (std::size_t i = 0; i < kHypotheses; ++i) {
    weight[i] /= sum;
    from[i] = &source(i, h);
  }
  out = anew ? Star::mix_emptied(from, weight) : Star::mix(from, weight);
}

/// Takes the block in, joint by joint.
/// @return log likelihood
template <typename Scalar, int Dofs>
Scalar HypothesisBank<Scalar, Dofs>::update(Star& star) noexcept {
  using std::exp;
  using std::log;
  const auto h = static_cast<std::size_t>(&star - next_.data());
  const Scalar mass = std::min(std::max(star.mean()[0], Scalar(0)), rated_);
  Scalar log_likelihood = Scalar(0), squared = Scalar(0);
  for (int j = 0; j < Dofs; ++j) {
    auto p = star.predict(j, model_.observation(j, mass));
    const Scalar square = p.innovation * p.innovation;
    const auto log_density = [square](Scalar variance) { return Scalar(-0.5) * (square / variance + log(variance)); };
    if (const Scalar jump = model_.stiction_jump(j); jump > 0) {  // both, by their likelihoods
      const Scalar stays = log_density(p.variance), jumps = log_density(p.variance + jump);
      const Scalar share = Scalar(1) / (Scalar(1) + exp(std::min(Scalar(80), stays - jumps)));
      log_likelihood += std::max(stays, jumps) + log(Scalar(1) + exp(-std::abs(stays - jumps)));
      star.joint(j).covariance(kStiction, kStiction) += share * jump;
      p = star.predict(j, model_.observation(j, mass));
    } else {
      log_likelihood += log_density(p.variance);
    }
    squared += square / p.variance;
    innovation_.values[h][j] = p.innovation;
    variance_.values[h][j] = p.variance;
    star.observe(j, p);
  }
  squared_.values[h] = squared / Scalar(Dofs);
  return log_likelihood;
}

/// phi is drawn anew from the prior. How heavy it is, the block itself says best: once for the mass, and once more with
/// the prior of m r that belongs to that mass.
template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::evaluate_exchange(Star& star) noexcept {
  const Hypothesis h = Hypothesis::Exchanged;
  const Star base = star;
  star.replace_payload(payload_.mean(), payload_.factor(payload_.square_mass()));
  (void)update(star);
  const Scalar mass = std::max(Scalar(0.02) * rated_, std::min(rated_, star.mean()[0]));
  star = base;
  star.replace_payload(payload_.mean(), payload_.factor(mass * mass));
  likelihood_[h] = update(star);
  likelihood_[h] += log_plausible(star);
}

/// A push says nothing of the payload, and nothing is learned from the block: only how likely it is, with a wrench
/// w ~ N(0, S) beside the payload, J^T S J more noise.
template <typename Scalar, int Dofs>
Scalar HypothesisBank<Scalar, Dofs>::push_likelihood(const Star& star) noexcept {
  constexpr int n = Dofs;
  Eigen::Matrix<Scalar, n, n> S;
  JointVector<Scalar, Dofs> e, independent;
  Eigen::Matrix<Scalar, n, kInertial> spread;
  Eigen::Matrix<Scalar, n, 6> wrench;
  const Scalar force = Scalar(4) * rated_, moment = Scalar(0.5) * rated_;  // [N], [N m]: 12 and 1.5 on a Panda
  for (int j = 0; j < n; ++j) {
    auto p = star.predict(j, model_.observation(j, star.mean()[0]));
    e[j] = p.innovation;
    independent[j] = p.given_payload;
    for (int i = 0; i < kInertial; ++i) spread(j, i) = p.spread[i];
    for (int i = 0; i < 6; ++i) wrench(j, i) = (i < 3 ? force : moment) * model_.block().jacobian(i, j);
  }
  S = detail::outer_square(spread);
  S += detail::outer_square(wrench);
  Scalar largest = Scalar(0);
  for (int j = 0; j < n; ++j) {
    S(j, j) += independent[j];
    largest = std::max(largest, S(j, j));
  }
  // What rounding may take off a pivot: torques that no wrench makes are known a hundred times better than those that
  // one does, which is as far as a float's square reaches.
  for (int j = 0; j < n; ++j) S(j, j) += 16 * Eigen::NumTraits<Scalar>::epsilon() * largest;
  const Cholesky<Scalar, n> factor(S);
  if (!factor.positive_definite()) return -std::numeric_limits<Scalar>::infinity();  // out of the question
  const JointVector<Scalar, Dofs> white = factor.solve_lower(e);
  const Scalar squared = detail::dot(white, white);
  squared_[Hypothesis::Pushed] = squared / Scalar(n);
  return Scalar(-0.5) * squared - factor.log_det_lower();
}

/// Covariance of what is poured in within a block: any mass, with its centre about where the payload's is.
template <typename Scalar, int Dofs>
InertialMatrix<Scalar> HypothesisBank<Scalar, Dofs>::filling(const Star& star) const noexcept {
  using std::sqrt;
  constexpr double kRate = 0.0027;  // of the rated payload, in a block of 20 ms
  const Scalar mass = Scalar(kRate) * rated_ * sqrt(model_.block().duration / Scalar(0.02));
  const Scalar held = star.mean()[0];
  Vector4<Scalar> poured;  // (m, m r) of a body of this mass
  poured[0] = mass;
  for (int i = 0; i < 3; ++i) {
    const Scalar off = 3 * payload_.com_std[i];
    const Scalar com = held > Scalar(0.007) * rated_ ? star.mean()[1 + i] / held - payload_.com_mean[i] : Scalar(0);
    poured[1 + i] = mass * (payload_.com_mean[i] + std::max(-off, std::min(off, com)));
  }
  InertialMatrix<Scalar> Q = InertialMatrix<Scalar>::Zero();
  for (int i = 0; i < 4; ++i)
    for (int j = 0; j < 4; ++j) Q(i, j) = poured[i] * poured[j];
  for (int i = 0; i < 3; ++i) {
    const Scalar spread = Scalar(0.3) * payload_.com_std[i] * mass;
    Q(1 + i, 1 + i) += spread * spread;
  }
  if (held > Scalar(0.02) * rated_) {
    // As little as is known of where the payload's centre is, is known of what comes to it; block after block the same.
    const InertialMatrix<Scalar> P = star.covariance();
    const Scalar share = Scalar(0.6) * mass / held, known = Scalar(1) / std::max(P(0, 0), Scalar(1e-12));
    for (int i = 1; i < 4; ++i)
      for (int j = 1; j < 4; ++j) Q(i, j) += share * (P(i, j) - P(i, 0) * P(0, j) * known);
  }
  const Scalar inertia = mass * detail::dot(payload_.com_mean, payload_.com_mean);
  for (int i = 4; i < kInertial; ++i) Q(i, i) = inertia * inertia;
  return Q;
}

template <typename Scalar, int Dofs>
Scalar HypothesisBank<Scalar, Dofs>::log_plausible(const Star& star) const noexcept {
  using std::erfc;
  using std::log;
  using std::sqrt;
  const Scalar deviation = sqrt(std::max(star.mass_variance(), Scalar(1e-12)));
  const auto below = [&](Scalar m) { return Scalar(0.5) * erfc((star.mean()[0] - m) / (deviation * sqrt(Scalar(2)))); };
  constexpr double kLightest = 0.007, kHeaviest = 1.2;  // of the rated payload: 20 g on a Panda
  return log(std::max(Scalar(1e-30), below(Scalar(kHeaviest) * rated_) - below(Scalar(kLightest) * rated_)));
}

}  // namespace rme
