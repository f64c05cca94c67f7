#include "synthetic_arm/arm_model.hpp"

#include <Eigen/Geometry>

namespace rme::examples {

RigidBody operator+(const RigidBody& a, const RigidBody& b) {
  RigidBody sum;
  sum.mass = a.mass + b.mass;
  if (!(sum.mass > 0)) return sum;
  sum.com = (a.mass * a.com + b.mass * b.com) / sum.mass;
  sum.inertia = a.inertia + b.inertia;
  for (const RigidBody* body : {&a, &b}) {
    const Eigen::Matrix3d lever = skew(body->com - sum.com);
    sum.inertia -= body->mass * lever * lever;
  }
  return sum;
}

RigidBody moved(const RigidBody& body, const Eigen::Vector3d& offset, const Eigen::Matrix3d& rotation) {
  return {body.mass, rotation * body.com + offset, rotation * body.inertia * rotation.transpose()};
}

RigidBody operator*(double factor, const RigidBody& body) {
  return {factor * body.mass, body.com, factor * body.inertia};
}

RigidBody box(double mass, const Eigen::Vector3d& com, const Eigen::Vector3d& size) {
  const Eigen::Vector3d s = size.cwiseAbs2();
  return {mass, com, (mass / 12 * Eigen::Vector3d(s[1] + s[2], s[0] + s[2], s[0] + s[1])).asDiagonal()};
}

Link link(const Eigen::Vector3d& offset, double roll, double mass, const Eigen::Vector3d& com,
          const std::array<double, 6>& inertia) {
  const auto& [xx, yy, zz, xy, xz, yz] = inertia;
  Eigen::Matrix3d tensor;
  tensor << xx, xy, xz, xy, yy, yz, xz, yz, zz;
  return {offset, Eigen::AngleAxisd(roll, Eigen::Vector3d::UnitX()).toRotationMatrix(), {mass, com, tensor}};
}

}  // namespace rme::examples
