#include <algorithm>
#include <cmath>
#include <rme/tracking/removal_guard.hpp>

#include "support/catch.hpp"

namespace {

using Guard = rme::RemovalGuard<double, 7>;
using Vector = Guard::Vector;

constexpr double kPeriod = 1e-3;

/// What a payload does to the joints, and what the arm shows besides [N m].
Vector weight() {
  Vector w;
  w << 0, 4, 0.5, -3, 0.2, 1, 0;
  return w;
}
const Vector kBesides = Vector::Constant(0.1);

Guard carrying() {
  Guard guard;
  guard.learn(weight() + kBesides, weight(), false, 0.02);
  for (int k = 0; k < 100; ++k) guard.update(weight() + kBesides, weight(), kPeriod);
  return guard;
}

TEST_CASE("RemovalGuard: what is held is carried in full, whatever else the arm shows", "[removal_guard]") {
  CHECK(Guard().share() == 1);
  CHECK(carrying().share() == 1);
}

TEST_CASE("RemovalGuard: a weight that goes at once is cut to nothing, by the law of its average", "[removal_guard]") {
  Guard guard = carrying();
  // Of the weight exp(-t / 4 ms) is left in the average; twice that is safe, as long as it is below 1.
  for (int k = 1; k <= 20; ++k) {
    guard.update(kBesides, weight(), kPeriod);
    CHECK(guard.share() == Approx(std::min(1.0, 2 * std::exp(-k * kPeriod / 0.004))).margin(1e-9));
  }
  CHECK(guard.share() < 0.02);
}

TEST_CASE("RemovalGuard: half of the weight is enough, a quarter of it halves the compensation", "[removal_guard]") {
  for (const auto& [left, share] : {std::pair(0.5, 1.0), std::pair(0.25, 0.5), std::pair(-0.5, 0.0)}) {
    Guard guard = carrying();
    for (int k = 0; k < 100; ++k) guard.update(left * weight() + kBesides, weight(), kPeriod);
    CAPTURE(left);
    CHECK(guard.share() == Approx(share).margin(1e-6));
  }
}

TEST_CASE("RemovalGuard: torque across the payload's is a push, and cuts nothing", "[removal_guard]") {
  Guard guard = carrying();
  Vector across = Vector::Zero();
  across[0] = 10;
  across[6] = -5;
  for (int k = 0; k < 100; ++k) guard.update(weight() + across + kBesides, weight(), kPeriod);
  CHECK(guard.share() == 1);
}

TEST_CASE("RemovalGuard: only a push that bears more than the payload lets it be carried, within a second",
          "[removal_guard]") {
  for (const double borne : {0.9, 1.15, 1.25, 3.0})
    for (const double pushed_for : {0.0, 0.62, 10.0}) {  // an odd number of blocks, too
      CAPTURE(borne, pushed_for);
      const Vector tau = weight() + kBesides - borne * weight();
      Guard guard = carrying();
      for (int k = 0; k < static_cast<int>(std::lround(pushed_for / 0.02)); ++k) guard.learn(tau, weight(), true, 0.02);
      for (int k = 0; k < 100; ++k) guard.update(tau, weight(), kPeriod);
      const double unlearned = borne > 1.2 ? std::exp(-pushed_for) : 1;
      CHECK(guard.share() == Approx(std::clamp(2 * (1 - borne * unlearned), 0.0, 1.0)).margin(1e-6));
      // The push ends: the weight is back.
      for (int k = 0; k < 100; ++k) guard.update(weight() + kBesides, weight(), kPeriod);
      CHECK(guard.share() == Approx(1));
    }
}

TEST_CASE("RemovalGuard: what comes back is carried again, and too little to be dangerous is left alone",
          "[removal_guard]") {
  Guard guard = carrying();
  for (int k = 0; k < 100; ++k) guard.update(kBesides, weight(), kPeriod);
  REQUIRE(guard.share() < 1e-6);
  for (int k = 0; k < 100; ++k) guard.update(weight() + kBesides, weight(), kPeriod);
  CHECK(guard.share() == Approx(1));
  // 0.29 N m in all, and then 0.31.
  for (int k = 0; k < 100; ++k) guard.update(kBesides, 0.29 * weight().normalized(), kPeriod);
  CHECK(guard.share() == 1);
  guard.update(kBesides, 0.31 * weight().normalized(), kPeriod);
  CHECK(guard.share() < 1e-6);
}

}  // namespace
