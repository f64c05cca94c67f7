#include <Eigen/Geometry>
#include <cmath>
#include <rme/core/payload.hpp>

#include "support/catch.hpp"

namespace {

TEMPLATE_TEST_CASE("payload_wrench: a kilogram 10 cm along x weighs 9.81 N and turns the flange about y", "[payload]",
                   float, double) {
  using Scalar = TestType;
  const rme::Payload<Scalar> payload{Scalar(1), {Scalar(0.1), Scalar(0), Scalar(0)}};
  const rme::Wrench<Scalar> w = rme::payload_wrench<Scalar>(payload, rme::Matrix3<Scalar>::Identity());
  // By hand: f = (0, 0, -9.81); r x f = (0.1, 0, 0) x (0, 0, -9.81) = (0, 0.981, 0).
  const rme::Vector6<Scalar> expected = (rme::Vector6<Scalar>() << 0, 0, Scalar(-9.81), 0, Scalar(0.981), 0).finished();
  CHECK((w.vector() - expected).norm() < 4 * Eigen::NumTraits<Scalar>::epsilon() * expected.norm());
}

TEST_CASE("payload_wrench: the centre of mass turns with the flange, gravity does not", "[payload]") {
  const rme::Payload<double> payload{2.0, {0.0, 0.0, 0.3}};
  // Flange z along world x: R e_z = e_x, so R r = (0.3, 0, 0), moment (0.3, 0, 0) x (0, 0, -19.62) = (0, 5.886, 0).
  const rme::Matrix3<double> R = Eigen::AngleAxisd(std::acos(0.0), Eigen::Vector3d::UnitY()).toRotationMatrix();
  const rme::Wrench<double> w = rme::payload_wrench(payload, R);
  CHECK((w.force - Eigen::Vector3d(0, 0, -19.62)).norm() < 1e-14);
  CHECK((w.moment - Eigen::Vector3d(0, 5.886, 0)).norm() < 1e-14);
}

TEST_CASE("payload_wrench: gravity is the caller's, as for an arm on a wall", "[payload]") {
  const rme::Payload<double> payload{1.0, {0.0, 0.2, 0.0}};
  const rme::Wrench<double> w =
      rme::payload_wrench<double>(payload, rme::Matrix3<double>::Identity(), Eigen::Vector3d(9.81, 0, 0));
  CHECK((w.force - Eigen::Vector3d(9.81, 0, 0)).norm() < 1e-14);
  CHECK((w.moment - Eigen::Vector3d(0, 0, -1.962)).norm() < 1e-14);  // (0, 0.2, 0) x (9.81, 0, 0)
}

TEST_CASE("Payload, Wrench and Twist keep their order through vector and back", "[payload]") {
  const Eigen::Vector4d theta(1.5, 0.1, -0.2, 0.3);
  CHECK(rme::Payload<double>::from_vector(theta).vector() == theta);
  CHECK(rme::Payload<double>::from_vector(theta).mass == 1.5);
  const rme::Vector6<double> six = (rme::Vector6<double>() << 1, 2, 3, 4, 5, 6).finished();
  CHECK(rme::Wrench<double>::from_vector(six).vector() == six);
  CHECK(rme::Wrench<double>::from_vector(six).moment == Eigen::Vector3d(4, 5, 6));
  CHECK(rme::Twist<double>::from_vector(six).vector() == six);
  CHECK(rme::Twist<double>::from_vector(six).angular == Eigen::Vector3d(4, 5, 6));
}

TEST_CASE("skew: [v]x u equals the cross product", "[types]") {
  const Eigen::Vector3d v(1, -2, 3), u(0.5, 4, -1);
  CHECK((rme::skew(v) * u - v.cross(u)).norm() < 1e-15);
}

}  // namespace
