// rme/host/pinocchio.hpp. Built against a stand-in for Pinocchio, and, where it is found, against Pinocchio itself.
#include <rme/host/pinocchio.hpp>

#include <cmath>
#include <fstream>
#include <iterator>
#include <limits>
#include <pinocchio/parsers/urdf.hpp>
#include <rme/host/payload_compensation.hpp>
#include <string>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/synthetic_arm.hpp>
#include <utility>
#include <vector>

#include "support/allocation_count.hpp"
#include "support/catch.hpp"

namespace {

using rme::examples::box;
using rme::examples::panda;
using rme::examples::RigidBody;
using Vector = rme::JointVector<double, 7>;
using Arm = rme::examples::SyntheticArm<7>;
using ArmConfig = rme::examples::SyntheticArmConfig<7>;
using rme::pinocchio_arm;
using rme::PinocchioSensing;

constexpr double kPeriod = 1e-3;  // [s]

RigidBody unknown_kilogram() {
  return box(1, {0.03, -0.02, 0.16}, {0.08, 0.06, 0.1});
}

std::vector<std::string> joint_names() {
  std::vector<std::string> names;
  for (int j = 1; j <= 7; ++j) names.push_back("panda_joint" + std::to_string(j));
  return names;
}

std::string panda_urdf() {
  std::ifstream file(RME_TEST_DATA "/urdf/panda.urdf");
  return {std::istreambuf_iterator<char>(file), {}};
}

pinocchio::Model model_of(const std::string& urdf) {
  pinocchio::Model model;
  pinocchio::urdf::buildModelFromXML(urdf, model);
  return model;
}

/// Two fingers on the flange, without mass.
pinocchio::Model panda_with_hand() {
  std::string urdf = panda_urdf();
  for (const char* number : {"1", "2"}) {
    const std::string finger =
        std::string("<link name=\"panda_finger") + number + "\"/><joint name=\"panda_finger_joint" + number +
        "\" type=\"prismatic\"><parent link=\"panda_link8\"/><child link=\"panda_finger" + number +
        "\"/><axis xyz=\"0 1 0\"/><limit lower=\"0\" upper=\"0.04\" effort=\"20\" "
        "velocity=\"0.2\"/></joint>";
    urdf.insert(urdf.find("</robot>"), finger);
  }
  return model_of(urdf);
}

pinocchio::Model panda_arm() {
  return pinocchio_arm(panda_with_hand(), joint_names());
}

TEST_CASE("PinocchioSensing: sees what a moving arm's own observer, Jacobian and pose say", "[host]") {
  Arm arm(panda(), ArmConfig(), panda().ready, Vector::Constant(1));
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", kPeriod);
  arm.attach(unknown_kilogram());
  for (int k = 0; k < 200; ++k) {
    rme::Proprioception<double, 7> sample;
    REQUIRE(sensing.update(arm.q(), arm.dq(), arm.tau_measured(), kPeriod, sample) == rme::Status::Ok);
    CAPTURE(k, arm.dq().transpose());
    // Momenta differ in their last digits, and the observer divides by a millisecond.
    REQUIRE((sample.tau_ext - arm.tau_ext()).norm() < 1e-8);
    REQUIRE((sample.jacobian - arm.kinematics().jacobian).norm() < 1e-12);
    REQUIRE((sample.rotation - arm.kinematics().rotation).norm() < 1e-12);
    REQUIRE((sensing.gravity() - arm.dynamics().gravity).norm() < 1e-10);
    REQUIRE((sensing.gravity(arm.q()) - arm.dynamics().gravity).norm() < 1e-10);
    REQUIRE((sample.dq == arm.dq()));
    REQUIRE(sample.period == kPeriod);
    arm.step(arm.dynamics().gravity);
  }
}

TEST_CASE("PinocchioSensing: the gravity torque along each axis is by how much g(q) changes with gravity along it",
          "[host]") {
  // Finite differences of gravity's direction and size; g is linear in them, so that the step may be large.
  constexpr double kStep = 3;  // [m/s^2]
  rme::EstimatorConfig<double, 7> tilted;
  tilted.gravity = {2, -3, -9};
  Arm arm(panda(), ArmConfig(), panda().ready, Vector::Constant(1));
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", kPeriod, tilted);
  rme::Proprioception<double, 7> sample;
  for (int k = 0; k < 100; ++k) {
    REQUIRE(sensing.update(arm.q(), arm.dq(), arm.tau_measured(), kPeriod, sample) == rme::Status::Ok);
    arm.step(arm.dynamics().gravity);
  }
  REQUIRE(sensing.update(arm.q(), arm.dq(), arm.tau_measured(), kPeriod, sample) == rme::Status::Ok);
  REQUIRE(sample.gravity_torque.has_value());
  for (int axis = 0; axis < 3; ++axis) {
    CAPTURE(axis);
    Vector difference = Vector::Zero();
    for (const int side : {1, -1}) {
      rme::EstimatorConfig<double, 7> config = tilted;
      config.gravity[axis] += side * kStep;
      PinocchioSensing<7> other(panda_arm(), "panda_link8", kPeriod, config);
      difference += side * other.gravity(arm.q()) / (2 * kStep);
    }
    CHECK(difference.norm() > (axis == 2 ? 1 : 0.1));
    CHECK((sample.gravity_torque->col(axis) - difference).norm() < 1e-9);
  }
  CHECK((*sample.gravity_torque * tilted.gravity - sensing.gravity()).norm() < 1e-9);
}

TEST_CASE("PinocchioSensing: an external torque that the robot reports is passed on with J, R and G of the model",
          "[host]") {
  Arm arm(panda(), ArmConfig(), panda().ready, Vector::Constant(1));
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", kPeriod), observing(panda_arm(), "panda_link8", kPeriod);
  rme::Proprioception<double, 7> sample, expected;
  const Vector tau_ext = Vector::LinSpaced(7, -3, 4);
  REQUIRE(observing.update(arm.q(), arm.dq(), arm.tau_measured(), kPeriod, expected) == rme::Status::Ok);
  REQUIRE(sensing.update_external(arm.q(), arm.dq(), tau_ext, 0.003, sample) == rme::Status::Ok);
  CHECK((sample.tau_ext == tau_ext));
  CHECK((sample.jacobian == expected.jacobian));
  CHECK((sample.rotation == expected.rotation));
  CHECK((*sample.gravity_torque == *expected.gravity_torque));
  CHECK((sample.dq == arm.dq()));
  CHECK(sample.period == 0.003);
  CHECK((sensing.gravity() == observing.gravity()));
  Vector spoilt = Vector::Zero();
  spoilt[3] = std::numeric_limits<double>::quiet_NaN();
  for (const int which : {0, 1, 2}) {
    const Vector q = which == 0 ? spoilt : arm.q(), dq = which == 1 ? spoilt : arm.dq();
    CHECK(sensing.update_external(q, dq, which == 2 ? spoilt : Vector(2 * tau_ext), kPeriod, sample) ==
          rme::Status::NonFiniteInput);
  }
  CHECK((sample.tau_ext == tau_ext));
}

TEST_CASE("PinocchioSensing: takes ticks that were lost as time that passed", "[host]") {
  // An arm that falls, so that its momentum changes; three of four samples never arrive.
  Arm arm(panda(), ArmConfig(), panda().ready);
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", kPeriod), unaware(panda_arm(), "panda_link8", kPeriod);
  rme::Proprioception<double, 7> sample, other;
  for (int k = 0; k <= 200; ++k) {
    if (k % 4 == 0) {
      REQUIRE(sensing.update(arm.q(), arm.dq(), arm.tau_measured(), k == 0 ? 0 : 4 * kPeriod, sample) ==
              rme::Status::Ok);
      REQUIRE(unaware.update(arm.q(), arm.dq(), arm.tau_measured(), 0, other) == rme::Status::Ok);
    }
    arm.step(Vector(0.5 * arm.dynamics().gravity));
  }
  CHECK(arm.tau_ext().norm() < 1e-3);  // nothing touches it
  CHECK(other.tau_ext.norm() > 10);
  CHECK(sample.tau_ext.norm() < 0.05);
}

TEST_CASE("PinocchioSensing: takes motor current, of either sign, and an arm on a wall", "[host]") {
  rme::EstimatorConfig<double, 7> config;
  config.torque_sign = rme::TorqueSign::Reaction;
  config.gravity = {9.81, 0, 0};
  rme::examples::ArmModel<7> on_wall = panda();
  on_wall.gravity_vector = config.gravity;
  Arm arm(on_wall, ArmConfig(), panda().ready, Vector::Constant(1));
  arm.attach(unknown_kilogram());
  const Vector gains = (Vector() << 11, 12, 9, 10, 8, 7, 6).finished();
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", kPeriod, config, gains);
  rme::Proprioception<double, 7> sample;
  for (int k = 0; k < 200; ++k) {
    const Vector current = -arm.tau_measured().cwiseQuotient(gains);
    REQUIRE(sensing.update(arm.q(), arm.dq(), current, kPeriod, sample) == rme::Status::Ok);
    if (k < 199) arm.step(arm.dynamics().gravity);
  }
  CHECK(arm.tau_ext().norm() > 1);
  CHECK((sample.tau_ext + arm.tau_ext()).norm() < 1e-8);  // reaction: the estimator turns it round
}

TEST_CASE("Pinocchio's host, slower than an observer of 1 kHz, filters as that does", "[host]") {
  Arm arm(panda(), ArmConfig(), panda().ready);
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", 4 * kPeriod);
  rme::Proprioception<double, 7> sample;
  arm.attach(unknown_kilogram());
  double largest = 0;
  for (int k = 0; k <= 100; ++k) {
    if (k % 4 == 0) {
      REQUIRE(sensing.update(arm.q(), arm.dq(), arm.tau_measured(), 0, sample) == rme::Status::Ok);
      CAPTURE(k);
      // By Euler's rule over its own period it would be ahead, by more than 0.05 N m.
      CHECK((sample.tau_ext - arm.tau_ext()).norm() < 0.01);
    }
    largest = std::max(largest, arm.tau_ext().norm());
    arm.step(arm.dynamics().gravity);
  }
  CHECK(largest > 4);
}

TEST_CASE("PinocchioSensing: takes the rotors that the torque accelerates off again", "[host]") {
  Arm arm(panda(), ArmConfig(), panda().ready);
  const Vector rotors = (Vector() << 1.5, 1.2, 0.8, 0.6, 0.3, 0.2, 0.1).finished();
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", kPeriod, {}, Vector::Ones(), rotors);
  rme::Proprioception<double, 7> sample;
  Vector before = arm.dq();
  double most = 0;
  for (int k = 0; k < 200; ++k) {
    const Vector share = rotors.cwiseProduct(arm.dq() - before) / kPeriod;  // of the torque, for the rotors
    before = arm.dq();
    most = std::max(most, share.norm());
    REQUIRE(sensing.update(arm.q(), arm.dq(), arm.tau_measured() + share, kPeriod, sample) == rme::Status::Ok);
    CAPTURE(k);
    REQUIRE((sample.tau_ext - arm.tau_ext()).norm() < 1e-8);
    arm.step(Vector(0.5 * arm.dynamics().gravity));
  }
  CHECK(most > 5);  // so that agreement means something
}

TEST_CASE("PinocchioSensing: refuses a bad sample, and is as it was", "[host]") {
  Arm arm(panda(), ArmConfig(), panda().ready, Vector::Constant(1));
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", kPeriod);
  rme::Proprioception<double, 7> sample;
  arm.attach(unknown_kilogram());
  Vector spoilt = Vector::Zero();
  spoilt[3] = std::numeric_limits<double>::quiet_NaN();
  for (int k = 0; k < 100; ++k) {
    REQUIRE(sensing.update(arm.q(), arm.dq(), arm.tau_measured(), kPeriod, sample) == rme::Status::Ok);
    const Vector before = sample.tau_ext;
    for (const int which : {0, 1, 2}) {
      const Vector q = which == 0 ? spoilt : arm.q(), dq = which == 1 ? spoilt : arm.dq();
      CHECK(sensing.update(q, dq, which == 2 ? spoilt : arm.tau_measured(), kPeriod, sample) ==
            rme::Status::NonFiniteInput);
    }
    CHECK((sample.tau_ext == before));
    CHECK((before - arm.tau_ext()).norm() < 1e-8);
    arm.step(arm.dynamics().gravity);
  }
}

TEST_CASE("PinocchioSensing: refuses another number of joints, and names them", "[host]") {
  CHECK_THROWS_WITH(PinocchioSensing<7>(panda_with_hand(), "panda_link8", kPeriod),
                    contains("expected 7 joints of one velocity each on a fixed base, got nv = 9: panda_joint1, ") &&
                        contains("panda_finger_joint2") && contains("pinocchio_arm()"));
  CHECK_THROWS_WITH(PinocchioSensing<6>(panda_arm(), "panda_link8", kPeriod),
                    contains("expected 6 joints of one velocity each on a fixed base, got nv = 7"));
}

TEST_CASE("PinocchioSensing: a continuous joint, whose position is a cosine and a sine, is a joint as any other",
          "[host]") {
  std::string urdf = panda_urdf();
  for (const char* joint : {"1", "5"}) {
    const std::string revolute = std::string("\"panda_joint") + joint + "\" type=\"revolute\"";
    REQUIRE(urdf.find(revolute) != std::string::npos);
    urdf.replace(urdf.find(revolute), revolute.size(), std::string("\"panda_joint") + joint + "\" type=\"continuous\"");
  }
  const pinocchio::Model continuous = model_of(urdf);
  REQUIRE(continuous.nq == 9);
  Arm arm(panda(), ArmConfig(), panda().ready, Vector::Constant(1));
  PinocchioSensing<7> sensing(continuous, "panda_link8", kPeriod), revolute(panda_arm(), "panda_link8", kPeriod);
  arm.attach(unknown_kilogram());
  rme::Proprioception<double, 7> sample, expected;
  for (int k = 0; k < 200; ++k) {
    REQUIRE(sensing.update(arm.q(), arm.dq(), arm.tau_measured(), kPeriod, sample) == rme::Status::Ok);
    REQUIRE(revolute.update(arm.q(), arm.dq(), arm.tau_measured(), kPeriod, expected) == rme::Status::Ok);
    CAPTURE(k);
    REQUIRE((sample.tau_ext - expected.tau_ext).norm() < 1e-8);
    REQUIRE((sample.jacobian - expected.jacobian).norm() < 1e-12);
    REQUIRE((sample.rotation - expected.rotation).norm() < 1e-12);
    arm.step(arm.dynamics().gravity);
  }
  CHECK(sample.tau_ext.norm() > 1);
}

TEST_CASE("PinocchioSensing: refuses a model whose links have no inertia, and names the joints", "[host]") {
  std::string urdf = panda_urdf();
  for (std::size_t at = urdf.find("<inertial>"); at != std::string::npos; at = urdf.find("<inertial>", at))
    urdf.erase(at, urdf.find("</inertial>", at) + 11 - at);
  CHECK_THROWS_WITH(PinocchioSensing<7>(model_of(urdf), "panda_link8", kPeriod),
                    contains("the model has no inertias: no mass moves with panda_joint1, panda_joint2, ") &&
                        contains("panda_joint7; expected <inertial>"));
}

TEST_CASE("PinocchioSensing: a link without mass is no fault if a later one has mass, and names its joint if none has",
          "[host]") {
  const auto without_mass = [](const std::string& link) {
    std::string urdf = panda_urdf();
    const std::size_t from = urdf.find("<inertial>", urdf.find("<link name=\"" + link + "\""));
    return model_of(urdf.erase(from, urdf.find("</inertial>", from) + 11 - from));
  };
  CHECK_NOTHROW(PinocchioSensing<7>(without_mass("panda_link3"), "panda_link8", kPeriod));
  CHECK_THROWS_WITH(PinocchioSensing<7>(without_mass("panda_link7"), "panda_link8", kPeriod),
                    contains("no mass moves with panda_joint7; expected"));
}

TEST_CASE("PinocchioSensing: refuses a period of zero", "[host]") {
  CHECK_THROWS_WITH(PinocchioSensing<7>(panda_arm(), "panda_link8", 0),
                    contains("PinocchioSensing::period: expected > 0 s, got 0"));
}

TEST_CASE("PinocchioSensing: a base in any orientation is a gravity vector in its axes", "[host]") {
  rme::EstimatorConfig<double, 7> config;
  config.gravity = Eigen::AngleAxisd(2.1, Eigen::Vector3d(1, -2, 0.5).normalized()) * rme::standard_gravity<double>();
  rme::examples::ArmModel<7> mounted = panda();
  mounted.gravity_vector = config.gravity;
  Arm arm(mounted, ArmConfig(), panda().ready, Vector::Constant(1));
  arm.attach(unknown_kilogram());
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", kPeriod, config),
      upright(panda_arm(), "panda_link8", kPeriod);
  rme::Proprioception<double, 7> sample, wrong;
  for (int k = 0; k < 200; ++k) {
    REQUIRE(sensing.update(arm.q(), arm.dq(), arm.tau_measured(), kPeriod, sample) == rme::Status::Ok);
    REQUIRE(upright.update(arm.q(), arm.dq(), arm.tau_measured(), kPeriod, wrong) == rme::Status::Ok);
    REQUIRE((sample.tau_ext - arm.tau_ext()).norm() < 1e-8);
    arm.step(arm.dynamics().gravity);
  }
  CHECK((wrong.tau_ext - arm.tau_ext()).norm() > 1);
}

TEST_CASE("PinocchioSensing: refuses a frame that the model lacks, and lists those that it has", "[host]") {
  CHECK_THROWS_WITH(PinocchioSensing<7>(panda_arm(), "flange", kPeriod),
                    contains("no frame flange; it has ") && contains("panda_link8"));
}

TEST_CASE("PinocchioSensing: refuses a frame that no joint moves, such as the base or another arm's hand", "[host]") {
  pinocchio::Model model = panda_arm();
  model.addFrame(pinocchio::Frame("other_hand", 0, 0, pinocchio::SE3::Identity(), pinocchio::BODY));
  CHECK_THROWS_WITH(
      PinocchioSensing<7>(model, "other_hand", kPeriod),
      contains("the frame other_hand: expected one that a joint of the arm moves; they are panda_joint1"));
}

TEST_CASE("PinocchioSensing: of a link and a joint that have the same name, the link's frame is meant", "[host]") {
  pinocchio::Model model = panda_arm();
  REQUIRE(model.frames[model.getFrameId("panda_link8")].type == pinocchio::BODY);
  model.addFrame(pinocchio::Frame("panda_link8", 7, 0, pinocchio::SE3::Identity(), pinocchio::FIXED_JOINT));
  PinocchioSensing<7> sensing(model, "panda_link8", kPeriod), alone(panda_arm(), "panda_link8", kPeriod);
  rme::Proprioception<double, 7> sample, expected;
  const Vector q = panda().ready;
  REQUIRE(sensing.update_external(q, Vector::Zero(), Vector::Zero(), kPeriod, sample) == rme::Status::Ok);
  REQUIRE(alone.update_external(q, Vector::Zero(), Vector::Zero(), kPeriod, expected) == rme::Status::Ok);
  CHECK(sample.jacobian == expected.jacobian);
}

TEST_CASE("PinocchioSensing: gravity() is that of the last update, also after another pose was asked for", "[host]") {
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", kPeriod);
  rme::Proprioception<double, 7> sample;
  REQUIRE(sensing.update_external(panda().ready, Vector::Zero(), Vector::Zero(), kPeriod, sample) == rme::Status::Ok);
  const Vector before = sensing.gravity();
  CHECK((sensing.gravity(Vector::Zero()) - before).norm() > 1);
  CHECK(sensing.gravity() == before);
}

TEST_CASE("PinocchioSensing: refuses joints that the model lacks, or has in another order, and names them", "[host]") {
  std::vector<std::string> names = joint_names();
  names[2] = "elbow";
  CHECK_THROWS_WITH(pinocchio_arm(panda_with_hand(), names), contains("no joint elbow; it has panda_joint1, "));
  names = joint_names();
  std::swap(names[0], names[1]);
  CHECK_THROWS_WITH(pinocchio_arm(panda_with_hand(), names), contains("got panda_joint2, panda_joint1, panda_joint3"));
}

TEST_CASE("PinocchioSensing: allocates nothing in its loop", "[host]") {
#ifdef RME_COUNTS_ALLOCATIONS
  Arm arm(panda(), ArmConfig(), panda().ready, Vector::Constant(1));
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", kPeriod);
  rme::Proprioception<double, 7> sample;
  int good = 0, allocated = 0;
  for (int k = 0; k < 100; ++k) {
    const int before = rme::testing::allocations();
    good += sensing.update(arm.q(), arm.dq(), arm.tau_measured(), k % 5 * kPeriod, sample) == rme::Status::Ok ? 1 : 0;
    good += sensing.update_external(arm.q(), arm.dq(), arm.tau_ext(), kPeriod, sample) == rme::Status::Ok ? 1 : 0;
    allocated += rme::testing::allocations() - before;
    arm.step(arm.dynamics().gravity);
  }
  CHECK(good == 200);
  CHECK(allocated == 0);
#else
  WARN("allocations are not counted here");
#endif
}

TEST_CASE("A payload that Pinocchio's model carries no longer shows in tau_ext, at rest and in motion", "[host]") {
  Arm arm(panda(), ArmConfig(), panda().ready, Vector::Constant(1));
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", kPeriod);
  arm.attach(unknown_kilogram());
  const RigidBody body = unknown_kilogram();
  sensing.carry(rme::InertialParameters<double>::of_body({body.mass, body.com}, body.inertia));
  rme::Proprioception<double, 7> sample;
  for (int k = 0; k < 200; ++k) {
    REQUIRE(sensing.update(arm.q(), arm.dq(), arm.tau_measured(), kPeriod, sample) == rme::Status::Ok);
    if (k == 100) CHECK(arm.dq().norm() > 1);
    arm.step(arm.dynamics().gravity);
  }
  CHECK(arm.tau_ext().norm() > 1);
  CHECK(sample.tau_ext.norm() < 1e-3);
}

/// A host's own controller: holds a pose, gravity left to others.
Vector impedance(const Vector& q, const Vector& dq) {
  const Vector stiffness = (Vector() << 600, 600, 600, 600, 100, 100, 50).finished();
  const Vector damping = (Vector() << 40, 40, 40, 40, 4, 4, 1).finished();
  return stiffness.cwiseProduct(panda().ready - q) - damping.cwiseProduct(dq);
}

TEST_CASE("An observer without the compensation in its torque sees only the mass that is not compensated", "[host]") {
  Arm arm(panda(), ArmConfig(), panda().ready);
  PinocchioSensing<7> sensing(panda_arm(), "panda_link8", kPeriod);
  rme::PayloadCompensation<double, 7> payload(kPeriod);
  Vector without = Vector::Zero();
  for (int k = 0; k < 4000; ++k) {
    if (k == 1000) arm.attach(unknown_kilogram());
    rme::Proprioception<double, 7> sample;
    REQUIRE(sensing.update(arm.q(), arm.dq(), without, kPeriod, sample) == rme::Status::Ok);
    REQUIRE(payload.update(sample) == rme::Status::Ok);
    without = impedance(arm.q(), arm.dq()) + arm.dynamics().gravity;
    arm.step(without + payload.torque());
  }
  const auto& state = payload.state();
  const double seen = state.payload.mean[0], carried = rme::Undecided<double>::carried(state.undecided) * seen;
  CAPTURE(seen, carried);
  CHECK(std::abs(seen + carried - 1) < 0.05);
  CHECK(seen < 0.65);
  CHECK(payload.state().health < 10);
}

}  // namespace
