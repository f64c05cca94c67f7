// Estimator and FlangeMotion.
#include <optional>
#include <rme/runtime_estimator.hpp>

#include "precompiled/any_joints.hpp"
#include "python/bindings.hpp"

extern template class rme::Estimator<double, 7>;  // rme_precompiled has it

namespace rme::python {

namespace {

using Motion = FlangeMotion<double>;

struct PythonMotion {
  std::shared_ptr<Motion> values = std::make_shared<Motion>();
};

// The arguments of update(), read while Python's lock is held: other threads may change the arrays afterwards.
struct Sample {
  Vector tau_ext, dq, compensation;
  Columns jacobian;
  Matrix3<double> rotation;
  Axes gravity_torque;
  std::optional<Motion> motion;
  double period;
};

// The field because of which a sample was refused, what was expected, and what came.
std::string reason(Status status, const Sample& in) {
  if (status == Status::NotAMeasurement)
    return "tau_ext: expected a new measurement, got one that is frozen, or zero in all joints";
  if (status == Status::NonFiniteInput) {
    std::string field = implausible("tau_ext", in.tau_ext);
    if (field.empty()) field = implausible("jacobian", in.jacobian);
    if (field.empty()) field = implausible("rotation", in.rotation);
    if (field.empty()) field = implausible("dq", in.dq);
    if (field.empty() && in.motion) {
      field = implausible("motion.angular_velocity", in.motion->angular_velocity);
      if (field.empty()) field = implausible("motion.linear_acceleration", in.motion->linear_acceleration);
      if (field.empty()) field = implausible("motion.angular_acceleration", in.motion->angular_acceleration);
    }
    if (field.empty()) field = implausible("compensation", in.compensation);
    if (field.empty()) field = implausible("gravity_torque", in.gravity_torque);
    if (field.empty()) field = "period: expected 0 to 1048576 s, got " + std::string(py::repr(py::float_(in.period)));
    return field;
  }
  if (status == Status::NotARotation) {
    const Matrix3<double> off = in.rotation.transpose() * in.rotation - Matrix3<double>::Identity();
    return "rotation: expected R^T R within 1e-3 of the identity and a determinant of 1, got " +
           std::string(py::repr(py::float_(off.cwiseAbs().maxCoeff()))) + " away from it and a determinant of " +
           std::string(py::repr(py::float_(in.rotation.determinant())));
  }
  return to_string(status);
}

class PythonEstimator {
 public:
  using Runtime = RuntimeEstimator<double, kFewest, kMost>;

  PythonEstimator(int joints, double dt, const Config& config)
      : estimator_(std::make_shared<Runtime>(joints, dt, config)),
        state_(py::cast(State({estimator_, &estimator_->state()}))),
        contact_(py::cast(Contact({estimator_, &estimator_->contact()}))) {}

  int joints() const { return estimator_->joints(); }
  const py::object& state() const { return state_; }
  const py::object& contact() const { return contact_; }
  const std::string& refusal() const { return refusal_; }

  py::object update(const py::object& tau_ext, const py::object& jacobian, const py::object& rotation,
                    const py::object& dq, const py::object& period, const py::object& motion,
                    const py::object& compensation, const py::object& gravity_torque) {
    const int joints = estimator_->joints();
    Sample in;
    in.tau_ext.resize(joints);
    in.jacobian.resize(6, joints);
    in.dq.resize(joints);
    read(tau_ext, "Estimator.update: tau_ext", in.tau_ext);
    read(jacobian, "Estimator.update: jacobian", in.jacobian);
    read(rotation, "Estimator.update: rotation", in.rotation);
    read(dq, "Estimator.update: dq", in.dq);
    in.period = number(period, "Estimator.update: period");
    if (!motion.is_none()) {
      if (!py::isinstance<PythonMotion>(motion))
        throw py::type_error("Estimator.update: motion: expected FlangeMotion or None, got " + type_text(motion));
      in.motion = *motion.cast<const PythonMotion&>().values;
    }
    if (!compensation.is_none()) {
      in.compensation.resize(joints);
      read(compensation, "Estimator.update: compensation", in.compensation);
    }
    if (!gravity_torque.is_none()) {
      in.gravity_torque.resize(joints, 3);
      read(gravity_torque, "Estimator.update: gravity_torque", in.gravity_torque);
    }
    Status status;
    {
      const InUse mark(in_use_, "Estimator");
      const py::gil_scoped_release unlocked;
      status = estimator_->update(in.tau_ext, in.jacobian, in.rotation, in.dq, in.period, in.motion, in.compensation,
                                  in.gravity_torque);
    }
    if (status == Status::Ok)
      refusal_.clear();
    else
      refusal_ = reason(status, in);
    return PythonEnum<Status>::of(status);
  }

