#include <cmath>
#include <rme/control/barriers.hpp>
#include <rme/control/prediction_error.hpp>
#include <synthetic_arm/panda.hpp>
#include <tuple>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using Vector7 = rme::JointVector<double, 7>;
using rme::examples::panda;

rme::PointMotion<double, 7> flange_motion(const Vector7& q, const Vector7& dq) {
  const auto k = panda().kinematics(q);
  const double h = 1e-5;
  const rme::Jacobian<double, 7> rate =
      (panda().kinematics(q + h * dq).jacobian - panda().kinematics(q - h * dq).jacobian) / (2 * h);
  return {k.position, k.jacobian.topRows<3>() * dq, k.jacobian.topRows<3>(), rate.topRows<3>() * dq};
}

TEST_CASE("Task-space barriers: gradient and curvature are those of h along the arm's motion", "[barriers]") {
  // Along q(t) = q + dq t + ddq t^2 / 2: h' = grad_h . dq and h'' = grad_h . ddq + dq^T hess_h dq, by differences of h.
  const unsigned seed = 4321;
  CAPTURE(seed);
  std::mt19937 random(seed);
  for (int i = 0; i < 50; ++i) {
    const Vector7 q = panda().ready + 0.3 * oracle::random_matrix(random, 7, 1);
    const Vector7 dq = oracle::random_matrix(random, 7, 1), ddq = oracle::random_matrix(random, 7, 1);
    const Eigen::Vector3d normal = oracle::random_matrix(random, 3, 1).normalized();
    const Eigen::Vector3d center(0.4, 0.1, 0.3);
    const auto barriers = [&](const Vector7& at, const Vector7& rate) {
      const auto point = flange_motion(at, rate);
      return std::array<rme::BarrierValue<double, 7>, 3>{
          rme::half_space_barrier<double, 7>(point, normal, 0.2),
          rme::sphere_barrier<double, 7>(point, center, 0.3, rme::SphereSide::Outside),
          rme::sphere_barrier<double, 7>(point, center, 0.9, rme::SphereSide::Inside)};
    };
    const double t = 1e-4;
    const auto now = barriers(q, dq);
    const auto ahead = barriers(q + t * dq + t * t / 2 * ddq, dq);
    const auto behind = barriers(q - t * dq + t * t / 2 * ddq, dq);
    for (std::size_t k = 0; k < 3; ++k) {
      CAPTURE(k);
      const double first = (ahead[k].h - behind[k].h) / (2 * t);
      const double second = (ahead[k].h - 2 * now[k].h + behind[k].h) / (t * t);
      REQUIRE(now[k].gradient.dot(dq) == Approx(first).margin(1e-6));
      REQUIRE(now[k].gradient.dot(ddq) + now[k].curvature == Approx(second).margin(1e-5));
    }
  }
}

TEST_CASE("Spheres and planes: h is positive where the point may be, and the distance next to the surface",
          "[barriers]") {
  rme::PointMotion<double, 7> point = flange_motion(panda().ready, Vector7::Zero());
  const Eigen::Vector3d center(1, 1, 1);
  const auto at = [&](double distance, rme::SphereSide side) {
    point.position = center + (0.5 + distance) * Eigen::Vector3d(2, -1, 2) / 3;
    return rme::sphere_barrier<double, 7>(point, center, 0.5, side).h;
  };
  CHECK(at(1e-4, rme::SphereSide::Outside) == Approx(1e-4).epsilon(1e-3));
  CHECK(at(-1e-4, rme::SphereSide::Outside) == Approx(-1e-4).epsilon(1e-3));
  CHECK(at(-1e-4, rme::SphereSide::Inside) == Approx(1e-4).epsilon(1e-3));
  point.position = {0.1, 0.2, 0.7};
  CHECK(rme::half_space_barrier<double, 7>(point, Eigen::Vector3d::UnitZ(), 0.4).h == Approx(0.3));
}

TEST_CASE("add_barrier: the bound is -k1 h - k2 grad_h dq - dq hess_h dq with gains from the poles", "[barriers]") {
  const rme::BarrierPoles<double> poles(2, 5);  // (s + 2)(s + 5) = s^2 + 7 s + 10
  CHECK(poles.k1 == 10);
  CHECK(poles.k2 == 7);
  rme::BarrierValue<double, 2> barrier{0.5, {1, -2}, 0.25};
  rme::ConstraintRows<double, 2, 4> rows;
  REQUIRE(rme::add_barrier(barrier, Eigen::Vector2d(0.1, 0.3), poles, rows) == rme::Status::Ok);
  CHECK(rows[0].lower == Approx(-10 * 0.5 - 7 * (0.1 - 0.6) - 0.25));
  CHECK(rows[0].upper == rows.kFree);
  CHECK(rows[0].a == Eigen::Vector2d(1, -2));
  barrier.h = std::numeric_limits<double>::quiet_NaN();
  CHECK(rme::add_barrier(barrier, Eigen::Vector2d(0.1, 0.3), poles, rows) == rme::Status::NonFiniteInput);
  CHECK(rows.size() == 1);
}

