// CompensationRamp and MomentumObserver.
#include <rme/host/runtime_compensation_ramp.hpp>
#include <rme/host/runtime_momentum_observer.hpp>

#include "python/bindings.hpp"

namespace rme::python {

namespace {

using Ramp = RuntimeCompensationRamp<double, kFewest, kMost>;
using Observer = RuntimeMomentumObserver<double, kFewest, kMost>;

// One number for all joints, or one for each.
Vector per_joint(const py::object& value, int joints, const char* field) {
  if (joints < kFewest || joints > kMost) return Vector();  // refused by the part itself
  Vector out(joints);
  if (float_array(value, field).ndim() == 0)
    out.setConstant(number(value, field));
  else
    read(value, field, out);
  return out;
}

class PythonRamp {
 public:
  PythonRamp(int joints, double period, const py::object& torque_rate)
      : ramp_(std::make_shared<Ramp>(joints, period, per_joint(torque_rate, joints, "CompensationRamp.torque_rate"))),
        torque_(view(ramp_->torque(), ramp_, false)) {}
  int joints() const { return ramp_->joints(); }
  const py::array& torque() const { return torque_; }
  const std::string& refusal() const { return refusal_; }
  void reset() { ramp_->reset(); }

  py::object update(const py::object& target) {
    Vector torque(ramp_->joints());
    read(target, "CompensationRamp.update: target", torque);
    Status status;
    {
      const InUse mark(in_use_, "CompensationRamp");
      const py::gil_scoped_release unlocked;
      status = ramp_->update(torque);
    }
    refusal_ = status == Status::Ok ? "" : implausible("target", torque);
    return PythonEnum<Status>::of(status);
  }

 private:
  std::shared_ptr<Ramp> ramp_;
  py::array torque_;
  std::string refusal_;
  bool in_use_ = false;
};

class PythonObserver {
 public:
  PythonObserver(int joints, double dt, const py::object& gain)
      : observer_(std::make_shared<Observer>(joints, dt, per_joint(gain, joints, "MomentumObserver.gain"))),
        tau_ext_(view(observer_->tau_ext(), observer_, false)) {}
  int joints() const { return observer_->joints(); }
  const py::array& tau_ext() const { return tau_ext_; }
  const std::string& refusal() const { return refusal_; }
  void reset() { observer_->reset(); }

  py::object update(const py::object& tau, const py::object& dq, const py::object& mass_matrix,
                    const py::object& coriolis_transpose, const py::object& gravity, const py::object& period) {
    const int joints = observer_->joints();
    Vector torque(joints), velocity(joints), coriolis(joints), weight(joints);
    Square mass(joints, joints);
    read(tau, "MomentumObserver.update: tau", torque);
    read(dq, "MomentumObserver.update: dq", velocity);
    read(mass_matrix, "MomentumObserver.update: mass_matrix", mass);
    read(coriolis_transpose, "MomentumObserver.update: coriolis_transpose", coriolis);
    read(gravity, "MomentumObserver.update: gravity", weight);
    const double h = number(period, "MomentumObserver.update: period");
    Status status;
    {
      const InUse mark(in_use_, "MomentumObserver");
      const py::gil_scoped_release unlocked;
      status = observer_->update(torque, velocity, mass, coriolis, weight, h);
    }
    refusal_.clear();
    if (status != Status::Ok) {
      refusal_ = implausible("tau", torque);
      if (refusal_.empty()) refusal_ = implausible("dq", velocity);
      if (refusal_.empty()) refusal_ = implausible("mass_matrix", mass);
      if (refusal_.empty()) refusal_ = implausible("coriolis_transpose", coriolis);
      if (refusal_.empty()) refusal_ = implausible("gravity", weight);
      if (refusal_.empty())
        refusal_ =
            "period: expected 0 to 1048576 s and no momentum beyond that, got " + std::string(py::repr(py::float_(h)));
    }
    return PythonEnum<Status>::of(status);
  }

