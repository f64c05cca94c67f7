#include <cmath>
#include <rme/control/passivity_monitor.hpp>

#include "support/catch.hpp"

namespace {

TEST_CASE("PassivityMonitor: a damped oscillator's residual is minus what the damper took", "[passivity]") {
  // x'' = -x - 0.4 x' from x = 1: x = exp(-0.2 t) (cos w t + 0.2 / w sin w t), w^2 = 0.96, x' = -exp(-0.2 t) sin(w t) /
  // w. S = (x^2 + x'^2) / 2, nothing supplied: the residual is S - 1/2.
  const double w = std::sqrt(0.96);
  rme::PassivityMonitor<double> monitor(0.01);
  double previous = 0;
  for (int k = 0; k <= 1000; ++k) {
    const double t = 0.01 * k, decay = std::exp(-0.2 * t);
    const double x = decay * (std::cos(w * t) + 0.2 / w * std::sin(w * t)), v = -decay * std::sin(w * t) / w;
    REQUIRE(monitor.update((x * x + v * v) / 2, 0) == rme::Status::Ok);
    REQUIRE(monitor.residual() == Approx((x * x + v * v) / 2 - 0.5).margin(1e-15));
    REQUIRE(monitor.residual() <= previous);
    REQUIRE(monitor.power_residual() <= 0);
    previous = monitor.residual();
  }
}

TEST_CASE("PassivityMonitor: supplied power is integrated, with an error that vanishes with the step's square",
          "[passivity]") {
  // A lossless system driven by P(t) = sin t from S = 3: S = 4 - cos t. The residual is the trapezoidal error.
  double errors[2] = {};
  for (const int halved : {0, 1}) {
    const double dt = halved ? 0.005 : 0.01;
    rme::PassivityMonitor<double> monitor(dt);
    for (int k = 0; k * dt < 2 + dt / 2; ++k)
      REQUIRE(monitor.update(4 - std::cos(k * dt), std::sin(k * dt)) == rme::Status::Ok);
    CHECK(monitor.supplied() == Approx(1 - std::cos(2.0)).epsilon(1e-4));
    errors[halved] = std::abs(monitor.residual());
  }
  CHECK(errors[0] < 1e-4);
  CHECK(errors[1] == Approx(errors[0] / 4).epsilon(0.01));
}

TEST_CASE("PassivityMonitor: the work of a force that is held leaves no residual, its power one of the step",
          "[passivity]") {
  // One kilogram on a spring of 1 N/m that is read once a step: the force is held, so that each step is a parabola.
  // Stored is the kinetic energy, supplied what the force does. Entered as power at the ticks, the force counts as one
  // that follows the motion, and what holding it puts in is missing.
  double by_work[2] = {}, by_power[2] = {}, stored[2] = {};
  for (const int halved : {0, 1}) {
    const double dt = halved ? 0.005 : 0.01;
    rme::PassivityMonitor<double> works(dt), powers(dt);
    double x = 1, v = 0, work = 5;  // before the first tick there is nothing that it could have done
    for (int k = 0; k * dt < 20 + dt / 2; ++k) {
      REQUIRE(works.update_with_work(v * v / 2, work) == rme::Status::Ok);
      REQUIRE(powers.update(v * v / 2, -x * v) == rme::Status::Ok);
      by_work[halved] = std::max(by_work[halved], std::abs(works.residual()));
      by_power[halved] = std::abs(powers.residual());
      const double force = -x, step = dt * v + dt * dt / 2 * force;
      work = force * step;
      x += step;
      v += dt * force;
      REQUIRE(std::abs(works.power_residual()) < 1e-11);
    }
    stored[halved] = works.storage();
    CHECK(works.supplied() == Approx(works.storage()).epsilon(1e-12));
  }
  CHECK(stored[0] > 0.3);
  CHECK(by_work[0] < 1e-14);
  CHECK(by_work[1] < 1e-14);
  CHECK(by_power[0] > 0.01);
  CHECK(by_power[1] == Approx(by_power[0] / 2).epsilon(0.1));
}

TEST_CASE("PassivityMonitor: work and power may take turns", "[passivity]") {
  // P = 1 W and S = t throughout: whichever way a tick is entered, nothing is missing.
  rme::PassivityMonitor<double> monitor(0.1);
  for (int k = 0; k <= 100; ++k) {
    const rme::Status status = k / 3 % 2 == 0 ? monitor.update(0.1 * k, 1) : monitor.update_with_work(0.1 * k, 0.1);
    REQUIRE(status == rme::Status::Ok);
    REQUIRE(std::abs(monitor.residual()) < 1e-13);
  }
  CHECK(monitor.supplied() == Approx(10));
}

TEST_CASE("PassivityMonitor: the residual of an active system rises", "[passivity]") {
  rme::PassivityMonitor<double> monitor(1e-3);
  for (int k = 0; k <= 1000; ++k) REQUIRE(monitor.update(1 + 0.5e-3 * k, 0.2) == rme::Status::Ok);
  CHECK(monitor.residual() == Approx(0.3));  // half a watt stored, 0.2 W supplied, for a second
  CHECK(monitor.power_residual() == Approx(0.3));
}

TEMPLATE_TEST_CASE("PassivityMonitor: five hours at 1 kHz leave a thousandth of what was turned over at most",
                   "[passivity]", float, double) {
  // A lossless store that takes all of 1 W: S = t, so that the residual is all error. (A plain sum in float: -801 J.)
  rme::PassivityMonitor<TestType> monitor(TestType(1e-3));
  const long ticks = 5 * 3600 * 1000;
  for (long k = 0; k <= ticks; ++k)
    if (monitor.update(static_cast<TestType>(1e-3 * static_cast<double>(k)), 1) != rme::Status::Ok) FAIL(k);
  CHECK(monitor.supplied() == Approx(18000).epsilon(1e-6));
  CHECK(std::abs(monitor.residual()) < 18);
}

TEST_CASE("PassivityMonitor: bad numbers do not enter the books, and reset() opens new ones", "[passivity]") {
  rme::PassivityMonitor<double> monitor(1e-3);
  REQUIRE(monitor.update(1, 2) == rme::Status::Ok);
  REQUIRE(monitor.update(1.5, 2) == rme::Status::Ok);
  const double residual = monitor.residual();
  CHECK(monitor.update(std::numeric_limits<double>::quiet_NaN(), 0) == rme::Status::NonFiniteInput);
  CHECK(monitor.update(0, std::numeric_limits<double>::infinity()) == rme::Status::NonFiniteInput);
  CHECK(monitor.update_with_work(0, std::numeric_limits<double>::infinity()) == rme::Status::NonFiniteInput);
  CHECK(monitor.update_with_work(std::numeric_limits<double>::quiet_NaN(), 0) == rme::Status::NonFiniteInput);
  CHECK(monitor.residual() == residual);
  monitor.reset();
  CHECK(monitor.residual() == 0);
  REQUIRE(monitor.update(7, 0) == rme::Status::Ok);
  CHECK(monitor.residual() == 0);
  CHECK(monitor.supplied() == 0);
  CHECK_THROWS_WITH(rme::PassivityMonitor<double>(0), contains("PassivityMonitor::period"));
}

TEST_CASE("kinetic_energy: half of dq M dq", "[passivity]") {
  Eigen::Matrix2d M;
  M << 2, 1, 1, 3;
  CHECK(rme::kinetic_energy<double, 2>(M, {1, 2}) == Approx(0.5 * (2 + 4 + 12)));
}

}  // namespace
