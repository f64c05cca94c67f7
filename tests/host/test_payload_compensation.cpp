#include <cmath>
#include <limits>
#include <memory>
#include <rme/host/payload_compensation.hpp>
#include <vector>

#include "realtime/allocations_of.hpp"
#include "realtime/life.hpp"
#include "support/catch.hpp"
#include "support/held_arm.hpp"

namespace {

using namespace rme;
using rme::testing::HeldArm;
using Vector7 = JointVector<double, 7>;
using Compensation = PayloadCompensation<double, 7>;
using Config = PayloadCompensationConfig<double, 7>;
using Sample = Proprioception<double, 7>;

constexpr double kPeriod = HeldArm::kPeriod;
const Payload<double> kKilogram{1, {0.02, 0.01, 0.13}};

// On a control thread's stack: the estimator is elsewhere.
static_assert(sizeof(Compensation) < 4096);

TEST_CASE("PayloadCompensation: is an estimator that is told what is commanded, and a ramp", "[host]") {
  auto ticks = rme::testing::life(375);
  rme::testing::spoil(ticks);
  Compensation payload(kPeriod);
  const auto estimator = std::make_unique<Estimator<double, 7>>(kPeriod);
  CompensationRamp<double, 7> ramp(kPeriod);
  double largest = 0;
  int refused = 0;
  for (const Sample& tick : ticks) {
    Sample told = tick;
    told.compensation = ramp.torque();
    const Status status = estimator->update(told);
    if (status == Status::Ok)
      REQUIRE(ramp.update(estimator->compensation(tick.jacobian, tick.rotation)) == Status::Ok);
    else
      ++refused;
    REQUIRE(payload.update(tick) == status);
    REQUIRE((payload.torque() == ramp.torque()));  // also after a refusal
    largest = std::max(largest, payload.torque().norm());
  }
  CHECK((payload.state().payload.mean == estimator->state().payload.mean));
  CHECK(refused > 50);
  CHECK(largest > 5);
}

TEST_CASE("PayloadCompensation: what a host says of its own command is left as it is", "[host]") {
  HeldArm arm(376);
  Compensation payload(kPeriod);
  const auto estimator = std::make_unique<Estimator<double, 7>>(kPeriod);
  for (int k = 0; k < 2000; ++k) {
    if (k == 1000) arm.hold(kKilogram);
    Sample tick = arm.tick();
    tick.compensation = Vector7::Constant(0.1 * std::sin(0.01 * k));
    REQUIRE(payload.update(tick) == Status::Ok);
    REQUIRE(estimator->update(tick) == Status::Ok);
  }
  CHECK((payload.state().payload.mean == estimator->state().payload.mean));
}

/// A kilogram is held, and known.
struct Holding {
  explicit Holding(const Config& config = Config()) : payload(kPeriod, config) {
    run(1000);
    arm.hold(kKilogram);
    run(1500);
  }
  void run(int ticks) {
    for (int k = 0; k < ticks; ++k) REQUIRE(payload.update(arm.tick()) == Status::Ok);
  }
  Vector7 wanted() const { return -arm.torque(kKilogram); }

