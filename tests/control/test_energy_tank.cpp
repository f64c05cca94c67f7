#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <rme/control/energy_tank.hpp>
#include <rme/core/compensation.hpp>
#include <stdexcept>
#include <synthetic_arm/panda.hpp>

#include "support/catch.hpp"

namespace {

using rme::EnergyTank;
using rme::EnergyTankConfig;
using rme::Status;
template <typename Scalar>
using One = rme::JointVector<Scalar, 1>;  // of a single joint

/// One tick of an arm with a single joint.
template <typename Scalar>
Status update(EnergyTank<Scalar, 1>& tank, double q, double torque, double potential = 0) {
  return tank.update(One<Scalar>(static_cast<Scalar>(q)), One<Scalar>(static_cast<Scalar>(torque)),
                     static_cast<Scalar>(potential));
}

TEMPLATE_TEST_CASE("EnergyTank: no sequence of torques and motions gets more out than was in it and was put in",
                   "[energy_tank]", float, double) {
  using Scalar = TestType;
  const unsigned seed = 160;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const double rounding = 1e3 * static_cast<double>(std::numeric_limits<Scalar>::epsilon());
  for (int run = 0; run < 50; ++run) {
    CAPTURE(run);
    EnergyTank<Scalar, 2> tank(Scalar(1e-3), EnergyTankConfig{10, 5, 2});
    rme::JointVector<Scalar, 2> q(1, -1);
    double drawn = 0, most = 0;  // net of what came back
    for (int tick = 0; tick < 5000; ++tick) {
      const rme::JointVector<Scalar, 2> before = q,
                                        torque = Scalar(std::pow(10.0, normal(random))) *
                                                 rme::JointVector<Scalar, 2>(normal(random) + 0.5, normal(random));
      REQUIRE(tank.update(q, torque) == Status::Ok);
      REQUIRE(tank.share() >= 0);
      REQUIRE(tank.share() <= 1);
      REQUIRE(tank.torque() == tank.share() * torque);
      REQUIRE(static_cast<double>(tank.energy()) >= -rounding);
      REQUIRE(static_cast<double>(tank.energy()) <= 10 + rounding);
      // The arm goes anywhere, though not so fast that more than the reserve is drawn in a tick.
      rme::JointVector<Scalar, 2> way{normal(random), normal(random)};
      if (tick % 3 != 0 && torque.dot(way) < 0) way = -way;
      q += Scalar(std::min(0.1, 1.9 / static_cast<double>(way.norm() * torque.norm()))) * way;
      // From any time on: at most what was in the tank then. Forgetting what overflows makes `drawn` the loss since
      // the tank was last full.
      drawn = std::max(drawn + static_cast<double>(tank.torque().dot(q - before)), -5.0);
      most = std::max(most, drawn);
    }
    CHECK(most <= 5 + rounding);
    CHECK(most > 4.9);  // it is used
  }
}

TEST_CASE("EnergyTank: what comes back beyond its capacity is lost, and so is a refill", "[energy_tank]") {
  EnergyTank<double, 1> tank(0.5, EnergyTankConfig{10, 5, 2, 1});
  REQUIRE(update(tank, 0, -4) == Status::Ok);
  CHECK(tank.energy() == Approx(5.5));
  REQUIRE(update(tank, 1, -4) == Status::Ok);
  CHECK(tank.energy() == Approx(10));
  REQUIRE(update(tank, 4, -4) == Status::Ok);
  CHECK(tank.energy() == Approx(10));
  REQUIRE(update(tank, 5, 3, -7) == Status::Ok);  // an object appears 7 J up: there is nothing that it could owe yet
  CHECK(tank.energy() == Approx(10));
  REQUIRE(update(tank, 5, 0, 0) == Status::Ok);  // where it vanishes again, it has taken 7 J
  CHECK(tank.energy() == Approx(3.5));
}

TEST_CASE("EnergyTank: without a potential, what lifts and lowers a payload is back where it was", "[energy_tank]") {
  EnergyTank<double, 1> tank(1e-3);
  for (int tick = 0; tick <= 2000; ++tick) {  // 1.1 kg, 0.3 m up and down again, on a joint that slides
    REQUIRE(update(tank, 0.15 - 0.15 * std::cos(M_PI * tick / 1000), 1.1 * 9.81) == Status::Ok);
    CHECK(tank.share() == 1);
    CHECK(tank.torque()[0] == 1.1 * 9.81);
  }
  CHECK(tank.energy() == Approx(12).margin(1e-12));
}

TEMPLATE_TEST_CASE("EnergyTank: lifting 2 kg by 0.8 m ten times costs nothing while the estimate is constant",
                   "[energy_tank]", float, double) {
  using Scalar = TestType;
  const double dt = 1e-3, weight = 2 * 9.81;
  EnergyTank<Scalar, 1> tank{Scalar(dt)};
  double least = 1;
  for (int tick = 0; tick <= 20000; ++tick) {  // z = -0.4 cos(pi t), picked up below: U = -m g z
    const double z = -0.4 * std::cos(M_PI * dt * tick);
    REQUIRE(update(tank, z, weight, -weight * z) == Status::Ok);
    least = std::min(least, static_cast<double>(tank.share()));
    // Picking it up 0.4 m below the zero of U has cost 2 * 9.81 * 0.4 J of the 12, and holding the torque nothing:
    // along a slide it is the same everywhere.
    REQUIRE(std::abs(static_cast<double>(tank.energy()) - (12 - weight * 0.4)) <
            100 * static_cast<double>(std::numeric_limits<Scalar>::epsilon()));
  }
  CHECK(least == 1);
}

TEMPLATE_TEST_CASE("EnergyTank: estimates that change while the arm moves put in no more than is stated",
                   "[energy_tank]", float, double) {
  // The worst that an estimator can do: all of 3 kg on the way up, nothing on the way down; and, at random, anything.
  using Scalar = TestType;
  const unsigned seed = 161;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  const double dt = 1e-3, rounding = 1e3 * static_cast<double>(std::numeric_limits<Scalar>::epsilon());
  for (int run = 0; run < 40; ++run) {
    CAPTURE(run);
    const double refill = run % 4 == 3 ? 0.5 : 0;
    EnergyTankConfig config;
    config.refill = refill;
    EnergyTank<Scalar, 1> tank(Scalar(dt), config);
    const double from = 0.8 * uniform(random) - 0.4, reach = 0.1 + 0.4 * uniform(random),
                 rate = 1 + 4 * uniform(random);
    const auto height = [&](int tick) { return from + reach * std::sin(rate * dt * tick); };
    double mass = 0, put_in = 0, largest = 0, most = 0, unscaled = 0;
    for (int tick = 0; tick < 20000; ++tick) {
      const double z = height(tick), next = height(tick + 1);
      if (run % 2 == 0) mass = next > z ? 3 : 0;
      if (run % 2 == 1 && uniform(random) < 0.01) mass = 3 * uniform(random);
      const double potential = -9.81 * mass * z;
      REQUIRE(update(tank, z, 9.81 * mass, potential) == Status::Ok);
      put_in += static_cast<double>(tank.torque()[0]) * (next - z);
      unscaled += 9.81 * mass * (next - z);
      largest = std::max(largest, std::abs(potential));
      most = std::max(most, put_in - refill * dt * (tick + 1));
      REQUIRE(tank.share() >= 0);
      REQUIRE(tank.share() <= 1);
      REQUIRE(static_cast<double>(tank.energy()) >= -largest - rounding);
    }
    CAPTURE(unscaled, most, largest);
    CHECK(most <= 12 + largest + rounding);
    if (run % 2 == 0) {
      CHECK(unscaled > 2 * (12 + largest));  // what it was kept from
      CHECK(most > 11);                      // it is used
    }
  }
}

/// A link that turns about a horizontal axis through (0, 0), with 2 kg at its end, 0.5 m away. A drive takes it to and
/// fro above the axis, and 2 kg are compensated for, by a torque that is read every 4 ms and held in between.
struct SwingingLink {
  static constexpr double kPeriod = 4e-3, kTurns = 6.28 /* rad/s */, kInertia = 2 * 0.5 * 0.5;
  static constexpr double kMoment = 2 * 9.81 * 0.5;  // of the weight [N m]
  double q = M_PI / 2, dq = 0;                       // from the horizontal, upwards [rad]
  double work = 0;                                   // that the compensation has done [J]

