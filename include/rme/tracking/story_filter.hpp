#pragma once
/// How a story takes in a block of samples.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/disturbance.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/joint_torque_model.hpp>
#include <rme/tracking/mode.hpp>
#include <rme/tracking/story.hpp>
#include <rme/tracking/torque_block.hpp>
#include <rme/tracking/transitions.hpp>

namespace rme {

/// The filter of a story, for one kind of torque sensing: a block comes in, and the story with the block and the
/// likelihood of the block go out (docs/theory.md, "Stories" and (T16) to (T18)). What is learned of the arm's noise is
/// the same for all stories. Real time: no call allocates.
template <typename Scalar, int Dofs>
class StoryFilter {
 public:
  using Star = StarGaussian<Scalar, Dofs>;       ///< state of a filter
  using Model = JointTorqueModel<Scalar, Dofs>;  ///< model of the arm
  using Tale = Story<Scalar, Dofs>;              ///< a story
  using Torque = JointVector<Scalar, Dofs>;      ///< one number per joint
  /// Innovations of a block, unless it is disturbed.
  struct Innovation {
    Torque innovation = Torque::Zero();  ///< e of each joint [N m]
    Torque variance = Torque::Ones();    ///< S of each joint [(N m)^2]
    Scalar squared = Scalar(0);          ///< e^T S^-1 e, joints taken one by one
  };

  /// Parameters as in Tracker; `kind` is the row of the kind assumed.
  StoryFilter(const SensingKind& kind, const ArmPrior<Scalar, Dofs>& arm, const PayloadPrior<Scalar>& payload,
              Scalar rated_payload, const Vector3<Scalar>& gravity) noexcept
      : model_(kind, arm, rated_payload, payload.square_arm(), gravity),
        payload_(payload),
        rated_(rated_payload),
        tails_(static_cast<Scalar>(kind.tails)),
        log_tails_(tails_ > 0 ? static_cast<Scalar>(std::lgamma(0.5 * (kind.tails + 1)) -
                                                    std::lgamma(0.5 * kind.tails) - 0.5 * std::log(0.5 * kind.tails))
                              : Scalar(0)) {}

  Model& model() noexcept { return model_; }              ///< of the arm; its block is the one that is taken in
  const Model& model() const noexcept { return model_; }  ///< the same

