// The Python module `synthetic_arm`: a simulated Panda that reports what a real one reports, and a controller that holds
// its pose.
#include <synthetic_arm/panda.hpp>
#include <synthetic_arm/pose_impedance.hpp>
#include <synthetic_arm/synthetic_arm.hpp>

#include "python/arrays.hpp"

namespace rme::python {

namespace {

using namespace rme::examples;
using Joints = JointVector<double, 7>;

Joints joints_of(const py::object& object, const char* field) {
  Joints out;
  read(object, field, out);
  return out;
}
Eigen::Vector3d vector_of(const py::object& object, const char* field) {
  Eigen::Vector3d out;
  read(object, field, out);
  return out;
}

// A new array.
template <typename Derived>
py::array array_of(const Eigen::PlainObjectBase<Derived>& matrix) {
  const auto kept = std::make_shared<Derived>(matrix);
  return view(*kept, kept, true);
}

class Panda {
 public:
  Panda(std::uint64_t seed, bool noise, bool friction, const py::object& q) {
    SyntheticArmConfig<7> config;
    config.seed = seed;
    const SyntheticArmConfig<7> faults = with_typical_faults(panda(), seed);
    if (noise) {
      config.torque_noise = faults.torque_noise;
      config.torque_offset = faults.torque_offset;
    }
    if (friction) config.friction = faults.friction;
    arm_ = std::make_shared<SyntheticArm<7>>(panda(), config, q.is_none() ? panda().ready : joints_of(q, "Panda: q"),
                                             Joints::Zero());
  }
  SyntheticArm<7>& arm() { return *arm_; }
  const SyntheticArm<7>& arm() const { return *arm_; }
  template <typename Derived>
  py::array shown(const Eigen::PlainObjectBase<Derived>& matrix) const {
    return view(matrix, arm_, false);
  }

 private:
  std::shared_ptr<SyntheticArm<7>> arm_;
};

class Controller {
 public:
  explicit Controller(const Panda& panda) : panda_(panda), law_(panda.arm().model(), panda.arm().q()) {}
  Joints torque() const {
    const SyntheticArm<7>& arm = panda_.arm();
    return law_.torque(arm.q(), arm.dq(), arm.kinematics(), arm.dynamics());
  }
  Eigen::Vector3d error() const { return law_.position_error(panda_.arm().kinematics()); }

