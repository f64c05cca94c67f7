#include <limits>
#include <random>
#include <rme/core/payload.hpp>
#include <rme/sensing/pseudo_wrench.hpp>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using rme::Status;
template <typename Scalar>
using Jacobian7 = rme::Jacobian<Scalar, 7>;
template <typename Scalar>
using Torque7 = rme::JointVector<Scalar, 7>;

/// Entries uniform in [-1, 1]: full rank with probability one.
template <typename Matrix>
Matrix uniform(std::mt19937_64& random) {
  std::uniform_real_distribution<double> u(-1, 1);
  return Matrix::NullaryExpr([&] { return static_cast<typename Matrix::Scalar>(u(random)); });
}

TEST_CASE("pseudo_wrench: with little damping it is the wrench that made the torque", "[pseudo_wrench]") {
  // J J^T W + lambda W = J J^T w, so W - w = -lambda (J J^T + lambda)^-1 w: at most lambda / s^2 of w, with s the
  // smallest singular value of J.
  const unsigned seed = 50;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 100; ++k) {
    CAPTURE(k);
    const auto J = uniform<Jacobian7<double>>(random);
    const rme::Vector6<double> w = 20 * uniform<rme::Vector6<double>>(random);
    const double s = oracle::singular_values(J)[5];
    const double damping = 1e-9;
    rme::Wrench<double> found;
    REQUIRE(rme::pseudo_wrench(J, J.transpose() * w, damping, found) == Status::Ok);
    CHECK((found.vector() - w).norm() <= (damping + 1e-14) / (s * s) * w.norm());
  }
}

TEMPLATE_TEST_CASE("pseudo_wrench: equals the published formula with an explicit inverse", "[pseudo_wrench]", float,
                   double) {
  const unsigned seed = 51;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 100; ++k) {
    CAPTURE(k);
    const auto J = uniform<Jacobian7<TestType>>(random);
    const Torque7<TestType> tau = 10 * uniform<Torque7<TestType>>(random);
    rme::Wrench<TestType> found;
    REQUIRE(rme::pseudo_wrench(J, tau, TestType(1e-2), found) == Status::Ok);
    const Eigen::MatrixXd Jd = J.template cast<double>();
    const Eigen::MatrixXd A = Jd * Jd.transpose() + 1e-2 * Eigen::MatrixXd::Identity(6, 6);
    const Eigen::VectorXd expected = oracle::inverse(A) * (Jd * tau.template cast<double>());
    // The damping bounds A's condition number by about 1e3: that many units of rounding.
    const double tolerance = 2e3 * static_cast<double>(std::numeric_limits<TestType>::epsilon()) * expected.norm();
    CHECK((found.vector().template cast<double>() - expected).norm() <= tolerance);
  }
}

TEST_CASE("pseudo_wrench: a direction that no joint can feel gets no force", "[pseudo_wrench]") {
  rme::Wrench<double> found{{1, 2, 3}, {4, 5, 6}};
  const Torque7<double> tau = Torque7<double>::Constant(3);
  REQUIRE(rme::pseudo_wrench(Jacobian7<double>::Zero(), tau, 1e-2, found) == Status::Ok);
  CHECK(found.vector() == rme::Vector6<double>::Zero());

  // One joint about z at lever (1, 0, 0): it feels f_y + n_z, J J^T has the one eigenvalue 2 along (0,1,0, 0,0,1), so
  // W = 3 / (2 + 0.01) along it.
  Eigen::Matrix<double, 6, 1> J;
  J << 0, 1, 0, 0, 0, 1;
  REQUIRE(rme::pseudo_wrench(J, rme::JointVector<double, 1>(3.0), 1e-2, found) == Status::Ok);
  CHECK((found.vector() - 3 / 2.01 * J).norm() < 1e-12);
}