  py::array compensation(const py::object& jacobian, const py::object& rotation, const py::object& out) {
    const int joints = estimator_->joints();
    Columns columns(6, joints);
    Matrix3<double> axes;
    read(jacobian, "Estimator.compensation: jacobian", columns);
    read(rotation, "Estimator.compensation: rotation", axes);
    py::array_t<double> torque = out.is_none() ? py::array_t<double>(joints) : writable(out, joints);
    JointVector<double, Eigen::Dynamic>::MapType result(torque.mutable_data(), joints);
    const InUse mark(in_use_, "Estimator");
    const py::gil_scoped_release unlocked;
    (void)estimator_->compensation(columns, axes, result);  // the sizes are right
    return std::move(torque);
  }

  py::array payload_torque(const py::object& jacobian, const py::object& rotation, const PythonMotion& motion) {
    const int joints = estimator_->joints();
    Columns columns(6, joints);
    Matrix3<double> axes;
    read(jacobian, "Estimator.payload_torque: jacobian", columns);
    read(rotation, "Estimator.payload_torque: rotation", axes);
    py::array_t<double> torque(joints);
    JointVector<double, Eigen::Dynamic>::MapType result(torque.mutable_data(), joints);
    const InUse mark(in_use_, "Estimator");
    const py::gil_scoped_release unlocked;
    (void)estimator_->payload_torque(columns, axes, *motion.values, result);  // the sizes are right
    return std::move(torque);
  }

  // Any of the calls that tell the estimator what the host knows.
  template <typename Call>
  auto tell(const Call& call) {
    const InUse mark(in_use_, "Estimator");
    const py::gil_scoped_release unlocked;
    return call(*estimator_);
  }

 private:
  static py::array_t<double> writable(const py::object& out, int joints) {
    if (!py::array_t<double, py::array::c_style>::check_(out))
      throw py::type_error("Estimator.compensation: out: expected a contiguous array of float64, got " +
                           type_text(out));
    auto array = py::reinterpret_borrow<py::array_t<double>>(out);
    if (array.ndim() != 1 || array.shape(0) != joints)
      throw py::value_error("Estimator.compensation: out: expected shape " + shape_text({joints}) + ", got " +
                            shape_text({array.shape(), array.shape() + array.ndim()}));
    if (!array.writeable())
      throw py::value_error(
          "Estimator.compensation: out: expected an array that can be written to, got a read-only one");
    return array;
  }

