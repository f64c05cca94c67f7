// EstimatorState, and what it is made of: PayloadGaussian, InertialGaussian, Event.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <string>

#include "python/bindings.hpp"

namespace rme::python {

namespace {

// Mean and covariance of phi, as views of a state.
struct Inertial {
  py::array mean, covariance;
};

/// A mean to the second digit of its standard deviation, and that.
std::string text_of(double mean, double deviation) {
  const bool known = deviation > 1e-9 && std::isfinite(deviation);
  const int decimals = known ? std::max(0, 1 - static_cast<int>(std::floor(std::log10(deviation)))) : 9;
  char text[80];
  std::snprintf(text, sizeof text, "%.*f +- %.2g", decimals, mean, deviation);
  return text;
}

std::string text_of(const PayloadGaussian<double>& payload) {
  const Vector4<double> std = payload.standard_deviation();
  const auto entry = [&](int i) { return text_of(payload.mean[i], std[i]); };
  return entry(0) + " kg at (" + entry(1) + ", " + entry(2) + ", " + entry(3) + ") m";
}

py::array copy_of(const Vector4<double>& vector) {
  return py::array_t<double>(4, vector.data());
}

void bind_parts(py::module_& module) {
  py::class_<Gaussian> gaussian(
      module, "PayloadGaussian",
      "A Gaussian over mass and centre of mass (m, r_x, r_y, r_z) [kg, m, m, m], end-effector\n"
      "axes, from the end-effector origin.");
  const auto made = [](const PayloadGaussian<double>& values) {
    const auto owner = std::make_shared<PayloadGaussian<double>>(values);
    return Gaussian(*owner, owner, true);
  };
  gaussian.def(py::init([made](const py::object& mean, const py::object& covariance) {
                 PayloadGaussian<double> values;
                 read(mean, "PayloadGaussian.mean", values.mean);
                 read(covariance, "PayloadGaussian.covariance", values.covariance);
                 return made(values);
               }),
               py::arg("mean"), py::arg("covariance"), "From a mean (4,) and a covariance (4, 4); they are copied.");
  gaussian.def_static(
      "independent",
      [made](const py::object& mean, const py::object& standard_deviation) {
        Vector4<double> center, deviation;
        read(mean, "PayloadGaussian.independent: mean", center);
        read(standard_deviation, "PayloadGaussian.independent: standard_deviation", deviation);
        return made(PayloadGaussian<double>::independent(center, deviation));
      },
      py::arg("mean"), py::arg("standard_deviation"),
      "With independent entries: a mean (4,) and standard deviations (4,).");
  gaussian.def_readonly("mean", &Gaussian::mean, "(m, r_x, r_y, r_z) [kg, m, m, m]: a NumPy view, (4,).");
  gaussian.def_readonly("covariance", &Gaussian::covariance, "Its covariance: a NumPy view, (4, 4).");
  gaussian.def(
      "standard_deviation", [](const Gaussian& self) { return copy_of(self.values->standard_deviation()); },
      "Marginal standard deviations now: a new array, (4,).");
  gaussian.def("__repr__", [](const Gaussian& self) { return "PayloadGaussian(" + text_of(*self.values) + ")"; });

  py::class_<Inertial> inertial(module, "InertialGaussian",
                                "A Gaussian over phi = (m, m r_x, m r_y, m r_z, I_xx, I_xy, I_xz, I_yy, I_yz, I_zz)\n"
                                "[kg, kg m, kg m^2], end-effector axes, I about the end-effector origin.");
  inertial.def_readonly("mean", &Inertial::mean, "Mean of phi: a NumPy view, (10,).");
  inertial.def_readonly("covariance", &Inertial::covariance, "Its covariance: a NumPy view, (10, 10).");

  py::class_<Event> event(module, "Event",
                          "The last event that was over when this object was read. Times count from the estimator's\n"
                          "construction or reset [s].");
  event.def_readonly("number", &Event::number,
                     "Number of events that are over, this one included; 0 before the first.");
  event.def_property_readonly(
      "kind", [](const Event& self) { return PythonEnum<EventKind>::of(self.kind); }, "Its EventKind.");
  event.def_readonly("onset", &Event::onset, "When it began, to within a block [s].");
  event.def_readonly("noticed", &Event::noticed, "When it was noticed [s].");
  event.def_readonly("over", &Event::over, "When it was found to be over [s].");
  event.def("__repr__", [](const Event& self) {
    char text[160];
    std::snprintf(text, sizeof text, "Event(number=%d, kind=%s, onset=%.4g, noticed=%.4g, over=%.4g)", self.number,
                  to_string(self.kind), self.onset, self.noticed, self.over);
    return std::string(text);
  });
}

}  // namespace

State::State(std::shared_ptr<const EstimatorState<double>> state)
    : values(std::move(state)),
      payload(values->payload, values, false),
      inertial_mean(view(values->inertial.mean, values, false)),
      inertial_covariance(view(values->inertial.covariance, values, false)),
      probability(view(values->probability.values, values)),
      sensing(view(values->sensing, values)),
      tool(view(values->tool, values, false)) {}

void bind_state(py::module_& module) {
  bind_parts(module);
  py::class_<State> state(
      module, "EstimatorState",
      "The current estimate, and what happens to the payload.\n\n"
      "Estimator.state shows the estimator's own numbers: they change with each update, and so do\n"
      "the arrays, which are read-only NumPy views without copies. copy() keeps what they are now.\n"
      "Times count from the estimator's construction or reset [s].");
  const auto number = [&](const char* name, auto get, const char* doc) {
    state.def_property_readonly(
        name, [get](const State& self) { return get(*self.values); }, doc);
  };
  using Values = EstimatorState<double>;
  number(
      "time", [](const Values& s) { return s.time; }, "Time of the last sample [s].");
  number(
      "updated", [](const Values& s) { return s.updated; },
      "Time of the last sample in the estimate: behind time by a block and the time to compute it [s].");
  state.def_readonly(
      "payload", &State::payload,
      "PayloadGaussian of all that is in the hand. While empty() holds, the centre of mass is zero, with\n"
      "the prior's standard deviations.");
  state.def_property_readonly(
      "inertial",
      [](const State& self) {
        return Inertial{self.inertial_mean, self.inertial_covariance};
      },
      "InertialGaussian, given that something is held. Its covariance does not grow with health.");
  state.def_readonly("probability", &State::probability,
                     "Probability of each Mode, sum 1: a NumPy view, (5,). probability[rme.Mode.Held] is one of them.");
  number(
      "held", [](const Values& s) { return s.held; }, "Probability that something is held, disturbed or not.");
  number(
      "swinging", [](const Values& s) { return s.swinging; },
      "Probability that what is held swings: it hangs, or the grip is soft.");
  number(
      "swing_frequency", [](const Values& s) { return s.swing_frequency; },
      "Frequency of the swing [Hz]; 0 if it is not known.");
  number(
      "undecided", [](const Values& s) { return s.undecided; },
      "Share of `payload` that may be no weight, but something rigid that holds the hand. A fifth of it is carried.");
  number(
      "confidence", [](const Values& s) { return s.confidence; },
      "How far to trust `payload`, 0 to 1: m^2 / (m^2 + std^2), divided by health / 3 while health is above 3.");
  number(
      "health", [](const Values& s) { return s.health; },
      "About 1 or less if the torque is as the model and this payload predict it, above 10 if not; 100 at most.");
  state.def_readonly("sensing", &State::sensing,
                     "Probability of each kind of torque Sensing, sum 1: a NumPy view, (3,).");
  number(
      "changing", [](const Values& s) { return s.changing; }, "Whether an event is going on.");
  number(
      "change_onset", [](const Values& s) { return s.change_onset; }, "When the current or the last event began [s].");
  number(
      "change_noticed", [](const Values& s) { return s.change_noticed; }, "When that event was noticed [s].");
  number(
      "event", [](const Values& s) { return s.event; }, "The last Event that is over.");
  state.def_readonly(
      "tool", &State::tool,
      "(m, m r) of what the robot's own model lacks at the last link, and of what tare() has counted as\n"
      "tool [kg, kg m]: a NumPy view, (4,). It is no part of `payload`, and is carried with it.");
  state.def(
      "heavier_than", [](const State& self, double mass) { return self.values->heavier_than(mass); }, py::arg("mass"),
      "Probability that what is held is heavier than this [kg].");
  state.def(
      "empty", [](const State& self) { return self.values->empty(); }, "Whether the hand is probably empty.");
  state.def(
      "friction_shows", [](const State& self) { return self.values->friction_shows(); },
      "Probability that tau_ext contains joint friction.");
  state.def(
      "copy", [](const State& self) { return State(std::make_shared<const EstimatorState<double>>(*self.values)); },
      "The state as it is now, which no update changes.");
  state.def("__repr__", [](const State& self) {
    char text[80];
    std::snprintf(text, sizeof text, "EstimatorState(time=%.4g, held=%.3g, payload: ", self.values->time,
                  self.values->held);
    return text + text_of(self.values->payload) + ")";
  });
}

}  // namespace rme::python