  /// Applies the block to a child that is still its parent's copy.
  /// @param child       on return, the story with the block
  /// @param parent      the story without it
  /// @param transition  from the parent to the child
  /// @param children    first() and drawn() are overwritten; if the child is changing and one block shows a payload,
  ///                    drawn() holds the payload that this block alone shows
  /// @param out         of the update
  /// @return log p(block | child) [nats], without the constant factor of 2 pi
  template <typename Children>
  Scalar take_in(Tale& child, const Tale& parent, const Transition& transition, Children& children,
                 Innovation& out) noexcept {
    const Scalar duration = model_.block().elapsed();
    model_.predict(child.star);
    if (transition.zeroed) model_.zero(child.star);
    if (!transition.swings) child.swing.end(child.star);
    if (parent.mode == Mode::Pouring && child.mode != Mode::Pouring) child.pour.end(child.star);
    if (child.mode == Mode::Empty || child.mode == Mode::Disturbed) decide(child, child.star);
    if (child.mode == Mode::Empty) child.undecided.let_go();
    if (transition.anew || child.mode == Mode::Changing) child.undecided.change();
    if (child.mode == Mode::Pouring && parent.mode != Mode::Pouring) child.undecided.pour();
    if (child.mode == Mode::Disturbed) {
      if (parent.mode != Mode::Disturbed || parent.how == Disturbing::Jolt)
        child.disturbance.begin(rated_);
      else
        child.disturbance.predict(child.how, duration, rated_);
      return child.disturbance.observe(model_, child.star, child.how, log_jolt(), rated_, out.squared);
    }
    if (transition.turned) return turn(child, parent, children, out);
    if (child.mode == Mode::Changing) {
      if (model_.kind().draws) {
        Tale& drawn = children.drawn();
        drawn.star = child.star;
        drawn.mode = Mode::Held;
        const auto load = draw(drawn, children.first(), out);
        const Scalar log_likelihood = update(drawn, load, out);
        decide(child, drawn.star);
        return log_likelihood + log_plausible(drawn.star, kLightest);
      }
      Star star = child.star;
      Disturbance<Scalar, Dofs> anything;
      anything.begin(rated_);
      return anything.observe(model_, star, Disturbing::Hand, kNone, rated_, out.squared);
    }
    if (transition.never) {
      // docs/theory.md (T51)
      const Scalar log_likelihood = child.star.payload_is_none() - *parent.log_none - parent.log_plausible;
      child.payload = 0;
      child.log_plausible = Scalar(0);
      child.log_none.reset();
      return log_likelihood + update(child, out);
    }
    if (child.mode == Mode::Empty) {
      child.log_none.reset();
      if (parent.payload != 0) model_.unload(child.star, parent.star.payload_mean(), parent.held_for);
      child.star.forget_payload();
      child.payload = 0;
      child.log_plausible = Scalar(0);
      return update(child, out);
    }
    Scalar log_likelihood = Scalar(0);
    std::optional<Load<Scalar, Dofs>> load;  // if it differs from what the child says before the block
    if (child.mode == Mode::Pouring) {
      if (parent.mode != Mode::Pouring) {
        if (child.payload == 0 && !model_.exchange_likely())  // if the host says so, it begins now
          child.pour.suppose_hidden(model_, child.star, payload_);
        child.log_none.reset();
        const PourKind held = child.payload == 0 ? PourKind::TakenUp : PourKind::More;
        child.pour.begin(child.star, payload_, rated_, child.quick ? PourKind::Quick : held);
        if (child.payload == 0) {
          child.payload = child.take_next();
          child.held_for = Scalar(0);
        }
      }
      child.pour.predict(child.star, duration, payload_, rated_);
    } else if (transition.anew) {
      if (transition.late) {
        Eigen::Matrix<Scalar, kArmShared, 1> lag = Eigen::Matrix<Scalar, kArmShared, 1>::Zero();
        lag[kLag] = Scalar(Transitions::kLate * Transitions::kLate);
        child.star.widen_arm(lag);
      }
      child.payload = child.take_next();
      child.log_plausible = Scalar(0);
      child.held_for = Scalar(0);
      if (transition.gains) child.star.widen_nuisance(kGain, Scalar(Transitions::kOffGain * Transitions::kOffGain));
      load = draw(child, children.first(), out);
      if (transition.swings) begin_swing(child, children.first().star, true, Vector4<Scalar>::Zero());
    } else if (transition.swings && parent.star.swings()) {
      child.swing.predict(child.star, duration);
    } else if (transition.swings) {  // so it may have swung before, unnoticed; or somebody leads the arm
      child.star.widen_payload(Swing<Scalar, Dofs>::hidden(child.held_for));
      begin_swing(child, child.star, false,
                  Swing<Scalar, Dofs>::led(child.held_for, weight(child.star) / norm(model_.gravity())));
      child.swing.predict(child.star, duration);
    }
    child.held_for += duration;
    log_likelihood += load ? update(child, *load, out) : update(child, out);
    decide(child, child.star);
    if (transition.swings) child.swing.learn(child.star, duration, weight(child.star));
    // What is poured begins with nothing. It may be as light as it likes, but not lighter than that.
    const Scalar plausible = log_plausible(child.star, child.mode == Mode::Pouring ? 0 : kLightest);
    log_likelihood += plausible - child.log_plausible;
    child.log_plausible = plausible;
    return log_likelihood;
  }

 private:
  static Scalar norm(const Vector3<Scalar>& v) noexcept { return std::sqrt(detail::dot(v, v)); }
  /// The weight of the payload [N], of one that an arm like this one may hold.
  Scalar weight(const Star& star) const noexcept {
    return norm(model_.gravity()) * std::max(Scalar(kLightestSwing) * rated_, std::min(rated_, star.mass()));
  }
  /// Counts the block in what is undecided.
  /// @param shown  has what the block shows to be held
  void decide(Tale& story, const Star& shown) noexcept {
    story.undecided.update(story.star.mass(), shown.mass(), model_.block().elapsed(), model_.risen(),
                           norm(model_.gravity()), model_.exchange_likely());
  }
  /// What is held swings from now on.
  /// @param shown  has its mass
  /// @param goes   as in Swing
  /// @param led    as in Swing
  void begin_swing(Tale& story, const Star& shown, bool goes, const Vector4<Scalar>& led) noexcept {
    story.log_none.reset();  // without the payload, nothing would swing
    story.swing.begin(story.star, weight(shown), goes, led);
  }
  /// What was taken for a wrench has been a weight all along. The blocks since it began are as likely as with the
  /// wrench, times how much better or worse a payload explains what is known of the wrench.
  template <typename Children>
  Scalar turn(Tale& child, const Tale& parent, Children& children, Innovation& out) noexcept {
    Tale& wrench = children.drawn();
    wrench.star = child.star;
    wrench.disturbance = parent.disturbance;
    wrench.disturbance.predict(parent.how, model_.block().elapsed(), rated_);
    Scalar log_likelihood =
        wrench.disturbance.observe(model_, wrench.star, parent.how, log_jolt(), rated_, out.squared);
    log_likelihood += wrench.disturbance.weigh(model_, child.star, payload_, rated_);
    child.payload = child.take_next();
    child.held_for = Scalar(0);
    const auto load = draw(child, children.first(), out);
    child.log_none.reset();  // the blocks before were a wrench's
    (void)update(child, load, out);
    child.log_plausible = log_plausible(child.star, kLightest);
    return log_likelihood + child.log_plausible;
  }