TEST_CASE("A barrier held with equality decays with its poles and never crosses", "[barriers]") {
  // h'' = -k1 h - k2 h' from h = 1, h' = -2 (the slow pole's own slope): h(t) = exp(-2 t) exactly.
  const rme::BarrierPoles<double> poles(2, 30);
  double h = 1, rate = -2;
  for (int k = 0; k < 20000; ++k) {
    rme::ConstraintRows<double, 1, 1> rows;
    using One = Eigen::Matrix<double, 1, 1>;
    REQUIRE(rme::add_barrier<double, 1, 1>({h, One(1.0), 0.0}, One(rate), poles, rows) == rme::Status::Ok);
    h += 1e-4 * rate + 0.5e-8 * rows[0].lower;
    rate += 1e-4 * rows[0].lower;
    REQUIRE(h > 0);
  }
  CHECK(h == Approx(std::exp(-4.0)).epsilon(1e-3));
}

TEST_CASE("JointLimits: the tighter of position and velocity bound counts, and position wins a contradiction",
          "[barriers]") {
  rme::JointLimitsConfig<double, 1> config;
  using One = Eigen::Matrix<double, 1, 1>;
  config.q_min << -1;
  config.q_max << 2;
  config.velocity_limit << 3;
  config.poles = {2, 5};
  config.velocity_pole = 10;
  const rme::JointLimits<double, 1> limits(config);
  const auto bounds = [&](double q, double dq) {
    rme::ConstraintRows<double, 1, 1> rows;
    REQUIRE(limits.append(One(q), One(dq), rows) == rme::Status::Ok);
    return Eigen::Vector2d(rows[0].lower, rows[0].upper);
  };
  // q = 0, dq = 1: position -10 * 1 - 7 = -17 and 10 * 2 - 7 = 13; velocity -10 * 4 = -40 and 10 * 2 = 20.
  CHECK((bounds(0, 1) - Eigen::Vector2d(-17, 13)).norm() < 1e-13);
  // dq = 2.9: position -10 - 20.3 and 20 - 20.3; velocity -59 and 1.
  CHECK((bounds(0, 2.9) - Eigen::Vector2d(-30.3, -0.3)).norm() < 1e-13);
  // q = 2.5, outside, dq = -4, too fast back: position -35 + 28 and -5 + 28; velocity 10 ... 70. Lower 10.
  CHECK((bounds(2.5, -4) - Eigen::Vector2d(10, 23)).norm() < 1e-13);
  // q = -3, far outside, dq = 3: position 20 - 21 = -1 and 50 - 21 = 29; velocity at most 0. No contradiction: 0.
  CHECK((bounds(-3, 3) - Eigen::Vector2d(-1, 0)).norm() < 1e-13);
  // q = -4, dq = 3: position at least 30 - 21 = 9, velocity at most 0: the position wins.
  CHECK((bounds(-4, 3) - Eigen::Vector2d(9, 9)).norm() < 1e-13);
}

/// h'' = row's bound + error, over a tick of which the error does what it likes within [0, 2 e]: the least h between.
struct SampledMotion {
  double h, rate, least;
  void tick(double bound, double period, std::mt19937& random, double error) {
    std::uniform_real_distribution<double> uniform;
    const int pieces = 40;
    const int kind = static_cast<int>(random() % 3);
    for (int i = 0; i < pieces; ++i) {
      const double share = kind == 0 ? 0 : kind == 1 ? uniform(random) : (i % 2 ? 2.0 : 0.0);
      const double u = bound + error * (share - 1), dt = period / pieces;
      if (rate < 0 && u > 0 && rate + u * dt > 0) least = std::min(least, h - rate * rate / (2 * u));
      h += rate * dt + u * dt * dt / 2;
      rate += u * dt;
      least = std::min(least, h);
    }
  }
};

