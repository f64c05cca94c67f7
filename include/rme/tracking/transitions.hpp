#pragma once
/// What may happen to the hand from one block to the next.
#include <algorithm>
#include <rme/tracking/disturbance.hpp>
#include <rme/tracking/mode.hpp>
#include <rme/tracking/sensing_kind.hpp>
#include <rme/tracking/star_gaussian.hpp>
#include <rme/tracking/story.hpp>

namespace rme {

/// A child that a story may have.
struct Transition {
  Mode mode = Mode::Empty;            ///< of the child
  double probability = 0;             ///< given the story
  bool goes_on = false;               ///< nothing begins or ends
  Disturbing how = Disturbing::Hand;  ///< of Mode::Disturbed
  bool quick = false;                 ///< of Mode::Pouring: it is taken up quickly
  bool anew = false;                  ///< of Mode::Held: a payload is drawn from the prior
  bool late = false;                  ///< of such a payload: the change has shown that the observer is not as stated
  bool gains = false;                 ///< of such a payload: it shows that the gains of the torque are less exact
  bool never = false;                 ///< of Mode::Empty: there has been no payload since this one was drawn
  bool zeroed = false;                ///< of Mode::Empty and Held: the torque sensors were zeroed, nothing else
  bool swings = false;                ///< of Mode::Held: the payload swings
  bool turned = false;                ///< of such a payload: the wrench that acted has been its weight all along
};

/// The transitions of a story, with their probabilities per block (docs/theory.md, "Stories" and "Numbers"). While a
/// block is explained without them, most are left out; slow ones take place in every kSlow-th block.
struct Transitions {
  static constexpr double kDisturbs = 1e-3;   ///< something begins to push
  static constexpr double kPours = 6e-4;      ///< something begins to flow into or out of what is held
  static constexpr double kFills = 1.2e-4;    ///< the same of an empty hand
  static constexpr double kSwings = 3e-6;     ///< what is held begins to swing
  static constexpr double kHangs = 3e-4;      ///< a payload that is drawn swings, as a share of drawn ones
  static constexpr double kSwingEnds = 2e-3;  ///< a swing ends
  static constexpr double kAtOnce = 0.3;      ///< no block lies between the old payload, or none, and the new: as a
                                              ///< share of SensingKind::change, to a new payload and to an empty hand;
                                              ///< and a payload turns out never to have been there;
                                              ///< and of kTurnsOut, a hand that pushes takes what is held or gives
  static constexpr double kZeroes = 1e-7;     ///< the torque sensors are zeroed, whatever is held
  static constexpr double kPourEnds = 4e-3;   ///< a pour ends
  static constexpr double kQuickEnds = 0.03;  ///< a quick pour ends: the payload is taken up
  static constexpr double kSettles = 0.25;    ///< a change ends in a new payload
  static constexpr double kEmpties = 0.1;     ///< a change ends in an empty hand
  static constexpr double kDisturbEnds = 0.02;  ///< a push ends
  static constexpr double kTouchEnds = 0.01;    ///< a wrench that stays or grows along itself ends
  static constexpr double kJoltEnds = 0.25;     ///< a jolt ends
  static constexpr double kOther = 0.02;        ///< a wrench trembles like a hand's from now on
  static constexpr double kSoftOther = 0.005;   ///< a wrench grows along itself, or stays as it is, from now on
  static constexpr double kTurnsOut = 0.01;     ///< a disturbance turns out to be a change, or the other way round
  static constexpr double kIsLate = 0.01;       ///< the first change shows that the observer is not as stated
  static constexpr double kOffGain = 0.02;      ///< relative error of the torque's gains that are off
  static constexpr double kGainsOff = 6e-4;     ///< the first payload shows that the torque's gains are off
  /// Standard deviation of the lag then, in time constants of the stated observer. One that is in truth half or twice
  /// as fast has a lag of 1 or -0.5.
  static constexpr double kLate = 0.5;
  static constexpr int kSlow = 10;  ///< blocks from one pour that begins to the next
  static constexpr int kSoon = 5;   ///< of quick pours that begin, pours that end, wrenches that turn out weights
  static constexpr int kMost = 12;  ///< most transitions of one story

