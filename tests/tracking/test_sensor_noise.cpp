#include <cmath>
#include <random>
#include <rme/tracking/sensor_noise.hpp>

#include "support/catch.hpp"

namespace {

constexpr int kDofs = 7;
using Noise = rme::SensorNoise<double, kDofs>;
using Regime = rme::FrictionRegime<double, kDofs>;
using Block = rme::TorqueBlock<double, kDofs>;
using Joints = rme::JointVector<double, kDofs>;
using rme::kind_of;
using rme::Sensing;

rme::ArmPrior<double, kDofs> prior() {
  return rme::ArmPrior<double, kDofs>::of(3);
}

/// All joints turn at this speed [rad/s].
Block moving(double speed) {
  Block block;
  block.duration = 0.02;
  block.velocity.setConstant(speed);
  block.velocities.setConstant(speed);
  block.velocity_noise.setZero();
  return block;
}

const Joints kNone = Joints::Zero();  // noise of joints that turn over

struct White {
  explicit White(unsigned seed) : random(seed) {}
  Joints operator()(const Joints& deviation) {
    Joints out;
    for (int j = 0; j < kDofs; ++j) out[j] = deviation[j] * normal(random);
    return out;
  }
  std::mt19937_64 random;
  std::normal_distribution<double> normal;
};

/// Scale of joint j's residual [N m].
double residual(const Noise& noise, int j = 0) {
  return std::sqrt(noise.residual_variance(j)) / prior().residual[j];
}

TEST_CASE("SensorNoise: white noise is learned to 10 % in a thousand blocks, from a third of the prior to ten times it",
          "[noise]") {
  for (const double factor : {0.3, 1.0, 10.0}) {
    for (const double offset : {0.0, 0.5}) {
      const unsigned seed = 540;
      CAPTURE(seed, factor, offset);
      White white(seed);
      Noise noise(kind_of(Sensing::LinkSide), prior());
      Regime regime;
      const Block block = moving(0);
      regime.update(block);
      const Joints truth = factor * prior().noise;
      // What lasts longer than a block is no noise.
      for (int k = 0; k < 1000; ++k)
        noise.learn(1, white(truth) + Joints::Constant(offset), truth.cwiseAbs2(), block, regime, kNone);
      for (int j = 0; j < kDofs; ++j) {
        CAPTURE(j);
        CHECK(std::sqrt(noise.variance(j)) == Approx(truth[j]).epsilon(0.1));
      }
    }
  }
}

TEST_CASE("SensorNoise: there is always some noise", "[noise]") {
  Noise noise(kind_of(Sensing::LinkSide), prior());
  Regime regime;
  const Block block = moving(0);
  regime.update(block);
  for (int k = 0; k < 5000; ++k) noise.learn(1, Joints::Zero(), Joints::Ones(), block, regime, kNone);
  for (int j = 0; j < kDofs; ++j) CHECK(std::sqrt(noise.variance(j)) == Approx(0.008 * prior().residual[j]));
}

/// Blocks of torque, watched; nothing is learned from them otherwise.
struct Watched {
  explicit Watched(unsigned seed) : white(seed), noise(kind_of(Sensing::LinkSide), prior()) {}
  void see(const Joints& torque, const Joints& other = Joints::Zero()) {
    Block block = moving(0);
    block.tau = torque;
    noise.watch(block, other);
  }
  double deviation(int j) const { return std::sqrt(noise.variance(j)); }
  White white;
  Noise noise;
};

TEST_CASE("SensorNoise: a joint that has become much noisier is known to within two seconds, though nothing is learned",
          "[noise]") {
  const unsigned seed = 545;
  for (const double factor : {4.0, 10.0, 30.0}) {
    CAPTURE(seed, factor);
    Watched watched(seed);
    Joints truth = prior().noise;
    for (int k = 0; k < 500; ++k) watched.see(watched.white(truth));
    for (int j = 0; j < kDofs; ++j) CHECK(watched.deviation(j) == prior().noise[j]);
    truth[2] *= factor;
    for (int k = 0; k < 100; ++k) watched.see(watched.white(truth));
    CHECK(watched.deviation(2) > 0.5 * truth[2]);
    CHECK(watched.deviation(2) < 3 * truth[2]);  // what is too much is learned
    for (int j = 0; j < kDofs; ++j)
      if (j != 2) CHECK(watched.deviation(j) == prior().noise[j]);
  }
}

TEST_CASE("SensorNoise: noise that comes and goes is forgotten within ten seconds, though the old one was known well",
          "[noise]") {
  const unsigned seed = 548;
  CAPTURE(seed);
  Watched watched(seed);
  Regime regime;
  regime.update(moving(0));
  const Joints usual = prior().noise, loud = 4 * usual;
  const auto learn = [&](int blocks) {
    for (int k = 0; k < blocks; ++k) {
      const Joints torque = watched.white(usual);
      watched.see(torque);
      watched.noise.learn(1, torque, usual.cwiseAbs2(), moving(0), regime, kNone);
    }
  };
  learn(1000);
  for (int k = 0; k < 100; ++k) watched.see(watched.white(loud));
  for (int j = 0; j < kDofs; ++j) REQUIRE(watched.deviation(j) > 2 * usual[j]);
  learn(500);
  for (int j = 0; j < kDofs; ++j) CHECK(watched.deviation(j) == Approx(usual[j]).epsilon(0.4));
}

TEST_CASE("SensorNoise: an hour of white noise, events, a hand and pours are not taken for more noise", "[noise]") {
  const unsigned seed = 546;
  CAPTURE(seed);
  Watched watched(seed);
  Joints still = Joints::Zero();
  double poured = 0;
  for (int k = 0; k < 180'000; ++k) {
    const double t = 0.02 * k;
    if (k % 50 == 0) still = 5 * watched.white(Joints::Ones());  // something comes or goes, once a second
    poured += t < 1000 ? 0.01 : -0.01;
    const double hand = t < 2000 ? 0 : 3 * std::sin(2 * M_PI * 2 * t) + 2 * std::sin(2 * M_PI * 5 * t);
    watched.see(still + watched.white(prior().noise) + Joints::Constant(poured + hand));
  }
  for (int j = 0; j < kDofs; ++j) CHECK(watched.deviation(j) == prior().noise[j]);
}

TEST_CASE("SensorNoise: noise that the caller knows of is not counted a second time", "[noise]") {
  const unsigned seed = 547;
  CAPTURE(seed);
  Watched watched(seed);
  const Joints truth = 4 * prior().noise;
  for (int k = 0; k < 1000; ++k) watched.see(watched.white(truth), truth.cwiseAbs2());
  for (int j = 0; j < kDofs; ++j) CHECK(watched.deviation(j) == prior().noise[j]);
}

TEST_CASE("SensorNoise: neither an event nor a difference across a gap or an exchange counts as noise", "[noise]") {
  const unsigned seed = 541;
  CAPTURE(seed);
  White white(seed);
  Noise noise(kind_of(Sensing::LinkSide), prior());
  Regime regime;
  const Block block = moving(0);
  regime.update(block);
  for (int k = 0; k < 1000; ++k) noise.learn(1, white(prior().noise), prior().noise.cwiseAbs2(), block, regime, kNone);
  // A single jump counts for nine variances in five hundred blocks at most, and it is two differences.
  const double before = noise.variance(0);
  noise.learn(1, Joints::Constant(5), Joints::Ones(), block, regime, kNone);
  noise.learn(1, Joints::Zero(), Joints::Ones(), block, regime, kNone);
  CHECK(noise.variance(0) < 1.035 * before);
  // Interrupted, or of another payload: no difference.
  const double now = noise.variance(0);
  noise.interrupt();
  noise.learn(1, Joints::Constant(5), Joints::Ones(), block, regime, kNone);
  CHECK(noise.variance(0) == now);
  noise.learn(2, Joints::Constant(-5), Joints::Ones(), block, regime, kNone);
  CHECK(noise.variance(0) == now);
  noise.learn(2, Joints::Constant(-5), Joints::Ones(), block, regime, kNone);
  CHECK(noise.variance(0) < now);
}

TEST_CASE("SensorNoise: nothing is learned of a joint that starts, stops or turns around", "[noise]") {
  Noise noise(kind_of(Sensing::JointFriction), prior());
  Regime regime;
  Block block = moving(0.3);
  block.velocities(2, 3) = 0;  // joint 2 stops
  regime.update(block);
  REQUIRE_FALSE(regime.joint(2).steady());
  for (int k = 0; k < 50; ++k) noise.learn(1, Joints::Zero(), Joints::Ones(), block, regime, kNone);
  const auto arm = prior();
  CHECK(noise.variance(2) == arm.noise[2] * arm.noise[2]);
  CHECK(noise.variance(1) < 0.5 * arm.noise[1] * arm.noise[1]);
  // Nor is what it was in such a block compared with the next one.
  noise.learn(1, Joints::Constant(5), Joints::Ones(), block, regime, kNone);
  const Block steady = moving(0.3);
  regime.update(steady);
  noise.learn(1, Joints::Zero(), Joints::Ones(), steady, regime, kNone);
  CHECK(noise.variance(2) == arm.noise[2] * arm.noise[2]);
}

TEST_CASE("SensorNoise: the residual is learned alike, whether something is held or not", "[noise]") {
  for (const Sensing sensing : {Sensing::LinkSide, Sensing::RoughModel}) {
    for (const double sign : {1.0, -1.0}) {
      CAPTURE(sign);
      Noise empty(kind_of(sensing), prior()), held(kind_of(sensing), prior());
      const double start = residual(empty);
      Regime regime;
      const Block block = moving(0.2);
      regime.update(block);
      for (int k = 0; k < 6; ++k) {
        Joints e = Joints::Zero();
        e[0] = k % 2 == 0 ? 1 : sign;
        empty.learn(1, e, Joints::Ones(), block, regime, kNone);
        held.learn(2, e, Joints::Ones(), block, regime, kNone);
      }
      REQUIRE(std::abs(residual(empty) / start - 1) > 0.005);
      CHECK(residual(held) == residual(empty));
    }
  }
}

TEST_CASE("SensorNoise: no block moves a residual by more than 15 %, and no joint that of another", "[noise]") {
  const auto after_two_blocks = [](const Joints& first, const Joints& second, double speed, int j) {
    Noise noise(kind_of(Sensing::LinkSide), prior());
    Regime regime;
    const Block block = moving(speed);
    regime.update(block);
    noise.learn(1, first, Joints::Ones(), block, regime, kNone);
    noise.learn(1, second, Joints::Ones(), block, regime, kNone);
    return std::log(residual(noise, j) / residual(Noise(kind_of(Sensing::LinkSide), prior()), j));
  };
  Joints large = Joints::Zero(), small = Joints::Zero();
  large[2] = 100;  // counts as three standard deviations
  small[2] = 0.5;
  // Of the half second's average one block is sqrt(1 - 0.96^2).
  const double once = 4 * 0.5 * 0.5 * std::sqrt(1 - 0.96 * 0.96);
  for (const double speed : {0.1, 2.0}) {
    CAPTURE(speed);
    CHECK(after_two_blocks(large, large, speed, 2) == Approx(0.025 * 6));
    CHECK(after_two_blocks(large, -large, speed, 2) == Approx(-0.025 * 6));
    CHECK(after_two_blocks(small, small, speed, 2) == Approx(0.025 * once));
    CHECK(after_two_blocks(small, -small, speed, 2) == Approx(-0.025 * once));
    for (const int other : {0, 1, 3, 6}) CHECK(after_two_blocks(large, large, speed, other) == 0);
  }
  CHECK(after_two_blocks(small, small, 0.05 / std::sqrt(7.0), 2) ==
        Approx(0.5 * 0.025 * once).epsilon(1e-6));  // half of a full way
}

TEST_CASE("SensorNoise: links are as wrong as the residuals of all joints say", "[noise]") {
  for (const double rated : {3.0, 10.0}) {
    const auto arm = rme::ArmPrior<double, kDofs>::of(rated);
    // After residuals have been driven to `size`, within their bounds: mean square beyond the least, over gravity.
    const auto deviation = [&](const Joints& size) {
      Noise noise(kind_of(Sensing::LinkSide), arm);
      Regime regime;
      const Block block = moving(0.2);
      regime.update(block);
      const auto now = [&](int j) { return std::sqrt(noise.residual_variance(j)) / arm.residual[j]; };
      for (int k = 0; k < 4000; ++k) {
        Joints e;
        for (int j = 0; j < kDofs; ++j) e[j] = now(j) < size[j] || k % 2 == 0 ? 1 : -1;
        noise.learn(1, e, Joints::Ones(), block, regime, kNone);
      }
      double square = 0;
      for (int j = 0; j < kDofs; ++j) square += (now(j) * now(j) - 0.005 * 0.005) / kDofs;
      CHECK(noise.first_moment_variance() == Approx(square * std::pow(rated / 3 / 9.81, 2)).margin(1e-15));
      return std::sqrt(noise.first_moment_variance());
    };
    CHECK(deviation(Joints::Constant(1)) == Approx(rated / 3 * 0.1 / 9.81).epsilon(0.01));
    CHECK(deviation(Joints::Zero()) < rated / 3 * 0.003 / 9.81);
    Joints one = Joints::Zero();
    one[3] = 1;
    CHECK(deviation(one) == Approx(rated / 3 * 0.1 / 9.81 / std::sqrt(7.0)).epsilon(0.1));
    CHECK(Noise(kind_of(Sensing::RoughModel), arm).first_moment_variance() == 0);
  }
}

TEST_CASE("SensorNoise: where the model is rough, innovations smaller or larger than said tell the residual's size",
          "[noise]") {
  const unsigned seed = 544;
  CAPTURE(seed);
  const auto change = [&](double scale, double variance) {
    White white(seed);
    Noise noise(kind_of(Sensing::RoughModel), prior());
    const double start = residual(noise);
    Regime regime;
    const Block block = moving(0.2);
    regime.update(block);
    for (int k = 0; k < 30; ++k)
      noise.learn(1, white(Joints::Constant(scale * std::sqrt(variance))), Joints::Constant(variance), block, regime,
                  kNone);
    return std::log(residual(noise) / start);
  };
  const Noise wrist(kind_of(Sensing::RoughModel), prior());  // has 0.4 of it
  CHECK(wrist.residual_variance(6) == Approx(0.16 * wrist.residual_variance(0)));
  const double expected = change(1, 100);
  CHECK(std::abs(expected) < 1);
  CHECK(change(0.3, 100) < expected - 0.4);
  CHECK(change(2, 100) > expected + 0.4);
  // What the sensor's noise explains says nothing of the residual.
  const double floor = std::pow(0.008 * prior().residual.minCoeff(), 2);
  CHECK(std::abs(change(0.03, floor)) < 0.1);
}

TEST_CASE("SensorNoise: correlated innovations raise the residual, anticorrelated ones let it sink", "[noise]") {
  const unsigned seed = 542;
  CAPTURE(seed);
  for (const Sensing sensing : {Sensing::LinkSide, Sensing::JointFriction, Sensing::RoughModel}) {
    const bool rough = sensing == Sensing::RoughModel;
    const double least = rough ? 0.1 : 0.005, largest = rough ? 4 : 0.1;
    CAPTURE(rough);
    White white(seed);
    Noise up(kind_of(sensing), prior()), down(kind_of(sensing), prior()), resting(kind_of(sensing), prior());
    const double start = residual(up);
    Regime regime;
    const Block block = moving(0.2);
    regime.update(block);
    Joints e = Joints::Zero(), last = Joints::Zero();
    for (int k = 0; k < 500; ++k) {
      const Joints w = white(Joints::Ones());
      e = 0.9 * e + 0.44 * w;
      up.learn(1, e, Joints::Ones(), block, regime, kNone);
      resting.learn(1, e, Joints::Ones(), moving(0), regime, kNone);
      down.learn(1, 0.7 * (w - last), Joints::Ones(), block, regime, kNone);
      last = w;
    }
    CHECK(residual(up) > 3 * start);
    CHECK(residual(down) < std::max(1.01 * least, 0.51 * start));
    // An arm that rests shows an offset, and no residual.
    CHECK(residual(resting) == start);
    // Bounded on both sides.
    for (int k = 0; k < 20'000; ++k) {
      const Joints w = white(Joints::Ones());
      e = 0.99 * e + 0.14 * w;
      up.learn(1, e, Joints::Ones(), block, regime, kNone);
      down.learn(1, 0.7 * (w - last), Joints::Ones(), block, regime, kNone);
      last = w;
    }
    CHECK(residual(up) == Approx(largest));
    CHECK(residual(down) == Approx(least));
  }
}

TEST_CASE("SensorNoise: an innovation beyond three deviations says no more of the residual than one of three",
          "[noise]") {
  Regime regime;
  const Block block = moving(0.2);
  regime.update(block);
  const auto after = [&](double first) {
    Noise noise(kind_of(Sensing::LinkSide), prior());
    for (const double e : {first, std::copysign(0.5, first)})
      noise.learn(1, Joints::Constant(e), Joints::Ones(), block, regime, kNone);
    return residual(noise);
  };
  CHECK(after(2) < after(3));
  CHECK(after(3) == after(30));
  CHECK(after(-3) == after(3));
  CHECK(after(-30) == after(3));
}

TEST_CASE("SensorNoise: after 20 s of motion the residual is learned a tenth as fast, however long the arm has rested",
          "[noise]") {
  Regime regime;
  const Block fast = moving(0.2), rest = moving(0);
  regime.update(fast);
  const auto way_after = [&](int blocks, const Block& block) {
    Noise noise(kind_of(Sensing::LinkSide), prior());
    Joints e = Joints::Zero();  // says nothing
    for (int k = 0; k < blocks; ++k) noise.learn(1, e, Joints::Ones(), block, regime, kNone);
    const double before = residual(noise);
    REQUIRE(before == residual(Noise(kind_of(Sensing::LinkSide), prior())));
    e[0] = 1;
    for (int k = 0; k < 5; ++k) noise.learn(1, e, Joints::Ones(), fast, regime, kNone);
    return std::log(residual(noise) / before);
  };
  const double at_first = way_after(0, fast);
  REQUIRE(at_first > 0.05);
  CHECK(way_after(94, fast) == Approx(at_first));  // of a hundred blocks in all
  CHECK(way_after(95, fast) < 0.9999 * at_first);
  CHECK(way_after(400, fast) == Approx(0.25 * at_first).epsilon(0.02));
  CHECK(way_after(1000, fast) == Approx(0.1 * at_first));
  CHECK(way_after(5000, fast) == Approx(0.1 * at_first));
  CHECK(way_after(5000, rest) == Approx(at_first));
  // That of a rough model as fast as ever: it sinks as innovations vanish.
  Noise rough(kind_of(Sensing::RoughModel), prior());
  for (int k = 0; k < 5000; ++k) rough.learn(1, Joints::Constant(3), Joints::Ones(), fast, regime, kNone);
  const double before = residual(rough);
  REQUIRE(before == Approx(4));
  for (int k = 0; k < 5; ++k) rough.learn(1, Joints::Zero(), Joints::Ones(), fast, regime, kNone);
  CHECK(std::log(residual(rough) / before) == Approx(-5 * 0.025 * 3.5).epsilon(0.01));
}

TEST_CASE("SensorNoise: noise of joints that turn over is rescaled by the innovations of such blocks, within bounds",
          "[noise]") {
  const Joints kFour = Joints::Constant(4);
  Regime regime;
  const Block block = moving(0.2);
  regime.update(block);
  for (const double size : {0.3, 2.0}) {
    CAPTURE(size);
    Noise noise(kind_of(Sensing::RoughModel), prior()), other = noise;
    for (int k = 0; k < 5; ++k) {
      const Joints e = Joints::Constant(k % 2 == 0 ? 2 * size : -2 * size);
      noise.learn(1, e, kFour, block, regime, Joints::Constant(2));  // of a variance of 4, half is turning
      other.learn(1, e, kFour, block, regime, kNone);
    }
    CHECK(other.turn_scale() == 1);
    CHECK(std::log(noise.turn_scale()) ==
          Approx(5 * 0.025 * std::max(-6.0, std::min(6.0, 7 * 0.5 * (size * size - 1)))));
    for (int k = 0; k < 2000; ++k)
      noise.learn(1, Joints::Constant(2 * size), kFour, block, regime, Joints::Constant(2));
    CHECK(noise.turn_scale() == Approx(size < 1 ? 0.01 : 10));
  }
}

/// Each joint's residual by a scalar Kalman filter that believes in the scale that is being learned: what a story does.
TEST_CASE(
    "SensorNoise: residuals of known sizes, one per joint, are learned to a factor of 1.6 by filters that use them",
    "[noise]") {
  // Random walks in the logarithm of each scale: their averages over eighty seconds.
  const double keep = std::exp(-0.2 * std::sqrt(7.0) * 0.02 / 0.7);
  const auto arm = prior();
  const Joints sensor = 0.01 * arm.residual;
  Joints truth;
  truth << 0.01, 0.08, 0.03, 0.01, 0.03, 0.08, 0.01;
  const unsigned seed = 543;
  CAPTURE(seed);
  White white(seed);
  Noise noise(kind_of(Sensing::LinkSide), arm);
  Regime regime;
  const Block block = moving(0.2);
  regime.update(block);
  const Joints deviation = truth.cwiseProduct(arm.residual);
  Joints state = white(deviation), mean = Joints::Zero(), log_sum = Joints::Zero();
  Joints variance = Joints::Constant(4e-4);
  const int blocks = 6000, used = 4000;
  for (int k = 0; k < blocks; ++k) {
    state = keep * state + std::sqrt(1 - keep * keep) * white(deviation);
    const Joints y = state + white(sensor);
    Joints e, S;
    for (int j = 0; j < kDofs; ++j) {
      mean[j] *= keep;
      variance[j] = keep * keep * variance[j] + (1 - keep * keep) * noise.residual_variance(j);
      e[j] = y[j] - mean[j];
      S[j] = variance[j] + sensor[j] * sensor[j];
      mean[j] += variance[j] / S[j] * e[j];
      variance[j] -= variance[j] * variance[j] / S[j];
    }
    noise.learn(1, e, S, block, regime, kNone);
    if (k < blocks - used) continue;
    for (int j = 0; j < kDofs; ++j) log_sum[j] += std::log(residual(noise, j) / truth[j]);
  }
  for (int j = 0; j < kDofs; ++j) {
    const double ratio = std::exp(log_sum[j] / used);
    CAPTURE(j, ratio);
    CHECK(ratio > 1 / 1.6);
    CHECK(ratio < 1.6);
  }
}

}  // namespace
