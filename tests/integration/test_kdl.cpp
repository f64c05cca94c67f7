// Models and physics that others wrote: Orocos KDL reads the same URDF files, and moves the arm that the estimator
// holds.
#include <Eigen/Cholesky>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <precompiled/any_joints.hpp>
#include <random>
#include <rivals/kdl_wrench.hpp>
#include <rme/sensing/momentum_observer.hpp>
#include <string>
#include <urdf_arm/urdf_chain.hpp>
#include <vector>

#include "integration/kdl_arm.hpp"
#include "support/catch.hpp"

namespace {

using rme::examples::ArmModel;
using rme::examples::RigidBody;
using rme::testing::KdlArm;

struct Arm {
  const char *file, *base, *tip;
  int dofs;
};
constexpr Arm kSmall = {RME_TEST_DATA "/urdf/six_joints_5kg.urdf", "world", "tool0", 6};
constexpr Arm kLarge = {RME_TEST_DATA "/urdf/six_joints_10kg.urdf", "world", "tool0", 6};
constexpr Arm kHand = {RME_TEST_DATA "/urdf/seven_joints_hand.urdf", "mount", "tool", 7};

template <int Dofs>
ArmModel<Dofs> model_of(const Arm& arm) {
  return rme::examples::arm_model<Dofs>(rme::examples::read_urdf(arm.file, arm.base, arm.tip));
}

template <int Dofs>
void compare(const Arm& arm) {
  CAPTURE(arm.file);
  using Vector = rme::JointVector<double, Dofs>;
  const ArmModel<Dofs> ours = model_of<Dofs>(arm);
  const KdlArm theirs(arm.file, arm.tip);
  REQUIRE(theirs.dofs() == Dofs);
  const unsigned seed = 5;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-2, 2);
  const Eigen::VectorXd rest = Eigen::VectorXd::Zero(Dofs);
  const auto difference = [](const auto& a, const auto& b) { return (a - b).cwiseAbs().maxCoeff(); };
  for (int k = 0; k < 20; ++k) {
    const auto draw = [&] { return uniform(random); };
    const Vector q = Vector::NullaryExpr(draw), dq = Vector::NullaryExpr(draw), ddq = Vector::NullaryExpr(draw);
    const auto at = ours.kinematics(q);
    CHECK(difference(at.position, theirs.position(q)) <= 1e-12);
    CHECK(difference(at.rotation, theirs.rotation(q)) <= 1e-12);
    CHECK(difference(at.jacobian, theirs.jacobian(q)) <= 1e-12);
    // Torques reach 200 N m, and the wrist's inertia 0.01 kg m^2: relative to the largest.
    const auto terms = ours.dynamics(q, dq);
    const Eigen::MatrixXd M = theirs.mass_matrix(q);
    const Eigen::VectorXd g = theirs.inverse_dynamics(q, rest, rest);
    const Eigen::VectorXd c = theirs.inverse_dynamics(q, dq, rest, false);
    CHECK(difference(terms.mass_matrix, M) <= 1e-12 * std::max(1.0, M.cwiseAbs().maxCoeff()));
    CHECK(difference(terms.gravity, g) <= 1e-12 * std::max(1.0, g.cwiseAbs().maxCoeff()));
    CHECK(difference(terms.coriolis, c) <= 1e-12 * std::max(1.0, c.cwiseAbs().maxCoeff()));
    // Nothing gets lost on the way from KDL's tree to its chain, nor between its two algorithms.
    const Eigen::VectorXd tree = theirs.tree_dynamics(q, dq, ddq);
    CHECK(difference(theirs.inverse_dynamics(q, dq, ddq), tree) <= 1e-12 * std::max(1.0, tree.cwiseAbs().maxCoeff()));
    CHECK(difference(M * ddq + c + g, tree) <= 1e-12 * std::max(1.0, tree.cwiseAbs().maxCoeff()));
    // dM/dt = C + C^T, with dM/dt of KDL's M by five-point differences.
    const double h = 1e-3;
    const auto along = [&](double s) { return theirs.mass_matrix(q + s * h * dq); };
    const Eigen::MatrixXd rate = (8 * (along(1) - along(-1)) - (along(2) - along(-2))) / (12 * h);
    CHECK(difference(terms.coriolis_transpose, rate * dq - c) <= 1e-8);
  }
}