  /// Calls use(transition) for each transition of a story.
  /// @param story      the parent
  /// @param kind       of torque sensing
  /// @param block      number of the block
  /// @param explained  whether one story in which nothing happens explains the block
  /// @param expected   whether the host says that the payload changes now: within a block or quickly, both as likely
  /// @param use        callable (const Transition&)
  template <typename Scalar, int Dofs, typename Use>
  static void each(const Story<Scalar, Dofs>& story, const SensingKind& kind, long block, bool explained, bool expected,
                   const Use& use) noexcept {
    const double change = kind.change;
    const bool slow = block % kSlow == 0, soon = block % kSoon == 0;
    const auto to = [&](Mode mode, double probability) {
      Transition t;
      t.mode = mode;
      t.probability = probability;
      return t;
    };
    const auto goes_on = [&](double probability) {
      Transition t = to(story.mode, probability);
      t.how = story.how;
      t.quick = story.quick;
      t.swings = story.star.swings();
      t.goes_on = true;
      use(t);
    };
    const auto disturbed = [&](double probability, Disturbing how) {
      Transition t = to(Mode::Disturbed, probability);
      t.how = how;
      use(t);
    };
    // What is not as stated of an arm is so from the first payload on: the k-th one shows it with k^-2 of the
    // probability.
    const double first = 1.0 / (1.0 * story.next * story.next);
    const bool exact = story.star.nuisance_variance(kGain) < Scalar(0.25 * kOffGain * kOffGain);
    const double off = kind.draws && exact ? kGainsOff * first : 0;
    const auto drawn = [&](double probability, double hangs, bool late) {  // it swings from the start, or it does not
      Transition t = to(Mode::Held, probability * (1 - hangs - off));
      t.anew = true;
      t.late = late;
      use(t);
      t.swings = true;
      t.probability = probability * hangs;
      if (hangs > 0) use(t);
      t.swings = false;
      t.gains = true;
      t.probability = probability * off;
      if (off > 0) use(t);
    };
    const double hangs = kHangs * kind.faint;
    if (!explained && story.mode != Mode::Pouring) {
      Transition zeroed = to(story.payload == 0 ? Mode::Empty : Mode::Held, kZeroes);
      zeroed.swings = story.star.swings();
      zeroed.zeroed = true;
      use(zeroed);
    }
    switch (story.mode) {
      case Mode::Empty:
      case Mode::Held: {
        const bool empty = story.mode == Mode::Empty;
        const double pours = (empty ? kFills : kPours) * kind.slowly;
        const double takes_up = expected ? change : empty ? kind.takes_up : 0;
        const double at_once = kAtOnce * change;
        const double never = !empty && story.log_none ? at_once : 0;
        const bool swings = story.star.swings();
        const double turns = empty ? 0 : swings ? kSwingEnds : kSwings * kind.faint;
        // The force of a swing explains almost every block, that of a payload which was drawn too light included.
        const bool asks = !explained || (swings && soon);
        goes_on(1 - change - (empty ? 1 : 2) * at_once - never - kDisturbs - kind.jolt - pours - takes_up - turns -
                kZeroes);
        if (turns > 0 && (swings ? soon : !explained)) {
          Transition t = to(Mode::Held, swings ? turns * kSoon : turns);
          t.swings = !swings;
          use(t);
        }
        if (takes_up > 0 && (!explained || soon)) {
          Transition quickly = to(Mode::Pouring, explained ? takes_up * kSoon : takes_up);
          quickly.quick = true;
          use(quickly);
        }
        if (asks) {
          use(to(Mode::Changing, change));
          drawn(at_once, empty ? hangs : 0, false);
          disturbed(kDisturbs, Disturbing::Hand);
          disturbed(kind.jolt, Disturbing::Jolt);
        }
        if (slow) use(to(Mode::Pouring, pours * kSlow));
        if (!empty && asks) use(to(Mode::Empty, at_once));
        if (never > 0 && slow) {
          Transition none = to(Mode::Empty, never * kSlow);
          none.never = true;
          use(none);
        }
        break;
      }
      case Mode::Pouring: {
        const double ends = story.quick ? kQuickEnds : kPourEnds;
        goes_on(1 - ends - change - kDisturbs - kind.jolt);
        if (!explained || story.quick)
          use(to(Mode::Held, ends));
        else if (soon)
          use(to(Mode::Held, ends * kSoon));
        if (explained) break;
        use(to(Mode::Changing, change));
        disturbed(kDisturbs, Disturbing::Hand);
        disturbed(kind.jolt, Disturbing::Jolt);
        break;
      }
      case Mode::Changing: {
        const bool may_be_late = kind.lag > 0 && story.star.variance(kLag) < Scalar(kLate * kLate);
        const double is_late = may_be_late ? kIsLate * first : 0;
        goes_on(1 - kSettles - kEmpties - kTurnsOut - kZeroes);
        disturbed(kTurnsOut, Disturbing::Hand);
        drawn(kSettles * (1 - is_late), hangs, false);
        if (may_be_late) drawn(kSettles * is_late, hangs, true);
        use(to(Mode::Empty, kEmpties));
        break;
      }
      case Mode::Disturbed: {
        const bool jolt = story.how == Disturbing::Jolt;
        const bool soft = story.how == Disturbing::Growing || story.how == Disturbing::Still;
        const double ends = jolt ? kJoltEnds : soft ? kTouchEnds : kDisturbEnds;
        const double turns_out = (soft ? 0.3 : 1) * kTurnsOut * std::min(1.0, change / 1e-3);
        const double turned = soft ? turns_out : 0;
        const auto other = [&](Disturbing how) {  // a jolt does not become a push
          return jolt || how == story.how ? 0 : how == Disturbing::Hand ? kOther : kSoftOther * kind.slowly;
        };
        const double at_once = story.how == Disturbing::Hand ? kAtOnce * turns_out * kind.faint : 0;
        const double empties = story.payload != 0 ? at_once : 0;
        goes_on(1 - kZeroes - ends - turns_out - turned - at_once - empties - other(Disturbing::Hand) -
                other(Disturbing::Growing) - other(Disturbing::Still));
        use(to(story.payload == 0 ? Mode::Empty : Mode::Held, ends));
        use(to(Mode::Changing, turns_out));
        if (at_once > 0) drawn(at_once, 0, false);
        if (empties > 0) use(to(Mode::Empty, empties));
        if (turned > 0 && soon) {
          Transition weight = to(Mode::Held, turned * kSoon);
          weight.anew = weight.turned = true;
          use(weight);
        }
        for (const Disturbing how : {Disturbing::Hand, Disturbing::Growing, Disturbing::Still})
          if (other(how) > 0) disturbed(other(how), how);
        break;
      }
    }
  }
};

}  // namespace rme
