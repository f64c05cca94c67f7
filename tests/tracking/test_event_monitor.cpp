#include <rme/tracking/event_monitor.hpp>

#include "support/catch.hpp"

namespace {

using rme::EventKind;
using rme::Hypothesis;

constexpr double kBlock = 0.02;  // [s]

/// A monitor that sees one hypothesis at a time.
struct Story {
  rme::EventMonitor<double> monitor;
  double t = 0;

  /// `blocks` blocks in which a hypothesis is likeliest, and what mass is believed in.
  Story& see(Hypothesis likeliest, int blocks, double mass = 0, double deviation = 0.001) {
    rme::PerHypothesis<double> probability = {{0.02, 0.02, 0.02, 0.02, 0.02}};
    probability[likeliest] = 0.92;
    for (; blocks > 0; --blocks, t += kBlock)
      monitor.update(probability, t, t + kBlock, t + kBlock + 0.005, mass, deviation);
    return *this;
  }
  EventKind kind() const { return monitor.last().kind; }
};

TEST_CASE("EventMonitor: an empty hand is no event, however long", "[event_monitor]") {
  Story story;
  story.see(Hypothesis::Empty, 500);
  CHECK(story.monitor.last().number == 0);
  CHECK(story.kind() == EventKind::None);
  CHECK_FALSE(story.monitor.changing());
}

TEST_CASE("EventMonitor: an attach begins with its block, is noticed after it, and over after a tenth of a second",
          "[event_monitor]") {
  Story story;
  story.see(Hypothesis::Empty, 50).see(Hypothesis::Exchanged, 2, 1.0);
  CHECK(story.monitor.changing());
  CHECK(story.monitor.onset() == Approx(1.0));
  CHECK(story.monitor.noticed() == Approx(1.025));
  story.see(Hypothesis::Steady, 4, 1.0);
  CHECK(story.monitor.changing());
  story.see(Hypothesis::Steady, 1, 1.0);
  CHECK_FALSE(story.monitor.changing());
  CHECK(story.monitor.last().number == 1);
  CHECK(story.kind() == EventKind::Attached);
  CHECK(story.monitor.last().onset == Approx(1.0));
  CHECK(story.monitor.last().noticed == Approx(1.025));
  CHECK(story.monitor.last().over == Approx(1.145));  // 7 blocks, and what it takes to compute the last one
}

TEST_CASE("EventMonitor: what happened is told from the hand before and after", "[event_monitor]") {
  Story story;
  story.see(Hypothesis::Empty, 50).see(Hypothesis::Exchanged, 3, 1.0).see(Hypothesis::Steady, 20, 1.0);
  REQUIRE(story.kind() == EventKind::Attached);
  story.see(Hypothesis::Exchanged, 3, 1.5).see(Hypothesis::Steady, 20, 1.5);
  CHECK(story.kind() == EventKind::Exchanged);
  story.see(Hypothesis::Filling, 30, 1.7).see(Hypothesis::Steady, 20, 1.7);
  CHECK(story.kind() == EventKind::Filling);
  story.see(Hypothesis::Pushed, 30, 1.7).see(Hypothesis::Steady, 20, 1.7);
  CHECK(story.kind() == EventKind::Pushed);
  story.see(Hypothesis::Empty, 20);
  CHECK(story.kind() == EventKind::Removed);
  CHECK(story.monitor.last().number == 5);
}

TEST_CASE("EventMonitor: an exchange that ends with the mass of before was a push, or nothing", "[event_monitor]") {
  Story story;
  story.see(Hypothesis::Empty, 50).see(Hypothesis::Exchanged, 3, 1.0).see(Hypothesis::Steady, 20, 1.0);
  // 2 g more at 1 g of doubt each is no other payload.
  story.see(Hypothesis::Exchanged, 3, 1.3).see(Hypothesis::Steady, 20, 1.002);
  CHECK(story.monitor.last().number == 1);
  story.see(Hypothesis::Exchanged, 2, 1.3).see(Hypothesis::Pushed, 10, 1.0).see(Hypothesis::Steady, 20, 1.002);
  CHECK(story.monitor.last().number == 2);
  CHECK(story.kind() == EventKind::Pushed);
}

TEST_CASE("EventMonitor: a payload known for 0.4 s is an event, whatever still drifts; a push that lasts is none yet",
          "[event_monitor]") {
  Story story;
  story.see(Hypothesis::Empty, 50).see(Hypothesis::Exchanged, 1, 1.0).see(Hypothesis::Filling, 19, 1.0);
  CHECK(story.monitor.changing());
  story.see(Hypothesis::Filling, 3, 1.0);
  CHECK(story.kind() == EventKind::Attached);
  Story pushed;
  pushed.see(Hypothesis::Empty, 50).see(Hypothesis::Pushed, 500);
  CHECK(pushed.monitor.changing());
  CHECK(pushed.monitor.last().number == 0);
}

TEST_CASE("EventMonitor: what the host says is no event", "[event_monitor]") {
  Story story;
  story.see(Hypothesis::Empty, 50);
  story.monitor.believe(false);
  story.see(Hypothesis::Steady, 50, 1.0);
  CHECK(story.monitor.last().number == 0);
  story.monitor.reset();
  story.see(Hypothesis::Steady, 50, 1.0);
  CHECK(story.kind() == EventKind::Attached);  // after a reset the hand was empty
}

}  // namespace
