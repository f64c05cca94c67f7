// The compensation of a hand that is held by something rigid, in closed loop.
#include <contact/rigid_hold.hpp>

#include "support/catch.hpp"

namespace {

using rme::examples::hold_fast;
using rme::examples::RigidHold;
using rme::examples::RigidHoldResult;

TEST_CASE("Undecided: compensation does not drive up the force on a hand that is held, at any stiffness",
          "[undecided]") {
  // With 7, the force came in steps, each of which appeared at once.
  for (const auto& [stiffness, rise] : {std::pair(200.0, 0.01), std::pair(200.0, 0.03), std::pair(1000.0, 0.02)})
    for (const std::uint64_t seed : {1u, 2u, 7u}) {
      CAPTURE(stiffness, rise, seed);
      RigidHold hold;
      hold.stiffness = stiffness;
      hold.rise = rise;
      hold.seed = seed;
      const RigidHoldResult with = hold_fast(hold);
      hold.compensates = false;
      const RigidHoldResult without = hold_fast(hold);
      REQUIRE(without.force > 0.8 * stiffness * rise);
      CHECK(with.force < 1.25 * without.force + 0.5);
      CHECK(with.believed < 2.5 * with.std);  // an empty hand
    }
}

TEST_CASE("Undecided: what stands on a table is lifted, and at once if the host says that it is a weight",
          "[undecided]") {
  for (const std::uint64_t seed : {1u, 2u}) {
    CAPTURE(seed);
    RigidHold hold;
    hold.rise = 0.05;
    hold.mass = 1;
    hold.seed = seed;
    hold.compensates = false;
    const RigidHoldResult without = hold_fast(hold);
    hold.compensates = true;
    const RigidHoldResult with = hold_fast(hold);
    hold.announced = true;
    const RigidHoldResult announced = hold_fast(hold);
    REQUIRE(without.sag > 0.045);
    CHECK(with.sag < 0.005);
    CHECK(announced.sag < 0.0015);
    CHECK(std::abs(with.believed - 1) < 3 * with.std + 0.02);
    CHECK(with.std < 0.1);
  }
}

TEST_CASE("Undecided: an object that leaves its table slowly is not taken for a lighter one that swings",
          "[undecided]") {
  for (const std::uint64_t seed : {7u, 17u, 27u}) {
    CAPTURE(seed);
    RigidHold hold;
    hold.rise = 0.05;
    hold.duration = 2;
    hold.mass = 1;
    hold.seed = seed;
    const RigidHoldResult with = hold_fast(hold);
    CHECK(with.sag < 0.004);
    CHECK(std::abs(with.believed - 1) < 3 * with.std + 0.02);
  }
}

}  // namespace