TEST_CASE("KDL: M, g, C dq, C^T dq, p, R and J of arms from their URDF are those that KDL computes", "[kdl][models]") {
  compare<6>(kSmall);
  compare<6>(kLarge);
  compare<7>(kHand);
}

TEST_CASE("KDL: its estimator of the wrench at the tip, as docs/real_arms.md uses it, weighs what hangs there",
          "[kdl][models]") {
  using Vector = rme::JointVector<double, 7>;
  const ArmModel<7> model = model_of<7>(kHand);  // its tool is turned against its last link
  KdlArm plant(kHand.file, kHand.tip);
  plant.attach(rme::examples::box(1.2, {0.04, -0.03, 0.09}, {0.1, 0.08, 0.12}));
  const Vector rotors = Vector::Constant(0.4), zero = Vector::Zero(), ddq = Vector::Constant(2);
  rme::examples::KdlTipMass<7> tip(model, rotors, 1e-3, 50, 1e-5);
  double mass = 0;
  for (int k = 0; k < 400; ++k) {  // from rest, faster and faster for a while, then at rest elsewhere
    const double t = 1e-3 * std::min(k, 100);
    const Vector q = Vector::Constant(0.6) + 0.5 * t * t * ddq;
    const bool moves = k < 100;
    const Vector dq = moves ? Vector(t * ddq) : zero, a = moves ? ddq : zero;
    mass = tip.update(q, dq, plant.inverse_dynamics(q, dq, a) + rotors.cwiseProduct(a));
    // On the way the payload's inertia is part of its weight.
    if (k == 99) CHECK(std::abs(mass - 1.2) < 0.4);
  }
  CHECK(mass == Approx(1.2).epsilon(1e-3));
}

/// What is wrong with the arm, and what is not known of it.
struct Faults {
  double torque_noise = 0, velocity_noise = 0;  // [N m], [rad/s], standard deviations
  double coulomb = 0, wrist_coulomb = 0;        // [N m]; the last three joints'
};

struct Found {
  double mass_error = 0, mass_deviation = 0;  // at the end of the hold, and what it is said to be [kg]
  double com_error = 0;                       // across gravity [m]
  double health = 0, pushed = 0;              // then; the latter a probability
  double friction_shows = 0;                  // a probability, at the end of the hold
  double empty_after = 1e9;                   // the detach [s]
  double mass_after = 0;                      // at the end of it all [kg]
  bool attached = false;                      // as an event
  int pushes = 0;
};