TEST_CASE("pseudo_wrench: bad input is named and leaves the wrench as it was", "[pseudo_wrench]") {
  std::mt19937_64 random(52);
  const double nan = std::numeric_limits<double>::quiet_NaN(), infinity = std::numeric_limits<double>::infinity();
  const auto J = uniform<Jacobian7<double>>(random);
  const auto tau = uniform<Torque7<double>>(random);
  rme::Wrench<double> found{{1, 2, 3}, {4, 5, 6}};
  const rme::Vector6<double> before = found.vector();
  for (const double bad : {nan, infinity, -infinity, std::numeric_limits<double>::max()}) {
    CAPTURE(bad);
    Jacobian7<double> bad_J = J;
    bad_J(4, 5) = bad;
    CHECK(rme::pseudo_wrench(bad_J, tau, 1e-2, found) == Status::NonFiniteInput);
    Torque7<double> bad_tau = tau;
    bad_tau.setConstant(bad);
    CHECK(rme::pseudo_wrench(2 * J, bad_tau, 1e-2, found) == Status::NonFiniteInput);
  }
  for (const double damping : {0.0, -1e-3}) {
    CAPTURE(damping);
    CHECK(rme::pseudo_wrench(J, tau, damping, found) == Status::NotPositiveDefinite);
  }
  CHECK(rme::pseudo_wrench(J, tau, nan, found) != Status::Ok);
  CHECK(found.vector() == before);
}

TEST_CASE("pseudo_wrench, in_end_effector_axes: a host's own arrays give what matrices give", "[pseudo_wrench]") {
  const unsigned seed = 51;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const auto rows = uniform<Eigen::Matrix<double, 6, 7, Eigen::RowMajor>>(random);  // row by row, as KDL's are
  const auto tau = uniform<Torque7<double>>(random);
  const auto R = uniform<Eigen::Matrix3d>(random);
  const Jacobian7<double> own = rows;
  rme::Wrench<double> from_map, from_matrix;
  REQUIRE(rme::pseudo_wrench(Eigen::Map<const Eigen::Matrix<double, 6, 7, Eigen::RowMajor>>(rows.data()),
                             Eigen::Map<const Torque7<double>>(tau.data()), 0.01, from_map) == Status::Ok);
  REQUIRE(rme::pseudo_wrench(own, tau, 0.01, from_matrix) == Status::Ok);
  CHECK((from_map.vector() - from_matrix.vector()).norm() < 1e-12 * from_matrix.vector().norm());
  CHECK(rme::in_end_effector_axes(from_matrix, Eigen::Map<const Eigen::Matrix3d>(R.data())).vector() ==
        rme::in_end_effector_axes(from_matrix, R).vector());
}

TEST_CASE("in_end_effector_axes: of a payload at rest it is the weight and its lever as the hand sees them",
          "[pseudo_wrench]") {
  // R^T (m g) = m g' and R^T ((R r) x (m g)) = r x (m g'), with g' = R^T g: no position, and of the orientation only
  // where "down" is. Turning the arm about the vertical therefore changes nothing.
  const unsigned seed = 53;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  const rme::Payload<double> payload{1.3, {0.05, -0.02, 0.11}};
  const Eigen::Vector3d g = rme::standard_gravity<double>();
  for (int k = 0; k < 20; ++k) {
    CAPTURE(k);
    const Eigen::Matrix3d R = Eigen::Quaterniond(uniform<Eigen::Vector4d>(random)).normalized().toRotationMatrix();
    const Eigen::Matrix3d turned = Eigen::AngleAxisd(0.3 * k, Eigen::Vector3d::UnitZ()).toRotationMatrix() * R;
    const Eigen::Vector3d down = R.transpose() * g;
    rme::Vector6<double> expected;
    expected << 1.3 * down, payload.com.cross(1.3 * down);
    for (const Eigen::Matrix3d& rotation : {R, turned}) {
      const auto J = uniform<Jacobian7<double>>(random);
      rme::Wrench<double> world;
      const Torque7<double> tau = J.transpose() * rme::payload_wrench(payload, rotation).vector();
      REQUIRE(rme::pseudo_wrench(J, tau, 1e-13, world) == Status::Ok);
      CHECK((rme::in_end_effector_axes(world, rotation).vector() - expected).norm() < 1e-7);
    }
  }
}

static_assert(noexcept(rme::pseudo_wrench(std::declval<const Jacobian7<double>&>(),
                                          std::declval<const Torque7<double>&>(), 1e-2,
                                          std::declval<rme::Wrench<double>&>())));
static_assert(noexcept(rme::in_end_effector_axes(std::declval<const rme::Wrench<double>&>(),
                                                 std::declval<const rme::Matrix3<double>&>())));

}  // namespace
