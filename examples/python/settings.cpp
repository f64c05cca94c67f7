// Settings of the estimator: EstimatorConfig, ArmPrior, PayloadPrior.
#include <nlohmann/json.hpp>
#include <optional>
#include <rme/estimator_json.hpp>

#include "python/bindings.hpp"

namespace rme::python {

namespace {

using Joints = ArmPrior<double, Eigen::Dynamic>;
using AnyVector = JointVector<double, Eigen::Dynamic>;

// Python's ArmPrior: vectors whose size is fixed once they are made, so that views of them stay valid.
struct PythonArmPrior {
  explicit PythonArmPrior(const Joints& prior) : values(std::make_shared<Joints>(prior)) {}
  std::shared_ptr<Joints> values;
};

struct PythonPayloadPrior {
  explicit PythonPayloadPrior(const PayloadPrior<double>& prior)
      : values(std::make_shared<PayloadPrior<double>>(prior)) {}
  std::shared_ptr<PayloadPrior<double>> values;
};

// Python's EstimatorConfig. `values` is without its arm and its payload, which are Python objects of their own, so that
// config.payload.mass_mean = 1 changes what it seems to change.
struct PythonConfig {
  std::shared_ptr<Config> values = std::make_shared<Config>();
  py::object arm = py::none(), payload = py::none();
};

AnyVector joint_vector(py::handle object, const char* field) {
  const py::array numbers = float_array(object, field);
  AnyVector out(numbers.ndim() == 1 ? numbers.shape(0) : 0);
  if (numbers.ndim() != 1)
    throw py::value_error(std::string(field) + ": expected one number per joint, got an array of " +
                          std::to_string(numbers.ndim()) + " dimensions");
  read(numbers, field, out);
  return out;
}

template <int Dofs = kFewest>
Joints default_arm(int joints, double rated_payload) {
  if (joints == Dofs) {
    const auto prior = ArmPrior<double, Dofs>::of(rated_payload);
    return {prior.noise, prior.offset, prior.residual, prior.coulomb, prior.viscous, prior.friction_std};
  }
  if constexpr (Dofs < kMost) {
    return default_arm<Dofs + 1>(joints, rated_payload);
  } else {
    throw py::value_error("ArmPrior.of: joints: expected " + std::to_string(kFewest) + " to " + std::to_string(kMost) +
                          ", got " + std::to_string(joints));
  }
}

template <typename Wanted>
void require_type(py::handle object, const char* field) {
  if (!object.is_none() && !py::isinstance<Wanted>(object))
    throw py::type_error(std::string(field) + ": expected " +
                         std::string(py::str(py::type::of<Wanted>().attr("__name__"))) + " or None, got " +
                         type_text(object));
}

void set_sensing(PythonConfig& config, py::handle sensing) {
  config.values->sensing.reset();
  if (!sensing.is_none()) config.values->sensing = PythonEnum<Sensing>::value_of(sensing, "EstimatorConfig.sensing");
}
void set_arm(PythonConfig& config, const py::object& arm) {
  require_type<PythonArmPrior>(arm, "EstimatorConfig.arm");
  config.arm = arm;
}
void set_payload(PythonConfig& config, const py::object& payload) {
  require_type<PythonPayloadPrior>(payload, "EstimatorConfig.payload");
  config.payload = payload;
}

Config complete(const PythonConfig& python) {
  Config config = *python.values;
  if (!python.arm.is_none()) config.arm = *python.arm.cast<const PythonArmPrior&>().values;
  if (!python.payload.is_none()) config.payload = *python.payload.cast<const PythonPayloadPrior&>().values;
  return config;
}

PythonConfig python_config(Config config) {
  PythonConfig out;
  if (config.arm) out.arm = py::cast(PythonArmPrior(*config.arm));
  if (config.payload) out.payload = py::cast(PythonPayloadPrior(*config.payload));
  config.arm.reset();
  config.payload.reset();
  *out.values = config;
  return out;
}

// A property that is a view of the object's own numbers, and can be assigned to as a whole.
template <typename Class, typename Get>
void add_view(Class& python, const char* name, const char* field, const char* doc, Get get) {
  using Self = typename Class::type;
  python.def_property(
      name, [get](Self& self) { return view(get(self), self.values, true); },
      [get, field](Self& self, const py::object& value) { read(value, field, get(self)); }, doc);
}
template <typename Class, typename Get>
void add_number(Class& python, const char* name, const char* field, const char* doc, Get get) {
  using Self = typename Class::type;
  python.def_property(
      name, [get](Self& self) { return get(self); },
      [get, field](Self& self, const py::object& value) { get(self) = number(value, field); }, doc);
}

void bind_priors(py::module_& module) {
  py::class_<PythonArmPrior> arm(
      module, "ArmPrior",
      "Sizes of the joints' noise, offset, residual and friction, one number > 0 per joint.\n\n"
      "The fields are NumPy views: assign to them, or change their entries.");
  arm.def(py::init([](const py::object& noise, const py::object& offset, const py::object& residual,
                      const py::object& coulomb, const py::object& viscous, const py::object& friction_std) {
            return PythonArmPrior({joint_vector(noise, "ArmPrior.noise"), joint_vector(offset, "ArmPrior.offset"),
                                   joint_vector(residual, "ArmPrior.residual"),
                                   joint_vector(coulomb, "ArmPrior.coulomb"), joint_vector(viscous, "ArmPrior.viscous"),
                                   number(friction_std, "ArmPrior.friction_std")});
          }),
          py::arg("noise"), py::arg("offset"), py::arg("residual"), py::arg("coulomb"), py::arg("viscous"),
          py::arg("friction_std") = 0.5, "From five arrays of one number per joint, which are copied, and a number.");
  arm.def_static(
      "of",
      [](const py::object& joints, const py::object& rated_payload) {
        return PythonArmPrior(
            default_arm(integer(joints, "ArmPrior.of: joints"), number(rated_payload, "ArmPrior.of: rated_payload")));
      },
      py::arg("joints"), py::arg("rated_payload"),
      "The defaults: those of a Panda (3 kg) times rated_payload / 3 kg, and 0.4 of that for the last three joints.");
  add_view(arm, "noise", "ArmPrior.noise",
           "Standard deviation of the torque's mean over 20 ms, before it is learned [N m].",
           [](PythonArmPrior& self) -> AnyVector& { return self.values->noise; });
  add_view(arm, "offset", "ArmPrior.offset", "Standard deviation of the torque sensor's offset [N m].",
           [](PythonArmPrior& self) -> AnyVector& { return self.values->offset; });
  add_view(arm, "residual", "ArmPrior.residual",
           "Size of the joint's noise and residual relative to a Panda's (no unit).",
           [](PythonArmPrior& self) -> AnyVector& { return self.values->residual; });
  add_view(arm, "coulomb", "ArmPrior.coulomb", "Mean of the Coulomb friction [N m].",
           [](PythonArmPrior& self) -> AnyVector& { return self.values->coulomb; });
  add_view(arm, "viscous", "ArmPrior.viscous", "Mean of the viscous friction [N m s/rad].",
           [](PythonArmPrior& self) -> AnyVector& { return self.values->viscous; });
  add_number(arm, "friction_std", "ArmPrior.friction_std",
             "Standard deviation of both, relative to their means; 0.5 unless it was measured.",
             [](PythonArmPrior& self) -> double& { return self.values->friction_std; });

  py::class_<PythonPayloadPrior> payload(
      module, "PayloadPrior",
      "What is likely to be picked up: mean and standard deviation of the mass and of\n"
      "the centre of mass, end-effector axes.");
  payload.def(py::init([](const py::object& mass_mean, const py::object& mass_std, const py::object& com_mean,
                          const py::object& com_std) {
                PayloadPrior<double> prior{
                    number(mass_mean, "PayloadPrior.mass_mean"), number(mass_std, "PayloadPrior.mass_std"), {}, {}};
                read(com_mean, "PayloadPrior.com_mean", prior.com_mean);
                read(com_std, "PayloadPrior.com_std", prior.com_std);
                return PythonPayloadPrior(prior);
              }),
              py::arg("mass_mean"), py::arg("mass_std"), py::arg("com_mean"), py::arg("com_std"),
              "From two numbers [kg] and two arrays of three [m]; they are copied.");
  payload.def_static(
      "of",
      [](const py::object& rated_payload) {
        return PythonPayloadPrior(PayloadPrior<double>::of(number(rated_payload, "PayloadPrior.of: rated_payload")));
      },
      py::arg("rated_payload"),
      "The default: a mass of 0.25 +- 0.3 of the rated payload, its centre at (0, 0, 10) +- (6, 6, 7) cm.");
  add_number(payload, "mass_mean", "PayloadPrior.mass_mean", "Mean of the mass [kg], 0 to the rated payload.",
             [](PythonPayloadPrior& self) -> double& { return self.values->mass_mean; });
  add_number(payload, "mass_std", "PayloadPrior.mass_std", "Standard deviation of the mass [kg], > 0.",
             [](PythonPayloadPrior& self) -> double& { return self.values->mass_std; });
  add_view(payload, "com_mean", "PayloadPrior.com_mean",
           "Mean of the centre of mass [m], end-effector axes, from the end-effector origin: a NumPy view.",
           [](PythonPayloadPrior& self) -> Vector3<double>& { return self.values->com_mean; });
  add_view(payload, "com_std", "PayloadPrior.com_std", "Standard deviations of its entries [m], > 0: a NumPy view.",
           [](PythonPayloadPrior& self) -> Vector3<double>& { return self.values->com_std; });
}

}  // namespace

Config config_of(py::handle python) {
  if (python.is_none()) return {};
  require_type<PythonConfig>(python, "Estimator: config");
  return complete(python.cast<const PythonConfig&>());
}

PayloadPrior<double> payload_prior_of(py::handle python, const char* field) {
  if (python.is_none()) return PayloadPrior<double>::of(Config().rated_payload);
  require_type<PythonPayloadPrior>(python, field);
  return *python.cast<const PythonPayloadPrior&>().values;
}

void bind_settings(py::module_& module) {
  bind_priors(module);
  py::class_<PythonConfig> config(
      module, "EstimatorConfig",
      "Settings of an Estimator; the defaults suit a Franka Panda. docs/tuning.md says how to\n"
      "find each. Ranges are checked when an Estimator is made of them.");
  config.def(
      py::init([](const py::object& gravity, const py::object& torque_sign, const py::object& rated_payload,
                  const py::object& observer_bandwidth, const py::object& contact_false_alarms,
                  const py::object& sensing, const py::object& arm, const py::object& payload) {
        PythonConfig self;
        if (!gravity.is_none()) read(gravity, "EstimatorConfig.gravity", self.values->gravity);
        if (!torque_sign.is_none())
          self.values->torque_sign = PythonEnum<TorqueSign>::value_of(torque_sign, "EstimatorConfig.torque_sign");
        if (!rated_payload.is_none())
          self.values->rated_payload = number(rated_payload, "EstimatorConfig.rated_payload");
        if (!observer_bandwidth.is_none())
          self.values->observer_bandwidth = number(observer_bandwidth, "EstimatorConfig.observer_bandwidth");
        if (!contact_false_alarms.is_none())
          self.values->contact_false_alarms = number(contact_false_alarms, "EstimatorConfig.contact_false_alarms");
        set_sensing(self, sensing);
        set_arm(self, arm);
        set_payload(self, payload);
        return self;
      }),
      py::kw_only(), py::arg("gravity") = py::none(), py::arg("torque_sign") = py::none(),
      py::arg("rated_payload") = py::none(), py::arg("observer_bandwidth") = py::none(),
      py::arg("contact_false_alarms") = py::none(), py::arg("sensing") = py::none(), py::arg("arm") = py::none(),
      py::arg("payload") = py::none(), "With the settings that are given, and the defaults for all others.");
  add_view(config, "gravity", "EstimatorConfig.gravity",
           "Gravity in world axes [m/s^2], default (0, 0, -9.81): a NumPy view.",
           [](PythonConfig& self) -> Vector3<double>& { return self.values->gravity; });
  config.def_property(
      "torque_sign", [](const PythonConfig& self) { return PythonEnum<TorqueSign>::of(self.values->torque_sign); },
      [](PythonConfig& self, const py::object& sign) {
        self.values->torque_sign = PythonEnum<TorqueSign>::value_of(sign, "EstimatorConfig.torque_sign");
      },
      "TorqueSign of the tau_ext that the arm reports, default External.");
  add_number(
      config, "rated_payload", "EstimatorConfig.rated_payload",
      "The heaviest payload that the arm is made for [kg], above 0 and at most 10,000, default 3. No larger mass\n"
      "is estimated, and the defaults for noise, offsets, friction and payloads scale with it.",
      [](PythonConfig& self) -> double& { return self.values->rated_payload; });
  add_number(config, "observer_bandwidth", "EstimatorConfig.observer_bandwidth",
             "Bandwidth of the first-order filter through which tau_ext comes [rad/s], default 50; 0 if the torque is\n"
             "unfiltered. The filter is assumed to run at 1 kHz.",
             [](PythonConfig& self) -> double& { return self.values->observer_bandwidth; });
  add_number(config, "contact_false_alarms", "EstimatorConfig.contact_false_alarms",
             "How often a contact may be noticed while nothing touches the arm [1/h], default 0.1.",
             [](PythonConfig& self) -> double& { return self.values->contact_false_alarms; });
  config.def_property(
      "sensing",
      [](const PythonConfig& self) {
        return self.values->sensing ? PythonEnum<Sensing>::of(*self.values->sensing) : py::none();
      },
      [](PythonConfig& self, const py::object& sensing) { set_sensing(self, sensing); },
      "Sensing, if it is known. None (default): found out, for which the arm has to move.");
  config.def_property(
      "arm", [](const PythonConfig& self) { return self.arm; },
      [](PythonConfig& self, const py::object& arm) { set_arm(self, arm); },
      "ArmPrior, if it is known better than ArmPrior.of(joints, rated_payload), or None.");
  config.def_property(
      "payload", [](const PythonConfig& self) { return self.payload; },
      [](PythonConfig& self, const py::object& payload) { set_payload(self, payload); },
      "PayloadPrior, if it is known better than PayloadPrior.of(rated_payload), or None.");
  config.def_static(
      "from_json",
      [](const std::string& text) {
        try {
          return python_config(estimator_config_from_json<double, Eigen::Dynamic>(nlohmann::json::parse(text)));
        } catch (const nlohmann::json::exception& error) {
          throw py::value_error("EstimatorConfig.from_json: expected JSON, got: " + std::string(error.what()));
        }
      },
      py::arg("text"), "The settings of a JSON text, such as check_arm writes. Missing fields keep their defaults.");
  config.def(
      "to_json", [](const PythonConfig& self) { return estimator_config_to_json(complete(self)).dump(); },
      "The settings as a JSON text.");
  config.def("__repr__", [](const PythonConfig& self) {
    return "EstimatorConfig(" + estimator_config_to_json(complete(self)).dump() + ")";
  });
}

}  // namespace rme::python
