// The Python module `rme`: the estimator for a number of joints known at run time, its settings and its state, the
// compensation ramp, the momentum observer and the catalogue of known objects.
#include <rme/host/object_catalogue.hpp>
#include <rme/version.hpp>
#include <stdexcept>
#include <utility>

#include "python/bindings.hpp"

namespace rme::python {

namespace {

// The library names C++ classes: "EstimatorConfig::rated_payload: expected ...".
std::string in_python(std::string message) {
  for (std::size_t at; (at = message.find("::")) != std::string::npos;) message.replace(at, 2, ".");
  const std::string runtime = "Runtime";  // Python knows no other number of joints
  return message.compare(0, runtime.size(), runtime) == 0 ? message.substr(runtime.size()) : message;
}

}  // namespace

void bind_enums(py::module_& module) {
  PythonEnum<Status>::define(
      module, "Status",
      "What a call in the control loop reports.\n\n"
      "Ok: done. Any other value: the input was refused, and the object is as it was; its `refusal` says why.\n"
      "NonFiniteInput: a number is NaN, infinite, or larger than any arm reports (2^20). NotARotation: a rotation\n"
      "matrix is not orthonormal with determinant +1. NotAMeasurement: tau_ext is frozen, or exactly zero though\n"
      "its noise rules that out; only the time counts. The others are reported by parts of rme that this module does "
      "not have.",
      {{"Ok", Status::Ok},
       {"NonFiniteInput", Status::NonFiniteInput},
       {"NotARotation", Status::NotARotation},
       {"NotReady", Status::NotReady},
       {"NotPositiveDefinite", Status::NotPositiveDefinite},
       {"NotConverged", Status::NotConverged},
       {"Infeasible", Status::Infeasible},
       {"CapacityExceeded", Status::CapacityExceeded},
       {"WrongSize", Status::WrongSize},
       {"NotAMeasurement", Status::NotAMeasurement}});
  PythonEnum<TorqueSign>::define(module, "TorqueSign",
                                 "Which torque an arm reports as external.\n\n"
                                 "External: what the environment exerts on the arm. Reaction: what the arm exerts on\n"
                                 "the environment, such as libfranka's tau_ext_hat_filtered.",
                                 {{"External", TorqueSign::External}, {"Reaction", TorqueSign::Reaction}});
  PythonEnum<Sensing>::define(
      module, "Sensing",
      "Kinds of torque sensing, and indices of EstimatorState.sensing.\n\n"
      "LinkSide: behind the gears, tau_ext contains no joint friction. JointFriction: tau_ext\n"
      "contains it. RoughModel: friction, and large errors of the arm's model: motor currents,\n"
      "heavy gears, quick motion.",
      {{"LinkSide", Sensing::LinkSide},
       {"JointFriction", Sensing::JointFriction},
       {"RoughModel", Sensing::RoughModel}});
  PythonEnum<Mode>::define(module, "Mode",
                           "What happens to the hand, and indices of EstimatorState.probability.\n\n"
                           "Empty: nothing is in the hand. Held: the payload is the same as before. Pouring: its mass\n"
                           "changes steadily. Disturbed: something else acts on the arm in addition, such as a push.\n"
                           "Changing: the old payload is gone, and the next one is not all there yet.",
                           {{"Empty", Mode::Empty},
                            {"Held", Mode::Held},
                            {"Pouring", Mode::Pouring},
                            {"Disturbed", Mode::Disturbed},
                            {"Changing", Mode::Changing}});
  PythonEnum<EventKind>::define(
      module, "EventKind",
      "Kinds of events.\n\n"
      "Attached: something is in a hand that was empty. Exchanged: the payload is heavier or\n"
      "lighter than before. Removed: the hand is empty again. Filling: the payload's mass has\n"
      "drifted. Pushed: something pushed, and the payload is the same as before. Moved: the\n"
      "payload is as heavy as before, and its centre of mass is elsewhere: slipped or turned.",
      {{"Nothing", EventKind::None},
       {"Attached", EventKind::Attached},
       {"Exchanged", EventKind::Exchanged},
       {"Removed", EventKind::Removed},
       {"Filling", EventKind::Filling},
       {"Pushed", EventKind::Pushed},
       {"Moved", EventKind::Moved}});
  PythonEnum<ContactCause>::define(
      module, "ContactCause",
      "What a contact turned out to be.\n\n"
      "Undecided: it goes on, or is not decided yet. Contact: something touched the arm. Payload:\n"
      "the payload was attached, exchanged, removed or filled. Arm: it lasts, and is taken for an\n"
      "error of the arm's own model or for a small payload.",
      {{"Undecided", ContactCause::Undecided},
       {"Contact", ContactCause::Contact},
       {"Payload", ContactCause::Payload},
       {"Arm", ContactCause::Arm}});
  PythonEnum<Holding>::define(
      module, "Holding",
      "What an ObjectCatalogue can say of a hand.\n\n"
      "CannotTell: no answer is probable enough, or the payload changes just now. Nothing: the hand\n"
      "is empty. Known: it holds one of the objects. Unknown: something that is none of them.",
      {{"CannotTell", Holding::CannotTell},
       {"Nothing", Holding::Nothing},
       {"Known", Holding::Known},
       {"Unknown", Holding::Unknown}});
}

}  // namespace rme::python

PYBIND11_MODULE(rme, module) {
  using namespace rme::python;
  module.doc() =
      "Mass and centre of mass of an unknown payload, from what a torque-controlled arm reports.\n\n"
      "Feed an Estimator each tick with external joint torque, Jacobian, rotation and joint velocities; read its "
      "state\n"
      "and the torque that carries the payload. SI units; world axes; linear rows of a Jacobian first. docs/python.md\n"
      "is the guide.";
  module.attr("__version__") = rme::kVersion;
  py::register_local_exception_translator([](std::exception_ptr thrown) {
    try {
      if (thrown) std::rethrow_exception(std::move(thrown));
    } catch (const std::invalid_argument& error) {
      PyErr_SetString(PyExc_ValueError, in_python(error.what()).c_str());
    }
  });
  bind_enums(module);
  bind_settings(module);
  bind_state(module);
  bind_contact(module);
  bind_estimator(module);
  bind_host_parts(module);
  bind_catalogue(module);
}
