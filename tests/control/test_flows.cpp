// The dynamical systems: linear attractor, limit cycle, orientation attractor, a host's own.
#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <rme/control/limit_cycle.hpp>
#include <rme/control/linear_attractor.hpp>
#include <rme/control/orientation_attractor.hpp>

#include "support/catch.hpp"

namespace {

using Vector3 = Eigen::Vector3d;

/// -grad V by central differences: the oracle for what a system calls its conservative part.
template <typename System>
Vector3 downhill(const System& system, const Vector3& x) {
  Vector3 slope;
  for (int i = 0; i < 3; ++i) {
    const Vector3 step = 1e-5 * Vector3::Unit(i);
    slope[i] = -(system(x + step).potential - system(x - step).potential) / 2e-5;
  }
  return slope;
}

Vector3 random_point(std::mt19937& random, double scale) {
  std::normal_distribution<double> normal;
  return scale * Vector3{normal(random), normal(random), normal(random)};
}

TEST_CASE("LinearAttractor: linear near the target, at most max_speed far from it", "[flow]") {
  rme::LinearAttractorConfig<double> config;
  config.target = {0.3, -0.1, 0.5};
  config.gain = 2;
  config.max_speed = 0.25;
  const rme::LinearAttractor<double> system(config);
  const Vector3 near(1e-4, -2e-4, 1e-4);
  CHECK((system(config.target + near).velocity + 2 * near).norm() < 1e-5 * near.norm());
  CHECK(system(config.target + Vector3(0, 1e3, 0)).velocity.y() == Approx(-0.25).epsilon(1e-6));
  // 3-4-5: k |e| / v = 3 / 4 at |e| = 0.09375, so the speed is k |e| / (5 / 4) = 0.15.
  CHECK((system(config.target + Vector3(0.09375, 0, 0)).velocity - Vector3(-0.15, 0, 0)).norm() < 1e-15);
  CHECK(system(config.target).potential == 0);
  CHECK(system(config.target).velocity == Vector3::Zero());
}

TEST_CASE("LinearAttractor and LimitCycle: the conservative part is minus the potential's gradient", "[flow]") {
  const unsigned seed = 4301;
  CAPTURE(seed);
  std::mt19937 random(seed);
  rme::LinearAttractorConfig<double> attractor;
  attractor.target = {0.1, 0.2, 0.3};
  rme::LimitCycleConfig<double> cycle;
  cycle.normal = {1, 2, -1};
  cycle.center = {0.4, 0, 0.5};
  cycle.radius = 0.3;
  cycle.angular_speed = -1.5;
  const rme::LinearAttractor<double> line(attractor);
  const rme::LimitCycle<double> circle(cycle);
  for (int i = 0; i < 100; ++i) {
    const Vector3 x = random_point(random, 0.6);
    REQUIRE((line(x).conservative - downhill(line, x)).norm() < 1e-9);
    REQUIRE((circle(x).conservative - downhill(circle, x)).norm() < 1e-9);
    REQUIRE(line(x).velocity == line(x).conservative);
    REQUIRE(line(x).potential >= 0);
    REQUIRE(circle(x).potential >= -1e-16);
  }
}

TEST_CASE("LimitCycle: trajectories end on the circle, turning about the normal at the angular speed", "[flow]") {
  const unsigned seed = 4302;
  CAPTURE(seed);
  std::mt19937 random(seed);
  rme::LimitCycleConfig<double> config;  // the paper's: in the y-z plane
  config.center = {0.4, 0, 0.5};
  config.radius = 0.12;
  config.angular_speed = 1.5;
  const rme::LimitCycle<double> system(config);
  for (int i = 0; i < 20; ++i) {
    Vector3 x = config.center + random_point(random, 0.3);
    for (int k = 0; k < 10000; ++k) x += 1e-3 * system(x).velocity;
    const Vector3 e = x - config.center;
    CHECK(std::abs(e.x()) < 1e-6);
    CHECK(e.norm() == Approx(0.12).epsilon(2e-3));  // the explicit step spirals out by a part in w^2 dt / (2 k)
    CHECK((system(x).velocity - 1.5 * Vector3::UnitX().cross(e)).norm() < 1e-3);
    CHECK(system(x).potential < 1e-6);
  }
  CHECK(system(config.center).velocity == Vector3::Zero());  // smooth at the centre
}

TEST_CASE("OrientationAttractor: turns the short way to the target, alike for both quaternions of it", "[flow]") {
  const unsigned seed = 4303;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 50; ++i) {
    rme::OrientationAttractorConfig<double> config;
    config.target = Eigen::Quaterniond::UnitRandom();
    config.gain = 3;
    const rme::OrientationAttractor<double> system(config);
    const Vector3 axis = random_point(random, 1).normalized();
    const double angle = 0.03 * (i + 1);
    // The present orientation is the target turned by `angle` about the world axis.
    const Eigen::Matrix3d R = Eigen::AngleAxisd(angle, axis) * config.target.toRotationMatrix();
    const auto flow = system(R);
    REQUIRE((flow.velocity + 3 * std::sin(angle) * axis).norm() < 1e-14);
    REQUIRE(flow.potential == Approx(3 * (1 - std::cos(angle))).margin(1e-14));
    config.target.coeffs() *= -1;
    REQUIRE((rme::OrientationAttractor<double>(config)(R).velocity - flow.velocity).norm() < 1e-14);
    // dV/dt = -f . omega for whatever angular velocity, here along each axis.
    for (int k = 0; k < 3; ++k) {
      const double h = 1e-5;
      const Eigen::Matrix3d ahead = Eigen::AngleAxisd(h, Vector3::Unit(k)) * R;
      const Eigen::Matrix3d behind = Eigen::AngleAxisd(-h, Vector3::Unit(k)) * R;
      const double slope = (system(ahead).potential - system(behind).potential) / (2 * h);
      REQUIRE(slope == Approx(-flow.conservative[k]).margin(1e-8));
    }
  }
}

