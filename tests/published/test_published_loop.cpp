// What a host may rely on, whatever the pipeline computes.
#include <cmath>
#include <limits>
#include <string>
#include <type_traits>
#include <vector>

#include "published/changing_hand.hpp"
#include "published/pipelines.hpp"
#include "realtime/allocations_of.hpp"
#include "support/catch.hpp"

namespace {

using rme::PublishedPhase;
using rme::Status;
using rme::testing::cast;
using rme::testing::changing_hand;
using Tick = rme::Proprioception<double, 7>;
using Guess = rme::FixedGuess<double>;
using Pipeline = rme::PublishedPipeline<double, 7, Guess>;

constexpr double kPeriod = 1e-3;

template <typename P, typename T>
constexpr bool kQuiet = noexcept(std::declval<P&>().update(std::declval<const T&>())) && noexcept(
    std::declval<const P&>()
        .state()) && noexcept(std::declval<P&>()
                                  .reset()) && noexcept(std::declval<const P&>()
                                                            .time()) && noexcept(std::declval<const P&>()
                                                                                     .compensation(
                                                                                         std::declval<const T&>()
                                                                                             .jacobian,
                                                                                         std::declval<const T&>()
                                                                                             .rotation));
static_assert(kQuiet<Pipeline, Tick>);
static_assert(kQuiet<rme::PublishedPipeline<float, 6>, rme::Proprioception<float, 6>>);
static_assert(!std::is_constructible_v<Pipeline, double, Guess>, "a temporary network would be gone");

template <typename Scalar>
void check_same(const rme::PublishedState<Scalar>& a, const rme::PublishedState<Scalar>& b) {
  CHECK(a.phase == b.phase);
  CHECK(a.detections == b.detections);
  CHECK(a.estimates == b.estimates);
  CHECK(a.detected_at == b.detected_at);
  CHECK(a.estimated_at == b.estimated_at);
  CHECK(a.posterior.mean == b.posterior.mean);
  CHECK(a.posterior.covariance == b.posterior.covariance);
  CHECK(a.iterations == b.iterations);
  CHECK(a.outcome == b.outcome);
}

const rme::Payload<double> kFirst = {0.9, {0.03, -0.02, 0.12}}, kSecond = {1.5, {0.02, 0.04, 0.1}};

TEMPLATE_TEST_CASE("PublishedPipeline: without a network it finds what was attached, added and removed", "[published]",
                   double, float) {
  // The solver's last step is good to 0.05 kg and 2 cm; the sensor's offset of 0.1 N m, of which nothing is known here,
  // half a metre from the hand is worth 0.02 kg, and a centimetre. Gravity is along z, which is not seen.
  const rme::FixedGuess<TestType> zero;
  const auto expect = [](const rme::PublishedState<TestType>& state, const rme::Payload<double>& truth) {
    const Eigen::Vector4d mean = state.posterior.mean.template cast<double>();
    CAPTURE(state.estimated_at);
    CHECK(std::abs(mean[0] - truth.mass) < 0.15);
    if (truth.mass > 0) CHECK((mean.segment<2>(1) - truth.com.head<2>()).norm() < 0.06);
    CHECK(state.posterior.covariance.isDiagonal(TestType(0)));
    CHECK((state.posterior.standard_deviation().array() > 0).all());
  };
  for (const unsigned seed : {520U, 521U, 522U}) {
    CAPTURE(seed);
    rme::PublishedPipeline<TestType, 7, rme::FixedGuess<TestType>> pipeline(kPeriod, zero, {}, seed);
    const auto ticks = changing_hand(seed, kFirst, kSecond);
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      REQUIRE(pipeline.update(cast<TestType>(ticks[k])) == Status::Ok);
      if (k == 799) CHECK(pipeline.state().detections == 0);
      if (k == 1999) expect(pipeline.state(), kFirst);
      if (k == 4499) expect(pipeline.state(), kSecond);
    }
    CHECK(pipeline.state().estimated_at > 4.7);
    expect(pipeline.state(), {});
  }
}

