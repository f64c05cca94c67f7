#include <random>
#include <rme/host/runtime_compensation_ramp.hpp>

#include "support/catch.hpp"

namespace {

using namespace rme;

template <int Dofs>
void check_equal() {
  CAPTURE(Dofs);
  std::mt19937 random(381);
  std::normal_distribution<double> normal(0, 5);
  CompensationRampConfig<double, Dofs> config;
  for (int j = 0; j < Dofs; ++j) config.torque_rate[j] = 300 + 70 * j;
  CompensationRamp<double, Dofs> fixed(0.001, config);
  RuntimeCompensationRamp<double> ramp(Dofs, 0.001, config.torque_rate);
  RuntimeCompensationRamp<double> plain(Dofs, 0.001);
  CompensationRamp<double, Dofs> fixed_plain(0.001);
  REQUIRE(ramp.joints() == Dofs);
  Eigen::VectorXd target(Dofs);
  bool differed = false;
  for (int tick = 0; tick < 500; ++tick) {
    if (tick % 20 == 0) target = Eigen::VectorXd::NullaryExpr(Dofs, [&] { return normal(random); });
    if (tick == 333) target[0] = std::nan("");
    if (tick == 334) target[0] = 1;
    const JointVector<double, Dofs> same = target;
    REQUIRE(ramp.update(target) == fixed.update(same));
    REQUIRE(plain.update(target) == fixed_plain.update(same));
    REQUIRE((ramp.torque() == fixed.torque()));
    REQUIRE((plain.torque() == fixed_plain.torque()));
    differed = differed || ramp.torque() != plain.torque();
  }
  CHECK(ramp.torque().norm() > 1);
  CHECK(differed);  // by their rates
  ramp.reset();
  CHECK(ramp.torque().isZero(0));
}

TEST_CASE("RuntimeCompensationRamp: for 1 to 8 joints it is CompensationRamp, to the last bit", "[host]") {
  check_equal<1>();
  check_equal<4>();
  check_equal<7>();
  check_equal<8>();
}

TEST_CASE("RuntimeCompensationRamp: another size is refused, and changes nothing", "[host]") {
  RuntimeCompensationRamp<double> ramp(6, 0.001);
  REQUIRE(ramp.update(Eigen::VectorXd::Constant(6, 0.1)) == Status::Ok);
  CHECK(ramp.update(Eigen::VectorXd::Constant(7, 3)) == Status::WrongSize);
  CHECK(ramp.update(Eigen::RowVectorXd::Constant(6, 3)) == Status::WrongSize);
  CHECK((ramp.torque() == Eigen::VectorXd::Constant(6, 0.1)));
  CHECK_THROWS_WITH(RuntimeCompensationRamp<double>(9, 0.001),
                    contains("RuntimeCompensationRamp::joints: expected 1 to 8, got 9"));
  CHECK_THROWS_WITH(RuntimeCompensationRamp<double>(0, 0.001), contains("got 0"));
  CHECK_THROWS_WITH(RuntimeCompensationRamp<double>(6, 0.0), contains("CompensationRamp::period"));
  CHECK_THROWS_WITH(RuntimeCompensationRamp<double>(6, 0.001, Eigen::VectorXd::Ones(5)),
                    contains("CompensationRampConfig::torque_rate: expected 6 numbers, one per joint, got 5"));
}

}  // namespace
