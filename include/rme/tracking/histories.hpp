#pragma once
/// A handful of weighted stories of what has happened to the hand, for one kind of torque sensing.
#include <algorithm>
#include <array>
#include <cmath>
#include <cstddef>
#include <cstdint>
#include <rme/core/small_matrix.hpp>
#include <rme/core/types.hpp>
#include <rme/tracking/arm_prior.hpp>
#include <rme/tracking/friction_regime.hpp>
#include <rme/tracking/joint_torque_model.hpp>
#include <rme/tracking/mode.hpp>
#include <rme/tracking/payload_belief.hpp>
#include <rme/tracking/story.hpp>
#include <rme/tracking/torque_block.hpp>
#include <utility>

namespace rme {

/// The children that stories have in a block, and those that are being computed. Several Histories may use the same, one
/// after the other.
template <typename Scalar, int Dofs, int Capacity>
class StoryChildren {
 public:
  /// @param i  0 to Capacity - 1: kept so far; then three that are being computed
  Story<Scalar, Dofs>& child(int i) noexcept { return slots_[at(slot_[at(i)])]; }
  const Story<Scalar, Dofs>& child(int i) const noexcept { return slots_[at(slot_[at(i)])]; }  ///< the same
  void exchange(int i, int j) noexcept { std::swap(slot_[at(i)], slot_[at(j)]); }              ///< children i and j

  StoryChildren() noexcept {
    for (int i = 0; i < kSlots; ++i) slot_[at(i)] = i;
  }

