#include <cmath>
#include <random>
#include <rme/tracking/torque_block.hpp>
#include <vector>

#include "support/catch.hpp"

namespace {

constexpr int kDofs = 3;
using Averager = rme::BlockAverager<double, kDofs>;
using Block = rme::TorqueBlock<double, kDofs>;
using Sample = rme::Proprioception<double, kDofs>;
using Joints = rme::JointVector<double, kDofs>;
const Eigen::Vector3d kGravity(0, 0, -9.81);

/// Somewhere, turned.
Sample at_rest() {
  Sample s;
  s.jacobian << 0.1, 0.4, 0.2, 0.5, -0.1, 0.1, 0.3, 0.2, -0.3, 0, 0.6, 0.8, 0.6, 0, 0.6, 0.8, 0.8, 0;
  s.rotation = Eigen::AngleAxisd(0.7, Eigen::Vector3d(1, 2, 3).normalized()).toRotationMatrix();
  return s;
}

/// Velocity of joints that swing at 2.5 to 3.3 Hz [rad/s], k ms after the start.
Joints smooth_velocity(int k) {
  return Joints(std::sin(0.016 * k), 0.7 * std::cos(0.018 * k), std::sin(1 - 0.021 * k));
}

/// An observer by Euler's rule with its own period of 1 ms, as arms have it: r += K p (tau - r). tau of the period that
/// ends at `k` ms. A host that is slower, or loses samples, sees some of its outputs.
struct Observer {
  double bandwidth = 50;
  Joints r = Joints::Zero();
  const Joints& operator()(const Joints& tau) { return r += bandwidth * 1e-3 * (tau - r); }
};

/// Blocks that an averager makes of what a host sees of 1 kHz.
template <typename Torque, typename Seen>
std::vector<Block> blocks_of(int milliseconds, Torque&& torque, Seen&& seen, double bandwidth = 50) {
  Averager averager(bandwidth, kGravity);
  Observer observer{bandwidth};
  Sample s = at_rest();
  std::vector<Block> blocks;
  int last = 0;
  for (int k = 0; k <= milliseconds; ++k) {
    s.tau_ext = k == 0 ? observer.r : observer(torque(k));
    if (!seen(k)) continue;
    if (averager.add(s, k == 0 ? 1e-3 : 1e-3 * (k - last), 1e-3 * k)) blocks.push_back(averager.block());
    last = k;
  }
  return blocks;
}

bool always(int) {
  return true;
}

TEST_CASE("BlockContext: by default nothing is known of the block, and every kind of sensing is likely", "[block]") {
  const rme::BlockContext<double, kDofs> context;
  CHECK_FALSE(context.exchange_likely);
  CHECK(context.log_share == 0);
  CHECK_FALSE(context.friction_shows);
  CHECK(context.compensation_change.isZero(0));
  CHECK(Block().observer_time == Approx(1 / 50.0));
}

TEST_CASE("BlockAverager: a step of the torque is there in full from the first block after it", "[block]") {
  const Joints before(0.3, -0.2, 0.1), after(4, -7, 2);
  const auto torque = [&](int k) { return k <= 40 ? before : after; };  // the third block's first sample is k = 41
  const auto blocks = blocks_of(100, torque, always);
  REQUIRE(blocks.size() == 5);
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    CAPTURE(i);
    CHECK((blocks[i].tau - (i < 2 ? before : after)).norm() < 1e-12);
    CHECK(blocks[i].duration == Approx(0.02).epsilon(1e-12));
    CHECK(blocks[i].end == Approx(0.02 * double(i + 1)).epsilon(1e-12));
  }
  // Without a filter it is the mean of what is reported.
  Averager plain(0, kGravity);
  Sample s = at_rest();
  for (int k = 0; k <= 20; ++k) {
    s.tau_ext = Joints::Constant(k);
    CHECK(plain.add(s, 1e-3, 1e-3 * k) == (k == 20));
    CHECK(plain.torque() == s.tau_ext);
  }
  CHECK((plain.block().tau - Joints::Constant(10.5)).norm() < 1e-12);  // of 1 to 20; the first one has no period
  // A lag is counted in time constants of the stated observer.
  CHECK(blocks_of(20, torque, always, 25).front().observer_time == Approx(0.04));
  CHECK(plain.block().observer_time == Approx(0.02));
}

TEST_CASE("BlockAverager: after restart() comes a short block, and nothing is in it of what was before", "[block]") {
  const Joints before(0.3, -0.2, 0.1), after(4, -7, 2);
  Averager averager(50, kGravity);
  Observer observer;
  Sample s = at_rest();
  std::vector<Block> blocks;
  for (int k = 0; k <= 84; ++k) {
    if (k > 0) s.tau_ext = observer(k <= 51 ? before : after);  // in the middle of the third block
    if (averager.add(s, 1e-3, 1e-3 * k)) blocks.push_back(averager.block());
    if (k == 54) averager.restart();
  }
  REQUIRE(blocks.size() == 4);
  const double ends[] = {0.02, 0.04, 0.064, 0.084}, durations[] = {0.02, 0.02, 0.01, 0.02};
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    CAPTURE(i);
    CHECK((blocks[i].tau - (i < 2 ? before : after)).norm() < 1e-11);
    CHECK(blocks[i].end == Approx(ends[i]).epsilon(1e-12));
    CHECK(blocks[i].duration == Approx(durations[i]).epsilon(1e-12));
    CHECK(blocks[i].usual == (i == 2 ? 0.02 : 0));
    CHECK(blocks[i].skipped == Approx(i == 2 ? 0.014 : 0).margin(1e-12));
    CHECK(blocks[i].elapsed() == Approx(ends[i] - (i > 0 ? ends[i - 1] : 0)).epsilon(1e-12));
  }
}