TEST_CASE("PublishedPipeline: it collects for 200 ms after the detection, and the state says so", "[published]") {
  const auto ticks = changing_hand(523, kFirst, kSecond);
  const Guess zero;
  Pipeline pipeline(kPeriod, zero);
  CHECK(pipeline.state().outcome == Status::NotReady);
  CHECK(pipeline.state().posterior.mean.isZero(0));
  int collecting = 0, estimates = 0;
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    REQUIRE(pipeline.update(ticks[k]) == Status::Ok);
    CHECK(pipeline.time() == Approx(kPeriod * double(k + 1)));
    const auto& state = pipeline.state();
    if (state.phase == PublishedPhase::Collecting) {
      CHECK(state.detections == state.estimates + 1);
      if (collecting++ == 0) CHECK(state.detected_at == pipeline.time());
    } else if (collecting > 0) {
      CHECK(collecting == 200);  // the tick of the detection, and 199 before that of the estimate
      CHECK(state.estimated_at == pipeline.time());
      CHECK(state.estimated_at - state.detected_at == Approx(0.2));
      CHECK(int(state.estimates) == ++estimates);
      CHECK(state.detections == state.estimates);
      CHECK((state.outcome == Status::Ok || state.outcome == Status::NotConverged));
      collecting = 0;
    }
  }
  CHECK(estimates >= 5);
  CHECK(std::string(to_string(PublishedPhase::Watching)) == "Watching");
  CHECK(std::string(to_string(PublishedPhase::Collecting)) == "Collecting");
}

TEST_CASE("PublishedPipeline: a sample that makes no sense is refused and leaves no trace", "[published]") {
  const auto ticks = changing_hand(524, kFirst, kSecond);
  const Guess zero;
  Pipeline pipeline(kPeriod, zero), clean(kPeriod, zero);
  constexpr double kNan = std::numeric_limits<double>::quiet_NaN(), kInfinity = std::numeric_limits<double>::infinity();
  for (std::size_t k = 0; k < ticks.size(); ++k) {
    if (k % 7 == 3) {
      Tick bad = ticks[k];
      Status expected = Status::NonFiniteInput;
      if (k % 5 == 0) bad.tau_ext[int(k % 7)] = kNan;
      if (k % 5 == 1) bad.jacobian(2, 4) = kInfinity;
      if (k % 5 == 2) bad.rotation *= 1.1, expected = Status::NotARotation;
      if (k % 5 == 3) bad.dq[1] = kNan;
      if (k % 5 == 4) bad.tau_ext.setConstant(1e6);  // each of them is believed; their norm is not
      REQUIRE(pipeline.update(bad) == expected);
    }
    REQUIRE(pipeline.update(ticks[k]) == Status::Ok);
    REQUIRE(clean.update(ticks[k]) == Status::Ok);
    REQUIRE(pipeline.time() == clean.time());
  }
  CHECK(clean.state().estimates >= 5);
  check_same(pipeline.state(), clean.state());
}

