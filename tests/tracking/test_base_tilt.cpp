#include <Eigen/Geometry>
#include <cmath>
#include <random>
#include <rme/tracking/base_tilt.hpp>
#include <synthetic_arm/panda.hpp>

#include "support/catch.hpp"

namespace {

using rme::usual_gravity_torque;
using rme::Vector3;

/// Jacobian of an end effector for revolute joints at `joints` about `axes`, world axes.
template <int Dofs>
rme::Jacobian<double, Dofs> jacobian_of(const Eigen::Matrix<double, 3, Dofs>& joints,
                                        const Eigen::Matrix<double, 3, Dofs>& axes, const Vector3<double>& tip) {
  rme::Jacobian<double, Dofs> J;
  for (int j = 0; j < Dofs; ++j) J.col(j) << axes.col(j).cross(tip - joints.col(j)), axes.col(j);
  return J;
}

TEST_CASE("usual_gravity_torque: an arm of such links has it, in any pose", "[base_tilt]") {
  // A planar arm, whose axes are parallel: the joints are where the axes meet its plane.
  const unsigned seed = 1180;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::uniform_real_distribution<double> angle(-3, 3), length(0.1, 0.6);
  for (int k = 0; k < 20; ++k) {
    constexpr int dofs = 3;
    Eigen::Matrix<double, 3, dofs + 1> points = Eigen::Matrix<double, 3, dofs + 1>::Zero();
    for (int j = 0; j < dofs; ++j) {
      const double a = angle(random), l = length(random);
      points.col(j + 1) = points.col(j) + l * Vector3<double>(std::cos(a), 0, std::sin(a));
    }
    const Eigen::Matrix<double, 3, dofs> joints = points.leftCols<dofs>(),
                                         axes = Vector3<double>(0, 1, 0).replicate<1, dofs>();
    // Links of 6, 4 and 2 kg; the torque that holds them against a unit of gravity along an axis.
    Eigen::Matrix<double, dofs, 3> expected = Eigen::Matrix<double, dofs, 3>::Zero();
    for (int link = 0; link < dofs; ++link) {
      const Vector3<double> centre = 0.5 * (points.col(link) + points.col(link + 1));
      for (int j = 0; j <= link; ++j)
        for (int axis = 0; axis < 3; ++axis)
          expected(j, axis) -=
              axes.col(j).dot((centre - joints.col(j)).cross(2.0 * (dofs - link) * Vector3<double>::Unit(axis)));
    }
    CHECK(
        (usual_gravity_torque<double, dofs>(jacobian_of<dofs>(joints, axes, points.col(dofs)), 12) - expected).norm() <
        1e-12);
  }
}

TEST_CASE("usual_gravity_torque: of a Panda, within a third, in random poses", "[base_tilt]") {
  const unsigned seed = 1181;
  CAPTURE(seed);
  std::mt19937 random(seed);
  std::normal_distribution<double> normal;
  const rme::examples::ArmModel<7> panda = rme::examples::panda();
  double wrong = 0, all = 0, mass = 0;
  for (const auto& link : panda.links) mass += link.body.mass;
  for (int k = 0; k < 100; ++k) {
    const rme::JointVector<double, 7> q =
        panda.ready + 0.5 * rme::JointVector<double, 7>::NullaryExpr([&] { return normal(random); });
    const auto usual = usual_gravity_torque<double, 7>(panda.kinematics(q).jacobian, mass);
    for (int axis = 0; axis < 2; ++axis) {  // across gravity
      rme::examples::ArmModel<7> turned = panda;
      turned.gravity_vector = Vector3<double>::Unit(axis);
      const auto truth = turned.dynamics(q, rme::JointVector<double, 7>::Zero()).gravity;
      wrong += (usual.col(axis) - truth).squaredNorm();
      all += truth.squaredNorm();
    }
  }
  CHECK(std::sqrt(wrong / all) < 0.34);
}

}  // namespace
