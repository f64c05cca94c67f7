#include <cmath>
#include <random>
#include <rme/control/linear_attractor.hpp>
#include <rme/control/passive_controller.hpp>
#include <rme/control/posture.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using Vector3 = Eigen::Vector3d;

TEST_CASE("damping_matrix: along the flow lambda_1, across it lambda_2", "[passive]") {
  const rme::DirectionalDamping<double> damping = {30, 90, 1e-9};
  const Vector3 f(0.1, -0.2, 0.2);
  const Eigen::Matrix3d D = rme::damping_matrix<double>(f, damping);
  CHECK((D * f - 30 * f).norm() < 1e-12);
  const Vector3 across = f.cross(Vector3(1, 1, 0.3));
  CHECK((D * across - 90 * across).norm() < 1e-12);
}

TEST_CASE("damping_matrix: is smooth through f = 0 from every side and always positive", "[passive]") {
  const rme::DirectionalDamping<double> damping = {10, 100, 0.01};
  CHECK(rme::damping_matrix<double>(Vector3::Zero(), damping) == 100 * Eigen::Matrix3d::Identity());
  // |dD/df| <= |lambda_1 - lambda_2| * max of d/ds (s^2 / (s^2 + f_0^2)) = 90 * 0.65 / f_0, plus turning: below 2 * 90
  // / f_0.
  const unsigned seed = 4311;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  for (int i = 0; i < 500; ++i) {
    const double size = std::pow(10.0, -6 + (i % 7));
    const Vector3 f = size * Vector3{normal(random), normal(random), normal(random)};
    const Vector3 step = 1e-6 * Vector3{normal(random), normal(random), normal(random)};
    const Eigen::Matrix3d D = rme::damping_matrix<double>(f, damping);
    REQUIRE((rme::damping_matrix<double>(f + step, damping) - D).norm() < 2 * 90 / 0.01 * step.norm());
    const oracle::Vector eigenvalues = oracle::eigenvalues(D);
    REQUIRE(eigenvalues[0] > 10 - 1e-9);
    REQUIRE(eigenvalues[2] < 100 + 1e-9);
  }
}

TEMPLATE_TEST_CASE("PassiveController: where f has a direction the force is -D (xdot - f)", "[passive]", float,
                   double) {
  using Scalar = TestType;
  rme::PassiveControllerConfig<Scalar> config;
  config.linear = {40, 70, Scalar(1e-9)};
  config.angular = {4, 7, Scalar(1e-9)};
  rme::PassiveController<Scalar> controller(config);
  rme::Flow<Scalar> position, orientation;
  position.velocity << Scalar(0.2), 0, 0;
  orientation.velocity << 0, 0, Scalar(-0.5);
  rme::Twist<Scalar> twist;
  twist.linear << Scalar(0.1), Scalar(0.3), 0;
  twist.angular << Scalar(0.2), 0, Scalar(-0.1);
  REQUIRE(controller.update(position, orientation, twist) == rme::Status::Ok);
  // By hand: -40 (0.1 - 0.2) = 4 along, -70 * 0.3 = -21 across; -7 * 0.2 = -1.4 and -4 (-0.1 + 0.5) = -1.6.
  const rme::Vector6<Scalar> expected = (rme::Vector6<Scalar>() << 4, -21, 0, Scalar(-1.4), 0, Scalar(-1.6)).finished();
  CHECK((controller.wrench().vector() - expected).norm() < 100 * Eigen::NumTraits<Scalar>::epsilon());
  twist.linear[0] = std::numeric_limits<Scalar>::quiet_NaN();
  CHECK(controller.update(position, orientation, twist) == rme::Status::NonFiniteInput);
  CHECK((controller.wrench().vector() - expected).norm() < 100 * Eigen::NumTraits<Scalar>::epsilon());
}

TEST_CASE("PassiveController: force times velocity is what the potential gives, less dissipation, plus injection",
          "[passive]") {
  // xdot . F_c = -d(lambda_1 V)/dt - dissipated + injected, at f = 0 and everywhere else: the identity behind (35).
  const unsigned seed = 4312;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  rme::PassiveController<double> controller;
  for (int i = 0; i < 200; ++i) {
    const auto any = [&] { return Vector3{normal(random), normal(random), normal(random)}; };
    rme::Flow<double> position, orientation;
    position.conservative = std::pow(10.0, -(i % 8)) * any();
    position.velocity = position.conservative + (i % 2 ? Vector3::Zero().eval() : any());
    orientation.velocity = any();
    const rme::Twist<double> twist{any(), any()};
    REQUIRE(controller.update(position, orientation, twist) == rme::Status::Ok);
    const double potential_rate =
        -60 * twist.linear.dot(position.conservative) - 6 * 0.0;  // default lambda_1: 60 and 6
    const double power = twist.vector().dot(controller.wrench().vector());
    REQUIRE(power ==
            Approx(-potential_rate - controller.dissipated_power() + controller.injected_power()).margin(1e-9));
    REQUIRE(controller.dissipated_power() >= 0);
  }
}

TEST_CASE("Posture: pulls to rest and damps", "[passive]") {
  rme::PostureConfig<double, 2> config;
  config.rest << 0.5, -0.5;
  config.stiffness = 10;
  config.damping = 3;
  const rme::Posture<double, 2> posture(config);
  // 10 (0.5 - 0.2) - 3 * 0.1 = 2.7; 10 (-0.5 - 0) - 3 * (-1) = -2
  CHECK((posture.torque({0.2, 0.0}, {0.1, -1.0}) - Eigen::Vector2d(2.7, -2)).norm() < 1e-14);
  config.damping = -1;
  CHECK_THROWS_WITH((rme::Posture<double, 2>(config)), contains("PostureConfig::damping"));
}

TEST_CASE("PassiveController: damping that is not positive is refused", "[passive]") {
  rme::PassiveControllerConfig<double> config;
  config.angular.across = 0;
  CHECK_THROWS_WITH(rme::PassiveController<double>(config), contains("DirectionalDamping::across"));
}

}  // namespace
