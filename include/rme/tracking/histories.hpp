#pragma once
/// A handful of weighted stories of what has happened to the hand, for one kind of torque sensing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <limits>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/joint_torque_model.hpp>
#include <rme/tracking/mode.hpp>
#include <rme/tracking/payload_belief.hpp>
#include <rme/tracking/story.hpp>
#include <rme/tracking/story_children.hpp>
#include <rme/tracking/story_filter.hpp>
#include <rme/tracking/torque_block.hpp>
#include <rme/tracking/transitions.hpp>

namespace rme {

/// Weighted stories (docs/theory.md, "Stories"). After each block each story has children: it goes on, or something
/// begins, or something ends. The weight of a child is its parent's weight, times the probability of the transition,
/// times the likelihood of the block. The heaviest stories live on; those that say the same but for when it began are
/// added up. Nothing is averaged into one state.
///
/// For each block, call begin(), then advance() until it returns true. Results change only then. Real time: no call
/// allocates; each advance() computes one child, some 10,000 multiplications for seven joints.
template <typename Scalar, int Dofs, int Capacity = 7>
class Histories {
 public:
  using Star = StarGaussian<Scalar, Dofs>;                 ///< state of a filter
  using Tale = Story<Scalar, Dofs>;                        ///< a story
  using Children = StoryChildren<Scalar, Dofs, Capacity>;  ///< of a block

  /// At first the hand is empty, or something is already held, or the arm is not as stated: its base is tilted, or its
  /// sensors are off. Parameters as in Tracker; `kind` is the row of the kind assumed.
  Histories(const SensingKind& kind, const ArmPrior<Scalar, Dofs>& arm, const PayloadPrior<Scalar>& payload,
            Scalar rated_payload, const Vector3<Scalar>& gravity) noexcept
      : filter_(kind, arm, payload, rated_payload, gravity) {
    using std::log;
    Tale& empty = told(0);
    empty.star = filter_.model().prior();
    empty.log_weight = log(Scalar(1) - Scalar(kHeldAtStart) - Scalar(kOffAtStart) - Scalar(kTiltedAtStart));
    told(1) = empty;
    Tale& holds = told(1);
    holds.mode = Mode::Changing;
    holds.log_weight = log(Scalar(kHeldAtStart));
    told(2) = empty;
    Tale& off = told(2);
    off.log_weight = log(Scalar(kOffAtStart));
    for (int j = 0; j < Dofs; ++j) off.star.joint(j).covariance(kOffset, kOffset) *= Scalar(kOff * kOff);
    told(3) = empty;
    Tale& tilted = told(3);
    tilted.tilted = true;
    tilted.log_weight = log(Scalar(kTiltedAtStart));
    count_ = 4;
  }

  /// Starts a block.
  /// @param block     the next block
  /// @param regime    which joints rest in it
  /// @param context   what else is known of it
  /// @param children  where the block's children are kept until it ends; nothing else may use it until then
  void begin(const TorqueBlock<Scalar, Dofs>& block, const FrictionRegime<Scalar, Dofs>& regime,
             const BlockContext<Scalar, Dofs>& context, Children& children) noexcept {
    work_ = &children;
    begin_model(block, regime, context);
    exchange_likely_ = context.exchange_likely;
    log_share_ = context.log_share;
    int heaviest = 0;
    for (int i = 1; i < count_; ++i)
      if (told(i).log_weight > told(heaviest).log_weight) heaviest = i;
    heaviest_ = told(heaviest).log_weight;
    swings_ = told(heaviest).star.swings();
    settled_ = -1;
    for (int i = 0; i < count_; ++i)
      if (told(i).settled() && (settled_ < 0 || told(i).log_weight > told(settled_).log_weight)) settled_ = i;
    settled_payload_ = -1;
    ++blocks_;
    children_ = 0;
    evidence_ = fresh_weight_ = Scalar(-1e30);
    explained_ = jolted_ = false;
    goes_on_weight_ = jolt_weight_ = Scalar(-1e30);
    settled_squared_ = Scalar(0);
    enter(Phase::Settled);
  }
  /// Computes the next child of the block, or ends the block.
  /// @param children  as in begin()
  /// @return whether the block is finished
  bool advance(Children& children) noexcept {
    work_ = &children;
    if (done_ < planned_) {
      compute(plans_[at(done_++)]);
      return false;
    }
    switch (phase_) {
      case Phase::Settled:
        enter(Phase::Shaken);
        return false;
      case Phase::Shaken:
        jolted_ = jolt_weight_ > goes_on_weight_;
        enter(Phase::GoesOn);
        return false;
      case Phase::GoesOn:
        explained_ = explained();
        enter(Phase::Begins);
        if (planned_ > 0) return false;
        break;
      case Phase::Begins:
        break;
    }
    finish();
    return true;
  }

