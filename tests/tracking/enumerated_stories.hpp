#pragma once
/// Stories by brute force: every child of every story, none ever given up, none left out.
#include <algorithm>
#include <cmath>
#include <limits>
#include <optional>
#include <rme/tracking/histories.hpp>
#include <vector>

#include "support/linear_algebra.hpp"

namespace rme::testing {

/// A block of 20 ms in which an arm rests.
template <typename Scalar, int Dofs>
TorqueBlock<Scalar, Dofs> block_at_rest(const Eigen::Matrix<Scalar, 6, Dofs>& jacobian, const Matrix3<Scalar>& rotation,
                                        const JointVector<Scalar, Dofs>& tau) {
  TorqueBlock<Scalar, Dofs> block;
  block.duration = Scalar(0.02);
  block.samples = 20;
  block.tau = tau;
  block.torque_rate.setZero();
  block.regressor =
      jacobian.transpose() * inertial_wrench_regressor<Scalar>(rotation, {0, 0, Scalar(-9.81)}, FlangeMotion<Scalar>());
  block.jacobian = jacobian;
  block.rotation = rotation;
  block.velocity.setZero();
  block.velocities.setZero();
  block.torque_step.setZero();
  block.velocity_noise.setZero();
  return block;
}

/// What Histories computes, without its shortcuts: a list of stories that grows without bound. Those that say the same of the
/// present are added up.
template <int Dofs>
class EnumeratedStories {
 public:
  using H = Histories<double, Dofs>;
  using Tale = Story<double, Dofs>;
  using Model = JointTorqueModel<double, Dofs>;

  /// @param alone  of the arm that is not the likeliest story's, the heaviest story lives on alone
  EnumeratedStories(const H& fresh, const PayloadPrior<double>& prior, double rated, bool alone)
      : prior_(prior), rated_(rated), alone_(alone) {
    for (int i = 0; i < fresh.count(); ++i) stories.push_back(fresh.story(i));
  }

  /// Takes in the block that `model` has begun.
  void advance(const Model& model) {
    for (Tale& s : stories) {  // no host passes the arm's gravity torque here
      if (blocks_ > 0) break;
      s.star.set_tilt(0);
      if (s.tilted) model.tilt(s.star, 0.04);
    }
    ++blocks_;
    std::sort(stories.begin(), stories.end(), [](const Tale& a, const Tale& b) { return a.log_weight > b.log_weight; });
    next_.clear();
    for (const bool goes_on : {true, false})
      for (const Tale& parent : stories) children(model, parent, goes_on);
    double best = -1e30, sum = 0;
    for (const Tale& s : next_) best = std::max(best, s.log_weight);
    for (const Tale& s : next_) sum += std::exp(s.log_weight - best);
    for (Tale& s : next_) s.log_weight -= best + std::log(sum);
    stories = next_;
  }

  std::vector<Tale> stories;