TEST_CASE(
    "BlockAverager: with noise of dq, a block after hurry() is 20 ms long, and one after restart() half as long as "
    "others",
    "[block]") {
  const unsigned seed = 533;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Averager averager(50, kGravity);
  Sample s = at_rest();
  std::vector<Block> blocks;
  for (int k = 0; blocks.size() < 104; ++k) {
    s.dq = Joints::NullaryExpr([&] { return 2e-3 * normal(random); });
    if (!averager.add(s, 1e-3, 1e-3 * k)) continue;
    blocks.push_back(averager.block());
    if (blocks.size() == 100) averager.hurry();
    if (blocks.size() == 102) averager.restart();
  }
  const double usual = blocks[99].duration;
  CHECK(usual > 0.03);
  CHECK(blocks[99].usual == 0);
  CHECK(blocks[100].duration == Approx(0.02).epsilon(1e-12));
  CHECK(std::abs(blocks[100].usual - usual) < 2e-3);
  CHECK(blocks[100].skipped == 0);
  CHECK(std::abs(blocks[101].duration - usual) < 2e-3);
  CHECK(blocks[101].usual == 0);
  CHECK(std::abs(blocks[102].duration - 0.5 * usual) < 2e-3);
  CHECK(std::abs(blocks[102].usual - usual) < 2e-3);
}

TEST_CASE("BlockAverager: a host with one sample per block has no shorter ones after restart()", "[block]") {
  Averager averager(50, kGravity);
  Sample s = at_rest();
  for (int k = 0; k <= 6; ++k) {
    s.dq = Joints(0.1, -0.2, 0.3) * k;
    CHECK(averager.add(s, 0.02, 0.02 * k) == (k > 0));
    if (k == 3) averager.restart();
    if (k == 0) continue;
    // Its velocity is that of each quarter.
    CHECK((averager.block().velocities.colwise() - averager.block().velocity).norm() < 1e-12);
    CHECK(averager.block().velocity[2] == Approx(0.3 * k));
    CHECK(averager.block().usual == 0);
    CHECK(averager.block().duration == Approx(0.02).epsilon(1e-12));
  }
}

TEST_CASE("BlockAverager: there are blocks however often it is told to begin anew, and their times add up", "[block]") {
  Averager averager(50, kGravity);
  const Sample s = at_rest();
  int blocks = 0;
  double elapsed = 0;
  for (int k = 0; k <= 200; ++k) {
    if (averager.add(s, 1e-3, 1e-3 * k)) {
      ++blocks;
      elapsed += averager.block().elapsed();
      CHECK(elapsed == Approx(1e-3 * k).epsilon(1e-12));
    }
    averager.restart();
  }
  CHECK(blocks == 20);  // of 10 ms
}

TEST_CASE("BlockAverager: a slower host, or one that loses samples, gets the same blocks", "[block]") {
  // A torque that changes at the edges of blocks alone: within them any average of it is the same.
  const auto torque = [](int k) {
    const double step = (k - 1) / 20;
    return Joints(1 + step, std::sin(step), -2 * step);
  };
  const auto full = blocks_of(200, torque, always);
  const auto at_250 = blocks_of(200, torque, [](int k) { return k % 4 == 0; });
  const auto at_100 = blocks_of(200, torque, [](int k) { return k % 10 == 0; });
  const unsigned seed = 520;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::bernoulli_distribution loses(0.3);
  // What comes last in a block has to be seen, or the block would end half a gap earlier.
  const auto lossy = blocks_of(200, torque, [&](int k) { return k % 20 == 0 || k % 20 > 15 || !loses(random); });
  for (const auto& blocks : {full, at_250, at_100, lossy}) {
    REQUIRE(blocks.size() == 10);
    for (std::size_t i = 0; i < blocks.size(); ++i) {
      CAPTURE(i);
      CHECK((blocks[i].tau - torque(int(20 * i) + 1)).norm() < 1e-11);
      CHECK(blocks[i].duration == Approx(0.02).epsilon(1e-9));
    }
  }
}

TEST_CASE("BlockAverager: of a torque that swings at 2 Hz a slow host's blocks are off by less than 2 %", "[block]") {
  // At 100 Hz the inverse weighs the ten periods by 0.95^age, a mean age of 4.1 ms instead of 4.5: 0.4 ms of 2 Hz are
  // 0.5 %.
  const auto torque = [](int k) { return Joints::Constant(3 * std::sin(2 * 3.141592653589793 * 2e-3 * k)); };
  const auto full = blocks_of(2000, torque, always);
  const auto slow = blocks_of(2000, torque, [](int k) { return k % 10 == 0; });
  REQUIRE(full.size() == slow.size());
  for (std::size_t i = 0; i < full.size(); ++i) CHECK((full[i].tau - slow[i].tau).cwiseAbs().maxCoeff() < 0.06);
}