  int count() const noexcept { return count_; }                ///< number of stories
  const Tale& story(int i) const noexcept { return told(i); }  ///< from 0 to count() - 1, the heaviest first
  Scalar weight(int i) const noexcept {                        ///< probability of story(i)
    using std::exp;
    return exp(story(i).log_weight);
  }
  /// The payload of story(i), given what it says of the last block. While something changes, that is the payload which
  /// this block alone shows, unless the torque is too rough for one block to show anything. While something pours, it
  /// is that of the middle of the next block, for which the host carries it.
  InertialGaussian<Scalar> payload(int i) const noexcept {
    if (story(i).mode == Mode::Pouring) return story(i).pour.payload_after(story(i).star, model().block().duration);
    return story(i).mode == Mode::Changing && model().kind().draws ? fresh_ : payload_in(story(i).star);
  }
  /// Whether story(i) says that something is held.
  bool holds(int i) const noexcept {
    return story(i).payload != 0 || (story(i).mode == Mode::Changing && model().kind().draws);
  }
  /// log p(last block | all blocks before) [nats], up to a constant that all kinds share.
  Scalar evidence() const noexcept { return evidence_; }
  /// e^T S^-1 e per joint in the last block, of the likeliest story, with what its payload and the arm explain. 1 on
  /// average if the torque is as the model predicts it (docs/theory.md (T30)).
  Scalar innovation_squared() const noexcept { return innovation_squared_; }
  const JointTorqueModel<Scalar, Dofs>& model() const noexcept { return filter_.model(); }  ///< of the arm

  /// Probability that something is poured, or that something else acts on the arm, of this kind's stories. What begins
  /// to swing long after it was picked up may be led by a hand.
  Scalar disturbed() const noexcept {
    Scalar sum = Scalar(0);
    for (int i = 0; i < count_; ++i) {
      const bool swings = told(i).star.swings() && Swing<Scalar, Dofs>::may_be_led(told(i).held_for);
      if (told(i).mode == Mode::Disturbed || told(i).mode == Mode::Pouring || swings) sum += weight(i);
    }
    return std::min(Scalar(1), sum);
  }
  /// The host says that the hand is empty: that becomes a story of the given probability.
  void believe_empty(Scalar probability) noexcept {
    Tale story = told(0);
    story.settle();
    story.undecided = {};
    story.star.forget_payload();
    add(story, Mode::Empty, 0, probability);
  }
  /// The host says that the hand holds phi ~ N(mean, factor factor^T): that becomes a story of the given probability.
  void believe_held(const InertialVector<Scalar>& mean, const InertialMatrix<Scalar>& factor,
                    Scalar probability) noexcept {
    Tale story = told(0);
    story.settle();
    story.undecided = {};
    story.star.draw_payload(mean, factor);
    story.held_for = std::numeric_limits<Scalar>::max();  // no swing has been taken for weight
    const int payload = story.take_next();
    add(story, Mode::Held, payload, probability);
  }
  /// The host says that what is held belongs to the tool: the hand is empty in every story.
  /// @param variance  added to that of what belongs to the arm, in the order of Shared
  void tare(const Eigen::Matrix<Scalar, kArmShared, 1>& variance) noexcept {
    Tale story = told(0);
    story.settle();
    story.undecided = {};
    story.star.payload_is_tool();
    story.star.widen_arm(variance);
    count_ = 0;  // a story in which it is still held, known well, would win against a tool that is known less well
    add(story, Mode::Empty, 0, Scalar(1));
  }
  /// Adds the offsets' prior variances to their variances.
  void reopen_offsets() noexcept {
    for (int i = 0; i < count_; ++i) filter_.model().reopen_offset(told(i).star);
  }

