#include <cmath>
#include <random>
#include <rme/estimator_state.hpp>

#include "support/catch.hpp"

namespace {

using State = rme::EstimatorState<double>;

/// Something is held with this probability, its mass [kg] known to a deviation.
State weighing(double held, double mass, double deviation) {
  State state;
  state.held = held;
  state.inertial.mean[0] = mass;
  state.inertial.covariance(0, 0) = deviation * deviation;
  return state;
}

TEST_CASE("EstimatorState: heavier_than() is the share of drawn payloads that are heavier, where an empty hand is not",
          "[estimator]") {
  const unsigned seed = 3643;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::normal_distribution<double> n;
  std::bernoulli_distribution held(0.8);
  constexpr int kDraws = 200'000;
  for (const double health : {1.0, 12.0}) {  // above 3, variances are multiplied by a third of it
    State state = weighing(0.8, 0.5, 0.03);
    state.health = health;
    const double deviation = 0.03 * std::sqrt(std::max(1.0, health / 3));
    for (const double mass : {0.0, 0.44, 0.5, 0.53, 0.62}) {
      CAPTURE(health, mass);
      int heavier = 0;
      for (int k = 0; k < kDraws; ++k) {
        const double drawn = 0.5 + deviation * n(random);
        heavier += held(random) && drawn > mass ? 1 : 0;
      }
      const double p = state.heavier_than(mass);
      CHECK(std::abs(heavier - p * kDraws) < 4 * std::sqrt(p * (1 - p) * kDraws) + 1);
    }
  }
}

TEST_CASE("EstimatorState: of a mass that is known exactly, heavier_than() is all or nothing", "[estimator]") {
  const State state = weighing(0.9, 0.5, 0);
  CHECK(state.heavier_than(0.499) == 0.9);
  CHECK(state.heavier_than(0.5) == 0);
  CHECK(State().heavier_than(0) == 0);
}

}  // namespace
