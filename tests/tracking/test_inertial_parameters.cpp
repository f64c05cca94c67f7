#include <Eigen/Core>
#include <random>
#include <rme/tracking/inertial_parameters.hpp>
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/six_joint_arm.hpp>
#include <vector>

#include "support/catch.hpp"
#include "support/linear_algebra.hpp"

namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;
using rme::FlangeMotion;
using Parameters = rme::InertialParameters<double>;

Vector3d gaussian3(std::mt19937_64& random) {
  std::normal_distribution<double> n;
  return {n(random), n(random), n(random)};
}

Matrix3d random_rotation(std::mt19937_64& random) {
  std::uniform_real_distribution<double> angle(-3, 3);
  return Eigen::AngleAxisd(angle(random), gaussian3(random).normalized()).toRotationMatrix();
}

/// A box of 1 to 20 cm, turned and off the origin.
rme::examples::RigidBody random_box(std::mt19937_64& random) {
  std::uniform_real_distribution<double> u(0, 1);
  const Vector3d size(0.01 + 0.19 * u(random), 0.01 + 0.19 * u(random), 0.01 + 0.19 * u(random));
  auto body = rme::examples::box(0.1 + 2 * u(random), 0.1 * gaussian3(random), size);
  const Matrix3d turn = random_rotation(random);
  body.inertia = turn * body.inertia * turn.transpose();
  return body;
}

Parameters parameters_of(const rme::examples::RigidBody& body) {
  return Parameters::of_body({body.mass, body.com}, body.inertia);
}

TEST_CASE("inertial_wrench_regressor: a carried box pushes back as Newton and Euler say", "[inertial]") {
  const unsigned seed = 500;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 200; ++k) {
    CAPTURE(k);
    const auto body = random_box(random);
    const Matrix3d R = random_rotation(random);
    const Vector3d g = 9.81 * gaussian3(random).normalized();
    const FlangeMotion<double> motion{2 * gaussian3(random), 5 * gaussian3(random), 10 * gaussian3(random)};
    const Vector3d &w = motion.angular_velocity, &alpha = motion.angular_acceleration;
    // World axes: the centre's acceleration, Newton for the force, Euler about the centre, then moved to the flange.
    const Vector3d p = R * body.com;
    const Vector3d at_centre = motion.linear_acceleration + alpha.cross(p) + w.cross(w.cross(p));
    const Matrix3d I = R * body.inertia * R.transpose();
    const Vector3d force = body.mass * (g - at_centre);
    rme::Vector6<double> expected;
    expected << force, p.cross(force) - I * alpha - w.cross(I * w);
    const auto Y = rme::inertial_wrench_regressor<double>(R, g, motion);
    CHECK((Y * parameters_of(body).vector() - expected).norm() < 1e-12 * (1 + expected.norm()));
  }
}

TEST_CASE("inertial_wrench_regressor: ten numbers are all that a cloud of point masses shows", "[inertial]") {
  const unsigned seed = 501;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> mass(0.01, 0.2);
  for (int k = 0; k < 50; ++k) {
    CAPTURE(k);
    const Matrix3d R = random_rotation(random);
    const Vector3d g(0, 0, -9.81);
    const FlangeMotion<double> motion{2 * gaussian3(random), 5 * gaussian3(random), 10 * gaussian3(random)};
    const Vector3d &w = motion.angular_velocity, &alpha = motion.angular_acceleration;
    Parameters sum;
    rme::Vector6<double> expected = rme::Vector6<double>::Zero();
    for (int i = 0; i < 6; ++i) {
      const double m = mass(random);
      const Vector3d r = 0.2 * gaussian3(random), p = R * r;
      sum.mass += m;
      sum.first_moment += m * r;
      sum.inertia += m * (r.squaredNorm() * Matrix3d::Identity() - r * r.transpose());
      const Vector3d force = m * (g - motion.linear_acceleration - alpha.cross(p) - w.cross(w.cross(p)));
      expected.head<3>() += force;
      expected.tail<3>() += p.cross(force);
    }
    const auto Y = rme::inertial_wrench_regressor<double>(R, g, motion);
    CHECK((Y * sum.vector() - expected).norm() < 1e-12 * (1 + expected.norm()));
    CHECK(sum.physically_consistent());
  }
}

