#pragma once
/// How HypothesisBank computes one hypothesis: its state at the start of a block, and the update with the block.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <rme/tracking/bank/hypothesis_bank.hpp>

namespace rme::bank {

template <typename Scalar, int Dofs>
Scalar HypothesisBank<Scalar, Dofs>::transition(std::size_t from, std::size_t to) const noexcept {
  constexpr std::size_t steady = index(Hypothesis::Steady), filling = index(Hypothesis::Filling);
  const auto usual = static_cast<Scalar>(kTransitions[from][to]);
  if (from != steady && from != filling) return usual;
  const Scalar more = from == steady ? pour_.onset() : pour_.end();
  if (to == from) return usual - more;
  return to == steady || to == filling ? usual + more : usual;
}

/// The state with which `to` starts if the block before was `from`. When a change is noticed, it has gone on for a
/// while, and the nuisances have absorbed a part of it. So after a change, `to` starts from an earlier state, before_.
/// The same holds for a pour that has shown for a while, and for a push after an exchange: the exchange was then the
/// beginning of the push, and the payload is the one from before.
template <typename Scalar, int Dofs>
auto HypothesisBank<Scalar, Dofs>::source(std::size_t from, Hypothesis to) const noexcept -> const Star& {
  const auto h = static_cast<Hypothesis>(from);
  const bool doubtful = h == Hypothesis::Exchanged || (h != Hypothesis::Empty && since_exchange_ < Scalar(kDoubtful));
  const bool poured = to == Hypothesis::Filling && h == Hypothesis::Steady && pour_.onset() > 0;
  const bool change = h != to && (to == Hypothesis::Empty || poured || (to == Hypothesis::Pushed && doubtful));
  return change ? before_ : stars_[from];
}

/// The state of `h` at the start of the block: the mixture of the states from which `h` may follow (docs/theory.md
/// (T20)).
template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::mix(Hypothesis h) noexcept {
  Star& out = next(h);
  if (h == Hypothesis::Exchanged) {  // the same for every hypothesis of the block before
    out = before_;
    out.empty_payload();
    if (model_.rough()) model_.reopen_hiding(out);
    return;
  }
  const bool emptied = h == Hypothesis::Empty;
  std::array<Scalar, kHypotheses> weight{};
  Scalar sum = Scalar(0);
  std::size_t parts = 0, last = index(h);
  for (std::size_t from = 0; from < kHypotheses; ++from) {
    const Scalar w = transition(from, index(h)) * probability_.values[from];
    if (!(w > Scalar(kNegligible) * predicted_[h])) continue;
    weight[from] = w;
    sum += w;
    last = from;
    ++parts;
  }
  if (parts <= 1) {
    out = source(last, h);
    if (emptied) out.empty_payload();
    unloaded_ = last == index(h) ? Scalar(0) : Scalar(1);
    return;
  }
  std::array<const Star*, kHypotheses> from{};
  for (std::size_t i = 0; i < kHypotheses; ++i) {
    weight[i] /= sum;
    from[i] = &source(i, h);
  }
  out = emptied ? Star::mix_emptied(from, weight) : Star::mix(from, weight);
  unloaded_ = Scalar(1) - weight[index(h)];
}

/// Updates a state of next_ with the block, joint by joint.
/// @return log p(block | hypothesis) [nats], without the constant factor of 2 pi
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
    if (const Scalar jump = model_.stiction_jump(star, j); jump > 0) {  // a mixture of both
      const Scalar stays = log_density(p.variance), jumps = log_density(p.variance + jump);
      const Scalar share = Scalar(1) / (Scalar(1) + exp(stays - jumps));
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

/// Replaces phi by its prior, and updates it with the block. The prior of m r needs the mass, and the block itself
/// shows the mass best. So the update is made twice: once to find the mass, and again with the prior for that mass.
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

/// Log likelihood of the block if a wrench acts in addition to the payload. The state is not updated: a pushed block is
/// not used to learn the payload or the nuisances.
template <typename Scalar, int Dofs>
Scalar HypothesisBank<Scalar, Dofs>::push_likelihood(const Star& star) noexcept {
  constexpr int n = Dofs;
  JointVector<Scalar, Dofs> e, independent;
  Eigen::Matrix<Scalar, n, kInertial> spread;
  for (int j = 0; j < n; ++j) {
    auto p = star.predict(j, model_.observation(j, star.mean()[0]));
    e[j] = p.innovation;
    independent[j] = p.given_payload;
    for (int i = 0; i < kInertial; ++i) spread(j, i) = p.spread[i];
  }
  Eigen::Matrix<Scalar, n, n> S = detail::outer_square(spread);
  for (int j = 0; j < n; ++j) S(j, j) += independent[j];
  return push_.update(e, S, model_.block().jacobian, model_.block().duration, goes_on_);
}

/// Covariance of the change of phi by what is poured within a block: its mass is N(0, spread^2), and its centre of mass
/// is near the payload's.
template <typename Scalar, int Dofs>
InertialMatrix<Scalar> HypothesisBank<Scalar, Dofs>::filling(const Star& star) const noexcept {
  const Scalar mass = pour_.spread(model_.block().duration) * rated_;
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
    // What is added has about the payload's centre of mass. The error of that estimate is the same in each block.
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
  constexpr double kLightest = 0.007, kHeaviest = 1.2;  // times the rated payload: 20 g and 3.6 kg on a Panda
  return log(std::max(Scalar(1e-30), below(Scalar(kHeaviest) * rated_) - below(Scalar(kLightest) * rated_)));
}

/// Watches the first tenth of a second after an exchange. If a block in it is badly explained, the observer's bandwidth
/// may not be the stated one, and payload or nuisances have absorbed its error. The payload is then estimated again,
/// from the arm's nuisances before the exchange. With link-side sensing this is done if a lag explains the error, with
/// the next block, for which the lag is a nuisance. With the other kinds it is done at the end of the tenth of a
/// second, when the observer's error has decayed.
template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::follow_exchange(Hypothesis settled) noexcept {
  const bool held = probability_[Hypothesis::Steady] + probability_[Hypothesis::Filling] > Scalar(0.5);
  if (exchange_anew_ && in_question_[Hypothesis::Exchanged] && held)
    stars_[index(Hypothesis::Steady)] = stars_[index(Hypothesis::Filling)] = stars_[index(Hypothesis::Exchanged)];
  since_exchange_ += model_.block().duration;
  worst_ = std::max(worst_, innovation_squared_);
  const bool spoilt = since_exchange_ < Scalar(kSettling) && innovation_squared_ > Scalar(kSpoilt);
  late_ = spoilt && model_.unexplained(innovation_[settled], variance_[settled]);
  if (probability_[Hypothesis::Exchanged] > Scalar(0.5)) since_exchange_ = worst_ = Scalar(0);
}

/// Updates the pour monitor with the results of Steady and Filling, while one of them is believed.
template <typename Scalar, int Dofs>
void HypothesisBank<Scalar, Dofs>::follow_pour() noexcept {
  const Hypothesis steady = Hypothesis::Steady, filling = Hypothesis::Filling;
  if (in_question_[steady] && probability_[steady] > Scalar(0.5)) {
    const InertialVector<Scalar>& phi = next(steady).mean();
    JointVector<Scalar, Dofs> noise;
    for (int j = 0; j < Dofs; ++j) noise[j] = model_.observation(j, phi[0]).noise;
    pour_.follow_steady(model_.block(), phi, rated_, innovation_[steady], variance_[steady], noise);
  } else {
    pour_.forget_lean();
  }
  if (in_question_[filling] && probability_[filling] > Scalar(0.5))
    pour_.follow_filling((next(filling).mean()[0] - star(filling).mean()[0]) / rated_, model_.block().duration);
  else
    pour_.forget_pace();
}

}  // namespace rme::bank
