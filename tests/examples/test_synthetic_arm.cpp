#include <Eigen/Geometry>
#include <io/log_reader.hpp>
#include <random>
#include <rme/core/payload.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/six_joint_arm.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using rme::examples::ArmModel;
using rme::examples::box;
using rme::examples::panda;
using rme::examples::PoseImpedance;
using rme::examples::RigidBody;
using rme::examples::SyntheticArm;
using rme::examples::SyntheticArmConfig;
using rme::examples::TorqueSensing;
using rme::examples::with_model_error;

template <int Dofs>
using Vector = rme::JointVector<double, Dofs>;

struct Panda {
  static constexpr int dofs = 7;
  static const ArmModel<7>& model() { return panda(); }
};
struct SixJointArm {
  static constexpr int dofs = 6;
  static const ArmModel<6>& model() { return rme::examples::six_joint_arm(); }
};

// Lets the impedance law hold the arm for a time.
template <int Dofs>
void hold(SyntheticArm<Dofs>& arm, const PoseImpedance<Dofs>& law, double seconds) {
  for (const double end = arm.time() + seconds - 1e-9; arm.time() < end;)
    arm.step(law.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()));
}

// What a body at rest in the hand does to the joints, by the conventions' payload wrench.
template <int Dofs>
Vector<Dofs> payload_torque(const SyntheticArm<Dofs>& arm, const RigidBody& body) {
  const rme::Payload<double> payload{body.mass, body.com};
  return arm.kinematics().jacobian.transpose() * rme::payload_wrench(payload, arm.kinematics().rotation).vector();
}

TEMPLATE_TEST_CASE("SyntheticArm: falling freely for 10 s its energy drifts below 1e-4 of its range", "[synthetic_arm]",
                   Panda, SixJointArm) {
  const auto& model = TestType::model();
  const int substeps = GENERATE(1, 3);
  CAPTURE(substeps);
  SyntheticArmConfig<TestType::dofs> config;
  config.substeps = substeps;
  SyntheticArm<TestType::dofs> arm(model, config, model.ready);
  const RigidBody payload = box(0.8, {0.02, 0.03, 0.1}, {0.1, 0.1, 0.2});
  arm.attach(payload);
  const double start = model.energy(arm.q(), arm.dq(), payload);
  double drift = 0, most_kinetic = 0;  // kinetic energy starts at zero: its largest value is the range
  while (arm.time() < 10) {
    arm.step(Vector<TestType::dofs>::Zero());
    const double energy = model.energy(arm.q(), arm.dq(), payload);
    drift = std::max(drift, std::abs(energy - start));
    most_kinetic = std::max(most_kinetic, energy - model.energy(arm.q(), 0 * arm.dq(), payload));
  }
  CAPTURE(drift, most_kinetic);
  CHECK(most_kinetic > 10);
  CHECK(drift < 1e-4 * most_kinetic);
}

TEST_CASE("SyntheticArm: under the impedance law it moves as MuJoCo's arm does when a payload appears",
          "[synthetic_arm]") {
  const auto log = rme::examples::read_log<7>(RME_TEST_DATA "/mujoco/panda_attach.csv");
  REQUIRE(log.size() == 311);
  SyntheticArm<7> arm(panda(), {}, log.q[0]);
  const PoseImpedance<7> law(panda(), log.q[0]);
  double moved = 0;
  for (std::size_t k = 0; k < log.size(); ++k) {
    CAPTURE(log.t[k]);
    if (k == 10) arm.attach(box(0.7, {0.06, 0, 0.13}, {0.06, 0.06, 0.1}));
    const auto tau = law.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics());
    // MuJoCo's semi-implicit steps of 0.25 ms put the arm ahead by about v 0.125 ms: 3e-5 rad at 0.25 rad/s.
    CHECK((arm.q() - log.q[k]).cwiseAbs().maxCoeff() < 4e-5);
    CHECK((arm.dq() - log.dq[k]).cwiseAbs().maxCoeff() < 1e-3);
    CHECK((tau - log.tau[k]).cwiseAbs().maxCoeff() < 1e-3);
    CHECK((arm.tau_ext() - log.tau_ext[k]).cwiseAbs().maxCoeff() < 1e-3);
    moved = std::max(moved, (log.q[k] - log.q[0]).cwiseAbs().maxCoeff());
    arm.step(tau);
  }
  CHECK(moved > 0.03);
}

