#include <cmath>
#include <rme/host/runtime_payload_compensation.hpp>
#include <string>
#include <utility>

#include "support/any_joints.hpp"
#include "support/catch.hpp"

namespace {

using namespace rme;
using examples::kFewestJoints;
using examples::kMostJoints;
using rme::testing::sample_at;
using Runtime = RuntimePayloadCompensation<double, kFewestJoints, kMostJoints>;

template <int Dofs>
void check_equal() {
  CAPTURE(Dofs);
  PayloadCompensationConfig<double, Dofs> fixed;
  Runtime::Config config;
  fixed.estimator.rated_payload = config.estimator.rated_payload = 5;
  fixed.fade_time = config.fade_time = 0.1;
  fixed.hand_over_error = config.hand_over_error = 100;
  fixed.torque_bound.emplace();
  fixed.torque_rate.emplace();
  fixed.levers.emplace();
  for (int j = 0; j < Dofs; ++j) {
    (*fixed.torque_bound)[j] = 4 + j;
    (*fixed.torque_rate)[j] = 100 + 30 * j;
    (*fixed.levers)[j] = 0.3 + 0.1 * j;
  }
  config.torque_bound = *fixed.torque_bound;
  config.torque_rate = *fixed.torque_rate;
  config.levers = *fixed.levers;
  PayloadCompensation<double, Dofs> expected(0.001, fixed);
  Runtime payload(Dofs, 0.001, config);
  REQUIRE(payload.joints() == Dofs);
  double largest = 0;
  for (int tick = 0; tick < 1600; ++tick) {
    if (tick % 400 == 300) {
      expected.enable(tick % 800 == 300);
      payload.enable(tick % 800 == 300);
    }
    if (tick == 1200) {
      expected.handed_over(expected.hand_over().body);
      payload.handed_over(payload.hand_over().body);
    }
    if (tick == 1500) {
      expected.load_cleared();
      payload.load_cleared();
    }
    const auto sample = sample_at<Dofs>(tick);
    const Eigen::VectorXd tau_ext = sample.tau_ext, dq = sample.dq;
    const Eigen::Matrix<double, 6, Eigen::Dynamic, Eigen::RowMajor> jacobian = sample.jacobian;
    REQUIRE(expected.update(sample) == payload.update(tau_ext, jacobian, sample.rotation, dq, sample.period));
    REQUIRE((payload.torque() == expected.torque()));
    REQUIRE(payload.enabled() == expected.enabled());
    REQUIRE(payload.load_lost() == expected.load_lost());
    largest = std::max(largest, payload.torque().norm());
  }
  CHECK(largest > 1);
  CHECK((payload.state().payload.mean == expected.state().payload.mean));
  CHECK((payload.state().payload.covariance == expected.state().payload.covariance));
  CHECK(payload.hand_over().verdict == expected.hand_over().verdict);
  CHECK(payload.hand_over().torque_error == expected.hand_over().torque_error);
  payload.expect_change();
  payload.in_contact(true);
  payload.declare_empty();
  CHECK(payload.state().empty());
  CHECK(payload.set_payload(PayloadGaussian<double>::independent({0.4, 0, 0, 0.1}, {0.01, 0.01, 0.01, 0.01})) ==
        Status::Ok);
  CHECK(std::abs(payload.state().payload.mean[0] - 0.4) < 0.02);
  payload.restart();
  CHECK(payload.torque().isZero(0));
  payload.reset();
  CHECK(payload.state().time == 0);
}

template <int Dofs = kFewestJoints>
void check_each() {
  check_equal<Dofs>();
  if constexpr (Dofs < kMostJoints) check_each<Dofs + 1>();
}

TEST_CASE("RuntimePayloadCompensation: for 4 to 8 joints it commands what PayloadCompensation does, to the last bit",
          "[host]") {
  check_each();
}

TEST_CASE("RuntimePayloadCompensation: what does not fit is refused", "[host]") {
  Runtime payload(6, 0.001);
  const auto sample = sample_at<6>(0);
  const Eigen::VectorXd tau = sample.tau_ext, seven = Eigen::VectorXd::Zero(7);
  const Eigen::MatrixXd J = sample.jacobian, wide = Eigen::MatrixXd::Zero(6, 7);
  REQUIRE(payload.update(tau, J, sample.rotation, tau) == Status::Ok);
  CHECK(payload.update(seven, J, sample.rotation, tau) == Status::WrongSize);
  CHECK(payload.update(tau, wide, sample.rotation, tau) == Status::WrongSize);
  CHECK(payload.update(tau, J, sample.rotation, seven) == Status::WrongSize);
  CHECK(payload.update(tau, J, Matrix3<double>::Zero(), tau) == Status::NotARotation);
  CHECK(payload.state().time == 0.001);
  const std::string range = std::to_string(kFewestJoints) + " to " + std::to_string(kMostJoints);
  CHECK_THROWS_WITH(Runtime(3, 0.001), contains("RuntimePayloadCompensation::joints: expected " + range + ", got 3"));
  using Config = Runtime::Config;
  for (const auto& [field, member] :
       {std::pair("torque_rate", &Config::torque_rate), std::pair("torque_bound", &Config::torque_bound),
        std::pair("levers", &Config::levers)}) {
    Config config;
    config.*member = seven;
    CHECK_THROWS_WITH(Runtime(6, 0.001, config), contains(std::string("PayloadCompensationConfig::") + field +
                                                          ": expected 6 numbers, one per joint, got 7"));
  }
}

}  // namespace
