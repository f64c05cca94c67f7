#pragma once
/// MuJoCo behind the Physics interface: the same arm, moved by dynamics that we did not write.
#include <cstddef>
#include <mujoco_arm/mjcf.hpp>

namespace rme::examples {

/// Runge-Kutta 4 too, but MuJoCo's, with its soft Coulomb friction set so stiff that a joint held below its breakaway
/// torque creeps 1e-6 rad/s. With friction, steps above half a millisecond are too coarse for it.
template <int Dofs>
class MujocoPhysics final : public Physics<Dofs> {
 public:
  using Vector = JointVector<double, Dofs>;

  /// @throws std::runtime_error with MuJoCo's own words if it refuses the arm
  MujocoPhysics(const ArmModel<Dofs>& model, const JointFriction<Dofs>& friction);
  static std::unique_ptr<Physics<Dofs>> make(const ArmModel<Dofs>& model, const JointFriction<Dofs>& friction) {
    return std::make_unique<MujocoPhysics>(model, friction);
  }

  /// @return the friction torque at the step's end, rather than its average
  Vector step(double h, const Load<Dofs>& load, JointState<Dofs>& state) override;

 private:
  void weld(const RigidBody& payload);

  MujocoModel model_;
  MujocoData data_, scratch_;
  RigidBody welded_;
  std::ptrdiff_t payload_, flange_;  // body numbers
};

extern template class MujocoPhysics<6>;
extern template class MujocoPhysics<7>;

}  // namespace rme::examples