TEMPLATE_TEST_CASE("SyntheticArm: once at rest with a payload, tau_ext is J^T of its wrench", "[synthetic_arm]", Panda,
                   SixJointArm) {
  const auto& model = TestType::model();
  SyntheticArm<TestType::dofs> arm(model, {}, model.ready);
  const PoseImpedance<TestType::dofs> law(model, model.ready);
  const RigidBody first = box(1.1, {0.05, 0.02, 0.13}, {0.06, 0.06, 0.1});
  const RigidBody second = box(0.4, {-0.03, 0.04, 0.05}, {0.05, 0.05, 0.05});
  hold(arm, law, 0.1);
  CHECK(arm.tau_ext().norm() < 1e-12);
  const int handle = arm.attach(first);
  hold(arm, law, 6);
  CHECK((arm.tau_ext() - payload_torque(arm, first)).norm() < 1e-6);
  CHECK(payload_torque(arm, first).norm() > 1);
  arm.attach(second);
  hold(arm, law, 6);
  CHECK((arm.tau_ext() - payload_torque(arm, first) - payload_torque(arm, second)).norm() < 1e-6);
  CHECK(arm.payload().mass == Approx(1.5).epsilon(1e-14));
  arm.detach(handle);
  hold(arm, law, 6);
  CHECK((arm.tau_ext() - payload_torque(arm, second)).norm() < 1e-6);
  CHECK((arm.payload().com - second.com).norm() < 1e-14);
}

TEST_CASE("SyntheticArm: handed over gradually, a payload weighs in and out in a straight line", "[synthetic_arm]") {
  SyntheticArm<7> arm(panda(), {}, panda().ready);
  const PoseImpedance<7> law(panda(), panda().ready);
  const int handle = arm.attach(box(2, {0, 0, 0.1}, {0.1, 0.1, 0.1}), 1.0);
  CHECK(arm.payload().mass == 0);
  hold(arm, law, 0.25);
  CHECK(arm.payload().mass == Approx(0.5));
  CHECK((arm.payload().com - Eigen::Vector3d(0, 0, 0.1)).norm() < 1e-15);
  hold(arm, law, 0.5);
  arm.detach(handle, 0.5);  // taken back at three quarters
  hold(arm, law, 0.25);
  CHECK(arm.payload().mass == Approx(0.75));
  hold(arm, law, 0.25);
  CHECK(arm.payload().mass == 0);
}

TEST_CASE("SyntheticArm: a push shows in tau_ext as J^T f through the observer, and ends", "[synthetic_arm]") {
  SyntheticArm<7> arm(panda(), {}, panda().ready);
  const PoseImpedance<7> law(panda(), panda().ready);
  const Eigen::Vector3d force(5, -8, 3);
  arm.push({force, Eigen::Vector3d::Zero()});
  const rme::Jacobian<double, 7> J = arm.kinematics().jacobian;
  hold(arm, law, 0.02);
  // 20 ms after it sets in, the observer at 50 rad/s has closed a twentieth of the gap twenty times; the arm has hardly
  // moved.
  const Vector<7> expected = (1 - std::pow(0.95, 20)) * J.topRows<3>().transpose() * force;
  CHECK((arm.tau_ext() - expected).norm() < 0.01 * expected.norm());
  arm.push({});
  hold(arm, law, 6);
  CHECK(arm.tau_ext().norm() < 1e-6);
}

