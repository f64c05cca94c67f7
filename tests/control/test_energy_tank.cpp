#include <cmath>
#include <limits>
#include <random>
#include <rme/control/energy_tank.hpp>
#include <stdexcept>

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

TEST_CASE("EnergyTank: below the reserve the share fades without a step, and recovers", "[energy_tank]") {
  EnergyTank<double> tank(1e-3, EnergyTankConfig{5, 3, 2});
  double last = 1;
  for (int tick = 0; tick < 4000; ++tick) {
    REQUIRE(tank.update(10) == Status::Ok);  // for ever, as if the payload fed a motion
    CHECK(std::abs(tank.share() - last) <= 10 * 1e-3 / 2);
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
}

static_assert(noexcept(std::declval<EnergyTank<double>&>().update(1.0)));

}  // namespace
