#include <cmath>
#include <io/log_reader.hpp>
#include <limits>
#include <random>
#include <rme/sensing/momentum_observer.hpp>
#include <synthetic_arm/panda.hpp>

#include "support/catch.hpp"

namespace {

template <typename Scalar>
using Observer = rme::MomentumObserver<Scalar, 2>;
template <typename Scalar>
using Config = rme::MomentumObserverConfig<Scalar, 2>;
using rme::Status;

TEMPLATE_TEST_CASE("MomentumObserver: a step of external torque comes out as 1 - (1 - K dt)^k, joint by joint",
                   "[momentum_observer]", float, double) {
  using Scalar = TestType;
  using Vector = rme::JointVector<Scalar, 2>;
  // Two decoupled inertias under gravity and motor torque; from sample 3 on an external torque e turns them evenly
  // faster, which is the exact solution of M dv = (tau + e - g) dt. The first-order filter's answer to a
  // step, by Euler's rule, is e (1 - (1 - K dt)^k) after k periods.
  const Scalar dt = Scalar(1e-3);
  const Vector e(2, Scalar(-0.5)), gravity(3, 1), tau(4, Scalar(0.5)), gain(50, 200);
  const rme::JointMatrix<Scalar, 2> mass = Vector(Scalar(0.5), 2).asDiagonal();
  Observer<Scalar> observer(dt, Config<Scalar>{gain});
  Vector dq(Scalar(0.3), Scalar(-0.1));
  for (int k = 0; k <= 100; ++k) {
    CAPTURE(k);
    REQUIRE(observer.update(tau, dq, mass, Vector::Zero(), gravity) == Status::Ok);
    for (int i = 0; i < 2; ++i) {
      const double left = std::pow(1 - 1e-3 * static_cast<double>(gain[i]), std::max(0, k - 3));
      const double expected = static_cast<double>(e[i]) * (1 - left);
      // float: momenta of 1 kg m^2/s have 1e-7 of rounding, divided by 1 ms.
      CHECK(std::abs(static_cast<double>(observer.tau_ext()[i]) - expected) < (sizeof(Scalar) == 4 ? 1e-3 : 1e-12));
    }
    const Vector net = k >= 3 ? Vector(tau - gravity + e) : Vector(tau - gravity);
    dq += dt * mass.inverse() * net;
  }
}

TEST_CASE("MomentumObserver: at short periods a step comes out as 1 - exp(-K t)", "[momentum_observer]") {
  using Vector = rme::JointVector<double, 2>;
  const double dt = 1e-5;
  const Vector e(2, -3), gain(50, 20), zero = Vector::Zero();
  Observer<double> observer(dt, Config<double>{gain});
  for (int k = 0; k <= 2000; ++k) {
    const double t = k * dt;  // a unit mass under e alone: dq = e t
    REQUIRE(observer.update(zero, e * t, rme::JointMatrix<double, 2>::Identity(), zero, zero) == Status::Ok);
    for (int i = 0; i < 2; ++i)  // Euler's rule errs by at most K dt / (2 e) of the step
      CHECK(std::abs(observer.tau_ext()[i] / e[i] - (1 - std::exp(-gain[i] * t))) < 0.2 * gain[i] * dt);
  }
}

TEST_CASE("MomentumObserver: from q, dq and the command it finds what MuJoCo's log reports as tau_ext",
          "[momentum_observer]") {
  const auto log = rme::examples::read_log<7>(RME_TEST_DATA "/mujoco/panda_attach.csv");
  REQUIRE(log.size() == 311);
  rme::MomentumObserver<double, 7> observer(1e-3);  // 50 rad/s, as the log's
  rme::JointVector<double, 7> held = rme::JointVector<double, 7>::Zero();
  double largest = 0;
  for (std::size_t k = 0; k < log.size(); ++k) {
    CAPTURE(log.t[k]);
    const auto terms = rme::examples::panda().dynamics(log.q[k], log.dq[k]);
    REQUIRE(observer.update(held, log.dq[k], terms.mass_matrix, terms.coriolis_transpose, terms.gravity) == Status::Ok);
    // The log takes C^T dq - g at the start of each period, we take the mean over it: at most half of what gravity
    // changes in 1 ms, and that is 9e-4 N m here.
    CHECK((observer.tau_ext() - log.tau_ext[k]).cwiseAbs().maxCoeff() < 5e-4);
    largest = std::max(largest, log.tau_ext[k].cwiseAbs().maxCoeff());
    held = log.tau[k];
  }
  CHECK(largest > 3);  // so that agreement means something
}

TEST_CASE("MomentumObserver: gravity that changes as the arm moves is not taken for a push", "[momentum_observer]") {
  // g = slope t and nothing else: by hand M dq = -slope t^2 / 2. The mean over a period is exact for a straight line.
  using Vector = rme::JointVector<double, 2>;
  const Vector slope(30, -20), inertia(0.5, 2), zero = Vector::Zero();
  Observer<double> observer(1e-3);
  for (int k = 0; k <= 200; ++k) {
    const double t = 1e-3 * k;
    const Vector dq = -t * t / 2 * slope.cwiseQuotient(inertia);
    REQUIRE(observer.update(zero, dq, inertia.asDiagonal(), zero, t * slope) == Status::Ok);
    CHECK(observer.tau_ext().norm() < 1e-11);
  }
}

TEMPLATE_TEST_CASE("MomentumObserver: samples at any instants are what the filter says at those instants",
                   "[momentum_observer]", float, double) {
  using Scalar = TestType;
  using Vector = rme::JointVector<Scalar, 2>;
  // Euler's rule with period dt is the continuous filter dr/dt = a (e - r), a = -ln(1 - K dt) / dt, seen each dt. Under
  // a constant e, an arm that obeys M dv = (tau + e - g) dt, and samples at instants t_k of any distance, its exact
  // answer is r(t_k) = e (1 - exp(-a t_k)). The last joint's K dt is 1: its filter forgets all within a sample.
  const Scalar dt = Scalar(2e-3);
  const Vector e(2, Scalar(-0.5)), gravity(3, 1), tau(4, Scalar(0.5)), gain(50, 500);
  const Vector inertia(Scalar(0.5), 2), start(Scalar(0.3), Scalar(-0.1));
  const Vector acceleration = (tau - gravity + e).cwiseQuotient(inertia);
  const unsigned seed = 3;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-1, 1.5);
  Observer<Scalar> observer(dt, Config<Scalar>{gain});
  double t = 0;
  for (int k = 0; k < 60; ++k) {
    const double h = k % 10 == 9 ? 0.5 : 2e-3 * std::pow(10, exponent(random));  // 0.2 to 60 ms, and gaps
    if (k > 0) t += h;
    CAPTURE(k, h, t);
    const Vector dq = start + Scalar(t) * acceleration;
    REQUIRE(observer.update(tau, dq, inertia.asDiagonal(), Vector::Zero(), gravity, h) == Status::Ok);
    const double a = -std::log(1 - 0.1) / 2e-3;
    const Vector expected(Scalar(2 * (1 - std::exp(-a * t))), Scalar(k > 0 ? -0.5 : 0));
    // float: momenta of 30 kg m^2/s have 2e-6 of rounding, divided by 0.2 ms.
    CHECK((observer.tau_ext() - expected).norm() < Scalar(sizeof(Scalar) == 4 ? 5e-2 : 1e-10));
    if (k == 20) {  // the filter is at rest: begin again with all that it has to say
      observer.reset();
      REQUIRE(observer.update(tau, start, inertia.asDiagonal(), Vector::Zero(), gravity, h) == Status::Ok);
      t = 0;
    }
  }
}