TEST_CASE("SyntheticArm: a joint at rest stays below its breakaway torque and slides above it", "[synthetic_arm]") {
  // Gravity is compensated, so what a joint's friction has to hold is the torque on top of it. The joints are coupled:
  // a torque pattern that each joint could hold alone must be held by all of them together.
  SyntheticArmConfig<7> config;
  config.friction.coulomb = panda().typical_coulomb;
  config.friction.viscous = panda().typical_viscous;
  const Vector<7> pattern = (Vector<7>() << 1, -1, 1, 1, -1, 1, -1).finished().cwiseProduct(config.friction.coulomb);
  SyntheticArm<7> arm(panda(), config, panda().ready);
  while (arm.time() < 5) arm.step(arm.dynamics().gravity + 0.95 * pattern);
  CHECK((arm.q() - panda().ready).cwiseAbs().maxCoeff() < 1e-12);
  CHECK(arm.dq().cwiseAbs().maxCoeff() < 1e-12);
  // The motor-side sensor sees the friction: the observer reports what it holds.
  CHECK((arm.tau_ext() + 0.95 * pattern).norm() < 1e-6);

  Vector<7> one_above = 0.5 * pattern;
  one_above[5] = 1.5 * pattern[5];
  while (arm.time() < 5.3) arm.step(arm.dynamics().gravity + one_above);
  CHECK(arm.q()[5] - panda().ready[5] > 0.01);
}

TEST_CASE("SyntheticArm: a sliding joint settles at the speed where friction equals the drive", "[synthetic_arm]") {
  // Joint 1 turns about the vertical: with gravity compensated, c + v dq = tau. By hand: (1 - 0.2) / 2 = 0.4 rad/s.
  // The other joints are locked by friction that nothing here breaks.
  SyntheticArmConfig<7> config;
  config.friction.coulomb << 0.2, 1e3, 1e3, 1e3, 1e3, 1e3, 1e3;
  config.friction.viscous[0] = 2;
  SyntheticArm<7> arm(panda(), config, panda().ready);
  while (arm.time() < 8) arm.step(arm.dynamics().gravity + Vector<7>::Unit(0));
  CHECK(arm.dq()[0] == Approx(0.4).epsilon(1e-6));
  CHECK((arm.q() - panda().ready).tail<6>().cwiseAbs().maxCoeff() < 1e-6);
  while (arm.time() < 16) arm.step(arm.dynamics().gravity);
  CHECK(std::abs(arm.dq()[0]) < 1e-12);  // and comes to rest for good when the drive ends
}

TEST_CASE("SyntheticArm: link-side torque sensors keep friction out of tau_ext", "[synthetic_arm]") {
  SyntheticArmConfig<7> config;
  config.friction.coulomb = panda().typical_coulomb;
  config.friction.viscous = panda().typical_viscous;
  const RigidBody payload = box(1, {0, 0, 0.1}, {0.1, 0.1, 0.1});
  const auto error = [&](TorqueSensing sensing) {
    config.sensing = sensing;
    SyntheticArm<7> arm(panda(), config, panda().ready);
    arm.attach(payload);
    hold(arm, PoseImpedance<7>(panda(), panda().ready), 4);
    return (arm.tau_ext() - payload_torque(arm, payload)).norm();
  };
  CHECK(error(TorqueSensing::LinkSide) < 1e-6);
  CHECK(error(TorqueSensing::MotorSide) > 0.1);
}

TEST_CASE("SyntheticArm: sensor offsets show in tau_ext with the opposite sign, noise with its standard deviation",
          "[synthetic_arm]") {
  const std::uint64_t seed = 11;
  CAPTURE(seed);
  SyntheticArmConfig<7> config;
  config.seed = seed;
  config.torque_offset << 0.1, -0.1, 0.05, 0.2, -0.05, 0.02, 0.03;
  SyntheticArm<7> offset_only(panda(), config, panda().ready);
  while (offset_only.time() < 1) offset_only.step(offset_only.dynamics().gravity);
  CHECK((offset_only.tau_ext() + config.torque_offset).norm() < 1e-12);

  config.torque_noise = panda().typical_noise;
  SyntheticArm<7> arm(panda(), config, panda().ready);
  Vector<7> sum = Vector<7>::Zero(), squares = sum;
  constexpr int samples = 4000;
  for (int k = 0; k < samples; ++k) {
    arm.step(arm.dynamics().gravity);
    const Vector<7> noise = arm.tau_measured() - arm.dynamics().gravity - config.torque_offset;
    sum += noise;
    squares += noise.cwiseAbs2();
  }
  // The estimate of a standard deviation from 4000 samples has a relative error of 1 / sqrt(8000) = 1.1 %.
  const Vector<7> deviation = (squares / samples).cwiseSqrt();
  CHECK((deviation.cwiseQuotient(config.torque_noise) - Vector<7>::Ones()).cwiseAbs().maxCoeff() < 0.05);
  CHECK((sum / samples).cwiseQuotient(config.torque_noise).cwiseAbs().maxCoeff() < 0.07);  // 4.4 standard errors
}

