#include <cmath>
#include <limits>
#include <random>
#include <rme/control/compensation.hpp>
#include <rme/control/energy_tank.hpp>
#include <stdexcept>
#include <synthetic_arm/panda.hpp>

#include "support/catch.hpp"

namespace {

using rme::EnergyTank;
using rme::EnergyTankConfig;
using rme::Status;

TEMPLATE_TEST_CASE("EnergyTank: no sequence of powers gets more out than was in it and was put in", "[energy_tank]",
                   float, double) {
  using Scalar = TestType;
  const unsigned seed = 160;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  for (int run = 0; run < 50; ++run) {
    CAPTURE(run);
    EnergyTank<Scalar> tank(Scalar(1e-3), EnergyTankConfig{10, 5, 2});
    double drawn = 0, most = 0;  // net of what came back
    for (int tick = 0; tick < 5000; ++tick) {
      const auto power = static_cast<Scalar>(std::pow(10.0, 4 * normal(random)) * (normal(random) + 0.3));
      REQUIRE(tank.update(power) == Status::Ok);
      REQUIRE(tank.share() >= 0);
      REQUIRE(tank.share() <= 1);
      REQUIRE(tank.energy() >= 0);
      REQUIRE(tank.energy() <= 10);
      // From any time on: at most what was in the tank then. Forgetting what overflows makes `drawn` the loss since
      // the tank was last full.
      drawn = std::max(drawn + static_cast<double>(tank.share() * power) * 1e-3, -5.0);
      most = std::max(most, drawn);
    }
    CHECK(most <= 5 + 1e-3);
    CHECK(most > 4.9);  // it is used
  }
}

TEST_CASE("EnergyTank: what lifts and lowers a payload is back where it was, and was never scaled", "[energy_tank]") {
  EnergyTank<double> tank(1e-3);
  for (int tick = 0; tick < 2000; ++tick) {  // 1.1 kg, 0.3 m up and down again
    REQUIRE(tank.update(1.1 * 9.81 * 0.15 * M_PI * std::sin(M_PI * (tick + 0.5) / 1000)) == Status::Ok);
    CHECK(tank.share() == 1);
  }
  CHECK(tank.energy() == Approx(12).margin(1e-9));
}

TEMPLATE_TEST_CASE("EnergyTank: lifting 2 kg by 0.8 m ten times costs nothing while the estimate is constant",
                   "[energy_tank]", float, double) {
  using Scalar = TestType;
  const double dt = 1e-3, weight = 2 * 9.81;
  EnergyTank<Scalar> tank{Scalar(dt)};
  REQUIRE(tank.update(0, 0) == Status::Ok);
  double least = 1;
  for (int tick = 0; tick <= 20000; ++tick) {  // z = -0.4 cos(pi t), picked up below: U = -m g z
    const double t = dt * tick, z = -0.4 * std::cos(M_PI * t), speed = 0.4 * M_PI * std::sin(M_PI * t);
    REQUIRE(tank.update(static_cast<Scalar>(weight * speed), static_cast<Scalar>(-weight * z)) == Status::Ok);
    least = std::min(least, static_cast<double>(tank.share()));
  }
  CHECK(least == 1);
  // Picking it up 0.4 m below the zero of U has cost 2 * 9.81 * 0.4 J of the 12; the rectangles of the sum, a part in
  // 1000.
  CHECK(static_cast<double>(tank.energy()) == Approx(12 - weight * 0.4).margin(0.02));
}

TEMPLATE_TEST_CASE("EnergyTank: estimates that change while the arm moves put in no more than is stated",
                   "[energy_tank]", float, double) {
  // The worst that an estimator can do: all of 3 kg on the way up, nothing on the way down; and, at random, anything.
  using Scalar = TestType;
  const unsigned seed = 161;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> uniform;
  const double dt = 1e-3;
  for (int run = 0; run < 40; ++run) {
    CAPTURE(run);
    const double refill = run % 4 == 3 ? 0.5 : 0;
    EnergyTankConfig config;
    config.refill = refill;
    EnergyTank<Scalar> tank(Scalar(dt), config);
    const double from = 0.8 * uniform(random) - 0.4, reach = 0.1 + 0.4 * uniform(random),
                 rate = 1 + 4 * uniform(random);
    double mass = 0, put_in = 0, largest = 0, most = 0, tick_power = 0, unscaled = 0;
    for (int tick = 0; tick < 20000; ++tick) {
      const double t = dt * tick, z = from + reach * std::sin(rate * t), speed = reach * rate * std::cos(rate * t);
      if (run % 2 == 0) mass = speed > 0 ? 3 : 0;
      if (run % 2 == 1 && uniform(random) < 0.01) mass = 3 * uniform(random);
      const double power = 9.81 * mass * speed, potential = -9.81 * mass * z;
      REQUIRE(tank.update(static_cast<Scalar>(power), static_cast<Scalar>(potential)) == Status::Ok);
      put_in += static_cast<double>(tank.share()) * power * dt;
      unscaled += power * dt;
      largest = std::max(largest, std::abs(potential));
      tick_power = std::max(tick_power, std::abs(power) * dt);
      most = std::max(most, put_in - refill * t);
      REQUIRE(tank.share() >= 0);
      REQUIRE(tank.share() <= 1);
      REQUIRE(static_cast<double>(tank.energy()) >= -largest - tick_power);
    }
    CAPTURE(unscaled, most, largest);
    CHECK(most <= 12 + largest + tick_power);
    if (run % 2 == 0) CHECK(unscaled > 2 * (12 + largest));  // what it was kept from
  }
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
    const double power = dq.dot(rme::compensation_torque<double, 7>(payload, now.jacobian, now.rotation));
    REQUIRE(power == Approx(-(at(1e-5) - at(-1e-5)) / 2e-5).margin(1e-6));
  }
}

