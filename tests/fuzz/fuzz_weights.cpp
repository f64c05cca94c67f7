// Any bytes as a weights file: refused with a message, or a network that survives being written, read and asked.
#include <cstdint>
#include <rme/network/json.hpp>
#include <stdexcept>
#include <string>

#include "fuzz/check.hpp"
#include "fuzz/json_input.hpp"
#include "network/golden.hpp"

namespace {

using fuzzing::check;
using Network = rme::MismatchNetwork<float, golden::SmallArchitecture>;

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  const auto file = fuzzing::json_of(data, size);
  if (!file) return 0;
  try {
    const auto model = rme::model_from_json<float, golden::SmallArchitecture>(*file);
    const nlohmann::json written = rme::model_to_json(model);
    check(rme::model_to_json(rme::model_from_json<float, golden::SmallArchitecture>(written)) == written);
    const Network network(model.weights);
    Network::Output out = Network::Output::Zero();
    const rme::Status status = network.forward(Network::Window::Ones(), out);
    check(status == rme::Status::Ok ? out.allFinite() : out.isZero(0));
  } catch (const std::invalid_argument& error) {
    check(std::string(error.what()).find("expected") != std::string::npos);
  }
  return 0;
}