 private:
  void children(const Model& model, const Tale& p, bool goes_on) {
    const SensingKind& kind = model.kind();
    const double c = kind.change;
    const bool swings = p.star.swings(), empty = p.mode == Mode::Empty;
    const auto child = [&](double probability, Transition t) {
      const bool same = t.mode == p.mode && !t.anew && !t.zeroed && (t.mode != Mode::Disturbed || t.how == p.how) &&
                        (t.mode != Mode::Pouring || t.quick == p.quick) && t.swings == swings;
      t.probability = probability;
      if (same == goes_on && probability > 0) add(take_in(model, p, t));
    };
    const auto to = [](Mode mode, bool swings_then = false) {
      Transition t;
      t.mode = mode;
      t.swings = swings_then;
      return t;
    };
    const auto disturbed = [&](Disturbing how) {
      Transition t = to(Mode::Disturbed);
      t.how = how;
      return t;
    };
    const auto pouring = [&](bool quick) {
      Transition t = to(Mode::Pouring);
      t.quick = quick;
      return t;
    };
    double gain = 0;
    for (int j = 0; j < Dofs; ++j) gain += p.star.joint(j).covariance(kGain, kGain) / Dofs;
    const double off = kind.draws && gain < 0.01 * 0.01 ? Transitions::kGainsOff / std::pow(p.next, 2) : 0;
    const auto drawn = [&](double probability, bool late) {
      const bool from_the_hand = p.mode == Mode::Empty || p.mode == Mode::Changing;
      const double hangs = from_the_hand ? Transitions::kHangs * kind.faint : 0;
      Transition t = to(Mode::Held);
      t.anew = true;
      t.late = late;
      child(probability * (1 - hangs - off), t);
      t.gains = true;
      child(probability * off, t);
      t.gains = false;
      t.swings = true;
      child(probability * hangs, t);
    };
    const auto disturb = [&] {
      child(Transitions::kDisturbs, disturbed(Disturbing::Hand));
      child(kind.jolt, disturbed(Disturbing::Jolt));
    };
    if (p.mode != Mode::Pouring) {
      Transition t = to(p.payload == 0 ? Mode::Empty : Mode::Held, swings);
      t.zeroed = true;
      child(Transitions::kZeroes, t);
    }
    if (empty || p.mode == Mode::Held) {
      const double pours = (empty ? Transitions::kFills : Transitions::kPours) * kind.slowly;
      const double never = !empty && p.log_none ? 0.3 * c : 0;
      const double turns = empty ? 0 : swings ? Transitions::kSwingEnds : Transitions::kSwings * kind.faint;
      child(1 - (empty ? 1.3 : 1.6) * c - never - Transitions::kDisturbs - kind.jolt - pours - turns -
                Transitions::kZeroes - (empty ? kind.takes_up : 0),
            to(p.mode, swings));
      if (!swings)
        child(turns, to(Mode::Held, true));
      else if (blocks_ % Transitions::kSoon == 0)
        child(turns * Transitions::kSoon, to(Mode::Held));
      child(c, to(Mode::Changing));
      drawn(0.3 * c, false);
      if (!empty) child(0.3 * c, to(Mode::Empty));
      if (blocks_ % Transitions::kSlow == 0) {
        Transition t = to(Mode::Empty);
        t.never = true;
        child(Transitions::kSlow * never, t);
        child(Transitions::kSlow * pours, pouring(false));
      }
      disturb();
      if (empty) child(kind.takes_up, pouring(true));
    } else if (p.mode == Mode::Pouring) {
      const double ends = p.quick ? Transitions::kQuickEnds : Transitions::kPourEnds;
      child(1 - ends - c - Transitions::kDisturbs - kind.jolt, pouring(p.quick));
      child(ends, to(Mode::Held));
      child(c, to(Mode::Changing));
      disturb();
    } else if (p.mode == Mode::Changing) {
      child(1 - Transitions::kSettles - Transitions::kEmpties - Transitions::kTurnsOut - Transitions::kZeroes,
            to(Mode::Changing));
      child(Transitions::kTurnsOut, disturbed(Disturbing::Hand));
      const bool late = kind.lag > 0 && p.star.variance(kLag) < Transitions::kLate * Transitions::kLate;
      drawn(Transitions::kSettles * (late ? 1 - Transitions::kIsLate / std::pow(p.next, 2) : 1), false);
      if (late) drawn(Transitions::kSettles * Transitions::kIsLate / std::pow(p.next, 2), true);
      child(Transitions::kEmpties, to(Mode::Empty));
    } else {
      const bool jolt = p.how == Disturbing::Jolt, soft = p.how == Disturbing::Growing || p.how == Disturbing::Still;
      const double ends = jolt ? Transitions::kJoltEnds : soft ? Transitions::kTouchEnds : Transitions::kDisturbEnds;
      const double turns_out = (soft ? 0.3 : 1) * Transitions::kTurnsOut * std::min(1.0, c / 1e-3);
      const double taken = p.how == Disturbing::Hand ? 0.3 * turns_out * kind.faint : 0;
      child(1 - Transitions::kZeroes - ends - (soft ? 2 : 1) * turns_out - (p.payload == 0 ? 1 : 2) * taken -
                (jolt ? 0
                      : Transitions::kOther * (p.how != Disturbing::Hand) +
                            Transitions::kSoftOther * (soft ? 1 : 2) * kind.slowly),
            disturbed(p.how));
      child(ends, to(p.payload == 0 ? Mode::Empty : Mode::Held));
      child(turns_out, to(Mode::Changing));
      drawn(taken, false);
      if (p.payload != 0) child(taken, to(Mode::Empty));
      if (soft && blocks_ % Transitions::kSoon == 0) {
        Transition t = to(Mode::Held);
        t.anew = t.turned = true;
        child(turns_out * Transitions::kSoon, t);
      }
      if (jolt) return;
      for (const Disturbing how : {Disturbing::Hand, Disturbing::Growing, Disturbing::Still})
        if (how != p.how)
          child(how == Disturbing::Hand ? Transitions::kOther : Transitions::kSoftOther * kind.slowly, disturbed(how));
    }
  }

