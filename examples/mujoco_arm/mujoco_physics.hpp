#pragma once
/// MuJoCo behind the Physics interface: the same arm, moved by dynamics that we did not write.
#include <synthetic_arm/physics.hpp>

#include <string>

struct mjModel_;
struct mjData_;

namespace rme::examples {

/// The arm as an MJCF text, for MuJoCo or for a reader: links and joints of the table, a welded body for the payload,
/// and shapes to look at that take no part in the physics.
template <int Dofs>
std::string to_mjcf(const ArmModel<Dofs>& model, const JointFriction<Dofs>& friction);

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
  struct Delete {
    void operator()(mjModel_* model) const;
    void operator()(mjData_* data) const;
  };
  void weld(const RigidBody& payload);

  std::unique_ptr<mjModel_, Delete> model_;
  std::unique_ptr<mjData_, Delete> data_, scratch_;
  RigidBody welded_;
  int payload_, flange_;  // body numbers
};

extern template class MujocoPhysics<6>;
extern template class MujocoPhysics<7>;

}  // namespace rme::examples
