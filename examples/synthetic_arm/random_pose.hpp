#pragma once
/// Poses that a Panda may well be asked to hold.
#include <rme/core/types.hpp>
#include <synthetic_arm/panda.hpp>

namespace rme::examples {

/// Whether each of J's singular values is above `least`: none of them is 0 but in a singular pose.
bool is_mobile(const Jacobian<double, 7>& jacobian, double least);

/// Joint angles anywhere but near a limit or a singular pose, which no controller would hold [rad].
/// @param uniform  callable (double low, double high) -> double: a random number in between
template <typename Uniform>
JointVector<double, 7> random_panda_pose(Uniform&& uniform) {
  using Vector7 = JointVector<double, 7>;
  const Vector7 reach = (Vector7() << 1.6, 1.05, 1.7, 1.0, 1.3, 0.9, 1.9).finished();
  const Vector7 middle = (Vector7() << 0, 0.05, 0, -1.65, 0, 1.8, 0).finished();
  while (true) {
    Vector7 q;
    for (int i = 0; i < 7; ++i) q[i] = middle[i] + uniform(-reach[i], reach[i]);
    if (is_mobile(panda().kinematics(q).jacobian, 0.1)) return q;
  }
}

}  // namespace rme::examples