TEST_CASE("MomentumObserver: a measured period that is the nominal one changes nothing", "[momentum_observer]") {
  using Vector = rme::JointVector<double, 2>;
  const unsigned seed = 8;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const auto draw = [&]() -> Vector { return Vector::NullaryExpr([&] { return normal(random); }); };
  Observer<double> nominal(1e-3), zero(1e-3), measured(1e-3);
  for (int k = 0; k < 200; ++k) {
    const Vector tau = draw(), dq = draw(), drift = draw(), gravity = draw();
    const rme::JointMatrix<double, 2> mass = rme::JointMatrix<double, 2>::Identity();
    REQUIRE(nominal.update(tau, dq, mass, drift, gravity) == Status::Ok);
    REQUIRE(zero.update(tau, dq, mass, drift, gravity, 0) == Status::Ok);
    REQUIRE(measured.update(tau, dq, mass, drift, gravity, 1e-3) == Status::Ok);
    CHECK(zero.tau_ext() == nominal.tau_ext());
    CHECK((measured.tau_ext() - nominal.tau_ext()).norm() < 1e-10);
  }
}

TEST_CASE("MomentumObserver: bad input is named and leaves it as it was", "[momentum_observer]") {
  using Vector = rme::JointVector<double, 2>;
  const double nan = std::numeric_limits<double>::quiet_NaN(), inf = std::numeric_limits<double>::infinity();
  const Vector tau(1, 2), dq(0.1, 0.2), zero = Vector::Zero();
  const rme::JointMatrix<double, 2> mass = rme::JointMatrix<double, 2>::Identity();
  Observer<double> disturbed(1e-3), clean(1e-3);
  for (int k = 0; k < 3; ++k)
    for (auto* observer : {&disturbed, &clean}) REQUIRE(observer->update(tau, k * dq, mass, zero, zero) == Status::Ok);
  const Vector before = disturbed.tau_ext();
  for (const double bad : {nan, inf, -inf}) {
    const Vector v(0, bad);
    CHECK(disturbed.update(v, dq, mass, zero, zero) == Status::NonFiniteInput);
    CHECK(disturbed.update(tau, v, mass, zero, zero) == Status::NonFiniteInput);
    CHECK(disturbed.update(tau, dq, bad * mass, zero, zero) == Status::NonFiniteInput);
    CHECK(disturbed.update(tau, dq, mass, v, zero) == Status::NonFiniteInput);
    CHECK(disturbed.update(tau, dq, mass, zero, v) == Status::NonFiniteInput);
    CHECK(disturbed.update(tau, dq, mass, zero, zero, bad) == Status::NonFiniteInput);
    CHECK(disturbed.tau_ext() == before);
  }
  for (const double bad : {-1e-3, 1e30, 1e-320})  // time that runs backwards, for too long, or not at all
    CHECK(disturbed.update(tau, dq, mass, zero, zero, bad) == Status::NonFiniteInput);
  REQUIRE(disturbed.update(tau, 3 * dq, mass, zero, zero) == Status::Ok);
  REQUIRE(clean.update(tau, 3 * dq, mass, zero, zero) == Status::Ok);
  CHECK(disturbed.tau_ext() == clean.tau_ext());  // nor did any of it stay in the momentum
}