TEST_CASE("SyntheticArm: the same seed gives the same noise and faults, another seed others", "[synthetic_arm]") {
  const auto run = [](std::uint64_t seed) {
    SyntheticArmConfig<7> config;
    config.torque_noise = panda().typical_noise;
    config.seed = seed;
    SyntheticArm<7> arm(panda(), config, panda().ready);
    hold(arm, PoseImpedance<7>(panda(), panda().ready), 0.1);
    return arm.tau_ext();
  };
  CHECK(run(1) == run(1));
  CHECK(run(1) != run(2));

  const auto faults = [](std::uint64_t seed) { return with_typical_faults(panda(), seed); };
  CHECK(faults(1).torque_offset == faults(1).torque_offset);
  CHECK(faults(1).torque_offset != faults(2).torque_offset);
  CHECK(faults(1).friction.coulomb != faults(2).friction.coulomb);
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const Vector<7> share = faults(seed).friction.coulomb.cwiseQuotient(panda().typical_coulomb);
    CHECK((share.minCoeff() >= 0.5 && share.maxCoeff() <= 1.5));
  }
}

// One second with a payload under gravity compensation alone, which looks at q only: what the reports are like does
// not change how the arm moves.
template <typename Look>
void sway(const SyntheticArmConfig<7>& config, Look look) {
  SyntheticArm<7> arm(panda(), config, panda().ready);
  arm.attach(box(0.5, {0.02, 0.03, 0.1}, {0.1, 0.1, 0.2}));
  for (int k = 0; k <= 1000; ++k) {
    look(arm);
    arm.step(panda().dynamics(arm.q(), Vector<7>::Zero()).gravity);
  }
}

SyntheticArmConfig<7> noisy_sensors() {
  SyntheticArmConfig<7> config;
  config.torque_noise = panda().typical_noise;
  return config;
}

std::vector<Vector<7>> tau_ext_of(const SyntheticArmConfig<7>& config) {
  std::vector<Vector<7>> out;
  sway(config, [&](const SyntheticArm<7>& arm) { out.push_back(arm.tau_ext()); });
  return out;
}

TEST_CASE("SyntheticArm: noise on the reported velocity is white, of its standard deviation, and changes nothing else",
          "[synthetic_arm]") {
  SyntheticArmConfig<7> config = noisy_sensors();
  std::vector<Vector<7>> q, dq, tau_ext;
  sway(config, [&](const SyntheticArm<7>& arm) {
    q.push_back(arm.q());
    dq.push_back(arm.dq());
    tau_ext.push_back(arm.tau_ext());
  });
  config.dq_noise << 0.002, 0.003, 0.004, 0.002, 0.003, 0.004, 0;
  Vector<7> sum = Vector<7>::Zero(), squares = sum, products = sum, last = sum;
  std::size_t k = 0;
  bool same = true;
  sway(config, [&](const SyntheticArm<7>& arm) {
    same = same && arm.q() == q[k] && arm.tau_ext() == tau_ext[k];
    const Vector<7> noise = arm.dq() - dq[k++];
    sum += noise;
    squares += noise.cwiseAbs2();
    products += noise.cwiseProduct(last);
    last = noise;
  });
  CHECK(same);
  REQUIRE(k == 1001);
  CHECK(squares[6] == 0);
  // 1001 numbers: the standard deviation is known to 2.2 %, the mean and the correlation to 1 / sqrt(1001) = 3.2 %.
  const auto variance = config.dq_noise.head<6>().cwiseAbs2().eval();
  CHECK(((squares.head<6>() / 1001).cwiseQuotient(variance).cwiseSqrt().array() - 1).abs().maxCoeff() < 0.09);
  CHECK((sum.head<6>() / 1001).cwiseQuotient(config.dq_noise.head<6>()).cwiseAbs().maxCoeff() < 0.13);
  CHECK((products.head<6>() / 1001).cwiseQuotient(variance).cwiseAbs().maxCoeff() < 0.13);
}

