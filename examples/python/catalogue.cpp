// ObjectCatalogue, and its answer.
#include <rme/host/object_catalogue.hpp>

#include "python/bindings.hpp"

namespace rme::python {

namespace {

constexpr int kObjects = 64;  // that a catalogue has room for: some 13 kB
using Catalogue = ObjectCatalogue<double, kObjects>;

// An answer, with the names that it refers to. A copy: neither the state nor the catalogue changes it.
struct Answer {
  HeldObject<double, kObjects> values;
  py::object name, likeliest;  // str or None
  py::array object;
};

class PythonCatalogue {
 public:
  explicit PythonCatalogue(const ObjectCatalogueConfig<double>& config)
      : catalogue_(std::make_unique<Catalogue>(config)) {}

  int add(const std::string& name, const py::object& payload, const py::object& weight) {
    if (!py::isinstance<Gaussian>(payload))
      throw py::type_error("ObjectCatalogue.add: payload: expected PayloadGaussian, got " + type_text(payload));
    return catalogue_->add(name, *payload.cast<const Gaussian&>().values,
                           number(weight, "ObjectCatalogue.add: weight"));
  }
  int add_mass(const std::string& name, const py::object& mass, const py::object& deviation, const py::object& weight) {
    return catalogue_->add(name, number(mass, "ObjectCatalogue.add_mass: mass"),
                           number(deviation, "ObjectCatalogue.add_mass: standard_deviation"),
                           number(weight, "ObjectCatalogue.add_mass: weight"));
  }
  py::list names() const {
    py::list out;
    for (int i = 0; i < catalogue_->size(); ++i) out.append(catalogue_->name(i));
    return out;
  }
  Answer identify(const py::object& state) const {
    if (!py::isinstance<State>(state))
      throw py::type_error("ObjectCatalogue.identify: state: expected EstimatorState, got " + type_text(state));
    Answer out;
    out.values = catalogue_->identify(*state.cast<const State&>().values);
    const auto named = [&](int index) {
      return index < 0 ? py::object(py::none()) : py::object(py::str(catalogue_->name(index)));
    };
    out.name = named(out.values.index);
    out.likeliest = named(out.values.likeliest);
    out.object = py::array_t<double>(catalogue_->size(), out.values.object.data());
    return out;
  }

 private:
  std::unique_ptr<Catalogue> catalogue_;
};

}  // namespace

void bind_catalogue(py::module_& module) {
  py::class_<Answer> answer(module, "HeldObject",
                            "Which object is in the hand: probabilities with the sum 1, and the decision that follows\n"
                            "from them. It does not change with the estimator.");
  const auto probability = [&](const char* name, auto get, const char* doc) {
    answer.def_property_readonly(
        name, [get](const Answer& self) { return get(self.values); }, doc);
  };
  using Values = HeldObject<double, kObjects>;
  answer.def_property_readonly(
      "holding", [](const Answer& self) { return PythonEnum<Holding>::of(self.values.holding); },
      "Holding: the answer whose probability is at least `certain`.");
  answer.def_readonly("name", &Answer::name, "Name of the object if `holding` is Known, otherwise None.");
  answer.def_readonly("likeliest", &Answer::likeliest,
                      "Name of the object with the largest probability, decided or not; None without any.");
  answer.def_readonly("object", &Answer::object,
                      "Probability of each object, in the order in which they were added: an array.");
  probability(
      "unknown", [](const Values& v) { return v.unknown; }, "Probability of something that is none of the objects.");
  probability(
      "nothing", [](const Values& v) { return v.nothing; }, "Probability of an empty hand.");
  probability(
      "changing", [](const Values& v) { return v.changing; },
      "Probability that the payload changes just now, so that nothing identifies it.");
  answer.def("__repr__", [](const Answer& self) {
    const std::string what =
        self.values.holding == Holding::Known ? std::string(py::repr(self.name)) : to_string(self.values.holding);
    return "HeldObject(" + what + ")";
  });

  py::class_<PythonCatalogue> catalogue(
      module, "ObjectCatalogue",
      "Which of the objects that the host knows is in the hand.\n\n"
      "Compares the estimator's payload with the objects that were added, and with something unknown.");
  catalogue.def(py::init([](const py::object& unknown, const py::object& unknown_share, const py::object& certain) {
                  ObjectCatalogueConfig<double> config;
                  config.unknown = payload_prior_of(unknown, "ObjectCatalogue: unknown");
                  config.unknown_share = number(unknown_share, "ObjectCatalogue: unknown_share");
                  config.certain = number(certain, "ObjectCatalogue: certain");
                  return std::make_unique<PythonCatalogue>(config);
                }),
                py::arg("unknown") = py::none(), py::arg("unknown_share") = 0.05, py::arg("certain") = 0.98,
                "unknown: PayloadPrior of what is none of the objects, the estimator's: EstimatorConfig.payload, or\n"
                "PayloadPrior.of(rated_payload); None for that of the default settings. unknown_share: how probable\n"
                "such a thing is, above 0 and below 1. certain: probability from which an answer is given, 0.5 to\n"
                "below 1. Raises ValueError naming what is out of range.");
  catalogue.def(
      "add", &PythonCatalogue::add, py::arg("name"), py::arg("payload"), py::arg("weight") = 1.0,
      "Adds an object, and returns its index. name: 1 to 31 bytes, a new one. payload: PayloadGaussian, when\n"
      "held; its covariance says how well both are known, the place of the grip included. weight: how often\n"
      "it is picked up, relative to the others, > 0. At most 64 objects. Raises ValueError naming the object\n"
      "and what is wrong; the catalogue is then as it was.");
  catalogue.def("add_mass", &PythonCatalogue::add_mass, py::arg("name"), py::arg("mass"), py::arg("standard_deviation"),
                py::arg("weight") = 1.0,
                "Adds an object of which only the mass is known [kg], > 0, with its standard deviation [kg], >= 0.\n"
                "Otherwise as add().");
  catalogue.def_property_readonly("names", &PythonCatalogue::names, "Names of the objects: a new list.");
  catalogue.def("identify", &PythonCatalogue::identify, py::arg("state"),
                "Which object is in the hand, by an EstimatorState: a HeldObject.");
}

}  // namespace rme::python