/// Computed torque along a path that the arm follows for ever, or at rest; the payload is there from 1 s to 6 s.
template <int Dofs>
Found live(const Arm& arm, double rated, double mass, bool moving, const Faults& faults, unsigned seed) {
  using Vector = rme::JointVector<double, Dofs>;
  constexpr double dt = 1e-3, begin = 0.2, attach = 1, detach = 6, end = 7.5;
  const ArmModel<Dofs> model = model_of<Dofs>(arm);
  KdlArm plant(arm.file, arm.tip);
  rme::EstimatorConfig<double, Dofs> config;
  config.rated_payload = rated;
  rme::Estimator<double, Dofs> estimator(dt, config);
  rme::MomentumObserver<double, Dofs> observer(dt);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto noise = [&](double sigma) -> Vector {
    return sigma > 0 ? Vector(sigma * Vector::NullaryExpr([&] { return normal(random); })) : Vector(Vector::Zero());
  };

  const Eigen::Vector3d com(0.04, -0.03, 0.09);
  const RigidBody payload = rme::examples::box(mass, com, {0.1, 0.08, 0.12});
  Vector home = Vector::Constant(0.6);
  home[1] = -1.1;
  home[2] = 1.3;
  Vector coulomb = Vector::Constant(faults.coulomb);
  coulomb.template tail<3>().setConstant(faults.wrist_coulomb);
  Vector q = home, dq = Vector::Zero(), tau = model.dynamics(q, dq).gravity;
  Found found;
  int events = 0;
  for (int k = 0; k * dt < end; ++k) {
    const double t = k * dt;
    if (k == static_cast<int>(attach / dt)) plant.attach(payload);
    if (k == static_cast<int>(detach / dt)) plant.detach();
    // The arm's physics over a period under a constant torque.
    const Vector before = dq;
    if (faults.coulomb == 0) {  // the midpoint's, with the mass matrix of that point
      const Vector middle = q + 0.5 * dt * dq;
      const Eigen::LDLT<Eigen::MatrixXd> M(plant.mass_matrix(middle));
      const Vector half = dq + 0.5 * dt * M.solve(tau - plant.inverse_dynamics(q, dq, Vector::Zero()));
      dq += dt * M.solve(tau - plant.inverse_dynamics(middle, half, Vector::Zero()));
      q += dt * half;
    } else {  // what friction can stop within the period, it stops
      const Eigen::MatrixXd inverse = plant.mass_matrix(q).inverse();
      dq += dt * inverse * (tau - plant.inverse_dynamics(q, dq, Vector::Zero()));
      Vector impulse = Vector::Zero();
      double change = 1;  // of an impulse in the last round: the wrist's joints need some hundred
      for (int round = 0; round < 2000 && change > 1e-12; ++round) {
        change = 0;
        for (int j = 0; j < Dofs; ++j) {
          const double wanted = impulse[j] - dq[j] / inverse(j, j), most = coulomb[j] * dt;
          const double step = std::min(most, std::max(-most, wanted)) - impulse[j];
          impulse[j] += step;
          dq += inverse.col(j) * step;
          change = std::max(change, std::abs(step));
        }
      }
      q += 0.5 * dt * (before + dq);
    }
    // What the host sees, and does.
    const Vector measured_dq = dq + noise(faults.velocity_noise);
    const auto terms = model.dynamics(q, measured_dq);
    REQUIRE(observer.update(tau + noise(faults.torque_noise), measured_dq, terms.mass_matrix, terms.coriolis_transpose,
                            terms.gravity) == rme::Status::Ok);
    const auto at = model.kinematics(q);
    // The robot's observer has forgotten the noise of its first sample, the momentum's, before a host comes.
    if (t < begin) continue;
    REQUIRE(estimator.update({observer.tau_ext(), at.jacobian, at.rotation, measured_dq}) == rme::Status::Ok);
    Vector goal = home, speed = Vector::Zero(), acceleration = Vector::Zero();
    if (moving) {
      for (int j = 0; j < Dofs; ++j) {
        const double w = 1.2 + 0.17 * j, a = 0.35;
        goal[j] += a * (1 - std::cos(w * t));
        speed[j] = a * w * std::sin(w * t);
        acceleration[j] = a * w * w * std::cos(w * t);
      }
    }
    tau = terms.mass_matrix * (acceleration + 400 * (goal - q) + 40 * (speed - measured_dq)) + terms.coriolis +
          terms.gravity + estimator.compensation(at.jacobian, at.rotation);

    const auto& state = estimator.state();
    if (k == static_cast<int>(detach / dt) - 1) {
      found.mass_error = std::abs(state.payload.mean[0] - mass);
      found.mass_deviation = state.payload.standard_deviation()[0];
      found.health = state.health;
      found.pushed = state.probability[rme::Mode::Disturbed];
      found.friction_shows = state.friction_shows();
      const Eigen::Vector3d down = at.rotation.transpose() * Eigen::Vector3d::UnitZ();
      const Eigen::Vector3d error = state.payload.mean.template tail<3>() - com;
      found.com_error = (error - down.dot(error) * down).norm();
    }
    found.mass_after = state.payload.mean[0];
    if (t > detach && !state.empty()) found.empty_after = 1e9;
    if (t > detach && state.empty() && found.empty_after > 1e8) found.empty_after = t - detach;
    if (state.event.number == events) continue;
    events = state.event.number;
    found.attached = found.attached || state.event.kind == rme::EventKind::Attached;
    found.pushes += state.event.kind == rme::EventKind::Pushed ? 1 : 0;
  }
  return found;
}

/// What a life has to show.
struct Target {
  double share, least;  // of the mass, and in kg, whichever is more: the mass's error
  bool across;          // the centre of mass across gravity, within 2 mm, and no event taken for a push
};
constexpr Target kExact = {0.005, 0.005, true}, kRough = {0.02, 0.03, false};