TEST_CASE("MomentumObserver: after reset the arm's speed is not taken for a push", "[momentum_observer]") {
  using Vector = rme::JointVector<double, 2>;
  const Vector zero = Vector::Zero();
  const rme::JointMatrix<double, 2> mass = rme::JointMatrix<double, 2>::Identity();
  Observer<double> observer(1e-3);
  for (const double speed : {0.0, 5.0}) {
    observer.reset();
    for (int k = 0; k < 5; ++k) REQUIRE(observer.update(zero, Vector(speed, -speed), mass, zero, zero) == Status::Ok);
    CHECK(observer.tau_ext() == zero);
  }
}

TEST_CASE("MomentumObserver: settings out of range are refused by name", "[momentum_observer]") {
  CHECK_THROWS_WITH(Observer<double>(0.0), contains("MomentumObserver::dt"));
  CHECK_THROWS_WITH(Observer<double>(std::nan("")), contains("MomentumObserver::dt"));
  CHECK_THROWS_WITH(Observer<double>(1e-3, Config<double>{{50, 0}}), contains("MomentumObserverConfig::gain"));
  CHECK_THROWS_WITH(Observer<double>(1e-3, Config<double>{{std::nan(""), 50}}), contains("gain"));
  CHECK_THROWS_WITH(Observer<double>(1e-3, Config<double>{{50, 1001}}), contains("at most one over the period"));
}

using V = rme::JointVector<double, 2>;
using M = rme::JointMatrix<double, 2>;
static_assert(noexcept(std::declval<Observer<double>&>().update(std::declval<const V&>(), std::declval<const V&>(),
                                                                std::declval<const M&>(), std::declval<const V&>(),
                                                                std::declval<const V&>(), 1e-3)),
              "a tick must not throw");

}  // namespace
