// Contact: what acts on the arm and is not explained, as views of an estimator's numbers.
#include <cstdio>
#include <string>

#include "python/bindings.hpp"

namespace rme::python {

namespace {

using Event = ContactEvent<double>;

void bind_event(py::module_& module) {
  py::class_<Event> event(module, "ContactEvent",
                          "The contact that went on when this object was read, or the last one. Times count from the\n"
                          "estimator's construction or reset [s].");
  event.def_readonly("number", &Event::number, "Number of contacts so far, this one included; 0 before the first.");
  event.def_property_readonly(
      "cause", [](const Event& self) { return PythonEnum<ContactCause>::of(self.cause); },
      "ContactCause: what it turned out to be.");
  event.def_readonly("onset", &Event::onset, "When the torque was usual for the last time before it [s].");
  event.def_readonly("noticed", &Event::noticed, "When it was noticed [s].");
  event.def_readonly("over", &Event::over, "When it was over [s]; 0 while it goes on.");
  event.def_readonly("peak_torque", &Event::peak_torque, "Largest norm of the residual torque so far [N m].");
  event.def_readonly("peak_force", &Event::peak_force, "Largest norm of the force at the tip so far [N].");
  event.def("__repr__", [](const Event& self) {
    char text[200];
    std::snprintf(text, sizeof text,
                  "ContactEvent(number=%d, cause=%s, onset=%.4g, noticed=%.4g, over=%.4g, peak_force=%.3g)",
                  self.number, to_string(self.cause), self.onset, self.noticed, self.over, self.peak_force);
    return std::string(text);
  });
}

}  // namespace

Contact::Contact(std::shared_ptr<const ContactState<double, Eigen::Dynamic>> contact)
    : values(std::move(contact)),
      residual(view(values->residual, values, false)),
      variance(view(values->variance, values, false)),
      threshold(view(values->threshold, values, false)),
      force(view(values->wrench.force, values, false)),
      moment(view(values->wrench.moment, values, false)),
      wrench_covariance(view(values->wrench_covariance, values, false)),
      link(view(values->link, values, false)) {}

void bind_contact(py::module_& module) {
  bind_event(module);
  py::class_<Contact> contact(
      module, "Contact",
      "What acts on the arm and is explained neither by the payload nor by what the arm has shown so far\n"
      "(docs/contact.md). Estimator.contact shows the estimator's own numbers: they change with each update, and so "
      "do\n"
      "the arrays, which are read-only NumPy views.");
  contact.def_property_readonly(
      "ready", [](const Contact& self) { return self.values->ready; },
      "Whether a contact would be noticed: not in the first second, and not while tau_ext is no measurement.");
  contact.def_property_readonly(
      "contact", [](const Contact& self) { return self.values->contact; },
      "Whether something touches the arm, or its payload changes.");
  contact.def_property_readonly(
      "statistic", [](const Contact& self) { return self.values->statistic; },
      "How much of the residual there is: 1 is the threshold.");
  contact.def_readonly("residual", &Contact::residual, "External torque that is not explained [N m], (joints,).");
  contact.def_readonly("variance", &Contact::variance, "Of `residual` while nothing touches the arm, (joints,).");
  contact.def_readonly("threshold", &Contact::threshold,
                       "Residual torque of each joint that would be a contact by itself [N m], (joints,).");
  contact.def_readonly("force", &Contact::force,
                       "Force at the tip that explains `residual` best, with `moment` [N], world axes, (3,).");
  contact.def_readonly("moment", &Contact::moment, "Moment about the end-effector origin [N m], world axes, (3,).");
  contact.def_readonly("wrench_covariance", &Contact::wrench_covariance, "Of (force, moment), (6, 6).");
  contact.def_readonly("link", &Contact::link,
                       "Probability of each link to be touched; zero while `contact` is false, (joints,).");
  contact.def_property_readonly(
      "last", [](const Contact& self) { return self.values->last; }, "The ContactEvent that goes on, or the last one.");
  contact.def(
      "likeliest_link", [](const Contact& self) { return self.values->likeliest_link(); },
      "Number of the link that is most probably touched, 1 to joints; 0 while there is no contact.");
  contact.def("__repr__", [](const Contact& self) {
    char text[160];
    std::snprintf(text, sizeof text, "Contact(contact=%s, statistic=%.3g, link=%d)",
                  self.values->contact ? "True" : "False", self.values->statistic, self.values->likeliest_link());
    return std::string(text);
  });
}

}  // namespace rme::python