/// Prints a line for each life if RME_PRINT is set.
template <int Dofs>
void judge(const Arm& arm, double rated, const std::vector<double>& masses, bool moving, const Faults& faults,
           const Target& target) {
  for (const double mass : masses) {
    const unsigned seed = 17;
    CAPTURE(arm.file, mass, moving, seed, faults.torque_noise, faults.velocity_noise, faults.coulomb);
    const Found found = live<Dofs>(arm, rated, mass, moving, faults, seed);
    if (std::getenv("RME_PRINT") != nullptr)
      std::printf(
          "%s %4.1f kg %s, noise %.2f N m, %.0f mrad/s, friction %.1f: mass %6.1f g (+- %.1f), com %5.2f mm, health "
          "%.1f, pushed %.2f, friction shows %.2f, empty after %.2f s (%.0f g at last), %s, %d pushes\n",
          std::string(arm.file).substr(std::string(arm.file).rfind('/') + 1).c_str(), mass,
          moving ? "moving " : "at rest", faults.torque_noise, 1e3 * faults.velocity_noise, faults.coulomb,
          1e3 * found.mass_error, 1e3 * found.mass_deviation, 1e3 * found.com_error, found.health, found.pushed,
          found.friction_shows, std::min(found.empty_after, 99.0), 1e3 * found.mass_after,
          found.attached ? "attached" : "not attached", found.pushes);
    CHECK(found.attached);
    CHECK(found.mass_error <= std::max(target.share * mass, target.least));
    if (target.across) CHECK(found.com_error <= 0.002);
    if (target.across) CHECK(found.pushes == 0);
    CHECK(found.empty_after <= 1);
  }
}

/// An arm that lives often.
template <int Dofs>
struct Often {
  static constexpr int dofs = Dofs;
  const Arm& arm;
  double rated;
};

const std::vector<double> kSmallMasses = {0.3, 1, 2.5, 5}, kLargeMasses = {0.3, 1, 5, 10},
                          kHandMasses = {0.3, 1, 1.5, 3};
constexpr Faults kNone = {}, kNoise = {0.08, 0.002, 0, 0}, kFriction = {0, 0, 0.5, 0.2},
                 kQuiet = {0.02, 0.0005, 0.5, 0.2}, kBoth = {0.08, 0.002, 0.5, 0.2};

// Payloads from 0.3 kg to the rated load, in KDL's forward dynamics. A tag for each test of ctest, which runs them at
// the same time.
TEST_CASE("KDL: an arm rated for 5 kg finds its payloads, and rejects none", "[kdl][small]") {
  judge<6>(kSmall, 5, kSmallMasses, false, kNone, kExact);
  judge<6>(kSmall, 5, kSmallMasses, true, kNone, kExact);
}
TEST_CASE("KDL: an arm rated for 10 kg finds its payloads, and rejects none", "[kdl][large]") {
  judge<6>(kLarge, 10, kLargeMasses, false, kNone, kExact);
  judge<6>(kLarge, 10, kLargeMasses, true, kNone, kExact);
}
TEST_CASE("KDL: an arm of seven joints with a hand finds its payloads, and rejects none", "[kdl][hand]") {
  judge<7>(kHand, 3, kHandMasses, false, kNone, kExact);
  judge<7>(kHand, 3, kHandMasses, true, kNone, kExact);
}

