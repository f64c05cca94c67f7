#include <cmath>
#include <cstdlib>
#include <limits>
#include <random>
#include <rme/control/barriers.hpp>
#include <rme/control/cpic.hpp>
#include <rme/core/cholesky.hpp>
#include <rme/inference/payload_enclosure.hpp>

#include "inference/enclosure_trial.hpp"
#include "support/allocation_count.hpp"
#include "support/catch.hpp"

namespace {

using rme::PayloadBox;
using rme::PayloadEnclosure;
using rme::PayloadEnclosureConfig;
using rme::Status;
using rme::testing::Errors;
using rme::testing::panda_bounds;
using rme::testing::random_trial;
using rme::testing::Torque7;
using rme::testing::Trial;

constexpr double kInfinity = std::numeric_limits<double>::infinity();

/// An arm of one joint, on which the payload of 1 kg exerts `a` [N m].
using One = PayloadEnclosure<double, 1>;
using OneConfig = PayloadEnclosureConfig<double, 1>;
using Torque1 = rme::JointVector<double, 1>;

Torque1 torque(double tau) {
  return Torque1::Constant(tau);
}

rme::PayloadRegressor<double, 1> lever(double a) {
  rme::PayloadRegressor<double, 1> regressor;
  regressor.a[0] = a;
  return regressor;
}

OneConfig one_config() {
  OneConfig config;
  config.drift[0] = 0.1;
  config.com_lower.setConstant(-0.5);
  config.com_upper.setConstant(0.5);
  return config;
}

/// The masses that an arm of one joint leaves.
void check_mass(One& enclosure, double lower, double upper) {
  PayloadBox<double> box;
  REQUIRE(enclosure.solve(box) == Status::Ok);
  CHECK(std::abs(box.mass_lower - lower) < 1e-12);
  CHECK(std::abs(box.mass_upper - upper) < 1e-12);
}

template <typename Scalar, int MaxPoses>
void add(PayloadEnclosure<Scalar, 7, MaxPoses>& enclosure, const Trial& trial) {
  for (const auto& pose : trial.poses) {
    const rme::PayloadRegressor<Scalar, 7> regressor{pose.regressor.a.template cast<Scalar>(),
                                                     pose.regressor.B.template cast<Scalar>()};
    REQUIRE(enclosure.add_change(pose.before.template cast<Scalar>(), pose.after.template cast<Scalar>(), regressor) ==
            Status::Ok);
  }
}

TEST_CASE("PayloadEnclosure: two joints, one that shows the mass and one that shows the moment, by hand",
          "[enclosure]") {
  PayloadEnclosureConfig<double, 2> config;
  config.drift << 0.1, 0.2;
  config.friction << 0.05, 0;
  rme::PayloadRegressor<double, 2> regressor;
  regressor.a << -9.81, 0;
  regressor.B.row(1) << 20, 0, 0;
  // 2 kg and 0.3 kg m, read with errors of 0.15 and -0.1 N m of the 0.1 + 2 * 0.05 and 0.2 that are stated.
  const Eigen::Vector2d before(1, 2), after = before + Eigen::Vector2d(-19.62 + 0.15, 6 - 0.1);
  const double lightest = (19.47 - 0.2) / 9.81, heaviest = (19.47 + 0.2) / 9.81;

  PayloadEnclosure<double, 2> enclosure(config);
  REQUIRE(enclosure.add_change(before, after, regressor) == Status::Ok);
  PayloadBox<double> box;
  CHECK(enclosure.solve(box) == Status::Unbounded);  // no joint shows y or z
  CHECK(std::abs(box.mass_lower - lightest) < 1e-11);
  CHECK(std::abs(box.mass_upper - heaviest) < 1e-11);
  CHECK(std::abs(box.moment_lower[0] - 0.285) < 1e-11);
  CHECK(std::abs(box.moment_upper[0] - 0.305) < 1e-11);
  CHECK(std::abs(box.com_lower[0] - 0.285 / heaviest) < 1e-11);
  CHECK(std::abs(box.com_upper[0] - 0.305 / lightest) < 1e-11);
  for (int i = 1; i < 3; ++i) {
    CHECK(box.moment_lower[i] == -kInfinity);
    CHECK(box.moment_upper[i] == kInfinity);
    CHECK(box.com_lower[i] == -kInfinity);
    CHECK(box.com_upper[i] == kInfinity);
  }
  CHECK(box.scale < 1e-11);  // two joints, two unknowns: some payload fits without any error

  // Bounds of the centre of mass bound what no joint shows; on x, 0.15 m cuts off what the readings leave.
  config.com_lower << 0, -0.1, 0.02;
  config.com_upper << 0.15, 0.1, 0.02;
  PayloadEnclosure<double, 2> bounded(config);
  REQUIRE(bounded.add_change(before, after, regressor) == Status::Ok);
  REQUIRE(bounded.solve(box) == Status::Ok);
  CHECK(std::abs(box.moment_upper[0] - 0.15 * heaviest) < 1e-11);
  CHECK(std::abs(box.mass_lower - lightest) < 1e-11);
  CHECK(std::abs(box.com_upper[0] - 0.15) < 1e-11);
  CHECK(std::abs(box.moment_lower[1] + 0.1 * heaviest) < 1e-11);
  CHECK(std::abs(box.moment_upper[2] - 0.02 * heaviest) < 1e-11);
  CHECK(std::abs(box.moment_lower[2] - 0.02 * lightest) < 1e-11);
  CHECK(std::abs(box.com_lower[2] - 0.02) < 1e-11);
  Eigen::Vector2d lower, upper;
  REQUIRE(bounded.range(regressor, lower, upper) == Status::Ok);
  CHECK((lower - Eigen::Vector2d(-19.47 - 0.2, 5.7)).norm() < 1e-11);
  CHECK((upper - Eigen::Vector2d(-19.47 + 0.2, 20 * 0.15 * heaviest)).norm() < 1e-11);
}

TEST_CASE("PayloadEnclosure: what is the same before and after cancels", "[enclosure]") {
  std::mt19937_64 random(41);
  const Trial trial = random_trial(random, panda_bounds(), 1, Errors::WithinBounds);
  const auto& pose = trial.poses[0];
  PayloadEnclosure<double, 7> plain(panda_bounds()), shifted(panda_bounds());
  const Torque7 offset = Torque7::LinSpaced(-8, 8);
  REQUIRE(plain.add_change(pose.before, pose.after, pose.regressor) == Status::Ok);
  REQUIRE(shifted.add_change(pose.before + offset, pose.after + offset, pose.regressor) == Status::Ok);
  PayloadBox<double> a, b;
  REQUIRE(plain.solve(a) == Status::Ok);
  REQUIRE(shifted.solve(b) == Status::Ok);
  CHECK(std::abs(a.mass_lower - b.mass_lower) < 1e-12);
  CHECK(std::abs(a.mass_upper - b.mass_upper) < 1e-12);
  CHECK((a.com_lower - b.com_lower).norm() < 1e-12);
  CHECK(a.mass_upper - a.mass_lower > 0.01);
}

TEST_CASE("PayloadEnclosure: each stated bound widens the interval as it should, on one joint", "[enclosure]") {
  OneConfig config = one_config();
  SECTION("same pose: drift and twice the friction; offset and link error do not count") {
    config.friction[0] = 0.2;
    config.offset[0] = 100;
    config.link[0] = 100;
    One enclosure(config);
    REQUIRE(enclosure.add_change(torque(3), torque(13), lever(10)) == Status::Ok);
    check_mass(enclosure, 0.95, 1.05);
  }
  SECTION("a bound of the offset that is below the drift bounds the drift") {
    config.offset[0] = 0.02;
    One enclosure(config);
    REQUIRE(enclosure.add_change(torque(0), torque(10), lever(10)) == Status::Ok);
    check_mass(enclosure, 0.996, 1.004);
  }
  SECTION("another pose: twice the link error as well") {
    config.link[0] = 0.5;
    One enclosure(config);
    REQUIRE(enclosure.add_empty(torque(3)) == Status::Ok);
    REQUIRE(enclosure.add_loaded(torque(13), lever(10)) == Status::Ok);
    check_mass(enclosure, 0.89, 1.11);
  }
  SECTION("a reading by itself: offset, friction and link error") {
    config.link[0] = 0.5;
    config.offset[0] = 2;
    config.friction[0] = 0.25;
    One enclosure(config);
    REQUIRE(enclosure.add_loaded(torque(13), lever(10)) == Status::Ok);
    check_mass(enclosure, 1.025, 1.575);
    REQUIRE(enclosure.add_empty(torque(2)) == Status::Ok);  // and 0.1 + 2 (0.25 + 0.5) from the difference
    check_mass(enclosure, 1.025, 1.26);
  }
  SECTION("two loaded poses: their difference, although no offset is stated") {
    config.link[0] = 0.5;
    One enclosure(config);
    REQUIRE(enclosure.add_loaded(torque(53), lever(10)) == Status::Ok);
    REQUIRE(enclosure.add_loaded(torque(64), lever(20)) == Status::Ok);
    check_mass(enclosure, 0.99, 1.21);
  }
  SECTION("gain: the payload's torque may be misread by a share, whatever its sign") {
    config.gain[0] = 0.1;
    for (const double sign : {-1.0, 1.0}) {
      One enclosure(config);
      REQUIRE(enclosure.add_change(torque(3), torque(3 + sign * 10), lever(sign * 10)) == Status::Ok);
      check_mass(enclosure, 9.9 / 11, 10.1 / 9);
      REQUIRE(enclosure.add_loaded(torque(1000), lever(20)) == Status::Ok);  // no bound of link: says nothing
      check_mass(enclosure, 9.9 / 11, 10.1 / 9);
    }
  }
  SECTION("gain, if the readings come in the order loaded, empty") {
    config.gain[0] = 0.1;
    config.link[0] = 0;
    One enclosure(config);
    REQUIRE(enclosure.add_loaded(torque(13), lever(10)) == Status::Ok);
    REQUIRE(enclosure.add_empty(torque(3)) == Status::Ok);
    check_mass(enclosure, 9.9 / 11, 10.1 / 9);
  }
  SECTION("a loaded reading alone, of which neither offset nor link error is stated") {
    One enclosure(config);
    REQUIRE(enclosure.add_loaded(torque(13), lever(10)) == Status::Ok);
    PayloadBox<double> box;
    CHECK(enclosure.solve(box) == Status::NotReady);
  }
  SECTION("a lever that the centre of mass may cancel: the mass is unbounded, the centre of mass as stated") {
    auto crooked = lever(10);
    crooked.B(0, 0) = -20;
    One enclosure(config);
    REQUIRE(enclosure.add_change(torque(0), torque(5), crooked) == Status::Ok);
    PayloadBox<double> box;
    CHECK(enclosure.solve(box) == Status::Unbounded);
    CHECK(std::abs(box.mass_lower - 4.9 / 20) < 1e-12);  // at -0.5 m
    CHECK(box.mass_upper == kInfinity);
    CHECK(box.com_lower == config.com_lower);
    CHECK(box.com_upper == config.com_upper);
  }
  SECTION("the rated mass") {
    config.mass_limit = 1;
    One enclosure(config);
    REQUIRE(enclosure.add_change(torque(0), torque(10), lever(10)) == Status::Ok);
    check_mass(enclosure, 0.99, 1);
  }
  SECTION("no mass is negative") {
    One enclosure(config);
    REQUIRE(enclosure.add_change(torque(0.05), torque(0), lever(10)) == Status::Ok);
    check_mass(enclosure, 0, 0.005);
    PayloadBox<double> box;
    REQUIRE(enclosure.solve(box) == Status::Ok);
    CHECK(box.com_lower == config.com_lower);  // where what weighs nothing has its centre, nothing says
    CHECK(box.com_upper == config.com_upper);
  }
}

TEST_CASE("PayloadEnclosure: a violated bound leaves the empty set, and by how much is said", "[enclosure]") {
  // Both joints show the mass: 1 kg +- 0.1 and 1.2 kg +- 0.05. With s times the bounds, 10 m <= 10 + s and
  // 20 m >= 24 - s meet at s = 4/3.
  PayloadEnclosureConfig<double, 2> config;
  config.drift << 1, 1;
  rme::PayloadRegressor<double, 2> regressor;
  regressor.a << 10, 20;
  PayloadEnclosure<double, 2> enclosure(config);
  const Eigen::Vector2d nothing(0, 0);
  REQUIRE(enclosure.add_change(nothing, Eigen::Vector2d(10, 24), regressor) == Status::Ok);
  PayloadBox<double> box;
  CHECK(enclosure.solve(box) == Status::Infeasible);
  CHECK(std::abs(box.scale - 4.0 / 3) < 1e-13);
  CHECK(box.mass_lower == kInfinity);
  CHECK(box.mass_upper == -kInfinity);
  CHECK((box.com_lower.array() > box.com_upper.array()).all());
  CHECK((box.moment_lower.array() > box.moment_upper.array()).all());
  Eigen::Vector2d lower(7, 7), upper(8, 8);
  CHECK(enclosure.range(regressor, lower, upper) == Status::Infeasible);
  CHECK(lower == Eigen::Vector2d(7, 7));
  CHECK(upper == Eigen::Vector2d(8, 8));

  // 4/3 of the bounds are just enough: the set is a point.
  config.drift *= (4.0 / 3) * (1 + 1e-12);
  config.com_lower.setZero();
  config.com_upper.setZero();
  PayloadEnclosure<double, 2> point(config);
  REQUIRE(point.add_change(nothing, Eigen::Vector2d(10, 24), regressor) == Status::Ok);
  REQUIRE(point.solve(box) == Status::Ok);
  CHECK(std::abs(box.scale - 1) < 1e-11);
  CHECK(std::abs(box.mass_lower - 34.0 / 30) < 1e-11);
  CHECK(std::abs(box.mass_upper - 34.0 / 30) < 1e-11);

  // Bounds of the mass are not among those that s loosens, but they are bounds: a torque upwards fits no payload.
  OneConfig one = one_config();
  One upwards(one);
  REQUIRE(upwards.add_change(torque(0), torque(-1), lever(10)) == Status::Ok);
  CHECK(upwards.solve(box) == Status::Infeasible);
  CHECK(std::abs(box.scale - 10) < 1e-12);
  one.com_lower.setConstant(-kInfinity);
  one.com_upper.setConstant(kInfinity);
  One without_limits(one);
  REQUIRE(without_limits.add_change(torque(0), torque(-1), lever(10)) == Status::Ok);
  CHECK(without_limits.solve(box) == Status::Infeasible);
  one = one_config();

  // Two readings of the empty hand that contradict each other: 5 N m where 0.1 + 2 * 0.5 are stated.
  one.link[0] = 0.5;
  One drifted(one);
  REQUIRE(drifted.add_empty(torque(0)) == Status::Ok);
  REQUIRE(drifted.add_empty(torque(5)) == Status::Ok);
  CHECK(drifted.solve(box) == Status::NotReady);
  REQUIRE(drifted.add_change(torque(5), torque(15), lever(10)) == Status::Ok);
  CHECK(drifted.solve(box) == Status::Infeasible);
  CHECK(std::abs(box.scale - 5 / 1.1) < 1e-12);
  drifted.clear();
  REQUIRE(drifted.add_change(torque(5), torque(15), lever(10)) == Status::Ok);
  check_mass(drifted, 0.99, 1.01);
}

TEST_CASE("PayloadEnclosure: 100,000 trials with errors at their bounds, and no truth outside", "[enclosure]") {
  const unsigned seed = 42;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto config = panda_bounds();
  PayloadEnclosure<double, 7> enclosure(config);
  int outside = 0, at_an_end = 0;
  for (int k = 0; k < 100000; ++k) {
    const Trial trial = random_trial(random, config, 1, Errors::AtBounds);
    enclosure.clear();
    (void)enclosure.add_change(trial.poses[0].before, trial.poses[0].after, trial.poses[0].regressor);
    PayloadBox<double> box;
    const Status status = enclosure.solve(box);
    outside += status != Status::Ok || !rme::testing::contains(box, trial.truth);
    at_an_end +=
        std::abs(box.mass_lower - trial.truth.mass) < 1e-9 || std::abs(box.mass_upper - trial.truth.mass) < 1e-9;
  }
  CHECK(outside == 0);
  CHECK(at_an_end > 20000);  // the intervals are no wider than the errors make them
}

TEST_CASE("PayloadEnclosure: errors of every kind at their bounds over several poses, in double and float",
          "[enclosure]") {
  const unsigned seed = 43;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  auto config = panda_bounds();
  for (int variant = 0; variant < 4; ++variant) {
    CAPTURE(variant);
    if (variant > 0) config.friction = 2 * config.drift;
    if (variant > 1) config.link.setConstant(0.2);
    if (variant > 1) config.offset.setConstant(0.3);
    if (variant > 2) config.gain.setConstant(0.05);
    PayloadEnclosureConfig<float, 7> config_f;
    config_f.drift = config.drift.cast<float>();
    config_f.friction = config.friction.cast<float>();
    config_f.offset = config.offset.cast<float>();
    config_f.link = config.link.cast<float>();
    config_f.gain = config.gain.cast<float>();
    config_f.mass_limit = 3;
    config_f.com_lower = config.com_lower.cast<float>();
    config_f.com_upper = config.com_upper.cast<float>();
    PayloadEnclosure<double, 7, 3> enclosure(config);
    PayloadEnclosure<float, 7, 3> enclosure_f(config_f);
    double apart = 0, thin = 0;
    int outside = 0, outside_f = 0, torque_outside = 0;
    for (int k = 0; k < 1500; ++k) {
      const Trial trial = random_trial(random, config, 1 + k % 3, k % 2 ? Errors::AtBounds : Errors::WithinBounds);
      enclosure.clear();
      enclosure_f.clear();
      add(enclosure, trial);
      add(enclosure_f, trial);
      PayloadBox<double> box;
      PayloadBox<float> box_f;
      outside += enclosure.solve(box) != Status::Ok || !rme::testing::contains(box, trial.truth);
      outside_f += enclosure_f.solve(box_f) != Status::Ok || !rme::testing::contains(box_f, trial.truth);
      double& worst = k % 2 ? thin : apart;
      worst = std::max({worst, std::abs(double(box_f.mass_lower) - box.mass_lower),
                        std::abs(double(box_f.mass_upper) - box.mass_upper)});
      const auto elsewhere = rme::testing::panda_regressor(rme::testing::random_pose_near_ready(random));
      Torque7 lower, upper;
      REQUIRE(enclosure.range(elsewhere, lower, upper) == Status::Ok);
      const Torque7 truth = elsewhere.torque(trial.truth);
      torque_outside += !((lower.array() <= truth.array()).all() && (truth.array() <= upper.array()).all());
    }
    CHECK(outside == 0);
    CHECK(outside_f == 0);
    CHECK(torque_outside == 0);
    CHECK(apart < 5e-4);
    CHECK(thin < 0.1);  // errors at their bounds leave sets that are thinner than what float makes of their torque
  }
}

TEST_CASE("PayloadEnclosure: in a direction that no joint shows, the interval is the stated limit, or unbounded",
          "[enclosure]") {
  // A singular pose, in which no joint feels any payload.
  const rme::PayloadRegressor<double, 7> blind;
  auto config = panda_bounds();
  PayloadEnclosure<double, 7> enclosure(config);
  PayloadBox<double> box;
  REQUIRE(enclosure.add_change(Torque7::Zero(), Torque7::Zero(), blind) == Status::Ok);
  REQUIRE(enclosure.solve(box) == Status::Ok);
  CHECK(std::abs(box.mass_lower) < 1e-12);
  CHECK(std::abs(box.mass_upper - 3) < 1e-12);
  CHECK((box.moment_upper.array() - 0.75).abs().maxCoeff() < 1e-12);
  CHECK(box.com_upper == config.com_upper);

  config.mass_limit = kInfinity;
  PayloadEnclosure<double, 7> unlimited(config);
  REQUIRE(unlimited.add_change(Torque7::Zero(), Torque7::Zero(), blind) == Status::Ok);
  CHECK(unlimited.solve(box) == Status::Unbounded);
  CHECK(box.mass_lower == 0);
  CHECK(box.mass_upper == kInfinity);
  CHECK(box.moment_lower[2] == -kInfinity);

  // One pose: the moment along gravity does not show. In a second pose gravity is elsewhere in the hand's axes.
  std::mt19937_64 random(44);
  config.com_lower.setConstant(-kInfinity);
  config.com_upper.setConstant(kInfinity);
  const Trial trial = random_trial(random, config, 2, Errors::WithinBounds);
  PayloadEnclosure<double, 7> free(config);
  REQUIRE(free.add_change(trial.poses[0].before, trial.poses[0].after, trial.poses[0].regressor) == Status::Ok);
  CHECK(free.solve(box) == Status::Unbounded);
  CHECK(box.mass_upper - box.mass_lower < 0.2);
  CHECK(box.mass_lower <= trial.truth.mass);
  CHECK(box.mass_upper >= trial.truth.mass);
  CHECK(box.moment_upper[2] == kInfinity);
  // The torque in this pose is bounded all the same, and that in another pose is not.
  Torque7 lower, upper;
  const Torque7 change = trial.poses[0].after - trial.poses[0].before;
  REQUIRE(free.range(trial.poses[0].regressor, lower, upper) == Status::Ok);
  CHECK((upper - change - config.drift).maxCoeff() < 1e-9);
  CHECK((change - config.drift - lower).maxCoeff() < 1e-9);
  CHECK(free.range(trial.poses[1].regressor, lower, upper) == Status::Unbounded);
  CHECK(upper.maxCoeff() == kInfinity);
  REQUIRE(free.add_change(trial.poses[1].before, trial.poses[1].after, trial.poses[1].regressor) == Status::Ok);
  REQUIRE(free.solve(box) == Status::Ok);
  CHECK(rme::testing::contains(box, trial.truth));
  CHECK((box.com_upper - box.com_lower).maxCoeff() < 0.3);
}

TEST_CASE("PayloadEnclosure: with its worst case in CPIC's rows, no payload that agrees breaks a joint limit",
          "[enclosure]") {
  // The world of this test: M ddq = tau - bias + A (phi - phi_hat), a payload whose own inertia is small, compensated as
  // phi_hat.
  const unsigned seed = 45;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto& arm = rme::examples::panda();
  auto config = panda_bounds();
  config.friction = config.drift;
  rme::CpicConfig<double, 7> cpic_config;
  cpic_config.torque_limit = arm.tau_max;
  rme::JointLimitsConfig<double, 7> limits_config;
  limits_config.q_min = arm.q_min;
  limits_config.q_max = arm.q_max;
  const rme::JointLimits<double, 7> limits(limits_config);
  int broken_plain = 0, broken_worst = 0, solved = 0, unsure = 0;
  for (int k = 0; k < 300; ++k) {
    CAPTURE(k);
    const Trial trial = random_trial(random, config, 1, Errors::AtBounds);
    PayloadEnclosure<double, 7> enclosure(config);
    add(enclosure, trial);
    PayloadBox<double> box;
    REQUIRE(enclosure.solve(box) == Status::Ok);

    // Joint 4 goes for its upper limit, 5 mm short of it, and the task drives the hand on.
    Torque7 q = rme::testing::random_pose_near_ready(random), dq = Torque7::Zero();
    q[3] = arm.q_max[3] - 0.005;
    const auto at = arm.kinematics(q);
    const auto dynamics = arm.dynamics(q, dq);
    const auto regressor = rme::testing::panda_regressor(q);
    const rme::Payload<double> estimate = {(box.mass_lower + box.mass_upper) / 2, (box.com_lower + box.com_upper) / 2};
    rme::CpicInput<double, 7> input;
    input.jacobian = at.jacobian;
    input.mass_matrix = dynamics.mass_matrix;
    input.bias = dynamics.gravity;
    input.other_torque = -regressor.torque(estimate);
    input.wrench.force = 40 * Eigen::Vector3d(u(random), u(random), u(random));

    // What the prediction may lack: M^-1 A (phi - phi_hat), row by row over the enclosure.
    Eigen::Matrix<double, 7, 4> A;
    A << regressor.a, regressor.B;
    const Eigen::Matrix<double, 7, 7> inverse = rme::Cholesky<double, 7>(dynamics.mass_matrix).inverse();
    Torque7 least, most;
    REQUIRE(enclosure.range<7>(inverse * A, least, most) == Status::Ok);
    const Torque7 counted = inverse * regressor.torque(estimate);
    const rme::AccelerationError<double, 7> worst((counted - least).cwiseMax(0), (most - counted).cwiseMax(0));

    for (const bool careful : {false, true}) {
      rme::Cpic<double, 7> cpic(cpic_config);
      rme::ConstraintRows<double, 7, 28> rows;
      const Status status = limits.append(q, dq, rows, careful ? worst : rme::AccelerationError<double, 7>());
      if (careful && status == Status::Infeasible) {  // so much is unknown that no torque is sure to keep both limits
        ++unsure;
        continue;
      }
      REQUIRE(status == Status::Ok);
      REQUIRE(cpic.update(input, rows) == Status::Ok);
      const Torque7 ddq = inverse * (cpic.torque() + input.other_torque - input.bias + regressor.torque(trial.truth));
      const Torque7 room = limits_config.poles.k1 * (arm.q_max - q) - ddq;
      const Torque7 room_below = limits_config.poles.k1 * (q - arm.q_min) + ddq;
      const bool broken = std::min(room.minCoeff(), room_below.minCoeff()) < -1e-6;
      (careful ? broken_worst : broken_plain) += broken;
      solved += careful;
    }
  }
  CHECK(solved + unsure == 300);
  CHECK(unsure < 30);
  CHECK(broken_plain > 20);
  CHECK(broken_worst == 0);
}

TEST_CASE("PayloadEnclosure: allocates nothing", "[enclosure]") {
#ifdef RME_COUNTS_ALLOCATIONS
  std::mt19937_64 random(46);
  auto config = panda_bounds();
  config.link.setConstant(0.1);
  const Trial trial = random_trial(random, config, 1, Errors::AtBounds);
  const auto& pose = trial.poses[0];
  PayloadEnclosure<double, 7> enclosure(config);
  PayloadBox<double> box;
  Torque7 lower, upper;
  const int before_any = rme::testing::allocations();
  void* volatile kept = std::malloc(8);  // or the compiler leaves the pair out
  std::free(kept);
  REQUIRE(rme::testing::allocations() > before_any);  // the counter counts
  const int before = rme::testing::allocations();
  bool good = enclosure.add_change(pose.before, pose.after, pose.regressor) == Status::Ok;
  good = enclosure.add_empty(pose.before) == Status::Ok && good;
  good = enclosure.add_loaded(pose.after, pose.regressor) == Status::Ok && good;
  good = enclosure.solve(box) == Status::Ok && good;
  good = enclosure.range(pose.regressor, lower, upper) == Status::Ok && good;
  enclosure.clear();
  const int during = rme::testing::allocations() - before;
  CHECK(during == 0);
  CHECK(good);
#endif
}

TEST_CASE("PayloadEnclosure: bad readings are refused, and change nothing", "[enclosure]") {
  std::mt19937_64 random(47);
  const Trial trial = random_trial(random, panda_bounds(), 1, Errors::WithinBounds);
  const auto& pose = trial.poses[0];
  PayloadEnclosure<double, 7, 2> enclosure(panda_bounds());
  PayloadBox<double> box, again;
  Torque7 lower, upper;
  CHECK(enclosure.solve(box) == Status::NotReady);
  CHECK(enclosure.range(pose.regressor, lower, upper) == Status::NotReady);
  REQUIRE(enclosure.add_change(pose.before, pose.after, pose.regressor) == Status::Ok);
  CHECK(enclosure.range(pose.regressor, lower, upper) == Status::NotReady);  // solve() comes first
  REQUIRE(enclosure.solve(box) == Status::Ok);
  for (const double bad : {std::numeric_limits<double>::quiet_NaN(), kInfinity, -2e6}) {
    Torque7 wrong = pose.after;
    wrong[4] = bad;
    auto crooked = pose.regressor;
    crooked.B(6, 2) = bad;
    CHECK(enclosure.add_change(wrong, pose.after, pose.regressor) == Status::NonFiniteInput);
    CHECK(enclosure.add_change(pose.before, wrong, pose.regressor) == Status::NonFiniteInput);
    CHECK(enclosure.add_change(pose.before, pose.after, crooked) == Status::NonFiniteInput);
    CHECK(enclosure.add_loaded(wrong, pose.regressor) == Status::NonFiniteInput);
    CHECK(enclosure.add_loaded(pose.after, crooked) == Status::NonFiniteInput);
    CHECK(enclosure.add_empty(wrong) == Status::NonFiniteInput);
    lower.setConstant(5);
    CHECK(enclosure.range(crooked, lower, upper) == Status::NonFiniteInput);
    CHECK(lower == Torque7::Constant(5));
  }
  REQUIRE(enclosure.range(pose.regressor, lower, upper) == Status::Ok);
  REQUIRE(enclosure.solve(again) == Status::Ok);
  CHECK(again.mass_lower == box.mass_lower);
  CHECK(again.com_upper == box.com_upper);
  REQUIRE(enclosure.add_empty(pose.before) == Status::Ok);
  CHECK(enclosure.range(pose.regressor, lower, upper) == Status::NotReady);  // a reading since solve()
  CHECK(enclosure.add_empty(pose.before) == Status::CapacityExceeded);
  CHECK(enclosure.add_change(pose.before, pose.after, pose.regressor) == Status::CapacityExceeded);
  REQUIRE(enclosure.solve(again) == Status::Ok);
  CHECK(again.mass_upper == box.mass_upper);  // the reading in another pose says nothing without a bound of link
}

TEST_CASE("PayloadEnclosure: the largest readings, and bounds far below them, give an answer or a status",
          "[enclosure]") {
  OneConfig config = one_config();
  config.drift[0] = 1e-9;
  One enclosure(config);
  REQUIRE(enclosure.add_change(torque(-1e6), torque(1e6), lever(1e6)) == Status::Ok);
  PayloadBox<double> box;
  REQUIRE(enclosure.solve(box) == Status::Ok);
  CHECK(box.mass_lower <= 2);
  CHECK(box.mass_upper >= 2);
  CHECK(box.mass_upper - box.mass_lower < 1e-11);
}

TEST_CASE("PayloadEnclosure: the unit of torque makes no difference, and what is hardly bounded says nothing",
          "[enclosure]") {
  std::mt19937_64 random(48);
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    const auto config = panda_bounds();
    const Trial trial = random_trial(random, config, 2, k % 2 ? Errors::AtBounds : Errors::WithinBounds);
    PayloadEnclosure<double, 7> plain(config);
    add(plain, trial);
    PayloadBox<double> box, other;
    REQUIRE(plain.solve(box) == Status::Ok);
    for (const double unit : {1e-5, 1e4}) {
      CAPTURE(unit);
      auto scaled = config;
      scaled.drift *= unit;
      PayloadEnclosure<double, 7> enclosure(scaled);
      for (auto pose : trial.poses) {
        pose.regressor.a *= unit;
        pose.regressor.B *= unit;
        REQUIRE(enclosure.add_change(unit * pose.before, unit * pose.after, pose.regressor) == Status::Ok);
      }
      REQUIRE(enclosure.solve(other) == Status::Ok);
      CHECK(std::abs(other.mass_upper - box.mass_upper) < 1e-8);
      CHECK((other.moment_lower - box.moment_lower).norm() < 1e-8);
      CHECK(rme::testing::contains(other, trial.truth));
    }
    // Joint 2 by itself: a drift of 1e6 N m, or a regressor and a torque of zero.
    auto loose = config;
    loose.drift[1] = 1e6;
    PayloadEnclosure<double, 7> loose_one(loose), without(config);
    for (auto pose : trial.poses) {
      REQUIRE(loose_one.add_change(pose.before, pose.after, pose.regressor) == Status::Ok);
      pose.regressor.a[1] = pose.after[1] = pose.before[1] = 0;
      pose.regressor.B.row(1).setZero();
      REQUIRE(without.add_change(pose.before, pose.after, pose.regressor) == Status::Ok);
    }
    REQUIRE(loose_one.solve(box) == Status::Ok);
    REQUIRE(without.solve(other) == Status::Ok);
    CHECK(std::abs(other.mass_lower - box.mass_lower) < 1e-8);
    CHECK((other.moment_upper - box.moment_upper).norm() < 1e-8);
    CHECK(rme::testing::contains(box, trial.truth));
  }
}