  std::shared_ptr<Runtime> estimator_;
  py::object state_, contact_;
  std::string refusal_;
  bool in_use_ = false;
};

void bind_motion(py::module_& module) {
  py::class_<PythonMotion> motion(
      module, "FlangeMotion",
      "How the end effector moves: world axes, at the end-effector origin; all zero at rest.\n\n"
      "The fields are NumPy views: assign to them, or change their entries.");
  motion.def(py::init([](const py::object& angular_velocity, const py::object& linear_acceleration,
                         const py::object& angular_acceleration) {
               PythonMotion self;
               if (!angular_velocity.is_none())
                 read(angular_velocity, "FlangeMotion.angular_velocity", self.values->angular_velocity);
               if (!linear_acceleration.is_none())
                 read(linear_acceleration, "FlangeMotion.linear_acceleration", self.values->linear_acceleration);
               if (!angular_acceleration.is_none())
                 read(angular_acceleration, "FlangeMotion.angular_acceleration", self.values->angular_acceleration);
               return self;
             }),
             py::arg("angular_velocity") = py::none(), py::arg("linear_acceleration") = py::none(),
             py::arg("angular_acceleration") = py::none(), "From arrays of three numbers; None is zero.");
  const auto field = [&](const char* name, const char* full_name, const char* doc, auto get) {
    motion.def_property(
        name, [get](PythonMotion& self) { return view(get(*self.values), self.values, true); },
        [get, full_name](PythonMotion& self, const py::object& value) { read(value, full_name, get(*self.values)); },
        doc);
  };
  field("angular_velocity", "FlangeMotion.angular_velocity", "omega [rad/s]: a NumPy view, (3,).",
        [](Motion& m) -> Vector3<double>& { return m.angular_velocity; });
  field("linear_acceleration", "FlangeMotion.linear_acceleration",
        "Of the origin, gravity not included [m/s^2]: a NumPy view, (3,).",
        [](Motion& m) -> Vector3<double>& { return m.linear_acceleration; });
  field("angular_acceleration", "FlangeMotion.angular_acceleration", "alpha [rad/s^2]: a NumPy view, (3,).",
        [](Motion& m) -> Vector3<double>& { return m.angular_acceleration; });
}

}  // namespace

void bind_estimator(py::module_& module) {
  bind_motion(module);
  py::class_<PythonEstimator> estimator(
      module, "Estimator",
      "Mass, centre of mass and inertia of an unknown payload, and the torque that carries it.\n\n"
      "Call update() for each new sample, then read `state` and compensation(). An estimator belongs to one thread at "
      "a\n"
      "time; the calls release Python's lock (the GIL) while they compute.");
  estimator.def(
      py::init([](const py::object& joints, const py::object& dt, const py::object& config) {
        return std::make_unique<PythonEstimator>(integer(joints, "Estimator: joints"), number(dt, "Estimator: dt"),
                                                 config_of(config));
      }),
      py::arg("joints"), py::arg("dt"), py::arg("config") = py::none(),
      "Makes an estimator that believes in an empty hand.\n\n"
      "joints: of the arm, 4 to 8. dt: nominal control period [s], above 0 and at most 0.1. config: an\n"
      "EstimatorConfig, which is copied; None for the defaults. Raises ValueError naming what is out of range.");
  estimator.def_property_readonly("joints", &PythonEstimator::joints, "The number of joints.");
  estimator.def(
      "update", &PythonEstimator::update, py::arg("tau_ext"), py::arg("jacobian"), py::arg("rotation"), py::arg("dq"),
      py::arg("period") = 0.0, py::arg("motion") = py::none(), py::arg("compensation") = py::none(),
      py::arg("gravity_torque") = py::none(),
      "Advances by one sample.\n\n"
      "tau_ext: external joint torque [N m], (joints,). jacobian: (6, joints), world axes, linear rows first, at\n"
      "the end-effector origin. rotation: (3, 3), end-effector axes to world axes. dq: joint velocity [rad/s],\n"
      "(joints,). period: time since the last sample, if it is measured [s]; 0 means dt. motion: FlangeMotion,\n"
      "if it is known better than from differences of J dq. compensation: torque that was really added to the\n"
      "command for the payload [N m], (joints,); None: what compensation() returned. gravity_torque: the arm's\n"
      "own gravity torque per unit of gravity along each world axis, (joints, 3).\n\n"
      "Returns a Status. If it is not Ok, the sample does not count, the estimate is as it was, and `refusal`\n"
      "says why. Raises ValueError or TypeError for arrays of another shape or of no numbers.");
  estimator.def_property_readonly("state", &PythonEstimator::state,
                                  "The EstimatorState: always the same object, which shows the present estimate.");
  estimator.def_property_readonly("contact", &PythonEstimator::contact,
                                  "The Contact: always the same object, which shows what touches the arm now.");
  estimator.def_property_readonly(
      "refusal", &PythonEstimator::refusal,
      "Which field of the last sample was refused, what was expected and what came; empty if\n"
      "the last status was Ok.");
  estimator.def(
      "compensation", &PythonEstimator::compensation, py::arg("jacobian"), py::arg("rotation"),
      py::arg("out") = py::none(),
      "The joint torque that carries the payload, to be added to the command [N m], (joints,).\n\n"
      "jacobian, rotation: of the present pose; if they are no numbers, those of the last good sample are used.\n"
      "out: an array of float64 to write to, which is returned; None for a new one.");
  estimator.def("payload_torque", &PythonEstimator::payload_torque, py::arg("jacobian"), py::arg("rotation"),
                py::arg("motion"),
                "The joint torque that carries the payload and moves it [N m], (joints,): for a controller that knows\n"
                "the FlangeMotion that it commands. compensation() if that is zero.");
  estimator.def(
      "tare", [](PythonEstimator& self) { self.tell([](auto& e) { e.tare(); }); },
      "Says that what the hand holds now is part of the tool: from then on the payload is what comes in addition.");
  estimator.def(
      "declare_empty", [](PythonEstimator& self) { self.tell([](auto& e) { e.declare_empty(); }); },
      "Says that the hand is empty.");
  estimator.def(
      "set_payload",
      [](PythonEstimator& self, const py::object& payload) {
        if (!py::isinstance<Gaussian>(payload))
          throw py::type_error("Estimator.set_payload: payload: expected PayloadGaussian, got " + type_text(payload));
        const PayloadGaussian<double> values = *payload.cast<const Gaussian&>().values;
        return PythonEnum<Status>::of(self.tell([&](auto& e) { return e.set_payload(values); }));
      },
      py::arg("payload"),
      "Says what is in the hand: a PayloadGaussian with a mass >= 0. Returns a Status; if it is not Ok, nothing "
      "changed.");
  estimator.def(
      "expect_change", [](PythonEstimator& self) { self.tell([](auto& e) { e.expect_change(); }); },
      "Says that the payload is about to change, for example because the gripper closes or opens.");
  estimator.def(
      "in_contact",
      [](PythonEstimator& self, bool contact) { self.tell([contact](auto& e) { e.in_contact(contact); }); },
      py::arg("contact"), "Says whether the arm is in contact. While it is, nothing is learned.");
  estimator.def(
      "reset", [](PythonEstimator& self) { self.tell([](auto& e) { e.reset(); }); },
      "Returns to the state after construction. What was learned of the arm is forgotten, too.");
}

}  // namespace rme::python