TEST_CASE("Sampled barriers: a torque that is held for a tick never crosses, whatever the error within its bound",
          "[barriers]") {
  const unsigned seed = 4322;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform;
  int continuous_crossed = 0;
  for (int run = 0; run < 3000; ++run) {
    const double period = std::pow(10.0, -3 + 2 * uniform(random)), fast = 2 / period * uniform(random);
    const double slow = fast * uniform(random), error = run % 3 == 0 ? 0 : 10 * uniform(random);
    if (!(slow > 0)) continue;
    CAPTURE(run, period, fast, slow, error);
    const rme::BarrierPoles<double> poles(run % 2 ? fast : slow, run % 2 ? slow : fast);
    const rme::BarrierPoles<double> sampled = poles.sampled(period);
    const double h = uniform(random) < 0.1 ? 0 : uniform(random), rate = -fast * h * (run % 5 ? uniform(random) : 1);
    for (const bool held : {true, false}) {
      const auto& gains = held ? sampled : poles;
      SampledMotion motion{h, rate, h};
      for (int k = 0; k < 60; ++k) {
        rme::ConstraintRows<double, 1, 1> rows;
        using One = Eigen::Matrix<double, 1, 1>;
        const rme::AccelerationError<double, 1> off{One(error), One(0.0)};
        REQUIRE(rme::add_barrier<double, 1, 1>({motion.h, One(1.0), 0.0}, One(motion.rate), gains, rows, rows.kHard,
                                               off) == rme::Status::Ok);
        motion.tick(rows[0].lower, period, random, error);
        if (held) REQUIRE(motion.rate + fast * motion.h >= -1e-9 * (1 + error));
      }
      if (held) REQUIRE(motion.least >= -1e-12);
      continuous_crossed += !held && motion.least < -1e-6 ? 1 : 0;
    }
  }
  CHECK(continuous_crossed > 300);  // what the rows for continuous time make of the same ticks
}

TEST_CASE("Sampled barriers: with a short period the gains are those of continuous time", "[barriers]") {
  const rme::BarrierPoles<double> poles(8, 40), sampled = poles.sampled(1e-7);
  CHECK(sampled.k1 == Approx(320).epsilon(1e-5));
  CHECK(sampled.k2 == Approx(48).epsilon(1e-5));
  CHECK_THROWS_WITH(poles.sampled(0), contains("BarrierPoles::sampled"));
  CHECK_THROWS_WITH(poles.sampled(0.051), contains("2 over the faster pole"));
}

TEST_CASE("JointLimits: an error that leaves no acceleration sure to keep both limits is named", "[barriers]") {
  rme::JointLimitsConfig<double, 1> config;
  using One = Eigen::Matrix<double, 1, 1>;
  config.q_min << -1;
  config.q_max << 1;
  config.poles = {2, 5};
  config.period = 1e-7;
  const rme::JointLimits<double, 1> limits(config);
  // At rest in the middle: -10 + below to 10 - above, met in the middle at 9 and 13: -1 and -3, so -2.
  for (const auto& [below, above, lower, upper, status] :
       {std::make_tuple(4.0, 3.0, -6.0, 7.0, rme::Status::Ok),
        std::make_tuple(9.0, 13.0, -2.0, -2.0, rme::Status::Infeasible)}) {
    rme::ConstraintRows<double, 1, 1> rows;
    CHECK(limits.append(One(0.0), One(0.0), rows, {One(below), One(above)}) == status);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].lower == Approx(lower).epsilon(1e-5));
    CHECK(rows[0].upper == Approx(upper).epsilon(1e-5));
  }
  config.period = 0.5;
  CHECK_THROWS_WITH((rme::JointLimits<double, 1>(config)), contains("2 over the faster pole"));
}

TEST_CASE("JointLimits: an error, however large, may stop a joint for its velocity's sake, but not drive it",
          "[barriers]") {
  rme::JointLimitsConfig<double, 1> config;
  using One = Eigen::Matrix<double, 1, 1>;
  config.q_min << -1e4;
  config.q_max << 1e4;
  config.velocity_limit << 3;
  config.velocity_pole = 10;
  const rme::JointLimits<double, 1> limits(config);
  // At 1 rad/s without error -10 * 4 = -40 to 10 * 2 = 20; each gives way to its error, by 10 * 3 at most: to -10.
  for (const auto& [below, above, lower, upper] :
       {std::make_tuple(12.0, 5.0, -28.0, 15.0), std::make_tuple(31.0, 29.0, -10.0, -9.0),
        std::make_tuple(12.0, 1e3, -28.0, -10.0), std::make_tuple(1e3, 12.0, -10.0, 8.0),
        std::make_tuple(1e3, 700.0, -10.0, -10.0)}) {
    CAPTURE(below, above);
    rme::ConstraintRows<double, 1, 1> rows;
    CHECK(limits.append(One(0.0), One(1.0), rows, {One(below), One(above)}) == rme::Status::Ok);
    REQUIRE(rows.size() == 1);
    CHECK(rows[0].lower == Approx(lower));
    CHECK(rows[0].upper == Approx(upper));
  }
  // Where the prediction is right although an error was feared, |dq| never passes its limit: no row asks it to.
  const unsigned seed = 4331;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> uniform(-1, 1);
  config.period = 1e-3;
  const rme::JointLimits<double, 1> sampled(config);
  double dq = 0;
  for (int k = 0; k < 20000; ++k) {
    CAPTURE(k);
    const double scale = std::pow(10.0, 2 + 2 * uniform(random));
    const double below = scale * std::max(uniform(random), 0.0), above = scale * std::max(uniform(random), 0.0);
    rme::ConstraintRows<double, 1, 1> rows;
    REQUIRE(sampled.append(One(0.0), One(dq), rows, {One(below), One(above)}) == rme::Status::Ok);
    const double wish = 1e3 * uniform(random);
    dq += config.period * std::min(std::max(wish, rows[0].lower), rows[0].upper);
    REQUIRE(std::abs(dq) <= 3 * (1 + 1e-12));
  }
}