TEST_CASE("flow_at: a host's callable without a potential counts as driven throughout", "[flow]") {
  const auto shear = [](const Vector3& x) -> Vector3 { return {x.y(), 0, 0}; };
  const rme::Flow<double> flow = rme::flow_at(shear, Vector3(1, 2, 3));
  CHECK(flow.velocity == Vector3(2, 0, 0));
  CHECK(flow.conservative == Vector3::Zero());
  CHECK(flow.potential == 0);
  const rme::LinearAttractor<double> attractor{rme::LinearAttractorConfig<double>{}};
  CHECK(rme::flow_at(attractor, Vector3(1, 2, 3)).conservative == attractor(Vector3(1, 2, 3)).conservative);
}

TEST_CASE("Dynamical systems: settings out of range are refused by name", "[flow]") {
  rme::LinearAttractorConfig<double> line;
  line.gain = -1;
  CHECK_THROWS_WITH(rme::LinearAttractor<double>(line), contains("LinearAttractorConfig::gain"));
  line = {};
  line.max_speed = 0;
  CHECK_THROWS_WITH(rme::LinearAttractor<double>(line), contains("max_speed"));
  rme::LimitCycleConfig<double> circle;
  circle.normal.setZero();
  CHECK_THROWS_WITH(rme::LimitCycle<double>(circle), contains("LimitCycleConfig::normal"));
  circle = {};
  circle.radius = std::numeric_limits<double>::quiet_NaN();
  CHECK_THROWS_WITH(rme::LimitCycle<double>(circle), contains("radius"));
  rme::OrientationAttractorConfig<double> turn;
  turn.target.coeffs().setZero();
  CHECK_THROWS_WITH(rme::OrientationAttractor<double>(turn), contains("unit quaternion"));
}

}  // namespace