  Tale take_in(const Model& model, const Tale& parent, const Transition& t) {
    Tale child = parent;
    child.mode = t.mode;
    child.how = t.how;
    child.quick = t.quick;
    model.predict(child.star);
    if (t.zeroed) model.zero(child.star);
    if (!t.swings) child.swing.end(child.star);
    if (parent.mode == Mode::Pouring && t.mode != Mode::Pouring) child.pour.end(child.star);
    child.log_weight += std::log(t.probability) + (t.turned  ? turn(model, parent, child)
                                                   : t.never ? nothing(model, child)
                                                             : likelihood(model, parent, child, t));
    return child;
  }
  /// There has been no payload since this one was drawn: what the joints' torques say of it, and its prior, at zero.
  double nothing(const Model& model, Tale& child) {
    double out = -*child.log_none - child.log_plausible + child.star.payload_is_none();
    child.payload = 0;
    child.log_plausible = 0;
    child.log_none.reset();
    return out + observe(model, child.star, nullptr);
  }
  /// The wrench has been a payload all along.
  double turn(const Model& model, const Tale& parent, Tale& child) {
    auto star = child.star;
    auto wrench = parent.disturbance;
    double squared;
    wrench.predict(parent.how, model.block().duration, rated_);
    const double out = wrench.observe(model, star, parent.how, std::log(model.kind().jolt), rated_, squared) +
                       wrench.weigh(model, child.star, prior_, rated_);
    child.payload = child.next++;
    child.held_for = 0;
    draw(model, child.star);
    child.log_plausible = plausible(child.star);
    child.log_none.reset();
    return out + child.log_plausible;
  }
  double likelihood(const Model& model, const Tale& parent, Tale& child, const Transition& t) {
    const double duration = model.block().duration;
    double squared;  // of no use here
    if (child.mode == Mode::Disturbed) {
      if (parent.mode == Mode::Disturbed && parent.how != Disturbing::Jolt)
        child.disturbance.predict(child.how, duration, rated_);
      else
        child.disturbance.begin(rated_);
      return child.disturbance.observe(model, child.star, child.how, std::log(model.kind().jolt), rated_, squared);
    }
    if (child.mode == Mode::Changing) {
      auto star = child.star;
      if (model.kind().draws) return draw(model, star) + plausible(star);
      Disturbance<double, Dofs> anything;
      anything.begin(rated_);
      return anything.observe(model, star, Disturbing::Hand, -std::numeric_limits<double>::infinity(), rated_, squared);
    }
    if (child.mode == Mode::Empty) {
      if (parent.payload != 0) model.unload(child.star, parent.star.payload_mean(), parent.held_for);
      child.star.forget_payload();
      child.payload = 0;
      child.log_plausible = 0;
      child.log_none.reset();
      return observe(model, child.star, nullptr);
    }
    double out = 0;
    if (t.anew) {
      child.payload = child.next++;
      child.log_plausible = 0;
      if (t.late) {
        Eigen::Matrix<double, kArmShared, 1> wider = Eigen::Matrix<double, kArmShared, 1>::Zero();
        wider[kLag] = Transitions::kLate * Transitions::kLate;
        child.star.widen_arm(wider);
      }
      for (int j = 0; t.gains && j < Dofs; ++j) child.star.joint(j).covariance(kGain, kGain) += 0.02 * 0.02;
      child.held_for = 0;
      out = draw(model, child.star, &child.log_none, t.swings ? &child : nullptr);
    } else if (child.mode == Mode::Pouring) {
      if (parent.mode != Mode::Pouring) {
        if (child.payload == 0) child.pour.suppose_hidden(model, child.star, prior_);
        child.log_none.reset();
        const PourKind held = child.payload == 0 ? PourKind::TakenUp : PourKind::More;
        child.pour.begin(child.star, prior_, rated_, child.quick ? PourKind::Quick : held);
        if (child.payload == 0) {
          child.payload = child.next++;
          child.held_for = 0;
        }
      }
      child.pour.predict(child.star, duration, prior_, rated_);
      out = observe(model, child.star, &child.pour);
    } else {
      if (t.swings && parent.star.swings()) {
        child.swing.predict(child.star, duration);
      } else if (t.swings) {
        child.star.widen_payload(0.03 * 0.03 * std::exp(-child.held_for / 0.3));
        const double mass = child.held_for > 1 ? weight(child.star) / 9.81 : 0;  // somebody may lead the arm
        const Vector4<double> led = mass * mass * Vector4<double>(0.09, 0.01, 0.01, 0.01);
        child.swing.begin(child.star, weight(child.star), false, led);
        child.swing.predict(child.star, duration);
        child.log_none.reset();
      }
      out = observe(model, child.star, nullptr, t.swings ? &child.swing : nullptr);
    }
    child.held_for += duration;
    if (t.swings) child.swing.learn(child.star, duration, weight(child.star));
    const double before = child.log_plausible;
    child.log_plausible = plausible(child.star, child.mode == Mode::Pouring ? 0 : 0.007);
    return out + child.log_plausible - before;
  }
  double weight(const StarGaussian<double, Dofs>& star) const {
    return 9.81 * std::clamp(star.mass(), 0.02 * rated_, rated_);
  }
  /// A new payload; its prior is for the mass that this block shows. If a story is given, it swings.
  double draw(const Model& model, StarGaussian<double, Dofs>& star, std::optional<double>* log_none = nullptr,
              Tale* swinging = nullptr) {
    star.draw_payload(prior_.mean(), prior_.factor(prior_.square_mass()));
    auto shown = star;
    observe(model, shown, nullptr);
    const double mass = std::clamp(shown.mass(), 0.02 * rated_, rated_);
    const oracle::Matrix factor = prior_.factor(mass * mass + shown.mass_variance());
    star.draw_payload(prior_.mean(), factor);
    if (log_none != nullptr) *log_none = oracle::log_normal(prior_.mean(), oracle::square(factor));
    if (swinging != nullptr) {
      swinging->swing.begin(star, weight(shown), true, Vector4<double>::Zero());
      swinging->log_none.reset();
    }
    return observe(model, star, nullptr, swinging != nullptr ? &swinging->swing : nullptr, &shown);
  }
  /// A Student t's as the mixture that it is: Gaussians of all variances, S / g, with g from a gamma distribution of mean 1.
  static double log_density(double square, double variance, double tails) {
    if (tails == 0) return -0.5 * (square / variance + std::log(variance));
    const double shape = 0.5 * tails, rate = shape + 0.5 * square / variance;  // e^(-rate g) is all that has e
    static const double integral = [shape] {                                   // over u = rate g
      double sum = 0;
      for (double u = 0.0005; u < 60; u += 0.001) sum += 0.001 * std::pow(u, shape - 0.5) * std::exp(-u);
      return std::log(sum);
    }();
    return shape * std::log(shape) - std::lgamma(shape) - 0.5 * std::log(variance) + integral -
           (shape + 0.5) * std::log(rate);
  }
  double observe(const Model& model, StarGaussian<double, Dofs>& star, Pour<double, Dofs>* pour,
                 Swing<double, Dofs>* swing = nullptr, const StarGaussian<double, Dofs>* bears = nullptr) {
    const auto& about = bears != nullptr ? *bears : star;
    Load<double, Dofs> load;
    load.mass = std::clamp(about.mass(), 0.0, rated_);
    load.torque = model.block().regressor * about.payload_mean();
    load.held = about.payload_mean().template head<4>();
    load.tilt = about.mean().template segment<2>(rme::kTilt);
    double out = 0;
    for (int j = 0; j < Dofs; ++j) {  // no joint's stiction jumps while the arm rests
      const auto p = star.predict(j, model.observation(j, load, star.swings()));
      out += log_density(p.innovation * p.innovation, p.variance, model.kind().tails);
      if (pour != nullptr) pour->observe(star, p);
      if (swing != nullptr) swing->observe(star, p);
      star.observe(j, p);
    }
    return out;
  }
  double plausible(const StarGaussian<double, Dofs>& star, double lightest = 0.007) const {
    const double deviation = std::sqrt(std::max(star.mass_variance(), 1e-12));
    const auto below = [&](double m) { return 0.5 * std::erfc((star.mass() - m) / deviation / std::sqrt(2.0)); };
    return std::log(std::max(1e-30, below(1.2 * rated_) - below(lightest * rated_)));
  }
  /// Of those that say the same the heavier one's filter lives on.
  void add(const Tale& child) {
    for (Tale& s : next_) {
      if (alone_ && s.tilted == child.tilted && s.tilted != stories.front().tilted && !s.same(child)) {
        if (child.log_weight >= s.log_weight) s = child;
        return;
      }
      if (!s.same(child)) continue;
      const double high = std::max(s.log_weight, child.log_weight);
      const double sum = high + std::log(std::exp(s.log_weight - high) + std::exp(child.log_weight - high));
      if (child.log_weight >= s.log_weight) s = child;
      s.log_weight = sum;
      return;
    }
    next_.push_back(child);
  }

  PayloadPrior<double> prior_;
  double rated_;
  bool alone_;
  long blocks_ = 0;
  std::vector<Tale> next_;
};

}  // namespace rme::testing