template <int Dofs>
void check_on_arm(const rme::examples::ArmModel<Dofs>& arm, unsigned seed) {
  CAPTURE(arm.name, seed);
  using Vector = rme::JointVector<double, Dofs>;
  std::mt19937_64 random(seed);
  std::uniform_real_distribution<double> u(-1, 1);
  const auto vector = [&](double scale) { return Vector(Vector::NullaryExpr([&] { return scale * u(random); })); };
  for (int k = 0; k < 30; ++k) {
    CAPTURE(k);
    const auto body = random_box(random);
    const Vector q = arm.ready + vector(1), dq = vector(2), ddq = vector(5);
    // With the payload M' ddq + C' dq + g' = tau, and without it M ddq + C dq + g = tau + tau_ext.
    const auto with = arm.dynamics(q, dq, body), without = arm.dynamics(q, dq);
    const Vector tau_ext = (without.mass_matrix - with.mass_matrix) * ddq + without.coriolis - with.coriolis +
                           without.gravity - with.gravity;
    // The flange's acceleration is J ddq + dJ/dt dq, with dJ/dt by differences of fourth order along the motion.
    const auto at = arm.kinematics(q);
    const auto twist = [&](double t) { return rme::Vector6<double>(arm.kinematics(q + t * dq).jacobian * dq); };
    const double h = 1e-3;
    const rme::Vector6<double> drift = (8 * (twist(h) - twist(-h)) - (twist(2 * h) - twist(-2 * h))) / (12 * h);
    const rme::Vector6<double> acceleration = at.jacobian * ddq + drift;
    const FlangeMotion<double> motion{at.jacobian.template bottomRows<3>() * dq, acceleration.head<3>(),
                                      acceleration.tail<3>()};
    const auto Y = rme::inertial_wrench_regressor<double>(at.rotation, arm.gravity_vector, motion);
    const Vector predicted = at.jacobian.transpose() * (Y * parameters_of(body).vector());
    CHECK((predicted - tau_ext).norm() < 1e-9 * (1 + tau_ext.norm()));
  }
}

TEST_CASE("inertial_wrench_regressor: J^T Y phi is what a payload changes in the dynamics of a whole arm",
          "[inertial]") {
  check_on_arm<7>(rme::examples::panda(), 502);
  check_on_arm<6>(rme::examples::six_joint_arm(), 503);
}

TEST_CASE("inertial_wrench_regressor: at rest it is the payload's wrench, whatever the inertia", "[inertial]") {
  const unsigned seed = 504;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 50; ++k) {
    CAPTURE(k);
    const auto body = random_box(random);
    const Matrix3d R = random_rotation(random);
    const Vector3d g = 9.81 * gaussian3(random).normalized();
    const auto Y = rme::inertial_wrench_regressor<double>(R, g, {});
    const auto expected = rme::payload_wrench<double>({body.mass, body.com}, R, g).vector();
    CHECK((Y * parameters_of(body).vector() - expected).norm() < 1e-13 * expected.norm());
    CHECK(Y.rightCols<6>().isZero(0));
  }
}

TEST_CASE("InertialParameters: of_body moves the inertia by the parallel axes and back", "[inertial]") {
  const unsigned seed = 505;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 50; ++k) {
    CAPTURE(k);
    const auto body = random_box(random);
    const Parameters phi = parameters_of(body);
    // Huygens and Steiner in components: I = I_c + m (|c|^2 1 - c c^T).
    const Matrix3d steiner =
        body.mass * (body.com.squaredNorm() * Matrix3d::Identity() - body.com * body.com.transpose());
    CHECK((phi.inertia - body.inertia - steiner).norm() < 1e-14);
    CHECK((phi.inertia_about_com() - body.inertia).norm() < 1e-14);
    CHECK((phi.payload().com - body.com).norm() < 1e-14);
    CHECK(phi.payload().mass == body.mass);
    const Parameters back = Parameters::from_vector(phi.vector());
    CHECK(back.mass == phi.mass);
    CHECK(back.first_moment == phi.first_moment);
    CHECK((back.inertia - phi.inertia).norm() < 1e-16);
  }
  CHECK(Parameters().payload().mass == 0);
  CHECK(Parameters().payload().com.isZero(0));
}

