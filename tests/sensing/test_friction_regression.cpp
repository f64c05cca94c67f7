#include <cmath>
#include <random>
#include <rme/sensing/friction_regression.hpp>

#include "support/catch.hpp"

namespace {

using Regression = rme::FrictionRegression<double, 2>;
using Joints = rme::JointVector<double, 2>;

const Joints kCoulomb(0.25, 0.05), kViscous(0.12, 0.4), kOffset(0.1, -0.3);

/// Two joints that swing, one of them slowly. The observer has a lag of 20 ms.
struct Swing {
  Joints dq = Joints::Zero(), friction = Joints::Zero();
  double time = 0;
  void tick() {
    time += 1e-3;
    dq = Joints(0.8 * std::sin(3 * time), 0.3 * std::sin(1.1 * time));
    for (int j = 0; j < 2; ++j) {
      const double now = (dq[j] > 0 ? kCoulomb[j] : -kCoulomb[j]) + kViscous[j] * dq[j];
      friction[j] += 1e-3 / (1e-3 + 0.02) * (now - friction[j]);
    }
  }
};

TEST_CASE("FrictionRegression: finds Coulomb and viscous friction beside an offset, and knows how well", "[contact]") {
  const unsigned seed = 500;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> normal;
  Regression regression(0.02, Joints::Ones(), 0.2 * Joints::Ones(), 0.1 * Joints::Ones());
  Swing swing;
  // At rest nothing is known of the friction but its prior: uniform from -c to c, of which E[c^2] = 0.2^2.
  regression.update(Joints::Zero(), 1e-3);
  CHECK(regression.torque() == Joints::Zero());
  CHECK(regression.variance(1)[0] == Approx(0.04 / 3));
  CHECK(regression.variance(0)[0] == 0);
  for (int k = 1; k <= 60000; ++k) {
    swing.tick();
    regression.update(swing.dq, 1e-3);
    Joints residual = swing.friction + kOffset;
    for (int j = 0; j < 2; ++j) residual[j] += 0.01 * normal(random);
    if (k % 20 == 0) regression.learn(residual);
    // After half a minute it explains what moves, but for the instants at which a joint turns over.
    if (k > 30000 && std::abs(swing.dq[0]) > 0.1) REQUIRE(std::abs((regression.torque() - swing.friction)[0]) < 0.02);
    if (k > 30000 && std::abs(swing.dq[1]) > 0.1) REQUIRE(std::abs((regression.torque() - swing.friction)[1]) < 0.02);
    if (k > 30000) REQUIRE(regression.variance(1).maxCoeff() < 0.04 / 3);
  }
  // A joint that rests now: most of the doubt is the stiction of the c that was found.
  for (int k = 0; k < 1000; ++k) regression.update(Joints::Zero(), 1e-3);
  CHECK(regression.torque().norm() < 1e-6);
  CHECK(regression.variance(0)[0] == Approx(kCoulomb[0] * kCoulomb[0] / 12).epsilon(0.15));
  CHECK(regression.rest()[0] == 1);
}

TEST_CASE("FrictionRegression: one wild residual hardly moves it", "[contact]") {
  Regression regression(0, Joints::Ones(), 0.2 * Joints::Ones(), 0.1 * Joints::Ones());
  Swing swing;
  for (int k = 1; k <= 20000; ++k) {
    swing.tick();
    regression.update(swing.dq, 1e-3);
    if (k % 20 == 0) regression.learn(kOffset);
  }
  const Joints before = regression.torque();
  regression.learn(Joints::Constant(1e6));
  CHECK((regression.torque() - before).norm() < 0.05);
  CHECK(regression.torque().allFinite());
}

}  // namespace