TEST_CASE("SyntheticArm: an observer that is fed noisy velocities reports K M times their noise", "[synthetic_arm]") {
  // r_k = a r_k-1 + K M (n_k - n_k-1) with a = 1 - K dt. The differences of white noise of variance s^2 through that
  // filter have the variance (K s)^2 M M^T 2 / (1 + a); C^T dq and gravity add nothing to speak of at rest.
  SyntheticArmConfig<7> config;
  config.dq_noise.setConstant(0.003);
  config.noisy_observer = true;
  SyntheticArm<7> arm(panda(), config, panda().ready);
  const rme::JointMatrix<double, 7> M = arm.dynamics().mass_matrix;
  Vector<7> squares = Vector<7>::Zero();
  constexpr int samples = 4000;
  for (int k = 0; k < samples; ++k) {
    arm.step(panda().dynamics(arm.q(), Vector<7>::Zero()).gravity);
    squares += arm.tau_ext().cwiseAbs2();
  }
  const Vector<7> expected = 50 * 0.003 * std::sqrt(2 / 1.95) * (M * M).diagonal().cwiseSqrt();
  CHECK(expected.maxCoeff() > 0.1);
  CHECK(((squares / samples).cwiseSqrt().cwiseQuotient(expected).array() - 1).abs().maxCoeff() < 0.06);
}

TEST_CASE("SyntheticArm: tau_ext in steps is the nearest multiple of the step", "[synthetic_arm]") {
  SyntheticArmConfig<7> config = noisy_sensors();
  const auto exact = tau_ext_of(config);
  config.torque_step = 0.05;
  const auto stepped = tau_ext_of(config);
  bool multiple = true;
  double furthest = 0;
  for (std::size_t k = 0; k < exact.size(); ++k) {
    const Vector<7> steps = stepped[k] / 0.05;
    multiple = multiple && (steps.array() - steps.array().round()).abs().maxCoeff() < 1e-9;
    furthest = std::max(furthest, (stepped[k] - exact[k]).cwiseAbs().maxCoeff());
  }
  CHECK(multiple);
  CHECK(furthest <= 0.025 + 1e-12);
  CHECK(furthest > 0.024);
}

TEST_CASE("SyntheticArm: a late tau_ext is the one of so many periods before, and zero until then", "[synthetic_arm]") {
  SyntheticArmConfig<7> config = noisy_sensors();
  const auto prompt = tau_ext_of(config);
  for (const int delay : {1, 5}) {
    CAPTURE(delay);
    config.torque_delay = delay;
    const auto late = tau_ext_of(config);
    const auto shift = static_cast<std::size_t>(delay);
    bool same = true;
    for (std::size_t k = 0; k < late.size(); ++k)
      same = same && late[k] == (k < shift ? Vector<7>::Zero().eval() : prompt[k - shift]);
    CHECK(same);
  }
}

TEST_CASE("SyntheticArm: reports get lost as often as they are told to, and the others stay the same",
          "[synthetic_arm]") {
  SyntheticArmConfig<7> config = noisy_sensors();
  const auto all = tau_ext_of(config);
  config.loss = 0.1;
  std::size_t k = 0, lost = 0, in_a_row = 0;
  bool same = true, last = false;
  sway(config, [&](const SyntheticArm<7>& arm) {
    same = same && arm.tau_ext() == all[k++];
    lost += arm.lost() ? 1 : 0;
    in_a_row += arm.lost() && last ? 1 : 0;
    last = arm.lost();
  });
  CHECK(same);
  // Of 1001: 100 +- 9.5 lost, 10 +- 3.5 right after another.
  CHECK((lost > 60 && lost < 140));
  CHECK((in_a_row > 0 && in_a_row < 25));
}