template <typename Change>
std::string refusal(const Change& change) {
  OneConfig config = one_config();
  change(config);
  try {
    One enclosure(config);
  } catch (const std::invalid_argument& error) {
    return error.what();
  }
  return "";
}

TEST_CASE("PayloadEnclosure: a wrong setting is refused by its name", "[enclosure]") {
  const double nan = std::numeric_limits<double>::quiet_NaN();
  CHECK(refusal([](OneConfig&) {}).empty());
  for (const double bad : {0.0, -1.0, nan, kInfinity}) {
    const std::string message = refusal([&](OneConfig& c) { c.drift[0] = bad; });
    CHECK_THAT(message, contains("PayloadEnclosureConfig::drift: expected > 0 N m, got "));
  }
  CHECK_THAT(refusal([](OneConfig& c) { c.drift[0] = -1; }), contains("got -1.0"));
  for (const double bad : {-0.1, nan, kInfinity})
    CHECK_THAT(refusal([&](OneConfig& c) { c.friction[0] = bad; }), contains("PayloadEnclosureConfig::friction"));
  for (const double bad : {0.0, nan})
    CHECK_THAT(refusal([&](OneConfig& c) { c.offset[0] = bad; }), contains("PayloadEnclosureConfig::offset"));
  for (const double bad : {-0.1, nan})
    CHECK_THAT(refusal([&](OneConfig& c) { c.link[0] = bad; }), contains("PayloadEnclosureConfig::link"));
  for (const double bad : {-0.1, 1.0, nan})
    CHECK_THAT(refusal([&](OneConfig& c) { c.gain[0] = bad; }), contains("PayloadEnclosureConfig::gain"));
  for (const double bad : {0.0, nan})
    CHECK_THAT(refusal([&](OneConfig& c) { c.mass_limit = bad; }), contains("PayloadEnclosureConfig::mass_limit"));
  for (const double bad : {kInfinity, nan})
    CHECK_THAT(refusal([&](OneConfig& c) { c.com_lower[1] = bad; }), contains("PayloadEnclosureConfig::com_lower"));
  for (const double bad : {-kInfinity, -0.6, nan})
    CHECK_THAT(refusal([&](OneConfig& c) { c.com_upper[1] = bad; }), contains("PayloadEnclosureConfig::com_upper"));
}

}  // namespace
