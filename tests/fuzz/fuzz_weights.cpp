// Any bytes as a weights file: refused with a message, or a network that survives being written, read and asked.
#include <cstdint>
#include <cstdlib>
#include <rme/network/json.hpp>
#include <sstream>
#include <stdexcept>
#include <string>

#include "network/golden.hpp"
#include "run_network/json_file.hpp"

namespace {

using Network = rme::MismatchNetwork<float, golden::SmallArchitecture>;

void check(bool good) {
  if (!good) std::abort();
}

}  // namespace

extern "C" int LLVMFuzzerTestOneInput(const std::uint8_t* data, std::size_t size) {
  std::istringstream text(std::string(reinterpret_cast<const char*>(data), size));
  nlohmann::json file;
  try {
    file = rme::examples::parse_strictly(text);
  } catch (const std::exception&) {
    return 0;  // no JSON
  }
  try {
    const auto model = rme::model_from_json<float, golden::SmallArchitecture>(file);
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