 private:
  using Innovation = typename StoryFilter<Scalar, Dofs>::Innovation;
  /// A child that is to be computed.
  struct Plan {
    int parent;
    Transition transition;
    Scalar log_probability;
  };
  /// The children of a block are computed in this order.
  enum class Phase : std::uint8_t {
    Settled,  ///< the likeliest settled story goes on
    Shaken,   ///< or single joints are shaken, if that story explains the block badly
    GoesOn,   ///< the other stories go on; if the first was shaken, all of the same arm are: none takes in such a block
    Begins,   ///< something begins or ends
  };
  static constexpr double kUnlikely = -11;      // log probability of a kind below which less is computed for it
  static constexpr double kShallow = 2;         // [nats]
  static constexpr double kSurprise = 2;        // innovation squared per joint from which a block is explained badly
  static constexpr double kHeldAtStart = 0.03;  // probability that something is held at the start

  static constexpr double kOffAtStart = 0.001;    // probability that the arm's torques are off by more than stated
  static constexpr double kOff = 30;              // how much more, times the stated offset
  static constexpr double kTiltedAtStart = 0.05;  // probability that the base is tilted
  static constexpr double kTilted = 0.04;         // by how much, about either axis [rad]
  // The same of the heaviest story in which nothing swings, if the force of a swing explains the blocks so far better
  // [nats].
  static constexpr double kSwingDepth = 40;
  static constexpr double kPourDepth = 8;  // log odds at which a pour is given up while nothing happens [nats]
  static constexpr int kPlans = Transitions::kMost * Capacity;

  static constexpr std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }

  /// Log odds at which a story is given up, over all kinds: early if the arm is unlikely to have this one.
  /// @param outlasts  nothing swings in it, but in the heaviest
  Scalar depth(bool outlasts) const noexcept {
    const double depth = outlasts ? kSwingDepth : model().kind().depth;
    return std::max(Scalar(kShallow), static_cast<Scalar>(depth) + log_share_);
  }
  /// Begins a phase of the block: plans its children.
  void enter(Phase phase) noexcept {
    phase_ = phase;
    planned_ = done_ = 0;
    for (int i = 0; i < count_; ++i)
      Transitions::each(told(i), model().kind(), blocks_, explained_, exchange_likely_,
                        [&](const Transition& t) { plan(i, t); });
  }
  /// Whether a child is to be computed in this phase.
  bool due(int i, const Transition& t) const noexcept {
    const bool settled = told(i).settled();
    const bool jolt = t.mode == Mode::Disturbed && t.how == Disturbing::Jolt;
    const bool jolted = jolted_ && settled && told(i).tilted == told(settled_).tilted;
    const bool shaken = settled && jolt && (jolted || (i == settled_ && settled_squared_ > Scalar(kSurprise)));
    switch (phase_) {
      case Phase::Settled:
        return i == settled_ && t.goes_on;
      case Phase::Shaken:
        return i == settled_ && shaken;
      case Phase::GoesOn:
        return i != settled_ && (jolted ? jolt : t.goes_on);
      case Phase::Begins:
        break;
    }
    return !t.goes_on && !shaken;
  }
  void plan(int i, const Transition& t) noexcept {
    using std::log;
    if (!due(i, t) || planned_ == kPlans) return;
    const Tale& parent = told(i);
    const bool exchange = t.mode == Mode::Changing || t.anew || (t.quick && parent.mode != Mode::Pouring) ||
                          (t.mode == Mode::Empty && parent.mode == Mode::Held && !t.never);
    auto log_probability = static_cast<Scalar>(log(t.probability));
    if (exchange_likely_ && parent.settled()) {  // as much as everything else together
      const double all = model().kind().change * (2 + (parent.mode == Mode::Held ? 2 : 1) * Transitions::kAtOnce);
      log_probability += static_cast<Scalar>(log(exchange ? 0.5 / all : 0.5));
    }
    if (parent.log_weight + log_probability < heaviest_ - depth(swings_ && !t.swings)) return;
    plans_[at(planned_++)] = {i, t, log_probability};
  }

  /// Whether one story in which nothing happens explains the block.
  bool explained() const noexcept {
    using std::exp;
    if (exchange_likely_ || children_ == 0) return false;
    Scalar sum = Scalar(0);
    int best = 0;
    for (int i = 0; i < children_; ++i) {
      sum += exp(next(i).log_weight - best_child_);
      if (next(i).log_weight > next(best).log_weight) best = i;
    }
    const Scalar quiet = static_cast<Scalar>(log_share_ > Scalar(kUnlikely) ? model().kind().quiet : 1.5);
    return exp(next(best).log_weight - best_child_) > Scalar(0.9) * sum && next(best).settled() &&
           squared_[at(best)] < quiet;
  }

