#include <rme/tracking/event_monitor.hpp>
#include <string>

#include "support/catch.hpp"

namespace {

using rme::EventKind;
using rme::Mode;

using Gaussian = rme::PayloadGaussian<double>;

constexpr double kBlock = 0.02;  // [s]

/// A mass [kg] known to a deviation, with its centre 10 cm below the flange.
Gaussian weighing(double mass, double deviation) {
  return Gaussian::independent({mass, 0, 0, 0.1}, {deviation, 0.002, 0.002, 0.002});
}

/// A monitor that sees one mode at a time.
struct Story {
  rme::EventMonitor<double> monitor;
  double t = 0;

  /// `blocks` blocks in which a mode is likeliest, and what payload is believed in.
  Story& see(Mode likeliest, int blocks, const Gaussian& payload) {
    rme::PerMode<double> probability = {{0.02, 0.02, 0.02, 0.02, 0.02}};
    probability[likeliest] = 0.92;
    for (; blocks > 0; --blocks, t += kBlock) monitor.update(probability, t, t + kBlock, t + kBlock + 0.005, payload);
    return *this;
  }
  Story& see(Mode likeliest, int blocks, double mass = 0, double deviation = 0.001) {
    return see(likeliest, blocks, weighing(mass, deviation));
  }
  EventKind kind() const { return monitor.last().kind; }
};

TEST_CASE("EventMonitor: an empty hand is no event, however long", "[event_monitor]") {
  Story story;
  CHECK_FALSE(story.monitor.changing());
  story.see(Mode::Empty, 500);
  CHECK(story.monitor.last().number == 0);
  CHECK(story.kind() == EventKind::None);
  CHECK_FALSE(story.monitor.changing());
}

TEST_CASE("EventMonitor: an attachment begins with its block, is noticed after it, and over after a tenth of a second",
          "[event_monitor]") {
  Story story;
  story.see(Mode::Empty, 50).see(Mode::Changing, 2, 1.0);
  CHECK(story.monitor.changing());
  CHECK(story.monitor.onset() == Approx(1.0));
  CHECK(story.monitor.noticed() == Approx(1.025));
  story.see(Mode::Held, 4, 1.0);
  CHECK(story.monitor.changing());
  story.see(Mode::Held, 1, 1.0);
  CHECK_FALSE(story.monitor.changing());
  CHECK(story.monitor.last().number == 1);
  CHECK(story.kind() == EventKind::Attached);
  CHECK(story.monitor.last().onset == Approx(1.0));
  CHECK(story.monitor.last().noticed == Approx(1.025));
  CHECK(story.monitor.last().over == Approx(1.145));  // 7 blocks, and what it takes to compute the last one
}

TEST_CASE("EventMonitor: what happened is told from the hand before and after", "[event_monitor]") {
  Story story;
  story.see(Mode::Empty, 50).see(Mode::Changing, 3, 1.0).see(Mode::Held, 20, 1.0);
  REQUIRE(story.kind() == EventKind::Attached);
  story.see(Mode::Changing, 3, 1.5).see(Mode::Held, 20, 1.5);
  CHECK(story.kind() == EventKind::Exchanged);
  story.see(Mode::Pouring, 30, 1.7).see(Mode::Held, 20, 1.7);
  CHECK(story.kind() == EventKind::Filling);
  story.see(Mode::Disturbed, 30, 1.7).see(Mode::Held, 20, 1.7);
  CHECK(story.kind() == EventKind::Pushed);
  story.see(Mode::Empty, 20);
  CHECK(story.kind() == EventKind::Removed);
  CHECK(story.monitor.last().number == 5);
}

TEST_CASE("EventMonitor: an exchange that ends with the mass of before was a push, or nothing", "[event_monitor]") {
  Story story;
  story.see(Mode::Empty, 50).see(Mode::Changing, 3, 1.0).see(Mode::Held, 20, 1.0);
  // 2 g more at 1 g of doubt each is no other payload.
  story.see(Mode::Changing, 3, 1.3).see(Mode::Held, 20, 1.002);
  CHECK(story.monitor.last().number == 1);
  story.see(Mode::Changing, 2, 1.3).see(Mode::Disturbed, 10, 1.0).see(Mode::Held, 20, 1.002);
  CHECK(story.monitor.last().number == 2);
  CHECK(story.kind() == EventKind::Pushed);
}

TEST_CASE("EventMonitor: an event is over 0.4 s after its change, whatever still drifts, but not while a push lasts",
          "[event_monitor]") {
  Story story;
  story.see(Mode::Empty, 50).see(Mode::Changing, 1, 1.0).see(Mode::Pouring, 19, 1.0);
  CHECK(story.monitor.changing());
  story.see(Mode::Pouring, 3, 1.0);
  CHECK(story.kind() == EventKind::Attached);
  Story pushed;
  pushed.see(Mode::Empty, 50).see(Mode::Disturbed, 500);
  CHECK(pushed.monitor.changing());
  CHECK(pushed.monitor.last().number == 0);
}

TEST_CASE("EventMonitor: a change that is only as likely as no change does not begin an event", "[event_monitor]") {
  rme::EventMonitor<double> monitor;
  monitor.update({{0.5, 0, 0, 0.5, 0}}, 0, kBlock, kBlock, weighing(0.5, 0.5));
  CHECK_FALSE(monitor.changing());
  monitor.update({{0.4999, 0, 0, 0.5001, 0}}, kBlock, 2 * kBlock, 2 * kBlock, weighing(0.5, 0.5));
  CHECK(monitor.changing());
}

TEST_CASE("EventMonitor: an event is not over when exactly 0.4 s have passed since its last change",
          "[event_monitor]") {
  rme::EventMonitor<double> monitor;
  const auto see = [&](Mode likeliest, double begin, double end) {
    rme::PerMode<double> probability;
    probability[likeliest] = 1;
    monitor.update(probability, begin, end, end, weighing(1, 0.001));
  };
  see(Mode::Changing, 0, 0.4);
  see(Mode::Pouring, 0.4, 0.8);  // 0.8 - 0.4 is 0.4 to the last bit
  CHECK(monitor.changing());
  see(Mode::Pouring, 0.8, 0.82);
  CHECK(monitor.last().kind == EventKind::Attached);
}

/// A hand that holds `mass`, known to `deviation`, after a second with an empty one.
Story holding(double mass, double deviation) {
  Story story;
  story.see(Mode::Empty, 50);
  story.see(Mode::Changing, 3, mass, deviation).see(Mode::Held, 20, mass, deviation);
  REQUIRE(story.monitor.last().number == 1);
  return story;
}

TEST_CASE(
    "EventMonitor: a mass has changed if it differs by more than 2 % and three standard deviations of the difference",
    "[event_monitor]") {
  const auto kind = [](double before, double after, double doubt_before, double doubt_after) {
    Story story = holding(before, doubt_before);
    story.see(Mode::Changing, 2, after, doubt_after).see(Mode::Held, 20, after, doubt_after);
    return story.monitor.last().number == 1 ? EventKind::None : story.kind();
  };
  // 60 g of 3 kg, known to 1 g.
  CHECK(kind(3, 3.05, 0.001, 0.001) == EventKind::None);
  CHECK(kind(3, 3.07, 0.001, 0.001) == EventKind::Exchanged);
  CHECK(kind(3, 2.93, 0.001, 0.001) == EventKind::Exchanged);
  // 10 g of doubt before and after are 14 about the difference.
  CHECK(kind(1, 1.03, 0.01, 0.01) == EventKind::None);
  CHECK(kind(1, 1.05, 0.01, 0.01) == EventKind::Exchanged);
  // 3, 4 and 5 eighths: exactly three doubts are no other payload.
  CHECK(kind(4, 4 + 1.875, 0.375, 0.5) == EventKind::None);
  CHECK(kind(4, 4 + 1.876, 0.375, 0.5) == EventKind::Exchanged);
}

/// What a change to `after` is, of something held as in `before`.
EventKind change_of(const Gaussian& before, const Gaussian& after, Mode through = Mode::Changing) {
  Story story;
  story.see(Mode::Empty, 50).see(Mode::Changing, 3, before).see(Mode::Held, 20, before);
  REQUIRE(story.kind() == EventKind::Attached);
  story.see(through, 3, after).see(Mode::Held, 20, after);
  return story.monitor.last().number == 1 ? EventKind::None : story.kind();
}
Gaussian with_com(const Eigen::Vector3d& com, const Eigen::Vector3d& deviation, double mass = 1) {
  Eigen::Vector4d mean, spread;
  mean << mass, com;
  spread << 0.001, deviation;
  return Gaussian::independent(mean, spread);
}

TEST_CASE("EventMonitor: as heavy as before with its centre elsewhere, the payload has moved in the hand",
          "[event_monitor]") {
  const Eigen::Vector3d sure = Eigen::Vector3d::Constant(0.001);
  const Gaussian before = with_com({0.02, 0, 0.1}, sure);
  for (const Eigen::Vector3d& way : {Eigen::Vector3d(0.03, 0, 0), Eigen::Vector3d(0, -0.03, 0),
                                     Eigen::Vector3d(0, 0, 0.03), Eigen::Vector3d(0.02, 0.02, -0.02)}) {
    CAPTURE(way.transpose());
    CHECK(change_of(before, with_com(before.mean.tail<3>() + way, sure)) == EventKind::Moved);
    // Pushed until it turned, it has moved.
    CHECK(change_of(before, with_com(before.mean.tail<3>() + way, sure), Mode::Disturbed) == EventKind::Moved);
  }
  // Another mass is another payload, wherever its centre is.
  CHECK(change_of(before, with_com({0.06, 0, 0.1}, sure, 1.1)) == EventKind::Exchanged);
  CHECK(change_of(before, with_com({0.02, 0, 0.1}, sure), Mode::Disturbed) == EventKind::Pushed);
}

TEST_CASE("EventMonitor: a centre of mass is elsewhere from 1 cm on, and from what its uncertainty explains",
          "[event_monitor]") {
  const Eigen::Vector3d sure = Eigen::Vector3d::Constant(0.0001);
  CHECK(change_of(with_com({0, 0, 0.1}, sure), with_com({0.0099, 0, 0.1}, sure)) == EventKind::None);
  CHECK(change_of(with_com({0, 0, 0.1}, sure), with_com({0.0101, 0, 0.1}, sure)) == EventKind::Moved);
  // 6 and 8 mm of doubt are 10 mm about the difference: 14.16 is 3.763 of them, squared.
  const Eigen::Vector3d once = Eigen::Vector3d::Constant(0.006), again = Eigen::Vector3d::Constant(0.008);
  CHECK(change_of(with_com({0, 0, 0.1}, once), with_com({0, 0.0376, 0.1}, again)) == EventKind::None);
  CHECK(change_of(with_com({0, 0, 0.1}, once), with_com({0, 0.0377, 0.1}, again)) == EventKind::Moved);
  // Along gravity, which a resting arm does not show, 10 cm are nothing; across it, 2 cm are known.
  const Eigen::Vector3d resting(0.002, 0.002, 0.07);
  CHECK(change_of(with_com({0, 0, 0.1}, resting), with_com({0, 0, 0.2}, resting)) == EventKind::None);
  CHECK(change_of(with_com({0, 0, 0.1}, resting), with_com({0, 0.02, 0.1}, resting)) == EventKind::Moved);
  // What is correlated counts as such: a share of the mass's doubt is in each entry alike.
  Gaussian alike = with_com({0, 0, 0.1}, sure), away = with_com({0.02, 0.02, 0.1}, sure);
  for (Gaussian* each : {&alike, &away}) each->covariance.block<2, 2>(1, 1).array() += 1e-4;
  CHECK(change_of(alike, away) == EventKind::None);
  away.mean[2] = -0.02;
  CHECK(change_of(alike, away) == EventKind::Moved);
  // Without a covariance, no distance is known to be large.
  const Eigen::Vector3d none = Eigen::Vector3d::Zero();
  CHECK(change_of(with_com({0, 0, 0.1}, none), with_com({0.03, 0, 0.1}, none)) == EventKind::None);
}

TEST_CASE("EventMonitor: what has moved is compared with where it is now", "[event_monitor]") {
  const Eigen::Vector3d sure = Eigen::Vector3d::Constant(0.001);
  const Gaussian here = with_com({0, 0, 0.1}, sure), there = with_com({0.05, 0, 0.1}, sure);
  Story story;
  story.see(Mode::Empty, 50).see(Mode::Changing, 3, here).see(Mode::Held, 20, here);
  story.see(Mode::Changing, 3, there).see(Mode::Held, 20, there);
  REQUIRE(story.kind() == EventKind::Moved);
  story.see(Mode::Disturbed, 10, there).see(Mode::Held, 20, there);
  CHECK(story.kind() == EventKind::Pushed);
  story.see(Mode::Changing, 3, here).see(Mode::Held, 20, here);
  CHECK(story.kind() == EventKind::Moved);
  CHECK(story.monitor.last().number == 4);
}

TEST_CASE("EventMonitor: a block that half belongs to a change does not count as the payload before it",
          "[event_monitor]") {
  const Eigen::Vector3d sure = Eigen::Vector3d::Constant(0.002);
  const Gaussian here = with_com({0, 0, 0.1}, sure), there = with_com({0.04, 0, 0.1}, sure);
  Story story;
  story.see(Mode::Empty, 50).see(Mode::Changing, 3, here).see(Mode::Held, 20, here);
  // Held is likeliest still, and the estimate a mixture: half way, and as uncertain as that.
  rme::PerMode<double> probability;
  probability[Mode::Held] = 0.55;
  probability[Mode::Changing] = 0.45;
  const Gaussian mixture = with_com({0.02, 0, 0.1}, Eigen::Vector3d(0.02, 0.002, 0.002));
  story.monitor.update(probability, story.t, story.t + kBlock, story.t + kBlock, mixture);
  REQUIRE_FALSE(story.monitor.changing());
  story.t += kBlock;
  story.see(Mode::Changing, 2, there).see(Mode::Held, 20, there);
  CHECK(story.kind() == EventKind::Moved);
}

TEST_CASE("EventMonitor: each kind has its name for logs", "[event_monitor]") {
  CHECK(rme::to_string(EventKind::Pushed) == std::string("pushed"));
  CHECK(rme::to_string(EventKind::Moved) == std::string("moved"));
}

TEST_CASE("EventMonitor: a mass that is another one after a push, or after a hand-over that drifted, is an exchange",
          "[event_monitor]") {
  Story pushed = holding(1, 0.001);
  pushed.see(Mode::Disturbed, 10, 1).see(Mode::Held, 20, 1.5);
  CHECK(pushed.kind() == EventKind::Exchanged);
  Story drifted = holding(1, 0.001);
  drifted.see(Mode::Changing, 2, 1.4).see(Mode::Pouring, 5, 1.45).see(Mode::Held, 20, 1.5);
  CHECK(drifted.kind() == EventKind::Exchanged);
}

TEST_CASE("EventMonitor: what still drifts after an event is compared with what that event found", "[event_monitor]") {
  // Known for 0.4 s, the payload has been attached; drifting ends with the same mass.
  Story story;
  story.see(Mode::Empty, 50).see(Mode::Changing, 1, 1.0).see(Mode::Pouring, 30, 1.0);
  REQUIRE(story.kind() == EventKind::Attached);
  REQUIRE(story.monitor.changing());
  story.see(Mode::Held, 20, 1.0);
  CHECK_FALSE(story.monitor.changing());
  CHECK(story.monitor.last().number == 1);
}

TEST_CASE("EventMonitor: what is learned of a payload between two events is known before the second",
          "[event_monitor]") {
  Story story = holding(1, 0.001);
  story.see(Mode::Held, 50, 1.2);
  story.see(Mode::Disturbed, 10, 1.2).see(Mode::Held, 20, 1.2);
  CHECK(story.kind() == EventKind::Pushed);
}

TEST_CASE("EventMonitor: what the host says is no event", "[event_monitor]") {
  Story story;
  story.see(Mode::Empty, 50);
  story.monitor.believe(false);
  story.see(Mode::Held, 50, 1.0);
  CHECK(story.monitor.last().number == 0);
  story.monitor.reset();
  story.see(Mode::Held, 50, 1.0);
  CHECK(story.kind() == EventKind::Attached);  // after a reset the hand was empty
}

}  // namespace
