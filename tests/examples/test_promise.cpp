#include <check_arm/held_out.hpp>
#include <check_arm/promise.hpp>
#include <limits>

#include "support/catch.hpp"
#include "swinging_panda.hpp"

namespace {

using namespace rme::examples;
using rme::testing::Swing;
using rme::testing::swinging_panda;

/// Two joints on a circle of 1 rad, once in `turn` seconds, and beside it.
LogPath circle(double seconds, double turn, double centre = 0) {
  LogPath out{{}, Eigen::MatrixXd(static_cast<Eigen::Index>(seconds * 100), 2)};
  for (Eigen::Index i = 0; i < out.q.rows(); ++i) {
    out.t.push_back(0.01 * static_cast<double>(i));
    const double angle = 2 * 3.141592653589793 * out.t.back() / turn;
    out.q.row(i) << centre + std::cos(angle), std::sin(angle);
  }
  return out;
}

double length(const std::vector<LogSpan>& spans) {
  double sum = 0;
  for (const LogSpan& span : spans) sum += span.end - span.begin;
  return sum;
}

/// Least distance of the rest's poses from the part's [rad].
double apart(const std::vector<LogPath>& logs, const HeldOut& part) {
  const auto poses = [&](const std::vector<LogSpan>& spans) {
    std::vector<Eigen::RowVectorXd> out;
    for (const LogSpan& span : spans)
      for (std::size_t i = 0; i < logs[span.log].t.size(); i += 3)
        if (logs[span.log].t[i] >= span.begin && logs[span.log].t[i] < span.end)
          out.emplace_back(logs[span.log].q.row(static_cast<Eigen::Index>(i)));
    return out;
  };
  double least = std::numeric_limits<double>::infinity();
  for (const auto& a : poses(part.part))
    for (const auto& b : poses(part.rest)) least = std::min(least, (a - b).cwiseAbs().maxCoeff());
  return least;
}

TEST_CASE("held_out_parts: no pose of the rest is one of the part", "[check_arm]") {
  struct Case {
    const char* what;
    std::vector<LogPath> logs;
    std::size_t parts;
    double part;  // length [s]
  };
  for (const Case& c :
       {Case{"two logs on different paths: each is a part", {circle(20, 20), circle(12, 12, 3)}, 2, 20},
        {"one log that turns once: halves", {circle(20, 20)}, 2, 10},
        {"one log that turns twice: halves show all poses, so that thirds do it", {circle(36, 18)}, 3, 12},
        {"the same path in two logs: halves of both", {circle(20, 20), circle(20, 20)}, 2, 20}}) {
    CAPTURE(c.what);
    const std::vector<HeldOut> parts = held_out_parts(c.logs);
    REQUIRE(parts.size() == c.parts);
    CHECK(length(parts.front().part) == Approx(c.part).margin(0.1));
    for (const HeldOut& part : parts) {
      CHECK(length(part.rest) >= 5);
      CHECK(apart(c.logs, part) > kOtherPath - 0.02);
    }
  }
}

TEST_CASE("held_out_parts: one path, or logs that are too short, have none", "[check_arm]") {
  CHECK(held_out_parts({circle(60, 5)}).empty());  // a dozen turns
  CHECK(held_out_parts({circle(9, 9)}).empty());   // halves of less than five seconds
  LogPath rests = circle(30, 30);
  rests.q.setZero();
  CHECK(held_out_parts({rests}).empty());
}

TEST_CASE("promise_of: mean, worst of twenty, coverage and the lightest payload that is found", "[check_arm]") {
  HeldOutTest test;
  // 20 payloads of each mass in motion, all of them of the same error but one; those below a tenth are not found.
  for (std::size_t share = 0; share < kShares.size(); ++share)
    for (int i = 0; i < 20; ++i) {
      Trial trial{0, share, kShares[share] * 3, {}};
      const double error = i == 0 ? 1 : 0.1;
      trial.answers.push_back({0, true, share >= 3, error, 0.1, 0.02});
      trial.answers.push_back({1, true, share >= 2 || (share == 1 && i < 18), -error, 0.1, 0.01});
      test.trials.push_back(trial);
    }
  test.trials.push_back({0, 3, 0.3, {{0, false, true, 0.5, 1, 0.1}}});
  const Promise promise = promise_of(test, 3);
  REQUIRE(promise.rows.size() == 3);
  CHECK(!promise.rows[0].moving);
  CHECK(promise.rows[0].answers == 1);
  CHECK(promise.rows[0].coverage == 1);
  CHECK(promise.rows[1].answers == 80);  // of four masses
  CHECK(promise.rows[1].error == Approx(0.145));
  CHECK(promise.rows[1].worst == Approx(1));  // four of 80 are as large
  CHECK(promise.rows[1].coverage == Approx(0.95));
  CHECK(promise.rows[1].centre == Approx(0.02));
  CHECK(promise.lightest[0] == Approx(0.3));
  CHECK(promise.lightest[1] == Approx(0.15));  // 0.06 kg only in 18 of 20
  CHECK(std::isinf(promise.lightest[2]));
  CHECK(promise.coverage == Approx(0.95));
}

TEST_CASE("widened: noise, offset and residual grow, friction stays", "[check_arm]") {
  rme::EstimatorConfig<double, 7> config;
  const auto usual = rme::ArmPrior<double, 7>::of(3);
  const auto arm = widened(config, 2).arm.value();
  CHECK(arm.noise == 2 * usual.noise);
  CHECK(arm.offset == 2 * usual.offset);
  CHECK(arm.residual == 2 * usual.residual);
  CHECK(arm.coulomb == usual.coulomb);
}

TEST_CASE("rehearse: what is simulated onto a quiet arm is found, and nothing else", "[check_arm]") {
  Swing swing;
  swing.noise = 0.02;
  const Log<7> log = swinging_panda(swing);
  ArmSettings<7> settings;
  settings.arm.model = panda();
  const Samples<7> samples = samples_of(log, settings.arm, settings.config);
  HeldOutTest test;
  std::mt19937_64 random(1);
  rehearse(log, samples, settings, 4, 12, 3, random, test);
  CHECK(test.seconds == Approx(8).margin(0.01));
  CHECK(test.false_payloads == 0);
  REQUIRE(test.trials.size() == 3 * kShares.size());
  for (const Trial& trial : test.trials) {
    CHECK(trial.t >= 4);
    CHECK(trial.mass == kShares[trial.share] * 3);
    REQUIRE(trial.answers.size() >= 2);  // a second fits in for each, five seconds do not
    CHECK(trial.answers.size() == (trial.t < 7 ? 3 : 2));
    for (const TrialAnswer& answer : trial.answers) CHECK(answer.moving);
    if (trial.share < kWeighed) continue;
    // 20 mN m of noise at 250 Hz, half a metre, a second: a gram or so, and what inertia and lag cost.
    CHECK(trial.answers[1].found);
    CHECK(std::abs(trial.answers[1].error) < 0.03);
    CHECK(std::abs(trial.answers[1].error) < 4 * trial.answers[1].deviation);
  }
}

}  // namespace
