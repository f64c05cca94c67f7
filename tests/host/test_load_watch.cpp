#include <cmath>
#include <rme/core/compensation.hpp>
#include <rme/host/load_watch.hpp>
#include <synthetic_arm/panda.hpp>

#include "support/catch.hpp"

namespace {

using namespace rme;
using rme::examples::panda;
using Vector7 = JointVector<double, 7>;
using Watch = LoadWatch<double, 7>;

constexpr double kPeriod = 1e-3;  // [s]

/// A robot that carries a load of 1.2 kg, and reports tau_ext through an observer.
struct Robot {
  explicit Robot(double bandwidth) : bandwidth_(bandwidth), watch(bandwidth) {}
  /// @param external  what acts beside the load that the robot knows of
  void run(int ticks, const Vector7& external, double period = kPeriod) {
    for (int k = 0; k < ticks; ++k) {
      filtered_ += (1 - std::pow(1 - 0.001 * bandwidth_, period / 0.001)) * (external - filtered_);
      watch.update(filtered_, load, period);
    }
  }
  examples::Kinematics<7> at = panda().kinematics(panda().ready);
  Vector7 load = compensation_torque<double>({1.2, {0.02, 0.01, 0.15}}, at.jacobian, at.rotation);

 private:
  double bandwidth_;
  Vector7 filtered_ = Vector7::Zero();

 public:
  Watch watch;
};

TEST_CASE("LoadWatch: a load that is there is not reported missing, a dropped one is within 6 ms, at any bandwidth",
          "[host]") {
  for (const double bandwidth : {25.0, 50.0, 200.0}) {
    CAPTURE(bandwidth);
    Robot robot(bandwidth);
    robot.run(1000, Vector7::Zero());
    CHECK(robot.watch.missing() == 0);
    // Dropped: the robot's own torque is what acts now. Through the average of 4 ms, 1 - exp(-t / 4 ms) of it is seen:
    // 0.63 after 4 ms, of which 4 * 0.63 - 2 counts as missing; more than three quarters after 6 ms.
    robot.run(4, robot.load);
    CHECK(robot.watch.missing() == Approx(2 - 4 * std::exp(-1.0)).epsilon(0.01));
    robot.run(2, robot.load);
    CHECK(robot.watch.missing() == 1);
    CHECK_FALSE(robot.watch.lost());
    robot.run(235, robot.load);
    CHECK_FALSE(robot.watch.lost());
    robot.run(30, robot.load);
    CHECK(robot.watch.lost());
    robot.run(1000, Vector7::Zero());
    CHECK(robot.watch.missing() == 0);
    CHECK(robot.watch.lost());  // until it is told
    robot.watch.reset();
    CHECK_FALSE(robot.watch.lost());
  }
}

TEST_CASE("LoadWatch: periods of several milliseconds are time that passed", "[host]") {
  Robot robot(50);
  robot.run(100, Vector7::Zero(), 4 * kPeriod);
  robot.run(1, robot.load, 4 * kPeriod);
  CHECK(robot.watch.missing() == Approx(2 - 4 * std::exp(-1.0)).epsilon(0.01));
}

TEST_CASE("LoadWatch: without a filter, the torque is taken as it is", "[host]") {
  Watch watch(0);
  const Vector7 load = Vector7::Constant(-3);
  for (int k = 0; k < 4; ++k) watch.update(load, load, kPeriod);
  CHECK(watch.missing() == Approx(2 - 4 * std::exp(-1.0)).epsilon(0.01));
}

TEST_CASE("LoadWatch: a push to the side, or a heavier load, is no loss", "[host]") {
  Robot robot(50);
  Vector6<double> push;
  push << 0, 30, 0, 0, 0, 0;
  robot.run(500, robot.at.jacobian.transpose() * push);
  CHECK(robot.watch.missing() == 0);
  robot.run(500, -robot.load);
  CHECK(robot.watch.missing() == 0);
  robot.run(500, 0.4 * robot.load);  // less than half
  CHECK(robot.watch.missing() == 0);
  CHECK_FALSE(robot.watch.lost());
}

TEST_CASE("LoadWatch: somebody who lifts the object for a moment has not taken it", "[host]") {
  Robot robot(50);
  robot.run(200, robot.load);
  CHECK(robot.watch.missing() > 0.9);
  robot.run(100, Vector7::Zero());
  robot.run(200, robot.load);
  CHECK_FALSE(robot.watch.lost());
}

TEST_CASE("LoadWatch: a load that weighs next to nothing in this pose is not judged", "[host]") {
  Robot robot(50);
  robot.load *= 0.9 / robot.load.norm();
  robot.run(500, robot.load);
  CHECK(robot.watch.missing() == 0);
}

}  // namespace