TEST_CASE("SyntheticArm: links that weigh more than the model says show in tau_ext as the gravity that it lacks",
          "[synthetic_arm]") {
  SyntheticArmConfig<7> config;
  config.mass_error = 0.01;
  config.com_error = 0.001;
  config.seed = 7;
  SyntheticArm<7> arm(panda(), config, panda().ready);
  hold(arm, PoseImpedance<7>(panda(), panda().ready), 6);
  // M ddq + C dq + g = tau + tau_ext at rest: the model's g is short of what gravity does to the real links.
  const ArmModel<7> real = with_model_error(panda(), 0.01, 0.001, 7);
  const Vector<7> lacking =
      panda().dynamics(arm.q(), 0 * arm.q()).gravity - real.dynamics(arm.q(), 0 * arm.q()).gravity;
  CHECK((arm.tau_ext() - lacking).norm() < 1e-6);
  CHECK(lacking.norm() > 0.05);
}

TEST_CASE("SyntheticArm: its model is off by what was asked for, and by nothing if nothing was", "[synthetic_arm]") {
  double mass = 0, com = 0;
  for (std::uint64_t seed = 0; seed < 100; ++seed) {
    const ArmModel<7> real = with_model_error(panda(), 0.01, 0.001, seed);
    for (std::size_t i = 0; i < 7; ++i) {
      const RigidBody &is = real.links[i].body, &should = panda().links[i].body;
      mass += std::pow(is.mass / should.mass - 1, 2);
      com += (is.com - should.com).squaredNorm() / 3;
      CHECK((is.inertia / is.mass - should.inertia / should.mass).norm() < 1e-12);
    }
  }
  // 700 masses, 2100 coordinates: known to 2.7 % and 1.5 %.
  CHECK(std::sqrt(mass / 700) == Approx(0.01).epsilon(0.11));
  CHECK(std::sqrt(com / 700) == Approx(0.001).epsilon(0.06));
  const ArmModel<7> right = with_model_error(panda(), 0, 0, 3);
  for (std::size_t i = 0; i < 7; ++i) {
    CHECK(right.links[i].body.mass == panda().links[i].body.mass);
    CHECK(right.links[i].body.com == panda().links[i].body.com);
    CHECK(right.links[i].body.inertia == panda().links[i].body.inertia);
  }
}

TEST_CASE("SyntheticArm: commands beyond the arm's torque limits are cut", "[synthetic_arm]") {
  SyntheticArm<7> arm(panda(), {}, panda().ready);
  arm.step(Vector<7>::Constant(1000));
  CHECK(arm.tau_measured() == panda().tau_max);
  arm.step(Vector<7>::Constant(-1000));
  CHECK(arm.tau_measured() == -panda().tau_max);
}

TEST_CASE("SyntheticArm: settings out of range are refused by name", "[synthetic_arm]") {
  SyntheticArmConfig<7> config;
  config.substeps = 0;
  CHECK_THROWS_WITH(SyntheticArm<7>(panda(), config, panda().ready), contains("substeps"));
  config = {};
  config.friction.coulomb[3] = -0.1;
  CHECK_THROWS_WITH(SyntheticArm<7>(panda(), config, panda().ready), contains("coulomb"));
  const auto refused = [](const char* field, auto set) {
    CAPTURE(field);
    SyntheticArmConfig<7> wrong;
    set(wrong);
    CHECK_THROWS_WITH(SyntheticArm<7>(panda(), wrong, panda().ready), contains(field));
  };
  refused("dq_noise", [](auto& c) { c.dq_noise[2] = -1e-3; });
  refused("torque_step", [](auto& c) { c.torque_step = -0.05; });
  refused("torque_delay", [](auto& c) { c.torque_delay = -1; });
  refused("loss", [](auto& c) { c.loss = 1; });
  refused("loss", [](auto& c) { c.loss = -0.1; });
  refused("mass_error", [](auto& c) { c.mass_error = -0.01; });
  refused("com_error", [](auto& c) { c.com_error = std::nan(""); });
  config = {};
  config.dt = 0;
  CHECK_THROWS_WITH(SyntheticArm<7>(panda(), config, panda().ready), contains("dt"));
}