TEST_CASE("EnergyTank: below the reserve the share fades without a step, and recovers", "[energy_tank]") {
  EnergyTank<double> tank(1e-3, EnergyTankConfig{5, 3, 2});
  double last = 1;
  for (int tick = 0; tick < 4000; ++tick) {
    REQUIRE(tank.update(10) == Status::Ok);                               // for ever, as if the payload fed a motion
    CHECK(std::abs(tank.share() - last) <= 10 * 1e-3 / 2 * (1 + 1e-12));  // but for rounding
    last = tank.share();
  }
  // 1 J down to the reserve in 0.1 s, then dE/dt = -10 E / 2: e^-5 per second.
  CHECK(last == Approx(std::exp(-5 * 3.9)).epsilon(0.1));
  for (int tick = 0; tick < 20000; ++tick) REQUIRE(tank.update(-10) == Status::Ok);
  CHECK(tank.share() == 1);
}

TEST_CASE("EnergyTank: bad input is named and costs nothing", "[energy_tank]") {
  EnergyTank<double> tank(1e-3);
  REQUIRE(tank.update(5) == Status::Ok);
  const double energy = tank.energy(), share = tank.share(), inf = std::numeric_limits<double>::infinity();
  for (const double bad : {std::nan(""), inf, -inf}) {
    CHECK(tank.update(bad) == Status::NonFiniteInput);
    CHECK(tank.energy() == energy);
    CHECK(tank.share() == share);
    CHECK(tank.update(0, bad) == Status::NonFiniteInput);
    CHECK(tank.energy() == energy);
  }
  const auto with = [](double capacity, double initial, double reserve) {
    EnergyTank<double>(1e-3, EnergyTankConfig{capacity, initial, reserve});
  };
  CHECK_THROWS_WITH(EnergyTank<double>(0), contains("EnergyTank::period"));
  CHECK_THROWS_WITH(with(0, 0, 1), contains("EnergyTankConfig::capacity"));
  CHECK_THROWS_WITH(with(5, 6, 1), contains("EnergyTankConfig::initial"));
  CHECK_THROWS_WITH(with(5, std::nan(""), 1), contains("EnergyTankConfig::initial"));
  CHECK_THROWS_WITH(with(5, 5, 0), contains("EnergyTankConfig::reserve"));
  CHECK_THROWS_WITH(with(5, 5, 6), contains("EnergyTankConfig::reserve"));
  EnergyTankConfig leaking;
  leaking.refill = -1;
  CHECK_THROWS_WITH(EnergyTank<double>(1e-3, leaking), contains("EnergyTankConfig::refill"));
}

static_assert(noexcept(std::declval<EnergyTank<double>&>().update(1.0)));

}  // namespace
