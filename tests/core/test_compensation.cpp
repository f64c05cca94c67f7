#include <array>
#include <cmath>
#include <limits>
#include <random>
#include <rme/core/compensation.hpp>
#include <stdexcept>

#include "support/catch.hpp"

namespace {

using Vector7 = rme::JointVector<double, 7>;

TEMPLATE_TEST_CASE("compensation_torque: a planar arm holds a kilogram half a metre out with m g l", "[compensation]",
                   float, double) {
  using Scalar = TestType;
  // One vertical-plane joint turning about world y at the origin, hand at (0.5, 0, 0): J = (y x p ; y) =
  // (0, 0, -0.5, 0, 1, 0). Gravity turns the joint by +m g l = 4.905 N m; the motor has to give -4.905 N m. With the
  // centre of mass 0.1 m further out along x (R = I) the lever is 0.6 m.
  Eigen::Matrix<Scalar, 6, 1> J;
  J << 0, 0, Scalar(-0.5), 0, 1, 0;
  const rme::Matrix3<Scalar> R = rme::Matrix3<Scalar>::Identity();
  const rme::Payload<Scalar> point{Scalar(1), rme::Vector3<Scalar>::Zero()};
  const rme::Payload<Scalar> further{Scalar(1), {Scalar(0.1), Scalar(0), Scalar(0)}};
  CHECK(rme::compensation_torque<Scalar>(point, J, R)[0] == Approx(-4.905).epsilon(1e-6));
  CHECK(rme::compensation_torque<Scalar>(further, J, R)[0] == Approx(-5.886).epsilon(1e-6));
  const rme::Vector3<Scalar> moon(0, 0, Scalar(-1.62));
  CHECK(rme::compensation_torque<Scalar>(point, J, R, moon)[0] == Approx(-0.81).epsilon(1e-6));
}

TEST_CASE("compensation_torque, compensation_potential: a host's own arrays give what matrices give",
          "[compensation]") {
  const unsigned seed = 20262;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  std::array<double, 42> columns{};  // column by column, as libfranka has it
  std::array<double, 16> pose{};     // 4x4
  for (double& x : columns) x = u(random);
  for (double& x : pose) x = u(random);
  const Eigen::Map<const rme::Jacobian<double, 7>> J(columns.data());
  const Eigen::Map<const Eigen::Matrix4d> T(pose.data());
  const rme::Payload<double> payload{1.2, {0.02, -0.03, 0.1}};
  const rme::Jacobian<double, 7> own_J = J;
  const Eigen::Matrix3d own_R = T.topLeftCorner<3, 3>();
  const Eigen::Vector3d own_p = T.topRightCorner<3, 1>();
  CHECK(
      (rme::compensation_torque(payload, J, T.topLeftCorner<3, 3>()) - rme::compensation_torque(payload, own_J, own_R))
          .norm() < 1e-15);
  CHECK(std::abs(rme::compensation_potential(payload, T.topRightCorner<3, 1>(), T.topLeftCorner<3, 3>()) -
                 rme::compensation_potential(payload, own_p, own_R)) < 1e-15);
}

TEMPLATE_TEST_CASE("CompensationRamp: no tick steps beyond the rate, whatever the estimates", "[compensation]", float,
                   double) {
  using Scalar = TestType;
  const unsigned seed = 20261;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> exponent(-3.0, 6.0), sign(-1.0, 1.0);
  rme::CompensationRamp<Scalar, 7> ramp(Scalar(1e-3));
  for (int tick = 0; tick < 5000; ++tick) {
    rme::JointVector<Scalar, 7> target;
    for (int j = 0; j < 7; ++j)
      target[j] = static_cast<Scalar>(std::copysign(std::pow(10.0, exponent(random)), sign(random)));
    const rme::JointVector<Scalar, 7> before = ramp.torque();
    REQUIRE(ramp.update(target) == rme::Status::Ok);
    const double step = static_cast<double>((ramp.torque() - before).cwiseAbs().maxCoeff());
    const double rounding = static_cast<double>(std::numeric_limits<Scalar>::epsilon() * before.cwiseAbs().maxCoeff());
    REQUIRE(step <= 0.5 * (1 + 4 * static_cast<double>(std::numeric_limits<Scalar>::epsilon())) + 2 * rounding);
  }
}

TEST_CASE("CompensationRamp: a kilogram more in the estimate arrives in the ticks that the rate needs",
          "[compensation]") {
  // 0.7 m lever: 6.867 N m at 0.5 N m per tick: 13 full steps of 0.5 and a 14th of 0.367. Exactly the target from then
  // on.
  rme::CompensationRamp<double, 7> ramp(1e-3);
  Vector7 target = Vector7::Zero();
  target[1] = -6.867;
  target[3] = 3.0;
  for (int tick = 1; tick <= 14; ++tick) {
    CAPTURE(tick);
    REQUIRE(ramp.update(target) == rme::Status::Ok);
    CHECK((ramp.torque() == target) == (tick == 14));
    CHECK(ramp.torque()[1] == Approx(-std::min(0.5 * tick, 6.867)));
    CHECK(ramp.torque()[3] / ramp.torque()[1] == Approx(3.0 / -6.867));  // the direction is kept on the way
  }
}

TEST_CASE("CompensationRamp: what is not finite leaves the torque as it was", "[compensation]") {
  rme::CompensationRamp<double, 7> ramp(1e-3);
  const Vector7 target = Vector7::Constant(0.25);
  REQUIRE(ramp.update(target) == rme::Status::Ok);
  Vector7 bad = target;
  bad[4] = std::numeric_limits<double>::quiet_NaN();
  CHECK(ramp.update(bad) == rme::Status::NonFiniteInput);
  bad[4] = -std::numeric_limits<double>::infinity();
  CHECK(ramp.update(bad) == rme::Status::NonFiniteInput);
  CHECK(ramp.torque() == target);
  bad[4] = -std::numeric_limits<double>::max();
  CHECK(ramp.update(bad) == rme::Status::Ok);
  CHECK((ramp.torque() - target).cwiseAbs().maxCoeff() <= 0.5);
  ramp.reset();
  CHECK(ramp.torque() == Vector7::Zero());
}

TEST_CASE("CompensationRamp: a period or a rate that is not positive is refused by name", "[compensation]") {
  using Ramp = rme::CompensationRamp<double, 7>;
  CHECK_THROWS_AS(Ramp(0.0), std::invalid_argument);
  CHECK_THROWS_AS(Ramp(std::numeric_limits<double>::quiet_NaN()), std::invalid_argument);
  rme::CompensationRampConfig<double, 7> config;
  config.torque_rate[6] = 0;
  CHECK_THROWS_WITH(Ramp(1e-3, config), contains("torque_rate"));
}

static_assert(noexcept(std::declval<rme::CompensationRamp<double, 7>&>().update(std::declval<const Vector7&>())));

}  // namespace