TEST_CASE("PoseImpedance: the posture torque moves the elbow and leaves the flange where it is", "[pose_impedance]") {
  // At rest on the target pose but with another posture: the law's only torque beyond gravity is the null space's,
  // and the flange must not accelerate, J M^-1 tau = 0 (at rest dJ/dt dq = 0).
  const PoseImpedance<7> law(panda(), panda().ready);
  Vector<7> q = panda().ready;
  const auto target = panda().kinematics(q);
  for (int k = 0; k < 2000; ++k) {  // walks along the null space of J, back onto the pose after each step
    const auto at = panda().kinematics(q);
    const Eigen::AngleAxisd turn(target.rotation * at.rotation.transpose());
    rme::Vector6<double> error;
    error << target.position - at.position, turn.angle() * turn.axis();
    // J^T (J J^T)^-1 of the error and, of what moves the elbow, of what J sees.
    const Vector<7> elbow = (k < 1990 ? 2e-4 : 0.0) * Vector<7>::Unit(0);
    const oracle::Matrix J = at.jacobian, seen = error - at.jacobian * elbow;
    q += elbow + Vector<7>(oracle::product(oracle::transposed(J), oracle::solve(oracle::square(J), seen)));
  }
  REQUIRE((q - panda().ready).norm() > 0.1);
  const auto at = panda().kinematics(q);
  const auto terms = panda().dynamics(q, Vector<7>::Zero());
  const Vector<7> tau = law.torque(q, Vector<7>::Zero(), at, terms) - terms.gravity;
  CHECK(tau.norm() > 0.1);
  CHECK(oracle::product(at.jacobian, oracle::solve(terms.mass_matrix, tau)).norm() < 1e-6);
  CHECK(tau.dot(panda().ready - q) > 0);  // towards the posture, not away from it
}

TEST_CASE("PoseImpedance: a target that says how it moves is followed, one that does not is lagged behind",
          "[pose_impedance]") {
  // Down at 5 cm/s while turning at 0.2 rad/s about the vertical, three seconds long. Without the target's velocity the
  // damping holds the arm back until the pull of the distance makes up for it: v / rate = 17 mm, D_r w / K_r = 0.02
  // rad.
  const Eigen::Vector3d velocity(0, 0, -0.05), spin(0, 0, 0.2);
  const auto home = panda().kinematics(panda().ready);
  const auto distance = [&](bool told) {
    SyntheticArm<7> arm(panda(), {}, panda().ready);
    PoseImpedance<7> law(panda(), panda().ready);
    while (arm.time() < 3) {
      const double t = arm.time();
      const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.2 * t, Eigen::Vector3d::UnitZ()) * home.rotation;
      rme::examples::PoseTarget target{home.position + t * velocity, turned};
      if (told) {
        target.velocity = velocity;
        target.angular_velocity = spin;
      }
      law.follow(target);
      arm.step(law.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics()));
    }
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.6, Eigen::Vector3d::UnitZ()) * home.rotation;
    return std::pair((arm.kinematics().position - home.position - 3 * velocity).norm(),
                     Eigen::AngleAxisd(turned * arm.kinematics().rotation.transpose()).angle());
  };
  const auto [near, near_turn] = distance(true);
  const auto [far, far_turn] = distance(false);
  CHECK(near < 2e-3);
  CHECK(near_turn < 4e-3);
  CHECK(far == Approx(0.05 / 3).epsilon(0.2));
  CHECK(far_turn == Approx(0.02).epsilon(0.3));
}

}  // namespace
