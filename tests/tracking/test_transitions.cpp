#include <rme/tracking/transitions.hpp>

#include "support/catch.hpp"

namespace {

using rme::Disturbing;
using rme::Mode;
using rme::Sensing;
using rme::Transition;
using rme::Transitions;
using Story = rme::Story<double, 2>;
constexpr long kAll = Transitions::kSlow * Transitions::kSoon;  // blocks after which slow transitions come round again

/// Calls see(story, kind) for stories of every mode, with and without a payload, on every kind of arm.
template <typename See>
void for_all_stories(const See& see) {
  for (const Sensing sensing : {Sensing::LinkSide, Sensing::JointFriction, Sensing::RoughModel})
    for (const Mode mode : {Mode::Empty, Mode::Held, Mode::Pouring, Mode::Disturbed, Mode::Changing})
      for (const Disturbing how : {Disturbing::Hand, Disturbing::Growing, Disturbing::Still, Disturbing::Jolt})
        for (const bool quick : {false, true})
          for (const int payload : {0, 1})
            for (const double lag : {0.0, 0.1}) {  // and the payload was drawn
              if ((mode == Mode::Empty) != (payload == 0) && mode != Mode::Disturbed && mode != Mode::Changing)
                continue;
              CAPTURE(static_cast<int>(sensing), static_cast<int>(mode), static_cast<int>(how), quick, payload, lag);
              Story story;
              story.mode = mode;
              story.how = how;
              story.quick = quick;
              story.payload = payload;
              if (payload != 0 && lag > 0) story.log_none = -1;
              if (mode == Mode::Held && quick) {
                story.star.draw_payload(rme::InertialVector<double>::Ones(), rme::InertialMatrix<double>::Identity());
                story.star.extend(rme::StarGaussian<double, 2>::Last::Force);
              }
              Eigen::Matrix<double, rme::kArmShared, 1> variance = Eigen::Matrix<double, rme::kArmShared, 1>::Zero();
              variance[rme::kLag] = lag * lag;
              story.star.set_arm(variance);
              see(story, rme::kind_of(sensing));
            }
}

TEST_CASE("Transitions: the probabilities of all that may happen to a story add up to one", "[transitions]") {
  for_all_stories([](const Story& story, const rme::SensingKind& kind) {
    for (const bool expected : {false, true}) {
      double sum = 0;
      for (long block = 0; block < kAll; ++block)
        Transitions::each(story, kind, block, false, expected, [&](const Transition& t) {
          CHECK(t.probability > 0);
          sum += t.probability / kAll;
        });
      // What is slow takes place in every fifth or tenth block, and what goes on leaves room for it in all of them.
      CHECK(sum == Approx(1).epsilon(1e-12));
    }
  });
}

TEST_CASE("Transitions: a story goes on in one way, and has no more children than there is room for", "[transitions]") {
  for_all_stories([](const Story& story, const rme::SensingKind& kind) {
    for (const bool explained : {false, true}) {
      int count = 0, go_on = 0;
      Transitions::each(story, kind, 0, explained, !explained, [&](const Transition& t) {
        ++count;
        if (!t.goes_on) return;
        ++go_on;
        Story child = story;
        child.mode = t.mode;
        child.how = t.how;
        child.quick = t.quick;
        CHECK(t.swings == story.star.swings());
        CHECK(child.same(story));
        CHECK_FALSE(t.anew);
      });
      CHECK(go_on == 1);
      CHECK(count <= Transitions::kMost);
    }
  });
}

TEST_CASE("Transitions: while a story explains the block, nothing begins but what is slow", "[transitions]") {
  for_all_stories([](const Story& story, const rme::SensingKind& kind) {
    if (story.mode != Mode::Empty && story.mode != Mode::Held) return;
    double taken_up = 0;  // quickly
    for (long block = 0; block < 2 * Transitions::kSlow; ++block) {
      const bool swings = story.star.swings(), soon = block % Transitions::kSoon == 0;
      bool drawn = false;
      Transitions::each(story, kind, block, true, false, [&](const Transition& t) {
        CHECK((t.goes_on || t.mode == Mode::Pouring || t.never || (swings && soon)));
        if (t.never) CHECK(block % Transitions::kSlow == 0);
        if (t.mode == Mode::Pouring && !t.quick) CHECK(block % Transitions::kSlow == 0);
        if (t.mode == Mode::Pouring && t.quick) CHECK(soon);
        if (t.mode == Mode::Pouring && t.quick) taken_up += t.probability;
        drawn = drawn || t.anew;
      });
      CHECK(drawn == (swings && soon));  // a swing explains almost anything
    }
    CHECK(taken_up == Approx(story.mode == Mode::Empty ? 2 * Transitions::kSlow * kind.takes_up : 0).margin(1e-15));
  });
}

TEST_CASE("Transitions: a payload that the host expects comes or goes quickly as likely as within a block",
          "[transitions]") {
  for_all_stories([](const Story& story, const rme::SensingKind& kind) {
    if (story.mode != Mode::Empty && story.mode != Mode::Held) return;
    double quickly = 0, changes = 0;
    Transitions::each(story, kind, 1, false, true, [&](const Transition& t) {
      if (t.mode == Mode::Pouring && t.quick) quickly += t.probability;
      if (t.mode == Mode::Changing) changes += t.probability;
    });
    CHECK(quickly == kind.change);
    CHECK(changes == kind.change);
  });
}

}  // namespace
