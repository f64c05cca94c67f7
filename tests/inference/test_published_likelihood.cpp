#include <cmath>
#include <random>
#include <rme/inference/published_likelihood.hpp>

#include "support/catch.hpp"
#include "support/random_events.hpp"

namespace {

using rme::Status;
using rme::testing::Event;
using rme::testing::random_event;
using Observation = rme::PayloadObservation<double, 7>;

/// Reads an event's samples.
auto samples_of(const Event& event) {
  return [&event](int i) -> const Observation& { return event.samples[static_cast<std::size_t>(i)]; };
}

TEST_CASE("published_likelihood: it is the Gaussian density of the paper, written out", "[published]") {
  const unsigned seed = 80;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    const Event event = random_event(random, 197, true);  // 197 = 4 * 49 + 1: each fourth sample, ends included
    rme::PayloadLikelihood<double> likelihood;
    REQUIRE(rme::published_likelihood<double, 7>(197, samples_of(event), likelihood) == Status::Ok);
    const Eigen::Vector4d theta = event.truth + 0.05 * Eigen::Vector4d::Random();
    const auto payload = rme::Payload<double>::from_vector(theta);
    double expected = 0;
    for (int j = 0; j < 7; ++j) {
      double least = 1e9, most = -1e9, squares = 0;
      for (std::size_t t = 0; t <= 196; t += 4) {
        least = std::min(least, event.samples[t].tau[j]);
        most = std::max(most, event.samples[t].tau[j]);
        const double e = event.samples[t].tau[j] - event.samples[t].regressor.torque(payload)[j];
        squares += e * e;
      }
      const double sigma = std::max(0.25 * (most - least), 0.1);
      expected -= 0.5 * squares / (sigma * sigma);
    }
    CHECK(likelihood.log_likelihood(theta) == Approx(expected).epsilon(1e-9));
  }
}

TEST_CASE("published_likelihood: it reads 50 samples from first to last, and no others", "[published]") {
  std::mt19937_64 random(81);
  const Event event = random_event(random, 200);
  std::vector<int> read;
  const auto at = [&](int i) {
    read.push_back(i);
    return event.samples[static_cast<std::size_t>(i)];
  };
  rme::PayloadLikelihood<double> likelihood;
  REQUIRE(rme::published_likelihood<double, 7>(200, at, likelihood) == Status::Ok);
  REQUIRE(read.size() == 50);
  CHECK(read.front() == 0);
  CHECK(read.back() == 199);
  for (std::size_t k = 1; k < read.size(); ++k) CHECK((read[k] - read[k - 1] == 4 || read[k] - read[k - 1] == 5));
}

TEST_CASE("published_likelihood: a short window is used as it is, an empty or broken one refused", "[published]") {
  std::mt19937_64 random(82);
  Event event = random_event(random, 3);
  rme::PayloadLikelihood<double> likelihood;
  REQUIRE(rme::published_likelihood<double, 7>(1, samples_of(event), likelihood) == Status::Ok);
  // One sample does not vary: sigma is 0.1 N m in every joint, and it counts 50 times.
  CHECK(likelihood.yy == Approx(50 * event.samples[0].tau.squaredNorm() / 0.01));
  likelihood.yy = 77;
  CHECK(rme::published_likelihood<double, 7>(0, samples_of(event), likelihood) == Status::NotReady);
  event.samples[1].regressor.B(2, 1) = std::nan("");
  CHECK(rme::published_likelihood<double, 7>(3, samples_of(event), likelihood) == Status::NonFiniteInput);
  CHECK(likelihood.yy == 77);
}

}  // namespace