 private:
  Panda panda_;  // shares the arm
  PoseImpedance<7> law_;
};

void bind_panda(py::module_& module) {
  py::class_<Panda> arm(
      module, "Panda",
      "A simulated Franka Emika Panda with torque sensors and a momentum observer (50 rad/s), at 1 kHz.\n\n"
      "The arrays are read-only NumPy views that change with each step.");
  arm.def(
      py::init<std::uint64_t, bool, bool, const py::object&>(), py::arg("seed") = 1, py::arg("noise") = true,
      py::arg("friction") = false, py::arg("q") = py::none(),
      "seed: of all that is random. noise: white noise and constant offsets of the torque sensors. friction: of the\n"
      "joints, in tau_ext. q: joint positions [rad], (7,); None for a pose in the middle of the workspace.");
  const auto number = [&](const char* name, auto get, const char* doc) {
    arm.def_property_readonly(
        name, [get](const Panda& self) { return self.shown(get(self.arm())); }, doc);
  };
  using Arm = SyntheticArm<7>;
  arm.def_property_readonly(
      "time", [](const Panda& self) { return self.arm().time(); }, "[s]");
  number(
      "q", [](const Arm& a) -> const Joints& { return a.q(); }, "Joint positions [rad], (7,).");
  number(
      "dq", [](const Arm& a) -> const Joints& { return a.dq(); }, "Joint velocities [rad/s], (7,).");
  number(
      "tau_ext", [](const Arm& a) -> const Joints& { return a.tau_ext(); }, "External joint torque [N m], (7,).");
  number(
      "tau_measured", [](const Arm& a) -> const Joints& { return a.tau_measured(); },
      "What the torque sensors measured over the last period [N m], (7,).");
  number(
      "position", [](const Arm& a) -> const Eigen::Vector3d& { return a.kinematics().position; },
      "Of the flange, world axes [m], (3,).");
  number(
      "rotation", [](const Arm& a) -> const Eigen::Matrix3d& { return a.kinematics().rotation; },
      "Flange axes to world axes, (3, 3).");
  number(
      "jacobian", [](const Arm& a) -> const Jacobian<double, 7>& { return a.kinematics().jacobian; },
      "At the flange, world axes, linear rows first, (6, 7).");
  arm.def(
      "step",
      [](Panda& self, const py::object& torque) {
        const Joints command = joints_of(torque, "Panda.step: torque");
        const py::gil_scoped_release unlocked;
        self.arm().step(command);
      },
      py::arg("torque"), "Goes on by 1 ms under a joint torque, gravity included [N m], (7,).");
  arm.def(
      "attach",
      [](Panda& self, double mass, const py::object& com, const py::object& size, double ramp) {
        return self.arm().attach(box(mass, vector_of(com, "Panda.attach: com"), vector_of(size, "Panda.attach: size")),
                                 ramp);
      },
      py::arg("mass"), py::arg("com"), py::arg("size") = py::make_tuple(0.06, 0.06, 0.1), py::arg("ramp") = 0.0,
      "Fixes a box to the flange: mass [kg], centre of mass and edges [m], flange axes, and the time in which it "
      "weighs\n"
      "in [s]. Returns a handle for detach().");
  arm.def(
      "detach", [](Panda& self, int handle, double ramp) { self.arm().detach(handle, ramp); }, py::arg("handle"),
      py::arg("ramp") = 0.0, "Takes a payload off, at once or in `ramp` seconds. An unknown handle changes nothing.");
  arm.def(
      "push",
      [](Panda& self, const py::object& force, const py::object& moment) {
        self.arm().push({vector_of(force, "Panda.push: force"), vector_of(moment, "Panda.push: moment")});
      },
      py::arg("force"), py::arg("moment") = py::make_tuple(0.0, 0.0, 0.0),
      "Pushes at the flange until told otherwise: force [N] and moment [N m], world axes.");
  arm.def_property_readonly(
      "payload",
      [](const Panda& self) {
        const RigidBody body = self.arm().payload();
        return array_of(Vector4<double>(body.mass, body.com[0], body.com[1], body.com[2]));
      },
      "The truth: mass and centre of mass of all that is attached [kg, m, m, m], flange axes, a new array, (4,).");

  py::class_<Controller> controller(module, "PoseImpedance",
                                    "A controller that holds the pose that the arm had when it was made, compliantly\n"
                                    "(180 N/m). Its model has no payload.");
  controller.def(py::init<const Panda&>(), py::arg("arm"), "For this arm, in its present pose.");
  controller.def(
      "torque", [](const Controller& self) { return array_of(self.torque()); },
      "The joint torque for this tick, gravity included [N m]: a new array, (7,).");
  controller.def(
      "position_error", [](const Controller& self) { return array_of(Eigen::Vector3d(self.error())); },
      "Where the flange is, seen from where it should be, world axes [m]: a new array, (3,).");
}

}  // namespace

}  // namespace rme::python

PYBIND11_MODULE(synthetic_arm, module) {
  using namespace rme::python;
  module.doc() =
      "A simulated Franka Emika Panda, to try the module rme on. docs/python.md is the guide.\n\n"
      "SI units; world axes; linear rows of a Jacobian first; the end effector is the flange.";
  bind_panda(module);
  module.def(
      "kinematics",
      [](const py::object& q) {
        const auto pose = panda().kinematics(joints_of(q, "kinematics: q"));
        return py::make_tuple(array_of(pose.position), array_of(pose.rotation), array_of(pose.jacobian));
      },
      py::arg("q"),
      "Position (3,), rotation (3, 3) and Jacobian (6, 7) of a Panda's flange at joint positions q [rad], (7,).");
  module.def(
      "dynamics",
      [](const py::object& q, const py::object& dq) {
        const auto terms = panda().dynamics(joints_of(q, "dynamics: q"), joints_of(dq, "dynamics: dq"));
        return py::make_tuple(array_of(terms.mass_matrix), array_of(terms.coriolis), array_of(terms.coriolis_transpose),
                              array_of(terms.gravity));
      },
      py::arg("q"), py::arg("dq"),
      "M (7, 7), C dq, C^T dq and g (7,) of a Panda without payload at q [rad] and dq [rad/s], (7,).");
}
