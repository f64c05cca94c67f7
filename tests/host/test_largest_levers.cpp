#include <cmath>
#include <limits>
#include <random>
#include <rme/host/largest_levers.hpp>
#include <synthetic_arm/panda.hpp>

#include "support/catch.hpp"

namespace {

using rme::examples::panda;
using Vector7 = rme::JointVector<double, 7>;

TEST_CASE("largest_levers: an arm of two links in a plane reaches as far as both together, from any pose", "[host]") {
  // Links of 0.4 and 0.3 m, joints about z. By hand: the elbow's axis is 0.3 m from the hand, always; the shoulder's at
  // most 0.7 m, when the arm is straight.
  for (const double elbow : {0.0, 0.5, 1.57, 3.0, -2.0}) {
    CAPTURE(elbow);
    rme::Jacobian<double, 2> J = rme::Jacobian<double, 2>::Zero();
    const double x = 0.4 + 0.3 * std::cos(elbow), y = 0.3 * std::sin(elbow);
    J.col(0) << -y, x, 0, 0, 0, 1;
    J.col(1) << -y, x - 0.4, 0, 0, 0, 1;
    const auto levers = rme::largest_levers(J);
    CHECK(levers[0] == Approx(0.7));
    CHECK(levers[1] == Approx(0.3));
  }
}

TEST_CASE("largest_levers: no pose of a Panda exceeds what any one pose says, which is at most 2 percent more",
          "[host]") {
  const unsigned seed = 371;
  CAPTURE(seed);
  std::mt19937 random(seed);
  const auto pose = [&] {
    return Vector7(Vector7::NullaryExpr([&] { return std::uniform_real_distribution<double>(-3.1, 3.1)(random); }));
  };
  Vector7 reached = Vector7::Zero();
  for (int k = 0; k < 20000; ++k)
    reached = reached.cwiseMax(panda().kinematics(pose()).jacobian.topRows<3>().colwise().norm().transpose());
  for (int k = 0; k < 50; ++k) {
    const Vector7 levers = rme::largest_levers(panda().kinematics(pose()).jacobian);
    CAPTURE(levers.transpose(), reached.transpose());
    for (int j = 0; j < 7; ++j) {
      CHECK(levers[j] >= reached[j] - 1e-12);
      CHECK(levers[j] <= 1.02 * reached[j] + 1e-12);
    }
  }
}

TEST_CASE("largest_levers: before a joint that is not revolute, nothing is known", "[host]") {
  rme::Jacobian<double, 7> J = panda().kinematics(panda().ready).jacobian;
  const Vector7 all = rme::largest_levers(J);
  REQUIRE(all.allFinite());
  J.col(3) << 0, 0, 1, 0, 0, 0;  // a slide
  const Vector7 levers = rme::largest_levers(J);
  for (int j = 0; j < 4; ++j) CHECK(levers[j] == std::numeric_limits<double>::infinity());
  CHECK((levers.tail<3>() == all.tail<3>()));
  J.col(6)[0] = std::nan("");
  CHECK(!(rme::largest_levers(J)[6] < 10));  // nothing that looks like a lever
}

}  // namespace