TEST_CASE("KDL: under noise the lightest and the heaviest payload are found within 2 % or 30 g, and hardly ever missed",
          "[kdl][noise]") {
  int lives = 0, beyond = 0, confident = 0;
  const auto live_often = [&](const auto& once) {
    for (unsigned seed = 17; seed < 25; ++seed)
      for (const bool moving : {false, true})
        for (const bool heavy : {false, true}) {
          CAPTURE(seed, moving, heavy);
          const double mass = heavy ? once.rated : 0.3;
          const Found found =
              live<std::decay_t<decltype(once)>::dofs>(once.arm, once.rated, mass, moving, kNoise, seed);
          CHECK(found.attached);
          if (std::getenv("RME_PRINT") != nullptr)
            std::printf(
                "rated %.0f kg, %.1f kg %s, seed %u: mass %.1f g (+- %.1f), empty after %.2f s (%.0f g at last)\n",
                once.rated, mass, moving ? "moving" : "at rest", seed, 1e3 * found.mass_error,
                1e3 * found.mass_deviation, std::min(found.empty_after, 99.0), 1e3 * found.mass_after);
          const bool far = found.mass_error > std::max(kRough.share * mass, kRough.least);
          beyond += far || found.empty_after > 1 ? 1 : 0;
          confident += far && found.mass_error > 2 * found.mass_deviation ? 1 : 0;
          ++lives;
        }
  };
  live_often(Often<6>{kSmall, 5});
  live_often(Often<6>{kLarge, 10});
  live_often(Often<7>{kHand, 3});
  CAPTURE(lives);
  CHECK(beyond <= 2);  // of 96: at rest, friction that nobody excluded may have held a part
  CHECK(confident == 0);
}

TEST_CASE(
    "KDL: under friction that nobody told, with noise and without, payloads in motion are found within 2 % or 30 g",
    "[kdl][friction]") {
  for (const Faults& faults : {kFriction, kBoth}) {
    judge<6>(kSmall, 5, kSmallMasses, true, faults, kRough);
    judge<6>(kLarge, 10, kLargeMasses, true, faults, kRough);
    judge<7>(kHand, 3, kHandMasses, true, faults, kRough);
  }
}

// A joint that friction holds confirms any compensation: by as much as that grows, so does tau_ext. An estimate that took
// this for news of the payload would wander.
TEST_CASE("KDL: at rest under friction that nobody told, an estimate does not follow its own compensation",
          "[kdl][rest]") {
  // Which joint sticks when is chance: a single life may be off by more.
  double sum = 0;
  int lives = 0, beyond = 0, outside = 0, ghosts = 0;
  const auto live_often = [&](const Arm& arm, double rated, const std::vector<double>& masses) {
    for (unsigned seed = 17; seed < 23; ++seed) {
      for (const double mass : masses) {
        for (const Faults& faults : {kQuiet, kBoth}) {
          const Found found = live<6>(arm, rated, mass, false, faults, seed);
          CAPTURE(seed, mass, faults.torque_noise);
          CHECK(found.attached);
          if (std::getenv("RME_PRINT") != nullptr)
            std::printf("rated %.0f kg, %.1f kg at rest, noise %.2f N m, seed %u: mass %.1f g (+- %.1f), %s\n", rated,
                        mass, faults.torque_noise, seed, 1e3 * found.mass_error, 1e3 * found.mass_deviation,
                        found.empty_after <= 1 ? "empty in time" : "not empty in time");
          ghosts += found.empty_after <= 1 ? 0 : 1;
          sum += found.mass_error;
          beyond += found.mass_error > std::max(kRough.share * mass, kRough.least) ? 1 : 0;
          outside += found.mass_error > 3 * found.mass_deviation ? 1 : 0;
          ++lives;
        }
      }
    }
  };
  live_often(kSmall, 5, kSmallMasses);
  live_often(kLarge, 10, {1, 5, 10});
  CAPTURE(lives);
  CHECK(sum / lives < kRough.least);
  CHECK(beyond <= lives / 5);
  CHECK(outside <= 1);  // of 84
  CHECK(ghosts <= 2);
}

// Hidden: a target that is not reached at rest, nor always can be. There friction may hold any torque up to its size:
// with 0.5 and 0.2 N m that alone leaves the mass a standard deviation of 31 (10 kg's arm) to 60 g (the hand's) in this
// pose. RME_PRINT=1 integration_test_kdl "[all_faults]" says how far it is.
TEST_CASE("KDL: under noise and friction that nobody told they are found within 2 % or 30 g", "[.][all_faults]") {
  for (const Faults& faults : {kNoise, kFriction, kBoth}) {
    for (const bool moving : {false, true}) {
      judge<6>(kSmall, 5, kSmallMasses, moving, faults, kRough);
      judge<6>(kLarge, 10, kLargeMasses, moving, faults, kRough);
      judge<7>(kHand, 3, kHandMasses, moving, faults, kRough);
    }
  }
}

}  // namespace
