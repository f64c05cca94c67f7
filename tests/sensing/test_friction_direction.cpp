#include <rme/sensing/friction_direction.hpp>

#include "support/catch.hpp"

namespace {

using Friction = rme::FrictionDirection<double, 1>;
using Vector = rme::JointVector<double, 1>;
const Eigen::Vector3d kStill = Eigen::Vector3d::Zero();

/// Coulomb friction of 0.2 N m, joints below 1e-3 rad/s rest.
Friction joint(double coulomb = 0.2) {
  return {1e-3, 1e-3, Vector(coulomb)};
}

double run(Friction& friction, double seconds, double tau, double dq, const Eigen::Vector3d& acceleration = kStill) {
  double d = 0;
  for (int k = 0; k < seconds * 1e3; ++k) d = friction.update(Vector(tau), Vector(dq), acceleration)[0];
  return d;
}

TEST_CASE("FrictionDirection: friction opposes a moving joint in full", "[friction_direction]") {
  Friction friction = joint();
  CHECK(run(friction, 0.01, 1, 0.5) == 1);
  CHECK(run(friction, 0.01, 1, -0.002) == -1);
}

TEST_CASE("FrictionDirection: a joint that stops under a steady torque keeps its direction", "[friction_direction]") {
  Friction friction = joint();
  run(friction, 0.2, 1, -0.5);
  CHECK(run(friction, 5, 1, 0) == -1);
}

TEST_CASE("FrictionDirection: at rest friction takes what the torque changes, up to its limit",
          "[friction_direction]") {
  Friction friction = joint();
  run(friction, 0.2, 1, -0.5);
  run(friction, 0.1, 1, 0);
  // tau_ext = payload - coulomb d: down by 0.1 N m is d up by half.
  CHECK(run(friction, 0.2, 0.9, 0) == Approx(-0.5).margin(1e-6));
  CHECK(run(friction, 0.2, 0.7, 0) == Approx(0.5).margin(1e-6));
  CHECK(run(friction, 0.2, 0.5, 0) == 1);
  CHECK(run(friction, 0.2, 0.9, 0) == Approx(-0.5).margin(1e-6));
  CHECK(run(friction, 0.01, 0.9, 0.1) == 1);  // and it moves again
}

TEST_CASE("FrictionDirection: while the flange accelerates a change of torque is not the friction's",
          "[friction_direction]") {
  Friction friction = joint();
  run(friction, 0.2, 1, -0.5);
  run(friction, 0.1, 1, 0);
  const Eigen::Vector3d falls(0, 0, -2);
  run(friction, 0.01, 1, 0, falls);
  CHECK(run(friction, 0.3, 0.8, 0, falls) == -1);
  CHECK(run(friction, 0.1, 0.8, 0) == Approx(-1).margin(1e-9));
  CHECK(run(friction, 0.2, 0.7, 0) == Approx(-0.5).margin(1e-6));  // from the level after the acceleration
}

TEST_CASE("FrictionDirection: more than friction can be is none of it", "[friction_direction]") {
  Friction friction = joint();
  run(friction, 0.2, 1, -0.5);
  run(friction, 3, 1, 0);
  CHECK(run(friction, 0.2, 4, 0) == Approx(-1).margin(1e-3));
  CHECK(run(friction, 0.2, 3.9, 0) == Approx(-0.5).margin(1e-3));  // and from there on it is friction again
}

TEST_CASE("FrictionDirection: while a payload comes or goes a change of torque is not the friction's",
          "[friction_direction]") {
  Friction friction = joint();
  run(friction, 0.2, 1, -0.5);
  run(friction, 3, 1, 0);
  double d = 0;
  for (int k = 0; k < 200; ++k) d = friction.update(Vector(0.9), Vector(0.0), kStill, false)[0];
  CHECK(d == Approx(-1).margin(1e-3));
  run(friction, 0.04, 0.85, 0);  // and shortly after
  CHECK(run(friction, 0.5, 0.85, 0) == Approx(-1).margin(0.01));
}

TEST_CASE("FrictionDirection: a sensor's offset that an observer takes its time to show is no friction",
          "[friction_direction]") {
  Friction friction = joint();
  friction.update(Vector(0.0), Vector(0.0), kStill);
  CHECK(run(friction, 1, -0.15, 0) == Approx(0).margin(1e-3));
}

TEST_CASE("FrictionDirection: without friction to expect, the last direction stays", "[friction_direction]") {
  Friction friction = joint(0);
  run(friction, 0.2, 1, -0.5);
  CHECK(run(friction, 0.2, 0.2, 0) == -1);
  friction.reset();
  CHECK(run(friction, 0.2, 0.2, 0) == 0);
}

TEST_CASE("FrictionDirection: what a payload did before it was noticed is taken back", "[friction_direction]") {
  Friction friction = joint();
  run(friction, 0.2, 1, -0.5);
  run(friction, 3, 1, 0);
  REQUIRE(run(friction, 0.015, 0.9, 0) > -0.7);  // it looks like friction for a while
  CHECK(friction.update(Vector(0.9), Vector(0.0), kStill, false)[0] < -0.95);
}

TEST_CASE("FrictionDirection: without friction to expect, the last direction stays while a payload comes as well",
          "[friction_direction]") {
  Friction friction = joint(0);
  run(friction, 0.15, 1, -0.5);
  for (int k = 0; k < 200; ++k) CHECK(friction.update(Vector(0.9), Vector(0.0), kStill, false)[0] == -1);
}

TEST_CASE("FrictionDirection: a torque that is there from the first sample on is no change", "[friction_direction]") {
  Friction friction = joint();
  for (int k = 0; k < 2; ++k) {
    CHECK(run(friction, 1, 50, 0) == Approx(0).margin(1e-9));
    friction.reset();
  }
}

TEST_CASE("FrictionDirection: a joint that does not move at all rests, however small the velocity that counts",
          "[friction_direction]") {
  Friction friction(1e-3, 0, Vector(0.2));
  run(friction, 0.2, 1, -1e-9);
  run(friction, 0.1, 1, 0);
  CHECK(run(friction, 0.2, 0.9, 0) == Approx(-0.5).margin(1e-6));
}

}  // namespace