TEST_CASE("PredictionErrorWatch: bounds what it has seen, each sign for itself, and forgets", "[barriers]") {
  using Two = Eigen::Vector2d;
  rme::PredictionErrorConfig<double, 2> config;
  config.stated << 1, 0;
  config.memory = 0.01;
  rme::PredictionErrorWatch<double, 2> watch(1e-3, config);
  REQUIRE(watch.observe(Two(0, 0)) == rme::Status::Ok);
  CHECK(watch.error().above == Two(1, 0));
  watch.predict(Two(10, 10));
  REQUIRE(watch.observe(Two(0.013, 0.004)) == rme::Status::Ok);  // 13 and 4 rad/s^2: off by 3 and -6
  CHECK((watch.error().above - Two(4, 0)).norm() < 1e-9);
  CHECK((watch.error().below - Two(1, 6)).norm() < 1e-9);
  CHECK(watch.error().along(Two(2, -1)) == Approx(2 * 1 + 1 * 0));
  CHECK(watch.error().along(Two(-1, 1)) == Approx(4 + 6));
  for (int k = 0; k < 10; ++k) REQUIRE(watch.observe(Two(0, 0)) == rme::Status::Ok);  // nothing predicted: no news
  CHECK(watch.error().below[1] == Approx(6 * std::exp(-1)));
  CHECK(watch.observe(Two(0, std::nan(""))) == rme::Status::NonFiniteInput);
  CHECK(watch.error().below[1] == Approx(6 * std::exp(-1)));
  watch.predict(Two(0, 0));  // of a tick whose velocity was refused: there is none to compare the next one with
  REQUIRE(watch.observe(Two(0.02, 0)) == rme::Status::Ok);
  CHECK(watch.error().above[0] == Approx(1 + 3 * std::exp(-1.1)));
  config.memory = 0;
  CHECK_THROWS_WITH((rme::PredictionErrorWatch<double, 2>(1e-3, config)), contains("PredictionErrorConfig::memory"));
  config = {};
  config.stated << -1, 0;
  CHECK_THROWS_WITH((rme::PredictionErrorWatch<double, 2>(1e-3, config)), contains("PredictionErrorConfig::stated"));
}

TEST_CASE("Spheres: at the centre of a sphere to be left no acceleration keeps the barrier, and a status says so",
          "[barriers]") {
  rme::PointMotion<double, 7> point = flange_motion(panda().ready, Vector7::Zero());
  const auto inside = rme::sphere_barrier<double, 7>(point, point.position, 0.3, rme::SphereSide::Outside);
  rme::ConstraintRows<double, 7, 4> rows;
  CHECK(rme::add_barrier(inside, Vector7(Vector7::Zero()), {2.0, 5.0}, rows) == rme::Status::Infeasible);
  CHECK(rows.size() == 0);
  const auto kept = rme::sphere_barrier<double, 7>(point, point.position, 0.3, rme::SphereSide::Inside);
  CHECK(rme::add_barrier(kept, Vector7(Vector7::Zero()), {2.0, 5.0}, rows) == rme::Status::Ok);
}

TEST_CASE("Barriers: unstable poles and inverted limits are refused by name", "[barriers]") {
  CHECK_THROWS_WITH(rme::BarrierPoles<double>(0, 1), contains("BarrierPoles::first"));
  CHECK_THROWS_WITH(rme::BarrierPoles<double>(1, -2), contains("BarrierPoles::second"));
  CHECK_THROWS_WITH(rme::BarrierPoles<double>(std::numeric_limits<double>::quiet_NaN(), 1), contains("stable"));
  rme::JointLimitsConfig<double, 7> config;
  config.q_min = panda().q_max;
  config.q_max = panda().q_min;
  CHECK_THROWS_WITH((rme::JointLimits<double, 7>(config)), contains("JointLimitsConfig::q_min"));
  std::swap(config.q_min, config.q_max);
  config.velocity_limit[3] = 0;
  CHECK_THROWS_WITH((rme::JointLimits<double, 7>(config)), contains("velocity_limit"));
}

}  // namespace