  static double torque(double angle) { return kMoment * std::cos(angle); }
  static double potential(double angle) { return -kMoment * std::sin(angle); }

  /// A tick from `t` on, by the fourth-order method of Runge and Kutta. The work is integrated with the motion: power
  /// by power, knowing nothing of displacements.
  void step(double t, double held) {
    constexpr int kSteps = 8;
    const double h = kPeriod / kSteps;
    using State = std::array<double, 3>;  // q, dq, work
    const auto rate = [&](double at, const State& s) {
      const double phase = kTurns * at;
      const double drive = 400 * (M_PI / 2 + std::sin(phase) - s[0]) + 20 * (kTurns * std::cos(phase) - s[1]);
      return State{s[1], (drive + held - torque(s[0])) / kInertia, held * s[1]};
    };
    const auto along = [](const State& s, double by, const State& d) {
      return State{s[0] + by * d[0], s[1] + by * d[1], s[2] + by * d[2]};
    };
    State s = {q, dq, work};
    for (int i = 0; i < kSteps; ++i) {
      const double at = t + i * h;
      const State a = rate(at, s), b = rate(at + h / 2, along(s, h / 2, a)), c = rate(at + h / 2, along(s, h / 2, b)),
                  d = rate(at + h, along(s, h, c));
      s = along(along(along(along(s, h / 6, a), h / 3, b), h / 3, c), h / 6, d);
    }
    q = s[0];
    dq = s[1];
    work = s[2];
  }
};

TEST_CASE(
    "EnergyTank: what a torque puts in by being held over ticks is within the bound, which counting at ticks breaks",
    "[energy_tank]") {
  // Above the axis the torque falls as the link rises, whichever way: held, it is too large on the way up and too small
  // on the way down. That puts in T/2 dq^2 m g l sin q (C18), 0.37 W here. The estimate is constant, and right.
  const double bound = 12 + SwingingLink::kMoment;
  const int ticks = 100000;
  SwingingLink free;
  double at_ticks = 0;  // what it seems to have put in and U not to have lost, by its power at the ticks
  for (int k = 0; k < ticks; ++k) {
    const double held = SwingingLink::torque(free.q);
    const double power = held * free.dq, lost = SwingingLink::potential(free.q);
    free.step(SwingingLink::kPeriod * k, held);
    at_ticks += SwingingLink::kPeriod * power + SwingingLink::potential(free.q) - lost;
  }
  CHECK(at_ticks < 1);           // a tank that pays for this lets all of it through for ever,
  CHECK(free.work > 3 * bound);  // against its bound
  EnergyTank<double, 1> tank(SwingingLink::kPeriod);
  SwingingLink link;
  double most = 0;
  for (int k = 0; k < ticks; ++k) {
    REQUIRE(update(tank, link.q, SwingingLink::torque(link.q), SwingingLink::potential(link.q)) == Status::Ok);
    if (k == 1000) CHECK(tank.share() == 1);  // 4 s on, hardly anything is used
    link.step(SwingingLink::kPeriod * k, tank.torque()[0]);
    most = std::max(most, link.work);
  }
  CHECK(most <= bound);
  CHECK(most > 11);  // it is used
  CHECK(tank.share() < 0.01);
}

TEST_CASE("EnergyTank: the energy that leaves it is what a held torque puts in, tick by tick", "[energy_tank]") {
  // The estimate changes all the time, between nothing and all of it.
  EnergyTankConfig config;
  config.capacity = 1000;  // never reached
  config.initial = 500;
  EnergyTank<double, 1> tank(SwingingLink::kPeriod, config);
  SwingingLink link;
  for (int k = 0; k < 20000; ++k) {
    const double believed = 0.5 + 0.5 * std::sin(0.7 + SwingingLink::kTurns * SwingingLink::kPeriod * k);
    const double potential = believed * SwingingLink::potential(link.q);
    REQUIRE(update(tank, link.q, believed * SwingingLink::torque(link.q), potential) == Status::Ok);
    REQUIRE(tank.energy() == Approx(500 - link.work - tank.share() * potential).margin(1e-4));
    link.step(SwingingLink::kPeriod * k, tank.torque()[0]);
  }
  CHECK(link.work > 15);
}

TEST_CASE("EnergyTank: the potential of an estimate is what its torque gives back", "[energy_tank]") {
  // By differences along a random path of a Panda: dq^T tau_comp = -dU/dt for a constant estimate.
  const unsigned seed = 162;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  const auto& model = rme::examples::panda();
  const rme::Payload<double> payload{1.3, {0.02, -0.03, 0.08}};
  for (int i = 0; i < 50; ++i) {
    rme::JointVector<double, 7> q, dq;
    for (int j = 0; j < 7; ++j) {
      q[j] = model.ready[j] + 0.3 * normal(random);
      dq[j] = normal(random);
    }
    const auto at = [&](double t) {
      const auto k = model.kinematics(q + t * dq);
      return rme::compensation_potential<double>(payload, k.position, k.rotation);
    };
    const auto now = model.kinematics(q);
    const double power = dq.dot(rme::compensation_torque<double>(payload, now.jacobian, now.rotation));
    REQUIRE(power == Approx(-(at(1e-5) - at(-1e-5)) / 2e-5).margin(1e-6));
  }
}

TEST_CASE("EnergyTank: below the reserve the share fades without a step, and recovers", "[energy_tank]") {
  EnergyTank<double, 1> tank(1e-3, EnergyTankConfig{5, 3, 2});
  double last = 1, q = 0;
  for (int tick = 0; tick < 4000; ++tick, q += 1e-3) {
    REQUIRE(update(tank, q, 10) == Status::Ok);                           // for ever, as if the payload fed a motion
    CHECK(std::abs(tank.share() - last) <= 10 * 1e-3 / 2 * (1 + 1e-12));  // but for rounding
    last = tank.share();
  }
  // 1 J down to the reserve in 0.1 s, then dE/dt = -10 E / 2: e^-5 per second.
  CHECK(last == Approx(std::exp(-5 * 3.9)).epsilon(0.1));
  // With so small a share, what comes back is little at first: e^5 per second.
  for (int tick = 0; tick < 4000; ++tick, q += 1e-3) REQUIRE(update(tank, q, -10) == Status::Ok);
  CHECK(tank.share() == 1);
}

TEST_CASE("EnergyTank: an arm at rest gets the same torque in each tick, however little is left", "[energy_tank]") {
  // The share changes what U asks for, and with it the level that the share hangs on: a loop that must not swing.
  for (const double potential : {-40.0, -8.0, -2.0, -1.0, 1.0, 8.0, 40.0}) {
    CAPTURE(potential);
    EnergyTank<double, 1> tank(1e-3, EnergyTankConfig{12, 0.5, 2});
    REQUIRE(update(tank, 0.3, 20, potential) == Status::Ok);
    const double share = tank.share();
    // Above its zero U gives more than the reserve back, and only so much is lent.
    CHECK(share == Approx(potential > 0 ? 0.5 / (2 + potential) : std::min(1.0, (0.5 - potential) / 2)));
    for (int tick = 0; tick < 100; ++tick) {
      REQUIRE(update(tank, 0.3, 20, potential) == Status::Ok);
      REQUIRE(tank.share() == share);
      REQUIRE(tank.torque()[0] == 20 * share);
    }
  }
}

TEST_CASE("EnergyTank: the share is continuous in the potential", "[energy_tank]") {
  // An estimate that grows by 0.01 J a tick, from much above to much below its zero, of an arm at rest.
  for (const double initial : {0.0, 1.0, 6.0}) {
    CAPTURE(initial);
    EnergyTank<double, 1> tank(1e-3, EnergyTankConfig{50, initial, 2});
    double last = 1;
    for (int k = -1000; k <= 4000; ++k) {
      REQUIRE(update(tank, 0, 1, 0.01 * k) == Status::Ok);
      REQUIRE(std::abs(tank.share() - last) <= 0.01 / 2 * (1 + 1e-9));
      last = tank.share();
    }
    CHECK(last == Approx(initial / 42));
  }
}

TEMPLATE_TEST_CASE("EnergyTank: a tank that five hours at 1 kHz have emptied has put in its bound, no more",
                   "[energy_tank]", float, double) {
  // 1.5 mW on average, in terms that a plain sum in float would lose.
  EnergyTank<TestType, 1> tank(TestType(1e-3));
  double put_in = 0;
  for (long k = 0; k < 5 * 3600 * 1000; ++k) {
    const bool back = k % 2 == 0;
    const TestType q = back ? TestType(1) : TestType(1.0009765625);  // 1 + 2^-10: forward with more torque than back
    if (tank.update(One<TestType>(q), One<TestType>(TestType(back ? 5.003 : 5)), TestType(0)) != Status::Ok) FAIL(k);
    put_in += static_cast<double>(tank.torque()[0]) * (back ? 1.0 : -1.0) / 1024;
  }
  CHECK(put_in <= 12 + 1e-2);
  CHECK(put_in > 11.9);
  CHECK(tank.share() < 0.01);
}

TEST_CASE("EnergyTank: a torque that is held on through ticks with bad input is paid for by the next good one",
          "[energy_tank]") {
  EnergyTank<double, 1> tank(1e-3);
  REQUIRE(update(tank, 0.5, 4) == Status::Ok);
  CHECK(tank.energy() == 12);
  for (int lost = 0; lost < 5; ++lost) {
    CHECK(update(tank, std::nan(""), 7) == Status::NonFiniteInput);
    CHECK(tank.torque()[0] == 4);
  }
  REQUIRE(update(tank, 0.7, 100) == Status::Ok);
  CHECK(tank.energy() == Approx(12 - 4 * 0.2));
}

TEST_CASE("EnergyTank: after reset() nothing is paid for until a torque is commanded again", "[energy_tank]") {
  EnergyTank<double, 1> tank(1e-3);
  REQUIRE(update(tank, 0, 4) == Status::Ok);
  REQUIRE(update(tank, 1, 4) == Status::Ok);
  CHECK(tank.energy() == Approx(8));
  tank.reset();
  CHECK(tank.torque()[0] == 0);
  CHECK(tank.energy() == Approx(8));  // nor does it fill
  REQUIRE(update(tank, 3, 4) == Status::Ok);
  CHECK(tank.energy() == Approx(8));
  REQUIRE(update(tank, 4, 4) == Status::Ok);
  CHECK(tank.energy() == Approx(4));
}

TEST_CASE("EnergyTank: bad input is named and costs nothing", "[energy_tank]") {
  EnergyTank<double, 1> tank(1e-3, EnergyTankConfig{12, 10, 2, 1});
  REQUIRE(update(tank, 0, 5) == Status::Ok);
  REQUIRE(update(tank, 0.1, 5) == Status::Ok);
  CHECK(tank.energy() == Approx(10 + 2e-3 - 0.5));
  const double energy = tank.energy(), share = tank.share(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), inf, -inf, 2 * rme::kLargestPlausible}) {
    CHECK(update(tank, bad, 5) == Status::NonFiniteInput);
    CHECK(update(tank, 0, bad) == Status::NonFiniteInput);
    CHECK(update(tank, 0, 5, bad) == Status::NonFiniteInput);
    CHECK(tank.energy() == energy);
    CHECK(tank.share() == share);
    CHECK(tank.torque()[0] == 5);
  }
  const auto with = [](double capacity, double initial, double reserve) {
    EnergyTank<double, 1>(1e-3, EnergyTankConfig{capacity, initial, reserve});
  };
  CHECK_THROWS_WITH((EnergyTank<double, 1>(0)), contains("EnergyTank::period"));
  CHECK_THROWS_WITH(with(0, 0, 1), contains("EnergyTankConfig::capacity"));
  CHECK_THROWS_WITH(with(5, 6, 1), contains("EnergyTankConfig::initial"));
  CHECK_THROWS_WITH(with(5, std::nan(""), 1), contains("EnergyTankConfig::initial"));
  CHECK_THROWS_WITH(with(5, 5, 0), contains("EnergyTankConfig::reserve"));
  CHECK_THROWS_WITH(with(5, 5, 6), contains("EnergyTankConfig::reserve"));
  CHECK_NOTHROW(with(5, 5, 5));
  CHECK_THROWS_WITH((EnergyTank<float, 1>(1e-3F, EnergyTankConfig{5, 5, 1e-60})),
                    contains("EnergyTankConfig::reserve"));
  EnergyTankConfig leaking;
  leaking.refill = -1;
  CHECK_THROWS_WITH((EnergyTank<double, 1>(1e-3, leaking)), contains("EnergyTankConfig::refill"));
}

static_assert(noexcept(std::declval<EnergyTank<double, 1>&>().update(std::declval<One<double>&>(),
                                                                     std::declval<One<double>&>())));

}  // namespace