TEST_CASE("BlockAverager: white noise of the sensor stays white, and averages out but for the weights' sixth part",
          "[block]") {
  const unsigned seed = 521;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  const auto noise = [&](int) { return Joints(Joints::NullaryExpr([&] { return 0.1 * n(random); })); };
  const auto blocks = blocks_of(100'000, noise, always);
  REQUIRE(blocks.size() == 5000);
  double square = 0, product = 0;
  for (std::size_t i = 1; i < blocks.size(); ++i) {
    square += blocks[i].tau.squaredNorm() / (kDofs * 4999);
    product += blocks[i].tau.dot(blocks[i - 1].tau) / (kDofs * 4999);
  }
  // 0.1^2 / 20 times the mean square of 6 s (1 - s), which is 1.2; by 15,000 numbers: 1.2 % of standard deviation, and
  // 0.8 % of correlation.
  CHECK(square == Approx(1.2 * 0.01 / 20).epsilon(0.05));
  CHECK(std::abs(product / square) < 0.04);
}

TEST_CASE("BlockAverager: the flange's acceleration is the weighted mean of the changes of its velocity", "[block]") {
  // At one place, so that the regressor of the mass is J^T (g - a), a the mean over the block. The velocity is smooth, so
  // that it has nearly no noise: its second differences are 3e-4 of it.
  Averager averager(50, kGravity, Averager::kDuration);
  Sample s = at_rest();
  Eigen::Vector3d last = Eigen::Vector3d::Zero(), change = Eigen::Vector3d::Zero();
  double weight = 0;
  Joints sum = Joints::Zero();
  bool first = true;
  int blocks = 0;
  for (int k = 0; k <= 200; ++k) {
    s.dq = smooth_velocity(k);
    const Eigen::Vector3d v = s.jacobian.topRows<3>() * s.dq;
    if (!first) {
      const double along = ((k - 1) % 20 + 0.5) / 20, shape = std::max(0.05, 6 * along * (1 - along));
      change += shape * (v - last);
      weight += 1e-3 * shape;
      sum += s.dq;
    }
    last = v;
    first = false;
    if (!averager.add(s, 1e-3, 1e-3 * k)) continue;
    ++blocks;
    const auto& block = averager.block();
    const Joints expected = s.jacobian.topRows<3>().transpose() * (kGravity - change / weight);
    CHECK((block.regressor.col(0) - expected).norm() < 1e-6 * expected.norm());
    CHECK((block.velocity - sum / 20).norm() < 1e-12);
    CHECK((block.velocities.rowwise().mean() - sum / 20).norm() < 1e-12);  // four parts of the same length
    change.setZero();
    weight = 0;
    sum.setZero();
  }
  CHECK(blocks == 10);
}

TEST_CASE("BlockAverager: in a steady turn the regressor is that of the turn", "[block]") {
  // One joint turns at a constant rate about the world's z axis: omega and no acceleration of the origin, which lies on
  // the axis.
  Averager averager(0, kGravity);
  Sample s;
  s.jacobian.setZero();
  s.jacobian(5, 0) = 1;
  s.dq << 2, 0, 0;
  rme::FlangeMotion<double> motion;
  motion.angular_velocity << 0, 0, 2;
  Joints expected = Joints::Zero();
  const rme::InertialVector<double> phi =
      (rme::InertialVector<double>() << 1, 0.1, 0.05, 0.1, 0.02, 0.001, 0, 0.02, 0, 0.03).finished();
  for (int k = 0; k <= 20; ++k) {
    s.rotation = Eigen::AngleAxisd(2e-3 * k, Eigen::Vector3d::UnitZ()).toRotationMatrix();
    if (k > 0 && k % 5 == 0)  // at the ends of the four parts
      expected +=
          s.jacobian.transpose() * (rme::inertial_wrench_regressor<double>(s.rotation, kGravity, motion) * phi) / 4;
    averager.add(s, 1e-3, 1e-3 * k);
  }
  CHECK((averager.block().regressor * phi - expected).norm() < 1e-12);
}

TEST_CASE("BlockAverager: motion that the host gives is used instead of differences", "[block]") {
  const unsigned seed = 523;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  Averager averager(50, kGravity);
  Sample s = at_rest();
  Eigen::Vector3d mean = Eigen::Vector3d::Zero();
  double weight = 0;
  for (int k = 0; k <= 20; ++k) {
    s.dq = Joints(u(random), u(random), u(random));  // nonsense
    const Eigen::Vector3d a(3, u(random), -2);
    s.motion = rme::FlangeMotion<double>{{0, 0, 0.5}, a, {0, 1, 0}};
    const double along = (k - 0.5) / 20, shape = std::max(0.05, 6 * along * (1 - along));
    if (k > 0) mean += shape * a;
    if (k > 0) weight += shape;
    averager.add(s, 1e-3, 1e-3 * k);
  }
  const rme::FlangeMotion<double> motion{{0, 0, 0.5}, mean / weight, {0, 1, 0}};
  const auto Y = rme::inertial_wrench_regressor<double>(s.rotation, kGravity, motion);
  CHECK((averager.block().regressor - s.jacobian.transpose() * Y).norm() < 1e-11);
}

TEST_CASE("BlockAverager: blocks are 20 ms long to a period, however the periods jitter", "[block]") {
  const unsigned seed = 524;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (const double period : {0.5e-3, 1e-3, 2e-3, 4e-3, 5e-3}) {
    CAPTURE(period);
    // A block ends with the first sample after which less than half a period is missing: no sooner than 1.4 / 2 periods
    // before its time, and at most 1.4 periods after a sample that came 0.6 / 2 periods too early for it.
    std::uniform_real_distribution<double> u(0.6 * period, 1.4 * period);
    Averager averager(50, kGravity);
    double time = 0, total = 0;
    int blocks = 0;
    while (time < 4) {
      const double dt = u(random);
      time += dt;
      if (!averager.add(at_rest(), dt, time)) continue;
      ++blocks;
      total += averager.block().duration;
      CHECK(averager.block().duration > 0.02 - 0.7 * period - 1e-12);
      CHECK(averager.block().duration < 0.02 + 1.1 * period + 1e-12);
      CHECK(averager.block().end == time);
    }
    CHECK(total / blocks == Approx(0.02).epsilon(0.02));
  }
}

TEST_CASE("BlockAverager: the rate of a torque is that of tau_ext as it comes, whatever the bandwidth and the period",
          "[block]") {
  const Joints rate(3, -2, 0);
  for (const double bandwidth : {0.0, 50.0}) {
    for (const double period : {1e-3, 4e-3}) {
      CAPTURE(bandwidth, period);
      Averager averager(bandwidth, kGravity);
      Sample s = at_rest();
      int blocks = 0;
      for (int k = 0; k < 200; ++k) {
        s.tau_ext = Joints::Constant(0.4) + rate * (period * k);
        if (!averager.add(s, period, period * k)) continue;
        ++blocks;
        // Each change of a ramp is as large as the last one, as if the torque were quantised: that may be its noise.
        if (blocks > 1) CHECK((averager.block().torque_rate - rate).norm() < 0.04 * rate.norm());
      }
      CHECK(blocks >= 9);
    }
  }
}

TEST_CASE("BlockAverager: the torque's resolution and the noise of dq are measured", "[block]") {
  const unsigned seed = 525;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  Averager averager(50, kGravity, Averager::kDuration);
  Sample s = at_rest();
  const Joints noise(1e-3, 3e-3, 0);
  Joints mean = Joints::Zero();
  int blocks = 0;
  for (int k = 0; k <= 20'000; ++k) {
    s.tau_ext = Joints(0.05 * std::round(10 * n(random)), 0.02 * std::round(10 * n(random)), 0);
    // A steady acceleration is no noise.
    for (int j = 0; j < kDofs; ++j) s.dq[j] = 1e-4 * k + noise[j] * n(random);
    if (!averager.add(s, 1e-3, 1e-3 * k)) continue;
    ++blocks;
    if (blocks > 400) mean += averager.block().velocity_noise / 600;  // it has a memory of some fifty blocks
  }
  REQUIRE(blocks == 1000);
  CHECK((averager.block().torque_step - Joints(0.05, 0.02, 0)).norm() < 1e-12);
  for (int j = 0; j < 2; ++j) CHECK(mean[j] == Approx(noise[j] * noise[j]).epsilon(0.05));
  CHECK(mean[2] < 1e-11);  // where learning begins is forgotten
}

TEST_CASE("BlockAverager: a velocity within the resolution of dq is none", "[block]") {
  // Rounded down in steps of 10 mrad/s, and half a step added, as motors on a bus do: at rest a joint says 5 mrad/s, or
  // -5 mrad/s, and nothing changes.
  constexpr double kStep = 0.01;
  const auto reported = [](double v) { return kStep * (std::floor(v / kStep) + 0.5); };
  Averager averager(50, kGravity, Averager::kDuration);
  Sample s = at_rest();
  const auto run = [&](int from, int to, const Joints& at, const Joints& faster) {  // ms; [rad/s], [rad/s^2]
    for (int k = from; k < to; ++k) {
      s.dq = (at + 1e-3 * (k - from) * faster).unaryExpr(reported);
      (void)averager.add(s, 1e-3, 1e-3 * k);
    }
    return averager.block();
  };
  const Joints rest(0, -1e-6, 0), starts(1, -1, 0);
  Block block = run(0, 100, rest, Joints::Zero());  // no change yet
  CHECK((block.velocity == Joints::Zero() && block.velocities.isZero()));
  block = run(100, 201, rest, starts);
  CHECK(block.velocity[0] == Approx(0.09).margin(0.006));
  CHECK(block.velocity[1] == Approx(-0.09).margin(0.006));
  block = run(201, 301, 0.02 * starts, Joints::Zero());  // slow, but moving
  CHECK(block.velocity[0] == Approx(0.02).margin(0.006));
  CHECK(block.velocities(1, 3) == Approx(-0.02).margin(0.006));
  block = run(301, 401, rest, Joints::Zero());
  CHECK((block.velocity == Joints::Zero() && block.velocities.isZero()));
}

/// Blocks of an arm that moves evenly, its dq under white noise, of one joint that lifts the flange by 0.5 m/rad.
std::vector<Block> noisy_blocks(double noise, unsigned seed, double acceleration, int milliseconds) {
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  Averager averager(0, kGravity);
  Sample s;
  s.jacobian(2, 0) = 0.5;
  std::vector<Block> blocks;
  for (int k = 0; k <= milliseconds; ++k) {
    s.dq[0] = acceleration * 1e-3 * k + noise * n(random);
    if (averager.add(s, 1e-3, 1e-3 * k)) blocks.push_back(averager.block());
  }
  return blocks;
}

TEST_CASE("BlockAverager: the noisier dq is, the longer is a block, to three times what it is otherwise", "[block]") {
  const auto length = [](double noise) { return noisy_blocks(noise, 526, 0, 8000).back().duration; };
  CHECK(length(0) == Approx(0.02).epsilon(1e-6));
  CHECK(length(1e-4) == Approx(0.02).epsilon(1e-6));
  // 12 sigma^2 dt / T^3 = 0.02^2 for sigma = 0.5 m * 2 mrad/s: 31 ms.
  CHECK(length(2e-3) == Approx(0.031).margin(0.004));
  CHECK(length(2e-2) == Approx(0.06).epsilon(1e-6));
}

TEST_CASE("BlockAverager: acceleration is the least-squares slope of J dq, with no more noise than that lets through",
          "[block]") {
  const double noise = 2e-2, acceleration = 1.2;
  const unsigned seed = 527;
  CAPTURE(seed);
  const auto blocks = noisy_blocks(noise, seed, acceleration, 60'000);
  double sum = 0, squares = 0;
  int count = 0;
  for (const Block& block : blocks) {
    if (block.end < 4) continue;
    // The torque of a kilogram: J^T (g - a).
    const double a = -9.81 - block.regressor(0, 0) / 0.5;
    sum += a;
    squares += a * a;
    ++count;
  }
  const double mean = sum / count, deviation = std::sqrt(squares / count - mean * mean);
  // Of 60 samples, 1 ms apart: sigma sqrt(12 / n^3) / dt, where the difference of two ends has sigma sqrt(2) / (n dt).
  const double slope = 0.5 * noise * std::sqrt(12 / (60.0 * 60 * 60)) / 1e-3;
  CHECK(std::abs(mean - 0.5 * acceleration) < 4 * deviation / std::sqrt(count));
  CHECK(deviation == Approx(slope).epsilon(0.08));
}

TEST_CASE("BlockAverager: after clear() the next sample is a first one", "[block]") {
  Averager averager(50, kGravity);
  Sample s = at_rest();
  for (int k = 0; k < 13; ++k) averager.add(s, 1e-3, 1e-3 * k);
  averager.clear();
  s.tau_ext.setConstant(9);
  for (int k = 0; k <= 20; ++k) CHECK(averager.add(s, 1e-3, 1 + 1e-3 * k) == (k == 20));
  // No jump from the sample before, which the observer's inverse would blow up to 9 / 0.05.
  CHECK((averager.block().tau - Joints::Constant(9)).norm() < 1e-12);
  CHECK(averager.block().velocity.isZero(0));
}

TEST_CASE("BlockAverager: torque and regressor of an arm that turns belong to the same instant", "[block]") {
  // A weight with a lever, turned about a horizontal axis: the mean torque over a block is the regressor's, to a few parts
  // in ten thousand. In the pose at the end of each quarter it would be off by a hundred times as much.
  for (const double rate : {1.5, -2.0}) {
    CAPTURE(rate);
    Averager averager(0, kGravity, Averager::kDuration);
    rme::InertialVector<double> phi = rme::InertialVector<double>::Zero();
    phi.head<4>() << 1.0, 0.1, 0.05, 0.2;
    rme::FlangeMotion<double> motion;
    motion.angular_velocity = {rate, 0, 0};
    Sample s = at_rest();
    s.motion = motion;
    double torque = 0, moment = 0;
    for (int k = 0; k <= 20; ++k) {
      // The torque of a sample is the mean since the one before.
      const auto at = [&](double ms) { return Eigen::AngleAxisd(rate * 1e-3 * ms, Eigen::Vector3d::UnitX()); };
      s.rotation = at(k - 0.5).toRotationMatrix();
      s.tau_ext = s.jacobian.transpose() * rme::inertial_wrench_regressor<double>(s.rotation, kGravity, motion) * phi;
      s.rotation = at(k).toRotationMatrix();
      averager.add(s, 1e-3, 1e-3 * k);
    }
    const auto& block = averager.block();
    torque = (block.tau - block.regressor * phi).norm();
    moment = rate * 0.01 * block.tau.norm();
    CHECK(torque < 0.01 * std::abs(moment));
  }
}

TEST_CASE("BlockAverager: each quarter of a block has its own velocity, and its own motion in the regressor",
          "[block]") {
  // (T9) sample by sample: weights 6 s (1 - s), velocity of the flange the mean of a period's two ends, acceleration
  // the weighted changes; the regressor is that of each quarter in the mean pose of its two ends, by its weight.
  Averager averager(0, kGravity, Averager::kDuration);
  Sample s = at_rest();
  Eigen::Matrix<double, 6, 1> last;
  Eigen::Matrix<double, kDofs, rme::kInertial> expected = decltype(expected)::Zero();
  Eigen::Matrix<double, kDofs, rme::kBlockParts> velocities = decltype(velocities)::Zero();
  double total = 0, weight = 0;
  Eigen::Matrix3d begin;
  rme::FlangeMotion<double> motion;
  for (int k = 0; k <= 20; ++k) {
    s.dq = smooth_velocity(k);
    s.rotation = Eigen::AngleAxisd(0.1 * k, Eigen::Vector3d::UnitX()).toRotationMatrix();
    if (k == 0) begin = s.rotation;
    const Eigen::Matrix<double, 6, 1> twist = s.jacobian * s.dq;
    if (k > 0) {
      const double along = (k - 0.5) / 20, shape = std::max(0.05, 6 * along * (1 - along));
      weight += 1e-3 * shape;
      motion.linear_acceleration += shape * (twist - last).head<3>();
      motion.angular_acceleration += shape * (twist - last).tail<3>();
      motion.angular_velocity += 1e-3 * shape * (twist + last).tail<3>() / 2;
      velocities.col((k - 1) / 5) += s.dq / 5;
    }
    last = twist;
    if (k > 0 && k % 5 == 0) {
      const rme::FlangeMotion<double> mean{motion.angular_velocity / weight, motion.linear_acceleration / weight,
                                           motion.angular_acceleration / weight};
      const Eigen::Matrix3d middle = 0.5 * (begin + s.rotation);
      begin = s.rotation;
      expected += weight * s.jacobian.transpose() * rme::inertial_wrench_regressor<double>(middle, kGravity, mean);
      total += weight;
      weight = 0;
      motion = rme::FlangeMotion<double>();
    }
    averager.add(s, 1e-3, 1e-3 * k);
  }
  CHECK((averager.block().regressor - expected / total).norm() < 1e-6 * expected.norm() / total);
  CHECK((averager.block().velocities - velocities).norm() < 1e-12);
}

/// The variance of dq that an averager of one joint's velocities has learned.
template <typename Velocity>
double learned_noise(Averager& averager, int blocks, Velocity&& velocity, double dt = 1e-3) {
  Sample s = at_rest();
  for (int k = 0; blocks > 0; ++k) {
    s.dq[0] = velocity(k);
    if (averager.add(s, dt, dt * k)) --blocks;
  }
  return averager.block().velocity_noise[0];
}

TEST_CASE("BlockAverager: what counts as noise of dq begins with the first second difference", "[block]") {
  Averager steady(0, kGravity, Averager::kDuration);
  CHECK(learned_noise(steady, 1, [](int k) { return 0.01 * k; }) < 1e-20);
  steady.clear();  // from another velocity: a new life has no differences yet
  CHECK(learned_noise(steady, 1, [](int k) { return 3 - 0.02 * k; }) < 1e-20);
  // A zigzag of +-a has second differences of 4 a, which white noise of variance 16 a^2 / 6 has as well.
  const double a = 2e-5;
  Averager zigzag(0, kGravity, Averager::kDuration);
  CHECK(learned_noise(zigzag, 1, [=](int k) { return k % 2 == 0 ? a : -a; }) == Approx(16 * a * a / 6).epsilon(1e-9));
}

TEST_CASE("BlockAverager: noise of dq is known from the first block on, and a wild sample in it is soon forgotten",
          "[block]") {
  // What is not known to be noise is taken for motion.
  const unsigned seed = 531;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto noisy = [&](int) { return 3e-3 * normal(random); };
  Averager averager(0, kGravity, Averager::kDuration);
  CHECK(learned_noise(averager, 1, noisy) == Approx(9e-6).epsilon(0.7));
  CHECK(learned_noise(averager, 20, noisy) == Approx(9e-6).epsilon(0.2));
  Averager wild(0, kGravity, Averager::kDuration);
  CHECK(learned_noise(wild, 1, [&](int k) { return k == 10 ? 5.0 : noisy(k); }) < 1.01e-4);
  CHECK(learned_noise(wild, 50, noisy) == Approx(9e-6).epsilon(0.3));
}

TEST_CASE("BlockAverager: a host so slow that a block is one sample learns no noise from the first", "[block]") {
  Averager averager(0, kGravity);
  const double noise = learned_noise(
      averager, 1, [](int) { return 0.1; }, 0.02);
  CHECK(noise == Approx(1e-8));
}

TEST_CASE("BlockAverager: noise of dq is learned after a long time without any, and one outlier hardly counts",
          "[block]") {
  const unsigned seed = 529;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Averager averager(0, kGravity, Averager::kDuration);
  CHECK(learned_noise(averager, 1000, [](int) { return 0.1; }) < 1e-15);
  double least = 1;
  for (int k = 0; k < 20; ++k)
    least = std::min(least, learned_noise(averager, 20, [&](int) { return 1e-3 * normal(random); }));
  CHECK(least > 0);
  const double noise = averager.block().velocity_noise[0];
  CHECK(noise == Approx(1e-6).epsilon(0.2));
  // One block counts a fiftieth, and no more than 25 times what is known.
  CHECK(learned_noise(averager, 1, [&](int k) { return k == 10 ? 1.0 : 1e-3 * normal(random); }) < 1.5 * noise);
}

TEST_CASE("BlockAverager: after a second each block counts a fiftieth of what noise of dq is", "[block]") {
  Averager averager(0, kGravity, Averager::kDuration);
  const double a = 2e-5, larger = 16 * 4 * a * a / 6;
  (void)learned_noise(averager, 200, [=](int k) { return k % 2 == 0 ? a : -a; });
  const auto zigzag = [=](int k) { return k % 2 == 0 ? 2 * a : -2 * a; };
  const double before = learned_noise(averager, 1, zigzag);  // the change itself
  CHECK(learned_noise(averager, 1, zigzag) - before == Approx((larger - before) / 50).epsilon(1e-6));
}

TEST_CASE("BlockAverager: noise of a joint that only turns the flange makes no block longer", "[block]") {
  // The payload's weight is regressed on the flange's linear acceleration.
  const unsigned seed = 530;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Averager averager(0, kGravity);
  Sample s;
  s.jacobian.setZero();
  s.jacobian.col(0).tail<3>() << 3, 3, 3;
  for (int k = 0; k <= 4000; ++k) {
    s.dq[0] = 2e-2 * normal(random);
    averager.add(s, 1e-3, 1e-3 * k);
  }
  CHECK(averager.block().duration == Approx(0.02).epsilon(1e-6));
}

/// Flange acceleration that a block's regressor of the mass contains: J^T (g - a) of at_rest()'s Jacobian, inverted.
Eigen::Vector3d acceleration_of(const Block& block) {
  const Eigen::Matrix3d linear = at_rest().jacobian.topRows<3>();
  return kGravity - linear.transpose().inverse() * block.regressor.col(0);
}

TEST_CASE("BlockAverager: the noise of dq of an arm at rest is not in the regressor, and in motion its acceleration is",
          "[block]") {
  const unsigned seed = 532;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Averager averager(50, kGravity, Averager::kDuration), clean(50, kGravity, Averager::kDuration);
  Sample s = at_rest(), t = s;
  const double linear = s.jacobian.topRows<3>().squaredNorm(), angular = s.jacobian.bottomRows<3>().squaredNorm();
  const double slope = 12 / (20 * 0.02 * 0.02);
  double noise_in = 0, noise_left = 0, inertia_left = 0, rest_variance = 0;
  double error = 0, variance = 0, angular_variance = 0, acceleration = 0;
  for (int k = 0; k < 120'000; ++k) {
    const bool moves = k >= 60'000;
    t.dq = moves ? Joints(0.5 * smooth_velocity(k)) : Joints(Joints::Zero());
    s.dq = t.dq + Joints::NullaryExpr([&] { return 2e-3 * normal(random); });
    const bool complete = averager.add(s, 1e-3, 1e-3 * k);
    CHECK(clean.add(t, 1e-3, 1e-3 * k) == complete);
    if (!complete) continue;
    const Block& block = averager.block();
    if (!moves && k > 2000) {
      noise_in += slope * 4e-6 * linear;
      noise_left += acceleration_of(block).squaredNorm();
      inertia_left += block.regressor.rightCols<6>().squaredNorm();  // of the angular acceleration alone
      rest_variance += 3 * block.acceleration_variance;
    } else if (k > 61'000) {
      const Eigen::Vector3d a = acceleration_of(clean.block());
      error += (acceleration_of(block) - a).squaredNorm();
      acceleration += a.squaredNorm();
      variance += 3 * block.acceleration_variance;
      angular_variance += 3 * block.angular_acceleration_variance;
    }
  }
  CHECK(noise_left < 1e-4 * noise_in);
  CHECK(inertia_left < 1e-3 * noise_in);
  CHECK(rest_variance < 0.15 * noise_in);
  CHECK(error < 0.01 * acceleration);
  CHECK(variance == Approx(error).epsilon(0.15));
  CHECK(angular_variance / angular == Approx(variance / linear).epsilon(0.03));  // the same noise in all joints
}

TEST_CASE("BlockAverager: a payload at rest keeps its weight for 15 minutes, whatever the noise of dq", "[block]") {
  // An estimate of the mass beside an offset, which is all that is known at rest: only a changing acceleration could
  // tell them apart, and at rest there is none.
  const unsigned seed = 533;
  CAPTURE(seed);
  for (const double noise : {5e-4, 2e-3, 1e-2}) {
    CAPTURE(noise);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    rme::BlockAverager<double, 1> averager(0, kGravity);
    rme::Proprioception<double, 1> s;
    s.jacobian(2, 0) = 0.5;
    Eigen::Vector2d mean(1, 0);
    Eigen::Matrix2d P = Eigen::Vector2d(0.04, 0.04 * 24).asDiagonal();  // 0.2 kg, and its torque of offset
    P(0, 1) = P(1, 0) = 0;
    for (int k = 0; k <= 900'000; ++k) {
      s.dq[0] = noise * normal(random);
      s.tau_ext[0] = -0.5 * 9.81 + 0.05 * normal(random);
      if (!averager.add(s, 1e-3, 1e-3 * k)) continue;
      const Eigen::Vector2d h(averager.block().regressor(0, 0), 1);
      const double S = h.dot(P * h) + 0.012 * 0.012;
      const Eigen::Vector2d gain = P * h / S;
      mean += gain * (averager.block().tau[0] - h.dot(mean));
      P -= (gain * S * gain.transpose()).eval();
    }
    CHECK(std::abs(mean[0] - 1) < 0.01);
    CHECK(P(0, 0) > 0.9 * 0.04 * 0.5);
  }
}

TEST_CASE("BlockAverager: a motion that the host gives is not shrunk and has no variance", "[block]") {
  const unsigned seed = 534;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Averager averager(50, kGravity);
  Sample s = at_rest();
  for (int k = 0; k <= 2000; ++k) {
    s.dq = Joints::NullaryExpr([&] { return 2e-3 * normal(random); });
    s.motion = rme::FlangeMotion<double>{Eigen::Vector3d::Zero(), {0.01, 0, 0.02}, Eigen::Vector3d::Zero()};
    if (!averager.add(s, 1e-3, 1e-3 * k)) continue;
    CHECK((acceleration_of(averager.block()) - s.motion->linear_acceleration).norm() < 1e-12);
    CHECK(averager.block().acceleration_variance == 0);
    CHECK(averager.block().angular_acceleration_variance == 0);
  }
}

TEST_CASE("BlockAverager: a joint that rests while another moves adds no noise to the regressor", "[block]") {
  const unsigned seed = 535;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Averager averager(50, kGravity, Averager::kDuration);
  Sample s;
  s.jacobian(0, 0) = s.jacobian(1, 1) = 1;  // each joint along its own axis
  double moving = 0, resting = 0;
  for (int k = 0; k <= 20'000; ++k) {
    s.dq = Joints(std::sin(0.01 * k) + 2e-3 * normal(random), 2e-3 * normal(random), 0);
    if (!averager.add(s, 1e-3, 1e-3 * k) || k < 1000) continue;
    moving += std::pow(averager.block().regressor(0, 0), 2);
    resting += std::pow(averager.block().regressor(1, 0), 2);
  }
  CHECK(moving / 950 == Approx(50).epsilon(0.03));
  CHECK(resting / 950 < 1e-5);  // of 6e-3
}

TEST_CASE("BlockAverager: the rate of a torque is zero in quiet, and that of a payload that is attached in full",
          "[block]") {
  const unsigned seed = 536;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  for (const double resolution : {0.0, 0.05}) {
    CAPTURE(resolution);
    Averager averager(50, kGravity), reference(50, kGravity);
    Observer observer, clean;
    Sample s = at_rest(), t = s;
    int zero = 0, quiet = 0, steep = 0;
    for (int k = 0; k <= 10'000; ++k) {
      const Joints tau = k > 9000 ? Joints(5, -3, 2) : Joints(Joints::Zero());
      s.tau_ext = observer(tau + Joints::NullaryExpr([&] { return 0.05 * normal(random); }));
      t.tau_ext = clean(tau);
      for (int j = 0; resolution > 0 && j < kDofs; ++j)
        s.tau_ext[j] = resolution * std::round(s.tau_ext[j] / resolution);
      const bool complete = averager.add(s, 1e-3, 1e-3 * k);
      CHECK(reference.add(t, 1e-3, 1e-3 * k) == complete);
      if (!complete) continue;
      const Joints rate = averager.block().torque_rate;
      if (k > 1000 && k <= 9000) {
        ++quiet;
        zero += rate.isZero(0) ? 1 : 0;
      }
      if (k > 9000 && k <= 9060) {  // 158, 58 and 21 N m/s in the first joint
        CAPTURE(k);
        ++steep;
        const Joints full = reference.block().torque_rate;
        CHECK((rate - full).norm() < 0.02 * full.norm() + 3);
      }
    }
    CHECK(zero > 0.98 * quiet);
    CHECK(steep == 3);
  }
}

TEST_CASE("BlockAverager: the compensation is averaged like the torque, and gravity's torque is the last sample's",
          "[block]") {
  Averager averager(0, kGravity);
  Sample s = at_rest();
  for (int k = 0; k <= 100; ++k) {
    s.tau_ext = Joints(std::sin(0.1 * k), k, 1);
    s.compensation.reset();
    s.gravity_torque.reset();
    if (k <= 40) s.compensation = s.tau_ext;
    if (k > 40 && k <= 60 && k % 20 < 9) s.compensation = Joints::Constant(2);  // in the lesser part of the block
    if (k > 60 && k <= 80 && k % 20 < 15) s.compensation = Joints::Constant(2);
    if (k % 40 == 0) s.gravity_torque = Eigen::Matrix3d::Constant(k);
    if (!averager.add(s, 1e-3, 1e-3 * k)) continue;
    const Block& block = averager.block();
    CAPTURE(k);
    CHECK(block.carried.has_value() == (k == 20 || k == 40 || k == 80));
    if (k <= 40) CHECK((*block.carried - block.tau).norm() < 1e-12);
    if (k == 80) CHECK((*block.carried - Joints::Constant(2)).norm() < 1e-12);
    CHECK(block.gravity_torque.has_value() == (k % 40 == 0));
    if (block.gravity_torque) CHECK(*block.gravity_torque == Eigen::Matrix3d::Constant(k));
  }
}

TEST_CASE("BlockAverager: at 10 Hz to 10 kHz blocks hold torque, acceleration and noise of an arm", "[block]") {
  const unsigned seed = 537;
  CAPTURE(seed);
  for (const double dt : {0.1, 1 / 15.0, 0.02, 0.01, 1e-3, 1e-4}) {
    CAPTURE(dt);
    std::mt19937_64 random(seed);
    std::normal_distribution<double> normal;
    Averager averager(50, kGravity, Averager::kDuration);
    Sample s = at_rest();
    const Joints acceleration(1.5, -1, 0.5);
    // At rest, then steadily accelerated.
    const int rest = int(4 / dt) + 60, all = rest + int(1 / dt) + 10;
    double noise = 0, error = 0, variance = 0, duration = 0;
    int blocks = 0, moving = 0;
    for (int k = 0; k <= all; ++k) {
      s.dq = acceleration * dt * std::max(0, k - rest) + Joints::NullaryExpr([&] { return 1e-3 * normal(random); });
      s.tau_ext = Joints(1, 2, 3);
      const bool complete = averager.add(s, dt, dt * k);
      if (k > 0 && dt >= 0.02 - 1e-9) CHECK(complete);  // a block is one sample
      if (!complete) continue;
      const Block& block = averager.block();
      REQUIRE(block.regressor.allFinite());
      REQUIRE(std::isfinite(block.acceleration_variance));
      CHECK((block.tau - s.tau_ext).norm() < 1e-9);
      duration += block.duration;
      ++blocks;
      if (k <= rest) noise = block.velocity_noise.mean();
      if (k > rest + 0.3 / dt + 2) {
        const Eigen::Vector3d a = s.jacobian.topRows<3>() * acceleration;
        error += (acceleration_of(block) - a).squaredNorm() / 3;
        variance += block.acceleration_variance;
        ++moving;
      }
    }
    CHECK(duration / blocks == Approx(std::max(0.02, dt)).epsilon(0.2));
    CHECK(noise == Approx(1e-6).epsilon(0.5));
    REQUIRE(moving > 0);
    // The slope's noise, and no more: of two samples at worst.
    const double n = std::max(1.0, 0.02 / dt), slope = std::min(2.0, 12 / n) / std::pow(std::max(0.02, dt), 2);
    const double most = slope * 1e-6 * s.jacobian.topRows<3>().squaredNorm() / 3;
    CHECK(error / moving < 3 * most);
    CHECK(variance / moving < 2 * most);
    CHECK(variance / moving > 0.2 * most);
  }
}

TEST_CASE("BlockAverager: a slow host's uneven acceleration counts as noise of dq", "[block]") {
  // Between samples 0.1 s apart nobody knows how the acceleration changes, and the torque is of one instant.
  Averager averager(50, kGravity);
  Sample s = at_rest();
  const Eigen::Matrix3d linear = s.jacobian.topRows<3>();
  double error = 0, variance = 0, size = 0;
  for (int k = 0; k <= 600; ++k) {
    s.dq = smooth_velocity(40 * k);  // 1 to 1.3 Hz
    if (!averager.add(s, 0.1, 0.1 * k) || k < 100) continue;
    const double at = 40.0 * k;
    const Joints a(6.4 * std::cos(0.016 * at), -0.7 * 7.2 * std::sin(0.018 * at), -8.4 * std::cos(1 - 0.021 * at));
    error += (acceleration_of(averager.block()) - linear * a).squaredNorm() / 3;
    size += (linear * a).squaredNorm() / 3;
    variance += averager.block().acceleration_variance;
  }
  CHECK(error < 0.4 * size);
  CHECK(variance == Approx(error).epsilon(0.6));
}

}  // namespace
