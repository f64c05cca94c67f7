// Any bytes as the settings of an estimator: refused by the name of a field, or settings that survive being written and
// read, with which an estimator works.
#include <cstdint>
#include <rme/estimator.hpp>
#include <rme/estimator_json.hpp>
#include <stdexcept>
#include <string>

#include "fuzz/check.hpp"
#include "fuzz/json_input.hpp"

namespace {

using fuzzing::check;

constexpr double kPeriod = 0.01;

/// Two seconds, half-way through which a kilogram comes.
void try_out(rme::Estimator<double, 6>& estimator) {
  rme::Proprioception<double, 6> tick;
  tick.jacobian.setIdentity();
  const auto pull = rme::payload_wrench<double>({1, {0, 0, 0.1}}, tick.rotation).vector();
  for (int k = 0; k < 200; ++k) {
    if (k > 100) tick.tau_ext += 0.4 * (pull - tick.tau_ext);
    check(estimator.update(tick) == rme::Status::Ok);
    check(estimator.compensation(tick.jacobian, tick.rotation).allFinite());
  }
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = fuzzing::json_of(data, size);
  if (!file) return 0;
  try {
    const auto config = rme::estimator_config_from_json<double, 6>(*file);
    const nlohmann::json written = rme::estimator_config_to_json(config);
    check(rme::estimator_config_to_json(rme::estimator_config_from_json<double, 6>(written)) == written);
    rme::Estimator<double, 6> estimator(kPeriod, config);
    try_out(estimator);
  } catch (const std::invalid_argument& error) {
    const std::string what = error.what();
    check(what.find("expected") != std::string::npos || what.find("unknown field") != std::string::npos ||
          what.find("missing") != std::string::npos);
  }
  return 0;
}