  /// Log probability that a jolt hides a disturbance in a block.
  Scalar log_jolt() const noexcept { return static_cast<Scalar>(std::log(model_.kind().jolt)); }

  static constexpr Scalar kNone = -std::numeric_limits<Scalar>::infinity();
  static constexpr double kLightestSwing = 0.02;               // mass that may swing, per rated payload
  static constexpr double kLightest = 0.007, kHeaviest = 1.2;  // times the rated payload: 20 g and 3.6 kg on a Panda

  /// Draws a new payload. The prior of m r needs the mass, and the block itself shows the mass best. So the prior is
  /// for the mass that the block shows.
  /// @return what the joints bear then, as far as the block shows it
  Load<Scalar, Dofs> draw(Tale& child, Tale& first, Innovation& out) noexcept {
    child.star.forget_payload();
    first.star = child.star;
    first.star.draw_payload(payload_.mean(), payload_.factor(payload_.square_mass()));
    first.mode = Mode::Held;
    (void)update(first, out);
    const Scalar mass = std::max(Scalar(0.02) * rated_, std::min(rated_, first.star.mass()));
    const Scalar square = mass * mass + first.star.mass_variance();
    const InertialVector<Scalar> mean = payload_.mean();
    const InertialMatrix<Scalar> factor = payload_.factor(square);
    child.star.draw_payload(mean, factor);
    Scalar log_none = Scalar(0);
    InertialVector<Scalar> white;  // factor^-1 mean
    for (int i = 0; i < kInertial; ++i) {
      white[i] = mean[i];
      for (int k = 0; k < i; ++k) white[i] -= factor(i, k) * white[k];
      white[i] /= factor(i, i);
      log_none -= Scalar(0.5) * white[i] * white[i] + std::log(factor(i, i));
    }
    child.log_none = log_none;
    return model_.load(first.star);
  }

  /// Updates a story's filter with the block, joint by joint.
  /// @return log p(block | story) [nats], without the constant factor of 2 pi
  Scalar update(Tale& story, Innovation& out) noexcept { return update(story, model_.load(story.star), out); }
  Scalar update(Tale& story, const Load<Scalar, Dofs>& load, Innovation& out) noexcept {
    using std::abs;
    using std::exp;
    using std::log;
    Star& star = story.star;
    Scalar log_likelihood = Scalar(0);
    out.squared = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      auto p = star.predict(j, model_.observation(j, load, star.swings()));
      const Scalar square = p.innovation * p.innovation;
      const auto log_density = [this, square](Scalar v) { return this->log_density(square, v); };
      if (const Scalar jump = model_.stiction_jump(star, j); jump > 0) {  // a mixture of both
        const Scalar stays = log_density(p.variance), jumps = log_density(p.variance + jump);
        const Scalar share = Scalar(1) / (Scalar(1) + exp(stays - jumps));
        log_likelihood += std::max(stays, jumps) + log(Scalar(1) + exp(-abs(stays - jumps)));
        star.joint(j).covariance(kStiction, kStiction) += share * jump;
        p = star.predict(j, model_.observation(j, load, star.swings()));
      } else {
        log_likelihood += log_density(p.variance);
      }
      out.squared += square / p.variance;
      out.innovation[j] = p.innovation;
      out.variance[j] = p.variance;
      if (story.mode == Mode::Pouring) story.pour.observe(star, p);
      if (star.swings()) story.swing.observe(star, p);
      star.observe(j, p);
    }
    return log_likelihood;
  }

  /// Log density of an innovation [nats], without the constant factor of 2 pi (docs/theory.md (T68)). What the model of
  /// an arm misses is not Gaussian: with Gaussian weights, single blocks decide what is held.
  Scalar log_density(Scalar square, Scalar variance) const noexcept {
    using std::log;
    if (!(tails_ > 0)) return Scalar(-0.5) * (square / variance + log(variance));
    return log_tails_ - Scalar(0.5) * ((tails_ + 1) * log(1 + square / (tails_ * variance)) + log(variance));
  }
  /// Log probability that the mass is plausible: neither indistinguishable from zero nor too large for the arm.
  /// @param lightest  mass that counts as nothing, per rated payload
  Scalar log_plausible(const Star& star, double lightest) const noexcept {
    using std::erfc;
    using std::log;
    using std::sqrt;
    const Scalar deviation = sqrt(std::max(star.mass_variance(), Scalar(1e-12)));
    const auto below = [&](Scalar m) { return Scalar(0.5) * erfc((star.mass() - m) / (deviation * sqrt(Scalar(2)))); };
    return log(std::max(Scalar(1e-30), below(Scalar(kHeaviest) * rated_) - below(Scalar(lightest) * rated_)));
  }

  Model model_;
  PayloadPrior<Scalar> payload_;
  Scalar rated_, tails_, log_tails_;
};

}  // namespace rme