 private:
  static constexpr std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }
  static constexpr int kSlots = Capacity + 3;
  std::array<Story<Scalar, Dofs>, at(kSlots)> slots_;
  std::array<int, at(kSlots)> slot_{};
};

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
  using Torque = JointVector<Scalar, Dofs>;                ///< one number per joint

  /// At first the hand is empty, or something is already held. Parameters as in Tracker; `kind` is the row of the
  /// kind assumed.
  Histories(const SensingKind& kind, const ArmPrior<Scalar, Dofs>& arm, const PayloadPrior<Scalar>& payload,
            Scalar rated_payload, const Vector3<Scalar>& gravity) noexcept
      : model_(kind, arm, rated_payload,
               detail::dot(payload.com_mean, payload.com_mean) + detail::dot(payload.com_std, payload.com_std),
               gravity),
        payload_(payload),
        rated_(rated_payload) {
    using std::log;
    Tale& empty = told(0);
    empty.star = model_.prior();
    empty.log_weight = log(Scalar(1) - Scalar(kHeldAtStart));
    told(1) = empty;
    Tale& holds = told(1);
    holds.mode = Mode::Changing;
    holds.log_weight = log(Scalar(kHeldAtStart));
    count_ = 2;
  }

  /// Starts a block.
  /// @param block    the next block
  /// @param regime   which joints rest in it
  /// @param context  what else is known of it
  /// @param children  where the block's children are kept until it ends; nobody else may use it until then
  void begin(const TorqueBlock<Scalar, Dofs>& block, const FrictionRegime<Scalar, Dofs>& regime,
             const BlockContext<Scalar, Dofs>& context, Children& children) noexcept {
    work_ = &children;
    model_.begin(block, regime, context);
    exchange_likely_ = context.exchange_likely;
    share_ = context.log_share;
    heaviest_ = Scalar(-1e30);
    for (int i = 0; i < count_; ++i) heaviest_ = std::max(heaviest_, told(i).log_weight);
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
  /// this block alone shows, unless the torque is too rough for one block to show anything.
  InertialGaussian<Scalar> payload(int i) const noexcept {
    return story(i).mode == Mode::Changing && model_.kind().draws ? fresh_ : payload_in(story(i).star);
  }
  /// Whether story(i) says that something is held.
  bool holds(int i) const noexcept {
    return story(i).payload != 0 || (story(i).mode == Mode::Changing && model_.kind().draws);
  }
  /// log p(last block | all blocks before) [nats], up to a constant that all kinds share.
  Scalar evidence() const noexcept { return evidence_; }
  /// e^T S^-1 e per joint in the last block, of the likeliest story, with what its payload and the arm explain. 1 on average if the torque is as the model predicts it (docs/theory.md (T30)).
  Scalar innovation_squared() const noexcept { return innovation_squared_; }
  const JointTorqueModel<Scalar, Dofs>& model() const noexcept { return model_; }  ///< of the arm

  /// Probability that something is poured, or that something else acts on the arm.
  Scalar disturbed() const noexcept {
    Scalar sum = Scalar(0);
    for (int i = 0; i < count_; ++i)
      if (told(i).mode == Mode::Disturbed || told(i).mode == Mode::Pouring) sum += weight(i);
    return std::min(Scalar(1), sum);
  }
  /// The host says that the hand is empty: that becomes a story of the given probability.
  void believe_empty(Scalar probability) noexcept {
    Tale story = told(0);
    story.star.forget_payload();
    add(story, Mode::Empty, 0, probability);
  }
  /// The host says that the hand holds phi ~ N(mean, factor factor^T): that becomes a story of the given probability.
  void believe_held(const InertialVector<Scalar>& mean, const InertialMatrix<Scalar>& factor,
                    Scalar probability) noexcept {
    Tale story = told(0);
    story.star.draw_payload(mean, factor);
    const int payload = story.take_next();
    add(story, Mode::Held, payload, probability);
  }
  /// The host says that what is held belongs to the tool: the hand is empty in every story.
  /// @param variance  added to that of what belongs to the arm, in the order of Shared
  void tare(const Eigen::Matrix<Scalar, kArmShared, 1>& variance) noexcept {
    Tale story = told(0);
    story.star.payload_is_tool();
    story.star.widen_arm(variance);
    count_ = 0;  // a story in which it is still held, known well, would win against a tool that is known less well
    add(story, Mode::Empty, 0, Scalar(1));
  }
  /// Adds the offsets' prior variances to their variances.
  void reopen_offsets() noexcept {
    for (int i = 0; i < count_; ++i) model_.reopen_offset(told(i).star);
  }

 private:
  /// A child that is to be computed.
  struct Plan {
    int parent;
    Mode mode;
    Disturbing how;
    bool anew, quick, late;
    Scalar log_transition;
  };
  /// The children of a block are computed in this order.
  enum class Phase : std::uint8_t {
    Settled,  ///< the likeliest settled story goes on
    Shaken,   ///< or single joints are shaken, if that story explains the block badly
    GoesOn,   ///< the other stories go on; if the first was shaken, all are: no other takes in such a block
    Begins,   ///< something begins or ends
  };
  static constexpr double kUnlikely = -11;      // log probability of a kind below which less is computed for it
  static constexpr double kShallow = 2;         // [nats]
  static constexpr double kSurprise = 2;        // innovation squared per joint from which a block is explained badly
  static constexpr double kHeldAtStart = 0.03;  // probability that something is held at the start

 public:
  /// @cond for the tests: docs/theory.md, "Numbers", has them
  // Probabilities per block. What begins:
  static constexpr double kDisturbs = 1e-3, kPours = 6e-4, kFills = 1.2e-4;
  // What ends: a pour; a change, in a new payload or an empty hand; a disturbance; a jolt.
  static constexpr double kPourEnds = 4e-3, kSettles = 0.25, kEmpties = 0.1, kDisturbEnds = 0.02, kJoltEnds = 0.25;
  static constexpr double kTouchEnds = 0.01;  // a wrench that stays or grows along itself ends
  static constexpr double kQuickEnds = 0.03;  // what is taken up is taken up
  static constexpr double kOther = 0.02;      // a wrench changes in another way from now on
  static constexpr double kTurnsOut = 0.01;   // a disturbance turns out to be a change
  static constexpr double kJolt = 3;          // torque of a jolt, times the joint's scale [N m]
  // An observer of 50 rad/s that is in truth half or twice as fast has a lag of 20 or -10 ms.
  static constexpr double kLate = 0.015,
                          kIsLate = 0.01;  // its standard deviation [s]; how often it shows that it is wrong
                                           /// @endcond

 private:
  static constexpr double kLightest = 0.007, kHeaviest = 1.2;  // times the rated payload: 20 g and 3.6 kg on a Panda
  static constexpr double kFall = 80;           // no child falls behind by more than this in a block [nats]
  static constexpr int kEvery = 5, kOften = 5;  // a pour begins, and ends, in each of this many blocks
  static constexpr double kPourDepth = 7;       // log odds at which a pour is given up while nothing happens [nats]
  static constexpr int kPlans = 8 * Capacity;

  static constexpr std::size_t at(int i) noexcept { return static_cast<std::size_t>(i); }

  /// Log odds at which a story is given up, over all kinds: early if the arm is unlikely to have this one.
  Scalar depth() const noexcept {
    return std::max(Scalar(kShallow), static_cast<Scalar>(model_.kind().depth) + share_);
  }
  /// Begins a phase of the block: plans its children.
  void enter(Phase phase) noexcept {
    phase_ = phase;
    planned_ = done_ = 0;
    for (int i = 0; i < count_; ++i) plan(i);
  }
  /// Whether a child is to be computed in this phase.
  bool due(int i, bool goes_on, bool jolt) const noexcept {
    const bool settled = told(i).settled();
    const bool shaken = settled && jolt && (jolted_ || (i == settled_ && settled_squared_ > Scalar(kSurprise)));
    switch (phase_) {
      case Phase::Settled:
        return i == settled_ && goes_on;
      case Phase::Shaken:
        return i == settled_ && shaken;
      case Phase::GoesOn:
        return i != settled_ && (jolted_ && settled ? jolt : goes_on);
      case Phase::Begins:
        break;
    }
    return !goes_on && !shaken;
  }
  /// Plans the children of story i in the present phase.
  void plan(int i) noexcept {
    const Tale& p = told(i);
    const SensingKind& kind = model_.kind();
    const double change = kind.change, jolts = kind.jolt;
    const bool slow = blocks_ % kOften == 0, begins = blocks_ % kEvery == 0;
    switch (p.mode) {
      case Mode::Empty:
      case Mode::Held: {
        const double pours = (p.mode == Mode::Empty ? kFills : kPours) * kind.slowly;
        plan(i, p.mode, 1 - 1.3 * change - kDisturbs - jolts - pours);
        if (p.mode == Mode::Empty && kind.takes_up > 0)
          plan(i, Mode::Pouring, kind.takes_up, Disturbing::Hand, false, true);
        if (explained_) {
          if (begins) plan(i, Mode::Pouring, pours * kEvery);
          break;
        }
        plan(i, Mode::Changing, change);
        if (p.mode == Mode::Held) plan(i, Mode::Empty, 0.3 * change);
        disturb(i, jolts);
        if (begins) plan(i, Mode::Pouring, pours * kEvery);
        break;
      }
      case Mode::Pouring:
        plan(i, Mode::Pouring, 1 - (p.quick ? kQuickEnds : kPourEnds) - change - kDisturbs - jolts, Disturbing::Hand,
             false, p.quick);
        if (explained_ && !slow && !p.quick) break;
        plan(i, Mode::Held, p.quick ? kQuickEnds : explained_ ? kPourEnds * kOften : kPourEnds);
        if (explained_) break;
        plan(i, Mode::Changing, change);
        disturb(i, jolts);
        break;
      case Mode::Changing:
        plan(i, Mode::Changing, 1 - kSettles - kEmpties - kTurnsOut);
        plan(i, Mode::Disturbed, kTurnsOut);
        plan(i, Mode::Held, kSettles, Disturbing::Hand, true);
        if (kind.lag > 0 && p.star.variance(kLag) < Scalar(kLate * kLate))
          plan(i, Mode::Held, kSettles * kIsLate, Disturbing::Hand, true, false, true);
        if (p.payload != 0) plan(i, Mode::Empty, kEmpties);
        break;
      case Mode::Disturbed: {
        const bool soft = p.how == Disturbing::Growing || p.how == Disturbing::Still, jolt = p.how == Disturbing::Jolt;
        const double ends = jolt ? kJoltEnds : soft ? kTouchEnds : kDisturbEnds;
        const double turns_out = (soft ? 0.3 : 1) * kTurnsOut * std::min(1.0, change / 1e-3);
        plan(i, Mode::Disturbed, 1 - ends - turns_out - (jolt ? 0 : 2 * kOther), p.how);
        plan(i, p.payload == 0 ? Mode::Empty : Mode::Held, ends);
        plan(i, Mode::Changing, turns_out);
        if (jolt) break;
        for (const Disturbing how : {Disturbing::Hand, Disturbing::Growing, Disturbing::Still})
          if (how != p.how) plan(i, Mode::Disturbed, how == Disturbing::Hand ? kOther : kOther * kind.slowly, how);
        break;
      }
    }
  }
  void disturb(int i, double jolts) noexcept {
    plan(i, Mode::Disturbed, kDisturbs);
    plan(i, Mode::Disturbed, jolts, Disturbing::Jolt);
  }
  void plan(int i, Mode mode, double transition, Disturbing how = Disturbing::Hand, bool anew = false,
            bool quick = false, bool late = false) noexcept {
    using std::log;
    const Tale& p = told(i);
    const bool goes_on = mode == p.mode && (mode != Mode::Disturbed || how == p.how) && !anew &&
                         (mode != Mode::Pouring || quick == p.quick);
    const bool jolt = mode == Mode::Disturbed && how == Disturbing::Jolt;
    if (!due(i, goes_on, jolt) || planned_ == kPlans) return;
    const bool exchange = mode == Mode::Changing || anew;
    auto log_transition = static_cast<Scalar>(log(transition));
    if (exchange_likely_ && p.settled())
      log_transition = exchange ? log(Scalar(0.25)) : log_transition + log(Scalar(0.5));
    if (p.log_weight + log_transition < heaviest_ - depth()) return;
    plans_[at(planned_++)] = {i, mode, how, anew, quick, late, log_transition};
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
    const Scalar quiet = static_cast<Scalar>(share_ > Scalar(kUnlikely) ? model_.kind().quiet : 1.5);
    return exp(next(best).log_weight - best_child_) > Scalar(0.9) * sum && next(best).settled() &&
           squared_[at(best)] < quiet;
  }

  static InertialGaussian<Scalar> payload_in(const Star& star) noexcept {
    return {star.payload_mean(), star.payload_covariance()};
  }
  Tale& told(int i) noexcept { return told_[at(i)]; }
  const Tale& told(int i) const noexcept { return told_[at(i)]; }
  Tale& next(int i) noexcept { return work_->child(i); }
  const Tale& next(int i) const noexcept { return work_->child(i); }

  /// Computes a child, and keeps it if it is among the heaviest.
  void compute(const Plan& plan) noexcept {
    using std::exp;
    using std::log;
    const Tale& parent = told(plan.parent);
    Tale& child = next(Capacity);  // computed here, then moved to its place
    child = parent;
    child.mode = plan.mode;
    child.how = plan.how;
    child.quick = plan.quick;
    Torque innovation, variance;
    Scalar squared = Scalar(0);
    const Scalar log_likelihood = take_in(child, parent, plan, innovation, variance, squared);
    if (!std::isfinite(log_likelihood) || !child.star.finite()) return;
    child.log_weight += plan.log_transition + log_likelihood;
    if (children_ == 0) best_child_ = child.log_weight;
    best_child_ = std::max(best_child_, child.log_weight);
    evidence_ = evidence_ > child.log_weight ? evidence_ + log(1 + exp(child.log_weight - evidence_))
                                             : child.log_weight + log(1 + exp(evidence_ - child.log_weight));
    if (phase_ == Phase::Settled) goes_on_weight_ = child.log_weight;
    if (phase_ == Phase::Shaken) jolt_weight_ = child.log_weight;
    if (plan.parent == settled_ && child.settled() && !plan.anew && child.mode == parent.mode) {
      settled_payload_ = child.mode == Mode::Pouring ? -1 : child.payload;
      settled_innovation_ = innovation;
      settled_variance_ = variance;
      settled_squared_ = squared / Scalar(Dofs);
    }
    int place = -1;
    for (int i = 0; i < children_ && place < 0; ++i) {
      if (!next(i).same(child)) continue;
      const Scalar high = std::max(next(i).log_weight, child.log_weight);
      const Scalar sum = high + log(exp(next(i).log_weight - high) + exp(child.log_weight - high));
      if (next(i).log_weight > child.log_weight) {
        next(i).log_weight = sum;
        return;
      }
      child.log_weight = sum;
      place = i;
    }
    if (place < 0 && children_ < Capacity) place = children_++;
    if (place < 0) {
      place = 0;
      for (int i = 1; i < children_; ++i)
        if (next(i).log_weight < next(place).log_weight) place = i;
      if (next(place).log_weight > child.log_weight) return;
    }
    work_->exchange(place, Capacity);
    squared_[at(place)] = squared / Scalar(Dofs);
  }

  /// Applies the block to a child that is still its parent's copy.
  /// @return log p(block | child)
  Scalar take_in(Tale& child, const Tale& parent, const Plan& plan, Torque& innovation, Torque& variance,
                 Scalar& squared) noexcept {
    const Scalar duration = model_.block().duration;
    model_.predict(child.star);
    if (parent.mode == Mode::Pouring && child.mode != Mode::Pouring) child.star.end_pour();
    if (child.mode == Mode::Disturbed) {
      const bool jolt = child.how == Disturbing::Jolt;
      if (parent.mode != Mode::Disturbed || parent.how == Disturbing::Jolt || jolt)
        child.disturbance.begin(rated_);
      else
        child.disturbance.predict(child.how, duration, rated_);
      return child.disturbance.observe(model_, child.star, jolt ? Scalar(kJolt) : Scalar(0), squared);
    }
    if (child.mode == Mode::Changing) {
      if (model_.kind().draws) {
        Tale& drawn = next(Capacity + 2);
        drawn.star = child.star;
        drawn.mode = Mode::Held;
        draw(drawn, innovation, variance, squared);
        const Scalar log_likelihood =
            update(drawn, innovation, variance, squared) + log_plausible(drawn.star, kLightest);
        if (child.log_weight + log_likelihood > fresh_weight_) {
          fresh_weight_ = child.log_weight + log_likelihood;
          fresh_ = payload_in(drawn.star);
        }
        return log_likelihood;
      }
      Star star = child.star;
      Disturbance<Scalar, Dofs> anything;
      anything.begin(rated_);
      return anything.observe(model_, star, Scalar(0), squared);
    }
    if (child.mode == Mode::Empty) {
      if (parent.payload != 0) model_.unload(child.star, parent.star.payload_mean());
      child.star.forget_payload();
      child.payload = 0;
      child.log_plausible = Scalar(0);
      return update(child, innovation, variance, squared);
    }
    Scalar log_likelihood = Scalar(0);
    if (child.mode == Mode::Pouring) {
      if (parent.mode != Mode::Pouring) {
        if (child.quick) model_.suppose_hidden(child.star, payload_.com_mean);
        child.pour.begin(child.star, payload_, rated_, child.quick);
        if (child.payload == 0) child.payload = child.take_next();
      }
      child.pour.predict(child.star, duration, payload_, rated_);
    } else if (plan.anew) {
      if (plan.late) {
        Eigen::Matrix<Scalar, kArmShared, 1> lag = Eigen::Matrix<Scalar, kArmShared, 1>::Zero();
        lag[kLag] = Scalar(kLate * kLate);
        child.star.widen_arm(lag);
      }
      child.payload = child.take_next();
      child.log_plausible = Scalar(0);
      draw(child, innovation, variance, squared);
    }
    log_likelihood += update(child, innovation, variance, squared);
    // What is poured begins with nothing. It may be as light as it likes, but not lighter than that.
    const Scalar plausible = log_plausible(child.star, child.mode == Mode::Pouring ? 0 : kLightest);
    log_likelihood += plausible - child.log_plausible;
    child.log_plausible = plausible;
    return log_likelihood;
  }
  /// Draws a new payload. The prior of m r needs the mass, and the block itself shows the mass best. So the prior is for
  /// the mass that the block shows.
  void draw(Tale& child, Torque& innovation, Torque& variance, Scalar& squared) noexcept {
    child.star.draw_payload(payload_.mean(), payload_.factor(payload_.square_mass()));
    Tale& first = next(Capacity + 1);
    first.star = child.star;
    first.mode = Mode::Held;
    (void)update(first, innovation, variance, squared);
    const Scalar mass = std::max(Scalar(0.02) * rated_, std::min(rated_, first.star.mass()));
    const Scalar square = mass * mass + first.star.mass_variance();
    child.star.draw_payload(payload_.mean(), payload_.factor(square));
  }

  /// Updates a story's filter with the block, joint by joint.
  /// @return log p(block | story) [nats], without the constant factor of 2 pi
  Scalar update(Tale& story, Torque& innovation, Torque& variance, Scalar& squared) noexcept {
    using std::abs;
    using std::exp;
    using std::log;
    Star& star = story.star;
    const Scalar mass = std::min(std::max(star.mass(), Scalar(0)), rated_);
    Scalar log_likelihood = Scalar(0);
    squared = Scalar(0);
    for (int j = 0; j < Dofs; ++j) {
      auto p = star.predict(j, model_.observation(j, mass));
      const Scalar square = p.innovation * p.innovation;
      const auto log_density = [square](Scalar v) { return Scalar(-0.5) * (square / v + log(v)); };
      if (const Scalar jump = model_.stiction_jump(star, j); jump > 0) {  // a mixture of both
        const Scalar stays = log_density(p.variance), jumps = log_density(p.variance + jump);
        const Scalar share = Scalar(1) / (Scalar(1) + exp(stays - jumps));
        log_likelihood += std::max(stays, jumps) + log(Scalar(1) + exp(-abs(stays - jumps)));
        star.joint(j).covariance(kStiction, kStiction) += share * jump;
        p = star.predict(j, model_.observation(j, mass));
      } else {
        log_likelihood += log_density(p.variance);
      }
      squared += square / p.variance;
      innovation[j] = p.innovation;
      variance[j] = p.variance;
      if (story.mode == Mode::Pouring) story.pour.observe(star, p);
      star.observe(j, p);
    }
    return log_likelihood;
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

  /// Ends a block: keeps the heaviest children, and learns noise and residual if nothing happened.
  void finish() noexcept {
    using std::exp;
    using std::log;
    if (children_ == 0) {
      evidence_ = Scalar(0);
      return;
    }
    std::array<int, at(Capacity)> order{};
    for (int i = 0; i < children_; ++i) order[at(i)] = i;
    std::sort(order.begin(), order.begin() + children_,
              [this](int a, int b) { return next(a).log_weight > next(b).log_weight; });
    innovation_squared_ = settled_squared_ > 0 ? settled_squared_ : squared_[at(order[0])];
    Scalar total = Scalar(0);
    const Scalar best = next(order[0]).log_weight, depth = this->depth();
    count_ = 0;
    for (int i = 0; i < children_; ++i) {
      const Tale& child = next(order[at(i)]);
      if (child.log_weight < best - (explained_ && child.mode == Mode::Pouring ? Scalar(kPourDepth) : depth)) continue;
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
    if (nothing > Scalar(0.9) && settled_payload_ >= 0)
      model_.learn(settled_payload_, settled_innovation_, settled_variance_);
    else
      model_.interrupt();
  }

  void add(const Tale& like, Mode mode, int payload, Scalar probability) noexcept {
    using std::log;
    Tale story = like;
    story.mode = mode;
    story.payload = payload;
    story.log_plausible = Scalar(0);
    story.log_weight = log(probability);
    count_ = std::min(count_, Capacity - 1);
    for (int i = count_; i > 0; --i) told(i) = told(i - 1);
    told(0) = story;
    ++count_;
    for (int i = 1; i < count_; ++i) told(i).log_weight += log(Scalar(1) - probability);
  }

  JointTorqueModel<Scalar, Dofs> model_;
  PayloadPrior<Scalar> payload_;
  Scalar rated_;
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
  Scalar share_ = Scalar(0);  // log probability of the kind
  Scalar goes_on_weight_ = Scalar(0), jolt_weight_ = Scalar(0);
  Scalar heaviest_ = Scalar(0), best_child_ = Scalar(0), evidence_ = Scalar(0), innovation_squared_ = Scalar(1);
  Scalar settled_squared_ = Scalar(0);  // of settled_'s story, if it goes on in this block
  std::array<Scalar, at(Capacity + 2)> squared_;
  Torque settled_innovation_ = Torque::Zero(), settled_variance_ = Torque::Ones();
};

}  // namespace rme
