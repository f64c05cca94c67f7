// What does a host's tick cost? A simulated Panda rests, gets a payload, carries it about, is pushed and loses it
// again, in random poses; each tick feeds the estimator and asks for the compensation torque, timed as one. What a
// block of 20 ticks needs is spread over the ticks after it, which is why they are told apart by how long ago the last
// block was done.
#include <array>
#include <cstdio>
#include <random>
#include <rme/estimator.hpp>
#include <string>
#include <vector>

#include "benchmarks/stopwatch.hpp"
#include "support/held_arm.hpp"

namespace {

using namespace rme;
using testing::HeldArm;

/// What goes on meanwhile.
enum Situation : std::size_t { kEmpty, kChange, kHeld, kMoving, kPushed, kSituations };
constexpr std::array<const char*, kSituations> kNames = {"empty hand at rest", "0.2 s after an attachment or removal",
                                                         "payload at rest", "payload in motion", "pushed"};
constexpr std::size_t kPhases = 20;  // ticks from block to block

struct Times {
  std::array<std::vector<double>, kPhases> phase;
  std::vector<double> mean;  // over blocks
};

/// One payload in one pose.
void live(std::mt19937_64& random, std::array<Times, kSituations>& times) {
  std::uniform_real_distribution<double> u(-1, 1);
  HeldArm arm(random());
  HeldArm::Vector pose = arm.pose();
  for (int j = 0; j < 7; ++j) pose[j] += 0.4 * u(random);
  arm.move(pose, HeldArm::kPeriod);
  (void)arm.tick();
  const Payload<double> payload = {1.1 + 0.7 * u(random), {0.05 * u(random), 0.05 * u(random), 0.1 + 0.08 * u(random)}};
  Estimator<double, 7> estimator(HeldArm::kPeriod);
  std::size_t phase = 0;
  double updated = 0, sum = 0;
  for (int tick = 0; tick < 5000; ++tick) {
    if (tick == 1000) arm.hold(payload);
    if (tick == 2000) arm.move(pose + 0.3 * HeldArm::Vector::Ones(), 1.5);
    if (tick == 3600) arm.push({{10 * u(random), 10 * u(random), 5}, Vector3<double>::Zero()});
    if (tick == 4000) arm.push({});
    if (tick == 4500) arm.hold({});
    const Situation now = tick < 1000                                    ? kEmpty
                          : tick < 1200 || (tick >= 4500 && tick < 4700) ? kChange
                          : tick >= 4700                                 ? kEmpty
                          : tick >= 3600 && tick < 4100                  ? kPushed
                          : arm.moving()                                 ? kMoving
                                                                         : kHeld;
    const auto& sample = arm.tick();
    Status status;
    HeldArm::Vector torque;
    const double time = benchmarks::time_of([&] {
      status = estimator.update(sample);
      torque = estimator.compensation(sample.jacobian, sample.rotation);
    });
    benchmarks::keep(torque);
    if (status != Status::Ok) continue;
    if (estimator.state().updated > updated) {
      updated = estimator.state().updated;
      if (tick > 100 && phase + 1 == kPhases) times[now].mean.push_back((sum + time) / kPhases);
      phase = 0;
      sum = 0;
    } else {
      phase = std::min(phase + 1, kPhases - 1);
      sum += time;
    }
    if (tick > 100) times[now].phase[phase].push_back(time);
  }
}

}  // namespace

int main(int argc, char** argv) {
  const int events = benchmarks::quick(argc, argv) ? 2 : 400;
  std::mt19937_64 random(401);
  std::array<Times, kSituations> times;
  for (int k = 0; k < events; ++k) {
    live(random, times);
    benchmarks::rest();
  }
  benchmarks::print_head("Estimator, 7 joints, double: update() and compensation()");
  for (std::size_t s = 0; s < kSituations; ++s) {
    const std::string name = kNames[s];
    std::size_t slowest = 0, fastest = 0;
    for (std::size_t phase = 0; phase < kPhases; ++phase) {
      const double median = benchmarks::percentile(times[s].phase[phase], 0.5);
      if (median > benchmarks::percentile(times[s].phase[slowest], 0.5)) slowest = phase;
      if (median < benchmarks::percentile(times[s].phase[fastest], 0.5)) fastest = phase;
    }
    benchmarks::print_row("tick, mean over a block: " + name, times[s].mean);
    benchmarks::print_row("fastest kind of tick: " + name, times[s].phase[fastest]);
    benchmarks::print_row("slowest kind of tick: " + name, times[s].phase[slowest]);
  }
  std::printf("\nseed 401, %d arms\n", events);
}
