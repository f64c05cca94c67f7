#pragma once
/// The estimator's settings from a file. The library itself reads no files.
// <snippet settings>
#include <fstream>
#include <rme/estimator_json.hpp>  // needs nlohmann-json
#include <stdexcept>
#include <string>

namespace hosts {

/// Settings from a file such as {"rated_payload": 12.5, "observer_bandwidth": 0, "torque_sign": "reaction"}. Missing
/// fields are those of `defaults`, such as rme::franka_config(); unknown ones are refused by name.
template <int Dofs>
rme::EstimatorConfig<double, Dofs> read_settings(const std::string& file,
                                                 const rme::EstimatorConfig<double, Dofs>& defaults = {}) {
  std::ifstream in(file);
  if (!in) throw std::runtime_error("cannot read " + file);
  return rme::estimator_config_from_json<double, Dofs>(nlohmann::json::parse(in), defaults);
}

}  // namespace hosts
// </snippet>
