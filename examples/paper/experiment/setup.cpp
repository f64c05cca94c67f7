#include "setup.hpp"

#include <synthetic_arm/panda.hpp>

namespace rme::examples {

const std::array<PublishedTrial, 6>& published_trials() {
  static const std::array<PublishedTrial, 6> trials = {{
      {0.300, {0.03, 0.00, 0.13}, {0.380, -0.04, 0.02, 0.13}, {0.018, 0.03, 0.01, 0.04}},
      {0.500, {0.06, 0.00, 0.13}, {0.511, 0.04, 0.01, 0.15}, {0.031, 0.04, 0.01, 0.02}},
      {0.700, {0.06, 0.00, 0.13}, {0.681, 0.07, 0.00, 0.14}, {0.019, 0.03, 0.01, 0.04}},
      {0.900, {0.05, -0.03, 0.13}, {0.861, 0.07, -0.02, 0.11}, {0.024, 0.01, 0.01, 0.03}},
      {1.100, {0.05, 0.02, 0.13}, {1.053, 0.07, 0.00, 0.00}, {0.018, 0.01, 0.01, 0.04}},
      {1.290, {0.05, 0.01, 0.13}, {1.269, 0.05, 0.00, 0.00}, {0.008, 0.00, 0.01, 0.06}},
  }};
  return trials;
}

RigidBody experiment_payload(double mass, const Eigen::Vector3d& com) {
  return box(mass, com, {0.06, 0.06, 0.1});
}

Setup Setup::parse(Arguments& arguments, Engine usual) {
  Setup setup;
  setup.engine = parse_engine(arguments, usual);
  setup.friction = arguments.flag("--friction");
  setup.quick = arguments.flag("--quick");
  setup.seed = arguments.whole("--seed", 0).value_or(1);
  setup.output = arguments.text("--output");
  if (setup.output) make_folder("--output", *setup.output);
  return setup;
}

SyntheticArmConfig<7> Setup::arm(std::uint64_t trial, bool faults) const {
  SyntheticArmConfig<7> config;
  if (faults) config = with_typical_faults(panda(), seed * 1000003 + trial);
  if (!friction) config.friction = {};
  config.dt = kPeriod;
  use_engine(engine, config);
  return config;
}

std::string Setup::name() const {
  return std::string(engine == Engine::Mujoco ? "MuJoCo" : "synthetic arm") +
         (friction ? ", joint friction" : ", link-side sensing");
}

}  // namespace rme::examples