 private:
  std::shared_ptr<Observer> observer_;
  py::array tau_ext_;
  std::string refusal_;
  bool in_use_ = false;
};

}  // namespace

void bind_host_parts(py::module_& module) {
  py::class_<PythonRamp> ramp(
      module, "CompensationRamp",
      "Limits the rate of the compensation torque, also when the estimate jumps.\n\n"
      "In a tick, no joint's torque changes by more than torque_rate * period, and all joints move\n"
      "by the same fraction of the way.");
  ramp.def(py::init([](const py::object& joints, const py::object& period, const py::object& torque_rate) {
             return std::make_unique<PythonRamp>(integer(joints, "CompensationRamp: joints"),
                                                 number(period, "CompensationRamp: period"), torque_rate);
           }),
           py::arg("joints"), py::arg("period"), py::arg("torque_rate") = 500.0,
           "joints: of the arm, 4 to 8. period: nominal control period [s], > 0. torque_rate: how fast the torque may\n"
           "change [N m/s], > 0, a number or one per joint. Raises ValueError naming what is out of range.");
  ramp.def_property_readonly("joints", &PythonRamp::joints, "The number of joints.");
  ramp.def(
      "update", &PythonRamp::update, py::arg("target"),
      "Moves the torque towards target [N m], (joints,), by at most one tick's step. Returns a Status; if it is not\n"
      "Ok, the torque is as it was.");
  ramp.def_property_readonly("torque", &PythonRamp::torque,
                             "The compensation torque to command now [N m]: a read-only NumPy view, (joints,).");
  ramp.def_property_readonly("refusal", &PythonRamp::refusal,
                             "Why the last target was refused; empty if the last status was Ok.");
  ramp.def("reset", &PythonRamp::reset,
           "Sets the torque to zero at once: a torque step, only for use while the arm is not commanded.");

  py::class_<PythonObserver> observer(
      module, "MomentumObserver",
      "The external joint torque of an arm that measures its joint torques and knows its own model.\n\n"
      "A generalised-momentum observer: tau_ext after a first-order filter of bandwidth `gain`.");
  observer.def(
      py::init([](const py::object& joints, const py::object& dt, const py::object& gain) {
        return std::make_unique<PythonObserver>(integer(joints, "MomentumObserver: joints"),
                                                number(dt, "MomentumObserver: dt"), gain);
      }),
      py::arg("joints"), py::arg("dt"), py::arg("gain") = 50.0,
      "joints: of the arm, 4 to 8. dt: period for which the observer is made [s], > 0; 0.001 for an Estimator,\n"
      "whatever your period is. gain: K [rad/s], > 0 and at most 1 / dt, a number or one per joint; it is the\n"
      "Estimator's observer_bandwidth. Raises ValueError naming what is out of range.");
  observer.def_property_readonly("joints", &PythonObserver::joints, "The number of joints.");
  observer.def(
      "update", &PythonObserver::update, py::arg("tau"), py::arg("dq"), py::arg("mass_matrix"),
      py::arg("coriolis_transpose"), py::arg("gravity"), py::arg("period") = 0.0,
      "Advances by one period; the first call only records the arm's momentum.\n\n"
      "tau: joint torque over the period that ends now, gravity and compensation included [N m]. dq: joint\n"
      "velocity now [rad/s]. mass_matrix: M(q) now [kg m^2], (joints, joints), without payload.\n"
      "coriolis_transpose: C(q, dq)^T dq now [N m]. gravity: g(q) now [N m]. period: time since the last sample,\n"
      "if it is measured [s]; 0 means dt. Returns a Status; if it is not Ok, the observer is as it was.");
  observer.def_property_readonly(
      "tau_ext", &PythonObserver::tau_ext,
      "The filtered external torque [N m]: a read-only NumPy view, (joints,); zero until the second update.");
  observer.def_property_readonly("refusal", &PythonObserver::refusal,
                                 "Why the last sample was refused; empty if the last status was Ok.");
  observer.def("reset", &PythonObserver::reset, "Returns to the state after construction.");
}

}  // namespace rme::python