  static InertialGaussian<Scalar> payload_in(const Star& star) noexcept {
    return {star.payload_mean(), star.payload_covariance()};
  }
  /// Begins a block in the model of the arm. With the arm's gravity torque from the host, each story has the tilt of a
  /// levelled base, and finds more if there is more; without, one story alone has a tilt.
  void begin_model(const TorqueBlock<Scalar, Dofs>& block, const FrictionRegime<Scalar, Dofs>& regime,
                   const BlockContext<Scalar, Dofs>& context) noexcept {
    const bool known = block.gravity_torque.has_value(), first = blocks_ == 0;
    bool tilts = known;
    for (int i = 0; i < count_; ++i) {
      if (first && known) told(i).tilted = false;
      if (first && !known) told(i).star.set_tilt(Scalar(0));
      tilts = tilts || told(i).tilted;
    }
    filter_.model().begin(block, regime, context, tilts);
    for (int i = 0; i < count_; ++i)
      if (first && told(i).tilted) filter_.model().tilt(told(i).star, Scalar(kTilted));
  }
  Tale& told(int i) noexcept { return told_[at(i)]; }
  const Tale& told(int i) const noexcept { return told_[at(i)]; }
  Tale& next(int i) noexcept { return work_->kept(i); }
  const Tale& next(int i) const noexcept { return work_->kept(i); }

  /// Computes a child, and keeps it if it is among the heaviest.
  void compute(const Plan& plan) noexcept {
    using std::exp;
    using std::log;
    const Tale& parent = told(plan.parent);
    const Transition& transition = plan.transition;
    Tale& child = work_->computed();
    child = parent;
    child.mode = transition.mode;
    child.how = transition.how;
    child.quick = transition.quick;
    Innovation innovation;
    const Scalar log_likelihood = filter_.take_in(child, parent, transition, *work_, innovation);
    if (child.mode == Mode::Changing && model().kind().draws && child.log_weight + log_likelihood > fresh_weight_) {
      fresh_weight_ = child.log_weight + log_likelihood;
      fresh_ = payload_in(work_->drawn().star);
    }
    if (!std::isfinite(log_likelihood) || !child.star.finite()) return;
    child.log_weight += plan.log_probability + log_likelihood;
    if (children_ == 0) best_child_ = child.log_weight;
    best_child_ = std::max(best_child_, child.log_weight);
    evidence_ = evidence_ > child.log_weight ? evidence_ + log(1 + exp(child.log_weight - evidence_))
                                             : child.log_weight + log(1 + exp(evidence_ - child.log_weight));
    if (phase_ == Phase::Settled) goes_on_weight_ = child.log_weight;
    if (phase_ == Phase::Shaken) jolt_weight_ = child.log_weight;
    if (plan.parent == settled_ && transition.goes_on) {
      settled_payload_ = child.mode == Mode::Pouring ? -1 : child.payload;
      settled_innovation_ = innovation;
      settled_squared_ = innovation.squared / Scalar(Dofs);
    }
    int place = -1;
    const bool unlikely = child.tilted != told(0).tilted;
    for (int i = 0; i < children_ && place < 0; ++i) {
      const bool same = next(i).same(child), heavier = next(i).log_weight > child.log_weight;
      if (same) {
        const Scalar high = std::max(next(i).log_weight, child.log_weight);
        const Scalar sum = high + log(exp(next(i).log_weight - high) + exp(child.log_weight - high));
        (heavier ? next(i) : child).log_weight = sum;
      }
      // Of an arm that is not the likeliest story's, the heaviest story lives on alone.
      if (!same && !(unlikely && next(i).tilted == child.tilted)) continue;
      if (heavier) return;
      place = i;
    }
    if (place < 0 && children_ < Capacity) place = children_++;
    if (place < 0) {
      int rigid = -1;  // the heaviest in which nothing swings stays
      for (int i = 0; i < children_; ++i)
        if (!next(i).star.swings() && (rigid < 0 || next(i).log_weight > next(rigid).log_weight)) rigid = i;
      const bool stays =
          !child.star.swings() && (rigid < 0 || child.log_weight > next(rigid).log_weight);  // or it is the child
      for (int i = 0; i < children_; ++i)
        if ((stays || i != rigid) && (place < 0 || next(i).log_weight < next(place).log_weight)) place = i;
      if (!stays && next(place).log_weight > child.log_weight) return;
    }
    work_->keep(place);
    squared_[at(place)] = innovation.squared / Scalar(Dofs);
  }