TEST_CASE("PublishedPipeline: the compensation is the wrench of the estimate through the Jacobian, and nothing before",
          "[published]") {
  const auto ticks = changing_hand(525, kFirst, kSecond);
  const Guess zero;
  rme::PublishedPipelineConfig<double> config;
  Pipeline pipeline(kPeriod, zero, config);
  const Tick& tick = ticks[1500];
  CHECK(pipeline.compensation(tick.jacobian, tick.rotation).isZero(0));
  rme::Jacobian<double, 7> no_pose = tick.jacobian;
  no_pose(3, 3) = std::nan("");
  CHECK(pipeline.compensation(no_pose, tick.rotation).isZero(0));
  for (std::size_t k = 0; k <= 1700; ++k) REQUIRE(pipeline.update(ticks[k]) == Status::Ok);
  const Eigen::Vector4d theta = pipeline.state().posterior.mean;
  const Eigen::Vector3d weight(0, 0, -9.81 * theta[0]);
  const Eigen::Vector3d moment = (tick.rotation * theta.tail<3>()).cross(weight);
  const auto torque = pipeline.compensation(tick.jacobian, tick.rotation);
  for (int j = 0; j < 7; ++j) {
    const auto column = tick.jacobian.col(j);
    CHECK(torque[j] == Approx(-(column.head<3>().dot(weight) + column.tail<3>().dot(moment))).margin(1e-12));
  }
  // It carries the payload: what is left of it is what the sensor's offset and the solver's noise make of it.
  CHECK((ticks[1700].tau_ext + torque).norm() < 0.2 * ticks[1700].tau_ext.norm());
  // A pose that is none: that of the last sample counts.
  const Tick& last = ticks[1700];
  CHECK(pipeline.compensation(no_pose, tick.rotation) == pipeline.compensation(last.jacobian, last.rotation));
}

TEST_CASE("PublishedPipeline: one seed gives one result, and after a reset the same again", "[published]") {
  const auto ticks = changing_hand(526, kFirst, kSecond);
  const Guess zero;
  Pipeline pipeline(kPeriod, zero, {}, 3), other(kPeriod, zero, {}, 4);
  const auto play = [&ticks](Pipeline& p) {
    for (std::size_t k = 0; k < 2500; ++k) REQUIRE(p.update(ticks[k]) == Status::Ok);
  };
  play(pipeline);
  play(other);
  const auto before = pipeline.state();
  CHECK(before.estimates >= 2);
  CHECK(other.state().posterior.mean != before.posterior.mean);
  pipeline.reset();
  CHECK(pipeline.time() == 0);
  check_same(pipeline.state(), rme::PublishedState<double>());
  play(pipeline);
  check_same(pipeline.state(), before);
}

TEST_CASE("PublishedPipeline: an inference that fails makes no estimate, says why, and the watch goes on",
          "[published]") {
  const auto ticks = changing_hand(527, kFirst, kSecond);
  for (const double mass : {std::nan(""), 1e7}) {  // what no arm carries could overflow in the compensation
    CAPTURE(mass);
    Guess guess;
    guess.theta[0] = mass;
    Pipeline pipeline(kPeriod, guess);
    for (const Tick& tick : ticks) REQUIRE(pipeline.update(tick) == Status::Ok);
    CHECK(pipeline.state().outcome == Status::NonFiniteInput);
    CHECK(pipeline.state().detections >= 5);
    CHECK(pipeline.state().estimates == 0);
    CHECK(pipeline.state().posterior.mean.isZero(0));
    CHECK(pipeline.compensation(ticks[0].jacobian, ticks[0].rotation).isZero(0));
  }
}

#ifdef RME_COUNTS_ALLOCATIONS
TEST_CASE("PublishedPipeline: nothing is allocated after construction", "[published]") {
  auto ticks = changing_hand(528, kFirst, kSecond);
  for (std::size_t k = 5; k < ticks.size(); k += 97) ticks[k].tau_ext[2] = std::nan("");
  const auto network = rme::testing::random_network(rme::InputFrame::EndEffector);
  rme::PublishedPipeline<double, 7> pipeline(kPeriod, *network);
  int refused = 0;
  double largest = 0;
  std::uint64_t estimates = 0;
  const int count = rme::testing::allocations_of([&] {
    for (int round = 0; round < 2; ++round) {
      for (const Tick& tick : ticks) {
        refused += pipeline.update(tick) != Status::Ok;
        largest = std::max(largest, pipeline.compensation(tick.jacobian, tick.rotation).norm());
      }
      estimates += pipeline.state().estimates;
      pipeline.reset();
    }
  });
  CHECK(count == 0);
  CHECK(estimates >= 10);
  CHECK(refused == 116);
  CHECK(largest > 1);
}
#endif

}  // namespace