  HeldArm arm{377};
  Compensation payload;
};

TEST_CASE("PayloadCompensation: enable() fades in and out in the time given, and the estimate goes on", "[host]") {
  Config config;
  config.enabled = false;
  config.fade_time = 0.2;
  Holding host(config);
  CHECK_FALSE(host.payload.enabled());
  CHECK((host.payload.torque() == Vector7::Zero()));
  CHECK(std::abs(host.payload.state().payload.mean[0] - 1) < 0.02);
  host.payload.enable(true);
  host.run(100);  // half of the way
  CHECK((host.payload.torque() - 0.5 * host.wanted()).norm() < 0.03 * host.wanted().norm());
  host.run(100);
  CHECK((host.payload.torque() - host.wanted()).norm() < 0.03 * host.wanted().norm());
  host.payload.enable(false);
  CHECK_FALSE(host.payload.enabled());
  host.run(150);
  CHECK((host.payload.torque() - 0.25 * host.wanted()).norm() < 0.03 * host.wanted().norm());
  host.run(51);
  CHECK((host.payload.torque() == Vector7::Zero()));
}

TEST_CASE("PayloadCompensation: no joint gets more than its bound, and all are reduced by the same factor", "[host]") {
  const Holding free;
  const Vector7 all = free.payload.torque();
  int j = 0;
  REQUIRE(all.cwiseAbs().maxCoeff(&j) > 3);
  Config config;
  config.torque_bound = Vector7::Constant(100);
  (*config.torque_bound)[j] = 2;
  const Holding bounded(config);
  CHECK(std::abs(bounded.payload.torque()[j]) <= 2 * (1 + 1e-12));
  CHECK((bounded.payload.torque() - all * (2 / std::abs(all[j]))).norm() < 0.02 * all.norm());
}

TEST_CASE("PayloadCompensation: the rate is the ramp's", "[host]") {
  Config config;
  config.torque_rate = Vector7::Constant(20);
  HeldArm arm(378);
  Compensation payload(kPeriod, config);
  double fastest = 0;
  for (int k = 0; k < 3000; ++k) {
    if (k == 1000) arm.hold(kKilogram);
    const Vector7 before = payload.torque();
    REQUIRE(payload.update(arm.tick()) == Status::Ok);
    fastest = std::max(fastest, (payload.torque() - before).cwiseAbs().maxCoeff());
  }
  CHECK(fastest <= 0.02 * (1 + 1e-9));
  CHECK(fastest > 0.019);
}

TEST_CASE("PayloadCompensation: restart() begins at zero torque and keeps the estimate, reset() forgets it", "[host]") {
  Holding host;
  host.payload.restart();
  CHECK((host.payload.torque() == Vector7::Zero()));
  host.run(1);
  CHECK(host.payload.torque().cwiseAbs().maxCoeff() <= 0.5 * (1 + 1e-9));
  host.run(100);
  CHECK((host.payload.torque() - host.wanted()).norm() < 0.03 * host.wanted().norm());
  host.payload.enable(false);
  host.payload.reset();
  CHECK(host.payload.enabled());
  CHECK((host.payload.torque() == Vector7::Zero()));
  CHECK(host.payload.state().time == 0);
  CHECK(host.payload.hand_over().verdict == HandOverVerdict::NotMeasured);
}

TEST_CASE("PayloadCompensation: a frozen torque leaves the payload less certain, and the torque follows", "[host]") {
  Holding host;
  const Sample last = host.arm.tick();
  const double before = host.payload.torque().norm();
  int stale = 0;
  for (int k = 0; k < 20000; ++k) stale += host.payload.update(last) == Status::NotAMeasurement;
  CHECK(stale > 19000);
  CHECK(host.payload.torque().norm() < 0.9 * before);
}

TEST_CASE("PayloadCompensation: bad numbers never become torque", "[host]") {
  Config config;
  config.torque_bound = Vector7::Constant(20);
  Holding host(config);
  std::vector<Sample> bad(6, host.arm.tick());
  bad[0].tau_ext[3] = std::nan("");
  bad[1].jacobian(2, 5) = std::numeric_limits<double>::infinity();
  bad[2].rotation.setZero();
  bad[3].dq[0] = 1e200;
  bad[4].period = -1;
  bad[5].compensation = Vector7::Constant(std::nan(""));
  const Vector7 held = host.payload.torque();
  const double time = host.payload.state().time;
  for (const Sample& sample : bad) {
    CHECK(host.payload.update(sample) != Status::Ok);
    CHECK((host.payload.torque() == held));
  }
  CHECK(host.payload.state().time == time);
  InertialParameters<double> body = host.payload.hand_over().body;
  body.first_moment[1] = std::nan("");
  host.payload.handed_over(body);  // not a load
  CHECK((host.payload.torque() == held));
  host.run(100);
  CHECK((host.payload.torque() - host.wanted()).norm() < 0.03 * host.wanted().norm());
}

/// What a robot reports that carries `load` itself.
Sample with_load(const HeldArm& arm, Sample tick, Vector7& filtered, const Payload<double>& load) {
  filtered += 50 * kPeriod * (-arm.torque(load) - filtered);
  tick.tau_ext += filtered;
  return tick;
}

TEST_CASE("PayloadCompensation: a payload is handed over when the hand has been tilted, and not before", "[host]") {
  Config config;
  config.estimator.sensing = Sensing::LinkSide;
  Holding host(config);
  const HandOver<double> early = host.payload.hand_over();
  CHECK(early.verdict == HandOverVerdict::Uncertain);  // at rest, nothing shows the centre of mass along gravity
  CHECK(early.torque_error > early.torque_limit);
  const Vector7 pose = host.arm.pose();
  for (const double way : {0.5, -0.5, 0.0}) {
    Vector7 goal = pose;
    goal[5] += way;
    goal[4] += way;
    host.arm.move(goal, 1);
    host.run(1500);
  }
  const HandOver<double> judged = host.payload.hand_over();
  CAPTURE(judged.torque_error, to_string(judged.verdict));
  REQUIRE(judged.ready());
  CHECK(std::abs(judged.body.mass - 1) < 0.01);
  CHECK((judged.body.payload().com - kKilogram.com).norm() < 0.02);

  // The robot takes it. The hand is then empty for the estimator, and nothing is added.
  host.payload.handed_over(judged.body);
  CHECK((host.payload.torque() == Vector7::Zero()));
  CHECK(host.payload.state().empty());
  Vector7 filtered = -host.arm.torque(judged.body.payload());
  const auto run = [&](int ticks) {
    for (int k = 0; k < ticks; ++k)
      REQUIRE(host.payload.update(with_load(host.arm, host.arm.tick(), filtered, judged.body.payload())) == Status::Ok);
  };
  run(1000);
  CHECK(host.payload.torque().norm() < 0.3);
  CHECK(host.payload.state().payload.mean[0] < 0.05);
  CHECK_FALSE(host.payload.load_lost());

  // It is dropped: the robot pushes upwards with the load's weight, and the compensation pulls back.
  host.arm.hold({});
  run(40);
  const Vector7 upwards = -host.arm.torque(judged.body.payload());
  CHECK((host.payload.torque() + upwards).norm() < 0.15 * upwards.norm());
  CHECK_FALSE(host.payload.load_lost());
  run(260);
  CHECK(host.payload.load_lost());
  host.payload.load_cleared();
  CHECK_FALSE(host.payload.load_lost());
  host.run(500);
  CHECK(host.payload.torque().norm() < 0.1);
  CHECK(host.payload.state().empty());
}

TEST_CASE("PayloadCompensation: levers may be given, as for joints that are not revolute", "[host]") {
  Config config;
  config.hand_over_error = 1e6;  // anything
  Holding host(config);
  REQUIRE(host.payload.hand_over().ready());
  config.levers = Vector7::Zero();
  (*config.levers)[2] = 5;
  const Holding given(config);
  CHECK(given.payload.hand_over().joint == 2);
}

TEST_CASE("PayloadCompensation: settings out of range are refused by name", "[host]") {
  const auto refused = [](auto change, const char* said) {
    Config config;
    change(config);
    CHECK_THROWS_WITH(Compensation(kPeriod, config), contains(said));
  };
  refused([](Config& c) { c.estimator.rated_payload = -1; }, "EstimatorConfig::rated_payload");
  refused([](Config& c) { c.torque_rate = Vector7::Zero(); }, "CompensationRampConfig::torque_rate: expected > 0");
  refused([](Config& c) { c.torque_bound = Vector7::Zero(); }, "PayloadCompensationConfig::torque_bound: expected > 0");
  refused([](Config& c) { c.fade_time = 0; }, "PayloadCompensationConfig::fade_time: expected > 0 s, got 0");
  refused([](Config& c) { c.hand_over_error = std::nan(""); }, "PayloadCompensationConfig::hand_over_error");
  refused([](Config& c) { c.levers = Vector7::Constant(-1); }, "PayloadCompensationConfig::levers: expected >= 0 m");
  CHECK_THROWS_WITH(Compensation(0.2), contains("Estimator::dt"));
}

TEST_CASE("PayloadCompensation: no call of the loop can throw", "[host]") {
  Compensation* p = nullptr;
  static_assert(noexcept(p->update(std::declval<const Sample&>()))&& noexcept(p->torque())&& noexcept(p->state()));
  static_assert(noexcept(p->enable(true))&& noexcept(p->restart())&& noexcept(p->reset()));
  static_assert(noexcept(p->hand_over())&& noexcept(
      p->handed_over(std::declval<const Compensation::Body&>()))&& noexcept(p->load_cleared()));
  CHECK(p == nullptr);
}

#ifdef RME_COUNTS_ALLOCATIONS
TEST_CASE("PayloadCompensation: allocates nothing after construction", "[host]") {
  auto ticks = rme::testing::life(379);
  rme::testing::spoil(ticks);
  Config config;
  config.torque_bound = Vector7::Constant(8);
  Compensation payload(kPeriod, config);
  double largest = 0;
  const int count = rme::testing::allocations_of([&] {
    for (std::size_t k = 0; k < ticks.size(); ++k) {
      payload.enable(k % 700 > 100);
      (void)payload.update(ticks[k]);
      largest = std::max(largest, payload.torque().norm());
      if (k == 2000) payload.handed_over(payload.hand_over().body);
      if (k == 3000) payload.load_cleared();
      if (k == 4000) payload.restart();
    }
    payload.reset();
  });
  CHECK(count == 0);
  CHECK(largest > 2);
}
#endif

}  // namespace