  /// Ends a block: keeps the heaviest children, and learns noise and residual if nothing happened.
  void finish() noexcept {
    using std::exp;
    using std::log;
    if (children_ == 0) {
      evidence_ = Scalar(0);
      return;
    }
    std::array<int, at(Capacity)> order{};  // by weight, the heaviest first: inserted one by one, they are few
    for (int i = 0; i < children_; ++i) {
      int place = i;
      for (; place > 0 && next(order[at(place - 1)]).log_weight < next(i).log_weight; --place)
        order[at(place)] = order[at(place - 1)];
      order[at(place)] = i;
    }
    const bool settled = next(order[0]).mode != Mode::Disturbed && settled_squared_ > 0;
    innovation_squared_ = settled ? settled_squared_ : squared_[at(order[0])];
    Scalar total = Scalar(0);
    const Scalar best = next(order[0]).log_weight;
    bool outlasts = next(order[0]).star.swings();  // the next story in which nothing swings
    count_ = 0;
    for (int i = 0; i < children_; ++i) {
      const Tale& child = next(order[at(i)]);
      Scalar depth = explained_ && child.mode == Mode::Pouring ? Scalar(kPourDepth) : this->depth(false);
      if (outlasts && !child.star.swings()) {
        depth = this->depth(true);
        outlasts = false;
      }
      if (child.log_weight < best - depth) continue;
      told(count_) = child;
      total += exp(told(count_).log_weight - best);
      ++count_;
    }
    const Scalar sum = best + log(total);
    for (int i = 0; i < count_; ++i) told(i).log_weight -= sum;
    // Noise and residual are learned while nothing happens, whichever payload is held.
    Scalar nothing = Scalar(0);
    for (int i = 0; i < count_; ++i)
      if (told(i).mode == Mode::Empty || told(i).mode == Mode::Held) nothing += weight(i);
    if (nothing > Scalar(0.5) && settled_payload_ >= 0)
      filter_.model().learn(settled_payload_, settled_innovation_.innovation, settled_innovation_.variance);
    else
      filter_.model().interrupt();
  }

  void add(const Tale& like, Mode mode, int payload, Scalar probability) noexcept {
    using std::log;
    Tale story = like;
    story.mode = mode;
    story.payload = payload;
    story.log_plausible = Scalar(0);
    story.log_none.reset();
    story.log_weight = log(probability);
    count_ = std::min(count_, Capacity - 1);
    for (int i = count_; i > 0; --i) told(i) = told(i - 1);
    told(0) = story;
    ++count_;
    for (int i = 1; i < count_; ++i) told(i).log_weight += log(Scalar(1) - probability);
  }

  StoryFilter<Scalar, Dofs> filter_;
  std::array<Tale, at(Capacity)> told_;
  Children* work_ = nullptr;        // of the present call
  InertialGaussian<Scalar> fresh_;  // a payload drawn from the last block alone, of the likeliest change
  Scalar fresh_weight_ = Scalar(0);
  int count_ = 0, children_ = 0;
  std::array<Plan, at(kPlans)> plans_;
  int planned_ = 0, done_ = 0;
  int settled_ = -1;          // the likeliest story before the block in which a payload, or none, explains the torque
  int settled_payload_ = -1;  // what it holds, if it goes on in this block
  long blocks_ = 0;
  Phase phase_ = Phase::Begins;
  bool explained_ = false, jolted_ = false, exchange_likely_ = false;
  bool swings_ = false;           // something swings in the heaviest story before the block
  Scalar log_share_ = Scalar(0);  // log probability of the kind
  Scalar goes_on_weight_ = Scalar(0), jolt_weight_ = Scalar(0);
  Scalar heaviest_ = Scalar(0), best_child_ = Scalar(0), evidence_ = Scalar(0), innovation_squared_ = Scalar(1);
  Scalar settled_squared_ = Scalar(0);        // of settled_'s story, if it goes on in this block
  std::array<Scalar, at(Capacity)> squared_;  // e^T S^-1 e per joint of each kept child
  Innovation settled_innovation_;             // of settled_'s story, if it goes on in this block
};

}  // namespace rme