TEST_CASE("InertialParameters: the ten numbers stand in the order that is documented", "[inertial]") {
  Parameters phi;
  phi.mass = 1;
  phi.first_moment << 2, 3, 4;
  phi.inertia << 5, 6, 7, 6, 8, 9, 7, 9, 10;
  for (int i = 0; i < rme::kInertial; ++i) CHECK(phi.vector()[i] == i + 1);
}

TEST_CASE("InertialParameters: boxes are consistent, a violated triangle inequality is not", "[inertial]") {
  const unsigned seed = 506;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 50; ++k) {
    CAPTURE(k);
    const auto body = random_box(random);
    CHECK(parameters_of(body).physically_consistent());
    // The largest principal moment of any body is at most the sum of the others: 1 % above it is no body.
    const Matrix3d axes = random_rotation(random);
    const auto with_moments = [&](double a, double b, double c) {
      return Parameters::of_body({body.mass, body.com}, axes * Vector3d(a, b, c).asDiagonal() * axes.transpose());
    };
    CHECK_FALSE(with_moments(1e-3, 2e-3, 3.03e-3).physically_consistent());
    CHECK_FALSE(with_moments(3.03e-3, 1e-3, 2e-3).physically_consistent());
    CHECK(with_moments(1e-3, 2e-3, 2.97e-3).physically_consistent());
    CHECK_FALSE(with_moments(-1e-3, 2e-3, 2e-3).physically_consistent());
  }
  CHECK_FALSE(Parameters().physically_consistent());
  CHECK_FALSE(Parameters::of_body({-1, {0, 0, 0.1}}, Matrix3d::Identity()).physically_consistent());
}

TEST_CASE("InertialParameters: made_consistent keeps mass and centre, and boxes as they are", "[inertial]") {
  const unsigned seed = 507;
  CAPTURE(seed);
  std::mt19937_64 random(seed);
  for (int k = 0; k < 100; ++k) {
    CAPTURE(k);
    const auto body = random_box(random);
    const Matrix3d noise = 0.02 * Matrix3d::NullaryExpr([&] { return std::normal_distribution<double>()(random); });
    const Parameters bad = Parameters::of_body({body.mass, body.com}, noise + noise.transpose());
    const double radius = 0.01;
    const Parameters good = bad.made_consistent(radius);
    CHECK(good.physically_consistent());
    CHECK(good.mass == bad.mass);
    CHECK((good.payload().com - body.com).norm() < 1e-14);
    // The density's second moment about the centre, from what was not negative in it: eigenvalues one by one.
    const auto second_moment = [](const Parameters& phi) {
      const Matrix3d I = phi.inertia_about_com();
      return Matrix3d(0.5 * I.trace() * Matrix3d::Identity() - I);
    };
    const Vector3d before = oracle::eigenvalues(second_moment(bad));
    const Vector3d after = oracle::eigenvalues(second_moment(good));
    for (int i = 0; i < 3; ++i)
      CHECK(after[i] == Approx(std::max(before[i], body.mass * radius * radius)).margin(1e-10));
    // A box thicker than the radius of gyration asked for is left alone.
    const Parameters box = parameters_of(rme::examples::box(1, body.com, {0.1, 0.12, 0.2}));
    CHECK((box.made_consistent(radius).vector() - box.vector()).norm() < 1e-14);
  }
  CHECK(Parameters().made_consistent(0.01).vector().isZero(0));
}

}  // namespace
