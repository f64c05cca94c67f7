#include <random>
#include <rme/sensing/onset.hpp>

#include "support/catch.hpp"

namespace {

using rme::Status;
using Window = rme::SampleWindow<double, 7>;
using Torque = rme::JointVector<double, 7>;

/// A window of torques as they are, without an observer's lag: signal(age) for age = size - 1 down to 0.
template <typename Signal>
Window window_of(std::size_t size, Signal&& signal) {
  rme::SampleWindowConfig config;
  config.observer_bandwidth = 0;
  Window window(1e-3, config);
  for (std::size_t age = size; age-- > 0;) {
    rme::Proprioception<double, 7> sample;
    sample.tau_ext = signal(age);
    REQUIRE(window.push(sample) == Status::Ok);
  }
  return window;
}

/// A fixed direction in joint space, of length 1.
Torque direction() {
  return Torque::LinSpaced(1, -1).normalized();
}

TEST_CASE("find_onset: a planted step is found to the sample, under noise within one", "[onset]") {
  // Means over 10 samples: one tick beside the step they differ by 0.1 of it less. Under white noise s the difference
  // of neighbouring ticks has the deviation sqrt(6) s / 10, and of ticks two apart sqrt(12) s / 10, against 0.2 of the
  // step: with a step of 2 N m and s = 0.2 N m a miss by two is 5.8 deviations away.
  const unsigned seed = 70;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  std::uniform_int_distribution<std::size_t> anywhere(9, 509);
  for (const double noise : {0.0, 0.02, 0.05, 0.1, 0.2}) {
    for (int k = 0; k < 100; ++k) {
      const std::size_t planted = anywhere(random);  // age of the first sample after the step
      CAPTURE(noise, k, planted);
      const Window window = window_of(520, [&](std::size_t age) {
        const Torque rest = Torque::Constant(0.7) + noise * Torque::NullaryExpr([&] { return n(random); });
        return age <= planted ? Torque(rest + 2 * direction()) : rest;
      });
      const auto onset = rme::find_onset(window, 520, 10);
      const std::size_t miss = onset.age > planted ? onset.age - planted : planted - onset.age;
      CHECK(miss <= (noise > 0 ? 1u : 0u));
      CHECK(onset.sharp());
      // Two means of ten: each joint's difference has the deviation sqrt(2 / 10) noise; five of these.
      CHECK(onset.jump == Approx(2).margin(5 * noise * std::sqrt(7 * 0.2) + 1e-12));
    }
  }
}

TEST_CASE("find_onset: a slow hand-over is not sharp", "[onset]") {
  // A ramp of slope c per tick: means 10 apart differ by 10 c everywhere, those at the ends of 520 samples by 510 c.
  const double slope = 0.01;
  const Window ramp = window_of(520, [&](std::size_t age) { return Torque(-slope * double(age) * direction()); });
  const auto onset = rme::find_onset(ramp, 520, 10);
  CHECK(onset.jump == Approx(10 * slope));
  CHECK(onset.total == Approx(510 * slope));
  CHECK_FALSE(onset.sharp());
}

TEST_CASE("find_onset: noise and swaying have no sharp onset", "[onset]") {
  const unsigned seed = 71;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    const double frequency = 0.005 + 0.0001 * k;  // 5 to 25 rad/s
    const Window noise =
        window_of(200, [&](std::size_t) { return Torque(Torque::NullaryExpr([&] { return n(random); })); });
    CHECK_FALSE(rme::find_onset(noise, 200, 10).sharp());
    const Window sway =
        window_of(200, [&](std::size_t age) { return Torque(std::sin(frequency * double(age) + k) * direction()); });
    CHECK_FALSE(rme::find_onset(sway, 200, 10).sharp());
  }
}

TEST_CASE("find_onset: only the range asked for is searched, and too few samples have no onset", "[onset]") {
  const auto two_steps = [](std::size_t age) {  // 5 N m at age 300, 1 N m at age 50
    return Torque((age <= 300 ? 5.0 : 0.0) * direction() + (age <= 50 ? 1.0 : 0.0) * direction());
  };
  const Window window = window_of(400, two_steps);
  CHECK(rme::find_onset(window, 400, 10).age == 300);
  CHECK(rme::find_onset(window, 1000, 10).age == 300);  // more than there are: all of them
  CHECK(rme::find_onset(window, 200, 10).age == 50);
  CHECK(rme::find_onset(window, 19, 10).jump == 0);
  CHECK(rme::find_onset(window, 400, 0).jump == 0);
  CHECK(rme::find_onset(window_of(19, two_steps), 400, 10).jump == 0);
  CHECK_FALSE(rme::find_onset(window_of(19, two_steps), 400, 10).sharp());
}

TEST_CASE("unrest: is the largest distance between the means of the quarters", "[onset]") {
  const Window still = window_of(200, [](std::size_t) { return Torque(3 * direction()); });
  CHECK(rme::unrest(still, 200) < 1e-12);
  // 2 N m more in the oldest quarter alone.
  const Window step = window_of(200, [](std::size_t age) { return Torque((age >= 150 ? 2.0 : 0.0) * direction()); });
  CHECK(rme::unrest(step, 200) == Approx(2));
  CHECK(rme::unrest(step, 148) < 1e-12);  // the step lies before
  // A pulse in the second quarter: first and last quarter agree.
  const Window pulse =
      window_of(200, [](std::size_t age) { return Torque((age >= 50 && age < 100 ? 2.0 : 0.0) * direction()); });
  CHECK(rme::unrest(pulse, 200) == Approx(2));
  // A ramp: the middles of the outer quarters lie 150 ticks apart.
  const Window ramp = window_of(200, [](std::size_t age) { return Torque(0.01 * double(age) * direction()); });
  CHECK(rme::unrest(ramp, 200) == Approx(1.5));
  CHECK(rme::unrest(ramp, 3) == 0);
}

static_assert(noexcept(rme::find_onset(std::declval<const Window&>(), 1, 1)));
static_assert(noexcept(rme::unrest(std::declval<const Window&>(), 1)));

}  // namespace
